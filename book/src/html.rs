//! Builds the book: every chapter made ready, turned into pages by mdBook, and the pages checked.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock, Mutex};

use anyhow::{Context, bail, ensure};
use mdbook_driver::MDBook;
use mdbook_driver::config::Config;
use regex::Regex;

use crate::fault::Fault;
use crate::figures::{self, Drawing, Figure};
use crate::lessons::{LESSONS, Lesson};
use crate::page::{Link, Shown, Sources, expand};

/// The book's own folder.
const BOOK: &str = env!("CARGO_MANIFEST_DIR");

/// Draws all figures into `out/figures/`.
///
/// # Errors
/// Where one cannot be drawn or written.
pub(crate) fn draw(out: &Path) -> anyhow::Result<()> {
    write(&drawn()?, &out.join("figures"))
}

/// Builds the book into a folder, whose old content goes.
///
/// # Errors
/// Lists whatever is wrong on a page. The pages are written all the same, with the mistakes marked.
pub(crate) fn build(out: &Path) -> anyhow::Result<()> {
    let drawings = drawn()?;
    let faults = pages(Path::new(BOOK), LESSONS, out, &drawings)?;
    write(&drawings, &out.join("figures"))?;
    if faults.is_empty() {
        return Ok(());
    }
    let list: String = faults.iter().map(|fault| format!("\n{fault}")).collect();
    bail!("{} mistakes in the book; the pages are in {} all the same{list}", faults.len(), out.display());
}

type Drawings = Vec<(&'static Figure, Drawing)>;

fn drawn() -> anyhow::Result<Drawings> {
    let draw = |figure: &'static Figure| {
        Ok((figure, (figure.draw)().with_context(|| format!("the figure {}", figure.name))?))
    };
    figures::all().map(draw).collect()
}

fn file_name((figure, drawing): &(&Figure, Drawing)) -> String {
    format!("{}.{}", figure.name, drawing.ending())
}

fn write(drawings: &Drawings, folder: &Path) -> anyhow::Result<()> {
    std::fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    drawings.iter().try_for_each(|drawn| drawn.1.write(&folder.join(file_name(drawn))))
}

/// Writes the pages of a book, and returns what is wrong with them.
fn pages(book: &Path, lessons: &[Lesson], out: &Path, drawings: &Drawings) -> anyhow::Result<Vec<Fault>> {
    let shown = |drawn: &(&'static Figure, Drawing)| {
        (drawn.0.name, Shown { file: file_name(drawn), alt: drawn.0.alt, size: drawn.1.size() })
    };
    let figures: BTreeMap<&str, Shown> = drawings.iter().map(shown).collect();
    let charts = book.join("pages/charts");
    let sources = Sources { root: &book.join(".."), charts: &charts, figures: &figures };
    let written = written(book, lessons)?;
    let mut made = BTreeMap::new();
    for (name, file) in &written {
        let text = std::fs::read_to_string(book.join(file))?;
        made.insert(name.clone(), expand(&in_repository(file), &text, &sources));
    }

    // mdBook wants all its pages in one folder.
    let staged = tempfile::tempdir()?;
    for (name, page) in &made {
        std::fs::write(staged.path().join(name), &page.markdown)?;
    }
    let contents = std::fs::read_to_string(book.join("pages/SUMMARY.md"))?;
    std::fs::write(
        staged.path().join("SUMMARY.md"),
        contents.replace("{{lessons}}\n", &contents_of(lessons)),
    )?;
    if charts.is_dir() {
        copy(&charts, &staged.path().join("charts"))?;
    }
    let mut config = Config::from_disk(book.join("book.toml"))?;
    config.book.src = staged.path().into();
    config.build.build_dir = std::path::absolute(out)?;
    let mdbook = MDBook::load_with_config(book, config)?;
    let listed: BTreeSet<PathBuf> =
        mdbook.book.chapters().filter_map(|chapter| chapter.path.clone()).collect();
    if let Err(error) = render(&mdbook) {
        // What it stumbles over is likely one of the mistakes that we know by their lines.
        let faults: Vec<Fault> = made.into_values().flat_map(|page| page.faults).collect();
        return if faults.is_empty() { Err(error) } else { Ok(faults) };
    }

    let mut faults = Vec::new();
    let pages = read_pages(out, &listed)?;
    for (name, page) in &mut made {
        let file = &written[name];
        faults.append(&mut page.faults);
        match pages.get(&name.with_extension("html")) {
            Some(html) => {
                faults.extend(broken_links(file, name, &page.links, &pages, staged.path()));
                faults.extend(leftovers(&book.join(file), file, html));
            }
            None => faults.push(Fault {
                file: in_repository(file),
                line: 1,
                message: "SUMMARY.md does not list this page".into(),
            }),
        }
    }
    let used: BTreeSet<&str> = made.values().flat_map(|page| &page.figures).map(String::as_str).collect();
    faults.extend(drawings.iter().filter(|drawn| !used.contains(drawn.0.name)).map(|(figure, _)| Fault {
        file: figure.row.file().replace('\\', "/").replace("src/../", ""),
        line: figure.row.line() as usize,
        message: format!("no page shows the figure `{}`", figure.name),
    }));
    faults.sort();
    Ok(faults)
}

