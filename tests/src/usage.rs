//! The command line of a lesson's program: what holds for every lesson, and for those that draw in depth or with a
//! texture.

use std::path::Path;
use std::process::Output;

use common::{Color, Format, Image, Lesson, Method};
use tempfile::tempdir;

use super::{CRATE, SPHERE, names, program, run};

/// Checks that a program failed as it should, and said why in one line.
///
/// # Panics
/// Where it did not.
#[track_caller]
pub fn assert_fails(output: &Output, code: i32, said: &[&str]) {
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{error}");
    assert_eq!(error.lines().count(), 1, "{error}");
    assert!(said.iter().all(|words| error.contains(words)), "{error}");
}

/// Checks that command lines are refused with exit code 2, each in a line with the words beside it, and that nothing
/// is written.
///
/// # Panics
/// Where one is not.
#[track_caller]
pub fn refuses(lesson: &Lesson, rows: &[(&[&str], &str)]) {
    let folder = tempdir().expect("a temporary folder can be made");
    for (arguments, said) in rows {
        assert_fails(&run(lesson.name, folder.path(), arguments), 2, &[said]);
    }
    assert_eq!(names(folder.path()), [""; 0]);
}

/// What holds for the program of every lesson: what it refuses, `--list`, `--help` and `--compare`.
///
/// # Panics
/// Where it does not hold.
#[track_caller]
pub fn check(lesson: &Lesson) {
    refuses(
        lesson,
        &[
            (&["--size", "0x0"], "--size <WxH>"),
            (&["--size", "99999x1"], "1 to 16384"),
            (&["--size", "16384x16384"], "67108864 pixels in all"),
            (&["--method", "no-such"], "possible values"),
            (&["--compare", "no-such"], "--compare <A,B>"),
            (&["--depth"], "--depth"),
            (&["extra"], "extra"),
            (&["--out"], "--out <FILE>"),
        ],
    );

    // The table and the help are printed, and nothing is drawn.
    let folder = tempdir().expect("a temporary folder can be made");
    let methods = (lesson.tables[0].rows)();
    let output = run(lesson.name, folder.path(), &["--list"]);
    let printed = String::from_utf8_lossy(&output.stdout);
    assert_eq!((output.status.code(), printed), (Some(0), Method::list(&methods).into()));
    let help = run(lesson.name, folder.path(), &["--help"]);
    assert!(help.status.success() && String::from_utf8_lossy(&help.stdout).contains("--compare <A,B>"));
    assert_eq!(names(folder.path()), [""; 0]);

    // Two methods and their difference in one picture, and the counts.
    let [a, b] = ends(lesson);
    let pair = [a, b].join(",");
    let output = run(lesson.name, folder.path(), &["--compare", &pair, "--size", "60x60", "--out", "a.png"]);
    let said = String::from_utf8_lossy(&output.stdout);
    let begins = format!("a.png (1812x600)\n{b} against {a}: ");
    assert!(said.starts_with(&begins) && said.contains(" pixels missing (orange), "), "{said}");
    assert_eq!(read(folder.path(), "a.png").width(), 1812);
}

/// What holds for a program with `--depth`: it writes the depths as a picture, a sphere's brightest where it is nearest and
/// so not at its outline, and a picture of one pixel, too small
/// for a sheet's cells, has none of them.
///
/// # Panics
/// Where it does not hold.
#[track_caller]
pub fn check_depth(lesson: &Lesson) {
    let folder = tempdir().expect("a temporary folder can be made");
    for (size, picture, depth) in [("61x40", "a.png", "b.tga"), ("1x1", "c.png", "d.png")] {
        let arguments = ["--size", size, "--out", picture, "--depth", depth, "--model", SPHERE];
        let output = run(lesson.name, folder.path(), &arguments);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
    let depth = read(folder.path(), "b.tga");
    assert_eq!((depth.width(), depth.height()), (61, 40));
    let white: Vec<_> = depth.pixels().filter(|pixel| pixel.2 == Color::WHITE).collect();
    assert!(!white.is_empty());
    for (x, y, _) in white {
        let beside = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)];
        assert!(beside.iter().all(|&(x, y)| depth.get(x, y) != Some(Color::BLACK)), "({x}, {y})");
    }
    assert_eq!(names(folder.path()), ["a.png", "b.tga", "c.png", "d.png"]);
}

/// What holds for a program with `--texture`: the model needs texture coordinates, and the texture must be there.
///
/// # Panics
/// Where it does not hold.
#[track_caller]
pub fn check_texture(lesson: &Lesson) {
    let folder = tempdir().expect("a temporary folder can be made");
    write_bare(folder.path());
    let bare = ["--model", "bare.obj", "--texture", CRATE, "--out", "a.png"];
    let said = ["bare.obj: not every face has texture coordinates; export the model with them"];
    assert_fails(&run(lesson.name, folder.path(), &bare), 1, &said);
    let missing = ["--model", SPHERE, "--texture", "none.png", "--out", "a.png"];
    assert_fails(&run(lesson.name, folder.path(), &missing), 1, &["cannot read none.png"]);
    assert_eq!(names(folder.path()), ["bare.obj"]);
}

