//! Chapter 8: looking at a point.

use anyhow::Context;
use camera::turntable::turned;
use camera::{Look, METHODS, View, basis, relative};
use common::{Color, Image, Mat3, Vec2, Vec3};
use gouraud::{Scene, Wrap, corner_normals};
use transforms::{place, projection, viewport};

use crate::figures::picture::{all_beside, method, model, texture};
use crate::figures::sheet::{AMBER, BLACK, BLUE, FAINT, GREEN, GREY, Ink, ORANGE, PURPLE, SKY, Sheet};
use crate::figures::{Drawing, Figure};
use crate::lessons::gouraud::figures::smooth;
use crate::lessons::transforms::figures::seen_from;

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new("camera-head", "The model from the front, and from the right and above.", || {
        views(&[Vec3::Z * 2.4, Vec3::new(1.0, 1.0, 2.0)].map(Shot::of_model))
    }),
    Figure::new(
        "camera-basis",
        "An eye that looks at a centre. At the centre stand three arrows at right angles: z' points to the eye, \
         x' to its right, y' up. The picture is the square that x' and y' span.",
        eye_and_basis,
    ),
    Figure::new(
        "camera-change",
        "A point P and two frames: one at O with level axes, and one at O' with slanting axes. P has a pair of \
         coordinates in each.",
        change,
    ),
    Figure::new(
        "camera-up",
        "Seen from the side: z' points to the eye, up stands askew to it. Without its part along z', up becomes y'.",
        up,
    ),
    Figure::new(
        "camera-steps",
        "From above, in three steps: a letter and an eye that looks at it, off the origin; both moved so that the \
         letter is at the origin; both turned so that the eye is straight below it.",
        || steps(Vec2::new(1.3, -1.1), true),
    ),
    Figure::new(
        "camera-listing-steps",
        "The same in the other order: first everything is turned, then the centre is subtracted, unturned. The \
         letter ends beside the origin.",
        || steps(Vec2::new(1.3, -1.1), false),
    ),
    Figure::new(
        "camera-listing",
        "The model with an eye that looks at a point of its face, the middle of the picture marked by a cross: by \
         the listing the point lies off the cross, by lookat under it.",
        by_both,
    ),
    Figure::new(
        "camera-chain",
        "Four boxes in a row: model, world, eye, picture. The arrows between them are the matrices T R S, V, and \
         viewport times projection, with the division by w.",
        chain,
    ),
    Figure::new(
        "camera-pole",
        "Four pictures of an eye that climbs over the top of the model: at 60, 85, 95 and 120 degrees. Between the \
         second and the third the picture has turned upside down.",
        pole,
    ),
    Figure::new(
        "camera-far",
        "The model and the eye, moved together to 10,000, 100,000 and 1,000,000: there the face is in steps, and \
         at last in rags. And once more at 1,000,000, by camera-relative drawing.",
        far,
    ),
    Figure::new(
        "camera-turntable",
        "Five pictures from a walk around the model, from its right side over the front to its left.",
        turntable,
    ),
];

/// An eye that looks at a centre, in a picture of which a length of 1 takes up this part.
struct Shot {
    eye: Vec3,
    center: Vec3,
    zoom: f32,
    light: Vec3,
}

/// From the front, a little from the right and above.
const LIGHT: Vec3 = Vec3::new(0.3, 0.4, 0.85);

impl Shot {
    /// Of the model where it stands, lit from the front.
    fn of_model(eye: Vec3) -> Self {
        Self { eye, center: Vec3::ZERO, zoom: 0.42, light: LIGHT }
    }
}

