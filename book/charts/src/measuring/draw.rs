//! The two kinds of chart: speed against accuracy, and lines of an error or a cost against what makes it larger.

use anyhow::Context;

use super::card::{Axis, Card, LAYOUTS, Layout, Mark, Told, Words, decades, hues, stroke, text_width};
use super::digits::{spelled, three_digits};
use super::place::{Rect, place};
use super::table::{Quantity, Series, number};

/// Where values are on a logarithmic axis, and those that have no place on it.
struct Scale {
    low: f64,
    high: f64,
    width: f64,
    /// 1 where larger values are to the right or on top, −1 where they are not.
    sign: f64,
    /// The names of the columns for infinity and for 0, if there are any.
    outer: [Option<&'static str>; 2],
}

impl Scale {
    /// For these values; the names of what is infinite and of what is 0.
    fn new(
        values: &(impl Iterator<Item = f64> + Clone),
        sign: f64,
        [failed, none]: [&'static str; 2],
    ) -> Self {
        let finite = values.clone().filter(|value| value.is_finite() && *value > 0.0).map(f64::log10);
        let (low, high) =
            finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
        let (low, high) = if low > high { (0.0, 0.0) } else { (low.floor(), high.ceil()) };
        let low = low.min(high - 2.0);
        let outer = [
            values.clone().any(f64::is_infinite).then_some(failed),
            values.clone().any(|value| value == 0.0).then_some(none),
        ];
        let [low, high] = if sign < 0.0 { [-high, -low] } else { [low, high] };
        Self { low, high, width: (high - low) * 0.1, sign, outer }
    }

    fn at(&self, value: f64) -> f64 {
        let [below, above] = [self.low - self.width, self.high + self.width];
        let [none, failed] = if self.sign < 0.0 { [above, below] } else { [below, above] };
        match value {
            0.0 => none,
            _ if value.is_finite() => self.sign * value.log10(),
            _ => failed,
        }
    }

    fn axis(&self, label: String) -> Axis {
        let [low, high] = if self.sign < 0.0 { [-self.high, -self.low] } else { [self.low, self.high] };
        let decade = |(exponent, text)| (self.sign * f64::from(exponent), text);
        let mut ticks: Vec<(f64, String)> = decades(low as i32, high as i32).map(decade).collect();
        let half = self.width / 2.0;
        let mut range = [self.low - half, self.high + half];
        let mut bands = Vec::new();
        for (name, value) in self.outer.iter().zip([f64::INFINITY, 0.0]) {
            if let Some(name) = name {
                let at = self.at(value);
                ticks.push((at, (*name).into()));
                range = [range[0].min(at - half), range[1].max(at + half)];
                bands.push([at - half, at + half]);
            }
        }
        Axis { label, range, ticks, bands }
    }
}

/// A chart of speed against accuracy.
pub(crate) struct Speed<'a> {
    pub(crate) name: &'a str,
    pub(crate) title: String,
    pub(crate) error: &'a Quantity,
    /// What an error of 0 is called.
    pub(crate) none: &'static str,
    /// What the other axis shows.
    pub(crate) speed: String,
    /// Whether it is shown as the time for one, in ms, instead of as a throughput.
    pub(crate) times: bool,
    pub(crate) dots: Vec<Dot>,
    pub(crate) caption: Vec<String>,
}

/// A method in a chart of speed against accuracy.
pub(crate) struct Dot {
    pub(crate) name: String,
    /// Its colour; none for what does another job.
    pub(crate) hue: Option<usize>,
    /// Its errors, as printed.
    pub(crate) worst: String,
    pub(crate) mean: String,
    /// Whether an error of 0 is more than what a sample showed.
    pub(crate) exact: bool,
    /// The throughput of the slowest build, of the one in the middle, of the fastest.
    pub(crate) speed: [f64; 3],
    pub(crate) frontier: bool,
    /// Whether another measurement may say otherwise about that.
    pub(crate) close: bool,
    /// Whether it does the job.
    pub(crate) does_it: bool,
}

impl Dot {
    /// Its worst error, and its mean one.
    fn errors(&self) -> [f64; 2] {
        [&self.worst, &self.mean].map(|error| number(error))
    }

