//! Lesson 6: smooth shading.

use assets::mesh::Corner;
use assets::sphere::sphere;
use common::{Color, Format, Image, Model, Vec2, Vec3};
use gouraud::{Drawn, Scene, Wrap};
use live_loops::shades::Shade;
use transforms::affine::euler;

use crate::head::{sound, white};
use crate::view::beside;
use crate::{Drawing, Figure, Input, Values, View, number, whole};

/// Width and height of each picture.
const SIDE: u16 = 200;
/// The ball's radius, half of the picture's side being 1.
const RADIUS: f32 = 0.94;

/// A ball of white triangles, with the sphere's normals at the corners.
struct Ball {
    model: Model,
    normals: Vec<[Vec3; 3]>,
}

impl Ball {
    fn new(bands: usize) -> Self {
        let mesh = sphere(bands, 2 * bands);
        let points: Vec<Vec3> = mesh.positions.iter().map(|point| point.as_vec3()).collect();
        let triangles: Vec<[usize; 3]> =
            mesh.triangles.iter().map(|corners| corners.map(|Corner { position, .. }| position)).collect();
        let normals = triangles.iter().map(|triangle| triangle.map(|n| points[n])).collect();
        let numbers = triangles.iter().map(|triangle| triangle.map(|n| n as u32)).collect::<Vec<_>>();
        let positions = points.iter().map(|&point| point * RADIUS).collect();
        // One texel serves all corners.
        let uvs = vec![[0; 3]; numbers.len()];
        let model =
            Model::from_triangles(positions, numbers).and_then(|model| model.with_uvs(vec![Vec2::ZERO], uvs));
        Self { model: sound(model), normals }
    }

    /// The ball by that method.
    fn drawn(&self, shade: Shade, light: Vec3) -> (Image, Drawn) {
        let Self { model, normals } = self;
        let scene = Scene { model, normals, texture: &white(), wrap: Wrap::Clamp, light };
        let mut image = Image::new(SIDE, SIDE, Format::Rgb);
        let drawn = shade.draw_as_it_stands(&scene, &mut image);
        (image, drawn)
    }
}

/// The brightness of the sphere that the ball stands for at the centre of a pixel; `None` beside it.
fn brightness(x: i32, y: i32, light: Vec3) -> Option<f32> {
    let at = ((Vec2::new(x as f32, y as f32) + 0.5) / f32::from(SIDE) * 2.0 - 1.0) / RADIUS;
    let depth = 1.0 - at.length_squared();
    (depth >= 0.0).then(|| at.extend(depth.sqrt()).dot(light).max(0.0))
}

/// A picture of that sphere.
fn smooth(light: Vec3) -> Image {
    let mut image = Image::new(SIDE, SIDE, Format::Rgb);
    image.set_all(|n| {
        let [x, y] = [n % usize::from(SIDE), n / usize::from(SIDE)].map(|place| place as i32);
        brightness(x, y, light).map_or(Color::BLACK, Color::gray)
    });
    image
}

/// The light turned about a ball of few triangles.
pub(crate) const LIGHT: Figure = Figure {
    name: "gouraud-highlight",
    stays: true,
    hint: "Turn the light by dragging it over the balls, or by the sliders: at 0 and 0 it comes from you. Left flat, in the middle \
           Gouraud, right the sphere that is meant.",
    inputs: &[Input::Turn { from: [25.0, -35.0] }],
    draw: lit,
};

fn lit(mut values: Values) -> View {
    let [right, down] = [values.number(), values.number()];
    let light = euler(Vec3::new(down, right, 0.0)) * Vec3::Z;
    let ball = Ball::new(6);
    let pictures = vec![ball.drawn(Shade::Flat, light).0, ball.drawn(Shade::Gouraud, light).0, smooth(light)];
    let brightest = |image: &Image| image.pixels().map(|(_, _, color)| color.r).max().unwrap_or_default();
    let [flat, gouraud, sphere] = [0, 1, 2].map(|n| brightest(&pictures[n]));
    let [right, down] = [right, down].map(whole);
    let told = format!(
        "Light turned by {right}° to the right and {down}° down. The brightest pixel of {} triangles has {flat} of 255 in flat \
         shading and {gouraud} in Gouraud's, that of the sphere {sphere}.",
        ball.model.triangles().len(),
    );
    View { drawing: Drawing::Pixels(beside(&[pictures])), told, table: Vec::new() }
}

/// The number of triangles against outline and shading.
pub(crate) const COARSE: Figure = Figure {
    name: "gouraud-coarse",
    stays: true,
    hint: "Make the ball of more and of fewer bands. Left flat, in the middle Gouraud, right the sphere that is meant.",
    inputs: &[Input::Slider { label: "Bands from pole to pole", from: 6.0, range: [2.0, 32.0], step: 1.0 }],
    draw: coarse,
};

fn coarse(mut values: Values) -> View {
    let bands = values.number() as usize;
    let light = Vec3::new(0.5, 0.5, 0.7).normalize();
    let ball = Ball::new(bands);
    let [(flat, drawn), (gouraud, _)] = [Shade::Flat, Shade::Gouraud].map(|shade| ball.drawn(shade, light));
    let (mut whole, mut missing, mut off) = (0, 0, [0.0; 2]);
    for (x, y, color) in flat.pixels() {
        let Some(meant) = brightness(x, y, light) else { continue };
        whole += 1;
        if drawn.depths.get(x, y) == f32::NEG_INFINITY {
            missing += 1;
            continue;
        }
        for (off, shown) in off.iter_mut().zip([Some(color), gouraud.get(x, y)]) {
            *off += shown.map_or(0.0, |shown| (f32::from(shown.r) - 255.0 * meant).abs());
        }
    }
    let covered = (whole - missing).max(1) as f32;
    let told = format!(
        "{bands} bands, {} sectors, {} triangles: {missing} of the {whole} pixels of the sphere are missing at the \
         outline. In the others the brightness is off by {} of 255 in the mean by flat shading, by {} by Gouraud's.",
        2 * bands,
        ball.model.triangles().len(),
        number(off[0] / covered),
        number(off[1] / covered),
    );
    View { drawing: Drawing::Pixels(beside(&[vec![flat, gouraud, smooth(light)]])), told, table: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With the light from the front, no corner of these faces the eye, and the brightest pixel is dimmer than the sphere's.
    #[test]
    fn the_sphere_is_as_bright_as_can_be() {
        let brightest = smooth(Vec3::Z).pixels().map(|(_, _, color)| color.r).max();
        assert_eq!(brightest, Some(255));
    }
}
