//! Other programs of the course, which cargo builds when they are asked for.

use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, ExitCode};

use anyhow::Context;

/// The cargo that runs this program.
pub(crate) fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// Runs the program that measures the charts. It takes many crates that nothing else does, so it is built when it is
/// asked for, as optimised as this one.
///
/// # Errors
/// Where cargo cannot be started. What goes wrong then, it says itself.
pub(crate) fn charts(arguments: &[OsString]) -> anyhow::Result<ExitCode> {
    let mut command = cargo();
    command
        .args(["run", "--quiet", "--manifest-path"])
        .arg(Path::new(crate::ROOT).join("book/charts/Cargo.toml"));
    if !cfg!(debug_assertions) {
        command.arg("--release");
    }
    let status = command.arg("--").args(arguments).status().context("cannot start cargo")?;
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
