//! An entity's alpha: what the assignment's version 8 says of it, and where that cannot be.

use std::sync::Arc;

use blending::{faded, over};
use clipping::Cull;
use common::{Color, Format, Image, Vec3};
use filtering::light::SRGB;
use filtering::{Texture, Wrap};
use scene::{Entity, Levels, Mesh, Paint, Scene, Shading, cube};

use crate::pictures::{SIZE, SKY, WAYS, covered, cube_of, different, lit, seen, seen_as, sphere_of};

/// So large that it fills the picture.
fn wall(levels: Arc<Levels>, alpha: f32) -> Entity {
    Entity { scale: Vec3::splat(4.0), alpha, ..Entity::new(levels) }
}

fn unlit(entities: Vec<Entity>) -> Scene {
    let mut scene = lit(entities);
    scene.style.shading = Shading::Unlit;
    scene
}

/// The colour in the middle of the picture.
fn middle(scene: &Scene) -> Color {
    seen(scene).0.get(i32::from(SIZE[0] / 2), i32::from(SIZE[1] / 2)).expect("inside")
}

/// Half of 255 is 127½, which the assignment has as 127: half transparent is 127/255, and white at a half over black is 127,
/// not 128.
#[test]
fn half_of_255_is_127() {
    assert_eq!(faded(Color::rgb(0, 200, 0), 0.5), Color { r: 0, g: 200, b: 0, a: 127 });
    let mut scene = unlit(vec![wall(cube_of(Color::WHITE), 0.5)]);
    scene.background = Color::BLACK;
    assert_eq!(middle(&scene), Color::rgb(127, 127, 127));
}

/// Porter and Duff's A over B has A above. Read with the picture that is there as A, of alpha 1, as the assignment has it, no
/// triangle would ever be seen.
#[test]
fn the_triangle_is_above() {
    let scene = unlit(vec![wall(cube_of(Color::RED), 0.5)]);
    let half = Color { a: 127, ..Color::RED };
    assert_eq!([over(half, SKY), over(SKY, half)], [middle(&scene), SKY]);
    assert_ne!(middle(&scene), SKY);
}

/// What is drawn already counts as opaque, and so does what is laid over it. Channels are rounded for each layer.
#[test]
fn pictures_stay_opaque() {
    let mut scene = unlit(vec![wall(cube_of(Color::WHITE), 0.25), wall(sphere_of(Color::RED), 0.25)]);
    for [antialiased, wireframe] in WAYS {
        let picture = seen_as(&scene, antialiased, wireframe);
        assert!(picture.pixels().all(|pixel| pixel.2.a == 255));
    }
    scene.entities.clear();
    assert!(seen(&scene).0.pixels().all(|pixel| pixel.2.a == 255));
}

/// Of alpha 0 nothing is seen, and nothing behind it is hidden. What is below 0, or no number, counts as 0, and what is above 1
/// as 1.
#[test]
fn alphas_of_0_and_1() {
    for shading in [Shading::Unlit, Shading::Phong, Shading::BlinnPhong] {
        let picture = |alphas: &[f32]| {
            let entity = |&alpha: &f32| wall(cube_of(Color::rgb(200, 100, 50)), alpha);
            let back = Entity { position: Vec3::new(0.4, 0.2, -3.0), ..wall(sphere_of(Color::GREEN), 1.0) };
            let mut scene = lit(alphas.iter().map(entity).chain([back]).collect());
            scene.style.shading = shading;
            seen(&scene).0
        };
        let [none, whole, half] = [&[][..], &[1.0], &[0.5]].map(picture);
        assert!(different(&none, &whole) > 500 && different(&whole, &half) > 500);
        for alpha in [0.0, -0.0, -1.0, f32::NAN, f32::NEG_INFINITY] {
            assert_eq!(different(&picture(&[alpha]), &none), 0, "{alpha}");
        }
        for alpha in [1.0, 1.5, f32::INFINITY] {
            assert_eq!(different(&picture(&[alpha]), &whole), 0, "{alpha}");
        }
        // It costs nothing, either.
        let unseen = lit(vec![wall(cube_of(Color::WHITE), 0.0), wall(cube_of(Color::WHITE), f32::NAN)]);
        assert_eq!(seen(&unseen).1.triangles.vertices, 0);
        // Nearly opaque is blended, and rounded to what opaque is: 254.6 is 255.
        assert_eq!(different(&picture(&[254.6 / 255.0]), &whole), 0);
    }
}

/// The assignment says that a vertex's colour is replaced by one with less alpha, and that vertices never change. Its meshes
/// are shared: one entity's alpha is none of another's, nor of the next picture's.
#[test]
fn an_alpha_is_the_entitys_own() {
    let cube = cube_of(Color::GREEN);
    let at =
        |x: f32, alpha: f32| Entity { position: Vec3::new(x, 0.0, 0.0), alpha, ..Entity::new(cube.clone()) };
    let both = lit(vec![at(-1.0, 0.5), at(1.0, 1.0)]);
    let first = seen(&both).0;
    assert_eq!(different(&seen(&both).0, &first), 0);
    assert!(matches!(cube.finest().paint(), Paint::Color(Color::GREEN)));
    let alone = [vec![at(-1.0, 0.5)], vec![at(1.0, 1.0)]].map(|entities| seen(&lit(entities)).0);
    for (x, y, color) in first.pixels() {
        let [left, right] = [0, 1].map(|n: usize| alone[n].get(x, y).expect("inside"));
        assert!(color == left || color == right, "({x}, {y})");
    }
}

/// The entity's alpha is times that of its colours, of which the assignment has several: a vertex's, a texel's.
#[test]
fn alphas_are_multiplied() {
    let see_through = Color { a: 128, ..Color::RED };
    let mut image = Image::new(1, 1, Format::Rgba);
    image.set(0, 0, see_through);
    let texture = Arc::new(Texture::new(&image, Wrap::Clamp, &SRGB));
    for paint in [Paint::Color(see_through), Paint::Colors(vec![see_through; 24]), Paint::Texture(texture)] {
        let mesh = Levels::one(Mesh::new(&cube(), paint));
        assert!(!mesh.finest().is_opaque());
        for (alpha, expected) in [(1.0, 128), (0.5, 64), (0.25, 32)] {
            let scene = unlit(vec![wall(mesh.clone(), alpha)]);
            assert_eq!(middle(&scene), over(Color { a: expected, ..Color::RED }, SKY), "{alpha}");
        }
    }
}

/// With backs left out one sees no inside: a glass cube is a film before what is behind it, each pixel covered once. With all
/// faces there are two layers.
#[test]
fn of_a_glass_cube_the_front_is_seen() {
    let mut scene = unlit(vec![Entity {
        alpha: 0.5,
        degrees: Vec3::new(10.0, 20.0, 30.0),
        ..Entity::new(cube_of(Color::RED))
    }]);
    let once = over(Color { a: 127, ..Color::RED }, SKY);
    assert!(seen(&scene).0.pixels().all(|pixel| pixel.2 == SKY || pixel.2 == once));
    scene.style.cull = Cull::None;
    let twice = over(Color { a: 127, ..Color::RED }, once);
    let picture = seen(&scene).0;
    let inside = picture.pixels().filter(|pixel| pixel.2 == twice).count();
    assert!(inside * 10 > covered(&picture) * 9, "{inside}");
}
