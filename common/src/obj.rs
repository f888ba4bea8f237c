//! Reads an OBJ file with `tobj`, behind a check of every face.
//!
//! `tobj` refuses a whole file for one bad index, accepts NaN, takes a line element for a triangle and
//! follows material files that can make it panic. So each face is checked here first, its corners are
//! written out as positive indices of just what was asked for, and `tobj` reads that: it parses the
//! numbers, shares the corners and cuts polygons into triangles.

use std::fmt::Write;

use glam::{Vec2, Vec3};

use crate::model::{Attributes, Model, Skipped};

/// The three lists of an OBJ file, in the order in which a face's corner names them: `position/uv/normal`.
const KINDS: [(&str, &str, usize); 3] =
    [("v", "vertex", 3), ("vt", "texture coordinate", 2), ("vn", "normal", 3)];

/// One list: for each element its numbers as written, or `None` if one is missing or not finite.
type List<'a> = Vec<Option<&'a str>>;

/// A face's line, with how long each list was there: a negative index counts back from that.
struct Face<'a> {
    line: usize,
    corners: &'a str,
    lengths: [usize; 3],
}

/// A corner's places in the three lists, counted from 1, where given.
type Corner = [Option<usize>; 3];

/// See [`Model::read`].
pub(crate) fn parse(bytes: &[u8], wanted: Attributes) -> Result<Model, String> {
    // Only names and comments may hold other than ASCII, and neither is used: any encoding will do.
    let text = String::from_utf8_lossy(bytes);
    let (lists, faces) = scan(text.trim_start_matches('\u{feff}'));
    if faces.is_empty() {
        return Err("there is no face in it; is it an OBJ file?".into());
    }
    let mut use_kind = [true, wanted.uvs, wanted.normals];
    let mut good: Vec<Vec<Corner>> = Vec::new();
    let mut skipped: Option<Skipped> = None;
    for face in &faces {
        match check(face, &lists, use_kind) {
            Ok(corners) => good.push(corners),
            Err(reason) => {
                let first =
                    || Skipped { count: 0, of: faces.len(), first: format!("line {}: {reason}", face.line) };
                skipped.get_or_insert_with(first).count += 1;
            }
        }
    }
    match skipped {
        Some(Skipped { of, first, .. }) if good.is_empty() => {
            return Err(format!("none of its {of} faces can be used; the first, {first}"));
        }
        _ => {}
    }
    for kind in [1, 2] {
        use_kind[kind] &= good.iter().flatten().all(|corner| corner[kind].is_some());
    }
    let model = triangulate(&rewrite(&lists, &good, use_kind))?;
    Ok(Model { skipped, ..model })
}

