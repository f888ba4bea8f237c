//! A class with every kind of hostile submission, graded; killed and resumed; in shards, and merged.
//!
//! A hostile submission that gets through a wall is rewarded with a right line, so that a missing wall is seen
//! in its marks. Each is bounded in itself, so that a missing wall harms no machine.
#![cfg(target_os = "linux")]

mod busy;
mod gradescope;
mod marks;
mod pairs;
mod shapes;
mod shards;
mod walls;

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::LazyLock;
use std::time::{Duration, Instant};

use serde_json::Value;
use tempfile::TempDir;

const FULL: &str = include_str!("../../../lessons/01-lines/solution.rs");
const COURSE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The exit code where a person has to look at something.
const LOOK: i32 = 3;

/// Where a submission has its file.
const PLACE: &str = "lessons/01-lines/mission/src/lib.rs";

fn hand_in(class: &Path, name: impl AsRef<OsStr>, text: impl AsRef<[u8]>) {
    let file = class.join(name.as_ref()).join(PLACE);
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    fs::write(file, text).unwrap();
}

fn grader(arguments: &[&str], paths: &[(&str, &Path)]) -> Command {
    let mut grader = Command::new(env!("CARGO_BIN_EXE_grade"));
    grader.args(arguments);
    paths.iter().for_each(|(flag, path)| {
        let flag = Some(flag).filter(|flag| !flag.is_empty());
        grader.args(flag).arg(path);
    });
    grader
}

/// Grades lesson 1 of a class, with seed 2 if no other is given.
fn grade(class: &Path, report: &Path, more: &[&str]) -> Output {
    let seed: &[&str] = if more.contains(&"--seed") { &[] } else { &["--seed", "2"] };
    let arguments = [&["class", "--lessons", "1"], seed, more].concat();
    grader(&arguments, &[("", class), ("--out", report)]).output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

/// Whether a grader ran. Where the walls cannot be built it must refuse, and this says so.
fn ran(output: &Output, report: &Path) -> bool {
    if matches!(output.status.code(), Some(0 | LOOK)) {
        return true;
    }
    let said = said(output);
    assert!(said.contains("nothing was graded"), "{said}");
    assert!(!report.join("index.html").exists());
    println!("NOT TESTED, no walls can be built here: {said}");
    false
}

/// The hostile submissions: name, text.
fn hostile(canary: &Path) -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/hostile");
    let course = Path::new(COURSE).canonicalize().unwrap();
    let read = |path: PathBuf| {
        let text = fs::read_to_string(path).unwrap();
        text.replace("CANARY", canary.to_str().unwrap()).replace("COURSE", course.to_str().unwrap())
    };
    let prelude = read(Path::new(folder).join("prelude.rs"));
    let mut files: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| !path.ends_with("prelude.rs"));
    files.sort();
    let text = |path: PathBuf| format!("{prelude}{}\nmod solution {{\n{FULL}}}\n", read(path));
    files
        .into_iter()
        .map(|path| (path.file_stem().unwrap().to_str().unwrap().to_string(), text(path)))
        .collect()
}

/// A class of everyone, graded once for all tests.
struct Graded {
    folder: TempDir,
    output: Output,
}

impl Graded {
    fn report(&self) -> PathBuf {
        self.folder.path().join("report")
    }

    /// The names, and what became of their lesson; nothing where no walls can be built.
    fn works(&self) -> Option<BTreeMap<String, Value>> {
        if !ran(&self.output, &self.report()) {
            return None;
        }
        let class: Value =
            serde_json::from_slice(&fs::read(self.report().join("class.json")).unwrap()).unwrap();
        let works = class["submissions"].as_object().unwrap().clone();
        Some(works.into_iter().map(|(name, works)| (name, without_pictures(&works[0]["outcome"]))).collect())
    }
}

