//! From a chapter as written to the Markdown that mdBook understands: formulas, quoted code, figures, measured
//! values and tables of methods are put in their places.
//!
//! | in a chapter | becomes |
//! |---|---|
//! | `$a^2$`, `$$a^2$$` | a formula, in the line or on its own; `$$a^2$${#NAME}` gives the latter a name |
//! | a code block that holds `{{#include PATH:ANCHOR}}`, the path from the repository's root | the code, quoted under its file's name |
//! | the same with `{{#include PATH:ANCHOR since [PATH:]ANCHOR}}` | with the lines marked that the other lacks |
//! | `{{figure NAME}} Caption.` | the figure, the rest of the paragraph under it |
//! | `{{chart NAME}} Caption.` | a chart of `charts/` |
//! | `{{value TABLE ROW... COLUMN}}` | a cell of `charts/TABLE.csv` |
//! | `{{ratio TABLE ROW OVER COLUMN}}` | how many times as large it is in one row as in another |
//! | `{{results TABLE COLUMN=Heading...}}` | columns of the table |
//! | `{{cross TABLE DOWN ACROSS COLUMN}}` | a column of the table, by two others |
//! | `{{insert NAME}}` | the page `charts/NAME.md`, which was written with the charts |
//! | `{{quiz}} Question`, then a list | a question with answers to choose from; see [`quiz`] |
//! | `{{methods TABLE}}`, `{{all-methods}}` | a lesson's table of methods, or all of them |
//! | `{{see NAME}}` | "figure 3.2" or "equation 3.4", as a link: of a figure, a chart or a named formula |
//! | `{{mark WORDS}}` | an entry of the index, of this place |
//!
//! In a lesson's chapter, figures and formulas on their own are numbered. [`links`](crate::links) makes further links.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;
use std::sync::LazyLock;

use anyhow::{Context, bail, ensure};
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag};
use regex::Regex;

use crate::fault::Fault;
use crate::markup::{escaped, guarded};
use crate::math::mathml;
use crate::quiz;
use crate::quote::Quote;
use crate::values::{Table, spelled};
use charts::figures::Drawn;
use charts::lessons::tables;

/// What a page can draw on.
pub(crate) struct Sources<'a> {
    /// The repository, which quoted code is from.
    pub(crate) root: &'a Path,
    /// The folder of the charts.
    pub(crate) charts: &'a Path,
    /// The figures.
    pub(crate) figures: &'a [Drawn],
}

/// A link to another place of the book.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Link {
    /// The line in which it stands.
    pub(crate) line: usize,
    /// As written.
    pub(crate) target: String,
}

/// A chapter made ready.
#[derive(Default)]
pub(crate) struct Page {
    /// For mdBook. What was wrong is marked in its place.
    pub(crate) markdown: String,
    /// What was wrong.
    pub(crate) faults: Vec<Fault>,
    /// Where it points to.
    pub(crate) links: Vec<Link>,
    /// The figures that it shows.
    pub(crate) figures: BTreeSet<String>,
    /// What can be referred to by name: its place on the page, and its number, as "figure 3.2".
    pub(crate) numbered: BTreeMap<String, (String, String)>,
    /// The code that is quoted: the names of what it defines, and its place on the page.
    pub(crate) code: Vec<(String, String)>,
    /// What the index is to have: words, and their place on the page.
    pub(crate) marks: Vec<(String, String)>,
}

static DIRECTIVE: LazyLock<Regex> =
    LazyLock::new(|| Regex::new(r"\{\{([^{}]*)\}\}").expect("the pattern is right"));

/// A chapter in the making.
struct Writer<'a> {
    file: &'a str,
    source: &'a str,
    sources: &'a Sources<'a>,
    /// Of the lesson, in whose chapter figures and formulas are numbered.
    lesson: Option<u8>,
    figures: usize,
    formulas: usize,
    page: Page,
    /// What to put in the place of what.
    edits: Vec<(Range<usize>, String)>,
}

/// Makes a chapter ready. `file` is its path from the repository's root, `lesson` its number if it is a lesson's.
pub(crate) fn expand(file: &str, source: &str, sources: &Sources, lesson: Option<u8>) -> Page {
    let page = Page::default();
    let mut writer =
        Writer { file, source, sources, lesson, figures: 0, formulas: 0, page, edits: Vec::new() };
    let elsewhere = writer.formulas_and_code();
    writer.directives(&elsewhere);
    writer.finish()
}

