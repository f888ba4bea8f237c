//! The missions as a student meets them, in a copy of the workspace: untouched, and solved.
//!
//! Building them takes a minute, and in a student's clone they are no longer untouched; so these tests are for
//! the course's own CI: `cargo test -p course -- --ignored`.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use object::{Object, ObjectSymbol};
use tasks::{COURSE, name};

use crate::copy::Copy;

/// The lessons, by number and name.
static LESSONS: LazyLock<Vec<String>> =
    LazyLock::new(|| tasks::lessons(Path::new(COURSE)).expect("the workspace can be read"));

impl Copy {
    fn mission(&self, lesson: &str, file: &str) -> PathBuf {
        self.root.join("lessons").join(lesson).join("mission").join(file)
    }

    /// `cargo` with students' programs.
    fn missions(&self, command: &str, lessons: &[impl AsRef<str>], arguments: &[&str]) -> Output {
        let packages: Vec<String> =
            lessons.iter().map(|lesson| format!("--package=my-{}", name(lesson.as_ref()))).collect();
        let packages = packages.iter().map(String::as_str);
        self.cargo(
            &[command].into_iter().chain(packages).chain(arguments.iter().copied()).collect::<Vec<_>>(),
        )
    }

    /// Builds students' programs, and the judges that they call.
    fn build(&self, lessons: &[impl AsRef<str>]) -> Output {
        let judges: Vec<String> =
            lessons.iter().map(|lesson| format!("--package={}-tests", name(lesson.as_ref()))).collect();
        self.missions("build", lessons, &judges.iter().map(String::as_str).collect::<Vec<_>>())
    }

    /// A student's program, run.
    fn run(&self, lesson: &str) -> Output {
        let mut command = Command::new(Self::program(&format!("my-{}", name(lesson))));
        command.current_dir(&self.root).env("RUST_BACKTRACE", "1").output().expect("it was built")
    }

    fn read(&self, lesson: &str, file: &str) -> String {
        fs::read_to_string(self.mission(lesson, file)).expect("it is part of the mission")
    }

    fn write(&self, lesson: &str, file: &str, text: &str) {
        fs::write(self.mission(lesson, file), text).expect("the copy can be written");
    }
}

/// All the code of a lesson's library.
fn source(lesson: &str) -> String {
    code_below(&Path::new(COURSE).join("lessons").join(lesson).join("src"))
}

/// The code of a folder, that of folders in it among it, but for its program.
fn code_below(folder: &Path) -> String {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder)
        .expect("a lesson has code")
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| !path.ends_with("main.rs"))
        .collect();
    paths.sort();
    let text = |path: &PathBuf| {
        if path.is_dir() { code_below(path) } else { fs::read_to_string(path).expect("it is text") }
    };
    paths.iter().map(text).collect()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// One test, since both need the same copy: first as it is, then solved.
