//! Code quoted from a lesson: the lines between `// ANCHOR: name` and `// ANCHOR_END: name`.

use std::path::Path;
use std::sync::LazyLock;

use anyhow::{Context, bail, ensure};
use regex::Regex;

use crate::markup::escaped;

/// A piece of a source file.
pub(crate) struct Quote {
    /// Where it is, from the repository's root.
    pub(crate) file: String,
    lines: Vec<String>,
}

impl Quote {
    /// Reads `path:anchor`, the path from a folder, usually the repository's root.
    ///
    /// # Errors
    /// Where the file, the anchor, its end or anything between is missing.
    pub(crate) fn read(folder: &Path, place: &str) -> anyhow::Result<Self> {
        let (path, anchor) = place
            .rsplit_once(':')
            .with_context(|| format!("`{place}` names no anchor: write path:anchor"))?;
        let text =
            std::fs::read_to_string(folder.join(path)).with_context(|| format!("cannot read {path}"))?;
        let lines = anchored(&text, anchor).with_context(|| path.to_string())?;
        Ok(Self { file: path.into(), lines })
    }

    /// The names of the functions, types and traits that it defines.
    pub(crate) fn defines(&self) -> Vec<String> {
        static ITEM: LazyLock<Regex> = LazyLock::new(|| {
            let pattern = r"^(?:pub(?:\([a-z]+\))? )?(?:const )?(?:fn|struct|trait|enum|const|static) (\w+)";
            Regex::new(pattern).expect("the pattern is right")
        });
        self.lines.iter().filter_map(|line| Some(ITEM.captures(line)?[1].to_string())).collect()
    }

    /// The code as HTML: `<pre>` under the file's name. Lines that are not in `before` are marked as new.
    pub(crate) fn html(&self, language: &str, before: Option<&Self>) -> String {
        let is_new = |line: &str| {
            let line = line.trim();
            before
                .is_some_and(|before| line.len() > 1 && before.lines.iter().all(|other| other.trim() != line))
        };
        let mut code = String::new();
        for line in &self.lines {
            // A line that is too long for its column goes on farther to the right than it began.
            let hang = line.len() - line.trim_start().len() + 6;
            let class = if is_new(line) { "line new" } else { "line" };
            let text = escaped(line);
            code.push_str(&format!("<span class=\"{class}\" style=\"--hang:{hang}ch\">{text}\n</span>"));
        }
        let legend = if before.is_some() { " <span class=\"legend\">marked: new</span>" } else { "" };
        // Blank lines around <pre>: in Markdown only HTML that begins with it may hold blank lines itself.
        format!(
            "<div class=\"quote\"><div class=\"quote-file\">{}{legend}</div>\n\n\
             <pre><code class=\"language-{language}\">{code}</code></pre>\n\n</div>",
            self.file
        )
    }
}

/// The lines of an anchor, less the marks of others, and less the indentation they share.
fn anchored(text: &str, anchor: &str) -> anyhow::Result<Vec<String>> {
    let mark = |line: &str, kind: &str| {
        line.trim_start_matches([' ', '/', '#']).strip_prefix(kind).map(|name| name.trim().to_string())
    };
    let is_begin = |line: &&str| mark(line, "ANCHOR:").as_deref() == Some(anchor);
    let is_end = |line: &&str| mark(line, "ANCHOR_END:").as_deref() == Some(anchor);
    let is_mark = |line: &str| mark(line, "ANCHOR:").or(mark(line, "ANCHOR_END:")).is_some();

    let mut rest = text.lines();
    ensure!(rest.any(|line| is_begin(&line)), "there is no anchor `{anchor}`");
    let rest: Vec<&str> = rest.collect();
    let Some(end) = rest.iter().position(is_end) else { bail!("anchor `{anchor}` has no end") };
    let lines: Vec<&str> = rest[..end].iter().copied().filter(|line| !is_mark(line)).collect();
    let full = || lines.iter().filter(|line| !line.trim().is_empty());
    let indentation = full().map(|line| line.len() - line.trim_start().len()).min();
    let indentation = indentation.with_context(|| format!("anchor `{anchor}` is empty"))?;
    Ok(lines.iter().map(|line| line.get(indentation..).unwrap_or_default().to_string()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "one\n    // ANCHOR: a\n    two\n    // ANCHOR: b\n      three\n    // ANCHOR_END: b\n\n    four\n    // ANCHOR_END: a\nfive\n// ANCHOR: c\n\n// ANCHOR_END: c\n// ANCHOR: d\nsix";

    #[test]
    fn an_anchor_is_what_lies_between_its_marks() {
        assert_eq!(anchored(TEXT, "a").unwrap(), ["two", "  three", "", "four"]);
        assert_eq!(anchored(TEXT, "b").unwrap(), ["three"]);
    }

    #[test]
    fn a_missing_an_endless_and_an_empty_anchor_are_errors() {
        for (anchor, said) in
            [("e", "there is no anchor `e`"), ("d", "`d` has no end"), ("c", "`c` is empty")]
        {
            assert!(anchored(TEXT, anchor).unwrap_err().to_string().contains(said), "{anchor}");
        }
    }

    #[test]
    fn a_quote_knows_what_it_defines() {
        let text = "// ANCHOR: a\n/// fn no\npub fn fill<T>(t: T) {\n    fn inner() {}\n}\nstruct Setup;\n// ANCHOR_END: a";
        let quote = Quote { file: "lib.rs".into(), lines: anchored(text, "a").unwrap() };
        assert_eq!(quote.defines(), ["fill", "Setup"]);
    }

    #[test]
    fn only_lines_that_were_not_there_are_marked() {
        let quote = |lines: &[&str]| Quote {
            file: "lib.rs".into(),
            lines: lines.iter().map(ToString::to_string).collect(),
        };
        let html =
            quote(&["for x {", "    y < 2", "}"]).html("rust", Some(&quote(&["for x {", "    y", "}"])));
        let lines = "<span class=\"line\" style=\"--hang:6ch\">for x {\n</span>\
                     <span class=\"line new\" style=\"--hang:10ch\">    y &lt; 2\n</span>\
                     <span class=\"line\" style=\"--hang:6ch\">}\n</span>";
        assert!(html.contains(lines), "{html}");
    }
}
