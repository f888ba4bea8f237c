use std::fs;
use std::path::Path;

use common::program::model::DEFAULT_MODEL;
use common::{Attributes, Color, Image, Model};
use proptest::prelude::*;
use tempfile::tempdir;
use verify::run;

use crate::{assert_fails, names};

const CRATE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/crate.png");

#[test]
fn what_is_no_model_is_an_error() {
    let folder = tempdir().unwrap();
    let write = |name: &str, text: &[u8]| fs::write(folder.path().join(name), text).unwrap();
    write("empty.obj", b"");
    write("points.obj", b"v 0 0 0\nv 1 1 1\n");
    write("bad.obj", b"v 0 0 0\nf 1 2 3\nf 1 1\n");
    fs::create_dir(folder.path().join("folder.obj")).unwrap();
    for (model, said) in [
        ("missing.obj", &["cannot read missing.obj"][..]),
        ("folder.obj", &["cannot read folder.obj"]),
        ("empty.obj", &["empty.obj: there is no face in it; is it an OBJ file?"]),
        ("points.obj", &["points.obj: there is no face in it"]),
        (CRATE, &["crate.png: it is a PNG picture"]),
        (
            "bad.obj",
            &[
                "bad.obj: none of its 2 faces can be used; the first, line 2: corner `2`",
                "no vertex 2 among 1",
            ],
        ),
    ] {
        for lesson in ["wireframe", "triangles"] {
            assert_fails(&run(lesson, folder.path(), &["--model", model]), 1, said);
        }
    }
    assert!(!names(folder.path()).contains(&"out".into()), "nothing was drawn, so no folder was needed");
}

#[test]
fn what_is_something_else_is_told() {
    let folder = tempdir().unwrap();
    let wide: Vec<u8> = "\u{feff}v 0 0 0\nf 1 1 1\n".encode_utf16().flat_map(u16::to_be_bytes).collect();
    for (name, bytes, said) in [
        ("a.obj", &wide[..], "a.obj: it is text in UTF-16: save it as UTF-8"),
        ("b.obj", b"\x1f\x8b\x08\0\0", "b.obj: it is compressed by gzip: unpack it first"),
        ("c.obj", b"\r\n<!DOCTYPE html>", "c.obj: it is a page in HTML: download the file itself"),
        ("d.obj", b"version https://git-lfs.github.com/spec/v1\noid", "d.obj: it is a pointer of Git LFS"),
    ] {
        fs::write(folder.path().join(name), bytes).unwrap();
        assert_fails(&run("zbuffer", folder.path(), &["--model", name]), 1, &[said]);
    }
}

#[test]
fn lines_are_drawn_by_the_lesson_that_draws_lines() {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("a.obj"), "v -1 -1 0\nv 1 1 0\nv 1 -1 0\nvt 0 0\nl 1 2 3/1\n").unwrap();
    let arguments = ["--model", "a.obj", "--size", "9x9", "--out", "a.png"];
    assert!(run("wireframe", folder.path(), &arguments).status.success());
    let picture = Image::read(&folder.path().join("a.png")).unwrap();
    for (x, y, color) in picture.pixels() {
        assert_eq!(color == Color::WHITE, x == y || x == 8, "({x}, {y})");
    }
    let said = "a.obj: there are lines in it and no faces; lesson 2 draws lines: cargo run -p wireframe -- --model a.obj";
    for lesson in ["triangles", "zbuffer", "textures", "shaders"] {
        assert_fails(&run(lesson, folder.path(), &arguments), 1, &[said]);
    }
}

