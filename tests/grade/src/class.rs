//! All submissions of a class. A text is graded once, whoever handed it in, and what is finished stays so.
//!
//! What a machine could not do while it did others at the same time is put off, and done alone. What it cannot do then,
//! either, is not graded: a person has to look.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use ::judge::message;
use ::judge::source::{Refusal, refused};
use anyhow::{Context, anyhow, bail, ensure};
use indicatif::{ProgressBar, ProgressStyle};

use crate::compile::{Compiled, compile};
use crate::judge::{self, Asked};
use crate::kit::{self, Kit};
use crate::proof::{self, Wall};
use crate::report::{self, Extras, Time};
use crate::results::{Class, Graded, Lesson, Look, Outcome, Work};
use crate::submission::{HandedOut, Source, Submission, Wanted};
use crate::walls::Terms;
use crate::{file, run, seed};

/// What to grade, and how.
pub(crate) struct Options {
    /// The class.
    pub(crate) submissions: Vec<Submission>,
    /// Where the reports go.
    pub(crate) report: PathBuf,
    /// The course.
    pub(crate) course: PathBuf,
    /// What the inputs are made from, if that is wished for.
    pub(crate) seed: Option<u64>,
    /// Which lessons.
    pub(crate) lessons: Vec<String>,
    /// Which part of the class, of how many: 1 of 1 is all of it.
    pub(crate) shard: (usize, usize),
    /// How many submissions at a time.
    pub(crate) jobs: usize,
    /// Submissions whose results are no longer wanted.
    pub(crate) regrade: Vec<String>,
    /// Whether those are no longer wanted that are not right.
    pub(crate) regrade_failed: bool,
    /// What else is written.
    pub(crate) extras: Extras,
    /// On what terms they are compiled and run.
    pub(crate) terms: Terms,
}

/// What one submission has for one lesson.
struct HandedIn<'a> {
    submission: &'a Submission,
    lesson: usize,
    source: Source,
    /// Under which its result is kept; that of another text, kit or seed is another.
    key: String,
}

/// Texts that could not be graded, by their keys, and why.
type PutOff = Mutex<BTreeMap<String, String>>;

/// Grades a class, or goes on with it, and writes the reports. Returns the class.
pub(crate) fn grade(options: &Options) -> anyhow::Result<Class> {
    let started = Instant::now();
    let (shard, of) = options.shard;
    let submissions: Vec<&Submission> = options.submissions.iter().skip(shard - 1).step_by(of).collect();
    let walls = prove(options.terms.closed)?;
    let work = std::path::absolute(options.report.join("work"))?;
    let (graded, scratch) = (work.join("graded"), work.join("scratch"));
    let _lock = begin(&work, &scratch)?;
    let seed = seed::of(&options.report, options.seed)?;
    let kits = build(options, &scratch)?;
    let asked: Vec<Vec<Asked>> = kits.iter().map(|kit| judge::checks(kit, seed)).collect::<Result<_, _>>()?;

    let handed_in = collect(&submissions, &kits, seed, options)?;
    forget(&handed_in, &graded, options)?;
    let mut texts: BTreeMap<&str, &HandedIn> = BTreeMap::new();
    for one in handed_in.iter().filter(|one| matches!(one.source, Source::Text(_))) {
        texts.entry(&one.key).or_insert(one);
    }
    let count = texts.len();
    let open: Vec<&HandedIn> =
        texts.into_values().filter(|one| Graded::read(&graded, &one.key).is_none()).collect();
    let now = open.len();
    let put_off = PutOff::default();
    let try_one = |one: &HandedIn| {
        let Source::Text(text) = &one.source else { return Ok(()) };
        let folder = scratch.join(&one.key);
        let result = grade_one(&kits[one.lesson], &asked[one.lesson], text, &folder, seed, options);
        if folder.exists() {
            std::fs::remove_dir_all(&folder)?;
        }
        let mut put_off = put_off.lock().map_err(|_| anyhow!("a part of the grader panicked"))?;
        match result {
            Ok(result) => {
                put_off.remove(&one.key);
                result.write(&graded, &one.key)
            }
            Err(why) => {
                put_off.insert(one.key.clone(), format!("{why:#}"));
                Ok(())
            }
        }
    };
    each(open.clone(), options.jobs, try_one)?;
    let again: Vec<&HandedIn> = match put_off.lock() {
        Ok(put_off) => open.into_iter().filter(|one| put_off.contains_key(&one.key)).collect(),
        Err(_) => bail!("a part of the grader panicked"),
    };
    each(again, 1, try_one)?;
    let put_off = put_off.into_inner().unwrap_or_default();

    let now = now - put_off.len();
    let (class, times) = gather(handed_in, &graded, &put_off, seed, options, walls, asked)?;
    let looks = report::write(&class, times, &options.extras, &options.report)?;
    std::fs::remove_dir_all(&scratch)?;
    println!(
        "{looks}{} submissions, {count} different texts: {now} graded now, {} kept from before; {:.1} s\n{}",
        submissions.len(),
        count - now - put_off.len(),
        started.elapsed().as_secs_f64(),
        options.report.join(report::PAGE).display()
    );
    Ok(class)
}

