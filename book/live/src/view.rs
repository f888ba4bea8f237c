//! What a figure shows, and how a page gets it.

use common::{Color, Format, Image, Vec2};
use sheet::Sheet;

/// What a figure shows.
pub struct View {
    /// What is seen.
    pub drawing: Drawing,
    /// The same in a sentence, with the numbers that matter.
    pub told: String,
    /// A table of numbers, its rows of the same length; the first row and the first column name the others. May be empty.
    pub table: Vec<Vec<String>>,
}

/// A drawing of either kind.
pub enum Drawing {
    /// Lines and letters.
    Sheet(Sheet),
    /// Pixels.
    Pixels(Image),
}

/// A view as a page gets it.
pub struct Rendered {
    parts: [Vec<u8>; 3],
    /// The width and height of the drawing in units of SVG or in pixels; of a sheet, also where the origin is, x and y, and how many
    /// of its units are 1.
    pub numbers: Vec<f64>,
}

impl Rendered {
    pub(crate) fn of(view: View) -> Self {
        let table: Vec<String> = view.table.iter().map(|row| row.join("\t")).collect();
        let (drawing, numbers) = match view.drawing {
            Drawing::Sheet(sheet) => {
                let ((width, height), (Vec2 { x, y }, scale)) = (sheet.size(), sheet.frame());
                let numbers = vec![f64::from(width), f64::from(height), x.into(), y.into(), scale.into()];
                (sheet.inline().into_bytes(), numbers)
            }
            Drawing::Pixels(image) => {
                (from_the_top(&image), vec![f64::from(image.width()), f64::from(image.height())])
            }
        };
        Self { parts: [drawing, view.told.into_bytes(), table.join("\n").into_bytes()], numbers }
    }

    /// The bytes of a part: 0 is the drawing, as the text of an `<svg>` or as pixels of four bytes, rows from the top; 1 what is
    /// told; 2 the table, a row a line, its cells apart by tabs.
    #[must_use]
    pub fn part(&self, n: usize) -> &[u8] {
        self.parts.get(n).map_or(&[], Vec::as_slice)
    }
}

/// Pixels as a canvas has them: red, green, blue and alpha, rows from the top.
fn from_the_top(image: &Image) -> Vec<u8> {
    let rows = (0..image.height()).rev();
    let pixels = rows.flat_map(|y| (0..image.width()).filter_map(move |x| image.get(x, y)));
    pixels.flat_map(|color| [color.r, color.g, color.b, color.a]).collect()
}

/// Pictures of one size in rows, the first row on top, with gaps between them.
pub(crate) fn beside(rows: &[Vec<Image>]) -> Image {
    const GAP: i32 = 6;
    const GROUND: Color = Color::rgb(128, 128, 128);
    let Some(first) = rows.first().and_then(|row| row.first()) else {
        return Image::new(1, 1, Format::Rgb);
    };
    let [width, height] = [first.width() + GAP, first.height() + GAP];
    let count = [rows[0].len() as i32, rows.len() as i32];
    let mut all = Image::new((count[0] * width - GAP) as u16, (count[1] * height - GAP) as u16, Format::Rgb);
    all.set_all(|_| GROUND);
    for (n, row) in rows.iter().rev().enumerate() {
        for (m, image) in row.iter().enumerate() {
            image
                .pixels()
                .for_each(|(x, y, color)| all.set(m as i32 * width + x, n as i32 * height + y, color));
        }
    }
    all
}
