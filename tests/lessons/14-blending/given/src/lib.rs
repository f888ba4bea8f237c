//! What mission 14 gives: comparisons, what can be done to a stencil value, and a loop over fragments. Nothing of lesson 14 is in
//! it, so that the program in which a submission runs has nothing of it either.

use common::{Color, Image, Vec2};

/// How two numbers must be to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compare {
    /// However they are.
    Always,
    /// Never mind how they are: no.
    Never,
    /// a < b.
    Less,
    /// a ≤ b.
    Lequal,
    /// a = b.
    Equal,
    /// a ≥ b.
    Gequal,
    /// a > b.
    Greater,
    /// a ≠ b.
    Notequal,
}

impl Compare {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Always,
        Self::Never,
        Self::Less,
        Self::Lequal,
        Self::Equal,
        Self::Gequal,
        Self::Greater,
        Self::Notequal,
    ];

    /// Whether a and b, in this order, are so.
    pub fn holds<T: PartialOrd + Copy>(self, a: T, b: T) -> bool {
        match self {
            Self::Always => true,
            Self::Never => false,
            Self::Less => a < b,
            Self::Lequal => a <= b,
            Self::Equal => a == b,
            Self::Gequal => a >= b,
            Self::Greater => a > b,
            Self::Notequal => a != b,
        }
    }
}

/// What is done to a stored stencil value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StencilOp {
    /// It stays.
    Keep,
    /// It becomes 0.
    Zero,
    /// It becomes the reference.
    Replace,
    /// One more, at most 255.
    Incr,
    /// One more, and 0 after 255.
    IncrWrap,
    /// One less, at least 0.
    Decr,
    /// One less, and 255 after 0.
    DecrWrap,
    /// Each bit is turned.
    Invert,
}

impl StencilOp {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Keep,
        Self::Zero,
        Self::Replace,
        Self::Incr,
        Self::IncrWrap,
        Self::Decr,
        Self::DecrWrap,
        Self::Invert,
    ];

    /// What becomes of a stored value.
    #[must_use]
    pub fn apply(self, stored: u8, reference: u8) -> u8 {
        match self {
            Self::Keep => stored,
            Self::Zero => 0,
            Self::Replace => reference,
            Self::Incr => stored.saturating_add(1),
            Self::IncrWrap => stored.wrapping_add(1),
            Self::Decr => stored.saturating_sub(1),
            Self::DecrWrap => stored.wrapping_sub(1),
            Self::Invert => !stored,
        }
    }
}

/// How the stencil value at a pixel is tested and changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StencilTest {
    /// How the reference must be to the kept value.
    pub function: Compare,
    /// With what the kept value is compared.
    pub reference: u8,
    /// The bits that are compared.
    pub read_mask: u8,
    /// The bits that may change.
    pub write_mask: u8,
    /// What is done where the stencil test fails.
    pub fail: StencilOp,
    /// What is done where that passes and the depth test fails.
    pub depth_fail: StencilOp,
    /// What is done where both pass.
    pub pass: StencilOp,
}

/// How the depth at a pixel is tested and changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DepthTest {
    /// How the fragment's depth must be to the kept one; a smaller depth is nearer.
    pub function: Compare,
    /// Whether the fragment's depth is kept then.
    pub write: bool,
}

/// What is kept at a pixel besides its colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kept {
    /// The stencil value.
    pub stencil: u8,
    /// The depth, from 0 to 1.
    pub depth: f32,
}

/// A colour over another.
pub type Over = fn(Color, Color) -> Color;

/// Stencil test and depth test of a fragment of some depth.
pub type Test = fn(&StencilTest, &DepthTest, f32, Kept) -> (bool, Kept);

/// A disc of one colour, and how its fragments are tested.
#[derive(Clone, Copy, Debug)]
pub struct Layer {
    /// Its middle, in pixels.
    pub center: Vec2,
    /// Its radius in pixels.
    pub radius: f32,
    /// Its depth in its middle.
    pub depth: f32,
    /// How much deeper it is a pixel farther on the right, and above.
    pub slope: Vec2,
    /// Its colour.
    pub color: Color,
    /// The test of the stencil value.
    pub stencil: StencilTest,
    /// The test of the depth.
    pub test: DepthTest,
}

/// Draws discs, one after the other. At first each pixel has the stencil value 0 and the depth 1.
pub fn draw(layers: &[Layer], over: Over, test: Test, image: &mut Image) {
    let width = image.width();
    let mut kept = vec![Kept { stencil: 0, depth: 1.0 }; (width * image.height()) as usize];
    for layer in layers {
        for (x, y, below) in image.clone().pixels() {
            let way = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) - layer.center;
            if way.length_squared() > layer.radius * layer.radius {
                continue;
            }
            let kept = &mut kept[(y * width + x) as usize];
            let (passes, after) =
                test(&layer.stencil, &layer.test, layer.depth + layer.slope.dot(way), *kept);
            *kept = after;
            if passes {
                image.set(x, y, over(layer.color, below));
            }
        }
    }
}
