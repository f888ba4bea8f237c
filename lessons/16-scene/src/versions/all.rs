//! Versions 9 and 10: a scene of our own with all that there is so far.

use clipping::Cull;
use common::{Color, Vec3};
use lighting::PointLight;

use super::crates::wooden_crate;
use super::{Version, in_perspective, turned};
use crate::entity::Entity;
use crate::levels::{Levels, spheres};
use crate::mesh::{Mesh, Paint};
use crate::orbit::Orbit;
use crate::scene::{Filtering, Scene, Shading, Style};
use crate::shapes::cube;

pub(super) const CAMERA: Version = Version {
    number: 9,
    what: "all of it, and a camera that moves around it",
    projection: in_perspective,
    scene: all,
    animate: Some(|scene, seconds| scene.entities[2].degrees.y = turned(40.0, seconds)),
    camera: Some(Orbit::new(25.0, 20.0, 5.0)),
    wireframe: true,
    antialiasing: false,
};

pub(super) const ANTIALIASING: Version =
    Version { number: 10, what: "the same with smooth edges, by F2", antialiasing: true, ..CAMERA };

fn all(sizes: &[[usize; 2]]) -> anyhow::Result<Scene> {
    let crate_ = wooden_crate()?;
    let sphere = spheres(sizes, &Paint::Color(Color::rgb(40, 90, 220)));
    let corner = |n: u64| Color::random(n + 8);
    let colors = Levels::one(Mesh::new(&cube(), Paint::Colors((0..24).map(corner).collect())));
    Ok(Scene {
        entities: vec![
            Entity::new(crate_.clone()),
            Entity { position: Vec3::new(1.5, 0.0, -0.5), ..Entity::new(sphere) },
            Entity { position: Vec3::new(-1.4, 0.0, 0.3), scale: Vec3::splat(0.8), ..Entity::new(colors) },
            Entity {
                position: Vec3::new(0.3, 0.2, 1.2),
                scale: Vec3::splat(0.6),
                alpha: 0.5,
                ..Entity::new(crate_)
            },
        ],
        lights: vec![PointLight { position: Vec3::new(2.0, 3.0, 4.0), ..PointLight::default() }],
        background: Color::rgb(0x18, 0x1c, 0x24),
        style: Style { shading: Shading::BlinnPhong, filter: Filtering::Bilinear, cull: Cull::Back },
    })
}
