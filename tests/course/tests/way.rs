//! A learner's way through the course, in a folder that has its missions and chapters and nothing else; and once in a
//! copy of the workspace, with the real programs.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use course::{Missions, hints, list};
use judge::marks::{keep, source};
use tasks::{COURSE, lessons, name};
use tempfile::{TempDir, tempdir};

use crate::copy::Copy;
use crate::one_more::files;

/// What stands in each mission of that folder.
const MINE: &str = "mine\n";

struct Way {
    folder: TempDir,
    lessons: Vec<String>,
}

impl Way {
    fn new() -> Self {
        let way = Self {
            folder: tempdir().expect("a temporary folder can be made"),
            lessons: lessons(Path::new(COURSE)).expect("the course can be read"),
        };
        for lesson in &way.lessons {
            way.add(lesson, &chapter(lesson));
        }
        way
    }

    /// A lesson's mission and chapter.
    fn add(&self, lesson: &str, chapter: &str) {
        way_file(&self.root().join("lessons").join(lesson).join("mission/Cargo.toml"), "");
        way_file(&source(self.root(), lesson), MINE);
        way_file(&self.root().join("book/lessons").join(lesson).join("chapter.md"), chapter);
    }

    fn root(&self) -> &Path {
        self.folder.path()
    }

    fn missions(&self) -> Missions {
        Missions::read(self.root()).expect("it is a course")
    }

    fn list(&self) -> String {
        list::told(&self.missions(), false)
    }

    /// The row of a lesson in the list.
    fn row(&self, lesson: &str) -> String {
        let package = format!(" my-{} ", name(lesson));
        let list = self.list();
        list.lines().find(|line| line.contains(&package)).unwrap_or_else(|| panic!("{lesson}: {list}")).into()
    }

    /// The mark of a run, as the mission's program keeps it.
    fn mark(&self, lesson: &str, points: u32) {
        keep(self.root(), lesson, (points, 10), MINE).expect("it can be kept");
    }

    fn hint(&self, which: Option<&str>, number: Option<usize>) -> Result<String, String> {
        hints::open(&self.missions(), which, number).map_err(|error| format!("{error:#}"))
    }
}

fn way_file(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().expect("it is in a folder")).expect("a folder can be made");
    fs::write(path, text).expect("a file can be written");
}

fn chapter(lesson: &str) -> String {
    let path = Path::new(COURSE).join("book/lessons").join(lesson).join("chapter.md");
    fs::read_to_string(path).unwrap_or_default()
}

/// How many hints a chapter has.
fn count(lesson: &str) -> usize {
    chapter(lesson).matches("<summary>Hint ").count()
}

#[test]
fn without_marks_the_first_mission_is_next() {
    let way = Way::new();
    let list = way.list();
    let (first, all) = (&way.lessons[0], way.lessons.len());
    assert!(list.starts_with(&format!("Pixel by Pixel: 0 of {all} missions done\n")), "{list}");
    assert!(
        list.contains(&format!("Next is mission 1, {}: lessons/{first}/mission/src/lib.rs.\n", name(first)))
    );
    assert!(list.contains(&format!("; 0 of {} are open\n", count(first))), "{list}");
    let at: Vec<_> = way.lessons.iter().map(|lesson| list.find(&way.row(lesson))).collect();
    assert!(at.is_sorted() && at.iter().all(Option::is_some), "{list}");
    assert_eq!(list.matches('→').count(), 1);
    assert!(way.row(first).starts_with("  →  1  Lines ") && way.row(first).ends_with('·'));
    assert!(!list.contains('■') && !list.contains('\x1b'), "{list}");
    assert!(list.lines().all(|line| line.chars().count() <= 80), "{list}");
    assert!(list::told(&way.missions(), true).contains("\x1b[1m"));
}

