//! Chapter 2: a model's edges.

use std::collections::BTreeMap;
use std::f32::consts::FRAC_PI_3;

use anyhow::{Context, anyhow};
use common::{Color, Model, Vec2, Vec3};
use lines::line;
use wireframe::{three_per_triangle, to_pixel, wireframe};

use crate::figures::picture::{all_beside, beside, canvas, model};
use crate::figures::sheet::{AMBER, BLACK, BLUE, FAINT, GREEN, GREY, ORANGE, PAPER, SKY, Sheet};
use crate::figures::{Drawing, Figure};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "wireframe-head",
        "A human head on black, drawn as a net of white lines. Front and back are seen at once.",
        head,
    ),
    Figure::new(
        "wireframe-sharing",
        "Five numbered points and three triangles between them. Neighbouring triangles share two points.",
        sharing,
    ),
    Figure::new(
        "wireframe-flat",
        "A box seen from the side. Parallel lines along the z axis carry its corners onto an upright plane.",
        flat,
    ),
    Figure::new(
        "wireframe-map",
        "An axis from minus one to one above a row of eight squares numbered 0 to 7. Zero falls on the border of \
         squares 3 and 4; one falls on the right border, where a ninth square would begin.",
        map,
    ),
    Figure::new(
        "wireframe-border",
        "Two pictures of a square with a diamond in it. In the left one the square's top and right side are \
         missing.",
        border,
    ),
    Figure::new(
        "wireframe-counts",
        "Six triangles around a point. The six inner edges are marked with a two, those of the rim with a one.",
        counts,
    ),
    Figure::new(
        "wireframe-fan",
        "A convex polygon of six corners and one with a notch, both cut into triangles by lines from their first \
         corner. In the second, a line leaves the polygon.",
        fans,
    ),
    Figure::new(
        "wireframe-cube",
        "A cube of twelve edges, and the two solid cubes that it may show: one seen from above, one from below.",
        cube,
    ),
    Figure::new(
        "wireframe-saturated",
        "Two pictures of the same spokes. On the left they point from the middle in all directions; on the right \
         there is one diagonal line.",
        saturated,
    ),
];

/// The lesson's picture, by the lesson's own function.
fn head() -> anyhow::Result<Drawing> {
    let mut image = canvas(720);
    wireframe(&model()?, &mut image, Color::WHITE);
    Ok(Drawing::Pixels(image, 1))
}

fn sharing() -> anyhow::Result<Drawing> {
    let points = [(0.0, 0.0), (3.0, 0.4), (1.4, 2.4), (4.6, 2.6), (6.4, 0.7)].map(|(x, y)| Vec2::new(x, y));
    let triangles = [([0, 1, 2], SKY), ([1, 3, 2], AMBER), ([1, 4, 3], SKY)];
    let mut sheet = Sheet::new((-0.7, -0.5), (7.1, 3.1));
    for (n, (corners, fill)) in triangles.into_iter().enumerate() {
        let [a, b, c] = corners.map(|i| points[i]);
        sheet.polygon(&[a, b, c], fill, BLACK);
        let face = format!("f {}", corners.map(|i| (i + 1).to_string()).join(" "));
        sheet.text((a + b + c) / 3.0 - Vec2::new(0.0, if n == 1 { -0.1 } else { 0.05 }), &face, BLACK);
    }
    let beside = [(-0.3, -0.1), (0.15, -0.35), (-0.3, 0.2), (0.2, 0.3), (0.35, 0.0)];
    for (n, (&point, (x, y))) in points.iter().zip(beside).enumerate() {
        sheet.dot(point, ORANGE);
        sheet.text(point + Vec2::new(x, y), &(n + 1).to_string(), ORANGE);
    }
    sheet.finish()
}

