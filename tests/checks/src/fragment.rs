//! What happens to a fragment on its way to a sample, operation by operation, by OpenGL's names, in rational numbers and bit by
//! bit.
//!
//! Source: OpenGL 4.6 (core), *Scissor Test*, *Stencil Test*, *Depth Buffer Test*, *Blending*, *Logical Operation* and *Fine
//! Control of Buffer Updates*.

use std::cmp::Ordering;

use common::Color;

/// Which of two values pass, the incoming one on the left.
///
/// # Panics
/// Where there is no such function.
#[must_use]
pub fn passes(function: &str, incoming: f64, kept: f64) -> bool {
    use Ordering::{Equal, Greater, Less};
    // NaN is in no order.
    let order = incoming.partial_cmp(&kept);
    let one_of = |orders: &[Ordering]| order.is_some_and(|order| orders.contains(&order));
    match function {
        "never" => false,
        "less" => one_of(&[Less]),
        "equal" => one_of(&[Equal]),
        "lequal" => one_of(&[Less, Equal]),
        "greater" => one_of(&[Greater]),
        "notequal" => !one_of(&[Equal]),
        "gequal" => one_of(&[Equal, Greater]),
        "always" => true,
        other => panic!("there is no function `{other}`"),
    }
}

/// What a stencil's number of 8 bits becomes.
///
/// # Panics
/// Where there is no such operation.
#[must_use]
pub fn stencil_op(operation: &str, kept: i64, reference: i64) -> i64 {
    match operation {
        "keep" => kept,
        "zero" => 0,
        "replace" => reference,
        "incr" => (kept + 1).min(255),
        "incr-wrap" => (kept + 1).rem_euclid(256),
        "decr" => (kept - 1).max(0),
        "decr-wrap" => (kept - 1).rem_euclid(256),
        "invert" => 255 - kept,
        other => panic!("there is no operation `{other}`"),
    }
}

fn bit(number: i64, place: u32) -> i64 {
    (number / 2_i64.pow(place)) % 2
}

/// A number whose bits come from `new` where the mask has a 1, and from `old` elsewhere.
fn masked(old: i64, new: i64, mask: i64) -> i64 {
    (0..8).map(|place| 2_i64.pow(place) * bit(if bit(mask, place) == 1 { new } else { old }, place)).sum()
}

/// A stencil test, by names.
#[derive(Clone, Debug)]
pub struct Stencil {
    /// How the reference compares with what is kept.
    pub function: String,
    /// The reference.
    pub reference: i64,
    /// The bits that are compared.
    pub read_mask: i64,
    /// The bits that change.
    pub write_mask: i64,
    /// What happens where the stencil test fails, where the depth test does, and where both pass.
    pub operations: [String; 3],
}

/// What is drawn to: one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Its colour.
    pub color: Color,
    /// Its depth.
    pub depth: f64,
    /// Its stencil.
    pub stencil: i64,
}

/// All operations on a fragment; what is `None` is left out.
#[derive(Clone, Debug)]
pub struct Pipeline {
    /// x, y, width and height.
    pub scissor: Option<[i64; 4]>,
    /// The stencil test.
    pub stencil: Option<Stencil>,
    /// The depth function, and whether depths are written.
    pub depth: (String, bool),
    /// The equation and the factors of source and destination, for colours and for alpha.
    pub blend: [[String; 3]; 2],
    /// What the constant factors mean.
    pub constant: Color,
    /// A logic operation, in place of blending.
    pub logic: Option<String>,
    /// Whether red, green, blue and alpha are written.
    pub mask: [bool; 4],
}

fn channels(Color { r, g, b, a }: Color) -> [i128; 4] {
    [r, g, b, a].map(i128::from)
}

/// The factor of a channel, in 255ths.
///
/// # Panics
/// Where there is no such factor.
#[must_use]
pub fn factor(name: &str, channel: usize, source: Color, destination: Color, constant: Color) -> i128 {
    let [source, destination, constant] = [source, destination, constant].map(channels);
    if let Some(name) = name.strip_prefix("one-minus-") {
        let whole = factor_of(name, channel, source, destination, constant);
        return 255 - whole;
    }
    factor_of(name, channel, source, destination, constant)
}

fn factor_of(
    name: &str,
    channel: usize,
    source: [i128; 4],
    destination: [i128; 4],
    constant: [i128; 4],
) -> i128 {
    let of = |what: &str, color: [i128; 4]| {
        let rest = name.strip_prefix(what)?;
        match rest {
            "-color" => Some(color[channel]),
            "-alpha" => Some(color[3]),
            _ => None,
        }
    };
    match name {
        "zero" => 0,
        "one" => 255,
        "src-alpha-saturate" if channel == 3 => 255,
        "src-alpha-saturate" => source[3].min(255 - destination[3]),
        _ => of("src", source)
            .or_else(|| of("dst", destination))
            .or_else(|| of("constant", constant))
            .unwrap_or_else(|| panic!("there is no factor `{name}`")),
    }
}

