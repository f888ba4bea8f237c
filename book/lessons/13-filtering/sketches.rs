//! Chapter 13's line drawings.

use std::f32::consts::{PI, TAU};

use anyhow::Context;
use common::{Color, Vec2, Vec3};
use filtering::filter::MOST_PROBES;
use filtering::footprint::{Axes, Gradients};
use filtering::light::SRGB;
use filtering::{Footprint, LAYOUTS};
use perspective::{perspective, view};

use crate::figures::Drawing;
use crate::figures::sheet::{
    AMBER, BLACK, BLUE, FAINT, GREEN, GREY, Ink, MINT, ORANGE, PALE, ROSE, SKY, Sheet,
};

pub(super) fn footprints() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    const SIZE: [i32; 2] = [24, 18];
    let size = at(SIZE[0] as f32, SIZE[1] as f32);
    // A level eye one above the floor; texture coordinates are x and the depth.
    let eye = Vec3::Y;
    let look = view(eye, eye - Vec3::Z, Vec3::Y).context("it looks somewhere")?;
    let to_clip = perspective(45.0, size.x / size.y, 0.1, 100.0)? * look;
    let corners = [at(-90.0, 0.5), at(90.0, 0.5), at(0.0, 90.0)];
    let clip = corners.map(|uv| to_clip * Vec3::new(uv.x, 0.0, -uv.y).extend(1.0));
    let gradients = Gradients::new(clip, corners, size);
    let half = (45.0_f32.to_radians() / 2.0).tan();
    let seen = |x: i32, y: i32| {
        let center = (at(x as f32, y as f32) + 0.5) / size * 2.0 - 1.0;
        let depth = -1.0 / (center.y * half);
        at(center.x * half * size.x / size.y * depth, depth)
    };
    // In the picture on the left, of a place on the floor.
    let (scale, left, right) = (0.4, at(0.0, 1.5), at(13.2, -1.6));
    // Of the picture only what is below the horizon, and a little more.
    let (wide, high) = (size.x * scale, 10.6 * scale);
    let shown = |uv: Vec2| {
        let clip = to_clip * Vec3::new(uv.x, 0.0, -uv.y).extend(1.0);
        left + (at(clip.x, clip.y) / clip.w + 1.0) / 2.0 * size * scale
    };
    let mut sheet = Sheet::new((-0.1, -0.75), (16.4, 9.4));
    sheet.rectangle(left, left + at(wide, high), PALE, GREY);
    let horizon = left + at(0.0, size.y / 2.0 * scale);
    sheet.line(horizon, horizon + at(wide, 0.0), GREY, 1.4);
    // Level lines of the floor, and lines that lead away; all within the picture.
    for depth in [2.5_f32, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0, 24.0] {
        let y = shown(at(0.0, depth)).y;
        sheet.line((left.x, y), (left.x + wide, y), FAINT, 1.2);
    }
    for u in -5..=5 {
        let far = shown(at(u as f32, 400.0));
        let nearest = (1..400)
            .map(|n| at(u as f32, 2.42 + 0.05 * n as f32))
            .find(|uv| (left.x..=left.x + wide).contains(&shown(*uv).x));
        if let Some(near) = nearest {
            sheet.line(shown(near), far, FAINT, 1.2);
        }
    }
    for u in -2..=3 {
        let x = right.x + u as f32;
        sheet.line((x, right.y + 2.0), (x, right.y + 10.8), FAINT, 1.2);
    }
    for v in 2..=10 {
        let y = right.y + v as f32;
        sheet.line((right.x - 2.0, y), (right.x + 3.0, y), FAINT, 1.2);
    }
    let fills: [(Ink, Ink); 3] = [(SKY, BLUE), (AMBER, ORANGE), (MINT, GREEN)];
    let pixels = [(4, 0), (12, 0), (19, 1), (7, 3), (15, 4), (10, 5), (16, 6)];
    for (n, (x, y)) in pixels.into_iter().enumerate() {
        let (fill, ink) = fills[n % 3];
        let corner = left + at(x as f32, y as f32) * scale;
        sheet.rectangle(corner, corner + scale, fill, ink);
        let uv = seen(x, y);
        let Footprint { x: a, y: b } = gradients.footprint(x, y, uv);
        sheet.polygon(&[-a - b, a - b, a + b, b - a].map(|p| right + uv + p / 2.0), fill, ink);
    }
    sheet.text(left + at(wide / 2.0, -0.6), "picture", GREY);
    sheet.text(right + at(0.5, 1.2), "floor, from above", GREY);
    sheet.finish()
}