#[test]
fn marks_are_shown_and_the_next_mission_named() {
    let way = Way::new();
    let [one, two, three, ..] = &way.lessons[..] else { panic!("there are lessons") };
    way.mark(one, 10);
    way.mark(two, 10);
    way.mark(three, 4);
    let list = way.list();
    assert!(list.contains(&format!(": 2 of {} missions done\n", way.lessons.len())), "{list}");
    assert!(list.contains(&format!("Next is mission 3, {}: ", name(three))), "{list}");
    for (lesson, sign, points) in [
        (one, "  ✓", " ■■■■■■■■■■  10 of 10"),
        (two, "  ✓", " ■■■■■■■■■■  10 of 10"),
        (three, "  →", " ■■■■······   4 of 10"),
    ] {
        let row = way.row(lesson);
        assert!(row.starts_with(sign) && row.ends_with(points), "{row}");
    }
    // What was marked is not what is there now.
    way_file(&source(way.root(), two), "mine, otherwise\n");
    assert!(way.row(two).ends_with("10 of 10  changed since") && !way.row(one).contains("changed"));
    assert!(way.list().lines().all(|line| line.chars().count() <= 80));
}

#[test]
fn when_all_are_done_nothing_is_next() {
    let way = Way::new();
    for lesson in &way.lessons {
        way.mark(lesson, 10);
    }
    let (list, all) = (way.list(), way.lessons.len());
    assert!(
        list.contains(&format!(": {all} of {all} missions done\n")) && list.contains("All are done."),
        "{list}"
    );
    assert!(!list.contains("Next is") && !list.contains('→'), "{list}");
    let said = way.hint(None, None).unwrap_err();
    assert_eq!(said, format!("all {all} missions are done; name one to see it again"));
    assert!(way.hint(Some("1"), None).is_ok());
}

#[test]
fn a_broken_mark_is_a_line() {
    let way = Way::new();
    let [one, two, ..] = &way.lessons[..] else { panic!("there are lessons") };
    way.mark(one, 10);
    way.mark(two, 10);
    way_file(&way.root().join("out").join(format!("my-{one}.mark")), "\u{1b}[2Jfn main() {}\n");
    let list = way.list();
    let told: Vec<&str> = list.lines().filter(|line| line.contains("not a mark of this course")).collect();
    assert!(told.len() == 1 && told[0].contains(&format!("my-{one}.mark: ")), "{list}");
    assert!(list.contains(": 1 of ") && !list.contains('\x1b'), "{list}");
    // A run mends it.
    way.mark(one, 10);
    assert!(way.list().contains(": 2 of ") && !way.list().contains("not a mark"));
}

#[test]
fn hints_are_opened_one_by_one_and_kept() {
    let way = Way::new();
    let lesson = &way.lessons[0];
    let of = count(lesson);
    for n in 1..=of {
        let said = way.hint(None, None).unwrap();
        let title = format!("Mission 1, {}, hint {n} of {of}: ", name(lesson));
        assert!(said.starts_with(&title) && said.matches(" hint ").count() <= 2, "{said}");
        let left = of - n;
        let told = match left {
            0 => "All hints are open. Our own code is told of from 8 of 10 points on; you have 0.\n".into(),
            1 => format!("One more is left: cargo run -p course -- hint {}\n", name(lesson)),
            _ => format!("{left} more are left: cargo run -p course -- hint {}\n", name(lesson)),
        };
        assert!(said.ends_with(&told), "{said}");
        assert!(way.list().contains(&format!("; {n} of {of} are open\n")), "{}", way.list());
    }
    let again = way.hint(None, None).unwrap();
    assert!((1..=of).all(|n| again.contains(&format!("hint {n} of {of}: "))), "{again}");
    way.mark(lesson, 8);
    let said = way.hint(Some("1"), Some(1)).unwrap();
    assert!(said.ends_with(&format!(" cargo run -p course -- solution {}\n", name(lesson))), "{said}");
}

#[test]
fn a_hint_can_be_asked_for_by_its_number() {
    let way = Way::new();
    let lesson = &way.lessons[1];
    let of = count(lesson);
    let said = way.hint(Some(name(lesson)), Some(2)).unwrap();
    assert!(said.contains(&format!("hint 2 of {of}: ")) && !said.contains("hint 1 of"), "{said}");
    // The first is still to be opened, and after it the third.
    for n in [1, 3] {
        assert!(way.hint(Some("2"), None).unwrap().contains(&format!("hint {n} of {of}: ")));
    }
    assert_eq!(
        way.hint(Some("2"), Some(of + 1)).unwrap_err(),
        format!("there is no hint {}; chapter 2 has {of}", of + 1)
    );
    assert!(way.hint(Some("2"), Some(0)).unwrap_err().starts_with("there is no hint 0"));
}

