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
    /// Pixels, in [`Format::Rgb`].
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
    /// Of a view.
    #[must_use]
    pub fn of(view: View) -> Self {
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
///
/// A figure's pictures have no alpha. As it takes as long as many of them to draw, it is done row by row.
fn from_the_top(image: &Image) -> Vec<u8> {
    let width = image.width() as usize;
    let mut bytes = vec![u8::MAX; 4 * width * image.height() as usize];
    let rows = image.buffer().chunks_exact(3 * width).rev();
    for (to, from) in bytes.chunks_exact_mut(4 * width).zip(rows) {
        for (to, from) in to.as_chunks_mut::<4>().0.iter_mut().zip(from.as_chunks().0) {
            let [r, g, b] = *from;
            *to = [r, g, b, u8::MAX];
        }
    }
    bytes
}

/// Pictures of one size in rows, the first row on top, with gaps between them. All are in [`Format::Rgb`].
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
    let whole = 3 * all.width() as usize;
    for (n, row) in rows.iter().rev().enumerate() {
        for (m, image) in row.iter().enumerate() {
            debug_assert_eq!(image.format(), Format::Rgb);
            let own = 3 * image.width() as usize;
            let first = n * height as usize * whole + 3 * m * width as usize;
            for (y, pixels) in image.buffer().chunks_exact(own).enumerate() {
                all.buffer_mut()[first + y * whole..][..own].copy_from_slice(pixels);
            }
        }
    }
    all
}
