//! Chapter 3: the pixels of a triangle, and how bright it is.

use std::collections::BTreeMap;

use anyhow::Context;
use common::{Bounds, Color, Format, IVec2, Image, Vec2, Vec3};
use lines::line;
use triangles::{METHODS, Triangle, draw_model, fill, flat_intensity};

use crate::figures::picture::{all_beside, beside, canvas, method, model};
use crate::figures::sheet::{AMBER, BLACK, BLUE, GREEN, GREY, MINT, ORANGE, PALE, PURPLE, ROSE, SKY, Sheet};
use crate::figures::{Drawing, Figure};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "triangles-three",
        "Three filled triangles on black: a red one on the left, a large thin white one, and a small green one.",
        three,
    ),
    Figure::new(
        "triangles-head",
        "The head twice: each of its triangles in a random colour, and in greys, as if lit from the front.",
        head,
    ),
    Figure::new(
        "triangles-half",
        "Three triangles, each filled up to the height of its middle corner. The side from the lowest to the middle \
         corner is white, from the middle to the highest green, from the lowest to the highest red.",
        half,
    ),
    Figure::new(
        "triangles-sweep",
        "A triangle filled with rows of pixels. The rows below its middle corner have one colour, those above \
         another; the row of the middle corner has a third.",
        sweep,
    ),
    Figure::new(
        "triangles-box",
        "A triangle in its bounding box on a grid. A dot marks the centre of each pixel of the box; pixels whose \
         centre is inside the triangle are filled.",
        bounding_box,
    ),
    Figure::new(
        "triangles-vector",
        "A triangle A, B, C with a point P in it. From A an arrow runs along AB, and from its end another one, \
         parallel to AC, to P.",
        vectors,
    ),
    Figure::new(
        "triangles-areas",
        "A point in a triangle, joined to the three corners. The three parts are labelled alpha, beta and gamma, \
         each opposite to its corner.",
        areas,
    ),
    Figure::new(
        "triangles-weights",
        "A triangle whose corners are red, green and blue; in between, the colours blend evenly.",
        weights,
    ),
    Figure::new(
        "triangles-sign",
        "Three lines through the sides of a triangle cut the plane into seven regions, each with three signs. \
         Only inside the triangle are all three positive.",
        signs,
    ),
    Figure::new(
        "triangles-steps",
        "A grid of pixels with a number in each. A step to the right takes 3 away, a step up adds 5. A line \
         separates the pixels with negative numbers from the others.",
        steps,
    ),
    Figure::new(
        "triangles-row",
        "A row of pixels across a triangle. Each of the three sides bounds the row from the left or from the \
         right; what is left is the interval that is drawn.",
        row,
    ),
    Figure::new(
        "triangles-snap",
        "A pixel with a fine grid in it. A corner of a triangle is moved to the nearest point of the grid.",
        snap,
    ),
    Figure::new(
        "triangles-top-left",
        "Two triangles that make a square, whose corners are pixel centres. Each pixel has the colour of the \
         triangle it belongs to: those on the diagonal belong to the lower one, the top row and the left column \
         to the square, the right column and the bottom row to neither.",
        top_left,
    ),
    Figure::new(
        "triangles-lambert",
        "Two beams of light of the same width. One falls straight onto a surface, the other at an angle, where \
         it is spread over a longer piece.",
        lambert,
    ),
    Figure::new(
        "triangles-shared",
        "A square cut into triangles, drawn by four methods. Outline: holes and doubled pixels; sweep and \
         barycentric: doubled pixels along all sides; edges: each pixel once.",
        shared,
    ),
    Figure::new(
        "triangles-fan",
        "A square cut into slivers around a point, drawn by three methods. With sweep most pixels are doubled \
         and many lie outside; with barycentric and with edges each is there once.",
        slivers,
    ),
    Figure::new(
        "triangles-far",
        "A mesh at a distance of ten million pixels. By barycentric weights it is full of doubled pixels and \
         has ragged borders, by edges each pixel is there once.",
        far,
    ),
];

