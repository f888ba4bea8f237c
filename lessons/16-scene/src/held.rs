//! Keys held down, and how they move the eye as time passes.

use std::mem::{replace, take};

use crate::orbit::{Axis, Orbit, Way};

/// What a press moves at least, in nanoseconds: a twelfth of a second, however soon the key is let go.
pub const PRESS: i64 = 1_000_000_000 / 12;

/// A key.
#[derive(Clone, Copy, Debug, Default)]
struct Hold {
    down: bool,
    /// So many nanoseconds it goes on, down or not.
    owed: i64,
}

impl Hold {
    /// For how much of the time that passes it moves the eye.
    fn pass(&mut self, nanoseconds: i64) -> i64 {
        let moving = if self.down { nanoseconds } else { self.owed.min(nanoseconds) };
        self.owed = (self.owed - moving).max(0);
        moving
    }
}

/// The six keys that move the eye: two an axis, one for each [`Way`].
#[derive(Clone, Debug, Default)]
pub struct Held([[Hold; 2]; Axis::ALL.len()]);

impl Held {
    /// Key down. Nothing happens where it is down already, as a keyboard's repetition says again and again.
    ///
    /// What the opposite key still owes although it was let go is moved at once: so presses, one after the other, lead to
    /// the same place however soon they follow, even where one of them ends at a pole.
    pub fn press(&mut self, axis: Axis, way: Way, orbit: &mut Orbit) {
        let [back, there] = &mut self.0[axis as usize];
        let (hold, opposite, sign) = match way {
            Way::Back => (back, there, 1),
            Way::There => (there, back, -1),
        };
        if replace(&mut hold.down, true) {
            return;
        }
        hold.owed += PRESS;
        if !opposite.down {
            *orbit = orbit.moved(axis, sign * take(&mut opposite.owed));
        }
    }

    /// Key up.
    pub fn release(&mut self, axis: Axis, way: Way) {
        self.0[axis as usize][way as usize].down = false;
    }

    /// All keys up: where a window no longer hears of keys, it does not hear of their release.
    pub fn release_all(&mut self) {
        self.0.as_flattened_mut().iter_mut().for_each(|hold| hold.down = false);
    }

    // ANCHOR: advance
    /// Moves the eye by what is held, for so many nanoseconds.
    ///
    /// One key or both: what they do together is there or back, never first one and then the other, so where the eye must
    /// stop it is stopped once.
    pub fn advance(&mut self, nanoseconds: i64, orbit: &mut Orbit) {
        for (axis, keys) in Axis::ALL.into_iter().zip(&mut self.0) {
            let [back, there] = keys.each_mut().map(|key| key.pass(nanoseconds));
            *orbit = orbit.moved(axis, there - back);
        }
    }
    // ANCHOR_END: advance

    /// Whether a key is down, or goes on.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.0.as_flattened().iter().any(|hold| hold.down || hold.owed > 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const START: (f32, f32, f32) = (10.0, 20.0, 4.0);

    fn start() -> Orbit {
        Orbit::new(START.0, START.1, START.2)
    }

    #[test]
    fn a_key_moves_as_long_as_it_is_down_but_a_press_at_least() {
        for (held, moved) in
            [(0, PRESS), (1, PRESS), (PRESS - 1, PRESS), (PRESS, PRESS), (7 * PRESS, 7 * PRESS)]
        {
            let (mut keys, mut orbit) = (Held::default(), start());
            keys.press(Axis::Around, Way::There, &mut orbit);
            keys.advance(held, &mut orbit);
            keys.release(Axis::Around, Way::There);
            assert_eq!(keys.is_moving(), held < PRESS, "{held}");
            keys.advance(10 * PRESS, &mut orbit);
            assert_eq!((orbit, keys.is_moving()), (start().moved(Axis::Around, moved), false), "{held}");
        }
    }

    #[test]
    fn repetition_is_no_press_and_each_press_counts() {
        let (mut keys, mut orbit) = (Held::default(), start());
        (0..30).for_each(|_| keys.press(Axis::Up, Way::Back, &mut orbit));
        keys.release(Axis::Up, Way::Back);
        keys.press(Axis::Up, Way::Back, &mut orbit);
        keys.release_all();
        (0..30).for_each(|_| keys.advance(PRESS / 3, &mut orbit));
        assert_eq!(orbit, start().moved(Axis::Up, -2 * PRESS));
    }

    #[test]
    fn opposite_keys_hold_the_eye_where_it_is_even_before_a_pole() {
        let top = Orbit::new(0.0, 89.0, 4.0);
        let (mut keys, mut orbit) = (Held::default(), top);
        for way in [Way::There, Way::Back] {
            keys.press(Axis::Up, way, &mut orbit);
        }
        keys.advance(5 * PRESS, &mut orbit);
        assert!(orbit == top && keys.is_moving());
        keys.release(Axis::Up, Way::There);
        keys.advance(PRESS, &mut orbit);
        assert_eq!(orbit, top.moved(Axis::Up, -PRESS));
    }

    #[test]
    fn what_the_opposite_key_owes_is_moved_first() {
        let top = Orbit::new(0.0, 89.0, 4.0);
        let (mut keys, mut orbit) = (Held::default(), top);
        for way in [Way::There, Way::Back, Way::There] {
            keys.press(Axis::Up, way, &mut orbit);
            keys.release(Axis::Up, way);
        }
        keys.advance(PRESS, &mut orbit);
        // Up stops at once, down goes a press away, up comes back.
        assert_eq!(orbit, top);
    }
}
