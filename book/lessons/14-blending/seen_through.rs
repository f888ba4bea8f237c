//! Chapter 14's pictures of what one sees through: orders, codes and light.

use std::path::Path;

use anyhow::Context;
use blending::blend::BlendStage;
use blending::cutout::{Cutout, FERN, WALL};
use blending::scene::{Entity, View};
use blending::space::SPACES;
use blending::transparency::{Fill, TRANSPARENCY, Transparency, gather};
use blending::{Over, TwoShift, faded, glass, over};
use clipping::Cull;
use common::{Bounds, Color, Image, Mat4, Method, Model, Vec2, Vec3};
use filtering::scene::Filterable;
use lighting::PointLight;
use perspective::scene::Loaded;
use perspective::{perspective, view};
use shaders::target::Target;
use textures::Wrap;
use zbuffer::{DepthBuffer, Surface};

use super::figures::{PAPER, filled};
use crate::figures::Drawing;
use crate::figures::picture::{method, painted};
use crate::lessons::clipping::figures::ALL;
use crate::lessons::filtering::figures::{HALF, THIRD, of_light, rows_of};

/// Soft borders, blended as codes and as light.
pub(super) fn seam() -> anyhow::Result<Drawing> {
    const HEIGHT: u16 = 110;
    let strip = |space: &str, [left, right]: [Color; 2]| -> anyhow::Result<Image> {
        let space = *method(SPACES, space)?;
        Ok(painted(HALF, HEIGHT, |x, _| {
            let share = ((x as f32 + 0.5) / f32::from(HALF) * 1.6 - 0.3).clamp(0.0, 1.0);
            space.color(faded(right, share), left)
        }))
    };
    let pairs = [[Color::rgb(0, 190, 0), Color::rgb(235, 0, 0)], [Color::BLACK, Color::WHITE]];
    let row =
        |space| pairs.map(|pair| strip(space, pair)).into_iter().collect::<anyhow::Result<Vec<Image>>>();
    rows_of(&[row("encoded-straight")?, row("linear-straight")?])
}

/// A part of the fern, much enlarged, filtered and laid over a light wall.
pub(super) fn fringe() -> anyhow::Result<Drawing> {
    const HEIGHT: u16 = 270;
    let fern = Cutout::read(FERN)?;
    let picture = |name: &str| -> anyhow::Result<Image> {
        let mut image = filled(HALF, HEIGHT, WALL);
        fern.draw(method(SPACES, name)?, 9.0, Vec2::new(0.72, 0.62), &mut image);
        Ok(image)
    };
    let row = |names: [&str; 2]| names.map(picture).into_iter().collect::<anyhow::Result<Vec<Image>>>();
    rows_of(&[
        row(["encoded-straight", "encoded-premultiplied"])?,
        row(["linear-straight", "linear-premultiplied"])?,
    ])
}

/// Three triangles, each over the next one, in a circle.
fn in_a_circle(side: f32) -> Vec<Surface> {
    let colors = [Color::rgb(0xd5, 0x3e, 0x2a), Color::rgb(0xf2, 0xb1, 0x34), Color::rgb(0x1f, 0x77, 0xb4)];
    let surface = |(n, color): (usize, Color)| {
        let along = Vec2::from_angle(std::f32::consts::TAU * n as f32 / 3.0 + 0.35);
        let middle = Vec2::new(0.5, 0.5) + along.perp() * 0.14;
        let corner = |t: f32, across: f32, depth: f32| {
            ((middle + along * t + along.perp() * across) * side).extend(depth)
        };
        let corners = [corner(-0.38, -0.19, 0.2), corner(0.44, 0.0, 0.8), corner(-0.38, 0.19, 0.2)];
        Surface { corners, color: Color { a: 190, ..color } }
    };
    colors.into_iter().enumerate().map(surface).collect()
}

/// Two triangles, each in front of the other on one side.
fn crossed(side: f32) -> Vec<Surface> {
    let corner = |x: f32, y: f32, depth: f32| (Vec2::new(x, y) * side).extend(depth);
    let [red, blue] = [Color::rgb(0xd5, 0x3e, 0x2a), Color::rgb(0x1f, 0x77, 0xb4)];
    vec![
        Surface {
            corners: [corner(0.06, 0.1, 0.2), corner(0.94, 0.3, 0.8), corner(0.1, 0.9, 0.25)],
            color: Color { a: 190, ..red },
        },
        Surface {
            corners: [corner(0.94, 0.08, 0.3), corner(0.9, 0.92, 0.25), corner(0.06, 0.5, 0.9)],
            color: Color { a: 190, ..blue },
        },
    ]
}