/// The model, moved together with the eye that looks at it.
fn view(look: Look, shot: &Shot, moved: Vec3) -> anyhow::Result<Image> {
    let Shot { eye, center, zoom, light } = *shot;
    let (model, texture, light) = (model()?, texture()?, light.normalize());
    let View { origin, matrix } =
        look(eye + moved, center + moved, Vec3::Y).context("the eye is at the centre")?;
    let all = viewport(500.0, 500.0, zoom) * projection(eye.distance(center)) * matrix;
    let scene = Scene {
        model: &model,
        normals: &corner_normals(&model),
        texture: &texture,
        wrap: Wrap::Clamp,
        light,
    };
    Ok(smooth(500, &scene, |point| place(&all, point + moved - origin)))
}

fn views(shots: &[Shot]) -> anyhow::Result<Drawing> {
    let lookat = *method(METHODS, "lookat")?;
    all_beside(shots.iter().map(|shot| view(lookat, shot, Vec3::ZERO)))
}

fn eye_and_basis() -> anyhow::Result<Drawing> {
    let see = seen_from(Vec3::new(-0.7, 1.3, 3.0))?;
    let (eye, center) = (Vec3::new(1.9, 1.5, 1.9), Vec3::new(-0.5, 0.1, -0.5));
    let rows = basis(eye, center, Vec3::Y).context("the eye is at the centre")?;
    let [x, y, z] = [0, 1, 2].map(|row| rows.row(row));
    let mut sheet = Sheet::new((-2.3, -1.55), (3.5, 2.0));
    let corner = |i: f32, j: f32| see(center + x * i + y * j);
    sheet.polygon(&[corner(-1.1, -1.1), corner(1.1, -1.1), corner(1.1, 1.1), corner(-1.1, 1.1)], SKY, BLUE);
    sheet.dashed(see(center), see(eye), GREY, 2.0);
    for (axis, ink, name) in [(x, ORANGE, "x′"), (y, GREEN, "y′"), (z, BLACK, "z′")] {
        sheet.arrow(see(center), see(center + axis * 0.95), ink);
        let tip = see(center + axis * 0.95);
        sheet.text(tip + (tip - see(center)).normalize() * 0.2, name, ink);
    }
    sheet.arrow(see(eye), see(eye + Vec3::Y * 0.75), PURPLE);
    sheet.dot(see(center), BLUE);
    sheet.dot(see(eye), BLACK);
    sheet.text_right_of(see(eye + Vec3::Y * 0.6) + Vec2::new(0.12, 0.0), "up", PURPLE);
    sheet.text_right_of(see(eye) + Vec2::new(0.12, -0.05), "eye E", BLACK);
    sheet.text(see(center) + Vec2::new(-0.1, -0.24), "C", BLUE);
    sheet.text(corner(-1.1, -1.1) + Vec2::new(0.1, -0.25), "the picture", BLUE);
    sheet.finish()
}

fn change() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.6, -0.6), (6.4, 3.9));
    let at = Vec2::new;
    let (other, i) = (at(2.4, 0.7), Vec2::from_angle(28_f32.to_radians()));
    let j = i.perp();
    let (a, b) = (2.6, 1.3);
    let p = other + i * a + j * b;
    for (from, to) in [(at(p.x, 0.0), p), (at(0.0, p.y), p)] {
        sheet.dashed(from, to, GREY, 1.8);
    }
    for (from, to) in [(other + i * a, p), (other + j * b, p)] {
        sheet.dashed(from, to, BLUE, 1.8);
    }
    sheet.line(Vec2::ZERO, (6.2, 0.0), FAINT, 1.8);
    sheet.line(Vec2::ZERO, (0.0, 3.8), FAINT, 1.8);
    sheet.line(other, other + i * 3.6, SKY, 1.8);
    sheet.line(other, other + j * 2.4, SKY, 1.8);
    sheet.arrow(Vec2::ZERO, other, PURPLE);
    sheet.arrow(Vec2::ZERO, (1.0, 0.0), BLACK);
    sheet.arrow(Vec2::ZERO, (0.0, 1.0), BLACK);
    sheet.arrow(other, other + i, BLUE);
    sheet.arrow(other, other + j, BLUE);
    sheet.dot(p, ORANGE);
    sheet.text_right_of(p + at(0.12, 0.12), "P", ORANGE);
    sheet.text((-0.2, -0.25), "O", BLACK);
    sheet.text((0.9, -0.28), "i", BLACK);
    sheet.text((-0.25, 0.9), "j", BLACK);
    sheet.text(other + at(0.15, -0.28), "O′", BLUE);
    sheet.text(other + i * 0.95 + at(0.12, -0.28), "i′", BLUE);
    sheet.text_left_of(other + j * 0.95 + at(-0.12, 0.0), "j′", BLUE);
    sheet.text((p.x, -0.28), "x", GREY);
    sheet.text_left_of((-0.1, p.y), "y", GREY);
    sheet.text(other + i * a + at(0.12, -0.28), "x′", BLUE);
    sheet.text_left_of(other + j * b + at(-0.12, 0.05), "y′", BLUE);
    sheet.finish()
}

