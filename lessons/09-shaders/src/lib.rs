//! Lesson 9: any look from one loop.
//!
//! **You will see** the head four times: flat and smooth, white and textured. **New:** nothing is drawn that was
//! not drawn before; what lessons 4 to 8 had in three loops is in one, and what differs is in a shader.
//!
//! The job: draw with any shader. [`program::Shader`] says what a shader is: what is computed at a corner and
//! interpolated, what once a triangle, what at a pixel. [`source`] has the colours (white, a texture), [`lighting`]
//! the brightness (flat, Gouraud, in steps), and [`Look`] puts one of each together: five looks in [`SHADERS`]
//! from five parts, none written twice.
//!
//! [`METHODS`] holds two ways to call a shader: through `dyn`, decided at every pixel when the program runs,
//! and generic, compiled once for each shader. One loop, [`program::render`], serves both.
//!
//! What it replaces: `draw_nearest` of lesson 4, `draw_textured` of lesson 5, `draw` of lesson 6, and the main
//! programs of 7 and 8 but for their matrices.
//!
//! Conventions: as in lessons 4 to 8. What has negative brightness is dropped: a whole triangle by the flat
//! shaders, a fragment by the others. A dropped fragment leaves colour and depth alone. Varyings are
//! interpolated in the picture, so a texture warps under perspective.

pub mod lighting;
pub mod program;
pub mod source;

use std::cell::RefCell;

use common::{Attributes, Color, Image, Lesson, Mat4, Method, Model, Table, Vec3, Vec4};
use zbuffer::DepthBuffer;

use lighting::{Flat, Gouraud, Lighting, Quantized};
use program::{Program, Shader, Stored, render};
use source::{Source, Texture, White};

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

/// What is drawn, from where, and under which light.
pub struct Scene<'a> {
    /// The triangles, with texture coordinates if the shader needs them.
    pub model: &'a Model,
    /// The unit normals at the corners of each triangle, if the shader needs them.
    pub normals: Vec<[Vec3; 3]>,
    /// The texture, if the shader needs it.
    pub texture: Option<&'a Image>,
    /// Unit vector from the surface to the light.
    pub light: Vec3,
    /// Viewport × projection × view: from the model's space to pixels and depth, before division by w.
    pub to_screen: Mat4,
    /// Steps of the quantized shader, at least 1.
    pub levels: u16,
}

/// A picture and the depths of what is seen in it.
pub struct Target {
    /// The picture.
    pub image: Image,
    /// The nearest depth in each pixel.
    pub depths: DepthBuffer<f32>,
}

impl Target {
    /// An empty target for a picture.
    #[must_use]
    pub fn new(image: Image) -> Self {
        let depths = DepthBuffer::new(&image, f32::NEG_INFINITY);
        Self { image, depths }
    }
}

// ANCHOR: look
/// A colour source under a lighting.
pub struct Look<'a, S, L> {
    scene: &'a Scene<'a>,
    source: S,
    lighting: L,
}

impl<'a, S, L> Look<'a, S, L> {
    /// One of each.
    pub fn new(scene: &'a Scene, source: S, lighting: L) -> Self {
        Self { scene, source, lighting }
    }
}

impl<S: Source, L: Lighting> Shader for Look<'_, S, L> {
    type Constant = L::Constant;
    type Varying = (S::Varying, L::Varying);

    fn triangle(&self, face: usize) -> Option<L::Constant> {
        self.lighting.triangle(face)
    }

    #[inline]
    fn vertex(&self, face: usize, corner: usize) -> (Vec4, Self::Varying) {
        let position = self.scene.to_screen * self.scene.model.position(face, corner).extend(1.0);
        (position, (self.source.vertex(face, corner), self.lighting.vertex(face, corner)))
    }

    #[inline]
    fn fragment(&self, constant: L::Constant, (source, lighting): Self::Varying) -> Option<Color> {
        let intensity = self.lighting.intensity(constant, lighting);
        (intensity >= 0.0).then(|| self.source.color(source).shaded(intensity))
    }
}
// ANCHOR_END: look

/// Draws a scene; returns how many triangles were left out since they reach behind the eye.
pub type Render = fn(&Scene, &mut Target) -> usize;

/// One shader, compiled both ways.
pub struct Rendering {
    /// What it needs of the model; with texture coordinates it needs a texture, too.
    pub needs: Attributes,
    /// Bytes that it interpolates for each pixel.
    pub interpolated: usize,
    /// Draws by the loop compiled for this shader.
    pub generic: Render,
    /// Draws by the loop that calls any shader.
    pub dynamic: Render,
}

// ANCHOR: macro
/// Makes a [`Rendering`] of a colour source and a lighting.
macro_rules! look {
    ($source:ident, $lighting:ident, $needs:expr) => {{
        fn look<'a>(scene: &'a Scene) -> impl Shader + 'a {
            Look::new(scene, $source::new(scene), $lighting::new(scene))
        }
        Rendering {
            needs: $needs,
            interpolated: size_of::<(<$source as Source>::Varying, <$lighting as Lighting>::Varying)>(),
            generic: |scene, target| render(&look(scene), scene.model.faces().len(), target),
            dynamic: |scene, target| {
                let program: &mut dyn Program = &mut Stored::new(look(scene));
                render(&RefCell::new(program), scene.model.faces().len(), target)
            },
        }
    }};
}
// ANCHOR_END: macro

const NOTHING: Attributes = Attributes { normals: false, uvs: false };
const UVS: Attributes = Attributes { normals: false, uvs: true };
const NORMALS: Attributes = Attributes { normals: true, uvs: false };
const BOTH: Attributes = Attributes { normals: true, uvs: true };

/// The shaders. The first four make the lesson's sheet, two a row.
pub const SHADERS: &[Method<Rendering>] = &[
    Method {
        name: "flat",
        run: look!(White, Flat, NOTHING),
        promise: "each triangle in one grey; interpolates nothing",
        failure: "facets",
    },
    Method {
        name: "flat-texture",
        run: look!(Texture, Flat, UVS),
        promise: "the texture, each triangle in one brightness; interpolates 2 numbers",
        failure: "facets; the texture warps under perspective",
    },
    Method {
        name: "gouraud",
        run: look!(White, Gouraud, NORMALS),
        promise: "smooth greys; interpolates 1 number",
        failure: "highlights smaller than a triangle are lost",
    },
    Method {
        name: "gouraud-texture",
        run: look!(Texture, Gouraud, BOTH),
        promise: "the texture, smoothly lit; interpolates 3 numbers",
        failure: "the texture warps under perspective",
    },
    Method {
        name: "quantized",
        run: look!(White, Quantized, NORMALS),
        promise: "as many greys as asked for, as in a comic; interpolates 1 number",
        failure: "with 1 level all is black but where the light falls straight",
    },
];

/// The way in which a look is drawn by one method.
pub type Choose = fn(&Rendering) -> Render;

/// The ways to call a shader.
pub const METHODS: &[Method<Choose>] = &[
    Method {
        name: "dyn",
        run: |rendering| rendering.dynamic,
        promise: "one loop in the program for all shaders, even those it does not know yet",
        failure: "a call through a table at every pixel, which nothing can be moved across",
    },
    Method {
        name: "generic",
        run: |rendering| rendering.generic,
        promise: "the same pixels; a loop for each shader, in which what it does not use does not exist",
        failure: "the program grows with every shader, and must know them all",
    },
];
