use tempfile::tempdir;
use verify::usage::{self, assert_fails};
use verify::{CRATE, SPHERE, names, run};
use zbuffer::LESSON;

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_depth(&LESSON);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(
        &LESSON,
        &[
            (&["--light", "0,0,0"], "--light <x,y,z>"),
            (&["--texture", CRATE], "unexpected argument '--texture'"),
            (&["--method", "painter", "--depth", "a.png"], "painter keeps no depths; use --method z-f32"),
            (&["--compare", "z16,z24", "--depth", "a.png"], "cannot be used with"),
        ],
    );
}

#[test]
fn a_depth_picture_needs_a_good_name() {
    let folder = tempdir().unwrap();
    let output = run("zbuffer", folder.path(), &["--model", SPHERE, "--out", "a.png", "--depth", "b.bmp"]);
    assert_fails(&output, 1, &["b.bmp: the name of a picture must end in .tga or .png"]);
    assert_eq!(names(folder.path()), [""; 0]);
}