    /// What is told of its worst error, or of its mean one.
    fn told(&self, of: &Speed, error: &str, kind: Option<&'static str>) -> Told {
        let Quantity { name, unit, .. } = of.error;
        let value = match error {
            "0" => String::from(if self.exact { "exact" } else { "none found" }),
            _ => with_unit(error, unit),
        };
        // A time is so many ms where a throughput is so many in 1000 ms.
        let speed = |rate: f64| spelled(&three_digits(if of.times { 1000.0 / rate } else { rate }));
        let [low, median, high] = self.speed.map(speed);
        let [from, to] = if of.times { [high, low] } else { [low, high] };
        let builds = if from == to { String::new() } else { format!(", by build from {from} to {to}") };
        let kind_of = kind.map(|kind| format!(", {kind}")).unwrap_or_default();
        let text = format!("{}{kind_of}: {name}: {value}. {median} {}{builds}", self.name, of.speed);
        Told::Errors { text, kind }
    }
}

/// A printed error with its unit.
fn with_unit(error: &str, unit: &str) -> String {
    match error {
        "inf" => "fails".into(),
        // Which is no unit but a range.
        _ if unit.starts_with(|c: char| c.is_ascii_digit()) => format!("{} ({unit})", spelled(error)),
        _ => format!("{} {unit}", spelled(error)),
    }
}

/// Draws a chart of speed against accuracy.
pub(crate) fn speed(of: &Speed, layout: &'static Layout) -> anyhow::Result<String> {
    let Quantity { name, unit, limit } = of.error;
    let errors: Vec<[f64; 2]> = of.dots.iter().map(Dot::errors).collect();
    let differ = errors.iter().any(|[worst, mean]| worst != mean);
    let x_scale = Scale::new(&errors.iter().flatten().copied().chain([limit.0]), -1.0, ["fails", of.none]);
    let x = x_scale.axis(format!("{name}, {unit}; more accurate →"));
    let rates: Vec<[f64; 3]> = of.dots.iter().map(|dot| dot.speed.map(f64::log10)).collect();
    let y = speed_axis(rates.iter().flatten().copied(), format!("{}; faster ↑", of.speed), of.times);
    let bars = of.dots.iter().any(|dot| dot.speed[2] > 1.03 * dot.speed[0]);
    let fails = |dot: &Dot| !dot.does_it || number(&dot.worst).is_infinite();
    let legend = [
        ("■ the first method", true),
        ("● worst case", differ),
        ("○ mean", differ),
        ("× does not do the job", of.dots.iter().any(fails)),
        ("I from the slowest build to the fastest", bars),
        ("bold, on the line of steps: nothing beats these", true),
        ("≈ a close call: a tenth would decide otherwise", of.dots.iter().any(|dot| dot.close)),
    ];
    let legend: Vec<&str> = legend.iter().filter(|(_, shown)| *shown).map(|(text, _)| *text).collect();
    let words = Words { title: of.title.clone(), reading: legend.join(" · "), caption: of.caption.clone() };

    let mut card = Card::new(layout, &words, [&x, &y]);
    let at = |card: &Card, error: f64, rate: f64| card.at([x_scale.at(error), rate]);
    let mut obstacles = limit_line(&mut card, x_scale.at(limit.0), limit.1).to_vec();

    let best = of.dots.iter().zip(errors.iter().zip(&rates)).filter(|(dot, _)| dot.frontier);
    let mut best: Vec<[f64; 2]> = best.map(|(_, (error, rate))| at(&card, error[0], rate[1])).collect();
    best.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let steps = staircase(&best, &card.plot);
    card.path(&steps, "rule", 1.2, None);
    obstacles.extend(steps.windows(2).map(|ends| Rect::around([ends[0], ends[1]], 2.0)));

    let names: Vec<String> =
        of.dots.iter().map(|dot| format!("{}{}", dot.name, if dot.close { " ≈" } else { "" })).collect();
    let mut anchors = Vec::new();
    for (n, dot) in of.dots.iter().enumerate() {
        let [worst, mean] = errors[n].map(|error| at(&card, error, rates[n][1]));
        let [low, high] = [0, 2].map(|end| at(&card, errors[n][0], rates[n][end]));
        let opacity = if dot.frontier || dot.close { 1.0 } else { 0.6 };
        let class = stroke(dot.hue);
        let mark = match n {
            _ if fails(dot) => Mark::Cross,
            0 => Mark::Square,
            _ => Mark::Disc,
        };
        let kind = |kind| differ.then_some(kind);
        card.of(&dot.name, |card| {
            if low[1] - high[1] > 12.0 {
                let cap = |[x, y]: [f64; 2]| [[x - 4.0, y], [x + 4.0, y]];
                card.line([low, high], &class, 1.5, None);
                [low, high].into_iter().for_each(|end| card.line(cap(end), &class, 1.5, None));
                obstacles.push(Rect::around([low, high], 4.0));
            }
            if mean == worst {
                let told = dot.told(of, &dot.worst, kind("worst case and mean"));
                card.mark(worst, mark, dot.hue, opacity, Some(&told));
            } else {
                card.line([worst, mean], &class, 0.8, None);
                card.mark(mean, Mark::Ring, dot.hue, opacity, Some(&dot.told(of, &dot.mean, kind("mean"))));
                card.mark(worst, mark, dot.hue, opacity, Some(&dot.told(of, &dot.worst, kind("worst case"))));
                obstacles.push(Rect::around([worst, mean], 1.0));
                obstacles.push(Rect::about(mean, 11.0, 11.0));
            }
        });
        obstacles.push(Rect::about(worst, 13.0, 13.0));
        anchors.push((worst, card.label_size(&names[n])));
    }
    for (n, label) in place(&anchors, &obstacles, card.plot).into_iter().enumerate() {
        let dot = &of.dots[n];
        let label = label.with_context(|| format!("{}: no room for the label {}", of.name, dot.name))?;
        card.of(&dot.name, |card| card.label(&names[n], &label, dot.hue, dot.frontier));
    }
    Ok(card.finish())
}

/// The vertical line of what cannot be told from exact, with its name on top. Returns where both are.
fn limit_line(card: &mut Card, at: f64, name: &str) -> [Rect; 2] {
    let [x, _] = card.at([at, 0.0]);
    let ends = [[x, card.plot.top], [x, card.plot.bottom]];
    card.line(ends, "rule", 1.0, Some("5 4"));
    let size = card.layout.label;
    let (width, text) = (text_width(name, size), format!("{name} →"));
    let width = width + 2.0 * size;
    // To the right of the line, if there is room.
    let (left, anchor) =
        if x + 4.0 + width < card.plot.right { (x + 4.0, "start") } else { (x - 4.0 - width, "end") };
    let from = if anchor == "start" { left } else { x - 5.0 };
    card.text(&text, [from, card.plot.top + size], "ink", anchor, size, false);
    [
        Rect::around([[left, card.plot.top], [left + width, card.plot.top + size + 4.0]], 0.0),
        Rect::around(ends, 2.0),
    ]
}

/// The border of what the points beat: from the left edge over the first one, down and right to the last one,
/// and down to the foot.
fn staircase(points: &[[f64; 2]], plot: &Rect) -> Vec<[f64; 2]> {
    let Some(last) = points.last() else { return Vec::new() };
    let mut steps = vec![[plot.left, points[0][1]]];
    for pair in points.windows(2) {
        steps.extend([pair[0], [pair[0][0], pair[1][1]]]);
    }
    steps.extend([*last, [last[0], plot.bottom]]);
    steps
}

/// An axis of throughputs, whose logarithms these are, or of the times for one: ticks at 1, 2 and 5 where there
/// are few decades.
fn speed_axis(rates: impl Iterator<Item = f64>, label: String, times: bool) -> Axis {
    let (low, high) =
        rates.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
    let margin = (0.6 - (high - low)).max(0.0) / 2.0 + 0.12 * (high - low).max(0.5);
    let range = [low - margin, high + margin];
    let steps: &[f64] = match range[1] - range[0] {
        span if span < 0.9 => &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0],
        span if span < 3.0 => &[1.0, 2.0, 5.0],
        _ => &[1.0],
    };
    let decades = range.map(|end| if times { 3.0 - end } else { end });
    let decades = decades[0].min(decades[1]).floor() as i32..=decades[0].max(decades[1]).ceil() as i32;
    let values = decades.flat_map(|exponent| steps.iter().map(move |step| step * 10f64.powi(exponent)));
    // A time in ms is 1000 over the throughput.
    let tick = |value: f64| (if times { 3.0 - value.log10() } else { value.log10() }, plain(value));
    let ticks = values.map(tick).filter(|tick| (range[0]..range[1]).contains(&tick.0)).collect();
    Axis { label, range, ticks, bands: Vec::new() }
}

