//! Mission 5: colour from a picture.

use common::{Color, Image, Model, Vec2, Vec3};
use fastrand::Rng;
use tasks::scenery::{LIGHT, MODEL, SIDE, TEXTURE, canvas, noise, signed};
use tasks::{Check, Mission, Precision, Raw, Task};
use zbuffer::DepthBuffer;

/// What the student writes.
#[derive(Clone, Copy)]
pub struct Textures {
    /// The lesson's `texel`.
    pub texel: fn(&Image, Vec2) -> Color,
    /// The lesson's `interpolate`.
    pub interpolate: fn([Vec2; 3], Vec3) -> Vec2,
    /// The lesson's `draw_textured`.
    pub draw_textured: Draw,
}

/// A model, the light, a picture, and the colour at (u, v).
pub type Draw = fn(&Model, Vec3, &mut Image, &dyn Fn(Vec2) -> Color) -> DepthBuffer<f32>;

/// The side of the random texture.
pub const TEXELS: u16 = 16;

/// The mission.
pub const MISSION: Mission<Textures> = Mission {
    lesson: "05-textures",
    checks: &[
        Check {
            name: "texels",
            asks: "the middle of each texel of a texture",
            points: 2,
            tasks: |rng| vec![looked_up("the middle of each texel", noise(rng, TEXELS), grid(0.5))],
            precision: Precision::EXACT,
        },
        Check {
            name: "within",
            asks: "all of a texel has its colour, not only the middle",
            points: 2,
            tasks: |rng| {
                let texture = noise(rng, TEXELS);
                [0.25, 0.75]
                    .map(|at| looked_up(&format!("at {at} of each texel"), texture.clone(), grid(at)))
                    .into()
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "border",
            asks: "at u = 1, v = 1 and outside: the nearest texel; u and v are −1½, 0, ½, 1 and 1½",
            points: 2,
            tasks: |rng| {
                let along = [-1.5, 0.0, 0.5, 1.0, 1.5];
                let places: Vec<Vec2> = along.iter().flat_map(|&v| along.map(|u| Vec2::new(u, v))).collect();
                vec![
                    looked_up("25 places", noise(rng, TEXELS), places.clone()),
                    looked_up("one texel", noise(rng, 1), places),
                ]
            },
            precision: Precision::EXACT,
        },
        Check {
            name: "interpolate",
            asks: "the mean of three corners' (u, v), each with its weight",
            points: 1,
            tasks: |rng| {
                let input: Vec<_> = (0..8).map(|_| (uvs(rng), weights(rng))).collect();
                vec![Task::new("corners and weights", move |student: &Textures| {
                    Raw::rows(
                        input.iter().map(|&(uvs, weights)| (student.interpolate)(uvs, weights).to_array()),
                    )
                })]
            },
            precision: Precision::NUMBERS,
        },
        Check {
            name: "coordinates",
            asks: "the model with u in red and v in green",
            points: 1,
            tasks: |_| {
                vec![model("the model", |_, uv| Color::rgb((uv.x * 255.0) as u8, (uv.y * 255.0) as u8, 64))]
            },
            precision: Precision::MODEL,
        },
        Check {
            name: "picture",
            asks: "the model with a texture, flat-shaded",
            points: 2,
            tasks: |_| vec![model("the model", |student, uv| (student.texel)(&TEXTURE, uv))],
            precision: Precision::MODEL,
        },
    ],
};

/// The (u, v) at the same place in each texel.
fn grid(at: f32) -> Vec<Vec2> {
    let texels = 0..TEXELS;
    let along = move |n: u16| (f32::from(n) + at) / f32::from(TEXELS);
    texels.clone().flat_map(|y| texels.clone().map(move |x| Vec2::new(along(x), along(y)))).collect()
}

/// The colours at places that form a square, as a picture.
fn looked_up(input: &str, texture: Image, places: Vec<Vec2>) -> Task<Textures> {
    Task::new(input, move |student: &Textures| {
        let side = places.len().isqrt();
        let mut image = canvas(side as u16, side as u16);
        for (n, &uv) in places.iter().enumerate() {
            image.set((n % side) as i32, (n / side) as i32, (student.texel)(&texture, uv));
        }
        Raw::Picture(image)
    })
}

/// The model in colours that depend on (u, v).
fn model(input: &str, color: fn(&Textures, Vec2) -> Color) -> Task<Textures> {
    Task::new(input, move |student: &Textures| {
        let mut image = canvas(SIDE, SIDE);
        (student.draw_textured)(&MODEL, LIGHT, &mut image, &|uv| color(student, uv));
        Raw::Picture(image)
    })
}

fn uvs(rng: &mut Rng) -> [Vec2; 3] {
    [(); 3].map(|()| Vec2::new(signed(rng), signed(rng)))
}

/// Three weights, each at least 0, that add up to 1.
fn weights(rng: &mut Rng) -> Vec3 {
    let weights = Vec3::new(rng.f32(), rng.f32(), rng.f32() + 0.1);
    weights / weights.element_sum()
}
