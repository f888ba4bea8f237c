//! Lesson 13: a texture without flicker.
//!
//! **You will see** lesson 11's floor without the grains into which its far checks fell, and a head whose texture has no
//! stairs from near and no sparks from afar. **New:** a pixel is a square, not a point, and sees as much of a texture as
//! lies under it, its footprint; textures in levels, each half as large as the one before; light instead of codes, where
//! colours are averaged.
//!
//! The job: the colour of a pixel's whole footprint in a texture. [`footprint`](mod@footprint) tells how large that is and
//! which level suits it, [`filter`] has the ways to look up a colour ([`METHODS`]), [`mipmap`] those to make the levels
//! ([`MIPMAPS`]), [`wrap`] what a texture is outside of itself ([`WRAPS`]), [`layout`] where its texels are in memory
//! ([`LAYOUTS`]), [`light`] what codes mean, [`texture`] is what filters read, and [`shader`] draws with it. From lesson 9
//! come shaders and lightings, from lesson 10 the camera, from lesson 11 the loop over triangles: all unchanged.
//!
//! Conventions: as in lessons 5 and 11. Texel (i, j) of a texture of w×h has its centre at ((i + ½)/w, (j + ½)/h). Light is
//! counted from 0 to 255. Only the averaging of texels is in light; shading multiplies codes, as before.

pub mod filter;
pub mod footprint;
pub mod layout;
pub mod light;
pub mod mipmap;
pub mod scene;
pub mod shader;
pub mod texture;
pub mod wrap;

use clipping::{Clipping, Counts, Cull, Drawn, Mesh, render};
use common::{Color, Image, Lesson, Method, Table, Vec2};
use perspective::Framebuffer;
use perspective::depth::ZF32;
use perspective::lighting::Clamped;
use shaders::Uniforms;

use filter::{Anisotropic, Bilinear, Bilinear8, Filter, Nearest, Trilinear};
use footprint::Asked;
use shader::Filtered;

pub use filter::{anisotropic, bilinear, bilinear_8, nearest, trilinear};
pub use footprint::{Footprint, level};
pub use layout::LAYOUTS;
pub use mipmap::MIPMAPS;
pub use texture::{Level, Texture};
pub use wrap::{WRAPS, Wrap};

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 13,
    name: "filtering",
    title: "Filtering",
    job: "a texture without flicker",
    tables: &[
        Table { name: "", job: "Filter a texture", rows: || Method::rows(METHODS) },
        Table { name: "mipmaps", job: "Make smaller levels", rows: || Method::rows(MIPMAPS) },
        Table { name: "wraps", job: "Go beyond the border", rows: || Method::rows(WRAPS) },
        Table { name: "layouts", job: "Keep texels", rows: || Method::rows(LAYOUTS) },
    ],
};

/// One method as two functions that share their code.
pub struct Sampler {
    /// Draws surfaces, smoothly lit; compiled for just this filter, it is timed.
    pub draw: fn(&[Surface], Cull, &mut Image) -> Drawn,
    /// The colour of a texture at (u, v), the centre of a pixel with that footprint.
    pub color: fn(&Texture, Vec2, Footprint) -> Color,
}

impl Sampler {
    const fn new<F: Filter + Default>() -> Self {
        Self {
            draw: |surfaces, cull, image| draw(surfaces, F::default(), cull, image),
            color: |texture, uv, footprint| F::default().color(texture, uv, F::Footprint::of(footprint)),
        }
    }
}

/// The ways to find the colour of a pixel, from the first idea to the last.
pub const METHODS: &[Method<Sampler>] = &[
    Method {
        name: "nearest",
        run: Sampler::new::<Nearest>(),
        promise: "the texel that the pixel's centre is in, as in lesson 5: one fetch",
        failure: "stairs where a texture is enlarged; where it is made smaller it sparkles, and flickers as it moves",
    },
    Method {
        name: "bilinear",
        run: Sampler::new::<Bilinear>(),
        promise: "linear between the centres of four texels: smooth where a texture is enlarged",
        failure: "made smaller by more than 2 it leaves texels out, and flickers like nearest",
    },
    Method {
        name: "bilinear-8",
        run: Sampler::new::<Bilinear8>(),
        promise: "the same with weights of 8 bits, as graphics hardware has them",
        failure: "the same; no step of light is finer than 1/256 of a difference: from black to white the first is 13 codes",
    },
    Method {
        name: "trilinear",
        run: Sampler::new::<Trilinear>(),
        promise: "bilinear in the two levels next to the footprint's size, and linear between them: no jump, hardly a flicker",
        failure: "as coarse in all directions as the footprint is in its longest: a floor is a blur long before the horizon",
    },
    Method {
        name: "anisotropic",
        run: Sampler::new::<Anisotropic>(),
        promise: "up to 16 trilinear probes along the footprint, each as coarse as it is wide: sharp to near the horizon",
        failure: "up to 16 times the work; footprints more than 16 times as long as wide are blurred again",
    },
];

/// A mesh with its texture.
pub struct Surface<'a> {
    /// The model, its normals, the light and the camera.
    pub uniforms: Uniforms<'a>,
    /// Its vertices and triangles.
    pub mesh: &'a Mesh,
    /// Its texture.
    pub texture: &'a Texture,
}

// ANCHOR: draw
/// Draws surfaces, filtered in one way and smoothly lit.
pub fn draw<F: Filter>(surfaces: &[Surface], filter: F, cull: Cull, image: &mut Image) -> Drawn {
    let size = image.size();
    let mut target = Framebuffer::new(image, ZF32);
    let mut counts = Counts::default();
    for &Surface { uniforms, mesh, texture } in surfaces {
        let shader = Filtered { uniforms, texture, filter, lighting: Clamped, size };
        counts += render(&shader, mesh, cull, Clipping::GuardBand, &mut target);
    }
    Drawn { depths: target.depths, counts }
}
// ANCHOR_END: draw
