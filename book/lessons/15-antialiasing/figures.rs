//! Chapter 15: without stairs.

use std::f32::consts::TAU;

use antialiasing::{METHODS, RESOLVES, area, coverage, pattern, resolve};
use clipping::{Clipping, Cull};
use common::{Color, Format, Image, IVec2, Vec2, Vec3};
use zbuffer::Surface;

use super::sketches::{centroid, heights, levels, patterns, shoelace};
use crate::figures::picture::{method, painted, paste};
use crate::figures::{Drawing, Figure};

pub(crate) const FIGURES: &[Figure] = &[
    Figure::new(
        "antialiasing-head",
        "A head before a dark ground with a fan of thin triangles beside it, twice, with a part enlarged. On the left its outline \
         is a flight of stairs and the fan breaks up into dots; on the right both are smooth.",
        head,
    ),
    Figure::new(
        "antialiasing-shares",
        "A slanted line across two rows of large pixels. Above, each pixel is black or white; below, those that the line runs \
         through have greys, the darker the less of them lies below the line.",
        shares,
    ),
    Figure::new(
        "antialiasing-shoelace",
        "A triangle that reaches out of a square to the right and above. What of it lies in the square has five corners, \
         numbered from P0 to P4; its area is seven sixteenths.",
        shoelace,
    ),
    Figure::new(
        "antialiasing-seam",
        "A square of two triangles and a wheel of twelve, grey on a bright ground, twice. On the left bright lines run along all \
         inner sides; on the right there are none.",
        seam,
    ),
    Figure::new(
        "antialiasing-heights",
        "Three pixels with their samples, and beside each a scale with a mark for each height that a sample has: four marks for \
         the grid, sixteen for the standard pattern of sixteen, four for the one of four.",
        heights,
    ),
    Figure::new(
        "antialiasing-patterns",
        "Six pixels with 1, 2, 4, 8 and 16 samples, scattered so that no two are in one row or column, and with a grid of four \
         by four.",
        patterns,
    ),
    Figure::new(
        "antialiasing-levels",
        "Greys told apart against the angle of a side. The grid has 5 next to 0 and 90 degrees, 8 at 45, and mostly 17 between \
         them; the pattern of sixteen has 17 next to the axes and from 11 to 17 elsewhere; the one of four has 5, and 3 or 4 at \
         some angles.",
        levels,
    ),
    Figure::new(
        "antialiasing-strips",
        "Six strips with the border between black and white, which rises by a pixel in sixty. The first has one step, the second \
         and third have four, the fourth eight, the fifth sixteen, and the last one is even.",
        strips,
    ),
    Figure::new(
        "antialiasing-crossing",
        "Two triangles that run through one another, three times, enlarged. On the left all borders are stairs; in the middle \
         the outlines are smooth and the line where the two meet is stairs; on the right all is smooth.",
        crossing,
    ),
];

/// Between pictures.
const GAP: i32 = 6;

/// The grey between pictures.
const BETWEEN: u8 = 96;

/// Pictures of one size in rows, one pixel for one.
fn rows_of(rows: &[Vec<Image>]) -> anyhow::Result<Drawing> {
    let first = rows.first().and_then(|row| row.first()).context("there is no picture")?;
    let [width, height] = [first.width(), first.height()];
    let whole = |side: i32, count: usize| (side * count as i32 + GAP * (count as i32 - 1)) as u16;
    let mut sheet = Image::new(whole(width, rows[0].len()), whole(height, rows.len()), Format::Rgb);
    sheet.buffer_mut().fill(BETWEEN);
    for (n, row) in rows.iter().rev().enumerate() {
        for (m, image) in row.iter().enumerate() {
            paste(image, &mut sheet, [m as i32 * (width + GAP), n as i32 * (height + GAP)]);
        }
    }
    Ok(Drawing::Pixels(sheet, 1))
}

/// Each pixel so many times as large.
fn enlarged(image: &Image, times: u16) -> Image {
    image.scale(image.width() as u16 * times, image.height() as u16 * times)
}

/// A triangle of one colour in the window.
fn flat(corners: [Vec2; 3], color: Color) -> Surface {
    Surface { corners: corners.map(|corner| corner.extend(0.5)), color }
}
