//! What a texture is outside of itself.

use common::Method;

/// What is found where (u, v) leave the square from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The texel at the border.
    Clamp,
    /// The texture again and again.
    #[default]
    Repeat,
    /// The texture and its mirror image in turn.
    Mirror,
}

/// What a texture can be outside of itself.
pub const WRAPS: &[Method<Wrap>] = &[
    Method {
        name: "clamp",
        run: Wrap::Clamp,
        promise: "the texel at the border, without end; nothing from the opposite border bleeds in",
        failure: "streaks where a surface is larger than its texture",
    },
    Method {
        name: "repeat",
        run: Wrap::Repeat,
        promise: "the texture again and again; filters blend across the border",
        failure: "a seam where the texture does not tile; on one that is no tile, each border gets some of the opposite one",
    },
    Method {
        name: "mirror",
        run: Wrap::Mirror,
        promise: "the texture and its mirror image in turn: no seam, whatever the texture",
        failure: "a pattern with a direction runs back and forth",
    },
];

// ANCHOR: wrap
impl Wrap {
    /// After how many textures all is the same again.
    #[inline]
    #[must_use]
    pub fn period(self) -> i32 {
        if self == Self::Mirror { 2 } else { 1 }
    }

    /// The place, from 0 to the [`period`](Self::period), at which there is the same as at u; NaN counts as 0, and to
    /// `repeat` and `mirror` so does what is infinite.
    #[inline]
    #[must_use]
    pub fn place(self, u: f32) -> f32 {
        match self {
            // NaN is not above 0.
            Self::Clamp if u > 0.0 => u.min(1.0),
            Self::Clamp => 0.0,
            Self::Repeat => fraction(u),
            Self::Mirror => 2.0 * fraction(0.5 * u),
        }
    }

    /// The texel, from 0 to n − 1, that stands for texel i of a row of n, from −1 to as many as there are in a period.
    /// (As Vulkan 1.3 has it in *Wrapping Operation*, where i
    /// may be anything.)
    #[inline]
    #[must_use]
    pub fn texel(self, i: i32, n: i32) -> i32 {
        match self {
            Self::Clamp => i.clamp(0, n - 1),
            Self::Repeat if i < 0 => n - 1,
            Self::Repeat if i >= n => 0,
            Self::Repeat => i,
            // The mirror stands between two texels: n − 1 comes twice in a row, and so does 0.
            Self::Mirror => (if i < n { i } else { 2 * n - 1 - i }).max(0),
        }
    }

    /// The same for any i.
    #[must_use]
    pub fn any_texel(self, i: i64, n: i64) -> i64 {
        match self {
            Self::Clamp => i.clamp(0, n - 1),
            Self::Repeat => i.rem_euclid(n),
            Self::Mirror => {
                let i = i.rem_euclid(2 * n);
                i.min(2 * n - 1 - i)
            }
        }
    }
}
// ANCHOR_END: wrap

/// How much more a number is than the whole one below it: u − ⌊u⌋, but no call of a function for ⌊u⌋, which older processors
/// take. 0 for what is not finite, and 1 where a number is so little below a whole one that the difference is rounded to that.
///
/// Nothing but this last rounding is lost: far out, an `f32` has fewer digits for a place in the texture, but what it has is
/// all there.
#[inline]
fn fraction(u: f32) -> f32 {
    // A float cast cuts off towards 0 and stays within the i32, so that from 2³¹ on, where all numbers are whole, there is a
    // rest, but no fraction.
    let rest = u - u as i32 as f32;
    if rest.abs() < 1.0 { if rest < 0.0 { rest + 1.0 } else { rest } } else { 0.0 }
}
