//! A learner's way through the course.
//!
//! ```text
//! cargo run -p course                      the missions, their marks, and the next one
//! cargo run -p course -- next              starts the next mission, and runs it again at every save
//! cargo run -p course -- hint              opens a hint of the chapter
//! cargo run -p course -- book              opens the chapter in a browser
//! cargo run -p course -- solution          where our own code is explained, from 8 of 10 points on
//! cargo run -p course -- hint triangles    each of them of any mission, by name or number
//! ```

use std::path::Path;
use std::process::ExitCode;

use anyhow::Context;
use clap::{Parser, Subcommand};
use common::terminal::{eprintln, is_styled, print};
use course::{Missions, hints, list};
use tasks::{COURSE, cargo, name};

/// The missions, their marks, and the next one.
#[derive(Parser)]
#[command(name = "course", disable_version_flag = true, bin_name = "cargo run -p course --")]
struct Arguments {
    #[command(subcommand)]
    asked: Option<Asked>,
}

#[derive(Subcommand)]
enum Asked {
    /// Start the next mission, and run it again whenever you save
    Next(Which),
    /// Open the next hint of the mission's chapter
    Hint {
        #[command(flatten)]
        which: Which,

        /// This hint, opened before or not
        #[arg(long, value_name = "N")]
        number: Option<usize>,
    },
    /// Open the mission's chapter in a browser; the first time, the book is built
    Book(Which),
    /// Say where our own code is explained, once you have 8 of 10 points
    Solution(Which),
}

#[derive(clap::Args)]
struct Which {
    /// Another mission than the one at hand: its name or number
    mission: Option<String>,
}

fn main() -> ExitCode {
    run(Arguments::parse().asked).unwrap_or_else(|error| {
        eprintln(format_args!("error: {error:#}"));
        ExitCode::FAILURE
    })
}

fn run(asked: Option<Asked>) -> anyhow::Result<ExitCode> {
    let missions = Missions::read(Path::new(COURSE))?;
    let said = match asked {
        None => list::told(&missions, is_styled()),
        Some(Asked::Hint { which: Which { mission }, number }) => {
            hints::open(&missions, mission.as_deref(), number)?
        }
        Some(Asked::Solution(Which { mission })) => missions.solution(mission.as_deref())?,
        Some(Asked::Next(Which { mission })) => {
            let mission = missions.find(mission.as_deref())?;
            return start(&missions.place(mission), &format!("my-{}", name(&mission.lesson)), &["--watch"]);
        }
        Some(Asked::Book(Which { mission })) => {
            let lesson = &missions.find(mission.as_deref())?.lesson;
            let said = "The first time, the book is built, which takes a minute or two.";
            return start(said, "book", &["read", lesson]);
        }
    };
    print(&said).map(|()| ExitCode::SUCCESS)
}

/// Says something, and starts a package's program. What that says, and how it ends, is its own.
fn start(said: &str, package: &str, words: &[&str]) -> anyhow::Result<ExitCode> {
    print(&format!("{said}\ncargo run -p {package} -- {}\n\n", words.join(" ")))?;
    let status = cargo("run", package).arg("--").args(words).status().context("cannot start cargo")?;
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
