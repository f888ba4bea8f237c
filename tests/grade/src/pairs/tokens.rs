//! A text as a sequence of tokens in which a renamed or reformatted copy is the same.
//!
//! The compiler's own lexer reads it. Comments and whitespace are gone; all names are one kind of token, and so are all
//! numbers, all strings, all characters and all lifetimes. Keywords and punctuation stay what they are.

use std::ops::Range;

use ra_ap_rustc_lexer::{FrontmatterAllowed, LiteralKind, TokenKind, strip_shebang, tokenize};

/// What is not compared: given code, and what is too short between it. The lexer makes none.
pub(super) const GIVEN: u8 = 0;

/// The strict keywords of the Rust Reference.
const KEYWORDS: [&str; 39] = [
    "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern", "false",
    "fn", "for", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return",
    "self", "Self", "static", "struct", "super", "trait", "true", "type", "unsafe", "use", "where", "while",
    "_",
];
/// The first keyword's kind; punctuation is its own ASCII character, and the rest a letter or digit.
const FIRST: u8 = 128;

/// The tokens of a text.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Tokens {
    /// What each is, in a byte.
    pub(super) kinds: Vec<u8>,
    /// Where each is, in bytes of the text.
    pub(super) places: Vec<Range<usize>>,
    /// The first line, from 1, in which something is no Rust, and what.
    pub(super) fault: Option<(usize, &'static str)>,
}

/// Reads any text. After something that is no token, it goes on.
pub(super) fn tokens(text: &str) -> Tokens {
    let mut tokens = Tokens::default();
    let mut at = strip_shebang(text).unwrap_or(0);
    for token in tokenize(&text[at..], FrontmatterAllowed::No) {
        let place = at..at + token.len as usize;
        at = place.end;
        let (kind, fault) = kind(token.kind, &text[place.clone()]);
        if let (Some(fault), None) = (fault, tokens.fault) {
            tokens.fault = Some((line(text, place.start), fault));
        }
        if let Some(kind) = kind {
            tokens.kinds.push(kind);
            tokens.places.push(place);
        }
    }
    tokens
}

/// The number of the line, from 1, that a byte is in.
pub(super) fn line(text: &str, at: usize) -> usize {
    text.as_bytes()[..at].iter().filter(|byte| **byte == b'\n').count() + 1
}

/// What a token is, if it is one that counts, and what is wrong with it, if something is.
fn kind(kind: TokenKind, text: &str) -> (Option<u8>, Option<&'static str>) {
    let open = |fault, terminated: bool| (!terminated).then_some(fault);
    match kind {
        TokenKind::Whitespace | TokenKind::LineComment { .. } | TokenKind::Eof => (None, None),
        TokenKind::BlockComment { terminated, .. } => (None, open("a comment without an end", terminated)),
        TokenKind::Ident => {
            let keyword = KEYWORDS.iter().position(|keyword| *keyword == text);
            (Some(keyword.map_or(b'i', |n| FIRST + n as u8)), None)
        }
        TokenKind::RawIdent | TokenKind::ForcedKeywordIdent => (Some(b'i'), None),
        TokenKind::Lifetime { .. } | TokenKind::RawLifetime => (Some(b'l'), None),
        TokenKind::Literal { kind, .. } => match kind {
            LiteralKind::Int { .. } | LiteralKind::Float { .. } => (Some(b'0'), None),
            LiteralKind::Char { terminated } | LiteralKind::Byte { terminated } => {
                (Some(b'\''), open("a character without an end", terminated))
            }
            LiteralKind::Str { terminated }
            | LiteralKind::ByteStr { terminated }
            | LiteralKind::CStr { terminated } => (Some(b'"'), open("a string without an end", terminated)),
            LiteralKind::RawStr { n_hashes }
            | LiteralKind::RawByteStr { n_hashes }
            | LiteralKind::RawCStr { n_hashes } => {
                (Some(b'"'), open("a raw string without an end", n_hashes.is_some()))
            }
        },
        TokenKind::InvalidIdent
        | TokenKind::UnknownPrefix
        | TokenKind::UnknownPrefixLifetime
        | TokenKind::GuardedStrPrefix
        | TokenKind::Frontmatter { .. }
        | TokenKind::Unknown => (Some(b'u'), Some("something that is no token of Rust")),
        // Punctuation, one ASCII character each.
        _ => (text.bytes().next(), None),
    }
}
