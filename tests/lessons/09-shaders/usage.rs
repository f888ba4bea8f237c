use common::{Color, Image};
use shaders::LESSON;
use tempfile::tempdir;
use verify::{CRATE, SPHERE, run, usage};

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

/// The four looks are of one model: their depths are the same, each in its own cell.
#[test]
fn each_cell_has_its_depths() {
    let folder = tempdir().unwrap();
    let scene =
        ["--model", SPHERE, "--texture", CRATE, "--size", "60x40", "--out", "a.png", "--depth", "b.png"];
    assert!(run("shaders", folder.path(), &scene).status.success());
    let depth = Image::read(&folder.path().join("b.png")).unwrap();
    let cell = |left, bottom| {
        let pixels = (0..20).flat_map(move |y| (0..30).map(move |x| (left + x, bottom + y)));
        pixels.map(|(x, y)| depth.get(x, y).unwrap()).collect::<Vec<_>>()
    };
    let first = cell(0, 0);
    assert!(first.contains(&Color::WHITE) && first.contains(&Color::BLACK));
    for (left, bottom) in [(30, 0), (0, 20), (30, 20)] {
        assert!(cell(left, bottom) == first, "({left}, {bottom})");
    }
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