/// The slides' three triangles.
const THREE: [([(f32, f32); 3], Color); 3] = [
    ([(10.0, 70.0), (50.0, 160.0), (70.0, 80.0)], Color::RED),
    ([(180.0, 50.0), (150.0, 1.0), (70.0, 180.0)], Color::WHITE),
    ([(180.0, 150.0), (120.0, 160.0), (130.0, 180.0)], Color::GREEN),
];

fn three() -> anyhow::Result<Drawing> {
    let mut image = canvas(200);
    for (corners, color) in THREE {
        (method(METHODS, "edges")?.draw)(corners.map(Vec2::from), &mut image, color);
    }
    Ok(Drawing::Pixels(image, 3))
}

/// The same up to their middle corners, with each side in the colour of its place.
fn half() -> anyhow::Result<Drawing> {
    let mut image = canvas(200);
    for (corners, _) in THREE {
        let mut sorted = corners.map(Vec2::from);
        sorted.sort_by(|a, b| a.y.total_cmp(&b.y));
        let [low, middle, high] = sorted;
        (method(METHODS, "sweep")?.visit)(sorted, image.bounds(), &mut |x, y, _| {
            if y < middle.y as i32 {
                image.set(x, y, Color::rgb(70, 110, 150));
            }
        });
        for (from, to, color) in
            [(low, high, Color::RED), (low, middle, Color::WHITE), (middle, high, Color::GREEN)]
        {
            line(from.as_ivec2(), to.as_ivec2(), &mut image, color);
        }
    }
    Ok(Drawing::Pixels(image, 3))
}

fn head() -> anyhow::Result<Drawing> {
    let (model, method) = (model()?, method(METHODS, "edges")?);
    let [mut random, mut flat] = [(); 2].map(|()| canvas(600));
    draw_model(&model, method, &mut random, |n, _| Some(Color::random(n as u64)));
    draw_model(&model, method, &mut flat, |_, corners| {
        let intensity = flat_intensity(corners, Vec3::Z);
        (intensity >= 0.0).then(|| Color::gray(intensity))
    });
    beside([&random, &flat])
}

/// How often a method visits each pixel.
fn visits(method: &Triangle, corners: [Vec2; 3]) -> BTreeMap<(i32, i32), usize> {
    let mut visits = BTreeMap::new();
    let bounds = Bounds { min: IVec2::splat(-50), max: IVec2::splat(50) };
    (method.visit)(corners, bounds, &mut |x, y, _| *visits.entry((x, y)).or_insert(0) += 1);
    visits
}

fn sweep() -> anyhow::Result<Drawing> {
    let corners = [(1.0, 1.0), (15.0, 5.0), (5.0, 10.0)].map(Vec2::from);
    let mut sheet = Sheet::new(Vec2::ZERO, (17.0, 12.0));
    sheet.grid((0, 0), (17, 12));
    for (&(x, y), &times) in &visits(method(METHODS, "sweep")?, corners) {
        sheet.pixel(
            x,
            y,
            if times > 1 {
                ROSE
            } else if y < 5 {
                SKY
            } else {
                AMBER
            },
        );
    }
    let [a, b, c] = corners.map(|corner| corner + 0.5);
    sheet.polygon(&[a, b, c], "none", BLACK);
    sheet.dashed((0.2, 5.5), (16.8, 5.5), PURPLE, 2.0);
    sheet.text(a - Vec2::new(0.5, 0.55), "low", BLACK);
    sheet.text(b + Vec2::new(0.2, -0.9), "middle", BLACK);
    sheet.text(c + Vec2::new(0.0, 0.75), "high", BLACK);
    sheet.finish()
}

const REAL: [(f32, f32); 3] = [(1.6, 1.2), (12.4, 4.7), (5.1, 9.3)];

