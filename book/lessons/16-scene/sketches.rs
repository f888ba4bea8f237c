//! Chapter 16's line drawings.

use std::f32::consts::{FRAC_PI_2, TAU};

use common::{Mat4, Vec2, Vec3};
use scene::frustum::{Sphere, pixels_per_unit, sees};
use scene::levels::{Sizes, error};
use scene::{Levels, METHODS, Paint, orbit, sphere};

use super::figures::sizes;
use crate::figures::Drawing;
use crate::figures::sheet::{
    AMBER, BLACK, BLUE, FAINT, GREEN, GREY, Ink, MINT, ORANGE, PALE, PURPLE, ROSE, SKY, Sheet,
};

pub(super) fn parts() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((0.0, 0.4), (48.0, 28.6));
    let at = |x: f32, y: f32| Vec2::new(x, y);
    sheet.rectangle((1.0, 6.4), (27.0, 28.0), PALE, BLACK);
    sheet.text_right_of((2.0, 26.4), "scene", BLACK);
    let entities = ["entity: here, turned", "entity: there, small", "entity: far, of glass"];
    let meshes = [(at(40.0, 22.4), "mesh: cube", AMBER), (at(40.0, 13.6), "mesh: sphere", MINT)];
    for (n, words) in entities.iter().enumerate() {
        let middle = at(14.0, 23.0 - 4.4 * n as f32);
        sheet.labelled(middle, (11.0, 1.7), SKY, words);
        let mesh = meshes[usize::from(n == 2)].0;
        sheet.arrow(middle + at(11.0, 0.0), mesh - at(6.6, 0.0) + at(0.0, 0.5 - n as f32 * 0.5), GREY);
    }
    for (middle, words, ink) in meshes {
        sheet.labelled(middle, (6.6, 1.9), ink, words);
    }
    sheet.labelled((8.4, 9.2), (5.4, 1.7), ROSE, "light");
    sheet.labelled((19.6, 9.2), (5.4, 1.7), ROSE, "light");
    sheet.labelled((14.0, 2.6), (11.0, 1.7), "none", "camera");
    sheet.arrow((14.0, 4.3), (14.0, 6.3), GREY);
    sheet.text_right_of((26.4, 2.6), "looks at it from outside", GREY);
    sheet.finish()
}

/// Three axes and two things before the eye; `towards` is 1 where z points away from it, and −1 where it points to it.
fn space(sheet: &mut Sheet, middle: Vec2, name: &str, towards: f32) {
    // What is far is drawn higher and more to the right.
    let away = Vec2::new(0.55, 0.4);
    let at = |x: f32, y: f32, depth: f32| middle + Vec2::new(x, y) + depth * away;
    sheet.line(at(0.0, 0.0, 0.0), at(0.0, 0.0, 11.0), FAINT, 1.4);
    for (x, depth, ink) in [(1.9, 10.5, MINT), (2.4, 6.0, AMBER)] {
        sheet.dashed(at(0.0, 0.0, depth), at(x, 0.0, depth), GREY, 1.2);
        let sides = if ink == MINT { 48 } else { 4 };
        let corner = |n: i32| {
            let angle = (n as f32 + 0.5) * TAU / sides as f32;
            at(x, 0.0, depth) + if sides == 4 { 1.4 } else { 1.05 } * Vec2::from_angle(angle)
        };
        sheet.polygon(&(0..sides).map(corner).collect::<Vec<Vec2>>(), ink, BLACK);
        let sign = if towards > 0.0 { "" } else { "−" };
        sheet.text_right_of(at(x + 1.3, 0.0, depth), &format!("z = {sign}{}", depth / 3.0), BLACK);
    }
    sheet.arrow(at(0.0, 0.0, 0.0), at(3.2, 0.0, 0.0), BLACK);
    sheet.arrow(at(0.0, 0.0, 0.0), at(0.0, 3.6, 0.0), BLACK);
    sheet.arrow(at(0.0, 0.0, 0.0), at(0.0, 0.0, 4.2 * towards), ORANGE);
    sheet.text(at(3.8, 0.0, 0.0), "x", BLACK);
    sheet.text(at(0.0, 4.3, 0.0), "y", BLACK);
    let tip = if towards > 0.0 { at(-0.1, 0.8, 3.6) } else { at(-0.2, 0.7, -4.0) };
    sheet.text(tip, "z", ORANGE);
    sheet.dot(at(0.0, 0.0, 0.0), BLACK);
    sheet.text(middle + Vec2::new(4.4, -2.4), name, GREY);
}

