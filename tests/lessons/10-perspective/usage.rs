use common::{Color, Image};
use perspective::LESSON;
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
fn what_reaches_behind_the_eye_is_left_out_and_told() {
    usage::check_behind_the_eye(&LESSON, &["--eye", "0,0,2", "--center", "0,0,0", "--light", "0,0,1"]);
}

#[test]
fn wrong_command_lines() {
    let [fov, near, far] = [
        "the field of view is 0 degrees: it must be more than 0 and less than 180",
        "it must lie before the eye, at more than 0",
        "it must lie behind the near one",
    ];
    let depths = "there are z24, z-f32, reversed-z-f32, logarithmic, w";
    usage::refuses(
        &LESSON,
        &[
            (&["--fov", "0"], fov),
            (&["--fov", "180"], "less than 180"),
            (&["--fov", "-45"], "--fov -45 --near 0.1 --far 100: the field of view is -45 degrees"),
            (&["--fov", "nan"], "less than 180"),
            (&["--fov", "wide"], "--fov <DEG>"),
            (&["--near", "0"], near),
            (&["--near", "-0.1"], near),
            (&["--near", "inf"], near),
            (&["--near", "nan"], near),
            (&["--far", "0.1"], far),
            (&["--far", "-1"], far),
            (&["--far", "nan"], far),
            (&["--near", "100"], "the far plane is at 100: it must lie behind the near one, which is at 100"),
            (&["--near", "3e38", "--far", "inf"], "too large for 32 bits"),
            (&["--projection", "z16"], depths),
            (
                &["--projection", "logarithmic", "--far", "inf"],
                "--projection logarithmic: it needs a finite --far",
            ),
            (&["--light", "0,0,0"], "a direction needs three finite numbers, not all 0"),
            (&["--eye", "1,2"], "--eye <x,y,z>"),
            (&["--up", "0,inf,0"], "write 3 finite numbers"),
            (&["--eye", "1,2,3", "--center", "1,2,3"], "--eye and --center are one point: move one of them"),
            (&["--cull", "none"], "'--cull': this lesson has no such flag"),
            (&["--turntable", "3"], "'--turntable': this lesson has no such flag"),
        ],
    );
}

/// The far plane may be infinite, and whatever keeps the depths the scene is the same one.
#[test]
fn every_depth_draws_the_scene() {
    let scene = ["--size", "120x120", "--far", "1000"];
    let expected = draw("perspective", &scene);
    for name in ["z24", "z-f32", "reversed-z-f32", "logarithmic", "w"] {
        let picture = draw("perspective", &[&scene[..], &["--projection", name]].concat());
        let differ = picture.pixels().filter(|&(x, y, color)| expected.get(x, y) != Some(color)).count();
        assert!(differ < 20, "{name}: {differ} pixels differ");
    }
    let infinite =
        draw("perspective", &["--size", "120x120", "--far", "inf", "--projection", "reversed-z-f32"]);
    let nearer = |color: Color| color != Color::BLACK;
    assert!(
        infinite.pixels().filter(|pixel| nearer(pixel.2)).count()
            >= expected.pixels().filter(|pixel| nearer(pixel.2)).count()
    );
}

/// A model of one's own stands alone, and so does the head where it is asked for; else there is a floor.
#[test]
fn a_model_that_is_asked_for_stands_alone() {
    let lowest =
        |picture: &Image| picture.pixels().filter(|&(_, y, color)| y < 8 && color != Color::BLACK).count();
    let size = ["--size", "100x100"];
    assert_eq!(lowest(&draw("perspective", &size)), 800);
    assert_eq!(lowest(&draw("perspective", &[&size[..], &["--model"]].concat())), 0);
    let sphere = ["--model", SPHERE, "--texture", CRATE];
    assert_eq!(lowest(&draw("perspective", &[&size[..], &sphere].concat())), 0);
}

/// Where what is looked at lies far from the origin, the floor is where it belongs: half a kilometre away no less.
#[test]
fn far_from_the_origin_the_floor_stays_where_it_is() {
    let folder = tempdir().unwrap();
    let view =
        ["--eye", "0,1030,0.1", "--center", "0,1029,0", "--far", "5000", "--size", "64x64", "--out", "a.png"];
    let output = run("perspective", folder.path(), &view);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    // 256 units of floor, from a kilometre above: a fifth of what 45 degrees show.
    let picture = Image::read(&folder.path().join("a.png")).unwrap();
    let drawn = picture.pixels().filter(|pixel| pixel.2 != Color::BLACK).count();
    assert!((300..500).contains(&drawn), "{drawn} pixels of the floor");
}