static CLASS: LazyLock<Graded> = LazyLock::new(|| {
    let folder = tempfile::tempdir().unwrap();
    let class = folder.path().join("class");
    let canary = folder.path().join("canary");
    fs::write(&canary, "alive").unwrap();
    for (name, text) in hostile(&canary) {
        hand_in(&class, name, text);
    }
    hand_in(&class, "full", FULL);
    hand_in(&class, "full, the same", FULL);
    hand_in(&class, "partial", FULL.replace("a.0..=b.0", "a.0..b.0"));
    hand_in(&class, "never_steep", FULL.replace("if steep", "if false && steep"));
    hand_in(&class, "none", fs::read(Path::new(COURSE).join(PLACE)).unwrap());
    hand_in(&class, "prints", FULL.replace("for x in", "println!(\"debug {a:?}\");\n    for x in"));
    hand_in(&class, "O'Neil \"x\" & <b>y $(touch z)", FULL);
    hand_in(&class, "=1+1", FULL);
    hand_in(&class, OsStr::from_bytes(b"na\xffme"), FULL);
    hand_in(&class, OsStr::from_bytes(b"na\xfeme"), "fn nothing() {}");
    hand_in(&class, OsStr::from_bytes(&[1; 200]), FULL);
    hand_in(&class, "\u{ffff}".repeat(80), FULL);
    hand_in(&class, "no_utf8", b"// \xff\xfe\npub fn line() {}");
    hand_in(&class, "long", " ".repeat(2 << 20));
    fs::create_dir_all(class.join("empty")).unwrap();
    fs::create_dir_all(class.join("folder").join(PLACE)).unwrap();
    symlink(class.join("full"), class.join("link_folder")).unwrap();
    for (name, target) in [("link_file", class.join("full").join(PLACE)), ("link_away", "/etc/passwd".into())]
    {
        hand_in(&class, name, "");
        fs::remove_file(class.join(name).join(PLACE)).unwrap();
        symlink(target, class.join(name).join(PLACE)).unwrap();
    }
    hand_in(&class, "pipe", "");
    fs::remove_file(class.join("pipe").join(PLACE)).unwrap();
    assert!(Command::new("mkfifo").arg(class.join("pipe").join(PLACE)).status().unwrap().success());
    fs::write(class.join("list.txt"), "not a submission").unwrap();
    // More at a time than any machine can do well.
    // A descriptor that was left open, as a shell leaves them, is not closed when a program becomes another one.
    let mut shell = Command::new("sh");
    shell.args(["-c", "exec 9<\"$0\"; exec \"$@\""]).arg(&canary).arg(env!("CARGO_BIN_EXE_grade"));
    shell
        .args(["class", "--lessons", "1", "--seed", "2", "--jobs", "60", "--out"])
        .arg(folder.path().join("report"));
    let output = shell.arg(&class).output().unwrap();
    println!("{}", said(&output));
    Graded { folder, output }
});

/// An outcome that can be read when a test fails.
fn without_pictures(outcome: &Value) -> Value {
    let mut outcome = outcome.clone();
    if let Some(checks) = outcome.pointer_mut("/Ran/checks").and_then(Value::as_array_mut) {
        checks.iter_mut().for_each(|check| check["pictures"] = Value::Null);
    }
    outcome
}

fn earned(outcome: &Value) -> u64 {
    let checks = outcome["Ran"]["checks"].as_array();
    checks.into_iter().flatten().map(|check| check["earned"].as_u64().unwrap()).sum()
}

#[test]
fn the_honest_get_what_they_deserve() {
    let Some(works) = CLASS.works() else { return };
    for (name, points) in [
        ("full", 10),
        ("full, the same", 10),
        ("prints", 10),
        ("O'Neil \"x\" & <b>y $(touch z)", 10),
        ("=1+1", 10),
        ("na%FFme", 10),
        // Gentle lines, and far ones, which are gentle.
        ("never_steep", 3),
        // The last pixel of each line is missing; it cannot be seen in far ones.
        ("partial", 1),
        ("none", 0),
    ] {
        assert_eq!(earned(&works[name]), points, "{name}: {}", works[name]);
    }
    let partial = &works["partial"];
    let causes =
        partial["Ran"]["checks"].as_array().unwrap().iter().filter_map(|check| check["cause"].as_str());
    assert!(causes.into_iter().any(|cause| cause.contains("the pixel at an end is missing")), "{partial}");
    assert!(works["none"].to_string().contains("not written yet"));
}

