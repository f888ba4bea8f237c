//! Reads an OBJ file.
//!
//! By a reader of our own, as the crate for it (`tobj`) rounds coordinates to `f32` before anything can be
//! subtracted from them, knows no line numbers, refuses a whole file for one bad index, takes NaN for a number
//! and a polyline for a triangle, loses what stands behind a lone carriage return, and needs many times the
//! file's length in memory. Tests hold this reader against it.
//!
//! The file is gone through once. Elements may be named before they are there, so faces are kept as numbers and
//! looked at in the end; what is wrong with one is found out from its text, for the first one.

mod building;
mod contents;
mod counts;
mod elements;
mod faults;
mod polygon;
mod stage;
mod text;
mod words;

use crate::model::{Attributes, Model};
use crate::placement::Placement;
use crate::{Error, kind, memory};
use contents::Contents;
use counts::Counts;
use stage::Stage;

pub(crate) use words::Words;

/// What share of the time each stage takes, about: the text is read, counted, understood, and made a model.
const STAGES: [[f64; 2]; 4] = [[0.0, 0.1], [0.1, 0.3], [0.3, 0.85], [0.85, 1.0]];

impl Model {
    /// Reads an OBJ file: positions, `l` elements, and what `wanted` asks for.
    ///
    /// Its text and what is made of it may take half of the memory that is free, and the text 4 GiB; where the system
    /// does not say what is free, it is taken to be 4 GiB. All is counted before anything is allocated for it. With all
    /// attributes a triangle takes 80 bytes, and a position with a normal and texture coordinates 112; without, 32 and
    /// 64. A million triangles of half as many positions take 136 MB and the text. Of a pipe, 256 MiB are read.
    ///
    /// Faces of more than three corners are cut into triangles in their own plane, convex or not. A face is left
    /// out and counted in [`skipped`](Self::skipped) if it has fewer than three corners, a corner that does not
    /// exist or is not finite, or more than 4,096 corners without being convex. Normals or texture coordinates
    /// that any good face lacks are absent from the whole model. A normal that is not finite is 0.
    ///
    /// # Errors
    /// One that names the file where it cannot be read, is too large, or holds no good face and no line.
    pub fn read(path: &std::path::Path, wanted: Attributes) -> Result<Self, Error> {
        Self::read_placed(path, wanted, &Placement::default())
    }

