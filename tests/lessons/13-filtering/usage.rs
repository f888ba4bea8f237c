use common::{Color, Format, Image};
use filtering::LESSON;
use tempfile::tempdir;
use verify::{CRATE, SPHERE, draw, names, run, usage};

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_depth(&LESSON);
    usage::check_texture(&LESSON);
}

#[test]
fn wrong_command_lines() {
    usage::refuses(
        &LESSON,
        &[
            (&["--wrap", "mirrored"], "--wrap mirrored: there are clamp, repeat, mirror"),
            (&["--mipmaps", "box"], "--mipmaps box: there are box-encoded, box-linear, lanczos-linear"),
            (&["--cull", "sides"], "--cull <back|front|none>"),
            (&["--fov", "180"], "less than 180"),
            (&["--near", "0"], "must lie before the eye, at more than 0"),
            (&["--far", "0.1"], "it must lie behind the near one"),
            (&["--eye", "1,2,3", "--center", "1,2,3"], "--eye and --center are one point: move one of them"),
            (&["--turntable", "0"], "--turntable <N>"),
            (&["--turntable", "3", "--depth", "a.png"], "cannot be used with"),
            (&["--turntable", "3", "--compare", "nearest,bilinear"], "cannot be used with"),
            (&["--projection", "w"], "'--projection': this lesson has no such flag"),
        ],
    );
}

/// A square with its texture from −1 to 3, eight texels across: outside there is what is asked for, and without asking the
/// texture again.
#[test]
fn outside_a_texture_is_what_is_asked_for() {
    let folder = tempdir().unwrap();
    let text =
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt -1 -1\nvt 3 -1\nvt 3 3\nvt -1 3\nf 1/1 2/2 3/3 4/4\n";
    std::fs::write(folder.path().join("a.obj"), text).unwrap();
    let mut texture = Image::new(2, 2, Format::Rgb);
    for (x, y, _) in texture.clone().pixels() {
        texture.set(x, y, Color::rgb(255 * x as u8, 255 * y as u8, 255));
    }
    texture.write(&folder.path().join("t.png")).unwrap();
    let scene = ["--model", "a.obj", "--texture", "t.png", "--size", "160x160", "--out", "a.png"];
    let eye = ["--eye", "0,0,2", "--center", "0,0,0", "--fov", "90", "--light", "0,0,1"];
    let repeated = [0, 1, 0, 1, 0, 1, 0, 1];
    for (wrap, texels) in [
        (&[][..], repeated),
        (&["--wrap", "repeat"], repeated),
        (&["--wrap", "clamp"], [0, 0, 0, 1, 1, 1, 1, 1]),
        (&["--wrap", "mirror"], [1, 0, 0, 1, 1, 0, 0, 1]),
    ] {
        let output =
            run(LESSON.name, folder.path(), &[&scene, &eye[..], &["--method", "nearest"], wrap].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let picture = Image::read(&folder.path().join("a.png")).unwrap();
        for (x, y) in (0..80).flat_map(|y| (0..80).map(move |x| (x, y))) {
            let [i, j] = [x, y].map(|n| texels[n as usize / 10]);
            assert_eq!(picture.get(40 + x, 40 + y), texture.get(i, j), "{wrap:?}, ({x}, {y})");
        }
    }
}

/// The turntable writes as many pictures as asked for, and turns.
#[test]
fn a_turn_around_the_head() {
    let folder = tempdir().unwrap();
    let arguments =
        ["--turntable", "3", "--size", "30x30", "--model", SPHERE, "--texture", CRATE, "--out", "a.png"];
    let output = run(LESSON.name, folder.path(), &arguments);
    assert_eq!(String::from_utf8_lossy(&output.stdout), "3 pictures\n");
    assert_eq!(names(folder.path()), ["a-000.png", "a-001.png", "a-002.png"]);
    let read = |n: usize| Image::read(&folder.path().join(format!("a-00{n}.png"))).unwrap();
    assert!(read(0) != read(1) && read(1) != read(2));
}

/// A model of one's own stands alone; else there is a floor.
#[test]
fn a_model_that_is_asked_for_stands_alone() {
    let lowest =
        |picture: &Image| picture.pixels().filter(|&(_, y, color)| y < 8 && color != Color::BLACK).count();
    let size = ["--size", "100x100"];
    assert_eq!(lowest(&draw("filtering", &size)), 800);
    assert_eq!(
        lowest(&draw("filtering", &[&size[..], &["--model", SPHERE, "--texture", CRATE]].concat())),
        0
    );
}

/// A side is left out if asked for: seen from outside, the backs of a sphere are the farther half.
#[test]
fn a_side_is_left_out_if_asked_for() {
    let sphere = ["--size", "60x60", "--model", SPHERE, "--texture", CRATE];
    let drawn = |cull: &str| draw("filtering", &[&sphere[..], &["--cull", cull]].concat());
    let [back, front, none] = ["back", "front", "none"].map(drawn);
    assert!(back == none && front != none);
}

/// The way in which levels are made tells where checks are too small to be seen: half the light, or half the code.
#[test]
fn levels_are_made_as_asked_for() {
    let folder = tempdir().unwrap();
    std::fs::write(
        folder.path().join("a.obj"),
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 256 0\nvt 256 256\nvt 0 256\nf 1/1 2/2 3/3 4/4\n",
    )
    .unwrap();
    let mut texture = Image::new(2, 2, Format::Rgb);
    texture.set(0, 0, Color::WHITE);
    texture.set(1, 1, Color::WHITE);
    texture.write(&folder.path().join("t.png")).unwrap();
    for (flags, grey) in [
        (&[][..], 188),
        (&["--mipmaps", "box-linear"], 188),
        (&["--mipmaps", "lanczos-linear"], 188),
        (&["--mipmaps", "box-encoded"], 128),
    ] {
        let scene = ["--model", "a.obj", "--texture", "t.png", "--size", "40x40", "--out", "a.png"];
        let eye = ["--eye", "0,0,1", "--center", "0,0,0", "--fov", "45", "--light", "0,0,1"];
        let output = run(LESSON.name, folder.path(), &[&scene, &eye[..], flags].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let picture = Image::read(&folder.path().join("a.png")).unwrap();
        assert!(picture.pixels().all(|pixel| pixel.2 == Color::rgb(grey, grey, grey)), "{flags:?}");
    }
}