/// A tick's value without noise behind the point.
fn plain(value: f64) -> String {
    let digits = if value >= 10.0 { 0 } else { (1.0 - value.log10().floor()) as usize };
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

/// A chart of lines.
pub(crate) struct Lines<'a> {
    pub(crate) name: &'a str,
    pub(crate) title: String,
    pub(crate) reading: String,
    /// What the horizontal axis shows, and whether it falls to the right.
    pub(crate) across: String,
    pub(crate) falling: bool,
    pub(crate) what: &'a str,
    pub(crate) unit: &'a str,
    /// A height to stay under, and its name.
    pub(crate) limit: Option<(f64, &'a str)>,
    pub(crate) lines: Vec<Line>,
    pub(crate) caption: Vec<String>,
}

impl Lines<'_> {
    /// What its lines go along, without the words that say which way.
    fn along(&self) -> &str {
        self.across.trim_end_matches(" →").trim_end_matches("; harder")
    }

    /// What is told of a point of a line.
    fn told(&self, line: &Line, (at, value): (f64, f64)) -> Told {
        let [at, value] = [
            plain_number(at),
            if value == 0.0 { "none".into() } else { with_unit(&three_digits(value), self.unit) },
        ];
        let text = format!("{}: {} {value} ({}: {at})", line.name, self.what, self.along());
        Told::Value { text, at, value }
    }
}

