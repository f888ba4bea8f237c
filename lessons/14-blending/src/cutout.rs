//! A leaf that its alpha cuts out, filtered and laid over a bright wall: where its colours are kept straight, with a dark
//! fringe.

use std::path::Path;

use clipping::mesh::indexed;
use clipping::{Clipping, Cull, Mesh, render};
use common::{Attributes, Color, Image, Mat4, Model, Vec2, Vec3};
use filtering::filter::Bilinear;
use filtering::shader::Filtered;
use filtering::{Texture, Wrap};
use shaders::Uniforms;
use shaders::lighting::Flat;
use zbuffer::DepthBuffer;

use crate::space::Space;
use crate::state::State;
use crate::target::Framebuffer;

/// The model of a square, and a picture with an alpha: a frond of a fern.
pub const FERN: [&str; 2] = [
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/square.obj"),
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/fern.png"),
];

/// What is behind it.
pub const WALL: Color = Color::rgb(0xf3, 0xe9, 0xd8);

/// A square and what is drawn on it.
pub struct Cutout {
    model: Model,
    mesh: Mesh,
    /// With straight alpha.
    pub picture: Image,
}

impl Cutout {
    /// Reads a square and a picture with an alpha.
    ///
    /// # Errors
    /// Where a file cannot be read.
    pub fn read([model, picture]: [&str; 2]) -> anyhow::Result<Self> {
        let needs = Attributes { normals: false, uvs: true };
        let model = Model::read(Path::new(model), needs)?;
        let mesh = indexed(&model, &[], needs);
        Ok(Self { model, mesh, picture: Image::read(Path::new(picture))? })
    }

    /// Draws it over an image, bilinearly filtered, `scale` pixels a texel, with its point (u, v) in the middle: texture and
    /// layer are in one of the spaces. Its depths are returned.
    // ANCHOR: cutout
    pub fn draw(&self, space: &Space, scale: f32, middle: Vec2, image: &mut Image) -> DepthBuffer<f32> {
        let texture: Texture = space.texture(&self.picture, Wrap::Clamp);
        let size = image.size();
        // The square is from −1 to 1, and so is the whole picture.
        let share = (scale * self.picture.size() / size).extend(1.0);
        let offset = (share.truncate() * (1.0 - 2.0 * middle)).extend(0.0);
        let to_clip = Mat4::from_translation(offset) * Mat4::from_scale(share);
        let uniforms = Uniforms { to_clip, light: Vec3::Z, ..Uniforms::new(&self.model) };
        let shader = Filtered { uniforms, texture: &texture, filter: Bilinear, lighting: Flat, size };
        let mut target = Framebuffer::new(image, State::blending(*space));
        render(&shader, &self.mesh, Cull::None, Clipping::GuardBand, &mut target);
        target.depths
    }
    // ANCHOR_END: cutout

    /// The same over the wall, and so large that one sees the texels.
    pub fn enlarged(&self, space: &Space, image: &mut Image) -> DepthBuffer<f32> {
        image.set_all(|_| WALL);
        self.draw(space, image.size().min_element() / 64.0, Vec2::new(0.72, 0.62), image)
    }
}
