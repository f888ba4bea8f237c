//! The card that every chart is drawn on: words, axes, marks, and its two layouts.
//!
//! A chart is drawn twice: as wide as the book's column, and as wide as a telephone. No letter is smaller than 12 px
//! in either. Colours are classes of a style sheet, so that the same file suits a light and a dark page. (Plotting
//! crates were looked at in 2026: plotters and kuva write fixed colours into each element and know one layout, and
//! neither keeps labels off marks, which is most of what is done here.)

use svg::node::element::{Circle, Group, Path, Rectangle, Style, Text, Title, path::Data};
use svg::{Document, Node};

use super::place::{Label, Rect};

/// How large a chart and its letters are, in px.
#[derive(Debug)]
pub(crate) struct Layout {
    /// Behind the name of the chart's file.
    pub(crate) ending: &'static str,
    pub(crate) width: f64,
    plot_height: f64,
    /// Heights of the letters of the title, of labels and of everything else.
    title: f64,
    pub(crate) label: f64,
    text: f64,
    /// Room for the texts along the upright axis.
    left: f64,
    /// Between the borders of the card and what is on it.
    margin: f64,
}

/// As wide as the book's column, and as wide as that of a telephone.
pub(crate) const LAYOUTS: [Layout; 2] = [
    Layout {
        ending: "",
        width: 740.0,
        plot_height: 360.0,
        title: 18.0,
        label: 13.5,
        text: 13.0,
        left: 58.0,
        margin: 18.0,
    },
    Layout {
        ending: "-narrow",
        width: 350.0,
        plot_height: 380.0,
        title: 16.0,
        label: 12.5,
        text: 12.5,
        left: 46.0,
        margin: 10.0,
    },
];

/// How many colours tell methods apart.
const HUES: usize = 8;

/// Each hue on a light page and on a dark one: chosen so that letters in them can be read, and that none is like another
/// one to those who do not see red or green.
const COLORS: [[&str; 2]; HUES] = [
    ["#225cab", "#82beff"],
    ["#980f00", "#df621b"],
    ["#00846e", "#52eeae"],
    ["#701170", "#fd2ba0"],
    ["#9a6b01", "#f7bd17"],
    ["#111418", "#ffffff"],
    ["#8e49fc", "#a967f2"],
    ["#1001b2", "#ffff00"],
];

/// The other colours: names, and what they are on a light page and on a dark one.
const GROUNDS: [(&str, &str, [&str; 2]); 6] = [
    ("card", "fill", ["#fdfcf9", "#1d2127"]),
    ("band", "fill", ["#f1eee5", "#282d35"]),
    ("grid", "stroke", ["#e4e0d6", "#363c45"]),
    ("ink", "fill", ["#23272c", "#e3e5e8"]),
    ("soft", "fill", ["#555b62", "#a9afb7"]),
    ("rule", "stroke", ["#555b62", "#a9afb7"]),
];

/// The style sheet.
fn style(layout: &Layout) -> String {
    let rules = |theme: usize| -> String {
        let grounds =
            GROUNDS.iter().map(|(name, property, colors)| format!(".{name}{{{property}:{}}}", colors[theme]));
        let hues = COLORS
            .iter()
            .enumerate()
            .map(|(n, colors)| format!(".f{n}{{fill:{0}}}.s{n}{{stroke:{0}}}", colors[theme]));
        grounds.chain(hues).collect()
    };
    format!(
        "text{{font:{}px 'Source Sans 3','Open Sans','Noto Sans',Helvetica,Arial,sans-serif}}{}\
         @media(prefers-color-scheme:dark){{{}}}",
        layout.text,
        rules(0),
        rules(1)
    )
}

/// The room that a text takes: no font that readers are likely to have is wider.
pub(crate) fn text_width(text: &str, height: f64) -> f64 {
    text.chars().count() as f64 * height * 0.55
}

/// A text in lines of at most that width, where it has spaces.
fn wrap(text: &str, height: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut().filter(|line| text_width(&format!("{line} {word}"), height * 0.9) <= width) {
            Some(line) => *line = format!("{line} {word}"),
            None => lines.push(word.into()),
        }
    }
    lines
}

