//! The camera that circles about (0, 0, 0), and how it is moved.
//!
//! The eye lies on a sphere: azimuth and elevation are its longitude and latitude, the distance is the radius. It always
//! looks at the middle, with up being up, as behind the player of a third-person game.
//!
//! What moves it is counted in whole nanoseconds of a key's time, never in degrees: sums of integers do not hang on how
//! they are split, so frames of any length lead to the same place, to the last bit.

use common::{Mat4, Vec3};
use libm::{asin, exp2};
use transforms::affine::{rotate_x, rotate_y};
use transforms::translate;

/// A full turn takes so long.
const TURN: i64 = 4_000_000_000;

/// Twice as near, or as far, takes so long.
const DOUBLE: i64 = 1_000_000_000;

/// The eye comes so many times as near as at the start, and goes so many times as far, in powers of two.
const MOST_DOUBLES: i64 = 3;

/// From the equator up to 89°, at the speed of a turn: at the pole itself, left and right would turn the picture on the spot.
const STEEPEST: i64 = TURN * 89 / 360;

// ANCHOR: orbit
/// The matrix of a camera that circles about (0, 0, 0) and looks at it: from eye space, in which the eye is the origin and
/// looks along −z, to the world. (What takes points before the eye is its inverse.)
///
/// Azimuth and elevation in degrees: with both 0 the eye is at (0, 0, distance). As the azimuth grows it moves to its
/// right, towards +x; as the elevation grows it rises, towards +y. From right to left: the eye is drawn back along its
/// own z, the arm that holds it is raised about x, then swung about y.
#[must_use]
pub fn orbit(azimuth: f32, elevation: f32, distance: f32) -> Mat4 {
    Mat4::from_mat3(rotate_y(azimuth) * rotate_x(-elevation)) * translate(Vec3::new(0.0, 0.0, distance))
}
// ANCHOR_END: orbit

/// A direction in which the eye moves, there and back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Around the middle: to the right, or else to the left.
    Around,
    /// Up, or else down; not over the poles.
    Up,
    /// Nearer, or else farther.
    Nearer,
}

impl Axis {
    /// All of them, in their order.
    pub const ALL: [Self; 3] = [Self::Around, Self::Up, Self::Nearer];
}

/// Which way along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// To the left, down, farther.
    Back,
    /// To the right, up, nearer.
    There,
}

// ANCHOR: state
/// Where a circling eye is: so many nanoseconds of movement away from the front, the equator and its first distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    around: i64,
    up: i64,
    nearer: i64,
    /// As far down as it goes.
    lowest: i64,
    /// It stays above a floor of that height.
    floor: f32,
    /// At first, in units of the world.
    distance: f32,
}
// ANCHOR_END: state

impl Orbit {
    /// An eye at an azimuth and an elevation in degrees, and a distance, as in [`orbit`]. The elevation is kept 1° away
    /// from the poles.
    #[must_use]
    pub const fn new(azimuth: f32, elevation: f32, distance: f32) -> Self {
        let around = time(azimuth).rem_euclid(TURN);
        let up = time(elevation.clamp(-89.0, 89.0));
        Self { around, up, nearer: 0, lowest: -STEEPEST, floor: f32::NEG_INFINITY, distance }
    }

    /// The same eye, which sinks no lower than it is, and stays above a floor of that height, below 0, however far it goes.
    #[must_use]
    pub const fn above(self, floor: f32) -> Self {
        Self { lowest: self.up, floor, ..self }
    }

    // ANCHOR: moved
    /// The eye after it has moved along an axis for so many nanoseconds, or back where they are negative. It goes around
    /// without an end; elsewhere it stops where it must.
    #[must_use]
    pub fn moved(self, axis: Axis, nanoseconds: i64) -> Self {
        let within = |at: i64, least: i64, most: i64| at.saturating_add(nanoseconds).clamp(least, most);
        match axis {
            Axis::Around => Self { around: (self.around + nanoseconds % TURN).rem_euclid(TURN), ..self },
            Axis::Up => Self { up: within(self.up, self.lowest, STEEPEST), ..self },
            Axis::Nearer => {
                let most = MOST_DOUBLES * DOUBLE;
                Self { nearer: within(self.nearer, -most, most), ..self }
            }
        }
    }
    // ANCHOR_END: moved

