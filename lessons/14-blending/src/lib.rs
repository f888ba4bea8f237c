//! Lesson 14: what happens to a fragment.
//!
//! **You will see** a large wooden crate, and through a smaller one before it. **New:** a fragment is not yet a pixel.
//! Before shading or after it is tested, by a rectangle, by a number for each pixel, by its depth; what passes is combined with
//! what is there, and only some channels may be written. So one sees through things, if they are drawn in the right order.
//!
//! The job: what happens to a fragment on its way to the picture. [`state`] says it in one small description,
//! whose parts are [`scissor`], [`stencil`], [`depth`], [`blend`] or [`logic`], and [`mask`]; what it leaves out is not in
//! the compiled loop. [`target`] is what fragments are drawn to, tested early or late, [`outputs`] takes several outputs of
//! one shader, [`translucent`] makes any shader's colours let light through. [`division`] has the ways to divide by 255
//! ([`METHODS`]), [`transparency`](mod@transparency) those to draw layers in no order ([`TRANSPARENCY`]), [`space`] those to mix
//! colours ([`SPACES`]). Put to use it is in [`crates`], [`outline`], [`mirror`], [`sheet`], [`glass`] and [`cutout`]. From lesson 9
//! come shaders and targets, from lesson 11 the loop, from lesson 12 the lamp, from lesson 13 the texture: all unchanged.
//!
//! Conventions: as in lesson 13. *Source* is the fragment, *destination* the pixel. Alpha is straight, a colour is not
//! multiplied by it, unless a name says so. What is blended is codes, not light, unless a name says so. A picture without
//! alpha is opaque. A blended channel is the exact result rounded to nearest, and clamped.

pub mod blend;
pub mod compare;
pub mod crates;
pub mod cutout;
pub mod depth;
pub mod division;
pub mod flags;
pub mod glass;
pub mod lamp;
pub mod logic;
pub mod mask;
pub mod mirror;
pub mod outline;
pub mod outputs;
pub mod plain;
pub mod scene;
pub mod scissor;
pub mod sheet;
pub mod space;
pub mod state;
pub mod stencil;
pub mod target;
pub mod translucent;
pub mod transparency;

use std::marker::PhantomData;

use clipping::{Counts, Cull, Drawn};
use common::{Bounds, Color, Image, Lesson, Method, Table};
use zbuffer::Surface;

use division::{Div256, Division, Exact, Float, Shift8};

pub use blend::{Blend, BlendOrLogic, Equation, Factor, Formula, Over};
pub use compare::Compare;
pub use depth::{DepthTest, Less};
pub use division::TwoShift;
pub use logic::LogicOp;
pub use mask::WriteMask;
pub use outputs::{Buffers, Outputs};
pub use space::{SPACES, Space};
pub use state::{Operations, State};
pub use stencil::{StencilOp, StencilTest};
pub use target::{Framebuffer, Late, Replaced};
pub use translucent::{Translucent, faded};
pub use transparency::{TRANSPARENCY, Transparency};

use blend::BlendStage;
use depth::DepthStage;
use scene::{Entity, View};
use stencil::StencilStage;

/// This lesson.
pub const LESSON: Lesson = Lesson {
    number: 14,
    name: "blending",
    title: "Blending",
    job: "what happens to a fragment",
    tables: &[
        Table { name: "", job: "Divide by 255", rows: || Method::rows(METHODS) },
        Table { name: "transparency", job: "Draw what is transparent", rows: || Method::rows(TRANSPARENCY) },
        Table { name: "spaces", job: "Mix colours", rows: || Method::rows(SPACES) },
    ],
};

/// A state that is decided when the program runs.
pub type AnyState<D = TwoShift> =
    State<Option<Bounds>, Option<StencilTest>, DepthTest, BlendOrLogic<D>, WriteMask>;

impl AnyState {
    /// What the program's flags say unless told otherwise: a depth test, and layers over what is there.
    pub const USUAL: Self = Self {
        scissor: None,
        stencil: None,
        depth: DepthTest { function: Compare::Less, write: true },
        blend: BlendOrLogic { blend: Blend::OVER, logic: None, division: PhantomData },
        mask: WriteMask::ALL,
    };
}

/// A framebuffer under such a state.
pub type AnyFramebuffer<'a> = Framebuffer<'a, AnyState>;