/// An axis: where it begins and ends, in decades, and what stands along it.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    pub(crate) label: String,
    pub(crate) range: [f64; 2],
    /// Places and their texts.
    pub(crate) ticks: Vec<(f64, String)>,
    /// Stretches that are no part of the scale, as that of what is exact.
    pub(crate) bands: Vec<[f64; 2]>,
}

/// The words around a chart.
pub(crate) struct Words {
    /// What was found.
    pub(crate) title: String,
    /// How to read it, under the title.
    pub(crate) reading: String,
    /// Paragraphs at the foot.
    pub(crate) caption: Vec<String>,
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

/// What a reader is told who points at a mark, and what the page's script, `theme/charts.js`, must know of it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Told {
    /// Of a chart of speed against accuracy: whether it is the worst case or the mean, where these differ.
    Errors { text: String, kind: Option<&'static str> },
    /// Of a line: how far along it the mark is, and its value there.
    Value { text: String, at: String, value: String },
}

/// A chart that is being drawn, in px, y down.
pub(crate) struct Card {
    document: Document,
    /// What is drawn of the method of which something is being drawn.
    method: Option<Group>,
    pub(crate) layout: &'static Layout,
    /// Where the data are.
    pub(crate) plot: Rect,
    ranges: [[f64; 2]; 2],
}

impl Card {
    /// Draws words and axes.
    pub(crate) fn new(layout: &'static Layout, words: &Words, [x, y]: [&Axis; 2]) -> Self {
        let Layout { width, margin, title, text, left, .. } = *layout;
        let wide = width - 2.0 * margin;
        let heading = wrap(&words.title, title * 1.04, wide);
        let reading = wrap(&words.reading, text, wide);
        let caption: Vec<String> = words.caption.iter().flat_map(|line| wrap(line, 12.0, wide)).collect();
        let [across, upright] = [x, y].map(|axis| wrap(&axis.label, text, wide));
        // Heights of lines, and from line to line.
        let (heading_step, step, small) = (title * 1.25, text * 1.35, 16.0);
        let title_top = margin + title;
        let reading_top = title_top + (heading.len() - 1) as f64 * heading_step + 8.0 + text;
        let upright_top = reading_top + (reading.len() - 1) as f64 * step + 10.0 + text;
        let top = upright_top + (upright.len() - 1) as f64 * step + 8.0;
        let bottom = top + layout.plot_height;
        let across_top = bottom + 18.0 + 8.0 + text;
        let caption_top = across_top + (across.len() - 1) as f64 * step + 24.0;
        let height = (caption_top + (caption.len().max(1) - 1) as f64 * small + margin * 0.7).ceil();

        let plot = Rect { left: margin + left, top, right: width - margin, bottom };
        let document = Document::new()
            .set("viewBox", (0, 0, width, height))
            .set("width", width)
            .set("height", height)
            .add(Title::new(words.title.clone()))
            .add(Style::new(style(layout)))
            .add(
                Rectangle::new().set("class", "card").set("width", width).set("height", height).set("rx", 8),
            );
        let mut card = Self { document, method: None, layout, plot, ranges: [x.range, y.range] };

        let lines = |lines: &[String], card: &mut Self, top: f64, step: f64, class: &str, size: f64, bold| {
            for (n, line) in lines.iter().enumerate() {
                card.text(line, [margin, top + n as f64 * step], class, "start", size, bold);
            }
        };
        lines(&heading, &mut card, title_top, heading_step, "ink", title, true);
        lines(&reading, &mut card, reading_top, step, "soft", text, false);
        lines(&upright, &mut card, upright_top, step, "ink", text, false);
        lines(&caption, &mut card, caption_top, small, "soft", 12.0, false);
        for (n, line) in across.iter().enumerate() {
            card.text(line, [plot.right, across_top + n as f64 * step], "ink", "end", text, false);
        }
        card.axes(x, y);
        card
    }

