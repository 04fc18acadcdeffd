//! The modes of one section, for a terminal.

use std::f64::consts::TAU;

use crate::report::modes::{DampingCoefficient, ModeFound, ModesFound, Moving, Reading, Shape};
use crate::report::stability::{
    bound_with, decimal, decimals, degrees, is_unknown, power, significant,
};
use crate::stability::comparison::{Value, angle};
use crate::stability::tolerance::{Certainty, Tolerance};

/// Decimals where no error is known.
const USUAL_DECIMALS: i32 = 9;

/// Doubles have no more than these near 1.
const MOST_DECIMALS: i32 = 15;

/// Digits of what a formula gives, which is shown however far it is off.
const FORMULA_DIGITS: usize = 6;

/// Digits of coefficients.
const COEFFICIENT_DIGITS: usize = 6;

/// Digits of what is computed, but not certain.
const UNKNOWN_DIGITS: usize = 2;

/// Decimals of amplitudes and phases.
const SHAPE_DECIMALS: i32 = 4;

/// A line a mode: λ, its error, and the frequency in Hz if it oscillates, with its shape below; then S, the
/// verdict and the warnings.
pub fn modes(found: &ModesFound) -> String {
    let mut text = found
        .reading
        .as_ref()
        .map_or_else(String::new, coefficients);
    for (place, mode) in found.modes.iter().enumerate() {
        let ModeFound {
            value,
            error,
            shape,
        } = mode;
        let [(real, within), (imaginary, _)] =
            [value.re, value.im.abs()].map(|part| number(part, *error, found.is_formula));
        text += &format!(
            "λ_{} = {real} {} {imaginary}i 1/s{within}; {}\n",
            place + 1,
            if value.im < 0.0 { '-' } else { '+' },
            frequency(mode, found)
        );
        if let Some(shape) = shape {
            text += &format!("      {}\n", moves(shape));
        }
    }
    if let Some(damping) = found.damping_coefficient {
        let DampingCoefficient { name, value, error } = damping;
        let unknown = error.is_some_and(|error| !found.is_formula && lost(value, error));
        let meaning = match error {
            Some(_) if unknown => ": not a digit of it is certain",
            Some(_) => "",
            None if value < 0.0 => ": by this form the section gallops",
            None => ": by this form the section is stable",
        };
        let (number, within) = number(value, error, found.is_formula);
        // What is certain shows how far.
        let within = if found.is_formula || unknown {
            within
        } else {
            String::new()
        };
        text += &format!("{name} = {number}{within}{meaning}\n");
    }
    if let Some(twist) = &found.twist {
        let (shown, within) = (degrees(twist), power(twist.error.to_degrees()));
        text += &format!(
            "Mean twist {shown}, certain within {within}°; balance: {}\n",
            twist.word()
        );
    }
    let verdict = found.verdict;
    text += &format!(
        "The {} is {}: {verdict}\n",
        found.subject.name(),
        verdict.name()
    );
    let errors = found.reading.as_ref();
    text += &errors
        .and_then(|own| own.within_errors)
        .map_or_else(String::new, |own| {
            within_errors(own, found.damping_coefficient)
        });
    for warning in &found.warnings {
        text += &format!("Warning: {warning}\n");
    }
    text
}

/// `At 68.5°: C_D 1.21, C_L -0.32, C_M 0.011; dC_D 0.4, dC_L -2.1, dC_M 0.03 per radian`
fn coefficients(reading: &Reading) -> String {
    let Some(own) = &reading.coefficients else {
        return String::new();
    };
    let named = own.named();
    let written = |part: &[(&str, f64)]| {
        let one = |(name, value): &(&str, f64)| {
            format!("{name} {}", significant(*value, COEFFICIENT_DIGITS))
        };
        part.iter().map(one).collect::<Vec<_>>().join(", ")
    };
    let (values, slopes) = named.split_at(3);
    format!(
        "At {}°: {}; {} per radian\n",
        angle(reading.angle),
        written(values),
        written(slopes)
    )
}

/// What is certain for all coefficients, with the ends of S.
fn within_errors(own: Tolerance, damping: Option<DampingCoefficient>) -> String {
    let verdict = match own.certainty {
        Certainty::Stable => "it is stable for all of them",
        Certainty::Unstable => "it is unstable for all of them",
        Certainty::Depends => "its stability depends on them",
        Certainty::Open => "this is not decided",
    };
    // Rounded outwards.
    let between = own.damping.map(|[least, most]| {
        [(least * 1e6).floor(), (most * 1e6).ceil()].map(|end| decimal(end / 1e6, 6))
    });
    let between = match (damping.map(|own| own.name), between) {
        (None, _) => String::new(),
        (Some(name), Some([least, most])) => format!(", {name} from {least} to {most}"),
        (Some(name), None) => format!(", and no bounds of {name} are known"),
    };
    format!("For all coefficients within their errors: {verdict}{between}\n")
}

