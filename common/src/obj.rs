//! Reads an OBJ file with `tobj`, behind a check of every face.
//!
//! `tobj` refuses a whole file for one bad index, accepts NaN, takes a line element for a triangle and
//! follows material files that can make it panic. So each face is checked here first, its corners are
//! written out as positive indices of just what was asked for, and `tobj` reads that: it parses the
//! numbers, shares the corners and cuts polygons into triangles.
//!
//! The text is gone through three times, for the lists, the faces and the writing, so that little has to be
//! kept of it: a byte for each element of a list, four for each index of a corner.

use std::fmt::Write;

use glam::{Vec2, Vec3};

use crate::model::{Attributes, Model, Skipped};

/// The longest file that is read, in bytes: some 350,000 triangles with all attributes. While it is read, it
/// takes up to 20 times its length in memory, and the worst of files 45 times, most of that in `tobj`.
pub(crate) const FILE_LIMIT: u64 = 32 << 20;

/// The three lists of an OBJ file, in the order in which a face's corner names them: `position/uv/normal`.
const KINDS: [(&str, &str, usize); 3] =
    [("v", "vertex", 3), ("vt", "texture coordinate", 2), ("vn", "normal", 3)];

/// One list: for each element whether all of its numbers are there and finite.
type List = Vec<bool>;

/// A face's line, with how long each list is there: a negative index counts back from that.
struct Face<'a> {
    line: usize,
    corners: &'a str,
    lengths: [usize; 3],
}

/// A corner's places in the three lists, counted from 1; 0 where none is given or the list is not used.
type Corner = [u32; 3];

/// The good faces.
#[derive(Default)]
struct Faces {
    /// How many corners each has.
    sizes: Vec<u32>,
    /// All corners' places in each list; nothing for a list that is not used.
    places: [Vec<u32>; 3],
}

/// See [`Model::read`].
pub(crate) fn parse(bytes: &[u8], wanted: Attributes) -> Result<Model, String> {
    // Only names and comments may hold other than ASCII, and neither is used: any encoding will do.
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}');
    let mut use_kind = [true, wanted.uvs, wanted.normals];
    let lists = scan(text, use_kind);
    let (mut faces, skipped) = check_faces(text, &lists, use_kind);
    match &skipped {
        None if faces.sizes.is_empty() => return Err("there is no face in it; is it an OBJ file?".into()),
        Some(Skipped { of, first, .. }) if faces.sizes.is_empty() => {
            return Err(format!("none of its {of} faces can be used; the first, {first}"));
        }
        _ => {}
    }
    for kind in [1, 2] {
        use_kind[kind] &= !faces.places[kind].contains(&0);
        if !use_kind[kind] {
            faces.places[kind] = Vec::new();
        }
    }
    let checked = rewrite(text, &lists, faces, use_kind);
    drop(lists);
    Ok(Model { skipped, ..triangulate(&checked)? })
}

/// The lines of the text, each with its number. One that ends in a backslash goes on in the next.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let (mut rest, mut next) = (text, 1);
    std::iter::from_fn(move || {
        let goes_on = |at: usize| rest[..at].trim_end_matches('\r').ends_with('\\');
        let end = rest.match_indices('\n').map(|(at, _)| at).find(|&at| !goes_on(at));
        let (line, after) = rest.split_at(end.map_or(rest.len(), |at| at + 1));
        let number = next;
        (rest, next) = (after, next + line.matches('\n').count());
        (!line.is_empty()).then_some((number, line))
    })
}

/// A line's keyword, and what stands behind it.
fn keyword(line: &str) -> (&str, &str) {
    let line = line.split('#').next().unwrap_or_default().trim();
    line.split_once(char::is_whitespace).unwrap_or((line, ""))
}

/// The words of a line, without the backslashes that join lines.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split_whitespace().map(|word| word.trim_end_matches('\\')).filter(|word| !word.is_empty())
}

/// The list to which a keyword adds.
fn kind_of(keyword: &str) -> Option<usize> {
    KINDS.iter().position(|kind| kind.0 == keyword)
}

/// The lists that are used; of the others, nothing.
fn scan(text: &str, use_kind: [bool; 3]) -> [List; 3] {
    let mut lists = [const { Vec::new() }; 3];
    for (keyword, numbers) in lines(text).map(|(_, line)| keyword(line)) {
        if let Some(kind) = kind_of(keyword).filter(|&kind| use_kind[kind]) {
            lists[kind].push(are_finite(numbers, KINDS[kind].2));
        }
    }
    lists
}

/// Whether the text begins with `count` numbers that are finite as `f32`.
fn are_finite(text: &str, count: usize) -> bool {
    let finite = |word: &&str| word.parse::<f32>().is_ok_and(f32::is_finite);
    words(text).take(count).filter(finite).count() == count
}

/// The faces that can be used, and what is to be told of the others.
fn check_faces(text: &str, lists: &[List; 3], use_kind: [bool; 3]) -> (Faces, Option<Skipped>) {
    let mut faces = Faces::default();
    let mut skipped: Option<Skipped> = None;
    let (mut lengths, mut of) = ([0; 3], 0);
    for (line, (keyword, corners)) in lines(text).map(|(number, line)| (number, keyword(line))) {
        if let Some(kind) = kind_of(keyword) {
            lengths[kind] += 1;
        } else if keyword == "f" {
            of += 1;
            match check(&Face { line, corners, lengths }, lists, use_kind) {
                Ok(corners) => {
                    faces.sizes.push(corners.len() as u32);
                    for kind in (0..3).filter(|&kind| use_kind[kind]) {
                        faces.places[kind].extend(corners.iter().map(|corner| corner[kind]));
                    }
                }
                Err(first) => skipped.get_or_insert(Skipped { count: 0, of: 0, first }).count += 1,
            }
        }
    }
    (faces, skipped.map(|skipped| Skipped { of, ..skipped }))
}

