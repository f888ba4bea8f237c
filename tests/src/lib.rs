//! What the tests of all lessons share: running a lesson's program, what holds for every command line, and snapshots
//! of pictures.
//!
//! The tests of a lesson are a package in `tests/lessons/NN-name`:
//!
//! | file | what is in it |
//! |---|---|
//! | `snapshots.rs` | what each method draws, against the `pictures/` beside it |
//! | `stability.rs` | where methods fail, and where they must not: tables of (input, method, what must happen) |
//! | `properties.rs` | what must hold for any input, tried on random ones; `proptest` makes a failing one small |
//! | `usage.rs` | the program's command line |
//! | `tasks/`, `judge.rs`, `faults.rs`, `solution.rs` | the mission: inputs, judgement, faults that are recognised |
//!
//! Small pictures are text; whole ones are PNG, drawn by the lesson's program. Up to lesson 6 the tolerance is 0:
//! lines and `edges` compute in integers, and what is computed in floats uses +, −, ×, ÷ and √ alone, which
//! IEEE 754 defines to the last bit on every platform. From lesson 7 on there are sines, which platforms round
//! differently, and matrix products, which glam computes with fused multiplications on some processors. Both move
//! a corner by an ulp or so: an intensity may then be rounded to the other side, and a pixel at a side or at a
//! texel's border change hands.
//!
//! A failure is pinned to the letter, so that a test notices when a method stops failing as the lesson says it
//! does. Every method of a lesson has a row for every input.
//!
//! This package's own tests:
//!
//! ```text
//! files/      bad files, what a terminal shows, and the assets made again
//! platforms/  the pictures, their bytes counted, on other platforms
//! benches/    how fast scenes are drawn, by the course and by others
//! ```

pub mod stability;
#[cfg(target_os = "linux")]
pub mod terminal;
pub mod turns;
pub mod usage;

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Mutex, PoisonError};

use checks::picture::{Fault, faults};
use common::file::Encoding;
use common::{Bounds, IVec2, Image, Lesson, Method, Vec3};
use escargot::CargoBuild;
use insta::internals::SnapshotContents;
use insta::{Comparator, Settings, Snapshot, assert_binary_snapshot, assert_snapshot};

/// The sphere of 5,000 triangles.
pub const SPHERE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/sphere.obj");

/// The wooden texture.
pub const CRATE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/crate.png");

/// A lesson's program, or that of the first example, built once a process, in the profile of these tests: what it
/// needs is built already, and overflow is noticed.
fn built(name: &str) -> PathBuf {
    static BUILT: Mutex<BTreeMap<String, PathBuf>> = Mutex::new(BTreeMap::new());
    let mut built = BUILT.lock().unwrap_or_else(PoisonError::into_inner);
    if !built.contains_key(name) {
        let build = match name {
            "pixel" => CargoBuild::new().package("common").example(name),
            lesson => CargoBuild::new().package(lesson).bin(lesson),
        };
        // Together with this package, so that they share its features and all that was built with them.
        let program = build
            .arg("--package=verify")
            .manifest_path(concat!(env!("CARGO_MANIFEST_DIR"), "/../Cargo.toml"))
            .run();
        let program = program.unwrap_or_else(|error| panic!("{name}: {error}"));
        built.insert(name.into(), program.path().to_path_buf());
    }
    built[name].clone()
}

/// A lesson's program, about to run in a folder.
#[must_use]
pub fn program(lesson: &str, folder: &Path) -> Command {
    let mut command = Command::new(built(lesson));
    command.current_dir(folder);
    command
}

/// Runs a lesson's program in a folder to its end.
///
/// # Panics
/// Where it cannot be started.
#[must_use]
pub fn run(lesson: &str, folder: &Path, arguments: &[&str]) -> Output {
    program(lesson, folder).args(arguments).output().unwrap_or_else(|error| panic!("{lesson}: {error}"))
}

