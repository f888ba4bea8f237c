//! What mission 4 gives: a depth for each pixel, and triangles as they will be seen. Nothing of lesson 4 is in it, so that the
//! program in which a submission runs has nothing of it either.

use common::{Bounds, Color, Image, Model, Vec2, Vec3};
use triangles::flat_intensity;

/// The nearest depth drawn in each pixel of a picture. A larger one is nearer.
#[derive(Clone, Debug, PartialEq)]
pub struct DepthBuffer<D> {
    width: usize,
    bounds: Bounds,
    depths: Vec<D>,
}

impl<D: Copy> DepthBuffer<D> {
    /// A buffer for a picture of that size; `nothing` is farther than anything that can be drawn.
    #[must_use]
    pub fn new(image: &Image, nothing: D) -> Self {
        let (width, height) = (image.width() as usize, image.height() as usize);
        Self { width, bounds: image.bounds(), depths: vec![nothing; width * height] }
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
    #[must_use]
    pub fn get(&self, x: i32, y: i32) -> D {
        self.depths[self.place(x, y)]
    }

    /// Keeps the depth of what is now seen at a pixel.
    ///
    /// # Panics
    /// Outside the [`bounds`](Self::bounds).
    pub fn set(&mut self, x: i32, y: i32, depth: D) {
        let place = self.place(x, y);
        self.depths[place] = depth;
    }

    /// Where a pixel's depth is. A row above or below the picture leads past the end, where indexing panics; a column
    /// beside it would lead into another row.
    fn place(&self, x: i32, y: i32) -> usize {
        let (x, y) = (x as usize, y as usize);
        assert!(x < self.width, "no such column");
        y.wrapping_mul(self.width).wrapping_add(x)
    }
}

/// A triangle as it will be seen, in one colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Its corners: x and y in pixels, z the depth.
    pub corners: [Vec3; 3],
    /// Its colour.
    pub color: Color,
}

/// The triangles of a flat-shaded model in the picture; those that face away from the light are left out.
#[must_use]
pub fn surfaces(model: &Model, light: Vec3, image: &Image) -> Vec<Surface> {
    let lit = model.faces().map(|corners| (corners, flat_intensity(corners, light)));
    lit.filter(|&(_, intensity)| intensity >= 0.0)
        .map(|(corners, intensity)| Surface {
            corners: corners.map(|corner| to_screen(corner, image.size())),
            color: Color::gray(intensity),
        })
        .collect()
}

/// A point of the model in a picture of that size: x and y in pixels as in lesson 3, z as the depth.
#[must_use]
pub fn to_screen(point: Vec3, size: Vec2) -> Vec3 {
    triangles::to_screen(point, size).extend(point.z)
}
