//! Chapter 7: matrices, viewport and projection.

use std::f32::consts::{PI, TAU};

use anyhow::Context;
use camera::lookat;
use common::{Color, DVec3, Image, Mat3, Mat4, Model, Quat, Vec2, Vec3, Vec4, Vec4Swizzles};
use gouraud::{Scene, Wrap, corner_normals};
use live::LETTER;
use transforms::affine::{about, rotate_x, rotate_y, rotate_z, shear_x};
use transforms::rotation::{from_quaternion, quaternion, rodrigues, rodrigues_f64};
use transforms::{METHODS, normal_matrix, place, projection, scale, translate, viewport};

use crate::figures::picture::{all_beside, beside, chequered, cut, method, model, texture};
use crate::figures::shape::{ball, parsed};
use crate::figures::sheet::{AMBER, BLACK, BLUE, FAINT, GREEN, GREY, Ink, ORANGE, PALE, PURPLE, SKY, Sheet};
use crate::figures::{Drawing, Figure};
use crate::lessons::gouraud::figures::{smooth, white};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "transforms-head",
        "The model twice: in perspective from a distance of 2, where the face is large and the back small, and in \
         parallel projection.",
        || distances(&[2.0, f32::INFINITY]),
    ),
    Figure::new(
        "transforms-maps",
        "The letter F under four maps of the plane: stretched, slanted, turned by 30 degrees, and moved.",
        maps,
    ),
    Figure::new(
        "transforms-homogeneous",
        "A plane with the axes x and w. Points lie on the line w = 1. Slanting the plane along x moves them to \
         the right; a vector on the axis w = 0 stays where it is. A point on w = 2 is on the same ray as one on \
         w = 1.",
        homogeneous,
    ),
    Figure::new(
        "transforms-order",
        "The letter F first moved and then turned, and first turned and then moved: it ends in different places.",
        order,
    ),
    Figure::new(
        "transforms-about",
        "Turning about a point in three steps: move the point to the origin, turn, move it back.",
        about_point,
    ),
    Figure::new(
        "transforms-rodrigues",
        "A vector u beside an axis. Its part along the axis stays; its part across turns in a circle about the \
         axis, from u across towards the cross product of axis and u.",
        rodrigues_parts,
    ),
    Figure::new(
        "transforms-circle",
        "The circle seen from the tip of the axis: u across, the vector v at right angles to it, and the turned \
         vector as cosine times the one plus sine times the other.",
        circle,
    ),
    Figure::new(
        "transforms-gimbal",
        "Three rings, one in another, for the turns about y, x and z. At a pitch of 20 degrees their axes differ; \
         at 90 degrees the inner and the outer ring lie in one plane, and their axes in one line.",
        gimbal,
    ),
    Figure::new(
        "transforms-long-way",
        "Two ways from one orientation to another, 100 degrees apart: eight steps along the short arc, and eight \
         steps around the other side.",
        long_way,
    ),
    Figure::new(
        "transforms-normals",
        "An ellipse made of a circle by stretching it sideways. Normals that were stretched with it lean over; \
         those by the inverse transpose stand upright on the curve.",
        normals,
    ),
    Figure::new(
        "transforms-stretched",
        "A ball squashed to a lens, lit from above. With normals that were squashed, too, it still looks like a \
         ball that is lit from the side; with the right ones it is a lens.",
        stretched,
    ),
    Figure::new(
        "transforms-similar",
        "The eye on the z axis at d, the picture at z = 0, a point P behind it. The line from the eye to P cuts the \
         picture at x'. Two similar triangles have their tips in the eye.",
        similar,
    ),
    Figure::new(
        "transforms-distances",
        "The model from distances of 1.3, 2 and 5, each filling the picture as much: from near the nose and the \
         forehead are large and the ears hidden.",
        || distances(&[1.3, 2.0, 5.0]),
    ),
    Figure::new(
        "transforms-behind",
        "A curve of 1 over w against z: it rises to infinity where z is d, and comes back from minus infinity \
         behind the eye.",
        behind,
    ),
    Figure::new(
        "transforms-ghost",
        "A tiled floor that passes under the eye. With the test of w it ends at the lower border of the picture; \
         without it the part behind the eye appears upside down in the sky.",
        ghost,
    ),
    Figure::new(
        "transforms-frustum",
        "The field of view from the side, between a near and a far plane, with planes at equal distances; and the \
         square that the matrix makes of it, in which the planes crowd towards the far side.",
        frustum_to_cube,
    ),
    Figure::new(
        "transforms-depth",
        "Depth after division against the distance from the eye: a curve that is steep near the near plane and \
         flat far away; with a nearer near plane it is much steeper and flatter.",
        depth_row,
    ),
    Figure::new(
        "transforms-viewport",
        "A letter F in the square from minus 1 to 1, and the same in a picture of eight by six pixels.",
        to_pixels,
    ),
    Figure::new(
        "transforms-drift",
        "The model after ten million turns and one back by the sum of their angles: in f32 it has become narrow, \
         renormalised it looks a little aside, in f64 it looks ahead.",
        drift,
    ),
];

