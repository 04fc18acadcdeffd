//! Quantities that are given a number once and for all.

use std::fmt;
use std::str::FromStr;

use crate::algebra::number::{Integer, Rational};
use crate::language::syntax::Name;

/// A quantity and its number: `r = 0.0178`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fixed {
    /// The ASCII name of the quantity, in whichever letters it was written.
    pub name: String,
    /// The number, exactly as it is written.
    pub value: Rational,
    /// How it is written.
    pub text: String,
}

/// Why a text fixes nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unfixed {
    /// There is no `=` in it, or nothing before it.
    Form,
    /// What stands behind the `=` is no number.
    Number(String),
}

impl fmt::Display for Unfixed {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unfixed::Form => {
                formatter.write_str("a quantity and its number are written `name=value`")
            }
            Unfixed::Number(text) => {
                write!(formatter, "`{text}` is no decimal number and no fraction")
            }
        }
    }
}

impl std::error::Error for Unfixed {}

impl FromStr for Fixed {
    type Err = Unfixed;

    fn from_str(text: &str) -> Result<Self, Unfixed> {
        let (name, number) = text.split_once('=').ok_or(Unfixed::Form)?;
        let (name, number) = (name.trim(), number.trim());
        if name.is_empty() {
            return Err(Unfixed::Form);
        }
        let value = number_of(number).ok_or_else(|| Unfixed::Number(number.to_string()))?;
        Ok(Fixed {
            name: Name::new(name).ascii,
            value,
            text: number.to_string(),
        })
    }
}

/// The exact value of a decimal number such as `-0.0178` or `1e-3`, or of a fraction of such numbers.
pub fn number_of(text: &str) -> Option<Rational> {
    match text.split_once('/') {
        None => signed(text),
        Some((above, below)) => {
            let (above, below) = (signed(above.trim())?, decimal(below.trim())?);
            (!below.is_zero()).then(|| above / below)
        }
    }
}

/// A number as a decimal where it has one of at most 20 places, else as a fraction.
pub fn written(value: &Rational) -> String {
    for places in 0..=20_usize {
        let scaled = value * Rational::from(Integer::from(10).pow(places));
        if !scaled.is_int() {
            continue;
        }
        let scaled = scaled.numerator().to_string();
        let (sign, digits) = match scaled.strip_prefix('-') {
            Some(digits) => ("-", digits),
            None => ("", scaled.as_str()),
        };
        let digits = format!("{digits:0>width$}", width = places + 1);
        let (whole, fraction) = digits.split_at(digits.len() - places);
        let point = if places == 0 { "" } else { "." };
        return format!("{sign}{whole}{point}{fraction}");
    }
    value.to_string()
}

fn signed(text: &str) -> Option<Rational> {
    match text.strip_prefix('-') {
        Some(text) => decimal(text).map(|value| -value),
        None => decimal(text.strip_prefix('+').unwrap_or(text)),
    }
}

/// The exact value of a decimal number without a sign.
pub(super) fn decimal(text: &str) -> Option<Rational> {
    /// Numbers beyond the doubles are of no use.
    const PLACES: u32 = 400;
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    if !is_number || digits.len() > PLACES as usize {
        return None;
    }
    let value = Rational::from(digits.parse::<Integer>().ok()?);
    let places = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    if places.unsigned_abs() > PLACES {
        return None;
    }
    let scale = Rational::from(Integer::from(10).pow(places.unsigned_abs() as usize));
    Some(if places < 0 {
        value / scale
    } else {
        value * scale
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_exact() {
        for (text, above, below) in [
            ("0.0178", 178, 10_000),
            ("-3/7", -3, 7),
            ("1e-3", 1, 1000),
            ("+2.5E1", 25, 1),
            ("1.5/0.5", 3, 1),
            ("7", 7, 1),
        ] {
            let expected = Rational::from(above) / Rational::from(below);
            assert_eq!(number_of(text), Some(expected), "{text}");
        }
        for text in [
            "", "-", "1,5", "1/0", "1/-2", "0x10", "1e999", "nan", "1 2", "--1", "1_000",
        ] {
            assert_eq!(number_of(text), None, "{text}");
        }
    }

    #[test]
    fn numbers_are_written_as_they_are_read() {
        for text in ["0", "-3", "0.0178", "-12.5", "1/3", "-22/7"] {
            assert_eq!(
                number_of(text).map(|number| written(&number)).as_deref(),
                Some(text)
            );
        }
    }

    #[test]
    fn a_name_and_a_number_are_wanted() {
        for (text, name) in [("r = 1/3", "r"), ("ρ=1/3", "rho")] {
            let fixed: Fixed = text.parse().expect("a name and a number");
            assert_eq!((fixed.name.as_str(), fixed.text.as_str()), (name, "1/3"));
        }
        assert_eq!("r".parse::<Fixed>(), Err(Unfixed::Form));
        assert_eq!("=3".parse::<Fixed>(), Err(Unfixed::Form));
        assert_eq!(
            "r=x".parse::<Fixed>(),
            Err(Unfixed::Number("x".to_string()))
        );
    }
}
