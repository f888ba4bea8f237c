//! The lesson's picture: rays behind a head, and a part of it enlarged.

use std::f64::consts::TAU;

use common::{Bounds, Color, DVec2, IVec2, Image, Vec2};
use zbuffer::Surface;

/// What is behind everything.
pub const NIGHT: Color = Color::rgb(16, 24, 48);

/// How many rays there are.
const RAYS: u16 = 72;

/// How far from the middle of a picture rays begin, as a share of its smaller side.
const NEAR: f64 = 0.12;

/// How far from it they end.
const FAR: f64 = 0.6;

/// How deep the rays are: behind whatever a camera sees.
const DEPTH: f32 = 0.999_99;

/// A fan of triangles about the middle of a picture of that size, as sun rays are drawn: each as wide as its neighbours let it
/// at its inner end, and running out into a point, long before which it is thinner than a pixel. First comes a sky that fills
/// the picture, whatever was there.
// ANCHOR: fan
#[must_use]
pub fn fan(size: Vec2) -> Vec<Surface> {
    let (middle, side) = (size.as_dvec2() / 2.0, f64::from(size.min_element()));
    let at = |turn: f64, radius: f64| {
        let (sine, cosine) = (libm::sin(turn * TAU), libm::cos(turn * TAU));
        (middle + DVec2::new(cosine, sine) * radius * side).as_vec2().extend(DEPTH)
    };
    let ray = |n: u16| {
        let [left, tip, right] = [0.0, 0.5, 1.0].map(|part| (f64::from(n) + part) / f64::from(RAYS));
        // From gold to rose, and back.
        let share = (f64::from(n) / f64::from(RAYS) * 2.0 - 1.0).abs();
        let color = Color::rgb(255, 200, 92).mixed(Color::rgb(232, 82, 100), (share * 255.0) as u8);
        Surface { corners: [at(left, NEAR), at(tip, FAR), at(right, NEAR)], color }
    };
    let corners =
        [Vec2::ZERO, size.with_y(0.0), size, size.with_x(0.0)].map(|corner| corner.extend(DEPTH.next_up()));
    let sky = [[0, 1, 2], [0, 2, 3]]
        .map(|triangle| Surface { corners: triangle.map(|n| corners[n]), color: NIGHT });
    sky.into_iter().chain((0..RAYS).map(ray)).collect()
}
// ANCHOR_END: fan

/// How many pixels are enlarged, each way.
const PART: i32 = 24;

/// For each so many pixels of a picture's smaller side, an enlarged pixel is one pixel wider.
const ONCE: i32 = 88;

/// Where the enlarged part has its middle, as shares of the picture's width and height.
const PLACE: Vec2 = Vec2::new(0.302, 0.475);

/// Enlarges a part of a picture in its lower corners: as it is on the right, and on the left as it is in another picture, which
/// `other` draws. One that is too small for that stays as it is, and no other is drawn.
// ANCHOR: magnify
pub fn magnify(other: impl FnOnce() -> Image, picture: &mut Image) {
    let size = picture.size();
    let times = size.min_element() as i32 / ONCE;
    if times < 2 {
        return;
    }
    let line = 1.max(times / 4);
    let middle = (PLACE * size).as_ivec2();
    let part = Bounds { min: middle - PART / 2, max: middle - PART / 2 + PART - 1 };
    let (whole, gap) = (picture.clone(), 3 * line);
    frame(part, line, Color::WHITE, picture);
    let right = picture.width() - gap - PART * times;
    for (from, x) in [(&other(), gap), (&whole, right)] {
        let corner = IVec2::new(x, gap);
        for (i, j) in (0..PART * times).flat_map(|j| (0..PART * times).map(move |i| (i, j))) {
            let pixel = part.min + IVec2::new(i, j) / times;
            if let Some(color) = from.get(pixel.x, pixel.y) {
                picture.set(corner.x + i, corner.y + j, color);
            }
        }
        frame(Bounds { min: corner, max: corner + PART * times - 1 }, line, Color::WHITE, picture);
    }
}
// ANCHOR_END: magnify

/// Draws a frame about a rectangle, so many pixels wide.
fn frame(Bounds { min, max }: Bounds, width: i32, color: Color, picture: &mut Image) {
    let inside = Bounds { min, max };
    for y in min.y - width..=max.y + width {
        let border = (min.x - width..=max.x + width).filter(|&x| !inside.contains(x, y));
        border.for_each(|x| picture.set(x, y, color));
    }
}
