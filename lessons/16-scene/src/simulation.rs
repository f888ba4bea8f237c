//! A version's scene while time passes and keys are pressed: what the window shows, and what is drawn without one.

use std::time::Duration;

use common::Mat4;
use common::program::UsageError;
use transforms::inverse::rigid;

use crate::held::{Held, PRESS};
use crate::keys::{Key, Presses};
use crate::levels::Sizes;
use crate::orbit::Orbit;
use crate::render::{Counts, render_scene};
use crate::scene::Scene;
use crate::target::Target;
use crate::versions::{VERSIONS, Version};

/// Up to so many pixels have sixteen samples: depths and colours of more would take over 2 GB.
const MOST_PIXELS: usize = 1 << 24;

/// A version's scene, the second that it is at, the eye, and what the keys have switched.
pub struct Simulation {
    version: &'static Version,
    scene: Scene,
    time: Duration,
    is_paused: bool,
    orbit: Option<Orbit>,
    held: Held,
    wireframe: bool,
    antialiased: bool,
    is_over: bool,
}

impl Simulation {
    /// A version at its beginning, with spheres of those sizes. Where F2 is known, edges are smooth at first.
    ///
    /// # Errors
    /// Where a file cannot be read.
    pub fn new(version: &'static Version, sizes: Sizes) -> anyhow::Result<Self> {
        Ok(Self {
            version,
            scene: (version.scene)(sizes)?,
            time: Duration::ZERO,
            is_paused: false,
            orbit: version.camera,
            held: Held::default(),
            wireframe: false,
            antialiased: version.antialiasing,
            is_over: false,
        })
    }

    /// The version.
    #[must_use]
    pub fn version(&self) -> &'static Version {
        self.version
    }

    /// Stops at a time, counted from the beginning: the scene stands still, the eye does not.
    pub fn stop_at(&mut self, time: Duration) {
        (self.time, self.is_paused) = (time, true);
    }

    /// Stops the scene where it is, or lets it go on.
    pub fn pause(&mut self) {
        self.is_paused = !self.is_paused;
    }

    /// Whether it is stopped.
    #[must_use]
    pub fn is_paused(&self) -> bool {
        self.is_paused
    }

    /// Whether it was ended by a key.
    #[must_use]
    pub fn is_over(&self) -> bool {
        self.is_over
    }

    /// Whether another picture would be another one, though no further key is pressed.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        let turns = self.version.animate.is_some() && !self.is_paused;
        turns || self.orbit.is_some() && self.held.is_moving()
    }

    // ANCHOR: press
    /// Key down. What the version does not have does nothing.
    pub fn press(&mut self, key: Key) {
        match key {
            _ if !self.version.has(key) => {}
            Key::Escape => self.is_over = true,
            Key::F1 => self.wireframe = !self.wireframe,
            Key::F2 => self.antialiased = !self.antialiased,
            _ => {
                if let (Some((axis, way)), Some(orbit)) = (key.moves(), &mut self.orbit) {
                    self.held.press(axis, way, orbit);
                }
            }
        }
    }

    /// Key up.
    pub fn release(&mut self, key: Key) {
        if let Some((axis, way)) = key.moves() {
            self.held.release(axis, way);
        }
    }
    // ANCHOR_END: press

    /// All keys up.
    pub fn release_all(&mut self) {
        self.held.release_all();
    }

    // ANCHOR: advance
    /// Lets time pass: the scene turns, unless it is paused, and held keys move the eye.
    pub fn advance(&mut self, time: Duration) {
        if !self.is_paused {
            self.time += time;
        }
        self.hold(i64::try_from(time.as_nanos()).unwrap_or(i64::MAX));
    }

    fn hold(&mut self, nanoseconds: i64) {
        if let Some(orbit) = &mut self.orbit {
            self.held.advance(nanoseconds, orbit);
        }
    }
    // ANCHOR_END: advance

    // ANCHOR: replay
    /// Presses keys one after the other, each for a twelfth of a second, while the scene stands still. What comes after
    /// Escape is not pressed.
    ///
    /// # Errors
    /// Where the version does not have one of them; then none is pressed.
    pub fn replay(&mut self, presses: &Presses) -> Result<(), UsageError> {
        if let Some(key) = presses.0.iter().find(|&&key| !self.version.has(key)) {
            let (name, number) = (key.name(), self.version.number);
            let first = VERSIONS.iter().find(|version| version.has(*key)).map_or(0, |version| version.number);
            return Err(UsageError(format!(
                "--keys {name}: version {number} has no such key, version {first} has"
            )));
        }
        for &key in &presses.0 {
            if self.is_over {
                break;
            }
            self.press(key);
            self.release(key);
            self.hold(PRESS);
        }
        Ok(())
    }
    // ANCHOR_END: replay

    /// Where the eye is, if it can move.
    #[must_use]
    pub fn orbit(&self) -> Option<Orbit> {
        self.orbit
    }

    /// Puts the eye elsewhere, if it can move.
    pub fn look_from(&mut self, orbit: Orbit) {
        self.orbit = self.orbit.and(Some(orbit));
    }

    /// Pulls what is seen by so many pixels to the right and down, in a picture so many pixels high.
    pub fn drag(&mut self, right: f64, down: f64, height: u32) {
        self.orbit = self.orbit.map(|orbit| orbit.dragged(right, down, height));
    }

    /// Turns the mouse's wheel by so many lines, nearer where they are positive.
    pub fn scroll(&mut self, lines: f64) {
        self.orbit = self.orbit.map(|orbit| orbit.scrolled(lines));
    }

    /// Whether a picture of that size can have as many samples as are asked for: edges of larger ones stay as they are.
    #[must_use]
    pub fn fits(&self, [width, height]: [u16; 2]) -> bool {
        !self.antialiased || usize::from(width) * usize::from(height) <= MOST_PIXELS
    }

    /// Draws what is seen now; nothing where the picture has no pixels.
    pub fn draw(&mut self, target: &mut Target) -> Counts {
        let size = [target.picture().width(), target.picture().height()].map(|side| side as u16);
        if size.contains(&0) {
            return Counts::default();
        }
        target.wireframe = self.wireframe;
        target.antialiased = self.antialiased && self.fits(size);
        if let Some(animate) = self.version.animate {
            animate(&mut self.scene, self.time.as_secs_f64());
        }
        let projection = (self.version.projection)(target.picture().size());
        let camera = self.orbit.map_or(Mat4::IDENTITY, |orbit| orbit.camera());
        // A camera is turned and moved, never stretched: of lesson 7's inverses, the one for rigid maps.
        render_scene(&self.scene, target, &projection, &rigid(&camera))
    }
}
