//! A sheet to draw on: the one look of the book's line drawings.
//!
//! What is drawn has coordinates as in the course, y up; the sheet turns them into those of SVG. Every sheet is
//! 480 units wide, and no letter smaller than 15: on a telephone that still reads. Colours are Okabe and Ito's, which
//! colour-blind people can tell apart; on a dark page, each has another shade, and the ground is dark.
//!
//! A sheet is written as a file of its own, whose shades follow the page that shows it, or as a part of a page
//! ([`Sheet::inline`]), which has the shades in its style ([`shades`]).

use std::fmt::{self, Write};

use common::Vec2;

/// Width of every sheet.
const WIDTH: f32 = 480.0;
/// Height of letters.
const LETTER: f32 = 16.0;
/// The namespace of elements.
const SVG: &str = "http://www.w3.org/2000/svg";
/// What letters are taken from.
const FONTS: &str = "'Source Sans 3', 'Open Sans', 'Noto Sans', Helvetica, Arial, sans-serif";
/// Ends and corners of lines.
const ROUND: &str = r#"stroke-linecap="round" stroke-linejoin="round""#;
/// The rim of letters.
const RIM: &str = r#"paint-order="stroke" stroke-opacity="0.7" stroke-width="3""#;
/// Free border.
const MARGIN: f32 = 14.0;
/// No sheet is higher; what would be is made narrower instead.
const HEIGHT: f32 = 430.0;

/// A colour of the book.
pub type Ink = &'static str;

/// Letters and outlines.
pub const BLACK: Ink = "#22262b";
/// What is there but not meant.
pub const GREY: Ink = "#6b7178";
/// Grids.
pub const FAINT: Ink = "#d3d1c9";
/// The ground.
pub const PAPER: Ink = "#fdfcf9";
/// First choice for what is meant.
pub const BLUE: Ink = "#0072b2";
/// Second choice, and what is wrong.
pub const ORANGE: Ink = "#d55e00";
/// Third choice, and what is right.
pub const GREEN: Ink = "#007a5a";
/// Fills behind black letters.
pub const SKY: Ink = "#9fd3f2";
/// Fills behind black letters.
pub const AMBER: Ink = "#f2c14e";
/// Fourth choice.
pub const PURPLE: Ink = "#a8487f";
/// Large areas behind everything.
pub const PALE: Ink = "#f1eee5";
/// Fills behind black letters.
pub const ROSE: Ink = "#d9a3c2";
/// Fills behind black letters.
pub const MINT: Ink = "#a5d8c3";

/// What becomes of the colours on a dark page.
const DARK: [(Ink, Ink); 13] = [
    (BLACK, "#e3e5e8"),
    (GREY, "#a9afb7"),
    (FAINT, "#3c434d"),
    (PAPER, "#1d2127"),
    (BLUE, "#63b3ec"),
    (ORANGE, "#f59a4c"),
    (GREEN, "#45c9a1"),
    (SKY, "#1f5577"),
    (AMBER, "#7a5c12"),
    (PURPLE, "#e39ac6"),
    (PALE, "#2a3038"),
    (ROSE, "#6b3a57"),
    (MINT, "#1f5c4a"),
];

/// The rules of style that give all colours their other shade in what a selector names; they are stronger than the attributes
/// that give each part its colour.
#[must_use]
pub fn shades(within: &str) -> String {
    let rule = |(light, dark): (Ink, Ink)| {
        format!("{within}[fill='{light}']{{fill:{dark}}}{within}[stroke='{light}']{{stroke:{dark}}}")
    };
    DARK.map(rule).concat()
}

/// Whether a colour has another shade on a dark page.
#[must_use]
pub fn has_dark_shade(color: &str) -> bool {
    DARK.iter().any(|(light, _)| *light == color)
}

