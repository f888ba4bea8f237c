//! In which numbers colours are mixed, and where a colour's alpha is.
//!
//! **Codes or light.** Half of one layer's light and half of another's is what one sees through a fine grid, or a pane. A mean
//! of codes is less light than that: see lesson 13. Most pictures on screens are mixed in codes all the same, by habit.
//!
//! **Straight or premultiplied.** A straight colour is that of the thing, whatever its alpha; where there is no thing, alpha is
//! 0 and the colour anything, mostly black. A filter takes the mean of colours and that of alphas each by itself, so that at a
//! cut-out's border the black that nobody sees is mixed in, and seen. Premultiplied, a channel is already what the layer adds:
//! what is not there adds nothing, and means of these numbers are right (T. Porter and T. Duff, *Compositing digital images*,
//! SIGGRAPH 1984).

use common::{Color, Format, Image, Method, Vec4, Vec4Swizzles};
use filtering::light::{Codes, ENCODED, SRGB};
use filtering::{Texture, Wrap};

use crate::blend::BlendStage;

/// What colours with an alpha are, for a texture, its filter, and the layer that is made of it.
#[derive(Clone, Copy)]
pub struct Space {
    /// What codes mean where they are mixed.
    pub codes: &'static Codes,
    /// Whether colours are kept multiplied by their alpha.
    pub premultiplied: bool,
}

/// The ways to keep and to mix colours with an alpha.
pub const SPACES: &[Method<Space>] = &[
    Method {
        name: "encoded-straight",
        run: Space { codes: &ENCODED, premultiplied: false },
        promise: "colours as files have them, mixed as they are: nothing to prepare, nothing to decode",
        failure: "a filtered cut-out gets a dark fringe; half of white over black is 128, a fifth of white's light",
    },
    Method {
        name: "encoded-premultiplied",
        run: Space { codes: &ENCODED, premultiplied: true },
        promise: "what is not there weighs nothing in a filter: no fringe of it; one product less a layer",
        failure: "codes are no amounts of light, so soft edges are still too dark; a low alpha leaves a colour few codes",
    },
    Method {
        name: "linear-straight",
        run: Space { codes: &SRGB, premultiplied: false },
        promise: "mixes light: half of white over black is 188, as a fine grid of both looks",
        failure: "the dark fringe; each layer is decoded and encoded again",
    },
    Method {
        name: "linear-premultiplied",
        run: Space { codes: &SRGB, premultiplied: true },
        promise: "light, and no fringe: what a filter should see and a layer should let through",
        failure: "decodes and encodes; a texture must be prepared, and its channels mean nothing without its alpha",
    },
];

impl Space {
    /// A straight colour as this space keeps it, rounded to codes.
    // ANCHOR: stored
    #[must_use]
    pub fn stored(&self, straight: Color) -> Color {
        let light = self.codes.light(straight);
        let share = if self.premultiplied { light.w / 255.0 } else { 1.0 };
        self.codes.color((light.xyz() * share).extend(light.w))
    }

    /// A picture with straight alpha as a texture of this space, ready to be filtered.
    #[must_use]
    pub fn texture(&self, image: &Image, wrap: Wrap) -> Texture {
        let mut stored = Image::new(image.width() as u16, image.height() as u16, Format::Rgba);
        image.pixels().for_each(|(x, y, color)| stored.set(x, y, self.stored(color)));
        Texture::new(&stored, wrap, self.codes)
    }
    // ANCHOR_END: stored
}

// ANCHOR: space_over
/// A layer, whose colour is as this space keeps it, over what is there. That is opaque, or its colour counts as
/// premultiplied.
impl BlendStage for Space {
    #[inline]
    fn color(self, source: Color, destination: Color) -> Color {
        let [source, destination] = [source, destination].map(|color| self.codes.light(color));
        let alpha = source.w / 255.0;
        let adds = if self.premultiplied { source } else { source * Vec4::new(alpha, alpha, alpha, 1.0) };
        self.codes.color(adds + destination * (1.0 - alpha))
    }
}
// ANCHOR_END: space_over
