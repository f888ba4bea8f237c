//! A mesh in several resolutions, of which the coarsest is drawn that looks like the finest.
//!
//! What triangles stand for is nearer to them than some distance, in the model's units. [`pixels_per_unit`](crate::frustum)
//! tells how many pixels that is at most; half a pixel is as good as nothing, since a pixel's centre is never farther from its
//! border (J. Clark, *Hierarchical geometric models for visible surface algorithms*, Communications of the ACM 19, 1976, has the
//! idea: details by the size on the screen). So the same few numbers choose a sphere's triangles and the head's.
//!
//! There is no memory in this: the same view has the same levels, whatever was seen before. Where a level changes with every
//! frame to and fro, the picture changes less than by what moves it there: each of the two is within half a pixel of the surface.

use std::f64::consts::PI;
use std::sync::Arc;

use common::{Method, Vec3};

use crate::mesh::{Mesh, Paint};
use crate::shapes::sphere;

/// The latitudes and longitudes of the spheres that there are to choose from, from coarse to fine.
pub type Sizes = &'static [[usize; 2]];

/// The ways to choose how many triangles a sphere has.
pub const METHODS: &[Method<Sizes>] = &[
    Method {
        name: "8x16",
        run: &[[8, 16]],
        promise: "224 triangles, wherever it stands; half a pixel off at most up to a radius of 13 px",
        failure: "corners are seen beyond 13 px of radius",
    },
    Method {
        name: "32x64",
        run: &[[32, 64]],
        promise: "3,968 triangles, wherever it stands; half a pixel off at most up to a radius of 207 px",
        failure: "corners from near; from afar several triangles to a pixel",
    },
    Method {
        name: "128x256",
        run: &[[128, 256]],
        promise: "65,024 triangles, wherever it stands; half a pixel off at most up to a radius of 3,320 px",
        failure: "hardly ever seen to be wrong, and always paid for: 65,024 triangles for a sphere of one pixel, too",
    },
    Method {
        name: "by-size",
        run: &[
            [3, 6],
            [4, 8],
            [6, 12],
            [8, 16],
            [12, 24],
            [16, 32],
            [24, 48],
            [32, 64],
            [48, 96],
            [64, 128],
            [96, 192],
            [128, 256],
        ],
        promise: "the coarsest of 12 steps, each about twice the last, whose bound on the error is half a pixel at most",
        failure: "where the eye is so near that the radius is more than 3,320 px; all steps are in memory, 5 MB for each paint",
    },
];

/// A mesh in one or several resolutions, from coarse to fine.
pub struct Levels {
    levels: Vec<(Mesh, f32)>,
    bounds: (Vec3, f32),
}

impl Levels {
    /// A mesh in one resolution.
    #[must_use]
    pub fn one(mesh: Mesh) -> Arc<Self> {
        Self::new(vec![(mesh, 0.0)])
    }

    /// Meshes from coarse to fine, each with its largest distance from the surface that it stands for, in the model's
    /// units.
    ///
    /// # Panics
    /// Where there is none.
    #[must_use]
    pub fn new(levels: Vec<(Mesh, f32)>) -> Arc<Self> {
        let (center, _) = levels.last().expect("at least one level").0.bounds();
        let positions = levels.iter().flat_map(|(mesh, _)| mesh.positions());
        let farthest = positions.map(|p| p.as_dvec3().distance(center.as_dvec3())).fold(0.0, f64::max);
        Arc::new(Self { levels, bounds: (center, (farthest as f32).next_up()) })
    }

    /// The coarsest that is nowhere farther than half a pixel from its surface, where a unit of the model is at most so many
    /// pixels; or else the finest.
    // ANCHOR: choose
    #[must_use]
    pub fn choose(&self, pixels_per_unit: f32) -> &Mesh {
        let fine = self.levels.iter().find(|(_, error)| error * pixels_per_unit <= 0.5);
        fine.map_or(self.finest(), |(mesh, _)| mesh)
    }
    // ANCHOR_END: choose

    /// The finest.
    #[must_use]
    pub fn finest(&self) -> &Mesh {
        &self.levels[self.levels.len() - 1].0
    }

    /// All of them with their distances, from coarse to fine.
    #[must_use]
    pub fn all(&self) -> &[(Mesh, f32)] {
        &self.levels
    }