    fn axes(&mut self, x: &Axis, y: &Axis) {
        let Rect { left, top, right, bottom } = self.plot;
        for [from, to] in &x.bands {
            self.rectangle(self.at([*from, y.range[1]]), self.at([*to, y.range[0]]));
        }
        for [from, to] in &y.bands {
            self.rectangle(self.at([x.range[0], *to]), self.at([x.range[1], *from]));
        }
        let text = self.layout.text;
        // Texts that would touch the one before them are left out; those of bands, which stand last, are not.
        let mut taken: Vec<Rect> = Vec::new();
        for (at, name) in x.ticks.iter().rev() {
            let [x, _] = self.at([*at, 0.0]);
            let half = text_width(name, text) / 2.0;
            let place =
                Rect::about([x.clamp(half, self.layout.width - half), bottom + 18.0], 2.0 * half + 8.0, text);
            self.line([[x, top], [x, bottom]], "grid", 1.0, None);
            if !taken.iter().any(|other| other.overlaps(&place)) {
                self.text(
                    name,
                    [(place.left + place.right) / 2.0, bottom + 18.0],
                    "ink",
                    "middle",
                    text,
                    false,
                );
                taken.push(place);
            }
        }
        for (at, name) in &y.ticks {
            let [_, y] = self.at([0.0, *at]);
            self.line([[left, y], [right, y]], "grid", 1.0, None);
            self.text(name, [left - 7.0, y + 0.35 * text], "ink", "end", text, false);
        }
        self.line([[left, top], [left, bottom], [right, bottom]], "rule", 1.0, None);
    }

    /// Names what the chart's lines go along, for the page's script.
    pub(crate) fn across(&mut self, name: &str) {
        self.document.assign("data-across", name);
    }

    /// Draws what is of one method, so that the page's script can switch it off.
    pub(crate) fn of(&mut self, method: &str, draw: impl FnOnce(&mut Self)) {
        self.method = Some(Group::new().set("data-of", method));
        draw(self);
        if let Some(group) = self.method.take() {
            self.document.append(group);
        }
    }

    fn append(&mut self, node: impl Into<Box<dyn Node>>) {
        match &mut self.method {
            Some(group) => group.append(node),
            None => self.document.append(node),
        }
    }

    /// Where a place on the axes is.
    pub(crate) fn at(&self, place: [f64; 2]) -> [f64; 2] {
        let share = |n: usize| (place[n] - self.ranges[n][0]) / (self.ranges[n][1] - self.ranges[n][0]);
        let Rect { left, top, right, bottom } = self.plot;
        [left + share(0) * (right - left), bottom - share(1) * (bottom - top)]
    }

    /// Draws straight lines through points.
    pub(crate) fn line<const N: usize>(
        &mut self,
        points: [[f64; 2]; N],
        class: &str,
        width: f64,
        dashes: Option<&str>,
    ) {
        self.path(&points, class, width, dashes);
    }

    /// Draws straight lines through points.
    pub(crate) fn path(&mut self, points: &[[f64; 2]], class: &str, width: f64, dashes: Option<&str>) {
        let Some((first, rest)) = points.split_first() else { return };
        let pair = |point: &[f64; 2]| (tenth(point[0]), tenth(point[1]));
        let data =
            rest.iter().fold(Data::new().move_to(pair(first)), |data, point| data.line_to(pair(point)));
        let mut path =
            Path::new().set("class", class).set("d", data).set("fill", "none").set("stroke-width", width);
        if let Some(dashes) = dashes {
            path = path.set("stroke-dasharray", dashes);
        }
        self.append(path);
    }

    fn rectangle(&mut self, [left, top]: [f64; 2], [right, bottom]: [f64; 2]) {
        let rectangle = Rectangle::new().set("class", "band").set("x", tenth(left)).set("y", tenth(top));
        self.document.append(rectangle.set("width", tenth(right - left)).set("height", tenth(bottom - top)));
    }

