//! Makes what the README and the book show.
//!
//! ```text
//! cargo run -p book -- read                  opens the book in a browser, and builds it first where it is out of date
//! cargo run -p book                          builds it: its figures and pages, into target/book/
//! cargo run -p book -- figures               its figures alone
//! cargo run -p book -- serve                 shows it to browsers that do not open files
//! cargo run --release -p book -- charts      speed against accuracy, into book/pages/charts/
//! cargo run -p book -- methods               the README's tables, and which method, when
//! cargo run -p book -- pictures              each lesson's picture, into the lessons' folders
//! ```

mod cargo;
mod check;
mod fault;
mod glossary;
mod html;
mod links;
mod live_charts;
mod markup;
mod math;
mod mdbook;
mod moving;
mod page;
mod pictures;
mod quiz;
mod quote;
mod read;
mod readme;
mod serve;
mod values;

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::Context;
use clap::{Parser, Subcommand};

/// The repository's root, as seen from the book's folder.
const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// Makes what the README and the book show. Without a command: builds the book, into target/book/.
#[derive(Parser)]
#[command(disable_version_flag = true, args_conflicts_with_subcommands = true)]
struct Arguments {
    #[command(subcommand)]
    make: Option<Make>,

    #[command(flatten)]
    folder: Folder,
}

/// Where the book is.
#[derive(clap::Args)]
struct Folder {
    /// The folder of the book [default: target/book]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl Folder {
    /// The folder, from the root of the file system, without the `..` that a browser's address would show.
    fn path(&self) -> anyhow::Result<PathBuf> {
        match &self.out {
            Some(folder) => Ok(std::path::absolute(folder)?),
            None => Ok(Path::new(env!("CARGO_MANIFEST_DIR"))
                .parent()
                .context("the book has no root")?
                .join("target/book")),
        }
    }
}

#[derive(Subcommand)]
enum Make {
    /// Open the book in a browser, and build it first where it is out of date
    Read {
        /// A chapter, as 3, or a page, as glossary; without it the first page
        page: Option<String>,

        #[command(flatten)]
        folder: Folder,

        /// Open no browser: print where the page is
        #[arg(long)]
        no_open: bool,
    },
    /// Draw each lesson's picture by its own program, into the lessons' folders
    Pictures,
    /// Measure every method and chart its speed against its accuracy, into book/pages/charts/
    #[command(disable_help_flag = true)]
    Charts {
        /// What cargo run -p charts takes
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<OsString>,
    },
    /// Write again what lists lessons and methods: the README's tables, and two pages of the charts
    Methods,
    /// Draw the book's figures, into target/book/figures/
    Figures(Folder),
    /// Show the book, as it was built last, to browsers that do not open files
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
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> anyhow::Result<ExitCode> {
    match &arguments.make {
        Some(Make::Read { page, folder, no_open }) => read::read(page.as_deref(), &folder.path()?, !no_open)?,
        Some(Make::Pictures) => pictures::draw_all()?,
        Some(Make::Charts { arguments }) => return cargo::charts(arguments),
        Some(Make::Methods) => {
            let code = cargo::charts(&["--methods".into()])?;
            if code != ExitCode::SUCCESS {
                return Ok(code);
            }
            readme::write()?;
        }
        Some(Make::Figures(folder)) => html::draw(&folder.path()?)?,
        Some(Make::Serve { folder, port }) => serve::serve(&folder.path()?, *port)?,
        None => {
            let out = arguments.folder.path()?;
            html::build(&out)?;
            println!("{}", out.join("index.html").display());
        }
    }
    Ok(ExitCode::SUCCESS)
}
