//! The third test: a fragment's depth against that of what is seen.

use crate::compare::Compare;

/// What is done about depth: nothing, for `()`; lessons 10 to 13's test, for [`Less`]; or any other.
pub trait DepthStage: Copy {
    /// Whether a fragment of that depth passes, where a pixel has that one.
    fn passes(self, depth: f32, kept: f32) -> bool;

    /// Whether a pixel keeps the depth of what passed.
    fn writes(self) -> bool;
}

/// Everything passes, and no depth is kept.
impl DepthStage for () {
    #[inline]
    fn passes(self, _: f32, _: f32) -> bool {
        true
    }

    #[inline]
    fn writes(self) -> bool {
        false
    }
}

/// What is nearer passes, and its depth is kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Less;

impl DepthStage for Less {
    #[inline]
    fn passes(self, depth: f32, kept: f32) -> bool {
        depth < kept
    }

    #[inline]
    fn writes(self) -> bool {
        true
    }
}

// ANCHOR: depth_test
/// A depth test that is decided when the program runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DepthTest {
    /// Passes where the fragment's depth, on the left, compares so with the pixel's.
    pub function: Compare,
    /// Whether the pixel keeps the depth of what passed.
    pub write: bool,
}

impl DepthStage for DepthTest {
    #[inline]
    fn passes(self, depth: f32, kept: f32) -> bool {
        self.function.passes(depth, kept)
    }

    #[inline]
    fn writes(self) -> bool {
        self.write
    }
}
// ANCHOR_END: depth_test

impl<D: DepthStage> DepthStage for Option<D> {
    #[inline]
    fn passes(self, depth: f32, kept: f32) -> bool {
        self.is_none_or(|test| test.passes(depth, kept))
    }

    #[inline]
    fn writes(self) -> bool {
        self.is_some_and(DepthStage::writes)
    }
}