/// A place on an axis: whole numbers of some digits as such.
fn plain_number(at: f64) -> String {
    if at.fract() == 0.0 && at.abs() < 1e7 { at.to_string() } else { spelled(&three_digits(at)) }
}

/// A line of such a chart.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    pub(crate) name: String,
    /// Its colour; none for what does another job.
    pub(crate) hue: Option<usize>,
    pub(crate) points: Series,
    /// The point that is ringed.
    pub(crate) ringed: Option<usize>,
    /// Whether a method does the job whose line it is.
    pub(crate) does_it: bool,
}

/// Draws a chart of lines in each layout: the names of files, without their ending, and what is in them.
pub(crate) fn lines_in_each_layout(of: &Lines) -> anyhow::Result<Vec<(String, String)>> {
    LAYOUTS.iter().map(|layout| Ok((format!("{}{}", of.name, layout.ending), lines(of, layout)?))).collect()
}

/// Draws a chart of lines.
pub(crate) fn lines(of: &Lines, layout: &'static Layout) -> anyhow::Result<String> {
    let values = || of.lines.iter().flat_map(|line| line.points.iter());
    let limits = of.limit.map(|limit| limit.0);
    let y_scale = Scale::new(&values().map(|point| point.1).chain(limits), 1.0, ["fails", "none"]);
    let y = y_scale.axis(format!("{}, {}; lower is better", of.what, of.unit));
    let x_scale = Scale::new(&values().map(|point| point.0), if of.falling { -1.0 } else { 1.0 }, ["∞", "0"]);
    let mut x = x_scale.axis(of.across.clone());
    // Room for the labels, which stand to the right of the last points.
    x.range[1] += (x.range[1] - x.range[0]) * 0.28;

    let words = Words { title: of.title.clone(), reading: of.reading.clone(), caption: of.caption.clone() };
    let mut card = Card::new(layout, &words, [&x, &y]);
    card.across(of.along());
    let mut obstacles = Vec::new();
    let limit = of.limit.map(|(limit, name)| (card.at([0.0, y_scale.at(limit)])[1], name));
    if let Some((height, _)) = limit {
        let ends = [[card.plot.left, height], [card.plot.right, height]];
        card.line(ends, "rule", 1.0, Some("5 4"));
        obstacles.push(Rect::around(ends, 2.0));
    }
    let mut anchors = Vec::new();
    for (n, line) in of.lines.iter().enumerate() {
        let path: Vec<[f64; 2]> =
            line.points.iter().map(|point| card.at([x_scale.at(point.0), y_scale.at(point.1)])).collect();
        let class = stroke(line.hue);
        // The first ones are the thickest, so that lines on top of each other are all seen.
        let width = 1.8 + 0.6 * (of.lines.len() - 1 - n).min(5) as f64;
        card.of(&line.name, |card| {
            card.path(&path, &class, width, None);
            for (place, point) in path.iter().zip(&line.points) {
                card.mark(*place, Mark::Dot, line.hue, 1.0, Some(&of.told(line, *point)));
            }
            if let Some(ringed) = line.ringed {
                card.mark(path[ringed], Mark::Halo, line.hue, 1.0, None);
                obstacles.push(Rect::about(path[ringed], 18.0, 18.0));
            }
        });
        obstacles.extend(path.windows(2).flat_map(|ends| along(ends[0], ends[1])));
        anchors.push((*path.last().unwrap_or(&[0.0; 2]), card.label_size(&line.name)));
    }
    if let Some((height, name)) = limit {
        obstacles.push(name_limit(&mut card, height, name, &obstacles[1..]));
    }
    for (line, label) in of.lines.iter().zip(place(&anchors, &obstacles, card.plot)) {
        let label = label.with_context(|| format!("{}: no room for the label {}", of.name, line.name))?;
        card.of(&line.name, |card| card.label(&line.name, &label, line.hue, false));
    }
    Ok(card.finish())
}

