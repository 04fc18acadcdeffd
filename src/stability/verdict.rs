//! Whether a section is stable, with proof.

use std::fmt;

use crate::algebra::budget::Budget;
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};

pub use super::doubt::Doubt;
use super::eigenvalue::Spectrum;
use super::exact_section::{ExactSection, at_speed};
use super::half_plane::{MOST_PRODUCTS, Roots, roots_without_pairs};
use super::in_speed::InSpeed;
use super::section::Section;
use super::system::arithmetic::NoValue;

/// What is known of the stability of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Every motion dies out: all eigenvalues have negative real parts.
    Stable(Proof),
    /// A motion grows: an eigenvalue has a positive real part.
    Unstable(Proof),
    /// Neither is shown.
    Undecided(Doubt),
}

/// How a verdict is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Proof {
    /// No eigenvalue that matters is within its error of the imaginary axis.
    Errors,
    /// By the signs of Hurwitz' determinants, in exact arithmetic.
    Determinants,
}

impl Verdict {
    /// Whether an S within its error is certainly wrong: above 0 though unstable, or below 0 though stable or
    /// neutral.
    pub fn refutes(self, damping_coefficient: f64, error: f64) -> bool {
        match self {
            Verdict::Unstable(_) => damping_coefficient > error,
            Verdict::Stable(_) | Verdict::Undecided(Doubt::Neutral) => damping_coefficient < -error,
            Verdict::Undecided(_) => false,
        }
    }

    /// `stable`, `unstable` or `undecided`.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Stable(_) => "stable",
            Verdict::Unstable(_) => "unstable",
            Verdict::Undecided(_) => "undecided",
        }
    }
}

impl fmt::Display for Verdict {
    /// The reason in words.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Verdict::Stable(Proof::Errors) => {
                formatter.write_str("every real part is below 0 by more than its error")
            }
            Verdict::Unstable(Proof::Errors) => {
                formatter.write_str("a real part is above 0 by more than its error")
            }
            Verdict::Stable(Proof::Determinants) => {
                formatter.write_str("all Hurwitz determinants are above 0, in exact arithmetic")
            }
            Verdict::Unstable(Proof::Determinants) => formatter.write_str(
                "the Hurwitz determinants show a positive real part, in exact arithmetic",
            ),
            Verdict::Undecided(Doubt::Neutral) => {
                formatter.write_str("a real part is exactly 0, and none is above 0")
            }
            Verdict::Undecided(Doubt::Digits(bits)) => write!(
                formatter,
                "a Hurwitz determinant is not told from 0 by {bits} binary digits"
            ),
            Verdict::Undecided(Doubt::Open) => formatter
                .write_str("it depends on less than the bound to which the mean twist is certain"),
            Verdict::Undecided(Doubt::TooLong) => formatter
                .write_str("the numbers are too long for exact arithmetic: give them fewer digits"),
        }
    }
}

/// The verdict on a section whose eigenvalues are known with bounds of their errors, for its doubles as
/// exact numbers.
///
/// Where the errors leave it open, that of [`exact_verdict`].
pub fn verdict(section: &Section, spectrum: &Spectrum) -> Verdict {
    verdict_by_errors(spectrum).unwrap_or_else(|| exact_verdict(&ExactSection::from(section)))
}

/// The verdict that the errors of eigenvalues allow; `None` where they leave it open.
pub fn verdict_by_errors(spectrum: &Spectrum) -> Option<Verdict> {
    by_errors(spectrum.largest_real_part())
}

/// The verdict that the largest real part allows, with a bound of its error.
pub(super) fn by_errors((part, error): (f64, f64)) -> Option<Verdict> {
    if part > error {
        Some(Verdict::Unstable(Proof::Errors))
    } else if part < -error {
        Some(Verdict::Stable(Proof::Errors))
    } else {
        None
    }
}

/// The verdict on a section in exact numbers.
///
/// The characteristic polynomial is a sum of sines and cosines, exactly, and its determinants are
/// enclosed with more and more digits. All positive: stable (Hurwitz). One negative: unstable, since
/// roots with no positive real part are limits of roots with negative ones, whose determinants are
/// positive. Where one is exactly 0, what even and odd part have in common is looked at by itself: its
/// roots λ² are those of the pairs ±λ; a root that is 0 is split off before.
///
/// Where attitude and coefficients are open, it is not decided: exact arithmetic is for one section.
///
/// Bounded: at most 2,100,000 products of machine words in exact sums, and 4096 binary digits.
pub fn exact_verdict(section: &ExactSection) -> Verdict {
    if section.is_open() {
        return Verdict::Undecided(Doubt::Open);
    }
    let sums = |steps: u64| TrigonometricSums::new(Budget::new(steps));
    let found = polynomial_and_squares(section, &sums(LONGEST_POLYNOMIAL));
    let found = found.map_err(|_| Doubt::TooLong);
    Verdict::from(found.and_then(|[polynomial, squares]| {
        roots_without_pairs(polynomial, squares.into_iter(), &sums(MOST_PRODUCTS))
    }))
}

impl From<Result<Roots, Doubt>> for Verdict {
    /// By where the roots of the characteristic polynomial lie.
    fn from(found: Result<Roots, Doubt>) -> Self {
        match found {
            Ok(Roots::Left) => Verdict::Stable(Proof::Determinants),
            Ok(Roots::Right) => Verdict::Unstable(Proof::Determinants),
            Ok(Roots::OnAxis) => Verdict::Undecided(Doubt::Neutral),
            Err(doubt) => Verdict::Undecided(doubt),
        }
    }
}

/// The products of machine words for the characteristic polynomial.
pub(super) const LONGEST_POLYNOMIAL: u64 = 2_000_000;

/// The characteristic polynomial at the speed of the section, and the squares of frequencies that are likely to
/// divide it.
fn polynomial_and_squares(
    section: &ExactSection,
    sums: &TrigonometricSums,
) -> Result<[Vec<Sum>; 2], NoValue> {
    let speed = &section.parameters().wind_speed;
    let value = |own: &InSpeed| at_speed(own, sums);
    let polynomial = section.characteristic_polynomial(speed, sums)?;
    let squares = section.likely_squares(speed, sums)?;
    Ok([
        polynomial.iter().map(value).collect::<Result<_, _>>()?,
        squares.iter().map(value).collect::<Result<_, _>>()?,
    ])
}