    /// As [`read`](Self::read), somewhere else: coordinates are placed in f64, and only then become `f32`.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_placed(
        path: &std::path::Path,
        wanted: Attributes,
        placement: &Placement,
    ) -> Result<Self, Error> {
        Self::read_watched(path, wanted, placement, &mut |_| ())
    }

    /// As [`read_placed`](Self::read_placed). `watch` is called some hundred times with the share of the work that is
    /// done, about, from 0 to 1.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_watched(
        path: &std::path::Path,
        wanted: Attributes,
        placement: &Placement,
        watch: &mut dyn FnMut(f64),
    ) -> Result<Self, Error> {
        let memory = memory::half();
        let text = text::read(path, memory, watch, STAGES[0])?;
        Self::parse_within(&text, wanted, placement, memory, watch)
            .map_err(|reason| Error::Model { path: path.into(), reason })
    }

    /// The model in the text of an OBJ file; see [`read`](Self::read).
    ///
    /// # Errors
    /// A line that says why there is no good face.
    pub fn parse(text: &[u8], wanted: Attributes) -> Result<Self, String> {
        Self::parse_placed(text, wanted, &Placement::default())
    }

    /// As [`parse`](Self::parse), somewhere else; see [`read_placed`](Self::read_placed).
    ///
    /// # Errors
    /// As [`parse`](Self::parse).
    pub fn parse_placed(text: &[u8], wanted: Attributes, placement: &Placement) -> Result<Self, String> {
        Self::parse_within(text, wanted, placement, memory::half(), &mut |_| ())
    }

    /// The model in a text that takes no more than so many bytes of memory, together with the text.
    fn parse_within(
        text: &[u8],
        wanted: Attributes,
        placement: &Placement,
        memory: u64,
        watch: &mut dyn FnMut(f64),
    ) -> Result<Self, String> {
        let counts = Counts::of(text, wanted, &mut Stage::new(watch, STAGES[1], text.len()));
        let needed = text.len() as u64 + counts.memory(wanted);
        let model = if needed > memory {
            let Counts { faces, elements: [vertices, ..], .. } = counts;
            let [needed, memory] = [needed.div_ceil(1 << 20), memory >> 20];
            Err(format!(
                "its {faces} faces and {vertices} vertices take {needed} MiB, more than the {memory} MiB that are half of the free memory: {}",
                text::CURE
            ))
        } else {
            let contents =
                Contents::read(text, counts, wanted, &mut Stage::new(watch, STAGES[2], text.len()));
            contents.model(text, wanted, placement, &mut Stage::new(watch, STAGES[3], counts.faces))
        };
        // Whatever such a file says by chance, what it is explains it better.
        model.map_err(|reason| kind::told(text).unwrap_or(reason))
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, Vec2, Vec3};

    use super::*;
    use crate::model::{Materials, Skipped};
    use crate::placement::Up;

    const ALL: Attributes = Attributes { normals: true, uvs: true };
    const NONE: Attributes = Attributes { normals: false, uvs: false };
    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n";

    fn fitted(up: Up) -> Placement {
        Placement { fit: Some(up), ..Placement::default() }
    }

    fn read(faces: &str, wanted: Attributes) -> Result<Model, String> {
        Model::parse(format!("{SQUARE}{faces}").as_bytes(), wanted)
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
            (
                "f 1, 2, 3",
                "line 9: corner `1,`: `1,` is not an index: write blanks between corners, and no comma",
            ),
            (
                "f 1,2,3",
                "line 9: corner `1,2,3`: `1,2,3` is not an index: write blanks between corners, and no comma",
            ),
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
            (&"𝄞".repeat(21), &("𝄞".repeat(20) + "...")),
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
        let model = Model::parse(text.as_bytes(), NONE).unwrap();
        assert_eq!(model.faces().collect::<Vec<_>>(), [[Vec3::ZERO, Vec3::X, Vec3::Y]]);
        let first = "line 10: corner `7`: there is no vertex 7 among 3";
        assert_eq!(model.skipped().unwrap().first, first);
        for text in ["\\", "f \\", "f 1 2 3 \\\n", "\\\n\\\r\n\\"] {
            assert!(Model::parse(text.as_bytes(), NONE).is_err());
        }
    }

    #[test]
    fn a_coordinate_that_is_not_finite_spoils_its_faces_alone() {
        let comma = "has a comma: write a point in a number, and a blank between numbers";
        for (bad, told) in [
            ("0 0 nan", "`nan` is not finite"),
            ("0 inf 0", "`inf` is not finite"),
            ("-inf 0 0", "`-inf` is not finite"),
            ("0 0 1e999", "`1e999` is not finite"),
            ("0 0 1e39", "`1e39` is too large"),
            ("0 0", "it needs 3 numbers and has 2"),
            ("", "it needs 3 numbers and has 0"),
            ("0 0 one", "`one` is not a number"),
            ("0,8 0,8 0", &format!("`0,8` {comma}")),
            ("0.8, 0.8, 0", &format!("`0.8,` {comma}")),
            ("1.0D-01 0 0", "`1.0D-01` is not a number: an exponent is written with an E"),
            ("0 0 \u{661}", "`\u{661}` is not a number"),
            // As C libraries of Windows write what is not finite.
            ("-nan(ind) 0 0", "`-nan(ind)` is not a number"),
            ("1.#QNAN 0 0", "`1.#QNAN` is not a number"),
            ("0 0 -1.#IND", "`-1.#IND` is not a number"),
            ("1.#INF00e+000 0 0", "`1.#INF00e+000` is not a number"),
        ] {
            let model = read(&format!("v {bad}\nf 1 2 3\nf 1 2 5"), NONE).unwrap();
            assert_eq!(model.triangles.len(), 1);
            let first = format!("line 10: corner `5`: vertex 5, in line 8: {told}");
            assert_eq!(model.skipped().unwrap().first, first);
        }
        let model = read("vt 0,5 0\nf 1/1 2/1 3/1\nf 1/1 2/1 3/3", ALL).unwrap();
        let first = format!("line 10: corner `3/3`: texture coordinate 3, in line 8: `0,5` {comma}");
        assert_eq!(model.skipped().unwrap().first, first);
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

    /// The second number of a texture coordinate may be left out, and so may a third.
    #[test]
    fn a_texture_coordinate_has_one_number_or_more() {
        let model = read("vt 0.5\nvt .5 1. 9\nf 1/3 2/4 3/4", ALL).unwrap();
        assert_eq!(
            model.face_uvs().next(),
            Some([Vec2::new(0.5, 0.0), Vec2::new(0.5, 1.0), Vec2::new(0.5, 1.0)])
        );
    }

    /// A normal that is not finite has no direction, as one of length 0 has none: the face is drawn all the same.
    #[test]
    fn a_normal_that_is_not_finite_is_0() {
        for (bad, told) in [
            ("nan 0 0", "`nan` is not finite"),
            ("0 0 1,", "`1,` has a comma: write a point in a number, and a blank between numbers"),
            ("0 0", "it needs 3 numbers and has 2"),
        ] {
            let model = read(&format!("vn {bad}\nf 1//1 2//2 3//1"), ALL).unwrap();
            assert_eq!(model.face_normals().next(), Some([Vec3::Z, Vec3::ZERO, Vec3::Z]));
            assert_eq!(model.skipped(), None);
            let remark = format!("1 of 2 normals have no direction; the first, line 8: {told}");
            assert_eq!(model.remarks(), [remark]);
        }
    }

    #[test]
    fn the_first_face_that_lacks_an_attribute_is_known() {
        let model = read("f 1/1/1 2/1/1 3/1/1\n\nf 1 2/1 3/1\nf 1//1 2//1 3//1\nf 1 2 9", ALL).unwrap();
        assert_eq!((model.without_uvs(), model.without_normals()), (Some(10), Some(10)));
        let model = read("f 1/1/1 2/1/1 3/1/1", ALL).unwrap();
        assert_eq!((model.without_uvs(), model.without_normals()), (None, None));
    }

    #[test]
    fn a_file_of_lines_alone_is_a_model_without_faces() {
        let model = read("l 1 2/1 -1\nl 4 9\nl 4\nl 4 x", NONE).unwrap();
        assert_eq!(model.lines(), [[0, 1], [1, 2]]);
        assert_eq!(model.positions(), [Vec3::ZERO, Vec3::X, Vec3::Y]);
        assert_eq!(model.faces().len(), 0);
        assert_eq!(model.remarks(), ["left out 3 of 4 `l` lines: a corner is missing or not finite"]);
        assert_eq!(
            read("l 1 9\nl 4", NONE).unwrap_err(),
            "none of its 2 `l` lines can be used: a corner is missing or not finite, and it has no faces"
        );
    }

    #[test]
    fn a_model_knows_its_materials() {
        let text = "mtllib \nmtllib a b.mtl\nmtllib c.mtl # c\nmtllib c.mtl\nusemtl unused\nusemtl  red \nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl red\nf 1 2 3";
        let model = read(text, ALL).unwrap();
        assert_eq!(model.materials().libraries, ["a b.mtl", "c.mtl"]);
        assert_eq!(model.materials().used, ["red", "blue"]);
        assert_eq!(read(text, NONE).unwrap().materials(), &Materials::default());
    }

    /// Whatever ends a line, no half of a square is lost.
    #[test]
    fn every_line_end_ends_a_line() {
        for text in
            ["f 1 2 3\n# second half\rf 1 3 4", "f 1 2 3\rf 1 3 4\r", "f 1 2 3\r\nf 1 3 4", "f 1 2 3 \\ \n4"]
        {
            assert_eq!(read(text, NONE).unwrap().triangles, [[0, 1, 2], [0, 2, 3]], "{text:?}");
        }
        assert_eq!(read("f\\\n1 2 3", NONE).unwrap().triangles.len(), 1);
    }

    #[test]
    fn what_is_no_model_is_told_by_what_it_is() {
        let wide: Vec<u8> = "v 0 0 0\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
        for (bytes, told) in [
            (&b"\xff\xfev\0 \0"[..], "it is text in UTF-16: save it as UTF-8"),
            (&wide, "it is text in UTF-16: save it as UTF-8"),
            (b"\x1f\x8b\x08\0", "it is compressed by gzip: unpack it first"),
            (b"\n<!DOCTYPE html>\n<html>", "it is a page in HTML: download the file itself"),
            (b"<HTML lang=en>\nf 1 2 3\n", "it is a page in HTML: download the file itself"),
            (
                b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
                "it is a pointer of Git LFS, which stands for the file: `git lfs pull` fetches it",
            ),
            (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "it is a PNG picture, whose name ends in .png"),
            (b"\xff\xd8\xff\xe0\0\x10JFIF", "it is a JPEG picture: convert it to PNG"),
            (b"ply\nformat ascii 1.0\n", "it is a PLY model: export it as OBJ"),
        ] {
            assert_eq!(Model::parse(bytes, NONE).unwrap_err(), told);
        }
        assert_eq!(
            Model::parse(b"BM\nv 0 0 0\nf 1 1 1\n", NONE).unwrap().faces().len(),
            1,
            "a model all the same"
        );
    }

    /// Besides the text, a position and a face of three corners take 64 + 32 + 36 · 3 bytes.
    #[test]
    fn a_model_may_take_as_much_memory_as_there_is() {
        let text = format!("v 0 0 0\nf 1 1 1\n#{}", "x".repeat(2 << 20));
        let placement = Placement::default();
        let parse = |memory| Model::parse_within(text.as_bytes(), NONE, &placement, memory, &mut |_| ());
        let needed = text.len() as u64 + 64 + 32 + 36 * 3;
        assert_eq!(parse(needed).unwrap().triangles.len(), 1);
        assert_eq!(
            parse(needed - 1).unwrap_err(),
            "its 1 faces and 1 vertices take 3 MiB, more than the 2 MiB that are half of the free memory: \
             close other programs, or draw a model of fewer faces"
        );
    }

    #[test]
    fn how_far_reading_has_come_is_told_from_the_first_byte_to_the_last_face() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.obj");
        std::fs::write(&path, [SQUARE, &"f 1 2 3\n".repeat(200_000)].concat()).unwrap();
        let mut told = Vec::new();
        Model::read_watched(&path, NONE, &Placement::default(), &mut |share| told.push(share)).unwrap();
        assert!(told.is_sorted() && told[0] > 0.0 && (200..400).contains(&told.len()), "{told:?}");
        assert!((0.99..=1.0).contains(told.last().unwrap()), "{told:?}");
        for [begin, end] in STAGES {
            assert!(told.iter().any(|share| (begin..=end).contains(share)), "{begin} to {end}");
        }
    }

    /// A unit cube where surveyors have it: about its own corner, no digit of the file is lost.
    #[test]
    fn coordinates_are_placed_before_they_are_rounded() {
        let text = "v 500000.37 4649776.81 212.4\nv 500001.37 4649776.81 212.4\nv 500001.37 4649777.81 213.4\nf 1 2 3";
        let corner = DVec3::new(500_000.37, 4_649_776.81, 212.4);
        let near =
            Model::parse_placed(text.as_bytes(), NONE, &Placement { origin: corner, ..Placement::default() })
                .unwrap();
        for (got, expected) in near.positions().iter().zip([Vec3::ZERO, Vec3::X, Vec3::ONE]) {
            assert!((*got - expected).length() < 1e-8, "{got}");
        }
        // An f32 is every half there: about this point, its roundings show.
        let shift = DVec3::new(0.1, 0.2, 0.3);
        let origin = corner + shift;
        let near = Model::parse_placed(text.as_bytes(), NONE, &Placement { origin, ..Placement::default() })
            .unwrap();
        assert!((near.positions()[0].as_dvec3() + shift).length() < 1e-7, "{}", near.positions()[0]);
        let far = Model::parse(text.as_bytes(), NONE).unwrap();
        assert_eq!(far.positions()[0], corner.as_vec3());
        assert_eq!(far.reach(), 4_649_778.0);
        let fitted = Model::parse_placed(text.as_bytes(), NONE, &fitted(Up::Y)).unwrap();
        let half = 0.8f32.sqrt() / 3f32.sqrt();
        for (got, expected) in fitted.positions().iter().zip([[-1.0; 3], [1.0, -1.0, -1.0], [1.0; 3]]) {
            assert!((*got - half * Vec3::from(expected)).length() < 1e-7, "{got}");
        }
    }

    /// Millimetres and what is a thousandth large alike come into view; what is up in the file is up.
    #[test]
    fn any_size_is_fitted() {
        for scale in [1e-30, 1e-3, 1.0, 1e3, 1e30] {
            let text = format!("v {0} 0 0\nv 0 {0} 0\nv 0 0 {0}\nvn 0 0 1\nf 1//1 2//1 3//1", 2.0 * scale);
            for (up, top, normal) in [(Up::Y, Vec3::Y, Vec3::Z), (Up::Z, Vec3::NEG_Z, Vec3::Y)] {
                let model = Model::parse_placed(text.as_bytes(), ALL, &fitted(up)).unwrap();
                let fit = *model.fit().unwrap();
                let middle = model.positions().iter().sum::<Vec3>() / 3.0;
                assert!((model.positions()[1] - middle).dot(top) > 0.5, "{scale} {up:?}");
                assert!(model.positions().iter().all(|p| p.length() <= 0.8944272), "{scale}");
                assert!(model.positions().iter().any(|p| p.length() > 0.894427), "{scale}");
                assert_eq!(model.face_normals().next(), Some([normal; 3]));
                assert!((fit.size / (2.0 * scale) - DVec3::ONE).length() < 1e-6, "{scale}");
            }
        }
        let point = Model::parse_placed(b"v 7 8 9\nf 1 1 1", NONE, &fitted(Up::Y)).unwrap();
        assert_eq!(point.positions(), [Vec3::ZERO]);
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
        let model = Model::parse(&bytes, NONE).unwrap();
        assert_eq!(model.faces().collect::<Vec<_>>(), [[Vec3::ZERO, Vec3::X, Vec3::Y]]);
    }
}
