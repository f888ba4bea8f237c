use antialiasing::{LESSON, METHODS};
use common::Color;
use verify::{CRATE, SPHERE, draw, run, usage};

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
            (&["--resolve", "gamma"], "--resolve gamma: there are encoded, linear"),
            (&["--method", "msaa-3"], "invalid value 'msaa-3' for '--method <NAME>'"),
            (&["--triangle", "0,0,1,1,2"], "write 6 numbers"),
            (&["--triangle", "0,0,1,1,2,2,ff"], "is not a colour"),
            (&["--triangle", "0,0,1,1,2,2,ffffff,1.5"], "the depth `1.5` does not lie from 0 to 1"),
            (&["--background", "blue"], "is not a colour"),
            (&["--cull", "sides"], "--cull <back|front|none>"),
            (&["--fov", "180"], "less than 180"),
            (&["--near", "0"], "must lie before the eye, at more than 0"),
            (&["--far", "0.1"], "it must lie behind the near one"),
            (&["--eye", "1,2,3", "--center", "1,2,3"], "--eye and --center are one point: move one of them"),
            (&["--blend", "one,one"], "'--blend': this lesson has no such flag"),
        ],
    );
}

/// What would take eight bytes for each of more than 2²⁸ samples is refused in a line, by the methods that would take it.
#[test]
fn too_many_samples_are_refused_and_said_how_many_will_do() {
    let folder = tempfile::tempdir().unwrap();
    let output = run(LESSON.name, folder.path(), &["--size", "4097x4096", "--out", "a.png"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.starts_with("error: --size 4097x4096: 16 samples a pixel are too many for it"), "{said}");
    assert!(
        said.trim_end().ends_with("up to 16777216 pixels will do") && said.lines().count() == 1,
        "{said}"
    );
    assert!(verify::names(folder.path()).is_empty());
}

/// Triangles stand alone, in the order given: no head, no rays, and nothing enlarged.
#[test]
fn triangles_that_are_asked_for_stand_alone() {
    // Half a pixel of each of the two columns beside x = 20, and a second triangle behind the first.
    let triangles =
        ["--triangle", "10.5,5,20.5,5,20.5,45,ff0000,0.25", "--triangle", "0,0,60,0,0,90,00ff00,0.75"];
    let arguments = [&["--size", "120x100", "--background", "0000ff"], &triangles[..]].concat();
    let picture = draw(LESSON.name, &arguments);
    let found = [(19, 8), (20, 8), (30, 8), (100, 50)].map(|(x, y)| picture.get(x, y).unwrap());
    assert_eq!(found, [Color::RED, Color::rgb(128, 128, 0), Color::GREEN, Color::rgb(0, 0, 255)]);
    let none = draw(LESSON.name, &[&arguments[..], &["--method", "none"]].concat());
    assert_eq!(none.get(20, 8), Some(Color::GREEN));
}

/// Half a pixel of white on black is half the code, or half the light.
#[test]
fn samples_are_resolved_as_asked_for() {
    for (flags, grey) in [(&[][..], 128), (&["--resolve", "encoded"], 128), (&["--resolve", "linear"], 188)] {
        let half = ["--size", "20x20", "--triangle", "-50,-50,10.5,-50,10.5,200"];
        let picture = draw(LESSON.name, &[&half[..], flags].concat());
        assert_eq!(picture.get(10, 10), Some(Color::rgb(grey, grey, grey)), "{flags:?}");
    }
}

/// A triangle of half alpha is laid over what is there, or covers half of the samples: over black both are half of it. Two, one
/// behind the other: laid over each other the one behind shines through, but of the same samples the nearer has all.
#[test]
fn alpha_is_laid_over_or_covers_samples() {
    let [near, far] = ["-50,-50,200,-50,-50,200,ffffff80,0.25", "-50,-50,200,-50,-50,200,ffffff80,0.75"];
    for (flags, triangles, grey) in [
        (&[][..], &[near][..], 128),
        (&["--alpha-to-coverage"], &[near], 128),
        (&[], &[far, near], 192),
        (&["--alpha-to-coverage"], &[far, near], 128),
    ] {
        let triangles = triangles.iter().flat_map(|triangle| ["--triangle", triangle]);
        let arguments: Vec<&str> = ["--size", "20x20"].into_iter().chain(triangles).collect();
        let picture = draw(LESSON.name, &[&arguments[..], flags].concat());
        assert_eq!(picture.get(5, 5), Some(Color::rgb(grey, grey, grey)), "{arguments:?} {flags:?}");
    }
}

/// A model of one's own stands alone, and nothing of it is enlarged.
#[test]
fn a_model_that_is_asked_for_stands_alone() {
    let corner = |picture: &common::Image| {
        picture.pixels().filter(|&(x, y, color)| x < 25 && y < 25 && color != Color::BLACK).count()
    };
    let size = ["--size", "200x200"];
    assert_eq!(corner(&draw(LESSON.name, &size)), 625);
    assert_eq!(
        corner(&draw(LESSON.name, &[&size[..], &["--model", SPHERE, "--texture", CRATE]].concat())),
        0
    );
}

/// On the left what `none` draws, on the right what the method does; the picture outside is the method's.
#[test]
fn a_part_is_enlarged_as_it_is_and_with_its_stairs() {
    let picture = |name| draw(LESSON.name, &["--size", "180x180", "--method", name]);
    let (times, part) = (2, 24);
    // Of both squares the lower left corners, inside of the frames.
    let squares = |picture: &common::Image| {
        [3, 180 - 3 - part * times].map(|x| {
            let at = |i: i32, j: i32| picture.get(x + i * times, 3 + j * times).unwrap();
            (0..part * part).map(|n| at(n % part, n / part)).collect::<Vec<Color>>()
        })
    };
    let stairs = squares(&picture("none"));
    assert_eq!(stairs[0], stairs[1]);
    for method in METHODS.iter().skip(1) {
        let [left, right] = squares(&picture(method.name));
        assert_eq!(left, stairs[0], "{}", method.name);
        assert_ne!(right, stairs[0], "{}", method.name);
    }
}

/// A side is left out if asked for.
#[test]
fn a_side_is_left_out_if_asked_for() {
    let sphere = ["--size", "60x60", "--model", SPHERE, "--texture", CRATE];
    let drawn = |cull: &str| draw(LESSON.name, &[&sphere[..], &["--cull", cull]].concat());
    let [back, front, none] = ["back", "front", "none"].map(drawn);
    assert!(back == none && front != none);
}

/// What a texture cuts out is seen through, whether its alpha covers samples or is blended: the square's corner shows the sky,
/// and a frond hides it.
#[test]
fn what_a_texture_cuts_out_is_seen_through() {
    let [square, fern] = ["square.obj", "fern.png"]
        .map(|file| [env!("CARGO_MANIFEST_DIR"), "/../../../assets/", file].concat());
    let sky = Color::rgb(0x88, 0xaa, 0xdd);
    for method in METHODS {
        for flags in [&[][..], &["--alpha-to-coverage"]] {
            let alone = ["--size", "160x160", "--model", &square, "--texture", &fern, "--eye", "0,0,2.6"];
            let rest = ["--background", "88aadd", "--method", method.name];
            let picture = draw(LESSON.name, &[&alone[..], &rest, flags].concat());
            let seen = picture.pixels().filter(|pixel| pixel.2 == sky).count();
            // The square is most of the picture, and the frond a part of it.
            assert!((10_000..24_000).contains(&seen), "{}, {flags:?}: {seen}", method.name);
        }
    }
}
