//! A mesh in several resolutions, of which one is drawn that is just fine enough.

use std::sync::Arc;

use common::Method;

use crate::mesh::{Mesh, Paint};
use crate::shapes::sphere;

/// The latitudes and longitudes of the spheres that there are to choose from.
pub type Sizes = &'static [[usize; 2]];

/// The ways to choose how many triangles a sphere has.
pub const METHODS: &[Method<Sizes>] = &[
    Method {
        name: "8x16",
        run: &[[8, 16]],
        promise: "224 triangles, always",
        failure: "corners are seen from near",
    },
    Method {
        name: "32x64",
        run: &[[32, 64]],
        promise: "3,968 triangles, always",
        failure: "corners are seen from very near",
    },
    Method {
        name: "128x256",
        run: &[[128, 256]],
        promise: "65,024 triangles, always",
        failure: "most are smaller than a pixel",
    },
    Method {
        name: "by-size",
        run: &[[3, 6], [6, 12], [12, 24], [24, 48], [48, 96], [96, 192]],
        promise: "as few triangles as half a pixel allows",
        failure: "nothing known",
    },
];

/// A mesh in one or several resolutions, from coarse to fine.
pub struct Levels {
    levels: Vec<(Mesh, f32)>,
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
        assert!(!levels.is_empty(), "at least one level");
        Arc::new(Self { levels })
    }

    /// The coarsest that is nowhere farther than half a pixel from its surface, where a unit of the model is at most so many
    /// pixels; or else the finest.
    #[must_use]
    pub fn choose(&self, pixels_per_unit: f32) -> &Mesh {
        let fine = self.levels.iter().find(|(_, error)| error * pixels_per_unit <= 0.5);
        fine.map_or(self.finest(), |(mesh, _)| mesh)
    }

    /// The finest.
    #[must_use]
    pub fn finest(&self) -> &Mesh {
        &self.levels[self.levels.len() - 1].0
    }
}

/// Spheres of radius 1 in those sizes.
///
/// # Panics
/// As [`sphere`].
#[must_use]
pub fn spheres(sizes: &[[usize; 2]], paint: &Paint) -> Arc<Levels> {
    let level = |&[latitudes, longitudes]: &[usize; 2]| {
        (Mesh::new(&sphere(latitudes, longitudes), paint.clone()), error(latitudes, longitudes) as f32)
    };
    Levels::new(sizes.iter().map(level).collect())
}

/// How far a sphere's triangles are from the true one at most.
#[must_use]
pub fn error(latitudes: usize, longitudes: usize) -> f64 {
    use std::f64::consts::PI;
    1.0 - libm::cos(PI / 2.0 / latitudes as f64) * libm::cos(PI / longitudes as f64)
}
