//! Tells a student what is right and what is not.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;
use std::{fs, io};

use anyhow::{Context, bail};
use checks::picture::distance;
use common::compare::{Difference, side_by_side};
use common::terminal::{eprintln, print};
use common::{Color, Format, IVec2, Image, preview};
use tasks::{Answer, COURSE, Raw, SEED, Shape};

use super::ask::{ask, tell_seed};
use super::enlarge::{self, enlarged, shape_at};
use super::report::{points, report, said};
use super::{AnswerKey, Finding, Judge, Question, Verdict, marks, source};

/// What a student's program answers to the questions of one check, or of all.
fn answers(program: &Path, keys: &[AnswerKey], check: Option<&str>) -> anyhow::Result<Vec<Answer>> {
    let folder = std::env::temp_dir().join(format!("pixel-by-pixel-{}", std::process::id()));
    fs::create_dir(&folder).context("cannot make a folder for the answers")?;
    let questions: Vec<usize> = keys.iter().map(|key| key.questions.len()).collect();
    let start = |file: &Path, from: usize| {
        let mut child = Command::new(program);
        child.arg("--answer").arg(file).arg(from.to_string()).args(check).stdin(Stdio::piped());
        let mut child = child.spawn().with_context(|| format!("cannot start {}", program.display()))?;
        tell_seed(&mut child, SEED)?;
        Ok(child)
    };
    let begun = Instant::now();
    let answered = ask(&questions, &folder, start, |_| Ok(begun.elapsed()));
    fs::remove_dir_all(&folder).context("cannot remove the folder of the answers")?;
    Ok(answered?.answers)
}

impl<F> Judge<F> {
    /// Says what is right and what is not, of one check or of all, and shows it.
    pub(crate) fn show(
        &self,
        program: &Path,
        check: Option<&str>,
        in_terminal: bool,
    ) -> anyhow::Result<ExitCode> {
        let lesson = self.mission.lesson;
        let mut keys = self.key(SEED);
        keys.retain(|key| check.is_none_or(|check| key.name == check));
        if keys.is_empty() {
            let names = self.mission.checks.iter().map(|check| format!("{:?}", check.name));
            bail!(
                "there is no check {:?}; there are {}",
                check.unwrap_or_default(),
                names.collect::<Vec<_>>().join(", ")
            );
        }
        let source = self.source()?;
        let answers = answers(program, &keys, check)?;
        let verdicts = self.judge(SEED, &keys, &answers);
        if check.is_none() {
            self.keep(&verdicts, source);
        }
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

        if let Some(Shown { title, pictures, pixel, shape }) = self.shown(&keys, &answers, &verdicts) {
            fs::create_dir_all("out").context("cannot create the folder out/")?;
            let path = PathBuf::from("out").join(format!("my-{lesson}.png"));
            let picture = side_by_side(&pictures.each_ref()).map_err(anyhow::Error::msg)?;
            picture.write(&path)?;
            if let Some(text) = preview::for_terminal(&picture).filter(|_| in_terminal) {
                print(&text)?;
            }
            print(&format!("{}: expected | got | difference, {title}\n", path.display()))?;
            let path = PathBuf::from("out").join(format!("my-{lesson}-enlarged.png"));
            let [expected, got, _] = &pictures;
            match pixel.and_then(|at| Some((at, enlarged([expected, got], at, shape.as_ref())?))) {
                Some((IVec2 { x, y }, image)) => {
                    image.write(&path)?;
                    let belongs = shape.map(|shape| format!(", of the {}", enlarge::said(&shape)));
                    print(&format!(
                        "{}: expected | got around ({x}, {y}), the first wrong pixel{}\n",
                        path.display(),
                        belongs.unwrap_or_default()
                    ))?;
                }
                // That of an earlier run would mislead.
                None if path.exists() => {
                    fs::remove_file(&path).context("cannot remove an old picture")?;
                }
                None => (),
            }
        }
        print(&report(lesson, &keys, &verdicts, check.is_none()))?;
        if check.is_none() {
            print(&marks::onward(Path::new(COURSE), lesson)?)?;
        }
        let all = verdicts.iter().all(|verdict| verdict.wrong.is_empty());
        Ok(if all { ExitCode::SUCCESS } else { ExitCode::FAILURE })
    }

    /// What the student wrote. It is read before the program is asked: whoever saves while it answers gets the mark of
    /// what was there. What the grader would not grade is not judged here, either.
    fn source(&self) -> anyhow::Result<io::Result<String>> {
        let file = marks::source(Path::new(COURSE), self.mission.lesson);
        let text = fs::read_to_string(&file);
        if let Some(why) = text.as_ref().ok().and_then(|text| source::refused(text)) {
            let file = Path::new("lessons").join(self.mission.lesson).join("mission/src/lib.rs");
            bail!("{}: {why}", file.display());
        }
        Ok(text)
    }