/// Where a matrix takes the letter.
fn letter(m: &Mat4) -> Vec<Vec2> {
    let points = LETTER.iter().map(|&(x, y)| place(m, Vec3::new(x, y, 0.0)));
    points.flatten().map(Vec3::truncate).collect()
}

/// Draws the letter as a matrix has it, with the origin at a place of the sheet.
fn draw_letter(sheet: &mut Sheet, origin: Vec2, m: &Mat4, fill: Ink, outline: Ink) {
    let corners: Vec<Vec2> = letter(m).iter().map(|&corner| origin + corner).collect();
    sheet.polygon(&corners, fill, outline);
}

/// A turn about z, as a matrix for points.
fn turn(degrees: f32) -> Mat4 {
    Mat4::from_mat3(rotate_z(degrees))
}

/// Points in space as seen from a place, in parallel projection.
pub(crate) fn seen_from(eye: Vec3) -> anyhow::Result<impl Fn(Vec3) -> Vec2> {
    let view = lookat(eye, Vec3::ZERO, Vec3::Y).context("the eye is at the centre")?;
    Ok(move |point: Vec3| (view * point.extend(1.0)).xy())
}

/// A model's normals by a matrix.
fn turned(model: &Model, by: Mat3) -> Vec<[Vec3; 3]> {
    corner_normals(model).iter().map(|corners| corners.map(|n| (by * n).normalize_or_zero())).collect()
}

/// A circle in space about an axis of length 1, as a chain of points.
fn ring(center: Vec3, axis: Vec3, radius: f32) -> impl Iterator<Item = Vec3> {
    let across = axis.any_orthonormal_vector() * radius;
    (0..=72).map(move |n| center + rodrigues(axis, TAU * n as f32 / 72.0) * across)
}

fn maps() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.9, -3.3), (6.3, 2.35));
    let panels = [
        ("stretched", scale(Vec3::new(1.8, 1.3, 1.0))),
        ("slanted", shear_x(0.5, 0.0)),
        ("turned", turn(30.0)),
        ("moved", translate(Vec3::new(0.9, 0.4, 0.0))),
    ];
    for (n, (words, m)) in panels.iter().enumerate() {
        let origin = Vec2::new(3.7 * (n % 2) as f32, -2.75 * (n / 2) as f32);
        sheet.axes(origin, Vec2::new(-0.8, -0.15), Vec2::new(2.4, 2.1), 1.4);
        draw_letter(&mut sheet, origin, m, SKY, BLUE);
        draw_letter(&mut sheet, origin, &Mat4::IDENTITY, "none", GREY);
        sheet.text(origin + Vec2::new(0.8, -0.35), words, BLACK);
    }
    sheet.finish()
}

