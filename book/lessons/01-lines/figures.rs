//! Chapter 1: lines.

use common::{Bounds, Color, Format, IVec2, Image, Vec2};
use lines::METHODS;

use crate::figures::picture::{canvas, method};
use crate::figures::sheet::{AMBER, BLACK, BLUE, GREEN, GREY, ORANGE, PALE, SKY, Sheet};
use crate::figures::{Drawing, Figure};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "lines-two",
        "A black picture with two thin lines: a white one that climbs gently to the right, and a red one that \
         climbs steeply.",
        two_lines,
    ),
    Figure::new(
        "lines-ideal",
        "A grid of pixels with a straight line through the centres of two of them. In each column the pixel \
         nearest to the line is filled.",
        ideal,
    ),
    Figure::new("lines-step", "The same segment drawn ten pixels apart: the dots do not touch.", || {
        by("step-0.1", [IVec2::new(0, 0), IVec2::new(19, 7)])
    }),
    Figure::new(
        "lines-steep",
        "A steep segment drawn with one pixel in each column: four pixels with wide gaps above each other.",
        || by("per-column", [IVec2::new(2, 0), IVec2::new(6, 12)]),
    ),
    Figure::new(
        "lines-octants",
        "A plane cut into eight equal sectors about the origin. Two of them, right and left, are marked as not \
         steep; the other two as steep; arrows show that a leftward line is walked from its other end.",
        octants,
    ),
    Figure::new(
        "lines-error",
        "Six columns of pixels. The ideal line climbs by two fifths of a pixel a column. In each column an arrow \
         shows the distance from the pixel's centre to the line; where it would exceed one half, the pixel \
         moves up.",
        error,
    ),
    Figure::new(
        "lines-listing",
        "A grid with a line of slope 0.9. The pixels of the slides' listing lie one row above those of \
         Bresenham's algorithm in most columns, and the last one lies past the end of the segment.",
        listing,
    ),
    Figure::new(
        "lines-wu",
        "A segment drawn with two pixels in each column, whose greys add up to white: the edge looks smooth.",
        smooth,
    ),
    Figure::new(
        "lines-ties",
        "A line of slope one half. In every second column it passes exactly between two pixels; the lower one is \
         filled, the upper one, as near, is outlined.",
        ties,
    ),
    Figure::new(
        "lines-drift",
        "The last twelve columns of a segment of 65,000 pixels. The pixels of the method that adds a rounded slope \
         run parallel to the line, many rows away from it.",
        drift,
    ),
    Figure::new(
        "lines-diamond",
        "A row of pixels, each with a diamond about its centre. A line crosses some diamonds and misses others; the \
         pixels of those that it leaves are filled.",
        diamond,
    ),
    Figure::new(
        "lines-visible",
        "A long line crosses a small window far from its ends. Only the part inside the window is drawn; the \
         walk begins where the line enters.",
        visible,
    ),
];

/// The lesson's picture, by the lesson's own function.
fn two_lines() -> anyhow::Result<Drawing> {
    let mut image = canvas(100);
    lines::line(IVec2::new(13, 20), IVec2::new(80, 40), &mut image, Color::WHITE);
    lines::line(IVec2::new(20, 13), IVec2::new(40, 80), &mut image, Color::RED);
    Ok(Drawing::Pixels(image, 4))
}

/// The pixels of a method.
fn pixels(name: &str, [a, b]: [IVec2; 2]) -> anyhow::Result<Vec<(i32, i32)>> {
    let mut pixels = Vec::new();
    (method(METHODS, name)?.visit)(a, b, Bounds::EVERYTHING, &mut |x, y, _| pixels.push((x, y)));
    Ok(pixels)
}

/// A pixel's centre.
fn center(pixel: IVec2) -> Vec2 {
    pixel.as_vec2() + 0.5
}

/// A grid about a segment, a border of one pixel around it.
fn grid([a, b]: [IVec2; 2]) -> Sheet {
    let (low, high) = (a.min(b) - 1, a.max(b) + 2);
    let mut sheet = Sheet::new(low.as_vec2(), high.as_vec2());
    sheet.grid((low.x, low.y), (high.x, high.y));
    sheet
}

/// The ideal segment and its ends.
fn segment(sheet: &mut Sheet, ends: [IVec2; 2]) {
    let [a, b] = ends.map(center);
    sheet.line(a, b, BLACK, 2.2);
    sheet.dot(a, BLACK);
    sheet.dot(b, BLACK);
}

