//! Lesson 1: lines.

use std::collections::BTreeSet;

use common::{Bounds, IVec2, Method, Vec2Swizzles};
use lines::METHODS;
use sheet::{AMBER, BLACK, PALE, SKY, Sheet};

use crate::{Drawing, Figure, Input, Values, View, number};

/// Columns and rows of the grid.
const SIZE: IVec2 = IVec2::new(13, 8);

/// A segment by any method, with f, k and e of each step.
pub(crate) const IDEAL: Figure = Figure {
    name: "lines-ideal",
    hint: "Drag an end of the segment, or move it by the arrow keys. Choose another method.",
    inputs: &[
        end("End a", [0.5, 0.5]),
        end("End b", [12.5, 5.5]),
        Input::Choice { label: "Method", rows: || Method::rows(METHODS), from: "bresenham" },
    ],
    draw: ideal,
};

/// An end of the segment, the centre of a pixel.
const fn end(label: &'static str, from: [f64; 2]) -> Input {
    Input::Point { label, from, low: [0.5, 0.5], high: [SIZE.x as f64 - 0.5, SIZE.y as f64 - 0.5], step: 1.0 }
}

fn ideal(mut values: Values) -> View {
    let [a, b] = [values.point(), values.point()].map(|end| end.floor().as_ivec2());
    let method = values.choice(METHODS);
    let mut plotted: Vec<(IVec2, u8)> = Vec::new();
    (method.run.visit)(a, b, Bounds::EVERYTHING, &mut |x, y, coverage| {
        plotted.push((IVec2::new(x, y), coverage));
    });

    let mut sheet = Sheet::new((-0.5, -0.5), SIZE.as_vec2() + 0.5);
    sheet.grid((0, 0), SIZE.into());
    let on_sheet = |pixel: IVec2| pixel.cmpge(IVec2::ZERO).all() && pixel.cmplt(SIZE).all();
    for &(pixel, coverage) in plotted.iter().filter(|(pixel, _)| on_sheet(*pixel)) {
        // As much of a pixel as is covered.
        let half = (f32::from(coverage) / 255.0).sqrt() / 2.0;
        let center = pixel.as_vec2() + 0.5;
        sheet.rectangle(
            center - half,
            center + half,
            if pixel == a || pixel == b { AMBER } else { SKY },
            PALE,
        );
    }
    let [from, to] = [a, b].map(|pixel| pixel.as_vec2() + 0.5);
    sheet.line(from, to, BLACK, 2.2);

    let steps = Steps::new(a, b);
    let pixels: BTreeSet<(i32, i32)> = plotted.iter().map(|&(pixel, _)| pixel.into()).collect();
    let farthest = plotted.iter().map(|&(pixel, _)| steps.fraction(pixel).abs()).fold(0.0, f32::max);
    let twice = plotted.len() - pixels.len();
    let told = format!(
        "{}: from ({}, {}) to ({}, {}), {} steps; {} pixels, {twice} of them coloured again; a centre is up to {} px from the \
         line.",
        method.name,
        a.x,
        a.y,
        b.x,
        b.y,
        steps.length,
        pixels.len(),
        number(farthest),
    );
    View { drawing: Drawing::Sheet(sheet), told, table: steps.table(&plotted) }
}

/// The steps along the longer side of a segment, ordered as lesson 1 orders it.
struct Steps {
    steep: bool,
    start: IVec2,
    length: i32,
    rise: i32,
    sign: i32,
}

impl Steps {
    fn new(a: IVec2, b: IVec2) -> Self {
        let steep = (b - a).abs().x < (b - a).abs().y;
        let [a, b] = if steep { [a.yx(), b.yx()] } else { [a, b] };
        let [start, end] = if a.x <= b.x { [a, b] } else { [b, a] };
        let (length, rise) = ((end - start).x, (end - start).y);
        Self { steep, start, length, rise: rise.abs(), sign: if rise < 0 { -1 } else { 1 } }
    }

    /// A pixel by its step, and by how many rows it has risen.
    fn place(&self, pixel: IVec2) -> (i32, i32) {
        let place = (if self.steep { pixel.yx() } else { pixel }) - self.start;
        (place.x, place.y * self.sign)
    }

    /// How far the line is above a pixel's centre there.
    fn fraction(&self, pixel: IVec2) -> f32 {
        let (step, risen) = self.place(pixel);
        (step * self.rise) as f32 / self.length.max(1) as f32 - risen as f32
    }

    /// The error of Bresenham's loop at a pixel.
    fn error(&self, pixel: IVec2) -> i32 {
        let (step, risen) = self.place(pixel);
        2 * step * self.rise - 2 * self.length * risen - self.length
    }

    /// Row k, fraction f and error e at each step; of several pixels in a column, of each.
    fn table(&self, plotted: &[(IVec2, u8)]) -> Vec<Vec<String>> {
        let at = |step: i32| -> Vec<IVec2> {
            let mut own: Vec<IVec2> = plotted.iter().map(|&(pixel, _)| pixel).collect();
            own.retain(|&pixel| self.place(pixel).0 == step);
            own.sort_by_key(|&pixel| self.place(pixel).1);
            own.dedup();
            own
        };
        let row = |name: &str, cell: &dyn Fn(IVec2) -> String| -> Vec<String> {
            let cells = (0..=self.length).map(|step| {
                let cells: Vec<String> = at(step).into_iter().map(cell).collect();
                if cells.is_empty() { "–".into() } else { cells.join(" · ") }
            });
            std::iter::once(name.into()).chain(cells).collect()
        };
        let minus = |n: i32| n.to_string().replace('-', "−");
        vec![
            std::iter::once("step".into()).chain((0..=self.length).map(|step| step.to_string())).collect(),
            row("k", &|pixel| minus(self.place(pixel).1)),
            row("f", &|pixel| format!("{:.2}", self.fraction(pixel)).replace('-', "−")),
            row("e", &|pixel| minus(self.error(pixel))),
        ]
    }
}

#[cfg(test)]
mod tests {
    use common::Vec2;

    use super::*;

    /// The chapter's example by hand: 7 columns, a rise of 3.
    #[test]
    fn the_chapters_example() {
        let table = IDEAL.view(&[0.5, 0.5, 7.5, 3.5, 8.0]).table;
        assert_eq!(table[1][1..], ["0", "0", "1", "1", "2", "2", "3", "3"]);
        assert_eq!(table[3][1..], ["−7", "−1", "−9", "−3", "−11", "−5", "−13", "−7"]);
    }

    /// One segment from both ends, whichever way it goes.
    #[test]
    fn the_table_is_of_the_segment() {
        let table = |a: Vec2, b: Vec2| IDEAL.view(&[a.x, a.y, b.x, b.y].map(f64::from)).table;
        for b in [Vec2::new(12.5, 5.5), Vec2::new(2.5, 7.5), Vec2::new(7.5, 0.5)] {
            let a = Vec2::new(4.5, 3.5);
            assert_eq!(table(a, b), table(b, a), "{b}");
        }
    }
}