/// What each hostile submission came to, in words that its result must have.
const ENDS: [(&str, &str); 41] = [
    ("abort", "SIGABRT"),
    ("again", "the wall held"),
    ("answers_file", "the answers are larger than 64 MiB"),
    ("arguments", "the wall held"),
    ("asks_for_files", "the wall held"),
    ("compile_error", "compile_error"),
    ("deletes", "the wall held"),
    ("devices", "the wall held"),
    ("drip", "ran out of time"),
    ("endless_constant", "the compiler was stopped"),
    ("endless_loop", "ran out of time"),
    ("endless_sleep", "ran out of time"),
    ("environment", "the wall held"),
    ("environment_by_macro", "the wall held"),
    ("fork_bomb", "the wall held"),
    ("helper_module", "write `mod helper { … }` in lib.rs"),
    ("include_by_macro", "Permission denied"),
    ("include_file", "write what that file has in lib.rs"),
    ("include_reference", "write what that file has in lib.rs"),
    ("long_panic", "too long too long"),
    ("macro_bomb", "the compiler was stopped"),
    ("many_answers", "ran out of time"),
    ("memory", "SIGABRT"),
    ("naked", "write it without that word"),
    ("naked_by_macro", "write it without that word"),
    ("names_reference", "can't find crate for `lines`"),
    ("names_tasks", "lines_tasks"),
    ("network", "the wall held"),
    ("odd_panic", "odd \u{fffd}\u{fffd}\u{fffd}[31m ]]>"),
    ("output", "SIGXFSZ"),
    ("own_answers", "the wall held"),
    ("own_program", "the wall held"),
    ("panic", "too bad"),
    ("path_module", "write `mod reference { … }` in lib.rs"),
    ("reads_files", "the wall held"),
    ("soundness_hole", "the wall held"),
    ("stack", "SIGSEGV"),
    ("threads", "the wall held"),
    ("unsafe_code", "write it without that word"),
    ("verdict", "missing"),
    ("writes_elsewhere", "the wall held"),
];

#[test]
fn the_hostile_earn_nothing_and_end_as_they_should() {
    let Some(works) = CLASS.works() else { return };
    let handed_in: Vec<String> = hostile(Path::new("")).into_iter().map(|(name, _)| name).collect();
    assert_eq!(handed_in, ENDS.map(|(name, _)| name));
    let other_ends: Vec<String> = (ENDS.iter())
        .filter(|(name, end)| !works[*name].to_string().contains(end) || earned(&works[*name]) > 0)
        .map(|(name, end)| format!("{name} is to end with `{end}` and no points: {}", works[*name]))
        .collect();
    assert!(other_ends.is_empty(), "{}", other_ends.join("\n"));
}

#[test]
fn what_cannot_be_read_is_told_and_is_no_0() {
    let Some(works) = CLASS.works() else { return };
    assert_eq!(CLASS.output.status.code(), Some(LOOK));
    let said = said(&CLASS.output);
    assert!(said.starts_with("look here: not graded, which is no 0\n"), "{said}");
    let page = fs::read_to_string(CLASS.report().join("index.html")).unwrap();
    for (name, why) in [
        ("folder", "is not a file"),
        ("link_away", "symbolic link"),
        ("link_file", "symbolic link"),
        ("link_folder", "symbolic link"),
        ("long", "larger than"),
        ("pipe", "is not a file"),
    ] {
        let look = &works[name]["NotGraded"];
        assert!(look.to_string().contains(why), "{name}: {}", works[name]);
        let [found, because, cure] = ["found", "because", "cure"].map(|part| look[part].as_str().unwrap());
        let line = format!("{name}, 01-lines: found {found}, not graded because {because}; {cure}");
        assert!(said.contains(&line), "{line}\n{said}");
        assert!(page.contains(&format!("<strong>{name}</strong>, 01-lines: found {found}")), "{name}");
        assert!(!CLASS.report().join("gradescope").join(name).join("results.json").exists(), "{name}");
    }
    assert!(
        page.find("Look here: 13 not graded").unwrap() < page.find("What kept the submissions in").unwrap()
    );
    for (name, end) in [("empty", "Missing"), ("na%FEme", "in crate `my_lines`"), ("no_utf8", "UTF-8")] {
        assert!(works[name].to_string().contains(end), "{name}: {}", works[name]);
        assert_eq!(earned(&works[name]), 0, "{name}");
    }
}