pub(super) fn handed() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.6, -3.3), (28.6, 6.2));
    space(&mut sheet, Vec2::new(0.0, 0.0), "left-handed", 1.0);
    space(&mut sheet, Vec2::new(15.6, 0.0), "right-handed", -1.0);
    sheet.finish()
}

/// Where a point is on a sheet that shows it from aside and above, as a camera far away sees it.
fn seen(point: Vec3, azimuth: f32, elevation: f32) -> Vec2 {
    (orbit(azimuth, elevation, 0.0).transpose() * point.extend(1.0)).truncate().truncate()
}

pub(super) fn around() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-5.2, -2.1), (6.4, 4.6));
    let at = |point: Vec3| seen(point, 24.0, 22.0);
    let (azimuth, elevation, distance) = (62.0_f32, 38.0, 4.6);
    let eye = |azimuth: f32, elevation: f32| orbit(azimuth, elevation, distance).w_axis.truncate();
    let circle = (0..=96).map(|n| at(eye(n as f32 * 3.75, 0.0)));
    sheet.polyline(circle, FAINT, 1.6);
    let arc = (0..=24).map(|n| at(eye(azimuth, n as f32 * 3.75)));
    sheet.polyline(arc, FAINT, 1.6);
    for (axis, name) in [(Vec3::X, "x"), (Vec3::Y, "y"), (Vec3::Z, "z")] {
        sheet.arrow(at(Vec3::ZERO), at(axis * 2.2), GREY);
        sheet.text(at(axis * 2.55), name, GREY);
    }
    let part = |angle: f32, high: f32, r: f32| at(orbit(angle, high, r).w_axis.truncate());
    sheet.dashed(at(Vec3::ZERO), at(eye(azimuth, 0.0)), GREY, 1.4);
    sheet.polyline((0..=30).map(|n| part(azimuth * n as f32 / 30.0, 0.0, 1.7)), ORANGE, 2.6);
    sheet.polyline((0..=30).map(|n| part(azimuth, elevation * n as f32 / 30.0, 2.6)), PURPLE, 2.6);
    sheet.line(at(Vec3::ZERO), at(eye(azimuth, elevation)), BLUE, 2.2);
    sheet.text(part(azimuth * 0.5, -9.0, 2.1), "φ", ORANGE);
    sheet.text(part(azimuth + 3.0, elevation * 0.5, 3.1), "ε", PURPLE);
    sheet.text(part(azimuth, elevation, 2.3) + Vec2::new(-0.25, 0.3), "r", BLUE);
    let place = at(eye(azimuth, elevation));
    sheet.dot(place, BLUE);
    sheet.text_right_of(place + Vec2::new(0.25, -0.4), "camera", BLUE);
    // Its own axes.
    let camera = orbit(azimuth, elevation, distance);
    for (axis, ink, name) in [(camera.x_axis, GREEN, "right"), (camera.y_axis, GREEN, "up")] {
        let tip = eye(azimuth, elevation) + axis.truncate() * 1.1;
        sheet.arrow(place, at(tip), ink);
        let beyond = at(tip) + (at(tip) - place).normalize_or_zero() * 0.3;
        if name == "up" { sheet.text(beyond, name, ink) } else { sheet.text_right_of(beyond, name, ink) }
    }
    sheet.finish()
}

/// The lines of a sphere's triangles on a sheet, each once.
fn sides(triangles: &[[u32; 3]]) -> std::collections::BTreeSet<[u32; 2]> {
    let of = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]);
    triangles.iter().flat_map(of).collect()
}

