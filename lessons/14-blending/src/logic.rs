//! The sixteen logic operations: each bit of the result hangs on one bit of the source and one of the destination.

use common::Color;

use crate::blend::BlendStage;

// ANCHOR: logic
/// A logic operation. With four pairs of bits there are sixteen of them. (OpenGL 4.6, *Logical Operation*.)
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum LogicOp {
    /// All bits 0.
    Clear,
    /// s and d.
    And,
    /// s and not d.
    AndReverse,
    /// s.
    Copy,
    /// d and not s.
    AndInverted,
    /// d.
    Noop,
    /// Either s or d.
    Xor,
    /// s or d.
    Or,
    /// Neither s nor d.
    Nor,
    /// Both s and d, or none.
    Equiv,
    /// Not d.
    Invert,
    /// s or not d.
    OrReverse,
    /// Not s.
    CopyInverted,
    /// d or not s.
    OrInverted,
    /// Not both s and d.
    Nand,
    /// All bits 1.
    Set,
}

impl LogicOp {
    /// Of each bit of two numbers.
    #[inline]
    #[must_use]
    pub fn apply(self, s: u32, d: u32) -> u32 {
        match self {
            Self::Clear => 0,
            Self::And => s & d,
            Self::AndReverse => s & !d,
            Self::Copy => s,
            Self::AndInverted => !s & d,
            Self::Noop => d,
            Self::Xor => s ^ d,
            Self::Or => s | d,
            Self::Nor => !(s | d),
            Self::Equiv => !(s ^ d),
            Self::Invert => !d,
            Self::OrReverse => s | !d,
            Self::CopyInverted => !s,
            Self::OrInverted => !s | d,
            Self::Nand => !(s & d),
            Self::Set => u32::MAX,
        }
    }
}

impl BlendStage for LogicOp {
    /// All four channels at once.
    #[inline]
    fn color(self, source: Color, destination: Color) -> Color {
        let bits = |Color { r, g, b, a }: Color| u32::from_le_bytes([r, g, b, a]);
        let [r, g, b, a] = self.apply(bits(source), bits(destination)).to_le_bytes();
        Color { r, g, b, a }
    }
}
// ANCHOR_END: logic
