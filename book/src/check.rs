//! What is wrong with the pages of the book as they were built.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use regex::Regex;

use crate::fault::Fault;
use crate::html::Made;
use crate::links::{MENTION, NUMBER, Targets};
use crate::page::Link;
use charts::figures::Drawn;

/// Pages that are not listed, links that lead nowhere, lessons, terms and code that are named without a link, marks
/// that came through, figures that no page shows. `staged` is what mdBook built the pages from, `built` what it built.
pub(crate) fn faults<'a>(
    pages: &'a [Made],
    targets: &'a Targets,
    book: &'a Path,
    staged: &'a Path,
    built: &'a Path,
    figures: &'a [Drawn],
) -> impl Iterator<Item = Fault> {
    let html = |page: &Made| std::fs::read_to_string(built.join(page.name.with_extension("html"))).ok();
    let texts: Vec<(&Made, Option<String>)> = pages.iter().map(|page| (page, html(page))).collect();
    let of_page = |(page, text): &(&Made, Option<String>)| match text {
        None => vec![fault(page, 1, "SUMMARY.md does not list this page".into())],
        Some(text) => {
            let broken = page.page.links.iter().filter(|link| leads_nowhere(link, page, &texts, staged));
            let message = |link: &Link| format!("the link to `{}` leads nowhere", link.target);
            let broken = broken.map(|link| fault(page, link.line, message(link)));
            broken.chain(leftover(page, text, book)).chain(unlinked(page, text, targets, book)).collect()
        }
    };
    let of_pages: Vec<Fault> = texts.iter().flat_map(of_page).collect();
    let shown: BTreeSet<&str> =
        pages.iter().flat_map(|page| &page.page.figures).map(String::as_str).collect();
    let unshown = figures.iter().map(|drawn| drawn.figure).filter(move |figure| !shown.contains(figure.name));
    of_pages.into_iter().chain(unshown.map(|figure| Fault {
        file: figure.row.file().replace('\\', "/").replace("charts/src/../../", ""),
        line: figure.row.line() as usize,
        message: format!("no page shows the figure `{}`", figure.name),
    }))
}

fn fault(page: &Made, line: usize, message: String) -> Fault {
    Fault { file: page.in_repository(), line, message }
}

/// Whether a link leads to a page, a place on a page, or a file that there is not.
fn leads_nowhere(link: &Link, from: &Made, pages: &[(&Made, Option<String>)], staged: &Path) -> bool {
    let (path, place) = link.target.split_once('#').unwrap_or((&link.target, ""));
    let target = if path.is_empty() { from.name.clone() } else { PathBuf::from(path) };
    match pages.iter().find(|(page, text)| page.name == target && text.is_some()) {
        Some((_, text)) => {
            let is_there = |text: &String| text.contains(&format!("id=\"{place}\""));
            !place.is_empty() && !text.as_ref().is_some_and(is_there)
        }
        None => !staged.join(&target).is_file(),
    }
}

/// What a page names and does not lead to: a lesson, and in a chapter a term of the glossary or a piece of code.
fn unlinked(page: &Made, text: &str, targets: &Targets, book: &Path) -> Vec<Fault> {
    static CODE: LazyLock<Regex> =
        LazyLock::new(|| Regex::new("<code>([^<]*)</code>").expect("the pattern is right"));
    // With a tag goes what its attributes say, as the words for who cannot see a figure.
    static TAG: LazyLock<Regex> =
        LazyLock::new(|| Regex::new("</?([a-z0-9]+)[^>]*>").expect("the pattern is right"));
    let main = text.split_once("<main>").map_or(text, |parts| parts.1);
    let main = main.split_once("</main>").map_or(main, |parts| parts.0);
    let words = [AWAY.as_slice(), &["code"]]
        .concat()
        .iter()
        .fold(main.to_string(), |rest, name| without(&rest, name));
    let words = TAG.replace_all(
        &words,
        |tag: &regex::Captures| {
            if ["em", "strong"].contains(&&tag[1]) { "" } else { "\0" }
        },
    );
    let mut named: Vec<String> = Vec::new();
    for mention in MENTION.find_iter(&words) {
        let numbers = NUMBER.captures_iter(mention.as_str()).filter_map(|found| found[1].parse().ok());
        let others = numbers.filter(|number| Some(*number) != page.lesson);
        named.extend(
            others.filter(|number| targets.chapters.contains_key(number)).map(|_| mention.as_str().into()),
        );
    }
    if page.lesson.is_some() {
        let leads_to = |id: &str| main.contains(&format!("href=\"glossary.html#{id}\""));
        for term in targets.terms.iter().filter(|term| !leads_to(&term.id)) {
            named.extend(term.uses(&words).next().map(|range| words[range].to_string()));
        }
        let coded = AWAY.iter().fold(main.to_string(), |rest, name| without(&rest, name));
        for code in CODE.captures_iter(&coded) {
            let place = targets.place_of(&page.name, &code[1]);
            let id = place.and_then(|place| place.split_once('#'));
            named.extend(
                id.filter(|(_, id)| !main.contains(&format!("#{id}\">"))).map(|_| code[1].to_string()),
            );
        }
    }
    let source = std::fs::read_to_string(book.join(&page.file)).unwrap_or_default();
    let fault_of = |words: String| {
        let first = words.split_whitespace().next().unwrap_or(&words);
        let line = source
            .lines()
            .position(|line| line.contains(&words) || line.contains(first))
            .map_or(1, |n| n + 1);
        fault(page, line, format!("`{words}` is named without a link"))
    };
    named.into_iter().map(fault_of).collect()
}

