//! Chapter 14's line drawings.

use blending::METHODS;
use common::Vec2;

use crate::figures::Drawing;
use crate::figures::sheet::{AMBER, BLACK, BLUE, FAINT, GREEN, GREY, Ink, ORANGE, PALE, ROSE, SKY, Sheet};

pub(super) fn stages() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-6.6, -10.2), (7.6, 0.7));
    let half = at(2.3, 0.5);
    let middle = |n: usize| at(0.0, -1.6 * n as f32);
    let stages: [(&str, Ink, Option<&str>); 7] = [
        ("fragment", PALE, None),
        ("scissor test", SKY, Some("a rectangle")),
        ("stencil test", SKY, Some("the stencil")),
        ("depth test", SKY, Some("the depths")),
        ("blending, or bits", AMBER, Some("the picture")),
        ("write mask", AMBER, Some("channels")),
        ("pixel", PALE, None),
    ];
    for n in 1..stages.len() {
        sheet.arrow(middle(n - 1) - half.with_x(0.0), middle(n) + half.with_x(0.0), BLACK);
    }
    for (n, (name, fill, beside)) in stages.into_iter().enumerate() {
        sheet.labelled(middle(n), half, fill, name);
        if let Some(beside) = beside {
            sheet.text_right_of(middle(n) + at(half.x + 1.1, 0.0), beside, GREY);
            sheet.arrow(middle(n) + at(half.x + 0.95, 0.0), middle(n) + at(half.x, 0.0), GREY);
        }
        // The stencil and the depths are not only read.
        if matches!(n, 2 | 3) {
            sheet.arrow(middle(n) + at(half.x, 0.0), middle(n) + at(half.x + 0.95, 0.0), GREY);
        }
        if fill == SKY {
            let out = middle(n) - at(half.x, 0.0);
            sheet.arrow(out, out - at(1.2, 0.0), ORANGE);
            sheet.text_left_of(out - at(1.4, 0.0), "no: gone", ORANGE);
        }
    }
    sheet.finish()
}

pub(super) fn areas() -> anyhow::Result<Drawing> {
    let at = Vec2::new;
    let mut sheet = Sheet::new((-4.0, -1.15), (5.2, 4.3));
    let side = 4.2;
    // What the source covers is to the left, what the destination covers below.
    let (source, destination) = (0.55 * side, 0.45 * side);
    let middle = |low: f32, high: f32| (low + high) / 2.0;
    for (low, high, fill, words) in [
        (at(0.0, 0.0), at(source, destination), ROSE, "both"),
        (at(0.0, destination), at(source, side), AMBER, "source"),
        (at(source, 0.0), at(side, destination), SKY, "destination"),
        (at(source, destination), at(side, side), PALE, "neither"),
    ] {
        sheet.rectangle(low, high, fill, BLACK);
        sheet.text((low + high) / 2.0, words, BLACK);
    }
    for (from, to, words) in [(0.0, source, "α of the source"), (source, side, "the rest")] {
        sheet.line(at(from + 0.05, -0.25), at(to - 0.05, -0.25), ORANGE, 2.4);
        sheet.text(at(middle(from, to), -0.7), words, ORANGE);
    }
    for (from, to, words) in [(0.0, destination, "α of the destination"), (destination, side, "the rest")] {
        sheet.line(at(-0.25, from + 0.05), at(-0.25, to - 0.05), BLUE, 2.4);
        sheet.text_left_of(at(-0.45, middle(from, to)), words, BLUE);
    }
    sheet.finish()
}

/// What a pixel is after each number of layers of white, over white and over black.
pub(super) fn layers() -> anyhow::Result<Drawing> {
    const COUNT: usize = 1000;
    const ALPHA: u8 = 1;
    let at = Vec2::new;
    let mut sheet = Sheet::new((-0.5, -2.2), (4.2, 1.95));
    let inks = [("two-shift", BLUE), ("shift-8", ORANGE)];
    for (bottom, first, name) in [(0.3, 255_u8, "over white"), (-1.75, 0, "over black")] {
        let place = |n: usize, code: f32| at((n as f32).log10(), bottom + 1.2 * code / 255.0);
        sheet.axes(at(0.0, bottom), (0.0, 0.0), (3.12, 1.3), 1.5);
        for code in [128.0, 255.0] {
            sheet.dashed(place(1, code), place(COUNT, code), FAINT, 1.4);
        }
        for (code, words) in [(0.0, "0"), (128.0, "128"), (255.0, "255")] {
            sheet.text_left_of(place(1, code) - at(0.06, 0.0), words, BLACK);
        }
        for n in [1, 10, 100, COUNT] {
            sheet.line(place(n, 0.0) - at(0.0, 0.03), place(n, 0.0) + at(0.0, 0.03), GREY, 1.5);
            sheet.text(place(n, 0.0) - at(0.0, 0.16), &n.to_string(), BLACK);
        }
        // As it should be.
        let exact = |n: usize| {
            let rest = (1.0 - f32::from(ALPHA) / 255.0).powi(n as i32);
            place(n, 255.0 + (f32::from(first) - 255.0) * rest)
        };
        sheet.polyline((1..=COUNT).map(exact), GREEN, 5.0);
        for method in METHODS {
            let Some((_, ink)) = inks.iter().find(|(name, _)| *name == method.name) else { continue };
            let mut code = first;
            let step = |n: usize| {
                code = (method.run.mix)(255, code, ALPHA);
                place(n, f32::from(code))
            };
            sheet.polyline((1..=COUNT).map(step), ink, 2.2);
        }
        sheet.text_right_of(at(0.1, bottom + 1.42), name, GREY);
    }
    sheet.text(at(1.5, -2.15), "layers of white", GREY);
    for (n, (name, ink)) in [("exact", GREEN)].into_iter().chain(inks).enumerate() {
        let low = at(3.3, 1.25 - 0.3 * n as f32);
        sheet.line(low, low + at(0.2, 0.0), ink, if n == 0 { 5.0 } else { 2.2 });
        sheet.text_right_of(low + at(0.28, 0.0), name, BLACK);
    }
    sheet.finish()
}
