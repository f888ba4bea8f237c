//! Builds the book: every page made ready, turned into HTML by mdBook, and checked.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use anyhow::{Context, bail};
use regex::Regex;

use crate::fault::Fault;
use crate::glossary::{self, Entries, Term};
use crate::links::Targets;
use crate::page::{Page, Sources, expand};
use crate::{check, live_charts, mdbook, moving};
use charts::figures::{self, Drawn};
use charts::lessons::{LESSONS, Lesson};

/// The book's own folder.
pub(crate) const BOOK: &str = env!("CARGO_MANIFEST_DIR");

/// The glossary's page.
const GLOSSARY: &str = "glossary.md";

/// A page of the book, made ready.
pub(crate) struct Made {
    /// Its name in the book, as `01-lines.md`.
    pub(crate) name: PathBuf,
    /// Its file, from the book's folder.
    pub(crate) file: PathBuf,
    /// The number of the lesson whose chapter it is.
    pub(crate) lesson: Option<u8>,
    /// What is on it.
    pub(crate) page: Page,
}

impl Made {
    /// Its file from the repository's root.
    pub(crate) fn in_repository(&self) -> String {
        in_repository(&self.file)
    }
}

/// Draws all figures into `out/figures/`.
///
/// # Errors
/// Where one cannot be drawn or written.
pub(crate) fn draw(out: &Path) -> anyhow::Result<()> {
    figures::write(&figures::draw()?, &out.join("figures"))
}

/// Builds the book into a folder, whose old content goes.
///
/// # Errors
/// Lists whatever is wrong on a page. The pages are written all the same, with the mistakes marked.
pub(crate) fn build(out: &Path) -> anyhow::Result<()> {
    let drawn = figures::draw()?;
    let faults = pages(Path::new(BOOK), LESSONS, out, &drawn)?;
    figures::write(&drawn, &out.join("figures"))?;
    moving::write(out)?;
    live_charts::write(&out.join("charts"))?;
    if faults.is_empty() {
        return Ok(());
    }
    let list: String = faults.iter().map(|fault| format!("\n{fault}")).collect();
    bail!("{} mistakes in the book; the pages are in {} all the same{list}", faults.len(), out.display());
}

/// Writes the pages of a book, and returns what is wrong with them.
fn pages(book: &Path, lessons: &[Lesson], out: &Path, figures: &[Drawn]) -> anyhow::Result<Vec<Fault>> {
    let charts = book.join("pages/charts");
    let sources = Sources { root: &book.join(".."), charts: &charts, figures };
    let make = |(name, file): (PathBuf, PathBuf)| {
        let text = std::fs::read_to_string(book.join(&file)).with_context(|| in_repository(&file))?;
        let lesson = lessons.iter().find(|lesson| page_of(lesson) == name).map(|lesson| lesson.lesson.number);
        let page = expand(&in_repository(&file), &text, &sources, lesson);
        Ok(Made { name, file, lesson, page })
    };
    let mut made = files(book, lessons)?.into_iter().map(make).collect::<anyhow::Result<Vec<Made>>>()?;
    let of_glossary = |page: &&Made| page.name == Path::new(GLOSSARY);
    let terms = made.iter().find(of_glossary).map(|page| glossary::terms(&page.page.markdown));
    let terms = terms.unwrap_or_default();
    let targets = targets(&made, lessons, &terms);
    join(&mut made, &targets, &terms, &mdbook::issues(book)?);

    // mdBook wants all its pages in one folder.
    let staged = tempfile::tempdir()?;
    for page in &made {
        std::fs::write(staged.path().join(&page.name), &page.page.markdown)?;
    }
    let contents = std::fs::read_to_string(book.join("pages/SUMMARY.md"))?;
    let contents = with_lessons(&contents, lessons);
    std::fs::write(staged.path().join("SUMMARY.md"), contents)?;
    if charts.is_dir() {
        copy(&charts, &staged.path().join("charts"))?;
    }
    let own = made.iter().flat_map(|made| &made.page.faults).cloned();
    if let Err(error) = mdbook::build(book, staged.path(), out) {
        // What it stumbles over is likely one of the mistakes that we know by their lines.
        let faults: Vec<Fault> = own.collect();
        return if faults.is_empty() { Err(error) } else { Ok(faults) };
    }
    let mut faults: Vec<Fault> =
        own.chain(check::faults(&made, &targets, book, staged.path(), out, figures)).collect();
    faults.sort();
    Ok(faults)
}

