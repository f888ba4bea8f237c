//! Lesson 4: the nearest surface.

use common::{Color, Image, Vec3};
use fastrand::Rng;
use zbuffer::{DepthBuffer, Surface};

use super::causes::{picture, picture_and, swapped};
use super::scenery::{LIGHT, MODEL, SIDE, canvas, depths};
use super::{Cause, Check, Mission, Precision, Raw, Task};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Zbuffer {
    /// [`zbuffer::fill_nearest`], for a buffer of f32.
    pub fill_nearest: Visit,
    /// [`zbuffer::z_f32`].
    pub z_f32: fn(&[Surface], &mut Image) -> DepthBuffer<f32>,
}

/// Corners, the buffer, what is stored of a depth, and `visit(x, y, weights)`.
type Visit = fn([Vec3; 3], &mut DepthBuffer<f32>, fn(f32) -> f32, &mut dyn FnMut(i32, i32, Vec3));

const NEAR: Color = Color::GREEN;
const FAR: Color = Color::RED;

/// Width of the picture of the two pairs.
const WIDE: u16 = 80;

/// The mission.
pub const MISSION: Mission<Zbuffer> = Mission {
    lesson: "04-zbuffer",
    reference: Zbuffer {
        fill_nearest: |corners, depths, store, visit| zbuffer::fill_nearest(corners, depths, store, visit),
        z_f32: zbuffer::z_f32,
    },
    checks: &[
        Check {
            name: "pairs",
            asks: "a near, green triangle before a far, red one; on the left the near one is drawn first",
            points: 3,
            tasks: |_| vec![Task::new("two pairs", pairs)],
            precision: Precision::EXACT,
            causes: || picture_and(&[LAST, FIRST, SIGN, NONE]),
        },
        Check {
            name: "depths",
            asks: "the depth is interpolated from the corners and kept in the buffer",
            points: 2,
            tasks: |rng| (0..3).map(|_| slanted(rng)).collect(),
            precision: Precision { tolerance: 1e-3, strays: 0 },
            causes: || {
                vec![
                    Cause {
                        name: "wrong sign of depth: a larger depth is nearer, and is kept as it is",
                        explains: |asked, got| {
                            asked.becomes(got, |raw| {
                                change(raw, |depth| if depth.is_finite() { -depth } else { depth })
                            })
                        },
                    },
                    Cause {
                        name: "the buffer stays empty: set() the depth of each pixel that is drawn",
                        explains: |asked, got| asked.becomes(got, |raw| change(raw, |_| f32::NEG_INFINITY)),
                    },
                ]
            },
        },
        Check {
            name: "layers",
            asks: "the same picture in whatever order the triangles are drawn",
            points: 2,
            tasks: layers,
            precision: Precision::EXACT,
            causes: || picture_and(&[]),
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
            causes: || {
                picture_and(&[Cause {
                    name: "the second one covers the first: nearer is >, not ≥",
                    explains: |asked, got| asked.becomes(got, |raw| swapped(raw, [NEAR, FAR], |_| true)),
                }])
            },
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
            causes: || picture_and(&[]),
        },
    ],
};

const LAST: Cause = Cause {
    name: "the last one drawn is seen: draw only what is nearer than the buffer says, and keep its depth there",
    explains: |asked, got| asked.becomes(got, |raw| swapped(raw, [NEAR, FAR], |x| x < i32::from(WIDE) / 2)),
};

const FIRST: Cause = Cause {
    name: "the first one drawn is seen: what is nearer than the buffer says must be drawn over it",
    explains: |asked, got| asked.becomes(got, |raw| swapped(raw, [NEAR, FAR], |x| x >= i32::from(WIDE) / 2)),
};

const SIGN: Cause = Cause {
    name: "wrong sign of depth, the far one is seen: a larger depth is nearer",
    explains: |asked, got| asked.becomes(got, |raw| swapped(raw, [NEAR, FAR], |_| true)),
};

const NONE: Cause = Cause {
    name: "nothing passes the depth test: a larger depth is nearer, and the buffer starts at −∞",
    explains: |asked, got| asked.becomes(got, |raw| picture(raw, |_, _, _| None)),
};

/// Every depth made another.
fn change(raw: &Raw, change: impl Fn(f32) -> f32) -> Raw {
    match raw {
        Raw::Depths { width, values } => {
            Raw::Depths { width: *width, values: values.iter().map(|&depth| change(depth)).collect() }
        }
        _ => raw.clone(),
    }
}

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
        depths(&buffer)
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
