//! Processes: how long they have run, how they end.
//!
//! What a student's text may take is CPU time, of which a busy machine takes nothing away. The clock is there so that
//! nobody waits for ever. What it stops, and what others kill, says nothing of the text.

use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, ExitStatus};
use std::time::{Duration, Instant};

use anyhow::Context;
use rustix::process::{Pid, Signal, kill_process_group};

/// How often a waiting process looks around.
const PAUSE: Duration = Duration::from_millis(5);

/// How a process ended.
pub(crate) enum End {
    /// By itself, or at one of its limits.
    Ran(ExitStatus),
    /// Neither, and why.
    PutOff(String),
}

/// Runs a command to its end, or until the clock says that it took too long.
pub(crate) fn finish(command: &mut Command, patience: Duration) -> anyhow::Result<End> {
    let mut child = command.spawn().context("cannot start the launcher")?;
    let since = Instant::now();
    loop {
        if since.elapsed() >= patience {
            stop(&mut child)?;
            return Ok(End::PutOff(overdue(patience)));
        }
        if let Some(status) = child.try_wait()? {
            return Ok(killed(status).map_or(End::Ran(status), |why| End::PutOff(why.into())));
        }
        std::thread::sleep(PAUSE);
    }
}

/// What is said of a process that the clock stopped.
pub(crate) fn overdue(patience: Duration) -> String {
    format!("after {} s by the clock", patience.as_secs_f64())
}

/// What is said of a process that another one killed. The limits of a wall send other signals.
pub(crate) fn killed(status: ExitStatus) -> Option<&'static str> {
    let killed = status.signal() == Some(Signal::KILL.as_raw());
    killed.then_some("by another program, or since the machine ran out of memory")
}

/// Ends a process and those that it started.
fn stop(child: &mut Child) -> anyhow::Result<()> {
    // It may have ended just now.
    let _ = kill_process_group(Pid::from_child(child), Signal::KILL);
    child.wait()?;
    Ok(())
}

/// The CPU time that a child has taken, on all its threads.
pub(crate) fn cpu_time(child: &Child) -> anyhow::Result<Duration> {
    let path = format!("/proc/{}/stat", child.id());
    let text = std::fs::read_to_string(Path::new(&path)).with_context(|| format!("cannot read {path}"))?;
    let ticks = ticks(&text).with_context(|| format!("{path} is not as it should be"))?;
    Ok(Duration::from_secs(ticks) / rustix::param::clock_ticks_per_second() as u32)
}

/// Ticks in the program and in the kernel, `utime` and `stime` of `proc_pid_stat(5)`. The second field is the program's
/// name, in brackets, and may hold anything.
fn ticks(stat: &str) -> Option<u64> {
    let mut fields = stat.rsplit_once(')')?.1.split_ascii_whitespace().skip(11);
    let mut number = || fields.next()?.parse::<u64>().ok();
    Some(number()? + number()?)
}

/// Which limit a process ran into, if it was one.
pub(crate) fn limit(status: ExitStatus) -> Option<&'static str> {
    let signal = |signal: Signal| status.signal() == Some(signal.as_raw());
    if signal(Signal::XCPU) {
        Some("it took too much CPU time")
    } else if signal(Signal::XFSZ) {
        Some("it wrote too much")
    } else if signal(Signal::ABORT) {
        Some("it ran out of memory, or aborted")
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_found_behind_any_name() {
        let stat = "7 (a ) 1 2 (x) R 1 7 7 0 -1 4194560 90 0 0 0 25 5 0 0 20 0 1 0 100 1000 10";
        assert_eq!(ticks(stat), Some(30));
        assert_eq!(ticks("7 (a) R 1"), None);
    }

    #[test]
    fn who_sleeps_takes_no_time_and_who_works_does() {
        let time = |program: &str| {
            let mut child = Command::new("sh").args(["-c", program]).spawn().unwrap();
            let since = Instant::now();
            // Long enough for a process that is given little of a busy machine.
            let mut time = Duration::ZERO;
            while time < Duration::from_millis(100) && since.elapsed() < Duration::from_secs(1) {
                std::thread::sleep(PAUSE);
                time = cpu_time(&child).unwrap();
            }
            child.kill().unwrap();
            child.wait().unwrap();
            time
        };
        assert!(time("exec sleep 60") < Duration::from_millis(100));
        assert!(time("while :; do :; done") > Duration::ZERO);
    }

    #[test]
    fn who_is_killed_from_outside_is_put_off() {
        let end = |program: &str, patience| {
            finish(Command::new("sh").args(["-c", program]).process_group(0), patience).unwrap()
        };
        use std::os::unix::process::CommandExt;
        let long = Duration::from_secs(600);
        assert!(matches!(end("kill -KILL $$", long), End::PutOff(why) if why.contains("another program")));
        assert!(matches!(end("sleep 60", Duration::ZERO), End::PutOff(why) if why.contains("by the clock")));
        assert!(matches!(end("kill -XCPU $$", long), End::Ran(status) if limit(status).is_some()));
    }
}
