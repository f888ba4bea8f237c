//! How the colours of samples are kept.

use std::slice;

use common::Color;

use crate::coverage::all;

/// The colours of `N` samples in each pixel.
// ANCHOR: storage
pub trait Storage<const N: usize> {
    /// For so many pixels, all black.
    fn new(pixels: usize) -> Self;

    /// Gives all samples that colour.
    fn clear(&mut self, color: Color);

    /// Changes the colours of those samples of a pixel whose bits are set; `change` makes the new colour of the old one, and
    /// of equal ones equal ones.
    fn change(&mut self, pixel: usize, samples: u32, change: impl FnMut(Color) -> Color);

    /// The colours of a pixel's samples; a single one where all are known to have it.
    fn colors(&self, pixel: usize) -> &[Color];
}
// ANCHOR_END: storage

/// A colour for each sample.
#[derive(Clone, Debug)]
pub struct Samples<const N: usize>(Vec<[Color; N]>);

/// Changes those of a pixel's colours whose bits are set.
#[inline]
fn change_samples<const N: usize>(
    colors: &mut [Color; N],
    samples: u32,
    mut change: impl FnMut(Color) -> Color,
) {
    for (s, color) in colors.iter_mut().enumerate() {
        // Chosen, not branched to: which samples an edge covers is hard to predict.
        let changed = change(*color);
        *color = if samples >> s & 1 == 1 { changed } else { *color };
    }
}

impl<const N: usize> Storage<N> for Samples<N> {
    fn new(pixels: usize) -> Self {
        Self(vec![[Color::BLACK; N]; pixels])
    }

    fn clear(&mut self, color: Color) {
        self.0.fill([color; N]);
    }

    #[inline]
    fn change(&mut self, pixel: usize, samples: u32, change: impl FnMut(Color) -> Color) {
        change_samples(&mut self.0[pixel], samples, change);
    }

    #[inline]
    fn colors(&self, pixel: usize) -> &[Color] {
        &self.0[pixel]
    }
}

/// One colour in a pixel whose samples all have it, which is most of them: where one triangle covers the pixel whole. The
/// others, at the edges, have a place for each sample. So hardware saves time, not memory: any pixel may come to need its
/// places.
#[derive(Clone, Debug)]
pub struct Compressed<const N: usize> {
    /// The colour of a pixel that has one.
    one: Vec<Color>,
    /// The colours of a pixel that has several.
    several: Vec<[Color; N]>,
    /// Which of the two it is.
    has_several: Vec<bool>,
}

// ANCHOR: compressed
impl<const N: usize> Storage<N> for Compressed<N> {
    fn new(pixels: usize) -> Self {
        let several = vec![[Color::BLACK; N]; pixels];
        Self { one: vec![Color::BLACK; pixels], several, has_several: vec![false; pixels] }
    }

    fn clear(&mut self, color: Color) {
        self.one.fill(color);
        self.has_several.fill(false);
    }

    #[inline]
    fn change(&mut self, pixel: usize, samples: u32, mut change: impl FnMut(Color) -> Color) {
        let one = &mut self.one[pixel];
        let has_several = &mut self.has_several[pixel];
        if samples == all::<N>() && !*has_several {
            *one = change(*one);
            return;
        }
        let several = &mut self.several[pixel];
        if !*has_several {
            *several = [*one; N];
        }
        change_samples(several, samples, change);
        *one = several[0];
        // All samples at once, as numbers: where the first differs is hard to predict, too.
        let bits = |&Color { r, g, b, a }: &Color| u32::from_ne_bytes([r, g, b, a]);
        *has_several = several.iter().fold(0, |sum, color| sum | (bits(color) ^ bits(one))) != 0;
    }

    #[inline]
    fn colors(&self, pixel: usize) -> &[Color] {
        if self.has_several[pixel] { &self.several[pixel] } else { slice::from_ref(&self.one[pixel]) }
    }
}
// ANCHOR_END: compressed