/// A wave of so many periods a pixel.
fn wave(periods: f32) -> impl Fn(f32) -> f32 {
    move |x| (TAU * periods * x).cos()
}

/// A curve over an interval, as points.
fn curve(from: f32, to: f32, f: impl Fn(f32) -> f32) -> impl Iterator<Item = Vec2> {
    (0..=400).map(move |n| from + (to - from) * n as f32 / 400.0).map(move |x| Vec2::new(x, f(x)))
}

pub(super) fn samples() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.35, -2.05), (10.4, 1.75));
    let up = 1.2;
    sheet.line((0.0, 0.0), (10.2, 0.0), FAINT, 1.6);
    for n in 0..=10 {
        sheet.line((n as f32, -1.2), (n as f32, 1.2), FAINT, 1.2);
        sheet.text((n as f32, -1.5), &n.to_string(), GREY);
    }
    for (periods, ink, width) in [(0.9, BLUE, 2.0), (0.1, ORANGE, 3.0)] {
        sheet.polyline(curve(0.0, 10.0, wave(periods)).map(|p| p * Vec2::new(1.0, up)), ink, width);
    }
    for n in 0..=10 {
        sheet.dot((n as f32, up * wave(0.9)(n as f32)), BLACK);
    }
    sheet.text((5.0, -1.9), "pixels", GREY);
    sheet.text((2.6, 1.55), "the texture", BLUE);
    sheet.text((7.4, 1.55), "what is seen", ORANGE);
    sheet.finish()
}

pub(super) fn folded() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.55, -0.42), (3.2, 0.86));
    let seen = |f: f32| (f - f.round()).abs();
    sheet.rectangle((0.0, 0.0), (0.5, 0.55), PALE, "none");
    sheet.axes((0.0, 0.0), (0.0, 0.0), (3.1, 0.68), 1.5);
    sheet.dashed((0.0, 0.5), (3.05, 0.5), FAINT, 1.6);
    sheet.polyline((0..=6).map(|n| n as f32 / 2.0).map(|f| (f, seen(f))), BLUE, 3.2);
    for (f, name) in [(0.5, "½"), (1.0, "1"), (1.5, "1½"), (2.0, "2"), (2.5, "2½"), (3.0, "3")] {
        sheet.line((f, -0.03), (f, 0.03), GREY, 1.6);
        sheet.text((f, -0.13), name, BLACK);
    }
    sheet.dashed((0.9, 0.0), (0.9, seen(0.9)), ORANGE, 1.8);
    sheet.dashed((0.0, seen(0.9)), (0.9, seen(0.9)), ORANGE, 1.8);
    sheet.dot((0.9, seen(0.9)), ORANGE);
    sheet.text_left_of((-0.05, 0.5), "½", BLACK);
    sheet.text_left_of((-0.05, 0.0), "0", BLACK);
    sheet.text_right_of((0.06, 0.76), "periods a pixel that are seen", GREY);
    sheet.text((1.5, -0.3), "periods a pixel", GREY);
    sheet.finish()
}