    /// Draws a mark in a method's colour, and what is told of it.
    pub(crate) fn mark(
        &mut self,
        [x, y]: [f64; 2],
        mark: Mark,
        hue: Option<usize>,
        opacity: f64,
        told: Option<&Told>,
    ) {
        let (fill, stroke) = (fill(hue), stroke(hue));
        let circle = |radius: f64| Circle::new().set("cx", tenth(x)).set("cy", tenth(y)).set("r", radius);
        let outlined =
            |circle: Circle| circle.set("class", stroke.as_str()).set("fill", "none").set("stroke-width", 2);
        let mut group = told.map_or_else(Group::new, Told::group);
        match mark {
            Mark::Disc => group.append(circle(5.5).set("class", fill)),
            Mark::Dot => group.append(circle(3.0).set("class", fill)),
            Mark::Ring => {
                group.append(circle(4.5).set("class", "card"));
                group.append(outlined(circle(4.5)));
            }
            Mark::Halo => group.append(outlined(circle(8.0))),
            Mark::Square => {
                let square = Rectangle::new().set("x", tenth(x - 5.5)).set("y", tenth(y - 5.5));
                group.append(square.set("width", 11).set("height", 11).set("class", fill));
            }
            Mark::Cross => {
                let data = [(-5.0, -5.0, 5.0, 5.0), (-5.0, 5.0, 5.0, -5.0)].iter().fold(
                    Data::new(),
                    |data, ends| {
                        let [from, to] = [(ends.0, ends.1), (ends.2, ends.3)]
                            .map(|(dx, dy)| (tenth(x + dx), tenth(y + dy)));
                        data.move_to(from).line_to(to)
                    },
                );
                group.append(Path::new().set("d", data).set("class", stroke.as_str()).set("stroke-width", 3));
            }
        }
        self.append(if opacity < 1.0 { group.set("opacity", opacity) } else { group });
    }

    /// Writes a label where it was placed, with its leader.
    pub(crate) fn label(&mut self, text: &str, label: &Label, hue: Option<usize>, bold: bool) {
        if let Some(from) = label.leader {
            self.line([from, label.anchor], "rule", 0.6, None);
        }
        let size = self.layout.label;
        let at = [label.place.left + 2.0, (label.place.top + label.place.bottom) / 2.0 + 0.35 * size];
        self.text(text, at, &fill(hue), "start", size, bold);
    }

    /// The room that a label takes.
    pub(crate) fn label_size(&self, text: &str) -> [f64; 2] {
        [text_width(text, self.layout.label * 1.06) + 4.0, self.layout.label + 3.0]
    }

    /// Writes a line of text; `at` is its base line.
    pub(crate) fn text(
        &mut self,
        text: &str,
        at: [f64; 2],
        class: &str,
        anchor: &str,
        size: f64,
        bold: bool,
    ) {
        let mut node = Text::new(text).set("class", class).set("x", tenth(at[0])).set("y", tenth(at[1]));
        if anchor != "start" {
            node = node.set("text-anchor", anchor);
        }
        let weight = if bold { "font-weight:600;" } else { "" };
        if bold || size != self.layout.text {
            node = node.set("style", format!("{weight}font-size:{size}px"));
        }
        self.append(node);
    }

