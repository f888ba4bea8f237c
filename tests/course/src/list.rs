//! The missions as a list in 80 columns: what is done, what is next, and by which command.

use judge::marks::{Mark, Standing, current};
use tasks::{name, number};

use super::{Missions, hints};

/// How many characters a bar has: one for each of a mission's points.
const BAR: u32 = 10;

/// The list. What is styled has bold and coloured parts, by the codes of ECMA-48.
#[must_use]
pub fn told(missions: &Missions, styled: bool) -> String {
    let paint = |code: &str, text: String| if styled { format!("\x1b[{code}m{text}\x1b[0m") } else { text };
    let all = &missions.all;
    let done = all.iter().filter(|one| one.is_done()).count();
    let current = current(all);
    let titles: Vec<String> = all.iter().map(|one| title(missions, one)).collect();
    let wide = |widths: &mut dyn Iterator<Item = usize>| widths.max().unwrap_or(0);
    let title_width = wide(&mut titles.iter().map(|title| title.chars().count()));
    let name_width = wide(&mut all.iter().map(|one| name(&one.lesson).chars().count()));

    let head = format!("Pixel by Pixel: {done} of {} missions done", all.len());
    let mut text = paint("1", head) + "\n\n";
    for (one, title) in all.iter().zip(&titles) {
        let is_next = current.is_some_and(|next| next.lesson == one.lesson);
        let sign = if one.is_done() {
            '✓'
        } else if is_next {
            '→'
        } else {
            ' '
        };
        let row = format!(
            "  {sign} {:>2}  {title:title_width$}  my-{:name_width$}  {}",
            number(&one.lesson),
            name(&one.lesson),
            one.mark.as_ref().map_or_else(|| "·".repeat(BAR as usize), points),
        );
        text += &match (one.is_done(), is_next) {
            (true, _) => paint("32", row),
            (_, true) => paint("1", row),
            _ => row,
        };
        text.push('\n');
    }
    for broken in all.iter().filter_map(|one| one.broken.as_ref()) {
        text += &format!("\n{broken}\n");
    }
    text.push('\n');
    let Some(next) = current else {
        return text + "All are done. Each chapter's mission ends with two open exercises, to go on with.\n";
    };
    text += &format!("Next is {}.\n", lower(&missions.place(next)));
    let opened = match hints::count(missions, next) {
        Some((opened, of)) => format!("opens a hint of its chapter; {opened} of {of} are open"),
        None => "opens a hint of its chapter".into(),
    };
    for (command, does) in [
        ("next", "starts it, and runs it again whenever you save"),
        ("hint", &opened),
        ("book", "opens its chapter in a browser"),
    ] {
        text += &format!("  cargo run -p course -- {command}   {does}\n");
    }
    text
}

/// A bar, and the points in numbers.
fn points(mark: &Mark) -> String {
    let full = BAR * mark.earned / mark.of;
    let bar = "■".repeat(full as usize) + &"·".repeat((BAR - full) as usize);
    let changed = if mark.changed { "  changed since" } else { "" };
    format!("{bar}  {:>2} of {}{changed}", mark.earned, mark.of)
}

/// What the chapter is called; without a chapter, the lesson's name.
fn title(missions: &Missions, mission: &Standing) -> String {
    let chapter = missions.chapter(mission).unwrap_or_default();
    let title = chapter.lines().find_map(|line| line.strip_prefix("# "));
    title.unwrap_or(name(&mission.lesson)).trim().into()
}

/// A sentence as the end of another.
fn lower(sentence: &str) -> String {
    sentence.replacen('M', "m", 1)
}
