//! What all charts share: card, title, axes, caption, colours, text.

use std::ops::Range;

use anyhow::anyhow;
use plotters::coord::Shift;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::place::{Label, Rect};

/// Width and height of a chart in pixels.
pub(crate) const SIZE: (u32, u32) = (1000, 680);

/// The card is light wherever it is shown.
const CARD: RGBColor = RGBColor(0xff, 0xfd, 0xf7);
pub(crate) const INK: RGBColor = RGBColor(0x22, 0x22, 0x22);
pub(crate) const GRAY: RGBColor = RGBColor(0x66, 0x66, 0x66);
const GRID: RGBColor = RGBColor(0xe4, 0xe0, 0xd6);
const BAND: RGBColor = RGBColor(0xf3, 0xef, 0xe4);

/// Okabe and Ito's colours without yellow, which is too pale on white (*Color Universal Design*, 2008).
pub(crate) const COLORS: [RGBColor; 7] = [
    RGBColor(0x00, 0x72, 0xb2),
    RGBColor(0xd5, 0x5e, 0x00),
    RGBColor(0x00, 0x9e, 0x73),
    RGBColor(0xcc, 0x79, 0xa7),
    RGBColor(0xe6, 0x9f, 0x00),
    RGBColor(0x56, 0xb4, 0xe9),
    RGBColor(0x22, 0x22, 0x22),
];

/// An axis: where it begins and ends, in decades, and what stands along it.
pub(crate) struct Axis {
    pub(crate) label: String,
    pub(crate) range: [f64; 2],
    /// Places and their texts.
    pub(crate) ticks: Vec<(f64, String)>,
    /// Stretches that are no part of the scale, as that of what is exact.
    pub(crate) bands: Vec<[f64; 2]>,
}

/// An axis as plotters wants it.
#[derive(Clone, Copy)]
struct Scale<'a>(&'a Axis);

impl Ranged for Scale<'_> {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let [low, high] = self.0.range;
        from + ((value - low) / (high - low) * f64::from(to - from)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        // Light points would be lines without a text.
        if hint.weight().allow_light_points() {
            Vec::new()
        } else {
            self.0.ticks.iter().map(|tick| tick.0).collect()
        }
    }

    fn range(&self) -> Range<f64> {
        self.0.range[0]..self.0.range[1]
    }
}

impl ValueFormatter<f64> for Scale<'_> {
    fn format_ext(&self, value: &f64) -> String {
        let found = self.0.ticks.iter().find(|tick| tick.0 == *value);
        found.map_or(String::new(), |tick| tick.1.clone())
    }
}

/// The words around a chart.
pub(crate) struct Words<'a> {
    pub(crate) title: String,
    /// How to read it: lines under the title.
    pub(crate) reading: Vec<String>,
    /// Lines at the foot.
    pub(crate) caption: &'a [String],
}

/// A chart that is being drawn, in pixels.
pub(crate) struct Frame<'a> {
    root: DrawingArea<SVGBackend<'a>, Shift>,
    /// Where the data are.
    pub(crate) plot: Rect,
    ranges: [[f64; 2]; 2],
}

/// Draws a chart: words and axes, and then what `draw` adds. Returns the SVG.
pub(crate) fn chart(
    words: &Words,
    axes: [&Axis; 2],
    draw: impl FnOnce(&Frame) -> anyhow::Result<()>,
) -> anyhow::Result<String> {
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        root.fill(&CARD).map_err(told)?;
        let frame = framed(root, words, axes)?;
        draw(&frame)?;
        frame.root.present().map_err(told)?;
    }
    Ok(svg)
}