/// What lies out of view is told with the cure, and the cure cures.
#[test]
fn a_model_of_any_size_can_be_brought_into_view() {
    let folder = tempdir().unwrap();
    for (name, size) in [("mm.obj", 1000.0), ("small.obj", 0.001)] {
        let text = format!("v 0 0 0\nv {size} 0 0\nv 0 {size} 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n");
        fs::write(folder.path().join(name), text).unwrap();
    }
    let arguments = ["--size", "80x80", "--out", "a.png", "--model"];
    for lesson in
        ["wireframe", "triangles", "zbuffer", "textures", "gouraud", "transforms", "camera", "shaders"]
    {
        for (name, said) in [
            (
                "mm.obj",
                "mm.obj: it reaches to 1000, and what lies beyond 1 may be out of view: --fit brings it in\n",
            ),
            ("small.obj", "small.obj: it reaches to 0.001 only: --fit makes it as large as the view\n"),
        ] {
            let output = run(lesson, folder.path(), &[&arguments[..], &[name]].concat());
            assert!(
                output.status.success() && String::from_utf8_lossy(&output.stderr).starts_with(said),
                "{lesson}"
            );
            let output = run(lesson, folder.path(), &[&arguments[..], &[name, "--fit"]].concat());
            let said = format!("{name}: ");
            assert!(
                output.status.success() && String::from_utf8_lossy(&output.stderr).starts_with(&said),
                "{lesson}"
            );
            assert!(String::from_utf8_lossy(&output.stderr).contains(" units about ("), "{lesson}");
            let picture = Image::read(&folder.path().join("a.png")).unwrap();
            let drawn = picture.pixels().filter(|pixel| pixel.2 != Color::BLACK).count();
            assert!(drawn >= if lesson == "wireframe" { 80 } else { 400 }, "{lesson} {name}: {drawn} pixels");
        }
    }
    let help = run("wireframe", folder.path(), &["--help"]);
    assert!(String::from_utf8_lossy(&help.stdout).contains("between -1 and 1 is in view"));
}

/// z becomes y: what lies flat in the file's xy plane is seen from its edge.
#[test]
fn a_model_with_z_up_can_be_put_upright() {
    let folder = tempdir().unwrap();
    let text = "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 9 0 1\nv 0 0 1\nf 1 2 3 4\nf 1 2 5 6\n";
    fs::write(folder.path().join("a.obj"), text).unwrap();
    let rows = |up: &str| {
        let arguments = ["--model", "a.obj", "--size", "90x90", "--out", "a.png", "--fit", up];
        assert!(run("wireframe", folder.path(), &arguments).status.success());
        let picture = Image::read(&folder.path().join("a.png")).unwrap();
        let lit: Vec<i32> =
            picture.pixels().filter(|pixel| pixel.2 == Color::WHITE).map(|pixel| pixel.1).collect();
        lit.iter().max().unwrap() - lit.iter().min().unwrap()
    };
    assert!(rows("y") > 50 && rows("z") < 10);
}

/// A unit cube where surveyors have it is the same picture as one at the origin.
#[test]
fn a_model_far_from_the_origin_is_drawn_as_it_is() {
    let folder = tempdir().unwrap();
    let cube = |name: &str, [x, y, z]: [f64; 3]| {
        let mut text = String::new();
        for n in 0..8 {
            let [dx, dy, dz] = [n & 1, n >> 1 & 1, n >> 2].map(f64::from);
            text += &format!("v {:.2} {:.2} {:.2}\n", x + dx, y + dy, z + dz);
        }
        text += "vt 0 0\nvt 1 1\nf 1/1 3/1 4/2 2/2\nf 5/1 6/1 8/2 7/2\nf 1/1 2/1 6/2 5/2\nf 3/1 7/1 8/2 4/2\nf 1/1 5/1 7/2 3/2\nf 2/1 4/1 8/2 6/2\n";
        fs::write(folder.path().join(name), text).unwrap();
    };
    let place = [500_000.37, 4_649_776.81, 212.4];
    cube("near.obj", [0.0; 3]);
    cube("far.obj", place);
    let draw = |lesson: &str, model: &str, [x, y, z]: [f64; 3]| {
        // At distances that an f32 has not so far away.
        let eye = format!("{:.2},{:.2},{:.2}", x + 1.21, y + 1.57, z + 2.83);
        let center = format!("{:.2},{:.2},{:.2}", x + 0.42, y + 0.61, z + 0.38);
        let arguments = [
            "--model",
            model,
            "--texture",
            CRATE,
            "--eye",
            &eye,
            "--center",
            &center,
            "--size",
            "150x150",
            "--out",
            "a.png",
        ];
        assert!(run(lesson, folder.path(), &arguments).status.success());
        Image::read(&folder.path().join("a.png")).unwrap()
    };
    for lesson in ["camera", "shaders"] {
        let (near, far) = (draw(lesson, "near.obj", [0.0; 3]), draw(lesson, "far.obj", place));
        let differ = near.pixels().zip(far.pixels()).filter(|(a, b)| a.2 != b.2).count();
        assert!(near.pixels().filter(|pixel| pixel.2 != Color::BLACK).count() > 2000, "{lesson}");
        assert_eq!(differ, 0, "{lesson}");
    }
    // The lessons without a camera have `--fit`.
    for lesson in
        ["wireframe", "triangles", "zbuffer", "textures", "gouraud", "transforms", "camera", "shaders"]
    {
        let [near, far] = ["near.obj", "far.obj"].map(|model| {
            let arguments = ["--fit", "--size", "90x90", "--out", "a.png", "--model", model];
            let output = run(lesson, folder.path(), &arguments);
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            let middle =
                "far.obj: 1 x 1 x 1 units about (500000.87, 4649777.31, 212.9), y up, scaled by 1.03\n";
            assert!(output.status.success() && (model == "near.obj" || said.contains(middle)), "{said}");
            Image::read(&folder.path().join("a.png")).unwrap()
        });
        assert!(near.pixels().any(|pixel| pixel.2 != Color::BLACK) && near == far, "{lesson}");
    }
}

