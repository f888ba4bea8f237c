//! The first test: a rectangle of the picture, outside of which nothing is drawn.

use common::{Bounds, IVec2};

// ANCHOR: stage
/// What is done about the scissor: nothing, for `()`; a rectangle's test; or what is decided when the program runs.
pub trait ScissorStage: Copy {
    /// Whether a pixel may be drawn to.
    fn contains(self, at: IVec2) -> bool;
}

impl ScissorStage for () {
    #[inline]
    fn contains(self, _: IVec2) -> bool {
        true
    }
}

impl ScissorStage for Bounds {
    #[inline]
    fn contains(self, at: IVec2) -> bool {
        Bounds::contains(self, at.x, at.y)
    }
}

impl<S: ScissorStage> ScissorStage for Option<S> {
    #[inline]
    fn contains(self, at: IVec2) -> bool {
        self.is_none_or(|scissor| scissor.contains(at))
    }
}
// ANCHOR_END: stage
