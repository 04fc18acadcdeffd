//! Units as a page sets them: upright, with a thin space before a unit and between two.

use super::escape;

/// A space that is thin, and at which no line is broken.
const THIN: &str = "\u{202F}";

/// The units behind numbers of a text.
const BEHIND_NUMBERS: [&str; 2] = ["m/s", "Hz"];

/// A unit as a document writes it, `N*s/m^2`, as HTML: N s/m².
pub fn set(unit: &str) -> String {
    let mut set = String::new();
    let mut rest = unit;
    while let Some((base, exponent)) = rest.split_once('^') {
        let end = end_of_exponent(exponent);
        let (exponent, after) = exponent.split_at(end);
        let exponent = exponent.trim().trim_matches(['(', ')']);
        set += &format!("{}<sup>{}</sup>", factors(base), factors(exponent));
        rest = after;
    }
    set + &factors(rest)
}

/// A text with a thin space between each number and its unit.
pub fn behind_numbers(text: &str) -> String {
    BEHIND_NUMBERS.iter().fold(text.to_owned(), |text, unit| {
        let unit = format!(" {unit}");
        let mut parts = text.split(&unit);
        let mut written = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let is_number = written.ends_with(|last: char| last.is_ascii_digit());
            written += if is_number { THIN } else { " " };
            written += &format!("{}{part}", unit.trim_start());
        }
        written
    })
}

/// Where an exponent ends: behind a number, or behind the bracket around a fraction.
fn end_of_exponent(text: &str) -> usize {
    if text.trim_start().starts_with('(') {
        return text.find(')').map_or(text.len(), |end| end + 1);
    }
    let is_part = |own: char| own.is_ascii_digit() || own == '-' || own == ' ';
    text.find(|own| !is_part(own)).unwrap_or(text.len())
}

/// Factors side by side.
fn factors(text: &str) -> String {
    let text: String = text.split_whitespace().collect();
    escape(&text)
        .replace(['*', '·'], THIN)
        .replace('-', "\u{2212}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_set_upright_with_thin_spaces() {
        for (unit, html) in [
            ("kg/m", "kg/m"),
            ("N*s/m^2", "N\u{202F}s/m<sup>2</sup>"),
            ("1/s^6", "1/s<sup>6</sup>"),
            ("kg * m^-2*s", "kg\u{202F}m<sup>\u{2212}2</sup>\u{202F}s"),
            ("m^(1/2)/s", "m<sup>1/2</sup>/s"),
            ("m^2*(", "m<sup>2</sup>\u{202F}("),
            ("1", "1"),
        ] {
            assert_eq!(set(unit), html);
        }
        assert_eq!(
            behind_numbers("U = 9 m/s, none at 1.2 Hz or so m/s"),
            "U = 9\u{202F}m/s, none at 1.2\u{202F}Hz or so m/s"
        );
    }
}