impl Writer<'_> {
    fn line(&self, at: usize) -> usize {
        self.source[..at].matches('\n').count() + 1
    }

    /// Notes what is wrong and returns a mark for the page.
    fn fault(&mut self, at: usize, message: String) -> String {
        // A directive's braces or a formula's dollars would count as another mistake.
        let shown = message.replace(['{', '}', '$'], "");
        let mark = format!("<strong class=\"fault\">{}</strong>", guarded(&escaped(&shown)));
        let line = self.line(at);
        self.page.faults.push(Fault { file: self.file.into(), line, message });
        mark
    }

    fn put(&mut self, range: Range<usize>, made: Result<String, String>) {
        let text = made.unwrap_or_else(|message| self.fault(range.start, message));
        self.edits.push((range, text));
    }

    /// Whether something begins at the left margin, where HTML can take its place.
    fn is_at_margin(&self, at: usize) -> bool {
        at == 0 || self.source.as_bytes()[at - 1] == b'\n'
    }

    /// Replaces formulas and quoted code, notes links and images. Returns where no directive is to be looked for.
    fn formulas_and_code(&mut self) -> Vec<Range<usize>> {
        let mut elsewhere = Vec::new();
        let options = Options::ENABLE_MATH | Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES;
        for (event, range) in Parser::new_ext(self.source, options).into_offset_iter() {
            match event {
                Event::InlineMath(latex) => {
                    let (range, before, after) = with_punctuation(self.source, range);
                    let whole = |math| format!("<span class=\"whole\">{before}{math}{after}</span>");
                    let bare = before.is_empty() && after.is_empty();
                    self.put(
                        range.clone(),
                        mathml(&latex, false).map(|math| if bare { math } else { whole(math) }),
                    );
                    elsewhere.push(range);
                }
                Event::DisplayMath(latex) => {
                    let name = name_of(&self.source[range.end..]);
                    let range = range.start..range.end + name.map_or(0, |name| name.len() + 3);
                    let made = mathml(&latex, true).and_then(|math| {
                        ensure_margin(self.is_at_margin(range.start), "a formula on its own")?;
                        let formula = format!("<div class=\"formula\" tabindex=\"0\">{math}</div>");
                        Ok(format!("\n\n{}\n\n", self.numbered_formula(formula, name)))
                    });
                    self.put(range.clone(), made);
                    elsewhere.push(range);
                }
                Event::Start(Tag::CodeBlock(kind)) => {
                    let text = &self.source[range.clone()];
                    if let (true, CodeBlockKind::Fenced(language)) = (text.contains("{{#"), kind) {
                        let made = self.quote(text, &language, self.is_at_margin(range.start));
                        let made = made.map(|(quote, html)| self.placed(&quote, &html));
                        self.put(range.clone(), made.map_err(|error| format!("{error:#}")));
                    }
                    elsewhere.push(range);
                }
                Event::Code(code) => {
                    if let Some(html) = with_whole_flags(&code) {
                        self.put(range.clone(), Ok::<_, String>(html));
                    }
                    elsewhere.push(range);
                }
                // Braces that do not match keep the parser from seeing a formula.
                Event::Text(text) if text.contains('$') && !self.source[..range.start].ends_with('\\') => {
                    let mark = self
                        .fault(range.start, "a `$` begins or ends no formula; as a sign, write `\\$`".into());
                    self.edits.push((range, mark));
                }
                Event::Start(Tag::Link { dest_url, .. }) => self.link(range.start, &dest_url),
                Event::Start(Tag::Image { .. }) => {
                    let mark = self.fault(range.start, "an image: show a figure, {{figure NAME}}".into());
                    self.edits.push((range.clone(), mark));
                    elsewhere.push(range);
                }
                Event::Html(html) | Event::InlineHtml(html) if html.contains("<img") => {
                    let mark = self.fault(range.start, "an <img>: show a figure, {{figure NAME}}".into());
                    self.edits.push((range.clone(), mark));
                }
                _ => {}
            }
        }
        elsewhere
    }

    /// A formula on its own, with its number where it has one.
    fn numbered_formula(&mut self, formula: String, name: Option<&str>) -> String {
        let Some(lesson) = self.lesson else { return formula };
        self.formulas += 1;
        let (number, id) = (self.formulas, format!("eq-{lesson}-{}", self.formulas));
        if let Some(name) = name {
            self.page.numbered.insert(name.into(), (id.clone(), format!("equation {lesson}.{number}")));
        }
        format!(
            "<div class=\"equation\" id=\"{id}\">{formula}<a class=\"number\" href=\"#{id}\" \
             aria-label=\"Equation {lesson}.{number}\">({lesson}.{number})</a></div>"
        )
    }

    /// Quoted code with a place on the page, which the names that it defines lead to.
    fn placed(&mut self, quote: &Quote, html: &str) -> String {
        let Some(name) = quote.defines().first().cloned() else { return html.into() };
        if self.page.code.iter().any(|(other, _)| *other == name) {
            return html.into();
        }
        let id = format!("code-{}{name}", self.lesson.map(|lesson| format!("{lesson}-")).unwrap_or_default());
        self.page.code.extend(quote.defines().into_iter().map(|name| (name, id.clone())));
        format!("<div id=\"{id}\">\n\n{html}\n\n</div>")
    }

    fn link(&mut self, at: usize, target: &str) {
        if !target.contains("://") && !target.starts_with("mailto:") {
            let line = self.line(at);
            self.page.links.push(Link { line, target: target.into() });
        }
    }

    /// A code block whose only line is an include.
    fn quote(&self, block: &str, language: &str, at_margin: bool) -> anyhow::Result<(Quote, String)> {
        ensure!(at_margin, "quoted code must begin at the left margin");
        let lines: Vec<&str> = block.lines().map(str::trim).collect();
        let directive = match lines.as_slice() {
            [_, line, _] => line.strip_prefix("{{#include ").and_then(|rest| rest.strip_suffix("}}")),
            _ => None,
        };
        let words: Vec<&str> = directive.unwrap_or_default().split_whitespace().collect();
        let (place, before) = match words.as_slice() {
            [place] => (*place, None),
            [place, "since", before] if before.contains(':') => (*place, Some((*before).to_string())),
            [place, "since", anchor] => {
                let path = place.rsplit_once(':').map_or(*place, |parts| parts.0);
                (*place, Some(format!("{path}:{anchor}")))
            }
            _ => bail!(
                "a quoting block holds one line, {{{{#include PATH:ANCHOR}}}}, perhaps with `since ANCHOR`"
            ),
        };
        let read = |place: &str| Quote::read(self.sources.root, place);
        let before = before.as_deref().map(read).transpose()?;
        let quote = read(place)?;
        let html = quote.html(language, before.as_ref());
        Ok((quote, html))
    }

    /// Replaces what stands in double braces outside of code and formulas.
    fn directives(&mut self, elsewhere: &[Range<usize>]) {
        let source = self.source;
        let mut quizzes = 0;
        for found in DIRECTIVE.captures_iter(source) {
            let whole = found.get_match().range();
            if elsewhere.iter().any(|range| range.start <= whole.start && whole.end <= range.end) {
                continue;
            }
            let words: Vec<&str> = found[1].split_whitespace().collect();
            if let [kind @ ("figure" | "chart"), name] = words.as_slice() {
                self.figure(kind, name, whole);
                continue;
            }
            if let ["mark", ..] = words.as_slice() {
                let id = format!("mark-{}-{}", self.lesson.unwrap_or_default(), self.page.marks.len());
                self.edits.push((whole, format!("<span id=\"{id}\"></span>")));
                self.page.marks.push((words[1..].join(" "), id));
                continue;
            }
            if words == ["quiz"] {
                quizzes += 1;
                let made = ensure_margin(self.is_at_margin(whole.start), "a quiz").and_then(|()| {
                    quiz::edits(source, whole.start, quizzes).map_err(|error| error.to_string())
                });
                match made {
                    Ok(edits) => self.edits.extend(edits),
                    Err(message) => self.put(whole, Err(message)),
                }
                continue;
            }
            let made = self.inserted(&words).map_err(|error| format!("{error:#}"));
            self.put(whole, made);
        }
    }

    /// What a directive without caption stands for.
    fn inserted(&self, words: &[&str]) -> anyhow::Result<String> {
        let charts = self.sources.charts;
        Ok(match words {
            ["value", table, row @ .., column] => spelled(Table::read(charts, table)?.cell(row, column)?),
            ["ratio", table, row, over, column] => Table::read(charts, table)?.ratio(row, over, column)?,
            ["results", table, columns @ ..] => {
                let named = columns.iter().map(|column| column.split_once('='));
                let named: Option<Vec<(&str, String)>> =
                    named.map(|pair| pair.map(|(column, name)| (column, name.replace('_', " ")))).collect();
                let named = named.filter(|named| named.len() > 1);
                let named =
                    named.context("name two columns or more, as in method=Method error_max=Largest_error")?;
                let named: Vec<(&str, &str)> =
                    named.iter().map(|(column, name)| (*column, name.as_str())).collect();
                Table::read(charts, table)?.markdown(&named)?
            }
            ["cross", table, down, across, column] => {
                Table::read(charts, table)?.crossed(down, across, column)?
            }
            ["insert", name] => {
                let file = charts.join(name).with_extension("md");
                std::fs::read_to_string(file).with_context(|| format!("there is no charts/{name}.md"))?
            }
            ["methods", name] => {
                let found = tables().find(|(table, _)| table == name).map(|(_, table)| methods(table));
                let names = || tables().map(|(table, _)| table).collect::<Vec<_>>().join(", ");
                found.with_context(|| format!("there is no table `{name}`, but {}", names()))?
            }
            // Where it is, only all pages together tell: html.rs puts it in.
            ["see", name] => format!("{{{{see {name}}}}}"),
            ["index"] => "{{index}}".into(),
            ["all-methods"] => {
                tables().map(|(_, table)| format!("### {}\n\n{}\n", table.job, methods(table))).collect()
            }
            _ => bail!("`{{{{{}}}}}` means nothing here; book/src/page.rs says what does", words.join(" ")),
        })
    }

    /// A figure with the rest of its paragraph as the caption.
    fn figure(&mut self, kind: &str, name: &str, whole: Range<usize>) {
        let rest = &self.source[whole.end..];
        let end = whole.end + rest.find("\n\n").unwrap_or(rest.len());
        let caption = !self.source[whole.end..end].trim().is_empty();
        let image = if kind == "figure" { self.drawn(name) } else { self.chart(name) };
        let image = image.and_then(|image| {
            ensure_margin(self.is_at_margin(whole.start), "a figure")?;
            if caption { Ok(image) } else { Err(format!("the figure `{name}` has no caption")) }
        });
        match image {
            Ok(image) => {
                let id = format!("fig-{name}");
                let number = self.lesson.map(|lesson| {
                    self.figures += 1;
                    let number = format!("{lesson}.{}", self.figures);
                    self.page.numbered.insert(name.into(), (id.clone(), format!("figure {number}")));
                    format!("<strong class=\"number\">Figure {number}</strong>")
                });
                let number = number.unwrap_or_default();
                let moves = kind == "figure" && live::FIGURES.iter().any(|figure| figure.name == name);
                let live = if moves { format!(" data-live=\"{name}\"") } else { String::new() };
                let text =
                    format!("<figure class=\"{kind}\" id=\"{id}\"{live}>{image}<figcaption>\n\n{number}");
                self.edits.push((whole, text));
                self.edits.push((end..end, "\n\n</figcaption></figure>".into()));
            }
            Err(message) => self.put(whole, Err(message)),
        }
    }

    fn drawn(&mut self, name: &str) -> Result<String, String> {
        let drawn = self.sources.figures.iter().find(|drawn| drawn.figure.name == name);
        let drawn = drawn.ok_or_else(|| format!("there is no figure `{name}`"))?;
        self.page.figures.insert(name.into());
        let (file, (width, height)) = (drawn.file(), drawn.drawing.size());
        let alt = escaped(drawn.figure.alt);
        Ok(format!("<img src=\"figures/{file}\" alt=\"{alt}\" width=\"{width}\" height=\"{height}\">"))
    }

    /// A measured chart, which leads to its file. On a telephone it is another one of the same figures.
    fn chart(&self, name: &str) -> Result<String, String> {
        let (file, folder) = (format!("charts/{name}.svg"), self.sources.charts);
        let svg = std::fs::read_to_string(folder.join(format!("{name}.svg")))
            .map_err(|_| format!("there is no {file}: cargo run --release -p book -- charts"))?;
        let (title, [width, height]) =
            chart_title(&svg).ok_or_else(|| format!("{file} has no title or no size"))?;
        let best = Table::read(folder, name).map(|table| table.best().join(", ")).unwrap_or_default();
        let best = if best.is_empty() { best } else { format!(" None beats these in both: {best}.") };
        let alt = escaped(&format!("Chart. {title}.{best}"));
        let narrow = format!("charts/{name}-narrow.svg");
        if !folder.join(format!("{name}-narrow.svg")).is_file() {
            return Err(format!("there is no {narrow}: cargo run --release -p book -- charts --draw"));
        }
        Ok(format!(
            "<a href=\"{file}\"><picture><source media=\"(max-width: 560px)\" srcset=\"{narrow}\"><img src=\"{file}\" \
             alt=\"{alt}\" width=\"{width}\" height=\"{height}\"></picture></a>"
        ))
    }

    /// The chapter with all edits made.
    fn finish(mut self) -> Page {
        self.page.faults.sort();
        self.page.faults.dedup();
        self.edits.sort_by_key(|(range, _)| (range.start, range.end));
        let mut at = 0;
        for (range, text) in &self.edits {
            if range.start >= at {
                self.page.markdown.push_str(&self.source[at..range.start]);
                self.page.markdown.push_str(text);
                at = range.end;
            }
        }
        self.page.markdown.push_str(&self.source[at..]);
        self.page
    }
}

