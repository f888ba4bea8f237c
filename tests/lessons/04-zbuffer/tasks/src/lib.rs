//! Mission 4: the nearest surface.

pub use zbuffer_given as given;

use common::{Color, Image, Vec3};
use fastrand::Rng;
use given::{DepthBuffer, Surface, to_screen};
use tasks::scenery::{MODEL, MODEL_CODE, SIDE, canvas, light};
use tasks::{Check, Code, Mission, Precision, Raw, Shape, Task};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Zbuffer {
    /// The lesson's `fill_nearest`, for a buffer of f32.
    pub fill_nearest: Visit,
    /// The lesson's `z_f32`.
    pub z_f32: fn(&[Surface], &mut Image) -> DepthBuffer<f32>,
}

/// Corners, the buffer, what is stored of a depth, and `visit(x, y, weights)`.
pub type Visit = fn([Vec3; 3], &mut DepthBuffer<f32>, fn(f32) -> f32, &mut dyn FnMut(i32, i32, Vec3));

/// The colour of what is near.
pub const NEAR: Color = Color::GREEN;
/// The colour of what is far.
pub const FAR: Color = Color::RED;

/// Width of the picture of the two pairs.
pub const WIDE: u16 = 80;

/// The mission.
pub const MISSION: Mission<Zbuffer> = Mission {
    lesson: "04-zbuffer",
    checks: &[
        Check {
            name: "pairs",
            asks: "a near, green triangle before a far, red one, on the left drawn first; in the end one between them",
            points: 3,
            tasks: |rng| vec![pairs(rng)],
            precision: Precision::EXACT,
        },
        Check {
            name: "depths",
            asks: "the depth is interpolated from the corners and kept in the buffer",
            points: 2,
            tasks: |rng| {
                let mut tasks: Vec<_> = (0..3).map(|_| slanted(rng)).collect();
                let layers = twelve(rng);
                let code = format!(
                    "{}let got = z_f32(&surfaces, &mut Image::new(40, 40, Format::Rgb));",
                    code(&layers)
                );
                let shapes = shapes(&layers);
                let task = Task::new("z_f32 of twelve triangles", code, move |student: &Zbuffer| {
                    let depths = (student.z_f32)(&layers, &mut canvas(40, 40));
                    Raw::depths(depths.bounds(), |x, y| depths.get(x, y))
                });
                tasks.push(task.of(move |_| shapes.clone()));
                tasks
            },
            precision: Precision { tolerance: 1e-3, strays: 0 },
        },
        Check {
            name: "layers",
            asks: "the same picture in whatever order the triangles are drawn",
            points: 2,
            tasks: layers,
            precision: Precision::EXACT,
        },
        Check {
            name: "equal",
            asks: "of equal depths the first one drawn stays; equal is what is stored of them",
            points: 1,
            tasks: |rng| {
                let z = rng.f32() - 0.5;
                let shift = rng.f32() * 4.0;
                let corners = [(5.0, 5.0), (35.0, 8.0), (20.0, 35.0)];
                let corners = corners.map(|(x, y)| Vec3::new(x, y + shift, z));
                let both = [NEAR, FAR].map(|color| Surface { corners, color });
                vec![drawing("one triangle twice, green, then red", both.into()), whole_depths(rng)]
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "picture",
            asks: "the model, in a shell of which the front half is missing",
            points: 2,
            tasks: |rng| {
                let image = canvas(SIDE, SIDE);
                let (light, larger) = (light(rng), 1.2 + 0.2 * rng.f32());
                let mut surfaces = given::surfaces(&MODEL, light, &image);
                // The far side of a sphere around it: drawn last, and hidden where the model is.
                surfaces.extend(MODEL.faces().filter(|corners| corners.iter().all(|p| p.z < 0.0)).map(
                    |corners| {
                        let corners = corners.map(|corner| to_screen(corner * larger, image.size()));
                        Surface { corners, color: Color::rgb(40, 60, 110) }
                    },
                ));
                let code = format!(
                    "{MODEL_CODE}let mut got = Image::new({SIDE}, {SIDE}, Format::Rgb);\n\
                     let mut surfaces = zbuffer_given::surfaces(&model, {}, &got);\n\
                     let back = model.faces().filter(|corners| corners.iter().all(|p| p.z < 0.0));\n\
                     surfaces.extend(back.map(|corners| Surface {{\n    \
                     corners: corners.map(|corner| to_screen(corner * {}, got.size())),\n    \
                     color: Color::rgb(40, 60, 110),\n}}));\nz_f32(&surfaces, &mut got);",
                    light.code(),
                    larger.code()
                );
                let shapes = shapes(&surfaces);
                let task = Task::new("the model", code, move |student: &Zbuffer| {
                    let mut image = canvas(SIDE, SIDE);
                    (student.z_f32)(&surfaces, &mut image);
                    Raw::Picture(image)
                });
                vec![task.of(move |_| shapes.clone())]
            },
            precision: Precision::MODEL,
        },
    ],
};

/// Surfaces as Rust.
fn code(surfaces: &[Surface]) -> String {
    let one = |Surface { corners, color }: &Surface| {
        format!("    Surface {{ corners: {}, color: {} }},\n", corners.code(), color.code())
    };
    format!("let surfaces = [\n{}];\n", surfaces.iter().map(one).collect::<String>())
}

fn shapes(surfaces: &[Surface]) -> Vec<Shape> {
    surfaces.iter().map(|surface| surface.corners.to_vec()).collect()
}

/// The same triangle near and far, drawn in either order, and then half-way.
fn pairs(rng: &mut Rng) -> Task<Zbuffer> {
    let (near, far) = (0.2 + 0.6 * rng.f32(), -0.9 + 0.6 * rng.f32());
    let between = ((near + far) / 2.0, Color::WHITE);
    let (near, far) = ((near, NEAR), (far, FAR));
    let up = 4.0 * rng.f32();
    let mut surfaces = Vec::new();
    for (shift, drawn) in [(0.0, [near, far, between]), (40.0, [far, near, between])] {
        surfaces.extend(drawn.map(|(z, color)| {
            let corners = [(4.25, 4.75), (36.25, 7.75), (19.25, 35.75)];
            Surface { corners: corners.map(|(x, y)| Vec3::new(x + shift, y + up, z)), color }
        }));
    }
    filled("two pairs", WIDE, surfaces, ("|depth| depth", |depth| depth))
}

/// Two triangles one in front of the other, of which a buffer of few levels keeps the same.
fn whole_depths(rng: &mut Rng) -> Task<Zbuffer> {
    let level = rng.i32(-3..3) as f32;
    let surfaces = [(level + 0.3, NEAR), (level + 0.6, FAR)].map(|(z, color)| {
        let corners = [(4.25, 4.75), (36.25, 7.75), (19.25, 35.75)];
        Surface { corners: corners.map(|(x, y)| Vec3::new(x, y, z)), color }
    });
    filled("a buffer of whole depths", 40, surfaces.into(), ("f32::floor", f32::floor))
}

/// Draws surfaces by `fill_nearest` alone.
fn filled(input: &str, width: u16, surfaces: Vec<Surface>, store: (&str, fn(f32) -> f32)) -> Task<Zbuffer> {
    let code = format!(
        "{}let mut got = Image::new({width}, 40, Format::Rgb);\n\
         let mut depths = DepthBuffer::new(&got, f32::NEG_INFINITY);\n\
         for surface in surfaces {{\n    \
         fill_nearest(surface.corners, &mut depths, {}, |x, y, _| got.set(x, y, surface.color));\n}}",
        code(&surfaces),
        store.0
    );
    let shapes = shapes(&surfaces);
    Task::new(input, code, move |student: &Zbuffer| {
        let mut image = canvas(width, 40);
        let mut depths = DepthBuffer::new(&image, f32::NEG_INFINITY);
        for &Surface { corners, color } in &surfaces {
            (student.fill_nearest)(corners, &mut depths, store.1, &mut |x, y, _| image.set(x, y, color));
        }
        Raw::Picture(image)
    })
    .of(move |_| shapes.clone())
}

/// The depths of one triangle that slants.
fn slanted(rng: &mut Rng) -> Task<Zbuffer> {
    let mut corner = |x: f32, y: f32| Vec3::new(x + rng.f32() * 8.0, y + rng.f32() * 8.0, rng.f32() + 0.1);
    let corners = [corner(1.0, 1.0), corner(30.0, 4.0), corner(10.0, 30.0)];
    let code = format!(
        "let mut got = DepthBuffer::new(&Image::new(40, 40, Format::Rgb), f32::NEG_INFINITY);\n\
         fill_nearest({}, &mut got, |depth| depth, |_, _, _| ());",
        corners.code()
    );
    Task::new("one slanted triangle", code, move |student: &Zbuffer| {
        let mut buffer = DepthBuffer::new(&canvas(40, 40), f32::NEG_INFINITY);
        (student.fill_nearest)(corners, &mut buffer, |depth| depth, &mut |_, _, _| ());
        Raw::depths(buffer.bounds(), |x, y| buffer.get(x, y))
    })
    .of(move |_| vec![corners.to_vec()])
}

/// Triangles one behind the other. Some are farther than -1.
fn twelve(rng: &mut Rng) -> Vec<Surface> {
    (0_u8..12)
        .map(|n| {
            let mut corner = || Vec3::new(rng.f32() * 40.0, rng.f32() * 40.0, f32::from(n) / 2.0 - 4.0);
            let corners = [corner(), corner(), corner()];
            Surface { corners, color: Color::rgb(20 * n + 15, 255 - 20 * n, 80) }
        })
        .collect()
}

/// Twelve triangles in three orders.
fn layers(rng: &mut Rng) -> Vec<Task<Zbuffer>> {
    let mut surfaces = twelve(rng);
    let shuffled = |_| {
        rng.shuffle(&mut surfaces);
        drawing("twelve layers", surfaces.clone())
    };
    (0..3).map(shuffled).collect()
}

/// Draws surfaces into a small picture.
fn drawing(input: &str, surfaces: Vec<Surface>) -> Task<Zbuffer> {
    let code = format!(
        "{}let mut got = Image::new(40, 40, Format::Rgb);\nz_f32(&surfaces, &mut got);",
        code(&surfaces)
    );
    let shapes = shapes(&surfaces);
    Task::new(input, code, move |student: &Zbuffer| {
        let mut image = canvas(40, 40);
        (student.z_f32)(&surfaces, &mut image);
        Raw::Picture(image)
    })
    .of(move |_| shapes.clone())
}