/// A number with so many digits behind the point, as `{:.n}` writes those that an `i64` can hold. A page loads this code: what
/// formats whole numbers is a tenth of what formats any.
#[must_use]
pub fn fixed(x: f32, digits: u32) -> String {
    let unit = 10_i64.pow(digits);
    // Exact: an f64 has room for the digits of both.
    let all = (f64::from(x) * unit as f64).round_ties_even() as i64;
    let sign = if all < 0 { "-" } else { "" };
    let all = all.unsigned_abs();
    let unit = unit.unsigned_abs();
    format!("{sign}{}.{:0width$}", all / unit, all % unit, width = digits as usize)
}

/// A number with at most four digits behind the point, so that files stay small.
#[must_use]
pub fn short(x: f32) -> String {
    fixed(x, 4).trim_end_matches('0').trim_end_matches('.').into()
}

/// A drawing, in which a rectangle of the plane can be seen.
pub struct Sheet {
    /// What is drawn, an element a line. It is written at once: a tree of elements would be more code than a page should load.
    elements: String,
    low: Vec2,
    scale: f32,
    height: f32,
}

impl Sheet {
    /// An empty sheet that shows what lies between two corners.
    #[must_use]
    pub fn new(low: impl Into<Vec2>, high: impl Into<Vec2>) -> Self {
        let (low, high) = (low.into(), high.into());
        let size = high - low;
        let scale = ((WIDTH - 2.0 * MARGIN) / size.x).min((HEIGHT - 2.0 * MARGIN) / size.y);
        // What is narrow stands in the middle.
        let low = low - Vec2::X * ((WIDTH - 2.0 * MARGIN) / scale - size.x) / 2.0;
        let height = ((high.y - low.y) * scale + 2.0 * MARGIN).ceil();
        let mut sheet = Self { elements: String::new(), low, scale, height };
        let (width, height) = sheet.size();
        sheet.add(format_args!(r#"<rect fill="{PAPER}" height="{height}" rx="8" width="{width}"/>"#));
        sheet
    }

    /// Width and height in SVG's units.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (WIDTH as u32, self.height as u32)
    }

    /// Where the origin is on the sheet, in SVG's units, and how many of them are 1: the point (x, y) is at
    /// (origin.x + x·scale, origin.y − y·scale).
    #[must_use]
    pub fn frame(&self) -> (Vec2, f32) {
        (
            Vec2::new(MARGIN, self.height - MARGIN) + Vec2::new(-self.low.x, self.low.y) * self.scale,
            self.scale,
        )
    }

    /// The drawing as a part of a page, without shades for a dark one.
    #[must_use]
    pub fn inline(&self) -> String {
        self.with("")
    }

    /// The drawing with one element more.
    fn with(&self, last: &str) -> String {
        let (elements, (width, height), letter) = (&self.elements, self.size(), short(LETTER));
        format!(
            r#"<svg font-family="{FONTS}" font-size="{letter}" {ROUND} viewBox="0 0 {width} {height}" xmlns="{SVG}">
{elements}{last}</svg>"#
        )
    }

    /// Where on the sheet a point is, to a hundredth of a unit, so that files stay small.
    fn at(&self, point: impl Into<Vec2>) -> (f32, f32) {
        let at = (point.into() - self.low) * self.scale;
        let hundredth = |x: f32| (x * 100.0).round() / 100.0;
        (hundredth(MARGIN + at.x), hundredth(self.height - MARGIN - at.y))
    }

    fn add(&mut self, element: fmt::Arguments) {
        writeln!(self.elements, "{element}").expect("a string takes all");
    }

    /// A line of a width in units of the sheet.
    pub fn line(&mut self, from: impl Into<Vec2>, to: impl Into<Vec2>, ink: Ink, width: f32) {
        self.segment(self.at(from), self.at(to), ink, width, "");
    }

    /// A dashed line.
    pub fn dashed(&mut self, from: impl Into<Vec2>, to: impl Into<Vec2>, ink: Ink, width: f32) {
        self.segment(self.at(from), self.at(to), ink, width, r#" stroke-dasharray="5 5""#);
    }

    fn segment(&mut self, from: (f32, f32), to: (f32, f32), ink: Ink, width: f32, dashes: &str) {
        let [x1, y1, x2, y2, width] = [from.0, from.1, to.0, to.1, width].map(short);
        self.add(format_args!(
            r#"<line stroke="{ink}"{dashes} stroke-width="{width}" x1="{x1}" x2="{x2}" y1="{y1}" y2="{y2}"/>"#
        ));
    }

    /// A vector: a line with a point at its end.
    pub fn arrow(&mut self, from: impl Into<Vec2>, to: impl Into<Vec2>, ink: Ink) {
        const HEAD: f32 = 11.0;
        let (from, to) = (from.into(), to.into());
        let along = (to - from).normalize_or_zero() * HEAD / self.scale;
        let across = along.perp() * 0.42;
        self.line(from, to - along * 0.6, ink, 2.4);
        self.polygon(&[to, to - along + across, to - along - across], ink, ink);
    }

    /// A filled area with an outline; either may be `none`.
    pub fn polygon(&mut self, corners: &[Vec2], fill: Ink, outline: Ink) {
        let points = self.points(corners);
        self.add(format_args!(
            r#"<polygon fill="{fill}" points="{points}" stroke="{outline}" stroke-width="1.8"/>"#
        ));
    }

    /// A rectangle whose sides are level and upright, filled as [`polygon`](Self::polygon) is.
    pub fn rectangle(&mut self, low: impl Into<Vec2>, high: impl Into<Vec2>, fill: Ink, outline: Ink) {
        let (low, high) = (low.into(), high.into());
        self.polygon(&[low, low.with_x(high.x), high, low.with_y(high.y)], fill, outline);
    }

    /// A box with words in it.
    pub fn labelled(&mut self, center: impl Into<Vec2>, half: impl Into<Vec2>, fill: Ink, words: &str) {
        let (center, half) = (center.into(), half.into());
        self.rectangle(center - half, center + half, fill, BLACK);
        self.text(center, words, BLACK);
    }

    /// Two axes through a place of the sheet, drawn from one corner about it to another.
    pub fn axes(&mut self, origin: impl Into<Vec2>, low: impl Into<Vec2>, high: impl Into<Vec2>, width: f32) {
        let (origin, low, high) = (origin.into(), low.into(), high.into());
        self.line(origin + low.with_y(0.0), origin + high.with_y(0.0), GREY, width);
        self.line(origin + low.with_x(0.0), origin + high.with_x(0.0), GREY, width);
    }

    /// A line through points.
    pub fn polyline<P>(&mut self, points: impl IntoIterator<Item = P>, ink: Ink, width: f32)
    where
        P: Into<Vec2>,
    {
        let points: Vec<Vec2> = points.into_iter().map(P::into).collect();
        let (points, width) = (self.points(&points), short(width));
        self.add(format_args!(
            r#"<polyline fill="none" points="{points}" stroke="{ink}" stroke-width="{width}"/>"#
        ));
    }

    /// Where points are on the sheet.
    fn points(&self, points: &[Vec2]) -> String {
        let points: Vec<String> = points.iter().map(|&point| pair(self.at(point))).collect();
        points.join(" ")
    }

    /// The arc about a point from one angle to another, counterclockwise, in radians.
    pub fn arc(&mut self, center: impl Into<Vec2>, radius: f32, from: f32, to: f32, ink: Ink) {
        let center = center.into();
        let rim = |angle: f32| pair(self.at(center + radius * Vec2::from_angle(angle)));
        let (r, large) = (radius * self.scale, i32::from(to - from > std::f32::consts::PI));
        let (r, from, to) = (fixed(r, 2), rim(from), rim(to));
        self.add(format_args!(
            r#"<path d="M {from} A {r} {r} 0 {large} 0 {to}" fill="none" stroke="{ink}" stroke-width="1.8"/>"#
        ));
    }

    /// A point.
    pub fn dot(&mut self, at: impl Into<Vec2>, ink: Ink) {
        let [cx, cy] = <[f32; 2]>::from(self.at(at)).map(short);
        self.add(format_args!(r#"<circle cx="{cx}" cy="{cy}" fill="{ink}" r="4.5" stroke="{PAPER}"/>"#));
    }

    /// The square of a pixel, given by its bottom-left corner.
    pub fn pixel(&mut self, x: i32, y: i32, fill: Ink) {
        let (left, bottom) = self.at(Vec2::new(x as f32, y as f32));
        let [left, top, scale] = [left, bottom - self.scale, self.scale].map(short);
        self.add(format_args!(
            r#"<rect fill="{fill}" height="{scale}" stroke="{PAPER}" stroke-width="1" width="{scale}" x="{left}" y="{top}"/>"#
        ));
    }

    /// The squares of pixels of one colour.
    pub fn pixels(&mut self, pixels: impl IntoIterator<Item = (i32, i32)>, fill: Ink) {
        pixels.into_iter().for_each(|(x, y)| self.pixel(x, y, fill));
    }

    /// The lines between pixels, from one corner to another.
    pub fn grid(&mut self, low: (i32, i32), high: (i32, i32)) {
        let point = |x: i32, y: i32| Vec2::new(x as f32, y as f32);
        for x in low.0..=high.0 {
            self.line(point(x, low.1), point(x, high.1), FAINT, 1.0);
        }
        for y in low.1..=high.1 {
            self.line(point(low.0, y), point(high.0, y), FAINT, 1.0);
        }
    }

    /// Words with their middle at a point.
    pub fn text(&mut self, at: impl Into<Vec2>, words: &str, ink: Ink) {
        self.words(at, words, ink, "middle");
    }

    /// Words that begin at a point.
    pub fn text_right_of(&mut self, at: impl Into<Vec2>, words: &str, ink: Ink) {
        self.words(at, words, ink, "start");
    }

    /// Words that end at a point.
    pub fn text_left_of(&mut self, at: impl Into<Vec2>, words: &str, ink: Ink) {
        self.words(at, words, ink, "end");
    }

    /// Words with a rim of the ground's colour, so that they read on lines as well.
    fn words(&mut self, at: impl Into<Vec2>, words: &str, ink: Ink, anchor: &str) {
        let (x, y) = self.at(at);
        let [x, y] = [x, y + LETTER * 0.35].map(short);
        let words = words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        self.add(format_args!(
            r#"<text fill="{ink}" {RIM} stroke="{PAPER}" text-anchor="{anchor}" x="{x}" y="{y}">{words}</text>"#
        ));
    }

    /// The drawing, finished, as what a figure returns.
    ///
    /// # Errors
    /// Never; a figure may fail, and a sheet is most often its end.
    pub fn finish<D: From<Self>, E>(self) -> Result<D, E> {
        Ok(self.into())
    }
}

fn pair((x, y): (f32, f32)) -> String {
    format!("{} {}", short(x), short(y))
}

impl fmt::Display for Sheet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let style = format!("<style>\n@media(prefers-color-scheme:dark){{{}}}\n</style>\n", shades(""));
        self.with(&style).fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_those_of_the_standard_library() {
        let numbers = (-40_000..40_000).map(|n| n as f32 / 1024.0).chain([0.0005, 1e6, 123.456_79, -0.0004]);
        for x in numbers {
            for digits in 1..=4 {
                let meant = format!("{x:.*}", digits as usize);
                let zero = meant.trim_start_matches('-').trim_matches(['0', '.']).is_empty();
                assert_eq!(fixed(x, digits), if zero { meant.replace('-', "") } else { meant }, "{x}");
            }
        }
        assert_eq!([40.949_997, 480.0, -0.5, 0.0].map(short), ["40.95", "480", "-0.5", "0"]);
    }
}