#[test]
fn what_is_no_list_of_hints_or_no_chapter_is_a_line() {
    let way = Way::new();
    let lesson = &way.lessons[0];
    let file = way.root().join("out").join(format!("my-{lesson}.hints"));
    for foreign in [&b"one"[..], b"1 -2", b"\xff", &[b' '; 5000]] {
        way_file(&file, "");
        fs::write(&file, foreign).unwrap();
        let said = way.hint(None, None).unwrap_err();
        assert!(said.contains("is not a list of hints: remove it") && said.lines().count() == 1, "{said}");
        assert_eq!(fs::read(&file).unwrap(), foreign, "it is not ours to replace");
        assert!(way.list().contains("opens a hint of its chapter\n"), "{}", way.list());
    }
    fs::remove_file(&file).unwrap();
    way.add(lesson, "# Lines\n\nNo hints yet.\n");
    assert_eq!(way.hint(None, None).unwrap_err(), "chapter 1 has no hints");
    fs::remove_file(way.root().join("book/lessons").join(lesson).join("chapter.md")).unwrap();
    assert!(way.hint(None, None).unwrap_err().starts_with("cannot read book"));
    // A lesson without a chapter goes by its name.
    assert!(way.row(lesson).contains(&format!("  1  {} ", name(lesson))));
}

#[test]
fn a_mission_has_a_name_and_a_number() {
    let way = Way::new();
    let missions = way.missions();
    for (n, lesson) in way.lessons.iter().enumerate() {
        for word in [
            lesson.clone(),
            name(lesson).into(),
            format!("my-{}", name(lesson)),
            (n + 1).to_string(),
            format!("{:02}", n + 1),
        ] {
            assert_eq!(&missions.find(Some(&word)).unwrap().lesson, lesson, "{word}");
        }
    }
    for word in ["", "0", "99", "line", "my-", "../01-lines"] {
        let said = missions.find(Some(word)).unwrap_err().to_string();
        assert!(
            said.starts_with(&format!("there is no mission {word:?}; there are lines, wireframe, ")),
            "{said}"
        );
    }
}

/// A line of a program that says something of how it is done, without the space before it: more than a word.
fn is_telling(line: &str) -> bool {
    line.len() > 8
        && line.contains(|c: char| !c.is_alphanumeric())
        && !["//", "use ", "pub ", "fn ", "#["].iter().any(|word| line.starts_with(word))
}

/// The lines of a lesson's code and of its mission's solution that none may see too early.
fn solution(lesson: &str) -> BTreeSet<String> {
    let mut paths = files(&Path::new(COURSE).join("lessons").join(lesson).join("src"));
    paths.push(Path::new(COURSE).join("tests/lessons").join(lesson).join("solution.rs"));
    paths.retain(|path| !path.ends_with("main.rs"));
    let texts = paths.iter().map(|path| fs::read_to_string(path).expect("it is text"));
    texts
        .flat_map(|text| text.lines().map(|line| line.trim().to_string()).collect::<Vec<_>>())
        .filter(|line| is_telling(line))
        .collect()
}

#[test]
fn nothing_shows_a_solution_before_eight_points() {
    for mark in [None, Some(0), Some(7)] {
        let way = Way::new();
        for lesson in &way.lessons {
            if let Some(points) = mark {
                way.mark(lesson, points);
            }
            let own = Some(name(lesson));
            let refused = way.missions().solution(own).unwrap_err().to_string();
            assert!(refused.ends_with("our own code is told of from 8 on"), "{refused}");
            let hints = (0..=count(lesson)).map(|_| way.hint(own, None).unwrap());
            let said: String = hints.chain([refused, way.list()]).collect();
            assert!(!said.contains("lessons/01-lines/src"), "{said}");
            // A line of code may be broken in two.
            let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
            let given: Vec<String> =
                solution(lesson).into_iter().filter(|line| said.contains(line)).collect();
            assert!(given.is_empty(), "{lesson}: {given:?}");
        }
    }
    let way = Way::new();
    for lesson in &way.lessons {
        way.mark(lesson, 8);
        let said = way.missions().solution(Some(name(lesson))).unwrap();
        assert!(
            said.contains("\"Our solution\"") && said.contains(&format!("lessons/{lesson}/src/")),
            "{said}"
        );
        assert!(chapter(lesson).contains("\n## Our solution\n"), "{lesson}: the chapter has no such part");
    }
}

