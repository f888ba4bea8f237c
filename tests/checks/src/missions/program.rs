//! A student's program: tries what was written, compares, and says what is right and what is not.
//!
//! The student's functions run in a child process, the same program started again, so that an endless loop or
//! a crash there ends with a verdict here. The child appends its answers to a file, a line each; when it dies,
//! or is stopped since no answer came for a while, the task at hand gets that as its answer, and another child
//! does the rest.

use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode};
use std::sync::Mutex;
use std::time::{Duration, Instant, SystemTime};

use anyhow::{Context, bail, ensure};
use common::compare::{Difference, side_by_side};
use common::terminal::{eprintln, print};
use common::{Color, Format, IVec2, Image, preview};

use super::judge::{Finding, Question, Sheet, Verdict};
use super::raw::{Answer, Raw};
use super::{LESSONS, Mission, SEED};
use crate::picture::distance;

/// How long a task may take. The references need less than a tenth of it on a slow machine.
const PATIENCE: Duration = Duration::from_secs(5);

/// How long one may take after another took too long: whoever has an endless loop need not wait for each check.
const LITTLE_PATIENCE: Duration = Duration::from_secs(1);

/// How long all tasks may take together, however often an answer comes.
const LONGEST: Duration = Duration::from_secs(30);

/// How often a waiting process looks around.
const PAUSE: Duration = Duration::from_millis(5);

/// How often `--watch` looks whether a file was saved.
const GLANCE: Duration = Duration::from_millis(200);

const USAGE: &str = "flags: --watch (run again whenever you save), --quiet (no picture in the terminal)";

/// Runs a mission on what a student wrote. `testing` is `cfg!(test)` of the caller: verdicts are then told in
/// the manner of `cargo test`.
///
/// The exit code is 0 if everything is right, 1 if not, 2 where the command line is at fault.
#[must_use]
pub fn run<F>(mission: &Mission<F>, student: &F, testing: bool) -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let result = match words.as_slice() {
        ["--answer", file, from, seed] => answer(mission, student, file, from, seed),
        ["--watched", folder] => std::env::set_current_dir(folder)
            .map_err(Into::into)
            .and_then(|()| show(mission, true))
            // Cargo would have something to say about a failure.
            .map(|_| ExitCode::SUCCESS),
        _ if testing => test(mission, &words),
        [] => show(mission, true),
        ["--quiet"] => show(mission, false),
        ["--watch"] => watch(mission),
        _ => {
            eprintln(USAGE);
            return ExitCode::from(2);
        }
    };
    result.unwrap_or_else(|error| {
        eprintln(format_args!("error: {error:#}"));
        ExitCode::FAILURE
    })
}

/// The child's part: does the tasks from the number `from` on and appends their answers to a file.
fn answer<F>(
    mission: &Mission<F>,
    student: &F,
    file: &str,
    from: &str,
    seed: &str,
) -> anyhow::Result<ExitCode> {
    static SAID: Mutex<String> = Mutex::new(String::new());
    std::panic::set_hook(Box::new(|panic| {
        let place = panic.location().map(|at| format!("{}:{}", at.file().replace('\\', "/"), at.line()));
        let said = panic.payload_as_str().unwrap_or("a panic without a message");
        if let Ok(mut last) = SAID.lock() {
            *last = format!("{}: {said}", place.unwrap_or_default());
        }
    }));
    let mut file = std::fs::OpenOptions::new().append(true).open(file)?;
    for task in mission.tasks(seed.parse()?).into_iter().flatten().skip(from.parse()?) {
        let answer = match catch_unwind(AssertUnwindSafe(|| (task.work)(student))) {
            Ok(raw) => Answer::Raw(raw),
            Err(_) => {
                let said = SAID.lock().map(|said| said.clone()).unwrap_or_default();
                // The words with which `todo!` begins.
                match said.split_once(": not yet implemented") {
                    Some((place, hint)) => Answer::Unwritten(format!("{place}{hint}")),
                    None => Answer::Crashed(said),
                }
            }
        };
        file.write_all(format!("{answer}\n").as_bytes())?;
    }
    Ok(ExitCode::SUCCESS)
}

