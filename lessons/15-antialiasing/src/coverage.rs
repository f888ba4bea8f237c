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
    /// The samples of a row of pixels that a triangle covers.
    #[inline(always)]
    pub(crate) fn row<'a>(&self, setup: &Setup, small: Option<&'a Small<N>>, y: i32) -> Row<'a, N> {
        let Bounds { min, max } = setup.bounds;
        if let Some(small) = small {
            let edges = setup.edges + setup.up * f64::from(y - min.y);
            let told = Told::ByAsking { small, inside: setup.inside };
            return Row { touched: min.x..max.x + 1, edges, told };
        }
        let centers = setup.row(y);
        // Beyond the triangle's own pixels none is asked about.
        let within = |x: i64| x.clamp(min.x.into(), i64::from(max.x) + 1) as i32;
        // Of a single sample, which is the centre, it is lesson 3's row.
        let rows = self.places.map(|place| {
            let Range { start, end } = if N == 1 { centers.pixels.clone() } else { setup.row_at(y, place) };
            (within(start), within(end))
        });
        let all = |pick: fn(i32, i32) -> i32, ends: [i32; N]| ends.into_iter().reduce(pick).unwrap_or(min.x);
        let (first, end) = (rows.map(|row| row.0), rows.map(|row| row.1));
        let touched = all(i32::min, first)..all(i32::max, end);
        let whole = all(i32::max, first)..all(i32::min, end);
        let mut edges = centers.edges;
        if N > 1 {
            edges += setup.right * (i64::from(touched.start) - centers.pixels.start) as f64;
        }
        Row { touched, edges, told: Told::ByEnds { whole, first, end, centers: centers.pixels } }
    }
    // ANCHOR_END: row
}

/// For each side and each sample: what the edge function is more there than at the pixel's centre, less what it is inside at
/// least.
pub(crate) struct Small<const N: usize> {
    margins: [[i32; N]; 3],
}

impl<const N: usize> Small<N> {
    // ANCHOR: small
    /// Of a triangle so small that it is less work to ask each pixel of its box than to find the ends of `N` rows of samples:
    /// one at most 16 px wide in the picture. Nowhere near the box may its edge functions be too large for an `i32`.
    #[inline(always)]
    pub(crate) fn new(setup: &Setup, offsets: &[DVec3; N]) -> Option<Self> {
        let size = (setup.bounds.max - setup.bounds.min).as_dvec2();
        let steps = setup.right.abs() * (size.x + 1.0) + setup.up.abs() * (size.y + 1.0);
        let largest = (setup.edges.abs() + steps).max_element();
        (N > 1 && size.x < 16.0 && largest < f64::from(1 << 30)).then(|| {
            let margins = offsets.map(|offset| offset - setup.inside);
            Self { margins: [0, 1, 2].map(|side| margins.map(|margin| margin[side] as i32)) }
        })
    }
    // ANCHOR_END: small
}

/// A row of pixels, some of whose samples a triangle covers.
pub(crate) struct Row<'a, const N: usize> {
    /// The pixels that may have a covered sample.
    pub(crate) touched: Range<i32>,
    /// The edge functions at the centre of the first of them.
    pub(crate) edges: DVec3,
    told: Told<'a, N>,
}

/// How it is told what is covered.
enum Told<'a, const N: usize> {
    /// By the pixels at which each sample is covered, and those at which all are.
    ByEnds { whole: Range<i32>, first: [i32; N], end: [i32; N], centers: Range<i64> },
    /// By the edge functions at each pixel.
    ByAsking { small: &'a Small<N>, inside: DVec3 },
}

impl<const N: usize> Row<'_, N> {
    // ANCHOR: mask
    /// The covered samples of a touched pixel with these edge functions at its centre, a bit for each.
    #[inline(always)]
    pub(crate) fn mask(&self, x: i32, edges: DVec3) -> u32 {
        match &self.told {
            Told::ByEnds { whole, .. } if N == 1 || whole.contains(&x) => all::<N>(),
            Told::ByEnds { first, end, .. } => {
                let covered = |s: usize| u32::from(first[s] <= x) & u32::from(x < end[s]);
                (0..N).fold(0, |mask, s| mask | covered(s) << s)
            }
            Told::ByAsking { small: Small { margins: [for_a, for_b, for_c] }, .. } => {
                let [a, b, c] = edges.to_array().map(|edge| edge as i32);
                // The sign of the three together is that of the least: 0 or −1 after the shift, and then no bit or that of the
                // sample. No branch and no bool, so that all samples are computed at once.
                let mut mask = 0;
                for s in 0..N {
                    let outside = ((a + for_a[s]) | (b + for_b[s]) | (c + for_c[s])) >> 31;
                    mask |= !outside & 1 << s;
                }
                mask as u32
            }
        }
    }
    // ANCHOR_END: mask

    /// Whether the centre of such a pixel is covered.
    #[inline(always)]
    pub(crate) fn has_center(&self, x: i32, edges: DVec3) -> bool {
        match &self.told {
            Told::ByEnds { centers, .. } => centers.contains(&x.into()),
            Told::ByAsking { inside, .. } => edges.cmpge(*inside).all(),
        }
    }
}

/// The mask of all samples.
pub(crate) const fn all<const N: usize>() -> u32 {
    u32::MAX >> (32 - N)
}
