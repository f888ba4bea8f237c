//! Chapter 14's pictures of the lesson's own scenes.

use std::path::Path;

use anyhow::Context;
use blending::crates::{self, CRATE};
use blending::scene::{Entity, View};
use blending::{
    Compare, DepthTest, Framebuffer, Less, METHODS, Over, State, StencilOp, StencilTest, Translucent,
    TwoShift, mirror, outline, sheet,
};
use clipping::{Clipping, Cull, render};
use common::program::model::TexturedModelFlags;
use common::{Color, DVec3, Format, Image, Mat4, Model, Vec3};
use filtering::Wrap;
use filtering::scene::Filterable;
use lighting::PointLight;
use perspective::scene::Loaded;
use perspective::{perspective, view};

use crate::figures::Drawing;
use crate::figures::picture::{canvas, method, model, painted, texture};
use crate::lessons::clipping::figures::ALL;
use crate::lessons::filtering::figures::{HALF, THIRD, of_light, rows_of};

/// How many times as large a picture is drawn as it is shown.
const LARGER: u16 = 3;

/// The camera and the lamp of the program.
fn seen() -> anyhow::Result<View> {
    let eye = Vec3::new(0.6, 1.2, 3.25);
    let look = view(eye, Vec3::ZERO, Vec3::Y).context("it looks somewhere")?;
    let light = PointLight {
        position: Vec3::new(-0.4, 2.4, 3.1),
        ambient: 0.34,
        diffuse: 1.05,
        ..PointLight::default()
    };
    Ok(View { to_clip: perspective(45.0, 1.0, 0.1, 100.0)? * look, eye, light })
}

fn filterable(model: Model, texture: Image) -> anyhow::Result<Filterable> {
    Ok(Filterable::new(Loaded::new(model, texture, textures::Wrap::Clamp), of_light()?, Wrap::Repeat))
}

fn of_crate() -> anyhow::Result<Filterable> {
    let [model, texture] = CRATE.map(Path::new);
    filterable(Model::read(model, ALL)?, Image::read(texture)?)
}

/// The head, and its floor.
fn on_floor() -> anyhow::Result<Vec<Filterable>> {
    Filterable::read(&TexturedModelFlags::default(), DVec3::ZERO, of_light()?, Wrap::Repeat)
}

pub(super) fn crates() -> anyhow::Result<Drawing> {
    let (model, view) = (of_crate()?, seen()?);
    let entities = method(METHODS, "two-shift")?.entities;
    let [large, small] = crates::entities(&model);
    let picture = |small: Entity| {
        let mut image = canvas(LARGER * HALF);
        entities(&[large, small], &view, &mut image);
        image.scale(HALF, HALF)
    };
    rows_of(&[vec![picture(Entity { alpha: 1.0, ..small }), picture(small)]])
}

/// The smaller crate with an alpha at each vertex, 1 at its top and 0 at its base, by two alphas of its own.
pub(super) fn fading() -> anyhow::Result<Drawing> {
    let file = Model::read(Path::new(CRATE[0]), ALL)?;
    let of_vertex = |vertex: u32| if file.positions()[vertex as usize].y > 0.0 { 1.0 } else { 0.0 };
    let alphas: Vec<[f32; 3]> = file.triangles().iter().map(|corners| corners.map(of_vertex)).collect();
    let (model, view) = (of_crate()?, seen()?);
    let [large, small] = crates::entities(&model);
    let picture = |alpha: f32| -> anyhow::Result<Image> {
        let mut image = canvas(LARGER * HALF);
        let shader = small.shader(&view, image.size()).context("no crate is flat")?.shader;
        let mut target = Framebuffer::new(&mut image, State::OFF);
        large.draw(&view, Cull::Back, &mut target);
        let mut target = target.under(State::blending(Over(TwoShift)));
        let shader = Translucent { shader, alpha, vertices: &alphas[..] };
        render(&shader, small.mesh(), Cull::Back, Clipping::GuardBand, &mut target);
        Ok(image.scale(HALF, HALF))
    };
    rows_of(&[vec![picture(1.0)?, picture(0.5)?]])
}

/// What a stencil keeps, as a picture: light where it is 1.
fn pictured(stencils: &[u8], image: &Image) -> Image {
    let [width, height] = [image.width(), image.height()];
    painted(width as u16, height as u16, |x, y| match stencils[(y * width + x) as usize] {
        0 => Color::rgb(0x1d, 0x21, 0x27),
        _ => Color::rgb(0xf2, 0xc1, 0x4e),
    })
}

/// What passes marks its pixel.
const MARK: StencilTest = StencilTest { reference: 1, pass: StencilOp::Replace, ..StencilTest::ALWAYS };

fn marking<D>(depth: D) -> State<(), StencilTest, D> {
    State { scissor: (), stencil: MARK, depth, blend: (), mask: () }
}

pub(super) fn outlined() -> anyhow::Result<Drawing> {
    let (head, view) = (filterable(model()?, texture()?)?, seen()?);
    let entity = Entity { model: &head, to_world: Mat4::IDENTITY, alpha: 1.0 };
    let mut image = canvas(LARGER * HALF);
    let mut target = Framebuffer::new(&mut image, marking(Less));
    entity.draw(&view, Cull::Back, &mut target);
    let stencil = pictured(&target.stencils, target.image);
    let mut image = canvas(LARGER * HALF);
    outline::draw(&entity, &view, Color::rgb(255, 196, 96), &mut image);
    rows_of(&[vec![stencil.scale(HALF, HALF), image.scale(HALF, HALF)]])
}

pub(super) fn mirrored() -> anyhow::Result<Drawing> {
    let (models, wood, view) = (on_floor()?, of_crate()?, seen()?);
    let (mirror, world) = mirror::scene(&models, &wood);
    // The lesson's first two steps.
    let mut image = canvas(LARGER * THIRD);
    let depth = DepthTest { function: Compare::Less, write: false };
    let mut target = Framebuffer::new(&mut image, marking(depth));
    mirror.pane.draw(&view, Cull::Back, &mut target);
    let stencil = pictured(&target.stencils, target.image);
    target.image.set_all(|_| Color::BLACK);
    let pane = &mirror.pane.to_world;
    let over = mirror::reflection(pane.transform_point3(Vec3::Z / 2.0), pane.z_axis.truncate().normalize());
    let light = PointLight { position: over.transform_point3(view.light.position), ..view.light };
    let marked = StencilTest { function: Compare::Equal, pass: StencilOp::Keep, ..MARK };
    let mut target = target.under(State { stencil: marked, ..marking(Less) });
    for entity in &world {
        let turned = Entity { to_world: over * entity.to_world, ..*entity };
        turned.draw(&View { light, ..view }, Cull::Front, &mut target);
    }
    let reflected = target.image.scale(THIRD, THIRD);
    let mut image = canvas(LARGER * THIRD);
    mirror::draw(&mirror, &world, &view, &mut image);
    rows_of(&[vec![stencil.scale(THIRD, THIRD), reflected, image.scale(THIRD, THIRD)]])
}

pub(super) fn outputs() -> anyhow::Result<Drawing> {
    let (models, view) = (on_floor()?, seen()?);
    let entities: Vec<Entity> =
        models.iter().map(|model| Entity { model, to_world: Mat4::IDENTITY, alpha: 1.0 }).collect();
    let side = 2 * HALF;
    let mut image = Image::new(2 * side, 2 * side, Format::Rgb);
    sheet::draw(&entities, &view, &mut image);
    Ok(Drawing::Pixels(image.scale(side, side), 1))
}
