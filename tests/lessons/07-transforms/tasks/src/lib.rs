//! Mission 7: viewport, projection, and where a point lands.

use common::{Mat4, Vec3};
use fastrand::Rng;
use gouraud::{Scene, Wrap, corner_normals};
use tasks::scenery::{LIGHT, MODEL, SIDE, TEXTURE, canvas, point};
use tasks::{Check, Mission, Precision, Raw, Task};

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
                let some = [[800.0, 600.0, 0.5], size(), size()];
                let task = |[width, height, zoom]: [f32; 3]| {
                    Task::new(format!("{width}x{height}, zoom {zoom:.2}"), move |student: &Transforms| {
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
            tasks: |_| [2.0, 5.0, 1.25].map(projected).into(),
            precision: Precision::NUMBERS,
        },
        Check {
            name: "parallel",
            asks: "d = ∞ is the identity",
            points: 1,
            tasks: |_| vec![projected(f32::INFINITY)],
            precision: Precision::EXACT,
        },
        Check {
            name: "place",
            asks: "a point under a matrix, divided by its w",
            points: 2,
            tasks: |rng| vec![placed(rng, 1.0)],
            precision: Precision::NUMBERS,
        },
        Check {
            name: "behind",
            asks: "no place at the eye's height and behind it, where w ≤ 1e-6",
            points: 1,
            tasks: |rng| vec![placed(rng, -1.0)],
            precision: Precision::NUMBERS,
        },
        Check {
            name: "picture",
            asks: "the model in perspective, and in parallel projection",
            points: 2,
            tasks: |_| [2.0, f32::INFINITY].map(picture).into(),
            precision: Precision::MODEL,
        },
    ],
};

fn projected(d: f32) -> Task<Transforms> {
    Task::new(format!("d = {d}"), move |student: &Transforms| Raw::matrix((student.projection)(d)))
}

/// Points under a matrix, a row each, NaN for those without a place; w is positive or negative.
fn placed(rng: &mut Rng, sign: f32) -> Task<Transforms> {
    let points: Vec<Vec3> = (0..8).map(|_| point(rng)).collect();
    let mut m = Mat4::from_cols_array(&[(); 16].map(|()| tasks::scenery::signed(rng)));
    // |w| is at least 4 − 3.
    (m.x_axis.w, m.y_axis.w, m.z_axis.w, m.w_axis.w) = (0.5, -0.8, 0.7, sign * 4.0);
    Task::new("points and a matrix", move |student: &Transforms| {
        Raw::rows(points.iter().map(|&p| (student.place)(&m, p).map_or([f32::NAN; 3], |p| p.to_array())))
    })
}

/// The model, placed by the student's three functions.
fn picture(d: f32) -> Task<Transforms> {
    Task::new(format!("the model, d = {d}"), move |student: &Transforms| {
        let mut image = canvas(SIDE, SIDE);
        let size = image.size();
        let all = (student.viewport)(size.x, size.y, 0.4) * (student.projection)(d);
        let scene = Scene {
            model: &MODEL,
            normals: &corner_normals(&MODEL),
            texture: &TEXTURE,
            wrap: Wrap::Clamp,
            light: LIGHT,
        };
        gouraud::gouraud(&scene, &mut image, |p| (student.place)(&all, p));
        Raw::Picture(image)
    })
}
