//! Flags of the programs that draw triangles in the window, this lesson's and the next one's.

use common::{Color, Vec3};
use zbuffer::Surface;

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
