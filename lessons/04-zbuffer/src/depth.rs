//! A depth for each pixel, and the test against it.
//!
//! The depth of a plane is linear in x and y, so at a pixel's centre it is the mean of the corners' depths,
//! each with its barycentric weight (slides, *Z-buffering*). A pixel is drawn if its depth is nearer than
//! that of whatever was drawn there before; the order of drawing then matters only between equals.

use common::{Bounds, Color, Format, Image, Vec3};
use triangles::fill;

/// The nearest depth drawn in each pixel of a picture. A larger one is nearer.
#[derive(Clone, Debug, PartialEq)]
pub struct DepthBuffer<D> {
    width: usize,
    bounds: Bounds,
    nothing: D,
    depths: Vec<D>,
}

impl<D: Copy + PartialOrd> DepthBuffer<D> {
    /// A buffer for a picture of that size; `nothing` is farther than anything that can be drawn.
    #[must_use]
    pub fn new(image: &Image, nothing: D) -> Self {
        let (width, height) = (image.width() as usize, image.height() as usize);
        Self { width, bounds: image.bounds(), nothing, depths: vec![nothing; width * height] }
    }

    /// The rectangle of its pixels.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Forgets all that was drawn.
    pub fn clear(&mut self) {
        self.depths.fill(self.nothing);
    }

    /// The depth of what is seen at a pixel, or `nothing`.
    ///
    /// # Panics
    /// Outside the [`bounds`](Self::bounds).
    #[inline]
    #[must_use]
    pub fn get(&self, x: i32, y: i32) -> D {
        self.depths[self.place(x, y)]
    }

    /// Keeps the depth of what is now seen at a pixel.
    ///
    /// # Panics
    /// Outside the [`bounds`](Self::bounds).
    #[inline]
    pub fn set(&mut self, x: i32, y: i32, depth: D) {
        let place = self.place(x, y);
        self.depths[place] = depth;
    }

    /// Whether that depth is nearer than what is seen at a pixel; of equal depths neither is.
    ///
    /// # Panics
    /// Outside the [`bounds`](Self::bounds).
    #[inline]
    #[must_use]
    pub fn is_nearer(&self, x: i32, y: i32, depth: D) -> bool {
        depth > self.get(x, y)
    }

    /// Where a pixel's depth is. A row above or below the picture leads past the end, where indexing panics; a
    /// column beside it would lead into another row.
    #[inline]
    fn place(&self, x: i32, y: i32) -> usize {
        let (x, y) = (x as usize, y as usize);
        assert!(x < self.width, "no such column");
        y.wrapping_mul(self.width).wrapping_add(x)
    }
}

impl<D: Copy + PartialOrd + Into<f64>> DepthBuffer<D> {
    /// The depths in grey: the nearest is white, the farthest the darkest grey; where nothing is stays black.
    #[must_use]
    pub fn picture(&self) -> Image {
        self.picture_by(D::into)
    }
}

impl<D: Copy + PartialOrd> DepthBuffer<D> {
    /// The same where `nearness`, larger for what is nearer, is what the grey levels are to show.
    #[must_use]
    pub fn picture_by(&self, nearness: impl Fn(D) -> f64) -> Image {
        let drawn =
            || self.depths.iter().filter(|&&depth| depth != self.nothing).map(|&depth| nearness(depth));
        let (far, near) = drawn().fold((f64::INFINITY, f64::NEG_INFINITY), |(far, near), depth: f64| {
            (far.min(depth), near.max(depth))
        });
        let bounds = self.bounds;
        let mut picture = Image::new((bounds.max.x + 1) as u16, (bounds.max.y + 1) as u16, Format::Gray);
        for (y, x) in (0..=bounds.max.y).flat_map(|y| (0..=bounds.max.x).map(move |x| (y, x))) {
            let depth = self.get(x, y);
            if depth != self.nothing {
                let share = if near > far { (nearness(depth) - far) / (near - far) } else { 1.0 };
                let level = (1.0 + share * 254.0).round() as u8;
                picture.set(x, y, Color::rgb(level, level, level));
            }
        }
        picture
    }
}

/// The mean of three corners' depths, each with its weight. Measured from the farthest one, so that a triangle
/// whose corners have one depth has it everywhere, to the last bit; and of three products one is 0 then, so that
/// the sum is the same in whichever order the corners come: equal surfaces compare as equal.
// ANCHOR: fill_depths
#[inline]
#[must_use]
pub fn depth_at(depths: Vec3, weights: Vec3) -> f32 {
    let farthest = depths.min_element();
    farthest + (depths - farthest).dot(weights)
}

/// Calls `visit(x, y, depth, weights)` for each pixel in `bounds` that a triangle covers. Corners are x and y in
/// pixels and z the depth. A triangle with a depth that is not finite has no plane and is left out.
#[inline]
pub fn fill_depths(corners: [Vec3; 3], bounds: Bounds, mut visit: impl FnMut(i32, i32, f32, Vec3)) {
    let z = Vec3::from_array(corners.map(|corner| corner.z));
    if z.is_finite() {
        let corners = corners.map(Vec3::truncate);
        fill(corners, bounds, move |x, y, weights| visit(x, y, depth_at(z, weights), weights));
    }
}
// ANCHOR_END: fill_depths

/// Calls `visit(x, y, weights)` for each pixel of a triangle that is nearer than what was drawn there, and then
/// keeps its depth, which `store` turns into what is kept. Corners are as in [`fill_depths`].
// ANCHOR: fill_nearest
pub fn fill_nearest<D: Copy + PartialOrd>(
    corners: [Vec3; 3],
    depths: &mut DepthBuffer<D>,
    store: impl Fn(f32) -> D,
    mut visit: impl FnMut(i32, i32, Vec3),
) {
    fill_depths(corners, depths.bounds(), |x, y, depth, weights| {
        let depth = store(depth);
        if depths.is_nearer(x, y, depth) {
            visit(x, y, weights);
            depths.set(x, y, depth);
        }
    });
}
// ANCHOR_END: fill_nearest