/// `0.845210 Hz`, as far as it is certain; what does not oscillate has none.
fn frequency(mode: &ModeFound, found: &ModesFound) -> String {
    let grows = mode.value.re > mode.error.unwrap_or(0.0);
    match (mode.value.im == 0.0, grows, found.diverges) {
        (true, false, _) => "no oscillation".to_string(),
        (true, true, true) => "no oscillation: it diverges".to_string(),
        (true, true, false) => format!("no oscillation: {}", found.subject.growth()),
        _ => {
            let value = mode.value.im / TAU;
            let error = mode.error.map(|error| error / TAU);
            match error {
                Some(error) if !found.is_formula && lost(value, error) => {
                    "frequency unknown".to_string()
                }
                _ => format!("{} Hz", number(value, error, found.is_formula).0),
            }
        }
    }
}

/// Whether no digit of a number is certain.
fn lost(value: f64, error: f64) -> bool {
    is_unknown(Value { value, error })
}

/// A number and how exact it is: as far as it is certain, or all that a formula gives and how far it is off.
fn number(value: f64, error: Option<f64>, is_formula: bool) -> (String, String) {
    match error {
        None if is_formula => (
            significant(value, FORMULA_DIGITS),
            ", off by an unknown amount".to_string(),
        ),
        None => (decimal(value, USUAL_DECIMALS), String::new()),
        Some(error) if is_formula => (
            significant(value, FORMULA_DIGITS),
            // Half a unit of the sixth digit is less than 5e-6 of the number.
            format!(", off by up to {}", power(error + 5e-6 * value.abs())),
        ),
        Some(error) => {
            let decimals = decimals(error, MOST_DECIMALS);
            // What is not known at all is not 0.
            let text = match lost(value, error) {
                true => significant(value, UNKNOWN_DIGITS),
                false => decimal(value, decimals),
            };
            (text, format!(", within {}", bound_with(error, decimals)))
        }
    }
}

/// `x 0.2104 at -12.3000°, y 1, rθ 0.0312 at 90.0000°`: amplitudes, and phases ahead of the largest.
fn moves(shape: &Shape) -> String {
    let Some(entries) = shape else {
        return "no shape in doubles".to_string();
    };
    let entry = |Moving {
                     shown: name,
                     entry: own,
                     ..
                 }: &Moving| {
        let phase = own.arg().to_degrees();
        // What is rounded to -180° is 180°.
        let phase = if phase < -179.99995 { 180.0 } else { phase };
        let [amplitude, phase, one, zero] =
            [own.norm(), phase, 1.0, 0.0].map(|number| decimal(number, SHAPE_DECIMALS));
        match (amplitude == one && phase == zero, amplitude == zero) {
            (true, _) => format!("{name} 1"),
            (_, true) => format!("{name} 0"),
            _ => format!("{name} {amplitude} at {phase}°"),
        }
    };
    entries.iter().map(entry).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex;

    use crate::report::modes::Subject;
    use crate::stability::verdict::{Proof, Verdict};

    fn page(error: f64, diverges: bool) -> String {
        let mode = |re, im| ModeFound {
            value: Complex::new(re, im),
            error: Some(error),
            shape: None,
        };
        modes(&ModesFound {
            twist: None,
            subject: Subject::Section,
            method: "state",
            is_formula: false,
            modes: vec![mode(-1.0, TAU / 3.0), mode(0.02, 0.0), mode(0.04, 0.0)],
            damping_coefficient: Some(DampingCoefficient {
                name: "S_3D",
                value: -16.8,
                error: Some(4e3 * error),
            }),
            verdict: Verdict::Stable(Proof::Errors),
            diverges,
            reading: None,
            warnings: Vec::new(),
        })
    }

    fn ends(page: &str) -> Vec<&str> {
        let lines = page.lines();
        lines.filter_map(|line| line.split("; ").nth(1)).collect()
    }

    #[test]
    fn a_frequency_has_the_digits_of_its_own_error() {
        // 0.03 1/s are 0.005 Hz.
        assert_eq!(
            ends(&page(0.03, true)),
            ["0.33 Hz", "no oscillation", "no oscillation: it diverges"]
        );
        assert_eq!(
            ends(&page(0.03, false)),
            ["0.33 Hz", "no oscillation", "no oscillation: it gallops"]
        );
    }

    #[test]
    fn what_is_not_known_is_not_0() {
        let page = page(0.03, false);
        let line = "S_3D = -17, within 1e3: not a digit of it is certain";
        assert!(page.lines().any(|own| own == line), "{page}");
        let page = self::page(20.0, false);
        assert!(
            page.starts_with("λ_1 = -1.0 + 2.1i 1/s, within 1e2; frequency unknown"),
            "{page}"
        );
    }
}
