//! A picture in the terminal.
//!
//! The character `▀` has its upper half in the text colour and the rest in the background colour: two
//! square pixels a character, in 24-bit colours.

use std::fmt::Write;
use std::io::IsTerminal;

use crate::terminal::wants_colors;
use crate::{Color, Image};

/// The picture as lines of half-block characters with ANSI colours, made smaller where it is wider than
/// `columns` or higher than `rows` characters.
#[must_use]
pub fn half_blocks(image: &Image, columns: u16, rows: u16) -> String {
    let (width, height) = (image.width().max(1) as f32, image.height().max(1) as f32);
    let factor = (f32::from(columns) / width).min(2.0 * f32::from(rows) / height).min(1.0);
    let fitted = |side: f32| ((side * factor).round() as u16).max(1);
    let small = image.scale(fitted(width), fitted(height));
    let mut text = String::new();
    for top in (0..small.height()).rev().step_by(2) {
        for x in 0..small.width() {
            let [above, below] = [top, top - 1].map(|y| small.get(x, y).unwrap_or(Color::BLACK));
            // Writing to a string cannot fail.
            let _ = write!(
                text,
                "\x1b[38;2;{};{};{};48;2;{};{};{}m▀",
                above.r, above.g, above.b, below.r, below.g, below.b
            );
        }
        text.push_str("\x1b[0m\n");
    }
    text
}

/// The picture for this terminal; `None` where standard output is no terminal, or one that may not show it.
#[must_use]
pub fn for_terminal(image: &Image) -> Option<String> {
    if !std::io::stdout().is_terminal() || !shows_colors(|name| std::env::var(name).unwrap_or_default()) {
        return None;
    }
    let (columns, rows) =
        terminal_size::terminal_size().map_or((80, 24), |(columns, rows)| (columns.0, rows.0));
    // Two lines stay free, for the command and for the line that names the files.
    Some(half_blocks(image, columns.max(1), rows.saturating_sub(2).max(1)))
}

/// Whether a terminal shows 24-bit colours, and its user wants colours, by the variables of its environment
/// (one that is not set is empty).
///
/// Terminals that can say so in `COLORTERM` (<https://github.com/termstandard/colors>). Some have names that
/// are enough, Windows Terminal has a variable of its own, and in terminfo `-direct` stands for these colours.
fn shows_colors(variable: impl Fn(&str) -> String) -> bool {
    const TERMS: [&str; 6] = ["alacritty", "contour", "foot", "wezterm", "xterm-ghostty", "xterm-kitty"];
    const PROGRAMS: [&str; 4] = ["WezTerm", "ghostty", "iTerm.app", "vscode"];
    let term = variable("TERM");
    let able = ["truecolor", "24bit"].contains(&variable("COLORTERM").as_str())
        || !variable("WT_SESSION").is_empty()
        || term.ends_with("-direct")
        || TERMS.contains(&term.as_str())
        || PROGRAMS.contains(&variable("TERM_PROGRAM").as_str());
    wants_colors(&variable) && able
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Format;

    #[test]
    fn two_rows_a_line_the_upper_one_first() {
        let mut image = Image::new(1, 3, Format::Rgb);
        image.set(0, 2, Color::RED);
        image.set(0, 1, Color::GREEN);
        image.set(0, 0, Color::WHITE);
        let expected = "\x1b[38;2;255;0;0;48;2;0;255;0m▀\x1b[0m\n\x1b[38;2;255;255;255;48;2;0;0;0m▀\x1b[0m\n";
        assert_eq!(half_blocks(&image, 80, 24), expected);
    }

    #[test]
    fn it_fits() {
        for (width, height, fitted) in [
            (100, 100, (24, 12)),
            (1000, 10, (40, 1)),
            (10, 1000, (1, 12)),
            (40, 3, (40, 2)),
            (1, 1, (1, 1)),
            (0, 0, (1, 1)),
        ] {
            let text = half_blocks(&Image::new(width, height, Format::Rgb), 40, 12);
            let columns = text.lines().map(|line| line.matches('▀').count());
            let (columns, rows) = (columns.collect::<Vec<_>>(), text.lines().count());
            assert_eq!((columns, rows), (vec![fitted.0; fitted.1], fitted.1), "{width}x{height}");
        }
    }

    #[test]
    fn it_is_shown_only_where_it_can_be() {
        for (variables, shown) in [
            (&[][..], false),
            (&[("TERM", "xterm-256color")], false),
            (&[("TERM", "linux")], false),
            (&[("TERM", "xterm-256color"), ("TERM_PROGRAM", "Apple_Terminal")], false),
            (&[("TERM", "xterm-256color"), ("COLORTERM", "truecolor")], true),
            (&[("TERM", "tmux-256color"), ("COLORTERM", "24bit")], true),
            (&[("COLORTERM", "yes")], false),
            (&[("WT_SESSION", "0e6f")], true),
            (&[("TERM", "xterm-kitty")], true),
            (&[("TERM", "xterm-direct")], true),
            (&[("TERM", "xterm-256color"), ("TERM_PROGRAM", "iTerm.app")], true),
            (&[("COLORTERM", "truecolor"), ("TERM", "dumb")], false),
            (&[("COLORTERM", "truecolor"), ("NO_COLOR", "1")], false),
            (&[("COLORTERM", "truecolor"), ("NO_COLOR", "")], true),
        ] {
            let variable = |name: &str| {
                let found = variables.iter().find(|variable| variable.0 == name);
                found.map_or(String::new(), |variable| variable.1.into())
            };
            assert_eq!(shows_colors(variable), shown, "{variables:?}");
        }
    }
}
