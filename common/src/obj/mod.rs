//! Reads an OBJ file.
//!
//! By a reader of our own, as the crate for it (`tobj`) rounds coordinates to `f32` before anything can be
//! subtracted from them, knows no line numbers, refuses a whole file for one bad index, takes NaN for a number
//! and a polyline for a triangle, loses what stands behind a lone carriage return, and needs many times the
//! file's length in memory. Tests hold this reader against it.
//!
//! The file is gone through once. Elements may be named before they are there, so faces are kept as numbers and
//! looked at in the end; what is wrong with one is found out from its text, for the first one.

mod polygon;
mod words;

use glam::{DVec3, Vec2, Vec3};

use crate::model::{Attributes, Materials, Model, Skipped};
use crate::placement::Placement;
use crate::{Error, file, kind};
use polygon::{CORNER_LIMIT, Cutter};
use words::{line_number, shown};

pub(crate) use words::Words;

/// The longest file that is read, in bytes.
const FILE_LIMIT: u64 = 256 << 20;

/// The most memory that a model takes besides the file, in bytes, as [`Contents::memory`] counts it: some two
/// million triangles with all attributes, or six million without. A vector that grows is copied into one twice as
/// large, so that at most three times this is taken for a moment.
const MEMORY_LIMIT: usize = 512 << 20;

/// The most materials of a file that are kept in mind.
const MATERIAL_LIMIT: usize = 256;

/// The three lists of an OBJ file, in the order in which a face's corner names them: `position/uv/normal`.
const KINDS: [&str; 3] = ["vertex", "texture coordinate", "normal"];

/// What is wrong with an `l` line that is left out.
const BAD_LINE: &str = "a corner is missing or not finite";

/// The numbers of an element of each list: how many there may be, and how many there must.
const NUMBERS: [(&str, usize, usize); 3] = [("v", 3, 3), ("vt", 2, 1), ("vn", 3, 3)];

/// A corner's places in the three lists, counted from 1.
type Corner = [u32; 3];

/// The place of what is not named.
const NONE: u32 = 0;

/// The place of what cannot be there: before the first.
const NOWHERE: u32 = u32::MAX;

/// A face, or a polyline.
struct Element {
    /// Where its line begins, in bytes.
    offset: u32,
    /// Behind its last corner. None are kept of an element with a corner that is no corner.
    end: u32,
}

/// What is kept of a file while it is read.
#[derive(Default)]
struct Contents<'a> {
    /// NaN in one that is not made of finite numbers.
    positions: Vec<DVec3>,
    /// The same.
    uvs: Vec<Vec2>,
    /// 0, which is no direction either.
    normals: Vec<Vec3>,
    /// How many normals are not made of finite numbers, and where the first of them is.
    bad_normals: (usize, Option<usize>),
    faces: Vec<Element>,
    /// The faces' corners: their places in each list, where that is wanted.
    places: [Vec<u32>; 3],
    polylines: Vec<Element>,
    /// The polylines' corners: their places among the positions.
    bends: Vec<u32>,
    libraries: Vec<&'a [u8]>,
    materials: Vec<&'a [u8]>,
}

impl Model {
    /// Reads an OBJ file: positions, `l` elements, and what `wanted` asks for. A file of up to 256 MiB will do
    /// whose model takes no more than 512 MiB: two million triangles with all attributes, and more without.
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
        Self::parse_placed(&file::read_bytes(path, FILE_LIMIT)?, wanted, placement)
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
        // Whatever such a file says by chance, what it is explains it better.
        Contents::read(text, wanted)
            .and_then(|contents| contents.model(text, wanted, placement))
            .map_err(|reason| kind::told(text).unwrap_or(reason))
    }
}

