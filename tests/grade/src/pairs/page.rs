//! The pairs for a person to look at: a page with their passages side by side, and a table.

use anyhow::anyhow;
use askama::Template;
use judge::message;

use super::compare::{Shares, passages};
use super::tokens::line;
use super::{Found, Lesson, Note, Options, Pair, Text, percent};
use crate::report::harmless;

/// How many passages of a pair are shown, the longest ones.
const MOST: usize = 12;
/// How much of a passage is shown, in bytes.
const LONGEST: usize = 8 << 10;

/// The page as `templates/pairs.html` lays it out.
#[derive(Template)]
#[template(path = "pairs.html")]
struct Page<'a> {
    least: usize,
    above: usize,
    notes: &'a [Note],
    lessons: Vec<Row<'a>>,
    pairs: Vec<Shown<'a>>,
    /// Who handed in the same text: lesson, names.
    same: Vec<(&'a str, String)>,
}

/// A lesson in numbers.
struct Row<'a> {
    name: &'a str,
    texts: usize,
    short: usize,
    common: usize,
    pairs: usize,
    /// The share that half of the pairs, nine of ten, and all but one in a hundred do not reach.
    quantiles: [String; 3],
}

struct Shown<'a> {
    lesson: &'a str,
    sides: [Side<'a>; 2],
    passages: Vec<[Excerpt; 2]>,
    /// How many more there are.
    more: usize,
}

struct Side<'a> {
    name: &'a str,
    /// How many others handed in the same text.
    others: usize,
    given: bool,
    percent: usize,
}

/// Some lines of a text.
struct Excerpt {
    /// The first and the last one, from 1.
    lines: [usize; 2],
    before: String,
    passage: String,
    after: String,
}

/// The page of all pairs.
pub(super) fn page(found: &Found, options: &Options) -> anyhow::Result<String> {
    let same = found.lessons.iter().flat_map(|lesson| {
        let several = lesson.texts.iter().filter(|text| text.names.len() > 1);
        several.map(|text| (lesson.name.as_str(), text.names.join(", ")))
    });
    let page = Page {
        least: percent(options.least),
        above: found.above,
        notes: &found.notes,
        lessons: found.lessons.iter().map(row).collect(),
        pairs: found.pairs.iter().map(|pair| shown(found, pair)).collect(),
        same: same.collect(),
    };
    Ok(page.render()?)
}

fn row(lesson: &Lesson) -> Row<'_> {
    let pairs = lesson.counts.iter().sum();
    let reached = |of_100: usize| {
        let mut seen = 0;
        let reached = lesson.counts.iter().position(|count| {
            seen += count;
            seen * 100 >= pairs * of_100
        });
        if pairs == 0 {
            "–".into()
        } else {
            reached.map_or_else(String::new, |percent| format!("{percent} %"))
        }
    };
    Row {
        name: &lesson.name,
        texts: lesson.texts.iter().filter(|text| !text.given).count(),
        short: lesson.short,
        common: lesson.common,
        pairs,
        quantiles: [50, 90, 99].map(reached),
    }
}

fn shown<'a>(found: &'a Found, pair: &Pair) -> Shown<'a> {
    let lesson = &found.lessons[pair.lesson];
    let [first, second] = pair.texts.map(|n| &lesson.texts[n]);
    let mut all = first.with(second).map(|(one, other)| passages(one, other)).unwrap_or_default();
    let more = all.len().saturating_sub(MOST);
    all.sort_by_key(|passage| (std::cmp::Reverse(passage.here.len()), passage.here.start));
    all.truncate(MOST);
    all.sort_by_key(|passage| passage.here.start);
    let passages = all
        .into_iter()
        .map(|passage| [excerpt(first, passage.here), excerpt(second, passage.there)])
        .collect();
    let side = |text: &'a Text, share| Side {
        name: &text.names[0],
        others: text.names.len() - 1,
        given: text.given,
        percent: percent(share),
    };
    Shown {
        lesson: &lesson.name,
        sides: [side(first, pair.shares.of_first), side(second, pair.shares.of_second)],
        passages,
        more,
    }
}

/// The lines of a passage, which is given in tokens.
fn excerpt(text: &Text, tokens: std::ops::Range<usize>) -> Excerpt {
    let places = &text.tokens.places[tokens];
    let whole = text.text.as_str();
    let (begin, end) = match places {
        [first, .., last] => (first.start, last.end),
        _ => (0, 0),
    };
    let from = whole[..begin].rfind('\n').map_or(0, |at| at + 1);
    let to = whole[end..].find('\n').map_or(whole.len(), |at| end + at);
    Excerpt {
        lines: [line(whole, begin), line(whole, end)],
        before: message::cut(&whole[from..begin]),
        passage: message::cut_to(&whole[begin..end], LONGEST),
        after: message::cut(&whole[end..to]),
    }
}

/// A row for each pair. Those who handed in the same text are a pair of the first with each of the others; in other rows
/// the first stands for all of them.
pub(super) fn table(found: &Found) -> anyhow::Result<Vec<u8>> {
    // The mark by which Excel knows UTF-8.
    let mut table = csv::Writer::from_writer("\u{feff}".as_bytes().to_vec());
    table.write_record(["lesson", "first", "second", "percent of first", "percent of second"])?;
    for lesson in &found.lessons {
        for text in &lesson.texts {
            for other in &text.names[1..] {
                table.write_record([
                    &lesson.name,
                    &harmless(&text.names[0]),
                    &harmless(other),
                    "100",
                    "100",
                ])?;
            }
        }
    }
    for pair in &found.pairs {
        let lesson = &found.lessons[pair.lesson];
        let [first, second] = pair.texts.map(|n| harmless(&lesson.texts[n].names[0]));
        let Shares { of_first, of_second } = pair.shares;
        let [of_first, of_second] = [of_first, of_second].map(|share| percent(share).to_string());
        table.write_record([&lesson.name, &first, &second, &of_first, &of_second])?;
    }
    table.into_inner().map_err(|error| anyhow!("{error}"))
}
