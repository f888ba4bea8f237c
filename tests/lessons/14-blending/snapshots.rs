use blending::{LESSON, METHODS};
use common::{Color, Format, Image};
use tempfile::tempdir;
use verify::{assert_drawn, assert_each_drawn};

const SIZE: [&str; 2] = ["--size", "200x200"];

#[test]
fn every_method_draws_the_crates() {
    assert_each_drawn(&LESSON, METHODS, &SIZE);
}

#[test]
fn scenes() {
    for scene in ["outline", "mirror", "outputs"] {
        assert_drawn(&LESSON, scene, &[&SIZE[..], &["--show", scene]].concat());
    }
}

/// Three triangles that lie over each other, the middle one drawn last.
const TRIANGLES: [&str; 10] = [
    "--size",
    "120x90",
    "--background",
    "d8d0c0",
    "--triangle",
    "5,8,110,20,40,85,c0392bc0,0.6",
    "--triangle",
    "115,5,100,80,12,60,2471a3a0,0.2",
    "--triangle",
    "2,40,118,44,70,2,f1c40f80,0.4",
];

#[test]
fn triangles_under_states() {
    for (name, flags) in [
        ("plain", &[][..]),
        ("scissor", &["--scissor", "20,10,70,50"]),
        ("greater", &["--depth-test", "notequal"]),
        ("additive", &["--blend", "src-alpha,one"]),
        ("reverse-subtract", &["--equation", "reverse-subtract", "--blend", "one,one"]),
        ("xor", &["--logic", "xor"]),
        ("red-and-blue", &["--write-mask", "rb"]),
        ("product", &["--blend", "dst-color,zero"]),
    ] {
        assert_drawn(&LESSON, &format!("triangles-{name}"), &[&TRIANGLES[..], flags].concat());
    }
}

/// A ring, through which one sees the crates.
#[test]
fn crates_through_a_stencil() {
    let folder = tempdir().unwrap();
    let file = folder.path().join("ring.png");
    let mut ring = Image::new(200, 200, Format::Gray);
    for (x, y, _) in ring.clone().pixels() {
        let (x_off, y_off) = (x - 100, y - 90);
        let far = x_off * x_off + y_off * y_off;
        ring.set(x, y, Color::gray(if (1600..6400).contains(&far) { 1.0 } else { 0.0 }));
    }
    ring.write(&file).unwrap();
    assert_drawn(&LESSON, "crates-stencil", &[&SIZE[..], &["--stencil", file.to_str().unwrap()]].concat());
}

/// Without a flag, but smaller.
#[test]
fn the_default_picture() {
    assert_drawn(&LESSON, "default", &SIZE);
}
