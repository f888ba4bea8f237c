//! Lesson 5: colour from a picture.

use common::{Color, Format, Image, Method, Vec2};
use sheet::{AMBER, BLACK, BLUE, FAINT, Ink, MINT, ORANGE, ROSE, SKY, Sheet};
use textures::{repeat, round, texel, truncate};

use crate::input::with;
use crate::{Drawing, Figure, Input, Values, View, number};

/// Finds the texel of (u, v).
type Sample = fn(&Image, Vec2) -> Color;

/// The lesson's table without its loops: the head has one for all.
pub(crate) const SAMPLERS: &[Method<Sample>] =
    &with::<_, Sample, 4>(textures::METHODS, [truncate, round, texel, repeat]);

/// What the methods find along a row of four texels.
pub(crate) const STRIPS: Figure = Figure {
    name: "textures-strips",
    stays: false,
    hint: "Move u past the texture's borders, at 0 and 1, and over those of its texels.",
    inputs: &[Input::Slider { label: "u", from: 0.95, range: [-0.5, 1.5], step: 0.025 }],
    draw: looked_up,
};

/// Columns of a strip that are asked, to each texel's width.
const STEPS: i32 = 16;

/// Four texels in a row, whose red is their number and one more.
fn row() -> Image {
    let mut row = Image::new(4, 1, Format::Rgb);
    row.set_all(|x| Color::rgb(x as u8 + 1, 0, 0));
    row
}

/// A row for each method: what it finds from u = −½ to 1½, black where that is nothing.
#[must_use]
pub fn strips() -> Sheet {
    const INKS: [Ink; 4] = [SKY, AMBER, MINT, ROSE];
    let row = row();
    let mut sheet = Sheet::new((-0.92, -0.25), (1.56, 1.62));
    for (n, method) in SAMPLERS.iter().enumerate() {
        let low = low_of(n);
        let at = |step: i32| step as f32 / (4 * STEPS) as f32;
        let found = |step: i32| (method.run)(&row, Vec2::new(at(step) + at(1) / 2.0, 0.25)).r;
        let (first, end) = (-2 * STEPS, 6 * STEPS);
        let mut begin = first;
        for step in first..end {
            if step + 1 == end || found(step + 1) != found(begin) {
                let [left, right] = [begin, step + 1].map(at);
                let fill = found(begin).checked_sub(1).map_or(BLACK, |texel| INKS[usize::from(texel)]);
                sheet.rectangle((left, low), (right, low + 0.28), fill, "none");
                if fill != BLACK && right - left > 0.1 {
                    sheet.text(((left + right) / 2.0, low + 0.14), &(found(begin) - 1).to_string(), BLACK);
                }
                begin = step + 1;
            }
        }
        sheet.text_left_of((-0.55, low + 0.14), method.name, BLACK);
    }
    for (u, name) in [(-0.5, "−½"), (0.0, "0"), (0.25, "¼"), (0.5, "½"), (0.75, "¾"), (1.0, "1"), (1.5, "1½")]
    {
        let ink = if u == 0.0 || u == 1.0 { ORANGE } else { BLACK };
        sheet.dashed((u, 0.0), (u, 1.58), if ink == ORANGE { ORANGE } else { FAINT }, 1.5);
        sheet.text((u, -0.13), name, ink);
    }
    sheet
}

/// The lower side of the strip of a method.
fn low_of(n: usize) -> f32 {
    1.26 - 0.4 * n as f32
}

fn looked_up(mut values: Values) -> View {
    let u = values.number();
    let row = row();
    let mut sheet = strips();
    sheet.line((u, -0.02), (u, 1.6), BLUE, 3.0);
    let found = |(n, method): (usize, &Method<Sample>)| {
        sheet.dot((u, low_of(n)), BLUE);
        match (method.run)(&row, Vec2::new(u, 0.25)).r {
            0 => format!("none by {}", method.name),
            texel => format!("{} by {}", texel - 1, method.name),
        }
    };
    let found: Vec<String> = SAMPLERS.iter().enumerate().map(found).collect();
    let told = format!(
        "u = {} is at {} of the texture's 4 texels. What is found there: texel {}.",
        number(u),
        number(4.0 * u),
        found.join(", "),
    );
    View { drawing: Drawing::Sheet(sheet), told, table: Vec::new() }
}