#[test]
#[ignore = "a minute; for the course's own CI"]
fn starters_fail_kindly_and_solutions_pass() {
    let copy = Copy::new();

    // What an earlier run has drawn.
    let _ = fs::remove_dir_all(copy.root.join("out"));

    // Untouched.
    let built = copy.build(&LESSONS);
    let said = text(&built.stderr);
    assert!(built.status.success() && !said.contains("warning"), "{said}");
    for lesson in LESSONS.iter() {
        let ran = copy.run(lesson);
        let said = text(&ran.stderr);
        assert_eq!((ran.status.code(), text(&ran.stdout).as_str()), (Some(1), ""), "{lesson}: {said}");
        let path = format!("lessons/{lesson}/mission/src/lib.rs:");
        let kind =
            said.starts_with("Nothing is written yet.") && said.contains(&path) && said.lines().count() == 1;
        assert!(kind, "{lesson}: {said}");
    }
    let mut kept =
        fs::read_dir(copy.root.join("out")).expect("marks are kept").map(|file| file.expect("a file").path());
    assert!(kept.all(|file| file.extension() == Some("mark".as_ref())), "nothing is drawn yet");
    let tested = text(&copy.missions("test", &LESSONS, &["--no-fail-fast"]).stdout);
    let verdicts: Vec<&str> = tested.lines().filter(|line| line.starts_with("test ")).collect();
    let failed = verdicts.iter().filter(|line| line.contains("FAILED") && line.contains("not written yet"));
    let results = verdicts.iter().filter(|line| line.starts_with("test result: FAILED. 0 passed"));
    assert_eq!(
        (failed.count() + results.clone().count(), results.count()),
        (verdicts.len(), LESSONS.len()),
        "{tested}"
    );

    // Solved, each on the solutions of the lessons below.
    for lesson in LESSONS.iter() {
        let solution = Path::new(COURSE).join("tests/lessons").join(lesson).join("solution.rs");
        let solution =
            fs::read_to_string(&solution).unwrap_or_else(|_| panic!("{} is not there", solution.display()));
        copy.write(lesson, "src/lib.rs", &solution);
        copy.write(lesson, "Cargo.toml", &on_own_lessons(&copy.read(lesson, "Cargo.toml")));
    }
    let built = copy.build(&LESSONS);
    assert!(built.status.success(), "{}", text(&built.stderr));
    for lesson in LESSONS.iter() {
        let ran = copy.run(lesson);
        let said = text(&ran.stdout);
        assert!(ran.status.success() && said.contains(": 10 of 10 points\n"), "{lesson}: {said}");
        assert!(copy.root.join(format!("out/my-{lesson}.png")).exists());
    }

    // With all that is written called, there is nothing of the lesson itself in the program; in the judge there is, unless all
    // of it was inlined. Windows keeps symbols in another file.
    let mut judges = 0;
    for lesson in LESSONS.iter().filter(|_| !cfg!(windows)) {
        let crates = |program: String| crates(&Copy::program(&program));
        let (own, mission) = (name(lesson), crates(format!("my-{}", name(lesson))));
        let linked = mission.contains("tasks") && mission.contains(&format!("{own}_tasks"));
        assert!(linked && !mission.contains(own), "{lesson}: {mission:?}");
        judges += usize::from(crates(format!("{own}-judge")).contains(own));
    }
    assert!(cfg!(windows) || 2 * judges > LESSONS.len(), "{judges} judges with their lesson");

    // Every input can be pasted into a test.
    for lesson in LESSONS.iter() {
        let solution = copy.read(lesson, "src/lib.rs");
        let judge = Copy::program(&format!("{}-judge", name(lesson)));
        let input = |n: usize| {
            let arguments = ["input", "no program", &n.to_string()];
            let said = Command::new(&judge).args(arguments).output().expect("it was built");
            said.status.success().then(|| text(&said.stdout))
        };
        let inputs: String = (1..).map_while(input).collect();
        copy.write(lesson, "src/lib.rs", &format!("{solution}\n{inputs}"));
    }
    let output = copy.missions("test", &LESSONS, &["--lib"]);
    let tested = text(&output.stdout);
    let passed =
        tested.lines().filter(|line| line.starts_with("test input_") && line.ends_with("ok")).count();
    let all = tested.lines().filter(|line| line.starts_with("test result: ok.")).count();
    assert!(all == LESSONS.len() && passed > 100, "{passed} of {all}: {tested}{}", text(&output.stderr));
    for lesson in LESSONS.iter() {
        let solution = Path::new(COURSE).join("tests/lessons").join(lesson).join("solution.rs");
        copy.write(lesson, "src/lib.rs", &fs::read_to_string(solution).expect("it was read before"));
    }

    // Whatever the student's code does, there is a verdict.
    let solution = copy.read("01-lines", "src/lib.rs");
    for (fault, points, said) in [
        ("loop {}", 0, "ran out of time"),
        ("std::process::abort()", 0, "crashed: the program ended"),
        ("std::process::exit(0)", 0, "crashed: the program ended"),
        ("if image.width() == 64 { [0][a.x as usize]; }", 2, "lib.rs:4: index out of bounds"),
        ("println!(\"right\")", 10, "\nright  picture "),
    ] {
        let code = format!(
            "#![allow(unused)]\nuse common::{{Color, IVec2, Image}};\n\
             pub fn line(a: IVec2, b: IVec2, image: &mut Image, color: Color) {{\n{fault};\n\
             solution::line(a, b, image, color) }}\nmod solution {{ {solution} }}"
        );
        copy.write("01-lines", "src/lib.rs", &code);
        assert!(copy.build(&["01-lines"]).status.success(), "{fault}");
        let told = text(&copy.run("01-lines").stdout);
        assert!(
            told.contains(said) && told.contains(&format!(": {points} of 10 points\n")),
            "{fault}: {told}"
        );
    }
    copy.write("01-lines", "src/lib.rs", &solution);

    // They are built on each other: where one is not written, those that use it fail, and no others.
    let built_on = |below: &str| -> Vec<&String> {
        let own = format!("package = \"my-{}\"", name(below));
        LESSONS.iter().filter(|lesson| copy.read(lesson, "Cargo.toml").contains(&own)).collect()
    };
    let below = LESSONS.iter().max_by_key(|lesson| built_on(lesson).len()).expect("there are lessons");
    let starter = Path::new(COURSE).join("lessons").join(below).join("mission/src/lib.rs");
    copy.write(below, "src/lib.rs", &fs::read_to_string(starter).expect("a lesson has a mission"));
    assert!(copy.build(&LESSONS).status.success());
    let failing: Vec<&String> = LESSONS.iter().filter(|lesson| !copy.run(lesson).status.success()).collect();
    assert!(failing.len() > 1);
    assert_eq!(failing, [&[below][..], &built_on(below)].concat());
}