/// One way to divide, and what it is compiled into.
pub struct Divide {
    /// Draws entities over a picture, the opaque ones first; compiled for just this, it is timed.
    pub entities: fn(&[Entity], &View, &mut Image) -> Drawn,
    /// Draws entities as they come, under any state, which the framebuffer has.
    pub entities_under: for<'a> fn(AnyFramebuffer<'a>, &[Entity], &View) -> (AnyFramebuffer<'a>, Counts),
    /// Draws triangles in the window likewise.
    pub triangles_under: for<'a> fn(AnyFramebuffer<'a>, &[Surface]) -> AnyFramebuffer<'a>,
    /// The colour that a blending makes of source and destination.
    pub blend: fn(&Blend, Color, Color) -> Color,
    /// Lays a row of colours over one of pixels, each over one; compiled for just this, it is timed.
    pub row: fn(&[Color], &mut [Color]),
    /// What lies between two channels, source and destination: so many 255ths of the source, the rest of the destination.
    pub mix: fn(u8, u8, u8) -> u8,
}

impl Divide {
    const fn new<D: Division>() -> Self {
        Self {
            entities: |entities, view, image| scene::draw(entities, view, Over(D::default()), image),
            entities_under: |target, entities, view| {
                let mut target = divided::<TwoShift, D>(target);
                let mut counts = Counts::default();
                for entity in entities {
                    counts += entity.draw(view, Cull::Back, &mut target);
                }
                (divided(target), counts)
            },
            triangles_under: |target, surfaces| {
                let mut target = divided::<TwoShift, D>(target);
                plain::draw(surfaces, &mut target);
                divided(target)
            },
            blend: |blend, source, destination| blend.by::<D>(source, destination),
            row: |sources, pixels| {
                let over = Over(D::default());
                pixels
                    .iter_mut()
                    .zip(sources)
                    .for_each(|(pixel, &source)| *pixel = over.color(source, *pixel));
            },
            mix: D::mix,
        }
    }
}

/// A framebuffer under the same state, which divides in another way.
fn divided<D: Division, E: Division>(target: Framebuffer<AnyState<D>>) -> Framebuffer<AnyState<E>> {
    let State { scissor, stencil, depth, blend: BlendOrLogic { blend, logic, .. }, mask } = target.state;
    let blend = BlendOrLogic { blend, logic, division: PhantomData };
    target.under(State { scissor, stencil, depth, blend, mask })
}

/// The ways to divide by 255, from the first idea to the last.
pub const METHODS: &[Method<Divide>] = &[
    Method {
        name: "float",
        run: Divide::new::<Float>(),
        promise: "each channel becomes a number from 0 to 1, and back: rounded to nearest",
        failure: "conversions to and fro, for three channels and alpha",
    },
    Method {
        name: "exact",
        run: Divide::new::<Exact>(),
        promise: "whole numbers: 127 is added and the sum divided, rounded to nearest",
        failure: "a division, which compilers make a product of 64 bits of",
    },
    Method {
        name: "two-shift",
        run: Divide::new::<TwoShift>(),
        promise: "rounded to nearest for all sums up to 255², by two additions and two shifts",
        failure: "nothing: what is more than 255² is clamped first",
    },
    Method {
        name: "shift-8",
        run: Divide::new::<Shift8>(),
        promise: "one shift; never too bright",
        failure: "up to 2 too dark: white on white is 254, and layers of alpha 1 are never seen on black",
    },
    Method {
        name: "div-256",
        run: Divide::new::<Div256>(),
        promise: "one shift, right at alpha 0 and 255; a colour on itself stays",
        failure: "off by 1 for one product in eight",
    },
];

/// A layer over what is there: red, green and blue by source alpha and one minus source alpha, alpha by one and one minus
/// source alpha, each rounded to nearest. Alphas are straight.
// ANCHOR: over_function
#[must_use]
pub fn over(source: Color, destination: Color) -> Color {
    Over(TwoShift).color(source, destination)
}
// ANCHOR_END: over_function

/// What a sample keeps besides its colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kept {
    /// Its stencil.
    pub stencil: u8,
    /// The depth of what is seen.
    pub depth: f32,
}

/// Stencil test, then depth test, of a fragment of that depth: whether it is seen, and what the sample keeps afterwards. The
/// stencil changes by how far the fragment came; the depth, where it passed and depths are written.
// ANCHOR: test
#[must_use]
pub fn test(stencil: &StencilTest, depth: &DepthTest, fragment: f32, kept: Kept) -> (bool, Kept) {
    let mut after = kept;
    let passes = stencil.test(&mut after.stencil, || depth.passes(fragment, kept.depth));
    if passes && depth.writes() {
        after.depth = fragment;
    }
    (passes, after)
}
// ANCHOR_END: test
