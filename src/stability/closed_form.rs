//! The closed forms (21) to (23), and where they may be used.

use std::fmt;

use num_complex::Complex;
use sextic_evaluators::closed_form::{ClosedFormInputs, closed_form as evaluated};

use super::forces::norm;
use super::given::Given;
use super::section::{Parameters, Section};

/// Damping of a mode above this share of its frequency is not small.
pub(super) const STRONG: f64 = 0.1;

/// What speaks against a closed form for a section.
///
/// In the order in which one should look; of one kind, the greater is the worse.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub enum Limitation {
    /// A coordinate is held: they do not apply.
    NotAllFree,
    /// No modes without wind, or no roots, were found in doubles.
    NoRoots,
    /// The natural frequencies differ: they do not apply.
    NotTuned,
    /// There is structural damping, which they leave out.
    StructuralDamping,
    /// There is aerodynamic stiffness, which the form leaves out.
    AerodynamicStiffness,
    /// e ≤ δ|S|: the modes are separated by less than they are damped, and even the sign may be wrong. The damping
    /// stands first, since what is damped more is worse.
    Eccentricity {
        /// δ|S| with δ = ρ D U/(2 m ω_n) and the Frobenius norm of S_a, Eq. (18).
        damping: f64,
        /// e = L_g/r.
        eccentricity: f64,
    },
    /// |S| ≤ |S_a| (δ|S_a|/e)²: what is left out may be as large as the result, and of the other sign.
    Sign {
        /// (δ|S_a|/e)².
        second_order: f64,
    },
    /// The damping is not small beside the frequencies: what is left out may matter.
    StrongDamping {
        /// The largest |λ_R|/ω of a mode by the closed forms; by the uniform form |B|/(2ν), the damping in modal
        /// coordinates over twice the lowest frequency.
        damping: f64,
    },
}

impl Limitation {
    /// In a word, as in tables: `held`, `detuned`, `damped`, `stiffness`, `eccentricity`, `sign`,
    /// `strong` or `no-roots`.
    pub fn name(&self) -> &'static str {
        match self {
            Limitation::NotAllFree => "held",
            Limitation::NotTuned => "detuned",
            Limitation::StructuralDamping => "damped",
            Limitation::AerodynamicStiffness => "stiffness",
            Limitation::Eccentricity { .. } => "eccentricity",
            Limitation::Sign { .. } => "sign",
            Limitation::StrongDamping { .. } => "strong",
            Limitation::NoRoots => "no-roots",
        }
    }
}

impl fmt::Display for Limitation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Limitation::NotAllFree => {
                write!(
                    formatter,
                    "this form needs x, y and theta free, and not all are"
                )
            }
            Limitation::NotTuned => write!(
                formatter,
                "the closed form needs perfect tuning, and the natural frequencies differ"
            ),
            Limitation::StructuralDamping => {
                write!(
                    formatter,
                    "the closed form leaves the structural damping out"
                )
            }
            Limitation::AerodynamicStiffness => {
                write!(
                    formatter,
                    "aerodynamic stiffness is on, and this form leaves it out"
                )
            }
            Limitation::Eccentricity {
                eccentricity,
                damping,
            } => write!(
                formatter,
                "the eccentricity L_g/r = {} is not above the aerodynamic damping δ|S_a| = {}: the closed form may have the wrong sign",
                short(*eccentricity),
                short(*damping)
            ),
            Limitation::Sign { second_order } => write!(
                formatter,
                "the closed form leaves out what is of the order (δ|S_a| r/L_g)² = {second_order:.1e} of |S_a|, as much as its S: it may have the wrong sign"
            ),
            Limitation::StrongDamping { damping } => write!(
                formatter,
                "the damping is not small: {damping:.2} of a frequency; the form leaves out higher orders of it"
            ),
            Limitation::NoRoots => write!(
                formatter,
                "the modes without wind were not found in doubles"
            ),
        }
    }
}

/// A number that is not negative, with three decimals or a power of ten.
fn short(number: f64) -> String {
    match number {
        0.0 => "0".to_string(),
        0.01..1e3 => format!("{number:.3}"),
        _ => format!("{number:.2e}"),
    }
}

/// The three eigenvalues with positive frequencies that a closed form gives.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm {
    /// λ_k = λ_Rk + i ω_k in 1/s, the highest frequency first.
    pub eigenvalues: [Complex<f64>; 3],
    /// What speaks against them.
    pub warnings: Vec<Limitation>,
}