fn homogeneous() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.7, -0.6), (5.4, 2.7));
    let at = Vec2::new;
    sheet.axes(Vec2::ZERO, at(-0.6, -0.3), at(5.2, 2.5), 1.4);
    sheet.line((-0.6, 1.0), (5.2, 1.0), BLACK, 2.4);
    // x' = x + 1.6·w.
    let slant = shear_x(1.6, 0.0);
    let [from, to] = [Mat4::IDENTITY, slant].map(|m| (m * Vec4::new(0.8, 1.0, 0.0, 1.0)).xy());
    sheet.dashed(Vec2::ZERO, from * 2.4, GREY, 1.6);
    sheet.arrow(Vec2::ZERO, from, BLUE);
    sheet.arrow(Vec2::ZERO, to, ORANGE);
    sheet.arrow(from + at(0.1, 0.12), to + at(-0.1, 0.12), GREEN);
    sheet.dot(from * 2.0, BLUE);
    sheet.arrow((3.4, 0.0), (4.6, 0.0), PURPLE);
    sheet.text_left_of((0.62, 1.2), "point", BLUE);
    sheet.text_right_of((2.5, 0.82), "moved", ORANGE);
    sheet.text_right_of((1.75, 2.0), "the same point, at w = 2", BLUE);
    sheet.text((4.0, 0.25), "a vector: w = 0", PURPLE);
    sheet.text((4.75, 1.2), "w = 1", BLACK);
    sheet.text((5.25, -0.25), "x", GREY);
    sheet.text((-0.2, 2.5), "w", GREY);
    sheet.finish()
}

fn order() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-2.0, -1.0), (9.6, 4.1));
    let (moved, turned) = (translate(Vec3::new(2.6, 0.0, 0.0)), turn(90.0));
    for (x, words, first, both) in [
        (0.0, "move, then turn: R · T", moved, turned * moved),
        (5.9, "turn, then move: T · R", turned, moved * turned),
    ] {
        let origin = Vec2::new(x, 0.0);
        sheet.axes(origin, Vec2::new(-1.8, -0.2), Vec2::new(3.6, 3.9), 1.4);
        draw_letter(&mut sheet, origin, &Mat4::IDENTITY, "none", GREY);
        draw_letter(&mut sheet, origin, &first, "none", ORANGE);
        draw_letter(&mut sheet, origin, &both, SKY, BLUE);
        sheet.text(origin + Vec2::new(1.0, -0.6), words, BLACK);
    }
    sheet.finish()
}

fn about_point() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.9, -2.6), (10.1, 2.4));
    let point = Vec3::new(1.0, 1.5, 0.0);
    let (back, turned) = (translate(-point), turn(60.0));
    let steps = [
        ("1. to the origin", Mat4::IDENTITY, back),
        ("2. turn", back, turned * back),
        ("3. back", turned * back, about(point, turned)),
    ];
    for (n, (words, from, to)) in steps.iter().enumerate() {
        let origin = Vec2::new(4.1 * n as f32, 0.0);
        sheet.axes(origin, Vec2::new(-1.7, -1.8), Vec2::new(1.9, 2.2), 1.4);
        draw_letter(&mut sheet, origin, from, "none", GREY);
        draw_letter(&mut sheet, origin, to, SKY, BLUE);
        let at = |m: &Mat4| place(m, point).map(|p| origin + p.truncate());
        if let (Some(before), Some(after)) = (at(from), at(to)) {
            sheet.dot(before, GREY);
            sheet.dot(after, ORANGE);
        }
        sheet.text(origin + Vec2::new(0.1, -2.3), words, BLACK);
    }
    sheet.finish()
}