impl<'a> Contents<'a> {
    fn read(bytes: &'a [u8], wanted: Attributes) -> Result<Self, String> {
        let mut contents = Self::default();
        let mut words = Words::new(bytes);
        let mut material = None;
        loop {
            let offset = words.offset();
            match words.word() {
                Some(b"v") => contents.positions.push(numbers(&mut words, 0).map_or(DVec3::NAN, DVec3::from)),
                Some(b"vt") if wanted.uvs => {
                    let uv = numbers(&mut words, 1).map(|[u, v, _]| Vec2::new(u as f32, v as f32));
                    contents.uvs.push(uv.unwrap_or(Vec2::NAN));
                }
                Some(b"vn") if wanted.normals => {
                    let normal = numbers(&mut words, 2).map(|normal| DVec3::from(normal).as_vec3());
                    if normal.is_none() {
                        let (count, first) = contents.bad_normals;
                        contents.bad_normals = (count + 1, first.or(Some(offset)));
                    }
                    contents.normals.push(normal.unwrap_or_default());
                }
                Some(b"f") => {
                    contents.face(&mut words, offset, wanted);
                    contents.materials.extend(material.take());
                }
                Some(b"l") => contents.polyline(&mut words, offset),
                Some(b"mtllib") if wanted.uvs => {
                    let name = words.rest();
                    let seen = name.is_empty() || contents.libraries.contains(&name);
                    if contents.libraries.len() < MATERIAL_LIMIT && !seen {
                        contents.libraries.push(name);
                    }
                }
                Some(b"usemtl") if wanted.uvs => {
                    let name = words.rest();
                    let seen =
                        contents.materials.len() >= MATERIAL_LIMIT || contents.materials.contains(&name);
                    material = Some(name).filter(|_| !seen);
                }
                _ => {}
            }
            if contents.memory() > MEMORY_LIMIT {
                let line = line_number(bytes, offset);
                let limit = MEMORY_LIMIT >> 20;
                return Err(format!("line {line}: up to here the model takes the {limit} MiB that it may"));
            }
            if !words.next_line() {
                return Ok(contents);
            }
        }
    }

    /// An upper bound of the bytes that these contents and the model made of them take together, with each
    /// element used: itself, its new place, and what it becomes. A face of n corners becomes n − 2 triangles.
    fn memory(&self) -> usize {
        let [positions, uvs, normals] = self.places.each_ref().map(Vec::len);
        self.positions.len() * (24 + 4 + 24 + 12)
            + self.uvs.len() * (8 + 4 + 8)
            + self.normals.len() * (12 + 4 + 12)
            + (positions + uvs + normals) * (4 + 12)
            + (self.faces.len() + self.polylines.len()) * 8
            + self.bends.len() * (4 + 8)
    }

    /// How many elements each list has.
    fn lengths(&self) -> [usize; 3] {
        [self.positions.len(), self.uvs.len(), self.normals.len()]
    }

    /// Keeps the face of a line.
    fn face(&mut self, words: &mut Words, offset: usize, wanted: Attributes) {
        let begin = self.places[0].len();
        let (lengths, used) = (self.lengths(), used(wanted));
        while let Some(word) = words.word() {
            match corner(word, used) {
                Ok(indices) => {
                    for kind in (0..3).filter(|&kind| used[kind]) {
                        self.places[kind].push(place(indices[kind], lengths[kind]));
                    }
                }
                Err(_) => {
                    self.places.iter_mut().for_each(|places| places.truncate(begin));
                    break;
                }
            }
        }
        self.faces.push(Element { offset: offset as u32, end: self.places[0].len() as u32 });
    }

    /// Keeps the polyline of a line.
    fn polyline(&mut self, words: &mut Words, offset: usize) {
        let begin = self.bends.len();
        while let Some(word) = words.word() {
            match corner(word, [true, false, false]) {
                Ok([index, ..]) => self.bends.push(place(index, self.positions.len())),
                Err(_) => {
                    self.bends.truncate(begin);
                    break;
                }
            }
        }
        self.polylines.push(Element { offset: offset as u32, end: self.bends.len() as u32 });
    }

    /// Whether a face's corners can be used: at least three, all there, and finite.
    fn is_good(&self, corners: &[Corner]) -> bool {
        corners.len() >= 3 && corners.iter().all(|corner| self.fault(corner).is_none())
    }

