//! The head in the openings of the chapters that draw nothing else, by their methods.

use std::f32::consts::TAU;

use camera::lookat;
use common::{Color, DVec3, Image, Mat4, Method, Vec2, Vec3};
use gouraud::{Scene, Wrap};
use live_loops::shades::Shade;
use perspective::scene::Loaded;
use shaders::{Framebuffer, Uniforms, fit};
use textures::draw_textured;
use transforms::rotation::rodrigues_f64;
use transforms::{place, projection, translate, viewport};
use triangles::{draw_model, flat_intensity};

use crate::head::{HEAD, HINT, SIDE, TURN, Turned, canvas, eye, method, smooth, view, white};
use crate::input::{named, with};
use crate::looks::{CALLS, LOOKS};
use crate::textures::SAMPLERS;
use crate::{Figure, Input, Values, View, number};

/// Lesson 1's lines: the edges of the head.
pub(crate) const LINES: Figure = Figure {
    name: "lines-two",
    stays: true,
    hint: "Turn a head of lines by dragging it, or by the sliders. Choose by which method its lines are drawn.",
    inputs: &[TURN, method(|| Method::rows(lines::METHODS), "bresenham")],
    draw: |values| {
        drawn(values, named!(lines::METHODS), |method, head, image| {
            let mut pixels = 0;
            let edges = wireframe::edges(&head.model);
            for edge in &edges {
                let [from, to] = edge.map(|n| wireframe::to_pixel(head.model.positions()[n as usize], image));
                (method.draw)(from, to, image, Color::WHITE);
                (method.visit)(from, to, image.bounds(), &mut |_, _, _| pixels += 1);
            }
            format!("{} lines, for which pixels are coloured {pixels} times", edges.len())
        })
    },
};

/// Lesson 2's head.
pub(crate) const WIREFRAME: Figure = Figure {
    name: "wireframe-head",
    stays: true,
    hint: HINT,
    inputs: &[TURN, method(|| Method::rows(wireframe::METHODS), "unique-edges")],
    draw: |values| {
        drawn(values, named!(wireframe::METHODS), |method, head, image| {
            (method.draw)(&head.model, image, Color::WHITE);
            let mut lines = 0;
            (method.visit)(&head.model, &mut |_| lines += 1);
            format!("lines drawn: {lines}")
        })
    },
};

/// Lesson 3's head, which knows no depth: the later triangle covers the earlier one.
pub(crate) const TRIANGLES: Figure = Figure {
    name: "triangles-head",
    stays: true,
    hint: HINT,
    inputs: &[TURN, method(|| Method::rows(triangles::METHODS), "edges")],
    draw: |values| {
        drawn(values, named!(triangles::METHODS), |method, head, image| {
            draw_model(&head.model, method, image, |_, corners| {
                let intensity = flat_intensity(corners, Vec3::Z);
                (intensity >= 0.0).then(|| Color::gray(intensity))
            });
            head.facing()
        })
    },
};

/// Lesson 4's head.
pub(crate) const ZBUFFER: Figure = Figure {
    name: "zbuffer-head",
    stays: true,
    hint: HINT,
    inputs: &[TURN, method(|| Method::rows(zbuffer::METHODS), "z-f32")],
    draw: |values| {
        drawn(values, named!(zbuffer::METHODS), |method, head, image| {
            let surfaces = zbuffer::surfaces(&head.model, Vec3::Z, image);
            (method.draw)(&surfaces, image);
            head.facing()
        })
    },
};

/// Lesson 5's head.
pub(crate) const TEXTURES: Figure = Figure {
    name: "textures-head",
    stays: true,
    hint: HINT,
    inputs: &[TURN, method(|| Method::rows(textures::METHODS), "nearest")],
    draw: |values| {
        drawn(values, SAMPLERS, |sample, head, image| {
            draw_textured(&head.model, Vec3::Z, image, |uv| sample(&HEAD.texture, uv));
            head.facing()
        })
    },
};

/// Lesson 6's methods.
const SHADES: &[Method<Shade>] = &with(gouraud::METHODS, [Shade::None, Shade::Flat, Shade::Gouraud]);

/// Lesson 6's head, white instead of textured.
pub(crate) const GOURAUD: Figure = Figure {
    name: "gouraud-three",
    stays: true,
    hint: HINT,
    inputs: &[TURN, method(|| Method::rows(gouraud::METHODS), "gouraud")],
    draw: |values| {
        drawn(values, SHADES, |shade, head, image| {
            let Turned { model, normals } = head;
            let scene = Scene { model, normals, texture: &white(), wrap: Wrap::Clamp, light: Vec3::Z };
            shade.draw_as_it_stands(&scene, image);
            head.facing()
        })
    },
};

/// The head turned, drawn by the method chosen, which tells something of it.
fn drawn<F>(
    mut values: Values,
    table: &'static [Method<F>],
    draw: impl Fn(&F, &Turned, &mut Image) -> String,
) -> View {
    let turn = [values.number(), values.number()];
    let method = values.choice(table);
    let mut image = canvas(SIDE);
    let rest = draw(&method.run, &Turned::by(turn), &mut image);
    view(image, method.name, "the head", turn, &rest)
}

/// What the chapter has, too: by it f32 shrinks much.
const ANGLE: f32 = TAU * 347.0 / 1000.0;

