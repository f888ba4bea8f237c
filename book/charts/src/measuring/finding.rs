//! What a chart shows, in one sentence: its title, from its figures as printed.

use super::digits::readable;
use super::draw::Line;
use super::frontier::is_faster;
use super::table::{Chart, Point, Row, number};

/// Of a table: which method to take for what its limit asks, and at what price.
pub(crate) fn table(chart: &Chart, rows: &[Row]) -> String {
    let (limit, within) = chart.error.limit;
    let error = |row: &Row| number(&row.error_max);
    let speed = |row: &Row| number(&row.throughput_median);
    let does_it: Vec<&Row> = rows.iter().filter(|row| row.does_the_job && error(row).is_finite()).collect();
    let fastest = |rows: &[&Row]| rows.iter().copied().max_by(|a, b| speed(a).total_cmp(&speed(b))).cloned();
    let good: Vec<&Row> = does_it.iter().copied().filter(|row| row.frontier && error(row) <= limit).collect();
    let faster = |a: &Row, b: &Row| is_faster(&a.figure(), &b.figure());
    let Some(quickest) = fastest(&does_it) else { return "No method does the job".into() };
    let off = |row: &Row| format!("{} {}", readable(error(row)), chart.error.unit);
    let Some(pick) = fastest(&good) else {
        let mean = |row: &Row| number(&row.error_mean);
        let nearest = does_it.iter().min_by(|a, b| mean(a).total_cmp(&mean(b)));
        return nearest.map_or(String::new(), |row| {
            format!(
                "No method stays {within}: {} comes nearest, {} off in the mean and {} at worst",
                row.method,
                readable(mean(row)),
                off(row)
            )
        });
    };
    // Those on the frontier that are as fast share the place.
    let ties = good.iter().filter(|row| !faster(&pick, row));
    let names: Vec<&str> = ties.map(|row| row.method.as_str()).collect();
    let (verb, are) = if names.len() == 1 { ("is", "is") } else { ("are", "are equally fast and") };
    let names = listed(&names);
    let how = if pick.is_exact(chart) { format!("{are} exact") } else { format!("{are} {within}") };
    if !faster(&quickest, &pick) {
        let nothing = if rows.len() == good.len() { "" } else { ", and nothing is clearly faster" };
        return format!("{names} {how}{nothing}");
    }
    let times = times(speed(&quickest) / speed(&pick));
    format!(
        "{names} {verb} the fastest {within}; {} is {times} as fast, and off by {}",
        quickest.method,
        off(&quickest)
    )
}

/// Of lines whose first failures are ringed: which holds out, and which fails first, and where. What does another job
/// is not spoken of.
pub(crate) fn stability(lines: &[Line], stress: &str) -> String {
    let lines: Vec<&Line> = lines.iter().filter(|line| line.does_it).collect();
    let never: Vec<&str> =
        lines.iter().filter(|line| line.ringed.is_none()).map(|line| line.name.as_str()).collect();
    let failing = lines.iter().filter_map(|line| Some((line.ringed?, *line)));
    let at = |at: usize, line: &Line| readable(line.points[at].0);
    let first = failing.clone().min_by_key(|(at, _)| *at);
    let last = failing.max_by_key(|(at, _)| *at);
    let (Some((n, first)), Some((m, last))) = (first, last) else {
        return format!("None fails, whatever the {stress}");
    };
    let fail = if first.name.contains(',') { "fail" } else { "fails" };
    let (who, begin) = (named(&first.name), at(n, first));
    match never[..] {
        [] if n == m => format!("{who} {fail} from {begin} on"),
        [] => format!("{who} {fail} first, at {begin}; {} last, at {}", last.name, at(m, last)),
        [name] if !name.contains(',') => format!("{name} holds throughout; {who} {fail} first, at {begin}"),
        ref names => {
            let names = listed(names);
            let names = match names.matches(' ').count() {
                0..=3 => names,
                _ if never.len() + 1 == lines.len() => "all others".into(),
                // Some of the others fail as well, only later.
                _ => format!("{} others", never.iter().map(|line| line.split(", ").count()).sum::<usize>()),
            };
            format!("{who} {fail} first, at {begin}; {names} hold throughout")
        }
    }
}

/// A method's name in a sentence: in quotes where it would be read as one of the sentence's own words.
fn named(name: &str) -> String {
    if name == "none" { format!("“{name}”") } else { name.into() }
}

