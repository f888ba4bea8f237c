//! Triangles of clip space as they are, each pixel of which tells all that its fragment was given.

use clipping::Mesh;
use clipping::assembly::Topology;
use clipping::mesh::Vertex;
use common::{Color, Vec2, Vec4};
use shaders::shader::{Fragment, Shader};
use speed::eight::EachPixel;

/// A corner in the window: x and y in 1/256 px, the depth, and w.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Corner {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) z: f32,
    pub(crate) w: f32,
}

impl Corner {
    /// At a place in 1/256 px, in the middle of the depths.
    pub(crate) const fn at(x: i32, y: i32) -> Self {
        Self { x, y, z: 0.5, w: 1.0 }
    }

    /// Where it is in clip space, for a picture of that size.
    pub(crate) fn clip(self, [width, height]: [u16; 2]) -> Vec4 {
        let Self { x, y, z, w } = self;
        let place = |n: i32, size: u16| (f64::from(n) / f64::from(size) / 128.0 - 1.0) as f32;
        Vec4::new(place(x, width), place(y, height), 2.0 * z - 1.0, 1.0) * w
    }
}

/// Which fragments have no colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Drops {
    Nothing,
    /// Every other pixel.
    Checker,
    /// Many, told by all that the fragment was given.
    Some,
    /// All.
    All,
    /// Those with a varying that is NaN, and no others.
    Nan,
    /// Every third triangle as a whole.
    Triangles,
}

/// Triangles, and which of their fragments are dropped.
#[derive(Clone, Debug)]
pub(crate) struct Soup {
    pub(crate) positions: Vec<Vec4>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) drops: Drops,
}

impl Soup {
    /// Triangles that share no vertices.
    pub(crate) fn apart(triangles: &[[Corner; 3]], size: [u16; 2]) -> Self {
        let positions = triangles.iter().flatten().map(|corner| corner.clip(size)).collect();
        let triangles = (0..triangles.len() as u32).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
        Self { positions, triangles, drops: Drops::Nothing }
    }

    /// Two triangles to a field of a grid whose corners are given row by row, so many in a row.
    pub(crate) fn grid(corners: &[Corner], across: usize, size: [u16; 2]) -> Self {
        let up = corners.len() / across;
        let fields = (1..up).flat_map(|y| (1..across).map(move |x| (y * across + x) as u32));
        let across = across as u32;
        let halves = fields.flat_map(|d| {
            let [a, b, c] = [d - across - 1, d - across, d - 1];
            [[a, b, d], [a, d, c]]
        });
        Self {
            positions: corners.iter().map(|corner| corner.clip(size)).collect(),
            triangles: halves.collect(),
            drops: Drops::Nothing,
        }
    }

    /// The same, some fragments dropped.
    pub(crate) fn dropping(self, drops: Drops) -> Self {
        Self { drops, ..self }
    }

    /// As a shader for a frame.
    pub(crate) fn shader(&self) -> EachPixel<&Self> {
        EachPixel { shader: self, keeps_all: matches!(self.drops, Drops::Nothing | Drops::Triangles) }
    }

    /// Its triangles, each vertex once.
    pub(crate) fn mesh(&self) -> Mesh {
        let mut numbers = vec![u32::MAX; self.positions.len()];
        let mut vertices = Vec::new();
        let mut indices = Vec::with_capacity(3 * self.triangles.len());
        for (triangle, face) in self.triangles.iter().zip(0..) {
            for (&position, corner) in triangle.iter().zip(0..) {
                let number = &mut numbers[position as usize];
                if *number == u32::MAX {
                    *number = vertices.len() as u32;
                    vertices.push(Vertex { position, face, corner });
                }
                indices.push(*number);
            }
        }
        let faces = (0..self.triangles.len() as u32).collect();
        Mesh { vertices, topology: Topology::List, indices, faces }
    }
}

/// A number that hangs on each bit of two others.
fn mixed(a: u32, b: u32) -> u32 {
    let n = (a ^ b.rotate_left(16)).wrapping_mul(0x9e37_79b1).wrapping_add(b);
    (n ^ n >> 15).wrapping_mul(0x85eb_ca77) ^ n >> 13
}

/// Its bits; there are many NaN, all of them alike here.
fn bits(n: f32) -> u32 {
    if n.is_nan() { u32::MAX } else { n.to_bits() }
}

impl Shader for &Soup {
    type Constant = u32;
    type Varying = (Vec2, f32);
    type Output = Color;

    fn position(&self, vertex: usize) -> Vec4 {
        self.positions[vertex]
    }

    fn triangle(&self, face: usize) -> Option<u32> {
        (self.drops != Drops::Triangles || face % 3 != 1).then_some(face as u32)
    }

    fn corner(&self, face: usize, corner: usize) -> (Vec2, f32) {
        let vertex = self.triangles[face][corner];
        let [a, b, c] = [1, 2, 3].map(|n| mixed(vertex, n) as f32 / u32::MAX as f32 - 0.5);
        let c = if self.drops == Drops::Nan && vertex.is_multiple_of(3) { f32::NAN } else { 1e3 * c };
        (Vec2::new(a, 40.0 * b), c)
    }

    fn fragment(&self, face: u32, fragment: Fragment<(Vec2, f32)>) -> Option<Color> {
        let Fragment { x, y, depth, varying: (two, one) } = fragment;
        let given = [face, x as u32, y as u32, bits(depth), bits(two.x), bits(two.y), bits(one)];
        let told = given.into_iter().fold(17, mixed);
        let dropped = match self.drops {
            Drops::Nothing | Drops::Triangles => false,
            Drops::Checker => (x ^ y) & 1 == 1,
            Drops::Some => told.is_multiple_of(3),
            Drops::All => true,
            Drops::Nan => one.is_nan(),
        };
        let [r, g, b, a] = told.to_le_bytes();
        (!dropped).then_some(Color { r, g, b, a })
    }
}