fn up() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.3, -0.45), (4.0, 2.0));
    let z = Vec2::from_angle(24_f32.to_radians());
    let up = Vec2::Y * 1.7;
    let y = (up - z * up.dot(z)).normalize();
    sheet.dashed(Vec2::ZERO, z * 3.4, GREY, 1.8);
    sheet.dashed(up, up - z * up.dot(z), GREY, 1.8);
    sheet.dashed(Vec2::ZERO, up - z * up.dot(z), GREY, 1.8);
    sheet.arrow(Vec2::ZERO, z * 1.2, BLACK);
    sheet.arrow(Vec2::ZERO, up, PURPLE);
    sheet.arrow(Vec2::ZERO, y * 1.2, GREEN);
    sheet.dot(Vec2::ZERO, ORANGE);
    sheet.dot(z * 3.4, BLACK);
    sheet.arc(Vec2::ZERO, 0.42, z.to_angle(), std::f32::consts::FRAC_PI_2, BLACK);
    sheet.text(Vec2::from_angle(1.0) * 0.6, "θ", BLACK);
    sheet.text(z * 3.4 + Vec2::new(0.0, -0.25), "eye", BLACK);
    sheet.text(z * 1.2 + Vec2::new(0.1, -0.22), "z′", BLACK);
    sheet.text_right_of(up + Vec2::new(0.1, 0.0), "up", PURPLE);
    sheet.text_left_of(y * 1.2 + Vec2::new(-0.1, 0.0), "y′", GREEN);
    sheet.text((0.25, -0.25), "x′, towards you", ORANGE);
    sheet.finish()
}

/// A letter on the ground as seen from above, about its middle.
const LETTER: [(f32, f32); 10] = [
    (-0.35, -0.6),
    (-0.1, -0.6),
    (-0.1, -0.1),
    (0.3, -0.1),
    (0.3, 0.15),
    (-0.1, 0.15),
    (-0.1, 0.4),
    (0.45, 0.4),
    (0.45, 0.65),
    (-0.35, 0.65),
];

