//! Which methods nothing beats.

/// For each (error, throughput) whether no other is at least as good in both and better in one. A small error
/// and a large throughput are good; an infinite error is never on the frontier.
pub(crate) fn frontier(figures: &[(f64, f64)]) -> Vec<bool> {
    let beats = |a: &(f64, f64), b: &(f64, f64)| a.0 <= b.0 && a.1 >= b.1 && (a.0 < b.0 || a.1 > b.1);
    figures.iter().map(|b| b.0.is_finite() && !figures.iter().any(|a| beats(a, b))).collect()
}

#[cfg(test)]
mod tests {
    use super::frontier;

    #[test]
    fn ties_are_on_it_and_failures_are_not() {
        let figures = [(1.0, 5.0), (1.0, 5.0), (0.0, 2.0), (0.0, 1.0), (3.0, 4.0), (f64::INFINITY, 9.0)];
        assert_eq!(frontier(&figures), [true, true, true, false, false, false]);
    }

    #[test]
    fn a_failure_is_not_on_it_even_alone() {
        assert_eq!(frontier(&[(f64::INFINITY, 1.0)]), [false]);
    }
}