    /// The SVG.
    pub(crate) fn finish(self) -> String {
        format!("{}\n", self.document)
    }
}

impl Told {
    /// A group for the mark. A browser that shows the chart alone shows the title of what is pointed at.
    fn group(&self) -> Group {
        let group = Group::new().set("class", "point");
        match self {
            Self::Errors { text, kind } => {
                let group = group.add(Title::new(text.as_str()));
                if let Some(kind) = kind { group.set("data-kind", *kind) } else { group }
            }
            Self::Value { text, at, value } => group
                .add(Title::new(text.as_str()))
                .set("data-at", at.as_str())
                .set("data-value", value.as_str()),
        }
    }
}

/// A colour for each of those that do the job, in their order; what does another one has none and is grey.
pub(crate) fn hues(do_it: impl Iterator<Item = bool>) -> Vec<Option<usize>> {
    let mut next = 0..;
    do_it.map(|does_it| if does_it { next.next() } else { None }).collect()
}

/// The class of what is filled in a method's colour.
fn fill(hue: Option<usize>) -> String {
    hue.map_or("soft".into(), |hue| format!("f{hue}"))
}

/// The class of a line in a method's colour.
pub(crate) fn stroke(hue: Option<usize>) -> String {
    hue.map_or("rule".into(), |hue| format!("s{hue}"))
}

/// To a tenth of a px, so that files stay small.
fn tenth(x: f64) -> f64 {
    (x * 10.0).round() / 10.0
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
    use glam::{DMat3, DVec3};

    #[test]
    fn powers_are_plain_where_that_is_short() {
        let texts = [-12, -3, -1, 0, 4, 5].map(power_of_ten);
        assert_eq!(texts, ["10⁻¹²", "0.001", "0.1", "1", "10000", "10⁵"]);
    }

    #[test]
    fn what_does_another_job_has_no_colour() {
        assert_eq!(hues([false, true, false, true].into_iter()), [None, Some(0), None, Some(1)]);
        assert_eq!((fill(None), stroke(None)), ("soft".into(), "rule".into()));
    }

    /// Light of the three primaries, from 0 to 1.
    fn linear(color: &str) -> DVec3 {
        let channel = |at: usize| f64::from(u8::from_str_radix(&color[at..at + 2], 16).unwrap()) / 255.0;
        let light = |v: f64| if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
        DVec3::new(light(channel(1)), light(channel(3)), light(channel(5)))
    }

    /// A colour's place in Oklab, where distances are those that are seen (B. Ottosson, *A perceptual color space for
    /// image processing*, 2020).
    fn oklab(light: DVec3) -> DVec3 {
        let cones = DMat3::from_cols_array(&[
            0.4122214708,
            0.5363325363,
            0.0514459929,
            0.2119034982,
            0.6806995451,
            0.1073969566,
            0.0883024619,
            0.2817188376,
            0.6299787005,
        ]);
        let lab = DMat3::from_cols_array(&[
            0.2104542553,
            0.793617785,
            -0.0040720468,
            1.9779984951,
            -2.428592205,
            0.4505937099,
            0.0259040371,
            0.7827717662,
            -0.808675766,
        ]);
        lab.transpose() * (cones.transpose() * light).map(f64::cbrt)
    }

    /// What those see who see all colours, who lack the cones for long waves, and who lack those for middle ones (G.
    /// Machado and others, *A physiologically-based model for simulation of color vision deficiency*, 2009, table 1).
    const VISIONS: [[f64; 9]; 3] = [
        [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
        [0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998],
        [0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.01182, 0.04294, 0.968881],
    ];

    #[test]
    fn no_two_colours_look_alike_to_anyone_and_all_can_be_read() {
        let luminance = |color: &str| linear(color).dot(DVec3::new(0.2126, 0.7152, 0.0722)) + 0.05;
        for theme in [0, 1] {
            let card = luminance(GROUNDS[0].2[theme]);
            for (n, a) in COLORS.iter().map(|colors| colors[theme]).enumerate() {
                // What the W3C's guidelines for accessible content ask of text (WCAG 2.2, 1.4.3).
                let contrast = luminance(a) / card;
                assert!(contrast.max(1.0 / contrast) >= 4.5, "{a}: {contrast}");
                for b in COLORS[..n].iter().map(|colors| colors[theme]) {
                    for vision in &VISIONS {
                        let seen = |color| {
                            let light = DMat3::from_cols_array(vision).transpose() * linear(color);
                            oklab(light.clamp(DVec3::ZERO, DVec3::ONE))
                        };
                        let apart = (seen(a) - seen(b)).length();
                        assert!(apart > 0.1, "{a} and {b}: {apart}");
                    }
                }
            }
        }
    }

    #[test]
    fn there_are_never_too_many_decades() {
        assert_eq!(decades(-3, 2).count(), 6);
        assert!(decades(-40, 40).count() <= 13);
    }

    #[test]
    fn no_line_is_wider_than_it_may_be() {
        let lines = wrap("one two three four", 10.0, 45.0);
        assert_eq!(lines, ["one two", "three", "four"]);
        assert!(LAYOUTS.iter().all(|layout| layout.text >= 12.0 && layout.label >= 12.0));
    }
}
