//! Figures as they are printed: no more digits than are known.

/// Three significant digits: plain from 0.001 to 99,999, else with an exponent. `inf` for what is not finite.
pub(crate) fn three_digits(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    to_unit(value, exponent(value) - 2)
}

/// A mean with as many digits, at most three significant ones, as its standard error leaves certain: a second
/// run with other samples will hardly ever move the last digit by more than 1.
///
/// The difference of two such means has √2 times the standard error; six times it is 4.2 of its own.
/// `charts --second-seed` tells where samples are too few for that.
pub(crate) fn known_digits(mean: f64, standard_error: f64) -> String {
    if mean == 0.0 || !mean.is_finite() {
        return three_digits(mean);
    }
    let certain = (6.0 * standard_error).log10().ceil().max(-300.0) as i32;
    // Errors so rare that not even one digit is certain: 1 in the first place that is, an upper bound.
    let shown = if certain > exponent(mean) { 10f64.powi(certain) } else { mean };
    to_unit(shown, certain.max(exponent(shown) - 2))
}

/// A figure in a sentence: powers of ten as such, no more than two digits.
pub(crate) fn readable(value: f64) -> String {
    if value == 0.0 || (0.01..1e5).contains(&value.abs()) {
        let digits = (1 - exponent(value)).max(0) as usize;
        let text = format!("{value:.digits$}");
        return if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.').into()
        } else {
            text
        };
    }
    let text = format!("{value:.1e}");
    let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
    match mantissa.trim_end_matches(".0") {
        "1" => format!("10{}", raised(power)),
        mantissa => format!("{mantissa}·10{}", raised(power)),
    }
}

/// A printed figure with its power of ten written out, as the tables of the book have it: 8e-4 as 8·10⁻⁴.
pub(crate) fn spelled(printed: &str) -> String {
    match printed.split_once('e') {
        Some((mantissa, power)) => format!("{mantissa}·10{}", raised(power)),
        None => printed.into(),
    }
}

/// An exponent as it is written behind a 10.
fn raised(power: &str) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    power.chars().map(|c| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize])).collect()
}

/// What the last printed digit stands for.
pub(crate) fn last_digit(text: &str) -> f64 {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len() as i32);
    10f64.powi(exponent.parse::<i32>().unwrap_or(0) - decimals)
}

/// Rounded to a multiple of 10^`unit`.
fn to_unit(value: f64, unit: i32) -> String {
    if !value.is_finite() {
        return "inf".into();
    }
    let rounded: f64 = format!("{value:.*e}", (exponent(value) - unit) as usize).parse().unwrap_or(value);
    if (1e-3..1e5).contains(&rounded.abs()) {
        format!("{rounded:.*}", (-unit).max(0) as usize)
    } else {
        // Rounding may have carried into one more digit.
        format!("{rounded:.*e}", (exponent(rounded) - unit) as usize)
    }
}

/// The power of ten of the first significant digit.
fn exponent(value: f64) -> i32 {
    let text = format!("{:e}", value.abs());
    text.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits_are_three() {
        let texts = [0.0, 1234.5, 0.5, 99.96, 0.001_234_5, 9.999e-4, 5.9604e-8, 123_456.0, f64::INFINITY];
        assert_eq!(
            texts.map(three_digits),
            ["0", "1230", "0.500", "100.0", "0.00123", "0.001000", "5.96e-8", "1.23e5", "inf"]
        );
    }

    #[test]
    fn a_sentence_has_short_figures() {
        let texts = [0.0, 3.0, 26.0, 0.25, 46_416.0, 1e5, 3.2e-4, 1e-6].map(readable);
        assert_eq!(texts, ["0", "3", "26", "0.25", "46416", "10⁵", "3.2·10⁻⁴", "10⁻⁶"]);
    }

    #[test]
    fn only_certain_digits_are_printed() {
        assert_eq!(known_digits(0.251_23, 0.0001), "0.251");
        assert_eq!(known_digits(0.251_23, 0.001), "0.25");
        assert_eq!(known_digits(0.251_23, 0.01), "0.3");
        assert_eq!(known_digits(2.512e-7, 1e-9), "2.5e-7");
        assert_eq!(known_digits(4e-4, 1e-4), "0.001");
        assert_eq!(known_digits(0.25, 0.0), "0.250");
        assert_eq!(known_digits(0.0, 0.0), "0");
    }

    #[test]
    fn the_last_digit_has_a_place() {
        for (text, place) in [("0.251", 1e-3), ("17", 1.0), ("2.5e-7", 1e-8), ("3e5", 1e5)] {
            assert!((last_digit(text) / place - 1.0).abs() < 1e-9, "{text}");
        }
    }
}
