//! Mission 7: viewport, projection, and where a point lands.

use common::{Mat4, Vec3};
use fastrand::Rng;
use gouraud::{Scene, Wrap, corner_normals};
use tasks::scenery::{MODEL, MODEL_CODE, TEXTURE, TEXTURE_CODE, canvas, light, point, signed, wide};
use tasks::{Check, Code, Mission, Precision, Raw, Task};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Transforms {
    /// The lesson's `viewport`.
    pub viewport: fn(f32, f32, f32) -> Mat4,
    /// The lesson's `projection`.
    pub projection: fn(f32) -> Mat4,
    /// The lesson's `place`.
    pub place: fn(&Mat4, Vec3) -> Option<Vec3>,
}

/// The mission.
pub const MISSION: Mission<Transforms> = Mission {
    lesson: "07-transforms",
    checks: &[
        Check {
            name: "viewport",
            asks: "the matrix from [−1, 1]² to pixels",
            points: 2,
            tasks: |rng| {
                let mut size = || [rng.i32(20..900) as f32, rng.i32(20..900) as f32, 0.3 + 0.3 * rng.f32()];
                let some = [[800.0, 600.0, 0.5], [320.0, 480.0, 0.4], size(), size()];
                let task = |[width, height, zoom]: [f32; 3]| {
                    let call = format!("viewport({}, {}, {})", width.code(), height.code(), zoom.code());
                    Task::call("", call, move |student: &Transforms| {
                        Raw::matrix((student.viewport)(width, height, zoom))
                    })
                };
                some.map(task).into()
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "projection",
            asks: "the matrix that makes w = 1 − z/d",
            points: 2,
            tasks: |rng| [2.0, 1.25, 3.0 + 3.0 * rng.f32()].map(projected).into(),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "parallel",
            asks: "d = ∞ is the identity, and what is far away nearly so",
            points: 1,
            tasks: |rng| vec![projected(f32::INFINITY), projected(1e4 + 1e6 * rng.f32())],
            precision: Precision::EXACT,
        },
        Check {
            name: "place",
            asks: "a point under a matrix, divided by its w",
            points: 2,
            tasks: |rng| placed(rng, 1.0),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "behind",
            asks: "no place at the eye's height and behind it, where w ≤ 1e-6",
            points: 1,
            tasks: |rng| {
                let mut tasks = placed(rng, -1.0);
                let p = point(rng);
                tasks.extend([0.0, 1e-7, 1e-6, 2e-6].map(|w| {
                    let mut m = Mat4::IDENTITY;
                    m.w_axis.w = w;
                    place(m, p)
                }));
                tasks
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "picture",
            asks: "the model in perspective, and in parallel projection",
            points: 2,
            tasks: |rng| [1.7 + 0.6 * rng.f32(), f32::INFINITY].map(|d| picture(rng, d)).into(),
            precision: Precision::MODEL,
        },
    ],
};

fn projected(d: f32) -> Task<Transforms> {
    let call = format!("projection({})", d.code());
    Task::call("", call, move |student: &Transforms| Raw::matrix((student.projection)(d)))
}

/// Points under a matrix; w is positive or negative.
fn placed(rng: &mut Rng, sign: f32) -> Vec<Task<Transforms>> {
    let points: Vec<Vec3> = (0..8).map(|_| point(rng)).collect();
    let mut m = Mat4::from_cols_array(&[(); 16].map(|()| signed(rng)));
    // |w| is at least 4 − 3.
    (m.x_axis.w, m.y_axis.w, m.z_axis.w, m.w_axis.w) = (0.5, -0.8, 0.7, sign * 4.0);
    points.into_iter().map(|p| place(m, p)).collect()
}

fn place(m: Mat4, p: Vec3) -> Task<Transforms> {
    let before = format!("let m = {};\n", m.code());
    Task::call(&before, format!("place(&m, {})", p.code()), move |student: &Transforms| {
        Raw::rows((student.place)(&m, p).map(|p| p.to_array()))
    })
}

/// The model, placed by the student's three functions.
fn picture(rng: &mut Rng, d: f32) -> Task<Transforms> {
    let ([width, height], light) = (wide(rng), light(rng));
    let code = format!(
        "{MODEL_CODE}{TEXTURE_CODE}let mut got = Image::new({width}, {height}, Format::Rgb);\n\
         let all = viewport({width}.0, {height}.0, 0.4) * projection({});\n\
         let normals = gouraud::corner_normals(&model);\n\
         let scene = gouraud::Scene {{ model: &model, normals: &normals, texture: &texture, wrap: gouraud::Wrap::Clamp, light: {} }};\n\
         gouraud::gouraud(&scene, &mut got, |p| place(&all, p));",
        d.code(),
        light.code()
    );
    let all = move |functions: &Transforms| {
        (functions.viewport)(width.into(), height.into(), 0.4) * (functions.projection)(d)
    };
    Task::new(format!("the model, {width}x{height}, d = {d}"), code, move |student: &Transforms| {
        let mut image = canvas(width, height);
        let all = all(student);
        let scene = Scene {
            model: &MODEL,
            normals: &corner_normals(&MODEL),
            texture: &TEXTURE,
            wrap: Wrap::Clamp,
            light,
        };
        gouraud::gouraud(&scene, &mut image, |p| (student.place)(&all, p));
        Raw::Picture(image)
    })
    .of(move |functions| {
        let all = all(functions);
        let corner = |p| (functions.place)(&all, p);
        MODEL.faces().filter_map(|corners| corners.map(corner).into_iter().collect()).collect()
    })
}
