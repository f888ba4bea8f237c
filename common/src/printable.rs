//! Text from outside as it can be shown in one line.

use std::fmt::{Display, Formatter, Result, Write};
use std::path::Path;

/// The text with what would break the line, move the cursor, or turn the writing round written as `\u{…}`.
pub fn printable(text: &str) -> impl Display + '_ {
    Printable(text)
}

/// A file's name, [printable]; what is no text in it is shown as U+FFFD.
pub fn shown(path: &Path) -> impl Display + '_ {
    Shown(path)
}

struct Printable<'a>(&'a str);

impl Display for Printable<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        // Beside control characters, those of Unicode's category Cf that order or hide others.
        let hides = |c| matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}');
        self.0.chars().try_for_each(|c| match c {
            c if c.is_control() || hides(c) => write!(f, "{}", c.escape_debug()),
            c => f.write_char(c),
        })
    }
}

struct Shown<'a>(&'a Path);

impl Display for Shown<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        Printable(&self.0.to_string_lossy()).fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_break_a_line_is_escaped_and_nothing_else() {
        let name = "a\nb\x1b[31m\u{7f}\u{85}\u{202e}\u{2028}\u{200b}.obj";
        assert_eq!(
            shown(Path::new(name)).to_string(),
            r"a\nb\u{1b}[31m\u{7f}\u{85}\u{202e}\u{2028}\u{200b}.obj"
        );
        let harmless = r#"C:\Models\"Köpfe" 頭 e' \n.obj"#;
        assert_eq!(printable(harmless).to_string(), harmless);
    }
}
