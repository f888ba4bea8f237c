//! Version 11: the course's own scene, with all that was built.

use std::path::Path;
use std::sync::Arc;

use blending::crates::CRATE;
use clipping::Cull;
use common::{Color, Format, Image, Mat4, Method, Vec2, Vec3};
use filtering::{MIPMAPS, Wrap};
use lighting::PointLight;
use lighting::light::Falloff;
use perspective::perspective;

use crate::entity::Entity;
use crate::head::head;
use crate::levels::{Levels, spheres};
use crate::mesh::{Mesh, Paint};
use crate::orbit::Orbit;
use crate::scene::{Filtering, Scene, Shading, Style};
use crate::shapes::{Shape, Vertex, cube};
use crate::versions::Version;

/// The version that is drawn unless another one is asked for.
pub const VERSION: Version = Version {
    number: 11,
    what: "the course's own scene: all that was built",
    projection,
    scene,
    animate: Some(animate),
    camera: Some(Orbit::new(24.0, 11.0, 5.6)),
    wireframe: true,
    antialiasing: true,
};

/// Where the floor is.
const GROUND: f32 = -1.0;

/// What is behind everything, and what the floor becomes far away.
const NIGHT: Color = Color::rgb(0x14, 0x1a, 0x26);

/// As [`in_perspective`](crate::versions::in_perspective), but up to the horizon.
fn projection(size: Vec2) -> Mat4 {
    perspective(40.0, size.x / size.y, 0.1, 400.0).expect("a picture has a width and a height")
}

/// A picture as a texture with all its levels.
fn texture(picture: &Image) -> Paint {
    let mipmap = Method::find(MIPMAPS, "box-linear").expect("a row of lesson 13's");
    Paint::Texture(Arc::new(mipmap.run.texture(picture, Wrap::Repeat)))
}

fn read(path: &str) -> anyhow::Result<Image> {
    Ok(Image::read(Path::new(path))?)
}

/// A square floor that reaches so far to each side, with so many of its texture on the way from one side to the other.
fn floor(reach: f32, times: f32) -> Shape {
    let corner = |[x, z]: [f32; 2]| Vertex {
        position: Vec3::new(x, 0.0, -z) * reach,
        normal: Vec3::Y,
        uv: (Vec2::new(x, z) + 1.0) / 2.0 * times,
    };
    let vertices = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(corner).to_vec();
    Shape { vertices, triangles: vec![[0, 1, 2], [0, 2, 3]] }
}

/// The floor's two colours, as checks of many texels each.
fn checks() -> Image {
    let mut image = Image::new(2, 2, Format::Rgb);
    for (x, y, color) in [(0, 0, 0xb8), (1, 1, 0xb8), (0, 1, 0x50), (1, 0, 0x50)] {
        image.set(x, y, Color::rgb(color, color, color));
    }
    image.scale(256, 256)
}

fn scene(sizes: &[[usize; 2]]) -> anyhow::Result<Scene> {
    let head = head(&texture(&read(common::program::model::DEFAULT_TEXTURE)?))?;
    let wood = Levels::one(Mesh::new(&cube(), texture(&read(CRATE[1])?)));
    let ball = |r, g, b| spheres(sizes, &Paint::Color(Color::rgb(r, g, b)));
    let floor = Levels::one(Mesh::new(&floor(200.0, 200.0), texture(&checks())));
    let at = |levels: &Arc<Levels>, x: f32, y: f32, z: f32, scale: f32| Entity {
        position: Vec3::new(x, y, z),
        scale: Vec3::splat(scale),
        ..Entity::new(levels.clone())
    };
    let turned = |entity: Entity, y: f32| Entity { degrees: Vec3::new(0.0, y, 0.0), ..entity };
    let (red, blue, gold) = (ball(214, 48, 49), ball(58, 110, 230), ball(245, 180, 50));
    let entities = vec![
        turned(at(&head, 0.0, 0.0, 0.0, 1.0), 20.0),
        turned(at(&wood, -1.9, GROUND + 0.45, -0.9, 0.9), 25.0),
        turned(at(&wood, -1.8, GROUND + 1.2, -0.95, 0.6), -14.0),
        turned(at(&wood, 1.9, GROUND + 0.35, -1.4, 0.7), 40.0),
        at(&red, 1.35, GROUND + 0.4, 0.35, 0.4),
        at(&blue, -1.2, GROUND + 0.25, 0.9, 0.25),
        at(&gold, 0.0, 0.0, 0.0, 0.12),
        at(&blue, 0.0, 0.0, 0.0, 0.09),
        Entity { alpha: 0.4, ..at(&ball(120, 220, 235), 0.8, GROUND + 0.3, 1.25, 0.3) },
        at(&floor, 0.0, GROUND, 0.0, 1.0),
    ];
    let light = |x, y, z, diffuse, specular, shininess| PointLight {
        position: Vec3::new(x, y, z),
        ambient: 0.13,
        diffuse,
        specular,
        shininess,
        falloff: Falloff::None,
    };
    Ok(Scene {
        entities,
        lights: vec![light(3.0, 4.0, 4.0, 0.75, 0.5, 64.0), light(-5.0, 3.0, 1.0, 0.3, 0.25, 32.0)],
        background: NIGHT,
        style: Style { shading: Shading::BlinnPhong, filter: Filtering::Trilinear, cull: Cull::Back },
    })
}

fn animate(scene: &mut Scene, seconds: f64) {
    let circle = |degrees: f64, radius: f64, height: f64| {
        let angle = degrees.to_radians();
        Vec3::new((radius * libm::sin(angle)) as f32, height as f32, (radius * libm::cos(angle)) as f32)
    };
    let bob = 0.1 * libm::sin(seconds * 0.9);
    scene.entities[6].position = circle(seconds * 30.0 + 60.0, 1.35, 0.35 + bob);
    scene.entities[7].position = circle(seconds * -40.0 + 290.0, 1.15, 0.75 - bob);
    scene.entities[2].degrees.y = (-14.0 + 12.0 * seconds % 360.0) as f32;
}
