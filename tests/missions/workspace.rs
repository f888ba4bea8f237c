//! The missions as a student meets them, in a copy of the workspace: untouched, and solved.
//!
//! Building them takes a minute, and in a student's clone they are no longer untouched; so these tests are for
//! the course's own CI: `cargo test -p verify --test missions -- --ignored`.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use checks::missions::LESSONS;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// How a mission is solved here: what stands before its functions, and the items of the lesson that are copied
/// behind it, each known by how its first line begins. Lessons of which no function is built on an earlier one's
/// lend them as they are.
const SOLUTIONS: [(&str, &str, &[&str]); 9] = [
    ("01-lines", "pub use lines::line;", &[]),
    (
        "02-wireframe",
        "use common::{Color, IVec2, Image, Model, Vec3};\nuse lines::line;",
        &["pub fn unique_edges", "pub fn wireframe", "fn draw_edge", "pub fn edges", "pub fn to_pixel"],
    ),
    ("03-triangles", "pub use triangles::{fill, flat_intensity, to_screen};", &[]),
    (
        "04-zbuffer",
        "use common::{Image, Vec3};\nuse triangles::fill;\npub use zbuffer::{DepthBuffer, Surface, to_screen};",
        &["pub fn depth_at", "pub fn fill_nearest", "pub fn z_f32", "fn draw_nearest"],
    ),
    (
        "05-textures",
        "use common::{Color, IVec2, Image, Model, Vec2, Vec3};\nuse triangles::flat_intensity;\n\
         use zbuffer::{DepthBuffer, fill_nearest, to_screen};",
        &["pub fn texel", "pub fn interpolate", "pub fn draw_textured"],
    ),
    (
        "06-gouraud",
        "use common::{Image, Vec3};\npub use gouraud::{Drawn, Scene, corner_normals};\n\
         use textures::{interpolate, texel};\nuse zbuffer::{DepthBuffer, fill_nearest};",
        &["pub fn intensities", "pub fn gouraud", "fn draw<"],
    ),
    (
        "07-transforms",
        "pub use transforms::{normal_matrix, place, projection, scale, translate, viewport};",
        &[],
    ),
    (
        "08-camera",
        "use common::{Mat3, Mat4, Vec3};\nuse transforms::translate;",
        &["pub fn basis", "pub fn lookat", "fn farthest_axis"],
    ),
    (
        "09-shaders",
        "use common::{Color, Vec2};\nuse shaders::Uniforms;\nuse shaders::source::Source;\n\
         pub use shaders::lighting::{Gouraud, Quantized};\nuse textures::texel;",
        &["pub struct Texture", "impl Source for Texture"],
    ),
];

/// The name in a lesson's `NN-name`.
fn name(lesson: &str) -> &str {
    lesson.split_once('-').expect("a lesson has a number").1
}

/// A copy of the workspace, in the folder of build products, so that the next run builds little.
struct Copy {
    root: PathBuf,
}

impl Copy {
    fn new() -> Self {
        let root = Path::new(ROOT).join("target/missions");
        fs::create_dir_all(&root).expect("a folder can be made");
        // What was copied before goes; what was built stays.
        if let Ok(entries) = fs::read_dir(&root) {
            for path in entries.map(|entry| entry.expect("the folder can be read").path()) {
                let _ = if path.is_dir() && !path.ends_with("target") {
                    fs::remove_dir_all(path)
                } else {
                    Ok(())
                };
            }
        }
        for entry in fs::read_dir(ROOT).expect("the workspace can be read") {
            let from = entry.expect("the workspace can be read").path();
            let name = from.file_name().expect("it has a name");
            if ![".git", "target", "out"].iter().any(|left_out| name == *left_out) {
                copy(&from, &root.join(name));
            }
        }
        Self { root }
    }

    fn mission(&self, lesson: &str, file: &str) -> PathBuf {
        self.root.join("lessons").join(lesson).join("mission").join(file)
    }

    fn cargo(&self, command: &str, lessons: &[&str], arguments: &[&str]) -> Output {
        Command::new(env!("CARGO"))
            .arg(command)
            .args(lessons.iter().flat_map(|lesson| ["--package".into(), format!("my-{}", name(lesson))]))
            .args(arguments)
            .current_dir(&self.root)
            .env("CARGO_TARGET_DIR", self.root.join("target"))
            .env("CARGO_TERM_COLOR", "never")
            .output()
            .expect("cargo can be started")
    }

