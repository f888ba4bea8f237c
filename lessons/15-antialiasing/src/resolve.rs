//! From the samples of a pixel to its colour.

use common::{Color, Method, Vec4};
use filtering::light::SRGB;

/// The colour of a pixel with these samples, of which there is at least one.
pub type Resolve = fn(&[Color]) -> Color;

/// The ways to make one colour of several.
pub const RESOLVES: &[Method<Resolve>] = &[
    Method {
        name: "encoded",
        run: resolve,
        promise: "the mean of the codes: whole numbers alone, as hardware does it for pictures not declared sRGB",
        failure: "half a white pixel on black has the code 128, which is a fifth of the light: bright edges are too thin",
    },
    Method {
        name: "linear",
        run: resolve_linear,
        promise: "the mean of the light, encoded: half a white pixel on black sends out half the light, the code 188",
        failure: "each sample is decoded; steps from black to white are even in light, not to the eye: dark edges look thin",
    },
];

// ANCHOR: resolve
/// The mean of each channel's codes, alpha too, rounded to nearest, halves up.
///
/// # Panics
/// Where there is no sample.
#[must_use]
pub fn resolve(samples: &[Color]) -> Color {
    let mut sums = [0; 4];
    for &Color { r, g, b, a } in samples {
        for (sum, code) in sums.iter_mut().zip([r, g, b, a]) {
            *sum += u32::from(code);
        }
    }
    let count = samples.len() as u32;
    let [r, g, b, a] = sums.map(|sum| ((2 * sum + count) / (2 * count)) as u8);
    Color { r, g, b, a }
}
// ANCHOR_END: resolve

// ANCHOR: resolve_linear
/// The colour of the mean of the samples' light, by lesson 13's tables; alpha is no light, and its mean that of its codes.
#[must_use]
pub fn resolve_linear(samples: &[Color]) -> Color {
    let light: Vec4 = samples.iter().map(|&color| SRGB.light(color)).sum();
    SRGB.color(light / samples.len() as f32)
}
// ANCHOR_END: resolve_linear