#[test]
fn nothing_was_written_elsewhere() {
    let Some(works) = CLASS.works() else { return };
    let names = |folder: &Path| {
        let mut names: Vec<_> =
            fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        names
    };
    assert_eq!(names(CLASS.folder.path()), ["canary", "class", "report"]);
    assert_eq!(fs::read_to_string(CLASS.folder.path().join("canary")).unwrap(), "alive");
    let reports = [
        "class.json",
        "grades.csv",
        "gradescope",
        "index.html",
        "junit.xml",
        "seed",
        "students",
        "times.csv",
        "work",
    ];
    assert_eq!(names(&CLASS.report()), reports);
    let graded = works.values().filter(|outcome| outcome.get("NotGraded").is_none()).count();
    assert_eq!(names(&CLASS.report().join("gradescope")).len(), graded);
    assert!(!Path::new("/tmp/grade-was-here").exists());
}

#[test]
fn the_reports_are_whole_and_nothing_in_them_is_of_the_students_making() {
    let Some(works) = CLASS.works() else { return };
    let page = fs::read_to_string(CLASS.report().join("index.html")).unwrap();
    assert!(page.contains("O&#39;Neil &#34;x&#34; &#38; &#60;b&#62;y"), "names are escaped");
    assert!(!page.contains("<script>alert") && !page.contains("</details><script"));
    assert!(!page.contains("http://") && !page.contains("https://"), "the page needs no network");
    let own = |name: &str| fs::read_to_string(CLASS.report().join(format!("students/{name}.html"))).unwrap();
    let partial = own("partial");
    assert!(partial.matches("data:image/png;base64,").count() >= 3 && !partial.contains("never_steep"));
    for (name, words) in
        [("odd_panic", "]]&#62; &#60;/pre&#62;&#60;script&#62;"), ("prints", "debug (13, 20)")]
    {
        let own = own(name);
        assert!(own.contains(words) && !own.contains("<script"), "{own}");
    }
    assert_eq!(page.matches("it held").count(), 11, "the report says which walls were up");

    let size = fs::metadata(CLASS.report().join("class.json")).unwrap().len();
    assert!(size < 4 << 20, "one student’s messages make the report large: {size}");
    for (begin, times) in [("%01", 200), ("%EF%BF%BF", 80)] {
        let mapped: Vec<&String> = works.keys().filter(|name| name.starts_with(begin)).collect();
        assert!(mapped.len() == 1 && mapped[0].len() < 200, "{begin}, {times} times: {mapped:?}");
    }

    let mut grades = csv::Reader::from_path(CLASS.report().join("grades.csv")).unwrap();
    let rows: Vec<csv::StringRecord> = grades.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), works.len());
    let row = |name: &str| rows.iter().find(|row| &row[0] == name).unwrap();
    assert_eq!((&row("full")[1], &row("full")[2]), ("10", "right"));
    assert_eq!(&row("'=1+1")[1], "10", "a spreadsheet does not take it for a formula");

    let junit = fs::read_to_string(CLASS.report().join("junit.xml")).unwrap();
    let junit = roxmltree::Document::parse(&junit).unwrap();
    let count = |name: &str| junit.descendants().filter(|node| node.has_tag_name(name)).count();
    assert_eq!((count("testsuite"), count("testcase")), (works.len(), 7 * works.len()));
    let cases = junit.descendants().filter(|node| node.has_tag_name("testcase"));
    let of_partial: Vec<_> =
        cases.filter(|case| case.attribute("classname") == Some("01-lines.partial")).collect();
    let seconds = |case: &roxmltree::Node| case.attribute("time").unwrap().parse::<f64>().unwrap();
    assert!(of_partial.len() == 7 && of_partial.iter().map(seconds).sum::<f64>() > 0.0);

    let pipe: Vec<&str> = row("pipe").iter().skip(1).collect();
    assert_eq!(pipe, ["", "not graded", "", "", "", "", "", "", "", "", "10"]);
    for (name, outcome) in works.iter().filter(|(_, outcome)| outcome.get("NotGraded").is_none()) {
        let path = CLASS.report().join("gradescope").join(name).join("results.json");
        let results: Value = serde_json::from_slice(&fs::read(path).unwrap()).unwrap();
        assert_eq!(results["score"].as_u64(), Some(earned(outcome)), "{name}");
        let scores = results["tests"].as_array().unwrap().iter().map(|test| test["score"].as_u64().unwrap());
        assert_eq!(scores.sum::<u64>(), earned(outcome), "{name}");
    }
}

