//! Lesson 5: colour from a picture.
//!
//! **You will see** lesson 4's head with skin and hair. **New:** a second pair of coordinates at each corner,
//! (u, v), which says where in a texture its colour is; interpolated like depth, and looked up.
//!
//! The job: find the texel of (u, v). From lesson 4 come the depth test and the loop, from lesson 3 the
//! brightness of a face.
//!
//! [`METHODS`] holds four ways; two of them are the slides', which miss by half a texel or at the border.
//!
//! Conventions: u from 0 at the left to 1 at the right, **v from 0 at the bottom row to 1 at the top**. Texel
//! (i, j) of a texture of w×h covers u from i/w to (i+1)/w. Colours are multiplied as they are encoded. (u, v)
//! is interpolated in the picture: under perspective, from lesson 7 on, that warps.

mod wrap;

use common::{Color, Image, Lesson, Method, Model, Table, Vec2, Vec3};
use triangles::flat_intensity;
use zbuffer::{DepthBuffer, fill_nearest, to_screen};

pub use wrap::Wrap;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 5,
    name: "textures",
    title: "Textures",
    job: "colour from a picture",
    tables: &[Table { name: "", job: "Find the texel of (u, v)", rows: || Method::rows(METHODS) }],
};

/// One method as two functions that share their code.
pub struct Sampler {
    /// Draws the textured, flat-shaded model and returns its depths; compiled for just this, it is timed.
    pub draw: fn(&Model, &Image, Vec3, &mut Image) -> DepthBuffer<f32>,
    /// The colour of a texture at (u, v).
    pub sample: fn(&Image, Vec2) -> Color,
}

/// The ways to find the texel of (u, v), from the first idea to the last.
pub const METHODS: &[Method<Sampler>] = &[
    Method {
        name: "truncate",
        run: Sampler {
            draw: |model, texture, light, image| {
                draw_textured(model, light, image, |uv| truncate(texture, uv))
            },
            sample: truncate,
        },
        promise: "right inside the texture, as first printed in the slides",
        failure: "black at u = 1 or v = 1 and beyond; down to -1/w it repeats the first texel",
    },
    Method {
        name: "round",
        run: Sampler {
            draw: |model, texture, light, image| draw_textured(model, light, image, |uv| round(texture, uv)),
            sample: round,
        },
        promise: "as printed with the slides' shaders",
        failure: "half a texel off: wrong in half of each texel and direction, black from 1 - 1/2w on",
    },
    Method {
        name: "nearest",
        run: Sampler {
            draw: |model, texture, light, image| draw_textured(model, light, image, |uv| texel(texture, uv)),
            sample: texel,
        },
        promise: "the texel that (u, v) is in; outside, the nearest one",
        failure: "blocks when enlarged, sparkles when made smaller",
    },
    Method {
        name: "repeat",
        run: Sampler {
            draw: |model, texture, light, image| draw_textured(model, light, image, |uv| repeat(texture, uv)),
            sample: repeat,
        },
        promise: "the texel that (u, v) is in; outside, the texture again and again",
        failure: "at u = 1 it is at the left border again: a seam where a texture does not tile",
    },
];

/// The slides' first lookup: whole numbers by truncation, black outside.
#[must_use]
pub fn truncate(texture: &Image, uv: Vec2) -> Color {
    let at = uv * texture.size();
    texture.get(at.x as i32, at.y as i32).unwrap_or(Color::BLACK)
}

/// The lookup of the slides' shaders: rounds where it should truncate, black outside.
#[must_use]
pub fn round(texture: &Image, uv: Vec2) -> Color {
    let at = (uv * texture.size()).round();
    texture.get(at.x as i32, at.y as i32).unwrap_or(Color::BLACK)
}

/// The texel that (u, v) is in, or the nearest one outside. NaN counts as 0; a texture without texels is
/// black. So near to a border that f32 rounds the product to it, the texel behind the border is found.
// ANCHOR: texel
#[inline]
#[must_use]
pub fn texel(texture: &Image, uv: Vec2) -> Color {
    let at = uv * texture.size();
    let last = texture.bounds().max;
    // A float cast turns NaN and what is below 0 into 0, and keeps what is above the largest u16 at that.
    let [x, y] = [at.x as u16, at.y as u16].map(i32::from);
    texture.get(x.min(last.x), y.min(last.y)).unwrap_or(Color::BLACK)
}
// ANCHOR_END: texel

/// The texel that (u, v) is in if the plane is tiled with the texture. What is not finite counts as 0; far out an f32
/// has few digits left for the place in the tile, and from ±2²³ on none: that is the tile's corner.
#[must_use]
pub fn repeat(texture: &Image, uv: Vec2) -> Color {
    // What is left may be rounded up to 1; `texel` then takes the last column.
    texel(texture, uv - uv.floor())
}

/// The mean of three corners' values, each with its weight.
#[inline]
#[must_use]
pub fn interpolate([a, b, c]: [Vec2; 3], weights: Vec3) -> Vec2 {
    a * weights.x + b * weights.y + c * weights.z
}

/// Draws a model whose colour at (u, v) is `color`, flat-shaded; what faces away from the light is left out.
// ANCHOR: draw_textured
pub fn draw_textured(
    model: &Model,
    light: Vec3,
    image: &mut Image,
    color: impl Fn(Vec2) -> Color,
) -> DepthBuffer<f32> {
    let mut depths = DepthBuffer::new(image, f32::NEG_INFINITY);
    let size = image.size();
    for (corners, uvs) in model.faces().zip(model.face_uvs()) {
        let intensity = flat_intensity(corners, light);
        if intensity >= 0.0 {
            let screen = corners.map(|corner| to_screen(corner, size));
            fill_nearest(
                screen,
                &mut depths,
                |depth| depth,
                |x, y, weights| {
                    image.set(x, y, color(interpolate(uvs, weights)).shaded(intensity));
                },
            );
        }
    }
    depths
}
// ANCHOR_END: draw_textured
