//! Makes what the README and the book show.
//!
//! ```text
//! cargo run --release -p book                the whole book, into target/book/
//! cargo run --release -p book -- html        its pages and figures alone
//! cargo run --release -p book -- figures     its figures alone
//! cargo run --release -p book -- serve       shows it in a browser
//! cargo run --release -p book -- charts      speed against accuracy, into book/pages/charts/
//! cargo run -p book -- methods               the README's tables, and which method, when
//! cargo run -p book -- pictures              each lesson's picture, into the lessons' folders
//! ```

mod check;
mod fault;
mod glossary;
mod html;
mod links;
mod markup;
mod math;
mod mdbook;
mod page;
mod pictures;
mod quiz;
mod quote;
mod readme;
mod serve;
mod values;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::Context;
use clap::{Parser, Subcommand};

/// Where the book is built.
const OUT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/book");

/// Makes what the README and the book show. Without a command: the whole book, into target/book/.
#[derive(Parser)]
#[command(disable_version_flag = true, args_conflicts_with_subcommands = true)]
struct Arguments {
    #[command(subcommand)]
    make: Option<Make>,

    #[command(flatten)]
    folder: Folder,

    /// Charts that are missing: take a twentieth of the time to measure them
    #[arg(long)]
    quick: bool,
}

/// Where the book is.
#[derive(clap::Args)]
struct Folder {
    /// The folder of the book
    #[arg(long, value_name = "DIR", default_value = OUT, hide_default_value = true)]
    out: PathBuf,
}

#[derive(Subcommand)]
enum Make {
    /// Draw each lesson's picture by its own program, into the lessons' folders
    Pictures,
    /// Measure every method and chart its speed against its accuracy, into book/pages/charts/
    Charts(charts::Flags),
    /// Write again what lists lessons and methods: the README's tables, and two pages of the charts
    Methods,
    /// Draw the book's figures, into target/book/figures/
    Figures(Folder),
    /// Build the book's pages with their figures, into target/book/
    Html(Folder),
    /// Show the book in a browser
    Serve {
        #[command(flatten)]
        folder: Folder,

        /// The port of this machine to use; 0 takes any
        #[arg(long, default_value_t = 3000)]
        port: u16,
    },
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> anyhow::Result<()> {
    match &arguments.make {
        Some(Make::Pictures) => pictures::draw_all(),
        Some(Make::Charts(flags)) => charts::run(flags),
        Some(Make::Methods) => {
            charts::write_summary()?;
            readme::write()
        }
        Some(Make::Figures(folder)) => html::draw(&folder.out),
        Some(Make::Serve { folder, port }) => serve::serve(&folder.out, *port),
        Some(Make::Html(folder)) => build(&folder.out),
        None => {
            charts::measure_missing(arguments.quick)?;
            build(&arguments.folder.out)
        }
    }
}

fn build(out: &Path) -> anyhow::Result<()> {
    std::fs::create_dir_all(out).with_context(|| format!("cannot create {}", out.display()))?;
    let out = out.canonicalize()?;
    html::build(&out)?;
    println!("{}", out.join("index.html").display());
    Ok(())
}
