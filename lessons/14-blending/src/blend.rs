//! Blending: what comes and what is there become one colour.
//!
//! *Source* is the fragment's colour, *destination* the pixel's. Each is multiplied by a factor, and an equation puts the two
//! together, for the three colours in one way, for alpha in another if so wished (notes and OpenGL 4.6, *Blending*).

use std::marker::PhantomData;

use common::Color;

use crate::division::{Division, TwoShift};
use crate::logic::LogicOp;

// ANCHOR: blend_stage
/// What is done with the two colours: the source replaces the destination, for `()`; or they are combined.
pub trait BlendStage: Copy {
    /// The colour that comes of the two.
    fn color(self, source: Color, destination: Color) -> Color;
}

impl BlendStage for () {
    #[inline]
    fn color(self, source: Color, _: Color) -> Color {
        source
    }
}

impl<B: BlendStage> BlendStage for Option<B> {
    #[inline]
    fn color(self, source: Color, destination: Color) -> Color {
        self.map_or(source, |blend| blend.color(source, destination))
    }
}
// ANCHOR_END: blend_stage

/// A layer over what is there: the source counts by its alpha, the destination by the rest.
///
/// Alpha itself is the share of light that both together hold back: αs + αd·(1 − αs), so that what was opaque stays opaque.
#[derive(Clone, Copy, Debug, Default)]
pub struct Over<D = TwoShift>(pub D);

// ANCHOR: over
impl<D: Division> BlendStage for Over<D> {
    #[inline]
    fn color(self, source: Color, destination: Color) -> Color {
        let mix = |source, destination, alpha| D::mix(source, destination, alpha);
        Color {
            r: mix(source.r, destination.r, source.a),
            g: mix(source.g, destination.g, source.a),
            b: mix(source.b, destination.b, source.a),
            a: mix(255, destination.a, source.a),
        }
    }
}
// ANCHOR_END: over

/// What a channel is multiplied by, in 255ths.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Factor {
    /// 0.
    Zero,
    /// 255.
    One,
    /// The source's channel.
    SrcColor,
    /// 255 less that.
    OneMinusSrcColor,
    /// The destination's channel.
    DstColor,
    /// 255 less that.
    OneMinusDstColor,
    /// The source's alpha.
    SrcAlpha,
    /// 255 less that.
    OneMinusSrcAlpha,
    /// The destination's alpha.
    DstAlpha,
    /// 255 less that.
    OneMinusDstAlpha,
    /// The constant colour's channel.
    ConstantColor,
    /// 255 less that.
    OneMinusConstantColor,
    /// The constant colour's alpha.
    ConstantAlpha,
    /// 255 less that.
    OneMinusConstantAlpha,
    /// The source's alpha, but no more than is left of the destination's; 255 for alpha itself.
    SrcAlphaSaturate,
}

// ANCHOR: factor
impl Factor {
    /// The factor of each channel.
    #[inline]
    #[must_use]
    pub fn of(self, source: Color, destination: Color, constant: Color) -> Color {
        let all = |a: u8| Color { r: a, g: a, b: a, a };
        let rest = |Color { r, g, b, a }: Color| Color { r: 255 - r, g: 255 - g, b: 255 - b, a: 255 - a };
        match self {
            Self::Zero => all(0),
            Self::One => all(255),
            Self::SrcColor => source,
            Self::OneMinusSrcColor => rest(source),
            Self::DstColor => destination,
            Self::OneMinusDstColor => rest(destination),
            Self::SrcAlpha => all(source.a),
            Self::OneMinusSrcAlpha => all(255 - source.a),
            Self::DstAlpha => all(destination.a),
            Self::OneMinusDstAlpha => all(255 - destination.a),
            Self::ConstantColor => constant,
            Self::OneMinusConstantColor => rest(constant),
            Self::ConstantAlpha => all(constant.a),
            Self::OneMinusConstantAlpha => all(255 - constant.a),
            Self::SrcAlphaSaturate => Color { a: 255, ..all(source.a.min(255 - destination.a)) },
        }
    }
}
// ANCHOR_END: factor

