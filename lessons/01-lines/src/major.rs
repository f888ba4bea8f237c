//! A segment seen along its major axis, the one along which it is longer.
//!
//! Along it there is one pixel a step; across it, on the minor axis, a step changes nothing or moves by 1.

use std::ops::RangeInclusive;

use common::{Bounds, IVec2, Vec2Swizzles};

/// A segment whose ends are ordered along the major axis, so that a→b and b→a are one.
pub(crate) struct Major {
    /// Whether the major axis is y.
    steep: bool,
    /// The lower end: major coordinate, minor coordinate.
    start: IVec2,
    /// Steps from end to end, 0 to 2³² − 1: one less than there are pixels.
    pub(crate) length: i64,
    /// How far the ends are apart on the minor axis, at most `length`.
    pub(crate) rise: i64,
    /// The way it goes on the minor axis, 1 or −1.
    sign: i64,
}

impl Major {
    pub(crate) fn new(a: IVec2, b: IVec2) -> Self {
        let steep = a.x.abs_diff(b.x) < a.y.abs_diff(b.y);
        let [a, b] = if steep { [a.yx(), b.yx()] } else { [a, b] };
        let [start, end] = if a.x <= b.x { [a, b] } else { [b, a] };
        let length = i64::from(start.x.abs_diff(end.x));
        let rise = i64::from(start.y.abs_diff(end.y));
        Self { steep, start, length, rise, sign: if end.y >= start.y { 1 } else { -1 } }
    }

    /// The pixel `step` steps along and `risen` across, as (x, y).
    pub(crate) fn pixel(&self, step: i64, risen: i64) -> (i32, i32) {
        // Both lie between the ends, as `wu` leaves out pixels of coverage 0: no bits are lost.
        let major = (i64::from(self.start.x) + step) as i32;
        let minor = (i64::from(self.start.y) + self.sign * risen) as i32;
        if self.steep { (minor, major) } else { (major, minor) }
    }

    /// The pixel there, even beside the segment; `None` beyond what 32 bits hold.
    pub(crate) fn neighbour(&self, step: i64, risen: i64) -> Option<(i32, i32)> {
        let minor = i32::try_from(i64::from(self.start.y) + self.sign * risen).ok()?;
        let major = (i64::from(self.start.x) + step) as i32;
        Some(if self.steep { (minor, major) } else { (major, minor) })
    }

    /// The steps in which the pixel `risen` across, or the next `wider` ones, can be seen in the window.
    /// `reach(n)` is the first step, at least 0, in which the segment has risen by at least `n`, if it were
    /// long enough.
    pub(crate) fn visible(
        &self,
        window: Bounds,
        wider: i64,
        reach: impl Fn(i64) -> i128,
    ) -> RangeInclusive<i64> {
        let reach = |risen| reach(risen).min(i128::from(self.length) + 1) as i64;
        let [min, max] = [window.min, window.max].map(|corner| if self.steep { corner.yx() } else { corner });
        let (start, rise_from) = (i64::from(self.start.x), i64::from(self.start.y));
        let across = [i64::from(min.y) - rise_from, i64::from(max.y) - rise_from];
        let [lowest, highest] = if self.sign > 0 { across } else { [-across[1], -across[0]] };
        let first = reach(lowest - wider).max(i64::from(min.x) - start).max(0);
        let last = (reach(highest + 1) - 1).min(i64::from(max.x) - start).min(self.length);
        first..=last
    }
}