/// Removes results that are no longer wanted.
fn forget(handed_in: &[HandedIn], graded: &Path, options: &Options) -> anyhow::Result<()> {
    for name in &options.regrade {
        let there = handed_in.iter().any(|one| one.submission.name == *name);
        ensure!(there, "--regrade {name}: the class holds no such submission");
    }
    for one in handed_in.iter().filter(|one| !one.key.is_empty()) {
        let wrong = |result: Graded| !result.is_right();
        if options.regrade.contains(&one.submission.name)
            || options.regrade_failed && Graded::read(graded, &one.key).is_some_and(wrong)
        {
            Graded::remove(graded, &one.key)?;
        }
    }
    Ok(())
}

/// Tries the walls; without them, goes on only where that is wanted.
fn prove(closed: bool) -> anyhow::Result<Vec<Wall>> {
    const CURE: &str =
        "nothing was graded; --unsafe-no-sandbox grades all the same, with this account's rights";
    let walls = proof::prove(closed).context(CURE)?;
    let open: Vec<&str> = walls.iter().filter(|wall| !wall.held).map(|wall| wall.against.as_str()).collect();
    ensure!(!closed || open.is_empty(), "no wall against {}: {CURE}", open.join(", "));
    Ok(walls)
}

/// Makes sure that no other grader writes here, and clears what one left that was killed.
fn begin(work: &Path, scratch: &Path) -> anyhow::Result<File> {
    let make = || std::fs::create_dir_all(work).and_then(|()| File::create(work.join("lock")));
    let lock = make().with_context(|| format!("cannot write {}", work.display()))?;
    if lock.try_lock().is_err() {
        bail!("another grader is at work in {}", work.display());
    }
    if scratch.exists() {
        std::fs::remove_dir_all(scratch).with_context(|| format!("cannot clear {}", scratch.display()))?;
    }
    Ok(lock)
}

fn build(options: &Options, scratch: &Path) -> anyhow::Result<Vec<Kit>> {
    let spinner = ProgressBar::new_spinner().with_message("building the missions");
    spinner.enable_steady_tick(Duration::from_millis(100));
    let kits = kit::build(&options.course, &options.lessons, &scratch.join("kits"))?;
    spinner.finish_and_clear();
    Ok(kits)
}

fn collect<'a>(
    submissions: &[&'a Submission],
    kits: &[Kit],
    seed: u64,
    options: &Options,
) -> anyhow::Result<Vec<HandedIn<'a>>> {
    let lessons = tasks::lessons(&options.course)?;
    let handed_out = |kit: &Kit| HandedOut::read(&options.course, &lessons, &kit.lesson);
    let handed_out: Vec<HandedOut> = kits.iter().map(handed_out).collect::<Result<_, _>>()?;
    let how = format!("{seed} {}", options.terms.closed);
    let mut all = Vec::new();
    for submission in submissions {
        let files = submission.files();
        for (lesson, handed_out) in handed_out.iter().enumerate() {
            let alone = kits.len() == 1;
            let wanted = Wanted { lessons: &lessons, alone, handed_out };
            let source = unless_refused(files.source(&wanted));
            let key = match &source {
                Source::Text(text) => file::digest([kits[lesson].digest.as_bytes(), how.as_bytes(), text]),
                _ => String::new(),
            };
            all.push(HandedIn { submission, lesson, source, key });
        }
    }
    Ok(all)
}