/// The pages as they are written: their names in the book, and their files from the book's folder.
fn written(book: &Path, lessons: &[Lesson]) -> anyhow::Result<BTreeMap<PathBuf, PathBuf>> {
    let mut written = BTreeMap::new();
    for entry in std::fs::read_dir(book.join("pages"))? {
        let name = PathBuf::from(entry?.file_name());
        if name.extension().is_some_and(|ending| ending == "md") && name != Path::new("SUMMARY.md") {
            written.insert(name.clone(), Path::new("pages").join(name));
        }
    }
    for lesson in lessons {
        written.insert(page_of(lesson), lesson.folder().join("chapter.md"));
    }
    Ok(written)
}

/// The lessons' part of the table of contents.
fn contents_of(lessons: &[Lesson]) -> String {
    let line = |lesson: &Lesson| {
        format!("- [{}. {}]({})\n", lesson.lesson.number, lesson.lesson.title, page_of(lesson).display())
    };
    lessons.iter().map(line).collect()
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

/// A page's path from the repository's root.
fn in_repository(file: &Path) -> String {
    format!("book/{}", file.display()).replace('\\', "/")
}

/// Lets mdBook write its pages. What it would only warn of is an error.
fn render(mdbook: &MDBook) -> anyhow::Result<()> {
    let warnings = Warnings::default();
    let writer = warnings.clone();
    let subscriber = tracing_subscriber::fmt()
        .with_max_level(tracing::Level::WARN)
        .with_ansi(false)
        .without_time()
        .with_writer(move || writer.clone())
        .finish();
    tracing::subscriber::with_default(subscriber, || mdbook.build())?;
    let text =
        warnings.0.lock().map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).unwrap_or_default();
    ensure!(text.is_empty(), "mdBook warns: {}", text.trim());
    Ok(())
}

/// Where mdBook's warnings go.
#[derive(Clone, Default)]
struct Warnings(Arc<Mutex<Vec<u8>>>);

impl Write for Warnings {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if let Ok(mut all) = self.0.lock() {
            all.extend_from_slice(bytes);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// The pages as built, by their path in the book.
fn read_pages(out: &Path, listed: &BTreeSet<PathBuf>) -> anyhow::Result<BTreeMap<PathBuf, String>> {
    let read = |name: &PathBuf| {
        let path = name.with_extension("html");
        let text = std::fs::read_to_string(out.join(&path)).with_context(|| path.display().to_string())?;
        Ok((path, text))
    };
    listed.iter().map(read).collect()
}

/// Links that lead nowhere: to a page, a place on a page, or a file that there is not.
fn broken_links(
    file: &Path,
    from: &Path,
    links: &[Link],
    pages: &BTreeMap<PathBuf, String>,
    staged: &Path,
) -> Vec<Fault> {
    let leads_nowhere = |link: &&Link| {
        let (path, place) = link.target.split_once('#').unwrap_or((&link.target, ""));
        let target = if path.is_empty() { from.to_path_buf() } else { PathBuf::from(path) };
        match pages.get(&target.with_extension("html")).filter(|_| target.extension() == from.extension()) {
            Some(page) => !place.is_empty() && !page.contains(&format!("id=\"{place}\"")),
            None => !staged.join(&target).is_file(),
        }
    };
    let fault = |link: &Link| Fault {
        file: in_repository(file),
        line: link.line,
        message: format!("the link to `{}` leads nowhere", link.target),
    };
    links.iter().filter(leads_nowhere).map(fault).collect()
}

/// Marks of ours or of LaTeX that came through to a page's text. The line is that of the page's source only if
/// there is one with the same words; code may hold such marks.
fn leftovers(source: &Path, file: &Path, page: &str) -> Option<Fault> {
    static CODE: LazyLock<Regex> = LazyLock::new(|| {
        Regex::new(r"(?s)<code.*?</code>|<script.*?</script>").expect("the pattern is right")
    });
    let text = CODE.replace_all(page, "");
    let mark = ["{{", "$$", "ANCHOR"].into_iter().find(|mark| text.contains(mark))?;
    let line = std::fs::read_to_string(source)
        .ok()
        .and_then(|source| source.lines().position(|line| line.contains(mark)))
        .map_or(1, |n| n + 1);
    Some(Fault { file: in_repository(file), line, message: format!("`{mark}` shows on the page") })
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
        let faults = super::pages(book, &[], &book.join("out"), &Vec::new()).unwrap();
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
        let error = pages(book, &[], &book.join("out"), &Vec::new()).unwrap_err().to_string();
        assert!(error.contains("unclosed HTML tag `<div>` found in `a.md`"), "{error}");
    }

    #[test]
    fn the_book_has_no_faults_and_shows_every_figure() {
        let folder = tempfile::tempdir().unwrap();
        let faults = pages(Path::new(BOOK), LESSONS, folder.path(), &drawn().unwrap()).unwrap();
        let list: Vec<String> = faults.iter().map(ToString::to_string).collect();
        assert!(list.is_empty(), "{}", list.join("\n"));
    }
}
