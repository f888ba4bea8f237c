//! Which methods nothing beats.

/// What decides about a method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Figure {
    /// Its error; infinite if it fails.
    pub(crate) error: f64,
    /// Its throughput in the slowest build, the one in the middle, the fastest.
    pub(crate) speed: [f64; 3],
    /// Whether it does the job at all.
    pub(crate) does_it: bool,
}

/// How much faster a method of a table must be than another to count as faster: what is less another build would
/// change. It is the widest spread over builds that one of the table's methods has, and at least a tenth.
pub(crate) fn margin(figures: &[Figure]) -> f64 {
    const LEAST: f64 = 1.1;
    let spreads =
        figures.iter().filter(|figure| figure.does_it).map(|figure| figure.speed[2] / figure.speed[0]);
    spreads.fold(LEAST, f64::max)
}

/// For each method whether none beats it. One does that is at least as accurate and faster, or more accurate and
/// as fast: where speeds are a tie, the more accurate one has it, and equals share. What does not do the job, or
/// fails, neither beats nor stands.
pub(crate) fn frontier(figures: &[Figure]) -> Vec<bool> {
    let margin = margin(figures);
    let stands = |figure: &Figure| figure.does_it && figure.error.is_finite();
    let faster = |a: &Figure, b: &Figure| a.speed[1] > margin * b.speed[1];
    let beats = |a: &Figure, b: &Figure| {
        stands(a) && (a.error <= b.error && faster(a, b) || a.error < b.error && !faster(b, a))
    };
    figures.iter().map(|b| stands(b) && !figures.iter().any(|a| beats(a, b))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure(error: f64, speed: f64) -> Figure {
        Figure { error, speed: [0.98 * speed, speed, 1.02 * speed], does_it: true }
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
        // Where one method's builds differ by so much, less decides nothing between others.
        let wide = Figure { speed: [1.0, 1.2, 1.4], ..figure(9.0, 1.2) };
        assert_eq!(frontier(&[figure(1.0, 6.0), figure(0.5, 5.0), wide]), [false, true, false]);
    }

    #[test]
    fn what_does_another_job_neither_beats_nor_stands() {
        let wrong = Figure { does_it: false, ..figure(0.0, 9.0) };
        assert_eq!(frontier(&[wrong, figure(1.0, 1.0)]), [false, true]);
    }
}
