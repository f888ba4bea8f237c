//! Version 11: the course's own scene, with all that was built.

use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use blending::crates::CRATE;
use clipping::Cull;
use common::program::model::DEFAULT_TEXTURE;
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
    camera: Some(Orbit::new(24.0, -4.0, 7.0).above(0.9 * GROUND)),
    wireframe: true,
    antialiasing: true,
};

/// What the scene consists of: the places among its entities.
pub const PARTS: [(&str, Range<usize>); 5] =
    [("head", 0..1), ("crates", 1..4), ("spheres", 4..8), ("glass", 8..9), ("floor", 9..10)];

/// The crate that turns, and the two spheres that circle about the head.
const MOVING: [usize; 3] = [2, 6, 7];

/// How high the floor is.
pub const GROUND: f32 = -1.0;

/// What is behind everything: a little bluer than the floor at the horizon, where no light but the ambient one reaches it.
const DUSK: Color = Color::rgb(0x22, 0x2c, 0x42);

/// The floor's two colours.
const TILES: [Color; 2] = [Color::rgb(0xae, 0xb8, 0xcc), Color::rgb(0x38, 0x46, 0x62)];

/// How far the floor reaches. From 1 above it, its end is half a pixel below the true horizon in a picture 1,024 px high; behind
/// it is no far plane.
const FAR: f32 = 3000.0;

fn projection(size: Vec2) -> Mat4 {
    perspective(40.0, size.x / size.y, 0.1, f32::INFINITY).expect("a picture has a width and a height")
}

/// A picture as a texture with all its levels.
fn texture(picture: &Image) -> Paint {
    let mipmap = Method::find(MIPMAPS, "box-linear").expect("a row of lesson 13's");
    Paint::Texture(Arc::new(mipmap.run.texture(picture, Wrap::Repeat)))
}

fn read(path: &str) -> anyhow::Result<Paint> {
    Ok(texture(&Image::read(Path::new(path))?))
}

/// Four tiles, each 1 wide where the texture is 2. Of no more texels than a floor seen at an angle shows: an enlarged texture
/// is looked up once a pixel, not in two levels.
fn tiles() -> Paint {
    let mut image = Image::new(2, 2, Format::Rgb);
    for (x, y) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        image.set(x, y, TILES[(x + y) as usize % 2]);
    }
    texture(&image.scale(128, 128))
}

/// A square in the plane y = 0 that reaches so far to each side, its texture 2 wide.
fn square(reach: f32) -> Shape {
    let corner = |[x, z]: [f32; 2]| Vertex {
        position: Vec3::new(x, 0.0, -z) * reach,
        normal: Vec3::Y,
        uv: Vec2::new(x, z) * reach / 2.0,
    };
    let vertices = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(corner).to_vec();
    Shape { vertices, triangles: vec![[0, 1, 2], [0, 2, 3]] }
}

fn scene(sizes: &[[usize; 2]]) -> anyhow::Result<Scene> {
    let head = head(&read(DEFAULT_TEXTURE)?)?;
    let wood = Levels::one(Mesh::new(&cube(), read(CRATE[1])?));
    let floor = Levels::one(Mesh::new(&square(FAR), tiles()));
    let ball = |r, g, b| spheres(sizes, &Paint::Color(Color::rgb(r, g, b)));
    let (red, blue, gold, cyan) =
        (ball(214, 48, 49), ball(58, 110, 230), ball(245, 180, 50), ball(120, 220, 235));
    // On the floor, so large, turned so far, so high above it.
    let at = |levels: &Arc<Levels>, [x, z]: [f32; 2], size: f32, degrees: f32, height: f32| Entity {
        position: Vec3::new(x, GROUND + height, z),
        degrees: Vec3::new(0.0, degrees, 0.0),
        scale: Vec3::splat(size),
        ..Entity::new(levels.clone())
    };
    let entities = vec![
        at(&head, [0.0, 0.0], 1.0, 20.0, -GROUND),
        at(&wood, [-1.9, -0.9], 0.9, 25.0, 0.45),
        at(&wood, [-1.8, -0.95], 0.6, -14.0, 1.2),
        at(&wood, [1.9, -1.4], 0.7, 40.0, 0.35),
        at(&red, [1.35, 0.35], 0.4, 0.0, 0.4),
        at(&blue, [-1.2, 0.9], 0.25, 0.0, 0.25),
        at(&gold, [0.0, 0.0], 0.12, 0.0, 0.0),
        at(&blue, [0.0, 0.0], 0.09, 0.0, 0.0),
        Entity { alpha: 0.4, ..at(&cyan, [0.75, 1.25], 0.3, 0.0, 0.3) },
        at(&floor, [0.0, 0.0], 1.0, 0.0, 0.0),
    ];
    Ok(lit(entities))
}

/// Entities in this version's light, before its sky.
#[must_use]
pub fn lit(entities: Vec<Entity>) -> Scene {
    let light = |position: [f32; 3], diffuse: f32, specular: f32| PointLight {
        position: position.into(),
        ambient: 0.13,
        diffuse,
        specular,
        shininess: 64.0,
        falloff: Falloff::None,
    };
    Scene {
        entities,
        lights: vec![light([3.0, 4.0, 4.0], 0.75, 0.5), light([-5.0, 3.0, 1.0], 0.3, 0.0)],
        background: DUSK,
        style: Style { shading: Shading::BlinnPhong, filter: Filtering::Trilinear, cull: Cull::Back },
    }
}

/// Slowly: the upper crate turns, and two spheres circle about the head, rising and sinking.
fn animate(scene: &mut Scene, seconds: f64) {
    let circle = |degrees: f64, radius: f64, height: f64| {
        let angle = (degrees % 360.0).to_radians();
        let [x, z] = [libm::sin(angle), libm::cos(angle)].map(|share| (radius * share) as f32);
        Vec3::new(x, height as f32, z)
    };
    let rise = 0.1 * libm::sin(0.9 * seconds);
    let [turning, gold, blue] = MOVING;
    scene.entities[turning].degrees.y = ((12.0 * seconds - 14.0) % 360.0) as f32;
    scene.entities[gold].position = circle(30.0 * seconds + 64.0, 1.35, 0.3 + rise);
    scene.entities[blue].position = circle(-40.0 * seconds + 290.0, 1.15, 0.75 - rise);
}