impl ClosedForm {
    /// The largest real part, in 1/s.
    pub fn largest_real_part(&self) -> f64 {
        let parts = self.eigenvalues.iter().map(|value| value.re);
        parts.fold(f64::NEG_INFINITY, f64::max)
    }
}

/// S by a closed form, and what speaks against it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Estimate {
    /// S; `None` where the form does not apply, or without wind.
    pub value: Option<f64>,
    /// What speaks against it.
    pub limitations: Vec<Limitation>,
}

impl Estimate {
    /// What a form says of a section.
    pub(super) fn new(p: &Parameters, form: Result<ClosedForm, Limitation>) -> Self {
        match form {
            Ok(form) => Estimate {
                value: p.damping_coefficient(form.largest_real_part()),
                limitations: form.warnings,
            },
            Err(limitation) => Estimate {
                value: None,
                limitations: vec![limitation],
            },
        }
    }
}

/// The closed forms for a section: the real parts of Eqs. (21)–(23) with the frequencies of Eq. (15).
///
/// # Errors
///
/// If they do not apply: [`Limitation::NotAllFree`], [`Limitation::NotTuned`]. Frequencies count as
/// equal if they differ by at most 1e-9 of themselves.
pub fn closed_form(section: &Section) -> Result<ClosedForm, Limitation> {
    closed_form_of(&Given::of(section.parameters()))
}

/// The same for numbers that are known to be possible.
pub(super) fn closed_form_of(given: &Given<f64>) -> Result<ClosedForm, Limitation> {
    let p = &given.parameters;
    if !p.free.are_all() {
        return Err(Limitation::NotAllFree);
    }
    let omega_n = p.natural_frequencies[0];
    let is_tuned = |omega: &f64| (omega - omega_n).abs() <= 1e-9 * omega_n;
    if !p.natural_frequencies.iter().all(is_tuned) {
        return Err(Limitation::NotTuned);
    }
    let s_a = given.scaled_damping();
    let parts = evaluated(&given.closed_form_inputs(&s_a));
    let parts = [parts.lamda_R1, parts.lamda_R2, parts.lamda_R3];
    let squares = given.squares_without_wind(omega_n);
    let mode = |place: usize| Complex::new(parts[place], squares[place].sqrt());
    let eigenvalues = [0, 1, 2].map(mode);
    Ok(ClosedForm {
        eigenvalues,
        warnings: warnings(p, norm(&s_a), &eigenvalues),
    })
}

/// What the evaluator of Eqs. (21)–(23) takes, of a section.
pub fn inputs(section: &Section) -> ClosedFormInputs<f64> {
    let given = Given::of(section.parameters());
    given.closed_form_inputs(&given.scaled_damping())
}

/// What speaks against the closed forms where they apply; `size` is |S_a|.
fn warnings(p: &Parameters, size: f64, eigenvalues: &[Complex<f64>; 3]) -> Vec<Limitation> {
    let is_damped = p.damping_ratios.iter().any(|&ratio| ratio > 0.0);
    let small = p.small_quantities();
    let (eccentricity, damping) = (small.e, small.delta * size);
    let second_order = (damping / eccentricity).powi(2);
    let largest = |number: fn(&Complex<f64>) -> f64| {
        let numbers = eigenvalues.iter().map(number);
        numbers.fold(f64::NEG_INFINITY, f64::max)
    };
    let coefficient = p.damping_coefficient(largest(|value| value.re));
    let share = largest(|value| value.re.abs() / value.im);
    let outside = if eccentricity <= damping {
        Some(Limitation::Eccentricity {
            eccentricity,
            damping,
        })
    } else if coefficient.is_some_and(|own| own.abs() <= second_order * size) {
        Some(Limitation::Sign { second_order })
    } else {
        None
    };
    let damped = is_damped.then_some(Limitation::StructuralDamping);
    let is_stiffened = p.aerodynamic_stiffness;
    let stiffened = is_stiffened.then_some(Limitation::AerodynamicStiffness);
    let strong = (share > STRONG).then_some(Limitation::StrongDamping { damping: share });
    let left_out = damped.into_iter().chain(stiffened);
    left_out.chain(outside).chain(strong).collect()
}
