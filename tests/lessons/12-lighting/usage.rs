use common::{Color, Image};
use lighting::LESSON;
use tempfile::tempdir;
use verify::{CRATE, SPHERE, draw, run, usage};

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_depth(&LESSON);
    usage::check_texture(&LESSON);
}

/// From 2 away, 90 degrees are 4 high: a square from −1 to 1 is half of the picture. All of its colour is ambient.
#[test]
fn outside_a_texture_is_its_border_or_the_texture_again() {
    let view = ["--eye", "0,0,2", "--center", "0,0,0", "--fov", "90"];
    let light = ["--ambient", "1", "--diffuse", "0", "--specular", "0"];
    usage::check_wrap(&LESSON, 160, &[&view[..], &light].concat());
}

#[test]
fn wrong_command_lines() {
    let share = "write a number from 0 to 1000000";
    usage::refuses(
        &LESSON,
        &[
            (&["--light-at", "1,2"], "--light-at <x,y,z>"),
            (&["--light-at", "0,0,inf"], "write 3 numbers from -1e18 to 1e18"),
            (&["--light-at", "0,-2e18,0"], "write 3 numbers from -1e18 to 1e18"),
            (&["--ambient", "-0.1"], share),
            (&["--diffuse", "nan"], share),
            (&["--specular", "much"], share),
            (&["--shininess", "1e7"], share),
            (&["--shininess", "-1"], "--shininess <E>"),
            (&["--falloff", "cubic"], "--falloff <none|linear|quadratic>"),
            (&["--stretch", "1,0,1"], "write 3 numbers from 0.001 to 1000"),
            (&["--stretch", "1,-1,1"], "write 3 numbers from 0.001 to 1000"),
            (&["--stretch", "2"], "--stretch <x,y,z>"),
            (&["--cull", "sides"], "--cull <back|front|none>"),
            (&["--fov", "180"], "less than 180"),
            (&["--near", "0"], "must lie before the eye, at more than 0"),
            (&["--eye", "1,2,3", "--center", "1,2,3"], "--eye and --center are one point: move one of them"),
            (
                &["--look", "shiny"],
                "--look shiny: there are plain, object-normals, tangent-normals, specular-map, toon",
            ),
            (&["--turntable", "0"], "--turntable <N>"),
            (&["--turntable", "3", "--depth", "a.png"], "cannot be used with"),
            (&["--projection", "w"], "'--projection': this lesson has no such flag"),
        ],
    );
}

