//! What is seen through what: transparent triangles over a picture of opaque ones.
//!
//! To lay one layer over another is no sum: red over green is not green over red. So the layers of a pixel must come in their
//! order, the farthest first, and a depth buffer, which keeps one of them, does not tell it. Here are the ways to get
//! by ([`TRANSPARENCY`]). All of them draw the same list of triangles in the window, of one colour each or [`Placed`] there for any
//! shader of the lessons before, through a target of their own; what is behind the opaque picture is tested away by its depths. How
//! one layer is laid over another is a [`BlendStage`], mostly [`Over`](crate::blend::Over).

mod drawn;
mod list;
mod peeling;
mod placed;
mod sorted;
mod weighted;

use common::{Image, Method};
use zbuffer::DepthBuffer;

use crate::blend::BlendStage;

pub use placed::{Fill, Placed, gather};
pub use weighted::weight;

/// A way to draw what is transparent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transparency {
    /// In the order given.
    Drawn,
    /// Whole triangles in the order of their depths.
    Sorted,
    /// The farthest layer of each pixel, then the next.
    Peeling,
    /// All layers of each pixel, sorted.
    List,
    /// A mean of all layers, the near ones with more weight.
    Weighted,
}

/// The ways to draw what is transparent, from the first idea to the last.
pub const TRANSPARENCY: &[Method<Transparency>] = &[
    Method {
        name: "drawn",
        run: Transparency::Drawn,
        promise: "each triangle over what is there, as it comes: nothing to sort, nothing to keep",
        failure: "right only where the far come before the near; else what is behind lies on top",
    },
    Method {
        name: "sorted",
        run: Transparency::Sorted,
        promise: "whole triangles, by their mean depth, the farthest first: one sort a picture",
        failure: "triangles that cut each other, or cover each other in a circle, have no order; long ones get a wrong one",
    },
    Method {
        name: "peeling",
        run: Transparency::Peeling,
        promise: "layer by layer from the back, whatever the triangles do; two depths and a colour a pixel",
        failure: "draws all triangles once for each layer and once more; of layers at one depth it finds the first only",
    },
    Method {
        name: "list",
        run: Transparency::List,
        promise: "draws once, keeps every layer, sorts them pixel by pixel; of equal depths the last drawn is on top",
        failure: "12 bytes for each fragment, however many there are",
    },
    Method {
        name: "weighted",
        run: Transparency::Weighted,
        promise: "draws once, in any order, 20 bytes a pixel; right for one layer, and how much of the background is seen always is",
        failure: "a mean is no order: a near opaque layer does not hide what is behind; the weights guess from the depth; it mixes codes, in no other space",
    },
];

impl Transparency {
    /// Draws transparent triangles over a picture of what is opaque, of whose depths in the window none is changed: a fragment
    /// is seen where it is nearer. `blend` lays one layer over another; the weighted mean does without.
    ///
    /// # Panics
    /// Where the depths are fewer than the picture's pixels.
    pub fn draw(
        self,
        transparent: &[impl Fill],
        blend: impl BlendStage,
        image: &mut Image,
        depths: &DepthBuffer<f32>,
    ) {
        match self {
            Self::Drawn => drawn::draw(transparent, blend, image, depths),
            Self::Sorted => sorted::draw(transparent, blend, image, depths),
            Self::Peeling => peeling::draw(transparent, blend, image, depths),
            Self::List => list::draw(transparent, blend, image, depths),
            Self::Weighted => weighted::draw(transparent, image, depths),
        }
    }
}
