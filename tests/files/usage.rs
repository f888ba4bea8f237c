use std::fs;

use common::{Color, Image, Method};
use tempfile::tempdir;
use verify::{CRATE, LESSONS, SPHERE, run};

use crate::{assert_fails, names};

/// The names and the printed table of each lesson's methods.
fn tables() -> Vec<(&'static str, Vec<&'static str>, String)> {
    fn table<F>(lesson: &'static str, methods: &[Method<F>]) -> (&'static str, Vec<&'static str>, String) {
        (lesson, methods.iter().map(|method| method.name).collect(), Method::list(methods))
    }
    vec![
        table("lines", lines::METHODS),
        table("wireframe", wireframe::METHODS),
        table("triangles", triangles::METHODS),
        table("zbuffer", zbuffer::METHODS),
        table("textures", textures::METHODS),
        table("gouraud", gouraud::METHODS),
        table("transforms", transforms::METHODS),
        table("camera", camera::METHODS),
        table("shaders", shaders::METHODS),
    ]
}

/// What names the model and the texture, for the lessons that have these flags.
fn scene(lesson: &str) -> Vec<&'static str> {
    match lesson {
        "lines" => vec![],
        "wireframe" | "triangles" | "zbuffer" => vec!["--model", SPHERE],
        _ => vec!["--model", SPHERE, "--texture", CRATE],
    }
}

#[test]
fn a_wrong_command_line_is_one_line_and_exit_code_2() {
    let folder = tempdir().unwrap();
    for lesson in LESSONS.map(|lesson| lesson.name) {
        for (arguments, said) in [
            (&["--size", "0x0"][..], "--size <WxH>"),
            (&["--size", "99999x1"], "1 to 16384"),
            (&["--size", "16384x16384"], "67108864 pixels in all"),
            (&["--method", "no-such"], "possible values"),
            (&["--compare", "no-such"], "--compare <A,B>"),
            (&["--depth"], "--depth"),
            (&["extra"], "extra"),
            (&["--out"], "--out <FILE>"),
        ] {
            assert_fails(&run(lesson, folder.path(), arguments), 2, &[said]);
        }
    }
    for (lesson, arguments, said) in [
        ("lines", &["--model"][..], "unexpected argument '--model'"),
        ("wireframe", &["--line", "1,2,3,4"], "unexpected argument '--line'"),
        ("triangles", &["--depth", "a.png"], "unexpected argument '--depth'"),
        ("triangles", &["--light", "0,0,0"], "not all 0"),
        ("zbuffer", &["--light", "0,0,0"], "--light <x,y,z>"),
        ("zbuffer", &["--texture", CRATE], "unexpected argument '--texture'"),
        (
            "zbuffer",
            &["--method", "painter", "--depth", "a.png"],
            "painter keeps no depths; use --method z-f32",
        ),
        ("zbuffer", &["--compare", "z16,z24", "--depth", "a.png"], "cannot be used with"),
        ("textures", &["--distance", "2"], "unexpected argument '--distance'"),
        ("textures", &["--light", "0,nan,1"], "--light <x,y,z>"),
        ("gouraud", &["--eye", "1,1,1"], "unexpected argument '--eye'"),
        ("transforms", &["--distance", "0"], "write a number above 0, or inf"),
        ("transforms", &["--distance", "-2"], "write a number above 0, or inf"),
        ("transforms", &["--distance", "nan"], "write a number above 0, or inf"),
        ("transforms", &["--turntable", "3"], "unexpected argument '--turntable'"),
        ("camera", &["--eye", "1,2"], "--eye <x,y,z>"),
        ("camera", &["--up", "0,inf,0"], "write 3 finite numbers"),
        (
            "camera",
            &["--eye", "1,2,3", "--center", "1,2,3", "--texture", CRATE],
            "--eye and --center are one point: move one of them",
        ),
        ("camera", &["--turntable", "0"], "--turntable <N>"),
        ("camera", &["--turntable", "1000"], "1..=999"),
        ("camera", &["--turntable", "3", "--depth", "a.png"], "cannot be used with"),
        ("camera", &["--turntable", "3", "--compare", "lookat,listing"], "cannot be used with"),
        (
            "shaders",
            &["--eye", "0,0,0", "--texture", CRATE],
            "--eye and --center are one point: move one of them",
        ),
        ("shaders", &["--light", "0,0,0"], "a direction needs three finite numbers, not all 0"),
        ("shaders", &["--levels", "0"], "--levels <N>"),
        ("shaders", &["--levels", "2.5"], "--levels <N>"),
        (
            "shaders",
            &["--shader", "phong"],
            "--shader phong: there are flat, flat-texture, gouraud, gouraud-texture, quantized",
        ),
    ] {
        assert_fails(&run(lesson, folder.path(), arguments), 2, &[said]);
    }
    assert_eq!(names(folder.path()), [""; 0]);
}

