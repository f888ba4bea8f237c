//! The same program several times, placed differently in memory.
//!
//! A loop may run half as fast again because of where its first instruction happens to lie, which any change
//! elsewhere in the program moves (T. Mytkowicz and others, *Producing wrong data without doing anything obviously
//! wrong!*, ASPLOS 2009). So a figure of one build is no property of a method. The timer is linked several times,
//! its functions in another random order each time, and the builds run in turn.

use std::env::consts::{EXE_SUFFIX, OS};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, ensure};
use fastrand::Rng;

use super::speed::{Bursts, Speed};

/// Builds of each kind, if the linker can place functions as it is told to.
const PLACEMENTS: u64 = 3;

/// The top of the workspace.
const TOP: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// For which processors a build is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum For {
    /// All of the kind, as the course's programs are built.
    Any,
    /// Those with AVX2, which round to whole numbers and fuse products with sums without calling a function.
    V3,
}

/// One of the builds, running.
struct Build {
    made_for: For,
    program: Child,
    lines: ChildStdin,
    answers: BufReader<ChildStdout>,
}

/// All of the builds, running.
pub(crate) struct Builds(Vec<Build>);

impl Builds {
    /// Builds and starts them; those for newer processors too, if asked for and if this is one.
    pub(crate) fn start(newer: bool) -> anyhow::Result<Self> {
        let placed = if OS == "linux" { (1..=PLACEMENTS).map(Some).collect() } else { vec![None] };
        let kinds = if newer && has_v3() { &[For::Any, For::V3][..] } else { &[For::Any] };
        let all = kinds.iter().flat_map(|kind| placed.iter().map(move |order| (*kind, *order)));
        let programs: anyhow::Result<Vec<(For, PathBuf)>> =
            all.map(|(kind, order)| Ok((kind, build(kind, order)?))).collect();
        programs?.iter().map(|(kind, program)| run(*kind, program)).collect::<anyhow::Result<_>>().map(Self)
    }

    /// How many there are that run on any processor.
    pub(crate) fn placements(&self) -> usize {
        self.0.iter().filter(|build| build.made_for == For::Any).count()
    }

    /// Times the pieces of work of that name and size, in bursts spread over the time, the builds in turn in a
    /// random order; those for newer processors too, if asked for.
    pub(crate) fn time(
        &mut self,
        name: &str,
        size: usize,
        seed: u64,
        limit: Duration,
        newer: bool,
    ) -> anyhow::Result<Vec<Speed>> {
        /// Fewer tell no median.
        const FEWEST: usize = 3;
        let mut order: Vec<usize> =
            (0..self.0.len()).filter(|&n| newer || self.0[n].made_for == For::Any).collect();
        // All make themselves ready at once.
        for &n in &order {
            self.0[n].tell(&format!("open {name} {size} {seed}"))?;
        }
        let mut amounts = Vec::new();
        for &n in &order {
            amounts = self.0[n].answer()?;
        }
        let mut random = Rng::with_seed(seed);
        let mut found = vec![Bursts::default(); self.0.len()];
        let start = Instant::now();
        while found[0].len() < FEWEST || start.elapsed() < limit {
            random.shuffle(&mut order);
            for &n in &order {
                self.0[n].tell(&format!("burst {}", random.u32(..)))?;
                found[n].add(self.0[n].answer()?);
            }
        }
        let of = |kind: For| -> Vec<Vec<f64>> {
            let builds =
                self.0.iter().zip(&found).filter(|(build, found)| build.made_for == kind && found.len() > 0);
            builds.map(|(_, bursts)| bursts.seconds_a_unit(&amounts)).collect()
        };
        Ok(Speed::all(&of(For::Any), &of(For::V3), found[0].len()))
    }
}

impl Build {
    fn tell(&mut self, line: &str) -> anyhow::Result<()> {
        Ok(writeln!(self.lines, "{line}")?)
    }

    /// The numbers of its answer.
    fn answer(&mut self) -> anyhow::Result<Vec<f64>> {
        let mut answer = String::new();
        self.answers.read_line(&mut answer)?;
        ensure!(!answer.is_empty(), "the timer ended");
        answer.split_whitespace().map(|number| number.parse().context("the timer gives numbers")).collect()
    }
}

impl Drop for Builds {
    fn drop(&mut self) {
        for build in &mut self.0 {
            // One that has ended already is no fault any more.
            let _ = build.program.kill().and_then(|()| build.program.wait());
        }
    }
}

/// Whether this processor runs programs for x86-64-v3.
fn has_v3() -> bool {
    #[cfg(target_arch = "x86_64")]
    {
        use std::is_x86_feature_detected as has;
        has!("avx2")
            && has!("bmi1")
            && has!("bmi2")
            && has!("f16c")
            && has!("fma")
            && has!("lzcnt")
            && has!("movbe")
    }
    #[cfg(not(target_arch = "x86_64"))]
    false
}

/// Builds the timer, its functions in the order that follows from a number, and returns where it is.
fn build(kind: For, order: Option<u64>) -> anyhow::Result<PathBuf> {
    let target =
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| Path::new(TOP).join("target"), PathBuf::from);
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["rustc", "--quiet", "--release", "--package", "charts", "--bin", "timer"]);
    let folder = match kind {
        For::Any => {
            cargo.env_remove("RUSTFLAGS");
            target
        }
        For::V3 => {
            cargo.env("RUSTFLAGS", "-C target-cpu=x86-64-v3");
            target.join("x86-64-v3")
        }
    };
    cargo.arg("--manifest-path").arg(Path::new(TOP).join("Cargo.toml")).arg("--target-dir").arg(&folder);
    if let Some(order) = order {
        // The default linker on Linux is LLVM's, and every function has a section of its own.
        cargo.args(["--", "-C", &format!("link-arg=-Wl,--shuffle-sections=.text*={order}")]);
    }
    ensure!(cargo.status().context("cargo cannot be run")?.success(), "the timer cannot be built");
    let folder = folder.join("release");
    let made = folder.join(format!("timer{EXE_SUFFIX}"));
    let kept = folder.join(format!("timer-{}{EXE_SUFFIX}", order.unwrap_or(0)));
    std::fs::copy(&made, &kept).with_context(|| format!("cannot copy {}", made.display()))?;
    Ok(kept)
}

/// Starts a build.
fn run(made_for: For, program: &Path) -> anyhow::Result<Build> {
    let mut program = Command::new(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .with_context(|| format!("cannot run {}", program.display()))?;
    let lines = program.stdin.take().context("it has an input")?;
    let answers = BufReader::new(program.stdout.take().context("it has an output")?);
    Ok(Build { made_for, program, lines, answers })
}
