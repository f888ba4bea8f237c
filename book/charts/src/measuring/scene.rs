//! Lesson 9's scene, drawn by its shaders and computed without them.

use camera::lookat;
use checks::supersampled::{Face, sampled};
use common::{Format, Image, Model, Vec2, Vec3};
use gouraud::corner_normals;
use shaders::{Draw, Framebuffer, Uniforms, fit};
use transforms::projection;

/// What a length of 1 takes up of the lesson's picture.
const ZOOM: f32 = 0.4;

/// Steps of the quantized shader.
pub(crate) const LEVELS: u16 = 6;

/// The lesson's default eye.
pub(crate) const EYE: Vec3 = Vec3::new(1.0, 1.0, 2.0);

/// A model with its normals and a texture.
#[derive(Clone)]
pub(crate) struct Subject<'a> {
    model: &'a Model,
    normals: Vec<[Vec3; 3]>,
    texture: &'a Image,
}

impl<'a> Subject<'a> {
    pub(crate) fn new(model: &'a Model, texture: &'a Image) -> Self {
        Self { model, normals: corner_normals(model), texture }
    }

    /// As the lesson shows it in a square picture, seen from `eye`.
    pub(crate) fn seen(&self, light: Vec3, eye: Vec3) -> Uniforms<'_> {
        let view = lookat(eye, Vec3::ZERO, Vec3::Y).expect("the eye is not at the centre");
        Uniforms {
            normals: &self.normals,
            texture: Some(self.texture),
            light,
            to_clip: fit(ZOOM, Vec2::ONE) * projection(eye.length()) * view,
            levels: LEVELS,
            ..Uniforms::new(self.model)
        }
    }
}

/// The picture that a shader draws.
pub(crate) fn draw(draw: Draw, uniforms: &Uniforms, side: u16) -> Framebuffer {
    let mut target = Framebuffer::new(Image::new(side, side, Format::Rgb));
    draw(uniforms, &mut target);
    target
}

/// The picture as it should be, in rows from the bottom, 0 to 255.
pub(crate) fn exact(
    model: &Model,
    texture: Option<&Image>,
    light: Vec3,
    eye: Vec3,
    (side, samples): (u16, usize),
) -> Vec<[f64; 3]> {
    let attributes = corner_normals(model).into_iter().zip(model.face_uvs());
    let faces = model.faces().zip(attributes).map(|(corners, (normals, uvs))| Face { corners, normals, uvs });
    let subject = checks::supersampled::Subject {
        faces: faces.collect(),
        texture,
        light: light.as_dvec3().normalize(),
        eye,
        center: Vec3::ZERO,
        up: Vec3::Y,
        zoom: f64::from(ZOOM),
        tone: |intensity| intensity,
    };
    sampled(&subject, usize::from(side), samples)
}

/// The picture as rows from the bottom, 0 to 255.
pub(crate) fn channels(image: &Image) -> impl Iterator<Item = [f64; 3]> + '_ {
    image.pixels().map(|(_, _, color)| [color.r, color.g, color.b].map(f64::from))
}
