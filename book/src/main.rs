//! Makes what the README and the book show.
//!
//! ```text
//! cargo run -p book -- pictures     each lesson's picture, into book/chapters/pictures/
//! ```

mod pictures;

use std::path::Path;

use clap::{Parser, Subcommand};

/// Makes what the README and the book show.
#[derive(Parser)]
#[command(disable_version_flag = true)]
struct Arguments {
    #[command(subcommand)]
    make: Make,
}

#[derive(Subcommand)]
enum Make {
    /// Draw each lesson's picture by its own program, into book/chapters/pictures/
    Pictures,
}

fn main() -> anyhow::Result<()> {
    match Arguments::parse().make {
        Make::Pictures => {
            pictures::draw_all(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/chapters/pictures")))
        }
    }
}
