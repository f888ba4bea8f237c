use clipping::LESSON;
use common::{Color, Image};
use tempfile::tempdir;
use verify::{CRATE, SPHERE, draw, run, usage};

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_depth(&LESSON);
    usage::check_texture(&LESSON);
}

/// From 2 away, 90 degrees are 4 high: a square from −1 to 1 is half of the picture.
#[test]
fn outside_a_texture_is_its_border_or_the_texture_again() {
    let flags = ["--eye", "0,0,2", "--center", "0,0,0", "--fov", "90", "--light", "0,0,1"];
    usage::check_wrap(&LESSON, 160, &flags);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(
        &LESSON,
        &[
            (&["--cull", "sides"], "--cull <back|front|none>"),
            (&["--fov", "180"], "less than 180"),
            (&["--near", "0"], "must lie before the eye, at more than 0"),
            (&["--far", "0.1"], "it must lie behind the near one"),
            (&["--eye", "1,2,3", "--center", "1,2,3"], "--eye and --center are one point: move one of them"),
            (&["--projection", "w"], "'--projection': this lesson has no such flag"),
        ],
    );
}

/// What lesson 10 leaves out and counts is drawn, and nothing is said of it.
#[test]
fn what_reaches_behind_the_eye_is_cut() {
    let folder = tempdir().unwrap();
    let text = "v -1 -1 0\nv 1 -1 0\nv 0 1 9\nvt 0 0\nf 2/1 1/1 3/1\n";
    std::fs::write(folder.path().join("a.obj"), text).unwrap();
    let scene = [
        "--model",
        "a.obj",
        "--texture",
        CRATE,
        "--out",
        "a.png",
        "--eye",
        "0,0.5,2",
        "--center",
        "0,-0.5,0",
    ];
    let mut drawn = Vec::new();
    for (method, told) in
        [("leave-out", "left out 1 triangle that reaches behind the eye\n"), ("guard-band", "")]
    {
        let flags = ["--light", "0,1,0", "--method", method];
        let output = run("clipping", folder.path(), &[&scene[..], &flags].concat());
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success() && said.contains("left out") != told.is_empty(), "{said}");
        assert!(said.ends_with(told), "{said}");
        let picture = Image::read(&folder.path().join("a.png")).unwrap();
        drawn.push(picture.pixels().filter(|pixel| pixel.2 != Color::BLACK).count());
    }
    assert!(drawn[0] == 0 && drawn[1] > 1000, "{drawn:?}");
}

/// A triangle, seen from either side.
#[test]
fn a_side_is_left_out_if_asked_for() {
    let folder = tempdir().unwrap();
    let text = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nvn 0 1 0\nf 1/1/1 2/1/1 3/1/1\n";
    std::fs::write(folder.path().join("a.obj"), text).unwrap();
    for (eye, seen) in [("0,0,3", ["none", "back"]), ("0,0,-3", ["none", "front"])] {
        for cull in ["none", "back", "front"] {
            let scene = ["--model", "a.obj", "--texture", CRATE, "--out", "a.png", "--center", "0,0,0"];
            let flags = ["--light", "0,1,0", "--eye", eye, "--cull", cull, "--size", "60x60"];
            let output = run("clipping", folder.path(), &[&scene[..], &flags].concat());
            assert!(output.status.success());
            let picture = Image::read(&folder.path().join("a.png")).unwrap();
            let drawn = picture.pixels().any(|pixel| pixel.2 != Color::BLACK);
            assert_eq!(drawn, seen.contains(&cull), "{eye}, {cull}");
        }
    }
}

/// A model of one's own stands alone; else there is a floor.
#[test]
fn a_model_that_is_asked_for_stands_alone() {
    let lowest =
        |picture: &Image| picture.pixels().filter(|&(_, y, color)| y < 8 && color != Color::BLACK).count();
    let size = ["--size", "100x100"];
    assert_eq!(lowest(&draw("clipping", &size)), 800);
    assert_eq!(lowest(&draw("clipping", &[&size[..], &["--model", SPHERE, "--texture", CRATE]].concat())), 0);
}
