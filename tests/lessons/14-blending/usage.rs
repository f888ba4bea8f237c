use blending::LESSON;
use common::{Color, Format, Image};
use tempfile::tempdir;
use verify::usage::assert_fails;
use verify::{CRATE, SPHERE, draw, names, run, usage};

#[test]
fn what_holds_for_every_lesson() {
    usage::check(&LESSON);
    usage::check_depth(&LESSON);
    usage::check_texture(&LESSON);
}

#[test]
fn wrong_command_lines() {
    let triangle = "0,0,9,0,0,9";
    usage::refuses(
        &LESSON,
        &[
            (&["--triangle", "1,2,3,4,5"], "write 6 numbers, and perhaps a colour and a depth, not 5 parts"),
            (&["--triangle", "1,2,3,4,5,6,ff0000,0.5,1"], "not 9 parts"),
            (&["--triangle", "1,2,3,4,5,x"], "`x` is not a number"),
            (&["--triangle", "1,2,3,4,5,inf"], "`inf` is not a number"),
            (&["--triangle", "1,2,3,4,5,6,red"], "`red` is not a colour: write six hexadecimal digits"),
            (&["--triangle", "1,2,3,4,5,6,ff00008"], "`ff00008` is not a colour"),
            (&["--triangle", "1,2,3,4,5,6,ff0000g0"], "`ff0000g0` is not a colour"),
            (&["--triangle", "1,2,3,4,5,6,ff0000ff,1.5"], "the depth `1.5` does not lie from 0 to 1"),
            (&["--triangle", "1,2,3,4,5,6,ff0000ff,nan"], "`nan` is not a number"),
            (&["--background", "ff"], "`ff` is not a colour"),
            (&["--scissor", "1,2,3"], "write 4 numbers"),
            (&["--scissor", "1,2,-3,4"], "width and height must be 0 or more"),
            (&["--depth-test", "nearer"], "--depth-test <FUNC>"),
            (&["--blend", "one"], "write 2 factors with a comma between them, not 1"),
            (&["--blend", "one,two"], "`two` is no factor"),
            (&["--blend-alpha", "one,one,one"], "not 3"),
            (&["--blend-color", "white"], "`white` is not a colour"),
            (&["--equation", "multiply"], "--equation <EQ>"),
            (&["--logic", "not"], "--logic <OP>"),
            (&["--write-mask", "rgx"], "write the letters of channels that are written"),
            (&["--write-mask", "rr"], "`r` stands there twice"),
            (&["--show", "windows"], "--show <SHOW>"),
            (&["--transparency", "wbo"], "there are drawn, sorted, peeling, list, weighted"),
            (&["--space", "linear"], "there are encoded-straight, encoded-premultiplied, linear-straight"),
            (
                &["--space", "linear-straight", "--logic", "xor", "--triangle", triangle],
                "leave out --scissor",
            ),
            (&["--transparency", "list", "--write-mask", "r"], "leave out --scissor"),
            (&["--transparency", "list", "--blend-color", "102030"], "--blend-color"),
            (
                &["--transparency", "weighted", "--space", "linear-straight"],
                "--transparency weighted lays no layer over another: leave out --space",
            ),
            (&["--fov", "0"], "--fov 0"),
            (&["--eye", "1,2,3", "--center", "1,2,3"], "--eye and --center are one point: move one of them"),
            (&["--turntable", "3", "--depth", "a.png"], "cannot be used with"),
            (&["--wrap", "repeat"], "'--wrap': this lesson has no such flag"),
        ],
    );
}

