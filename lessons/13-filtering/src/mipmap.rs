//! Smaller and smaller pictures of a texture, down to one texel.
//!
//! Each side of a level is half as long as before, rounded down, but at least 1. Where it was odd, 2m + 1 texels become m,
//! and each of them covers more than two: with shares of (m − i)/(2m + 1), m/(2m + 1) and (i + 1)/(2m + 1) of three
//! neighbours, texel i is the mean of just what it covers (S. Guthe and P. Heckbert, *Non-power-of-two mipmap creation*,
//! NVIDIA, 2005). Leaving the last column out instead, as ⌊n/2⌋ pairs, would lose what is in it, and shift all else.
//!
//! Each level is computed from the one before, as it was before its light was rounded to codes.

use std::f64::consts::PI;

use common::{Format, Image, Method, Vec4};

use crate::light::{Codes, ENCODED, SRGB};
use crate::texture::Texture;
use crate::wrap::Wrap;

/// The ways to make smaller levels, from the first idea to the last.
pub const MIPMAPS: &[Method<Mipmap>] = &[
    Method {
        name: "box-encoded",
        run: Mipmap { codes: &ENCODED, taps: box_taps },
        promise: "the mean of what a texel covers, of its codes: whole numbers and nothing to decode",
        failure: "codes are no amounts of light: black and white checks become 128 instead of 188, half as much light",
    },
    Method {
        name: "box-linear",
        run: Mipmap { codes: &SRGB, taps: box_taps },
        promise: "the mean of the light of what a texel covers: as much of it on every level",
        failure: "what is a little finer than texels still shows, in a false pattern; edges get soft",
    },
    Method {
        name: "lanczos-linear",
        run: Mipmap { codes: &SRGB, taps: lanczos_taps },
        promise: "of light, too, by a windowed sinc: lets pass what the level can show, and less of what it cannot",
        failure: "rings: a dark rim beside what is bright; looks beyond the border, and must know what the texture is there",
    },
];

/// A way to make smaller levels.
#[derive(Clone, Copy)]
pub struct Mipmap {
    /// What codes mean.
    pub codes: &'static Codes,
    /// What of n texels each of ⌊n/2⌋, or 1, is made of.
    taps: fn(usize, Wrap) -> Vec<Taps>,
}

/// Texels with their weights, which sum to 1.
type Taps = Vec<(usize, f64)>;

impl Mipmap {
    /// A picture with all its levels. A picture without pixels is one black texel.
    #[must_use]
    pub fn texture(&self, image: &Image, wrap: Wrap) -> Texture {
        Texture::of_levels(&self.levels(image, wrap), wrap, self.codes)
    }

    /// A picture and all its smaller ones, down to 1×1. `wrap` says what is beyond the border, for those that look there.
    // ANCHOR: levels
    #[must_use]
    pub fn levels(&self, image: &Image, wrap: Wrap) -> Vec<Image> {
        let light = image.pixels().map(|(_, _, color)| self.codes.light(color)).collect();
        let mut plane = Plane { width: image.width() as usize, light };
        let mut levels = vec![image.clone()];
        while plane.light.len() > 1 {
            plane = plane.halved(self.taps, wrap);
            levels.push(plane.image(self.codes));
        }
        levels
    }
    // ANCHOR_END: levels
}

/// A picture's light, in rows from the bottom.
struct Plane {
    width: usize,
    light: Vec<Vec4>,
}

impl Plane {
    /// Half as wide, then half as high. What a texel is made of is the same in all rows, and in all columns.
    // ANCHOR: halved
    fn halved(&self, taps: fn(usize, Wrap) -> Vec<Taps>, wrap: Wrap) -> Self {
        let columns = taps(self.width, wrap);
        let width = columns.len();
        let sum = |row: &[Vec4], taps: &Taps| taps.iter().map(|&(i, weight)| row[i] * weight as f32).sum();
        let narrow: Vec<Vec4> = self
            .light
            .chunks_exact(self.width)
            .flat_map(|row| columns.iter().map(move |taps| sum(row, taps)))
            .collect();
        let mut light = Vec::new();
        for taps in taps(self.light.len() / self.width, wrap) {
            let column =
                |x: usize| taps.iter().map(|&(j, weight)| narrow[j * width + x] * weight as f32).sum();
            light.extend((0..width).map(column).collect::<Vec<Vec4>>());
        }
        Self { width, light }
    }
    // ANCHOR_END: halved

    fn image(&self, codes: &Codes) -> Image {
        let mut image = Image::new(self.width as u16, (self.light.len() / self.width) as u16, Format::Rgba);
        for (n, &light) in self.light.iter().enumerate() {
            image.set((n % self.width) as i32, (n / self.width) as i32, codes.color(light));
        }
        image
    }
}

// ANCHOR: box_taps
/// Each texel is the mean of what it covers: of m texels in the place of n, texel i covers n/m of them, from i·n/m on. In
/// m-ths of a texel all these are whole numbers.
fn box_taps(n: usize, _: Wrap) -> Vec<Taps> {
    let m = (n / 2).max(1);
    let taps = |i: usize| {
        let (from, to) = (i * n, (i + 1) * n);
        let covered = |j: usize| (to.min((j + 1) * m) - from.max(j * m)) as f64;
        (from / m..to.div_ceil(m)).map(|j| (j, covered(j) / n as f64)).collect()
    };
    (0..m).map(taps).collect()
}
// ANCHOR_END: box_taps

// ANCHOR: lanczos_taps
/// How far the kernel reaches to either side, in texels of the smaller level.
const REACH: f64 = 3.0;

/// Weights by sinc(x)·sinc(x/3), x the distance from the texel's centre in texels of the smaller level (C. E. Duchon,
/// *Lanczos filtering in one and two dimensions*, Journal of Applied Meteorology 18, 1979).
fn lanczos_taps(n: usize, wrap: Wrap) -> Vec<Taps> {
    let m = (n / 2).max(1);
    let scale = n as f64 / m as f64;
    let sinc = |x: f64| if x == 0.0 { 1.0 } else { libm::sin(PI * x) / (PI * x) };
    let taps = |i: usize| {
        let center = (i as f64 + 0.5) * scale;
        let ends = [center - REACH * scale, center + REACH * scale].map(|end| end.round() as i64);
        let weight = |j: i64| {
            let x = (j as f64 + 0.5 - center) / scale;
            sinc(x) * sinc(x / REACH)
        };
        let whole: f64 = (ends[0]..ends[1]).map(weight).sum();
        (ends[0]..ends[1]).map(|j| (wrap.any_texel(j, n as i64) as usize, weight(j) / whole)).collect()
    };
    if n == 1 { box_taps(n, wrap) } else { (0..m).map(taps).collect() }
}
// ANCHOR_END: lanczos_taps