/// What is left of a wave of so many periods a pixel after the mean over a pixel.
pub(super) fn of_box(periods: f32) -> f32 {
    let x = PI * periods;
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

pub(super) fn kernels() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-1.75, -4.75), (4.55, 1.75));
    // The weights.
    for (middle, ink, fill, corners, name) in [
        (at(-0.2, 0.0), BLUE, SKY, vec![at(-0.5, 0.0), at(-0.5, 1.0), at(0.5, 1.0), at(0.5, 0.0)], "box"),
        (at(3.0, 0.0), ORANGE, AMBER, vec![at(-1.0, 0.0), at(0.0, 1.0), at(1.0, 0.0)], "tent"),
    ] {
        let corners: Vec<Vec2> = corners.into_iter().map(|p| p + middle).collect();
        sheet.polygon(&corners, fill, ink);
        sheet.line(middle - at(1.4, 0.0), middle + at(1.4, 0.0), GREY, 1.5);
        for (x, name) in [(-1.0, "−1"), (0.0, "0"), (1.0, "1")] {
            sheet.line(middle + at(x, -0.05), middle + at(x, 0.05), GREY, 1.5);
            sheet.text(middle + at(x, -0.28), name, BLACK);
        }
        sheet.text(middle + at(0.0, 1.35), name, ink);
    }
    // What they leave of a wave.
    let origin = at(-1.2, -3.35);
    let (wide, high) = (1.75, 2.1);
    let place = |p: Vec2| origin + p * at(wide, high);
    sheet.polygon(&[at(0.0, -0.24), at(0.5, -0.24), at(0.5, 1.0), at(0.0, 1.0)].map(place), PALE, "none");
    sheet.axes(origin, (0.0, -0.5), (5.5, 2.3), 1.5);
    sheet.polyline(curve(0.0, 3.05, of_box).map(place), BLUE, 2.8);
    sheet.polyline(curve(0.0, 3.05, |f| of_box(f).powi(2)).map(place), ORANGE, 2.8);
    sheet.dashed(place(at(0.5, -0.24)), place(at(0.5, 1.08)), GREY, 1.6);
    for (f, name) in [(0.5, "½"), (1.0, "1"), (2.0, "2"), (3.0, "3")] {
        sheet.text(place(at(f, -0.33)), name, BLACK);
    }
    sheet.text_left_of(place(at(-0.06, 1.0)), "1", BLACK);
    sheet.text_left_of(place(at(-0.06, 0.0)), "0", BLACK);
    sheet.text_right_of(place(at(0.72, 0.78)), "what is left of a wave", GREY);
    sheet.text(place(at(1.5, -0.58)), "periods a pixel", GREY);
    sheet.finish()
}

pub(super) fn centres() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-1.9, -0.35), (5.2, 3.35));
    let fills = [[SKY, AMBER, PALE], [MINT, ROSE, PALE], [PALE, PALE, PALE]];
    for (j, row) in fills.iter().enumerate() {
        for (i, fill) in row.iter().enumerate() {
            let low = at(i as f32, j as f32);
            sheet.rectangle(low, low + 1.0, fill, FAINT);
        }
    }
    // The share of the way from the centre of texel (0, 0): to the right and up.
    let (t, s) = (0.7, 0.4);
    let place = at(0.5 + t, 0.5 + s);
    let (low, high) = (place - 0.5, place + 0.5);
    for (from, to, fill) in [
        (low, at(1.0, 1.0), SKY),
        (at(1.0, low.y), at(high.x, 1.0), AMBER),
        (at(low.x, 1.0), at(1.0, high.y), MINT),
        (at(1.0, 1.0), high, ROSE),
    ] {
        sheet.rectangle(from, to, fill, BLACK);
    }
    for j in 0..3 {
        for i in 0..3 {
            sheet.dot(at(i as f32 + 0.5, j as f32 + 0.5), GREY);
        }
    }
    sheet.dot(place, ORANGE);
    for (corner, words) in [
        (at(3.25, 0.15), "(1−t)(1−s)"),
        (at(3.25, 0.75), "t (1−s)"),
        (at(3.25, 1.35), "(1−t) s"),
        (at(3.25, 1.95), "t s"),
    ]
    .into_iter()
    .zip([SKY, AMBER, MINT, ROSE])
    .map(|((corner, words), fill)| ((corner, fill), words))
    {
        let (corner, fill) = corner;
        sheet.rectangle(corner, corner + 0.35, fill, BLACK);
        sheet.text_right_of(corner + at(0.5, 0.17), words, BLACK);
    }
    sheet.text_left_of((-0.15, 0.5), "row j", GREY);
    sheet.text_left_of((-0.15, 1.5), "row j + 1", GREY);
    sheet.text((0.5, -0.22), "i", GREY);
    sheet.text((1.5, -0.22), "i + 1", GREY);
    sheet.finish()
}

