//! Chapter 15's line drawings.

use antialiasing::area::clipped;
use antialiasing::{coverage, pattern};
use common::{IVec2, Vec2, Vec4Swizzles};

use crate::figures::Drawing;
use crate::figures::sheet::{AMBER, BLACK, BLUE, FAINT, GREEN, GREY, Ink, ORANGE, PALE, PURPLE, SKY, Sheet};

/// Sample places in a pixel, from its lower left corner, in 1/16 px.
type Places = Vec<[i32; 2]>;

/// The standard pattern of so many samples.
fn standard(samples: usize) -> Places {
    pattern(samples).to_vec()
}

/// The middles of 4×4 squares.
pub(crate) fn grid() -> Places {
    (0..16).map(|n| [2 + 4 * (n % 4), 2 + 4 * (n / 4)]).collect()
}

fn place([x, y]: [i32; 2]) -> Vec2 {
    Vec2::new(x as f32, y as f32)
}

/// A pixel, 16 units wide, with its lines and its samples.
fn pixel(sheet: &mut Sheet, low: Vec2, places: &[[i32; 2]], ink: Ink) {
    sheet.rectangle(low, low + 16.0, "none", GREY);
    for n in 1..16 {
        let n = n as f32;
        sheet.line(low + Vec2::new(n, 0.0), low + Vec2::new(n, 16.0), FAINT, 0.8);
        sheet.line(low + Vec2::new(0.0, n), low + Vec2::new(16.0, n), FAINT, 0.8);
    }
    places.iter().for_each(|&at| sheet.dot(low + place(at), ink));
}

/// A triangle and the pixel from (0, 0) to (1, 1): the corners of the chapter's example.
pub(super) const CUT: [Vec2; 3] = [Vec2::new(0.25, 0.25), Vec2::new(1.25, 0.25), Vec2::new(0.25, 1.25)];

pub(super) fn shoelace() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.75, -0.22), (1.75, 1.4));
    sheet.rectangle((0.0, 0.0), (1.0, 1.0), PALE, GREY);
    let left: Vec<Vec2> =
        clipped(CUT, IVec2::ZERO).corners().iter().map(|corner| corner.position.xy()).collect();
    sheet.polygon(&left, SKY, "none");
    sheet.polygon(&CUT, "none", BLUE);
    sheet.polygon(&left, "none", BLACK);
    let middle = left.iter().sum::<Vec2>() / left.len() as f32;
    for (n, corner) in left.iter().enumerate() {
        sheet.dot(*corner, ORANGE);
        sheet.text(middle.lerp(*corner, 0.8), &format!("P{}", ["₀", "₁", "₂", "₃", "₄", "₅", "₆"][n]), BLACK);
    }
    sheet.text_right_of((1.05, 0.92), "pixel", GREY);
    sheet.text_left_of((0.2, 1.2), "triangle", BLUE);
    sheet.text(middle, "7/16", BLUE);
    sheet.finish()
}

pub(super) fn patterns() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.5, -4.0), (58.5, 39.5));
    let all: [(&str, Places); 6] = [
        ("1", standard(1)),
        ("2", standard(2)),
        ("4", standard(4)),
        ("8", standard(8)),
        ("16", standard(16)),
        ("4 × 4", grid()),
    ];
    for (n, (name, places)) in all.iter().enumerate() {
        let low = Vec2::new(21.0 * (n % 3) as f32, if n < 3 { 22.0 } else { 0.0 });
        pixel(&mut sheet, low, places, if n == 5 { ORANGE } else { BLUE });
        sheet.text(low + Vec2::new(8.0, -2.2), name, BLACK);
    }
    sheet.finish()
}

pub(super) fn heights() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-0.5, -4.0), (71.5, 17.5));
    for (n, (name, places, ink)) in
        [("4 × 4", grid(), ORANGE), ("16", standard(16), BLUE), ("4", standard(4), BLUE)].iter().enumerate()
    {
        let low = Vec2::new(25.0 * n as f32, 0.0);
        pixel(&mut sheet, low, places, ink);
        for at in places {
            let height = low + Vec2::new(0.0, at[1] as f32);
            sheet.line(height + Vec2::new(17.5, 0.0), height + Vec2::new(21.0, 0.0), ink, 2.4);
        }
        sheet.text(low + Vec2::new(8.0, -2.4), name, BLACK);
    }
    sheet.finish()
}

/// How many greys an edge at that angle to the rows shows, in degrees: a step between two counts if it takes a quarter of an
/// even one.
pub(super) fn told_apart(places: &[[i32; 2]], degrees: f32) -> usize {
    let normal = Vec2::from_angle(degrees.to_radians()).perp();
    let mut met: Vec<f32> = places.iter().map(|&at| place(at).dot(normal) / 16.0).collect();
    met.sort_by(f32::total_cmp);
    let least = 0.25 / places.len() as f32;
    // What is as long but for rounding is long enough.
    2 + met.windows(2).filter(|pair| pair[1] - pair[0] > least - 1e-6).count()
}

