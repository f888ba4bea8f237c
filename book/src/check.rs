//! What is wrong with the pages of the book as they were built.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use regex::Regex;

use crate::fault::Fault;
use crate::html::Made;
use crate::page::Link;
use charts::figures::Drawn;

/// Pages that are not listed, links that lead nowhere, marks that came through, figures that no page shows. `staged`
/// is what mdBook built the pages from, `built` what it built.
pub(crate) fn faults<'a>(
    pages: &'a [Made],
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
            broken.chain(leftover(page, text, book)).collect()
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
