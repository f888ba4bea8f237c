//! One small description of what happens to a fragment.

use common::{Color, IVec2};

use crate::blend::BlendStage;
use crate::depth::{DepthStage, Less};
use crate::mask::MaskStage;
use crate::scissor::ScissorStage;
use crate::stencil::StencilStage;

// ANCHOR: state
/// What happens to a fragment, in this order. Each part is a type: `()` leaves the operation out, and then it is not in the
/// compiled loop; an `Option` leaves it out or not when the program runs. What the types are unless told otherwise leaves out
/// all but the depth test of lessons 10 to 13.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<Sc = (), St = (), D = Less, B = (), M = ()> {
    /// The rectangle that is drawn to.
    pub scissor: Sc,
    /// The test against a number for each pixel.
    pub stencil: St,
    /// The test against the depth of what is seen.
    pub depth: D,
    /// How source and destination become one: blending, or a logic operation.
    pub blend: B,
    /// The channels that are written.
    pub mask: M,
}
// ANCHOR_END: state

impl State {
    /// Everything left out but that depth test.
    pub const OFF: Self = Self::blending(());
}

impl<B> State<(), (), Less, B> {
    /// Everything left out but the depth test and that blending.
    pub const fn blending(blend: B) -> Self {
        Self { scissor: (), stencil: (), depth: Less, blend, mask: () }
    }
}

// ANCHOR: operations
/// The operations on one sample. They know its values, and no picture.
pub trait Operations: Copy {
    /// What a sample keeps for the stencil.
    type Stencil: Copy + Default;

    /// Scissor, stencil, depth: whether a fragment at a pixel, of that depth, is seen, where the sample has `kept_depth`. The
    /// stencil changes as its test says.
    fn test(&self, at: IVec2, depth: f32, kept_depth: f32, stencil: &mut Self::Stencil) -> bool;

    /// Whether the sample keeps the depth of a fragment that passed.
    fn writes_depth(&self) -> bool;

    /// Blending or logic operation, then the write mask: what the sample's colour becomes.
    fn color(&self, source: Color, destination: Color) -> Color;
}

impl<Sc, St, D, B, M> Operations for State<Sc, St, D, B, M>
where
    Sc: ScissorStage,
    St: StencilStage,
    D: DepthStage,
    B: BlendStage,
    M: MaskStage,
{
    type Stencil = St::Kept;

    #[inline]
    fn test(&self, at: IVec2, depth: f32, kept_depth: f32, stencil: &mut St::Kept) -> bool {
        self.scissor.contains(at) && self.stencil.test(stencil, || self.depth.passes(depth, kept_depth))
    }

    #[inline]
    fn writes_depth(&self) -> bool {
        self.depth.writes()
    }

    #[inline]
    fn color(&self, source: Color, destination: Color) -> Color {
        self.mask.color(self.blend.color(source, destination), destination)
    }
}
// ANCHOR_END: operations