/// What the lessons with a texture draw of a model, with the looks of lesson 9 apart.
fn drawn_by_each(folder: &Path, model: &str, texture: &Image) -> Vec<(&'static str, Vec<Color>)> {
    texture.write(&folder.join("texture.png")).unwrap();
    let looks = [
        ("textures", &[][..]),
        ("gouraud", &[]),
        ("transforms", &[]),
        ("camera", &[]),
        ("shaders", &["--shader", "flat-texture"]),
        ("shaders", &["--shader", "gouraud-texture"]),
    ];
    looks
        .map(|(lesson, look)| {
            let scene = ["--model", model, "--texture", "texture.png", "--size", "60x60", "--out", "a.png"];
            assert!(run(lesson, folder, &[&scene[..], look].concat()).status.success(), "{lesson} {look:?}");
            let picture = Image::read(&folder.join("a.png")).unwrap();
            let drawn: Vec<Color> =
                picture.pixels().map(|pixel| pixel.2).filter(|&color| color != Color::BLACK).collect();
            assert!(drawn.len() > 100, "{lesson} {look:?}: {} pixels", drawn.len());
            (look.last().copied().unwrap_or(lesson), drawn)
        })
        .into()
}

const TRIANGLE: &str = "v -.3 -.7 -.3\nv .4 -.4 .2\nv -.1 .8 -.1\n";

/// The normals at the corners of a sheet's two sides cancel but for rounding, which is no direction: it is as bright as
/// its face, 255 · 0.99/√(0.69² + 0.04² + 0.99²) = 209.1.
#[test]
fn a_sheet_is_as_bright_as_its_face() {
    let folder = tempdir().unwrap();
    let mut white = Image::new(1, 1, common::Format::Rgb);
    white.set(0, 0, Color::WHITE);
    for faces in ["f 1/1 2/1 3/1\nf 3/1 2/1 1/1\n", "f 1/1 2/1 3/1\nf 2/1 1/1 3/1\nf 2/1 3/1 1/1\n"] {
        fs::write(folder.path().join("sheet.obj"), format!("{TRIANGLE}vt .5 .5\n{faces}")).unwrap();
        for (look, drawn) in drawn_by_each(folder.path(), "sheet.obj", &white) {
            assert!(drawn.iter().all(|&color| color == Color::rgb(209, 209, 209)), "{look}: {:?}", drawn[0]);
        }
    }
}

/// One triangle six times, with its corners in each order, the first with another texel than the others: it stays. (What
/// is flat has one side: there the first stays that is seen from the front.)
#[test]
fn of_equal_surfaces_the_first_stays_in_every_lesson() {
    let folder = tempdir().unwrap();
    let mut texture = Image::new(2, 1, common::Format::Rgb);
    texture.set(0, 0, Color::RED);
    texture.set(1, 0, Color::GREEN);
    let orders = [[1, 2, 3], [2, 3, 1], [3, 1, 2], [1, 3, 2], [3, 2, 1], [2, 1, 3]];
    for first in 0..6 {
        let faces = (first..first + 6).map(|n| {
            let uv = if n == first { 1 } else { 2 };
            let [a, b, c] = orders[n % 6];
            format!("f {a}/{uv}/1 {b}/{uv}/1 {c}/{uv}/1\n")
        });
        let text = format!("{TRIANGLE}vt .25 .5\nvt .75 .5\nvn 0 0 1\n{}", faces.collect::<String>());
        fs::write(folder.path().join("sheet.obj"), text).unwrap();
        for (look, drawn) in drawn_by_each(folder.path(), "sheet.obj", &texture) {
            let leaves_out = ["textures", "flat-texture"].contains(&look);
            let is_red = |color: &Color| color.r > 0 && color.g == 0;
            let expected = !leaves_out || first < 3;
            assert!(drawn.iter().all(|color| is_red(color) == expected), "{look}, {:?}", orders[first]);
        }
    }
}