    /// The eye after a share of a full turn to the right: stop `n` of so many.
    ///
    /// # Panics
    /// Where there are no stops.
    #[must_use]
    pub fn turned(self, n: u16, stops: u16) -> Self {
        self.moved(Axis::Around, TURN * i64::from(n) / i64::from(stops))
    }

    /// The eye after something was pulled by so many pixels to the right and down, in a window of that height: what is seen
    /// follows, so the eye goes the other way. From top to bottom is half a turn.
    #[must_use]
    pub fn dragged(self, right: f64, down: f64, height: u32) -> Self {
        let time = |pixels: f64| whole(pixels / f64::from(height.max(1)) * TURN as f64 / 2.0);
        self.moved(Axis::Around, time(-right)).moved(Axis::Up, time(down))
    }

    /// The eye after the mouse's wheel has turned by so many lines, nearer where they are positive: twelve are twice as
    /// near.
    #[must_use]
    pub fn scrolled(self, lines: f64) -> Self {
        self.moved(Axis::Nearer, whole(lines / 12.0 * DOUBLE as f64))
    }

    /// Its longitude in degrees, 0 up to 360.
    #[must_use]
    pub fn azimuth(&self) -> f32 {
        (self.around as f64 * 360.0 / TURN as f64) as f32
    }

    /// Its latitude in degrees, −89 to 89. On a floor it lies: what it has sunk is kept, so that nearer it sinks again.
    #[must_use]
    pub fn elevation(&self) -> f32 {
        let on_floor = asin(f64::from(self.floor / self.distance()).max(-1.0)).to_degrees();
        (self.up as f64 * 360.0 / TURN as f64).max(on_floor) as f32
    }

    /// How far it is from (0, 0, 0): an eighth of the first distance to eight times as much.
    #[must_use]
    pub fn distance(&self) -> f32 {
        (f64::from(self.distance) * exp2(-(self.nearer as f64) / DOUBLE as f64)) as f32
    }

    /// Its matrix, from eye space to the world, as [`orbit`] gives it.
    #[must_use]
    pub fn camera(&self) -> Mat4 {
        orbit(self.azimuth(), self.elevation(), self.distance())
    }
}

/// So many degrees take so many nanoseconds.
const fn time(degrees: f32) -> i64 {
    (degrees as f64 / 360.0 * TURN as f64) as i64
}

/// The nearest whole number, and the end of the range beyond; 0 for what is no number.
fn whole(number: f64) -> i64 {
    number.round() as i64
}

#[cfg(test)]
mod tests {
    use common::{DMat3, DVec3};

    use super::*;

    /// The same camera without matrices: where longitude and latitude say that it is, and the basis of lesson 8.
    fn eye(azimuth: f64, elevation: f64) -> DVec3 {
        let [(sin_a, cos_a), (sin_e, cos_e)] = [azimuth, elevation].map(|angle| angle.to_radians().sin_cos());
        DVec3::new(sin_a * cos_e, sin_e, cos_a * cos_e)
    }

    #[test]
    fn the_eye_is_where_longitude_and_latitude_say_and_looks_at_the_middle() {
        for azimuth in (-720..=720).step_by(15) {
            for elevation in (-85..=85).step_by(10) {
                let camera = orbit(azimuth as f32, elevation as f32, 5.0).as_dmat4();
                let z = eye(azimuth.into(), elevation.into());
                let x = DVec3::Y.cross(z).normalize();
                let expected = DMat3::from_cols(x, z.cross(x), z);
                let turn = DMat3::from_mat4(camera);
                assert!(turn.abs_diff_eq(expected, 1e-5), "{azimuth} {elevation}: {turn} {expected}");
                assert!(camera.w_axis.truncate().abs_diff_eq(z * 5.0, 3e-5), "{azimuth} {elevation}");
                assert_eq!(camera.row(3).to_array(), [0.0, 0.0, 0.0, 1.0]);
            }
        }
    }

