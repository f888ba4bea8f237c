//! The two kinds of chart: speed against accuracy, and error against stress.

use anyhow::Context;
use plotters::style::text_anchor::HPos;
use plotters::style::{Color, FontStyle, RGBColor};

use super::frame::{Axis, COLORS, Frame, GRAY, INK, LABEL, Mark, Words, chart, decades, label_size};
use super::place::{Rect, place};
use super::table::{Chart, Quantity, Row, Series, number};

/// What is drawn where an error has no place on a logarithmic axis.
struct Columns {
    low: f64,
    high: f64,
    width: f64,
    /// Whether what failed and what is exact have a column.
    outer: [bool; 2],
}

impl Columns {
    /// For these values and the limit; the axis shows `sign`·log₁₀.
    fn new(values: &(impl Iterator<Item = f64> + Clone), sign: f64, always_exact: bool) -> Self {
        let finite = values.clone().filter(|value| value.is_finite() && *value > 0.0).map(f64::log10);
        let (low, high) =
            finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
        let (low, high) = if low > high { (0.0, 0.0) } else { (low.floor(), high.ceil()) };
        let low = low.min(high - 2.0);
        let outer =
            [values.clone().any(f64::is_infinite), always_exact || values.clone().any(|value| value == 0.0)];
        let [low, high] = if sign < 0.0 { [-high, -low] } else { [low, high] };
        Self { low, high, width: (high - low) * 0.09, outer }
    }

    /// Where a value is on an axis on which the better side is `better` (1 right or up, −1).
    fn at(&self, value: f64, sign: f64) -> f64 {
        let (exact, failed) = if sign < 0.0 {
            (self.high + self.width, self.low - self.width)
        } else {
            (self.low - self.width, self.high + self.width)
        };
        if value == 0.0 {
            exact
        } else if value.is_finite() {
            sign * value.log10()
        } else {
            failed
        }
    }