fn rodrigues_parts() -> anyhow::Result<Drawing> {
    let see = seen_from(Vec3::new(0.0, 1.8, 2.6))?;
    let mut sheet = Sheet::new((-2.3, -0.2), (2.3, 2.95));
    let (axis, u, angle) = (Vec3::Y, Vec3::new(-0.75, 1.9, 1.3), 55_f32.to_radians());
    let along = axis * axis.dot(u);
    let across = u - along;
    let v = axis.cross(across);
    let turned = rodrigues(axis, angle) * u;
    sheet.polyline(ring(along, axis, across.length()).map(&see), FAINT, 2.0);
    for (end, ink) in [(u, GREY), (turned, GREY), (along + v, PURPLE)] {
        sheet.dashed(see(along), see(end), ink, 2.0);
    }
    sheet.line(see(Vec3::ZERO), see(along), GREEN, 3.0);
    sheet.arrow(see(along), see(axis * 3.4), BLACK);
    sheet.arrow(see(Vec3::ZERO), see(u), BLUE);
    sheet.arrow(see(Vec3::ZERO), see(turned), ORANGE);
    sheet.dot(see(along), GREEN);
    sheet.dot(see(along + v), PURPLE);
    sheet.text_right_of(see(axis * 3.25) + Vec2::new(0.1, 0.0), "Δ", BLACK);
    sheet.text_left_of(see(u * 0.6) + Vec2::new(-0.08, -0.04), "u", BLUE);
    sheet.text_right_of(see(turned * 0.6) + Vec2::new(0.1, -0.04), "u′", ORANGE);
    sheet.text_left_of(see(along) + Vec2::new(-0.1, 0.16), "u∥", GREEN);
    sheet.text_left_of(see(along + across * 0.6) + Vec2::new(-0.06, 0.08), "u⊥", GREY);
    sheet.text_right_of(see(along + v) + Vec2::new(0.1, -0.12), "v = Δ × u⊥", PURPLE);
    sheet.finish()
}

fn circle() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.9, -0.35), (1.9, 1.5));
    let angle = 55_f32.to_radians();
    sheet.arc(Vec2::ZERO, 1.2, 0.0, PI, FAINT);
    let (sin, cos) = (1.2 * angle.sin(), 1.2 * angle.cos());
    sheet.dashed((cos, 0.0), (cos, sin), GREY, 1.8);
    sheet.dashed((0.0, sin), (cos, sin), GREY, 1.8);
    sheet.arrow(Vec2::ZERO, (1.2, 0.0), BLACK);
    sheet.arrow(Vec2::ZERO, (0.0, 1.2), PURPLE);
    sheet.arrow(Vec2::ZERO, (cos, sin), ORANGE);
    sheet.arc(Vec2::ZERO, 0.35, 0.0, angle, BLACK);
    sheet.text((0.42, 0.22), "θ", BLACK);
    sheet.text_right_of((1.25, 0.0), "u⊥", BLACK);
    sheet.text((0.0, 1.34), "v", PURPLE);
    sheet.text_right_of((cos + 0.06, sin + 0.06), "u⊥ turned", ORANGE);
    sheet.text((cos / 2.0, -0.16), "cos θ · u⊥", GREY);
    sheet.text_left_of((-0.06, sin / 2.0), "sin θ · v", GREY);
    sheet.finish()
}

fn gimbal() -> anyhow::Result<Drawing> {
    let see = seen_from(Vec3::new(2.4, 1.3, 2.6))?;
    let mut sheet = Sheet::new((-2.3, -2.4), (6.7, 2.2));
    for (left, pitch) in [(0.0, 20.0), (4.4, 90.0)] {
        let origin = Vec2::new(left, 0.0);
        let (outer, middle) = (rotate_y(-20.0), rotate_y(-20.0) * rotate_x(pitch));
        for (axis, radius, ink, name) in [
            (Vec3::Y, 1.5, BLUE, "outer, y"),
            (outer * Vec3::X, 1.25, GREEN, "middle, x"),
            (middle * Vec3::Z, 1.0, ORANGE, "inner, z"),
        ] {
            sheet.polyline(ring(Vec3::ZERO, axis, radius).map(|point| origin + see(point)), ink, 3.0);
            let end = see(axis * (radius + 0.35));
            sheet.arrow(origin, origin + end, ink);
            // Beside the tip, away from the rings.
            let beside = origin + end + end.normalize_or_zero() * 0.24;
            match end.x {
                x if x > 0.3 => sheet.text_right_of(beside, name, ink),
                x if x < -0.3 => sheet.text_left_of(beside, name, ink),
                _ => sheet.text(beside, name, ink),
            }
        }
        sheet.text(origin + Vec2::new(0.0, -2.15), &format!("pitch {pitch}°"), BLACK);
    }
    sheet.finish()
}