/// The head's maps are the head's; another model brings its own, or is drawn by a look without.
#[test]
fn maps_belong_to_a_model() {
    let folder = tempdir().unwrap();
    let said = |flags: &[&str]| {
        let scene = ["--model", SPHERE, "--texture", CRATE, "--out", "a.png", "--size", "20x20", "--quiet"];
        let output = run("lighting", folder.path(), &[&scene[..], flags].concat());
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    for (look, flag) in [
        (&["--look", "object-normals"][..], "normal-map"),
        (&["--look", "tangent-normals"], "normal-map"),
        (&["--look", "specular-map"], "normal-map"),
        (&["--look", "specular-map", "--normal-map", CRATE], "specular-map"),
    ] {
        let (code, told) = said(look);
        let cure = format!("{}: the head's map fits no other model; give one by --{flag} FILE", look[1]);
        assert!(code == Some(2) && told.contains(&cure) && told.lines().count() == 1, "{told}");
    }
    let (code, told) = said(&["--look", "tangent-normals", "--normal-map", "none.png"]);
    assert!(code == Some(1) && told.contains("cannot read none.png"), "{told}");
    // What a look does not need is not looked at.
    for look in ["plain", "toon"] {
        let flags = ["--look", look, "--normal-map", "none.png", "--specular-map", "none.png"];
        assert_eq!(said(&flags), (Some(0), String::new()));
    }
    let maps = ["--look", "specular-map", "--normal-map", CRATE, "--specular-map", CRATE];
    assert_eq!(said(&maps), (Some(0), String::new()));
}

/// What a white square shows in its middle, with these flags and the eye straight before it.
fn middle(flags: &[&str]) -> u8 {
    let folder = tempdir().unwrap();
    let text = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nf 1/1 2/1 3/1 4/1\n";
    std::fs::write(folder.path().join("a.obj"), text).unwrap();
    let mut white = Image::new(1, 1, common::Format::Rgb);
    white.set(0, 0, Color::WHITE);
    white.write(&folder.path().join("w.png")).unwrap();
    let scene = ["--model", "a.obj", "--texture", "w.png", "--out", "a.png", "--size", "41x41"];
    let view = ["--eye", "0,0,2", "--center", "0,0,0"];
    let output = run("lighting", folder.path(), &[&scene[..], &view, flags].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let color = Image::read(&folder.path().join("a.png")).unwrap().get(20, 20).unwrap();
    assert!(color.r == color.g && color.g == color.b, "{color:?}");
    color.r
}

/// The middle of the square faces eye and light, so that each share is seen as it is.
#[test]
fn each_flag_is_a_share_of_white() {
    let straight = ["--light-at", "0,0,2", "--ambient", "0"];
    for (flags, level) in [
        (&["--diffuse", "0", "--specular", "0"][..], 0),
        (&["--diffuse", "0.2", "--specular", "0"], 51),
        (&["--diffuse", "0", "--specular", "0.6"], 153),
        (&["--diffuse", "0.2", "--specular", "0.6"], 204),
        (&["--diffuse", "0.4", "--specular", "0", "--falloff", "linear"], 51),
        (&["--diffuse", "0.8", "--specular", "0", "--falloff", "quadratic"], 51),
        (&["--diffuse", "0.8", "--specular", "0", "--falloff", "none"], 204),
        (&["--diffuse", "5"], 255),
    ] {
        assert_eq!(middle(&[&straight[..], flags].concat()), level, "{flags:?}");
    }
    // With the light 60° aside, half of it falls on the square, and half-way to the eye is 30° aside: cos² 30° is ¾.
    let aside = ["--light-at", "3.4641016,0,2", "--ambient", "0"];
    assert_eq!(middle(&[&aside[..], &["--diffuse", "0.8", "--specular", "0"]].concat()), 102);
    let shining = ["--diffuse", "0", "--specular", "0.8", "--shininess", "2"];
    assert_eq!(middle(&[&aside[..], &shining].concat()), 153);
    let mirrored = [&shining[..], &["--method", "phong"]].concat();
    assert_eq!(middle(&[&aside[..], &mirrored].concat()), 51);
    // From behind nothing is seen of it but what is ambient.
    assert_eq!(middle(&["--light-at", "0,0,-2", "--ambient", "0.6"]), 153);
}

/// Light is where it is in the world, however far away all of it is.
#[test]
fn a_scene_far_away_is_lit_as_one_here() {
    let here = draw(
        "lighting",
        &["--size", "60x60", "--model", SPHERE, "--texture", CRATE, "--eye", "0,0,3", "--center", "0,0,0"],
    );
    let folder = tempdir().unwrap();
    let text = std::fs::read_to_string(SPHERE).unwrap();
    let moved: Vec<String> = text
        .lines()
        .map(|line| match line.strip_prefix("v ") {
            Some(numbers) => {
                let place = |n: &str| format!("{}", n.parse::<f64>().unwrap() + 4096.0);
                format!("v {}", numbers.split_whitespace().map(place).collect::<Vec<_>>().join(" "))
            }
            None => line.to_string(),
        })
        .collect();
    std::fs::write(folder.path().join("a.obj"), moved.join("\n")).unwrap();
    let scene = ["--size", "60x60", "--model", "a.obj", "--texture", CRATE, "--out", "a.png"];
    let view = ["--eye", "4096,4096,4099", "--center", "4096,4096,4096", "--light-at", "4097,4097,4098"];
    let output = run("lighting", folder.path(), &[&scene[..], &view].concat());
    assert!(output.status.success());
    let there = Image::read(&folder.path().join("a.png")).unwrap();
    let differ = here.pixels().filter(|&(x, y, color)| there.get(x, y) != Some(color)).count();
    assert!(differ < 20, "{differ}");
}

/// The ends of what flags take are taken.
#[test]
fn the_least_and_the_most_are_taken() {
    let shares = ["--ambient", "1000000", "--diffuse", "1e6", "--specular", "0", "--shininess", "1e6"];
    assert_eq!(middle(&[&shares[..], &["--light-at", "1e18,-1e18,1e18"]].concat()), 255);
    assert_eq!(middle(&["--stretch", "1000,1000,0.001", "--ambient", "0.6", "--light-at", "0,0,-1"]), 153);
    let dark = ["--ambient", "0", "--diffuse", "0", "--specular", "0", "--shininess", "0"];
    assert_eq!(middle(&[&dark[..], &["--light-at", "-1e18,1e18,-1e18"]].concat()), 0);
}

/// The eye goes round, the light stays: another part of the model is lit in each picture.
#[test]
fn a_turntable_turns_the_eye_and_not_the_light() {
    let folder = tempdir().unwrap();
    let scene =
        ["--model", SPHERE, "--texture", CRATE, "--size", "31x31", "--out", "a.png", "--turntable", "2"];
    let view = ["--eye", "0,0,3", "--center", "0,0,0", "--light-at", "0,0,9"];
    let output = run("lighting", folder.path(), &[&scene[..], &view].concat());
    assert_eq!(String::from_utf8_lossy(&output.stdout), "2 pictures\n");
    let middle = |n: usize| {
        let picture = Image::read(&folder.path().join(format!("a-00{n}.png"))).unwrap();
        picture.get(15, 15).unwrap().luma()
    };
    assert!(middle(0) > 2 * middle(1) && middle(1) > 0, "{} {}", middle(0), middle(1));
}

/// A stretched model is as large as it was asked to be: it covers as much more of the picture.
#[test]
fn a_model_is_stretched_along_its_axes() {
    let covered = |stretch: &str| {
        let scene = [
            "--model",
            SPHERE,
            "--texture",
            CRATE,
            "--size",
            "80x80",
            "--eye",
            "0,0,30",
            "--center",
            "0,0,0",
        ];
        let picture = draw("lighting", &[&scene[..], &["--fov", "6", "--stretch", stretch]].concat());
        picture.pixels().filter(|pixel| pixel.2 != Color::BLACK).count() as f64
    };
    let whole = covered("1,1,1");
    assert!((covered("0.5,1,1") / whole - 0.5).abs() < 0.02);
    assert!((covered("1,0.25,1") / whole - 0.25).abs() < 0.02);
    assert!((covered("1,1,0.5") / whole - 1.0).abs() < 0.02);
}