/// A source, unless its text says what no submission may say.
fn unless_refused(source: Source) -> Source {
    let refused = match &source {
        Source::Text(text) => std::str::from_utf8(text).ok().and_then(refused),
        _ => None,
    };
    match refused {
        Some(Refusal { found, because, cure }) => {
            Source::NotRead(Look { found, because: because.into(), cure })
        }
        None => source,
    }
}

/// Does something with each text, several at a time, and shows how far it is. The first error ends it.
fn each<'a>(
    texts: Vec<&'a HandedIn<'a>>,
    jobs: usize,
    work: impl Fn(&HandedIn) -> anyhow::Result<()> + Sync,
) -> anyhow::Result<()> {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg} {eta}")?;
    let bar = ProgressBar::new(texts.len() as u64).with_style(style);
    let (texts, result) = (Mutex::new(texts.into_iter()), Mutex::new(Ok(())));
    let take =
        || result.lock().is_ok_and(|result| result.is_ok()).then(|| texts.lock().ok()?.next()).flatten();
    std::thread::scope(|scope| {
        for _ in 0..jobs {
            scope.spawn(|| {
                while let Some(one) = take() {
                    bar.set_message(one.submission.name.clone());
                    if let (Err(error), Ok(mut result)) = (work(one), result.lock()) {
                        *result = Err(error.context(format!("while {} was graded", one.submission.name)));
                    }
                    bar.inc(1);
                }
            });
        }
    });
    bar.finish_and_clear();
    result.into_inner().unwrap_or_else(|_| bail!("a part of the grader panicked"))
}

/// Grades a text.
///
/// # Errors
/// Where that says nothing of the text: the machine did not do what it was to do.
fn grade_one(
    kit: &Kit,
    asked: &[Asked],
    text: &[u8],
    folder: &Path,
    seed: u64,
    options: &Options,
) -> anyhow::Result<Graded> {
    let started = Instant::now();
    let compiled = compile(kit, text, folder, options.terms)?;
    let compiling = started.elapsed().as_secs_f64();
    let outcome = match compiled {
        Compiled::Not(said) => Outcome::NotCompiled(said),
        Compiled::Program(program) => {
            let (answers, printed) = run::run(kit, &program, asked, seed, folder, options.terms)?;
            // Nobody knows all the results that a hostile program can send. One of them must not end the class.
            let checks =
                judge::mark(kit, asked, &answers, seed, folder).context("its answers cannot be judged")?;
            Outcome::Ran { checks, printed }
        }
    };
    Ok(Graded { outcome, compiling, running: started.elapsed().as_secs_f64() - compiling })
}

/// Puts the results of all submissions together.
fn gather(
    handed_in: Vec<HandedIn>,
    graded: &Path,
    put_off: &BTreeMap<String, String>,
    seed: u64,
    options: &Options,
    walls: Vec<Wall>,
    asked: Vec<Vec<Asked>>,
) -> anyhow::Result<(Class, Vec<Time>)> {
    let lesson = |(name, asked): (&String, Vec<Asked>)| Lesson {
        name: name.clone(),
        checks: asked.into_iter().map(|asked| asked.check).collect(),
    };
    let lessons = options.lessons.iter().zip(asked).map(lesson).collect();
    let mut class = Class { seed, lessons, walls, submissions: BTreeMap::new(), late: BTreeSet::new() };
    let mut times = Vec::new();
    for HandedIn { submission, lesson, source, key } in handed_in {
        let (text, outcome) = match source {
            Source::Missing => (String::new(), Outcome::Missing),
            Source::NotRead(look) => (String::new(), Outcome::NotGraded(look)),
            Source::Text(text) if put_off.contains_key(&key) => {
                let look = Look {
                    found: "its text".into(),
                    because: message::cut(&put_off[&key]),
                    cure: "give the same command again when the machine has less to do".into(),
                };
                (file::digest([text.as_slice()]), Outcome::NotGraded(look))
            }
            Source::Text(text) => {
                let result = Graded::read(graded, &key).context("a result is gone")?;
                let (compiling, running) = (result.compiling, result.running);
                let lesson = options.lessons[lesson].clone();
                times.push(Time { submission: submission.name.clone(), lesson, compiling, running });
                (file::digest([text.as_slice()]), result.outcome)
            }
        };
        class.late.extend(submission.late.then(|| submission.name.clone()));
        class.submissions.entry(submission.name.clone()).or_default().push(Work { text, outcome });
    }
    Ok((class, times))
}
