//! Makes what the README and the book show.
//!
//! ```text
//! cargo run -p book -- pictures           each lesson's picture, into book/chapters/pictures/
//! cargo run --release -p book -- charts   speed against accuracy, into book/chapters/charts/
//! cargo run -p book -- methods            which method, when: from the figures of the charts
//! ```

mod charts;
mod pictures;

use std::path::Path;
use std::process::ExitCode;

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
    /// Measure every method and chart its speed against its accuracy, into book/chapters/charts/
    Charts(charts::Flags),
    /// Write again, from the book's figures, which method to take when: two pages and the README's table
    Methods,
}

fn main() -> ExitCode {
    let made = match Arguments::parse().make {
        Make::Pictures => {
            pictures::draw_all(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/chapters/pictures")))
        }
        Make::Charts(flags) => charts::run(&flags),
        Make::Methods => charts::write_summary(),
    };
    match made {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
