//! Which methods nothing beats.
//!
//! Two methods are compared in the same builds, where they were timed in the same bursts: what slows a burst, or a build
//! as a whole, slows both.

use super::speed::median;

/// What decides about a method.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Figure {
    /// Its error; infinite if it fails.
    pub(crate) error: f64,
    /// Its throughput in each build.
    pub(crate) builds: Vec<f64>,
    /// Whether it does the job at all.
    pub(crate) does_it: bool,
}

/// By how much one method leads another: above 1 it counts as faster. It does where it is in every build, and in the one
/// in the middle by at least a tenth. Less than that is a tie.
fn lead(a: &Figure, b: &Figure) -> f64 {
    const LEAST: f64 = 1.1;
    let mut ratios: Vec<f64> = a.builds.iter().zip(&b.builds).map(|(a, b)| a / b).collect();
    let middle = median(&mut ratios);
    ratios[0].min(middle / LEAST)
}

/// Whether a method counts as faster than another.
pub(crate) fn is_faster(a: &Figure, b: &Figure) -> bool {
    lead(a, b) > 1.0
}

/// For each method whether none beats it. One does that is at least as accurate and faster, or more accurate and
/// as fast: where speeds are a tie, the more accurate one has it, and equals share. What does not do the job, or
/// fails, neither beats nor stands.
pub(crate) fn frontier(figures: &[Figure]) -> Vec<bool> {
    frontier_from(1.0, figures)
}

/// For each method whether a tenth more or less of some speed would decide otherwise about it: another measurement may.
pub(crate) fn close(figures: &[Figure]) -> Vec<bool> {
    const TENTH: f64 = 1.1;
    let [sooner, later] = [1.0 / TENTH, TENTH].map(|lead| frontier_from(lead, figures));
    frontier(figures)
        .into_iter()
        .zip(sooner.into_iter().zip(later))
        .map(|(is, (a, b))| is != a || is != b)
        .collect()
}

/// For each method whether another measurement contradicts what one found: both are sure, of opposite things.
pub(crate) fn contradicted(one: &[Figure], another: &[Figure]) -> Vec<bool> {
    let sure = |figures: &[Figure]| -> Vec<Option<bool>> {
        frontier(figures).into_iter().zip(close(figures)).map(|(is, close)| (!close).then_some(is)).collect()
    };
    let both = sure(one).into_iter().zip(sure(another));
    both.map(|(one, another)| one.zip(another).is_some_and(|(one, another)| one != another)).collect()
}

/// The frontier where a lead above `least` counts as faster.
fn frontier_from(least: f64, figures: &[Figure]) -> Vec<bool> {
    let stands = |figure: &Figure| figure.does_it && figure.error.is_finite();
    let faster = |a: &Figure, b: &Figure| lead(a, b) > least;
    let beats = |a: &Figure, b: &Figure| {
        stands(a) && (a.error <= b.error && faster(a, b) || a.error < b.error && !faster(b, a))
    };
    figures.iter().map(|b| stands(b) && !figures.iter().any(|a| beats(a, b))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure(error: f64, speed: f64) -> Figure {
        Figure { error, builds: vec![speed, 0.98 * speed, 1.02 * speed], does_it: true }
    }

    #[test]
    fn equals_share_it_and_failures_are_not_on_it() {
        let figures = [(1.0, 5.0), (1.0, 5.1), (0.0, 2.0), (0.0, 1.0), (3.0, 4.0), (f64::INFINITY, 9.0)];
        let figures = figures.map(|(error, speed)| figure(error, speed));
        assert_eq!(frontier(&figures), [true, true, true, false, false, false]);
        assert_eq!(frontier(&figures[5..]), [false]);
    }

    #[test]
    fn of_two_that_are_as_fast_the_more_accurate_one_stands() {
        assert_eq!(frontier(&[figure(1.0, 5.2), figure(0.5, 5.0)]), [false, true]);
        assert_eq!(frontier(&[figure(1.0, 6.0), figure(0.5, 5.0)]), [true, true]);
        // What is faster in the middle, but not in each build, is no faster.
        let wide = Figure { builds: vec![4.0, 6.0, 6.1], ..figure(1.0, 6.0) };
        assert_eq!(frontier(&[wide, figure(0.5, 5.0)]), [false, true]);
        // What slows a whole build slows both.
        let [a, b] = [(1.0, 6.0), (0.5, 5.0)].map(|(error, speed)| Figure {
            builds: vec![speed, 0.5 * speed, 0.9 * speed],
            ..figure(error, speed)
        });
        assert_eq!(frontier(&[a, b]), [true, true]);
        // Whose builds differ decides nothing between others.
        let slow = Figure { builds: vec![1.0, 1.9, 1.2], ..figure(9.0, 1.2) };
        assert_eq!(frontier(&[figure(1.0, 6.0), figure(0.5, 5.0), slow]), [true, true, false]);
    }

    #[test]
    fn what_a_tenth_would_decide_otherwise_is_close() {
        let close = |speed: f64| close(&[figure(1.0, speed), figure(1.0, 5.0)]);
        assert_eq!([4.9, 5.4, 5.9, 6.2].map(|speed| close(speed)[1]), [false, true, true, false]);
        // The faster of equals stands either way.
        assert!(!close(5.6)[0]);
    }

    #[test]
    fn only_what_both_are_sure_of_is_contradicted() {
        let of = |speed: f64| [figure(1.0, speed), figure(1.0, 5.0)];
        let second = |one: f64, another: f64| contradicted(&of(one), &of(another))[1];
        // Beaten at 6.2, standing at 4.9, and unsure of it between.
        assert!(second(6.2, 4.9) && second(4.9, 6.2));
        assert!(!second(6.2, 5.9) && !second(5.4, 6.2) && !second(6.2, 7.0));
    }

    #[test]
    fn what_does_another_job_neither_beats_nor_stands() {
        let wrong = Figure { does_it: false, ..figure(0.0, 9.0) };
        assert_eq!(frontier(&[wrong, figure(1.0, 1.0)]), [false, true]);
    }
}