/// The crates of which a program has functions. There are two ways in which symbols are mangled: by Rust's RFC 2603 a crate's
/// name has the form `Cs`, a hash, `_`, its length, and itself; in the older way it is the first of the names after `_ZN`, each
/// behind its length, and of a trait's function for a type stands in that one, behind `$`s and before `..`.
fn crates(program: &Path) -> BTreeSet<String> {
    let bytes = fs::read(program).expect("it was built");
    let file = object::File::parse(&*bytes).expect("it is a program");
    let symbols = file.symbols().filter(ObjectSymbol::is_definition);
    let names = symbols.filter_map(|symbol| symbol.name().ok().map(str::to_owned));
    let counted = |text: &str| {
        let digits = text.find(|c: char| !c.is_ascii_digit())?;
        text[digits..].get(..text[..digits].parse().ok()?).map(str::to_owned)
    };
    let named = |piece: &str| counted(piece.split_once('_')?.1);
    let older = |name: &str| {
        let first = counted(name.strip_prefix("_ZN")?)?;
        let path = first.split("..").next()?;
        path.rsplit('$').next().map(str::to_owned)
    };
    let both = |name: String| -> Vec<String> {
        name.split("Cs").skip(1).filter_map(named).chain(older(&name)).collect()
    };
    names.flat_map(both).collect()
}

/// A mission's Cargo.toml with every `# name = …` line in the place of the line above it.
fn on_own_lessons(manifest: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut moved = 0;
    for line in manifest.lines() {
        match line.strip_prefix("# ").filter(|line| line.contains("package = \"my-")) {
            Some(mine) => {
                let above = lines.pop().expect("there is a line above");
                let same = |line: &str| line.split(['.', ' ']).next().map(str::to_owned);
                assert_eq!(same(&above), same(mine), "{manifest}");
                lines.push(mine.into());
                moved += 1;
            }
            None => lines.push(line.into()),
        }
    }
    let others = lines.iter().filter(|line| line.contains("package = \"my-")).count();
    assert_eq!(others, moved);
    lines.join("\n") + "\n"
}

