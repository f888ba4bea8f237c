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

use clap::{Parser, Subcommand};
use common::terminal::{eprintln, print};
use course::{Missions, book, hints, list};
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
    match asked {
        None => print(&list::told(&missions, common::terminal::is_styled())),
        Some(Asked::Next(which)) => return next(&missions, which.mission.as_deref()),
        Some(Asked::Hint { which, number }) => {
            print(&hints::open(&missions, which.mission.as_deref(), number)?)
        }
        Some(Asked::Book(which)) => book::open(&missions, which.mission.as_deref()),
        Some(Asked::Solution(which)) => print(&missions.solution(which.mission.as_deref())?),
    }
    .map(|()| ExitCode::SUCCESS)
}

/// Starts a mission. What it says and how it ends is its own.
fn next(missions: &Missions, which: Option<&str>) -> anyhow::Result<ExitCode> {
    let mission = missions.find(which)?;
    let package = format!("my-{}", name(&mission.lesson));
    print(&format!("{}\ncargo run -p {package} -- --watch\n\n", missions.place(mission)))?;
    let status = cargo("run", &package).args(["--", "--watch"]).status()?;
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