    /// The list in which a corner has a place that is not there or not finite.
    fn fault(&self, corner: &Corner) -> Option<usize> {
        let [position, uv, _] = corner.map(|place| (place as usize).wrapping_sub(1));
        let is_there = [
            self.positions.get(position).is_some_and(|position| position.is_finite()),
            corner[1] == NONE || self.uvs.get(uv).is_some_and(|uv| uv.is_finite()),
            corner[2] as usize <= self.normals.len(),
        ];
        is_there.iter().position(|there| !there)
    }

    /// Why a face cannot be used, with its line.
    fn why(&self, bytes: &[u8], face: &Element, corners: &[Corner], wanted: Attributes) -> String {
        let mut words = Words::at(bytes, face.offset as usize);
        words.word();
        let mut count = 0;
        let reason = loop {
            let Some(word) = words.word() else {
                break match count {
                    0..3 => format!("a face needs 3 corners, this has {count}"),
                    _ => {
                        format!("a face that is not convex may have {CORNER_LIMIT} corners, this has {count}")
                    }
                };
            };
            match corner(word, used(wanted)) {
                Err(reason) => break reason,
                Ok(indices) => {
                    if let Some(kind) = corners.get(count).and_then(|corner| self.fault(corner)) {
                        let index = indices[kind].unwrap_or_default();
                        break format!(
                            "corner `{}`: {}",
                            shown(word),
                            self.lack(bytes, corners[count][kind], kind, index)
                        );
                    }
                }
            }
            count += 1;
        };
        format!("line {}: {reason}", line_number(bytes, face.offset as usize))
    }

    /// What is wrong with the place of a list that an index names.
    fn lack(&self, bytes: &[u8], place: u32, kind: usize, index: i64) -> String {
        let (name, length) = (KINDS[kind], self.lengths()[kind]);
        if place as usize > length || place == NONE {
            return format!("there is no {name} {index} among {length}");
        }
        let mut words = Words::new(bytes);
        let mut left = place;
        loop {
            let offset = words.offset();
            if words.word() == Some(NUMBERS[kind].0.as_bytes()) {
                left -= 1;
                if left == 0 {
                    let line = line_number(bytes, offset);
                    return format!("{name} {index}, in line {line}: {}", no_numbers(&mut words, kind));
                }
            }
            if !words.next_line() {
                return format!("{name} {index} is not made of finite numbers");
            }
        }
    }

    /// The model of the good faces and lines.
    fn model(&self, bytes: &[u8], wanted: Attributes, placement: &Placement) -> Result<Model, String> {
        let mut building = Building::new(self, wanted);
        let mut cutter = Cutter::new();
        let mut skipped: Option<Skipped> = None;
        let (mut begin, mut corners, mut points) = (0, Vec::new(), Vec::new());
        for face in &self.faces {
            let end = face.end as usize;
            corners.clear();
            corners.extend(
                (begin..end)
                    .map(|n| self.places.each_ref().map(|places| places.get(n).copied().unwrap_or(NONE))),
            );
            begin = end;
            let good = self.is_good(&corners) && {
                points.clear();
                points.extend(corners.iter().map(|corner| self.positions[corner[0] as usize - 1]));
                let mut note = |triangle: [u32; 3]| building.triangle(triangle.map(|n| corners[n as usize]));
                cutter.cut(&points, &mut note).is_ok()
            };
            if good {
                building.note_lacks(&corners, face.offset);
            } else {
                let why = || self.why(bytes, face, &corners, wanted);
                let first = || Skipped { count: 0, of: self.faces.len(), first: why() };
                skipped.get_or_insert_with(first).count += 1;
            }
        }
        let lines_left_out = self.lines(&mut building);
        let Building { model, .. } = &building;
        if model.triangles.is_empty() && model.lines.is_empty() {
            return Err(match &skipped {
                None if lines_left_out > 0 => {
                    format!(
                        "none of its {lines_left_out} `l` lines can be used: {BAD_LINE}, and it has no faces"
                    )
                }
                None => "there is no face in it; is it an OBJ file?".into(),
                Some(Skipped { of, first, .. }) => {
                    format!("none of its {of} faces can be used; the first, {first}")
                }
            });
        }
        let mut remarks = Vec::new();
        if let (count, Some(offset)) = self.bad_normals {
            let mut words = Words::at(bytes, offset);
            words.word();
            let (line, reason) = (line_number(bytes, offset), no_numbers(&mut words, 2));
            let of = self.normals.len();
            remarks
                .push(format!("{count} of {of} normals have no direction; the first, line {line}: {reason}"));
        }
        if lines_left_out > 0 {
            let of = self.polylines.len();
            remarks.push(format!("left out {lines_left_out} of {of} `l` lines: {BAD_LINE}"));
        }
        let text =
            |names: &[&[u8]]| names.iter().map(|name| String::from_utf8_lossy(name).into_owned()).collect();
        let materials = Materials { libraries: text(&self.libraries), used: text(&self.materials) };
        Ok(Model { skipped, remarks, materials, ..building.finish(bytes, placement) })
    }

