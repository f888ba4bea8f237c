//! What an OBJ file holds, and the model that it makes.

use glam::{DVec3, Vec2, Vec3};

use super::building::Building;
use super::counts::Counts;
use super::elements::{Corner, NONE, corner, no_numbers, numbers, place, used};
use super::polygon::Cutter;
use super::stage::Stage;
use super::words::{Words, line_number};
use crate::model::{Attributes, Materials, Model, Skipped};
use crate::placement::Placement;

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
    /// How much there was to be kept.
    pub(super) counts: Counts,
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
    /// With room for what was counted.
    fn with_room(counts: Counts, wanted: Attributes) -> Self {
        let used = used(wanted);
        let [positions, uvs, normals] = counts.elements;
        Self {
            counts,
            positions: Vec::with_capacity(positions),
            uvs: Vec::with_capacity(uvs),
            normals: Vec::with_capacity(normals),
            faces: Vec::with_capacity(counts.faces),
            places: used.map(|used| Vec::with_capacity(if used { counts.corners } else { 0 })),
            polylines: Vec::with_capacity(counts.polylines),
            bends: Vec::with_capacity(counts.bends),
            ..Self::default()
        }
    }

    /// What is in the text, of which so much was counted.
    pub(super) fn read(bytes: &'a [u8], counts: Counts, wanted: Attributes, stage: &mut Stage) -> Self {
        let mut contents = Self::with_room(counts, wanted);
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
            stage.done(offset);
            if !words.next_line() {
                return contents;
            }
        }
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
        stage: &mut Stage,
    ) -> Result<Model, String> {
        let mut building = Building::new(self, wanted);
        let mut cutter = Cutter::new();
        let mut skipped: Option<Skipped> = None;
        let most = self.counts.most_corners;
        let (mut begin, mut corners, mut points) = (0, Vec::with_capacity(most), Vec::with_capacity(most));
        for (n, face) in self.faces.iter().enumerate() {
            stage.done(n);
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

    #[test]
    fn no_more_than_256_materials_are_kept_in_mind() {
        let text: String = (0..300).map(|n| format!("mtllib {n}\nusemtl {n}\nf 1 1 1\n")).collect();
        let wanted = Attributes { normals: false, uvs: true };
        let watch = &mut |_| ();
        let stage = &mut Stage::new(watch, [0.0, 1.0], text.len());
        let contents = Contents::read(text.as_bytes(), Counts::default(), wanted, stage);
        assert_eq!((contents.libraries.len(), contents.materials.len()), (256, 256));
    }
}