/// Starts this program again as a child that does the tasks from a number on.
fn start(file: &Path, from: usize) -> anyhow::Result<Child> {
    let mut child = Command::new(std::env::current_exe()?);
    child.arg("--answer").arg(file).args([from.to_string(), SEED.to_string()]);
    child.spawn().context("cannot start this program again")
}

/// The parent's part: all answers, from as many children as it takes. `start(file, from)` starts one that
/// does the tasks from that number on and appends their answers to that file.
///
/// # Errors
/// Where a child cannot be started, or a temporary file not be made and read.
pub fn ask(
    sheets: &[Sheet],
    mut start: impl FnMut(&Path, usize) -> anyhow::Result<Child>,
) -> anyhow::Result<Vec<Answer>> {
    // Where each check's questions end.
    let ends: Vec<usize> = sheets
        .iter()
        .scan(0, |end, sheet| {
            *end += sheet.questions.len();
            Some(*end)
        })
        .collect();
    let count = ends.last().copied().unwrap_or(0);
    let mut answers: Vec<Answer> = Vec::new();
    let mut patience = PATIENCE;
    let until = Instant::now() + LONGEST;
    while answers.len() < count {
        let file = tempfile::NamedTempFile::new().context("cannot make a temporary file")?;
        let child = start(file.path(), answers.len())?;
        let end = wait(child, file.path(), patience, until)?;
        let text = std::fs::read(file.path()).context("cannot read the answers")?;
        let text = String::from_utf8_lossy(&text);
        let lines: Vec<Answer> = text.lines().map_while(|line| line.parse().ok()).collect();
        answers.extend(lines);
        if answers.len() < count {
            let skipped = if end == Answer::OutOfTime {
                patience = LITTLE_PATIENCE;
                // The rest of the check is not tried.
                let over = Instant::now() >= until;
                ends.iter().copied().find(|&end| end > answers.len() && !over).unwrap_or(count)
            } else {
                answers.len() + 1
            };
            answers.resize(skipped, end);
        }
    }
    answers.truncate(count);
    Ok(answers)
}

/// Waits for a child that appends to a file. Returns how it ended, as the answer to the task that it left.
fn wait(mut child: Child, file: &Path, patience: Duration, until: Instant) -> anyhow::Result<Answer> {
    let (mut length, mut since) = (0, Instant::now());
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Answer::Crashed(format!("the program ended ({status})")));
        }
        let now = std::fs::metadata(file)?.len();
        if now > length && Instant::now() < until {
            (length, since) = (now, Instant::now());
        } else if since.elapsed() > patience || Instant::now() >= until {
            child.kill()?;
            child.wait()?;
            return Ok(Answer::OutOfTime);
        }
        std::thread::sleep(PAUSE);
    }
}

/// Judges answers to the questions of all sheets in a row.
#[must_use]
pub fn judge(sheets: &[Sheet], answers: &[Answer]) -> Vec<Verdict> {
    let mut rest = answers;
    let verdict = |sheet: &Sheet| {
        let (own, others) = rest.split_at(sheet.questions.len().min(rest.len()));
        rest = others;
        sheet.judge(own)
    };
    sheets.iter().map(verdict).collect()
}

