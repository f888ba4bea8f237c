//! What mission 15 gives: the sides of a triangle, the places of samples, and a loop over pixels. Nothing of lesson 15 is in it, so
//! that the program in which a submission runs has nothing of it either.

use common::{Color, IVec2, Image, Vec2};

/// A side of a triangle, with its inside on the left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Side {
    /// Where it begins, in 1/256 px.
    from: [i64; 2],
    /// The way to its end.
    way: [i64; 2],
    /// Whether a point on it belongs to the triangle: it goes down, or it is level and goes left.
    pub top_left: bool,
}

impl Side {
    /// Its edge function at a point in 1/256 px: above 0 on the left, 0 on the side, below 0 on the right.
    #[must_use]
    pub fn edge(&self, point: [i64; 2]) -> i64 {
        let [x, y] = [0, 1].map(|axis| point[axis] - self.from[axis]);
        self.way[0] * y - self.way[1] * x
    }
}

/// The three sides of a triangle, counterclockwise whatever the order of its corners, which are in pixels, up to ±2¹⁶, and are
/// rounded to 1/256 px. `None` where it has no area.
#[must_use]
pub fn sides(corners: [Vec2; 3]) -> Option<[Side; 3]> {
    let [a, b, c] = corners.map(|corner| corner.to_array().map(|n| (n * 256.0).round_ties_even() as i64));
    let side = |from: [i64; 2], to: [i64; 2]| {
        let way = [to[0] - from[0], to[1] - from[1]];
        Side { from, way, top_left: way[1] < 0 || way[1] == 0 && way[0] < 0 }
    };
    match side(a, b).edge(c).signum() {
        0 => None,
        1 => Some([side(a, b), side(b, c), side(c, a)]),
        _ => Some([side(a, c), side(c, b), side(b, a)]),
    }
}

/// The standard places of 1, 2, 4, 8 or 16 samples in a pixel, x and y in 1/16 px from its lower left corner (Vulkan 1.3,
/// *Multisampling*, where y points down).
///
/// # Panics
/// For another number.
#[must_use]
pub fn pattern(samples: usize) -> &'static [[i32; 2]] {
    match samples {
        1 => &[[8, 8]],
        2 => &[[12, 4], [4, 12]],
        4 => &[[6, 14], [14, 10], [2, 6], [10, 2]],
        8 => &[[9, 11], [7, 5], [13, 7], [5, 13], [3, 3], [1, 9], [11, 1], [15, 15]],
        16 => &[
            [9, 7],
            [7, 11],
            [5, 6],
            [12, 9],
            [3, 10],
            [10, 3],
            [13, 5],
            [11, 13],
            [6, 2],
            [8, 15],
            [4, 14],
            [2, 4],
            [0, 8],
            [15, 12],
            [14, 1],
            [1, 16],
        ],
        _ => panic!("there is no pattern of {samples} samples"),
    }
}

/// The samples of a pixel that a triangle covers.
pub type Coverage = fn([Vec2; 3], IVec2, &[[i32; 2]]) -> u32;

/// A pixel's colour from those of its samples.
pub type Resolve = fn(&[Color]) -> Color;

/// Draws triangles, each in its colour and over those before it, with as many samples a pixel as there are places.
pub fn draw(
    triangles: &[([Vec2; 3], Color)],
    pattern: &[[i32; 2]],
    coverage: Coverage,
    resolve: Resolve,
    image: &mut Image,
) {
    for (x, y, background) in image.clone().pixels() {
        let mut samples = vec![background; pattern.len()];
        for &(corners, color) in triangles {
            let mask = coverage(corners, IVec2::new(x, y), pattern);
            for (s, sample) in samples.iter_mut().enumerate() {
                if mask >> s & 1 == 1 {
                    *sample = color;
                }
            }
        }
        image.set(x, y, resolve(&samples));
    }
}
