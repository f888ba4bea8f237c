//! Lesson 13: a texture without flicker.

use common::{Vec2, Vec3, Vec4Swizzles};
use filtering::footprint::{Axes, Gradients};
use filtering::{Footprint, level};
use perspective::{perspective, view, window};
use sheet::{BLUE, FAINT, GREY, PALE, SKY, Sheet};

use crate::{Drawing, Figure, Input, Values, View, number, whole};

/// A pixel of a floor and its footprint.
pub(crate) const FOOTPRINTS: Figure = Figure {
    name: "filtering-footprints",
    stays: true,
    hint: "Drag the pixel in the picture, or move it by the arrow keys. The grey squares on the floor are the texels of the level \
           that is nearest to the footprint's size.",
    inputs: &[Input::Point {
        label: "The pixel",
        from: [7.5, 3.5],
        low: [0.5, 0.5],
        high: [23.5, 6.5],
        step: 1.0,
    }],
    draw: footprints,
};

/// Columns and rows of the picture; of the rows those below the horizon are shown, and a little more.
const SIZE: Vec2 = Vec2::new(24.0, 18.0);
/// How many rows are shown.
const ROWS: f32 = 10.5;
/// Texels of the texture's first level along a length of 1 of the floor.
const TEXELS: f32 = 4.0;
/// The middle of the floor as seen from above, and half of what is seen of it, in texels.
const FLOOR: [Vec2; 2] = [Vec2::new(32.5, 5.6), Vec2::new(6.5, 9.0)];

fn footprints(mut values: Values) -> View {
    let pixel = values.point().floor();
    // A level eye one above the floor; texture coordinates are x and the depth.
    let eye = Vec3::Y;
    let look = view(eye, eye - Vec3::Z, Vec3::Y).expect("it looks somewhere");
    let to_clip = perspective(45.0, SIZE.x / SIZE.y, 0.1, 100.0).unwrap_or_default() * look;
    let clip = |uv: Vec2| to_clip * Vec3::new(uv.x, 0.0, -uv.y).extend(1.0);
    let shown = |uv: Vec2| window(clip(uv), SIZE).unwrap_or_default().xy();
    let corners = [Vec2::new(-90.0, 0.5), Vec2::new(90.0, 0.5), Vec2::new(0.0, 90.0)];
    let gradients = Gradients::new(corners.map(clip), corners, SIZE);
    // At the depth 1 half of the picture is so large.
    let half = Vec2::new(1.0 / to_clip.x_axis.x, 1.0 / to_clip.y_axis.y);
    let center = (pixel + 0.5) / SIZE * 2.0 - 1.0;
    let depth = -1.0 / (center.y * half.y);
    let uv = Vec2::new(center.x * half.x * depth, depth);

    let mut sheet = Sheet::new((-0.2, -4.8), (39.2, 14.8));
    sheet.rectangle((0.0, 0.0), (SIZE.x, ROWS), PALE, GREY);
    sheet.line((0.0, SIZE.y / 2.0), (SIZE.x, SIZE.y / 2.0), GREY, 1.4);
    // Lines of the floor, from where they come into the picture.
    for depth in [2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0, 24.0] {
        let y = shown(Vec2::new(0.0, depth)).y;
        sheet.line((0.0, y), (SIZE.x, y), FAINT, 1.2);
    }
    for u in -6..=6 {
        let u = u as f32;
        let near = (u.abs() / half.x).max(1.0 / half.y);
        sheet.line(shown(Vec2::new(u, near)), shown(Vec2::new(u, 400.0)), FAINT, 1.2);
    }
    sheet.rectangle(pixel, pixel + 1.0, SKY, BLUE);
    sheet.text((SIZE.x / 2.0, -1.2), "picture", GREY);

    let footprint = gradients.footprint(pixel.x as i32, pixel.y as i32, uv);
    let level = level(footprint, Vec2::splat(TEXELS));
    let in_texels = footprint.texels(Vec2::splat(TEXELS));
    let [middle, reach] = FLOOR;
    sheet.rectangle(middle - reach, middle + reach, PALE, GREY);
    // The level that is nearest in size.
    let texel = level.round().max(0.0).exp2();
    for (step, ink, width) in [(1.0, FAINT, 1.0), (texel, GREY, 1.6)] {
        let first = ((uv * TEXELS - reach) / step).ceil();
        let last = ((uv * TEXELS + reach) / step).floor();
        for x in first.x as i32..=last.x as i32 {
            let x = middle.x + x as f32 * step - uv.x * TEXELS;
            sheet.line((x, middle.y - reach.y), (x, middle.y + reach.y), ink, width);
        }
        for y in first.y as i32..=last.y as i32 {
            let y = middle.y + y as f32 * step - uv.y * TEXELS;
            sheet.line((middle.x - reach.x, y), (middle.x + reach.x, y), ink, width);
        }
    }
    let Footprint { x: a, y: b } = in_texels;
    sheet.polygon(&[-a - b, a - b, a + b, b - a].map(|p| middle + p / 2.0), SKY, BLUE);
    sheet.text((middle.x, -4.4), "floor, from above", GREY);
    let Axes { major, minor, .. } = in_texels.axes();
    let finer = level.max(0.0).floor();
    let told = format!(
        "The footprint of pixel ({}, {}) is {} texels long and {} wide, and its level is {}: trilinear takes levels {} and {}, \
         whose texels are {} and {} times as wide as those of the texture.",
        whole(pixel.x),
        whole(pixel.y),
        number(major),
        number(minor),
        number(level),
        whole(finer),
        whole(finer + 1.0),
        whole(finer.exp2()),
        whole((finer + 1.0).exp2()),
    );
    View { drawing: Drawing::Sheet(sheet), told, table: Vec::new() }
}