/// A model of one's own has its own texture, or a checker, and never the head's skin; the line says which.
#[test]
fn a_model_brings_its_texture() {
    let folder = tempdir().unwrap();
    let square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";
    let faces = "f 1/1/1 2/2/1 3/3/1 4/4/1\n";
    fs::write(folder.path().join("own.obj"), format!("mtllib own.mtl\n{square}usemtl red\n{faces}")).unwrap();
    fs::write(folder.path().join("own.mtl"), "newmtl red\nmap_Kd red.tga\n").unwrap();
    fs::write(folder.path().join("bare.obj"), format!("{square}{faces}")).unwrap();
    let mut red = Image::new(1, 1, common::Format::Rgb);
    red.set(0, 0, Color::RED);
    red.write(&folder.path().join("red.tga")).unwrap();
    for lesson in ["textures", "gouraud", "transforms"] {
        let draw = |model: &str, said: &str| {
            let output = run(lesson, folder.path(), &["--model", model, "--size", "40x40", "--out", "a.png"]);
            assert_eq!(String::from_utf8_lossy(&output.stderr), said, "{lesson}");
            Image::read(&folder.path().join("a.png")).unwrap()
        };
        let own = draw("own.obj", "own.obj: its texture is red.tga\n");
        assert!(own.pixels().all(|pixel| pixel.2 == Color::RED), "{lesson}");
        let bare = draw(
            "bare.obj",
            "bare.obj: drawn with a checker, as it names none; --texture FILE gives it another\n",
        );
        let mut colors: Vec<u8> = bare.pixels().map(|pixel| pixel.2.r).collect();
        colors.sort_unstable();
        colors.dedup();
        assert_eq!(colors, [150, 230], "{lesson}");
    }
}

#[test]
fn the_first_face_without_texture_coordinates_is_named() {
    let folder = tempdir().unwrap();
    let text = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0\nf 1/1 2/1 3/1\nf 1 2 3\nf 1/1 2 3\n";
    fs::write(folder.path().join("a.obj"), text).unwrap();
    let said = ["a.obj: not every face has texture coordinates", "the first face without them is in line 6"];
    assert_fails(&run("textures", folder.path(), &["--model", "a.obj"]), 1, &said);
}

#[test]
fn bad_faces_are_left_out_and_told() {
    let folder = tempdir().unwrap();
    let text = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0 0 nan\nf 1 2 3\nf 1 2 9\nf 1 2 4\nf 1 2\n";
    fs::write(folder.path().join("some.obj"), text).unwrap();
    let output = run("wireframe", folder.path(), &["--model", "some.obj", "--size", "9x9"]);
    assert!(output.status.success());
    let expected =
        "some.obj: left out 3 of 4 faces; the first, line 6: corner `9`: there is no vertex 9 among 4\n";
    assert_eq!(String::from_utf8_lossy(&output.stderr), expected);
    assert_eq!(names(&folder.path().join("out")), ["02-wireframe.png", "02-wireframe.tga"]);
}

/// Both methods draw the one model that was read: from a pipe, there is no second time.
#[cfg(unix)]
#[test]
fn a_comparison_reads_its_model_once() {
    let folder = tempdir().unwrap();
    let text = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\nf 1 2\n";
    fs::write(folder.path().join("some.obj"), text).unwrap();
    let script =
        "cat some.obj | \"$0\" --model /dev/stdin --compare three-per-triangle,unique-edges --out a.png";
    let output = std::process::Command::new("sh")
        .args(["-c", script])
        .arg(verify::program("wireframe", folder.path()).get_program())
        .current_dir(folder.path())
        .output()
        .unwrap();
    let expected =
        "/dev/stdin: left out 1 of 2 faces; the first, line 5: a face needs 3 corners, this has 2\n";
    assert_eq!(String::from_utf8_lossy(&output.stderr), expected);
    assert!(String::from_utf8_lossy(&output.stdout).contains("against three-per-triangle: 0 pixels missing"));
}

#[cfg(target_os = "linux")]
#[test]
fn an_endless_model_is_refused() {
    let folder = tempdir().unwrap();
    assert_fails(
        &run("wireframe", folder.path(), &["--model", "/dev/zero"]),
        1,
        &["/dev/zero: it does not say how long it is, and has more than 256 MiB: save it as a file first"],
    );
}

