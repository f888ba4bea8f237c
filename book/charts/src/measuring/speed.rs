//! How fast methods are: medians over bursts, and their spread over builds.

/// The times that one build gave: a run's seconds, a row for each burst, a column for each piece of work.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bursts(Vec<Vec<f64>>);

impl Bursts {
    pub(crate) fn add(&mut self, seconds: Vec<f64>) {
        self.0.push(seconds);
    }

    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// The median seconds for a unit of work of each piece that does any, less those of one that does nothing.
    ///
    /// What slows a whole burst, as another program, is taken out first: by the median, over the pieces, of how
    /// much slower than usual they were.
    pub(crate) fn seconds_a_unit(&self, amounts: &[f64]) -> Vec<f64> {
        /// What no operation takes: a clock that ticks 3·10⁹ times a second shows no less.
        const LEAST: f64 = 1e-11;
        let columns = 0..amounts.len();
        let usual: Vec<f64> = columns
            .clone()
            .map(|n| median(&mut self.0.iter().map(|burst| burst[n]).collect::<Vec<_>>()))
            .collect();
        let slower =
            |burst: &Vec<f64>| median(&mut burst.iter().zip(&usual).map(|(a, b)| a / b).collect::<Vec<_>>());
        let mended: Vec<f64> = columns
            .map(|n| median(&mut self.0.iter().map(|burst| burst[n] / slower(burst)).collect::<Vec<_>>()))
            .collect();
        let nothing = amounts.iter().position(|amount| *amount == 0.0).map_or(0.0, |n| mended[n]);
        let pieces = mended.iter().zip(amounts).filter(|(_, amount)| **amount > 0.0);
        pieces.map(|(seconds, amount)| ((seconds - nothing) / amount).max(LEAST)).collect()
    }
}

/// A throughput, in units of work a second.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Speed {
    /// In each build.
    pub(crate) builds: Vec<f64>,
    /// The one in the middle of those for newer processors, if there are any.
    pub(crate) newer: Option<f64>,
    /// How many times each build was timed.
    pub(crate) bursts: usize,
}

impl Speed {
    /// Of each piece of work, from the seconds a unit that each build took, and each for newer processors.
    pub(crate) fn all(builds: &[Vec<f64>], newer: &[Vec<f64>], bursts: usize) -> Vec<Self> {
        let rates = |builds: &[Vec<f64>], n: usize| -> Vec<f64> {
            builds.iter().map(|build| 1.0 / build[n]).collect()
        };
        let speed = |n: usize| Self {
            builds: rates(builds, n),
            newer: Some(median(&mut rates(newer, n))).filter(|rate| !rate.is_nan()),
            bursts,
        };
        (0..builds.first().map_or(0, Vec::len)).map(speed).collect()
    }

    /// In the build in the middle.
    pub(crate) fn median(&self) -> f64 {
        median(&mut self.builds.clone())
    }
}

/// Of a figure in each build: the lowest, the one in the middle, the highest.
pub(crate) fn spread(builds: &[f64]) -> [f64; 3] {
    let mut builds = builds.to_vec();
    let middle = median(&mut builds);
    [builds[0], middle, builds[builds.len() - 1]]
}

/// The median; it sorts them. NaN of none.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    match values.len() {
        0 => f64::NAN,
        n if n % 2 == 1 => values[n / 2],
        n => (values[n / 2 - 1] + values[n / 2]) / 2.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_in_the_middle() {
        assert_eq!(median(&mut [5.0, 1.0, 3.0]), 3.0);
        assert_eq!(median(&mut [4.0, 1.0, 2.0, 9.0]), 3.0);
        assert!(median(&mut []).is_nan());
    }

    #[test]
    fn what_nothing_takes_is_taken_off_and_what_slows_all_is_no_ones() {
        // A loop of 1 s, methods of 1 and 3 s for two units; the second burst ran at half speed.
        let bursts = Bursts(vec![vec![1.0, 2.0, 4.0], vec![2.0, 4.0, 8.0], vec![1.0, 2.0, 4.0]]);
        assert_eq!(bursts.seconds_a_unit(&[0.0, 2.0, 2.0]), [0.5, 1.5]);
        assert_eq!(Bursts(vec![vec![2.0]]).seconds_a_unit(&[4.0]), [0.5]);
    }

    #[test]
    fn the_spread_is_that_of_the_builds() {
        let speeds = Speed::all(&[vec![0.5], vec![0.25], vec![1.0]], &[vec![0.1]], 7);
        assert_eq!(speeds, [Speed { builds: vec![2.0, 4.0, 1.0], newer: Some(10.0), bursts: 7 }]);
        assert_eq!(speeds[0].median(), 2.0);
        assert_eq!(spread(&speeds[0].builds), [1.0, 2.0, 4.0]);
        assert_eq!(Speed::all(&[vec![1.0]], &[], 1)[0].newer, None);
    }
}