    /// Keeps the mark of a run of all checks. Where that cannot be, the verdicts are still worth telling.
    fn keep(&self, verdicts: &[Verdict], source: io::Result<String>) {
        let kept = source.context("cannot read the mission's lib.rs").and_then(|source| {
            marks::keep(Path::new(COURSE), self.mission.lesson, points(verdicts), &source)
        });
        if let Err(error) = kept {
            eprintln(format_args!("The mark is not kept: {error:#}"));
        }
    }

    /// What is to be seen: the first picture that is wrong, or else that of the lesson.
    fn shown(&self, keys: &[AnswerKey], answers: &[Answer], verdicts: &[Verdict]) -> Option<Shown> {
        let asked = keys.iter().zip(verdicts).flat_map(|(key, verdict)| {
            (key.questions.iter().enumerate()).map(move |(n, question)| {
                let wrong = verdict.wrong.iter().find(|wrong| wrong.question == n);
                (key, n, question, wrong)
            })
        });
        let pictures: Vec<_> = asked
            .zip(answers)
            .filter_map(|((key, n, question, wrong), answer)| {
                Some((key, n, wrong, pictures(question, answer)?))
            })
            .collect();
        let first = pictures.iter().find(|(.., wrong, _)| wrong.is_some());
        let (key, n, wrong, pictures) =
            first.or_else(|| pictures.iter().find(|(key, ..)| key.name == "picture"))?;
        let pixel = wrong.and_then(|wrong| wrong.findings.iter().find_map(Finding::pixel));
        let tasks = self.mission.tasks(SEED).into_iter().flatten();
        let task = tasks.skip(key.first - 1 + n).take(1).next()?;
        Some(Shown {
            title: format!("{}: {}", key.name, task.input),
            pictures: pictures.clone(),
            pixel,
            shape: pixel.and_then(|at| shape_at(&(task.shapes)(&self.reference), at).cloned()),
        })
    }

    /// Tells the verdicts as `cargo test` tells those of tests, and understands what it may be asked: a part of a
    /// name, `--exact`, `--list`.
    pub(crate) fn test(&self, program: &Path, words: &[&str]) -> anyhow::Result<ExitCode> {
        let filters: Vec<&&str> = words.iter().filter(|word| !word.starts_with('-')).collect();
        let exact = words.contains(&"--exact");
        let chosen = |name: &str| {
            filters.is_empty()
                || filters.iter().any(|word| if exact { **word == name } else { name.contains(**word) })
        };
        if words.contains(&"--list") {
            let names = self.mission.checks.iter().map(|check| check.name).filter(|name| chosen(name));
            let list: String = names.map(|name| format!("{name}: test\n")).collect();
            return print(&list).map(|()| ExitCode::SUCCESS);
        }
        let mut keys = self.key(SEED);
        let source = self.source()?;
        let answers = answers(program, &keys, None)?;
        let mut verdicts = self.judge(SEED, &keys, &answers);
        self.keep(&verdicts, source);
        keys.retain(|key| chosen(key.name));
        verdicts.retain(|verdict| chosen(verdict.name));
        let mut text = format!("\nrunning {} tests\n", verdicts.len());
        for (verdict, key) in verdicts.iter().zip(&keys) {
            let said = verdict.wrong.first().map(|wrong| {
                format!("FAILED, {}", said(&key.questions[wrong.question].input, &wrong.findings))
            });
            let cause =
                verdict.cause.as_ref().map(|cause| format!("; likely cause: {cause}")).unwrap_or_default();
            text += &format!("test {} ... {}{cause}\n", verdict.name, said.as_deref().unwrap_or("ok"));
        }
        let passed = verdicts.iter().filter(|verdict| verdict.wrong.is_empty()).count();
        let failed = verdicts.len() - passed;
        let word = if failed == 0 { "ok" } else { "FAILED" };
        text += &format!("\ntest result: {word}. {passed} passed; {failed} failed\n\n");
        print(&text)?;
        Ok(if failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
    }
}

/// What there is to be seen.
struct Shown {
    title: String,
    /// Expected, got, and their difference.
    pictures: [Image; 3],
    /// The first wrong pixel, and what it belongs to.
    pixel: Option<IVec2>,
    shape: Option<Shape>,
}

/// The pictures of a question that asks for one: expected, got, and their difference. Without a result, what
/// was got is black.
pub(crate) fn pictures(question: &Question, answer: &Answer) -> Option<[Image; 3]> {
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