/// Writes the name of a horizontal line at that height, above it or below, as far to the right as it covers nothing, or else as
/// little as can be. Returns where it is.
fn name_limit(card: &mut Card, height: f64, name: &str, obstacles: &[Rect]) -> Rect {
    let (size, width) = (card.layout.label, text_width(name, card.layout.label));
    let plot = card.plot;
    let rect = |right: f64, foot: f64| Rect::around([[right - width, foot - size], [right, foot + 4.0]], 0.0);
    let feet = [height - 5.0, height + size + 4.0];
    let rights =
        (0..).map(|step| plot.right - 4.0 - 8.0 * f64::from(step)).take_while(|x| x - width > plot.left);
    let covered = |&[right, foot]: &[f64; 2]| {
        let rect = rect(right, foot);
        let below = if rect.bottom > plot.bottom { obstacles.len() } else { 0 };
        below + obstacles.iter().filter(|other| other.overlaps(&rect)).count()
    };
    let places = rights.flat_map(|right| feet.map(|foot| [right, foot]));
    let [right, foot] = places.min_by_key(covered).unwrap_or([plot.right - 4.0, feet[0]]);
    card.text(name, [right, foot], "ink", "end", size, false);
    rect(right, foot)
}

/// Small rectangles along a line.
fn along(a: [f64; 2], b: [f64; 2]) -> impl Iterator<Item = Rect> {
    let count = ((b[0] - a[0]).hypot(b[1] - a[1]) / 8.0).ceil().max(1.0) as u32;
    (0..=count).map(move |n| {
        let t = f64::from(n) / f64::from(count);
        Rect::about([0, 1].map(|i| a[i] + t * (b[i] - a[i])), 9.0, 9.0)
    })
}

/// Methods with the same points as one line each.
pub(crate) fn alike(methods: &[&str], wrong: &[&str], series: &[Series]) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    let hues = hues(methods.iter().map(|method| !wrong.contains(method)));
    for ((method, hue), points) in methods.iter().zip(hues).zip(series) {
        match lines.iter_mut().find(|line| line.points == *points) {
            Some(line) => {
                line.name.push_str(", ");
                line.name.push_str(method);
                line.does_it |= !wrong.contains(method);
                line.hue = line.hue.or(hue);
            }
            None => lines.push(Line {
                name: (*method).into(),
                hue,
                points: points.clone(),
                ringed: None,
                does_it: !wrong.contains(method),
            }),
        }
    }
    if let [line] = &mut lines[..]
        && methods.len() > MOST_NAMES
    {
        line.name = format!("all {} methods", methods.len());
    }
    lines
}

/// Where all methods share a line, so many are named beside it.
const MOST_NAMES: usize = 4;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_staircase_goes_down_to_the_right() {
        let plot = Rect { left: 0.0, top: 0.0, right: 100.0, bottom: 80.0 };
        let steps = staircase(&[[20.0, 10.0], [60.0, 30.0]], &plot);
        assert_eq!(steps, [[0.0, 10.0], [20.0, 10.0], [20.0, 30.0], [60.0, 30.0], [60.0, 80.0]]);
        assert!(staircase(&[], &plot).is_empty());
    }

    #[test]
    fn methods_with_equal_points_share_a_line() {
        let lines = alike(&["a", "b", "c"], &["b"], &[vec![(1.0, 0.0)], vec![(1.0, 2.0)], vec![(1.0, 0.0)]]);
        let lines: Vec<(&str, Option<usize>, bool)> =
            lines.iter().map(|line| (line.name.as_str(), line.hue, line.does_it)).collect();
        assert_eq!(lines, [("a, c", Some(0), true), ("b", None, false)]);
    }

    #[test]
    fn exact_and_failed_lie_outside_the_scale() {
        let scale = Scale::new(&[0.01, 10.0, 0.0, f64::INFINITY].into_iter(), -1.0, ["fails", "exact"]);
        let [failed, worst, best, exact] = [f64::INFINITY, 10.0, 0.01, 0.0].map(|error| scale.at(error));
        assert!(failed < worst && worst < best && best < exact);
        let axis = scale.axis(String::new());
        assert!(axis.range[0] < failed && exact < axis.range[1]);
    }
}
