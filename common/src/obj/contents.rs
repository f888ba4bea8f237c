//! What an OBJ file holds, and the model that it makes.

use glam::{DVec3, Vec2, Vec3};

use super::building::Building;
use super::elements::{Corner, NONE, corner, no_numbers, numbers, place, used};
use super::polygon::Cutter;
use super::words::{Words, line_number};
use crate::model::{Attributes, Materials, Model, Skipped};
use crate::placement::Placement;

/// The most memory that a model takes besides the file, in bytes, as [`Contents::memory`] counts it: some two
/// million triangles with all attributes, or six million without. A vector that grows is copied into one twice as
/// large, so that at most three times this is taken for a moment.
const MEMORY_LIMIT: usize = 512 << 20;

/// The most materials of a file that are kept in mind.
const MATERIAL_LIMIT: usize = 256;

/// What is wrong with an `l` line that is left out.
const BAD_LINE: &str = "a corner is missing or not finite";

/// A face, or a polyline.
pub(super) struct Element {
    /// Where its line begins, in bytes.
    pub(super) offset: u32,
    /// Behind its last corner. None are kept of an element with a corner that is no corner.
    pub(super) end: u32,
}

/// What is kept of a file while it is read.
#[derive(Default)]
pub(super) struct Contents<'a> {
    /// NaN in one that is not made of finite numbers.
    pub(super) positions: Vec<DVec3>,
    /// The same.
    pub(super) uvs: Vec<Vec2>,
    /// 0, which is no direction either.
    pub(super) normals: Vec<Vec3>,
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

impl<'a> Contents<'a> {
    pub(super) fn read(bytes: &'a [u8], wanted: Attributes) -> Result<Self, String> {
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
    pub(super) fn lengths(&self) -> [usize; 3] {
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
    pub(super) fn fault(&self, corner: &Corner) -> Option<usize> {
        let [position, uv, _] = corner.map(|place| (place as usize).wrapping_sub(1));
        let is_there = [
            self.positions.get(position).is_some_and(|position| position.is_finite()),
            corner[1] == NONE || self.uvs.get(uv).is_some_and(|uv| uv.is_finite()),
            corner[2] as usize <= self.normals.len(),
        ];
        is_there.iter().position(|there| !there)
    }

    /// The model of the good faces and lines.
    pub(super) fn model(
        &self,
        bytes: &[u8],
        wanted: Attributes,
        placement: &Placement,
    ) -> Result<Model, String> {
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

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: Attributes = Attributes { normals: false, uvs: false };
    const ALL: Attributes = Attributes { normals: true, uvs: true };

    /// An element is counted as read, its place in the model, and as it is there; a corner is a place, and as part of
    /// a triangle three of them. A position is an f64 on its way, too.
    #[test]
    fn each_line_is_counted_with_all_that_is_made_of_it() {
        let place = size_of::<u32>();
        let [vec2, vec3, dvec3] = [size_of::<Vec2>(), size_of::<Vec3>(), size_of::<DVec3>()];
        let (element, corner, bend) = (size_of::<Element>(), place + 3 * place, place + 2 * place);
        let counted = |text: &str, wanted| Contents::read(text.as_bytes(), wanted).unwrap().memory();
        let lines = [
            ("v 0 0 0\n", dvec3 + place + dvec3 + vec3),
            ("vt 0 0\n", vec2 + place + vec2),
            ("vn 0 0 1\n", vec3 + place + vec3),
            ("f 1/1/1 2/1/1 3/1/1 4/1/1\n", element + 4 * 3 * corner),
            ("l 1 2 3\n", element + 3 * bend),
        ];
        for (line, bytes) in lines {
            for n in [1, 4] {
                assert_eq!(counted(&line.repeat(n), ALL), n * bytes, "{line:?} {n} times");
            }
        }
        let (text, bytes): (String, Vec<usize>) = lines.into_iter().unzip();
        assert_eq!(counted(&text, ALL), bytes.iter().sum());
        // What is not wanted is not kept.
        assert_eq!(counted("vt 0 0\nvn 0 0 1\n", NONE), 0);
        for (wanted, lists) in
            [(NONE, 1), (Attributes { uvs: true, ..NONE }, 2), (Attributes { normals: true, ..NONE }, 2)]
        {
            assert_eq!(counted("f 1/1/1 2/1/1 3/1/1\n", wanted), element + 3 * lists * corner, "{wanted:?}");
        }
    }

    #[test]
    fn no_more_than_256_materials_are_kept_in_mind() {
        let text: String = (0..300).map(|n| format!("mtllib {n}\nusemtl {n}\nf 1 1 1\n")).collect();
        let contents = Contents::read(text.as_bytes(), ALL).unwrap();
        assert_eq!((contents.libraries.len(), contents.materials.len()), (256, 256));
    }
}
