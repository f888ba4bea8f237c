//! What a program says: on standard output, on standard error, and how far it has come.

use std::io::{ErrorKind, IsTerminal, Write};
use std::time::{Duration, Instant};

use anyhow::Context;

use crate::printable::printable;

/// Prints to standard output. A reader that has gone away wants no more: that is no error.
///
/// # Errors
/// Where standard output cannot be written.
pub fn print(text: &str) -> anyhow::Result<()> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(error).context("cannot write to standard output")
        }
        _ => Ok(()),
    }
}

/// Says a line on standard error. Where that fails there is nobody left to tell: unlike the macro of that
/// name, it does not panic, and what would break the line is [`printable`].
pub fn eprintln(line: impl std::fmt::Display) {
    let _ = writeln!(std::io::stderr(), "{}", printable(&line.to_string()));
}

/// Whether bold and coloured text may be written to standard output: it is a terminal that knows ECMA-48's codes, and
/// its user wants colours.
#[must_use]
pub fn is_styled() -> bool {
    let variable = |name: &str| std::env::var(name).unwrap_or_default();
    // Windows' older terminal shows the codes as text, unless a program has asked it not to.
    let knows = !cfg!(windows) || ["WT_SESSION", "TERM"].iter().any(|name| !variable(name).is_empty());
    std::io::stdout().is_terminal() && knows && wants_colors(variable)
}

/// Whether colours are wanted, by the variables of the environment (one that is not set is empty). `NO_COLOR` counts
/// where it is not empty (<https://no-color.org>).
pub(crate) fn wants_colors(variable: impl Fn(&str) -> String) -> bool {
    variable("NO_COLOR").is_empty() && variable("TERM") != "dumb"
}

/// A line on standard error that says how far a long work has come, if that is a terminal; it disappears at
/// the end.
pub struct Progress {
    wanted: bool,
    shown: bool,
    begun: Instant,
    patience: Duration,
    done: u16,
    of: u16,
}

impl Progress {
    /// Of a work in so many steps, none of them done. It is shown to those who have waited for so long.
    #[must_use]
    pub fn new(of: u16, patience: Duration) -> Self {
        let wanted = std::io::stderr().is_terminal();
        let mut progress = Self { wanted, shown: false, begun: Instant::now(), patience, done: 0, of };
        progress.show();
        progress
    }

    /// Counts one more step as done.
    pub fn step(&mut self) {
        self.reach(self.done + 1);
    }

    /// Counts so many steps as done.
    pub fn reach(&mut self, done: u16) {
        if done != self.done || !self.shown {
            self.done = done;
            self.show();
        }
    }

    fn show(&mut self) {
        let taken = self.begun.elapsed();
        if self.wanted && taken >= self.patience {
            self.shown = true;
            let _ = write!(std::io::stderr(), "\r{}{CLEAR}", bar(self.done, self.of, taken));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.shown {
            let _ = write!(std::io::stderr(), "\r{CLEAR}");
        }
    }
}

/// Clears the terminal's line from here on (ECMA-48's EL).
const CLEAR: &str = "\x1b[K";

/// How much is done, and how many seconds the rest will take if it goes on like this.
fn bar(done: u16, of: u16, taken: Duration) -> String {
    const WIDTH: usize = 40;
    let share = f64::from(done) / f64::from(of.max(1));
    let full = (share * WIDTH as f64) as usize;
    let left = if done == 0 {
        String::new()
    } else {
        format!(" {:.0} s", taken.as_secs_f64() * (1.0 / share - 1.0))
    };
    format!("{}{} {done}/{of}{left}", "█".repeat(full), "░".repeat(WIDTH - full))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_fills_up_and_says_how_long() {
        let seconds = Duration::from_secs;
        assert_eq!(bar(0, 8, seconds(9)), "░".repeat(40) + " 0/8");
        assert_eq!(bar(2, 8, seconds(9)), "█".repeat(10) + &"░".repeat(30) + " 2/8 27 s");
        assert_eq!(bar(8, 8, seconds(9)), "█".repeat(40) + " 8/8 0 s");
        assert_eq!(bar(0, 0, seconds(9)), "░".repeat(40) + " 0/0");
    }
}
