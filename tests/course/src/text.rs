//! Markdown as plain text in 80 columns.

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use super::formula::formula;

/// How wide a line may be, in characters.
const WIDTH: usize = 80;

/// What a space is that no line may end at. It is a space again in the end.
const BOUND: char = '\u{a0}';

/// Markdown as lines that begin with so much space: paragraphs, lists and code. Emphasis keeps a star and code its
/// backticks, of links the words are left, and formulas are in Unicode. No line ends inside of code or of a formula.
pub(crate) fn plain(markdown: &str, indent: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut text = String::new();
    // What stands before the next paragraph of a list, and the numbers of the lists that are open.
    let mut mark = String::new();
    let mut numbers: Vec<Option<u64>> = Vec::new();
    let mut is_first = true;
    for event in Parser::new_ext(markdown, Options::ENABLE_MATH) {
        match event {
            Event::Text(part) => text += &part,
            Event::Code(code) => text += &bound(&format!("`{code}`")),
            Event::InlineMath(tex) | Event::DisplayMath(tex) => text += &bound(&formula(&tex)),
            Event::SoftBreak | Event::HardBreak => text.push(' '),
            Event::Start(Tag::Emphasis | Tag::Strong) | Event::End(TagEnd::Emphasis | TagEnd::Strong) => {
                text.push('*');
            }
            Event::Start(Tag::List(first)) => {
                is_first = true;
                numbers.push(first);
            }
            Event::End(TagEnd::List(_)) => drop(numbers.pop()),
            Event::Start(Tag::Item) => {
                mark = numbers.last_mut().and_then(Option::as_mut).map_or("- ".into(), |number| {
                    *number += 1;
                    format!("{}. ", *number - 1)
                });
            }
            Event::End(TagEnd::Paragraph | TagEnd::Item) if !text.is_empty() => {
                let below = if numbers.is_empty() { 0 } else { 2 * numbers.len() - 2 + mark.chars().count() };
                begin(&mut lines, is_first || mark.is_empty());
                is_first = false;
                let first = format!("{indent}{}{mark}", " ".repeat(below - mark.chars().count()));
                lines.extend(wrapped(&text, &first, &format!("{indent}{}", " ".repeat(below))));
                (text, mark) = (String::new(), String::new());
            }
            Event::End(TagEnd::CodeBlock) => {
                begin(&mut lines, true);
                lines.extend(text.lines().map(|line| format!("{indent}    {line}")));
                text = String::new();
            }
            _ => (),
        }
    }
    lines.iter().map(|line| format!("{}\n", line.replace(BOUND, " "))).collect()
}

/// An empty line between paragraphs.
fn begin(lines: &mut Vec<String>, apart: bool) {
    if apart && !lines.is_empty() {
        lines.push(String::new());
    }
}

fn bound(text: &str) -> String {
    text.replace(' ', &BOUND.to_string())
}

/// A paragraph in lines, the first of which begins in a way of its own. A word that is longer than a line is left whole.
fn wrapped(text: &str, first: &str, others: &str) -> Vec<String> {
    let mut lines = vec![first.to_string()];
    let mut is_empty = true;
    for word in text.split([' ', '\n']).filter(|word| !word.is_empty()) {
        let line = lines.last_mut().expect("there is one");
        let width = line.chars().count() + usize::from(!is_empty) + word.chars().count();
        if !is_empty && width > WIDTH {
            lines.push(format!("{others}{word}"));
        } else {
            line.push_str(if is_empty { "" } else { " " });
            line.push_str(word);
        }
        is_empty = false;
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_paragraph_is_wrapped_and_code_stays_in_a_line() {
        let markdown = "Words of *one*\n**paragraph**, with [a link](x.md#y), and `a b c`, that goes on up to `d e f g`.";
        let text =
            "  Words of *one* *paragraph*, with a link, and `a b c`, that goes on up to\n  `d e f g`.\n";
        assert_eq!(plain(markdown, "  "), text);
    }

    #[test]
    fn lists_and_code_keep_their_form() {
        let markdown =
            "First:\n\n- one `x`\n- two\n\n1. a\n2. b\n\n```rust\nfn f() {\n    g()\n}\n```\n\nEnd $x = -1$.";
        let text =
            "First:\n\n- one `x`\n- two\n\n1. a\n2. b\n\n    fn f() {\n        g()\n    }\n\nEnd x = −1.\n";
        assert_eq!(plain(markdown, ""), text);
    }
}
