//! The first wrong pixel, enlarged: what was expected and what was got around it, with the pixels' centres and the
//! sides of the triangle, or the segment, that it belongs to.

use common::compare::side_by_side;
use common::{Color, Format, IVec2, Image, Vec2, Vec3, Vec3Swizzles};
use tasks::Shape;

/// How many pixels are shown on each side of the wrong one.
const AROUND: i32 = 7;

/// The side of an enlarged pixel.
const SCALE: i32 = 24;

/// Half the width of a side, in enlarged pixels.
const HALF_WIDTH: f32 = 1.2;

/// Beyond the picture, and between its pixels.
const NOTHING: Color = Color::rgb(70, 70, 70);
const SIDE: Color = Color::rgb(0, 200, 255);
const FRAME: Color = Color::rgb(255, 0, 255);

/// The shape that a pixel belongs to: the nearest one, of those the one in front, of those the last one drawn.
pub(crate) fn shape_at(shapes: &[Shape], pixel: IVec2) -> Option<&Shape> {
    let center = pixel.as_vec2() + 0.5;
    let rank = |shape: &Shape| (-distance(shape, center), depth(shape, center));
    shapes.iter().max_by(|a, b| {
        let (a, b) = (rank(a), rank(b));
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    })
}

/// A shape in words.
pub(crate) fn said(shape: &Shape) -> String {
    let corner = |p: &Vec3| format!("({}, {})", p.x, p.y);
    let kind = if shape.len() == 2 { "segment" } else { "triangle" };
    format!("{kind} {}", shape.iter().map(corner).collect::<Vec<_>>().join(" "))
}

/// Both pictures around a pixel, side by side.
pub(crate) fn enlarged(pictures: [&Image; 2], pixel: IVec2, shape: Option<&Shape>) -> Option<Image> {
    let [expected, got] = pictures.map(|image| one(image, pixel, shape));
    side_by_side(&[&expected, &got]).ok()
}

fn one(image: &Image, pixel: IVec2, shape: Option<&Shape>) -> Image {
    let corner = pixel - AROUND;
    let side = (2 * AROUND + 1) * SCALE;
    let mut picture = Image::new(side as u16, side as u16, Format::Rgb);
    for (x, y, _) in picture.clone().pixels() {
        let at = corner + IVec2::new(x / SCALE, y / SCALE);
        let within = IVec2::new(x % SCALE, y % SCALE);
        let color = image.get(at.x, at.y);
        let real = corner.as_vec2() + (Vec2::new(x as f32, y as f32) + 0.5) / SCALE as f32;
        let border = (within.min(SCALE - 1 - within)).min_element();
        let on_side = shape.is_some_and(|shape| outline(shape, real) * SCALE as f32 <= HALF_WIDTH);
        let shown = match color {
            _ if on_side => SIDE,
            _ if at == pixel && border < 2 => FRAME,
            _ if border < 1 => NOTHING,
            Some(color) if (within - SCALE / 2).abs().max_element() <= 1 => {
                if color.luma() < 128 {
                    Color::WHITE
                } else {
                    Color::BLACK
                }
            }
            color => color.unwrap_or(NOTHING),
        };
        picture.set(x, y, shown);
    }
    picture
}

/// How far a point is from a shape; 0 inside.
fn distance(shape: &Shape, point: Vec2) -> f32 {
    if weights(shape, point).is_some_and(|weights| weights.min_element() >= 0.0) {
        return 0.0;
    }
    outline(shape, point)
}

/// How far a point is from a shape's sides.
fn outline(shape: &Shape, point: Vec2) -> f32 {
    let next = shape.iter().cycle().skip(1);
    let distances = shape.iter().zip(next).map(|(a, b)| {
        let (a, b) = (a.xy(), b.xy());
        let along = ((point - a).dot(b - a) / a.distance_squared(b).max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
        point.distance(a + along * (b - a))
    });
    distances.fold(f32::INFINITY, f32::min)
}

/// The depth of a triangle at a point in it.
fn depth(shape: &Shape, point: Vec2) -> f32 {
    let z = |shape: &Shape| Vec3::new(shape[0].z, shape[1].z, shape[2].z);
    weights(shape, point).map_or(0.0, |weights| weights.dot(z(shape)))
}

fn weights(shape: &Shape, point: Vec2) -> Option<Vec3> {
    let [a, b, c] = *shape.as_slice() else { return None };
    let area = |a: Vec2, b: Vec2, c: Vec2| (b - a).perp_dot(c - a);
    let (a, b, c) = (a.xy(), b.xy(), c.xy());
    let whole = area(a, b, c);
    let weights = Vec3::new(area(b, c, point), area(c, a, point), area(a, b, point)) / whole;
    weights.is_finite().then_some(weights)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(z: f32, corners: [(f32, f32); 3]) -> Shape {
        corners.map(|(x, y)| Vec3::new(x, y, z)).to_vec()
    }

    #[test]
    fn a_pixel_belongs_to_what_is_in_front_of_it_or_else_nearest() {
        let wide = [(0.0, 0.0), (20.0, 0.0), (0.0, 20.0)];
        let shapes = [
            triangle(0.9, wide),
            triangle(0.1, wide),
            triangle(2.0, [(50.0, 0.0), (60.0, 0.0), (50.0, 9.0)]),
        ];
        assert_eq!(shape_at(&shapes, IVec2::new(3, 3)), Some(&shapes[0]));
        assert_eq!(shape_at(&shapes, IVec2::new(45, 3)), Some(&shapes[2]));
        assert_eq!(shape_at(&[], IVec2::ZERO), None);
        let segments = [vec![Vec3::ZERO, Vec3::X * 9.0], vec![Vec3::Y * 5.0, Vec3::new(9.0, 5.0, 0.0)]];
        assert_eq!(shape_at(&segments, IVec2::new(4, 4)), Some(&segments[1]));
        assert_eq!(said(&segments[0]), "segment (0, 0) (9, 0)");
    }

    #[test]
    fn the_pixel_is_in_the_middle_and_the_sides_are_drawn() {
        let mut image = Image::new(20, 20, Format::Rgb);
        image.set(10, 10, Color::RED);
        let side: Shape = vec![Vec3::new(10.0, 8.5, 0.0), Vec3::new(11.0, 8.5, 0.0)];
        let drawn = one(&image, IVec2::splat(10), Some(&side));
        let at = |x: i32, y: i32, within: i32| drawn.get((x - 3) * SCALE + within, (y - 3) * SCALE + within);
        assert_eq!(at(10, 10, 5), Some(Color::RED));
        assert_eq!(at(10, 10, 1), Some(FRAME));
        assert_eq!(at(9, 9, 12), Some(Color::WHITE));
        assert_eq!(at(10, 8, 12), Some(SIDE));
        assert_eq!(at(9, 8, 5), Some(Color::BLACK));
    }
}
