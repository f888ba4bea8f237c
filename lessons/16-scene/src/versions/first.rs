//! Versions 0 to 5: a cube and a sphere, from white to lit at each pixel and seen in perspective.

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

pub(super) const COLORS: Version = Version {
    number: 1,
    what: "a triangle with a colour at each corner",
    scene: |_| Ok(triangle()),
    ..WHITE
};

// ANCHOR: depth
pub(super) const DEPTH: Version = Version {
    number: 2,
    what: "a red cube partly in a blue sphere: what is nearer hides what is behind",
    scene: |sizes| Ok(cube_and_sphere(sizes, [Color::RED, BLUE], 0.5, Shading::Unlit)),
    ..WHITE
};
// ANCHOR_END: depth

pub(super) const PHONG: Version = Version {
    number: 3,
    what: "the same under a light, by Phong's model at the corners of triangles",
    scene: |sizes| Ok(cube_and_sphere(sizes, [Color::RED, BLUE], 0.5, Shading::Phong)),
    ..WHITE
};

pub(super) const BLINN_PHONG: Version = Version {
    number: 4,
    what: "by Blinn's model at each pixel, and both turn",
    scene: |sizes| Ok(cube_and_sphere(sizes, [Color::RED, BLUE], 0.5, Shading::BlinnPhong)),
    animate: Some(turn),
    ..WHITE
};

pub(super) const PERSPECTIVE: Version = Version {
    number: 5,
    what: "the same in perspective",
    projection: |size| in_perspective(75.0, size),
    ..BLINN_PHONG
};

/// A cube of side 1 on the left and a sphere of radius 1 on the right, each so far from the middle, two units before the eye,
/// and the light where the eye is.
// ANCHOR: cube_and_sphere
fn cube_and_sphere(sizes: &[[usize; 2]], [left, right]: [Color; 2], x: f32, shading: Shading) -> Scene {
    let cube = Levels::one(Mesh::new(&cube(), Paint::Color(left)));
    let sphere = spheres(sizes, &Paint::Color(right));
    Scene {
        entities: vec![at(cube, Vec3::new(-x, 0.0, 2.0)), at(sphere, Vec3::new(x, 0.0, 2.0))],
        // Ambient 0.2, diffuse 0.4, specular 0.4.
        lights: vec![PointLight { position: Vec3::ZERO, ..PointLight::default() }],
        background: Color::BLACK,
        style: Style { shading, filter: Filtering::Nearest, cull: Cull::None },
    }
}
// ANCHOR_END: cube_and_sphere

/// The triangle.
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

/// Cube and sphere turn about themselves at constant speed.
fn turn(scene: &mut Scene, seconds: f64) {
    let degrees = Vec3::new(turned(30.0, seconds), turned(50.0, seconds), 0.0);
    for entity in &mut scene.entities {
        entity.degrees = ours(Vec3::ZERO, degrees).1;
    }
}
