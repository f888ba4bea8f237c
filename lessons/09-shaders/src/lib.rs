//! Lesson 9: any look from one loop.
//!
//! **You will see** the head four times: flat and smooth, white and textured. **New:** nothing is drawn that was
//! not drawn before; what lessons 4 to 8 had in three loops is in one, and what differs is in a shader.
//!
//! The job: draw with any shader. [`shader::Shader`] says what a shader is: what is computed at a vertex, what once
//! a triangle, what at a corner and interpolated, what at a pixel. [`source`] has the colours (white, a texture),
//! [`lighting`] the brightness (flat, Gouraud, in steps), and [`Lit`] puts one of each together: five looks in
//! [`SHADERS`] from five parts, none written twice. What they make goes to a [`target`].
//!
//! [`METHODS`] holds two ways to call a shader: through `dyn`, decided at every pixel when the program runs,
//! and generic, compiled once for each shader. One loop, [`shader::render`], serves both.
//!
//! What it replaces: `draw_nearest` of lesson 4, `draw_textured` of lesson 5, `draw` of lesson 6, and the main
//! programs of 7 and 8 but for their matrices.
//!
//! Conventions: as in lessons 4 to 8, but for the picture's place in a matrix: a position is in the square −w ≤ x, y ≤ w,
//! which becomes the whole picture, so that how large the model is in it belongs to the projection. What has negative
//! brightness is dropped: a whole triangle by the flat shaders, a fragment by the others. A dropped fragment leaves
//! colour and depth alone. Varyings are interpolated in the picture, so a texture warps under perspective; lesson 10
//! mends it.

pub mod lighting;
pub mod shader;
pub mod source;
pub mod target;

use std::hint::black_box;

use common::{Attributes, Color, Image, Lesson, Mat4, Method, Model, Table, Vec2, Vec3, Vec4};
use textures::Wrap;
use transforms::scale;

use lighting::{Flat, Gouraud, Lighting, Quantized};
use shader::{Fragment, Shader, render};
use source::{Source, Texture, White};

pub use target::Framebuffer;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 9,
    name: "shaders",
    title: "Shaders",
    job: "any look from one loop",
    tables: &[
        Table { name: "", job: "Call a shader", rows: || Method::rows(METHODS) },
        Table { name: "looks", job: "Choose a look", rows: || Method::rows(SHADERS) },
    ],
};

/// What the shaders read, the same for all vertices and fragments of a picture.
#[derive(Clone, Copy)]
pub struct Uniforms<'a> {
    /// The triangles, with texture coordinates if the shader needs them.
    pub model: &'a Model,
    /// The unit normals at the corners of each triangle, if the shader needs them.
    pub normals: &'a [[Vec3; 3]],
    /// The texture, if the shader needs it.
    pub texture: Option<&'a Image>,
    /// What the texture is outside.
    pub wrap: Wrap,
    /// Unit vector from the surface to the light.
    pub light: Vec3,
    /// Projection × view: from the model's space to the square of the picture and depth, before division by w.
    pub to_clip: Mat4,
    /// Steps of the quantized shader, at least 1.
    pub levels: u16,
}

impl<'a> Uniforms<'a> {
    /// A model as it stands, without normals or texture, lit from the front, in six steps.
    #[must_use]
    pub fn new(model: &'a Model) -> Self {
        Self {
            model,
            normals: &[],
            texture: None,
            wrap: Wrap::Clamp,
            light: Vec3::Z,
            to_clip: Mat4::IDENTITY,
            levels: 6,
        }
    }
}

/// Lets a length of 1 take up `zoom` times the smaller side of a picture of that size, to the right and up. With
/// `zoom` ½ the square from −1 to 1 fits in.
// ANCHOR: fit
#[must_use]
pub fn fit(zoom: f32, size: Vec2) -> Mat4 {
    scale((2.0 * zoom * size.min_element() / size).extend(1.0))
}
// ANCHOR_END: fit

// ANCHOR: lit
/// A colour source under a lighting.
pub struct Lit<'a, S, L> {
    uniforms: Uniforms<'a>,
    source: S,
    lighting: L,
}

impl<'a, S: Source, L: Lighting> Lit<'a, S, L> {
    /// With what both read.
    #[must_use]
    pub fn new(uniforms: Uniforms<'a>, source: S, lighting: L) -> Self {
        Self { uniforms, source, lighting }
    }
}

