//! How often a model of reflection is computed: once a triangle, at its corners, or at each of its pixels.

use clipping::{Clipping, Cull, Drawn, Mesh, render};
use common::direction::{scaled, unit};
use common::{Color, Image, Vec2, Vec3, Vec4};
use perspective::Framebuffer;
use perspective::depth::ZF32;
use shaders::shader::{Fragment, Shader};

use crate::light::Reflected;
use crate::normalisation::Normalisation;
use crate::power::Power;
use crate::reflection::{Highlight, PointLit, Reflection};
use crate::scene::Scene;
use crate::surface::{Smooth, Surface};

/// Once a triangle, at its middle, with its own normal.
pub struct PerTriangle<'a, R> {
    scene: Scene<'a>,
    reflection: R,
}

/// At the corners of each triangle; what is reflected is interpolated.
pub struct PerCorner<'a, R> {
    scene: Scene<'a>,
    reflection: R,
}

/// At each pixel, where the position and what the surface asks for are interpolated.
pub struct PerPixel<'a, R, S = Smooth> {
    scene: Scene<'a>,
    reflection: R,
    surface: S,
}

impl<'a, R: Reflection> PerTriangle<'a, R> {
    /// For a scene under its light.
    #[must_use]
    pub fn new(scene: &Scene<'a>) -> Self {
        Self { scene: *scene, reflection: R::new(&scene.light) }
    }
}

impl<'a, R: Reflection> PerCorner<'a, R> {
    /// For a scene under its light.
    #[must_use]
    pub fn new(scene: &Scene<'a>) -> Self {
        Self { scene: *scene, reflection: R::new(&scene.light) }
    }
}

impl<'a, R: Reflection, S: Surface> PerPixel<'a, R, S> {
    /// For a scene under its light, with that surface.
    #[must_use]
    pub fn new(scene: &Scene<'a>, surface: S) -> Self {
        Self { scene: *scene, reflection: R::new(&scene.light), surface }
    }
}

// ANCHOR: per_triangle
impl<R: Reflection> Shader for PerTriangle<'_, R> {
    type Constant = Reflected;
    type Varying = Vec2;
    type Output = Color;

    #[inline]
    fn position(&self, vertex: usize) -> Vec4 {
        position(&self.scene, vertex)
    }

    #[inline]
    fn triangle(&self, face: usize) -> Option<Reflected> {
        let [a, b, c] = [0, 1, 2].map(|corner| self.scene.position(face, corner));
        // The product of two sides may be no f32: they are scaled first.
        let normal = unit(scaled(b - a).cross(scaled(c - a))).unwrap_or_default();
        Some(self.reflection.reflect((a + b + c) / 3.0, normal, self.scene.eye))
    }

    #[inline]
    fn corner(&self, face: usize, corner: usize) -> Vec2 {
        self.scene.uv(face, corner)
    }

    #[inline]
    fn fragment(&self, reflected: Reflected, fragment: Fragment<Vec2>) -> Option<Color> {
        Some(reflected.color(self.scene.texel(fragment.varying)))
    }
}
// ANCHOR_END: per_triangle

// ANCHOR: per_corner
impl<R: Reflection> Shader for PerCorner<'_, R> {
    type Constant = ();
    /// (u, v), and what is reflected of the body's colour and of white.
    type Varying = (Vec2, (f32, f32));
    type Output = Color;

    #[inline]
    fn position(&self, vertex: usize) -> Vec4 {
        position(&self.scene, vertex)
    }

    #[inline]
    fn triangle(&self, _: usize) -> Option<()> {
        Some(())
    }

    #[inline]
    fn corner(&self, face: usize, corner: usize) -> Self::Varying {
        let (point, normal) = (self.scene.position(face, corner), self.scene.normal(face, corner));
        let Reflected { body, highlight } = self.reflection.reflect(point, normal, self.scene.eye);
        (self.scene.uv(face, corner), (body, highlight))
    }

    #[inline]
    fn fragment(&self, (): (), fragment: Fragment<Self::Varying>) -> Option<Color> {
        let (uv, (body, highlight)) = fragment.varying;
        Some(Reflected { body, highlight }.color(self.scene.texel(uv)))
    }
}
// ANCHOR_END: per_corner

// ANCHOR: per_pixel
impl<R: Reflection, S: Surface> Shader for PerPixel<'_, R, S> {
    type Constant = S::Constant;
    /// (u, v), the position in the world, and what the surface interpolates.
    type Varying = (Vec2, (Vec3, S::Varying));
    type Output = Color;

    #[inline]
    fn position(&self, vertex: usize) -> Vec4 {
        position(&self.scene, vertex)
    }

    #[inline]
    fn triangle(&self, face: usize) -> Option<S::Constant> {
        Some(self.surface.triangle(&self.scene, face))
    }

    #[inline]
    fn corner(&self, face: usize, corner: usize) -> Self::Varying {
        let scene = &self.scene;
        let varying = self.surface.corner(scene, face, corner);
        (scene.uv(face, corner), (scene.position(face, corner), varying))
    }

    #[inline]
    fn fragment(&self, constant: S::Constant, fragment: Fragment<Self::Varying>) -> Option<Color> {
        let (uv, (point, varying)) = fragment.varying;
        let shape = self.surface.at(&self.scene, constant, uv, varying);
        let Reflected { body, highlight } = self.reflection.reflect(point, shape.normal, self.scene.eye);
        Some(Reflected { body, highlight: highlight * shape.gloss }.color(self.scene.texel(uv)))
    }
}
// ANCHOR_END: per_pixel

#[inline]
fn position(scene: &Scene, vertex: usize) -> Vec4 {
    scene.uniforms.to_clip * scene.uniforms.model.positions()[vertex].extend(1.0)
}

// ANCHOR: draw
/// Draws a mesh by a shader, in lesson 11's loop.
pub fn draw<S: Shader<Output = Color>>(shader: &S, mesh: &Mesh, cull: Cull, image: &mut Image) -> Drawn {
    let mut target = Framebuffer::new(image, ZF32);
    let counts = render(shader, mesh, cull, Clipping::GuardBand, &mut target);
    Drawn { depths: target.depths, counts }
}
// ANCHOR_END: draw

/// Draws a smooth scene, each pixel lit by one of the two highlights, one way to make vectors 1 long and one way to compute
/// powers.
pub(crate) fn per_pixel<H: Highlight, N: Normalisation, P: Power>(
    scene: &Scene,
    mesh: &Mesh,
    cull: Cull,
    image: &mut Image,
) -> Drawn {
    draw(&PerPixel::<PointLit<H, N, P>>::new(scene, Smooth), mesh, cull, image)
}
