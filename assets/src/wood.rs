//! A side of a wooden box: planks in a frame with nails, painted by formula.

use common::{Color, Format, Image};
use glam::DVec3;

/// Planks between the two beams of the frame.
const PLANKS: f64 = 5.0;
/// Width of the frame, as a share of the side.
const FRAME: f64 = 0.13;

/// The side as a square picture of `size` pixels.
#[must_use]
pub fn crate_side(size: u16) -> Image {
    let mut image = Image::new(size, size, Format::Rgb);
    for y in 0..i32::from(size) {
        for x in 0..i32::from(size) {
            let at = |n: i32| (f64::from(n) + 0.5) / f64::from(size);
            let [r, g, b] = paint(at(x), at(y)).to_array().map(|level| (level * 255.0).round() as u8);
            image.set(x, y, Color::rgb(r, g, b));
        }
    }
    image
}

/// The colour at (u, v), each channel from 0 to 1.
fn paint(u: f64, v: f64) -> DVec3 {
    // In the corners the beams at the top and the bottom run through, the others stand between them.
    let (from_side, from_end) = (u.min(1.0 - u), v.min(1.0 - v));
    if from_end < FRAME {
        let nails = nail(from_side - FRAME / 2.0, from_end - FRAME / 2.0);
        board(u, v / FRAME, 11.0 + v.round()) * bevel(from_end / FRAME) * nails
    } else if from_side < FRAME {
        board(v, u / FRAME, 13.0 + u.round()) * bevel(from_side / FRAME) * seam(from_end - FRAME)
    } else {
        let across = (u - FRAME) / (1.0 - 2.0 * FRAME) * PLANKS;
        let nails = nail((across.fract() - 0.5) * 0.15, from_end - FRAME - 0.035);
        // The frame throws a shadow on the planks.
        let shade = 1.0 - 0.45 * fade((from_side.min(from_end) - FRAME) / 0.05);
        board(v, across.fract(), across.floor()) * 0.8 * bevel(across.fract()) * shade * nails
    }
}

/// Wood with its grain along the board: `along` and `across` in units of the board's width.
fn board(along: f64, across: f64, seed: f64) -> DVec3 {
    let tone = noise(seed * 7.3, 0.5);
    let bend = 0.35 * noise(along * 4.0 + seed * 31.0, across * 1.5);
    // Rings are cut at a slope: bands along the board, wavering.
    let rings = noise(along * 2.0 + seed * 17.0, (across + bend) * 9.0);
    let fibre = noise(along * 9.0, across * 60.0 + seed * 101.0);
    let light = DVec3::new(0.80, 0.58, 0.34);
    let dark = DVec3::new(0.46, 0.27, 0.13);
    dark.lerp(light, 0.25 + 0.25 * tone + 0.35 * rings + 0.15 * fibre)
}

/// A board's edges: lit on one side, dark in the gap; `across` from 0 to 1.
fn bevel(across: f64) -> f64 {
    1.0 - 0.65 * fade(across / 0.07) - 0.55 * fade((1.0 - across) / 0.06)
        + 0.18 * fade((across - 0.1).abs() / 0.04)
}

/// A dark line where two boards meet at distance 0.
fn seam(distance: f64) -> f64 {
    1.0 - 0.6 * fade(distance.abs() / 0.008)
}

/// A nail's head at (0, 0), with a glint and a ring of shadow.
fn nail(x: f64, y: f64) -> f64 {
    let radius = (x * x + y * y).sqrt() / 0.016;
    let glint = ((x + 0.005) * (x + 0.005) + (y - 0.005) * (y - 0.005)).sqrt() / 0.006;
    1.0 - 0.6 * fade((radius - 0.6).max(0.0)) + 0.7 * fade(glint)
}

/// 1 at 0, falling smoothly to 0 at 1 and beyond.
fn fade(x: f64) -> f64 {
    let rest = 1.0 - x.clamp(0.0, 1.0);
    rest * rest * (3.0 - 2.0 * rest)
}

/// Value noise from 0 to 1: random numbers on the grid of whole numbers, smoothly joined.
fn noise(x: f64, y: f64) -> f64 {
    let random = |x: f64, y: f64| {
        let n = (x as i64 as u64).wrapping_mul(0x1_0000_0001).wrapping_add(y as i64 as u64);
        f64::from(Color::random(n).r) / 255.0
    };
    let (left, below) = (x.floor(), y.floor());
    let (s, t) = (1.0 - fade(x - left), 1.0 - fade(y - below));
    let row = |y: f64| random(left, y) * (1.0 - s) + random(left + 1.0, y) * s;
    row(below) * (1.0 - t) + row(below + 1.0) * t
}
