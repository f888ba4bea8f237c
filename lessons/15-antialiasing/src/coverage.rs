//! Which samples of a pixel a triangle covers.
//!
//! A sample is inside by the rules of lesson 3: corners are rounded to 1/256 px, sample places are on 1/16 px, so every edge
//! function at a sample is a whole number, and what is right on an edge belongs to one of two neighbours.
//!
//! A row of pixels is a row of samples for each place of the pattern, and each of these has a first and a last pixel, as in
//! lesson 3: its edge functions are those at the centres and a number more. Between the latest first and the earliest last
//! pixel all samples are covered, and nothing more is asked; elsewhere a sample is covered if the pixel is in its row.

use std::ops::Range;

use common::{Bounds, DVec3, IVec2, Vec2};
use triangles::edges::{SUBPIXELS, Setup};

use crate::pattern::{PLACES, Place};

/// Steps of lesson 3's grid between two neighbouring places.
const STEP: i64 = SUBPIXELS / PLACES as i64;

// ANCHOR: coverage
/// The samples of a pixel that a triangle covers: bit s is set where sample s is inside. Corners are in pixels, in any order.
/// The pattern has places in 1/16 px, from 0 to 16, counted from the pixel's lower left corner, y up.
#[must_use]
pub fn coverage(corners: [Vec2; 3], pixel: IVec2, pattern: &[Place]) -> u32 {
    let bounds = Bounds { min: pixel, max: pixel };
    let Some(setup) = Setup::asked_at(corners, bounds, ANYWHERE) else { return 0 };
    let along = |pixel: i32, place: i32| i64::from(pixel) * SUBPIXELS + i64::from(place) * STEP;
    let inside = |&[x, y]: &Place| setup.covers([along(pixel.x, x), along(pixel.y, y)]);
    (0..).zip(pattern).fold(0, |mask, (s, place)| mask | u32::from(inside(place)) << s)
}
// ANCHOR_END: coverage

/// The lower left and the upper right corner of a pixel, from its centre.
const ANYWHERE: [[i64; 2]; 2] = [[-SUBPIXELS / 2; 2], [SUBPIXELS / 2; 2]];

/// A place, in 1/256 px from the pixel's centre.
const fn from_center([x, y]: Place) -> [i64; 2] {
    [x as i64 * STEP - SUBPIXELS / 2, y as i64 * STEP - SUBPIXELS / 2]
}

/// The samples of a pattern, as lesson 3 counts: in 1/256 px from the pixel's centre.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Places<const N: usize> {
    places: [[i64; 2]; N],
    /// The lower left and the upper right corner of the box about them.
    reach: [[i64; 2]; 2],
}

impl<const N: usize> Places<N> {
    /// Those of a pattern.
    pub(crate) const fn new(pattern: &[Place]) -> Self {
        let mut places = [[0; 2]; N];
        let mut reach = [[i64::MAX; 2], [i64::MIN; 2]];
        let mut s = 0;
        while s < N {
            places[s] = from_center(pattern[s]);
            let mut axis = 0;
            while axis < 2 {
                let place = places[s][axis];
                if place < reach[0][axis] {
                    reach[0][axis] = place;
                }
                if place > reach[1][axis] {
                    reach[1][axis] = place;
                }
                axis += 1;
            }
            s += 1;
        }
        Self { places, reach }
    }

    /// The triangle with these corners made ready, in the picture that `bounds` are of; `None` where it covers no sample.
    #[inline]
    pub(crate) fn setup(&self, corners: [Vec2; 3], bounds: Bounds) -> Option<Setup> {
        Setup::asked_at(corners, bounds, self.reach)
    }

    /// What the edge functions are more at each sample than at the centre.
    #[inline]
    pub(crate) fn offsets(&self, setup: &Setup) -> [DVec3; N] {
        self.places.map(|place| setup.offset(place))
    }

    // ANCHOR: row
    /// The samples of a row of pixels that a triangle covers. Of a single sample, which is the centre, it is lesson 3's row,
    /// `centers`.
    #[inline(always)]
    pub(crate) fn row(&self, setup: &Setup, y: i32, centers: &Range<i64>) -> Row<N> {
        let Bounds { min, max } = setup.bounds;
        // Beyond the triangle's own pixels none is asked about.
        let within = |x: i64| x.clamp(min.x.into(), i64::from(max.x) + 1) as i32;
        let rows = self.places.map(|place| {
            let Range { start, end } = if N == 1 { centers.clone() } else { setup.row_at(y, place) };
            (within(start), within(end))
        });
        let all = |pick: fn(i32, i32) -> i32, ends: [i32; N]| ends.into_iter().reduce(pick).unwrap_or(min.x);
        let (first, end) = (rows.map(|row| row.0), rows.map(|row| row.1));
        Row {
            touched: all(i32::min, first)..all(i32::max, end),
            whole: all(i32::max, first)..all(i32::min, end),
            first,
            end,
        }
    }
    // ANCHOR_END: row
}

/// The samples of a row of pixels that a triangle covers.
#[derive(Clone, Debug)]
pub(crate) struct Row<const N: usize> {
    /// The pixels that may have a covered sample.
    pub(crate) touched: Range<i32>,
    /// The pixels all of whose samples are covered.
    whole: Range<i32>,
    first: [i32; N],
    end: [i32; N],
}

/// The mask of all samples.
pub(crate) const fn all<const N: usize>() -> u32 {
    u32::MAX >> (32 - N)
}

impl<const N: usize> Row<N> {
    // ANCHOR: mask
    /// The covered samples of a touched pixel, a bit for each.
    #[inline(always)]
    pub(crate) fn mask(&self, x: i32) -> u32 {
        if N == 1 || self.whole.contains(&x) {
            return all::<N>();
        }
        let covered = |s: usize| u32::from(self.first[s] <= x) & u32::from(x < self.end[s]);
        (0..N).fold(0, |mask, s| mask | covered(s) << s)
    }
    // ANCHOR_END: mask
}