    /// Adds the good polylines; returns how many are not.
    fn lines(&self, building: &mut Building) -> usize {
        let (mut begin, mut left_out) = (0, 0);
        for polyline in &self.polylines {
            let bends = &self.bends[begin..polyline.end as usize];
            begin = polyline.end as usize;
            if bends.len() >= 2 && bends.iter().all(|&bend| self.fault(&[bend, NONE, NONE]).is_none()) {
                bends.windows(2).for_each(|pair| building.line([pair[0], pair[1]]));
            } else {
                left_out += 1;
            }
        }
        left_out
    }
}

/// A model to which triangles are added.
struct Building<'a> {
    contents: &'a Contents<'a>,
    /// Which lists are used, and no face lacks so far.
    used: [bool; 3],
    /// Where the first face begins that lacks something of a list.
    lacks: [Option<u32>; 3],
    /// The place in the model of each element of each list.
    renamed: [Vec<u32>; 3],
    /// The model's positions before they are placed.
    positions: Vec<DVec3>,
    model: Model,
}

impl<'a> Building<'a> {
    fn new(contents: &'a Contents, wanted: Attributes) -> Self {
        let used = used(wanted);
        let renamed =
            [0, 1, 2].map(|kind| vec![NOWHERE; if used[kind] { contents.lengths()[kind] } else { 0 }]);
        Self { contents, used, lacks: [None; 3], renamed, positions: Vec::new(), model: Model::default() }
    }

    /// The place in the model of an element of the file, which enters it with its first use.
    fn enter<T: Copy>(renamed: &mut [u32], place: u32, from: &[T], to: &mut Vec<T>) -> u32 {
        let at = place as usize - 1;
        if renamed[at] == NOWHERE {
            renamed[at] = to.len() as u32;
            to.push(from[at]);
        }
        renamed[at]
    }

    /// Adds a triangle. What it lacks is noted afterwards; until then it has the first element instead.
    fn triangle(&mut self, corners: [Corner; 3]) {
        let Self { contents, renamed: [positions, uvs, normals], model, .. } = self;
        model
            .triangles
            .push(corners.map(|c| Self::enter(positions, c[0], &contents.positions, &mut self.positions)));
        if self.used[1] && corners.iter().all(|c| c[1] != NONE) {
            model.uv_indices.push(corners.map(|c| Self::enter(uvs, c[1], &contents.uvs, &mut model.uvs)));
        }
        if self.used[2] && corners.iter().all(|c| c[2] != NONE) {
            model
                .normal_indices
                .push(corners.map(|c| Self::enter(normals, c[2], &contents.normals, &mut model.normals)));
        }
    }

    /// Notes what a good face lacks: the model is without it then.
    fn note_lacks(&mut self, corners: &[Corner], offset: u32) {
        for kind in [1, 2] {
            if self.used[kind] && corners.iter().any(|corner| corner[kind] == NONE) {
                self.used[kind] = false;
                self.lacks[kind] = Some(offset);
            }
        }
    }

    /// Adds a line between two positions.
    fn line(&mut self, ends: [u32; 2]) {
        let renamed = &mut self.renamed[0];
        let ends = ends.map(|end| Self::enter(renamed, end, &self.contents.positions, &mut self.positions));
        self.model.lines.push(ends);
    }

