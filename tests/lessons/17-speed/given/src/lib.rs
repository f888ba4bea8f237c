//! What mission 17 gives: the edge functions of a triangle, what can be said of a block, and the loop over blocks. Nothing of
//! lesson 17 is in it, so that the program in which a submission runs has nothing of it either.

use common::{Color, DVec2, DVec3, Image, Vec2};

/// A block's side in pixels.
pub const SIDE: i32 = 8;

/// How much of a block a triangle covers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cover {
    /// None of its pixels.
    Nothing = 0,
    /// Perhaps some: they are to be asked one by one.
    Part = 1,
    /// All of them.
    Whole = 2,
}

/// What a student says of a block: from the edge functions at its lower left pixel, what a pixel to the right and one up add to
/// them, and the least values inside.
pub type CoverOf = fn(DVec3, DVec3, DVec3, DVec3) -> Cover;

/// The edge functions of a triangle, of its three sides.
#[derive(Clone, Copy, Debug)]
pub struct Edges {
    /// At the centre of pixel (0, 0).
    origin: DVec3,
    /// What a pixel to the right adds.
    pub right: DVec3,
    /// What a pixel up adds.
    pub up: DVec3,
    /// The least value inside: 0 on a top or left side, else 1.
    pub inside: DVec3,
}

impl Edges {
    /// Those of a triangle whose corners are in pixels, up to ±2¹⁶, in any order, and are rounded to 1/256 px. `None` where it has
    /// no area.
    #[must_use]
    pub fn new(corners: [Vec2; 3]) -> Option<Self> {
        let rounded = |place: f32| f64::from((place * 256.0).round_ties_even());
        let corners = corners.map(|corner| DVec2::from_array(corner.to_array().map(rounded)));
        let [a, b, c] = corners;
        let [a, b, c] = match (b - a).perp_dot(c - a) {
            0.0 => return None,
            area if area > 0.0 => [a, b, c],
            _ => [a, c, b],
        };
        let sides = [[b, c], [c, a], [a, b]];
        let of = |value: fn([DVec2; 2]) -> f64| DVec3::from_array(sides.map(value));
        Some(Self {
            origin: of(|[from, to]| (to - from).perp_dot(DVec2::splat(128.0) - from)),
            right: of(|[from, to]| 256.0 * (from.y - to.y)),
            up: of(|[from, to]| 256.0 * (to.x - from.x)),
            inside: of(|[from, to]| {
                let top_left = to.y < from.y || to.y == from.y && to.x < from.x;
                f64::from(!top_left)
            }),
        })
    }

    /// At the centre of a pixel: whole numbers below 2⁵³, not rounded.
    #[must_use]
    pub fn at(&self, x: i32, y: i32) -> DVec3 {
        self.origin + self.right * f64::from(x) + self.up * f64::from(y)
    }

    /// Whether the triangle covers a pixel.
    #[must_use]
    pub fn covers(&self, x: i32, y: i32) -> bool {
        self.at(x, y).cmpge(self.inside).all()
    }

    /// How many pixels of a block are inside of each side, 0 to 64.
    #[must_use]
    pub fn counts(&self, x: i32, y: i32) -> [i32; 3] {
        let mut counts = [0; 3];
        for (x, y) in block(x, y) {
            let inside = self.at(x, y).cmpge(self.inside);
            counts = [0, 1, 2].map(|side| counts[side] + i32::from(inside.test(side)));
        }
        counts
    }

    /// Whether a block is empty though pixels of it are inside of each side: it may be said to be `Nothing` as well as `Part`.
    #[must_use]
    pub fn is_open(&self, x: i32, y: i32) -> bool {
        self.counts(x, y).iter().all(|&count| count > 0) && !block(x, y).any(|(x, y)| self.covers(x, y))
    }
}

/// The pixels of a block, from its lower left one on.
fn block(x: i32, y: i32) -> impl Iterator<Item = (i32, i32)> {
    (0..SIDE).flat_map(move |up| (0..SIDE).map(move |right| (x + right, y + up)))
}

/// Draws triangles, block by block. What is accepted with its block has the triangle's colour, what was asked for pixel by pixel
/// half of it, and where it was asked for nothing there is a dark blue. (Not in blocks of which both may be said.)
pub fn draw(triangles: &[([Vec2; 3], Color)], cover: CoverOf, image: &mut Image) {
    for &(corners, color) in triangles {
        let Some(edges) = Edges::new(corners) else { continue };
        for y in (0..image.height()).step_by(SIDE as usize) {
            for x in (0..image.width()).step_by(SIDE as usize) {
                let said = cover(edges.at(x, y), edges.right, edges.up, edges.inside);
                if said == Cover::Nothing || edges.is_open(x, y) {
                    continue;
                }
                for (x, y) in block(x, y) {
                    if said == Cover::Whole {
                        image.set(x, y, color);
                    } else if edges.covers(x, y) {
                        image.set(x, y, Color::rgb(color.r / 2, color.g / 2, color.b / 2));
                    } else if image.get(x, y) == Some(Color::BLACK) {
                        image.set(x, y, Color::rgb(0, 0, 48));
                    }
                }
            }
        }
    }
}