fn bounding_box() -> anyhow::Result<Drawing> {
    let corners = REAL.map(Vec2::from);
    let mut sheet = Sheet::new(Vec2::ZERO, (14.0, 11.0));
    sheet.grid((0, 0), (14, 11));
    let inside = visits(method(METHODS, "barycentric")?, corners);
    sheet.pixels(inside.keys().copied(), SKY);
    sheet.polygon(&corners, "none", BLACK);
    sheet.rectangle((1.0, 1.0), (13.0, 10.0), "none", PURPLE);
    for (x, y) in (1..10).flat_map(|y| (1..13).map(move |x| (x, y))) {
        let center = IVec2::new(x, y).as_vec2() + 0.5;
        sheet.dot(center, if inside.contains_key(&(x, y)) { GREEN } else { GREY });
    }
    sheet.finish()
}

const ABC: [Vec2; 3] = [Vec2::new(0.0, 0.0), Vec2::new(6.0, 0.6), Vec2::new(2.0, 3.8)];
const P: Vec2 = Vec2::new(2.5, 1.5);

/// A triangle with the names of its corners.
fn named(fill: &'static str) -> Sheet {
    let mut sheet = Sheet::new((-0.7, -0.6), (6.7, 4.2));
    sheet.polygon(&ABC, fill, BLACK);
    sheet.text(ABC[0] - Vec2::new(0.35, 0.1), "A", BLACK);
    sheet.text(ABC[1] + Vec2::new(0.35, -0.1), "B", BLACK);
    sheet.text(ABC[2] + Vec2::new(-0.3, 0.15), "C", BLACK);
    sheet
}

fn vectors() -> anyhow::Result<Drawing> {
    let [a, b, c] = ABC;
    let mut sheet = named(PALE);
    let weights = triangles::barycentric::weights(ABC, P).context("the triangle has an area")?;
    let along = a + weights.y * (b - a);
    let up = a + weights.z * (c - a);
    sheet.dashed(up, P, GREY, 1.5);
    sheet.arrow(a, b, GREY);
    sheet.arrow(a, c, GREY);
    sheet.arrow(a, along, BLUE);
    sheet.arrow(along, P, GREEN);
    sheet.dot(P, ORANGE);
    sheet.text(P + Vec2::new(0.3, 0.15), "P", ORANGE);
    sheet.text((a + along) / 2.0 - Vec2::new(-0.1, 0.35), &format!("u = {:.2}", weights.y), BLUE);
    sheet.text_right_of((along + P) / 2.0 + Vec2::new(0.15, -0.05), &format!("v = {:.2}", weights.z), GREEN);
    sheet.finish()
}

fn areas() -> anyhow::Result<Drawing> {
    let [a, b, c] = ABC;
    let mut sheet = named("none");
    let weights = triangles::barycentric::weights(ABC, P).context("the triangle has an area")?;
    let parts = [
        ([P, b, c], SKY, "α", weights.x),
        ([P, c, a], AMBER, "β", weights.y),
        ([P, a, b], MINT, "γ", weights.z),
    ];
    for (part, fill, name, weight) in parts {
        sheet.polygon(&part, fill, BLACK);
        let middle = (part[0] + part[1] + part[2]) / 3.0;
        sheet.text(middle, &format!("{name} = {weight:.2}"), BLACK);
    }
    sheet.dot(P, ORANGE);
    sheet.text(P - Vec2::new(0.0, 0.3), "P", ORANGE);
    sheet.finish()
}

fn weights() -> anyhow::Result<Drawing> {
    let mut image = Image::new(160, 120, Format::Rgb);
    let corners = [(8.0, 12.0), (150.0, 30.0), (62.0, 112.0)].map(Vec2::from);
    fill(corners, image.bounds(), |x, y, weights| {
        let [r, g, b] = weights.to_array().map(|weight| (weight * 255.0).round() as u8);
        image.set(x, y, Color::rgb(r, g, b));
    });
    Ok(Drawing::Pixels(image, 4))
}

