use std::fs;

use common::{Attributes, Model};
use proptest::prelude::*;
use tempfile::tempdir;
use verify::run;

use crate::{assert_fails, names};

const SPHERE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/sphere.obj");
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

    #[test]
    fn no_bytes_panic(bytes in any::<Vec<u8>>()) {
        let _ = Model::parse(&bytes, Attributes::default());
    }
}

#[test]
fn the_default_model_needs_no_flag() {
    let folder = tempdir().unwrap();
    for arguments in
        [&["--out", "a.png"][..], &["--out", "b.png", "--model"], &["--out", "c.png", "--model", SPHERE]]
    {
        assert!(run("wireframe", folder.path(), arguments).status.success());
    }
    let read = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert!(read("a.png") == read("b.png"));
}