    /// The middle of a sphere that all of them are within, and that sphere's radius, in the model's space.
    #[must_use]
    pub fn bounds(&self) -> (Vec3, f32) {
        self.bounds
    }
}

/// Spheres of radius 1 in those sizes.
///
/// # Panics
/// As [`sphere`].
#[must_use]
pub fn spheres(sizes: &[[usize; 2]], paint: &Paint) -> Arc<Levels> {
    let level = |&[latitudes, longitudes]: &[usize; 2]| {
        let mesh = Mesh::new(&sphere(latitudes, longitudes), paint.clone());
        // Corners are rounded to `f32`, which brings them up to 2⁻²⁴ times √3/2 off the sphere.
        (mesh, error(latitudes, longitudes) as f32 + f32::EPSILON)
    };
    Levels::new(sizes.iter().map(level).collect())
}

/// How far the triangles of [`sphere`] are from the true one of radius 1, where they are farthest.
///
/// **Derivation.** Corners are on the sphere, so the triangles are inside of it, and farthest where they are nearest to its
/// middle. The two triangles of a cell are in one plane, as the cell's upper and lower side are parallel, and a cell is its own
/// mirror image: the nearest point is half-way between its columns. There, with a = π/longitudes, all corners' sides of a row are
/// at cos a times their distance from the axis: the cut through the mesh is a polygon with its corners on the ellipse
/// (cos a · sin θ, cos θ), at each θ of a row. With h = π/(2·latitudes) the side between θ = m − h and m + h is on the line
/// (sin m/cos a)·x + cos m·y = cos h, since that is so of the circle's chord. Its distance from the middle is
///
/// ```text
/// cos h / √(sin² m/cos² a + cos² m) = cos h / √(1 + sin² m · tan² a)
/// ```
///
/// which is least for the belt next to the equator: for an odd number of latitudes it lies across, m = π/2, for an even one
/// beside, sin m = cos h. The foot of the perpendicular is on that side, by symmetry in the first case and in the second as
/// cos² a · cos 2h < 1 + cos 2h; so the distance is reached.
// ANCHOR: error
#[must_use]
pub fn error(latitudes: usize, longitudes: usize) -> f64 {
    let [h, a] = [PI / (2 * latitudes) as f64, PI / longitudes as f64];
    let sin_m = if latitudes.is_multiple_of(2) { libm::cos(h) } else { 1.0 };
    1.0 - libm::cos(h) / libm::hypot(1.0, sin_m * libm::tan(a))
}
// ANCHOR_END: error

#[cfg(test)]
mod tests {
    use common::Color;

    use super::*;

    /// 8 and 16: cos 11.25° / √(1 + cos² 11.25° · tan² 11.25°); 3 and 6: cos² 30°.
    #[test]
    fn errors_of_the_first_steps() {
        assert!((error(8, 16) - 0.0374).abs() < 5e-5, "{}", error(8, 16));
        assert!((error(3, 6) - 0.25).abs() < 1e-15, "{}", error(3, 6));
        // With 2 latitudes and 4 longitudes it is an octahedron, whose sides are 1/√3 from the middle.
        assert!((error(2, 4) - (1.0 - 1.0 / 3.0_f64.sqrt())).abs() < 1e-15, "{}", error(2, 4));
    }

    /// Half a pixel is still good enough; of what is too coarse at any size the finest is taken, even where the size is none.
    #[test]
    fn the_coarsest_that_is_fine_enough() {
        let mesh = |n| Mesh::new(&sphere(n, 2 * n), Paint::Color(Color::WHITE));
        let levels = Levels::new(vec![(mesh(2), 0.25), (mesh(4), 0.0625), (mesh(8), 0.015_625)]);
        for (pixels, triangles) in [
            (0.0, 8),
            (2.0, 8),
            (2.001, 48),
            (8.0, 48),
            (8.001, 224),
            (32.0, 224),
            (1e9, 224),
            (f32::INFINITY, 224),
        ] {
            assert_eq!(levels.choose(pixels).triangles(), triangles, "{pixels}");
        }
        assert_eq!(levels.choose(f32::NAN).triangles(), 224);
        // Of one that is exact there is nothing to choose from.
        assert_eq!(Levels::one(mesh(2)).choose(f32::INFINITY).triangles(), 8);
    }
}
