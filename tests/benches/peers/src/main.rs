//! Times other renderers and lesson 17's methods on the same scenes, in turn; started by `run`.

mod buffers;
mod child;
mod comparison;
mod euc;
mod facts;
mod file;
mod painter;
mod table;

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Context;
use clap::{Parser, Subcommand, ValueEnum};

use crate::euc::Euc;
use painter::{Ours, serve};

#[derive(Parser)]
struct Flags {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Time all renderers on all scenes
    Compare(comparison::Flags),
    /// Draw a scene as often as standard input says
    Paint {
        /// By whom
        who: Who,
        /// The scene's name
        scene: String,
        /// On so many threads
        threads: usize,
    },
}

#[derive(Clone, Copy, ValueEnum)]
enum Who {
    /// The course's methods
    Ours,
    /// `euc`
    Euc,
}

fn main() -> ExitCode {
    let done = match Flags::parse().task {
        Task::Compare(flags) => comparison::run(&flags),
        Task::Paint { who, scene, threads } => paint(who, &scene, threads),
    };
    let Err(error) = done else { return ExitCode::SUCCESS };
    eprintln!("error: {error:#}");
    ExitCode::FAILURE
}

fn paint(who: Who, scene: &str, threads: usize) -> anyhow::Result<()> {
    let recipe = speed_scenes::find(scene).with_context(|| format!("there is no scene `{scene}`"))?;
    let scene = (recipe.make)();
    let (lines, answers) = (std::io::stdin().lock(), std::io::stdout().lock());
    match who {
        Who::Ours => serve("ours", Ours::new(scene, threads), lines, answers),
        Who::Euc => serve(&format!("euc {}", facts::euc_version()), Euc::new(&scene), lines, answers),
    }
}

/// A path that is there.
fn existing(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    if path.exists() { Ok(path) } else { Err("there is no such file".into()) }
}