#[test]
fn a_text_handed_in_by_several_is_built_once() {
    if CLASS.works().is_none() {
        return;
    }
    let mut times = csv::Reader::from_path(CLASS.report().join("times.csv")).unwrap();
    let rows: Vec<csv::StringRecord> = times.records().map(Result::unwrap).collect();
    let of = |name: &str| rows.iter().find(|row| &row[0] == name).unwrap()[2].to_string();
    assert_eq!(of("full"), of("full, the same"));
    assert_ne!(of("full"), of("partial"));
    // 34 hostile texts that are compiled, and those of `full`, `never_steep`, `partial`, `none`, `prints`, `na\xfeme` and `no_utf8`.
    assert!(
        said(&CLASS.output).contains("41 different texts: 41 graded now, 0 kept"),
        "{}",
        said(&CLASS.output)
    );
}

/// Six submissions that take no time.
fn small_class() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for n in 0..6 {
        hand_in(&folder.path().join("class"), format!("s{n}"), format!("{FULL}// {n}"));
    }
    hand_in(&folder.path().join("class"), "s3", "not Rust");
    hand_in(&folder.path().join("class"), "s4", FULL.replace("..=", ".."));
    folder
}

/// The files of a report of these submissions that depend on results alone, times aside.
fn reports_of(report: &Path, names: &[String]) -> Vec<Vec<u8>> {
    let fixed = ["class.json", "index.html", "grades.csv", "junit.xml"].map(String::from);
    let of_one = |name| [format!("gradescope/{name}/results.json"), format!("students/{name}.html")];
    fixed
        .into_iter()
        .chain(names.iter().flat_map(of_one))
        .map(|name| without_times(fs::read(report.join(name)).unwrap()))
        .collect()
}

/// A report without the seconds that `junit.xml` has.
fn without_times(report: Vec<u8>) -> Vec<u8> {
    let text = String::from_utf8(report).unwrap();
    let mut parts = text.split(" time=\"");
    let first = parts.next().unwrap().to_string();
    let seconds = |part: &str| part.split_once('"').is_some_and(|(time, _)| time.parse::<f64>().is_ok());
    let rest = parts.map(|part| if seconds(part) { part.split_once('"').unwrap().1 } else { part });
    rest.fold(first, |text, part| text + part).into_bytes()
}

/// Those of the small class.
fn reports(report: &Path) -> Vec<Vec<u8>> {
    reports_of(report, &(0..6).map(|n| format!("s{n}")).collect::<Vec<_>>())
}

