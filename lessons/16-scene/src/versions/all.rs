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

/// Where the top of the board is.
const BOARD: f32 = -0.7;

/// Crates and spheres on a board, one of each to be seen through, and a cube of all colours.
// ANCHOR: all
fn all(sizes: &[[usize; 2]]) -> anyhow::Result<Scene> {
    let wood = wooden_crate()?;
    let painted = |paint| Levels::one(Mesh::new(&cube(), paint));
    let sphere = |r, g, b| spheres(sizes, &Paint::Color(Color::rgb(r, g, b)));
    let [colors, board] = [Paint::Colors(all_colors()), Paint::Color(Color::rgb(185, 180, 166))].map(painted);
    let on_board = |levels: &Arc<Levels>, [x, z]: [f32; 2], height: f32, degrees: f32| Entity {
        position: Vec3::new(x, BOARD + height / 2.0, z),
        degrees: Vec3::new(0.0, degrees, 0.0),
        scale: Vec3::splat(height),
        ..Entity::new(levels.clone())
    };
    let ball = |levels: &Arc<Levels>, at, radius: f32| Entity {
        scale: Vec3::splat(radius),
        ..on_board(levels, at, 2.0 * radius, 0.0)
    };
    let upper =
        Entity { position: Vec3::new(-0.85, BOARD + 1.6, -0.75), ..on_board(&wood, [0.0; 2], 0.8, -14.0) };
    let board_size = Vec3::new(4.8, 0.16, 3.8);
    Ok(Scene {
        entities: vec![
            Entity {
                position: Vec3::new(0.25, 0.15, 1.2),
                alpha: 0.5,
                ..on_board(&wood, [0.0; 2], 0.6, 0.0)
            },
            Entity { position: Vec3::new(-1.6, BOARD + 0.7, 0.9), ..on_board(&colors, [0.0; 2], 0.65, 0.0) },
            Entity { position: Vec3::new(0.0, BOARD - 0.08, 0.0), scale: board_size, ..Entity::new(board) },
            on_board(&wood, [-0.85, -0.7], 1.2, 24.0),
            upper,
            ball(&sphere(47, 111, 214), [1.15, -0.75], 0.8),
            ball(&sphere(216, 58, 52), [-0.35, 1.15], 0.3),
            Entity { alpha: 0.45, ..ball(&sphere(111, 224, 176), [1.35, 0.95], 0.5) },
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
