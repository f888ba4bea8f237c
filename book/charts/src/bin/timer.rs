//! Times methods when it is told to: the charts build several of this program and let them run in turn.

use std::io::{stdin, stdout};

fn main() -> anyhow::Result<()> {
    charts::measuring::serve(stdin().lock(), stdout().lock())
}
