//! Flags of the programs that draw triangles in the window, this lesson's and the next one's; and those that say what happens
//! to their fragments.

use std::marker::PhantomData;
use std::path::PathBuf;

use clap::ValueEnum;
use common::program::{UsageError, values};
use common::{Bounds, Color, IVec2, Image, Vec3};
use zbuffer::Surface;

use crate::AnyState;
use crate::blend::{Blend, BlendOrLogic, Equation, Factor, Formula};
use crate::compare::Compare;
use crate::depth::DepthTest;
use crate::logic::LogicOp;
use crate::mask::WriteMask;
use crate::state::State;
use crate::stencil::StencilTest;

/// `--triangle` and `--background`.
#[derive(Clone, Debug, clap::Args)]
pub struct TriangleFlags {
    /// A triangle instead of the lesson's scene, in pixels, with its colour, its alpha and its depth from 0 to 1; may be
    /// repeated
    #[arg(long = "triangle", value_name = "x0,y0,x1,y1,x2,y2[,rrggbb[aa[,z]]]", value_parser = triangle, allow_hyphen_values = true)]
    pub triangles: Vec<Surface>,

    /// What the picture is filled with at first
    #[arg(long, value_name = "rrggbb", default_value = "000000")]
    pub background: Color,
}

/// How deep a triangle is unless told otherwise.
const DEPTH: f32 = 0.5;

fn triangle(text: &str) -> Result<Surface, String> {
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    if !(6..=8).contains(&parts.len()) {
        return Err(format!("write 6 numbers, and perhaps a colour and a depth, not {} parts", parts.len()));
    }
    let number = |part: &str| -> Result<f32, String> {
        let number = part.parse().ok().filter(|number: &f32| number.is_finite());
        number.ok_or_else(|| format!("`{part}` is not a number that can be used here"))
    };
    let color = parts.get(6).map_or(Ok(Color::WHITE), |part| color_with_alpha(part))?;
    let depth = parts.get(7).map_or(Ok(DEPTH), |part| number(part))?;
    if !(0.0..=1.0).contains(&depth) {
        return Err(format!("the depth `{depth}` does not lie from 0 to 1"));
    }
    let numbers = parts[..6].iter().map(|part| number(part)).collect::<Result<Vec<f32>, String>>()?;
    let corners = [0, 2, 4].map(|n| Vec3::new(numbers[n], numbers[n + 1], depth));
    Ok(Surface { corners, color })
}

/// Reads `rrggbb`, which is opaque, or `rrggbbaa`.
///
/// # Errors
/// Where it is neither.
pub fn color_with_alpha(text: &str) -> Result<Color, String> {
    let refused = || {
        format!("`{text}` is not a colour: write six hexadecimal digits, as in ff8000, or eight with alpha")
    };
    let (color, alpha) = match text.len() {
        8 => text.split_at_checked(6).ok_or_else(refused)?,
        _ => (text, "ff"),
    };
    // A colour of the alpha's two digits, three times over, is checked digit by digit.
    let alpha: Color = alpha.repeat(3).parse().map_err(|_| refused())?;
    let color: Color = color.parse().map_err(|_| refused())?;
    Ok(Color { a: alpha.r, ..color })
}

/// `--scissor`, `--stencil`, `--depth-test`, `--blend`, `--blend-alpha`, `--blend-color`, `--equation`, `--logic` and
/// `--write-mask`, by OpenGL's names.
#[derive(Clone, Debug, PartialEq, clap::Args)]
pub struct StateFlags {
    /// Draw to a rectangle only: its lower left corner, its width and its height, in pixels
    #[arg(long, value_name = "x,y,w,h", value_parser = rectangle, allow_hyphen_values = true)]
    pub scissor: Option<Bounds>,

    /// A picture of the same size: where it is black, nothing is drawn
    #[arg(long, value_name = "FILE")]
    pub stencil: Option<PathBuf>,

    /// Which depths pass against what is there: never, less, equal, lequal, greater, notequal, gequal or always
    #[arg(long, value_name = "FUNC", value_enum, hide_possible_values = true, default_value = "less")]
    pub depth_test: Compare,