/// What a scene cannot take is refused, and what it can take is not.
#[test]
fn flags_that_a_scene_cannot_take() {
    let state: &[&str] = &["--logic", "xor"];
    let order: &[&str] = &["--transparency", "sorted"];
    let space: &[&str] = &["--space", "linear-straight"];
    let all = [(state, "--blend-color"), (order, "--transparency"), (space, "--space")];
    let triangle: &[&str] = &["--triangle", "0,0,9,0,0,9"];
    for (scene, takes) in [
        ("crates", [true, true, true]),
        ("outline", [false, false, false]),
        ("mirror", [false, false, false]),
        ("outputs", [false, false, false]),
        ("glass", [false, true, true]),
        ("fern", [false, false, true]),
    ] {
        let shown = ["--show", scene];
        for ((flags, named), taken) in all.into_iter().zip(takes) {
            let arguments = [&shown[..], flags].concat();
            if taken {
                drop(draw(LESSON.name, &[&arguments[..], &["--size", "8x8"]].concat()));
            } else {
                usage::refuses(&LESSON, &[(&arguments, &format!("--show {scene} takes no"))]);
                usage::refuses(&LESSON, &[(&arguments, named)]);
            }
            // Triangles are drawn instead of any scene, and take all.
            drop(draw(LESSON.name, &[&arguments[..], triangle, &["--size", "8x8"]].concat()));
        }
    }
}

/// A near layer that comes before a far one: depths are kept, so that the far one is hidden, unless an order is asked for. To mix
/// light instead of codes is no order.
#[test]
fn an_order_is_only_what_is_asked_for() {
    let (near, far) = (triangle(LEFT, "00ff0080,0.25"), triangle(WHOLE, "ff000080,0.75"));
    let both = ["--triangle", &near, "--triangle", &far];
    let rgb = Color::rgb;
    for (flags, expected) in [
        (&[][..], [rgb(0, 128, 0), rgb(128, 0, 0)]),
        (&["--space", "linear-straight"], [rgb(0, 188, 0), rgb(188, 0, 0)]),
        (&["--transparency", "drawn"], [rgb(128, 64, 0), rgb(128, 0, 0)]),
        (&["--transparency", "list"], [rgb(64, 128, 0), rgb(128, 0, 0)]),
    ] {
        assert_eq!(colors(&[&both[..], flags].concat()), expected, "{flags:?}");
    }
}

/// So it is for entities: the smaller crate leaves its depths, unless an order is asked for.
#[test]
fn a_space_keeps_depths() {
    let folder = tempdir().unwrap();
    let depths = |flags: &[&str]| {
        let arguments = [&["--size", "60x60", "--depth", "d.png", "--out", "a.png"][..], flags].concat();
        assert!(run(LESSON.name, folder.path(), &arguments).status.success());
        Image::read(&folder.path().join("d.png")).unwrap()
    };
    let usual = depths(&[]);
    assert!(depths(&["--space", "linear-straight"]) == usual);
    assert!(depths(&["--transparency", "drawn"]) != usual);
}

/// A stencil that is missing, or of another size.
#[test]
fn wrong_stencils() {
    let folder = tempdir().unwrap();
    let missing = run(LESSON.name, folder.path(), &["--stencil", "none.png", "--out", "a.png"]);
    assert_fails(&missing, 1, &["cannot read none.png"]);
    Image::new(3, 2, Format::Gray).write(&folder.path().join("small.png")).unwrap();
    let arguments = ["--stencil", "small.png", "--size", "4x2", "--out", "a.png"];
    let small = run(LESSON.name, folder.path(), &arguments);
    assert_fails(&small, 2, &["--stencil: it is 3x2, and the picture 4x2: make them of one size"]);
    assert_eq!(names(folder.path()), ["small.png"]);
}

/// The whole picture, or its left half.
const WHOLE: &str = "-9,-9,99,-9,-9,99";
const LEFT: &str = "-90,-90,4,-90,4,900";

/// The colours of a pixel on the left and of one on the right of a picture of 8×4.
fn colors(arguments: &[&str]) -> [Color; 2] {
    let picture = draw(LESSON.name, &[&["--size", "8x4"], arguments].concat());
    [1, 6].map(|x| picture.get(x, 1).unwrap())
}

fn triangle(corners: &str, rest: &str) -> String {
    format!("{corners},{rest}")
}