/// Elements whose words need no link, or have one.
const AWAY: [&str; 10] = ["a", "pre", "h1", "h2", "h3", "h4", "summary", "label", "math", "script"];

/// HTML without the elements of a name.
fn without(html: &str, name: &str) -> String {
    let (open, close) = (format!("<{name}"), format!("</{name}>"));
    let mut rest = html;
    let mut left = String::with_capacity(html.len());
    while let Some((before, after)) = rest.split_once(&open) {
        left.push_str(before);
        // `<a` begins `<article>` as well.
        match after.split_once(&close) {
            Some((_, behind)) if after.starts_with([' ', '>', '\n']) => {
                left.push('\0');
                rest = behind;
            }
            _ => {
                left.push_str(&open);
                rest = after;
            }
        }
    }
    left + rest
}

/// A mark of ours or of LaTeX that came through to a page's text. The line is that of the page's source only if
/// there is one with the same words; code may hold such marks.
fn leftover(page: &Made, text: &str, book: &Path) -> Option<Fault> {
    static CODE: LazyLock<Regex> = LazyLock::new(|| {
        Regex::new(r"(?s)<code.*?</code>|<script.*?</script>").expect("the pattern is right")
    });
    let text = CODE.replace_all(text, "");
    let mark = ["{{", "$$", "ANCHOR"].into_iter().find(|mark| text.contains(mark))?;
    let source = std::fs::read_to_string(book.join(&page.file)).unwrap_or_default();
    let line = source.lines().position(|line| line.contains(mark)).map_or(1, |n| n + 1);
    Some(fault(page, line, format!("`{mark}` shows on the page")))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::glossary;
    use crate::page::Page;

    fn unlinked(html: &str) -> Vec<String> {
        let terms = glossary::terms("| pixel | p | x |\n");
        let targets = Targets {
            chapters: [(1, "01-a.md".into()), (2, "02-b.md".into())].into(),
            terms: &terms,
            code: BTreeMap::from([("fill".into(), vec!["02-b.md#code-2-fill".into()])]),
        };
        let page =
            Made { name: "01-a.md".into(), file: "a.md".into(), lesson: Some(1), page: Page::default() };
        let html = format!("<nav>lesson 2</nav><main>{html}</main>");
        super::unlinked(&page, &html, &targets, Path::new("."))
            .into_iter()
            .map(|fault| fault.message)
            .collect()
    }

    #[test]
    fn what_is_named_without_a_link_is_told() {
        for (html, words) in [
            ("<p>In lesson 2 and lesson 1.</p>", "lesson 2"),
            ("<p>In <em>chapter</em>\n2.</p>", "chapter\n2"),
            ("<p>Two pixels.</p>", "pixels"),
            ("<p>By <code>fill(x)</code>.</p>", "fill(x)"),
        ] {
            assert_eq!(unlinked(html), [format!("`{words}` is named without a link")]);
        }
    }

    #[test]
    fn what_has_a_link_or_needs_none_is_sound() {
        for html in [
            "<a href=\"02-b.html\">lesson 2</a>",
            "<h2 id=\"x\">Pixels of lesson 2</h2>",
            "<a href=\"glossary.html#pixel\">pixel</a> pixel",
            "<code><a href=\"02-b.html#code-2-fill\">fill</a></code> <code>fill</code>",
            "<pre><code>fill</code></pre> <article>lesson 3</article>",
            "<img alt=\"In lesson 2, a pixel.\">",
        ] {
            assert_eq!(unlinked(html), [""; 0], "{html}");
        }
    }
}