    /// A student's program, run.
    fn run(&self, lesson: &str) -> Output {
        let program = format!("target/debug/my-{}{}", name(lesson), std::env::consts::EXE_SUFFIX);
        let mut command = Command::new(self.root.join(program));
        command.current_dir(&self.root).env("RUST_BACKTRACE", "1").output().expect("it was built")
    }

    fn read(&self, lesson: &str, file: &str) -> String {
        fs::read_to_string(self.mission(lesson, file)).expect("it is part of the mission")
    }

    fn write(&self, lesson: &str, file: &str, text: &str) {
        fs::write(self.mission(lesson, file), text).expect("the copy can be written");
    }
}

fn copy(from: &Path, to: &Path) {
    if from.is_dir() {
        fs::create_dir_all(to).expect("a folder can be made");
        for entry in fs::read_dir(from).expect("the folder can be read") {
            let path = entry.expect("the folder can be read").path();
            copy(&path, &to.join(path.file_name().expect("it has a name")));
        }
    } else {
        fs::copy(from, to).expect("a file can be copied");
    }
}

/// All the code of a lesson's library.
fn source(lesson: &str) -> String {
    let folder = Path::new(ROOT).join("lessons").join(lesson).join("src");
    let mut paths: Vec<PathBuf> = fs::read_dir(folder)
        .expect("a lesson has code")
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| !path.ends_with("main.rs"))
        .collect();
    paths.sort();
    paths.iter().map(|path| fs::read_to_string(path).expect("it is text")).collect()
}

