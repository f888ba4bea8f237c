//! How fast methods are, timed side by side, and how wrong, over samples.

use std::hint::black_box;
use std::time::{Duration, Instant};

use fastrand::Rng;

/// How much is measured.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// A twentieth of the samples and of the time.
    pub(crate) quick: bool,
    /// What all random numbers follow from.
    pub(crate) seed: u64,
}

impl Effort {
    /// How many samples to take, of as many as a full run takes.
    pub(crate) fn samples(self, full: usize) -> usize {
        if self.quick { full.div_ceil(20) } else { full }
    }

    /// Random numbers, the same in every run.
    pub(crate) fn random(self) -> Rng {
        Rng::with_seed(self.seed)
    }

    /// For how long to time, of as long as a full run does.
    fn time(self, full: Duration) -> Duration {
        if self.quick { full / 20 } else { full }
    }
}

/// A piece of work to be timed.
pub(crate) struct Work {
    /// What one run does, in the chart's unit: pixels, triangles, operations.
    amount: f64,
    run: Box<dyn FnMut()>,
}

impl Work {
    /// `run` does `amount` of work. What it returns counts as used, so that nothing is optimised away.
    pub(crate) fn new<T>(amount: f64, mut run: impl FnMut() -> T + 'static) -> Self {
        Self { amount, run: Box::new(move || drop(black_box(run()))) }
    }

    /// The seconds that `times` runs take.
    fn time(&mut self, times: u32) -> f64 {
        let start = Instant::now();
        (0..times).for_each(|_| (self.run)());
        start.elapsed().as_secs_f64()
    }
}

/// The quartiles of a throughput, in units of work a second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Throughput {
    pub(crate) p25: f64,
    pub(crate) median: f64,
    pub(crate) p75: f64,
    /// How many times it was measured.
    pub(crate) rounds: usize,
}

impl Throughput {
    fn of(mut rates: Vec<f64>) -> Self {
        rates.sort_unstable_by(f64::total_cmp);
        let at = |share: f64| {
            let place = share * (rates.len() - 1) as f64;
            let (low, part) = (place.floor() as usize, place.fract());
            rates[low] + part * (rates[(low + 1).min(rates.len() - 1)] - rates[low])
        };
        Self { p25: at(0.25), median: at(0.5), p75: at(0.75), rounds: rates.len() }
    }

    /// Half the width of the median's 95 % confidence interval, as a share of the median (R. `McGill`, J. Tukey,
    /// W. Larsen, *Variations of box plots*, The American Statistician 32, 1978).
    fn uncertainty(self) -> f64 {
        1.57 * (self.p75 - self.p25) / (self.rounds as f64).sqrt() / self.median
    }
}

/// Times pieces of work in turn, so that whatever slows the machine slows them all, until each median is
/// known to 1 % or the time is up.
pub(crate) fn alternate(works: &mut [Work], limit: Duration, effort: Effort) -> Vec<Throughput> {
    /// Long enough for the clock; short enough for most rounds to pass without another program in between.
    const ROUND: f64 = 5e-4;
    let limit = effort.time(limit);
    let times: Vec<u32> = works
        .iter_mut()
        .map(|work| {
            // The first run warms the caches and says how many more it takes to tell its time.
            let trial = (ROUND / 8.0 / work.time(1).max(1e-9)).clamp(1.0, 1e6) as u32;
            (ROUND / (work.time(trial) / f64::from(trial)).max(1e-9)).clamp(1.0, 1e6) as u32
        })
        .collect();
    let mut rates = vec![Vec::new(); works.len()];
    let start = Instant::now();
    loop {
        for (n, work) in works.iter_mut().enumerate() {
            rates[n].push(work.amount * f64::from(times[n]) / work.time(times[n]));
        }
        let found: Vec<Throughput> = rates.iter().cloned().map(Throughput::of).collect();
        let known = rates[0].len() >= 15 && found.iter().all(|found| found.uncertainty() < 0.01);
        if known || rates[0].len() >= 5 && start.elapsed() > limit {
            return found;
        }
    }
}

/// The errors of one method over samples.
#[derive(Clone, Debug)]
pub(crate) struct Errors {
    largest: f64,
    sum: f64,
    squares: f64,
    samples: usize,
    /// Sums of whatever else was counted.
    further: Vec<f64>,
}

impl Errors {
    /// None yet; with so many further counts.
    pub(crate) fn new(further: usize) -> Self {
        Self { largest: 0.0, sum: 0.0, squares: 0.0, samples: 0, further: vec![0.0; further] }
    }

    /// One for each method.
    pub(crate) fn table(methods: usize, further: usize) -> Vec<Self> {
        vec![Self::new(further); methods]
    }

    /// Adds a sample: its largest and its mean error, and what else was counted. NaN counts as infinite.
    pub(crate) fn add(&mut self, largest: f64, mean: f64, further: &[f64]) {
        let finite = |error: f64| if error.is_nan() { f64::INFINITY } else { error };
        self.largest = self.largest.max(finite(largest));
        self.sum += finite(mean);
        self.squares += finite(mean) * finite(mean);
        self.samples += 1;
        self.further.iter_mut().zip(further).for_each(|(sum, count)| *sum += count);
    }

    pub(crate) fn largest(&self) -> f64 {
        self.largest
    }

    pub(crate) fn mean(&self) -> f64 {
        self.sum / self.samples as f64
    }

    pub(crate) fn samples(&self) -> usize {
        self.samples
    }

    /// The means of what else was counted.
    pub(crate) fn further(&self) -> impl Iterator<Item = f64> + '_ {
        self.further.iter().map(|sum| sum / self.samples as f64)
    }

    /// The standard error of the mean.
    pub(crate) fn standard_error(&self) -> f64 {
        let (n, mean) = (self.samples as f64, self.mean());
        ((self.squares / n - mean * mean).max(0.0) / n).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_lie_between_the_rates() {
        let found = Throughput::of(vec![5.0, 1.0, 3.0, 2.0, 4.0]);
        assert_eq!((found.p25, found.median, found.p75, found.rounds), (2.0, 3.0, 4.0, 5));
        assert_eq!(Throughput::of(vec![1.0, 2.0]).median, 1.5);
    }

    #[test]
    fn means_and_their_standard_errors_are_those_of_the_samples() {
        let mut errors = Errors::new(1);
        for error in [1.0, 2.0, 3.0, 6.0] {
            errors.add(error, error, &[2.0 * error]);
        }
        assert_eq!((errors.largest(), errors.mean(), errors.samples()), (6.0, 3.0, 4));
        assert!((errors.standard_error() - (3.5_f64 / 4.0).sqrt()).abs() < 1e-12);
        assert_eq!(errors.further().collect::<Vec<_>>(), [6.0]);
        errors.add(f64::NAN, f64::NAN, &[0.0]);
        assert_eq!((errors.largest(), errors.mean()), (f64::INFINITY, f64::INFINITY));
    }
}