pub(super) fn rows() -> anyhow::Result<Drawing> {
    const SIZE: [usize; 2] = [6, 12];
    let mut sheet = Sheet::new((-11.8, -6.0), (19.2, 6.2));
    let shape = sphere(SIZE[0], SIZE[1]);
    let round = |n: u32| seen(shape.vertices[n as usize].position, 15.0, 20.0) * 4.6 + Vec2::new(-6.6, 0.0);
    let front = |triangle: &&[u32; 3]| {
        let [a, b, c] = triangle.map(round);
        (b - a).perp_dot(c - a) > 0.0
    };
    let front: Vec<[u32; 3]> = shape.triangles.iter().filter(front).copied().collect();
    for triangle in &front {
        sheet.polygon(&triangle.map(round), PALE, "none");
    }
    for [a, b] in sides(&front) {
        sheet.line(round(a), round(b), GREY, 1.2);
    }
    let flat = |n: u32| shape.vertices[n as usize].uv * Vec2::new(19.0, 9.2) + Vec2::new(-0.4, -4.6);
    sheet.rectangle((-0.4, -4.6), (18.6, 4.6), PALE, "none");
    for [a, b] in sides(&shape.triangles) {
        sheet.line(flat(a), flat(b), GREY, 1.2);
    }
    for (n, vertex) in shape.vertices.iter().enumerate() {
        let is_pole = vertex.uv.y == 0.0 || vertex.uv.y == 1.0;
        let is_seam = vertex.uv.x == 0.0 || vertex.uv.x == 1.0;
        let ink = if is_pole { PURPLE } else { ORANGE };
        if is_pole || is_seam {
            sheet.dot(flat(n as u32), ink);
            let on_front = front.iter().flatten().any(|&other| other == n as u32);
            if on_front {
                sheet.dot(round(n as u32), ink);
            }
        }
    }
    sheet.text_right_of((-2.0, -5.6), "column 0", ORANGE);
    sheet.text_left_of((19.2, -5.6), "column 12", ORANGE);
    sheet.text((9.1, 5.7), "north pole, 12 times", PURPLE);
    sheet.text((9.1, -5.6), "south pole", PURPLE);
    sheet.finish()
}

pub(super) fn chord() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-6.6, 3.5), (19.6, 11.1));
    const RADIUS: f32 = 10.0;
    let half = 36.0_f32.to_radians();
    for (middle, chords) in [(0.0, 1_usize), (13.0, 2)] {
        let on = |angle: f32| Vec2::new(middle, 0.0) + RADIUS * Vec2::from_angle(FRAC_PI_2 - angle);
        let corner = |n: usize| on(-half + 2.0 * half * n as f32 / chords as f32);
        for n in 0..chords {
            let (a, b) = (corner(n), corner(n + 1));
            let inside = (a + b) / 2.0;
            let outside = Vec2::new(middle, 0.0) + (inside - Vec2::new(middle, 0.0)).normalize() * RADIUS;
            sheet.line(a, b, BLUE, 2.6);
            sheet.line(inside, outside, ORANGE, 3.2);
        }
        sheet.polyline((0..=60).map(|n| on(-half + 2.0 * half * n as f32 / 60.0)), BLACK, 2.0);
        (0..=chords).for_each(|n| sheet.dot(corner(n), BLUE));
        let foot = Vec2::new(middle, 4.2);
        for end in [corner(0), corner(chords)] {
            sheet.dashed(foot + (end - foot) * 0.06, end, FAINT, 1.4);
        }
    }
    sheet.text((0.0, 7.3), "1 − cos δ/2", ORANGE);
    sheet.text((13.0, 7.3), "a quarter of it", ORANGE);
    sheet.text((0.0, 4.3), "angle δ", GREY);
    sheet.text((13.0, 4.3), "twice δ/2", GREY);
    sheet.finish()
}

/// The picture in which [`levels`] measures.
const PICTURE: Vec2 = Vec2::new(1024.0, 768.0);

