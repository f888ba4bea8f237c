//! Mission 4: the nearest surface.

use common::{Color, Image, Vec3};
use fastrand::Rng;
use tasks::scenery::{LIGHT, MODEL, SIDE, canvas};
use tasks::{Check, Mission, Precision, Raw, Task};
use zbuffer::{DepthBuffer, Surface};

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
            asks: "a near, green triangle before a far, red one; on the left the near one is drawn first",
            points: 3,
            tasks: |_| vec![Task::new("two pairs", pairs)],
            precision: Precision::EXACT,
        },
        Check {
            name: "depths",
            asks: "the depth is interpolated from the corners and kept in the buffer",
            points: 2,
            tasks: |rng| (0..3).map(|_| slanted(rng)).collect(),
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
            asks: "of equal depths the first one drawn stays",
            points: 1,
            tasks: |_| {
                let corners = [(5.0, 5.0), (35.0, 8.0), (20.0, 35.0)].map(|(x, y)| Vec3::new(x, y, 0.5));
                let both = [NEAR, FAR].map(|color| Surface { corners, color });
                vec![drawing("one triangle twice, green, then red", both.into())]
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "picture",
            asks: "the model, in a shell of which the front half is missing",
            points: 2,
            tasks: |_| {
                let image = canvas(SIDE, SIDE);
                let mut surfaces = zbuffer::surfaces(&MODEL, LIGHT, &image);
                // The far side of a sphere around it: drawn last, and hidden where the model is.
                surfaces.extend(MODEL.faces().filter(|corners| corners.iter().all(|p| p.z < 0.0)).map(
                    |corners| {
                        let corners = corners.map(|corner| zbuffer::to_screen(corner * 1.3, image.size()));
                        Surface { corners, color: Color::rgb(40, 60, 110) }
                    },
                ));
                vec![Task::new("the model", move |student: &Zbuffer| {
                    let mut image = canvas(SIDE, SIDE);
                    (student.z_f32)(&surfaces, &mut image);
                    Raw::Picture(image)
                })]
            },
            precision: Precision::MODEL,
        },
    ],
};

/// The same triangle near and far, drawn in either order.
fn pairs(student: &Zbuffer) -> Raw {
    let mut image = canvas(WIDE, 40);
    let mut depths = DepthBuffer::new(&image, f32::NEG_INFINITY);
    for (shift, z, color) in [(0.0, 0.4, NEAR), (0.0, -0.7, FAR), (40.0, -0.7, FAR), (40.0, 0.4, NEAR)] {
        let corners = [(4.25, 4.75), (36.25, 7.75), (19.25, 35.75)].map(|(x, y)| Vec3::new(x + shift, y, z));
        (student.fill_nearest)(corners, &mut depths, |depth| depth, &mut |x, y, _| image.set(x, y, color));
    }
    Raw::Picture(image)
}

/// The depths of one triangle that slants.
fn slanted(rng: &mut Rng) -> Task<Zbuffer> {
    let mut corner = |x: f32, y: f32| Vec3::new(x + rng.f32() * 8.0, y + rng.f32() * 8.0, rng.f32() + 0.1);
    let corners = [corner(1.0, 1.0), corner(30.0, 4.0), corner(10.0, 30.0)];
    Task::new("one slanted triangle", move |student: &Zbuffer| {
        let mut buffer = DepthBuffer::new(&canvas(40, 40), f32::NEG_INFINITY);
        (student.fill_nearest)(corners, &mut buffer, |depth| depth, &mut |_, _, _| ());
        Raw::depths(buffer.bounds(), |x, y| buffer.get(x, y))
    })
}

/// Triangles one behind the other, in three orders.
fn layers(rng: &mut Rng) -> Vec<Task<Zbuffer>> {
    let mut surfaces: Vec<Surface> = (0_u8..12)
        .map(|n| {
            let mut corner = || Vec3::new(rng.f32() * 40.0, rng.f32() * 40.0, f32::from(n) / 10.0 - 0.5);
            let corners = [corner(), corner(), corner()];
            Surface { corners, color: Color::rgb(20 * n + 15, 255 - 20 * n, 80) }
        })
        .collect();
    let shuffled = |_| {
        rng.shuffle(&mut surfaces);
        drawing("twelve layers", surfaces.clone())
    };
    (0..3).map(shuffled).collect()
}

/// Draws surfaces into a small picture.
fn drawing(input: &str, surfaces: Vec<Surface>) -> Task<Zbuffer> {
    Task::new(input, move |student: &Zbuffer| {
        let mut image = canvas(40, 40);
        (student.z_f32)(&surfaces, &mut image);
        Raw::Picture(image)
    })
}