/// Draws words and axes.
fn framed<'a>(
    root: DrawingArea<SVGBackend<'a>, Shift>,
    words: &Words,
    [x, y]: [&Axis; 2],
) -> anyhow::Result<Frame<'a>> {
    let (width, height) = (f64::from(SIZE.0), f64::from(SIZE.1));
    let top = 58.0 + 20.0 * words.reading.len() as f64;
    let bottom = height - 62.0 - 18.0 * words.caption.len() as f64;
    let plot = Rect { left: 96.0, top, right: width - 36.0, bottom };
    let frame = Frame { root, plot, ranges: [x.range, y.range] };

    for [from, to] in &x.bands {
        frame.rectangle([frame.at([*from, y.range[1]]), frame.at([*to, y.range[0]])], BAND)?;
    }
    for [from, to] in &y.bands {
        frame.rectangle([frame.at([x.range[0], *to]), frame.at([x.range[1], *from])], BAND)?;
    }
    let (left, right) = (plot.left as i32, SIZE.0 as i32 - plot.right as i32);
    let mut chart = ChartBuilder::on(&frame.root)
        .margin_top(plot.top as i32)
        .margin_right(right)
        .margin_bottom(SIZE.1 as i32 - plot.bottom as i32 - 26)
        .margin_left(left - 70)
        .x_label_area_size(26)
        .y_label_area_size(70)
        .build_cartesian_2d(Scale(x), Scale(y))
        .map_err(told)?;
    chart
        .configure_mesh()
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .axis_style(GRAY)
        .label_style(style(13, INK, FontStyle::Normal))
        .draw()
        .map_err(told)?;

    frame.text(&words.title, [26.0, 36.0], 21, INK, FontStyle::Bold, HPos::Left)?;
    for (n, line) in words.reading.iter().enumerate() {
        frame.text(line, [26.0, 60.0 + 20.0 * n as f64], 14, GRAY, FontStyle::Normal, HPos::Left)?;
    }
    let middle = (plot.left + plot.right) / 2.0;
    frame.text(&x.label, [middle, plot.bottom + 42.0], 14, INK, FontStyle::Normal, HPos::Center)?;
    for (n, line) in words.caption.iter().enumerate() {
        let at = [26.0, plot.bottom + 68.0 + 18.0 * n as f64];
        frame.text(line, at, 12, GRAY, FontStyle::Normal, HPos::Left)?;
    }
    let upright = style(14, INK, FontStyle::Normal).transform(FontTransform::Rotate270);
    let upright = upright.pos(Pos::new(HPos::Center, VPos::Center));
    let at = pixel([24.0, (plot.top + plot.bottom) / 2.0]);
    frame.root.draw(&Text::new(y.label.clone(), at, upright)).map_err(told)?;
    Ok(frame)
}

impl Frame<'_> {
    /// Where a place on the axes is.
    pub(crate) fn at(&self, place: [f64; 2]) -> [f64; 2] {
        let share = |n: usize| (place[n] - self.ranges[n][0]) / (self.ranges[n][1] - self.ranges[n][0]);
        let Rect { left, top, right, bottom } = self.plot;
        [left + share(0) * (right - left), bottom - share(1) * (bottom - top)]
    }

    /// Draws lines through these points.
    pub(crate) fn path(&self, points: &[[f64; 2]], color: RGBAColor, width: u32) -> anyhow::Result<()> {
        let points: Vec<(i32, i32)> = points.iter().map(|point| pixel(*point)).collect();
        self.root.draw(&PathElement::new(points, color.stroke_width(width))).map_err(told)
    }

    /// Draws a dashed line between two points.
    pub(crate) fn dashes(&self, [a, b]: [[f64; 2]; 2], color: RGBColor) -> anyhow::Result<()> {
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let at = |along: f64| [0, 1].map(|n| a[n] + (b[n] - a[n]) * (along / length).min(1.0));
        let count = (length / 9.0).ceil() as u32;
        (0..count)
            .map(|n| f64::from(n) * 9.0)
            .try_for_each(|from| self.path(&[at(from), at(from + 5.0)], color.into(), 1))
    }

    /// Fills a rectangle.
    pub(crate) fn rectangle(&self, corners: [[f64; 2]; 2], color: RGBColor) -> anyhow::Result<()> {
        self.root.draw(&Rectangle::new(corners.map(pixel), color.filled())).map_err(told)
    }

    /// Draws a mark.
    pub(crate) fn mark(&self, at: [f64; 2], mark: Mark, color: RGBAColor) -> anyhow::Result<()> {
        let (x, y) = pixel(at);
        let drawn = match mark {
            Mark::Disc => self.root.draw(&Circle::new((x, y), 6, color.filled())),
            Mark::Ring => {
                self.root.draw(&Circle::new((x, y), 5, CARD.filled())).map_err(told)?;
                self.root.draw(&Circle::new((x, y), 5, color.stroke_width(2)))
            }
            Mark::Halo => self.root.draw(&Circle::new((x, y), 9, color.stroke_width(2))),
            Mark::Square => self.root.draw(&Rectangle::new([(x - 6, y - 6), (x + 6, y + 6)], color.filled())),
            Mark::Cross => self.root.draw(&Cross::new((x, y), 6, color.stroke_width(3))),
            Mark::Dot => self.root.draw(&Circle::new((x, y), 3, color.filled())),
        };
        drawn.map_err(told)
    }

    /// Writes a label where it was placed, with its leader.
    pub(crate) fn label(&self, text: &str, label: &Label, color: RGBColor, bold: bool) -> anyhow::Result<()> {
        if let Some(from) = label.leader {
            self.path(&[from, label.anchor], color.mix(0.45), 1)?;
        }
        let at = [label.place.left + 2.0, (label.place.top + label.place.bottom) / 2.0 + 5.0];
        let style = if bold { FontStyle::Bold } else { FontStyle::Normal };
        self.text(text, at, LABEL, color, style, HPos::Left)
    }

    /// Writes a line of text; `at` is its base line.
    pub(crate) fn text(
        &self,
        text: &str,
        at: [f64; 2],
        size: u32,
        color: RGBColor,
        font: FontStyle,
        side: HPos,
    ) -> anyhow::Result<()> {
        let style = style(size, color, font).pos(Pos::new(side, VPos::Bottom));
        // plotters raises what it puts above a point by half the height of an x.
        let (x, y) = pixel([at[0], at[1] + 0.26 * f64::from(size)]);
        self.root.draw(&Text::new(text.to_string(), (x, y), style)).map_err(told)
    }
}