/// The way of an eye and the letter that it looks at into the eye's frame, from above: x to the right, z down.
fn steps(center: Vec2, right_order: bool) -> anyhow::Result<Drawing> {
    let center = Vec3::new(center.x, 0.0, center.y);
    let eye = center + Vec3::new(1.4, 0.0, 1.4);
    let turn = basis(eye, center, Vec3::Y).context("the eye is at the centre")?;
    let moved = move |m: Mat3, before: Vec3, after: Vec3| move |p: Vec3| m * (p - before) - after;
    let (identity, zero) = (Mat3::IDENTITY, Vec3::ZERO);
    let panels = if right_order {
        [
            ("1. the world", moved(identity, zero, zero)),
            ("2. P − C", moved(identity, center, zero)),
            ("3. R · (P − C)", moved(turn, center, zero)),
        ]
    } else {
        [
            ("1. the world", moved(identity, zero, zero)),
            ("2. R · P", moved(turn, zero, zero)),
            ("3. R · P − C", moved(turn, zero, center)),
        ]
    };
    let mut sheet = Sheet::new((-1.9, -4.2), (11.6, 2.4));
    for (n, (words, map)) in panels.iter().enumerate() {
        let origin = Vec2::new(4.4 * n as f32, 0.0);
        let at = |p: Vec3| origin + Vec2::new(map(p).x, -map(p).z);
        sheet.axes(origin, (-1.8, -2.2), (2.3, 2.2), 1.4);
        let letter = LETTER.map(|(x, y)| at(center + Vec3::new(x, 0.0, -y)));
        sheet.polygon(&letter, SKY, BLUE);
        sheet.dashed(at(eye), at(center), BLACK, 1.8);
        sheet.dot(at(center), ORANGE);
        sheet.dot(at(eye), BLACK);
        sheet.text(origin + Vec2::new(0.2, -3.9), words, BLACK);
    }
    sheet.finish()
}

fn by_both() -> anyhow::Result<Drawing> {
    let shot =
        Shot { center: Vec3::new(0.0, 0.1, 0.55), zoom: 0.5, ..Shot::of_model(Vec3::new(1.7, 0.5, 1.9)) };
    all_beside(["listing", "lookat"].map(|name| {
        let mut image = view(*method(METHODS, name)?, &shot, Vec3::ZERO)?;
        // The middle, marked.
        for n in -14..=14 {
            for (x, y) in [(250 + n, 250), (250, 250 + n), (250 + n, 249), (249, 250 + n)] {
                image.set(x, y, Color::WHITE);
            }
        }
        Ok(image)
    }))
}

fn chain() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((0.0, -1.35), (14.4, 2.1));
    let boxes: [(&str, &str, Ink); 4] = [
        ("model", "where it was made", AMBER),
        ("world", "where it stands", AMBER),
        ("eye", "as it is seen", SKY),
        ("picture", "pixels, depth", SKY),
    ];
    for (n, (name, _, fill)) in boxes.iter().enumerate() {
        let left = 4.0 * n as f32;
        sheet.labelled((left + 1.2, 0.0), (1.1, 0.5), fill, name);
    }
    for (n, words) in ["T · R · S", "V", "W · P, ÷ w"].iter().enumerate() {
        let left = 4.0 * n as f32 + 2.4;
        sheet.arrow((left, 0.0), (left + 1.6, 0.0), BLACK);
        sheet.text((left + 0.8, 0.95), words, ORANGE);
    }
    for (n, words) in ["chapter 7", "this one", "chapter 7"].iter().enumerate() {
        sheet.text((4.0 * n as f32 + 3.2, -0.95), words, GREY);
    }
    sheet.finish()
}

fn pole() -> anyhow::Result<Drawing> {
    let shot = |degrees: f32| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Shot { light: Vec3::new(0.2, 0.9, 0.3), ..Shot::of_model(Vec3::new(0.0, 2.6 * sin, 2.6 * cos)) }
    };
    views(&[60.0, 85.0, 95.0, 120.0].map(shot))
}

fn far() -> anyhow::Result<Drawing> {
    let shot = Shot::of_model(Vec3::new(0.5, 0.3, 2.4));
    let lookat = *method(METHODS, "lookat")?;
    let by = [(lookat, 1e4), (lookat, 1e5), (lookat, 1e6), (relative as Look, 1e6)];
    all_beside(by.map(|(look, distance)| view(look, &shot, Vec3::splat(distance))))
}

fn turntable() -> anyhow::Result<Drawing> {
    let eye = Vec3::new(0.0, 0.5, 2.4);
    let stop = |n: i8| Shot::of_model(turned(eye, Vec3::ZERO, Vec3::Y, f32::from(n) / 8.0));
    views(&[-2, -1, 0, 1, 2].map(stop))
}