/// Where a process may take 400 MiB of addresses, half of them are a model's. One file is longer by itself; the faces of
/// the other take four times its length.
#[cfg(target_os = "linux")]
#[test]
fn a_model_that_does_not_fit_in_memory_is_refused_before_it_is_read() {
    let folder = tempdir().unwrap();
    fs::File::create(folder.path().join("long.obj")).unwrap().set_len(300 << 20).unwrap();
    let text = ["v 0 0 0\n", &"f 1 1 1\n".repeat(6_000_000)].concat();
    fs::write(folder.path().join("rich.obj"), text).unwrap();
    for (model, said) in [
        (
            "long.obj",
            "long.obj: its 300 MiB are more than the 200 MiB that are half of the free memory: close other programs, or draw a model of fewer faces",
        ),
        (
            "rich.obj",
            "rich.obj: its 6000000 faces and 1 vertices take 229 MiB, more than the 200 MiB that are half of the free memory: close other programs, or draw a model of fewer faces",
        ),
    ] {
        let output = std::process::Command::new("sh")
            .args(["-c", "ulimit -v 409600; exec \"$0\" --model \"$1\""])
            .arg(verify::program("wireframe", folder.path()).get_program())
            .arg(model)
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert_fails(&output, 1, &[said]);
    }
}

proptest! {
    /// However a file is cut off or altered, reading it gives a model or a line of text.
    #[test]
    fn no_file_panics(
        cut in any::<prop::sample::Index>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..20),
    ) {
        let whole = b"o a\nv 0 0 0\nv 1 0 0 1\nv 1 1 -1e0\nvt 0 0\nvt 1 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\n\
                      f -1//-1 -2//-1 -3//-1\nf 1 2 3 1\nl 1 2 3\nmtllib a\nusemtl b\n";
        let mut bytes = whole.to_vec();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        bytes.truncate(cut.index(bytes.len() + 1));
        for (normals, uvs) in [(false, false), (true, true)] {
            match Model::parse(&bytes, Attributes { normals, uvs }) {
                Ok(model) => {
                    prop_assert!(model.faces().len() + model.lines().len() > 0);
                    prop_assert!(model.faces().flatten().all(common::Vec3::is_finite));
                    prop_assert!([0, model.faces().len()].contains(&model.face_normals().len()));
                    prop_assert!([0, model.faces().len()].contains(&model.face_uvs().len()));
                }
                Err(reason) => prop_assert_eq!(reason.lines().count(), 1),
            }
        }
    }

    /// Bytes that an OBJ file is made of, in any order, and now and then others.
    #[test]
    fn no_bytes_panic(words in prop::collection::vec(word(), 0..80)) {
        let bytes = words.concat();
        for (normals, uvs) in [(false, false), (false, true), (true, true)] {
            if let Err(reason) = Model::parse(&bytes, Attributes { normals, uvs }) {
                prop_assert!(!reason.contains(char::is_control), "{:?}", reason);
            }
        }
    }
}

/// A piece of an OBJ file.
fn word() -> impl Strategy<Value = Vec<u8>> {
    const LINES: [&str; 9] = [
        "\nv 0 0 0\n",
        "\nv 1 0 -1e1\n",
        "\nvt 0 1\n",
        "\nvn 0 0 1\n",
        "\nf 1 2 1\n",
        "\nf -1/1/1 1/-1/1 1/1/-1\n",
        "\nf 1//1 1//1 1//1 1//1 1//1\n",
        "\nf ",
        "\nv ",
    ];
    const WORDS: [&str; 20] = [
        "\n", "\r\n", "\\\n", " ", "\t", "#", "v", "vt", "vn", "f", "l", "o", "g", "/", "//", "-", "0", "1",
        "2", "nan",
    ];
    let text = |text: &'static [&str]| prop::sample::select(text).prop_map(|text| text.as_bytes().to_vec());
    prop_oneof![4 => text(&LINES), 4 => text(&WORDS), 1 => any::<i64>().prop_map(|n| n.to_string().into_bytes()),
        1 => any::<u8>().prop_map(|byte| vec![byte])]
}