    #[test]
    fn the_eye_moves_the_way_that_the_axis_says() {
        let place = |orbit: Orbit| orbit.camera().w_axis.truncate();
        let front = Orbit::new(0.0, 0.0, 4.0);
        assert_eq!(place(front), Vec3::new(0.0, 0.0, 4.0));
        assert!(place(front.moved(Axis::Around, 1_000_000)).x > 0.0);
        assert!(place(front.moved(Axis::Up, 1_000_000)).y > 0.0);
        assert_eq!(place(front.moved(Axis::Nearer, DOUBLE)), Vec3::new(0.0, 0.0, 2.0));
        assert!(place(front.moved(Axis::Around, TURN / 4)).abs_diff_eq(Vec3::new(4.0, 0.0, 0.0), 1e-6));
    }

    #[test]
    fn a_start_is_kept_as_it_was_written() {
        for (azimuth, elevation, kept) in
            [(30.0, 20.0, [30.0, 20.0]), (-90.0, -12.5, [270.0, -12.5]), (725.0, 90.0, [5.0, 89.0])]
        {
            let orbit = Orbit::new(azimuth, elevation, 7.5);
            assert_eq!(([orbit.azimuth(), orbit.elevation()], orbit.distance()), (kept, 7.5));
        }
    }

    #[test]
    fn it_stops_before_the_poles_and_at_an_eighth_and_eight_times_the_distance_and_comes_back() {
        let start = Orbit::new(10.0, 20.0, 4.0);
        for (axis, ends) in [(Axis::Up, [-89.0, 89.0]), (Axis::Nearer, [32.0, 0.5])] {
            let read = |orbit: Orbit| if axis == Axis::Up { orbit.elevation() } else { orbit.distance() };
            for (way, end) in [-1, 1].into_iter().zip(ends) {
                let far = [1_000_000_000, 5_000_000_000, i64::MAX]
                    .into_iter()
                    .fold(start, |orbit, time| orbit.moved(axis, way * time));
                assert_eq!(read(far), end);
                // The way back is not longer for having pushed on.
                assert_ne!(read(far.moved(axis, -way * 1_000_000)), end);
            }
        }
        assert_eq!(start.moved(Axis::Around, TURN), start);
        assert_eq!(
            start.moved(Axis::Around, i64::MIN).moved(Axis::Around, i64::MAX).moved(Axis::Around, 1),
            start
        );
    }

    /// However far it goes, a little above the floor, as an `f32` tells places; and the way up begins where it is.
    #[test]
    fn an_eye_above_a_floor_stays_there() {
        let start = Orbit::new(24.0, -4.0, 7.0).above(-0.9);
        assert_eq!(start.elevation(), -4.0);
        for time in (0..=40).map(|n| n * DOUBLE / 10) {
            let down = start.moved(Axis::Nearer, -time).moved(Axis::Up, -10 * TURN);
            let height = down.camera().w_axis.y;
            assert!((-0.9 - 1e-4..0.0).contains(&height), "{time}: {height}");
            assert!(down.moved(Axis::Up, TURN / 36).elevation() > down.elevation() + 5.0, "{time}");
            assert_eq!(down.moved(Axis::Nearer, time.min(3 * DOUBLE)).elevation(), -4.0);
        }
        assert_eq!(Orbit::new(0.0, -80.0, 4.0).moved(Axis::Up, -TURN).elevation(), -89.0);
    }

    #[test]
    fn a_walk_around_comes_back_and_its_stops_are_evenly_far_from_each_other() {
        let start = Orbit::new(30.0, 20.0, 4.0);
        assert_eq!((start.turned(0, 7), start.turned(7, 7)), (start, start));
        assert_eq!([1, 2, 3].map(|n| start.turned(n, 4).azimuth()), [120.0, 210.0, 300.0]);
    }

    #[test]
    fn what_is_pulled_follows_the_mouse_and_the_wheel_goes_by_lines() {
        let start = Orbit::new(90.0, 20.0, 4.0);
        let pulled = start.dragged(100.0, 50.0, 200);
        assert_eq!((pulled.azimuth(), pulled.elevation()), (0.0, 65.0));
        assert_eq!(pulled.dragged(-100.0, -50.0, 200), start);
        assert_eq!([12.0, -24.0, 1e300].map(|lines| start.scrolled(lines).distance()), [2.0, 16.0, 0.5]);
        for wrong in [f64::NAN, 0.0] {
            assert_eq!((start.dragged(wrong, wrong, 0), start.scrolled(wrong)), (start, start));
        }
    }
}
