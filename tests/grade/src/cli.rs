//! The command line.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use anyhow::Context;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};

use crate::class::{self, Options};
use crate::walls::{NOT_BUILT, Terms, Walls};
use crate::{gradescope, kit, merge, pairs, proof, report, submission};

/// Grades what students wrote for the course's missions.
#[derive(Parser)]
#[command(version, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Grade a class: a folder with a folder for each submission.
    ///
    /// Stopped half-way, the same command goes on where it was. A report that is there is brought up to date.
    ///
    /// The exit code is 3 if something could not be graded, and a person has to look at it.
    Class {
        /// The class.
        dir: PathBuf,
        /// The folder for the reports; made if need be.
        #[arg(long, value_name = "REPORT")]
        out: PathBuf,
        /// What the inputs are made from, if not from a random number, which is kept in the report. Students see those of 1.
        #[arg(long)]
        seed: Option<u64>,
        /// Which lessons, as in 1-3,7; all of them if not given.
        #[arg(long)]
        lessons: Option<String>,
        /// Only the i-th of n parts of the class.
        #[arg(long, value_name = "i/n", default_value = "1/1", value_parser = shard)]
        shard: (usize, usize),
        /// How many submissions at a time; as many as there are processors if not given.
        #[arg(long)]
        jobs: Option<std::num::NonZero<usize>>,
        /// Grade this submission again; may be given several times.
        #[arg(long, value_name = "NAME")]
        regrade: Vec<String>,
        /// Grade all again that are not right.
        #[arg(long)]
        regrade_failed: bool,
        /// How many seconds a compiler or a program may take by the clock, when the machine is busy, before it is put off.
        #[arg(long, value_name = "SECONDS", default_value_t = 600)]
        patience: u64,
        #[command(flatten)]
        extras: report::Flags,
        /// The course's folder, if not the one that this program was built in.
        #[arg(long, default_value = COURSE, hide_default_value = true)]
        course: PathBuf,
        /// Run what students wrote with this account's rights, at your own risk.
        #[arg(long)]
        unsafe_no_sandbox: bool,
    },
    /// Make one report of several, such as those of all shards.
    Merge {
        /// Folders with reports.
        #[arg(required = true)]
        parts: Vec<PathBuf>,
        /// The folder for the reports; made if need be.
        #[arg(long, value_name = "REPORT")]
        out: PathBuf,
        #[command(flatten)]
        extras: report::Flags,
    },
    /// Build the package of an autograder for Gradescope.
    Gradescope {
        /// Which lessons, as in 1-3,7, or all.
        lessons: String,
        /// The zip file.
        #[arg(long, value_name = "FILE", default_value = "autograder.zip")]
        out: PathBuf,
        #[command(flatten)]
        how: gradescope::How,
        /// The course's folder, if not the one that this program was built in.
        #[arg(long, default_value = COURSE, hide_default_value = true)]
        course: PathBuf,
    },
    /// Grade a submission in Gradescope's container.
    #[command(hide = true)]
    Autograde {
        submission: PathBuf,
        #[arg(long)]
        results: PathBuf,
        #[arg(long)]
        lessons: String,
        #[command(flatten)]
        how: gradescope::How,
        #[arg(long, default_value = COURSE)]
        course: PathBuf,
    },
    /// Compare the texts of a class with each other and with the course's: who has handed in much the same?
    ///
    /// Renaming, other numbers, other comments and another layout hide nothing. The page REPORT/pairs.html has the passages
    /// side by side; what they mean is for a person to judge. Nothing is compiled or run.
    ///
    /// The exit code is 3 if something could not be compared, and a person has to look at it.
    Pairs {
        /// The class.
        dir: PathBuf,
        /// The folder for the reports; made if need be.
        #[arg(long, value_name = "REPORT")]
        out: PathBuf,
        /// Which lessons, as in 1-3,7; all of them if not given.
        #[arg(long)]
        lessons: Option<String>,
        /// From which percentage on a pair is listed.
        #[arg(long, value_name = "PERCENT", default_value_t = 50, value_parser = clap::value_parser!(u8).range(0..=100))]
        least: u8,
        /// How many pairs are listed, those with most in common.
        #[arg(long, value_name = "N", default_value_t = 100)]
        most: usize,
        /// The course's folder, if not the one that this program was built in.
        #[arg(long, default_value = COURSE, hide_default_value = true)]
        course: PathBuf,
    },
    /// Build walls around this process, and become a program.
    #[command(hide = true)]
    Wall {
        walls: String,
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        command: Vec<OsString>,
    },
    /// Try the walls from inside.
    #[command(hide = true)]
    Try { folder: PathBuf },
    /// Use up what is limited.
    #[command(hide = true)]
    Exhaust { what: String },
}

