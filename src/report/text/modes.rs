//! The modes of one section, for a terminal.

use std::f64::consts::TAU;

use crate::report::modes::ModesFound;

/// A line a mode: λ, its error, and the frequency in Hz; then S_3D and the warnings.
pub fn modes(found: &ModesFound) -> String {
    let mut text = String::new();
    for (place, (value, error)) in found.eigenvalues.iter().enumerate() {
        let error = error.map_or(String::new(), |error| format!(", within {error:.0e}"));
        text += &format!(
            "λ_{} = {} {} {}i 1/s{error}; {:.6} Hz\n",
            place + 1,
            value.re,
            if value.im < 0.0 { '-' } else { '+' },
            value.im.abs(),
            value.im / TAU
        );
    }
    if let Some(damping) = found.damping_coefficient {
        let meaning = if damping < 0.0 {
            "the section gallops"
        } else {
            "the section is stable"
        };
        text += &format!("S_3D = {damping}: {meaning}\n");
    }
    for warning in &found.warnings {
        text += &format!("Warning: {warning}\n");
    }
    text
}
