//! What programs show in a terminal, and nowhere else.

use std::fs::File;
use std::io::Write;
use std::process::Command;
use std::thread;
use std::time::Duration;

use common::Image;
use common::preview::half_blocks;
use tempfile::{TempDir, tempdir};
use verify::terminal::in_terminal;
use verify::{CRATE, SPHERE, program};

/// A program that finds no variables of the environment but these, of those that count.
fn with(lesson: &str, folder: &TempDir, variables: &[(&str, &str)]) -> Command {
    let mut command = program(lesson, folder.path());
    for name in ["COLORTERM", "NO_COLOR", "TERM", "TERM_PROGRAM", "WT_SESSION"] {
        command.env_remove(name);
    }
    command.envs(variables.iter().copied());
    command
}

const TRUE_COLORS: &[(&str, &str)] = &[("TERM", "xterm"), ("COLORTERM", "truecolor")];

/// It is as large as the terminal allows, but for two lines; a terminal that does not know its size has 80 × 24.
#[test]
fn a_picture_is_shown_in_a_terminal_that_can() {
    let folder = tempdir().unwrap();
    let draw = |variables, flags: &[&str], columns, rows| {
        let mut command = with("lines", &folder, variables);
        command.args(["--out", "a.png"]).args(flags);
        in_terminal(command, columns, rows)
    };
    let named = "a.png (100x100)\r\n";
    for (columns, rows, shown) in
        [(80, 24, (80, 22)), (9, 40, (9, 38)), (80, 2, (80, 1)), (80, 1, (80, 1)), (0, 0, (80, 22))]
    {
        let told = draw(TRUE_COLORS, &[], columns, rows);
        let picture = Image::read(&folder.path().join("a.png")).unwrap();
        let expected = half_blocks(&picture, shown.0, shown.1).replace('\n', "\r\n") + named;
        assert!(told == expected, "{columns}x{rows}:\n{told}");
    }
    assert_eq!(draw(TRUE_COLORS, &["--quiet"], 80, 24), named);
    assert_eq!(draw(&[("TERM", "xterm")], &[], 80, 24), named);
}

#[test]
fn a_bar_says_how_far_a_series_has_come_and_disappears() {
    let folder = tempdir().unwrap();
    let mut command = with("camera", &folder, TRUE_COLORS);
    let scene = ["--model", SPHERE, "--texture", CRATE, "--size", "9x9", "--out", "a.png"];
    command.args(["--turntable", "2"]).args(scene);
    let told = in_terminal(command, 80, 24);
    let lines: Vec<&str> = told.split('\r').collect();
    let (full, empty) = ("█".repeat(20), "░".repeat(20));
    assert_eq!(lines.len(), 6, "{told:?}");
    assert_eq!(lines[1], format!("{empty}{empty} 0/2\x1b[K"));
    let seconds = lines[2].strip_prefix(&format!("{full}{empty} 1/2 ")).unwrap();
    assert!(seconds.ends_with(" s\x1b[K"), "{told:?}");
    assert_eq!(lines[3], format!("{full}{full} 2/2 0 s\x1b[K"));
    assert_eq!(lines[4..], ["\x1b[K2 pictures", "\n"]);
}

/// A pipe that is slow: after a second there is a bar, and at the end it is gone.
#[test]
fn a_bar_says_how_much_of_a_model_has_been_read_to_those_who_wait() {
    let folder = tempdir().unwrap();
    let pipe = folder.path().join("pipe.obj");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let slowly = pipe.clone();
    let writer = thread::spawn(move || {
        let mut file = File::create(slowly).unwrap();
        thread::sleep(Duration::from_secs(1));
        file.write_all(b"v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    });
    let mut command = with("wireframe", &folder, TRUE_COLORS);
    command.args(["--model", "pipe.obj", "--quiet", "--out", "a.png"]);
    let told = in_terminal(command, 80, 24);
    writer.join().unwrap();
    let lines: Vec<&str> = told.split('\r').collect();
    let [first, bars @ .., last, end] = &lines[..] else { panic!("{told:?}") };
    assert_eq!((*first, *last, *end), ("", "\x1b[Ka.png (800x800)", "\n"), "{told:?}");
    assert!(!bars.is_empty(), "{told:?}");
    for bar in bars {
        assert!(bar.contains("/100 ") && bar.ends_with(" s\x1b[K"), "{told:?}");
    }
}

#[test]
fn a_list_is_bold_in_a_terminal_whose_user_wants_it() {
    let folder = tempdir().unwrap();
    for (variables, bold) in [
        (&[][..], true),
        (&[("TERM", "xterm")], true),
        (&[("TERM", "dumb")], false),
        (&[("NO_COLOR", "1")], false),
        (&[("NO_COLOR", "")], true),
    ] {
        let told = in_terminal(with("course", &folder, variables), 80, 24);
        assert_eq!(told.contains("\x1b[1mPixel by Pixel"), bold, "{variables:?}: {told}");
        assert_eq!(told.contains('\x1b'), bold, "{variables:?}");
    }
    let piped = with("course", &folder, &[("TERM", "xterm")]).output().unwrap();
    assert!(!String::from_utf8(piped.stdout).unwrap().contains('\x1b'));
}
