//! What the tests of all lessons share: running a lesson's program, and snapshots of pictures.
//!
//! ```text
//! lessons/     a folder a lesson: snapshots of what each method draws, stability tests, properties
//! missions/    starters, solutions, and the faults that checks recognise
//! files/       bad files and bad flags, and the assets made again
//! benches/     what drawing costs
//! ```

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use checks::picture::{Fault, faults};
use common::file::Encoding;
use common::{Bounds, IVec2, Image, Lesson};
use escargot::CargoBuild;
use insta::internals::SnapshotContents;
use insta::{Comparator, Settings, Snapshot, assert_binary_snapshot, assert_snapshot};

/// The lessons, in order.
pub const LESSONS: [Lesson; 9] = [
    lines::LESSON,
    wireframe::LESSON,
    triangles::LESSON,
    zbuffer::LESSON,
    textures::LESSON,
    gouraud::LESSON,
    transforms::LESSON,
    camera::LESSON,
    shaders::LESSON,
];

/// The sphere of 5,000 triangles.
pub const SPHERE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/sphere.obj");

/// The wooden texture.
pub const CRATE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/crate.png");

/// The lessons' programs and the first of all, built once a process, in the profile of these tests: what they
/// need is built already, and overflow is noticed.
static PROGRAMS: LazyLock<BTreeMap<&str, PathBuf>> = LazyLock::new(|| {
    let build = |name, build: CargoBuild| {
        // Together with this package, so that they share its features and all that was built with them.
        let built = build.arg("--package=verify").manifest_path("../Cargo.toml").run();
        (name, built.unwrap_or_else(|error| panic!("{name}: {error}")).path().to_path_buf())
    };
    let lesson = |name| build(name, CargoBuild::new().package(name).bin(name));
    let mut programs = BTreeMap::from(LESSONS.map(|one| lesson(one.name)));
    programs.extend([build("pixel", CargoBuild::new().package("common").example("pixel"))]);
    programs
});

/// A lesson's program, about to run in a folder.
#[must_use]
pub fn program(lesson: &str, folder: &Path) -> Command {
    let mut command = Command::new(&PROGRAMS[lesson]);
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
pub fn method<'a, F>(table: &'a [common::Method<F>], name: &str) -> &'a F {
    &common::Method::find(table, name).unwrap_or_else(|| panic!("there is no method `{name}`")).run
}