/// How far a sphere of radius 1 is from round in the picture, in pixels, at that distance: by a row of the table.
pub(super) fn off(levels: &Levels, sizes: Sizes, distance: f32) -> anyhow::Result<f32> {
    let projection = perspective::perspective(45.0, PICTURE.x / PICTURE.y, 0.1, 1000.0)?;
    let to_clip = projection * Mat4::from_translation(Vec3::NEG_Z * distance);
    let bounds = Sphere { center: Vec3::ZERO, radius: 1.0 };
    let chosen = levels.choose(pixels_per_unit(&to_clip, &bounds, PICTURE)).triangles();
    let [latitudes, longitudes] =
        sizes.iter().copied().find(|[m, n]| 2 * n * (m - 1) == chosen).unwrap_or(sizes[sizes.len() - 1]);
    // Of what is seen of a sphere, the outline's radius.
    let radius = PICTURE.y / 2.0 / 22.5_f32.to_radians().tan() / (distance * distance - 1.0).sqrt();
    Ok(error(latitudes, longitudes) as f32 * radius)
}

pub(super) fn levels() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-2.6, -2.3), (21.8, 13.0));
    // Distances up to 100, errors from 0.01 to 100 pixels.
    const NEAREST: f32 = 1.3;
    let across = |distance: f32| (distance / NEAREST).log10() * 20.0 / (100.0 / NEAREST).log10();
    let up = |pixels: f32| (pixels.log10() + 2.0) * 3.0;
    let at = |distance: f32, pixels: f32| Vec2::new(across(distance), up(pixels));
    for pixels in [0.01, 0.1, 1.0, 10.0, 100.0] {
        sheet.line(at(NEAREST, pixels), at(100.0, pixels), FAINT, 1.0);
        sheet.text_left_of(at(NEAREST, pixels) - Vec2::new(0.3, 0.0), &pixels.to_string(), BLACK);
    }
    for distance in [2.0, 5.0, 10.0, 20.0, 50.0, 100.0] {
        sheet.line(at(distance, 0.01), at(distance, 100.0), FAINT, 1.0);
        sheet.text(at(distance, 0.01) - Vec2::new(0.0, 0.7), &distance.to_string(), BLACK);
    }
    sheet.dashed(at(NEAREST, 0.5), at(100.0, 0.5), BLACK, 1.8);
    let inks: [(Ink, f32); 4] = [(PURPLE, 2.0), (GREEN, 2.0), (ORANGE, 2.0), (BLUE, 3.0)];
    for (row, (ink, width)) in METHODS.iter().zip(inks) {
        let levels = scene::levels::spheres(row.run, &Paint::Color(common::Color::WHITE));
        let mut points = Vec::new();
        for n in 0..=1200 {
            let distance = NEAREST * (100.0 / NEAREST).powf(n as f32 / 1200.0);
            points.push(at(distance, off(&levels, sizes(row.name)?, distance)?.clamp(0.01, 100.0)));
        }
        // Where it leaves the sheet it lies along the border.
        points.retain(|point| point.y > up(0.01) && point.y < up(100.0));
        sheet.polyline(points, ink, width);
    }
    sheet.text(at(3.2, 30.0), "8x16", PURPLE);
    sheet.text(at(2.3, 2.4), "32x64", GREEN);
    sheet.text(at(2.6, 0.027), "128x256", ORANGE);
    sheet.text(at(33.0, 0.125), "by-size", BLUE);
    sheet.text_left_of(at(96.0, 0.72), "½ px", BLACK);
    sheet.text_right_of(at(NEAREST, 100.0) + Vec2::new(0.0, 0.55), "pixels", GREY);
    sheet.text(Vec2::new(10.0, -1.9), "distance", GREY);
    sheet.finish()
}

/// The balls of [`frustum`]: where they are from above, and how large.
const BALLS: [(f32, f32, f32); 12] = [
    (0.4, -2.6, 0.5),
    (-1.3, -4.4, 0.7),
    (2.2, -5.8, 0.9),
    (-3.0, -7.3, 0.8),
    (0.2, -6.6, 0.45),
    (3.4, -3.2, 0.7),
    (-4.0, -4.5, 0.6),
    (5.9, -6.2, 0.5),
    (-1.9, 0.2, 0.8),
    (0.9, -9.4, 0.7),
    (3.3, 0.4, 0.6),
    (5.92, -8.75, 1.0),
];