/// What a method makes of a segment, with the ideal line over it.
fn by(name: &str, ends: [IVec2; 2]) -> anyhow::Result<Drawing> {
    let mut sheet = grid(ends);
    sheet.pixels(pixels(name, ends)?, SKY);
    segment(&mut sheet, ends);
    sheet.finish()
}

fn ideal() -> anyhow::Result<Drawing> {
    by("bresenham", [IVec2::new(0, 0), IVec2::new(12, 5)])
}

fn octants() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-3.0, -2.0), (3.0, 2.0));
    let at = Vec2::new;
    let flat = |side: f32| {
        [at(0.0, 0.0), at(2.0 * side, 2.0), at(2.9 * side, 2.0), at(2.9 * side, -2.0), at(2.0 * side, -2.0)]
    };
    sheet.polygon(&flat(1.0), SKY, "none");
    sheet.polygon(&flat(-1.0), SKY, "none");
    sheet.dashed((-2.0, -2.0), (2.0, 2.0), GREY, 1.5);
    sheet.dashed((-2.0, 2.0), (2.0, -2.0), GREY, 1.5);
    sheet.arrow((0.0, 0.0), (2.5, 0.8), BLUE);
    sheet.arrow((0.0, 0.0), (-2.5, -0.8), ORANGE);
    sheet.arrow((0.0, 0.0), (0.5, 1.8), BLUE);
    sheet.text((1.75, -0.55), "|dx| ≥ |dy|", BLACK);
    sheet.text((1.75, -0.9), "walk along x", BLACK);
    sheet.text((-1.8, 0.9), "leftward: walk", BLACK);
    sheet.text((-1.8, 0.55), "from the other end", BLACK);
    sheet.text((-0.35, 1.75), "|dx| < |dy|", BLACK);
    sheet.text((0.0, -1.4), "steep: swap", BLACK);
    sheet.text((0.0, -1.75), "x and y", BLACK);
    sheet.dot((0.0, 0.0), BLACK);
    sheet.finish()
}

fn error() -> anyhow::Result<Drawing> {
    let ends = [IVec2::new(0, 0), IVec2::new(5, 2)];
    let mut sheet = grid(ends);
    sheet.pixels(pixels("bresenham", ends)?, SKY);
    segment(&mut sheet, ends);
    for (x, y) in pixels("bresenham", ends)?.into_iter().filter(|&(x, ..)| (1..5).contains(&x)) {
        let from = center(IVec2::new(x, y));
        let to = Vec2::new(from.x, 0.5 + 0.4 * x as f32);
        sheet.line(from, to, if to.y > from.y { ORANGE } else { GREEN }, 5.0);
        sheet.dot(from, BLUE);
        let words = format!("{:+.1}", to.y - from.y).replace('-', "−");
        sheet.text((from.x, y as f32 - 0.22), &words, BLACK);
    }
    sheet.finish()
}

fn listing() -> anyhow::Result<Drawing> {
    let ends = [IVec2::new(0, 0), IVec2::new(10, 9)];
    let mut sheet = grid(ends);
    let right = pixels("bresenham", ends)?;
    sheet.pixels(right.iter().copied(), SKY);
    sheet.pixels(pixels("listing", ends)?.into_iter().filter(|pixel| !right.contains(pixel)), AMBER);
    segment(&mut sheet, ends);
    sheet.text_right_of((5.4, 2.5), "blue: Bresenham", BLUE);
    sheet.text_left_of((5.6, 8.5), "amber: the listing", ORANGE);
    sheet.finish()
}

fn smooth() -> anyhow::Result<Drawing> {
    let mut image = Image::new(60, 24, Format::Rgb);
    for (name, up) in [("bresenham", 0), ("wu", 9)] {
        (method(METHODS, name)?.draw)(
            IVec2::new(2, 2 + up),
            IVec2::new(57, 12 + up),
            &mut image,
            Color::WHITE,
        );
    }
    Ok(Drawing::Pixels(image, 10))
}

fn visible() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((-12.0, -6.0), (12.0, 6.0));
    let at = Vec2::new;
    let slope = |x: f32| at(x, x * 0.4 + 0.3);
    sheet.rectangle((-4.0, -3.0), (4.0, 3.0), PALE, GREY);
    sheet.dashed(slope(-11.5), slope(-4.0), GREY, 2.0);
    sheet.dashed(slope(4.0), slope(11.5), GREY, 2.0);
    sheet.line(slope(-4.0), slope(4.0), BLUE, 4.0);
    sheet.dot(slope(-4.0), ORANGE);
    sheet.text((0.0, 2.3), "the window", BLACK);
    sheet.text_left_of((-4.3, 0.9), "the first step", ORANGE);
    sheet.text_left_of((-4.3, -0.1), "that can be seen", ORANGE);
    sheet.text((8.2, 2.0), "skipped", GREY);
    sheet.text((-8.6, -4.6), "skipped", GREY);
    sheet.finish()
}