fn signs() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let corners = [at(-1.6, -1.0), at(1.9, -0.6), at(-0.2, 1.7)];
    let mut sheet = Sheet::new((-4.4, -2.4), (4.4, 3.0));
    sheet.polygon(&corners, SKY, "none");
    for n in 0..3 {
        let (from, to) = (corners[n], corners[(n + 1) % 3]);
        let along = (to - from).normalize();
        sheet.dashed(from - along * 1.35, to + along * 1.35, GREY, 1.5);
        sheet.arrow(from, to, [BLUE, ORANGE, GREEN][n]);
    }
    let edge = |n: usize, p: Vec2| (corners[(n + 1) % 3] - corners[n]).perp_dot(p - corners[n]);
    let places = [
        at(0.0, 0.0),
        at(0.2, -1.75),
        at(2.3, 1.3),
        at(-2.2, 1.0),
        at(-3.2, -1.75),
        at(3.3, -1.2),
        at(-0.35, 2.6),
    ];
    for place in places {
        let signs: Vec<&str> = (0..3).map(|n| if edge(n, place) > 0.0 { "+" } else { "−" }).collect();
        sheet.text(place, &signs.join(" "), if signs.contains(&"−") { ORANGE } else { BLACK });
    }
    for (corner, name, away) in
        [(0, "A", at(-0.12, -0.32)), (1, "B", at(0.3, -0.22)), (2, "C", at(-0.35, 0.12))]
    {
        sheet.dot(corners[corner], BLACK);
        sheet.text(corners[corner] + away, name, BLACK);
    }
    sheet.finish()
}

fn steps() -> anyhow::Result<Drawing> {
    let [a, b] = [IVec2::new(1, 0), IVec2::new(6, 3)];
    let mut sheet = Sheet::new(Vec2::ZERO, (8.0, 5.0));
    sheet.grid((0, 0), (8, 5));
    let value = |x: i32, y: i32| (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    let all = || (0..5).flat_map(|y| (0..8).map(move |x| (x, y)));
    sheet.pixels(all().filter(|&(x, y)| value(x, y) >= 0), SKY);
    let [from, to] = [a, b].map(|end| end.as_vec2() + 0.5);
    let along = (to - from) / 5.0;
    sheet.dashed(from - along, to + along * 1.4, GREY, 1.5);
    sheet.arrow(from, to, BLACK);
    for (x, y) in all() {
        let words = value(x, y).to_string().replace('-', "−");
        sheet.text((x as f32 + 0.5, y as f32 + 0.5), &words, if value(x, y) < 0 { ORANGE } else { BLACK });
    }
    sheet.finish()
}

fn row() -> anyhow::Result<Drawing> {
    let corners = [(1.4, 0.6), (13.3, 2.8), (4.2, 8.2)].map(Vec2::from);
    let mut sheet = Sheet::new((0.0, -0.2), (15.0, 9.0));
    sheet.grid((0, 0), (15, 9));
    let y = 4;
    let inside: Vec<i32> = visits(method(METHODS, "edges")?, corners)
        .into_keys()
        .filter(|pixel| pixel.1 == y)
        .map(|pixel| pixel.0)
        .collect();
    sheet.pixels(inside.iter().map(|&x| (x, y)), SKY);
    sheet.polygon(&corners, "none", BLACK);
    let level = y as f32 + 0.5;
    sheet.dashed((0.0, level), (15.0, level), GREY, 1.5);
    (0..15).for_each(|x| {
        sheet.dot((x as f32 + 0.5, level), if inside.contains(&x) { GREEN } else { GREY });
    });
    let [a, b, c] = corners;
    for (from, to, ink) in [(c, a, BLUE), (b, c, ORANGE)] {
        let t = (level - from.y) / (to.y - from.y);
        let x = from.x + t * (to.x - from.x);
        let side = if ink == BLUE { 1.0 } else { -1.0 };
        sheet.line((x, level - 0.9), (x, level + 0.9), ink, 3.0);
        sheet.arrow((x, level - 0.75), (x + 1.3 * side, level - 0.75), ink);
    }
    sheet.text((1.6, 5.7), "E ≥ 0", BLUE);
    sheet.text((11.4, 5.8), "E ≥ 0", ORANGE);
    sheet.text((10.4, 0.85), "the third side bounds this row too,", GREY);
    sheet.text((10.4, 0.25), "but farther right", GREY);
    sheet.finish()
}

fn snap() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-4.6, -0.6), (12.6, 8.6));
    sheet.grid((0, 0), (8, 8));
    sheet.rectangle((0.0, 0.0), (8.0, 8.0), "none", BLACK);
    let corner = Vec2::new(2.6, 5.35);
    let snapped = corner.round();
    for (at, ink) in [(corner, GREY), (snapped, BLUE)] {
        sheet.line(at, at + Vec2::new(9.0, -2.4), ink, 2.0);
        sheet.line(at, at + Vec2::new(1.0, -5.6), ink, 2.0);
    }
    sheet.dot(corner, GREY);
    sheet.dot(snapped, BLUE);
    sheet.dot(Vec2::splat(4.0), ORANGE);
    sheet.text_right_of((4.3, 3.1), "the centre", ORANGE);
    sheet.text((2.3, 6.2), "a corner", GREY);
    sheet.text((5.2, 7.1), "where it is moved", BLUE);
    sheet.finish()
}

