//! Several outputs of one fragment shader, each into a buffer of its own, in one pass.

use common::{Bounds, Color, Vec3, Vec4};
use shaders::shader::{Fragment, Shader};
use shaders::target::Target;
use zbuffer::DepthBuffer;

use crate::state::Operations;
use crate::target::Framebuffer;

/// What is known of a surface at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outputs {
    /// Its colour.
    pub color: Color,
    /// Its normal in the world, of length 1, or 0 where it has none.
    pub normal: Vec3,
    /// How far it is from the eye.
    pub distance: f32,
}

/// A framebuffer, and beside it a buffer of normals and one of distances. (So they are called a geometry buffer, or
/// G-buffer: T. Saito and T. Takahashi, *Comprehensible rendering of 3-D shapes*, SIGGRAPH 1990.)
pub struct Buffers<'a, S: Operations> {
    /// Colours and depths, with what happens to fragments.
    pub framebuffer: Framebuffer<'a, S>,
    /// The normals of what is seen, rows from the bottom; 0 where nothing is.
    pub normals: Vec<Vec3>,
    /// How far away it is; infinity where nothing is.
    pub distances: DepthBuffer<f32>,
}

impl<'a, S: Operations> Buffers<'a, S> {
    /// With nothing in the two further buffers.
    #[must_use]
    pub fn new(framebuffer: Framebuffer<'a, S>) -> Self {
        let normals = vec![Vec3::ZERO; framebuffer.stencils.len()];
        let distances = DepthBuffer::new(framebuffer.image, f32::INFINITY);
        Self { framebuffer, normals, distances }
    }
}

// ANCHOR: outputs
impl<S: Operations> Target<Outputs> for Buffers<'_, S> {
    fn bounds(&self) -> Bounds {
        self.framebuffer.bounds()
    }

    #[inline]
    fn test(&mut self, x: i32, y: i32, depth: f32) -> bool {
        self.framebuffer.test(x, y, depth)
    }

    #[inline]
    fn write(&mut self, x: i32, y: i32, depth: f32, Outputs { color, normal, distance }: Outputs) {
        self.framebuffer.write(x, y, depth, color);
        self.normals[y as usize * self.framebuffer.image.width() as usize + x as usize] = normal;
        self.distances.set(x, y, distance);
    }

    fn clear(&mut self) {
        self.framebuffer.clear();
        self.normals.fill(Vec3::ZERO);
        self.distances.clear();
    }
}
// ANCHOR_END: outputs

/// Any shader's colours, and with them normal and distance.
pub struct Described<'a, S> {
    /// What makes the colours.
    pub shader: S,
    /// Where the surface is in the world, and its normals.
    pub scene: lighting::Scene<'a>,
}

impl<S: Shader<Output = Color>> Shader for Described<'_, S> {
    type Constant = S::Constant;
    /// What the colours need, the position in the world, and the normal.
    type Varying = (S::Varying, (Vec3, Vec3));
    type Output = Outputs;

    #[inline]
    fn position(&self, vertex: usize) -> Vec4 {
        self.shader.position(vertex)
    }

    #[inline]
    fn triangle(&self, face: usize) -> Option<S::Constant> {
        self.shader.triangle(face)
    }

    #[inline]
    fn corner(&self, face: usize, corner: usize) -> Self::Varying {
        let place = (self.scene.position(face, corner), self.scene.normal(face, corner));
        (self.shader.corner(face, corner), place)
    }

    #[inline]
    fn fragment(&self, constant: S::Constant, fragment: Fragment<Self::Varying>) -> Option<Outputs> {
        let Fragment { x, y, depth, varying: (varying, (point, normal)) } = fragment;
        let color = self.shader.fragment(constant, Fragment { x, y, depth, varying })?;
        Some(Outputs { color, normal: normal.normalize_or_zero(), distance: point.distance(self.scene.eye) })
    }
}
