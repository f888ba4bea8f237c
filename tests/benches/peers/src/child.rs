//! Painters as other programs, each on the processors that it is given.

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::Duration;

use anyhow::{Context, ensure};
use speed_scenes::clock::Clock;

/// A painter that runs. It ends when this is dropped.
pub(crate) struct Running {
    /// What it says of itself.
    pub(crate) says: String,
    child: Child,
    lines: Option<ChildStdin>,
    answers: BufReader<ChildStdout>,
}

impl Running {
    /// Starts a program on processors as `taskset` counts them.
    ///
    /// # Errors
    /// Where it does not start, or says nothing.
    pub(crate) fn start(processors: &str, program: &Command) -> anyhow::Result<Self> {
        let mut command = Command::new("taskset");
        command.args(["--cpu-list", processors]).arg(program.get_program()).args(program.get_args());
        command.envs(program.get_envs().filter_map(|(name, value)| Some((name, value?))));
        let mut child = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .context("taskset does not run: apt-get install util-linux")?;
        let lines = child.stdin.take();
        let answers = BufReader::new(child.stdout.take().context("there is a pipe")?);
        let says = Path::new(program.get_program()).display().to_string();
        let mut running = Self { says, child, lines, answers };
        running.says = running.answer()?;
        Ok(running)
    }

    fn answer(&mut self) -> anyhow::Result<String> {
        let mut answer = String::new();
        let read = self.answers.read_line(&mut answer)?;
        ensure!(read > 0, "{} ended before it answered", self.says);
        Ok(answer.trim_end().into())
    }

    fn tell(&mut self, line: &str, clock: Clock) -> anyhow::Result<Duration> {
        writeln!(self.lines.as_mut().context("it still runs")?, "{line}")?;
        let answer = self.answer()?;
        let nanoseconds = answer.split(' ').nth(usize::from(clock == Clock::Processor));
        let nanoseconds = nanoseconds.and_then(|number| number.parse().ok());
        nanoseconds.map(Duration::from_nanos).with_context(|| format!("{}: {answer}", self.says))
    }

    /// Lets it draw, and returns how long it took.
    pub(crate) fn draw(&mut self, method: &str, clock: Clock) -> anyhow::Result<Duration> {
        self.tell(&format!("draw {method}"), clock)
    }

    /// The picture that it draws, three bytes a pixel, rows from the bottom.
    pub(crate) fn picture(&mut self, method: &str, file: &Path) -> anyhow::Result<Vec<u8>> {
        self.tell(&format!("picture {method} {}", file.display()), Clock::Wall)?;
        std::fs::read(file).with_context(|| file.display().to_string())
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // It ends where its lines do.
        self.lines = None;
        let _ = self.child.wait();
    }
}
