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

    /// The depth of what is seen at a pixel, or `nothing`.
    ///
    /// # Panics
    /// Outside the [`bounds`](Self::bounds).
    #[inline]
    #[must_use]
    pub fn get(&self, x: i32, y: i32) -> D {
        self.depths[y as usize * self.width + x as usize]
    }

    /// Keeps the depth of what is now seen at a pixel.
    ///
    /// # Panics
    /// Outside the [`bounds`](Self::bounds).
    #[inline]
    pub fn set(&mut self, x: i32, y: i32, depth: D) {
        self.depths[y as usize * self.width + x as usize] = depth;
    }
}

impl<D: Copy + PartialOrd + Into<f64>> DepthBuffer<D> {
    /// The depths in grey: the nearest is white, the farthest the darkest grey; where nothing is stays black.
    #[must_use]
    pub fn picture(&self) -> Image {
        let drawn = || self.depths.iter().filter(|&&depth| depth != self.nothing).map(|&depth| depth.into());
        let (far, near) = drawn().fold((f64::INFINITY, f64::NEG_INFINITY), |(far, near), depth: f64| {
            (far.min(depth), near.max(depth))
        });
        let bounds = self.bounds;
        let mut picture = Image::new((bounds.max.x + 1) as u16, (bounds.max.y + 1) as u16, Format::Gray);
        for (y, x) in (0..=bounds.max.y).flat_map(|y| (0..=bounds.max.x).map(move |x| (y, x))) {
            let depth = self.get(x, y);
            if depth != self.nothing {
                let share = if near > far { (depth.into() - far) / (near - far) } else { 1.0 };
                let level = (1.0 + share * 254.0).round() as u8;
                picture.set(x, y, Color::rgb(level, level, level));
            }
        }
        picture
    }
}

/// The mean of three corners' depths, each with its weight. Measured from the first one, so that a triangle
/// whose corners have one depth has it everywhere, to the last bit, and equal depths compare as equal.
// ANCHOR: fill_nearest
#[inline]
#[must_use]
pub fn depth_at(depths: Vec3, weights: Vec3) -> f32 {
    depths.x + weights.y * (depths.y - depths.x) + weights.z * (depths.z - depths.x)
}

/// Calls `visit(x, y, weights)` for each pixel of a triangle that is nearer than what was drawn there, and
/// keeps its depth. Corners are x and y in pixels and z the depth, which `store` turns into what is kept. A
/// triangle with a depth that is not finite is left out.
pub fn fill_nearest<D: Copy + PartialOrd>(
    corners: [Vec3; 3],
    depths: &mut DepthBuffer<D>,
    store: impl Fn(f32) -> D,
    mut visit: impl FnMut(i32, i32, Vec3),
) {
    let z = Vec3::from_array(corners.map(|corner| corner.z));
    if !z.is_finite() {
        return;
    }
    fill(corners.map(Vec3::truncate), depths.bounds(), |x, y, weights| {
        let depth = store(depth_at(z, weights));
        if depth > depths.get(x, y) {
            depths.set(x, y, depth);
            visit(x, y, weights);
        }
    });
}
// ANCHOR_END: fill_nearest