fn ties() -> anyhow::Result<Drawing> {
    let ends = [IVec2::new(0, 0), IVec2::new(8, 4)];
    let mut sheet = grid(ends);
    for (x, y) in pixels("bresenham", ends)? {
        sheet.pixel(x, y, SKY);
        if x % 2 == 1 {
            let (above, inset) = (IVec2::new(x, y + 1).as_vec2(), 0.06);
            sheet.rectangle(above + inset, above + 1.0 - inset, "none", ORANGE);
        }
    }
    segment(&mut sheet, ends);
    sheet.finish()
}

fn drift() -> anyhow::Result<Drawing> {
    const LENGTH: i32 = 65_000;
    const COLUMNS: i32 = 12;
    let ends = [IVec2::new(0, 0), IVec2::new(LENGTH, 24_050)];
    let shown = |name: &str| -> anyhow::Result<Vec<IVec2>> {
        let all = pixels(name, ends)?.into_iter().map(IVec2::from);
        Ok(all.filter(|pixel| pixel.x > LENGTH - COLUMNS).collect())
    };
    let (right, wrong) = (shown("bresenham")?, shown("slope")?);
    let both = || right.iter().chain(&wrong);
    let low = both().copied().reduce(IVec2::min).unwrap_or_default() - 1;
    let high = both().copied().reduce(IVec2::max).unwrap_or_default() + 2;
    // Counted from the corner: f32 has no room for halves of pixels out here.
    let mut sheet = Sheet::new(Vec2::ZERO, (high - low).as_vec2());
    sheet.grid((0, 0), (high - low).into());
    for (list, ink) in [(&right, SKY), (&wrong, AMBER)] {
        sheet.pixels(list.iter().map(|&pixel| (pixel - low).into()), ink);
    }
    let last = ends[1] - low;
    let slope = 24_050.0 / LENGTH as f32;
    let end = center(last);
    sheet.line(end - Vec2::new(COLUMNS as f32 - 1.0, slope * (COLUMNS as f32 - 1.0)), end, BLACK, 2.2);
    sheet.dot(end, BLACK);
    let middle = (high - low).x as f32 / 2.0;
    let height = |list: &[IVec2]| list.iter().map(|pixel| pixel.y - low.y).max().unwrap_or_default() as f32;
    sheet.text((middle - 2.5, height(&right) + 0.6), "bresenham", BLUE);
    sheet.text((middle - 2.5, height(&wrong) + 0.6), "slope", ORANGE);
    sheet.finish()
}

fn diamond() -> anyhow::Result<Drawing> {
    let mut sheet = Sheet::new((0.0, 0.0), (6.0, 3.0));
    let (from, to) = (Vec2::new(0.55, 0.55), Vec2::new(5.45, 2.45));
    sheet.grid((0, 0), (6, 3));
    let pixels = (0..3).flat_map(|y| (0..6).map(move |x| IVec2::new(x, y)));
    for pixel in pixels {
        let middle = center(pixel);
        // The shares of the line at which it enters and leaves the diamond, by its four sides.
        let sides = [Vec2::new(1.0, 1.0), Vec2::new(1.0, -1.0), Vec2::new(-1.0, 1.0), Vec2::new(-1.0, -1.0)];
        let (mut enter, mut leave) = (f32::NEG_INFINITY, f32::INFINITY);
        for side in sides {
            let (at, by) = (side.dot(from - middle) - 0.5, side.dot(to - from));
            let share = -at / by;
            if by < 0.0 { enter = enter.max(share) } else { leave = leave.min(share) }
        }
        let exits = enter < leave && leave > 0.0 && leave <= 1.0;
        if exits {
            sheet.pixel(pixel.x, pixel.y, SKY);
        }
        let corner = |x: f32, y: f32| middle + Vec2::new(x, y) / 2.0;
        let corners = [corner(1.0, 0.0), corner(0.0, 1.0), corner(-1.0, 0.0), corner(0.0, -1.0)];
        sheet.polygon(&corners, "none", if exits { BLUE } else { GREY });
    }
    sheet.line(from, to, BLACK, 2.4);
    sheet.dot(from, BLACK);
    sheet.dot(to, BLACK);
    sheet.finish()
}
