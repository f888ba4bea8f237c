//! Things in the world that one sees through.

use antialiasing::{METHODS, Scene, World, resolve};
use blending::scene::{Entity, View};
use blending::{faded, over};
use clipping::Cull;
use common::{Attributes, Color, Format, Image, Mat4, Model, Vec3};
use filtering::scene::Filterable;
use filtering::{MIPMAPS, Wrap};
use lighting::PointLight;
use perspective::perspective;
use perspective::scene::Loaded;
use verify::{CRATE, SPHERE, method};

const GROUND: Color = Color::rgb(40, 90, 200);

/// A ball of some alpha by a method; those of its triangles that show their backs are left out, so nothing is seen twice.
fn ball(name: &str, alpha: f32, alpha_to_coverage: bool) -> Image {
    let needs = Attributes { normals: true, uvs: true };
    let model = Model::read(SPHERE.as_ref(), needs).unwrap();
    let loaded = Loaded::new(model, Image::read(CRATE.as_ref()).unwrap(), textures::Wrap::Repeat);
    let model = Filterable::new(loaded, *method(MIPMAPS, "box-linear"), Wrap::Repeat);
    let eye = Vec3::new(1.0, 2.0, 3.0);
    let look = perspective::view(eye, Vec3::ZERO, Vec3::Y).unwrap();
    let to_clip = perspective(45.0, 1.5, 0.1, 100.0).unwrap() * look;
    let entities = [Entity { model: &model, to_world: Mat4::IDENTITY, alpha }];
    let world = Some(World {
        entities: &entities,
        view: View { to_clip, eye, light: PointLight::default() },
        cull: Cull::Back,
    });
    let scene = Scene { background: GROUND, triangles: &[], world, alpha_to_coverage, resolve };
    let mut image = Image::new(90, 60, Format::Rgb);
    (method(METHODS, name).picture)(&scene, &mut image);
    image
}

/// Each pixel of the ball is laid over the ground with its alpha, whichever that is.
#[test]
fn what_is_not_opaque_is_laid_over_what_is_there() {
    let opaque = ball("none", 1.0, false);
    assert!(opaque.pixels().filter(|&(.., color)| color != GROUND).count() > 1000);
    for alpha in [0.0, 0.25, 0.5, 0.99] {
        let got = ball("none", alpha, false);
        for (x, y, color) in opaque.pixels() {
            let expected = if color == GROUND { GROUND } else { over(faded(color, alpha), GROUND) };
            assert_eq!(got.get(x, y), Some(expected), "({x}, {y}) with alpha {alpha}");
        }
    }
}

/// Half of alpha covers two samples of four with the ball's own colour, and leaves the ground to the others. Where two triangles
/// share a pixel, these two samples may be those of the brighter one.
#[test]
fn alpha_is_a_share_of_the_samples_if_asked_for() {
    let (opaque, half) = (ball("msaa-4", 1.0, true), ball("msaa-4", 0.5, true));
    let inside = |x: i32, y: i32| (x - 45).pow(2) + (y - 30).pow(2) < 100;
    for (x, y, color) in opaque.pixels().filter(|&(x, y, _)| inside(x, y)) {
        let expected = resolve(&[color, color, GROUND, GROUND]);
        let got = half.get(x, y).unwrap();
        let off = [(got.r, expected.r), (got.g, expected.g), (got.b, expected.b)].map(|(a, b)| a.abs_diff(b));
        assert!(off.into_iter().all(|off| off <= 3), "({x}, {y}): {got:?} for {expected:?}");
    }
    assert_ne!(half, ball("msaa-4", 0.5, false));
}
