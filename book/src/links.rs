//! Links that nobody has to write: a mention of a lesson leads to its chapter, the first use of a term in a chapter to
//! the glossary, and the first mention of a piece of code to where the book quotes it.
//!
//! This runs over pages that are made ready, so that it sees what was inserted as well. Headings, code blocks,
//! formulas, the answers of a quiz and what is a link already are left as they are.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;
use std::sync::LazyLock;

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use regex::Regex;

use crate::glossary::Term;

/// "Lesson 3", "chapters 3 to 6", "Lessons 4, 5 and 6".
pub(crate) static MENTION: LazyLock<Regex> = LazyLock::new(|| {
    let pattern = r"\b(?i:lessons?|chapters?)\s+\d+(?:(?:,|\s+(?:to|and|or))\s+\d+\b)*";
    Regex::new(pattern).expect("the pattern is right")
});

/// One number of a mention, the first with the word before it, which is longer than "and" or "to".
pub(crate) static NUMBER: LazyLock<Regex> =
    LazyLock::new(|| Regex::new(r"(?:[A-Za-z]{6,}\s+)?(\d+)").expect("the pattern is right"));

/// What the words of a page can lead to.
pub(crate) struct Targets<'a> {
    /// The chapters' pages by the numbers of their lessons, as `01-lines.md`.
    pub(crate) chapters: BTreeMap<u8, String>,
    /// The glossary.
    pub(crate) terms: &'a [Term],
    /// What is quoted or listed as a method under a name, each as `01-lines.md#code-bresenham`.
    pub(crate) code: BTreeMap<String, Vec<String>>,
}

/// What of a page leads where.
pub(crate) struct Linked {
    /// The page with its links.
    pub(crate) markdown: String,
    /// The terms of the glossary, by their places in it, that a chapter uses; `id`s of the links.
    pub(crate) terms: BTreeMap<usize, String>,
}

impl Targets<'_> {
    /// A page with its links. Terms and code are linked in the chapters of lessons only: `number` is the lesson's.
    pub(crate) fn link(&self, page: &Path, number: Option<u8>, markdown: &str) -> Linked {
        let words = Words::of(markdown);
        let mut edits = Vec::new();
        for mention in MENTION.find_iter(&words.plain) {
            for found in NUMBER.captures_iter(mention.as_str()) {
                let lesson = found[1].parse().ok().filter(|lesson| Some(*lesson) != number);
                if let Some(chapter) = lesson.and_then(|lesson| self.chapters.get(&lesson)) {
                    let at = found.get_match().range();
                    let range = mention.start() + at.start..mention.start() + at.end;
                    edits.push((range, format!("<a href=\"{chapter}\">")));
                }
            }
        }
        let mut terms = BTreeMap::new();
        if let Some(number) = number {
            let taken = |range: &Range<usize>, edits: &[(Range<usize>, String)]| {
                edits.iter().any(|(other, _)| other.start < range.end && range.start < other.end)
            };
            let mut uses: Vec<(Range<usize>, usize)> = Vec::new();
            for (index, term) in self.terms.iter().enumerate() {
                uses.extend(term.uses(&words.plain).map(|range| (range, index)));
            }
            // "Edge function" before "edge": of two that begin together the longer one.
            uses.sort_by_key(|(range, _)| (range.start, usize::MAX - range.end));
            let mut at = 0;
            for (range, index) in uses {
                if range.start < at || taken(&range, &edits) {
                    continue;
                }
                at = range.end;
                if let Entry::Vacant(first) = terms.entry(index) {
                    let term = &self.terms[index].id;
                    let id = format!("use-{number}-{term}");
                    edits
                        .push((range, format!("<a class=\"term\" id=\"{id}\" href=\"glossary.md#{term}\">")));
                    first.insert(id);
                }
            }
            edits.extend(self.code(page, &words));
        }
        edits.sort_by_key(|(range, _)| range.start);
        let mut linked = String::with_capacity(markdown.len() * 2);
        let mut at = 0;
        for (range, tag) in edits {
            linked.push_str(&markdown[at..range.start]);
            linked.push_str(&tag);
            linked.push_str(&markdown[range.clone()]);
            linked.push_str("</a>");
            at = range.end;
        }
        linked.push_str(&markdown[at..]);
        Linked { markdown: linked, terms }
    }

    /// Links of the first mention of each piece of code.
    fn code(&self, page: &Path, words: &Words) -> Vec<(Range<usize>, String)> {
        let mut seen = BTreeSet::new();
        let mut edits = Vec::new();
        for (range, code) in &words.code {
            let Some(place) = self.place_of(page, code) else { continue };
            if seen.insert(place) {
                // On its own page the `#` is enough, and the printed book keeps it.
                let place = place.strip_prefix(&*page.to_string_lossy()).unwrap_or(place);
                edits.push((range.clone(), format!("<a href=\"{place}\">")));
            }
        }
        edits
    }

    /// Where the book has a piece of code, by what stands between the backquotes: on the page itself, or on the one
    /// page that has something of that name.
    pub(crate) fn place_of(&self, page: &Path, code: &str) -> Option<&String> {
        let name = code.split('(').next().unwrap_or(code);
        let name = name.rsplit("::").next().unwrap_or(name);
        let places = self.code.get(name)?;
        let page = page.to_string_lossy();
        let own = places.iter().find(|place| place.starts_with(&*page));
        let page_of = |place: &String| place.split('#').next().map(String::from);
        let only = || places.first().filter(|one| places.iter().all(|place| page_of(place) == page_of(one)));
        own.or_else(only)
    }
}

