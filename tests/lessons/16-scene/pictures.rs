//! Small scenes of our own, and how they are looked at.

use std::sync::Arc;

use clipping::Cull;
use common::{Color, Format, Image, Mat4, Vec2, Vec3};
use filtering::light::SRGB;
use filtering::{Texture, Wrap};
use lighting::PointLight;
use scene::levels::spheres;
use scene::versions::in_perspective;
use scene::{
    Counts, Entity, Filtering, Levels, Mesh, Orbit, Paint, Scene, Shading, Style, Target, cube, render_scene,
};
use transforms::inverse::elimination;

/// Small, and not square.
pub(crate) const SIZE: [u16; 2] = [64, 48];

/// From where scenes are looked at: off all axes.
pub(crate) const ORBIT: Orbit = Orbit::new(25.0, 20.0, 5.0);

/// Degrees from the bottom of the picture to its top.
pub(crate) const FIELD_OF_VIEW: f64 = 60.0;

/// What an eye ahead sees in a picture of that size.
pub(crate) fn ahead(size: Vec2) -> Mat4 {
    in_perspective(FIELD_OF_VIEW as f32, size)
}

/// What is behind everything.
pub(crate) const SKY: Color = Color::rgb(10, 20, 40);

/// A cube of one colour.
pub(crate) fn cube_of(color: Color) -> Arc<Levels> {
    Levels::one(Mesh::new(&cube(), Paint::Color(color)))
}

/// A sphere of 224 triangles and one colour.
pub(crate) fn sphere_of(color: Color) -> Arc<Levels> {
    spheres(&[[8, 16]], &Paint::Color(color))
}

/// A cube with a texture of 3×2 texels, all different.
pub(crate) fn patched_cube() -> Arc<Levels> {
    let mut image = Image::new(3, 2, Format::Rgb);
    (0..6).for_each(|n| image.set(n % 3, n / 3, Color::random(n as u64 + 3)));
    let texture = Texture::new(&image, Wrap::Clamp, &SRGB);
    Levels::one(Mesh::new(&cube(), Paint::Texture(Arc::new(texture))))
}

/// A scene under one lamp, backs left out.
pub(crate) fn lit(entities: Vec<Entity>) -> Scene {
    Scene {
        entities,
        lights: vec![PointLight { position: Vec3::new(2.0, 3.0, 4.0), ..PointLight::default() }],
        background: SKY,
        style: Style { shading: Shading::BlinnPhong, filter: Filtering::Bilinear, cull: Cull::Back },
    }
}

/// Draws a scene to a target as seen from an orbit.
pub(crate) fn draw_from(scene: &Scene, orbit: Orbit, target: &mut Target) -> Counts {
    let size: Vec2 = target.picture().size();
    let inverse = elimination(&orbit.camera()).expect("an orbit has an inverse");
    render_scene(scene, target, &ahead(size), &inverse)
}

/// A scene as seen from off all axes.
pub(crate) fn seen(scene: &Scene) -> (Image, Counts) {
    let mut target = Target::new(SIZE[0], SIZE[1]);
    let counts = draw_from(scene, ORBIT, &mut target);
    (target.into_picture(), counts)
}

/// The same with sixteen samples a pixel, or as lines, or both.
pub(crate) fn seen_as(scene: &Scene, antialiased: bool, wireframe: bool) -> Image {
    let mut target = Target::new(SIZE[0], SIZE[1]);
    (target.antialiased, target.wireframe) = (antialiased, wireframe);
    draw_from(scene, ORBIT, &mut target);
    target.into_picture()
}

/// In all four ways to draw.
pub(crate) const WAYS: [[bool; 2]; 4] = [[false, false], [true, false], [false, true], [true, true]];

/// How many pixels differ.
pub(crate) fn different(a: &Image, b: &Image) -> usize {
    assert_eq!([a.width(), a.height()], [b.width(), b.height()]);
    a.pixels().zip(b.pixels()).filter(|(a, b)| a.2 != b.2).count()
}

/// How many pixels show something.
pub(crate) fn covered(picture: &Image) -> usize {
    picture.pixels().filter(|pixel| pixel.2 != SKY).count()
}

/// The matrix that brings nothing anywhere.
pub(crate) const NOWHERE: Mat4 = Mat4::ZERO;
