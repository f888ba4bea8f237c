//! Versions 9 and 10: a scene of our own with all that there is so far.

use std::sync::Arc;

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
    what: "all there is so far, and a camera that moves around it",
    projection: |size| in_perspective(50.0, size),
    scene: all,
    animate: Some(turn),
    camera: Some(Orbit::new(28.0, 18.0, 6.2)),
    wireframe: true,
    antialiasing: false,
};

pub(super) const ANTIALIASING: Version =
    Version { number: 10, what: "the same with smooth edges, until F2", antialiasing: true, ..CAMERA };

/// Crates and spheres on a board whose top is at −0.7, one of each to be seen through, and a cube of all colours.
// ANCHOR: all
fn all(sizes: &[[usize; 2]]) -> anyhow::Result<Scene> {
    let wood = wooden_crate()?;
    let painted = |paint| Levels::one(Mesh::new(&cube(), paint));
    let sphere = |r, g, b| spheres(sizes, &Paint::Color(Color::rgb(r, g, b)));
    let [colors, board] = [Paint::Colors(all_colors()), Paint::Color(Color::rgb(185, 180, 166))].map(painted);
    let at = |levels: &Arc<Levels>, position: [f32; 3], size: f32| Entity {
        position: position.into(),
        scale: Vec3::splat(size),
        ..Entity::new(levels.clone())
    };
    Ok(Scene {
        entities: vec![
            Entity { alpha: 0.5, ..at(&wood, [0.5, 0.65, 0.3], 0.6) },
            at(&colors, [-1.6, 0.0, 0.9], 0.65),
            Entity { scale: Vec3::new(4.8, 0.16, 3.8), ..at(&board, [0.0, -0.78, 0.0], 1.0) },
            Entity { degrees: Vec3::new(0.0, 24.0, 0.0), ..at(&wood, [-0.85, -0.1, -0.7], 1.2) },
            Entity { degrees: Vec3::new(0.0, -14.0, 0.0), ..at(&wood, [-0.85, 0.9, -0.75], 0.8) },
            at(&sphere(47, 111, 214), [1.15, 0.1, -0.75], 0.8),
            at(&sphere(216, 58, 52), [-0.35, -0.4, 1.15], 0.3),
            Entity { alpha: 0.45, ..at(&sphere(111, 224, 176), [1.35, -0.2, 0.95], 0.5) },
        ],
        lights: vec![
            PointLight {
                position: Vec3::new(-2.5, 4.0, 3.5),
                ambient: 0.16,
                diffuse: 0.62,
                specular: 0.35,
                ..PointLight::default()
            },
            PointLight {
                position: Vec3::new(4.0, 2.0, 2.0),
                ambient: 0.06,
                diffuse: 0.28,
                specular: 0.2,
                ..PointLight::default()
            },
        ],
        background: Color::rgb(22, 27, 38),
        style: Style { shading: Shading::BlinnPhong, filter: Filtering::Bilinear, cull: Cull::Back },
    })
}
// ANCHOR_END: all

/// At each corner of the cube the colour whose red, green and blue are its x, y and z.
fn all_colors() -> Vec<Color> {
    let color = |position: Vec3| {
        let [r, g, b] = (255.0 * (position + 0.5)).to_array().map(|channel| channel as u8);
        Color::rgb(r, g, b)
    };
    cube().vertices.iter().map(|vertex| color(vertex.position)).collect()
}

/// The crate that is seen through and the cube of all colours turn about themselves.
fn turn(scene: &mut Scene, seconds: f64) {
    let rates = [[20.0, 0.0, 40.0], [30.0, 25.0, -35.0]];
    for (entity, [tilt, x, y]) in scene.entities.iter_mut().zip(rates) {
        entity.degrees = Vec3::new(tilt as f32 + turned(x, seconds), turned(y, seconds), 0.0);
    }
}
