//! Times of two things that take turns, for benchmarks: on a machine that is now fast and now slow, their ratio holds.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// The median of the times of `a` over those of `b`, taking turns for three seconds or longer. Each gets what `make` makes,
/// untimed.
pub fn ratio_on<T>(make: impl Fn() -> T, mut a: impl FnMut(&mut T), mut b: impl FnMut(&mut T)) -> f64 {
    let time = |run: &mut dyn FnMut(&mut T)| {
        let mut made = make();
        let start = Instant::now();
        run(&mut made);
        let taken = start.elapsed();
        black_box(made);
        taken.as_secs_f64()
    };
    let start = Instant::now();
    let mut ratios = Vec::new();
    while ratios.len() < 31 || start.elapsed() < Duration::from_secs(3) {
        ratios.push(time(&mut a) / time(&mut b));
    }
    ratios.sort_by(f64::total_cmp);
    ratios[ratios.len() / 2]
}

/// The same of what is made already.
pub fn ratio(mut a: impl FnMut(), mut b: impl FnMut()) -> f64 {
    ratio_on(|| (), |()| a(), |()| b())
}
