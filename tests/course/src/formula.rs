//! Formulas as text: TeX's mathematics, as far as chapters use it in their hints, in Unicode.

/// What commands stand for. Spaces are kept, several as one.
const SYMBOLS: &[(&str, &str)] = &[
    ("times", " × "),
    ("cdot", " · "),
    ("pm", " ± "),
    ("le", " ≤ "),
    ("ge", " ≥ "),
    ("ne", " ≠ "),
    ("approx", " ≈ "),
    ("in", " ∈ "),
    ("to", " → "),
    ("infty", "∞"),
    ("pi", "π"),
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("varphi", "φ"),
    ("lambda", "λ"),
    ("theta", "θ"),
    ("Delta", "Δ"),
    ("lfloor", "⌊"),
    ("rfloor", "⌋"),
    ("lceil", "⌈"),
    ("rceil", "⌉"),
    ("lVert", "‖"),
    ("rVert", "‖"),
    ("dots", "…"),
    ("ldots", "…"),
    ("quad", "  "),
    (",", " "),
    (";", " "),
    (" ", " "),
    ("{", "{"),
    ("}", "}"),
    ("%", "%"),
    // A function's name, or a sign that changes nothing but the size or the type.
    ("max", "max"),
    ("min", "min"),
    ("sin", "sin "),
    ("cos", "cos "),
    ("tan", "tan "),
    ("log", "log "),
    ("left", ""),
    ("right", ""),
    ("vec", ""),
    ("hat", ""),
    ("mathbf", ""),
    ("mathrm", ""),
    ("text", ""),
    ("operatorname", ""),
];

/// Digits and letters that there are above and below the line.
const RAISED: (&str, &str) = ("0123456789+−=()niTxyz", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿⁱᵀˣʸᶻ");
const LOWERED: (&str, &str) = ("0123456789+−=()aehijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ");

/// A formula as text. A command that is not known stays as it is, with its backslash.
pub(crate) fn formula(tex: &str) -> String {
    let mut rest = tex;
    let text = sequence(&mut rest);
    let words: Vec<&str> = text.split(' ').filter(|word| !word.is_empty()).collect();
    // What closes follows at once.
    ["⌋", "⌉", ")"].iter().fold(words.join(" "), |text, sign| text.replace(&format!(" {sign}"), sign))
}

/// Everything up to the end, or to a brace that closes.
fn sequence(rest: &mut &str) -> String {
    let mut text = String::new();
    while !rest.is_empty() && !rest.starts_with('}') {
        text += &one(rest);
    }
    text
}

/// One sign, command or group in braces.
fn one(rest: &mut &str) -> String {
    let mut signs = rest.chars();
    let Some(sign) = signs.next() else { return String::new() };
    *rest = signs.as_str();
    match sign {
        '{' => {
            let text = sequence(rest);
            *rest = rest.strip_prefix('}').unwrap_or(rest);
            text
        }
        '\\' => command(rest),
        '^' => script(&argument(rest), '^', RAISED),
        '_' => script(&argument(rest), '_', LOWERED),
        '-' => "−".into(),
        '\'' => "′".into(),
        '\n' => " ".into(),
        '<' | '>' | '=' => format!(" {sign} "),
        sign => sign.into(),
    }
}

/// What a command takes: the next sign or group.
fn argument(rest: &mut &str) -> String {
    *rest = rest.trim_start();
    one(rest)
}

fn command(rest: &mut &str) -> String {
    let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
    let length = if letters > 0 { letters } else { rest.chars().next().map_or(0, char::len_utf8) };
    let (name, behind) = rest.split_at(length);
    // The space behind letters ends the command and is no part of the formula.
    *rest = if letters > 0 { behind.trim_start() } else { behind };
    match name {
        "frac" | "tfrac" | "dfrac" => {
            let (above, below) = (argument(rest), argument(rest));
            format!("{}/{}", grouped(&above), grouped(&below))
        }
        "sqrt" => format!("√{}", grouped(&argument(rest))),
        _ => SYMBOLS
            .iter()
            .find(|(symbol, _)| *symbol == name)
            .map_or_else(|| format!("\\{name} "), |(_, text)| (*text).into()),
    }
}

/// In parentheses where it is more than one number or name, such as `10` or `x²`.
fn grouped(text: &str) -> String {
    let text = text.trim();
    let letters = text.chars().filter(char::is_ascii_alphanumeric).count();
    let is_number = text.chars().all(|c| c.is_ascii_digit());
    let is_name = letters <= 1 && text.chars().all(|c| c.is_alphanumeric() || "∞′".contains(c));
    if is_number || is_name { text.into() } else { format!("({text})") }
}

/// Above or below the line where Unicode has all of it, or else behind a sign.
fn script(text: &str, sign: char, (plain, moved): (&str, &str)) -> String {
    let text = text.trim();
    let one = |c: char| plain.chars().position(|own| own == c).and_then(|n| moved.chars().nth(n));
    let is_word = text.chars().all(char::is_alphabetic);
    let behind = || format!("{sign}{}", if is_word { text.into() } else { grouped(text) });
    text.chars().map(one).collect::<Option<String>>().unwrap_or_else(behind)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_can_be_read() {
        for (tex, text) in [
            ("x = -1", "x = −1"),
            (r"\max(|\Delta x|, |\Delta y|) + 1", "max(|Δx|, |Δy|) + 1"),
            (r"(b - a) \times (c - a)", "(b − a) × (c − a)"),
            (r"1 / \infty", "1 / ∞"),
            (r"\vec u = (0, 1, 0)", "u = (0, 1, 0)"),
            (r"\vec z' = \vec{x}'", "z′ = x′"),
            (r"\tfrac12", "1/2"),
            (r"\frac{x - a_x}{b_x}", "(x − aₓ)/bₓ"),
            (r"\frac{-1}{2w}", "(−1)/(2w)"),
            (r"\frac{10}{x^2}", "10/x²"),
            (r"\sqrt{n^2 + r^{10}}", "√(n² + r¹⁰)"),
            ("w_{clip}", "w_clip"),
            ("e^{-x/2}", "e^(−x/2)"),
            (r"0\le t\le 1", "0 ≤ t ≤ 1"),
            (r"\lfloor N \cdot i \rfloor", "⌊N · i⌋"),
            (r"45\,\%", "45 %"),
            (r"\unknown{x}", r"\unknown x"),
            ("a}b", "a"),
            ("{a", "a"),
            ("a^", "a"),
            ("\\", "\\"),
        ] {
            assert_eq!(formula(tex), text, "{tex}");
        }
    }
}