/// The picture that a lesson's program draws.
///
/// # Panics
/// Where the program fails.
#[must_use]
pub fn draw(lesson: &str, arguments: &[&str]) -> Image {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let output = run(lesson, folder.path(), &[arguments, &["--out", "picture.png"]].concat());
    assert!(output.status.success(), "{lesson} {arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    Image::read(&folder.path().join("picture.png")).expect("the program wrote a picture")
}

/// A lesson's folder of snapshots, each named after what it shows.
fn settings(lesson: &Lesson) -> Settings {
    let mut settings = Settings::clone_current();
    let lessons = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons");
    settings.set_snapshot_path(lessons.join(lesson.folder()).join("pictures"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings
}

/// Compares PNG snapshots pixel by pixel, so that another version of the encoder changes nothing.
#[derive(Clone)]
struct Pixels {
    /// By how much a channel may differ.
    tolerance: u8,
    /// How many pixels may differ by more.
    strays: usize,
}

impl Comparator for Pixels {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        let [expected, got] = [reference, test].map(|snapshot| match snapshot.contents() {
            SnapshotContents::Binary(Some(bytes)) => Image::decode(bytes.as_slice(), Encoding::Png).ok(),
            _ => None,
        });
        let (Some(expected), Some(got)) = (expected, got) else { return false };
        let faults = faults(&expected, &got, self.tolerance);
        faults.iter().take(5).for_each(|fault: &Fault| println!("{fault}"));
        println!("{} pixels differ", faults.len());
        faults.len() <= self.strays && !matches!(faults[..], [Fault::Size { .. }])
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

/// Compares a picture with the lesson's snapshot of that name; each channel may differ by `tolerance`.
///
/// # Panics
/// Where it differs by more, or there is no such snapshot. What was drawn is then in
/// `target/drawn/NN-LESSON-NAME.png`.
pub fn assert_picture(lesson: &Lesson, name: &str, image: &Image, tolerance: u8) {
    assert_pixels(lesson, name, image, Pixels { tolerance, strays: 0 });
}

/// As [`assert_picture`], for a picture that depends on sines or on SIMD: each channel may differ by 1, and one
/// pixel in 2,000 by any amount. (An eye moved by an ulp, or turns composed in f64 instead of f32, change one or
/// two pixels of 40,000.)
///
/// # Panics
/// As [`assert_picture`].
pub fn assert_similar(lesson: &Lesson, name: &str, image: &Image) {
    let strays = (image.width() * image.height()) as usize / 2000;
    assert_pixels(lesson, name, image, Pixels { tolerance: 1, strays });
}

/// Compares what a lesson's program draws with the lesson's snapshot of that name: pixel by pixel up to lesson 6, from
/// lesson 7 on as [`assert_similar`].
///
/// # Panics
/// As [`draw`] and [`assert_picture`].
pub fn assert_drawn(lesson: &Lesson, name: &str, arguments: &[&str]) {
    let picture = draw(lesson.name, arguments);
    if lesson.number < 7 {
        assert_picture(lesson, name, &picture, 0);
    } else {
        assert_similar(lesson, name, &picture);
    }
}

/// Compares what a lesson's program draws by each method with the snapshot of the method's name.
///
/// # Panics
/// As [`assert_drawn`].
pub fn assert_each_drawn<F>(lesson: &Lesson, methods: &[Method<F>], arguments: &[&str]) {
    for method in methods {
        assert_drawn(lesson, method.name, &[arguments, &["--method", method.name]].concat());
    }
}

/// Compares what `draw` makes of each method with the text snapshot `WHAT-METHOD`.
///
/// # Panics
/// As [`assert_text`].
pub fn assert_each_text<F>(
    lesson: &Lesson,
    what: &str,
    methods: &[Method<F>],
    draw: impl Fn(&Method<F>) -> Image,
) {
    for method in methods {
        assert_text(lesson, &format!("{what}-{}", method.name), &draw(method));
    }
}

fn assert_pixels(lesson: &Lesson, name: &str, image: &Image, comparator: Pixels) {
    // A name may not hold a dot, since that begins the ending.
    let name = name.replace('.', "_");
    let bytes = image.encode(Encoding::Png).expect("the picture has pixels");
    let mut settings = settings(lesson);
    settings.set_comparator(Box::new(comparator));
    let compare = || settings.bind(|| assert_binary_snapshot!(&format!("{name}.png"), bytes));
    if let Err(difference) = catch_unwind(AssertUnwindSafe(compare)) {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/drawn");
        let drawn = folder.join(format!("{}-{name}.png", lesson.folder()));
        let written = std::fs::create_dir_all(&folder).is_ok() && image.write(&drawn).is_ok();
        println!(
            "what was drawn: {}",
            if written { drawn.display().to_string() } else { "not saved".into() }
        );
        resume_unwind(difference);
    }
}

/// Compares a small picture with a text snapshot of the lesson, a character a pixel, so that a review can read it: `.` is
/// black, `#` is white, and a digit says how many ninths of the way it is.
///
/// # Panics
/// Where it differs, or there is no such snapshot.
pub fn assert_text(lesson: &Lesson, name: &str, image: &Image) {
    let symbol = |x, y| match image.get(x, y).map_or(0, common::Color::luma) {
        0 => '.',
        255 => '#',
        level => char::from(b'0' + (u32::from(level) * 9 / 255).max(1) as u8),
    };
    let rows =
        (0..image.height()).rev().map(|y| (0..image.width()).map(|x| symbol(x, y)).collect::<String>());
    let text = rows.collect::<Vec<_>>().join("\n");
    settings(lesson).bind(|| assert_snapshot!(name, text));
}

/// The names in a folder, sorted.
///
/// # Panics
/// Where it cannot be read.
#[must_use]
pub fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut names: Vec<String> = entries
        .map(|entry| entry.expect("it can be read").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// The letter F in triangles, about the origin.
#[must_use]
pub fn letter() -> Vec<[Vec3; 3]> {
    let bar = |[x0, y0, x1, y1]: [f32; 4]| {
        let [a, b, c, d] = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| Vec3::new(x, y, 0.0));
        [[a, b, c], [a, c, d]]
    };
    [[-4.2, -7.1, -1.9, 7.1], [-1.9, 4.8, 4.9, 7.1], [-1.9, -0.6, 3.1, 1.7]]
        .into_iter()
        .flat_map(bar)
        .collect()
}

/// The rectangle of pixels from (0, 0) on.
#[must_use]
pub fn window(width: i32, height: i32) -> Bounds {
    Bounds { min: IVec2::ZERO, max: IVec2::new(width - 1, height - 1) }
}

/// The row of a table of methods that has that name.
///
/// # Panics
/// Where there is none.
#[must_use]
pub fn method<'a, F>(table: &'a [Method<F>], name: &str) -> &'a F {
    &Method::find(table, name).unwrap_or_else(|| panic!("there is no method `{name}`")).run
}
