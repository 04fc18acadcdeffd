//! The modes of one section by one method.

use num_complex::Complex;

use crate::stability::verdict::Verdict;

/// What a method says of a section.
#[derive(Clone, Debug, PartialEq)]
pub struct ModesFound {
    /// The method: `closed`, `uniform`, `exact`, `companion`, `state`.
    pub method: &'static str,
    /// λ in 1/s, one of each pair of conjugates, with a bound of its error if the method gives one.
    pub eigenvalues: Vec<(Complex<f64>, Option<f64>)>,
    /// S_3D, with a bound of its error if the method gives one; `None` without wind.
    pub damping_coefficient: Option<(f64, Option<f64>)>,
    /// Whether the section is stable, with proof, by whichever method the modes are found.
    pub verdict: Verdict,
    /// What speaks against the answer, and what was given in vain.
    pub warnings: Vec<String>,
}