pub(super) fn odd() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-0.3, -1.0), (10.3, 3.7));
    // In halves of an old texel, as k = 2.
    for i in 0..5 {
        let fill = [SKY, SKY, PALE, AMBER, AMBER][i];
        let low = at(2.0 * i as f32, 2.0);
        sheet.rectangle(low, low + at(2.0, 1.0), fill, BLACK);
        sheet.text(low + at(1.0, 1.35), &i.to_string(), GREY);
    }
    sheet.dashed((5.0, 2.0), (5.0, 3.0), GREY, 1.6);
    for (j, (fill, weights)) in [(SKY, [2, 2, 1]), (AMBER, [1, 2, 2])].into_iter().enumerate() {
        let low = at(5.0 * j as f32, 0.0);
        sheet.rectangle(low, low + at(5.0, 1.0), fill, BLACK);
        let mut from = low.x;
        for (n, weight) in weights.into_iter().enumerate() {
            let middle = from + weight as f32 / 2.0;
            let to = at(low.x + [0.9, 2.5, 4.1][n], 1.0);
            sheet.arrow((middle, 1.93), to + at(0.0, 0.07), GREY);
            sheet.text(low + at([0.9, 2.5, 4.1][n], 0.5), &format!("{weight}/5"), BLACK);
            from += weight as f32;
        }
        sheet.text(low + at(2.5, -0.42), &j.to_string(), GREY);
    }
    sheet.finish()
}

pub(super) fn parallelogram() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-4.9, -2.7), (5.6, 2.7));
    // Left the pixel, right its footprint on a grid of texels.
    let (pixel, middle) = (at(-3.7, 0.0), at(2.2, 0.0));
    let (a, b) = (at(3.4, 1.5), at(0.9, 2.3));
    let grid: Vec<i32> = (0..=6).collect();
    for &n in &grid {
        let x = -0.8 + n as f32;
        sheet.line((x, -2.5), (x, 2.5), FAINT, 1.0);
    }
    for n in 0..=5 {
        let y = -2.5 + n as f32;
        sheet.line((-0.8, y), (5.2, y), FAINT, 1.0);
    }
    sheet.rectangle(pixel - 0.8, pixel + 0.8, SKY, BLUE);
    sheet.polygon(&[-a - b, a - b, a + b, b - a].map(|p| middle + p / 2.0), SKY, BLUE);
    let circle = |n: i32| Vec2::from_angle(TAU * n as f32 / 120.0) / 2.0;
    sheet.polyline((0..=120).map(circle).map(|p| pixel + 1.6 * p), ORANGE, 2.6);
    sheet.polyline((0..=120).map(circle).map(|p| middle + p.x * a + p.y * b), ORANGE, 2.6);
    sheet.arrow(pixel, pixel + at(1.6, 0.0), BLACK);
    sheet.arrow(pixel, pixel + at(0.0, 1.6), BLACK);
    sheet.arrow(middle, middle + a, BLACK);
    sheet.arrow(middle, middle + b, BLACK);
    sheet.text(pixel + at(1.35, -0.3), "1", BLACK);
    sheet.text(pixel + at(-0.3, 1.4), "1", BLACK);
    sheet.text(middle + a + at(-0.15, -0.4), "a", BLACK);
    sheet.text(middle + b + at(0.35, 0.05), "b", BLACK);
    sheet.text(pixel + at(0.0, -1.35), "picture", GREY);
    sheet.text_left_of((-0.95, -2.3), "texture", GREY);
    sheet.finish()
}

pub(super) fn of_curve() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-0.3, -0.2), (1.5, 1.13));
    let light = |code: u8| SRGB.light(Color::rgb(code, code, code)).x / 255.0;
    let place = |code: u8| at(f32::from(code) / 255.0, light(code));
    sheet.axes((0.0, 0.0), (0.0, 0.0), (1.06, 1.06), 1.5);
    for (code, ink) in [(128, ORANGE), (188, BLUE)] {
        let p = place(code);
        sheet.dashed((p.x, 0.0), p, ink, 1.8);
        sheet.dashed((0.0, p.y), p, ink, 1.8);
    }
    sheet.polyline((0..=255).map(place), BLACK, 2.8);
    for (code, ink) in [(0, BLACK), (128, ORANGE), (188, BLUE), (255, BLACK)] {
        sheet.dot(place(code), ink);
        sheet.text((place(code).x, -0.07), &code.to_string(), ink);
    }
    sheet.text_left_of((-0.03, light(128)), "22 %", ORANGE);
    sheet.text_left_of((-0.03, light(188)), "50 %", BLUE);
    sheet.text_left_of((-0.03, 1.0), "light", GREY);
    sheet.text((1.32, -0.07), "code", GREY);
    sheet.text_right_of((0.78, 0.5), "mean of the light", BLUE);
    sheet.text_right_of((0.78, 0.2), "mean of the codes", ORANGE);
    sheet.finish()
}