fn flat() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-2.6, -1.7), (3.4, 1.75));
    let plane = 1.6;
    let corners = [(-1.7, -0.5), (-0.3, -1.0), (0.4, 0.45), (-1.0, 0.95)].map(|(z, y)| Vec2::new(z, y));
    sheet.polygon(&corners, SKY, BLACK);
    for corner in corners {
        sheet.dashed(corner, corner.with_x(plane), GREY, 1.5);
        sheet.dot(corner, BLACK);
        sheet.dot(corner.with_x(plane), BLUE);
    }
    sheet.line((plane, -1.2), (plane, 1.2), BLUE, 3.0);
    sheet.text((plane, 1.45), "the picture", BLUE);
    sheet.arrow((-2.4, -1.45), (-1.5, -1.45), GREEN);
    sheet.text_right_of((-1.4, -1.45), "z", GREEN);
    sheet.arrow((-2.4, -1.45), (-2.4, -0.55), GREEN);
    sheet.text((-2.4, -0.35), "y", GREEN);
    sheet.arrow((3.2, 0.0), (2.1, 0.0), ORANGE);
    sheet.text((2.65, 0.22), "you look", ORANGE);
    sheet.text((2.65, -0.22), "along −z", ORANGE);
    sheet.finish()
}

fn map() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.7, -0.9), (9.2, 3.0));
    for column in 0..9 {
        let x = f32::from(column as u8);
        if column < 8 {
            sheet.pixel(column, 0, SKY);
        } else {
            sheet.rectangle((8.0, 0.0), (9.0, 1.0), "none", FAINT);
        }
        sheet.text((x + 0.5, 0.5), &column.to_string(), if column < 8 { BLACK } else { ORANGE });
    }
    sheet.line((0.0, 2.2), (8.0, 2.2), BLACK, 2.0);
    for (x, name) in [(-1.0, "−1"), (-0.5, "−½"), (0.0, "0"), (0.5, "½"), (1.0, "1")] {
        let column = (x + 1.0) * 8.0 / 2.0;
        let ink = if x < 1.0 { GREY } else { ORANGE };
        sheet.dashed((column, 2.2), (column, 0.0), ink, 1.5);
        sheet.dot((column, 2.2), if x < 1.0 { BLACK } else { ORANGE });
        sheet.text((column, 2.65), name, if x < 1.0 { BLACK } else { ORANGE });
    }
    sheet.text((4.0, -0.5), "column = ⌊(x + 1) · 8 / 2⌋", BLACK);
    sheet.text((-0.45, 2.2), "x", BLACK);
    sheet.finish()
}

/// A square that fills the model's space, and in it one that stands on a corner.
fn squares() -> anyhow::Result<Model> {
    let corner = |(x, y): (f32, f32)| Vec3::new(x, y, 0.0);
    let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let inner = [(-0.6, 0.0), (0.0, -0.6), (0.6, 0.0), (0.0, 0.6)];
    let corners = square.into_iter().chain(inner).map(corner).collect();
    Model::from_triangles(corners, vec![[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]]).map_err(|e| anyhow!(e))
}

/// Left without the rule for the border, right with it.
fn border() -> anyhow::Result<Drawing> {
    // White ones would be lost against a white page, where they run along the picture's border.
    const SIDES: Color = Color::rgb(255, 170, 40);
    let model = squares()?;
    let mut printed = canvas(30);
    let mut mended = printed.clone();
    let pixel = |point: Vec3| ((point.truncate() + 1.0) * 30.0 / 2.0).floor().as_ivec2();
    three_per_triangle(&model, |edge| {
        let [a, b] = edge.map(|i| pixel(model.positions()[i as usize]));
        line(a, b, &mut printed, SIDES);
    });
    wireframe(&model, &mut mended, SIDES);
    beside([&printed, &mended])
}

fn counts() -> anyhow::Result<Drawing> {
    let rim = (0..6).map(|n| (Vec2::from_angle(n as f32 * FRAC_PI_3) * Vec2::new(2.4, 1.5)).extend(0.0));
    let corners: Vec<Vec3> = std::iter::once(Vec3::ZERO).chain(rim).collect();
    let triangles = (0..6).map(|n| [0, n + 1, (n + 1) % 6 + 1]).collect();
    let model = Model::from_triangles(corners, triangles).map_err(|e| anyhow!(e))?;
    let mut times = BTreeMap::new();
    three_per_triangle(&model, |[a, b]| *times.entry([a.min(b), a.max(b)]).or_insert(0) += 1);
    let mut sheet = Sheet::new((-3.0, -1.6), (3.0, 1.6));
    let place = |i: u32| model.positions()[i as usize].truncate();
    for (edge, times) in &times {
        let [a, b] = edge.map(place);
        sheet.line(a, b, if *times == 1 { BLUE } else { ORANGE }, 2.0 * *times as f32);
    }
    for (edge, times) in &times {
        let [a, b] = edge.map(place);
        let middle = (a + b) / 2.0;
        let half = Vec2::new(0.2, 0.13);
        sheet.rectangle(middle - half, middle + half, PAPER, "none");
        sheet.text(middle, &format!("{times}×"), if *times == 1 { BLUE } else { ORANGE });
    }
    model.positions().iter().for_each(|point| sheet.dot(point.truncate(), BLACK));
    sheet.finish()
}

