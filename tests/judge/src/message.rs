//! What a student's program says, within bounds.

/// How much of a message is kept, in bytes.
pub const LONGEST: usize = 2 << 10;

/// A message, of which at most [`LONGEST`] bytes are kept, with a note if there was more. What XML 1.0 cannot hold, and
/// other control characters, become U+FFFD.
#[must_use]
pub fn cut(said: &str) -> String {
    cut_to(said, LONGEST)
}

/// The same with another bound, in bytes.
#[must_use]
pub fn cut_to(said: &str, longest: usize) -> String {
    let kept = &said[..said.floor_char_boundary(longest)];
    let plain: String = kept.chars().map(plain).collect();
    let whole = kept.len() == said.len() && plain.len() <= longest;
    let note = if whole { "" } else { "… (the rest is not shown)" };
    format!("{}{note}", &plain[..plain.floor_char_boundary(longest)])
}

/// A character that every report can hold (Extensible Markup Language 1.0, 2.2: Char).
fn plain(c: char) -> char {
    match c {
        '\n' | '\t' => c,
        '\r' => '\n',
        '\u{fffe}' | '\u{ffff}' => char::REPLACEMENT_CHARACTER,
        c if c.is_control() => char::REPLACEMENT_CHARACTER,
        c => c,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_message_is_cut_between_characters() {
        let short = "é".repeat(LONGEST / 2);
        assert_eq!(cut(&short), short);
        let long = format!("x{short}");
        assert_eq!(cut(&long), format!("x{}… (the rest is not shown)", "é".repeat(LONGEST / 2 - 1)));
        // Each of these takes more room than before.
        let odd = cut(&"\0".repeat(LONGEST));
        assert!(odd.ends_with("\u{fffd}… (the rest is not shown)") && odd.len() < LONGEST + 30);
    }

    #[test]
    fn characters_that_xml_has_not_are_replaced() {
        assert_eq!(cut("a\0b\u{ffff}c\u{1b}[31m\r\n\t😀"), "a\u{fffd}b\u{fffd}c\u{fffd}[31m\n\n\t😀");
    }
}
