//! A question with answers to choose from, each with what is to be said about it.
//!
//! ```text
//! {{quiz}} How many pixels has the segment from (0, 0) to (6, 4)?
//!
//! - ( ) 6 :: There are six steps, but one pixel more than steps.
//! - (x) 7 :: One in each column, both ends among them.
//! ```
//!
//! On the page it is a group of radio buttons. What is said about an answer appears when it is chosen, by CSS
//! alone: there is no script, and without CSS everything is shown.

use std::ops::Range;

use anyhow::{Context, ensure};

/// What opens a question.
pub(crate) const MARK: &str = "{{quiz}}";

/// What to put in the place of what, for the question that begins at `start`; `number` is its number on the page.
///
/// # Errors
/// Where there are fewer than two answers, none or several are right, or one has nothing said about it.
pub(crate) fn edits(
    source: &str,
    start: usize,
    number: usize,
) -> anyhow::Result<Vec<(Range<usize>, String)>> {
    let asked = source[start..]
        .find("\n\n- (")
        .context("a quiz's answers follow its question, after a blank line")?;
    let first = start + asked + 2;
    let end = first + source[first..].find("\n\n").unwrap_or(source[first..].trim_end().len());
    let mut edits = vec![(start..start + MARK.len(), "<fieldset class=\"quiz\">\n\n".to_string())];
    let mut right = 0;
    let mut at = first;
    let mut count = 0;
    while at < end {
        let stop = source[at..end].find("\n- (").map_or(end, |length| at + length);
        let item = &source[at..stop];
        let (kind, mark) = match item.get(..6) {
            Some("- (x) ") => ("right", 6),
            Some("- ( ) ") => ("wrong", 6),
            _ => anyhow::bail!("an answer of a quiz begins with `- ( ) ` or `- (x) `"),
        };
        let said = item.find(" :: ").context("nothing is said about an answer: ANSWER :: WHY")?;
        right += usize::from(kind == "right");
        let id = format!("quiz-{number}-{count}");
        edits.push((
            at..at + mark,
            format!("\n<input type=\"radio\" name=\"quiz-{number}\" id=\"{id}\"><label for=\"{id}\">"),
        ));
        edits.push((at + said..at + said + 4, format!("</label><span class=\"why {kind}\">")));
        edits.push((stop..stop, "</span>\n".into()));
        count += 1;
        at = stop + 1;
    }
    ensure!(count > 1 && right == 1, "a quiz has two answers or more, one of them right");
    edits.push((end..end, "\n</fieldset>".into()));
    Ok(edits)
}
