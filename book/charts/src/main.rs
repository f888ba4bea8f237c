//! Measures every method and charts its speed against its accuracy: cargo run --release -p book -- charts

use std::process::ExitCode;

use charts::measuring::{Flags, run};
use clap::Parser;

/// Measure every method and chart its speed against its accuracy, into book/pages/charts/.
#[derive(Parser)]
#[command(name = "cargo run --release -p book -- charts")]
struct Arguments {
    #[command(flatten)]
    flags: Flags,
}

fn main() -> ExitCode {
    match run(&Arguments::parse().flags) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
