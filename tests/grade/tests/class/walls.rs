//! A system in which a wall cannot be built, or is built and does not hold: nothing is graded there.
//!
//! What the manual promises of the walls, and which of the hostile submissions or other tests hold it to that:
//!
//! | promise | held by |
//! |---|---|
//! | reads nothing else | `reads_files`, `devices`, `own_program`, `environment`; the compiler: `include_by_macro`, `environment_by_macro`, `names_reference` |
//! | writes its answers, and nothing else | `writes_elsewhere`, `deletes`, `devices`, `answers_file`; `nothing_was_written_elsewhere` |
//! | uses no network | `network` |
//! | starts no process, and no thread | `fork_bomb`, `threads` |
//! | becomes no other program | `again` |
//! | asks not even which files there are | `asks_for_files` |
//! | is stopped when it takes too much | `endless_loop`, `drip`, `stack`, `memory`, `output`, `answers_file`, `many_answers`; the compiler: `endless_constant`, `macro_bomb` |
//! | a sleep is over at once | `endless_sleep` |
//! | open files are closed | `soundness_hole`, with the descriptor 9 that `main.rs` leaves open |
//! | does not read its answers again | `own_answers` |
//! | a verdict that is printed is text | `verdict` |
//! | is not told the seed | `arguments` |
//! | a wall that does not hold is told, and nothing is graded | below |

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Output};

use seccompiler::{
    BpfProgram, SeccompAction, SeccompCmpArgLen, SeccompCmpOp, SeccompCondition, SeccompFilter, SeccompRule,
    apply_filter,
};

use crate::{FULL, grade, grader, hand_in, ran, said};

/// Runs a command where a system call, perhaps only with a value as its second argument, has this error and does nothing. With
/// error 0 it seems to have done it.
fn with_fault(call: i64, only: Option<u64>, error: i32, mut command: Command) -> Output {
    // The filter is the thread's, and of what it starts.
    let thread = std::thread::spawn(move || {
        let only = only.map(|value| {
            let is = SeccompCondition::new(1, SeccompCmpArgLen::Dword, SeccompCmpOp::Eq, value).unwrap();
            SeccompRule::new(vec![is]).unwrap()
        });
        let rules = BTreeMap::from([(call, only.into_iter().collect())]);
        let fault = SeccompAction::Errno(error.cast_unsigned());
        let machine = std::env::consts::ARCH.try_into().unwrap();
        let filter = SeccompFilter::new(rules, SeccompAction::Allow, fault, machine).unwrap();
        apply_filter(&BpfProgram::try_from(filter).unwrap()).unwrap();
        command.output().unwrap()
    });
    thread.join().unwrap()
}

fn command(class: &Path, report: &Path, more: &[&str]) -> Command {
    let arguments = [&["class", "--lessons", "1", "--seed", "2"], more].concat();
    grader(&arguments, &[("", class), ("--out", report)])
}

#[test]
fn without_a_wall_nothing_is_graded() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    hand_in(&path("class"), "ann", FULL);
    if !ran(&grade(&path("class"), &path("here"), &[]), &path("here")) {
        return;
    }
    for (call, only, error, words) in [
        (
            libc::SYS_landlock_create_ruleset,
            None,
            libc::ENOSYS,
            "there is no Landlock, or one older than Linux 6.2's",
        ),
        (libc::SYS_seccomp, None, libc::EINVAL, "seccomp is not there"),
        (
            libc::SYS_landlock_restrict_self,
            None,
            0,
            "no wall against reading the instructor's files, writing and deleting: nothing was graded",
        ),
        (
            libc::SYS_seccomp,
            None,
            0,
            "no wall against asking which files there are, network, TCP, UDP and local, processes and threads",
        ),
        (
            libc::SYS_prlimit64,
            Some(u64::from(libc::RLIMIT_AS)),
            0,
            "no wall against memory: nothing was graded",
        ),
    ] {
        let report = path("report");
        let output = with_fault(call, only, error, command(&path("class"), &report, &[]));
        let said = said(&output);
        assert!(output.status.code() == Some(1) && said.contains(words), "{words}: {said}");
        assert!(said.contains("nothing was graded") && said.trim().lines().count() == 1, "{said}");
        assert!(!report.exists(), "{words}");
    }

    // Unless that is wished for, and then the page says so.
    let report = path("open");
    let open = command(&path("class"), &report, &["--unsafe-no-sandbox"]);
    let output = with_fault(libc::SYS_landlock_create_ruleset, None, libc::ENOSYS, open);
    assert!(output.status.success(), "{}", said(&output));
    let read = |name: &str| std::fs::read_to_string(report.join(name)).unwrap();
    assert!(read("grades.csv").contains("\nann,10,right"));
    // Memory, CPU time, output and the clock are limited all the same.
    let page = read("index.html");
    assert_eq!([page.matches("it was not up").count(), page.matches("it held").count()], [7, 4]);
}