fn long_way() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-2.6, -1.45), (2.6, 1.5));
    let (from, to) = (quaternion(Vec3::Z, 20_f32.to_radians()), quaternion(Vec3::Z, 120_f32.to_radians()));
    let direction = |q: Quat| (from_quaternion(q.normalize()) * Vec3::X).truncate();
    for (to, radius, ink) in [(to, 1.15, BLUE), (-to, 0.9, ORANGE)] {
        let steps: Vec<Vec2> = (0..=8)
            .map(|n| {
                // A step on the straight line between two quaternions, made 1 long: not quite even, but on the arc.
                let t = n as f32 / 8.0;
                direction(from * (1.0 - t) + to * t) * radius
            })
            .collect();
        steps.iter().for_each(|&step| sheet.line(Vec2::ZERO, step, FAINT, 1.4));
        steps.iter().for_each(|&step| sheet.dot(step, ink));
    }
    for (q, words) in [(from, "q"), (to, "p")] {
        sheet.arrow(Vec2::ZERO, direction(q) * 1.32, BLACK);
        sheet.text(direction(q) * 1.32 + Vec2::new(0.28 * direction(q).x.signum(), 0.08), words, BLACK);
    }
    sheet.text_right_of((0.75, 1.15), "q to p", BLUE);
    sheet.text_right_of((0.85, -0.75), "q to −p", ORANGE);
    sheet.finish()
}

fn normals() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-3.0, -0.25), (3.0, 1.95));
    let m = scale(Vec3::new(2.3, 1.0, 1.0));
    let right = normal_matrix(&m).context("the map flattens space")?;
    let on = |degrees: f32| Vec2::from_angle(degrees.to_radians()).extend(0.0);
    sheet.polyline((0..=180).map(|n| (m * on(n as f32).extend(1.0)).xy()), BLACK, 2.6);
    for degrees in [30.0, 60.0, 90.0, 120.0, 150.0] {
        let point = (m * on(degrees).extend(1.0)).xy();
        let wrong = (m * on(degrees).extend(0.0)).xy().normalize();
        let normal = (right * on(degrees)).truncate().normalize();
        sheet.arrow(point, point + wrong * 0.6, ORANGE);
        sheet.arrow(point, point + normal * 0.75, BLUE);
        sheet.dot(point, BLACK);
    }
    sheet.text((0.0, 0.5), "blue: inverse transpose", BLUE);
    sheet.text((0.0, 0.16), "orange: stretched as points are", ORANGE);
    sheet.finish()
}

fn stretched() -> anyhow::Result<Drawing> {
    let model = ball(48, 80)?;
    let m = Mat4::from_mat3(rotate_x(12.0)) * scale(Vec3::new(1.0, 0.3, 1.0));
    let right = normal_matrix(&m).context("the map flattens space")?;
    let draw = |by: Mat3| {
        let light = Vec3::new(0.35, 0.85, 0.4).normalize();
        let scene = Scene {
            model: &model,
            normals: &turned(&model, by),
            texture: &white(),
            wrap: Wrap::Clamp,
            light,
        };
        let all = viewport(500.0, 500.0, 0.45) * m;
        cut(&smooth(500, &scene, |point| place(&all, point)), [0, 110], [500, 280])
    };
    beside([&draw(Mat3::from_mat4(m)), &draw(right)])
}

