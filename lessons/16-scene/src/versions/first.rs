//! Versions 0 to 5: a cube and a sphere, from white to lit at each pixel.

use std::sync::Arc;

use clipping::Cull;
use common::{Color, Vec2, Vec3};
use lighting::PointLight;

use super::{Version, in_perspective, orthographic, ours, turned};
use crate::entity::Entity;
use crate::levels::{Levels, spheres};
use crate::mesh::{Mesh, Paint};
use crate::scene::{Filtering, Scene, Shading, Style};
use crate::shapes::{Shape, Vertex, cube};

const BLUE: Color = Color::rgb(0, 0, 255);

pub(super) const WHITE: Version = Version {
    number: 0,
    what: "a white cube and a white sphere",
    projection: orthographic,
    scene: |sizes| Ok(cube_and_sphere(sizes, [Color::WHITE; 2], 2.5, Shading::Unlit)),
    animate: None,
    camera: None,
    wireframe: false,
    antialiasing: false,
};

pub(super) const COLORS: Version =
    Version { number: 1, what: "a triangle between red, green and blue", scene: |_| Ok(triangle()), ..WHITE };

pub(super) const DEPTH: Version = Version {
    number: 2,
    what: "a red cube in a blue sphere: what is nearer hides what is behind",
    scene: |sizes| Ok(cube_and_sphere(sizes, [Color::RED, BLUE], 0.5, Shading::Unlit)),
    ..WHITE
};

pub(super) const PHONG: Version = Version {
    number: 3,
    what: "a light, Phong's model at the corners",
    scene: |sizes| Ok(cube_and_sphere(sizes, [Color::RED, BLUE], 0.5, Shading::Phong)),
    ..WHITE
};

pub(super) const BLINN_PHONG: Version = Version {
    number: 4,
    what: "Blinn's model at each pixel; both turn",
    scene: |sizes| Ok(cube_and_sphere(sizes, [Color::RED, BLUE], 0.5, Shading::BlinnPhong)),
    animate: Some(turn),
    ..WHITE
};

pub(super) const PERSPECTIVE: Version =
    Version { number: 5, what: "the same in perspective", projection: in_perspective, ..BLINN_PHONG };

/// A cube of side 1 on the left and a sphere of radius 1 on the right, each so far from the middle, 2 before the eye, and a
/// light at the eye.
fn cube_and_sphere(sizes: &[[usize; 2]], [left, right]: [Color; 2], x: f32, shading: Shading) -> Scene {
    let cube = Levels::one(Mesh::new(&cube(), Paint::Color(left)));
    let sphere = spheres(sizes, &Paint::Color(right));
    Scene {
        entities: vec![at(cube, Vec3::new(-x, 0.0, 2.0)), at(sphere, Vec3::new(x, 0.0, 2.0))],
        lights: vec![PointLight { position: ours(Vec3::ZERO, Vec3::ZERO).0, ..PointLight::default() }],
        background: Color::BLACK,
        style: Style { shading, filter: Filtering::Nearest, cull: Cull::None },
    }
}

/// The triangle between three colours.
fn triangle() -> Scene {
    let corners = [[-0.5, -0.5], [0.5, -0.5], [0.0, 0.5]];
    let vertex =
        |[x, y]: [f32; 2]| Vertex { position: Vec3::new(x, y, 0.0), normal: Vec3::Z, uv: Vec2::ZERO };
    let shape = Shape { vertices: corners.map(vertex).to_vec(), triangles: vec![[0, 1, 2]] };
    let mesh = Mesh::new(&shape, Paint::Colors(vec![Color::RED, Color::GREEN, BLUE]));
    Scene {
        entities: vec![at(Levels::one(mesh), Vec3::new(0.0, 0.0, 2.0))],
        lights: Vec::new(),
        background: Color::BLACK,
        style: Style { shading: Shading::Unlit, filter: Filtering::Nearest, cull: Cull::None },
    }
}

/// At a place of the assignment.
fn at(levels: Arc<Levels>, position: Vec3) -> Entity {
    Entity { position: ours(position, Vec3::ZERO).0, ..Entity::new(levels) }
}

/// Cube and sphere turn at constant speed.
fn turn(scene: &mut Scene, seconds: f64) {
    for entity in &mut scene.entities {
        let degrees = Vec3::new(turned(30.0, seconds), turned(50.0, seconds), 0.0);
        entity.degrees = ours(Vec3::ZERO, degrees).1;
    }
}