#[test]
fn the_table_and_the_help_are_printed_and_nothing_is_drawn() {
    let folder = tempdir().unwrap();
    for (lesson, _, rows) in tables() {
        let output = run(lesson, folder.path(), &["--list"]);
        assert_eq!((output.status.code(), String::from_utf8_lossy(&output.stdout)), (Some(0), rows.into()));
        let help = run(lesson, folder.path(), &["--help"]);
        assert!(help.status.success() && String::from_utf8_lossy(&help.stdout).contains("--compare <A,B>"));
    }
    assert_eq!(names(folder.path()), [""; 0]);
}

/// In every lesson: two methods and their difference in one picture, and the counts.
#[test]
fn every_lesson_compares() {
    for (lesson, methods, _) in tables() {
        let folder = tempdir().unwrap();
        let [a, b] = [methods[0], methods[methods.len() - 1]];
        let pair = format!("{a},{b}");
        let arguments = ["--compare", &pair, "--size", "60x60", "--out", "a.png"];
        let output = run(lesson, folder.path(), &[&arguments[..], &scene(lesson)].concat());
        let said = String::from_utf8_lossy(&output.stdout);
        let begins = format!("a.png (1812x600)\n{b} against {a}: ");
        assert!(said.starts_with(&begins) && said.contains(" pixels missing (orange), "), "{lesson}: {said}");
        assert_eq!(Image::read(&folder.path().join("a.png")).unwrap().width(), 1812);
    }
}

#[test]
fn a_depth_picture_comes_with_the_picture() {
    for lesson in LESSONS.map(|lesson| lesson.name).into_iter().skip(3) {
        let folder = tempdir().unwrap();
        let arguments = ["--size", "61x40", "--out", "a.png", "--depth", "b.tga"];
        let output = run(lesson, folder.path(), &[&arguments[..], &scene(lesson)].concat());
        assert!(output.status.success(), "{lesson}: {}", String::from_utf8_lossy(&output.stderr));
        let depth = Image::read(&folder.path().join("b.tga")).unwrap();
        assert_eq!((depth.width(), depth.height()), (61, 40), "{lesson}");
        assert!(depth.pixels().any(|pixel| pixel.2 == Color::WHITE), "{lesson}");
    }
}

/// A picture too small for the sheet's cells has none of them; nothing panics.
#[test]
fn one_pixel_is_a_picture() {
    for lesson in LESSONS.map(|lesson| lesson.name).into_iter().skip(3) {
        let folder = tempdir().unwrap();
        let arguments = ["--size", "1x1", "--out", "a.png", "--depth", "b.png"];
        let output = run(lesson, folder.path(), &[&arguments[..], &scene(lesson)].concat());
        assert!(output.status.success(), "{lesson}: {}", String::from_utf8_lossy(&output.stderr));
        assert_eq!(names(folder.path()), ["a.png", "b.png"], "{lesson}");
    }
}

#[test]
fn a_depth_picture_needs_a_good_name() {
    let folder = tempdir().unwrap();
    let output = run("zbuffer", folder.path(), &["--model", SPHERE, "--out", "a.png", "--depth", "b.bmp"]);
    assert_fails(&output, 1, &["b.bmp: the name of a picture must end in .tga or .png"]);
    assert_eq!(names(folder.path()), [""; 0]);
}

/// From lesson 5 on a model needs texture coordinates and the texture must be there, but only where it is used.
#[test]
fn what_a_look_does_not_use_need_not_be_there() {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("bare.obj"), "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let bare = ["--model", "bare.obj", "--out", "a.png", "--texture"];
    for lesson in ["textures", "gouraud", "transforms", "camera", "shaders"] {
        let output = run(lesson, folder.path(), &[&bare[..], &[CRATE]].concat());
        let said = ["bare.obj: not every face has texture coordinates; export the model with them"];
        assert_fails(&output, 1, &said);
        let missing = ["--model", SPHERE, "--texture", "none.png", "--out", "a.png"];
        assert_fails(&run(lesson, folder.path(), &missing), 1, &["cannot read none.png"]);
    }
    assert_eq!(names(folder.path()), ["bare.obj"]);
    for (shader, told) in [
        ("flat", ""),
        ("gouraud", "bare.obj: not every face has normals; they are computed\n"),
        ("quantized", "bare.obj: not every face has normals; they are computed\n"),
    ] {
        let output = run("shaders", folder.path(), &[&bare[..], &["none.png", "--shader", shader]].concat());
        assert!(output.status.success());
        assert_eq!(String::from_utf8_lossy(&output.stderr), told, "{shader}");
    }
}

