//! The lines and words of an OBJ or MTL file, as bytes.
//!
//! A line ends in a line feed, a carriage return, or both. A backslash at its end joins the next line to it,
//! blanks behind the backslash or not; in a comment only without blanks, as a folder's name may end a comment.
//! A comment goes from `#` to the end of the line, also where the `#` ends a word. Only names and comments may hold other than ASCII, so any
//! encoding that has ASCII in it will do.

/// What ends a word but no line.
fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0x0b | 0x0c)
}

/// A place in a file, from which it is read word by word and line by line.
#[derive(Clone)]
pub(crate) struct Words<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Words<'a> {
    /// Reads from the beginning; a byte order mark is passed over.
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        let at = if bytes.starts_with("\u{feff}".as_bytes()) { 3 } else { 0 };
        Self { bytes, at }
    }

    /// Reads from an offset in bytes.
    pub(crate) fn at(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at }
    }

    /// The offset in bytes of what is read next.
    pub(crate) fn offset(&self) -> usize {
        self.at
    }

    /// The next word of this line; `None` at its end.
    pub(crate) fn word(&mut self) -> Option<&'a [u8]> {
        while let Some(&byte) = self.bytes.get(self.at) {
            match byte {
                _ if is_blank(byte) => self.at += 1,
                b'\\' => match self.joined(self.at, true) {
                    Some(next) => self.at = next,
                    None => break,
                },
                _ => break,
            }
        }
        let begin = self.at;
        while let Some(&byte) = self.bytes.get(self.at) {
            let ends = is_blank(byte)
                || matches!(byte, b'\n' | b'\r')
                || byte == b'#' && !self.is_in_a_number()
                || byte == b'\\' && self.joined(self.at, true).is_some();
            if ends {
                break;
            }
            self.at += 1;
        }
        (begin < self.at).then(|| &self.bytes[begin..self.at])
    }

    /// How many words are left of this line.
    pub(crate) fn count(&mut self) -> usize {
        std::iter::from_fn(|| self.word()).count()
    }

    /// Whether a `#` begins no comment: C libraries of Windows wrote `1.#INF`, `-1.#IND`, `1.#QNAN` for what is not
    /// finite, and what is left of those without a comment would be a number.
    fn is_in_a_number(&self) -> bool {
        let behind = &self.bytes[self.at + 1..];
        self.bytes[..self.at].ends_with(b".")
            && ["INF", "IND", "QNAN", "SNAN"].iter().any(|name| behind.starts_with(name.as_bytes()))
    }

    /// What is left of this line but blanks around it and a comment: a name, which may have blanks in it.
    pub(crate) fn rest(&mut self) -> &'a [u8] {
        let begin = self.at;
        while self.bytes.get(self.at).is_some_and(|byte| !matches!(byte, b'\n' | b'\r' | b'#')) {
            self.at += 1;
        }
        self.bytes[begin..self.at].trim_ascii()
    }

    /// Goes to the beginning of the next line; false at the end of the file.
    pub(crate) fn next_line(&mut self) -> bool {
        let mut in_comment = false;
        while let Some(&byte) = self.bytes.get(self.at) {
            match byte {
                b'\n' | b'\r' => {
                    self.at = self.line_end(self.at);
                    return true;
                }
                b'\\' => self.at = self.joined(self.at, !in_comment).unwrap_or(self.at + 1),
                _ => {
                    in_comment |= byte == b'#';
                    self.at += 1;
                }
            }
        }
        false
    }

    /// Behind the line end that begins at `at`.
    fn line_end(&self, at: usize) -> usize {
        at + if self.bytes[at..].starts_with(b"\r\n") { 2 } else { 1 }
    }

    /// Where the next line begins if the backslash at `at` joins it to this one.
    fn joined(&self, at: usize, over_blanks: bool) -> Option<usize> {
        let mut end = at + 1;
        while over_blanks && self.bytes.get(end).copied().is_some_and(is_blank) {
            end += 1;
        }
        match self.bytes.get(end) {
            None => Some(end),
            Some(b'\n' | b'\r') => Some(self.line_end(end)),
            Some(_) => None,
        }
    }
}

