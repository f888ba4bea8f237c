//! A mesh: vertices that are computed once each, and the index buffer that makes triangles of them.
//!
//! An OBJ file numbers positions, normals and texture coordinates apart. To whoever draws, a vertex is all of these
//! together: where one of them differs, as at a seam of the texture, there are two vertices at one place. So they are
//! unified once, when the mesh is made: corners with the same position, normal and texture coordinates become one vertex.
//! Of these three, only what a look needs is compared: a look without texture has no seams.

use std::collections::HashMap;
use std::ops::Range;

use common::{Attributes, Method, Model, Vec3};

use crate::assembly::{RESTART, Topology, Triangles};

/// A vertex: a position, and one of the corners that it stands for, the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vertex {
    /// The number of its position in the model.
    pub position: u32,
    /// A triangle that has it as a corner.
    pub face: u32,
    /// Which of that triangle's corners it is: 0, 1 or 2.
    pub corner: u32,
}

/// Triangles of a model, as vertices and numbers of these.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// The vertices, in the order of their first use.
    pub vertices: Vec<Vertex>,
    /// How the indices make triangles.
    pub topology: Topology,
    /// Numbers of vertices.
    pub indices: Vec<u32>,
    /// For each triangle made of the indices, its number in the model.
    pub faces: Vec<u32>,
}

/// Makes a mesh of a model, the unit normals at the corners of its triangles, and what of these a look needs.
pub type Assemble = fn(&Model, &[[Vec3; 3]], Attributes) -> Mesh;

/// The ways to hand over a model's triangles. All make the same triangles.
pub const ASSEMBLIES: &[Method<Assemble>] = &[
    Method {
        name: "per-corner",
        run: |model, _, _| per_corner(model),
        promise: "needs no preparation; three vertices computed for each triangle",
        failure: "each vertex is computed as often as triangles meet there, about six times",
    },
    Method {
        name: "indexed",
        run: indexed,
        promise: "each vertex computed once; three numbers read for each triangle",
        failure: "corners must be unified first; a value that differs from triangle to triangle splits vertices",
    },
    Method {
        name: "strip",
        run: |model, normals, needs| strips(indexed(model, normals, needs)),
        promise: "each vertex computed once; for the head 1.7 numbers read for each triangle instead of 3",
        failure: "the model's order of triangles is lost: of equal depths another one may stay; strips must be found first",
    },
];

impl Mesh {
    /// The triangles in the order in which they are drawn: the number of each in the model, and its three vertices.
    #[inline]
    pub fn triangles(&self) -> impl Iterator<Item = (usize, [u32; 3])> + '_ {
        let triangles: Triangles = self.topology.triangles(&self.indices);
        self.faces.iter().map(|&face| face as usize).zip(triangles)
    }

    /// Those of the triangles that a range names, counted in that order. Only of a list can they be found without all before
    /// them.
    ///
    /// # Panics
    /// Where the range ends beyond the last.
    #[inline]
    pub fn some_triangles(&self, range: Range<usize>) -> impl Iterator<Item = (usize, [u32; 3])> + '_ {
        let is_list = self.topology == Topology::List;
        let indices = if is_list { &self.indices[3 * range.start..] } else { &self.indices[..] };
        let before = if is_list { 0 } else { range.start };
        let triangles = self.topology.triangles(indices).skip(before);
        self.faces[range].iter().map(|&face| face as usize).zip(triangles)
    }
}

/// A vertex for each corner.
fn per_corner(model: &Model) -> Mesh {
    let vertices: Vec<Vertex> = corners(model).collect();
    let indices = (0..vertices.len() as u32).collect();
    Mesh { vertices, topology: Topology::List, indices, faces: all_faces(model) }
}

/// One vertex for all corners that have the same position and, as far as they are needed, the same normal and texture
/// coordinates.
///
/// # Panics
/// Where normals or texture coordinates are needed and missing.
// ANCHOR: indexed
#[must_use]
pub fn indexed(model: &Model, normals: &[[Vec3; 3]], needs: Attributes) -> Mesh {
    let mut vertices = Vec::new();
    let mut known = HashMap::new();
    let number = |vertex: Vertex| {
        let (face, corner) = (vertex.face as usize, vertex.corner as usize);
        let normal = needs.normals.then(|| normals[face][corner].to_array().map(f32::to_bits));
        let uv = needs.uvs.then(|| model.uv(face, corner).to_array().map(f32::to_bits));
        // Vertices are numbered as they come, whatever the order in which the map keeps them.
        *known.entry((vertex.position, normal, uv)).or_insert_with(|| {
            vertices.push(vertex);
            vertices.len() as u32 - 1
        })
    };
    let indices = corners(model).map(number).collect();
    Mesh { vertices, topology: Topology::List, indices, faces: all_faces(model) }
}
// ANCHOR_END: indexed

/// All corners of a model, triangle by triangle.
fn corners(model: &Model) -> impl Iterator<Item = Vertex> + '_ {
    let numbered = model.triangles().iter().zip(0..);
    numbered.flat_map(|(triangle, face)| {
        triangle.iter().zip(0..).map(move |(&position, corner)| Vertex { position, face, corner })
    })
}

fn all_faces(model: &Model) -> Vec<u32> {
    (0..model.triangles().len() as u32).collect()
}

/// The triangles of a list in strips, as long as a simple search finds them: from the first triangle that is in none yet,
/// over one side after the other, until there is no neighbour left; of the three sides over which to start, that which
/// leads farthest.
#[must_use]
pub fn strips(list: Mesh) -> Mesh {
    let triangles: Vec<[u32; 3]> = list.topology.triangles(&list.indices).collect();
    // The triangles on the left of a side, walked from one vertex to another.
    let mut beside: HashMap<[u32; 2], Vec<usize>> = HashMap::new();
    for (n, &[a, b, c]) in triangles.iter().enumerate() {
        for side in [[a, b], [b, c], [c, a]] {
            beside.entry(side).or_default().push(n);
        }
    }
    let mut used = vec![false; triangles.len()];
    // The walk that came by each triangle last.
    let (mut walk, mut walked) = (0, vec![0; triangles.len()]);
    let (mut indices, mut faces) = (Vec::new(), Vec::new());
    for (n, &[a, b, c]) in triangles.iter().enumerate() {
        if used[n] {
            continue;
        }
        let from = |start: [u32; 3]| {
            let (mut strip, mut members) = (start.to_vec(), vec![n]);
            walk += 1;
            walked[n] = walk;
            loop {
                let [p, q] = [strip[strip.len() - 2], strip[strip.len() - 1]];
                // An odd triangle has its corners the other way round.
                let side = if members.len() % 2 == 1 { [q, p] } else { [p, q] };
                let fresh = |&&n: &&usize| !used[n] && walked[n] != walk;
                let Some(&next) = beside.get(&side).into_iter().flatten().find(fresh) else { break };
                let Some(third) = triangles[next].into_iter().find(|corner| !side.contains(corner)) else {
                    break;
                };
                strip.push(third);
                members.push(next);
                walked[next] = walk;
            }
            (strip, members)
        };
        let longest =
            [[a, b, c], [b, c, a], [c, a, b]].map(from).into_iter().rev().max_by_key(|strip| strip.0.len());
        let Some((strip, members)) = longest else { continue };
        if !indices.is_empty() {
            indices.push(RESTART);
        }
        indices.extend(strip);
        members.iter().for_each(|&member| used[member] = true);
        faces.extend(members.into_iter().map(|member| list.faces[member]));
    }
    Mesh { topology: Topology::Strip, indices, faces, ..list }
}