/// The corners of a face, or why it cannot be used. Of the lists that are not used nothing is checked.
fn check(face: &Face, lists: &[List; 3], use_kind: [bool; 3]) -> Result<Vec<Corner>, String> {
    let corners: Result<Vec<Corner>, String> =
        words(face.corners).map(|word| check_corner(word, face, lists, use_kind)).collect();
    match corners {
        Ok(corners) if corners.len() < 3 => {
            Err(format!("a face needs 3 corners, this has {}", corners.len()))
        }
        checked => checked,
    }
    .map_err(|reason| format!("line {}: {reason}", face.line))
}

/// The places that a corner such as `3`, `3/1`, `3//2` or `-1/-1/-1` names.
fn check_corner(word: &str, face: &Face, lists: &[List; 3], use_kind: [bool; 3]) -> Result<Corner, String> {
    let name_it = || format!("corner `{}`", shown(word));
    let mut corner = [0; 3];
    let parts: Vec<&str> = word.split('/').collect();
    if parts.len() > 3 || parts[0].is_empty() {
        return Err(format!("`{}` is not a corner", shown(word)));
    }
    for (kind, part) in parts.iter().enumerate() {
        if part.is_empty() || !use_kind[kind] {
            continue;
        }
        let (_, name, _) = KINDS[kind];
        let index: i64 =
            part.parse().map_err(|_| format!("{}: `{}` is not an index", name_it(), shown(part)))?;
        let place = if index < 0 { index.saturating_add(face.lengths[kind] as i64 + 1) } else { index };
        let list = &lists[kind];
        let at = usize::try_from(place).ok().filter(|&at| 1 <= at && at <= list.len());
        let at =
            at.ok_or_else(|| format!("{}: there is no {name} {index} among {}", name_it(), list.len()))?;
        if !list[at - 1] {
            return Err(format!("{}: {name} {index} is not made of finite numbers", name_it()));
        }
        corner[kind] = at as u32;
    }
    Ok(corner)
}

/// A word of the file as it can be shown in a line: what would not print is escaped, and it is cut short.
fn shown(word: &str) -> String {
    const LONGEST: usize = 20;
    let cut = if word.chars().nth(LONGEST).is_some() { "..." } else { "" };
    word.chars().take(LONGEST).flat_map(char::escape_debug).chain(cut.chars()).collect()
}

/// The good faces, and the lists that they use, as an OBJ text that says nothing else.
fn rewrite(text: &str, lists: &[List; 3], faces: Faces, use_kind: [bool; 3]) -> String {
    let mut checked = String::new();
    let mut finite = lists.each_ref().map(|list| list.iter());
    for (keyword, numbers) in lines(text).map(|(_, line)| keyword(line)) {
        if let Some(kind) = kind_of(keyword).filter(|&kind| use_kind[kind]) {
            // A bad element keeps its place, so that the others keep theirs; no good face names it.
            let numbers = if finite[kind].next() == Some(&true) { numbers } else { "0 0 0" };
            checked.push_str(keyword);
            words(numbers).take(KINDS[kind].2).for_each(|number| checked.extend([" ", number]));
            checked.push('\n');
        }
    }
    let mut at = 0;
    for size in faces.sizes {
        checked.push('f');
        for corner in at..at + size as usize {
            // Writing to a string cannot fail.
            let [position, uv, normal] = faces.places.each_ref().map(|places| places.get(corner));
            let _ = match (position, uv, normal) {
                (Some(v), None, None) => write!(checked, " {v}"),
                (Some(v), Some(vt), None) => write!(checked, " {v}/{vt}"),
                (Some(v), None, Some(vn)) => write!(checked, " {v}//{vn}"),
                (Some(v), Some(vt), Some(vn)) => write!(checked, " {v}/{vt}/{vn}"),
                (None, ..) => Ok(()),
            };
        }
        checked.push('\n');
        at += size as usize;
    }
    checked
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
    fn what_a_file_says_is_shown_short_and_in_print() {
        for (word, shown) in [
            ("\u{1b}[31mred", r"\u{1b}[31mred"),
            ("\u{202e}a\u{7}", r"\u{202e}a\u{7}"),
            ("12345678901234567890", "12345678901234567890"),
            ("123456789012345678901", "12345678901234567890..."),
            ("\u{fffd}\u{0}", "\u{fffd}\\0"),
        ] {
            let error = read(&format!("f 1 2 {word}"), NONE).unwrap_err();
            assert!(error.ends_with(&format!("corner `{shown}`: `{shown}` is not an index")), "{error}");
            let error = read(&format!("f 1 2 /{word}"), NONE).unwrap_err();
            assert!(error.ends_with(" is not a corner") && !error.contains(char::is_control), "{error}");
        }
    }

    #[test]
    fn a_backslash_joins_lines() {
        let text = "v 0 0 \\\n0\nv 1\\\r\n0 0\nv 0 1 0 # a comment \\\nv 9 9 9\nf 1 \\\n\\\n2 3\nf 1 2 7";
        let model = parse(text.as_bytes(), NONE).unwrap();
        assert_eq!(model.faces().collect::<Vec<_>>(), [[Vec3::ZERO, Vec3::X, Vec3::Y]]);
        let first = "line 10: corner `7`: there is no vertex 7 among 3";
        assert_eq!(model.skipped().unwrap().first, first);
        for text in ["\\", "f \\", "f 1 2 3 \\\n", "\\\n\\\r\n\\"] {
            assert!(parse(text.as_bytes(), NONE).is_err());
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