#[test]
fn every_hint_can_be_read_in_a_terminal() {
    let way = Way::new();
    for lesson in &way.lessons {
        assert!(count(lesson) > 0, "{lesson}: the chapter has no hints");
        for n in 1..=count(lesson) {
            let said = way.hint(Some(name(lesson)), Some(n)).unwrap();
            let left: Vec<&str> = ["$", "\\", "{{", "**", "](", "<", "_{"]
                .into_iter()
                .filter(|markup| without_code(&said).contains(markup))
                .collect();
            assert!(left.is_empty(), "{lesson}: {left:?} in {said}");
            assert!(said.lines().all(|line| line.chars().count() <= 80), "{lesson}: {said}");
        }
    }
}

/// Text without what stands between backticks.
fn without_code(text: &str) -> String {
    text.split('`').step_by(2).collect()
}

#[test]
fn a_lesson_more_is_there_by_itself() {
    let way = Way::new();
    let number = way.lessons.len() + 1;
    let toy = format!("{number:02}-toy");
    way.add(&toy, "# A toy\n\n<details>\n<summary>Hint 1: how?</summary>\n\nSo.\n\n</details>\n");
    assert!(way.list().contains(&format!(" of {number} missions done")));
    assert!(way.row(&toy).contains(&format!(" {number}  A toy ")), "{}", way.row(&toy));
    assert!(
        way.hint(Some("toy"), None)
            .unwrap()
            .starts_with(&format!("Mission {number}, toy, hint 1 of 1: how?\n\n  So.\n"))
    );
}

#[test]
fn the_program_says_what_is_wrong_in_a_line() {
    let program = |arguments: &[&str]| -> Output {
        Command::new(env!("CARGO_BIN_EXE_course")).args(arguments).output().expect("it was built")
    };
    let list = program(&[]);
    let said = text(&list.stdout);
    assert!(
        list.status.success() && said.starts_with("Pixel by Pixel: ") && !said.contains('\x1b'),
        "{said}"
    );
    for (arguments, code, words) in [
        (&["hint", "nothing"][..], 1, "error: there is no mission \"nothing\"; "),
        (&["book", "99"], 1, "error: there is no mission \"99\"; "),
        (&["next", ""], 1, "error: there is no mission \"\"; "),
        (&["onward"], 2, "error: unrecognized subcommand 'onward'"),
        (&["hint", "1", "--number", "x"], 2, "error: invalid value 'x'"),
    ] {
        let output = program(arguments);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}");
        assert!(said.starts_with(words) && output.stdout.is_empty(), "{arguments:?}: {said}");
        assert!(code == 2 || said.lines().count() == 1, "{said}");
    }
}

