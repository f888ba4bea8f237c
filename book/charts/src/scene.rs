//! Lesson 9's scene, drawn by its shaders and computed without them.

use camera::lookat;
use checks::render::{self, Face, render};
use common::{Format, Image, Model, Vec3};
use gouraud::corner_normals;
use shaders::{Render, Scene, Target};
use transforms::{projection, viewport};

/// What the lesson's viewport leaves of the picture's side to a length of 1.
const ZOOM: f32 = 0.4;

/// Steps of the quantized shader.
pub(crate) const LEVELS: u16 = 6;

/// The lesson's default eye.
pub(crate) const EYE: Vec3 = Vec3::new(1.0, 1.0, 2.0);

/// The lesson's scene of a model, a picture of `side`×`side`, seen from `eye`.
pub(crate) fn scene<'a>(
    model: &'a Model,
    texture: &'a Image,
    light: Vec3,
    eye: Vec3,
    side: u16,
) -> Scene<'a> {
    let side = f32::from(side);
    let view = lookat(eye, Vec3::ZERO, Vec3::Y).expect("the eye is not at the centre");
    Scene {
        model,
        normals: corner_normals(model),
        texture: Some(texture),
        light,
        to_screen: viewport(side, side, ZOOM) * projection(eye.length()) * view,
        levels: LEVELS,
    }
}

/// An empty picture with its depths.
pub(crate) fn target(side: u16) -> Target {
    Target::new(Image::new(side, side, Format::Rgb))
}

/// The picture that a shader draws.
pub(crate) fn draw(render: Render, scene: &Scene, side: u16) -> Target {
    let mut target = target(side);
    render(scene, &mut target);
    target
}

/// The scene as it should be, in rows from the bottom, 0 to 255.
pub(crate) fn exact(
    model: &Model,
    texture: Option<&Image>,
    light: Vec3,
    eye: Vec3,
    (side, samples): (u16, usize),
) -> Vec<[f64; 3]> {
    let attributes = corner_normals(model).into_iter().zip(model.face_uvs());
    let faces = model.faces().zip(attributes).map(|(corners, (normals, uvs))| Face { corners, normals, uvs });
    let scene = render::Scene {
        faces: faces.collect(),
        texture,
        light: light.as_dvec3().normalize(),
        eye,
        center: Vec3::ZERO,
        up: Vec3::Y,
        zoom: f64::from(ZOOM),
        tone: |intensity| intensity,
    };
    render(&scene, usize::from(side), samples)
}

/// The picture as rows from the bottom, 0 to 255.
pub(crate) fn channels(image: &Image) -> impl Iterator<Item = [f64; 3]> + '_ {
    image.pixels().map(|(_, _, color)| [color.r, color.g, color.b].map(f64::from))
}