#[test]
fn killed_and_resumed_in_shards_and_merged_the_report_is_the_same() {
    let folder = small_class();
    let [class, whole, merged] = ["class", "whole", "merged"].map(|name| folder.path().join(name));

    // Killed when it has some results, but not all.
    let mut grader = grader(
        &["class", "--lessons", "1", "--seed", "2", "--jobs", "1"],
        &[("", &class), ("--out", &whole)],
    );
    let mut running = grader.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    let kept = || {
        let files = fs::read_dir(whole.join("work/graded")).into_iter().flatten().map(|file| file.unwrap());
        let whole = files.filter(|file| !file.file_name().as_bytes().starts_with(b"."));
        let stamp = |file: fs::DirEntry| (file.file_name(), file.metadata().unwrap().modified().unwrap());
        whole.map(stamp).collect::<BTreeMap<_, _>>()
    };
    let since = Instant::now();
    while kept().len() < 2 && running.try_wait().unwrap().is_none() {
        assert!(since.elapsed() < Duration::from_secs(240), "no result in four minutes");
        std::thread::sleep(Duration::from_millis(5));
    }
    running.kill().unwrap();
    running.wait().unwrap();
    let before = kept();
    assert!(!whole.join("index.html").exists());

    // Resumed: nothing that was there is done again.
    let output = grade(&class, &whole, &[]);
    if !ran(&output, &whole) {
        return;
    }
    let (now, kept_before) = (6 - before.len(), before.len());
    assert!(kept_before >= 2 && now >= 1, "it was to be killed half-way: {before:?}");
    let expected = format!("6 different texts: {now} graded now, {kept_before} kept from before");
    assert!(said(&output).contains(&expected), "{}", said(&output));
    assert!(before.iter().all(|(name, time)| kept()[name] == *time));

    // Once more: nothing is left to do, and the report is the same.
    let first = reports(&whole);
    let output = grade(&class, &whole, &[]);
    assert!(said(&output).contains("0 graded now, 6 kept"), "{}", said(&output));
    assert!(first == reports(&whole));

    // In two shards.
    let shards = ["1/2", "2/2"].map(|shard| {
        let report = folder.path().join(shard.replace('/', "-"));
        let output = grade(&class, &report, &["--shard", shard]);
        assert!(said(&output).contains("3 submissions"), "{}", said(&output));
        report
    });
    // Neither the order of the parts nor a part given twice makes a difference.
    let parts = [("", &*shards[1]), ("", &shards[0]), ("", &shards[1])];
    let output = self::grader(&["merge"], &[&parts[..], &[("--out", &*merged)]].concat()).output().unwrap();
    assert!(output.status.success(), "{}", said(&output));
    assert!(first == reports(&merged));
}

#[test]
fn two_submissions_of_one_name_are_both_kept() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    hand_in(&path("monday"), "ann", FULL);
    hand_in(&path("friday"), "ann", "not Rust");
    for section in ["monday", "friday"] {
        let report = path(&format!("{section}-report"));
        if !ran(&grade(&path(section), &report, &[]), &report) {
            return;
        }
    }
    let parts = [("", &*path("monday-report")), ("", &path("friday-report")), ("--out", &path("all"))];
    let output = grader(&["merge"], &parts).output().unwrap();
    assert!(output.status.success(), "{}", said(&output));
    let grades = fs::read_to_string(path("all/grades.csv")).unwrap();
    assert!(grades.contains("\nann,10,right") && grades.contains("\nann (2),0,does not compile"), "{grades}");

    // Parts that were graded otherwise cannot be put together.
    let other = path("other");
    assert!(grade(&path("friday"), &other, &["--seed", "3"]).status.success());
    let parts = [("", &*path("monday-report")), ("", &other), ("--out", &path("none"))];
    let output = grader(&["merge"], &parts).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(
        said(&output).contains("graded with another seed") && !path("none").exists(),
        "{}",
        said(&output)
    );
}