/// A newcomer's first mission, with the programs themselves.
#[test]
#[ignore = "a minute; for the course's own CI"]
fn a_solution_pasted_is_shown_and_the_next_mission_named() {
    let copy = Copy::new();
    let _ = fs::remove_dir_all(copy.root.join("out"));
    let all = lessons(&copy.root).expect("the course can be read");
    let run = |arguments: &[&str]| copy.cargo(&[&["run", "--quiet"], arguments].concat());
    let list = || text(&run(&["--package=course"]).stdout);
    assert!(list().starts_with(&format!("Pixel by Pixel: 0 of {} missions done\n", all.len())), "{}", list());

    let untouched = run(&["--package=my-lines"]);
    assert!(text(&untouched.stderr).contains("Nothing is written yet. Begin at lessons/01-lines/"));
    let row = "  →  1  Lines           my-lines       ··········   0 of 10";
    let squeezed = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(list().lines().any(|line| squeezed(line) == squeezed(row)), "{}", list());

    let solution = Path::new(COURSE).join("tests/lessons/01-lines/solution.rs");
    fs::copy(solution, source(&copy.root, "01-lines")).expect("the copy can be written");
    // One check is no run of the mission.
    assert!(run(&["--package=my-lines", "--", "--check", "steep"]).status.success());
    assert!(list().contains(": 0 of "));
    let solved = text(&run(&["--package=my-lines"]).stdout);
    let told = format!(
        "01-lines: 10 of 10 points\n1 of {} missions done; next, wireframe: `cargo run -p course -- next`\n",
        all.len()
    );
    assert!(solved.contains(&told), "{solved}");
    let row = "✓ 1 Lines my-lines ■■■■■■■■■■ 10 of 10";
    assert!(list().lines().any(|line| squeezed(line) == row), "{}", list());
    assert!(list().contains("\nNext is mission 2, wireframe: "), "{}", list());

    // As tests they are judged as well.
    fs::write(source(&copy.root, "01-lines"), nothing_drawn()).expect("the copy can be written");
    assert!(list().contains("10 of 10  changed since"), "{}", list());
    assert!(!copy.cargo(&["test", "--quiet", "--package=my-lines"]).status.success());
    let row = "→ 1 Lines my-lines ·········· 0 of 10";
    assert!(list().lines().any(|line| squeezed(line) == row), "{}", list());

    #[cfg(unix)]
    programs::next_and_the_book_are_started(&copy);
}

/// A line that is drawn by nobody.
fn nothing_drawn() -> &'static str {
    "//! Nothing is drawn.\n\nuse common::{Color, IVec2, Image};\n\n/// Draws nothing.\n\
     pub fn line(_: IVec2, _: IVec2, _: &mut Image, _: Color) {}\n"
}

/// What needs the system's way to end a group of processes, or to stand in for a program.
#[cfg(unix)]
mod programs {
    use std::io::{BufRead, BufReader};
    use std::os::unix::fs::PermissionsExt;
    use std::os::unix::process::CommandExt;
    use std::process::Stdio;

    use super::{Command, Copy, fs, text, way_file};

    pub(super) fn next_and_the_book_are_started(copy: &Copy) {
        let program = || {
            let mut program = Command::new(Copy::program("course"));
            copy.within(&mut program);
            program
        };

        let mut next = program();
        next.args(["next", "wireframe"]).stdout(Stdio::piped()).stderr(Stdio::null()).process_group(0);
        let mut next = next.spawn().expect("it was built");
        let said = BufReader::new(next.stdout.take().expect("it is a pipe"));
        let mut told: Vec<String> = Vec::new();
        for line in said.lines().map_while(Result::ok) {
            told.push(line);
            if told.last().is_some_and(|line| line.starts_with("watching ")) {
                break;
            }
        }
        let ended = Command::new("kill").args(["--", &format!("-{}", next.id())]).status();
        assert!(ended.is_ok_and(|status| status.success()) && next.wait().is_ok());
        let place = "Mission 2, wireframe: lessons/02-wireframe/mission/src/lib.rs";
        assert_eq!(told.first().map(String::as_str), Some(place), "{told:?}");
        assert!(told.last().is_some_and(|line| line.starts_with("watching ")), "{told:?}");
        assert!(copy.root.join("out/my-02-wireframe.mark").exists(), "{told:?}");

        // In the place of cargo, what writes down what it is to do.
        let (stand_in, asked) = (copy.root.join("target/stand-in"), copy.root.join("target/asked"));
        way_file(&stand_in, &format!("#!/bin/sh\necho \"$@\" >{}\nexit 3\n", asked.display()));
        fs::set_permissions(&stand_in, fs::Permissions::from_mode(0o755)).expect("it is ours");
        let output = program().args(["book", "3"]).env("CARGO", &stand_in).output().expect("it was built");
        let said = text(&output.stdout);
        assert!(said.contains("\ncargo run -p book -- read 03-triangles\n"), "{said}");
        let asked = fs::read_to_string(asked).expect("it was started");
        assert!(
            asked.starts_with("run ") && asked.ends_with("--package book -- read 03-triangles\n"),
            "{asked}"
        );
        assert_eq!(output.status.code(), Some(1));
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
