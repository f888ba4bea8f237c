//! Lesson 11's floor before any eye, drawn and as it is.

use checks::footprint::{Outside, Plane, Texture as Exactly, code};
use checks::ray::Screen;
use clipping::mesh::indexed;
use clipping::{Cull, Drawn, Mesh, SLABS};
use common::{Attributes, Color, DVec2, DVec3, Format, Image, Mat4, Model, Vec3, Vec4};
use filtering::scene::fine;
use filtering::{MIPMAPS, Surface, Texture, Wrap};
use perspective::{perspective, view};
use shaders::Uniforms;
use verify::method;

/// Degrees from the bottom to the top of the picture.
const FOV: f32 = 45.0;

/// At least so many rays to a length of 1 on the floor, which is two fields.
const DENSITY: f64 = 16.0;

/// An eye above the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Eye {
    pub(crate) from: Vec3,
    pub(crate) to: Vec3,
    pub(crate) up: Vec3,
}

impl Eye {
    /// Upright.
    pub(crate) const fn new(from: [f32; 3], to: [f32; 3]) -> Self {
        Self { from: Vec3::from_array(from), to: Vec3::from_array(to), up: Vec3::Y }
    }
}

/// The floor, with its checks, under a light that leaves codes as they are.
pub(crate) struct Floor {
    model: Model,
    mesh: Mesh,
    normals: Vec<[Vec3; 3]>,
    texture: Texture,
    exactly: Exactly,
}

/// Draws surfaces.
type Draw = fn(&[Surface], Cull, &mut Image) -> Drawn;

/// A picture's red, green and blue, from 0 to 255, in rows from the bottom; none where not all of a pixel is floor.
pub(crate) type Picture = Vec<Option<[f64; 3]>>;

impl Floor {
    pub(crate) fn new() -> Self {
        let [model, texture] = SLABS.map(std::path::Path::new);
        let needs = Attributes { normals: true, uvs: true };
        let model = Model::read(model, needs).unwrap();
        let normals = vec![[Vec3::Y; 3]; model.triangles().len()];
        let mesh = indexed(&model, &normals, needs);
        let image = fine(&Image::read(texture).unwrap());
        let texture = method(MIPMAPS, "box-linear").texture(&image, Wrap::Repeat);
        let exactly = Exactly::new(&image, Outside::Again);
        Self { model, mesh, normals, texture, exactly }
    }

    /// What a way to draw makes of it, in a square picture.
    pub(crate) fn drawn(&self, eye: Eye, side: u16, draw: Draw) -> Picture {
        let to_clip = perspective(FOV, 1.0, 0.1, 100.0).unwrap() * look(eye);
        let Self { model, mesh, normals, texture, .. } = self;
        let uniforms = Uniforms { normals, light: Vec3::Y, to_clip, ..Uniforms::new(model) };
        let mut image = Image::new(side, side, Format::Rgba);
        draw(&[Surface { uniforms, mesh, texture }], Cull::Back, &mut image);
        let channels = |Color { r, g, b, .. }: Color| [r, g, b].map(f64::from);
        image.pixels().map(|(.., color)| (color.a > 0).then(|| channels(color))).collect()
    }

    /// The same as it is: the mean of so many rays a pixel in each direction, or more where they would be too far apart. Nothing where they come within a hundredth of the horizon, or meet
    /// what lies beyond the far plane.
    pub(crate) fn exact(&self, eye: Eye, side: u16, rays: u32) -> Picture {
        let pixels = (0..i32::from(side)).flat_map(|y| (0..i32::from(side)).map(move |x| (x, y)));
        let (screen, plane) = (screen(side), plane(eye));
        pixels
            .map(|(x, y)| {
                let corner = |(dx, dy)| screen.direction(DVec2::new(f64::from(x + dx), f64::from(y + dy)));
                let inside = [(0, 0), (1, 0), (0, 1), (1, 1)].map(corner).into_iter().all(|ray| {
                    let seen = plane.met(ray);
                    seen.is_some_and(|uv| uv.abs().max_element() < 127.0)
                        && seen.is_some_and(|uv| -(plane.origin + plane.u * uv.x + plane.v * uv.y).z < 99.0)
                });
                if !inside {
                    return None;
                }
                let center = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                let rays =
                    plane.moves(&screen, center)?.map(|side| rays.max((DENSITY * side.length()) as u32));
                let light = plane.seen(&self.exactly, &screen, [x, y], rays)?;
                Some(light.map(code))
            })
            .collect()
    }
}

/// The directions of the pixels' rays.
pub(crate) fn screen(side: u16) -> Screen {
    Screen::ahead(FOV.into(), DVec2::splat(side.into()))
}

/// The floor in eye space. (u, v) are x and −z.
pub(crate) fn plane(eye: Eye) -> Plane {
    let to_eye = look(eye);
    let to = |point: Vec4| (to_eye.as_dmat4() * point.as_dvec4()).truncate();
    let direction = |x, y, z| -> DVec3 { to(Vec4::new(x, y, z, 0.0)) };
    Plane {
        origin: to(Vec4::new(0.0, -0.996, 0.0, 1.0)),
        u: direction(1.0, 0.0, 0.0),
        v: direction(0.0, 0.0, -1.0),
    }
}

fn look(eye: Eye) -> Mat4 {
    view(eye.from, eye.to, eye.up).unwrap()
}

/// The mean of what `off` says of two pictures' channels, where both have some.
pub(crate) fn mean<const N: usize>(pictures: [&Picture; N], off: impl Fn([f64; N]) -> f64) -> f64 {
    let (mut sum, mut count) = (0.0, 0_u32);
    for n in 0..pictures[0].len() {
        let pixels = pictures.map(|picture| picture[n]);
        if pixels.iter().all(Option::is_some) {
            for channel in 0..3 {
                sum += off(pixels.map(|pixel| pixel.unwrap_or_default()[channel]));
            }
            count += 3;
        }
    }
    assert!(count > 300, "{count}");
    sum / f64::from(count)
}