    fn axis(&self, sign: f64, label: String) -> Axis {
        let [low, high] = if sign < 0.0 { [-self.high, -self.low] } else { [self.low, self.high] };
        let mut ticks: Vec<(f64, String)> = decades(low as i32, high as i32)
            .map(|(exponent, text)| (sign * f64::from(exponent), text))
            .collect();
        let [failed, exact] = self.outer;
        let half = self.width / 2.0;
        let mut range = [self.low - half, self.high + half];
        let mut bands = Vec::new();
        for (shown, value, name) in [(failed, f64::INFINITY, "fails"), (exact, 0.0, "exact")] {
            if shown {
                let at = self.at(value, sign);
                ticks.push((at, name.into()));
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
    pub(crate) worst: f64,
    pub(crate) mean: f64,
    /// Quartiles of the throughput: 25 %, 50 %, 75 %.
    pub(crate) speed: [f64; 3],
    pub(crate) frontier: bool,
}

/// Draws the rows of a table of methods.
pub(crate) fn table(of: &Chart, rows: &[Row], caption: &str) -> anyhow::Result<String> {
    let bound =
        if of.exhaustive { "all of them: worst cases are maxima" } else { "worst cases are lower bounds" };
    let dot = |row: &Row| Dot {
        name: row.method.clone(),
        worst: number(&row.error_max),
        mean: number(&row.error_mean),
        speed: [&row.throughput_p25, &row.throughput_median, &row.throughput_p75].map(|text| number(text)),
        frontier: row.frontier,
    };
    speed(&Speed {
        name: of.name,
        title: of.job.into(),
        error: &of.error,
        speed: of.throughput.into(),
        times: false,
        dots: rows.iter().map(dot).collect(),
        caption: vec![
            format!("Errors over {}; {bound}.", of.samples),
            format!("Timed: {}; methods in turn.", of.timed),
            caption.into(),
        ],
    })
}

/// Draws a chart of speed against accuracy.
pub(crate) fn speed(of: &Speed) -> anyhow::Result<String> {
    let Quantity { name, unit, limit } = of.error;
    let errors: Vec<[f64; 2]> = of.dots.iter().map(|dot| [dot.worst, dot.mean]).collect();
    let columns = Columns::new(&errors.iter().flatten().copied().chain([limit.0]), -1.0, true);
    let x = columns.axis(-1.0, format!("{name}, {unit} — more accurate →"));
    let rates: Vec<[f64; 3]> = of.dots.iter().map(|dot| dot.speed.map(f64::log10)).collect();
    let y = speed_axis(rates.iter().flatten().copied(), format!("{} — faster →", of.speed), of.times);
    let mut legend = String::new();
    if errors.iter().any(|[worst, mean]| worst != mean) {
        legend.push_str("● worst case · ○ mean · ");
    }
    legend.push_str(
        "■ the first method · │ quartiles of speed · ┐ frontier: nothing beats these · pale: beaten",
    );
    if errors.iter().flatten().any(|error| error.is_infinite()) {
        legend.push_str(" · × none");
    }
    let words = Words {
        title: format!("{}: right is more accurate, up is faster", of.title),
        reading: vec![format!("Pick the fastest one right of the dashed line ({}).", limit.1), legend],
        caption: &of.caption,
    };
    chart(&words, [&x, &y], |frame| {
        let at = |error: f64, rate: f64| frame.at([columns.at(error, -1.0), rate]);
        let mut obstacles = limit_line(frame, columns.at(limit.0, -1.0), limit.1)?.to_vec();

        let best = of.dots.iter().zip(errors.iter().zip(&rates)).filter(|(dot, _)| dot.frontier);
        let mut best: Vec<[f64; 2]> = best.map(|(_, (error, rate))| at(error[0], rate[1])).collect();
        best.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let steps = staircase(&best, &frame.plot);
        frame.path(&steps, COLORS[0].mix(0.55), 2)?;
        obstacles.extend(steps.windows(2).map(|ends| Rect::around([ends[0], ends[1]], 2.0)));

        let mut anchors = Vec::new();
        for (n, dot) in of.dots.iter().enumerate() {
            let color = if dot.frontier { COLORS[0].mix(1.0) } else { GRAY.mix(0.5) };
            let [worst, mean] = errors[n].map(|error| at(error, rates[n][1]));
            let bar = [0, 2].map(|quartile| at(errors[n][0], rates[n][quartile]));
            frame.path(&bar, color, 2)?;
            frame.path(&[worst, mean], color.mix(0.6), 1)?;
            let mark = match (errors[n][0].is_finite(), n) {
                (false, _) => Mark::Cross,
                (true, 0) => Mark::Square,
                (true, _) => Mark::Disc,
            };
            if mean != worst {
                frame.mark(mean, Mark::Ring, color)?;
            }
            frame.mark(worst, mark, color)?;
            obstacles.push(Rect::about(worst, 14.0, 14.0));
            obstacles.push(Rect::about(mean, 12.0, 12.0));
            obstacles.push(Rect::around(bar, 3.0));
            obstacles.push(Rect::around([worst, mean], 1.0));
            anchors.push((worst, label_size(&dot.name)));
        }
        for (dot, label) in of.dots.iter().zip(place(&anchors, &obstacles, frame.plot)) {
            let label = label.with_context(|| format!("{}: no room for the label {}", of.name, dot.name))?;
            frame.label(&dot.name, &label, if dot.frontier { INK } else { GRAY }, dot.frontier)?;
        }
        Ok(())
    })
}

/// The vertical line of what cannot be told from exact, with its name on top. Returns where both are.
fn limit_line(frame: &Frame, at: f64, name: &str) -> anyhow::Result<[Rect; 2]> {
    let x = frame.at([at, 0.0])[0];
    let ends = [[x, frame.plot.top], [x, frame.plot.bottom]];
    frame.dashes(ends, INK)?;
    let [width, height] = label_size(name);
    let middle = [x - width / 2.0 - 4.0, frame.plot.top + height / 2.0 + 2.0];
    let middle =
        if middle[0] - width / 2.0 < frame.plot.left { [x + width / 2.0 + 4.0, middle[1]] } else { middle };
    let place = Rect::about(middle, width, height);
    frame.text(name, [middle[0], middle[1] + 5.0], LABEL, INK, FontStyle::Italic, HPos::Center)?;
    Ok([place, Rect::around(ends, 2.0)])
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

/// A chart of lines: an error against what makes it larger.
pub(crate) struct Lines<'a> {
    pub(crate) name: &'a str,
    pub(crate) title: String,
    pub(crate) reading: String,
    /// What the horizontal axis shows, and whether it falls to the right.
    pub(crate) across: String,
    pub(crate) falling: bool,
    pub(crate) error: &'a Quantity,
    pub(crate) lines: Vec<Line>,
    pub(crate) caption: Vec<String>,
}

/// A line of such a chart.
pub(crate) struct Line {
    pub(crate) name: String,
    pub(crate) points: Series,
    /// The point that is ringed.
    pub(crate) ringed: Option<usize>,
}

/// Draws error against stress, methods that behave alike as one line, their first failures ringed.
pub(crate) fn stability(of: &Chart, series: &[Series], caption: &str) -> anyhow::Result<String> {
    let error = &of.stability.error;
    let limit = error.limit;
    let mut all = alike(&(of.methods)(), series);
    for line in &mut all {
        line.ringed = line.points.iter().position(|point| point.1 > limit.0);
    }
    lines(&Lines {
        name: of.name,
        title: format!("{}: where methods fail; lower is better", of.job),
        reading: format!(
            "◯ first failure: above the dashed line ({}). Methods with the same figures share a line.",
            limit.1
        ),
        across: format!("{} — harder →", of.stability.stress),
        falling: of.stability.falling,
        error,
        lines: all,
        caption: vec![caption.into()],
    })
}

/// Draws a chart of lines.
pub(crate) fn lines(of: &Lines) -> anyhow::Result<String> {
    let Quantity { name, unit, limit } = of.error;
    let values = || of.lines.iter().flat_map(|line| line.points.iter());
    let y_columns = Columns::new(&values().map(|point| point.1).chain([limit.0]), 1.0, false);
    let y = y_columns.axis(1.0, format!("{name}, {unit}"));
    let sign = if of.falling { -1.0 } else { 1.0 };
    let x_columns = Columns::new(&values().map(|point| point.0), sign, false);
    let mut x = x_columns.axis(sign, of.across.clone());
    // Room for the labels, which stand to the right of the last points.
    x.range[1] += (x.range[1] - x.range[0]) * 0.28;

    let words = Words { title: of.title.clone(), reading: vec![of.reading.clone()], caption: &of.caption };
    chart(&words, [&x, &y], |frame| {
        let at = |point: &(f64, f64)| frame.at([x_columns.at(point.0, sign), y_columns.at(point.1, 1.0)]);
        let height = frame.at([0.0, y_columns.at(limit.0, 1.0)])[1];
        frame.dashes([[frame.plot.left, height], [frame.plot.right, height]], INK)?;
        let mut anchors = Vec::new();
        let mut obstacles = vec![Rect::around([[frame.plot.left, height], [frame.plot.right, height]], 2.0)];
        for (n, line) in of.lines.iter().enumerate() {
            let path: Vec<[f64; 2]> = line.points.iter().map(at).collect();
            // The first ones are the thickest, so that lines on top of each other are all seen.
            let width = 2 + (of.lines.len() - 1 - n).min(6) as u32;
            frame.path(&path, color(n).mix(1.0), width)?;
            path.iter().try_for_each(|point| frame.mark(*point, Mark::Dot, color(n).mix(1.0)))?;
            if let Some(ringed) = line.ringed {
                frame.mark(path[ringed], Mark::Halo, color(n).mix(1.0))?;
                obstacles.push(Rect::about(path[ringed], 20.0, 20.0));
            }
            obstacles.extend(path.windows(2).flat_map(|ends| along(ends[0], ends[1])));
            anchors.push((*path.last().unwrap_or(&[0.0; 2]), label_size(&line.name)));
        }
        for (n, label) in place(&anchors, &obstacles, frame.plot).into_iter().enumerate() {
            let name = &of.lines[n].name;
            let label = label.with_context(|| format!("{}: no room for the label {name}", of.name))?;
            frame.label(name, &label, color(n), true)?;
        }
        Ok(())
    })
}

fn color(n: usize) -> RGBColor {
    COLORS[n % COLORS.len()]
}

/// Small rectangles along a line.
fn along(a: [f64; 2], b: [f64; 2]) -> impl Iterator<Item = Rect> {
    let count = ((b[0] - a[0]).hypot(b[1] - a[1]) / 8.0).ceil().max(1.0) as u32;
    (0..=count).map(move |n| {
        let t = f64::from(n) / f64::from(count);
        Rect::about([0, 1].map(|i| a[i] + t * (b[i] - a[i])), 10.0, 10.0)
    })
}

/// Methods with the same points as one line each.
fn alike(methods: &[&str], series: &[Series]) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for (method, points) in methods.iter().zip(series) {
        match lines.iter_mut().find(|line| line.points == *points) {
            Some(line) => {
                line.name.push_str(", ");
                line.name.push_str(method);
            }
            None => lines.push(Line { name: (*method).into(), points: points.clone(), ringed: None }),
        }
    }
    lines
}

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
        let lines = alike(&["a", "b", "c"], &[vec![(1.0, 0.0)], vec![(1.0, 2.0)], vec![(1.0, 0.0)]]);
        assert_eq!(lines.iter().map(|line| line.name.as_str()).collect::<Vec<_>>(), ["a, c", "b"]);
    }

    #[test]
    fn exact_and_failed_lie_outside_the_scale() {
        let columns = Columns::new(&[0.01, 10.0, 0.0, f64::INFINITY].into_iter(), -1.0, true);
        let [failed, worst, best, exact] =
            [f64::INFINITY, 10.0, 0.01, 0.0].map(|error| columns.at(error, -1.0));
        assert!(failed < worst && worst < best && best < exact);
        let axis = columns.axis(-1.0, String::new());
        assert!(axis.range[0] < failed && exact < axis.range[1]);
    }
}
