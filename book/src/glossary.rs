//! The glossary's terms, read from its page, and the index of where the chapters use them.

use std::collections::BTreeMap;
use std::ops::Range;

use regex::Regex;

/// A row of the glossary.
pub(crate) struct Term {
    /// As the glossary writes it.
    pub(crate) name: String,
    /// Of its place on the page.
    pub(crate) id: String,
    /// Its forms in a text; none for a term in italics, an everyday word as well, which is linked by hand.
    forms: Option<Regex>,
}

impl Term {
    /// Where a text uses the term.
    pub(crate) fn uses<'a>(&'a self, text: &'a str) -> impl Iterator<Item = Range<usize>> + 'a {
        self.forms.iter().flat_map(|forms| forms.find_iter(text)).map(|found| found.range())
    }
}

/// The terms of the glossary's table: what stands in its first column. Forms are parted by commas.
pub(crate) fn terms(page: &str) -> Vec<Term> {
    rows(page)
        .map(|cell| {
            let name = cell.trim_matches('*');
            let form = |form: &str| format!("{}(?:s|es)?", regex::escape(form).replace(' ', r"\s+"));
            let forms: Vec<String> = name.split(", ").map(form).collect();
            let forms = Regex::new(&format!(r"(?i)\b(?:{})\b", forms.join("|"))).ok();
            Term { name: name.into(), id: id(name), forms: forms.filter(|_| name == cell) }
        })
        .collect()
}

fn rows(page: &str) -> impl Iterator<Item = &str> {
    let cells = page.lines().filter_map(|line| line.strip_prefix("| ")?.split(" | ").next());
    cells.filter(|cell| *cell != "term")
}

/// The name of a term's place: its first form, in letters and hyphens.
fn id(name: &str) -> String {
    let first = name.split(", ").next().unwrap_or(name).to_lowercase();
    let word = |c: char| if c.is_alphanumeric() { c } else { '-' };
    first.chars().filter(|c| *c != '\'').map(word).collect()
}

/// The glossary's page with a place at each term.
pub(crate) fn with_places(page: &str) -> String {
    let line = |line: &str| match line.strip_prefix("| ").and_then(|rest| rest.split_once(" | ")) {
        Some((cell, rest)) if cell != "term" => {
            format!("| <span id=\"{}\">{cell}</span> | {rest}\n", id(cell.trim_matches('*')))
        }
        _ => format!("{line}\n"),
    };
    page.lines().map(line).collect()
}

/// An entry of the index: what it is called, and the places, each as a link and the chapter's number.
pub(crate) type Entries = BTreeMap<String, Vec<(u8, String)>>;

/// The index as Markdown: a list for each letter.
pub(crate) fn index(entries: &Entries) -> String {
    let letter = |name: &str| name.trim_matches('`').chars().next().unwrap_or('#').to_ascii_uppercase();
    let mut names: Vec<&String> = entries.keys().collect();
    names.sort_by_key(|name| (name.trim_matches('`').to_lowercase(), (*name).clone()));
    let mut page = String::new();
    let mut current = None;
    for name in names {
        if current != Some(letter(name)) {
            current = Some(letter(name));
            page.push_str(&format!("\n## {}\n\n", letter(name)));
        }
        let mut places = entries[name].clone();
        places.sort();
        let places: Vec<String> = places.iter().map(|(number, link)| format!("[{number}]({link})")).collect();
        page.push_str(&format!("- {name}: {}\n", places.join(", ")));
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "# Glossary\n\n| term | in French | what |\n|---|---|---|\n| depth buffer, z-buffer | t | x |\n\
                        | *face* | face | x |\n| painter's algorithm | a | x |\n";

    #[test]
    fn a_term_is_found_in_all_its_forms() {
        let terms = terms(PAGE);
        let ids: Vec<&str> = terms.iter().map(|term| term.id.as_str()).collect();
        assert_eq!(ids, ["depth-buffer", "face", "painters-algorithm"]);
        let uses: Vec<Range<usize>> = terms[0].uses("Depth\nbuffers, a z-buffer, depth").collect();
        assert_eq!(uses, [0..13, 17..25]);
        assert_eq!(terms[1].uses("a face").count(), 0);
    }

    #[test]
    fn every_term_has_a_place() {
        let page = with_places(PAGE);
        assert!(page.contains("| <span id=\"face\">*face*</span> | face | x |\n"), "{page}");
        assert!(page.contains("| term | in French |"), "{page}");
    }

    #[test]
    fn the_index_is_in_the_order_of_letters() {
        let entry = |name: &str, places: &[(u8, &str)]| {
            (name.to_string(), places.iter().map(|&(number, link)| (number, link.to_string())).collect())
        };
        let entries =
            [entry("pixel", &[(2, "b.md#y"), (1, "a.md#x")]), entry("`bresenham`", &[(1, "a.md#z")])];
        let expected = "\n## B\n\n- `bresenham`: [1](a.md#z)\n\n## P\n\n- pixel: [1](a.md#x), [2](b.md#y)\n";
        assert_eq!(index(&entries.into()), expected);
    }
}