/// The name that is given to a formula right behind it.
fn name_of(rest: &str) -> Option<&str> {
    rest.strip_prefix("{#")?.split_once('}').map(|(name, _)| name)
}

/// The range of a formula with the bracket before it and the punctuation behind it, and these: between a formula and
/// what touches it a browser would end a line.
fn with_punctuation(source: &str, range: Range<usize>) -> (Range<usize>, &str, &str) {
    let begin = range.start - usize::from(source[..range.start].ends_with('('));
    let rest = &source[range.end..];
    let end = range.end + rest.len() - rest.trim_start_matches(['.', ',', ';', ':', '?', ')']).len();
    (begin..end, &source[begin..range.start], &source[range.end..end])
}

/// Code in the line as HTML in which no flag is cut at its hyphens; nothing if it has none.
fn with_whole_flags(code: &str) -> Option<String> {
    let is_flag = |word: &&str| word.starts_with('-') && word.len() > 1;
    code.split(' ').find(is_flag)?;
    let word = |word: &str| match escaped(word) {
        flag if is_flag(&word) => format!("<span class=\"whole\">{flag}</span>"),
        other => other,
    };
    let words: Vec<String> = code.split(' ').map(word).collect();
    Some(guarded(&format!("<code>{}</code>", words.join(" "))))
}