fn similar() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-3.1, -0.75), (3.2, 2.3));
    let at = Vec2::new;
    let (d, p) = (2.6, at(-2.1, 1.9));
    let seen = place(&projection(d), Vec3::new(p.y, 0.0, p.x)).context("the point is behind the eye")?.x;
    sheet.polygon(&[at(d, 0.0), p, at(p.x, 0.0)], SKY, "none");
    sheet.polygon(&[at(d, 0.0), at(0.0, seen), at(0.0, 0.0)], AMBER, "none");
    sheet.line((-3.0, 0.0), (3.1, 0.0), GREY, 1.6);
    sheet.line((0.0, -0.35), (0.0, 2.1), BLACK, 2.4);
    sheet.line((d, 0.0), p, BLACK, 1.8);
    sheet.line((p.x, 0.0), p, BLUE, 3.0);
    sheet.line((0.0, 0.0), (0.0, seen), ORANGE, 4.0);
    sheet.dot(p, BLUE);
    sheet.dot((0.0, seen), ORANGE);
    sheet.dot((d, 0.0), BLACK);
    sheet.text(p + at(0.0, 0.22), "P", BLUE);
    sheet.text_left_of((p.x - 0.1, 0.95), "x", BLUE);
    sheet.text_right_of((0.1, 0.42), "x′", ORANGE);
    sheet.text((0.5, 1.95), "picture", BLACK);
    sheet.text((d, 0.27), "eye", BLACK);
    sheet.text((p.x, -0.25), "z", BLACK);
    sheet.text((0.22, -0.25), "0", BLACK);
    sheet.text((d, -0.25), "d", BLACK);
    sheet.text((1.3, -0.6), "d", ORANGE);
    sheet.line((0.0, -0.45), (d, -0.45), ORANGE, 1.6);
    sheet.text((-1.2, -0.6), "d − z", BLUE);
    sheet.line((p.x, -0.38), (d, -0.38), BLUE, 1.6);
    sheet.finish()
}

/// The model from some distances, always as large where z is 0.
fn distances(distances: &[f32]) -> anyhow::Result<Drawing> {
    let (model, texture) = (model()?, texture()?);
    let scene = Scene {
        model: &model,
        normals: &corner_normals(&model),
        texture: &texture,
        wrap: Wrap::Clamp,
        light: Vec3::Z,
    };
    let zoom = if distances.len() > 2 { 0.36 } else { 0.42 };
    all_beside(distances.iter().map(|&d| {
        let all = viewport(600.0, 600.0, zoom) * projection(d);
        Ok(smooth(600, &scene, |point| place(&all, point)))
    }))
}

fn behind() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-4.3, -2.7), (6.0, 3.0));
    let at = Vec2::new;
    let d = 2.0;
    let size = |z: f32| 0.5 / (projection(d) * Vec4::new(0.0, 0.0, z, 1.0)).w;
    sheet.axes(Vec2::ZERO, at(-4.2, -2.5), at(5.8, 2.8), 1.4);
    sheet.dashed((d, -2.6), (d, 2.8), GREY, 1.8);
    for (from, to, ink) in [(-4.2, d - 0.01, BLUE), (d + 0.01, 5.8, ORANGE)] {
        let points = (0..=100).map(|n| from + (to - from) * n as f32 / 100.0).map(|z| (z, size(z)));
        sheet.polyline(points.filter(|(_, size)| size.abs() < 2.7), ink, 2.8);
    }
    sheet.dot((0.0, size(0.0)), BLUE);
    sheet.text_right_of((0.12, 0.3), "1", BLUE);
    sheet.text_right_of((d + 0.15, 2.55), "z = d: the eye", BLACK);
    sheet.text((-2.4, 0.75), "1 / w: seen", BLUE);
    sheet.text_right_of((3.4, -1.35), "upside down:", ORANGE);
    sheet.text_right_of((3.4, -1.85), "behind the eye", ORANGE);
    sheet.text((5.7, 0.3), "z", GREY);
    sheet.finish()
}

/// Amber and blue.
pub(crate) const TILES: [Color; 2] = [Color::rgb(0xf2, 0xc1, 0x4e), Color::rgb(0x00, 0x72, 0xb2)];

/// A tiled floor at a height, from one z to another, white and grey by the texture of one texel a tile.
fn floor(height: f32, from: i32, to: i32) -> anyhow::Result<(Model, Image)> {
    let mut text = String::from("vt 0.25 0.5\nvt 0.75 0.5\nvn 0 1 0\n");
    let mut count = 0;
    for (x, z) in (from..to).flat_map(|z| (-5..5).map(move |x| (x, z))) {
        let tint = (x + z).rem_euclid(2) + 1;
        let [x, z] = [x, z].map(|n| n as f32 * 0.5);
        for (right, near) in [(0.0, 0.5), (0.5, 0.5), (0.5, 0.0), (0.0, 0.0)] {
            text += &format!("v {} {height} {}\n", x + right, z + near);
        }
        let corner = |k: i32| format!("{}/{tint}/1", count + k);
        text += &format!("f {} {} {} {}\n", corner(1), corner(2), corner(3), corner(4));
        count += 4;
    }
    Ok((parsed(&text)?, chequered(2, 1, TILES)))
}

