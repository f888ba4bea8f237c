//! How far the reading of a file has come.

/// How often a stage tells how far it has come.
const TIMES: usize = 100;

/// A stage of the work, a share of the whole.
pub(super) struct Stage<'a> {
    watch: &'a mut dyn FnMut(f64),
    begin: f64,
    end: f64,
    of: usize,
    next: usize,
}

impl<'a> Stage<'a> {
    /// The stage from one share of the whole to another, in so many steps. `watch` is called with the share that is
    /// done, from 0 to 1.
    pub(super) fn new(watch: &'a mut dyn FnMut(f64), [begin, end]: [f64; 2], of: usize) -> Self {
        Self { watch, begin, end, of, next: of / TIMES }
    }

    /// So many steps of this stage are done.
    pub(super) fn done(&mut self, steps: usize) {
        if steps >= self.next {
            self.next = steps + self.of / TIMES;
            let share = steps as f64 / self.of.max(1) as f64;
            (self.watch)(self.begin + (self.end - self.begin) * share.min(1.0));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stage_tells_its_share_of_the_whole_a_hundred_times() {
        let mut told = Vec::new();
        let mut watch = |share| told.push(share);
        let mut stage = Stage::new(&mut watch, [0.5, 0.75], 100_000);
        (1..=100_000).for_each(|steps| stage.done(steps));
        assert_eq!((told.len(), told[0], told[99]), (100, 0.5025, 0.75));
    }

    #[test]
    fn a_stage_of_no_steps_is_done() {
        let mut told = Vec::new();
        let mut watch = |share| told.push(share);
        Stage::new(&mut watch, [0.5, 0.75], 0).done(0);
        assert_eq!(told, [0.5]);
    }
}
