//! Where a model is put when it is read.

use glam::DVec3;

/// How far from the origin a model reaches that was fitted: √(4/5). From a distance of 2, the default, the
/// outline of a sphere of radius r is seen at r/√(1 − r²/4), which is 1 then, the border of the picture.
const RADIUS: f64 = 0.894_427_190_999_915_9;

/// What happens to the coordinates of a file, in f64, before they become `f32`; by default, nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Placement {
    /// First the model is moved and scaled into view, whatever its units, if its up is given.
    pub fit: Option<Up>,
    /// Then this point becomes the origin: near it no digit is lost, however far away it was.
    pub origin: DVec3,
}

/// The axis of a file that is up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Up {
    /// As in this course.
    Y,
    /// As in programs for construction and maps: z becomes y, and y becomes −z.
    Z,
}

/// How a model was fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// The sides of its box, in the file's units and axes.
    pub size: DVec3,
    /// The middle of that box, which became the origin.
    pub middle: DVec3,
    /// What one unit of the file became.
    pub scale: f64,
    /// The axis that is up.
    pub up: Up,
}

impl Fit {
    /// What brings these positions into view: the middle of their box to the origin, the one that is farthest
    /// from it to a distance of √(4/5). What has no size keeps it.
    pub(crate) fn of(positions: &[DVec3], up: Up) -> Self {
        let min = positions.iter().copied().reduce(DVec3::min).unwrap_or_default();
        let max = positions.iter().copied().reduce(DVec3::max).unwrap_or_default();
        let middle = min.midpoint(max);
        let farthest = positions.iter().map(|position| position.distance(middle)).fold(0.0, f64::max);
        let scale = if farthest > 0.0 { RADIUS / farthest } else { 1.0 };
        Self { size: max - min, middle, scale, up }
    }

    /// Where a position is put.
    pub(crate) fn place(&self, position: DVec3) -> DVec3 {
        self.turn((position - self.middle) * self.scale)
    }

    /// How a direction is turned.
    pub(crate) fn turn(&self, direction: DVec3) -> DVec3 {
        match self.up {
            Up::Y => direction,
            Up::Z => DVec3::new(direction.x, direction.z, -direction.y),
        }
    }
}
