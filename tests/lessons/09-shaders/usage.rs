use shaders::LESSON;
use tempfile::tempdir;
use verify::{run, usage};

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_depth(&LESSON);
    usage::check_texture(&LESSON);
}

#[test]
fn what_holds_for_a_view() {
    usage::check_view(&LESSON);
}

#[test]
fn outside_a_texture_is_its_border_or_the_texture_again() {
    for shader in ["flat-texture", "gouraud-texture"] {
        usage::check_wrap(&LESSON, 100, &["--eye", "0,0,2", "--shader", shader]);
    }
}

#[test]
fn wrong_command_lines() {
    usage::refuses(
        &LESSON,
        &[
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
