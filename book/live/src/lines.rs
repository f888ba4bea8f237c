//! Lesson 1: lines.

use common::{Bounds, IVec2, Method, Vec2, Vec2Swizzles};
use lines::METHODS;
use sheet::{AMBER, BLACK, Ink, ORANGE, PALE, SKY, Sheet, fixed};

use crate::few::Few;
use crate::input::named;
use crate::{Drawing, Figure, Input, Values, View, number};

/// Columns and rows of the grid.
const SIZE: IVec2 = IVec2::new(13, 8);

/// A segment by any method, with f, k and e of each step.
pub(crate) const IDEAL: Figure = Figure {
    name: "lines-ideal",
    stays: false,
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
    let Drawn { method, a, b, plotted } = Drawn::of(&mut values);
    let sheet = drawn_on(&plotted, [a, b], |pixel| if pixel == a || pixel == b { AMBER } else { SKY });
    let steps = Steps::new(a, b);
    let pixels = different(&plotted);
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

/// A segment by a method.
struct Drawn {
    method: &'static Method<lines::Line>,
    a: IVec2,
    b: IVec2,
    /// Its pixels with their coverage, as often as the method sets them.
    plotted: Vec<(IVec2, u8)>,
}

impl Drawn {
    fn of(values: &mut Values) -> Self {
        let [a, b] = [values.point(), values.point()].map(|end| end.floor().as_ivec2());
        let method = values.choice(named!(METHODS));
        let mut plotted = Vec::new();
        (method.run.visit)(a, b, Bounds::EVERYTHING, &mut |x, y, coverage| {
            plotted.push((IVec2::new(x, y), coverage));
        });
        Self { method, a, b, plotted }
    }
}

/// The pixels, each once: coloured again, a pixel is covered no more.
fn different(plotted: &[(IVec2, u8)]) -> Vec<(IVec2, u8)> {
    let mut pixels = Few::new();
    for &(pixel, coverage) in plotted {
        *pixels.of(pixel) = coverage;
    }
    pixels.all().to_vec()
}

/// Pixels in their colours, and the segment over them.
fn drawn_on(plotted: &[(IVec2, u8)], ends: [IVec2; 2], fill: impl Fn(IVec2) -> Ink) -> Sheet {
    let mut sheet = Sheet::new((-0.5, -0.5), SIZE.as_vec2() + 0.5);
    sheet.grid((0, 0), SIZE.into());
    let on_sheet = |pixel: IVec2| pixel.cmpge(IVec2::ZERO).all() && pixel.cmplt(SIZE).all();
    for &(pixel, coverage) in plotted.iter().filter(|(pixel, _)| on_sheet(*pixel)) {
        // As much of a pixel as is covered.
        let half = (f32::from(coverage) / 255.0).sqrt() / 2.0;
        let center = pixel.as_vec2() + 0.5;
        sheet.rectangle(center - half, center + half, fill(pixel), PALE);
    }
    let [from, to] = ends.map(|pixel| pixel.as_vec2() + 0.5);
    sheet.line(from, to, BLACK, 2.2);
    sheet
}

/// The coverage that the pixels of a column share, and their centre of mass.
pub(crate) const WU: Figure = Figure {
    name: "lines-wu",
    stays: true,
    hint: "Drag an end of the segment, or move it by the arrow keys. Choose another method. As much of each pixel is blue as is \
           covered; the orange points are the centres of mass.",
    inputs: &[
        end("End a", [0.5, 1.5]),
        end("End b", [12.5, 6.5]),
        Input::Choice { label: "Method", rows: || Method::rows(METHODS), from: "wu" },
    ],
    draw: shared,
};

fn shared(mut values: Values) -> View {
    let Drawn { method, a, b, plotted } = Drawn::of(&mut values);
    let mut sheet = drawn_on(&plotted, [a, b], |_| SKY);
    let steps = Steps::new(a, b);
    let pixels = different(&plotted);
    // Of each step: what is covered, and the sums of places and of heights above the line, as heavy as the coverage.
    let mut sums: Few<i32, (f32, Vec2, f32)> = Few::new();
    for &(pixel, coverage) in &pixels {
        let share = f32::from(coverage) / 255.0;
        let (mass, places, heights) = sums.of(steps.place(pixel).0);
        *mass += share;
        *places += (pixel.as_vec2() + 0.5) * share;
        *heights -= steps.fraction(pixel) * share;
    }
    let [mut covered, mut height] = ["covered", "height"].map(|name| vec![String::from(name)]);
    let (mut drawn, mut farthest, mut least, mut most) = (0, 0.0_f32, f32::INFINITY, 0.0_f32);
    for step in 0..=steps.length {
        let Some(&(_, (mass, places, heights))) = sums.all().iter().find(|(of, _)| *of == step) else {
            for row in [&mut covered, &mut height] {
                row.push("–".into());
            }
            continue;
        };
        let above = heights / mass;
        sheet.dot(places / mass, ORANGE);
        covered.push(hundredths(mass));
        height.push(hundredths(above));
        (least, most, farthest) = (least.min(mass), most.max(mass), farthest.max(above.abs()));
        drawn += 1;
    }
    let (places, many) = (steps.length + 1, if steps.steep { "rows" } else { "columns" });
    let name = method.name;
    let told = if drawn == 0 {
        format!("{name}: there are no pixels in any of {places} {many}.")
    } else {
        format!(
            "{name}: there are pixels in {drawn} of {places} {many}; of each, between {} px and {} px are covered, and the centre \
             of mass is up to {} px from the line. All pixels together are {} px, and the segment is {} px long.",
            number(least),
            number(most),
            number(farthest),
            number(pixels.iter().map(|&(_, coverage)| f32::from(coverage)).sum::<f32>() / 255.0),
            number((b - a).as_vec2().length()),
        )
    };
    View { drawing: Drawing::Sheet(sheet), told, table: vec![steps.head(), covered, height] }
}

/// A number with two digits behind the point and a true minus.
fn hundredths(x: f32) -> String {
    fixed(x, 2).replace('-', "−")
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

    /// The steps as the first row of a table.
    fn head(&self) -> Vec<String> {
        std::iter::once("step".into()).chain((0..=self.length).map(|step| step.to_string())).collect()
    }

    /// Row k, fraction f and error e at each step; of several pixels in a column, rows for each.
    fn table(&self, plotted: &[(IVec2, u8)]) -> Vec<Vec<String>> {
        let rows = plotted.iter().map(|&(pixel, _)| self.place(pixel).1);
        let rows = rows.clone().min().unwrap_or(0)..=rows.max().unwrap_or(0);
        let columns: Vec<Vec<IVec2>> = (0..=self.length)
            .map(|step| {
                let own = |row: i32| {
                    plotted.iter().map(|&(pixel, _)| pixel).find(|&pixel| self.place(pixel) == (step, row))
                };
                rows.clone().filter_map(own).collect()
            })
            .collect();
        let minus = |n: i32| n.to_string().replace('-', "−");
        let mut table = vec![self.head()];
        for nth in 0..columns.iter().map(Vec::len).max().unwrap_or_default() {
            let mut row = |name: &str, cell: &dyn Fn(IVec2) -> String| {
                let cells =
                    columns.iter().map(|column| column.get(nth).map_or("–".into(), |&pixel| cell(pixel)));
                table.push(std::iter::once(name.into()).chain(cells).collect());
            };
            row("k", &|pixel| minus(self.place(pixel).1));
            row("f", &|pixel| hundredths(self.fraction(pixel)));
            row("e", &|pixel| minus(self.error(pixel)));
        }
        table
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

    /// What the chapter says of Wu's line: in each column as much as a pixel is covered, with its centre of mass on the line.
    #[test]
    fn a_columns_centre_of_mass_is_on_the_line() {
        let table = WU.view(&[]).table;
        assert!(table[1][1..].iter().all(|covered| covered == "1.00"));
        assert!(table[2][1..].iter().all(|height| height == "0.00"));
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
