//! The program that times: it is told what to make ready and when to time it, a line at a time, and answers each
//! with a line of numbers.
//!
//! | line | answer |
//! |---|---|
//! | `open NAME SIZE SEED` | how much work each piece gets done; 0 for one that does nothing |
//! | `burst SEED` | the seconds that each piece takes once, timed in a random order |

use std::io::{BufRead, Write};

use anyhow::{Context, bail};
use fastrand::Rng;

use super::measure::{Effort, Work};

/// Long enough for the clock; short enough for most to pass without another program in between.
const LONG_ENOUGH: f64 = 5e-4;

/// How often each piece is timed in a burst, of which the median counts; what takes longer than so many seconds is
/// timed once.
const PASSES: usize = 3;
const LONG: f64 = 0.1;

/// Answers lines until there are no more.
///
/// # Errors
/// A line that means nothing, and an answer that nobody takes.
pub fn serve(lines: impl BufRead, mut answers: impl Write) -> anyhow::Result<()> {
    let mut pieces: Vec<(Work, u32)> = Vec::new();
    for line in lines.lines() {
        let line = line?;
        let numbers: Vec<f64> = match line.split_whitespace().collect::<Vec<_>>()[..] {
            ["open", name, size, seed] => {
                let works = super::works(name, size.parse()?, Effort { quick: false, seed: seed.parse()? })
                    .with_context(|| format!("nothing is called {name}"))?;
                pieces = works.into_iter().map(with_runs).collect();
                pieces.iter().map(|piece| piece.0.amount).collect()
            }
            ["burst", seed] => burst(&mut pieces, &mut Rng::with_seed(seed.parse()?)),
            _ => bail!("`{line}` means nothing"),
        };
        let numbers: Vec<String> = numbers.iter().map(ToString::to_string).collect();
        writeln!(answers, "{}", numbers.join(" "))?;
        answers.flush()?;
    }
    Ok(())
}

/// A piece with the number of runs that are long enough. The first one warms the caches.
fn with_runs(mut work: Work) -> (Work, u32) {
    let runs = |share: f64, seconds: f64| (share * LONG_ENOUGH / seconds.max(1e-9)).clamp(1.0, 1e6) as u32;
    let trial = runs(0.125, work.time(1));
    let seconds = work.time(trial) / f64::from(trial);
    (work, runs(1.0, seconds))
}

/// The seconds that a run of each piece takes.
fn burst(pieces: &mut [(Work, u32)], random: &mut Rng) -> Vec<f64> {
    let mut order: Vec<usize> = (0..pieces.len()).collect();
    let mut seconds = vec![Vec::new(); pieces.len()];
    let mut sum = 0.0;
    for pass in 0..PASSES {
        if pass > 0 && sum > LONG {
            break;
        }
        random.shuffle(&mut order);
        for &n in &order {
            let (work, runs) = &mut pieces[n];
            let time = work.time(*runs);
            seconds[n].push(time / f64::from(*runs));
            sum += time;
        }
    }
    seconds.into_iter().map(|mut passes| super::speed::median(&mut passes)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_burst_has_a_time_for_each_piece() {
        let mut answers = Vec::new();
        serve(&b"open 07-transforms-rotations 1000 1\nburst 3\n"[..], &mut answers).unwrap();
        let text = String::from_utf8(answers).unwrap();
        let lines: Vec<Vec<f64>> = text
            .lines()
            .map(|line| line.split(' ').map(|number| number.parse().unwrap()).collect())
            .collect();
        assert_eq!(lines[0], [0.0, 1000.0, 1000.0, 1000.0]);
        assert!(lines[1].len() == 4 && lines[1].iter().all(|seconds| *seconds > 0.0));
    }

    #[test]
    fn what_means_nothing_is_told() {
        for line in ["open", "open none 1 1", "burst", "else 1"] {
            assert!(serve(line.as_bytes(), Vec::new()).is_err(), "{line}");
        }
    }
}