/// What a file becomes, and what it says the most with: each takes no more than is counted before room is made for it.
/// Beyond that, there is what does not hang on the file's length, such as what the system says of its memory.
#[test]
fn reading_takes_bounded_memory() {
    const LINES: u64 = 33_000;
    let header = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";
    let all = Attributes { normals: true, uvs: true };
    for (line, wanted, bytes) in [
        ("f 1 2 3\n", Attributes::default(), 32),
        ("f 1/1/1 2/1/1 3/1/1\n", Attributes::default(), 32),
        ("f 1/1/1 2/1/1 3/1/1\n", all, 80),
        ("f 1 2 3\n", all, 80),
        ("f 1 2 3 1 2 3 1 2 3 1 2 3 1 2 3 1 2 3\n", Attributes::default(), 8 + 18 * 4 + 16 * 12),
        ("v 0 0 0\nvt 0\nvn 0 0 1\nf -1/-1/-1 -1/-1/-1 -1/-1/-1\n", all, 64 + 20 + 28 + 80),
        ("v 0 0 0\n", all, 64),
        ("v\n", all, 64),
        ("vt 0\n", all, 20),
        ("vn 0 0 1\n", all, 28),
        ("vn 0 0 1\n", Attributes::default(), 0),
        ("f 1 2\n", Attributes::default(), 16),
        ("f x\n", Attributes::default(), 12),
        ("l 1 2\n", Attributes::default(), 32),
    ] {
        let text = [header, &line.repeat(LINES as usize), "f 1/1/1 2/1/1 3/1/1\n"].concat();
        let counted = allocation_counter::measure(|| drop(Model::parse(text.as_bytes(), wanted)));
        let rest = counted.bytes_max.saturating_sub(LINES * bytes);
        assert!(rest <= 50_000, "{line:?}: {rest} bytes too many");
    }
}

/// A polygon's corners are put together before it is cut, in the room that the largest one needs.
#[test]
fn a_face_of_many_corners_takes_bounded_memory() {
    let corners = |n: usize| " 1 2 3".repeat(n / 3);
    let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf{}\nf{}", corners(210_000), corners(300_000));
    let counted = allocation_counter::measure(|| drop(Model::parse(text.as_bytes(), Attributes::default())));
    let bytes = 510_000 * (4 + 12) + 300_000 * 36;
    assert!(counted.bytes_max <= bytes + 50_000, "{} bytes, not {bytes}", counted.bytes_max);
}

/// As many triangles as a large scan has, with all attributes, in whichever form.
#[test]
fn a_million_triangles_are_read() {
    let row = |n: usize| format!("v {n}.123456 1 0\nv {n}.123456 0 1\n");
    let vertices: String = (0..500_001).map(row).collect();
    let triangles: String = (0..500_000)
        .map(|n| 2 * n + 1)
        .map(|n| format!("f {n}//1 {}//1 {}//1\nf {}//1 {}//1 {n}//1\n", n + 1, n + 3, n + 3, n + 2))
        .collect();
    let text = [&vertices, "vn 0 0 1\n", &triangles].concat();
    let normals = Attributes { normals: true, uvs: false };
    assert!(text.len() > 36 << 20);
    let counted = allocation_counter::measure(|| {
        let model = Model::parse(text.as_bytes(), normals).unwrap();
        assert_eq!((model.faces().len(), model.face_normals().len()), (1_000_000, 1_000_000));
    });
    // A triangle takes 56 bytes and a position 64.
    assert!(counted.bytes_max < 1_000_000 * 56 + 1_000_002 * 64 + 50_000, "{} bytes", counted.bytes_max);
}

/// What another reader makes of a file whose faces have texture coordinates, normals, or both. (Of what they do not
/// have, it gives them the first.)
fn by_tobj(text: &[u8], has: Attributes) -> Vec<[[f32; 8]; 3]> {
    let options = tobj::LoadOptions { triangulate: true, ..tobj::LoadOptions::default() };
    let (models, _) =
        tobj::load_obj_buf(&mut &*text, &options, |_| Err(tobj::LoadError::OpenFileFailed)).unwrap();
    let meshes = models.iter().map(|model| &model.mesh);
    meshes
        .flat_map(|mesh| {
            let get = |list: &[f32], at: u32, size: usize| list[at as usize * size..][..size].to_vec();
            let or_zero = |has: bool, list: &[f32], indices: &[u32], n: usize, size: usize| {
                if has { get(list, indices[n], size) } else { vec![0.0; size] }
            };
            let corner = |n: usize| {
                let position = get(&mesh.positions, mesh.indices[n], 3);
                let uv = or_zero(has.uvs, &mesh.texcoords, &mesh.texcoord_indices, n, 2);
                let normal = or_zero(has.normals, &mesh.normals, &mesh.normal_indices, n, 3);
                [position, uv, normal].concat().try_into().unwrap()
            };
            (0..mesh.indices.len() / 3).map(|n| [3 * n, 3 * n + 1, 3 * n + 2].map(corner)).collect::<Vec<_>>()
        })
        .collect()
}

