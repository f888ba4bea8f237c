//! Threads: tiles share no pixel, so all cores draw.
//!
//! **Better:** vertices are computed each by itself, parts of the triangles sorted each into lists of their own, and tiles drawn
//! each to memory of its own. No pixel is locked, and which thread does what changes none: a tile takes the parts' lists in their
//! order. Who is free takes the next part, tile or row of tiles, from a list behind a lock that is held for an instant
//! (`par_bridge` of the crate `rayon`); vertices, which take alike, are divided.
//! **What it costs:** a thread that sleeps is woken once a drawing, and once for the picture. What is drawn in less time
//! than that gains nothing, and what waits for memory gains little: cores share it.

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Threads that wait for work, or the caller's alone.
pub(crate) struct Threads(Option<ThreadPool>);

/// WebAssembly in a page starts no threads.
const HAVE_THREADS: bool = !cfg!(target_family = "wasm");

// ANCHOR: threads
impl Threads {
    /// So many.
    ///
    /// # Panics
    /// Where the system starts no thread.
    pub(crate) fn new(count: usize) -> Self {
        let pool = || ThreadPoolBuilder::new().num_threads(count).build().expect("the system starts threads");
        Self((HAVE_THREADS && count > 1).then(pool))
    }

    /// The threads, if there are any. Where there can be none the compiler leaves out `rayon`.
    fn pool(&self) -> Option<&ThreadPool> {
        self.0.as_ref().filter(|_| HAVE_THREADS)
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.pool().map_or(1, ThreadPool::current_num_threads)
    }

    /// Does some work on one of the threads, from where the others are soon at hand.
    pub(crate) fn run<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match self.pool() {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }

    /// Does some work with each of these. Each is handed out by itself, as one may cost much more than the next.
    pub(crate) fn each<T: Send>(&self, items: &mut [T], work: impl Fn(usize, &mut T) + Sync) {
        self.each_piece(items, 1, |n, item| work(n, &mut item[0]));
    }

    /// Does some work with each piece of these, all of that length but perhaps the last.
    pub(crate) fn each_piece<T: Send>(
        &self,
        items: &mut [T],
        length: usize,
        work: impl Fn(usize, &mut [T]) + Sync,
    ) {
        match self.pool() {
            Some(pool) => pool.install(|| {
                // Halves of halves, rayon's way with slices, can leave one long piece to the end.
                items.chunks_mut(length).enumerate().par_bridge().for_each(|(n, piece)| work(n, piece));
            }),
            None => items.chunks_mut(length).enumerate().for_each(|(n, piece)| work(n, piece)),
        }
    }

    /// Puts what is made of the numbers below `count` in a list, in the place of what was there.
    pub(crate) fn fill<T: Send>(
        &self,
        list: &mut Vec<T>,
        count: usize,
        make: impl Fn(usize) -> T + Send + Sync,
    ) {
        /// Fewer are not worth a thread's waking.
        const LEAST: usize = 1024;
        match self.pool() {
            Some(pool) => pool.install(|| {
                (0..count).into_par_iter().with_min_len(LEAST).map(make).collect_into_vec(list);
            }),
            None => {
                list.clear();
                list.extend((0..count).map(make));
            }
        }
    }
}
// ANCHOR_END: threads
