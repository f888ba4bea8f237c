//! A filtered texture under a light.

use common::{Color, Vec2, Vec4};
use shaders::Uniforms;
use shaders::lighting::Lighting;
use shaders::shader::{Fragment, Shader};

use crate::filter::Filter;
use crate::footprint::{Asked, Gradients};
use crate::layout::{Layout, Rows};
use crate::texture::Texture;

// ANCHOR: filtered
/// A texture, filtered in one way, under a lighting.
pub struct Filtered<'a, F, L, O = Rows> {
    /// The model, its normals, the light and the camera. Their texture is not looked at.
    pub uniforms: Uniforms<'a>,
    /// The texture, in some layout.
    pub texture: &'a Texture<O>,
    /// How it is filtered.
    pub filter: F,
    /// How it is lit.
    pub lighting: L,
    /// The picture's size in pixels.
    pub size: Vec2,
}

impl<F: Filter, L: Lighting, O: Layout> Shader for Filtered<'_, F, L, O> {
    /// What the filter must know of a triangle to tell footprints, if it asks for any, and what the lighting keeps.
    type Constant = (<F::Footprint as Asked>::Constant, L::Constant);
    type Varying = (Vec2, L::Varying);
    type Output = Color;

    #[inline]
    fn position(&self, vertex: usize) -> Vec4 {
        self.uniforms.to_clip * self.uniforms.model.positions()[vertex].extend(1.0)
    }

    #[inline]
    fn triangle(&self, face: usize) -> Option<Self::Constant> {
        let lighting = self.lighting.triangle(&self.uniforms, face)?;
        let model = self.uniforms.model;
        let gradients = || {
            let corners = model.triangles()[face].map(|vertex| self.position(vertex as usize));
            Gradients::new(corners, [0, 1, 2].map(|corner| model.uv(face, corner)), self.size)
        };
        Some((F::Footprint::triangle(gradients), lighting))
    }

    #[inline]
    fn corner(&self, face: usize, corner: usize) -> Self::Varying {
        let uniforms = &self.uniforms;
        (uniforms.model.uv(face, corner), self.lighting.corner(uniforms, face, corner))
    }

    #[inline]
    fn fragment(&self, constant: Self::Constant, fragment: Fragment<Self::Varying>) -> Option<Color> {
        let (triangle, lighting) = constant;
        let Fragment { x, y, varying: (uv, lit), .. } = fragment;
        let intensity = self.lighting.intensity(lighting, lit);
        (intensity >= 0.0).then(|| {
            let footprint = F::Footprint::at(triangle, x, y, uv);
            self.filter.color(self.texture, uv, footprint).shaded(intensity)
        })
    }
}
// ANCHOR_END: filtered