/// The words of a page, apart from all that is to be left alone.
struct Words {
    /// As long as the page, with NULs for what is no word.
    plain: String,
    /// Code in the line.
    code: Vec<(Range<usize>, String)>,
}

impl Words {
    fn of(markdown: &str) -> Self {
        let mut plain = vec![0; markdown.len()];
        let mut keep = |range: Range<usize>| {
            plain[range.clone()].copy_from_slice(&markdown.as_bytes()[range]);
        };
        let mut code = Vec::new();
        // How deep in a heading, a link and the like.
        let mut closed = 0;
        // The inline HTML that is open and keeps its words.
        let mut html: Option<String> = None;
        let mut lead = false;
        let mut after_break: Option<usize> = None;
        let options = Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES | Options::ENABLE_STRIKETHROUGH;
        for (event, range) in Parser::new_ext(markdown, options).into_offset_iter() {
            if let Some(end) = after_break.take()
                && range.start >= end
                && markdown[end..range.start].trim().is_empty()
            {
                keep(end..range.start);
            }
            match event {
                Event::Start(
                    Tag::Heading { .. } | Tag::Link { .. } | Tag::Image { .. } | Tag::CodeBlock(_),
                ) => {
                    closed += 1;
                }
                Event::End(TagEnd::Heading(_) | TagEnd::Link | TagEnd::Image | TagEnd::CodeBlock) => {
                    closed -= 1;
                }
                Event::End(TagEnd::HtmlBlock) => lead = false,
                Event::Html(text) => {
                    lead |= text.starts_with("<p class=\"lead\">");
                    if lead {
                        outside_of_tags(&text).for_each(|part| {
                            keep(range.start + part.start..range.start + part.end);
                        });
                    }
                }
                Event::InlineHtml(tag) => match &html {
                    Some(name) if tag.starts_with(&format!("</{name}")) => html = None,
                    Some(_) => {}
                    None => {
                        let name = ["math", "label", "a ", "strong"]
                            .into_iter()
                            .find(|name| tag.strip_prefix('<').is_some_and(|rest| rest.starts_with(name)));
                        html = name.map(|name| name.trim().into());
                    }
                },
                Event::Text(text) if closed == 0 && html.is_none() && markdown[range.clone()] == *text => {
                    keep(range);
                }
                Event::Code(text) if closed == 0 && html.is_none() => code.push((range, text.to_string())),
                Event::SoftBreak if closed == 0 && html.is_none() => {
                    after_break = Some(range.end);
                    keep(range);
                }
                _ => {}
            }
        }
        // Only whole texts were copied, so no character is cut.
        Self { plain: String::from_utf8(plain).unwrap_or_default(), code }
    }
}