pub(super) fn probes() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-6.4, -4.9), (6.4, 4.9));
    for n in -6..=6 {
        sheet.line((n as f32, -4.8), (n as f32, 4.8), FAINT, 1.0);
    }
    for n in -4..=4 {
        sheet.line((-6.3, n as f32), (6.3, n as f32), FAINT, 1.0);
    }
    let footprint = Footprint { x: at(1.1, -0.55), y: at(7.0, 4.1) };
    let Footprint { x: a, y: b } = footprint;
    let Axes { direction, major, minor } = footprint.axes();
    let side = major.max(a.length()).max(b.length()) / 2.0;
    let square = |middle: Vec2, half: f32| {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| middle + at(x, y) * half)
    };
    sheet.polygon(&square(Vec2::ZERO, side), PALE, GREY);
    sheet.polygon(&[-a - b, a - b, a + b, b - a].map(|p| p / 2.0), SKY, BLUE);
    // As many as the filter takes, where it takes them.
    let width = minor.max(major / f32::from(MOST_PROBES));
    let count = (major / width.max(1.0)).round() as i32;
    for n in 0..count {
        let middle = direction * major * ((n as f32 + 0.5) / count as f32 - 0.5);
        sheet.polygon(&square(middle, width / 2.0), "none", ORANGE);
        sheet.dot(middle, ORANGE);
    }
    sheet.text_left_of((side - 0.15, -side + 0.4), "trilinear", GREY);
    sheet.text_left_of((6.2, 4.45), &format!("{count} probes"), ORANGE);
    sheet.finish()
}

pub(super) fn layouts() -> anyhow::Result<Drawing> {
    const SIDE: u32 = 8;
    let mut sheet = Sheet::new((-0.2, -1.4), (28.2, 8.2));
    for (layout, left) in LAYOUTS.iter().zip((0..).step_by(10)) {
        let mut order: Vec<(usize, u32, u32)> = (0..SIDE)
            .flat_map(|y| (0..SIDE).map(move |x| (x, y)))
            .map(|(x, y)| ((layout.run.place)([SIDE; 2], [x, y]), x, y))
            .collect();
        order.sort_unstable();
        for &(place, x, y) in &order {
            sheet.pixel(left + x as i32, y as i32, LINES[place / 16 % 4]);
        }
        let centre = |&(_, x, y): &(usize, u32, u32)| Vec2::new(left as f32 + x as f32 + 0.5, y as f32 + 0.5);
        sheet.polyline(order.iter().map(centre), BLACK, 1.8);
        sheet.dot(centre(&order[0]), ORANGE);
        sheet.text((left as f32 + 4.0, -0.9), layout.name, BLACK);
    }
    sheet.finish()
}

pub(super) fn walk() -> anyhow::Result<Drawing> {
    const WIDTH: u32 = 32;
    const HEIGHT: u32 = 20;
    let at = Vec2::new;
    let mut sheet = Sheet::new((-0.2, -25.8), (32.2, 20.4));
    let step = Vec2::from_angle(36.0_f32.to_radians());
    let points: Vec<Vec2> = (0..31).map(|n| at(1.5, 1.5) + step * n as f32).collect();
    // By rows and by tiles.
    for (layout, bottom) in LAYOUTS.iter().zip([0, -23]) {
        let line = |x: u32, y: u32| (layout.run.place)([WIDTH, HEIGHT], [x, y]) / 16;
        let mut touched: Vec<usize> = points.iter().map(|p| line(p.x as u32, p.y as u32)).collect();
        touched.sort_unstable();
        touched.dedup();
        for (x, y) in (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))) {
            if let Ok(n) = touched.binary_search(&line(x, y)) {
                sheet.pixel(x as i32, bottom + y as i32, [SKY, AMBER][n % 2]);
            }
        }
        sheet.grid((0, bottom), (WIDTH as i32, bottom + HEIGHT as i32));
        for p in &points {
            sheet.dot(*p + at(0.0, bottom as f32), BLACK);
        }
        let words = format!("{}: {} lines for {} texels", layout.name, touched.len(), points.len());
        sheet.text((16.0, bottom as f32 - 1.2), &words, BLACK);
    }
    sheet.finish()
}

/// The fills of four lines of memory.
const LINES: [Ink; 4] = [SKY, AMBER, MINT, ROSE];
