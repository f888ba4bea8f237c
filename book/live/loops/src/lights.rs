//! Lesson 12's methods, chosen when the program runs: one loop for all, where the lesson has one for each.

use clipping::{Counts, Cull, Mesh};
use common::{Color, Image, Vec2, Vec3, Vec4};
use lighting::reflection::{Halfway, Mirrored, PointLit};
use lighting::shader::{PerCorner, PerPixel, PerTriangle};
use lighting::surface::Smooth;
use lighting::{Reflected, Scene, shader};
use shaders::shader::{Fragment, Shader};

/// How a scene is lit, which makes the shader for it.
pub type Make = for<'a> fn(&Scene<'a>) -> AnyLight<'a>;

/// The lesson's methods, in its order.
pub const MAKES: [Make; 4] = [
    |scene| AnyLight::Flat(PerTriangle::new(scene)),
    |scene| AnyLight::Vertex(PerCorner::new(scene)),
    |scene| AnyLight::Phong(PerPixel::new(scene, Smooth)),
    |scene| AnyLight::BlinnPhong(PerPixel::new(scene, Smooth)),
];

/// Any of the lesson's shaders.
pub enum AnyLight<'a> {
    /// Phong's model once a triangle.
    Flat(PerTriangle<'a, PointLit<Mirrored>>),
    /// At the corners.
    Vertex(PerCorner<'a, PointLit<Mirrored>>),
    /// At each pixel.
    Phong(PerPixel<'a, PointLit<Mirrored>>),
    /// Blinn's model at each pixel.
    BlinnPhong(PerPixel<'a, PointLit<Halfway>>),
}

impl Shader for AnyLight<'_> {
    type Constant = Reflected;
    /// (u, v), and what the others interpolate at most: the position and the normal.
    type Varying = (Vec2, (Vec3, Vec3));
    type Output = Color;

    fn position(&self, vertex: usize) -> Vec4 {
        match self {
            Self::Flat(shader) => shader.position(vertex),
            Self::Vertex(shader) => shader.position(vertex),
            Self::Phong(shader) => shader.position(vertex),
            Self::BlinnPhong(shader) => shader.position(vertex),
        }
    }

    fn triangle(&self, face: usize) -> Option<Reflected> {
        match self {
            Self::Flat(shader) => shader.triangle(face),
            _ => Some(Reflected { body: 0.0, highlight: 0.0 }),
        }
    }

    fn corner(&self, face: usize, corner: usize) -> Self::Varying {
        match self {
            Self::Flat(shader) => (shader.corner(face, corner), (Vec3::ZERO, Vec3::ZERO)),
            Self::Vertex(shader) => {
                let (uv, (body, highlight)) = shader.corner(face, corner);
                (uv, (Vec3::new(body, highlight, 0.0), Vec3::ZERO))
            }
            Self::Phong(shader) => shader.corner(face, corner),
            Self::BlinnPhong(shader) => shader.corner(face, corner),
        }
    }

    #[inline]
    fn fragment(&self, constant: Reflected, fragment: Fragment<Self::Varying>) -> Option<Color> {
        let Fragment { x, y, depth, varying: (uv, (first, _)) } = fragment;
        match self {
            Self::Flat(shader) => shader.fragment(constant, Fragment { x, y, depth, varying: uv }),
            Self::Vertex(shader) => {
                let varying = (uv, (first.x, first.y));
                shader.fragment((), Fragment { x, y, depth, varying })
            }
            Self::Phong(shader) => shader.fragment((), fragment),
            Self::BlinnPhong(shader) => shader.fragment((), fragment),
        }
    }
}

/// Draws a scene as lesson 12 does.
pub fn draw(scene: &Scene, light: Make, mesh: &Mesh, image: &mut Image) -> Counts {
    shader::draw(&light(scene), mesh, Cull::Back, image).counts
}