/// What the words of the pages can lead to.
fn targets<'a>(pages: &[Made], lessons: &[Lesson], terms: &'a [Term]) -> Targets<'a> {
    let chapters = lessons.iter().map(|lesson| (lesson.lesson.number, page_of(lesson).display().to_string()));
    let mut code: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for page in pages {
        for (name, id) in &page.page.code {
            code.entry(name.clone()).or_default().push(format!("{}#{id}", page.name.display()));
        }
    }
    for lesson in lessons {
        for row in lesson.lesson.tables.iter().flat_map(|table| (table.rows)()) {
            let place = format!("{}#the-methods-compared", page_of(lesson).display());
            code.entry(row.name.into()).or_default().push(place);
        }
    }
    Targets { chapters: chapters.collect(), terms, code }
}

/// Puts in what takes all pages: references, links, the index, and where to tell of a mistake.
fn join(pages: &mut [Made], targets: &Targets, terms: &[Term], issues: &str) {
    static SEE: LazyLock<Regex> =
        LazyLock::new(|| Regex::new(r"\{\{see ([\w-]+)\}\}").expect("the pattern is right"));
    let mut numbered = BTreeMap::new();
    let mut entries = Entries::new();
    for page in &*pages {
        let name = page.name.display();
        for (what, (id, number)) in &page.page.numbered {
            numbered.insert(what.clone(), format!("<a href=\"{name}#{id}\">{number}</a>"));
        }
        let marks =
            page.lesson.into_iter().flat_map(|lesson| page.page.marks.iter().map(move |mark| (lesson, mark)));
        for (lesson, (words, id)) in marks {
            entries.entry(words.clone()).or_default().push((lesson, format!("{name}#{id}")));
        }
    }
    for (name, places) in &targets.code {
        for place in places {
            let number = targets.chapters.iter().find(|(_, page)| place.starts_with(page.as_str()));
            if let Some((number, _)) = number {
                let places = entries.entry(format!("`{name}`")).or_default();
                if places.iter().all(|(other, _)| other != number) {
                    places.push((*number, place.clone()));
                }
            }
        }
    }
    for page in pages.iter_mut() {
        let text = SEE.replace_all(&page.page.markdown, |found: &regex::Captures| {
            // What nobody has numbered stays, and is found among the marks that came through.
            numbered.get(&found[1]).cloned().unwrap_or_else(|| found[0].to_string())
        });
        let linked = targets.link(&page.name, page.lesson, &text);
        for (term, id) in linked.terms {
            let link = format!("{}#{id}", page.name.display());
            let number = page.lesson.unwrap_or_default();
            entries.entry(terms[term].name.clone()).or_default().push((number, link));
        }
        page.page.markdown = linked.markdown;
    }
    for page in pages {
        if page.name == Path::new(GLOSSARY) {
            page.page.markdown = glossary::with_places(&page.page.markdown);
        }
        page.page.markdown = page.page.markdown.replace("{{index}}", &glossary::index(&entries));
        page.page.markdown.push_str(&format!(
            "\n\n<p class=\"errata\">Is something on this page wrong, or not clear? {issues}</p>\n"
        ));
    }
}

/// The names of the pages in the book, and their files from the book's folder.
pub(crate) fn files(book: &Path, lessons: &[Lesson]) -> anyhow::Result<Vec<(PathBuf, PathBuf)>> {
    let chapter = |lesson: &Lesson| (page_of(lesson), lesson.folder().join("chapter.md"));
    let mut files: Vec<(PathBuf, PathBuf)> = lessons.iter().map(chapter).collect();
    for entry in std::fs::read_dir(book.join("pages"))? {
        let name = PathBuf::from(entry?.file_name());
        if name.extension().is_some_and(|ending| ending == "md") && name != Path::new("SUMMARY.md") {
            files.push((name.clone(), Path::new("pages").join(name)));
        }
    }
    Ok(files)
}

/// The table of contents with the lessons of a part in the place of `{{lessons 1-9}}`; those of the last part are
/// `{{lessons 16-}}`. A part that has none yet is left out.
fn with_lessons(contents: &str, lessons: &[Lesson]) -> String {
    static PART: LazyLock<Regex> = LazyLock::new(|| {
        Regex::new(r"(# .*\n\n)\{\{lessons (\d+)-(\d*)\}\}\n\n").expect("the pattern is right")
    });
    let line = |lesson: &Lesson| {
        format!("- [{}. {}]({})\n", lesson.lesson.number, lesson.lesson.title, page_of(lesson).display())
    };
    let lines = |part: &regex::Captures| -> String {
        let first = part[2].parse().unwrap_or_default();
        let last = part[3].parse().unwrap_or(u8::MAX);
        let own = lessons.iter().filter(|lesson| (first..=last).contains(&lesson.lesson.number));
        let lines: String = own.map(line).collect();
        if lines.is_empty() { lines } else { format!("{}{lines}\n", &part[1]) }
    };
    PART.replace_all(contents, lines).into_owned()
}