pub(super) fn frustum() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-7.2, -1.8), (7.8, 10.6));
    let (near, far) = (1.0, 8.0);
    let to_clip = perspective::perspective(60.0, 1.0, near, far)?;
    let slope = 30.0_f32.to_radians().tan();
    // From above, −z up.
    let at = |x: f32, z: f32| Vec2::new(x, -z);
    let corner = |side: f32, depth: f32| at(side * slope * depth, -depth);
    let seen = [corner(-1.0, near), corner(1.0, near), corner(1.0, far), corner(-1.0, far)];
    sheet.polygon(&seen, PALE, BLACK);
    for side in [-1.0, 1.0] {
        sheet.dashed(at(0.0, 0.0), corner(side, near), GREY, 1.4);
        sheet.dashed(corner(side, far), corner(side, 10.3), GREY, 1.4);
    }
    for (x, z, radius) in BALLS {
        let ball = Sphere { center: Vec3::new(x, 0.0, z), radius };
        let kept = sees(&to_clip, &ball);
        let (fill, ink) = match kept {
            true if touches(x, z, radius, slope, near, far) => (SKY, BLUE),
            true => (AMBER, ORANGE),
            false => ("none", GREY),
        };
        let rim: Vec<Vec2> =
            (0..72).map(|n| at(x, z) + radius * Vec2::from_angle(n as f32 * TAU / 72.0)).collect();
        sheet.polygon(&rim, fill, ink);
    }
    sheet.dot(at(0.0, 0.0), BLACK);
    sheet.text_right_of(at(0.35, 0.05), "eye", BLACK);
    sheet.text_left_of(at(-0.8, -1.0), "near", GREY);
    sheet.text_left_of(at(-4.75, -8.0), "far", GREY);
    sheet.finish()
}

/// Whether some of a disc is in the frustum, from above.
fn touches(x: f32, z: f32, radius: f32, slope: f32, near: f32, far: f32) -> bool {
    let inside = |x: f32, z: f32| -z >= near && -z <= far && x.abs() <= slope * -z;
    let ring = |part: f32| {
        (0..720).map(move |n| Vec2::new(x, z) + part * radius * Vec2::from_angle(n as f32 * TAU / 720.0))
    };
    (0..=20).flat_map(|n| ring(n as f32 / 20.0)).any(|point| inside(point.x, point.y))
}

pub(super) fn held() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-1.7, -2.3), (24.4, 10.8));
    let inks: [(f32, Ink); 3] = [(10.0, ORANGE), (20.0, GREEN), (40.0, BLUE)];
    for (left, words) in [(0.0, "by pictures"), (13.0, "by time")] {
        let at = |seconds: f32, distance: f32| Vec2::new(left + 10.0 * seconds, 9.0 * distance);
        sheet.axes((left, 0.0), (0.0, 0.0), (10.6, 9.8), 1.6);
        sheet.text(at(0.5, -0.19), words, BLACK);
        sheet.text(at(1.0, -0.09), "1 s", GREY);
        sheet.text_left_of(at(-0.03, 1.0), "r", GREY);
        for (rate, ink) in inks {
            let pictures = rate as usize;
            // A step of 1/45 of the way in each picture, or what is left after the time that has gone by.
            let place = |n: usize| match left {
                0.0 => 1.0 - n as f32 / 45.0,
                _ => (-(n as f32) / rate).exp(),
            };
            let stairs = (0..pictures)
                .flat_map(|n| [at(n as f32 / rate, place(n)), at((n + 1) as f32 / rate, place(n))]);
            sheet.polyline(stairs.chain([at(1.0, place(pictures))]), ink, 2.2);
            sheet.dot(at(1.0, place(pictures)), ink);
        }
    }
    for (n, (rate, ink)) in inks.iter().enumerate() {
        sheet.text_right_of((18.4, 9.6 - 1.2 * n as f32), &format!("{rate} a second"), ink);
    }
    sheet.finish()
}