pub(super) fn levels() -> anyhow::Result<Drawing> {
    let at = |degrees: f32, levels: f32| Vec2::new(degrees / 90.0 * 20.0, levels);
    let mut sheet = Sheet::new((-2.2, -2.6), (23.5, 19.4));
    sheet.axes((0.0, 0.0), (0.0, 0.0), (21.0, 18.3), 1.5);
    for levels in [3.0, 5.0, 9.0, 17.0] {
        sheet.dashed(at(0.0, levels), at(90.0, levels), FAINT, 1.4);
        sheet.text_left_of(at(-2.0, levels), &levels.to_string(), BLACK);
    }
    for degrees in [0.0, 22.5, 45.0, 67.5, 90.0] {
        sheet.line(at(degrees, -0.2), at(degrees, 0.2), GREY, 1.5);
        if degrees.fract() == 0.0 {
            sheet.text(at(degrees, -1.1), &format!("{degrees}°"), BLACK);
        }
    }
    let lines: [(Ink, f32, Places); 3] =
        [(PURPLE, 2.0, standard(4)), (ORANGE, 2.6, grid()), (BLUE, 2.6, standard(16))];
    for (ink, width, places) in &lines {
        let points = (0..=360).map(|n| 0.25 * n as f32);
        sheet.polyline(points.map(|a| at(a, told_apart(places, a) as f32)), ink, *width);
    }
    sheet.text_right_of((0.3, 19.0), "greys told apart", GREY);
    sheet.text(at(45.0, -2.2), "angle of the side to the rows", GREY);
    sheet.text_right_of(at(91.0, 3.9), "4", PURPLE);
    sheet.text_right_of(at(91.0, 6.0), "4 × 4", ORANGE);
    sheet.text_right_of(at(91.0, 17.0), "16", BLUE);
    sheet.finish()
}

pub(super) fn centroid() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-13.0, -0.5), (31.0, 17.6));
    // In 1/16 px, as the places are.
    let corners = [Vec2::new(-12.0, 9.0), Vec2::new(24.5, 10.5), Vec2::new(20.0, 17.2)];
    sheet.rectangle((0.0, 0.0), (16.0, 16.0), PALE, GREY);
    sheet.polygon(&corners, AMBER, "none");
    pixel(&mut sheet, Vec2::ZERO, &[], GREY);
    sheet.polygon(&corners, "none", BLACK);
    let places = standard(16);
    let mask = coverage(corners.map(|corner| corner / 16.0), IVec2::ZERO, &places);
    let covered = || places.iter().enumerate().filter(|(s, _)| mask >> s & 1 == 1).map(|(_, at)| place(*at));
    places.iter().for_each(|at| sheet.dot(place(*at), GREY));
    covered().for_each(|at| sheet.dot(at, BLUE));
    let mean = covered().sum::<Vec2>() / covered().count() as f32;
    sheet.line((8.0, 8.0), mean, BLACK, 1.6);
    sheet.dot((8.0, 8.0), ORANGE);
    sheet.dot(mean, GREEN);
    for (height, ink, words) in [
        (6.4, ORANGE, "centre".to_string()),
        (3.8, BLUE, format!("{} of 16", covered().count())),
        (1.2, GREEN, "centroid of these".to_string()),
    ] {
        sheet.dot((17.4, height), ink);
        sheet.text_right_of((18.4, height), &words, ink);
    }
    sheet.finish()
}

pub(super) fn row() -> anyhow::Result<Drawing> {
    const WIDTH: i32 = 13;
    let at = |x: f32, y: f32| Vec2::new(x, y);
    let mut sheet = Sheet::new((-0.6, -3.1), (WIDTH as f32 + 0.4, 2.1));
    // A triangle whose sides cross the row aslant.
    let corners = [at(-0.8, -0.9), at(13.9, -0.55), at(8.0, 2.6)];
    let inside = |height: f32| {
        let cross = |from: Vec2, to: Vec2| from.lerp(to, (height - from.y) / (to.y - from.y));
        [cross(corners[0], corners[2]), cross(corners[1], corners[2])]
    };
    let ([a, b], [d, c]) = (inside(0.0), inside(1.0));
    sheet.polygon(&[a, b, c, d], AMBER, "none");
    for x in 0..WIDTH {
        let low = at(x as f32, 0.0);
        sheet.rectangle(low, low + 1.0, "none", GREY);
    }
    sheet.line(a, d, BLACK, 1.8);
    sheet.line(b, c, BLACK, 1.8);
    let places = standard(4);
    let masks: Vec<u32> = (0..WIDTH).map(|x| coverage(corners, IVec2::new(x, 0), &places)).collect();
    let mut spans = Vec::new();
    for (s, &place_of) in places.iter().enumerate() {
        let covered = |x: &i32| masks[*x as usize] >> s & 1 == 1;
        for x in 0..WIDTH {
            let ink = if covered(&x) { BLUE } else { GREY };
            sheet.dot(at(x as f32, 0.0) + place(place_of) / 16.0, ink);
        }
        let first = (0..WIDTH).find(covered).unwrap_or(0);
        let end = (0..WIDTH).rev().find(covered).map_or(0, |last| last + 1);
        spans.push((first, end));
        let height = -0.55 - 0.55 * s as f32;
        sheet.line(at(first as f32 + 0.08, height), at(end as f32 - 0.08, height), BLUE, 6.0);
        sheet.text_left_of(at(-0.2, height), &s.to_string(), GREY);
    }
    let first = spans.iter().map(|span| span.0).max().unwrap_or(0) as f32;
    let end = spans.iter().map(|span| span.1).min().unwrap_or(0) as f32;
    for x in [first, end] {
        sheet.dashed(at(x, -2.5), at(x, 1.5), ORANGE, 2.0);
    }
    sheet.text(at((first + end) / 2.0, 1.75), "covered whole", ORANGE);
    sheet.text(at((first + end) / 2.0, -2.85), "from the first to the last pixel of each sample", GREY);
    sheet.finish()
}