/// The parts of HTML between its tags.
fn outside_of_tags(html: &str) -> impl Iterator<Item = Range<usize>> {
    static TAG: LazyLock<Regex> = LazyLock::new(|| Regex::new("<[^>]*>").expect("the pattern is right"));
    let mut at = 0;
    let ends = TAG.find_iter(html).map(|tag| (tag.start(), tag.end())).chain([(html.len(), html.len())]);
    ends.map(move |(start, end)| std::mem::replace(&mut at, end)..start).filter(|range| !range.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::glossary;

    fn linked(number: Option<u8>, markdown: &str) -> String {
        let terms = glossary::terms("| pixel | p | x |\n| edge function | f | x |\n| *face* | f | x |\n");
        let pages = [(1, "01-a.md"), (2, "02-b.md"), (3, "03-c.md")];
        let targets = Targets {
            chapters: pages.iter().map(|&(number, page)| (number, page.into())).collect(),
            terms: &terms,
            code: [
                ("fill", vec!["03-c.md#code-fill"]),
                ("flat", vec!["01-a.md#code-flat", "02-b.md#code-flat"]),
            ]
            .map(|(name, places)| (name.into(), places.into_iter().map(String::from).collect()))
            .into(),
        };
        targets.link(Path::new("01-a.md"), number, markdown).markdown
    }

    #[test]
    fn every_lesson_that_is_named_is_a_link() {
        for (written, made) in [
            ("See lesson 2.", "See <a href=\"02-b.md\">lesson 2</a>."),
            ("Chapter\n3's", "<a href=\"03-c.md\">Chapter\n3</a>'s"),
            ("Lessons 2, 3 and 4", "<a href=\"02-b.md\">Lessons 2</a>, <a href=\"03-c.md\">3</a> and 4"),
            ("lessons 1 to 3", "lessons 1 to <a href=\"03-c.md\">3</a>"),
            (
                "<p class=\"lead\">In lesson\n2.</p>\n",
                "<p class=\"lead\">In <a href=\"02-b.md\">lesson\n2</a>.</p>\n",
            ),
            ("- item, lesson\n  2", "- item, <a href=\"02-b.md\">lesson\n  2</a>"),
            ("A | B\n--|--\nx | lesson 2", "A | B\n--|--\nx | <a href=\"02-b.md\">lesson 2</a>"),
        ] {
            assert_eq!(linked(Some(1), written), made);
        }
    }

    #[test]
    fn what_is_no_mention_is_left_alone() {
        for text in [
            "# Lesson 2",
            "[lesson 2](x.md)",
            "`lesson 2`",
            "```\nlesson 2\n```",
            "lesson 12",
            "lesson 1",
            "<label>lesson 2</label>",
            "<details>\n<summary>lesson 2</summary>\n\n</details>",
            "lesson\n\n2",
        ] {
            assert_eq!(linked(Some(1), text), text);
        }
    }

    #[test]
    fn a_term_is_a_link_where_a_chapter_first_uses_it() {
        let made = linked(Some(1), "# A pixel\n\n`pixel` Pixels are pixels. An *edge\nfunction*, a face.\n");
        let pixel = "<a class=\"term\" id=\"use-1-pixel\" href=\"glossary.md#pixel\">Pixels</a> are pixels.";
        assert!(made.contains(pixel), "{made}");
        assert!(made.contains("href=\"glossary.md#edge-function\">edge\nfunction</a>*, a face."), "{made}");
        assert_eq!(linked(None, "A pixel."), "A pixel.");
    }

    #[test]
    fn code_is_a_link_to_where_it_is_quoted() {
        assert_eq!(
            linked(Some(1), "`fill(a)`, `fill`, `flat`, `other`"),
            "<a href=\"03-c.md#code-fill\">`fill(a)`</a>, `fill`, <a href=\"#code-flat\">`flat`</a>, `other`"
        );
    }
}