fn fans() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.4, -0.6), (9.8, 4.2));
    let convex: [(f32, f32); 6] = [(0.0, 1.6), (1.2, 0.0), (3.2, 0.3), (4.2, 1.9), (3.0, 3.5), (1.0, 3.2)];
    let notched: [(f32, f32); 6] = [(9.2, 0.4), (7.4, 1.4), (9.4, 3.4), (6.6, 2.4), (5.4, 3.6), (5.2, 0.2)];
    for corners in [convex, notched] {
        let faces = || (2..6).map(|n| [0, n - 1, n].map(|i| Vec2::from(corners[i])));
        let inside = |[a, b, c]: &[Vec2; 3]| (b - a).perp_dot(c - a) > 0.0;
        faces().filter(|face| inside(face)).for_each(|face| sheet.polygon(&face, SKY, BLUE));
        faces().filter(|face| !inside(face)).for_each(|face| sheet.polygon(&face, AMBER, BLUE));
        sheet.polyline(corners.into_iter().chain([corners[0]]), BLACK, 3.5);
        sheet.dot(corners[0], ORANGE);
    }
    sheet.text((-0.1, 1.15), "1", ORANGE);
    sheet.text((9.5, 0.2), "1", ORANGE);
    sheet.finish()
}

/// A cube that is turned a little: its edges, and the same without those at its farthest or nearest corner.
fn cube() -> anyhow::Result<Drawing> {
    let turned = |corner: usize| {
        let side = |bit: usize| if corner & bit == 0 { -0.52 } else { 0.52 };
        let (plane, y) = (Vec2::from_angle(0.55).rotate(Vec2::new(side(1), side(4))), side(2));
        let tilted = Vec2::from_angle(-0.45).rotate(Vec2::new(plane.y, y));
        Vec3::new(plane.x, tilted.y, tilted.x)
    };
    let corners: Vec<Vec3> = (0..8).map(turned).collect();
    let by_depth = |&a: &usize, &b: &usize| corners[a].z.total_cmp(&corners[b].z);
    let far = (0..8).min_by(by_depth).context("a cube has corners")?;
    let near = (0..8).max_by(by_depth).context("a cube has corners")?;
    let draw = |without: usize| {
        let mut image = canvas(150);
        for (a, b) in (0..8).flat_map(|a| [1, 2, 4].map(|bit| (a, a | bit))) {
            if a != b && a != without && b != without {
                let [from, to] = [a, b].map(|n| to_pixel(corners[n], &image));
                line(from, to, &mut image, Color::WHITE);
            }
        }
        image
    };
    beside([&draw(8), &draw(far), &draw(near)])
}

/// Spokes whose ends are far outside the picture: 10³ and 10⁹ times its size.
fn saturated() -> anyhow::Result<Drawing> {
    all_beside([1e3, 1e9].map(|size: f32| {
        let mut image = canvas(148);
        let end =
            |n: u32| (Vec2::from_angle((n as f32 + 0.5) * std::f32::consts::PI / 12.0) * size).extend(0.0);
        let corners: Vec<Vec3> = (0..12).flat_map(|n| [end(n), -end(n)]).collect();
        let spokes = (0..12).map(|n| [2 * n, 2 * n + 1, 2 * n]).collect();
        let model = Model::from_triangles(corners, spokes).map_err(|e| anyhow!(e))?;
        wireframe(&model, &mut image, Color::WHITE);
        Ok(image)
    }))
}