fn ghost() -> anyhow::Result<Drawing> {
    let (model, tiles) = floor(-0.5, -16, 16)?;
    let all = viewport(500.0, 500.0, 0.4) * projection(2.0);
    let scene = Scene {
        model: &model,
        normals: &corner_normals(&model),
        texture: &tiles,
        wrap: Wrap::Clamp,
        light: Vec3::Y,
    };
    let right = smooth(500, &scene, |point| place(&all, point));
    // The fault: no look at the sign of w.
    let wrong = smooth(500, &scene, |point| {
        let p = all * point.extend(1.0);
        Some(p.xyz() / p.w)
    });
    beside([&right, &wrong])
}

/// The projection of a field of view from `left`, `right`, `bottom`, `top` at the distance `near` to the cube
/// [−1, 1]³, as the chapter derives it.
fn frustum([left, right]: [f32; 2], [bottom, top]: [f32; 2], near: f32, far: f32) -> Mat4 {
    Mat4::from_cols(
        Vec4::new(2.0 * near / (right - left), 0.0, 0.0, 0.0),
        Vec4::new(0.0, 2.0 * near / (top - bottom), 0.0, 0.0),
        Vec4::new(
            (right + left) / (right - left),
            (top + bottom) / (top - bottom),
            -(far + near) / (far - near),
            -1.0,
        ),
        Vec4::new(0.0, 0.0, -2.0 * far * near / (far - near), 0.0),
    )
}

fn frustum_to_cube() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-4.4, -2.1), (4.8, 2.1));
    let at = Vec2::new;
    let (near, far, half) = (1.0, 4.0, 0.45);
    let m = frustum([-half, half], [-half, half], near, far);
    // The eye is at the right and looks to the left, along −z.
    let eye = at(0.2, 0.0);
    let outside = |distance: f32, up: f32| eye + at(-distance, up * half * distance);
    sheet.dashed(eye, outside(near, 1.0), GREY, 1.6);
    sheet.dashed(eye, outside(near, -1.0), GREY, 1.6);
    sheet.polygon(
        &[outside(near, 1.0), outside(near, -1.0), outside(far, -1.0), outside(far, 1.0)],
        SKY,
        BLUE,
    );
    let cube = at(3.1, 0.0);
    sheet.rectangle(cube - 1.3, cube + 1.3, SKY, BLUE);
    for n in 0..=6 {
        let distance = near + (far - near) * n as f32 / 6.0;
        let z = place(&m, Vec3::new(0.0, 0.0, -distance)).context("behind the eye")?.z;
        sheet.line(outside(distance, 1.0), outside(distance, -1.0), BLUE, 1.8);
        sheet.line(cube + at(-z, 1.0) * 1.3, cube + at(-z, -1.0) * 1.3, BLUE, 1.8);
    }
    sheet.dot(eye, BLACK);
    sheet.text(eye + at(0.15, 0.3), "eye", BLACK);
    sheet.text(eye + at(-near, -0.8), "n", BLACK);
    sheet.text_left_of(outside(far, 0.0) - at(0.12, 0.0), "f", BLACK);
    sheet.text(cube + at(1.2, -1.6), "−1", BLACK);
    sheet.text(cube + at(-1.2, -1.6), "1", BLACK);
    sheet.text(cube + at(0.0, 1.6), "after division", BLACK);
    sheet.finish()
}