/// Says what is right and what is not, and shows it.
fn show<F>(mission: &Mission<F>, in_terminal: bool) -> anyhow::Result<ExitCode> {
    let sheets = mission.key(SEED);
    let answers = ask(&sheets, start)?;
    let verdicts = judge(&sheets, &answers);
    let unwritten = |answer: &Answer| match answer {
        Answer::Unwritten(said) => Some(said.clone()),
        _ => None,
    };
    if let Some(said) =
        answers.first().and_then(unwritten).filter(|_| answers.iter().all(|a| unwritten(a).is_some()))
    {
        eprintln(format_args!("Nothing is written yet. Begin at {said}"));
        return Ok(ExitCode::FAILURE);
    }

    if let Some((title, sheet)) = comparison(&sheets, &answers, &verdicts) {
        std::fs::create_dir_all("out").context("cannot create the folder out/")?;
        let path = PathBuf::from("out").join(format!("my-{}.png", mission.lesson));
        sheet.write(&path)?;
        if let Some(text) = preview::for_terminal(&sheet).filter(|_| in_terminal) {
            print(&text)?;
        }
        print(&format!("{}: expected | got | difference, {title}\n", path.display()))?;
    }
    print(&report(mission, &sheets, &verdicts))?;
    let all = verdicts.iter().all(|verdict| verdict.wrong.is_empty());
    Ok(if all { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The verdicts as text.
fn report<F>(mission: &Mission<F>, sheets: &[Sheet], verdicts: &[Verdict]) -> String {
    let width = verdicts.iter().map(|verdict| verdict.name.len()).max().unwrap_or(0);
    let mut lines = Vec::new();
    for (verdict, sheet) in verdicts.iter().zip(sheets) {
        let Verdict { name, asks, points, wrong, cause } = verdict;
        let word = if wrong.is_empty() { "right" } else { "wrong" };
        lines.push(format!("{word}  {name:width$}  {}/{points}  {asks}", verdict.earned()));
        let Some(first) = wrong.first() else { continue };
        let count = match (wrong.len(), sheet.questions.len()) {
            (_, 1) => String::new(),
            (wrong, of) if wrong == of => format!("all {of} inputs; the first, "),
            (wrong, of) => format!("{wrong} of {of} inputs; the first, "),
        };
        let input = &sheet.questions[first.question].input;
        lines.push(format!("       {count}{input}: {}", said(&first.findings)));
        if let Some(cause) = cause {
            lines.push(format!("       likely cause: {cause}"));
        }
    }
    let [earned, of] = [Verdict::earned, |verdict: &Verdict| verdict.points]
        .map(|points: fn(&Verdict) -> u32| verdicts.iter().map(points).sum::<u32>());
    lines.push(format!("{}: {earned} of {of} points", mission.lesson));
    if earned == of {
        let next = LESSONS.iter().skip_while(|lesson| **lesson != mission.lesson).nth(1);
        lines.push(match next.and_then(|lesson| Some((lesson, lesson.split_once('-')?.1))) {
            Some((lesson, name)) => {
                format!("Next: lessons/{lesson}/mission/src/lib.rs, and `cargo run -p my-{name}`")
            }
            None => "That was the last mission of this part.".into(),
        });
    }
    lines.join("\n") + "\n"
}

/// Findings in one line.
fn said(findings: &[Finding]) -> String {
    findings.iter().map(Finding::to_string).collect::<Vec<_>>().join("; ")
}

/// The picture to look at, and what it shows: the first one that is wrong, or else that of the lesson.
fn comparison(sheets: &[Sheet], answers: &[Answer], verdicts: &[Verdict]) -> Option<(String, Image)> {
    let asked = sheets.iter().zip(verdicts).flat_map(|(sheet, verdict)| {
        (sheet.questions.iter().enumerate()).map(move |(n, question)| {
            let wrong = verdict.wrong.iter().any(|wrong| wrong.question == n);
            (sheet.name, question, wrong)
        })
    });
    let pictures: Vec<_> = asked
        .zip(answers)
        .filter_map(|((name, question, wrong), answer)| {
            Some((name, question, wrong, pictures(question, answer)?))
        })
        .collect();
    let wrong = pictures.iter().find(|&&(_, _, wrong, _)| wrong);
    let (name, question, _, [expected, got, off]) =
        wrong.or_else(|| pictures.iter().find(|&&(name, ..)| name == "picture"))?;
    Some((format!("{name}: {}", question.input), side_by_side(&[expected, got, off]).ok()?))
}

/// The pictures of a question that asks for one: expected, got, and their difference. Without a result, what
/// was got is black.
#[must_use]
pub fn pictures(question: &Question, answer: &Answer) -> Option<[Image; 3]> {
    let expected = image(&question.expected, &question.expected)?;
    let got = match answer {
        Answer::Raw(raw) => image(raw, &question.expected)?,
        _ => Image::new(expected.width() as u16, expected.height() as u16, Format::Rgb),
    };
    let mut off = Difference::between(&expected, &got);
    let near = |at: &IVec2| {
        let colors = (expected.get(at.x, at.y), got.get(at.x, at.y));
        let tolerance = question.precision.tolerance as u8;
        matches!(colors, (Some(a), Some(b)) if distance(a, b) <= tolerance)
    };
    for list in [&mut off.missing, &mut off.extra, &mut off.recolored] {
        list.retain(|at| !near(at));
    }
    let off = off.picture(&expected);
    Some([expected, got, off])
}

/// A result as a picture, if it is one; depths in grey, as far as they lie between those expected.
fn image(raw: &Raw, expected: &Raw) -> Option<Image> {
    match (raw, expected) {
        (Raw::Picture(image), _) => Some(image.clone()),
        (Raw::Depths { width, values }, Raw::Depths { values: expected, .. }) => {
            let finite = || expected.iter().copied().filter(|depth| depth.is_finite());
            let (far, near) =
                (finite().fold(f32::INFINITY, f32::min), finite().fold(f32::NEG_INFINITY, f32::max));
            let mut image = Image::new(*width as u16, (values.len() / width) as u16, Format::Rgb);
            for (n, &depth) in values.iter().enumerate().filter(|(_, depth)| depth.is_finite()) {
                let level = Color::gray(0.1 + 0.9 * (depth - far) / (near - far).max(f32::MIN_POSITIVE));
                image.set((n % width) as i32, (n / width) as i32, level);
            }
            Some(image)
        }
        _ => None,
    }
}

/// Tells the verdicts as `cargo test` tells those of tests, and understands what it may be asked: a part of a
/// name, `--exact`, `--list`.
fn test<F>(mission: &Mission<F>, words: &[&str]) -> anyhow::Result<ExitCode> {
    let filters: Vec<&&str> = words.iter().filter(|word| !word.starts_with('-')).collect();
    let exact = words.contains(&"--exact");
    let chosen = |name: &str| {
        filters.is_empty()
            || filters.iter().any(|word| if exact { **word == name } else { name.contains(**word) })
    };
    if words.contains(&"--list") {
        let names = mission.checks.iter().map(|check| check.name).filter(|name| chosen(name));
        let list: String = names.map(|name| format!("{name}: test\n")).collect();
        return print(&list).map(|()| ExitCode::SUCCESS);
    }
    let mut sheets = mission.key(SEED);
    let answers = ask(&sheets, start)?;
    let mut verdicts = judge(&sheets, &answers);
    sheets.retain(|sheet| chosen(sheet.name));
    verdicts.retain(|verdict| chosen(verdict.name));
    let mut text = format!("\nrunning {} tests\n", verdicts.len());
    for (verdict, sheet) in verdicts.iter().zip(&sheets) {
        let said = verdict.wrong.first().map(|wrong| {
            format!("FAILED, {}: {}", sheet.questions[wrong.question].input, said(&wrong.findings))
        });
        let cause = verdict.cause.map(|cause| format!("; likely cause: {cause}")).unwrap_or_default();
        text += &format!("test {} ... {}{cause}\n", verdict.name, said.as_deref().unwrap_or("ok"));
    }
    let passed = verdicts.iter().filter(|verdict| verdict.wrong.is_empty()).count();
    let failed = verdicts.len() - passed;
    let word = if failed == 0 { "ok" } else { "FAILED" };
    text += &format!("\ntest result: {word}. {passed} passed; {failed} failed\n\n");
    print(&text)?;
    Ok(if failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Runs the mission, and again whenever its source is saved.
///
/// Cargo builds it as a test: a program that runs, as this one does, cannot be replaced on every system.
fn watch<F>(mission: &Mission<F>) -> anyhow::Result<ExitCode> {
    let package = mission.package();
    let Some(folder) = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from) else {
        bail!("--watch needs cargo: cargo run -p {package} -- --watch");
    };
    let source = folder.join("src/lib.rs");
    let saved = || -> Option<SystemTime> { std::fs::metadata(&source).ok()?.modified().ok() };
    ensure!(saved().is_some(), "cannot read {}", source.display());
    loop {
        let before = saved();
        Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
            .args(["test", "--quiet", "--bin", &package, "--manifest-path"])
            .arg(folder.join("Cargo.toml"))
            .args(["--", "--watched"])
            .arg(std::env::current_dir()?)
            .status()
            .context("cannot start cargo")?;
        print(&format!("watching {}; Ctrl+C ends\n", source.display()))?;
        while saved() == before {
            std::thread::sleep(GLANCE);
        }
    }
}