/// The number of the line, from 1, in which the byte at `offset` is.
pub(crate) fn line_number(bytes: &[u8], offset: usize) -> usize {
    let before = &bytes[..offset];
    let ends = before.iter().zip(bytes.iter().skip(1).chain(&[0]));
    1 + ends.filter(|&(&byte, &next)| byte == b'\n' || byte == b'\r' && next != b'\n').count()
}

/// A word of a file as it can be shown in a line: what would not print is escaped, and it is cut short.
pub(crate) fn shown(word: &[u8]) -> String {
    const LONGEST: usize = 20;
    // No character takes more than 4 bytes; one more says that there are more.
    let text = String::from_utf8_lossy(&word[..word.len().min(4 * (LONGEST + 1))]);
    let cut = if text.chars().nth(LONGEST).is_some() { "..." } else { "" };
    text.chars().take(LONGEST).flat_map(char::escape_debug).chain(cut.chars()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each line's number and words.
    fn lines(text: &str) -> Vec<(usize, Vec<String>)> {
        let mut words = Words::new(text.as_bytes());
        let mut lines = Vec::new();
        loop {
            let number = line_number(text.as_bytes(), words.offset());
            let mut line = Vec::new();
            while let Some(word) = words.word() {
                line.push(shown(word));
            }
            lines.push((number, line));
            if !words.next_line() {
                return lines;
            }
        }
    }

    fn line(number: usize, words: &str) -> (usize, Vec<String>) {
        (number, words.split_whitespace().map(Into::into).collect())
    }

    #[test]
    fn a_line_ends_in_a_line_feed_a_carriage_return_or_both() {
        for end in ["\n", "\r", "\r\n"] {
            let text = ["a 1", "", "# b", "c# d", "e"].join(end);
            let expected = [line(1, "a 1"), line(2, ""), line(3, ""), line(4, "c"), line(5, "e")];
            assert_eq!(lines(&text), expected, "{end:?}");
        }
        assert_eq!(
            lines("a\rb\nc\r\nd\n\re"),
            [1, 2, 3, 4, 5, 6].map(|n| line(n, ["a", "b", "c", "d", "", "e"][n - 1]))
        );
    }

    #[test]
    fn a_backslash_at_the_end_joins_the_next_line() {
        for joint in ["\\\n", " \\\r\n", "\\ \t\n ", "\\\r", "\\\n\\\n"] {
            let joints = joint.matches('\\').count();
            assert_eq!(
                lines(&format!("f 1{joint}2\nb")),
                [line(1, "f 1 2"), line(2 + joints, "b")],
                "{joint:?}"
            );
            assert_eq!(lines(&format!("f{joint}2")), [line(1, "f 2")], "{joint:?}");
        }
        assert_eq!(lines("a\\b \\c\nd\\"), [line(1, r"a\\b \\c"), line(2, "d")]);
        // In a comment, one that stands at the very end.
        assert_eq!(lines("# a \\\nb\nc"), [line(1, ""), line(3, "c")]);
        assert_eq!(lines("# C:\\models\\ \nb"), [line(1, ""), line(2, "b")]);
        // Also one of whose words no more is read.
        let mut words = Words::new(b"o a \\ \nb\nc");
        assert!(words.next_line());
        assert_eq!(words.word(), Some(&b"c"[..]));
    }

    #[test]
    fn a_comment_may_begin_behind_a_number() {
        assert_eq!(lines("1.# a\n2#INF\n1.#INF"), [line(1, "1."), line(2, "2"), line(3, "1.#INF")]);
    }

    #[test]
    fn a_mark_before_the_first_word_is_passed_over() {
        assert_eq!(lines("\u{feff}v 1"), [line(1, "v 1")]);
        assert_eq!(lines(""), [line(1, "")]);
    }
}
