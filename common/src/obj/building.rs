//! Triangles and lines become a model, whose lists hold no more than they name.

use glam::DVec3;

use super::contents::Contents;
use super::elements::{Corner, NONE, NOWHERE, used};
use super::words::line_number;
use crate::model::{Attributes, Model};
use crate::placement::Placement;

/// A model to which triangles are added.
pub(super) struct Building<'a> {
    contents: &'a Contents<'a>,
    /// Which lists are used, and no face lacks so far.
    used: [bool; 3],
    /// Where the first face begins that lacks something of a list.
    lacks: [Option<u32>; 3],
    /// The place in the model of each element of each list.
    renamed: [Vec<u32>; 3],
    /// The model's positions before they are placed.
    positions: Vec<DVec3>,
    pub(super) model: Model,
}

impl<'a> Building<'a> {
    pub(super) fn new(contents: &'a Contents, wanted: Attributes) -> Self {
        let used = used(wanted);
        let renamed =
            [0, 1, 2].map(|kind| vec![NOWHERE; if used[kind] { contents.lengths()[kind] } else { 0 }]);
        let counts = &contents.counts;
        let room = |kind: usize| if used[kind] { counts.elements[kind] } else { 0 };
        let triangles = |kind: usize| if used[kind] { counts.triangles } else { 0 };
        let model = Model {
            triangles: Vec::with_capacity(triangles(0)),
            uvs: Vec::with_capacity(room(1)),
            uv_indices: Vec::with_capacity(triangles(1)),
            normals: Vec::with_capacity(room(2)),
            normal_indices: Vec::with_capacity(triangles(2)),
            lines: Vec::with_capacity(counts.bends),
            ..Model::default()
        };
        Self { contents, used, lacks: [None; 3], renamed, positions: Vec::with_capacity(room(0)), model }
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
    pub(super) fn triangle(&mut self, corners: [Corner; 3]) {
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
    pub(super) fn note_lacks(&mut self, corners: &[Corner], offset: u32) {
        for kind in [1, 2] {
            if self.used[kind] && corners.iter().any(|corner| corner[kind] == NONE) {
                self.used[kind] = false;
                self.lacks[kind] = Some(offset);
            }
        }
    }

    /// Adds a line between two positions.
    pub(super) fn line(&mut self, ends: [u32; 2]) {
        let renamed = &mut self.renamed[0];
        let ends = ends.map(|end| Self::enter(renamed, end, &self.contents.positions, &mut self.positions));
        self.model.lines.push(ends);
    }

    pub(super) fn finish(self, bytes: &[u8], placement: &Placement) -> Model {
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