/// Ways to mark a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Mark {
    Disc,
    Ring,
    Halo,
    Square,
    Cross,
    Dot,
}

/// The size of a label's letters.
pub(crate) const LABEL: u32 = 14;

/// The room that a label takes: no font that readers are likely to have is wider.
pub(crate) fn label_size(text: &str) -> [f64; 2] {
    [text.chars().count() as f64 * f64::from(LABEL) * 0.62 + 4.0, f64::from(LABEL) + 4.0]
}

fn style(size: u32, color: RGBColor, font: FontStyle) -> TextStyle<'static> {
    // plotters writes a size divided by 1.24 into the SVG.
    let style = TextStyle::from(("sans-serif", f64::from(size) * 1.24, font));
    TextStyle { color: color.to_backend_color(), ..style }
}

fn pixel(at: [f64; 2]) -> (i32, i32) {
    (at[0].round() as i32, at[1].round() as i32)
}

/// plotters' errors hold borrows; their text does not.
fn told(error: impl std::fmt::Display) -> anyhow::Error {
    anyhow!("the chart cannot be drawn: {error}")
}

/// The decades from `low` to `high`, both exponents of 10, and the texts of their powers; at most twelve or so.
pub(crate) fn decades(low: i32, high: i32) -> impl Iterator<Item = (i32, String)> {
    let step = ((high - low) as usize).div_ceil(12).max(1);
    (low..=high).step_by(step).map(|exponent| (exponent, power_of_ten(exponent)))
}

/// A power of ten as it is written.
pub(crate) fn power_of_ten(exponent: i32) -> String {
    match exponent {
        0..=4 => 10_i64.pow(exponent as u32).to_string(),
        -3..0 => format!("{:.*}", exponent.unsigned_abs() as usize, 10f64.powi(exponent)),
        _ => {
            const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
            let digits = exponent.unsigned_abs().to_string();
            let raised: String = digits.bytes().map(|digit| RAISED[usize::from(digit - b'0')]).collect();
            format!("10{}{raised}", if exponent < 0 { "⁻" } else { "" })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_plain_where_that_is_short() {
        let texts = [-12, -3, -1, 0, 4, 5].map(power_of_ten);
        assert_eq!(texts, ["10⁻¹²", "0.001", "0.1", "1", "10000", "10⁵"]);
    }

    #[test]
    fn there_are_never_too_many_decades() {
        assert_eq!(decades(-3, 2).count(), 6);
        assert!(decades(-40, 40).count() <= 13);
    }
}