/// Lesson 7's head.
pub(crate) const TRANSFORMS: Figure = Figure {
    name: "transforms-head",
    stays: true,
    hint: "Turn the head by dragging it, or by the sliders. Before that it is turned many times by 347/1000 of a \
           circle, and once back by the sum. Choose how that is computed.",
    inputs: &[
        TURN,
        Input::Slider { label: "Rotations: 10ⁿ, n", from: 3.0, range: [3.0, 5.0], step: 1.0 },
        method(|| Method::rows(transforms::METHODS), "f32"),
    ],
    draw: composed,
};

fn composed(mut values: Values) -> View {
    let turn = [values.number(), values.number()];
    let count = 10_u32.pow(values.number() as u32);
    let method = values.choice(named!(transforms::METHODS));
    // What would bring it back, without any error.
    let back = rodrigues_f64(DVec3::Y, -f64::from(ANGLE) * f64::from(count)).as_mat3();
    let product = back * (method.run)(Vec3::Y, ANGLE, count);
    let Turned { model, normals } = &Turned::by(turn);
    let normals: Vec<_> = normals.iter().map(|corners| corners.map(|normal| product * normal)).collect();
    let side = f32::from(SIDE);
    let all = viewport(side, side, 0.42) * projection(2.0) * Mat4::from_mat3(product);
    let scene = Scene { model, normals: &normals, texture: &HEAD.texture, wrap: Wrap::Clamp, light: Vec3::Z };
    let image = smooth(&scene, &all);
    let apart = |&point: &Vec3| (product * point).distance(point);
    let farthest = model.positions().iter().map(apart).fold(0.0, f32::max);
    let rest = format!("{count} rotations leave a corner up to {} from where it was", number(farthest));
    view(image, method.name, "the head", turn, &rest)
}

/// Lesson 8's head.
pub(crate) const CAMERA: Figure = Figure {
    name: "camera-head",
    stays: true,
    hint: "Take the eye around the head by dragging, or by the sliders; it looks at a centre, marked by a cross. Move the \
           centre, and choose another method.",
    inputs: &[
        Input::Turn { from: [-27.0, 24.0] },
        Input::Slider { label: "The centre, z", from: 0.0, range: [0.0, 0.6], step: 0.05 },
        method(|| Method::rows(camera::METHODS), "lookat"),
    ],
    draw: looked_at,
};

fn looked_at(mut values: Values) -> View {
    const DISTANCE: f32 = 2.4;
    let turn = [values.number(), values.number()];
    let center = Vec3::Z * values.number();
    let method = values.choice(named!(camera::METHODS));
    let camera::View { origin, matrix } =
        (method.run)(eye(center, DISTANCE, turn), center, Vec3::Y).expect("the eye is not at the centre");
    let side = f32::from(SIDE);
    // Here, where nothing is far away, what is subtracted may be so by the matrix.
    let all = viewport(side, side, 0.36) * projection(DISTANCE) * matrix * translate(-origin);
    let Loaded { model, normals, texture, wrap } = &*HEAD;
    let light = Vec3::new(0.3, 0.4, 0.85).normalize();
    let mut image = smooth(&Scene { model, normals, texture, wrap: *wrap, light }, &all);
    let at = place(&all, center).unwrap_or_default().truncate();
    for n in -8..=8 {
        let [x, y] = at.to_array().map(|x| x as i32);
        image.set(x + n, y, Color::WHITE);
        image.set(x, y + n, Color::WHITE);
    }
    let off = at.distance(Vec2::splat(side / 2.0));
    let rest = format!("the centre is drawn {} pixels from the picture's middle", number(off));
    view(image, method.name, "the head", turn, &rest)
}

/// Lesson 9's head.
pub(crate) const SHADERS: Figure = Figure {
    name: "shaders-sheet",
    stays: true,
    hint: "Turn the head by dragging it, or by the sliders. Choose another look, and how its shader is called.",
    inputs: &[
        Input::Turn { from: [-27.0, 24.0] },
        Input::Choice { label: "Look", rows: || Method::rows(shaders::SHADERS), from: "gouraud-texture" },
        method(|| Method::rows(shaders::METHODS), "generic"),
    ],
    draw: shaded,
};

fn shaded(mut values: Values) -> View {
    const DISTANCE: f32 = 2.4;
    let turn = [values.number(), values.number()];
    let look = values.choice(LOOKS);
    let call = values.choice(CALLS);
    let camera = lookat(eye(Vec3::ZERO, DISTANCE, turn), Vec3::ZERO, Vec3::Y).unwrap_or_default();
    let to_clip = fit(0.36, Vec2::ONE) * projection(DISTANCE) * camera;
    let Loaded { model, normals, texture, .. } = &*HEAD;
    let light = Vec3::new(0.5, 0.3, 0.8).normalize();
    let texture = Some(texture);
    let uniforms = Uniforms { normals, texture, light, to_clip, levels: 4, ..Uniforms::new(model) };
    let mut target = Framebuffer::new(canvas(SIDE));
    (call.run)(look.run, &uniforms, &mut target);
    let rest = format!("{} bytes are interpolated for each pixel", look.run.interpolated());
    view(target.image, &format!("{}, {}", look.name, call.name), "the head", turn, &rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_head_is_as_the_lesson_draws_it() {
        let Loaded { model, normals, texture, wrap } = &*HEAD;
        let scene = Scene { model, normals, texture, wrap: *wrap, light: Vec3::new(0.6, 0.0, 0.8) };
        for (own, lesson) in SHADES.iter().zip(gouraud::METHODS) {
            let [mut drawn, mut meant] = [canvas(100), canvas(100)];
            own.run.draw_as_it_stands(&scene, &mut drawn);
            (lesson.run)(&scene, &mut meant);
            assert!(drawn == meant, "{}", own.name);
        }
    }
}
