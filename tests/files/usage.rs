use tempfile::tempdir;
use verify::run;

use crate::{assert_fails, names};

const LESSONS: [&str; 3] = ["lines", "wireframe", "triangles"];

#[test]
fn a_wrong_command_line_is_one_line_and_exit_code_2() {
    let folder = tempdir().unwrap();
    for lesson in LESSONS {
        for (arguments, said) in [
            (&["--size", "0x0"][..], "--size <WxH>"),
            (&["--size", "99999x1"], "1 to 16384"),
            (&["--size", "16384x16384"], "67108864 pixels in all"),
            (&["--method", "none"], "possible values"),
            (&["--compare", "none"], "--compare <A,B>"),
            (&["--depth", "a.png"], "--depth"),
            (&["extra"], "extra"),
            (&["--out"], "--out <FILE>"),
        ] {
            assert_fails(&run(lesson, folder.path(), arguments), 2, &[said]);
        }
    }
    assert_fails(&run("lines", folder.path(), &["--model"]), 2, &["unexpected argument '--model'"]);
    assert_fails(
        &run("wireframe", folder.path(), &["--line", "1,2,3,4"]),
        2,
        &["unexpected argument '--line'"],
    );
    assert_fails(
        &run("triangles", folder.path(), &["--light", "0,0,0"]),
        2,
        &["--light <x,y,z>", "not all 0"],
    );
    assert_eq!(names(folder.path()), [""; 0]);
}

#[test]
fn the_table_and_the_help_are_printed_and_nothing_is_drawn() {
    let folder = tempdir().unwrap();
    for (lesson, rows) in LESSONS.iter().zip([
        common::Method::list(lines::METHODS),
        common::Method::list(wireframe::METHODS),
        common::Method::list(triangles::METHODS),
    ]) {
        let output = run(lesson, folder.path(), &["--list"]);
        assert_eq!((output.status.code(), String::from_utf8_lossy(&output.stdout)), (Some(0), rows.into()));
        let help = run(lesson, folder.path(), &["--help"]);
        assert!(help.status.success() && String::from_utf8_lossy(&help.stdout).contains("--compare <A,B>"));
    }
    assert_eq!(names(folder.path()), [""; 0]);
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
    let image = common::Image::read(&folder.path().join("a.png")).unwrap();
    assert_eq!(image.get(50, 50), Some(common::Color::WHITE));
    assert_eq!(image.get(99, 9), Some(common::Color::RED));
}