/// A table of methods, as a table in Markdown.
fn methods(table: &common::Table) -> String {
    let row = |row: common::Method<()>| format!("| `{}` | {} | {} |\n", row.name, row.promise, row.failure);
    let rows: String = (table.rows)().into_iter().map(row).collect();
    format!("| method | what it promises | where it fails |\n|---|---|---|\n{rows}")
}

/// The title of a chart, and its width and height.
fn chart_title(svg: &str) -> Option<(String, [String; 2])> {
    let document = roxmltree::Document::parse(svg).ok()?;
    let title =
        document.descendants().find(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "title")))?;
    let root = document.root_element();
    let side = |name| root.attribute(name).map(String::from);
    Some((title.text()?.trim().to_string(), [side("width")?, side("height")?]))
}

fn ensure_margin(at_margin: bool, what: &str) -> Result<(), String> {
    if at_margin { Ok(()) } else { Err(format!("{what} must begin at the left margin")) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use charts::figures::Figure;
    use charts::figures::sheet::Sheet;

    /// A page of this source in a folder with one lesson file and one table.
    fn page(source: &str) -> Page {
        page_of(None, source)
    }

    fn page_of(lesson: Option<u8>, source: &str) -> Page {
        let folder = tempfile::tempdir().unwrap();
        let charts = folder.path().join("charts");
        std::fs::create_dir_all(&charts).unwrap();
        let code =
            "// ANCHOR: f\nfn f() {\n    g();\n}\n// ANCHOR_END: f\n// ANCHOR: none\n// ANCHOR_END: none\n";
        std::fs::write(folder.path().join("lib.rs"), code).unwrap();
        std::fs::write(charts.join("t.csv"), "method,error\na,0.5\nb,0.25\n").unwrap();
        static DOT: Figure = Figure::new("dot", "A dot.", || Sheet::new((0.0, 0.0), (4.0, 1.0)).finish());
        let figures = [Drawn { figure: &DOT, drawing: (DOT.draw)().unwrap() }];
        let sources = Sources { root: folder.path(), charts: &charts, figures: &figures };
        expand("book/pages/x.md", source, &sources, lesson)
    }

    #[test]
    fn a_formula_keeps_what_touches_it_and_a_flag_its_hyphens() {
        let text = page("A ($w$), then $x$. Run `cargo run --release` and `a-b`.\n").markdown;
        assert!(
            text.contains("A <span class=\"whole\">(<math") && text.contains("</math>),</span> then"),
            "{text}"
        );
        assert!(text.contains("</math>.</span> Run <code>cargo run <span class=\"whole\">"), "{text}");
        assert!(text.contains("</span></code> and `a-b`."), "{text}");
    }

    #[test]
    fn everything_has_its_place() {
        let made = page(
            "A {{value t a error}}, {{ratio t a b error}} times $x$.\n\n{{figure dot}} See $y$\nhere.\n\n\
             ```rust\n{{#include lib.rs:f}}\n```\n\n$$a = b$$\n\n{{results t method=Method error=Error}}\n\n\
             {{methods 01-lines}}\n\nSee [there](y.md#z).\n",
        );
        assert_eq!(made.faults, []);
        let text = &made.markdown;
        for part in [
            "A 0.5, 2.0 times <span class=\"whole\"><math",
            "<img src=\"figures/dot.svg\" alt=\"A dot.\" width=\"480\" height=\"141\"><figcaption>\n\n See <math",
            "here.\n\n</figcaption></figure>",
            "<div class=\"quote-file\">lib.rs</div>\n\n<pre><code class=\"language-rust\"><span class=\"line\" style=\"--hang:6ch\">fn f() {\n</span>",
            "<div class=\"formula\" tabindex=\"0\"><math",
            "| Method | Error |\n|---|--:|\n| a | 0.5 |",
            "| `bresenham` | exact",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
        assert!(!text.contains("{{") && !text.contains('$'), "{text}");
        assert_eq!(made.links, [Link { line: 16, target: "y.md#z".into() }]);
        assert_eq!(made.figures, BTreeSet::from(["dot".into()]));
    }

    #[test]
    fn every_mistake_is_told_with_file_and_line() {
        for (source, said) in [
            ("```rust\n{{#include lib.rs:g}}\n```", "there is no anchor `g`"),
            ("```rust\n{{#include lib.rs:none}}\n```", "anchor `none` is empty"),
            ("```rust\n{{#include none.rs:f}}\n```", "cannot read none.rs"),
            ("```rust\n{{#include lib.rs}}\n```", "names no anchor"),
            ("```rust\n{{#include lib.rs:f since g}}\n```", "there is no anchor `g`"),
            ("```rust\nlet x;\n{{#include lib.rs:f}}\n```", "a quoting block holds one line"),
            ("{{#include lib.rs:f}}", "means nothing here"),
            ("$\\frac{1}{$", "begins or ends no formula"),
            ("$\\nonsense$", "nonsense"),
            ("$$\\nonsense$$", "nonsense"),
            ("Text $$x$$", "must begin at the left margin"),
            ("{{figure none}} Caption.", "there is no figure `none`"),
            ("{{figure dot}}", "has no caption"),
            ("{{chart none}} Caption.", "there is no charts/none.svg"),
            ("{{value none a error}}", "there is no table charts/none.csv"),
            ("{{value t c error}}", "no row `c`"),
            ("{{value t a speed}}", "no column `speed`"),
            ("{{ratio t a c error}}", "no row `c`"),
            ("{{results t method=Method speed=Speed}}", "no column `speed`"),
            ("{{cross t method speed error}}", "no column `speed`"),
            ("{{insert none}}", "there is no charts/none.md"),
            ("{{methods 99-none}}", "there is no table `99-none`"),
            ("{{nonsense}}", "means nothing here"),
            ("{{quiz}} Which?", "answers follow its question"),
            ("Which? {{quiz}}\n\n- (x) a :: b\n- ( ) c :: d", "must begin at the left margin"),
            ("{{quiz}} Which?\n\n- (x) a :: b", "two answers or more"),
            ("{{quiz}} Which?\n\n- (x) a :: b\n- (x) c :: d", "one of them right"),
            ("{{quiz}} Which?\n\n- (x) a :: b\n- ( ) c", "nothing is said about an answer"),
            ("{{quiz}} Which?\n\n- (x) a :: b\n- (y) c :: d", "begins with `- ( ) `"),
            ("![dot](dot.png)", "show a figure"),
            ("<img src=\"dot.png\">", "show a figure"),
        ] {
            let made = page(&format!("One.\n\n{source}\n"));
            let [fault] = made.faults.as_slice() else { panic!("{source}: {:?}", made.faults) };
            assert!(fault.to_string().starts_with("book/pages/x.md:3: "), "{fault}");
            assert!(fault.message.contains(said) && !fault.message.contains('\n'), "{source}: {fault}");
            assert!(made.markdown.contains("class=\"fault\""), "{source}");
        }
    }

    #[test]
    fn a_quiz_says_something_about_each_answer() {
        let made = page("{{quiz}} What is $x$?\n\n- ( ) $y$ :: No.\n  Really.\n- (x) `z` :: Yes.\n\nText.\n");
        assert_eq!(made.faults, []);
        let text = &made.markdown;
        for part in [
            "<fieldset class=\"quiz\">\n\n What is <span class=\"whole\"><math",
            "\n\n\n<input type=\"radio\" name=\"quiz-1\" id=\"quiz-1-0\"><label for=\"quiz-1-0\"><math",
            "</math></label><span class=\"why wrong\">No.\n  Really.</span>\n",
            "<label for=\"quiz-1-1\">`z`</label><span class=\"why right\">Yes.</span>\n\n</fieldset>\n\nText.",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }

    #[test]
    fn what_a_chapter_shows_has_a_number_and_a_place() {
        let source = "$$a$$\n\n$$b$${#named}\n\n{{figure dot}} A dot.\n\n{{see dot}} {{mark Some words}}here\n\n\
                      ```rust\n{{#include lib.rs:f}}\n```\n";
        let made = page_of(Some(3), source);
        assert_eq!(made.faults, []);
        for part in [
            "<div class=\"equation\" id=\"eq-3-1\"><div class=\"formula\" tabindex=\"0\"><math",
            "href=\"#eq-3-2\" aria-label=\"Equation 3.2\">(3.2)</a></div>\n\n",
            "<figure class=\"figure\" id=\"fig-dot\"><img",
            "<figcaption>\n\n<strong class=\"number\">Figure 3.1</strong> A dot.",
            "{{see dot}} <span id=\"mark-3-0\"></span>here",
            "<div id=\"code-3-f\">\n\n<div class=\"quote\">",
        ] {
            assert!(made.markdown.contains(part), "{part}: {}", made.markdown);
        }
        let numbered = [("dot", ("fig-dot", "figure 3.1")), ("named", ("eq-3-2", "equation 3.2"))];
        let numbered = numbered.map(|(name, (id, number))| (name.into(), (id.into(), number.into())));
        assert_eq!(made.numbered, BTreeMap::from(numbered));
        assert_eq!(made.code, [("f".into(), "code-3-f".into())]);
        assert_eq!(made.marks, [("Some words".into(), "mark-3-0".into())]);
    }

    #[test]
    fn a_chart_is_told_by_its_title() {
        let svg = "<svg xmlns='http://www.w3.org/2000/svg' width='10' height='7'><title>\nThe title\n</title>\
                   <text>a</text></svg>";
        assert_eq!(chart_title(svg), Some(("The title".into(), ["10".into(), "7".into()])));
        assert_eq!(chart_title("<svg/>"), None);
    }

    #[test]
    fn code_and_formulas_may_hold_braces_and_dollars() {
        let source = "`{{x}}` costs `$1` or \\$2.\n\n```rust\nformat!(\"{{}}\");\n```\n";
        let made = page(source);
        assert_eq!((made.faults, made.markdown), (vec![], source.into()));
        assert_eq!(page("$\\frac{{a}}{b}$").faults, []);
    }
}
