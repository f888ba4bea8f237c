//! A model: a set of triangles in space, from an OBJ file.

use std::path::Path;

use glam::{Vec2, Vec3};

use crate::{Error, file, obj};

/// What a lesson asks for beyond positions. What it does not ask for is not looked at, and not in the model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Attributes {
    /// A normal for each corner.
    pub normals: bool,
    /// Texture coordinates for each corner.
    pub uvs: bool,
}

/// Faces of a file that could not be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Skipped {
    /// How many were left out.
    pub count: usize,
    /// Of how many in the file.
    pub of: usize,
    /// Line and reason of the first one.
    pub first: String,
}

/// Triangles whose corners share positions, and share normals and texture coordinates apart from those: a
/// seam in the texture does not cut the surface.
///
/// Every index is valid and every number finite.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) normals: Vec<Vec3>,
    pub(crate) normal_indices: Vec<[u32; 3]>,
    pub(crate) uvs: Vec<Vec2>,
    pub(crate) uv_indices: Vec<[u32; 3]>,
    pub(crate) skipped: Option<Skipped>,
}

impl Model {
    /// Reads an OBJ file of up to 32 MiB: positions, and what `wanted` asks for. Polygons become fans of
    /// triangles.
    ///
    /// A face is left out and counted in [`skipped`](Self::skipped) if it has fewer than three corners, or
    /// a corner that does not exist or is not finite. Normals or texture coordinates that any good face
    /// lacks are absent from the whole model.
    ///
    /// # Errors
    /// One that names the file where it cannot be read or no face is good.
    pub fn read(path: &Path, wanted: Attributes) -> Result<Self, Error> {
        obj::parse(&file::read_bytes(path, obj::FILE_LIMIT)?, wanted)
            .map_err(|reason| Error::Model { path: path.into(), reason })
    }

    /// The model in the text of an OBJ file; see [`read`](Self::read).
    ///
    /// # Errors
    /// A line that says why there is no good face.
    pub fn parse(text: &[u8], wanted: Attributes) -> Result<Self, String> {
        obj::parse(text, wanted)
    }

    /// A model of positions alone.
    ///
    /// # Errors
    /// A line that names the first triangle with a corner that does not exist or is not finite.
    pub fn from_triangles(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self, String> {
        let good = |&i: &u32| positions.get(i as usize).is_some_and(|position| position.is_finite());
        match triangles.iter().position(|triangle| !triangle.iter().all(good)) {
            Some(n) => Err(format!("triangle {n} has a corner that does not exist or is not finite")),
            None => Ok(Self { positions, triangles, ..Self::default() }),
        }
    }

    /// The positions that triangles use, each line of the file once, in the order of their first use.
    #[must_use]
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// The triangles, as indices into [`positions`](Self::positions), in the file's order.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The three positions of each triangle, in order.
    #[must_use]
    pub fn faces(&self) -> impl ExactSizeIterator<Item = [Vec3; 3]> + '_ {
        self.triangles.iter().map(|triangle| triangle.map(|i| self.positions[i as usize]))
    }

    /// The three normals of each triangle, as long as the file has them; none where it lacks them or they
    /// were not asked for. Their lengths are the file's: often, but not always, 1.
    #[must_use]
    pub fn face_normals(&self) -> impl ExactSizeIterator<Item = [Vec3; 3]> + '_ {
        self.normal_indices.iter().map(|triangle| triangle.map(|i| self.normals[i as usize]))
    }

    /// The three (u, v) of each triangle, v up; none where the file lacks them or they were not asked for.
    #[must_use]
    pub fn face_uvs(&self) -> impl ExactSizeIterator<Item = [Vec2; 3]> + '_ {
        self.uv_indices.iter().map(|triangle| triangle.map(|i| self.uvs[i as usize]))
    }

    /// The position of a corner (0, 1 or 2) of a triangle.
    ///
    /// # Panics
    /// Where there is no such triangle or corner.
    #[inline]
    #[must_use]
    pub fn position(&self, face: usize, corner: usize) -> Vec3 {
        self.positions[self.triangles[face][corner] as usize]
    }

    /// The texture coordinates of a corner (0, 1 or 2) of a triangle.
    ///
    /// # Panics
    /// Where there is no such triangle or corner, or the model has no texture coordinates.
    #[inline]
    #[must_use]
    pub fn uv(&self, face: usize, corner: usize) -> Vec2 {
        self.uvs[self.uv_indices[face][corner] as usize]
    }

    /// What was left out of the file, if anything.
    #[must_use]
    pub fn skipped(&self) -> Option<&Skipped> {
        self.skipped.as_ref()
    }
}