/// Sorts the lines of the text into the three lists and the faces.
fn scan(text: &str) -> ([List<'_>; 3], Vec<Face<'_>>) {
    let mut lists = [const { Vec::new() }; 3];
    let mut faces = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default().trim();
        let (keyword, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        if let Some(kind) = KINDS.iter().position(|kind| kind.0 == keyword) {
            lists[kind].push(Some(rest).filter(|numbers| are_finite(numbers, KINDS[kind].2)));
        } else if keyword == "f" {
            let lengths = lists.each_ref().map(Vec::len);
            faces.push(Face { line: index + 1, corners: rest, lengths });
        }
    }
    (lists, faces)
}

/// Whether the text begins with `count` numbers that are finite as `f32`.
fn are_finite(text: &str, count: usize) -> bool {
    let finite = |word: &&str| word.parse::<f32>().is_ok_and(f32::is_finite);
    text.split_whitespace().take(count).filter(finite).count() == count
}

/// The corners of a face, or why it cannot be used. Of the lists that are not used nothing is checked.
fn check(face: &Face, lists: &[List; 3], use_kind: [bool; 3]) -> Result<Vec<Corner>, String> {
    let corners: Vec<Corner> = face
        .corners
        .split_whitespace()
        .map(|word| check_corner(word, face, lists, use_kind))
        .collect::<Result<_, _>>()?;
    match corners.len() {
        count @ 0..3 => Err(format!("a face needs 3 corners, this has {count}")),
        _ => Ok(corners),
    }
}

/// The places that a corner such as `3`, `3/1`, `3//2` or `-1/-1/-1` names.
fn check_corner(word: &str, face: &Face, lists: &[List; 3], use_kind: [bool; 3]) -> Result<Corner, String> {
    let mut corner = [None; 3];
    let parts: Vec<&str> = word.split('/').collect();
    if parts.len() > 3 || parts[0].is_empty() {
        return Err(format!("`{word}` is not a corner"));
    }
    for (kind, part) in parts.iter().enumerate() {
        if part.is_empty() || !use_kind[kind] {
            continue;
        }
        let (_, name, _) = KINDS[kind];
        let index: i64 = part.parse().map_err(|_| format!("corner `{word}`: `{part}` is not an index"))?;
        let place = if index < 0 { index.saturating_add(face.lengths[kind] as i64 + 1) } else { index };
        let list = &lists[kind];
        let at = usize::try_from(place).ok().filter(|&at| 1 <= at && at <= list.len());
        let at =
            at.ok_or_else(|| format!("corner `{word}`: there is no {name} {index} among {}", list.len()))?;
        if list[at - 1].is_none() {
            return Err(format!("corner `{word}`: {name} {index} is not made of finite numbers"));
        }
        corner[kind] = Some(at);
    }
    Ok(corner)
}

/// The good faces as an OBJ text that says nothing else.
fn rewrite(lists: &[List; 3], faces: &[Vec<Corner>], use_kind: [bool; 3]) -> String {
    let mut text = String::new();
    for ((keyword, _, count), list) in
        KINDS.iter().zip(lists).zip(use_kind).filter_map(|(l, used)| used.then_some(l))
    {
        for numbers in list {
            // A bad element keeps its place, so that the others keep theirs; no good face names it.
            text.push_str(keyword);
            let numbers = numbers.unwrap_or("0 0 0").split_whitespace().take(*count);
            numbers.for_each(|number| text.extend([" ", number]));
            text.push('\n');
        }
    }
    for face in faces {
        text.push('f');
        for corner in face {
            let place = |kind: usize| corner[kind].filter(|_| use_kind[kind]);
            let show = |place: Option<usize>| place.map(|place| place.to_string()).unwrap_or_default();
            // Writing to a string cannot fail.
            let _ = write!(text, " {}/{}/{}", show(place(0)), show(place(1)), show(place(2)));
        }
        text.push('\n');
    }
    text
}

/// Hands the checked text to `tobj`.
fn triangulate(text: &str) -> Result<Model, String> {
    let options = tobj::LoadOptions { triangulate: true, ..tobj::LoadOptions::default() };
    let no_materials = |_: &std::path::Path| Err(tobj::LoadError::OpenFileFailed);
    let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, no_materials)
        .map_err(|error| format!("not a usable OBJ file: {error}"))?;
    let mesh = models.into_iter().next().map(|model| model.mesh).unwrap_or_default();
    Ok(Model {
        positions: mesh.positions.as_chunks().0.iter().copied().map(Vec3::from_array).collect(),
        triangles: mesh.indices.as_chunks().0.to_vec(),
        normals: mesh.normals.as_chunks().0.iter().copied().map(Vec3::from_array).collect(),
        normal_indices: mesh.normal_indices.as_chunks().0.to_vec(),
        uvs: mesh.texcoords.as_chunks().0.iter().copied().map(Vec2::from_array).collect(),
        uv_indices: mesh.texcoord_indices.as_chunks().0.to_vec(),
        skipped: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: Attributes = Attributes { normals: true, uvs: true };
    const NONE: Attributes = Attributes { normals: false, uvs: false };
    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n";

    fn read(faces: &str, wanted: Attributes) -> Result<Model, String> {
        parse(format!("{SQUARE}{faces}").as_bytes(), wanted)
    }

    #[test]
    fn only_what_is_asked_for_is_kept() {
        let faces = "f 1/1/1 2/2/1 3/2/1";
        let bare = read(faces, NONE).unwrap();
        assert_eq!((bare.normals.capacity(), bare.normal_indices.capacity()), (0, 0));
        assert_eq!((bare.uvs.capacity(), bare.uv_indices.capacity()), (0, 0));
        let full = read(faces, ALL).unwrap();
        assert_eq!(full.face_normals().collect::<Vec<_>>(), [[Vec3::Z; 3]]);
        assert_eq!(full.face_uvs().collect::<Vec<_>>(), [[Vec2::ZERO, Vec2::ONE, Vec2::ONE]]);
    }

    #[test]
    fn polygons_become_fans() {
        let model = read("f 1 2 3 4", NONE).unwrap();
        assert_eq!(model.triangles, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(model.faces().len(), 2);
    }

    #[test]
    fn positions_are_shared_across_a_seam() {
        let model = read("f 1/1 2/1 3/1\nf 1/2 3/2 4/2", ALL).unwrap();
        assert_eq!((model.positions.len(), model.uvs.len()), (4, 2));
        assert_eq!(model.triangles, [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn negative_indices_count_back() {
        assert_eq!(
            read("f -4 -3 -2", NONE).unwrap().faces().next(),
            read("f 1 2 3", NONE).unwrap().faces().next()
        );
    }

    #[test]
    fn a_bad_face_is_left_out_and_told() {
        for (face, reason) in [
            ("f 1 2 5", "line 9: corner `5`: there is no vertex 5 among 4"),
            ("f 1 2 0", "line 9: corner `0`: there is no vertex 0 among 4"),
            ("f 1 2 -5", "line 9: corner `-5`: there is no vertex -5 among 4"),
            (
                "f 1 2 99999999999999999999",
                "line 9: corner `99999999999999999999`: `99999999999999999999` is not an index",
            ),
            ("f 1 2", "line 9: a face needs 3 corners, this has 2"),
            ("f", "line 9: a face needs 3 corners, this has 0"),
            ("f 1 2 x", "line 9: corner `x`: `x` is not an index"),
            ("f 1 2 /1", "line 9: `/1` is not a corner"),
            ("f 1 2 3/1/1/1", "line 9: `3/1/1/1` is not a corner"),
            ("f 1/1 2/1 3/9", "line 9: corner `3/9`: there is no texture coordinate 9 among 2"),
            ("f 1/1 2/1 3/-9", "line 9: corner `3/-9`: there is no texture coordinate -9 among 2"),
            ("f 1//1 2//1 3//0", "line 9: corner `3//0`: there is no normal 0 among 1"),
        ] {
            let model = read(&format!("f 1/1/1 2/1/1 3/1/1\n{face}\nf 1 2 x"), ALL).unwrap();
            assert_eq!(model.triangles.len(), 1, "{face}");
            assert_eq!(model.skipped(), Some(&Skipped { count: 2, of: 3, first: reason.into() }));
        }
    }

    #[test]
    fn a_coordinate_that_is_not_finite_spoils_its_faces_alone() {
        for bad in ["nan", "inf", "-inf", "1e999", "", "one"] {
            let model = read(&format!("v 0 0 {bad}\nf 1 2 3\nf 1 2 5"), NONE).unwrap();
            assert_eq!(model.triangles.len(), 1);
            assert_eq!(
                model.skipped().unwrap().first,
                "line 10: corner `5`: vertex 5 is not made of finite numbers"
            );
        }
    }

    #[test]
    fn what_was_not_asked_for_cannot_be_wrong() {
        let model = read("vn nan 0 0\nf 1/9/9 2/x/-7 3//0", NONE).unwrap();
        assert_eq!((model.triangles.len(), model.skipped()), (1, None));
    }

    #[test]
    fn an_attribute_that_one_face_lacks_is_absent() {
        let model = read("f 1/1/1 2/1/1 3/1/1\nf 1//1 2//1 3//1", ALL).unwrap();
        assert_eq!((model.face_uvs().len(), model.face_normals().len()), (0, 2));
    }

    #[test]
    fn without_a_good_face_there_is_no_model() {
        assert_eq!(read("", NONE).unwrap_err(), "there is no face in it; is it an OBJ file?");
        assert_eq!(
            read("f 1 2\nf 1 2 7", NONE).unwrap_err(),
            "none of its 2 faces can be used; the first, line 8: a face needs 3 corners, this has 2"
        );
    }

    #[test]
    fn the_rest_of_the_format_is_passed_over() {
        let text = "\u{feff}# caf\u{e9}\r\nmtllib none.mtl\r\no a\r\nv 0 0 0 1.0\r\nv 1 0 0 1 0 0\r\ng b\r\nv 0 1 0 # top\r\n\
                    usemtl m\r\ns 1\r\nl 1 2 3\r\np 1\r\nvp 1\r\n\tf 1 2 3\r\n";
        let mut bytes = text.as_bytes().to_vec();
        bytes.extend(b"# latin-1: \xe9\n");
        let model = parse(&bytes, NONE).unwrap();
        assert_eq!(model.faces().collect::<Vec<_>>(), [[Vec3::ZERO, Vec3::X, Vec3::Y]]);
    }
}
