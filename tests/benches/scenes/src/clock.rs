//! Clocks for a machine that is quiet, and for one that is not.

use std::time::{Duration, Instant};

/// What is taken for the time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// What passes until it is done, whoever else has the processors meanwhile.
    Wall,
    /// For how long this program has processors, all its threads added up: on one thread what would pass on a quiet
    /// machine, but for what others leave of the caches.
    Processor,
}

impl Clock {
    /// How long something takes, and what it gives.
    pub fn time<T>(self, run: impl FnOnce() -> T) -> (T, Duration) {
        match self {
            Self::Wall => {
                let start = Instant::now();
                let result = run();
                (result, start.elapsed())
            }
            Self::Processor => {
                let start = processor_time();
                let result = run();
                (result, processor_time() - start)
            }
        }
    }
}

#[cfg(unix)]
fn processor_time() -> Duration {
    use rustix::time::{ClockId, clock_gettime};
    clock_gettime(ClockId::ProcessCPUTime).try_into().expect("this clock begins at 0")
}

/// Since the first call: elsewhere such clocks tick too slowly.
#[cfg(not(unix))]
fn processor_time() -> Duration {
    static START: std::sync::LazyLock<Instant> = std::sync::LazyLock::new(Instant::now);
    START.elapsed()
}
