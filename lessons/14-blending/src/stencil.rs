//! The second test: a number for each pixel, which fragments are compared with, and which they change.
//!
//! A mask is the simplest stencil: where it is 0, nothing is drawn (notes, *Stencil test*). The general one, OpenGL's, also
//! counts and marks: what becomes of the number hangs on how far a fragment came (OpenGL 4.6, *Stencil Test*).

use crate::compare::Compare;

/// What becomes of a pixel's number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum StencilOp {
    /// It stays.
    Keep,
    /// It becomes 0.
    Zero,
    /// It becomes the reference.
    Replace,
    /// It grows by 1; 255 stays.
    Incr,
    /// It grows by 1, and 255 becomes 0.
    IncrWrap,
    /// It shrinks by 1; 0 stays.
    Decr,
    /// It shrinks by 1, and 0 becomes 255.
    DecrWrap,
    /// Each of its bits is turned over.
    Invert,
}

// ANCHOR: stencil_op
impl StencilOp {
    /// The number that comes of another, with a reference.
    #[inline]
    #[must_use]
    pub fn apply(self, kept: u8, reference: u8) -> u8 {
        match self {
            Self::Keep => kept,
            Self::Zero => 0,
            Self::Replace => reference,
            Self::Incr => kept.saturating_add(1),
            Self::IncrWrap => kept.wrapping_add(1),
            Self::Decr => kept.saturating_sub(1),
            Self::DecrWrap => kept.wrapping_sub(1),
            Self::Invert => !kept,
        }
    }
}
// ANCHOR_END: stencil_op

/// A stencil test, and what becomes of the number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StencilTest {
    /// Passes where the reference, on the left, compares so with the pixel's number.
    pub function: Compare,
    /// What the number is compared with.
    pub reference: u8,
    /// The bits of both that are compared.
    pub read_mask: u8,
    /// The bits of the number that may change.
    pub write_mask: u8,
    /// What becomes of it where the test fails.
    pub fail: StencilOp,
    /// What becomes of it where this test passes and the depth test fails.
    pub depth_fail: StencilOp,
    /// What becomes of it where both pass.
    pub pass: StencilOp,
}

impl StencilTest {
    /// Everything passes, and nothing is changed.
    pub const ALWAYS: Self = Self {
        function: Compare::Always,
        reference: 0,
        read_mask: 255,
        write_mask: 255,
        fail: StencilOp::Keep,
        depth_fail: StencilOp::Keep,
        pass: StencilOp::Keep,
    };

    /// The notes' mask: where a pixel's number is 0, nothing is drawn.
    pub const MASK: Self = Self { function: Compare::Notequal, ..Self::ALWAYS };
}

// ANCHOR: stencil_stage
/// What is done about the stencil: nothing, for `()`; a test; or what is decided when the program runs.
pub trait StencilStage: Copy {
    /// What each pixel keeps for it.
    type Kept: Copy + Default;

    /// Whether a fragment passes this test, and the depth test, which is asked only where this one is passed. What the pixel
    /// keeps changes by how far it came.
    fn test(self, kept: &mut Self::Kept, depth: impl FnOnce() -> bool) -> bool;
}

impl StencilStage for () {
    type Kept = ();

    #[inline]
    fn test(self, (): &mut (), depth: impl FnOnce() -> bool) -> bool {
        depth()
    }
}
// ANCHOR_END: stencil_stage

// ANCHOR: stencil_test
impl StencilStage for StencilTest {
    type Kept = u8;

    #[inline]
    fn test(self, kept: &mut u8, depth: impl FnOnce() -> bool) -> bool {
        let Self { function, reference, read_mask, write_mask, fail, depth_fail, pass } = self;
        let before = *kept;
        let after = |op: StencilOp| (before & !write_mask) | (op.apply(before, reference) & write_mask);
        if !function.passes(reference & read_mask, before & read_mask) {
            *kept = after(fail);
            return false;
        }
        let passes = depth();
        *kept = after(if passes { pass } else { depth_fail });
        passes
    }
}
// ANCHOR_END: stencil_test

impl<S: StencilStage> StencilStage for Option<S> {
    type Kept = S::Kept;

    #[inline]
    fn test(self, kept: &mut S::Kept, depth: impl FnOnce() -> bool) -> bool {
        match self {
            None => depth(),
            Some(stencil) => stencil.test(kept, depth),
        }
    }
}
