//! What a ray from an eye meets, in `f64`: no matrix, no division by w, no weights in a picture.
//!
//! The eye is at the origin and looks along −z.

use common::{DVec2, DVec3, Vec4};

/// The rectangle on the plane z = −1 that fills a picture.
#[derive(Clone, Copy, Debug)]
pub struct Screen {
    /// Its bottom left corner.
    pub low: DVec2,
    /// Its top right corner.
    pub high: DVec2,
    /// Width and height of the picture, in pixels.
    pub pixels: DVec2,
}

/// A point of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// How much each corner counts there: the point is the sum of the corners with these weights.
    pub weights: DVec3,
    /// How far before the eye it is, along −z.
    pub depth: f64,
}

impl Screen {
    /// Straight ahead, `fov` degrees from bottom to top.
    #[must_use]
    pub fn ahead(fov: f64, pixels: DVec2) -> Self {
        let top = (fov / 360.0 * std::f64::consts::PI).tan();
        let high = DVec2::new(top * pixels.x / pixels.y, top);
        Self { low: -high, high, pixels }
    }

    /// The direction of the ray through a point of the picture, in pixels; it is at depth 1.
    #[must_use]
    pub fn direction(&self, at: DVec2) -> DVec3 {
        (self.low + (self.high - self.low) * (at / self.pixels)).extend(-1.0)
    }

    /// The ray through the centre of a pixel.
    #[must_use]
    pub fn through(&self, x: i32, y: i32) -> DVec3 {
        self.direction(DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5))
    }

    /// The point that is seen at a place of the window: x and y in pixels, and 1/w as the fourth coordinate.
    #[must_use]
    pub fn point(&self, window: Vec4) -> DVec3 {
        self.direction(DVec2::new(window.x.into(), window.y.into())) / f64::from(window.w)
    }
}

/// Where the ray from the eye in a direction meets the plane of a triangle. NaN or infinite where it does not.
///
/// With A, B, C the corners and d the direction, μA·A + μB·B + μC·C = s·d by Cramer's rule for μ/s, and the μ sum to 1.
#[must_use]
pub fn hit([a, b, c]: [DVec3; 3], direction: DVec3) -> Hit {
    let parts = DVec3::new(b.cross(c).dot(direction), c.cross(a).dot(direction), a.cross(b).dot(direction));
    let whole = parts.element_sum();
    Hit { weights: parts / whole, depth: -direction.z * a.dot(b.cross(c)) / whole }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_a_slanting_side_is_seen_off_its_middle() {
        // From 1 before the eye on the left to 3 before it on the right.
        let triangle = [DVec3::new(-1.0, 0.0, -1.0), DVec3::new(3.0, 0.0, -3.0), DVec3::new(0.0, 1.0, -2.0)];
        let seen = hit(triangle, DVec3::new(0.0, 0.0, -1.0));
        assert_eq!(seen, Hit { weights: DVec3::new(0.75, 0.25, 0.0), depth: 1.5 });
        // The middle of that side is at (1, 0, −2).
        let middle = hit(triangle, DVec3::new(0.5, 0.0, -1.0));
        assert_eq!(middle, Hit { weights: DVec3::new(0.5, 0.5, 0.0), depth: 2.0 });
    }

    #[test]
    fn a_screen_of_90_degrees_reaches_as_far_up_as_ahead() {
        let screen = Screen::ahead(90.0, DVec2::new(200.0, 100.0));
        assert!((screen.direction(DVec2::new(200.0, 100.0)) - DVec3::new(2.0, 1.0, -1.0)).length() < 1e-15);
        assert!((screen.through(99, 49) - DVec3::new(-0.01, -0.01, -1.0)).length() < 1e-15);
        let seen = screen.point(Vec4::new(0.0, 50.0, 0.0, 0.25));
        assert!((seen - DVec3::new(-8.0, 0.0, -4.0)).length() < 1e-14);
    }
}
