use std::fs;

use common::program::model::DEFAULT_MODEL;
use common::{Attributes, Model};
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
        (CRATE, &["crate.png: there is no face in it; is it an OBJ file?"]),
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
        &["/dev/zero: larger than the 32 MiB that are read"],
    );
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
                    prop_assert!(model.faces().len() > 0);
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

/// The worst of files say the most in the fewest bytes: faces of small indices, just more than a power of two,
/// at which vectors grow.
#[test]
fn reading_takes_bounded_memory() {
    let header = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";
    let all = Attributes { normals: true, uvs: true };
    for (line, wanted, times) in [
        ("f 1 2 3\n", Attributes::default(), 45),
        ("f 1/1/1 2/1/1 3/1/1\n", Attributes::default(), 18),
        ("f 1/1/1 2/1/1 3/1/1\n", all, 19),
        ("f 1 2 3 1 2 3 1 2 3 1 2 3 1 2 3 1 2 3\n", Attributes::default(), 45),
        ("v 0 0 0\n", all, 6),
        ("vn 0 0 1\n", Attributes::default(), 1),
        ("f 1 2\n", all, 1),
    ] {
        let text = [header, &line.repeat(33_000), "f 1/1/1 2/1/1 3/1/1\n"].concat();
        let counted = allocation_counter::measure(|| drop(Model::parse(text.as_bytes(), wanted)));
        let taken = counted.bytes_max as f64 / text.len() as f64;
        assert!(taken <= f64::from(times), "{line:?}: {taken:.1} times the file's length");
    }
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
