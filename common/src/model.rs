//! A model: a set of triangles in space, from an OBJ file.

use glam::{DVec3, Vec2, Vec3};

use crate::placement::{Fit, Placement};

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

/// What a file says of its materials, all names as they stand there.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Materials {
    /// The files in which materials are described (`mtllib`), each once.
    pub libraries: Vec<String>,
    /// The materials that faces use (`usemtl`), each once, in the order of their first use.
    pub used: Vec<String>,
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
    pub(crate) lines: Vec<[u32; 2]>,
    pub(crate) skipped: Option<Skipped>,
    pub(crate) remarks: Vec<String>,
    pub(crate) without_uvs: Option<usize>,
    pub(crate) without_normals: Option<usize>,
    pub(crate) materials: Materials,
    pub(crate) fit: Option<Fit>,
}

impl Model {
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

    /// The same with texture coordinates, v up: for each triangle the three that its corners have, as indices into `uvs`.
    ///
    /// # Errors
    /// A line that says that there are not as many triangles as the model has, or names the first with a corner that
    /// does not exist or is not finite.
    pub fn with_uvs(self, uvs: Vec<Vec2>, triangles: Vec<[u32; 3]>) -> Result<Self, String> {
        let good = |&i: &u32| uvs.get(i as usize).is_some_and(|uv| uv.is_finite());
        let (count, own) = (triangles.len(), self.triangles.len());
        if count != own {
            return Err(format!("there are texture coordinates for {count} triangles of {own}"));
        }
        match triangles.iter().position(|triangle| !triangle.iter().all(good)) {
            Some(n) => {
                Err(format!("triangle {n} has texture coordinates that do not exist or are not finite"))
            }
            None => Ok(Self { uvs, uv_indices: triangles, ..self }),
        }
    }

    /// Makes these the positions, as they are placed.
    pub(crate) fn place(&mut self, positions: &[DVec3], placement: &Placement) {
        self.fit = placement.fit.map(|up| Fit::of(positions, up));
        let place = |position: DVec3| self.fit.map_or(position, |fit| fit.place(position)) - placement.origin;
        self.positions = positions.iter().map(|&position| place(position).as_vec3()).collect();
        if let Some(fit) = self.fit {
            self.normals.iter_mut().for_each(|normal| *normal = fit.turn(normal.as_dvec3()).as_vec3());
        }
    }

    /// The positions that triangles and lines use, each line of the file once, in the order of their first use.
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

    /// The lines of `l` elements, as indices into [`positions`](Self::positions), in the file's order.
    #[must_use]
    pub fn lines(&self) -> &[[u32; 2]] {
        &self.lines
    }

    /// The largest coordinate, whatever its sign: within 1 the model is in view.
    #[must_use]
    pub fn reach(&self) -> f32 {
        self.positions.iter().map(|position| position.abs().max_element()).fold(0.0, f32::max)
    }

    /// How it was moved and scaled, if it was [fitted](Placement::fit).
    #[must_use]
    pub fn fit(&self) -> Option<&Fit> {
        self.fit.as_ref()
    }

    /// The materials that its faces use; nothing unless texture coordinates were asked for.
    #[must_use]
    pub fn materials(&self) -> &Materials {
        &self.materials
    }

    /// The line of the first face that lacks the texture coordinates that were asked for.
    #[must_use]
    pub fn without_uvs(&self) -> Option<usize> {
        self.without_uvs
    }

    /// The line of the first face that lacks the normals that were asked for.
    #[must_use]
    pub fn without_normals(&self) -> Option<usize> {
        self.without_normals
    }

    /// What else is to be told of the file, a sentence each.
    #[must_use]
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// What was left out of the file, if anything.
    #[must_use]
    pub fn skipped(&self) -> Option<&Skipped> {
        self.skipped.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texture_coordinates_are_given_to_corners_that_are_there() {
        let model = || Model::from_triangles(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).unwrap();
        let uvs = || vec![Vec2::ZERO, Vec2::ONE];
        let given = model().with_uvs(uvs(), vec![[1, 0, 1]]).unwrap();
        assert_eq!(given.face_uvs().collect::<Vec<_>>(), [[Vec2::ONE, Vec2::ZERO, Vec2::ONE]]);
        assert_eq!(given.positions(), model().positions());

        let refused = |uvs, triangles| model().with_uvs(uvs, triangles).unwrap_err();
        assert_eq!(refused(uvs(), vec![]), "there are texture coordinates for 0 triangles of 1");
        let missing = "triangle 0 has texture coordinates that do not exist or are not finite";
        assert_eq!(refused(uvs(), vec![[0, 1, 2]]), missing);
        assert_eq!(refused(vec![Vec2::NAN], vec![[0, 0, 0]]), missing);
    }
}
