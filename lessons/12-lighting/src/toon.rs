//! As a cartoon: light in few steps, inside an outline.
//!
//! The outline is the mesh once more, black, a little swollen, and seen from within: its vertices are moved along their
//! normals, and only the triangles that show their back are drawn. In front of the model there are none; around it, and around
//! each part of it that stands before another, as much is seen of them as they were moved. So it is about as wide everywhere,
//! which a line where |n·v| is small is not: that is wide where the surface bends slowly, and missing where it has an edge. What
//! it costs is the mesh a second time; and it takes a closed mesh whose corners run counterclockwise: a sheet has no outline, and
//! what is turned inside out is hidden by it.

use clipping::{Clipping, Cull, Drawn, Mesh, render};
use common::direction::unit;
use common::{Color, Image, Vec3, Vec4};
use perspective::Framebuffer;
use perspective::depth::ZF32;
use shaders::lighting::{Lighting, Quantized};
use shaders::shader::{Fragment, Shader};

use crate::light::{PointLight, Reflected};
use crate::reflection::{Halfway, PointLit, Reflection};
use crate::scene::Scene;
use crate::shader::PerPixel;
use crate::surface::Smooth;

/// Steps of diffuse light.
const STEPS: f32 = 4.0;

/// How far vertices are moved for the outline, in units of the world.
pub const WIDTH: f32 = 0.01;

/// Blinn's model of reflection, its diffuse light cut down to the nearest lower of a few steps, as by lesson 9's
/// [`Quantized`]; a highlight is there in full where it is half as bright as it gets, or brighter, and else not at all.
#[derive(Clone, Copy, Debug)]
pub struct Toon {
    light: PointLight,
    /// The shares of light that arrive, before they are stepped.
    shares: PointLit<Halfway>,
}

// ANCHOR: toon
impl Reflection for Toon {
    fn new(light: &PointLight) -> Self {
        let shares = PointLight { ambient: 0.0, diffuse: 1.0, specular: 1.0, ..*light };
        Self { light: *light, shares: PointLit::new(&shares) }
    }

    #[inline]
    fn reflect(&self, point: Vec3, normal: Vec3, eye: Vec3) -> Reflected {
        let shares = self.shares.reflect(point, normal, eye);
        Reflected {
            body: self.light.ambient + self.light.diffuse * Quantized.intensity(STEPS, shares.body),
            highlight: self.light.specular * Quantized.intensity(1.0, 2.0 * shares.highlight),
        }
    }
}
// ANCHOR_END: toon

/// The mesh in one colour, its vertices moved along their normals in the world.
pub struct Swollen<'a> {
    scene: Scene<'a>,
    color: Color,
    /// By how much each vertex is moved, in the model's space.
    moves: Vec<Vec3>,
}

impl<'a> Swollen<'a> {
    /// For a scene, moved by a width in units of the world. Where corners meet they move together, along the sum of their
    /// normals, and the outline has no gap; where that is 0 they stay.
    // ANCHOR: swollen
    #[must_use]
    pub fn new(scene: &Scene<'a>, width: f32, color: Color) -> Self {
        let model = scene.uniforms.model;
        let mut sums = vec![Vec3::ZERO; model.positions().len()];
        for (face, triangle) in model.triangles().iter().enumerate() {
            for (corner, &vertex) in triangle.iter().enumerate() {
                sums[vertex as usize] += scene.normal(face, corner);
            }
        }
        // M⁻¹ is the transpose of what turns normals.
        let to_model = scene.normals_to_world.transpose();
        let moves = sums.into_iter().map(|sum| to_model * (unit(sum).unwrap_or_default() * width));
        Self { scene: *scene, color, moves: moves.collect() }
    }
    // ANCHOR_END: swollen
}

// ANCHOR: outline
impl Shader for Swollen<'_> {
    type Constant = ();
    type Varying = ();
    type Output = Color;

    #[inline]
    fn position(&self, vertex: usize) -> Vec4 {
        let place = self.scene.uniforms.model.positions()[vertex] + self.moves[vertex];
        self.scene.uniforms.to_clip * place.extend(1.0)
    }

    #[inline]
    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    #[inline]
    fn corner(&self, _: usize, _: usize) {}

    #[inline]
    fn fragment(&self, (): (), _: Fragment<()>) -> Option<Color> {
        Some(self.color)
    }
}

/// Draws a scene as a cartoon, on white paper.
pub fn draw(scene: &Scene, mesh: &Mesh, cull: Cull, image: &mut Image) -> Drawn {
    image.buffer_mut().fill(u8::MAX);
    let mut target = Framebuffer::new(image, ZF32);
    let (outline, body) = (Swollen::new(scene, WIDTH, Color::BLACK), PerPixel::<Toon>::new(scene, Smooth));
    let mut counts = render(&outline, mesh, Cull::Front, Clipping::GuardBand, &mut target);
    counts += render(&body, mesh, cull, Clipping::GuardBand, &mut target);
    Drawn { depths: target.depths, counts }
}
// ANCHOR_END: outline