fn depth_row() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.5, -3.0), (10.9, 2.9));
    let at = Vec2::new;
    let far = 10.0;
    sheet.axes(Vec2::ZERO, at(-0.1, -2.2), at(10.6, 2.4), 1.4);
    sheet.dashed((0.0, 2.0), (10.3, 2.0), GREY, 1.4);
    sheet.dashed((0.0, -2.0), (10.3, -2.0), GREY, 1.4);
    for (near, ink, words, where_) in
        [(1.0, BLUE, "near plane at 1", at(3.4, 0.75)), (0.1, ORANGE, "at 0.1", at(1.5, 2.45))]
    {
        let m = frustum([-1.0, 1.0], [-1.0, 1.0], near, far);
        let points = (0..=200).map(|n| near + (far - near) * (n as f32 / 200.0).powi(2));
        let curve = points.filter_map(|distance| Some((distance, 2.0 * place(&m, Vec3::Z * -distance)?.z)));
        sheet.polyline(curve, ink, 2.8);
        sheet.text_right_of(where_, words, ink);
    }
    sheet.text_left_of((-0.2, 2.0), "1", BLACK);
    sheet.text_left_of((-0.2, -2.0), "−1", BLACK);
    for distance in [1, 5, 10] {
        sheet.line((distance as f32, -0.12), (distance as f32, 0.12), GREY, 1.6);
        sheet.text((distance as f32, -0.5), &distance.to_string(), BLACK);
    }
    sheet.text_left_of((10.8, -1.2), "distance from the eye", GREY);
    sheet.text_right_of((0.2, -2.65), "depth after division, from −1 to 1", GREY);
    sheet.finish()
}

fn to_pixels() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.5, -0.9), (14.4, 6.6));
    let letter_in_square = translate(Vec3::new(-0.35, -0.6, 0.0)) * scale(Vec3::splat(0.75));
    let (center, half) = (Vec2::new(2.2, 3.0), 2.0);
    sheet.rectangle(center - half, center + half, PALE, GREY);
    sheet.axes(center, Vec2::splat(-half), Vec2::splat(half), 1.4);
    draw_letter(&mut sheet, center, &(scale(Vec3::splat(half)) * letter_in_square), SKY, BLUE);
    sheet.text(center - half - Vec2::new(0.0, 0.5), "(−1, −1)", BLACK);
    sheet.text(center + half + Vec2::new(-0.3, 0.5), "(1, 1)", BLACK);
    sheet.arrow((4.6, 3.0), (5.7, 3.0), BLACK);
    let picture = Vec2::new(6.0, 0.0);
    sheet.grid((6, 0), (14, 6));
    draw_letter(&mut sheet, picture, &(viewport(8.0, 6.0, 0.5) * letter_in_square), SKY, BLUE);
    sheet.dot(picture, BLACK);
    sheet.dot(picture + Vec2::new(4.0, 3.0), ORANGE);
    sheet.text(picture + Vec2::new(0.2, -0.5), "(0, 0)", BLACK);
    sheet.text_right_of(picture + Vec2::new(5.1, 3.0), "(4, 3)", ORANGE);
    sheet.text_left_of(picture + Vec2::new(8.2, -0.5), "8 × 6 pixels", BLACK);
    sheet.finish()
}

fn drift() -> anyhow::Result<Drawing> {
    const TURNS: u32 = 10_000_000;
    // Of the angles by whole thousandths of a turn, one by which f32 shrinks much.
    let angle = TAU * 347.0 / 1000.0;
    // What would bring it back, without any error.
    let back = rodrigues_f64(DVec3::Y, -f64::from(angle) * f64::from(TURNS)).as_mat3();
    let (model, texture) = (model()?, texture()?);
    all_beside(["f32", "f32-renormalised", "f64"].map(|name| {
        let turn = Mat4::from_mat3(back * method(METHODS, name)?(Vec3::Y, angle, TURNS));
        let all = viewport(500.0, 500.0, 0.4) * projection(4.0) * turn;
        let normals = turned(&model, normal_matrix(&turn).context("the model is flat")?);
        let scene =
            Scene { model: &model, normals: &normals, texture: &texture, wrap: Wrap::Clamp, light: Vec3::Z };
        Ok(smooth(500, &scene, |point| place(&all, point)))
    }))
}
