//! What mission 12 gives: a point light, what is reflected of it, and a loop over pixels. All of it is made of lessons 3 to
//! 11, so that the program in which a submission runs has nothing of lesson 12.

use clipping::mesh::indexed;
use clipping::{Clipping, Cull, render};
use common::{Attributes, Color, Image, Mat4, Model, Vec3, Vec4};
use gouraud::corner_normals;
use perspective::Framebuffer;
use perspective::depth::ZF32;
use shaders::shader::{Fragment, Shader};

/// A light that shines from one point in all directions, as strongly near as far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Where it is.
    pub position: Vec3,
    /// A: what of a surface's colour is seen without it.
    pub ambient: f32,
    /// D: what of a surface's colour is seen more where the light falls straight on it.
    pub diffuse: f32,
    /// S: how much white is added where the surface mirrors the light straight into the eye.
    pub specular: f32,
    /// E: the exponent that makes a highlight small.
    pub shininess: f32,
}

/// What a surface reflects towards the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflected {
    /// What is seen of the surface's own colour, as a share.
    pub body: f32,
    /// What white is added.
    pub highlight: f32,
}

impl Reflected {
    /// The colour that is seen of a surface with this colour; what is too bright for a channel is clamped.
    #[must_use]
    pub fn color(self, base: Color) -> Color {
        let channel = |base: u8| (f32::from(base) * self.body + 255.0 * self.highlight + 0.5) as u8;
        Color::rgb(channel(base.r), channel(base.g), channel(base.b))
    }
}

/// What is reflected at a point of a surface with a normal towards an eye, of a light.
pub type Reflect = fn(Vec3, Vec3, Vec3, &PointLight) -> Reflected;

/// Draws a model of one colour, with `reflect` at each pixel. `to_clip` is the camera's matrix, `eye` its place.
pub fn draw(
    model: &Model,
    base: Color,
    to_clip: Mat4,
    eye: Vec3,
    light: &PointLight,
    reflect: Reflect,
    image: &mut Image,
) {
    let normals = corner_normals(model);
    let mesh = indexed(model, &normals, Attributes { normals: true, uvs: false });
    let shader = Lit { model, normals: &normals, base, to_clip, eye, light, reflect };
    render(&shader, &mesh, Cull::Back, Clipping::GuardBand, &mut Framebuffer::new(image, ZF32));
}

/// The position and the normal are interpolated, and the light is computed at each pixel.
struct Lit<'a> {
    model: &'a Model,
    normals: &'a [[Vec3; 3]],
    base: Color,
    to_clip: Mat4,
    eye: Vec3,
    light: &'a PointLight,
    reflect: Reflect,
}

impl Shader for Lit<'_> {
    type Constant = ();
    type Varying = (Vec3, Vec3);
    type Output = Color;

    fn position(&self, vertex: usize) -> Vec4 {
        self.to_clip * self.model.positions()[vertex].extend(1.0)
    }

    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    fn corner(&self, face: usize, corner: usize) -> (Vec3, Vec3) {
        (self.model.position(face, corner), self.normals[face][corner])
    }

    fn fragment(&self, (): (), fragment: Fragment<(Vec3, Vec3)>) -> Option<Color> {
        let (point, normal) = fragment.varying;
        Some((self.reflect)(point, normal, self.eye, self.light).color(self.base))
    }
}
