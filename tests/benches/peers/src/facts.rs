//! What was measured on, and with.

use std::collections::BTreeSet;
use std::fs::read_to_string;
use std::process::Command;

use serde_json::{Value, json};

/// The machine, the programs and how busy it was.
pub(crate) struct Facts {
    processor: String,
    load: [String; 2],
    date: String,
    commit: String,
    compiler: String,
    renderers: BTreeSet<String>,
}

/// How programs are built: `run` does it.
const FLAGS: &str = "ours as the course's release build, for any x86-64 or whatever the machine is; euc with lto = \"fat\", \
                     codegen-units = 1, target-cpu=native; llvmpipe as the system has it, LP_NUM_THREADS = cores, \
                     GL_RGBA8 and 32-bit depths, not read back";

impl Facts {
    pub(crate) fn find() -> Self {
        let cpus = read_to_string("/proc/cpuinfo").unwrap_or_default();
        let models = || cpus.lines().filter(|line| line.starts_with("model name"));
        let model =
            models().next().and_then(|line| line.split_once(": ")).map_or("unknown", |(_, name)| name);
        Self {
            processor: format!("{model}, {} processors", models().count()),
            load: [load(), String::new()],
            date: told_by("date", &["+%Y-%m-%d %H:%M"]),
            commit: told_by(
                "git",
                &["-C", env!("CARGO_MANIFEST_DIR"), "describe", "--always", "--dirty=, changed"],
            ),
            compiler: told_by("rustc", &["--version"]),
            renderers: BTreeSet::new(),
        }
    }

    /// What painters say of themselves.
    pub(crate) fn add_renderers<'a>(&mut self, renderers: impl Iterator<Item = &'a str>) {
        self.renderers.extend(renderers.map(Into::into));
    }

    /// Takes down how busy the machine is at the end.
    pub(crate) fn load_after(&mut self) {
        self.load[1] = load();
    }

    /// With the names that the facts of the book's charts have.
    pub(crate) fn json(&self) -> Value {
        let Self { processor, load, date, commit, compiler, renderers } = self;
        json!({
            "machine": { "processor": processor, "commit": commit, "compiler": compiler }, "quick": false, "date": date,
            "load_before": load[0], "load_after": load[1], "flags": FLAGS, "renderers": renderers,
        })
    }

    /// The same as lines.
    pub(crate) fn lines(&self) -> String {
        let Self { processor, load: [before, after], date, commit, compiler, renderers } = self;
        let renderers = renderers.iter().map(String::as_str).collect::<Vec<_>>().join("; ");
        format!(
            "{processor}; load {before} before, {after} at the end; {date}; commit {commit}; {compiler}.\n\
             Renderers: {renderers}.\nBuilds: {FLAGS}."
        )
    }
}

/// The mean number of programs that ran or wanted to in the last minute.
fn load() -> String {
    let text = read_to_string("/proc/loadavg").unwrap_or_default();
    text.split(' ').next().filter(|load| !load.is_empty()).unwrap_or("unknown").into()
}

fn told_by(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).output().ok().filter(|output| output.status.success());
    output.map_or("unknown".into(), |output| String::from_utf8_lossy(&output.stdout).trim().into())
}

/// Which `euc` this is.
pub(crate) fn euc_version() -> &'static str {
    let packages = include_str!("../Cargo.lock").split("[[package]]");
    let mut versions = packages.filter(|package| package.contains("name = \"euc\"\n"));
    let version = versions.next().and_then(|package| package.split("version = \"").nth(1)?.split('"').next());
    version.unwrap_or("of an unknown version")
}
