//! Formulas: `LaTeX` in the source, `MathML` in the page, which browsers lay out without a script.

use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, ParserError, RenderConfig, Storage, push_mathml};

use crate::markup::guarded;

/// What stands between a function's name and a factor.
const SPACE: &str = "<mspace width=\"0.1667em\" />";

/// A formula as `MathML`, on a line of its own if `display`. It can stand anywhere in Markdown.
///
/// # Errors
/// What cannot be read, in one line.
pub(crate) fn mathml(latex: &str, display: bool) -> Result<String, String> {
    let storage = Storage::new();
    let events: Result<Vec<_>, _> = Parser::new(latex, &storage).collect();
    let events = events.map_err(|error| one_line(&error))?;
    let display_mode = if display { DisplayMode::Block } else { DisplayMode::Inline };
    let mut html = String::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    push_mathml(&mut html, events.into_iter().map(Ok::<_, ParserError>), config)
        .map_err(|error| error.to_string())?;
    // A space that LaTeX writes as `\ ` or `~` comes out escaped twice.
    let html = html.replace("&amp;nbsp;", "&nbsp;");
    // The sign is written as it is, which no page may hold.
    let html = html.replace("<mo><</mo>", "<mo>&lt;</mo>");
    // The space before a function's name comes out as a part of a power that has two, which no browser then sets above.
    let html = ["msup", "msub", "msubsup"]
        .into_iter()
        .fold(html, |html, name| html.replace(&format!("<{name}>{SPACE}"), &format!("{SPACE}<{name}>")));
    // The letter, which is set in italics like all others; what comes out is the sign of micrometres.
    let html = html.replace("<mi>\u{b5}</mi>", "<mi>\u{3bc}</mi>");
    Ok(guarded(&html))
}

/// The parser's message without the frame that it draws around the place.
fn one_line(error: &ParserError) -> String {
    let words = error.to_string().replace(['╭', '╰', '─', '►', '│', '^'], " ");
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_chapters_need_is_understood() {
        for latex in [
            r"\begin{pmatrix} 1 & 0 \\ 0 & \cos\theta \end{pmatrix}",
            r"\begin{aligned} a &= b + c \\ &= d \end{aligned}",
            r"\overrightarrow{AB} \cdot \vec{u}_\parallel \times \hat{n}",
            r"f(x) = \begin{cases} 1 & x > 0 \\ 0 & \text{otherwise} \end{cases}",
            r"a\ b~c\text{ d }",
            r"\left\lfloor \frac{2 i \cdot r + n - 1}{2 n} \right\rfloor \le \lceil x \rceil",
        ] {
            let html = mathml(latex, true).unwrap();
            assert!(html.starts_with("<math") && !html.contains('\n') && !html.contains("&amp;"), "{html}");
        }
    }

    #[test]
    fn markdown_finds_no_markup_in_a_formula() {
        let html = mathml(r"a * b_1 [c] | d", false).unwrap();
        let text: String =
            html.split('<').filter_map(|part| part.split_once('>')).map(|part| part.1).collect();
        assert!(!text.contains(['*', '_', '[', '|']), "{text}");
    }

    #[test]
    fn a_power_has_two_parts() {
        let html = mathml(r"2 \sin^2 \theta \log_2 x", true).unwrap();
        for part in ["<msup><mi>sin</mi><mn>2</mn></msup>", "<msub><mi>log</mi><mn>2</mn></msub>"] {
            assert!(html.contains(part), "{html}");
        }
    }

    #[test]
    fn less_than_is_no_tag() {
        let html = mathml(r"0 \le i < n", true).unwrap();
        assert!(html.contains("<mo>&lt;</mo>") && !html.contains("<<"), "{html}");
    }

    #[test]
    fn a_broken_formula_is_an_error_of_one_line() {
        for latex in [r"\frac{1}{", r"\nonsense", r"{a", r"a &"] {
            let error = mathml(latex, false).unwrap_err();
            assert!(!error.is_empty() && !error.contains('\n'), "{latex}: {error}");
        }
    }
}
