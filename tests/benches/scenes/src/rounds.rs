//! Times of things that take turns: on a machine that is now fast and now slow, what is compared is slow together.

use std::time::{Duration, Instant};

use fastrand::Rng;

/// How many rounds there are.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// So many, or
    pub rounds: usize,
    /// as many as begin within this time, but at least three.
    pub time: Duration,
}

impl Limits {
    fn reached(self, rounds: usize, start: Instant) -> bool {
        rounds >= self.rounds.max(1) || rounds >= 3 && start.elapsed() >= self.time
    }
}

/// The middle of the times that something took, in milliseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// A quarter of the times is less.
    pub p25: f64,
    /// Half of them.
    pub median: f64,
    /// Three quarters.
    pub p75: f64,
}

impl Times {
    /// Of times in milliseconds, of which the nearest is taken.
    ///
    /// # Panics
    /// Where there are none.
    #[must_use]
    pub fn of(mut times: Vec<f64>) -> Self {
        times.sort_by(f64::total_cmp);
        let at = |quarters: usize| times[(times.len() - 1) * quarters / 4];
        Self { p25: at(1), median: at(2), p75: at(3) }
    }
}

/// Lets `count` things take turns, in another order in each round, once to warm up and then as often as told.
/// `run(n)` does thing `n` and says how long it took.
///
/// # Errors
/// The first of `run`.
pub fn rounds<E>(
    count: usize,
    limits: Limits,
    mut run: impl FnMut(usize) -> Result<Duration, E>,
) -> Result<Vec<Times>, E> {
    let mut random = Rng::with_seed(17);
    let mut order: Vec<usize> = (0..count).collect();
    let mut times = vec![Vec::new(); count];
    for &n in &order {
        run(n)?;
    }
    let start = Instant::now();
    for round in 0.. {
        if limits.reached(round, start) {
            break;
        }
        random.shuffle(&mut order);
        for &n in &order {
            times[n].push(1000.0 * run(n)?.as_secs_f64());
        }
    }
    Ok(times.into_iter().map(Times::of).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_are_times_that_were_taken() {
        let times = Times::of(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!(times, Times { p25: 2.0, median: 3.0, p75: 4.0 });
        assert_eq!(Times::of(vec![7.0]), Times { p25: 7.0, median: 7.0, p75: 7.0 });
    }

    #[test]
    fn all_take_turns_and_the_warm_up_does_not_count() {
        let mut turns = Vec::new();
        let limits = Limits { rounds: 4, time: Duration::MAX };
        let times = rounds(2, limits, |n| {
            turns.push(n);
            Ok::<_, ()>(Duration::from_millis(if turns.len() <= 2 { 1000 } else { n as u64 + 1 }))
        });
        let medians: Vec<f64> = times.unwrap().iter().map(|times| times.median).collect();
        assert_eq!(medians, [1.0, 2.0]);
        assert!(turns.chunks(2).all(|round| round.contains(&0) && round.contains(&1)) && turns.len() == 10);
    }

    #[test]
    fn what_takes_long_takes_three_rounds_and_what_fails_ends_them() {
        let limits = Limits { rounds: 9, time: Duration::ZERO };
        let mut count = 0;
        let counted = rounds(1, limits, |_| {
            count += 1;
            Ok::<_, ()>(Duration::ZERO)
        });
        assert!(counted.is_ok() && count == 4);
        assert_eq!(rounds(1, limits, |_| Err::<Duration, _>("no")), Err("no"));
    }
}