#[test]
fn every_lesson_can_be_graded() {
    let folder = tempfile::tempdir().unwrap();
    let [class, report] = ["class", "report"].map(|name| folder.path().join(name));
    let lessons = tasks::lessons(Path::new(COURSE)).unwrap();
    for lesson in &lessons {
        let file = format!("lessons/{lesson}/mission/src/lib.rs");
        let starter = fs::read_to_string(Path::new(COURSE).join(&file)).unwrap();
        for (name, text) in [
            ("starter", starter.clone()),
            ("thief", theft(lesson, &starter)),
            ("solver", fs::read_to_string(solution(lesson)).unwrap()),
        ] {
            let file = class.join(name).join(&file);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, text).unwrap();
        }
    }
    let output = grader(&["class", "--seed", "2"], &[("", &class), ("--out", &report)]).output().unwrap();
    if !ran(&output, &report) {
        return;
    }
    let class: Value = serde_json::from_slice(&fs::read(report.join("class.json")).unwrap()).unwrap();
    for (n, lesson) in lessons.iter().enumerate() {
        let outcome = |name: &str| without_pictures(&class["submissions"][name][n]["outcome"]);
        let starter = outcome("starter");
        assert!(
            earned(&starter) == 0 && starter.to_string().contains("not written yet"),
            "{lesson}: {starter}"
        );
        let thief = outcome("thief").to_string();
        assert!(thief.contains("NotCompiled") && thief.contains("error[E043"), "{lesson}: {thief}");
        assert_eq!(earned(&outcome("solver")), 10, "{lesson}: {}", outcome("solver"));
    }
}

fn solution(lesson: &str) -> PathBuf {
    Path::new(COURSE).join("tests/lessons").join(lesson).join("solution.rs")
}

/// The starter, but the first thing that it is to write is taken from the lesson itself.
fn theft(lesson: &str, starter: &str) -> String {
    let begins = starter.lines().find(|line| line.starts_with("pub fn ") || line.starts_with("pub struct "));
    let end = |c: char| !(c.is_alphanumeric() || c == '_' || c == ' ');
    let begins = begins.and_then(|line| line.split(end).next()).unwrap();
    let asked = begins.rsplit(' ').next().unwrap();
    let files = fs::read_dir(Path::new(COURSE).join("lessons").join(lesson).join("src")).unwrap();
    let defines = |path: &PathBuf| {
        let text = fs::read_to_string(path).unwrap();
        text.lines().any(|line| line.starts_with(begins) && line[begins.len()..].starts_with(end))
    };
    let file = files.map(|entry| entry.unwrap().path()).filter(|path| path.is_file()).find(defines).unwrap();
    let module = match file.file_stem().unwrap().to_str().unwrap() {
        "lib" => String::new(),
        module => format!("::{module}"),
    };
    let name = tasks::name(lesson);
    format!("{starter}\nmod theft {{\n    pub use ::{name}{module}::{asked} as stolen;\n}}\n")
}

#[test]
fn bad_command_lines_and_folders_are_one_line() {
    let folder = small_class();
    let [class, report, empty, missing] =
        ["class", "report", "empty", "missing"].map(|name| folder.path().join(name));
    fs::create_dir(&empty).unwrap();
    for (dir, more, code, words) in [
        (&class, &["--lessons", "99"][..], 2, "not a lesson's number"),
        (&class, &["--lessons", "3-1"], 2, "names no lesson"),
        (&class, &["--shard", "3/2"], 2, "not i/n"),
        (&class, &["--shard", "1/2"], 2, "--shard needs --seed"),
        (&class, &["--course", "/"], 1, "is not the course"),
        (&empty, &[], 1, "holds no submission"),
        (&missing, &[], 1, "cannot read"),
    ] {
        let output = grader(&[&["class"], more].concat(), &[("", dir), ("--out", &report)]).output().unwrap();
        assert_eq!(output.status.code(), Some(code), "{more:?}: {}", said(&output));
        assert!(
            said(&output).contains(words) || said(&output).contains("nothing was graded"),
            "{}",
            said(&output)
        );
        assert!(!said(&output).contains("panicked"));
    }
}