impl<S: Source, L: Lighting> Shader for Lit<'_, S, L> {
    type Constant = L::Constant;
    type Varying = (S::Varying, L::Varying);
    type Output = Color;

    #[inline]
    fn position(&self, vertex: usize) -> Vec4 {
        self.uniforms.to_clip * self.uniforms.model.positions()[vertex].extend(1.0)
    }

    #[inline]
    fn triangle(&self, face: usize) -> Option<L::Constant> {
        self.lighting.triangle(&self.uniforms, face)
    }

    #[inline]
    fn corner(&self, face: usize, corner: usize) -> Self::Varying {
        let uniforms = &self.uniforms;
        (self.source.corner(uniforms, face, corner), self.lighting.corner(uniforms, face, corner))
    }

    #[inline]
    fn fragment(&self, constant: L::Constant, fragment: Fragment<Self::Varying>) -> Option<Color> {
        let (source, lighting) = fragment.varying;
        let intensity = self.lighting.intensity(constant, lighting);
        (intensity >= 0.0).then(|| self.source.color(&self.uniforms, source).shaded(intensity))
    }
}
// ANCHOR_END: lit

/// Draws with a shader; returns how many triangles were left out since they reach behind the eye.
pub type Draw = fn(&Uniforms, &mut Framebuffer) -> usize;

/// One shader, compiled both ways.
pub struct Look {
    /// What it needs of the model; with texture coordinates it needs a texture, too.
    pub needs: Attributes,
    /// Bytes that it interpolates for each pixel.
    pub interpolated: usize,
    /// Draws by the loop compiled for this shader.
    pub generic: Draw,
    /// Draws by the loop that calls any shader of the same types.
    pub dynamic: Draw,
}

// ANCHOR: ways
impl Look {
    /// A colour source under a lighting.
    const fn new<S: Source + Default, L: Lighting + Default>(needs: Attributes) -> Self {
        Self {
            needs,
            interpolated: size_of::<(S::Varying, L::Varying)>(),
            generic: |uniforms, target| draw(uniforms, S::default(), L::default(), target),
            dynamic: draw_dynamic::<S, L>,
        }
    }
}

/// Draws by the loop compiled for this source and lighting.
pub fn draw(
    uniforms: &Uniforms,
    source: impl Source,
    lighting: impl Lighting,
    target: &mut Framebuffer,
) -> usize {
    let shader = Lit::new(*uniforms, source, lighting);
    render(&shader, uniforms.model.positions().len(), uniforms.model.triangles(), target)
}

/// A shader of which the loop knows what it computes with, and nothing else.
type AnyShader<'a, C, V> = &'a dyn Shader<Constant = C, Varying = V, Output = Color>;

fn draw_dynamic<S: Source + Default, L: Lighting + Default>(
    uniforms: &Uniforms,
    target: &mut Framebuffer,
) -> usize {
    let shader = Lit::new(*uniforms, S::default(), L::default());
    // Without the box the compiler might see which one it is, and call it directly.
    let shader: AnyShader<L::Constant, (S::Varying, L::Varying)> = black_box(&shader);
    render(shader, uniforms.model.positions().len(), uniforms.model.triangles(), target)
}
// ANCHOR_END: ways

const NOTHING: Attributes = Attributes { normals: false, uvs: false };
const UVS: Attributes = Attributes { normals: false, uvs: true };
const NORMALS: Attributes = Attributes { normals: true, uvs: false };
const BOTH: Attributes = Attributes { normals: true, uvs: true };

/// The shaders. The first four make the lesson's sheet, two a row.
pub const SHADERS: &[Method<Look>] = &[
    Method {
        name: "flat",
        run: Look::new::<White, Flat>(NOTHING),
        promise: "each triangle in one grey; interpolates nothing",
        failure: "facets",
    },
    Method {
        name: "flat-texture",
        run: Look::new::<Texture, Flat>(UVS),
        promise: "the texture, each triangle in one brightness; interpolates 2 numbers",
        failure: "facets; the texture warps under perspective",
    },
    Method {
        name: "gouraud",
        run: Look::new::<White, Gouraud>(NORMALS),
        promise: "smooth greys; interpolates 1 number",
        failure: "highlights smaller than a triangle are lost",
    },
    Method {
        name: "gouraud-texture",
        run: Look::new::<Texture, Gouraud>(BOTH),
        promise: "the texture, smoothly lit; interpolates 3 numbers",
        failure: "the texture warps under perspective",
    },
    Method {
        name: "quantized",
        run: Look::new::<White, Quantized>(NORMALS),
        promise: "as many greys as asked for, as in a comic; interpolates 1 number",
        failure: "with 1 level all is black but where the light falls straight",
    },
];

/// The way in which a look is drawn by one method.
pub type Call = fn(&Look) -> Draw;

/// The ways to call a shader.
pub const METHODS: &[Method<Call>] = &[
    Method {
        name: "dyn",
        run: |look| look.dynamic,
        promise: "one loop for all shaders that compute with the same types, even those it does not know yet",
        failure: "a call through a table at every pixel, which nothing can be moved across",
    },
    Method {
        name: "generic",
        run: |look| look.generic,
        promise: "the same pixels; a loop for each shader, in which what it does not use does not exist",
        failure: "the program grows with every shader, and must know them all",
    },
];
