//! Versions 6 to 8: wooden crates.

use std::sync::Arc;

use blending::crates::CRATE;
use clipping::Cull;
use common::{Color, Image, Vec3};
use filtering::light::SRGB;
use filtering::{Texture, Wrap};
use lighting::PointLight;

use super::{Version, in_perspective, ours, turned};
use crate::entity::Entity;
use crate::levels::{Levels, spheres};
use crate::mesh::{Mesh, Paint};
use crate::scene::{Filtering, Scene, Shading, Style};
use crate::shapes::cube;

pub(super) const TEXTURE: Version = Version {
    number: 6,
    what: "a wooden crate: a texture on each face",
    projection: |size| in_perspective(60.0, size),
    scene: |_| Ok(scene(vec![crate_at(&wooden_crate()?, [0.0, 0.0, 1.9])], Filtering::Nearest, Cull::None)),
    animate: Some(turn),
    camera: None,
    wireframe: false,
    antialiasing: false,
};

pub(super) const WIREFRAME: Version = Version {
    number: 7,
    what: "a crate and a sphere, and by F1 the sides of their triangles",
    scene: |sizes| {
        let paint = Paint::Color(Color::rgb(0x4f, 0x9d, 0xe8));
        let entities = vec![
            crate_at(&wooden_crate()?, [-0.75, 0.0, 2.4]),
            crate_at(&spheres(sizes, &paint), [0.95, 0.0, 3.0]),
        ];
        Ok(scene(entities, Filtering::Nearest, Cull::None))
    },
    wireframe: true,
    ..TEXTURE
};

pub(super) const BLENDING: Version = Version {
    number: 8,
    what: "a crate that is seen through before a large one; bilinear filtering, backs culled",
    scene: |_| Ok(two_crates(&wooden_crate()?)),
    animate: Some(|scene, seconds| turn_one(&mut scene.entities[1], seconds)),
    ..WIREFRAME
};

/// The crate, its wood without smaller levels.
pub(super) fn wooden_crate() -> anyhow::Result<Arc<Levels>> {
    let wood = Texture::new(&Image::read(CRATE[1].as_ref())?, Wrap::Clamp, &SRGB);
    Ok(Levels::one(Mesh::new(&cube(), Paint::Texture(Arc::new(wood)))))
}

// ANCHOR: two_crates
/// A large crate, and before it a small one of half alpha.
fn two_crates(crate_: &Arc<Levels>) -> Scene {
    let degrees = ours(Vec3::ZERO, Vec3::new(-12.0, 32.0, 0.0)).1;
    let large = Entity { degrees, scale: Vec3::splat(1.6), ..crate_at(crate_, [-0.1, 0.05, 3.1]) };
    let small = Entity { scale: Vec3::splat(0.6), alpha: 0.5, ..crate_at(crate_, [0.3, -0.12, 1.7]) };
    scene(vec![large, small], Filtering::Bilinear, Cull::Back)
}
// ANCHOR_END: two_crates

/// Entities under a lamp on the left, above the eye.
fn scene(entities: Vec<Entity>, filter: Filtering, cull: Cull) -> Scene {
    let (position, _) = ours(Vec3::new(-1.0, 1.5, 0.0), Vec3::ZERO);
    let lamp = PointLight { position, ambient: 0.3, diffuse: 0.7, specular: 0.2, ..PointLight::default() };
    let style = Style { shading: Shading::BlinnPhong, filter, cull };
    Scene { entities, lights: vec![lamp], background: Color::BLACK, style }
}

/// At a place before the eye, as the assignment counts it.
fn crate_at(levels: &Arc<Levels>, position: [f32; 3]) -> Entity {
    Entity { position: ours(position.into(), Vec3::ZERO).0, ..Entity::new(levels.clone()) }
}

fn turn(scene: &mut Scene, seconds: f64) {
    scene.entities.iter_mut().for_each(|entity| turn_one(entity, seconds));
}

/// About itself, from where three of its faces are seen.
fn turn_one(entity: &mut Entity, seconds: f64) {
    let degrees = Vec3::new(turned(20.0, seconds) - 25.0, turned(40.0, seconds) + 35.0, 0.0);
    entity.degrees = ours(Vec3::ZERO, degrees).1;
}