/// The name of a chapter in the book.
fn page_of(lesson: &Lesson) -> PathBuf {
    format!("{}.md", lesson.lesson.folder()).into()
}

/// Copies the files of a folder.
fn copy(from: &Path, to: &Path) -> anyhow::Result<()> {
    std::fs::create_dir(to)?;
    for entry in std::fs::read_dir(from)? {
        let entry = entry?;
        std::fs::copy(entry.path(), to.join(entry.file_name()))?;
    }
    Ok(())
}

/// A file's path from the repository's root.
fn in_repository(file: &Path) -> String {
    format!("book/{}", file.display()).replace('\\', "/")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A book of these pages; what is wrong with it.
    fn faults(pages: &[(&str, &str)]) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        let book = folder.path();
        std::fs::create_dir_all(book.join("pages/charts")).unwrap();
        std::fs::write(book.join("book.toml"), "[book]\ntitle = \"Test\"\n").unwrap();
        for (name, text) in pages {
            std::fs::write(book.join("pages").join(name), text).unwrap();
        }
        let faults = super::pages(book, &[], &book.join("out"), &[]).unwrap();
        faults.iter().map(ToString::to_string).collect()
    }

    const SUMMARY: (&str, &str) = ("SUMMARY.md", "[A](a.md)\n[B](b.md)\n");

    #[test]
    fn a_sound_book_has_no_faults() {
        let a = (
            "a.md",
            "# A\n\n[b](b.md#there), [here](#a), [file](charts/c.csv), [far](https://example.org)\n",
        );
        assert_eq!(faults(&[SUMMARY, a, ("b.md", "# B\n\n## There\n"), ("charts/c.csv", "x")]), [""; 0]);
    }

    #[test]
    fn broken_links_and_stray_files_are_told() {
        let a = ("a.md", "# A\n\n[b](b.md#nowhere)\n[c](c.md)\n[d](#d)\n");
        let found = faults(&[SUMMARY, a, ("b.md", "# B\n"), ("e.md", "# E\n")]);
        let expected = [
            "book/pages/a.md:3: the link to `b.md#nowhere` leads nowhere",
            "book/pages/a.md:4: the link to `c.md` leads nowhere",
            "book/pages/a.md:5: the link to `#d` leads nowhere",
            "book/pages/e.md:1: SUMMARY.md does not list this page",
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn marks_that_come_through_are_told() {
        let found =
            faults(&[SUMMARY, ("a.md", "# A\n\n<p>$$x$$</p>\n"), ("b.md", "# B\n\n{{value}} `$$`\n")]);
        assert!(found[0].contains("a.md") && found[0].contains("`$$` shows on the page"), "{found:?}");
        assert!(found[1].starts_with("book/pages/b.md:3: "), "{found:?}");
        assert_eq!(found.len(), 2, "{found:?}");
    }

    #[test]
    fn what_mdbook_warns_of_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let book = folder.path();
        std::fs::create_dir(book.join("pages")).unwrap();
        std::fs::write(book.join("book.toml"), "[book]\n").unwrap();
        std::fs::write(book.join("pages/SUMMARY.md"), "[A](a.md)\n").unwrap();
        std::fs::write(book.join("pages/a.md"), "# A\n\n<div>\n\nText\n").unwrap();
        let error = pages(book, &[], &book.join("out"), &[]).unwrap_err().to_string();
        assert!(error.contains("unclosed HTML tag `<div>` found in `a.md`"), "{error}");
    }

    #[test]
    fn the_book_has_no_faults_and_shows_every_figure() {
        let folder = tempfile::tempdir().unwrap();
        let drawn = figures::draw().unwrap();
        for live::Figure { name, .. } in live::FIGURES {
            assert!(
                drawn.iter().any(|still| still.figure.name == *name),
                "{name}: no still figure has this name"
            );
        }
        let faults = pages(Path::new(BOOK), LESSONS, folder.path(), &drawn).unwrap();
        let list: Vec<String> = faults.iter().map(ToString::to_string).collect();
        assert!(list.is_empty(), "{}", list.join("\n"));
    }
}
