//! The last operation: which channels are written.

use std::str::FromStr;

use common::Color;

/// What is done about the write mask: nothing, for `()`; a mask; or what is decided when the program runs.
pub trait MaskStage: Copy {
    /// What a pixel keeps, of what would be written and what is there.
    fn color(self, written: Color, destination: Color) -> Color;
}

impl MaskStage for () {
    #[inline]
    fn color(self, written: Color, _: Color) -> Color {
        written
    }
}

/// The channels that are written; the others stay as they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WriteMask {
    /// Red.
    pub r: bool,
    /// Green.
    pub g: bool,
    /// Blue.
    pub b: bool,
    /// Alpha.
    pub a: bool,
}

impl WriteMask {
    /// All are written.
    pub const ALL: Self = Self { r: true, g: true, b: true, a: true };
    /// None is: only depths and stencil change.
    pub const NOTHING: Self = Self { r: false, g: false, b: false, a: false };
}

// ANCHOR: mask
impl MaskStage for WriteMask {
    #[inline]
    fn color(self, written: Color, destination: Color) -> Color {
        let choose = |write: bool, new: u8, old: u8| if write { new } else { old };
        Color {
            r: choose(self.r, written.r, destination.r),
            g: choose(self.g, written.g, destination.g),
            b: choose(self.b, written.b, destination.b),
            a: choose(self.a, written.a, destination.a),
        }
    }
}
// ANCHOR_END: mask

impl<M: MaskStage> MaskStage for Option<M> {
    #[inline]
    fn color(self, written: Color, destination: Color) -> Color {
        self.map_or(written, |mask| mask.color(written, destination))
    }
}

impl FromStr for WriteMask {
    type Err = String;

    /// Reads the letters of the channels that are written, as `rgba`, in any order; an empty word writes nothing.
    fn from_str(text: &str) -> Result<Self, String> {
        let mut mask = Self::NOTHING;
        for letter in text.chars() {
            let channel = match letter {
                'r' => &mut mask.r,
                'g' => &mut mask.g,
                'b' => &mut mask.b,
                'a' => &mut mask.a,
                _ => return Err("write the letters of channels that are written, as in rgba".into()),
            };
            if std::mem::replace(channel, true) {
                return Err(format!("`{letter}` stands there twice"));
            }
        }
        Ok(mask)
    }
}