fn top_left() -> anyhow::Result<Drawing> {
    let [a, b, c, d] = [(1.5, 1.5), (7.5, 1.5), (7.5, 7.5), (1.5, 7.5)].map(Vec2::from);
    let mut sheet = Sheet::new((-1.5, 0.0), (10.5, 9.0));
    sheet.grid((0, 0), (9, 9));
    for (corners, color) in [([a, b, c], SKY), ([a, c, d], AMBER)] {
        sheet.pixels(visits(method(METHODS, "edges")?, corners).into_keys(), color);
        sheet.polygon(&corners, "none", BLACK);
    }
    for (x, y) in (1..8).flat_map(|y| (1..8).map(move |x| (x, y))) {
        if x == 1 || x == 7 || y == 1 || y == 7 || x == y {
            sheet.dot(IVec2::new(x, y).as_vec2() + 0.5, BLACK);
        }
    }
    sheet.text((4.5, 8.4), "top: inside", GREEN);
    sheet.text((0.2, 4.5), "left:", GREEN);
    sheet.text((0.2, 3.9), "inside", GREEN);
    sheet.text((4.5, 0.6), "bottom: outside", ORANGE);
    sheet.text((9.0, 4.5), "right:", ORANGE);
    sheet.text((9.0, 3.9), "outside", ORANGE);
    sheet.finish()
}

fn lambert() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.3, -0.9), (9.3, 4.6));
    for (middle, angle) in [(2.0, 0.0), (6.6, 0.85)] {
        let along = Vec2::from_angle(angle);
        let foot = Vec2::new(middle, 1.2);
        let half = 0.8 / along.x;
        let [left, right] = [foot - along * half, foot + along * half];
        let top = 4.2;
        sheet.polygon(&[left, right, right.with_y(top), left.with_y(top)], PALE, "none");
        sheet.line(foot - along * 1.8, foot + along * 1.8, BLACK, 2.5);
        sheet.line(left, right, AMBER, 6.0);
        for side in [left, right] {
            sheet.dashed(side.with_y(top), side, GREY, 1.5);
        }
        sheet.arrow(foot, foot + Vec2::Y * 1.9, AMBER);
        if angle > 0.0 {
            sheet.text_right_of(foot + Vec2::new(0.15, 1.8), "l", BLACK);
            sheet.arrow(foot, foot + along.perp() * 1.9, BLUE);
            sheet.text(foot + along.perp() * 2.1, "n", BLUE);
            sheet.arc(foot, 0.9, std::f32::consts::FRAC_PI_2, std::f32::consts::FRAC_PI_2 + angle, ORANGE);
            sheet.text(foot + 1.2 * Vec2::from_angle(std::f32::consts::FRAC_PI_2 + angle / 2.0), "θ", ORANGE);
        } else {
            sheet.text(foot + Vec2::new(0.0, 2.2), "l = n", BLACK);
        }
    }
    sheet.text((2.0, -0.3), "width d", BLACK);
    sheet.text((6.6, -0.6), "width d / cos θ", BLACK);
    sheet.finish()
}

