//! The modes of one section, for a terminal.

use std::f64::consts::TAU;

use crate::report::modes::ModesFound;
use crate::report::stability::{bound_with, decimal, decimals};

/// Decimals where no error is known.
const USUAL_DECIMALS: usize = 9;

/// Doubles have no more than these near 1.
const MOST_DECIMALS: usize = 15;

/// A line a mode: λ, its error, and the frequency in Hz; then S_3D, the verdict and the warnings.
pub fn modes(found: &ModesFound) -> String {
    let mut text = String::new();
    for (place, (value, error)) in found.eigenvalues.iter().enumerate() {
        let decimals = error.map_or(USUAL_DECIMALS, |error| decimals(error, MOST_DECIMALS));
        let error = error.map_or(String::new(), |error| {
            format!(", within {}", bound_with(error, decimals))
        });
        text += &format!(
            "λ_{} = {} {} {}i 1/s{error}; {:.6} Hz\n",
            place + 1,
            decimal(value.re, decimals),
            if value.im < 0.0 { '-' } else { '+' },
            decimal(value.im.abs(), decimals),
            value.im / TAU
        );
    }
    if let Some((damping, error)) = found.damping_coefficient {
        let meaning = match error {
            Some(_) => "",
            None if damping < 0.0 => ": by this form the section gallops",
            None => ": by this form the section is stable",
        };
        let decimals = error.map_or(USUAL_DECIMALS, |error| decimals(error, MOST_DECIMALS));
        text += &format!("S_3D = {}{meaning}\n", decimal(damping, decimals));
    }
    let verdict = found.verdict;
    text += &format!("The section is {}: {verdict}\n", verdict.name());
    for warning in &found.warnings {
        text += &format!("Warning: {warning}\n");
    }
    text
}