/// Triangles in no order, by each way.
pub(super) fn crossing() -> anyhow::Result<Drawing> {
    const SIDE: u16 = 174;
    let row = |surfaces: Vec<Surface>| {
        let picture = |way: &Method<Transparency>| {
            let mut image = filled(SIDE, SIDE, PAPER);
            let depths = DepthBuffer::new(&image, 1.0);
            way.run.draw(&surfaces, Over(TwoShift), &mut image, &depths);
            image
        };
        TRANSPARENCY.iter().map(picture).collect::<Vec<Image>>()
    };
    rows_of(&[row(in_a_circle(SIDE.into())), row(crossed(SIDE.into()))])
}

/// All that arrives at each pixel.
struct Layers {
    bounds: Bounds,
    fragments: Vec<Vec<(f32, Color)>>,
}

impl Target<Color> for Layers {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn test(&mut self, _: i32, _: i32, _: f32) -> bool {
        true
    }

    fn write(&mut self, x: i32, y: i32, depth: f32, color: Color) {
        self.fragments[(y * (self.bounds.max.x + 1) + x) as usize].push((depth, color));
    }

    fn clear(&mut self) {
        self.fragments.iter_mut().for_each(Vec::clear);
    }
}

/// A knot of glass, its layers from the farthest on, and all of it.
pub(super) fn peeled() -> anyhow::Result<Drawing> {
    const HEIGHT: u16 = 220;
    let size = [3 * THIRD, 3 * HEIGHT];
    let color = Color::rgb(0x58, 0xb4, 0xe0);
    let loaded = Loaded::new(Model::read(Path::new(KNOT), ALL)?, painted(1, 1, |_, _| color), Wrap::Clamp);
    let knot = Filterable::new(loaded, of_light()?, filtering::Wrap::Clamp);
    let eye = Vec3::new(0.6, 1.0, 3.9);
    let look = view(eye, Vec3::ZERO, Vec3::Y).context("it looks somewhere")?;
    let to_clip = perspective(24.0, f32::from(size[0]) / f32::from(size[1]), 0.1, 100.0)? * look;
    let light = PointLight {
        position: Vec3::new(1.0, 3.0, 3.0),
        ambient: 0.45,
        diffuse: 0.6,
        ..PointLight::default()
    };
    let entity = Entity { model: &knot, to_world: Mat4::IDENTITY, alpha: 0.6 };
    let mut image = filled(size[0], size[1], PAPER);
    let shader = entity.shader(&View { to_clip, eye, light }, image.size()).context("it is not flat")?;
    let mut placed = Vec::new();
    gather(&shader, entity.mesh(), Cull::None, image.size(), &mut placed);
    let pixels = usize::from(size[0]) * usize::from(size[1]);
    let mut layers = Layers { bounds: image.bounds(), fragments: vec![Vec::new(); pixels] };
    placed.iter().for_each(|triangle| triangle.fill(&mut layers));
    layers.fragments.iter_mut().for_each(|all| all.sort_by(|a, b| b.0.total_cmp(&a.0)));
    let layer = |n: usize| {
        let pixel = |x: i32, y: i32| {
            let fragments = &layers.fragments[y as usize * usize::from(size[0]) + x as usize];
            fragments.get(n).map_or(PAPER, |&(_, color)| over(color, PAPER))
        };
        painted(size[0], size[1], pixel).scale(THIRD, HEIGHT)
    };
    let depths = DepthBuffer::new(&image, 1.0);
    method(TRANSPARENCY, "peeling")?.draw(&placed, Over(TwoShift), &mut image, &depths);
    let all = image.scale(THIRD, HEIGHT);
    rows_of(&[[0, 1, 2].map(layer).to_vec(), vec![layer(3), layer(4), all]])
}

/// The course's knot.
const KNOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/torus-knot.obj");

/// The lesson's rosette, by three ways.
pub(super) fn rosette() -> anyhow::Result<Drawing> {
    const LARGE: u16 = 3 * THIRD;
    let picture = |name: &str| -> anyhow::Result<Image> {
        let mut image = filled(LARGE, LARGE, PAPER);
        glass::draw(*method(TRANSPARENCY, name)?, Over(TwoShift), &mut image);
        Ok(image.scale(THIRD, THIRD))
    };
    let pictures = ["sorted", "list", "weighted"].map(picture).into_iter();
    rows_of(&[pictures.collect::<anyhow::Result<Vec<Image>>>()?])
}