/// A square of 24×24 px, cut into squares of 4 px and those along their diagonal.
fn grid() -> Vec<[Vec2; 3]> {
    let corner = |i: i32, j: i32| IVec2::new(i, j).as_vec2() * 4.0;
    let cells = (0..6).flat_map(|j| (0..6).map(move |i| (i, j)));
    cells
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect()
}

/// A square of 24×24 px, cut into slivers around a point.
fn fan() -> Vec<[Vec2; 3]> {
    let rim = |n: i32| {
        let along = (n % 24) as f32;
        Vec2::from(
            [(along, 0.0), (24.0, along), (24.0 - along, 24.0), (0.0, 24.0 - along)][(n / 24 % 4) as usize],
        )
    };
    (0..96).map(|n| [Vec2::new(7.25, 8.5), rim(n), rim(n + 1)]).collect()
}

/// What a method makes of a mesh of a square of 24×24 px that is moved by `shift`. Blue: drawn once. Amber: more
/// often. Red: a hole. Purple: beside the square.
fn counted(name: &str, mesh: &[[Vec2; 3]], shift: f32) -> anyhow::Result<Image> {
    const SIDE: u16 = 28;
    let start = IVec2::splat(shift as i32 - 2);
    let window = Bounds { min: start, max: start + (i32::from(SIDE) - 1) };
    let count = |method: &Triangle, triangles: &[[Vec2; 3]]| {
        let mut visits = BTreeMap::new();
        for corners in triangles {
            let moved = corners.map(|corner| corner + shift);
            (method.visit)(moved, window, &mut |x, y, _| *visits.entry((x, y)).or_insert(0) += 1);
        }
        visits
    };
    let [a, b, c, d] = [(0.0, 0.0), (24.0, 0.0), (24.0, 24.0), (0.0, 24.0)].map(Vec2::from);
    let expected = count(method(METHODS, "edges")?, &[[a, b, c], [a, c, d]]);
    let got = count(method(METHODS, name)?, mesh);
    let mut image = canvas(SIDE);
    for (x, y) in expected.keys().chain(got.keys()).copied() {
        let color = match (expected.contains_key(&(x, y)), got.get(&(x, y)).copied().unwrap_or(0)) {
            (true, 0) => Color::rgb(213, 94, 0),
            (true, 1) => Color::rgb(86, 160, 211),
            (true, _) => Color::rgb(242, 193, 78),
            (false, _) => Color::rgb(168, 72, 127),
        };
        image.set(x - start.x, y - start.y, color);
    }
    Ok(image)
}

fn shared() -> anyhow::Result<Drawing> {
    all_beside(METHODS.iter().map(|method| counted(method.name, &grid(), 0.5)))
}

fn slivers() -> anyhow::Result<Drawing> {
    all_beside(["sweep", "barycentric", "edges"].map(|name| counted(name, &fan(), 0.0)))
}

fn far() -> anyhow::Result<Drawing> {
    all_beside(["barycentric", "edges"].map(|name| counted(name, &grid(), 1e7)))
}
