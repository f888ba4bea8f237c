//! A texture with alpha, filtered and laid over a colour, in `f64`, rounded nowhere.

use common::{Color, DVec2, Image};

use crate::footprint::{Outside, Texture, code, light};

/// A picture with straight alpha, made ready to be filtered.
pub struct Cutout {
    colors: Texture,
    alphas: Texture,
    linear: bool,
    premultiplied: bool,
}

impl Cutout {
    /// What is mixed is light where `linear`, else codes; the filter's means are of colours times their alpha where
    /// `premultiplied`, else of colours. The truth is both.
    #[must_use]
    pub fn new(image: &Image, linear: bool, premultiplied: bool) -> Self {
        let share = |alpha: u8| f64::from(alpha) / 255.0;
        let numbers = |Color { r, g, b, a }: Color| {
            let times = if premultiplied { share(a) } else { 1.0 };
            [r, g, b].map(|code| times * decoded(code, linear))
        };
        let colors = Texture::of(image, Outside::Border, numbers);
        let alphas = Texture::of(image, Outside::Border, |color| [share(color.a); 3]);
        Self { colors, alphas, linear, premultiplied }
    }

    /// The codes, from 0 to 255, of what is seen at (u, v) over an opaque colour.
    #[must_use]
    pub fn over(&self, uv: DVec2, below: Color) -> [f64; 3] {
        let [alpha, ..] = self.alphas.at(uv);
        let times = if self.premultiplied { 1.0 } else { alpha };
        let colors = self.colors.at(uv);
        let below = [below.r, below.g, below.b].map(|code| decoded(code, self.linear));
        [0, 1, 2].map(|n| {
            let seen = times * colors[n] + (1.0 - alpha) * below[n];
            if self.linear { code(seen) } else { 255.0 * seen }
        })
    }
}

/// From 0 to 1.
fn decoded(code: u8, linear: bool) -> f64 {
    if linear { light(code.into()) } else { f64::from(code) / 255.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use common::Format;

    /// Between a green texel and one that is not there, over white: half of the green, and half of the white.
    #[test]
    fn what_is_not_there_is_seen_in_straight_colours_only() {
        let mut image = Image::new(2, 1, Format::Rgba);
        image.set(0, 0, Color::GREEN);
        let seen = |linear, premultiplied| {
            Cutout::new(&image, linear, premultiplied).over(DVec2::splat(0.5), Color::WHITE)
        };
        assert_eq!(seen(false, true), [127.5, 255.0, 127.5]);
        assert_eq!(seen(false, false), [127.5, 191.25, 127.5]);
        let [[half, ..], [.., dark]] = [seen(true, true), seen(true, false)];
        assert!((half - 187.516).abs() < 1e-3 && (dark - half).abs() < 1e-9, "{half} {dark}");
        let [[_, full, _], [_, fringe, _]] = [seen(true, true), seen(true, false)];
        assert!((full - 255.0).abs() < 1e-3 && (fringe - code(0.75)).abs() < 1e-9, "{full} {fringe}");
    }
}
