//! Lesson 10: a true camera.

use common::{Color, Format, Image, Method, Vec2, Vec3, Vec4};
use perspective::interpolation::Interpolation;
use perspective::{METHODS, frustum, window};

use crate::view::beside;
use crate::ways::{WAYS, Way};
use crate::{Drawing, Figure, Input, Values, View, number};

/// A floor of two triangles by two ways to interpolate.
pub(crate) const FLOOR: Figure = Figure {
    name: "perspective-floor",
    stays: false,
    hint: "Make the far side of the floor r times as far away as the near one. Choose another method for the left picture: each \
           row of this floor has one depth, so that a division now and then is enough.",
    inputs: &[
        Input::Slider { label: "r", from: 3.0, range: [1.1, 12.0], step: 0.1 },
        Input::Choice { label: "Left", rows: || Method::rows(METHODS), from: "affine" },
    ],
    draw: floor,
};

/// Columns and rows of each picture.
const SIZE: [u16; 2] = [300, 144];
/// Amber and blue.
const TILES: [Color; 2] = [Color::rgb(0xf2, 0xc1, 0x4e), Color::rgb(0x00, 0x72, 0xb2)];

fn floor(mut values: Values) -> View {
    let r = values.number();
    let method = values.choice(WAYS);
    // The floor is 1 below the eye, from the depth 1 to r, and 2 wide.
    let to_clip = frustum(-0.102, 0.102, -0.102, -0.004, 0.1, 100.0).unwrap_or_default();
    let size = Vec2::from_array(SIZE.map(f32::from));
    let corners = [(-1.0, 1.0), (1.0, 1.0), (1.0, r), (-1.0, r)];
    let corners = corners.map(|(x, depth)| {
        window(to_clip * Vec3::new(x, -1.0, -depth).extend(1.0), size).unwrap_or(Vec4::ZERO)
    });
    let uvs = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    let [left, right] = [method.run, Way::PerPixel].map(|way| {
        let mut found = vec![None; usize::from(SIZE[0]) * usize::from(SIZE[1])];
        for half in [[0, 1, 2], [0, 2, 3]] {
            // With a brightness, which the head has, the code is the same.
            let varyings = half.map(|n| (uvs[n], 0.0));
            way.fill(half.map(|n| corners[n]), varyings, canvas().bounds(), |x: i32, y: i32, _, (uv, _)| {
                found[y as usize * usize::from(SIZE[0]) + x as usize] = Some(uv);
            });
        }
        found
    });
    let off = left
        .iter()
        .zip(&right)
        .filter_map(|(left, right)| Some((left.as_ref()?.y - right.as_ref()?.y).abs()));
    let told = format!(
        "r = {}: by {}, v is off by up to {} of the texture. On a side whose ends are at 1 and r, affine is off by up to \
         (√r − 1) / (√r + 1) = {}.",
        number(r),
        method.name,
        number(off.fold(0.0, f32::max)),
        number((r.sqrt() - 1.0) / (r.sqrt() + 1.0)),
    );
    let pictures = [left, right].map(|found| {
        let mut image = canvas();
        image.set_all(|n| found[n].map_or(Color::BLACK, tile));
        image
    });
    View { drawing: Drawing::Pixels(beside(&[pictures.into()])), told, table: Vec::new() }
}

fn canvas() -> Image {
    Image::new(SIZE[0], SIZE[1], Format::Rgb)
}

/// The colour of a texture of eight by eight tiles.
fn tile(uv: Vec2) -> Color {
    let at = (uv * 8.0).as_ivec2();
    TILES[((at.x + at.y) & 1) as usize]
}
