//! A busy machine: what the clock says is no verdict.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::{FULL, LOOK, grade, grader, hand_in, ran, reports_of, said};

/// Right and wrong ones of all kinds that end by themselves.
fn class(folder: &Path) -> Vec<String> {
    let early = |text: &str| {
        format!(
            "use common::{{Color, IVec2, Image}};\npub fn line(_: IVec2, _: IVec2, _: &mut Image, _: Color) {{ {text} }}"
        )
    };
    let mut texts = vec![
        ("broken", "not Rust".to_string()),
        (
            "deep",
            early(
                "fn deep(n: u64) -> u64 { if n == 0 { 0 } else { 1 + deep(std::hint::black_box(n + 1)) } } deep(1);",
            ),
        ),
        ("late", early("loop { std::hint::black_box(1); }")),
        ("loud", early("loop { println!(\"{}\", \"loud\".repeat(1 << 14)); }")),
        ("panics", early("panic!(\"too bad\")")),
        ("partly", FULL.replace("..=", "..")),
    ];
    let right = ["a", "b", "c", "d"];
    texts.extend(right.map(|name| (name, format!("{FULL}// {name}"))));
    texts.iter().for_each(|(name, text)| hand_in(folder, name, text));
    texts.into_iter().map(|(name, _)| name.into()).collect()
}

#[test]
fn many_at_a_time_get_what_few_get() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let names = class(&path("class"));
    let few = grade(&path("class"), &path("few"), &["--jobs", "2"]);
    if !ran(&few, &path("few")) {
        return;
    }
    let many = grade(&path("class"), &path("many"), &["--jobs", "60"]);
    assert_eq!((few.status.code(), many.status.code()), (Some(0), Some(0)), "{}", said(&many));
    assert!(reports_of(&path("few"), &names) == reports_of(&path("many"), &names));
    let class: Value = serde_json::from_slice(&fs::read(path("many/class.json")).unwrap()).unwrap();
    for (name, words) in [("deep", "SIGSEGV"), ("late", "ran out of time"), ("loud", "SIGXFSZ")] {
        let outcome = class["submissions"][name][0]["outcome"]["Ran"]["checks"].to_string();
        assert!(outcome.contains(words), "{name}");
    }
}

#[test]
fn what_the_clock_stops_is_not_graded_and_not_kept() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    hand_in(&path("class"), "ann", FULL);
    hand_in(&path("class"), "ben", "not Rust");
    let grades = || fs::read_to_string(path("report/grades.csv")).unwrap();
    let output = grade(&path("class"), &path("report"), &["--patience", "0"]);
    if !ran(&output, &path("report")) {
        return;
    }
    assert_eq!(output.status.code(), Some(LOOK));
    let words =
        "ann, 01-lines: found its text, not graded because the compiler was stopped after 0 s by the clock";
    assert!(said(&output).contains(words), "{}", said(&output));
    assert!(grades().contains("\nann,,not graded,,"), "{}", grades());

    // With time enough they are graded, and stay so.
    let output = grade(&path("class"), &path("report"), &[]);
    assert!(said(&output).contains("2 graded now, 0 kept"), "{}", said(&output));
    assert!(grades().contains("\nann,10,right") && grades().contains("\nben,0,does not compile"));
    let again = |more: &[&str]| said(&grade(&path("class"), &path("report"), more));
    assert!(again(&[]).contains("0 graded now, 2 kept"));
    assert!(again(&["--regrade", "ann"]).contains("1 graded now, 1 kept"));
    assert!(again(&["--regrade-failed"]).contains("1 graded now, 1 kept"));
    assert!(again(&["--regrade", "cem"]).contains("holds no such submission"));
}

/// The children of a process, as they were started.
fn children(parent: u32) -> Vec<(String, String)> {
    let processes =
        fs::read_dir("/proc").unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let numbers = processes.filter(|name| name.bytes().all(|byte| byte.is_ascii_digit()));
    let child = |number: String| {
        let read = |file: &str| fs::read_to_string(format!("/proc/{number}/{file}")).ok();
        let own = read("status")?.contains(&format!("\nPPid:\t{parent}\n"));
        own.then_some((number.clone(), read("cmdline")?))
    };
    numbers.filter_map(child).collect()
}

#[test]
fn what_another_program_kills_is_tried_again_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    hand_in(&path("class"), "ann", FULL);
    let mut command = grader(
        &["class", "--lessons", "1", "--seed", "2"],
        &[("", &path("class")), ("--out", &path("report"))],
    );
    let mut running = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let since = Instant::now();
    // As a system does that has run out of memory.
    let killed = loop {
        let compiler = children(running.id())
            .into_iter()
            .find(|(_, command)| command.contains("--crate-name\0my_lines"));
        if let Some((number, _)) = compiler {
            break Command::new("sh")
                .args(["-c", &format!("kill -KILL {number}")])
                .status()
                .unwrap()
                .success();
        }
        assert!(since.elapsed() < Duration::from_secs(600), "no compiler in ten minutes");
        if running.try_wait().unwrap().is_some() {
            break false;
        }
        std::thread::sleep(Duration::from_millis(2));
    };
    let output = running.wait_with_output().unwrap();
    if !ran(&output, &path("report")) {
        return;
    }
    assert!(killed, "{}", said(&output));
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    assert!(fs::read_to_string(path("report/grades.csv")).unwrap().contains("\nann,10,right"));
}