/// The item whose first line begins in this way. It ends at the next line that is a lone brace.
fn item(source: &str, begins: &str) -> String {
    let lines: Vec<&str> = source.lines().skip_while(|line| !line.starts_with(begins)).collect();
    let end = lines.iter().position(|line| *line == "}").unwrap_or_else(|| panic!("there is no `{begins}`"));
    lines[..=end].join("\n") + "\n"
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// One test, since both need the same copy: first as it is, then solved.
#[test]
#[ignore = "a minute; for the course's own CI"]
fn starters_fail_kindly_and_solutions_pass() {
    let copy = Copy::new();

    // Untouched.
    let built = copy.cargo("build", &LESSONS, &[]);
    let said = text(&built.stderr);
    assert!(built.status.success() && !said.contains("warning"), "{said}");
    for lesson in LESSONS {
        let ran = copy.run(lesson);
        let said = text(&ran.stderr);
        assert_eq!((ran.status.code(), text(&ran.stdout).as_str()), (Some(1), ""), "{lesson}: {said}");
        let path = format!("lessons/{lesson}/mission/src/lib.rs:");
        let kind =
            said.starts_with("Nothing is written yet.") && said.contains(&path) && said.lines().count() == 1;
        assert!(kind, "{lesson}: {said}");
    }
    assert!(!copy.root.join("out").exists(), "nothing is drawn yet");
    let tested = text(&copy.cargo("test", &LESSONS, &["--no-fail-fast"]).stdout);
    let verdicts: Vec<&str> = tested.lines().filter(|line| line.starts_with("test ")).collect();
    let failed = verdicts.iter().filter(|line| line.contains("FAILED") && line.contains("not written yet"));
    let results = verdicts.iter().filter(|line| line.starts_with("test result: FAILED. 0 passed"));
    assert_eq!((failed.count() + results.clone().count(), results.count()), (verdicts.len(), 9), "{tested}");

    // Solved, each on the solutions of the lessons below.
    for (lesson, preamble, items) in SOLUTIONS {
        let source = source(lesson);
        let solved: String = items.iter().map(|begins| item(&source, begins)).collect();
        copy.write(lesson, "src/lib.rs", &format!("#![allow(missing_docs)]\n{preamble}\n{solved}"));
        let own = format!("{} = {{ path = \"..\" }}\n", name(lesson));
        copy.write(lesson, "Cargo.toml", &on_own_lessons(&copy.read(lesson, "Cargo.toml"), &own));
    }
    let built = copy.cargo("build", &LESSONS, &[]);
    assert!(built.status.success(), "{}", text(&built.stderr));
    for lesson in LESSONS {
        let ran = copy.run(lesson);
        let said = text(&ran.stdout);
        assert!(ran.status.success() && said.contains(": 10 of 10 points\n"), "{lesson}: {said}");
        assert!(copy.root.join(format!("out/my-{lesson}.png")).exists());
    }

    // Whatever the student's code does, there is a verdict.
    let solution = copy.read("01-lines", "src/lib.rs");
    for (fault, points, said) in [
        ("loop {}", 0, "ran out of time"),
        ("std::process::abort()", 0, "crashed: the program ended"),
        ("std::process::exit(0)", 0, "crashed: the program ended"),
        ("if image.width() == 64 { [0][a.x as usize]; }", 2, "lib.rs:4: index out of bounds"),
        ("println!(\"right\"); lines::line(a, b, image, color)", 10, "\nright  picture "),
    ] {
        let code = format!(
            "#![allow(unused)]\nuse common::{{Color, IVec2, Image}};\n\
             pub fn line(a: IVec2, b: IVec2, image: &mut Image, color: Color) {{\n{fault};\n\
             lines::line(a, b, image, color) }}"
        );
        copy.write("01-lines", "src/lib.rs", &code);
        assert!(copy.cargo("build", &["01-lines"], &[]).status.success(), "{fault}");
        let told = text(&copy.run("01-lines").stdout);
        assert!(
            told.contains(said) && told.contains(&format!(": {points} of 10 points\n")),
            "{fault}: {told}"
        );
    }
    copy.write("01-lines", "src/lib.rs", &solution);

    // They are built on each other: what is broken in lesson 4 is broken in 5 and 6, and not in 3 or 7.
    let broken = copy.read("04-zbuffer", "src/lib.rs").replace("depth > depths.get", "depth < depths.get");
    copy.write("04-zbuffer", "src/lib.rs", &broken);
    assert!(copy.cargo("build", &LESSONS, &[]).status.success());
    let passing: Vec<&str> = LESSONS.into_iter().filter(|lesson| copy.run(lesson).status.success()).collect();
    assert_eq!(
        passing,
        ["01-lines", "02-wireframe", "03-triangles", "07-transforms", "08-camera", "09-shaders"]
    );
}

/// A mission's Cargo.toml with every `# name = …` line in the place of the line above it; and with the lesson
/// itself, where it has not got that.
fn on_own_lessons(manifest: &str, own: &str) -> String {
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
    let key = own.split(' ').next().unwrap_or_default();
    if !lines.iter().any(|line| line.starts_with(&format!("{key}."))) {
        let at = lines.iter().position(|line| line == "[dependencies]").expect("it has dependencies") + 1;
        lines.insert(at, own.trim_end().into());
    }
    lines.join("\n") + "\n"
}

/// No starter has code in a function that is to be written but the `todo!`, or a line of the reference.
#[test]
#[ignore = "for the course's own CI: a student's are written"]
fn no_starter_gives_the_solution_away() {
    for lesson in LESSONS {
        let path = Path::new(ROOT).join("lessons").join(lesson).join("mission/src/lib.rs");
        let starter = fs::read_to_string(path).expect("a lesson has a mission");
        let code = |text: &str| -> BTreeSet<String> {
            let lines = text.lines().filter(|line| line.starts_with("    ")).map(str::trim);
            // What says nothing of the solution: signatures, types, and what is too short to be one.
            let tells = |line: &&str| {
                let given = ["//", "#[", "fn ", "pub ", "type ", "let _ = ", "Self", "Some(())"];
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
        .current_dir(ROOT)
        .output()
        .expect("cargo can be started");
    let metadata = text(&output.stdout);
    let (members, defaults) = metadata
        .split_once("\"workspace_members\":")
        .and_then(|(_, rest)| rest.split_once("\"workspace_default_members\":"))
        .expect("cargo lists members and default members");
    let defaults = defaults.split_once(']').expect("it is a list").0;
    for lesson in LESSONS {
        let id = format!("lessons/{lesson}/mission#my-{}@", name(lesson));
        assert!(members.contains(&id) && !defaults.contains(&id), "{lesson}");
        assert!(defaults.contains(&format!("lessons/{lesson}#{}@", name(lesson))), "{lesson}");
    }
}