    fn finish(self, bytes: &[u8], placement: &Placement) -> Model {
        let Self { used, lacks, positions, mut model, .. } = self;
        let line = |offset: Option<u32>| offset.map(|offset| line_number(bytes, offset as usize));
        if !used[1] {
            (model.uvs, model.uv_indices, model.without_uvs) = (Vec::new(), Vec::new(), line(lacks[1]));
        }
        if !used[2] {
            (model.normals, model.normal_indices, model.without_normals) =
                (Vec::new(), Vec::new(), line(lacks[2]));
        }
        model.place(&positions, placement);
        model
    }
}

/// Which of the three lists are used.
fn used(wanted: Attributes) -> [bool; 3] {
    [true, wanted.uvs, wanted.normals]
}

/// The numbers of an element of a list, the last ones 0 if they may be left out; `None` unless all are finite,
/// as `f32` too.
fn numbers(words: &mut Words, kind: usize) -> Option<[f64; 3]> {
    let (_, most, least) = NUMBERS[kind];
    let mut numbers = [0.0; 3];
    for (n, number) in numbers[..most].iter_mut().enumerate() {
        *number = match words.word() {
            Some(word) => text(word)?.parse().ok()?,
            None if n >= least => 0.0,
            None => return None,
        };
        if !(*number as f32).is_finite() {
            return None;
        }
    }
    Some(numbers)
}

/// What is wrong with the numbers of an element of a list.
fn no_numbers(words: &mut Words, kind: usize) -> String {
    let (_, most, least) = NUMBERS[kind];
    for n in 0..most {
        let Some(word) = words.word() else {
            return format!("it needs {least} numbers and has {n}");
        };
        let number = text(word).and_then(|word| word.parse::<f64>().ok());
        let shown = shown(word);
        match number {
            Some(number) if (number as f32).is_finite() => {}
            Some(number) if number.is_finite() => return format!("`{shown}` is too large"),
            Some(_) => return format!("`{shown}` is not finite"),
            None if word.contains(&b',') => {
                return format!(
                    "`{shown}` has a comma: write a point in a number, and a blank between numbers"
                );
            }
            None if has_exponent_with_d(word) => {
                return format!("`{shown}` is not a number: an exponent is written with an E");
            }
            None => return format!("`{shown}` is not a number"),
        }
    }
    "it is not made of finite numbers".into()
}

/// Whether a word is a number as Fortran writes it, `1.0D-01`.
fn has_exponent_with_d(word: &[u8]) -> bool {
    text(word).is_some_and(|word| word.replace(['D', 'd'], "e").parse::<f64>().is_ok())
}

/// A word that is text, as all numbers are.
fn text(word: &[u8]) -> Option<&str> {
    std::str::from_utf8(word).ok()
}

/// The indices that a corner such as `3`, `3/1`, `3//2` or `-1/-1/-1` names in the lists that are used. Of the
/// others, nothing is looked at.
fn corner(word: &[u8], used: [bool; 3]) -> Result<[Option<i64>; 3], String> {
    let mut indices = [None; 3];
    let mut parts = word.split(|&byte| byte == b'/');
    if word.starts_with(b"/") || parts.clone().count() > 3 {
        return Err(format!("`{}` is not a corner", shown(word)));
    }
    for (index, used) in indices.iter_mut().zip(used) {
        let Some(part) = parts.next() else { break };
        if used && !part.is_empty() {
            let number = text(part).and_then(|part| part.parse().ok());
            let cure = if part.contains(&b',') { ": write blanks between corners, and no comma" } else { "" };
            let no_index = || format!("corner `{}`: `{}` is not an index{cure}", shown(word), shown(part));
            *index = Some(number.ok_or_else(no_index)?);
        }
    }
    Ok(indices)
}

/// The place in a list of that length so far that an index names: a negative one counts back from its end.
fn place(index: Option<i64>, length: usize) -> u32 {
    let place = match index {
        None => return NONE,
        Some(index) if index < 0 => index.saturating_add(length as i64 + 1),
        Some(index) => index,
    };
    u32::try_from(place).ok().filter(|&place| place != NONE).unwrap_or(NOWHERE)
}

#[cfg(test)]
mod tests {
    use super::*;
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