    /// The factors of source and destination: zero, one, src-color, src-alpha, dst-color, dst-alpha, constant-color,
    /// constant-alpha, each of these with one-minus- before it, or src-alpha-saturate
    #[arg(long, value_name = "SRC,DST", default_value = "src-alpha,one-minus-src-alpha", value_parser = factors)]
    pub blend: [Factor; 2],

    /// The same for alpha
    #[arg(long, value_name = "SRC,DST", default_value = "one,one-minus-src-alpha", value_parser = factors)]
    pub blend_alpha: [Factor; 2],

    /// What the constant factors mean
    #[arg(long, value_name = "rrggbb[aa]", default_value = "00000000", value_parser = color_with_alpha)]
    pub blend_color: Color,

    /// How the two are put together: func-add, subtract, reverse-subtract, min or max
    #[arg(long, value_name = "EQ", value_enum, hide_possible_values = true, default_value = "func-add")]
    pub equation: Equation,

    /// A logic operation in place of blending: clear, and, and-reverse, copy, and-inverted, noop, xor, or, nor, equiv,
    /// invert, or-reverse, copy-inverted, or-inverted, nand or set
    #[arg(long, value_name = "OP", value_enum, hide_possible_values = true)]
    pub logic: Option<LogicOp>,

    /// The channels that are written, some of the letters r, g, b and a
    #[arg(long, value_name = "rgba", default_value = "rgba")]
    pub write_mask: WriteMask,
}

impl StateFlags {
    /// Whether anything but the defaults is asked for.
    #[must_use]
    pub fn are_given(&self) -> bool {
        self.state() != AnyState::USUAL
    }

    /// The state that they describe.
    #[must_use]
    pub fn state(&self) -> AnyState {
        let &Self {
            scissor, depth_test, blend, blend_alpha, blend_color, equation, logic, write_mask, ..
        } = self;
        let formula = |[source, destination]: [Factor; 2]| Formula { equation, source, destination };
        let blend = Blend { color: formula(blend), alpha: formula(blend_alpha), constant: blend_color };
        State {
            scissor,
            stencil: self.stencil.as_ref().map(|_| StencilTest::MASK),
            depth: DepthTest { function: depth_test, write: true },
            blend: BlendOrLogic { blend, logic, division: PhantomData },
            mask: write_mask,
        }
    }

    /// The stencil's picture, where there is one.
    ///
    /// # Errors
    /// As [`Image::read`].
    pub fn read_stencil(&self) -> anyhow::Result<Option<Image>> {
        Ok(self.stencil.as_deref().map(Image::read).transpose()?)
    }

    /// The numbers of a stencil's picture, for a picture of that size: the largest of each pixel's channels, so that just black
    /// is 0.
    ///
    /// # Errors
    /// Where it has another size.
    pub fn stencils(&self, stencil: &Image, picture: &Image) -> Result<Vec<u8>, UsageError> {
        let [has, needs] = [stencil, picture].map(|image| (image.width(), image.height()));
        if has != needs {
            let why = format!(
                "--stencil: it is {}x{}, and the picture {}x{}: make them of one size",
                has.0, has.1, needs.0, needs.1
            );
            return Err(UsageError(why));
        }
        Ok(stencil.pixels().map(|(_, _, Color { r, g, b, .. })| r.max(g).max(b)).collect())
    }
}

fn rectangle(text: &str) -> Result<Bounds, String> {
    let [x, y, width, height] = values::numbers::<i32, 4>(text)?;
    if width < 0 || height < 0 {
        return Err("width and height must be 0 or more".into());
    }
    let min = IVec2::new(x, y);
    // A rectangle of no width ends before it begins.
    let max = IVec2::new(x.saturating_add(width - 1), y.saturating_add(height - 1));
    Ok(Bounds { min, max })
}

fn factors(text: &str) -> Result<[Factor; 2], String> {
    let names: Vec<&str> = text.split(',').map(str::trim).collect();
    let &[source, destination] = names.as_slice() else {
        return Err(format!("write 2 factors with a comma between them, not {}", names.len()));
    };
    let factor = |name: &str| Factor::from_str(name, false).map_err(|_| format!("`{name}` is no factor"));
    Ok([factor(source)?, factor(destination)?])
}
