//! What a submission may not say: only its one file is graded, and no `unsafe` in it.
//!
//! The words are looked for among the tokens, so that they may stand in comments and strings. A program that is made of
//! what this lets through can still do much: that it gains nothing by it is for the walls, and for there being nothing to
//! gain.

use std::fmt;
use std::str::FromStr;

use proc_macro2::{Spacing, TokenStream, TokenTree};

/// Why a text is not graded.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// What it says.
    pub found: String,
    /// Why that is not graded.
    pub because: &'static str,
    /// What to do.
    pub cure: String,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "found {}, not graded because {}; {}", self.found, self.because, self.cure)
    }
}

/// What of a text is not graded, if anything is.
///
/// What is not made of Rust's tokens is left to the compiler, unless the word `unsafe` stands anywhere in it.
#[must_use]
pub fn refused(text: &str) -> Option<Refusal> {
    match TokenStream::from_str(text) {
        Ok(tokens) => among(tokens),
        Err(_) => text.contains("unsafe").then(not_safe),
    }
}

fn not_safe() -> Refusal {
    Refusal {
        found: "`unsafe`".into(),
        because: "no mission needs it",
        cure: "write it without that word".into(),
    }
}

fn another_file(found: String, cure: String) -> Refusal {
    Refusal { found, because: "that names another file, and only lib.rs is graded", cure }
}

fn among(tokens: TokenStream) -> Option<Refusal> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let word = |n: usize| match tokens.get(n) {
        Some(TokenTree::Ident(ident)) => ident.to_string(),
        _ => String::new(),
    };
    let mark =
        |n: usize, mark: char| matches!(tokens.get(n), Some(TokenTree::Punct(p)) if p.as_char() == mark);
    let not_equal = |n: usize| {
        matches!(tokens.get(n), Some(TokenTree::Punct(p)) if p.spacing() == Spacing::Joint)
            && mark(n + 1, '=')
    };
    for (n, token) in tokens.iter().enumerate() {
        let found = match token {
            TokenTree::Group(group) => among(group.stream()),
            TokenTree::Ident(_) => match word(n).as_str() {
                "unsafe" => Some(not_safe()),
                "mod" if mark(n + 2, ';') => {
                    let name = word(n + 1);
                    let cure = format!("write `mod {name} {{ … }}` in lib.rs, with that file's text in it");
                    Some(another_file(format!("`mod {name};`"), cure))
                }
                name @ ("include" | "include_bytes" | "include_str")
                    if mark(n + 1, '!') && !not_equal(n + 1) =>
                {
                    Some(another_file(format!("`{name}!`"), "write what that file has in lib.rs".into()))
                }
                _ => None,
            },
            _ => None,
        };
        if found.is_some() {
            return found;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_an_honest_text_says_is_not_refused() {
        for text in [
            "// unsafe\n/* mod a; */ /// unsafe\nfn f() -> &'static str { \"unsafe { mod a; }\" }",
            "mod helper { pub mod inner { pub fn unsafely() {} } }",
            "fn r#mod() {} const MODULUS: i32 = 1; fn f(include: i32) -> bool { include != 2 }",
            "fn broken( {",
            "",
        ] {
            assert_eq!(refused(text), None, "{text}");
        }
    }

    #[test]
    fn what_is_refused_is_told_with_the_cure() {
        for (text, word) in [
            ("fn f() { unsafe { () } }", "found `unsafe`, not graded"),
            ("#[unsafe(naked)] extern \"C\" fn f() {}", "found `unsafe`, not graded"),
            ("macro_rules! m { () => { #[unsafe(no_mangle)] fn f() {} } }", "found `unsafe`, not graded"),
            ("fn broken( { unsafe", "found `unsafe`, not graded"),
            ("mod helper;", "write `mod helper { … }`"),
            ("mod a { #[path = \"b.rs\"]\npub mod b; }", "write `mod b { … }`"),
            ("const A: &[u8] = include_bytes!(\"a\");", "found `include_bytes!`"),
            ("std::include ! { \"a\" }", "found `include!`"),
        ] {
            let said = refused(text).map(|refusal| refusal.to_string()).unwrap_or_default();
            assert!(said.contains(word) && said.lines().count() == 1, "{text}: {said}");
        }
    }
}
