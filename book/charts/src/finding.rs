//! What a chart shows, in one sentence: its title, from its figures as printed.

use super::draw::Line;
use super::frontier::faster;
use super::table::{Chart, Point, Row, number};

/// Of a table: which method to take for what its limit asks, and at what price.
pub(crate) fn table(chart: &Chart, rows: &[Row]) -> String {
    let (limit, within) = chart.error.limit;
    let error = |row: &Row| number(&row.error_max);
    let speed = |row: &Row| number(&row.throughput_median);
    let does_it: Vec<&Row> = rows.iter().filter(|row| row.does_the_job && error(row).is_finite()).collect();
    let fastest = |rows: &[&Row]| rows.iter().copied().max_by(|a, b| speed(a).total_cmp(&speed(b))).cloned();
    let good: Vec<&Row> = does_it.iter().copied().filter(|row| row.frontier && error(row) <= limit).collect();
    let Some(quickest) = fastest(&does_it) else { return "No method does the job".into() };
    let off = |row: &Row| format!("{} {}", row.error_max, chart.error.unit);
    let Some(pick) = fastest(&good) else {
        let nearest = does_it.iter().min_by(|a, b| error(a).total_cmp(&error(b)));
        return nearest.map_or(String::new(), |row| {
            format!("No method stays {within}: {} comes nearest, with {}", row.method, off(row))
        });
    };
    // Those on the frontier that are as fast share the place.
    let ties = good.iter().filter(|row| !faster(pick.figure().speed, row.figure().speed));
    let names: Vec<&str> = ties.map(|row| row.method.as_str()).collect();
    let (verb, are) = if names.len() == 1 { ("is", "is") } else { ("are", "are as fast and") };
    let names = listed(&names);
    let how = if pick.is_exact(chart) { format!("{are} exact") } else { format!("{are} {within}") };
    if !faster(quickest.figure().speed, pick.figure().speed) {
        let nothing = if rows.len() == good.len() { "" } else { ", and nothing is faster" };
        return format!("{names} {how}{nothing}");
    }
    let times = times(speed(&quickest) / speed(&pick));
    format!(
        "{names} {verb} the fastest {within}; {} is {times} as fast, and off by {}",
        quickest.method,
        off(&quickest)
    )
}

/// Of lines whose first failures are ringed: which holds out, and which fails first, and where.
pub(crate) fn stability(lines: &[Line], stress: &str) -> String {
    let never: Vec<&str> =
        lines.iter().filter(|line| line.ringed.is_none()).map(|line| line.name.as_str()).collect();
    let failing = lines.iter().filter_map(|line| Some((line.ringed?, line)));
    let (first, last) = (failing.clone().min_by_key(|(at, _)| *at), failing.max_by_key(|(at, _)| *at));
    let at = |at: usize, line: &Line| super::figures::readable(line.points[at].0);
    match (first, last, never.is_empty()) {
        (Some((n, line)), _, false) => {
            let verb = if never.len() == 1 && !never[0].contains(',') { "holds" } else { "hold" };
            format!("{} {verb} throughout; {} fails first, at {}", listed(&never), line.name, at(n, line))
        }
        (Some((n, line)), Some((m, longest)), true) if n != m => format!(
            "{} fails first, at {}; {} holds longest, to {}",
            line.name,
            at(n, line),
            longest.name,
            at(m, longest)
        ),
        (Some((n, line)), _, true) => {
            let names: Vec<&str> = lines.iter().map(|line| line.name.as_str()).collect();
            format!("{} fail alike, from {} on ({stress})", listed(&names), at(n, line))
        }
        _ => format!("None fails, whatever the {stress}"),
    }
}

/// Of the cost at each size: which is the cheapest, and where that changes.
pub(crate) fn growth(chart: &Chart, points: &[Point]) -> String {
    let does_it = |point: &&Point| !chart.wrong.contains(&point.method.as_str());
    let mut cheapest: Vec<(&str, &str, &str)> = Vec::new();
    for size in sizes(points) {
        let here = points.iter().filter(|point| point.at == size).filter(does_it);
        let Some(best) = here.min_by(|a, b| number(&a.value).total_cmp(&number(&b.value))) else { continue };
        match cheapest.last_mut().filter(|last| last.0 == best.method) {
            Some(last) => last.2 = size,
            None => cheapest.push((&best.method, size, size)),
        }
    }
    let what = chart.sizes.name;
    match cheapest[..] {
        [(method, ..)] => format!("{method} is the fastest at every number of {what}"),
        [] => String::new(),
        _ => {
            let parts = cheapest.iter().enumerate().map(|(n, (method, from, to))| match n {
                0 => format!("{method} is the fastest up to {to} {what}"),
                _ => format!("{method} from {from}"),
            });
            parts.collect::<Vec<_>>().join(", ")
        }
    }
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
