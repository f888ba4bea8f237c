use common::{Color, Image};
use lines::LESSON;
use tempfile::tempdir;
use verify::{run, usage};

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(&LESSON, &[(&["--model"], "unexpected argument '--model'")]);
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
