//! Mission 2: a model's edges.

use common::{Color, IVec2, Image, Model, Vec3};
use fastrand::Rng;
use tasks::scenery::{MODEL, SIDE, canvas, signed};
use tasks::{Check, Mission, Precision, Raw, Task};

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Wireframe {
    /// The lesson's `wireframe`.
    pub wireframe: fn(&Model, &mut Image, Color),
    /// The lesson's `to_pixel`.
    pub to_pixel: fn(Vec3, &Image) -> IVec2,
}

/// Width and height of the small pictures.
pub const SIZE: IVec2 = IVec2::new(60, 40);

/// The mission.
pub const MISSION: Mission<Wireframe> = Mission {
    lesson: "02-wireframe",
    checks: &[
        Check {
            name: "pixel",
            asks: "the pixel in which a point lies",
            points: 2,
            tasks: |rng| {
                // Well inside a pixel's upper right quarter, where rounding goes wrong and cutting off does not.
                let within = |rng: &mut Rng, size: i32| {
                    let pixel = rng.i32(0..size - 1) as f32 + 0.6 + 0.3 * rng.f32();
                    pixel * 2.0 / size as f32 - 1.0
                };
                let points =
                    (0..12).map(|_| Vec3::new(within(rng, SIZE.x), within(rng, SIZE.y), signed(rng)));
                vec![pixels("points inside the picture", points.collect())]
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "border",
            asks: "a point at exactly 1 lies in the last column or row",
            points: 2,
            tasks: |_| {
                let points = [(1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (-1.0, -1.0), (1.0, -1.0), (0.5, 0.5)];
                vec![pixels("points on the border", points.map(|(x, y)| Vec3::new(x, y, 0.0)).into())]
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "outside",
            asks: "a point beyond the border lies beyond the picture",
            points: 1,
            tasks: |_| {
                let points = [(-1.01, 0.3), (0.3, -1.01), (1.2, 0.3), (0.3, 1.2), (-3.01, -2.02)];
                vec![pixels("points beyond the border", points.map(|(x, y)| Vec3::new(x, y, 0.0)).into())]
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "edges",
            asks: "all three sides of a few triangles",
            points: 2,
            tasks: |rng| (0..4).map(|_| few(rng)).collect(),
            precision: Precision::EXACT,
        },
        Check {
            name: "picture",
            asks: "the model",
            points: 3,
            tasks: |_| {
                vec![Task::new("the model", |student: &Wireframe| {
                    let mut image = canvas(SIDE, SIDE);
                    (student.wireframe)(&MODEL, &mut image, Color::WHITE);
                    Raw::Picture(image)
                })]
            },
            // Points of the model may lie on a pixel's border, where the last bit decides.
            precision: Precision { tolerance: 0.0, ..Precision::MODEL },
        },
    ],
};

/// The pixels of points, a row each.
fn pixels(input: &str, points: Vec<Vec3>) -> Task<Wireframe> {
    Task::new(input, move |student: &Wireframe| {
        let image = canvas(SIZE.x as u16, SIZE.y as u16);
        Raw::rows(points.iter().map(|&point| (student.to_pixel)(point, &image).as_vec2().to_array()))
    })
}

/// Three triangles with corners in the middle of pixels; the last two share a side.
fn few(rng: &mut Rng) -> Task<Wireframe> {
    let mut corner = || {
        let pixel = [SIZE.x, SIZE.y].map(|size| (rng.i32(0..size) as f32 + 0.5) * 2.0 / size as f32 - 1.0);
        Vec3::new(pixel[0], pixel[1], 0.0)
    };
    let positions: Vec<Vec3> = (0..7).map(|_| corner()).collect();
    let model =
        Model::from_triangles(positions, vec![[0, 1, 2], [3, 4, 5], [5, 4, 6]]).expect("they are finite");
    Task::new("three triangles", move |student: &Wireframe| {
        let mut image = canvas(SIZE.x as u16, SIZE.y as u16);
        (student.wireframe)(&model, &mut image, Color::WHITE);
        Raw::Picture(image)
    })
}