/// What `--wrap` shows of a texture of 2×2 texels on a square that has it from −1 to 3, 80 px wide in the middle of a
/// picture of that side: eight texels across, of which the third and fourth are the texture's own.
///
/// # Panics
/// Where a pixel has another texel than it should.
#[track_caller]
pub fn check_wrap(lesson: &Lesson, side: i32, flags: &[&str]) {
    let folder = tempdir().expect("a temporary folder can be made");
    let text =
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt -1 -1\nvt 3 -1\nvt 3 3\nvt -1 3\nf 1/1 2/2 3/3 4/4\n";
    std::fs::write(folder.path().join("a.obj"), text).expect("the folder can be written");
    let mut texture = Image::new(2, 2, Format::Rgb);
    for (x, y, _) in texture.clone().pixels() {
        texture.set(x, y, Color::rgb(255 * x as u8, 255 * y as u8, 255));
    }
    texture.write(&folder.path().join("t.png")).expect("the folder can be written");

    let size = format!("{side}x{side}");
    let scene = ["--model", "a.obj", "--texture", "t.png", "--size", &size, "--out", "a.png"];
    for (wrap, repeats) in [(&[][..], false), (&["--wrap", "clamp"], false), (&["--wrap", "repeat"], true)] {
        let output = run(lesson.name, folder.path(), &[&scene, flags, wrap].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let picture = read(folder.path(), "a.png");
        let margin = (side - 80) / 2;
        for (x, y) in (0..80).flat_map(|y| (0..80).map(move |x| (x, y))) {
            let texel = |n: i32| if repeats { n.rem_euclid(2) } else { n.clamp(0, 1) };
            let [i, j] = [x, y].map(|n| texel(n / 10 - 2));
            let found = picture.get(margin + x, margin + y);
            assert_eq!(found, texture.get(i, j), "{wrap:?}, ({x}, {y})");
        }
    }
    assert_fails(&run(lesson.name, folder.path(), &["--wrap", "mirror"]), 2, &["--wrap <clamp|repeat>"]);
}

/// Checks that what reaches behind the eye is left out and told, and all else is drawn.
///
/// # Panics
/// Where it is not.
#[track_caller]
pub fn check_behind_the_eye(lesson: &Lesson, flags: &[&str]) {
    let folder = tempdir().expect("a temporary folder can be made");
    let text = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0 1 9\nvt 0 0\nf 1/1 2/1 3/1\nf 1/1 2/1 4/1\n";
    std::fs::write(folder.path().join("a.obj"), text).expect("the folder can be written");
    let scene = ["--model", "a.obj", "--texture", CRATE, "--out", "a.png"];
    let output = run(lesson.name, folder.path(), &[&scene[..], flags].concat());
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(told.ends_with("left out 1 triangle that reaches behind the eye\n"), "{told}");
    assert!(read(folder.path(), "a.png").pixels().any(|pixel| pixel.2 != Color::BLACK));
}

/// What holds for a program that looks at a point, from anywhere and all around: what it refuses, what is behind the
/// eye, and the turntable.
///
/// # Panics
/// Where it does not hold.
#[track_caller]
pub fn check_view(lesson: &Lesson) {
    refuses(
        lesson,
        &[
            (&["--eye", "1,2"], "--eye <x,y,z>"),
            (&["--up", "0,inf,0"], "write 3 finite numbers"),
            (
                &["--eye", "1,2,3", "--center", "1,2,3", "--texture", CRATE],
                "--eye and --center are one point: move one of them",
            ),
            (&["--turntable", "0"], "--turntable <N>"),
            (&["--turntable", "1000"], "1..=999"),
            (&["--turntable", "3", "--depth", "a.png"], "cannot be used with"),
            (&["--turntable", "3", "--compare", &ends(lesson).join(",")], "cannot be used with"),
        ],
    );
    check_behind_the_eye(lesson, &["--eye", "0,0,2"]);
    check_turntable(lesson);
    #[cfg(unix)]
    check_turntable_reads_once(lesson);
}

/// Checks that a turntable writes as many pictures as asked for, and depths beside them, and that it turns.
#[track_caller]
fn check_turntable(lesson: &Lesson) {
    let folder = tempdir().expect("a temporary folder can be made");
    let output = run(lesson.name, folder.path(), &["--turntable", "3", "--size", "30x30", "--model", SPHERE]);
    assert_eq!(String::from_utf8_lossy(&output.stdout), "3 pictures\n");
    let out = folder.path().join("out");
    let file = |n: usize, kind: &str| format!("{}-{n:03}.{kind}", lesson.folder());
    let expected: Vec<String> = (0..3).flat_map(|n| ["png", "tga"].map(|kind| file(n, kind))).collect();
    assert_eq!(names(&out), expected);
    assert!(read(&out, &file(0, "png")) != read(&out, &file(1, "png")));
}

/// Checks that a turntable reads its texture once: from a pipe, there is no second time.
#[cfg(unix)]
#[track_caller]
fn check_turntable_reads_once(lesson: &Lesson) {
    let folder = tempdir().expect("a temporary folder can be made");
    std::os::unix::fs::symlink("/dev/stdin", folder.path().join("pipe.png")).expect("a link can be made");
    let script = format!(
        "cat {CRATE} | \"$0\" --model {SPHERE} --texture pipe.png --turntable 3 --size 30x30 --out a.png"
    );
    let output = std::process::Command::new("sh")
        .args(["-c", &script])
        .arg(program(lesson.name, folder.path()).get_program())
        .current_dir(folder.path())
        .output()
        .expect("there is a shell");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    assert_eq!(names(folder.path()), ["a-000.png", "a-001.png", "a-002.png", "pipe.png"]);
}

/// Writes `bare.obj`: a triangle of positions alone.
///
/// # Panics
/// Where the folder cannot be written.
pub fn write_bare(folder: &Path) {
    let text = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
    std::fs::write(folder.join("bare.obj"), text).expect("the folder can be written");
}

/// The first and the last of a lesson's methods.
fn ends(lesson: &Lesson) -> [&'static str; 2] {
    let methods = (lesson.tables[0].rows)();
    [methods[0].name, methods[methods.len() - 1].name]
}

fn read(folder: &Path, name: &str) -> Image {
    Image::read(&folder.join(name)).expect("the program wrote a picture")
}