/// What is asked for, what is drawn on the left and on the right; first a red triangle over all, then a half-transparent green
/// one over the left, nearer.
#[test]
fn flags_are_heard() {
    let (red, green) = (triangle(WHOLE, "ff0000"), triangle(LEFT, "00ff0080,0.25"));
    let both = ["--triangle", &red, "--triangle", &green];
    let rgb = Color::rgb;
    let with_alpha = |r, g, b, a| Color { r, g, b, a };
    for (flags, expected) in [
        (&[][..], [rgb(127, 128, 0), rgb(255, 0, 0)]),
        (&["--scissor", "0,0,3,4"], [rgb(127, 128, 0), rgb(0, 0, 0)]),
        (&["--scissor", "5,0,3,4"], [rgb(0, 0, 0), rgb(255, 0, 0)]),
        (&["--scissor", "0,0,8,1"], [rgb(0, 0, 0); 2]),
        (&["--scissor", "1,1,6,1"], [rgb(127, 128, 0), rgb(255, 0, 0)]),
        (&["--scissor", "2,1,4,1"], [rgb(0, 0, 0); 2]),
        (&["--depth-test", "never"], [rgb(0, 0, 0); 2]),
        (&["--depth-test", "greater"], [rgb(0, 0, 0); 2]),
        (&["--depth-test", "less"], [rgb(127, 128, 0), rgb(255, 0, 0)]),
        (&["--depth-test", "equal"], [rgb(0, 0, 0); 2]),
        (&["--blend", "one,zero"], [with_alpha(0, 255, 0, 255), rgb(255, 0, 0)]),
        (&["--blend", "one,one"], [rgb(255, 255, 0), rgb(255, 0, 0)]),
        (&["--blend", "src-alpha,one"], [rgb(255, 128, 0), rgb(255, 0, 0)]),
        (
            &["--blend", "one,one", "--blend-alpha", "one,zero"],
            [with_alpha(255, 255, 0, 128), rgb(255, 0, 0)],
        ),
        (
            &["--blend", "one,one", "--equation", "subtract"],
            [with_alpha(0, 255, 0, 1), with_alpha(255, 0, 0, 255)],
        ),
        (&["--blend", "zero,one", "--equation", "func-add"], [rgb(0, 0, 0); 2]),
        (&["--equation", "max"], [rgb(255, 255, 0), rgb(255, 0, 0)]),
        (&["--equation", "min"], [with_alpha(0, 0, 0, 128), rgb(0, 0, 0)]),
        (&["--logic", "copy"], [with_alpha(0, 255, 0, 128), rgb(255, 0, 0)]),
        (&["--logic", "xor"], [with_alpha(255, 255, 0, 128), with_alpha(255, 0, 0, 0)]),
        (&["--logic", "invert"], [with_alpha(0, 0, 0, 255), with_alpha(255, 255, 255, 0)]),
        (&["--write-mask", "g"], [rgb(0, 128, 0), rgb(0, 0, 0)]),
        (&["--write-mask", ""], [rgb(0, 0, 0); 2]),
        (&["--background", "0000ff", "--write-mask", "rg"], [rgb(127, 128, 255), rgb(255, 0, 255)]),
        (&["--blend", "constant-color,zero", "--blend-color", "336699"], [rgb(0, 0x66, 0), rgb(0x33, 0, 0)]),
        (
            &["--blend", "constant-alpha,zero", "--blend-color", "00000033"],
            [rgb(0, 0x33, 0), rgb(0x33, 0, 0)],
        ),
        (&["--transparency", "list"], [rgb(127, 128, 0), rgb(255, 0, 0)]),
        (&["--space", "linear-straight"], [rgb(187, 188, 0), rgb(255, 0, 0)]),
        (&["--method", "shift-8"], [with_alpha(126, 127, 0, 253), with_alpha(254, 0, 0, 254)]),
    ] {
        let got = colors(&[&both[..], flags].concat());
        // Alphas of what is opaque may be left out.
        assert_eq!(got, expected, "{flags:?}");
    }
}

