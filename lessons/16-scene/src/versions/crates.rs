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
use crate::levels::Levels;
use crate::mesh::{Mesh, Paint};
use crate::scene::{Filtering, Scene, Shading, Style};
use crate::shapes::cube;

pub(super) const TEXTURE: Version = Version {
    number: 6,
    what: "a wooden crate, textured",
    projection: in_perspective,
    scene: |_| crate_alone(),
    animate: Some(|scene, seconds| turn(&mut scene.entities[0], seconds)),
    camera: None,
    wireframe: false,
    antialiasing: false,
};

pub(super) const WIREFRAME: Version =
    Version { number: 7, what: "its wireframe, by F1", wireframe: true, ..TEXTURE };

pub(super) const BLENDING: Version = Version {
    number: 8,
    what: "a crate that one sees through before a large one; bilinear filtering, backs culled",
    scene: |_| two_crates(),
    animate: Some(|scene, seconds| turn(&mut scene.entities[1], seconds)),
    ..WIREFRAME
};

/// The crate, its wood without smaller levels.
pub(super) fn wooden_crate() -> anyhow::Result<Arc<Levels>> {
    let wood = Texture::new(&Image::read(CRATE[1].as_ref())?, Wrap::Clamp, &SRGB);
    Ok(Levels::one(Mesh::new(&cube(), Paint::Texture(Arc::new(wood)))))
}

fn crate_alone() -> anyhow::Result<Scene> {
    let (position, _) = ours(Vec3::new(0.0, 0.0, 2.0), Vec3::ZERO);
    Ok(Scene {
        entities: vec![Entity { position, ..Entity::new(wooden_crate()?) }],
        lights: vec![lamp()],
        background: Color::BLACK,
        style: Style { shading: Shading::BlinnPhong, filter: Filtering::Nearest, cull: Cull::None },
    })
}

fn two_crates() -> anyhow::Result<Scene> {
    let crate_ = wooden_crate()?;
    let (position, degrees) = ours(Vec3::new(-0.2, 0.1, 3.2), Vec3::new(-15.0, 30.0, 0.0));
    let large = Entity { position, degrees, scale: Vec3::splat(1.7), ..Entity::new(crate_.clone()) };
    let (position, _) = ours(Vec3::new(0.4, -0.1, 1.6), Vec3::ZERO);
    let small = Entity { position, scale: Vec3::splat(0.6), alpha: 0.5, ..Entity::new(crate_) };
    Ok(Scene {
        entities: vec![large, small],
        lights: vec![lamp()],
        background: Color::BLACK,
        style: Style { shading: Shading::BlinnPhong, filter: Filtering::Bilinear, cull: Cull::Back },
    })
}

fn lamp() -> PointLight {
    let (position, _) = ours(Vec3::new(-1.0, 1.5, 0.0), Vec3::ZERO);
    PointLight { position, ambient: 0.3, diffuse: 0.7, specular: 0.2, ..PointLight::default() }
}

fn turn(entity: &mut Entity, seconds: f64) {
    let degrees = Vec3::new(turned(20.0, seconds) - 25.0, turned(40.0, seconds) + 35.0, 0.0);
    entity.degrees = ours(Vec3::ZERO, degrees).1;
}