/// Of the cost at each size: which method is the fastest, and where that changes. One within a tenth is a tie with it: each
/// is chosen to stay so over as many sizes as may be, the last one of the table where they are equal.
pub(crate) fn growth(chart: &Chart, points: &[Point]) -> String {
    const TIE: f64 = 1.1;
    let sizes = sizes(points);
    let methods: Vec<&str> =
        (chart.methods)().into_iter().filter(|name| !chart.wrong.contains(name)).collect();
    let cost = |method: &str, size: &str| {
        let point = points.iter().find(|point| point.method == method && point.at == size);
        point.map_or(f64::INFINITY, |point| number(&point.value))
    };
    let is_fastest =
        |method: &str, size: &str| methods.iter().all(|other| cost(method, size) <= TIE * cost(other, size));
    let mut parts: Vec<(&str, &str, &str)> = Vec::new();
    let mut at = 0;
    while at < sizes.len() {
        let reach = |method: &str| sizes[at..].iter().take_while(|size| is_fastest(method, size)).count();
        let Some(best) = methods.iter().max_by_key(|method| reach(method)) else { break };
        let end = at + reach(best).max(1);
        parts.push((best, sizes[at], sizes[end - 1]));
        at = end;
    }
    let what = chart.sizes.name;
    if let [(method, ..)] = parts[..] {
        return format!("{method} is the fastest or nearly so at any number of {what}");
    }
    let parts = parts.iter().enumerate().map(|(n, (method, from, to))| match n {
        0 if from == to => format!("{method} is the fastest or nearly so at {}", counted(to, what)),
        0 => format!("{method} is the fastest or nearly so up to {to} {what}"),
        _ => format!("{method} from {from}"),
    });
    parts.collect::<Vec<_>>().join(", ")
}

/// So many of what is counted, as `1 pixel a segment`.
fn counted(size: &str, what: &str) -> String {
    let (first, rest) = what.split_at(what.find(' ').unwrap_or(what.len()));
    format!("{size} {}{rest}", if size == "1" { first.trim_end_matches('s') } else { first })
}

/// The sizes, in order.
pub(crate) fn sizes(points: &[Point]) -> Vec<&str> {
    let mut sizes: Vec<&str> = points.iter().map(|point| point.at.as_str()).collect();
    sizes.sort_by(|a, b| number(a).total_cmp(&number(b)));
    sizes.dedup();
    sizes
}

/// Names with commas and an `and`.
fn listed(names: &[&str]) -> String {
    match names {
        [] => "nothing".into(),
        [name] => (*name).into(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// A ratio in words.
pub(crate) fn times(ratio: f64) -> String {
    if ratio < 10.0 { format!("{ratio:.1} times") } else { format!("{ratio:.0} times") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(name: &str, ringed: Option<usize>) -> Line {
        let points = vec![(1.0, 0.0), (100.0, 2.0), (1e6, 3.0)];
        Line { name: name.into(), hue: None, points, ringed, does_it: true }
    }

    #[test]
    fn what_holds_and_what_fails_first_is_told() {
        let text = |lines: &[Line]| stability(lines, "length");
        assert_eq!(text(&[line("a", Some(1)), line("b", None)]), "b holds throughout; a fails first, at 100");
        assert_eq!(text(&[line("a", Some(1)), line("b", Some(2))]), "a fails first, at 100; b last, at 10⁶");
        assert_eq!(text(&[line("a, b", Some(0)), line("c", Some(0))]), "a, b fail from 1 on");
        assert_eq!(text(&[line("a", None)]), "None fails, whatever the length");
        let another = Line { does_it: false, ..line("c", Some(0)) };
        let lines = [another, line("a", Some(1)), line("b", None)];
        assert_eq!(text(&lines), "b holds throughout; a fails first, at 100");
        let all = [line("a", Some(1)), line("b, c, d, e, f", None), line("g", None)];
        assert_eq!(text(&all), "a fails first, at 100; all others hold throughout");
        let later = [&all[..], &[line("h", Some(2))]].concat();
        assert_eq!(text(&later), "a fails first, at 100; 6 others hold throughout");
    }

    #[test]
    fn one_is_no_plural() {
        let texts = [("1", "pixels a segment"), ("10", "pixels a segment"), ("1", "products")];
        let texts = texts.map(|(size, what)| counted(size, what));
        assert_eq!(texts, ["1 pixel a segment", "10 pixels a segment", "1 product"]);
    }

    #[test]
    fn a_tie_stays_the_fastest() {
        let chart =
            crate::lessons::all_charts().into_iter().find(|chart| chart.name == "03-triangles").unwrap();
        let of = |method: &str, costs: [f64; 3]| -> Vec<Point> {
            let point = |(at, cost): (&str, f64)| Point {
                method: method.into(),
                at: at.into(),
                value: cost.to_string(),
            };
            ["1", "10", "100"].into_iter().zip(costs).map(point).collect()
        };
        let points =
            [of("sweep", [1.0, 2.0, 9.0]), of("edges", [3.0, 1.9, 1.0]), of("outline", [0.1, 0.1, 0.1])];
        let expected = "sweep is the fastest or nearly so up to 10 pixels a triangle, edges from 100";
        assert_eq!(growth(chart, &points.concat()), expected);
        let points = [of("sweep", [1.0, 2.0, 9.0]), of("edges", [1.05, 1.9, 1.0])].concat();
        assert_eq!(
            growth(chart, &points),
            "edges is the fastest or nearly so at any number of pixels a triangle"
        );
    }
}