/// How the two are put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Equation {
    /// s·f + d·g.
    FuncAdd,
    /// s·f − d·g.
    #[value(alias = "subtract")]
    FuncSubtract,
    /// d·g − s·f.
    #[value(alias = "reverse-subtract")]
    FuncReverseSubtract,
    /// The smaller of s and d; factors do not count.
    Min,
    /// The larger of s and d; factors do not count.
    Max,
}

// ANCHOR: equation
impl Equation {
    /// A channel of the source, its factor, one of the destination, its factor.
    #[inline]
    #[must_use]
    pub fn apply<D: Division>(self, s: u8, f: u8, d: u8, g: u8) -> u8 {
        match self {
            Self::FuncAdd => D::channel(D::product(s, f) + D::product(d, g)),
            Self::FuncSubtract => D::channel(D::product(s, f) - D::product(d, g)),
            Self::FuncReverseSubtract => D::channel(D::product(d, g) - D::product(s, f)),
            Self::Min => s.min(d),
            Self::Max => s.max(d),
        }
    }
}
// ANCHOR_END: equation

/// An equation and its two factors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Formula {
    /// How the two are put together.
    pub equation: Equation,
    /// What the source is multiplied by.
    pub source: Factor,
    /// What the destination is multiplied by.
    pub destination: Factor,
}

/// Any blending, decided when the program runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Blend {
    /// For red, green and blue.
    pub color: Formula,
    /// For alpha.
    pub alpha: Formula,
    /// What the constant factors mean.
    pub constant: Color,
}

impl Blend {
    /// As [`Over`].
    pub const OVER: Self = Self {
        color: Formula {
            equation: Equation::FuncAdd,
            source: Factor::SrcAlpha,
            destination: Factor::OneMinusSrcAlpha,
        },
        alpha: Formula {
            equation: Equation::FuncAdd,
            source: Factor::One,
            destination: Factor::OneMinusSrcAlpha,
        },
        // What OpenGL has before it is told.
        constant: Color { r: 0, g: 0, b: 0, a: 0 },
    };

    /// The colour that comes of the two, by one of the ways to divide.
    // ANCHOR: blend
    #[inline]
    #[must_use]
    pub fn by<D: Division>(&self, source: Color, destination: Color) -> Color {
        let factors = |formula: Formula| {
            let factor = |factor: Factor| factor.of(source, destination, self.constant);
            (formula.equation, factor(formula.source), factor(formula.destination))
        };
        let ((equation, f, g), (equation_a, f_a, g_a)) = (factors(self.color), factors(self.alpha));
        Color {
            r: equation.apply::<D>(source.r, f.r, destination.r, g.r),
            g: equation.apply::<D>(source.g, f.g, destination.g, g.g),
            b: equation.apply::<D>(source.b, f.b, destination.b, g.b),
            a: equation_a.apply::<D>(source.a, f_a.a, destination.a, g_a.a),
        }
    }
    // ANCHOR_END: blend
}

impl BlendStage for Blend {
    #[inline]
    fn color(self, source: Color, destination: Color) -> Color {
        self.by::<TwoShift>(source, destination)
    }
}

/// Blending or, where there is one, a logic operation in its place: what a command line says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlendOrLogic<D = TwoShift> {
    /// The blending.
    pub blend: Blend,
    /// What turns it off. (OpenGL 4.6, *Logical Operation*: an enabled logic operation is as if blending were disabled.)
    pub logic: Option<LogicOp>,
    /// How it divides.
    pub division: PhantomData<D>,
}

impl<D: Division> BlendStage for BlendOrLogic<D> {
    #[inline]
    fn color(self, source: Color, destination: Color) -> Color {
        match self.logic {
            Some(logic) => logic.color(source, destination),
            None => self.blend.by::<D>(source, destination),
        }
    }
}
