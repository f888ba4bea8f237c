//! Lesson 9's looks, chosen when the program runs: two loops, where the lesson has two for each.

use std::hint::black_box;

use common::{Color, Method, Vec2};
use shaders::lighting::{Flat, Gouraud, Lighting, Quantized};
use shaders::shader::{Shader, render};
use shaders::source::{Source, Texture, White};
use shaders::{Framebuffer, Lit, Uniforms};

use crate::input::with;

/// A colour source under a lighting.
#[derive(Clone, Copy)]
pub(crate) struct AnyLook {
    source: AnySource,
    lighting: AnyLighting,
}

/// The lesson's table.
pub(crate) const LOOKS: &[Method<AnyLook>] = &with(
    shaders::SHADERS,
    [
        AnyLook { source: AnySource::White, lighting: AnyLighting::Flat },
        AnyLook { source: AnySource::Texture, lighting: AnyLighting::Flat },
        AnyLook { source: AnySource::White, lighting: AnyLighting::Gouraud },
        AnyLook { source: AnySource::Texture, lighting: AnyLighting::Gouraud },
        AnyLook { source: AnySource::White, lighting: AnyLighting::Quantized },
    ],
);

impl AnyLook {
    /// Bytes that the lesson's shader interpolates for each pixel.
    pub(crate) const fn interpolated(self) -> usize {
        let source = match self.source {
            AnySource::White => 0,
            AnySource::Texture => size_of::<Vec2>(),
        };
        let lighting = match self.lighting {
            AnyLighting::Flat => 0,
            AnyLighting::Gouraud | AnyLighting::Quantized => size_of::<f32>(),
        };
        source + lighting
    }
}

/// Draws a look.
type Call = fn(AnyLook, &Uniforms, &mut Framebuffer);

/// The lesson's ways to call a shader.
pub(crate) const CALLS: &[Method<Call>] = &with(shaders::METHODS, [dynamic, generic]);

fn dynamic(look: AnyLook, uniforms: &Uniforms, target: &mut Framebuffer) {
    let shader = Lit::new(*uniforms, look.source, look.lighting);
    let shader: &dyn Shader<Constant = f32, Varying = (Vec2, f32), Output = Color> = black_box(&shader);
    render(shader, uniforms.model.positions().len(), uniforms.model.triangles(), target);
}

fn generic(look: AnyLook, uniforms: &Uniforms, target: &mut Framebuffer) {
    shaders::draw(uniforms, look.source, look.lighting, target);
}

/// Any of the lesson's sources.
#[derive(Clone, Copy)]
enum AnySource {
    White,
    Texture,
}

impl Source for AnySource {
    type Varying = Vec2;

    #[inline]
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> Vec2 {
        Texture.corner(uniforms, face, corner)
    }

    #[inline]
    fn color(&self, uniforms: &Uniforms, uv: Vec2) -> Color {
        match self {
            Self::White => White.color(uniforms, ()),
            Self::Texture => Texture.color(uniforms, uv),
        }
    }
}

/// Any of its lightings.
#[derive(Clone, Copy)]
enum AnyLighting {
    Flat,
    Gouraud,
    Quantized,
}

impl Lighting for AnyLighting {
    type Constant = f32;
    type Varying = f32;

    #[inline]
    fn triangle(&self, uniforms: &Uniforms, face: usize) -> Option<f32> {
        match self {
            Self::Flat => Flat.triangle(uniforms, face),
            Self::Gouraud | Self::Quantized => Quantized.triangle(uniforms, face),
        }
    }

    #[inline]
    fn corner(&self, uniforms: &Uniforms, face: usize, corner: usize) -> f32 {
        Gouraud.corner(uniforms, face, corner)
    }

    #[inline]
    fn intensity(&self, constant: f32, varying: f32) -> f32 {
        match self {
            Self::Flat => Flat.intensity(constant, ()),
            Self::Gouraud => Gouraud.intensity((), varying),
            Self::Quantized => Quantized.intensity(constant, varying),
        }
    }
}

#[cfg(test)]
mod tests {
    use common::Vec3;
    use perspective::scene::Loaded;

    use super::*;
    use crate::head::{HEAD, canvas};

    #[test]
    fn looks_are_as_the_lesson_draws_them() {
        let Loaded { model, normals, texture, .. } = &*HEAD;
        let uniforms = Uniforms { normals, texture: Some(texture), light: Vec3::Z, ..Uniforms::new(model) };
        for (own, lesson) in LOOKS.iter().zip(shaders::SHADERS) {
            assert_eq!(own.run.interpolated(), lesson.run.interpolated, "{}", own.name);
            for (call, way) in CALLS.iter().zip(shaders::METHODS) {
                let [mut drawn, mut meant] = [canvas(100), canvas(100)].map(Framebuffer::new);
                (call.run)(own.run, &uniforms, &mut drawn);
                (way.run)(&lesson.run)(&uniforms, &mut meant);
                assert!(drawn.image == meant.image, "{}, {}", own.name, call.name);
            }
        }
    }
}
