//! A triangle made ready to be drawn, in as few bytes as will do, since there may be a million.

use common::{Bounds, DVec3, IVec2, Vec2, Vec3, Vec3Swizzles, Vec4, Vec4Swizzles};
use perspective::interpolation::relative;
use triangles::edges::{SUBPIXELS, snap};

/// What is kept of a triangle between the moment when its corners are known and that when its pixels are drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ready<C, V> {
    /// Its corners in 1/256 px.
    pub(crate) corners: [[i32; 2]; 3],
    /// Their depths.
    pub(crate) z: Vec3,
    /// Their 1/w, as shares of the largest.
    pub(crate) inverse_w: Vec3,
    /// What the shader's own step gave.
    pub(crate) constant: C,
    /// What is interpolated.
    pub(crate) varyings: [V; 3],
}

/// The edge functions of a triangle as linear functions of a pixel's column and row: lesson 3's, the same whole numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edges {
    /// At the centre of pixel (0, 0).
    pub(crate) origin: DVec3,
    /// What a pixel to the right adds.
    pub(crate) right: DVec3,
    /// What a pixel up adds.
    pub(crate) up: DVec3,
    /// The least value inside.
    pub(crate) inside: DVec3,
    /// One over twice the area.
    pub(crate) per_area: f64,
}

/// Up to where a corner's edge functions are exact: a guard band lets none beyond.
const FARTHEST: f32 = (1 << 17) as f32;

impl<C, V> Ready<C, V> {
    /// From corners in the window. `None` where lessons 3 and 10 leave a triangle out, too.
    #[inline(always)]
    pub(crate) fn new(corners: [Vec4; 3], constant: C, varyings: [V; 3]) -> Option<Self> {
        let z = Vec3::from_array(corners.map(|corner| corner.z));
        let inverse_w = relative(corners).filter(|_| z.is_finite())?;
        // NaN is within no limit.
        let near = |corner: &Vec4| corner.xy().abs().cmple(Vec2::splat(FARTHEST)).all();
        let near = corners.iter().all(near);
        let corners = corners.map(|corner| snap(corner.xy()).map(|coordinate| coordinate as i32));
        near.then_some(Self { corners, z, inverse_w, constant, varyings })
    }

    /// Where it is, and not how it looks.
    #[inline(always)]
    pub(crate) fn bare(&self) -> Ready<(), ()> {
        let &Self { corners, z, inverse_w, .. } = self;
        Ready { corners, z, inverse_w, constant: (), varyings: [(); 3] }
    }

    /// The pixels with their centre in the box about the corners, in a picture of these; empty where `max` is below `min`.
    #[inline(always)]
    pub(crate) fn bounds(&self, picture: Bounds) -> Bounds {
        const HALF: i32 = SUBPIXELS as i32 / 2;
        let [a, b, c] = self.corners.map(IVec2::from_array);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        // An arithmetic shift rounds down.
        let [first, last]: [IVec2; 2] = [(low + (HALF - 1)) >> 8, (high - HALF) >> 8];
        Bounds { min: first.max(picture.min), max: last.min(picture.max) }
    }

    /// Its edge functions; `None` where it has no area.
    #[inline(always)]
    pub(crate) fn edges(&self) -> Option<Edges> {
        let [x, y] = [0, 1].map(|axis| {
            let [a, b, c] = self.corners.map(|corner| f64::from(corner[axis]));
            DVec3::new(a, b, c)
        });
        let area = (x.y - x.x) * (y.z - y.x) - (y.y - y.x) * (x.z - x.x);
        if area == 0.0 {
            return None;
        }
        // A side runs from the next corner to the one after that; clockwise ones are walked in the other direction.
        let turn = area.signum();
        let (along_x, along_y) = ((x.zxy() - x.yzx()) * turn, (y.zxy() - y.yzx()) * turn);
        let center = SUBPIXELS as f64 / 2.0;
        let top_left = along_y.cmplt(DVec3::ZERO) | (along_y.cmpeq(DVec3::ZERO) & along_x.cmplt(DVec3::ZERO));
        Some(Edges {
            origin: along_x * (center - y.yzx()) - along_y * (center - x.yzx()),
            right: along_y * -SUBPIXELS as f64,
            up: along_x * SUBPIXELS as f64,
            inside: DVec3::select(top_left, DVec3::ZERO, DVec3::ONE),
            per_area: 1.0 / area.abs(),
        })
    }
}

impl Edges {
    /// At the centre of a pixel.
    #[inline(always)]
    pub(crate) fn at(&self, x: i32, y: i32) -> DVec3 {
        self.origin + self.right * f64::from(x) + self.up * f64::from(y)
    }
}
