//! From a picture's codes to light, and back.
//!
//! The codes 0 to 255 of a picture are spaced as the eye tells brightness, not as light: a field of black and white
//! points sends out half the light of white, and the code of that is 188, not 128 (sRGB, IEC 61966-2-1:1999). What
//! averages colours should average light. Hardware does: of a texture that is declared sRGB it decodes each texel
//! before it filters (Vulkan 1.3, *Texel Input Operations*, *Format Conversion*). Here a table
//! does it, as a code has no more than 256 values.
//!
//! Light is counted from 0 to 255 here, so that codes may also be taken for light, as they are.

use common::{Color, Vec4};

/// The light of each code, and the code nearest to a light.
pub struct Codes {
    light: [f32; 256],
    /// For each code the least light that has the next one; after the last there is none, and nothing reaches NaN.
    next: [f32; 256],
    /// The code at the beginning of each 1/16 of light.
    first: [u8; FIRST],
}

/// Sixteenths from 0 to 255; what is more counts to the last. Each holds at most one border between codes: the narrowest of
/// sRGB's are 1/12.92 apart.
const FIRST: usize = 255 * 16;

/// sRGB: codes as all lessons' pictures have them.
pub static SRGB: Codes = Codes::new(true);

/// Codes taken for light: what is averaged so is too dark.
pub static ENCODED: Codes = Codes::new(false);

impl Codes {
    /// The tables are made when this is compiled, by additions, products and quotients alone: they are the same on every
    /// platform.
    const fn new(srgb: bool) -> Self {
        let mut codes = Self { light: [0.0; 256], next: [f32::NAN; 256], first: [255; FIRST] };
        let mut code = 0;
        let mut sixteenth = 0;
        while code < 256 {
            codes.light[code] = light_of(code as f64, srgb) as f32;
            if code < 255 {
                // The border is where the light of half a code more is.
                let border = light_of(code as f64 + 0.5, srgb);
                let rounded = border as f32;
                codes.next[code] = if (rounded as f64) < border { rounded.next_up() } else { rounded };
                while (sixteenth as f32) / 16.0 < codes.next[code] {
                    codes.first[sixteenth] = code as u8;
                    sixteenth += 1;
                }
            }
            code += 1;
        }
        codes
    }

    /// The light of a colour: red, green and blue from 0 to 255. Alpha is no light, and stays what it is.
    // ANCHOR: light
    #[inline]
    #[must_use]
    pub fn light(&self, color: Color) -> Vec4 {
        let Color { r, g, b, a } = color;
        let [r, g, b] = [r, g, b].map(|code| self.light[usize::from(code)]);
        Vec4::new(r, g, b, f32::from(a))
    }
    // ANCHOR_END: light

    /// The colour of a light, each channel the code whose light is seen as nearest: the border between two codes is the
    /// light of what is half-way between them, and has the upper one. What lies outside of 0 to 255 is clamped, NaN is 0.
    // ANCHOR: color
    #[inline]
    #[must_use]
    pub fn color(&self, light: Vec4) -> Color {
        let [r, g, b] = [light.x, light.y, light.z].map(|light| self.code(light));
        Color { r, g, b, a: (light.w + 0.5) as u8 }
    }

    #[inline]
    fn code(&self, light: f32) -> u8 {
        // A float cast turns NaN and what is below 0 into 0.
        let code = self.first[usize::from((light * 16.0) as u16).min(FIRST - 1)];
        code + u8::from(light >= self.next[usize::from(code)])
    }
    // ANCHOR_END: color
}

/// The light of a code, which need not be whole.
const fn light_of(code: f64, srgb: bool) -> f64 {
    let share = code / 255.0;
    if !srgb {
        code
    } else if share <= 0.040_45 {
        code / 12.92
    } else {
        // x to the power of 2.4 is x²·(x²)^(1/5).
        let square = (share + 0.055) / 1.055 * ((share + 0.055) / 1.055);
        255.0 * square * fifth_root(square)
    }
}

/// By Newton's steps for x⁵ = a, from above, for a from 0 to 1.
const fn fifth_root(a: f64) -> f64 {
    let mut x = 1.0;
    let mut step = 0;
    while step < 40 {
        x -= (x - a / (x * x * x * x)) / 5.0;
        step += 1;
    }
    x
}
