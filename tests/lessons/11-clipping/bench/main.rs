//! What drawing costs: `cargo bench -p clipping-tests`, single-threaded.

fn main() {}
