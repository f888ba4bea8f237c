//! A version's scene as time goes by.

use std::time::Duration;

use common::Mat4;
use transforms::inverse::elimination;

use crate::levels::Sizes;
use crate::orbit::Orbit;
use crate::render::{Counts, render_scene};
use crate::scene::Scene;
use crate::target::Target;
use crate::versions::Version;

/// A version's scene, its time and its camera.
pub struct Simulation {
    version: &'static Version,
    scene: Scene,
    time: Duration,
    orbit: Option<Orbit>,
}

impl Simulation {
    /// A version at its beginning, with spheres of those sizes.
    ///
    /// # Errors
    /// Where a file cannot be read.
    pub fn new(version: &'static Version, sizes: Sizes) -> anyhow::Result<Self> {
        let scene = (version.scene)(sizes)?;
        Ok(Self { version, scene, time: Duration::ZERO, orbit: version.camera })
    }

    /// Lets time go by.
    pub fn advance(&mut self, time: Duration) {
        self.time += time;
    }

    /// Draws what is to be seen now.
    pub fn draw(&mut self, target: &mut Target) -> Counts {
        (self.version.animate)(&mut self.scene, self.time.as_secs_f64());
        let camera = self.orbit.map_or(Mat4::IDENTITY, |orbit| orbit.camera());
        let projection = (self.version.projection)(target.picture().size());
        let inverse = elimination(&camera).unwrap_or(Mat4::IDENTITY);
        render_scene(&self.scene, target, &projection, &inverse)
    }
}