/// The same of a model, 0 for what it lacks.
fn corners(model: &Model) -> Vec<[[f32; 8]; 3]> {
    let uvs = model.face_uvs().chain(std::iter::repeat([Default::default(); 3]));
    let normals = model.face_normals().chain(std::iter::repeat([Default::default(); 3]));
    let faces = model.faces().zip(uvs).zip(normals);
    faces
        .map(|((positions, uvs), normals)| {
            [0, 1, 2].map(|n| {
                let [p, uv, normal] = [positions[n], uvs[n].extend(0.0), normals[n]].map(|v| v.to_array());
                [p[0], p[1], p[2], uv[0], uv[1], normal[0], normal[1], normal[2]]
            })
        })
        .collect()
}

#[test]
fn the_assets_are_read_as_another_reader_reads_them() {
    let mut count = 0;
    for entry in fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../assets")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|ending| ending == "obj") {
            let text = fs::read(&path).unwrap();
            let all = Attributes { normals: true, uvs: true };
            assert!(corners(&Model::parse(&text, all).unwrap()) == by_tobj(&text, all), "{}", path.display());
            count += 1;
        }
    }
    assert!(count >= 4);
}

/// A file that both read: coordinates, faces of three corners or of four that are convex, all attributes or none.
fn well_formed() -> impl Strategy<Value = (String, Attributes)> {
    let number = prop_oneof![
        (-9_999_999i32..9_999_999).prop_map(|n| format!("{}", f64::from(n) / 1e4)),
        (-999i32..999, -20i32..20).prop_map(|(n, e)| format!("{n}.5e{e}")),
        (-99i32..99).prop_map(|n| n.to_string()),
    ];
    let face = (prop::collection::vec(0u32..9, 3), any::<bool>());
    let numbers = prop::collection::vec(number, 9 * 8);
    (numbers, prop::collection::vec(face, 1..9), 0..4usize, any::<bool>()).prop_map(
        |(numbers, faces, form, windows)| {
            let mut lines: Vec<String> =
                ["# made", "o a", "v 0 0 7", "v 1 0 7", "v 1 1e-3 7", "v 0 1 7"].map(Into::into).into();
            for n in numbers.chunks(8) {
                lines.push(format!("v {} {}  {}", n[0], n[1], n[2]));
                lines.push(format!("vt\t{} {}", n[3], n[4]));
                lines.push(format!("vn {} {} {} ", n[5], n[6], n[7]));
            }
            for (corners, negative) in faces {
                let index = |n: u32| i64::from(n) + if negative { -9 } else { 1 };
                let corner = |&n: &u32| {
                    let [v, vt, vn] = [n, (n + 1) % 9, (n + 5) % 9].map(index);
                    // Before the other positions there are four of a face of their own.
                    let v = if negative { v } else { v + 4 };
                    match form {
                        0 => format!("{v}"),
                        1 => format!("{v}/{vt}"),
                        2 => format!("{v}//{vn}"),
                        _ => format!("{v}/{vt}/{vn}"),
                    }
                };
                lines.push(format!("f {}", corners.iter().map(corner).collect::<Vec<_>>().join(" ")));
            }
            lines.push(
                ["f 1 2 3 4", "f 1/1 2/1 3/2 4/3", "f 1//1 2//1 3//2 4//3", "f 1/1/1 2/2/2 3/3/3 4/4/4"]
                    [form]
                    .into(),
            );
            let has = Attributes { uvs: form % 2 == 1, normals: form >= 2 };
            (lines.join(if windows { "\r\n" } else { "\n" }), has)
        },
    )
}

