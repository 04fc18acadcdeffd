//! Decimal literals, exactly as they are written.

use crate::algebra::number::{Integer, Rational};

/// Longer literals and larger exponents are beyond all doubles.
const LONGEST: usize = 1_200;

/// The exact value of a literal such as `8.0`, `0.125` or `1.0e3`; none without a point, because C takes
/// `1/3` for 0.
pub(super) fn decimal(text: &str) -> Option<Rational> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.')?;
    let is_digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    if text.len() > LONGEST || !is_digits(whole) || !is_digits(fraction) {
        return None;
    }
    let digits: Integer = format!("{whole}{fraction}").parse().ok()?;
    let places = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    let length = places.unsigned_abs() as usize;
    if length > LONGEST {
        return None;
    }
    let scale = Rational::from(Integer::from(10).pow(length));
    let value = Rational::from(digits);
    Some(match places < 0 {
        true => value / scale,
        false => value * scale,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_are_exact_decimals() {
        for (text, above, below) in [
            ("8.0", 8, 1),
            ("0.125", 1, 8),
            ("1.5e3", 1_500, 1),
            ("12.50E-1", 5, 4),
            ("0.0178", 89, 5_000),
        ] {
            let value = Rational::from(above) / Rational::from(below);
            assert_eq!(decimal(text), Some(value), "{text}");
        }
        for text in [
            "",
            "8",
            "8.",
            ".5",
            "1e3",
            "0x1.0",
            "1_0.0",
            "1.0f",
            "-1.0",
            "1.0e999999",
        ] {
            assert_eq!(decimal(text), None, "{text}");
        }
        assert_eq!(decimal(&format!("0.{}", "0".repeat(2_000))), None);
    }
}
