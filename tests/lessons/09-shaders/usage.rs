use shaders::LESSON;
use tempfile::tempdir;
use verify::{CRATE, run, usage};

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_depth(&LESSON);
    usage::check_texture(&LESSON);
}

#[test]
fn what_reaches_behind_the_eye_is_left_out() {
    usage::check_behind_the_eye(&LESSON, &["--eye", "0,0,2"]);
}

#[test]
fn a_turntable_writes_as_many_pictures_as_asked_for() {
    usage::check_turntable(&LESSON);
}

#[cfg(unix)]
#[test]
fn a_turntable_reads_its_texture_once() {
    usage::check_turntable_reads_once(&LESSON);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(
        &LESSON,
        &[
            (&["--eye", "0,0,0", "--texture", CRATE], "--eye and --center are one point: move one of them"),
            (&["--light", "0,0,0"], "a direction needs three finite numbers, not all 0"),
            (&["--levels", "0"], "--levels <N>"),
            (&["--levels", "2.5"], "--levels <N>"),
            (
                &["--shader", "phong"],
                "--shader phong: there are flat, flat-texture, gouraud, gouraud-texture, quantized",
            ),
        ],
    );
}

/// A look without a texture needs neither the file nor the model's texture coordinates.
#[test]
fn what_a_look_does_not_use_need_not_be_there() {
    let folder = tempdir().unwrap();
    usage::write_bare(folder.path());
    let bare = ["--model", "bare.obj", "--out", "a.png", "--texture", "none.png", "--shader"];
    for (shader, told) in [
        ("flat", ""),
        ("gouraud", "bare.obj: not every face has normals; they are computed\n"),
        ("quantized", "bare.obj: not every face has normals; they are computed\n"),
    ] {
        let output = run("shaders", folder.path(), &[&bare[..], &[shader]].concat());
        assert!(output.status.success());
        assert_eq!(String::from_utf8_lossy(&output.stderr), told, "{shader}");
    }
}
