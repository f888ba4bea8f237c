//! Makes what the README and the book show.
//!
//! ```text
//! cargo run --release -p book                the whole book, into target/book/
//! cargo run --release -p book -- figures     its figures alone
//! cargo run --release -p book -- serve       shows it in a browser
//! cargo run -p book -- pictures              each lesson's picture, into book/chapters/pictures/
//! ```

mod fault;
mod figures;
mod html;
mod markup;
mod math;
mod methods;
mod page;
mod pictures;
mod quote;
mod serve;
mod values;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Where the book is built.
const OUT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/book");

/// Makes what the README and the book show. Without a command: the whole book.
#[derive(Parser)]
#[command(disable_version_flag = true)]
struct Arguments {
    #[command(subcommand)]
    make: Option<Make>,

    /// The folder for the book [default: target/book]
    #[arg(long, value_name = "DIR", global = true)]
    out: Option<PathBuf>,
}

#[derive(Subcommand)]
enum Make {
    /// Draw each lesson's picture by its own program, into book/chapters/pictures/
    Pictures,
    /// Draw the book's figures
    Figures,
    /// Build the book's pages, figures included
    Html,
    /// Show the book in a browser
    Serve {
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
    let out = arguments.out.as_deref().unwrap_or(Path::new(OUT));
    match &arguments.make {
        Some(Make::Pictures) => {
            pictures::draw_all(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/chapters/pictures")))
        }
        Some(Make::Figures) => html::draw(out),
        Some(Make::Serve { port }) => serve::serve(out, *port),
        Some(Make::Html) | None => {
            html::build(out)?;
            println!("{}", out.join("index.html").display());
            Ok(())
        }
    }
}