/// A channel of a blended colour in 255ths of a code, rounded nowhere and not clamped.
///
/// # Panics
/// Where there is no such equation.
#[must_use]
pub fn blended(
    [equation, source_factor, destination_factor]: [&str; 3],
    channel: usize,
    source: Color,
    destination: Color,
    constant: Color,
) -> i128 {
    let [s, d] = [source, destination].map(|color| channels(color)[channel]);
    let f = factor(source_factor, channel, source, destination, constant);
    let g = factor(destination_factor, channel, source, destination, constant);
    match equation {
        "func-add" => s * f + d * g,
        "func-subtract" => s * f - d * g,
        "func-reverse-subtract" => d * g - s * f,
        "min" => 255 * s.min(d),
        "max" => 255 * s.max(d),
        other => panic!("there is no equation `{other}`"),
    }
}

/// 255ths of a code as a code: the nearest one from 0 to 255. None is half-way between two, as 255 is odd.
#[must_use]
pub fn rounded(n: i128) -> u8 {
    (0..=255_u8).min_by_key(|&code| (255 * i128::from(code) - n).abs()).unwrap_or(0)
}

/// The logic operation of two channels, bit by bit: for the bits 00, 01, 10 and 11 of source and destination, in this order,
/// each has its results.
///
/// # Panics
/// Where there is no such operation.
#[must_use]
pub fn logic(operation: &str, source: u8, destination: u8) -> u8 {
    let table: [i64; 4] = match operation {
        "clear" => [0, 0, 0, 0],
        "and" => [0, 0, 0, 1],
        "and-reverse" => [0, 0, 1, 0],
        "copy" => [0, 0, 1, 1],
        "and-inverted" => [0, 1, 0, 0],
        "noop" => [0, 1, 0, 1],
        "xor" => [0, 1, 1, 0],
        "or" => [0, 1, 1, 1],
        "nor" => [1, 0, 0, 0],
        "equiv" => [1, 0, 0, 1],
        "invert" => [1, 0, 1, 0],
        "or-reverse" => [1, 0, 1, 1],
        "copy-inverted" => [1, 1, 0, 0],
        "or-inverted" => [1, 1, 0, 1],
        "nand" => [1, 1, 1, 0],
        "set" => [1, 1, 1, 1],
        other => panic!("there is no operation `{other}`"),
    };
    let result = |place: u32| {
        let [s, d] = [source, destination].map(|byte| bit(byte.into(), place));
        2_i64.pow(place) * table[(2 * s + d) as usize]
    };
    (0..8).map(result).sum::<i64>() as u8
}

impl Pipeline {
    /// What becomes of a sample, and whether the fragment was seen.
    #[must_use]
    pub fn after(&self, [x, y]: [i64; 2], depth: f64, source: Color, sample: Sample) -> (bool, Sample) {
        if let Some([left, bottom, width, height]) = self.scissor
            && !((left..left + width).contains(&x) && (bottom..bottom + height).contains(&y))
        {
            return (false, sample);
        }
        let mut after = sample;
        let stencil_passes = self.stencil.as_ref().is_none_or(|stencil| {
            let [reference, kept] =
                [stencil.reference, sample.stencil].map(|n| masked(0, n, stencil.read_mask));
            passes(&stencil.function, reference as f64, kept as f64)
        });
        let depth_passes = passes(&self.depth.0, depth, sample.depth);
        if let Some(Stencil { reference, write_mask, operations, .. }) = &self.stencil {
            let operation = match (stencil_passes, depth_passes) {
                (false, _) => &operations[0],
                (true, false) => &operations[1],
                (true, true) => &operations[2],
            };
            after.stencil =
                masked(sample.stencil, stencil_op(operation, sample.stencil, *reference), *write_mask);
        }
        if !(stencil_passes && depth_passes) {
            return (false, after);
        }
        if self.depth.1 {
            after.depth = depth;
        }
        let bytes = |Color { r, g, b, a }: Color| [r, g, b, a];
        let (from, old) = (bytes(source), bytes(sample.color));
        let new: Vec<u8> = (0..4)
            .map(|channel| {
                let written = match &self.logic {
                    Some(operation) => logic(operation, from[channel], old[channel]),
                    None => {
                        let names = self.blend[usize::from(channel == 3)].each_ref().map(String::as_str);
                        rounded(blended(names, channel, source, sample.color, self.constant))
                    }
                };
                if self.mask[channel] { written } else { old[channel] }
            })
            .collect();
        after.color = Color { r: new[0], g: new[1], b: new[2], a: new[3] };
        (true, after)
    }
}

/// What is between the background and a layer after so many layers of one colour and alpha, from 0 to 255, rounded nowhere:
/// s + (d − s)·(1 − α)ⁿ.
#[must_use]
pub fn layered(source: u8, destination: u8, alpha: u8, layers: u32) -> f64 {
    let through = f64::from(255 - alpha) / 255.0;
    let [s, d] = [source, destination].map(f64::from);
    s + (d - s) * through.powf(layers.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_outside_is_clamped() {
        assert_eq!(
            [-400, -1, 0, 127, 128, 255 * 254, 255 * 255, 255 * 400].map(rounded),
            [0, 0, 0, 0, 1, 254, 255, 255]
        );
    }

    #[test]
    fn masks_choose_bits() {
        assert_eq!((masked(0b1010, 0b0101, 0b0110), masked(0, 255, 7)), (0b1100, 7));
    }
}
