//! Pieces of work to be timed, and how wrong methods are, over samples.

use std::hint::black_box;
use std::time::Duration;

use fastrand::Rng;

/// How much is measured.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// A twentieth of the samples and less of the time.
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
}

/// A piece of work to be timed.
pub(crate) struct Work {
    /// What one run gets done, in the chart's unit: pixels, triangles, operations. 0 for a run that does nothing.
    pub(crate) amount: f64,
    run: Box<dyn FnMut()>,
}

impl Work {
    /// `run` does `amount` of work. What it returns counts as used, so that nothing is optimised away.
    pub(crate) fn new<T>(amount: f64, mut run: impl FnMut() -> T + 'static) -> Self {
        Self { amount, run: Box::new(move || drop(black_box(run()))) }
    }

    /// The seconds of a processor that `times` runs take.
    pub(crate) fn time(&mut self, times: u32) -> f64 {
        let start = processor_time();
        (0..times).for_each(|_| (self.run)());
        (processor_time() - start).as_secs_f64()
    }
}

/// For how long this thread has had a processor: while others have it, as on a busy machine, this clock stands still.
#[cfg(unix)]
fn processor_time() -> Duration {
    use rustix::time::{ClockId, clock_gettime};
    clock_gettime(ClockId::ThreadCPUTime).try_into().expect("this clock begins at 0")
}

/// Since the first call: elsewhere such clocks tick too slowly.
#[cfg(not(unix))]
fn processor_time() -> Duration {
    static START: std::sync::LazyLock<std::time::Instant> = std::sync::LazyLock::new(std::time::Instant::now);
    START.elapsed()
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