proptest! {
    #[test]
    fn what_is_well_formed_is_read_as_another_reader_reads_it((text, has) in well_formed()) {
        let model = Model::parse(text.as_bytes(), Attributes { normals: true, uvs: true }).unwrap();
        prop_assert_eq!(corners(&model), by_tobj(text.as_bytes(), has));
    }

    /// A face with one row of corners below another, and each its own distance from the middle: whichever corner
    /// comes first, wherever its plane lies, just what is inside is covered, once.
    #[test]
    fn a_face_of_any_shape_covers_its_inside(
        outline in outline(),
        first in any::<prop::sample::Index>(),
        axes in prop::array::uniform2(prop::array::uniform3(-9i32..=9)),
        backwards in any::<bool>(),
    ) {
        let [a, b] = axes.map(|axis| glam::DVec3::from_array(axis.map(f64::from)));
        prop_assume!(a.cross(b) != glam::DVec3::ZERO);
        let mut order: Vec<usize> = (1..=outline.len()).collect();
        order.rotate_left(first.index(outline.len()));
        if backwards {
            order.reverse();
        }
        // In whole numbers, so that the plane is met exactly.
        let mut text = String::new();
        for &[x, y] in &outline {
            let p = a * f64::from(x) + b * f64::from(y);
            text += &format!("v {} {} {}\n", p.x, p.y, p.z);
        }
        text += &order.iter().fold("f".to_string(), |line, n| format!("{line} {n}"));
        let model = Model::parse(text.as_bytes(), Attributes::default()).unwrap();
        // Back in the plane, by the products with the two axes.
        let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
        let flat = |p: common::Vec3| {
            let (pa, pb) = (p.as_dvec3().dot(a), p.as_dvec3().dot(b));
            [(pa * bb - pb * ab) / (aa * bb - ab * ab), (pb * aa - pa * ab) / (aa * bb - ab * ab)].map(f64::round)
        };
        let triangles: Vec<[[f64; 2]; 3]> = model.faces().map(|face| face.map(flat)).collect();
        for (x, y) in (-20..20).flat_map(|x| (-20..20).map(move |y| (x, y))) {
            // A point that lies on no line between two whole numbers of this size.
            let point = [f64::from(x) + 0.123_456_7, f64::from(y) + 0.765_432_1];
            let outline: Vec<[f64; 2]> = outline.iter().map(|corner| corner.map(f64::from)).collect();
            let count = triangles.iter().filter(|triangle| is_inside(*triangle, point)).count();
            prop_assert_eq!(count, usize::from(is_inside(&outline, point)), "{:?}", point);
        }
        let turns = |[p, q, r]: [common::Vec3; 3]| (q - p).cross(r - p).as_dvec3().dot(a.cross(b));
        let area: f64 = signed_area(&outline) * if backwards { -1.0 } else { 1.0 };
        prop_assert!(model.faces().all(|face| turns(face) * area >= 0.0));
    }
}

/// Whether a point is inside an outline, by the even-odd rule.
fn is_inside(outline: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let sides = outline.iter().zip(outline.iter().cycle().skip(1));
    let crossed = sides
        .filter(|&(&[px, py], &[qx, qy])| (py > y) != (qy > y) && x < px + (y - py) / (qy - py) * (qx - px));
    crossed.count() % 2 == 1
}

fn signed_area(outline: &[[i32; 2]]) -> f64 {
    let sides = outline.iter().zip(outline.iter().cycle().skip(1));
    sides.map(|(p, q)| f64::from(p[0] * q[1] - q[0] * p[1])).sum()
}

/// The corners of a face that does not cross itself, counterclockwise: around the middle, each at a distance of
/// its own; some on one line with their neighbours.
fn outline() -> impl Strategy<Value = Vec<[i32; 2]>> {
    const AROUND: [[i32; 2]; 16] = [
        [4, 0],
        [4, 1],
        [4, 2],
        [3, 4],
        [0, 4],
        [-1, 4],
        [-2, 4],
        [-4, 3],
        [-4, 0],
        [-4, -1],
        [-4, -2],
        [-3, -4],
        [0, -4],
        [1, -4],
        [2, -4],
        [4, -3],
    ];
    prop::collection::vec(prop_oneof![2 => Just(4), 3 => 0..5i32], 16).prop_filter_map(
        "too few",
        |distances| {
            let corners = AROUND.iter().zip(distances).filter(|(_, d)| *d > 0);
            let outline: Vec<[i32; 2]> = corners.map(|(at, d)| at.map(|c| c * d)).collect();
            // The middle stays inside as long as no three neighbours are missing.
            let turn = |p: [i32; 2], q: [i32; 2]| p[0] * q[1] - p[1] * q[0];
            let all = outline.iter().zip(outline.iter().cycle().skip(1)).all(|(&p, &q)| turn(p, q) > 0);
            (outline.len() >= 3 && all).then_some(outline)
        },
    )
}

#[test]
fn the_default_model_needs_no_flag() {
    let folder = tempdir().unwrap();
    for arguments in [
        &["--out", "a.png"][..],
        &["--out", "b.png", "--model"],
        &["--out", "c.png", "--model", DEFAULT_MODEL],
    ] {
        assert!(run("wireframe", folder.path(), arguments).status.success());
    }
    let read = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert!(read("a.png") == read("b.png") && read("a.png") == read("c.png"));
}