/// The course in which this program was built.
const COURSE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn shard(text: &str) -> Result<(usize, usize), String> {
    let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    numbers.filter(|(i, n)| (1..=*n).contains(i)).ok_or_else(|| "not i/n with 1 ≤ i ≤ n".into())
}

pub(crate) fn main() -> ExitCode {
    let launcher = matches!(std::env::args_os().nth(1), Some(word) if word == "wall");
    match run(Cli::parse().command) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(if launcher { NOT_BUILT as u8 } else { 1 })
        }
    }
}

/// A course's folder, and those of its lessons that a list names: all of them if there is none.
fn chosen(course: &Path, list: Option<&str>, flag: &str) -> anyhow::Result<(PathBuf, Vec<String>)> {
    let course = course.canonicalize().with_context(|| format!("cannot read {}", course.display()))?;
    let all = tasks::lessons(&course).with_context(|| format!("{} is not the course", course.display()))?;
    let lessons = list.map_or(Ok(all.clone()), |list| kit::lessons(list, &all));
    let wrong = |why| Cli::command().error(ErrorKind::ValueValidation, format!("{flag}: {why}"));
    Ok((course, lessons.unwrap_or_else(|why| wrong(why).exit())))
}

/// The exit code where a person has to look at something.
const LOOK: u8 = 3;

fn run(command: Command) -> anyhow::Result<ExitCode> {
    let class = match command {
        Command::Class {
            dir,
            out,
            seed,
            lessons,
            shard,
            jobs,
            regrade,
            regrade_failed,
            patience,
            extras,
            course,
            unsafe_no_sandbox,
        } => {
            let (course, lessons) = chosen(&course, lessons.as_deref(), "--lessons")?;
            let jobs =
                jobs.map_or_else(|| std::thread::available_parallelism().map_or(1, usize::from), usize::from);
            if shard.1 > 1 && seed.is_none() {
                let why = "--shard needs --seed: all parts of a class are graded with the same one";
                Cli::command().error(ErrorKind::MissingRequiredArgument, why).exit();
            }
            // A file that cannot be read is told before anything is graded.
            let extras = extras.read(&course)?;
            class::grade(&Options {
                submissions: submission::all(&dir)?,
                report: out,
                course,
                seed,
                lessons,
                shard,
                jobs,
                regrade,
                regrade_failed,
                extras,
                terms: Terms { closed: !unsafe_no_sandbox, patience: Duration::from_secs(patience) },
            })?
        }
        Command::Merge { parts, out, extras } => {
            merge::merge(&parts, &extras.read(Path::new(COURSE))?, &out)?
        }
        Command::Gradescope { lessons, out, how, course } => {
            let list = Some(lessons.as_str()).filter(|list| *list != "all");
            let (course, lessons) = chosen(&course, list, "LESSONS")?;
            return gradescope::package(&course, &lessons, &how, &out).map(|()| ExitCode::SUCCESS);
        }
        Command::Autograde { submission, results, lessons, how, course } => {
            let (course, lessons) = chosen(&course, Some(&lessons), "--lessons")?;
            return gradescope::autograde(&submission, &results, course, lessons, &how)
                .map(|()| ExitCode::SUCCESS);
        }
        Command::Pairs { dir, out, lessons, least, most, course } => {
            let (course, lessons) = chosen(&course, lessons.as_deref(), "--lessons")?;
            let least = f64::from(least) / 100.0;
            let look =
                pairs::report(&pairs::Options { class: dir, report: out, course, lessons, least, most })?;
            return Ok(if look { ExitCode::from(LOOK) } else { ExitCode::SUCCESS });
        }
        Command::Wall { walls, command } => {
            let walls: Walls = serde_json::from_str(&walls)?;
            match walls.enter(&command)? {}
        }
        Command::Try { folder } => return proof::attempt(&folder).map(|()| ExitCode::SUCCESS),
        Command::Exhaust { what } => return proof::exhaust(&what).map(|()| ExitCode::SUCCESS),
    };
    Ok(if class.looks().is_empty() { ExitCode::SUCCESS } else { ExitCode::from(LOOK) })
}