/// A stencil's pixel hides where it is black, and nowhere else.
#[test]
fn a_stencil_hides() {
    let folder = tempdir().unwrap();
    let file = folder.path().join("stencil.png");
    let mut stencil = Image::new(8, 4, Format::Rgb);
    stencil.set(6, 1, Color::rgb(0, 0, 1));
    stencil.write(&file).unwrap();
    let red = triangle(WHOLE, "ff0000");
    let got = colors(&["--triangle", &red, "--stencil", file.to_str().unwrap()]);
    assert_eq!(got, [Color::BLACK, Color::RED]);
}

/// Defaults of a triangle: white, opaque, at depth 0.5; and of equal depths the first stays.
#[test]
fn what_a_triangle_is_unless_told_otherwise() {
    let (far, near) = (triangle(LEFT, "00ff00ff,0.5"), triangle(LEFT, "00ff00ff,0.4999"));
    assert_eq!(colors(&["--triangle", WHOLE, "--triangle", &far]), [Color::WHITE; 2]);
    assert_eq!(colors(&["--triangle", WHOLE, "--triangle", &near]), [Color::GREEN, Color::WHITE]);
    // At depth 1 is what is cleared, and nothing is nearer than itself.
    assert_eq!(colors(&["--triangle", &triangle(WHOLE, "ff0000,1")]), [Color::BLACK; 2]);
    assert_eq!(colors(&["--triangle", &triangle(WHOLE, "ff0000,0")]), [Color::RED; 2]);
}

/// The background is what the picture is filled with, in scenes as well.
#[test]
fn a_background_is_behind_all() {
    for scene in ["crates", "outline", "outputs"] {
        let picture = draw(LESSON.name, &["--size", "40x40", "--show", scene, "--background", "123456"]);
        let expected = if scene == "outputs" { 0 } else { 100 };
        let count = picture.pixels().filter(|pixel| pixel.2 == Color::rgb(0x12, 0x34, 0x56)).count();
        assert!(count >= expected, "{scene}: {count}");
    }
}

/// The model is the user's, in its texture.
#[test]
fn a_model_in_place_of_the_crates() {
    let size = ["--size", "60x60"];
    let usual = draw(LESSON.name, &size);
    let sphere = draw(LESSON.name, &[&size[..], &["--model", SPHERE, "--texture", CRATE]].concat());
    assert!(usual != sphere);
    let folder = tempdir().unwrap();
    let mut red = Image::new(1, 1, Format::Rgb);
    red.set(0, 0, Color::RED);
    red.write(&folder.path().join("red.png")).unwrap();
    let file = folder.path().join("red.png");
    let picture = draw(LESSON.name, &[&size[..], &["--texture", file.to_str().unwrap()]].concat());
    assert!(picture.pixels().all(|(_, _, Color { g, b, .. })| (g, b) == (0, 0)));
    assert!(picture.pixels().any(|pixel| pixel.2.r > 100));
}

/// The turntable writes as many pictures as asked for, and turns.
#[test]
fn a_turn_around_the_crates() {
    let folder = tempdir().unwrap();
    let output = run(LESSON.name, folder.path(), &["--turntable", "3", "--size", "30x30", "--out", "a.png"]);
    assert_eq!(String::from_utf8_lossy(&output.stdout), "3 pictures\n");
    assert_eq!(names(folder.path()), ["a-000.png", "a-001.png", "a-002.png"]);
}

/// Each scene has its depths, of what of it has any.
#[test]
fn depths_of_every_scene() {
    for scene in ["crates", "outline", "mirror", "outputs", "glass", "fern"] {
        let folder = tempdir().unwrap();
        let arguments = ["--show", scene, "--size", "60x60", "--depth", "d.png", "--out", "a.png"];
        assert!(run(LESSON.name, folder.path(), &arguments).status.success(), "{scene}");
        let depths = Image::read(&folder.path().join("d.png")).unwrap();
        assert!(depths.pixels().any(|pixel| pixel.2 == Color::WHITE), "{scene}");
    }
}
