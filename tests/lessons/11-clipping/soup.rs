//! Triangles of clip space as they are, drawn so that each pixel tells what was seen there.

use checks::clipspace::{Hit, nearest};
use clipping::assembly::Topology;
use clipping::mesh::Vertex;
use clipping::{Clipping, Counts, Cull, Mesh, render};
use common::{Bounds, Vec2, Vec3, Vec4};
use perspective::perspective;
use shaders::shader::{Fragment, Shader};
use shaders::target::Target;
use verify::window;

/// Triangles that share no vertices.
pub(crate) struct Soup<'a>(pub(crate) &'a [[Vec4; 3]]);

/// What was seen at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Seen {
    /// The number of the triangle.
    pub(crate) face: usize,
    /// The weights of its first two corners.
    pub(crate) weights: Vec2,
    /// How deep it is.
    pub(crate) depth: f32,
}

impl Shader for Soup<'_> {
    type Constant = usize;
    type Varying = Vec2;
    type Output = Seen;

    fn position(&self, vertex: usize) -> Vec4 {
        self.0[vertex / 3][vertex % 3]
    }

    fn triangle(&self, face: usize) -> Option<usize> {
        Some(face)
    }

    fn corner(&self, _: usize, corner: usize) -> Vec2 {
        [Vec2::X, Vec2::Y, Vec2::ZERO][corner]
    }

    fn fragment(&self, face: usize, Fragment { depth, varying, .. }: Fragment<Vec2>) -> Option<Seen> {
        Some(Seen { face, weights: varying, depth })
    }
}

/// The nearest of what was drawn, and how often each pixel was covered at all.
pub(crate) struct Log {
    bounds: Bounds,
    pub(crate) seen: Vec<Option<Seen>>,
    pub(crate) covered: Vec<u32>,
}

impl Log {
    pub(crate) fn new(side: i32) -> Self {
        let count = (side * side) as usize;
        Self { bounds: window(side, side), seen: vec![None; count], covered: vec![0; count] }
    }

    fn place(&self, x: i32, y: i32) -> usize {
        assert!(self.bounds.contains(x, y), "({x}, {y}) is not in the picture");
        (y * (self.bounds.max.x + 1) + x) as usize
    }
}

impl Target<Seen> for Log {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Nothing beyond far is seen, and all else may be written.
    fn test(&mut self, _: i32, _: i32, depth: f32) -> bool {
        assert!(!depth.is_nan());
        depth < 1.0
    }

    fn write(&mut self, x: i32, y: i32, depth: f32, output: Seen) {
        let place = self.place(x, y);
        self.covered[place] += 1;
        if self.seen[place].is_none_or(|seen| depth < seen.depth) {
            self.seen[place] = Some(output);
        }
    }

    fn clear(&mut self) {
        *self = Self::new(self.bounds.max.x + 1);
    }
}

/// A vertex for each corner of so many triangles.
pub(crate) fn corners(faces: usize) -> Mesh {
    let numbers = || 0..faces as u32;
    let vertices = numbers()
        .flat_map(|face| (0..3).map(move |corner| Vertex { position: 3 * face + corner, face, corner }));
    let vertices: Vec<Vertex> = vertices.collect();
    let indices = (0..vertices.len() as u32).collect();
    Mesh { vertices, topology: Topology::List, indices, faces: numbers().collect() }
}

/// What a way to clip draws of some triangles into a square picture.
pub(crate) fn drawn(triangles: &[[Vec4; 3]], clipping: Clipping, cull: Cull, side: i32) -> (Log, Counts) {
    let mut log = Log::new(side);
    let counts = render(&Soup(triangles), &corners(triangles.len()), cull, clipping, &mut log);
    (log, counts)
}

/// What the rays through a pixel's centre and through eight points 1/64 px about it meet, if they agree on the triangle: only
/// then may nothing else be drawn there. A corner is rounded to 1/256 px, which moves a side by less.
pub(crate) fn certain(
    triangles: &[[Vec4; 3]],
    x: i32,
    y: i32,
    side: i32,
) -> Option<Vec<Option<(usize, Hit)>>> {
    let at = |n: i32, off: i32| (2.0 * f64::from(n) + 1.0 + f64::from(off) / 32.0) / f64::from(side) - 1.0;
    let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy)));
    let hits: Vec<_> = around.map(|(dx, dy)| nearest(triangles, [at(x, dx), at(y, dy)])).collect();
    let face = |hit: &Option<(usize, Hit)>| hit.map(|hit| hit.0);
    hits.iter().all(|hit| face(hit) == face(&hits[0])).then_some(hits)
}

/// From eye space to clip space: 90° from side to side, near at ½, far at 16.
pub(crate) fn eye(triangles: &[[[f32; 3]; 3]]) -> Vec<[Vec4; 3]> {
    let to_clip = perspective(90.0, 1.0, 0.5, 16.0).unwrap();
    triangles
        .iter()
        .map(|corners| corners.map(|corner| to_clip * Vec3::from_array(corner).extend(1.0)))
        .collect()
}