/// No starter has code in a function that is to be written but the `todo!`, or a line of the reference.
#[test]
#[ignore = "for the course's own CI: a student's are written"]
fn no_starter_gives_the_solution_away() {
    for lesson in LESSONS.iter() {
        let path = Path::new(COURSE).join("lessons").join(lesson).join("mission/src/lib.rs");
        let starter = fs::read_to_string(path).expect("a lesson has a mission");
        let code = |text: &str| -> BTreeSet<String> {
            let lines = text.lines().filter(|line| line.starts_with("    ")).map(str::trim);
            // What says nothing of the solution: signatures, types, and what is too short to be one.
            let tells = |line: &&str| {
                let given = [
                    "//",
                    "#[",
                    "fn ",
                    "pub ",
                    "type ",
                    "let _ = ",
                    "Self",
                    "Some(())",
                    // Mission 9 gives the levels to whoever cuts down to them.
                    "Some(f32::from(uniforms.levels))",
                ];
                line.len() > 8 && !given.iter().any(|word| line.starts_with(word)) && !line.ends_with(',')
            };
            lines.filter(tells).map(str::to_owned).collect()
        };
        let (own, reference) = (code(&starter), code(&source(lesson)));
        let same: Vec<&String> = own.intersection(&reference).collect();
        assert!(same.is_empty(), "{lesson}: {same:?}");
        // Whatever is left is a `todo!` and its words.
        let rest: Vec<&String> = own
            .iter()
            .filter(|line| {
                !line.starts_with("todo!(")
                    && !line.starts_with('"')
                    && !line.ends_with('"')
                    && !line.ends_with('\\')
            })
            .collect();
        assert!(rest.is_empty(), "{lesson}: {rest:?}");
        assert!(starter.contains("todo!("), "{lesson}");
    }
}

/// Every mission is a member, and none is built by a plain `cargo test`.
#[test]
fn missions_are_members_but_not_default_members() {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--no-deps", "--offline", "--format-version", "1"])
        .current_dir(COURSE)
        .output()
        .expect("cargo can be started");
    let metadata = text(&output.stdout);
    let (members, defaults) = metadata
        .split_once("\"workspace_members\":")
        .and_then(|(_, rest)| rest.split_once("\"workspace_default_members\":"))
        .expect("cargo lists members and default members");
    let defaults = defaults.split_once(']').expect("it is a list").0;
    for lesson in LESSONS.iter() {
        let id = format!("lessons/{lesson}/mission#my-{}@", name(lesson));
        assert!(members.contains(&id) && !defaults.contains(&id), "{lesson}");
        assert!(defaults.contains(&format!("lessons/{lesson}#{}@", name(lesson))), "{lesson}");
    }
}

/// What runs a submission is built of the tasks and of what is given, and has no way to what is expected.
#[test]
fn a_mission_is_built_without_what_it_asks_for() {
    for (n, lesson) in LESSONS.iter().enumerate() {
        let name = name(lesson);
        let output = Command::new(env!("CARGO"))
            .args(["tree", "--offline", "--edges=normal", "--prefix=none", "--format={p}", "--package"])
            .arg(format!("my-{name}"))
            .current_dir(COURSE)
            .output()
            .expect("cargo can be started");
        let tree = text(&output.stdout);
        let own: BTreeSet<&str> = tree
            .lines()
            .filter(|line| line.contains('/'))
            .filter_map(|line| line.split(' ').next())
            .collect();
        let mut may: BTreeSet<String> = ["common".into(), "tasks".into(), format!("my-{name}")].into();
        may.extend([format!("{name}-tasks"), format!("{name}-given")]);
        may.extend(LESSONS[..n].iter().map(|below| tasks::name(below).to_string()));
        let more: Vec<_> = own.iter().filter(|package| !may.contains(**package)).collect();
        assert!(own.contains("tasks") && more.is_empty(), "{lesson}: {more:?}");
    }
}

/// Whoever does nothing earns nothing, in each mission: its judge's tests say so, and of all checks that they depend on the seed.
#[test]
fn every_mission_is_tried_by_doing_nothing() {
    for lesson in LESSONS.iter() {
        let faults = Path::new(COURSE).join("tests/lessons").join(lesson).join("faults.rs");
        let tests = fs::read_to_string(faults).expect("a mission has faults");
        let missing =
            ["JUDGE.check()", "JUDGE.earns_nothing(&"].into_iter().find(|test| !tests.contains(test));
        assert_eq!(missing, None, "{lesson}");
    }
}