/// What reaches behind the eye is left out and told; all else is drawn.
#[test]
fn what_is_behind_the_eye_is_left_out_and_told() {
    let folder = tempdir().unwrap();
    let text = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0 1 9\nvt 0 0\nf 1/1 2/1 3/1\nf 1/1 2/1 4/1\n";
    fs::write(folder.path().join("a.obj"), text).unwrap();
    let scene = ["--model", "a.obj", "--texture", CRATE, "--out", "a.png"];
    let from_z = ["--eye", "0,0,2"];
    for (lesson, flags) in [("transforms", &[][..]), ("camera", &from_z), ("shaders", &from_z)] {
        let output = run(lesson, folder.path(), &[&scene[..], flags].concat());
        let told = String::from_utf8_lossy(&output.stderr);
        assert!(told.ends_with("left out 1 triangle that reaches behind the eye\n"), "{lesson}: {told}");
        let picture = Image::read(&folder.path().join("a.png")).unwrap();
        assert!(picture.pixels().any(|pixel| pixel.2 != Color::BLACK), "{lesson}");
    }
}

#[test]
fn a_turntable_writes_as_many_pictures_as_asked_for() {
    let folder = tempdir().unwrap();
    for lesson in ["camera", "shaders"] {
        let stops = ["--turntable", "3", "--size", "30x30"];
        let output = run(lesson, folder.path(), &[&stops[..], &scene(lesson)].concat());
        assert_eq!(String::from_utf8_lossy(&output.stdout), "3 pictures\n");
    }
    let stem = |n: usize| ["08-camera", "09-shaders"][n / 6].to_string() + &format!("-{:03}", n / 2 % 3);
    let expected: Vec<String> = (0..12).map(|n| stem(n) + [".png", ".tga"][n % 2]).collect();
    assert_eq!(names(&folder.path().join("out")), expected);
    let read = |name: &str| Image::read(&folder.path().join("out").join(name)).unwrap();
    assert!(read("08-camera-000.png") != read("08-camera-001.png"));
}

/// The turntable draws what was read once: from a pipe, there is no second time.
#[cfg(unix)]
#[test]
fn a_turntable_reads_its_texture_once() {
    for lesson in ["camera", "shaders"] {
        let folder = tempdir().unwrap();
        std::os::unix::fs::symlink("/dev/stdin", folder.path().join("pipe.png")).unwrap();
        let script = format!(
            "cat {CRATE} | \"$0\" --model {SPHERE} --texture pipe.png --turntable 3 --size 30x30 --out a.png"
        );
        let output = std::process::Command::new("sh")
            .args(["-c", &script])
            .arg(verify::program(lesson, folder.path()).get_program())
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{lesson}");
        assert_eq!(names(folder.path()), ["a-000.png", "a-001.png", "a-002.png", "pipe.png"], "{lesson}");
    }
}

#[test]
fn a_comparison_counts() {
    let folder = tempdir().unwrap();
    let output = run(
        "lines",
        folder.path(),
        &["--compare", "bresenham,listing", "--out", "a.png", "--line", "0,0,9,9"],
    );
    let expected = "a.png (1812x600)\nlisting against bresenham: \
                    10 pixels missing (orange), 10 extra (blue), 0 of another colour (yellow)\n";
    assert_eq!(String::from_utf8_lossy(&output.stdout), expected);
}

#[test]
fn lines_far_outside_are_drawn_where_they_are_seen() {
    let folder = tempdir().unwrap();
    let far =
        ["--line", "-2147483648,-2147483648,2147483647,2147483647", "--line", "5,9,2000000000,-7,ff0000"];
    assert!(run("lines", folder.path(), &[&far[..], &["--out", "a.png"]].concat()).status.success());
    let image = Image::read(&folder.path().join("a.png")).unwrap();
    assert_eq!(image.get(50, 50), Some(Color::WHITE));
    assert_eq!(image.get(99, 9), Some(Color::RED));
}
