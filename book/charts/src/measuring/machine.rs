//! What charts were measured on, and with.

use std::process::Command;

use anyhow::Context;
use serde::Serialize;

use super::measure::Effort;

/// Machine, compiler, and state of the sources.
#[derive(Serialize)]
pub(crate) struct Machine {
    processor: String,
    system: &'static str,
    compiler: String,
    flags: String,
    commit: String,
    date: String,
    #[serde(skip)]
    effort: Effort,
}

/// What a commit is called where the sources are not just those.
const CHANGED: &str = ", changed";

impl Machine {
    /// This one, now; with programs that were built so many times.
    pub(crate) fn find(effort: Effort, placements: usize) -> anyhow::Result<Self> {
        let cargo = std::env::var_os("CARGO").map(std::path::PathBuf::from).unwrap_or_default();
        let compiler = told_by(&mut Command::new(cargo.with_file_name("rustc")), &["--version"])
            .or_else(|_| told_by(&mut Command::new("rustc"), &["--version"]))
            .unwrap_or_else(|_| "unknown compiler".into());
        let compiler = compiler.split(" (").next().unwrap_or_default().to_string();
        let flags = format!(
            "{} --release, codegen-units = 1, {}",
            std::env::consts::ARCH,
            if placements == 1 {
                "1 build".into()
            } else {
                format!("{placements} builds with functions in other places")
            }
        );
        // Without git, as in an archive, there is no commit to name.
        let git = |arguments: &[&str]| {
            told_by(Command::new("git").current_dir(env!("CARGO_MANIFEST_DIR")), arguments)
        };
        let changed = git(&[
            "status",
            "--porcelain",
            "--untracked-files=no",
            "--",
            "../..",
            ":!../pages/charts",
            ":!../../README.md",
        ]);
        let commit = match (git(&["rev-parse", "--short", "HEAD"]), changed) {
            (Ok(commit), Ok(changed)) if changed.is_empty() => commit,
            (Ok(commit), _) => commit + CHANGED,
            _ => "unknown".into(),
        };
        Ok(Self {
            processor: processor(),
            system: std::env::consts::OS,
            compiler,
            flags,
            commit,
            date: jiff::Timestamp::now().to_string().split('T').next().context("a time has a date")?.into(),
            effort,
        })
    }

    /// Makes sure that the figures can be measured again.
    pub(crate) fn ensure_reproducible(&self) -> anyhow::Result<()> {
        anyhow::ensure!(
            !self.commit.ends_with(CHANGED),
            "the book's charts name the commit that they were measured at: commit what you changed, or give --out"
        );
        Ok(())
    }

    /// In one line.
    pub(crate) fn caption(&self) -> String {
        let Self { processor, system, compiler, flags, commit, date, effort } = self;
        let quick = if effort.quick { "; QUICK RUN: figures are rough" } else { "" };
        format!(
            "{processor}, {system}, {compiler}, {flags}; seed {}, commit {commit}, {date}{quick}.",
            effort.seed
        )
    }
}

/// What a program prints, without the end of the line.
fn told_by(command: &mut Command, arguments: &[&str]) -> anyhow::Result<String> {
    let output = command.args(arguments).output()?;
    anyhow::ensure!(output.status.success());
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_string())
}

/// The processor's name, where the system tells it.
pub(crate) fn processor() -> String {
    let linux = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        Some(line.split_once(':')?.1.trim().to_string())
    });
    let macos = || told_by(&mut Command::new("sysctl"), &["-n", "machdep.cpu.brand_string"]).ok();
    let windows = || std::env::var("PROCESSOR_IDENTIFIER").ok();
    linux.or_else(macos).or_else(windows).unwrap_or_else(|| std::env::consts::ARCH.into())
}
