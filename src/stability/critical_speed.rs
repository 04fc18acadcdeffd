//! The wind speeds at which a section begins and ceases to gallop, all of them.

use rayon::prelude::*;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::budget::{Budget, Exhausted};
use crate::algebra::interval::Intervals;
use crate::algebra::number::Rational;
use crate::algebra::trigonometric_sum::TrigonometricSums;
use crate::algebra::univariate::Univariate;

use super::case::Case;
use super::coefficient_table::CoefficientTable;
use super::comparison::section_at;
use super::exact_section::{ExactSection, InSpeed};
use super::input::InputError;
use super::interpolation::CoefficientCurves;
use super::speed_search::{Found, LOWEST, Part, parts};

/// What is certain of a section at all wind speeds of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// All eigenvalues have negative real parts.
    Stable,
    /// An eigenvalue has a positive real part: the section gallops.
    Unstable,
    /// A real eigenvalue is above 0: static divergence, whether the section gallops beside it or not.
    Divergent,
    /// None of these is shown.
    Undecided,
}

impl Stability {
    /// `stable`, `unstable`, `divergent` or `undecided`.
    pub fn name(self) -> &'static str {
        match self {
            Stability::Stable => "stable",
            Stability::Unstable => "unstable",
            Stability::Divergent => "divergent",
            Stability::Undecided => "undecided",
        }
    }
}

/// Wind speeds in m/s, all of one stability.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedRange {
    /// The lowest speed.
    pub from: f64,
    /// The highest speed.
    pub to: f64,
    /// What is certain at every speed between.
    pub stability: Stability,
}

impl SpeedRange {
    /// Whether it begins with the lowest speeds of any range, `highest` being the highest speed of all.
    pub fn is_lowest(&self, highest: f64) -> bool {
        self.from <= (highest * 0.5_f64.powi(i32::from(LOWEST))).next_up()
    }
}

/// A wind speed at which stability changes: a simple root of Hurwitz' last determinant but one, or of the
/// determinant of the stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalSpeed {
    /// The speed, in m/s.
    pub speed: f64,
    /// What is exact is no farther away.
    pub error: f64,
    /// What the section is above it.
    pub becomes: Stability,
}

/// The wind speeds above 0 up to a highest one.
#[derive(Clone, Debug, PartialEq)]
pub struct Speeds {
    /// Ranges in order. Speeds below 2⁻¹⁰⁰ of the highest may be in none of them.
    pub ranges: Vec<SpeedRange>,
    /// The speeds at which stability changes for certain, in order, each between two ranges.
    pub critical: Vec<CriticalSpeed>,
    /// Whether a motion neither grows nor dies out at any speed, exactly: then nothing is stable.
    pub is_neutral: bool,
}

impl Speeds {
    /// Ranges and critical speeds by what is known of each part of the speeds up to a highest one.
    fn new(parts: &[Part], highest: f64, is_neutral: bool) -> Self {
        let found = |own: &Part| match own.found {
            Found::Certain(Stability::Stable) if is_neutral => Found::Certain(Stability::Undecided),
            found => found,
        };
        let neighbour = |place: Option<usize>| match parts.get(place?).map(found) {
            Some(Found::Certain(stability)) => Some(stability),
            _ => None,
        };
        // A part is a multiple of a power of 2 of 41 digits, so that only the product is rounded.
        let speed = |part: &Rational| part.to_f64().value() * highest;
        let mut speeds = Speeds {
            ranges: Vec::new(),
            critical: Vec::new(),
            is_neutral,
        };
        let mut is_continued = false;
        for (place, own) in parts.iter().enumerate() {
            let [low, high] = [speed(&own.from), speed(&own.to)];
            let stability = match found(own) {
                Found::Certain(stability) => stability,
                Found::Change([below, above]) => {
                    let neighbours = [place.checked_sub(1), place.checked_add(1)].map(neighbour);
                    if neighbours == [Some(below), Some(above)] {
                        speeds.critical.push(CriticalSpeed {
                            speed: (low + high) / 2.0,
                            error: (high.next_up() - low) / 2.0 + high * f64::EPSILON,
                            becomes: above,
                        });
                        is_continued = false;
                        continue;
                    }
                    Stability::Undecided
                }
            };
            if stability == Stability::Undecided && own.is_negligible() {
                is_continued = false;
                continue;
            }
            let to = match own.to == Rational::ONE {
                true => highest,
                false => high.next_down(),
            };
            match speeds.ranges.last_mut() {
                Some(last) if is_continued && last.stability == stability => last.to = to,
                _ => speeds.ranges.push(SpeedRange {
                    from: match own.from.is_zero() {
                        true => 0.0,
                        false => low.next_up(),
                    },
                    to,
                    stability,
                }),
            }
            is_continued = true;
        }
        speeds
    }
}

/// The digits of the enclosures; more where fewer leave something open.
const DIGITS: [usize; 2] = [256, 1024];

/// Products of machine words in the exact coefficients.
const MOST_PRODUCTS: u64 = 1_000_000;

/// The wind speeds at which a section is stable and unstable, above 0 and up to `highest` in m/s.
///
/// The characteristic polynomial is a polynomial in U with exact coefficients, and so are Hurwitz'
/// determinants. On a range of speeds they are above 0, or one is below, if their Bernstein coefficients
/// are; a range on which neither is so is halved, down to 2⁻⁴⁰ of the speeds in it. What is left is a
/// critical speed where the last determinant but one, which alone vanishes where a pair of roots becomes
/// imaginary (Orlando), is monotonous and the earlier ones are above 0. Else the roots are compared with lines
/// beside the imaginary axis, by the determinants of the shifted polynomial; what that leaves is undecided.
///
/// Likewise with the constant coefficient, the determinant of the stiffness, which aerodynamic stiffness may
/// make negative: then an odd number of real roots is above 0, and where it vanishes one of them passes 0.
///
/// Without a highest speed above 0 there are no ranges. Bounded: at most 20,000 ranges are halved, with 256
/// binary digits and, where these leave something open, with 1024.
pub fn speeds(section: &ExactSection, highest: f64) -> Speeds {
    let unit = Rational::try_from(highest).unwrap_or_default();
    if unit <= Rational::ZERO {
        return Speeds::new(&[], highest, false);
    }
    let mut found = Speeds::new(&[Part::undecided()], highest, false);
    let sums = TrigonometricSums::new(Budget::new(MOST_PRODUCTS));
    let Ok(polynomial) = section.characteristic_polynomial(&unit, &sums) else {
        return found;
    };
    let stiffness = polynomial.first().cloned().unwrap_or_default();
    let Ok((polynomial, is_neutral)) = without_neutral_pairs(section, polynomial, &sums) else {
        return found;
    };
    for bits in DIGITS {
        let parts = parts(&polynomial, &stiffness, &Intervals::new(bits));
        found = Speeds::new(&parts, highest, is_neutral);
        let is_open = |own: &SpeedRange| own.stability == Stability::Undecided;
        if is_neutral || !found.ranges.iter().any(is_open) {
            break;
        }
    }
    found
}

/// The characteristic polynomial in powers of λ and of the speed, divided by λ² + ω² as often as a
/// natural frequency ω allows, and whether a motion is neutral at all speeds: one of these, or all of them
/// where there is no damping at all and the frequencies do not depend on the speed.
fn without_neutral_pairs(
    section: &ExactSection,
    mut polynomial: Vec<InSpeed>,
    sums: &TrigonometricSums,
) -> Result<(Vec<InSpeed>, bool), Exhausted> {
    let in_speed = Univariate(sums);
    let in_lambda = Univariate(&in_speed);
    let is_undamped = polynomial.iter().skip(1).step_by(2).all(Vec::is_empty);
    let mut is_neutral = is_undamped && polynomial.iter().all(|powers| powers.len() <= 1);
    for pair in section.natural_pairs() {
        let powers = [&pair[0], &sums.zero(), &pair[1]];
        let pair: Vec<InSpeed> = powers
            .map(|own| in_speed.polynomial(vec![own.clone()]))
            .to_vec();
        let (quotient, rest) = in_lambda.pseudo_division(&polynomial, &pair)?;
        if rest.is_empty() {
            (polynomial, is_neutral) = (quotient, true);
        }
    }
    Ok((polynomial, is_neutral))
}

/// The speeds of a case at all its angles, in degrees.
///
/// # Errors
///
/// If an angle is outside of the table, or no section is possible there.
pub fn speeds_of(
    case: &Case,
    table: &CoefficientTable,
    highest: f64,
) -> Result<Vec<(f64, Speeds)>, InputError> {
    let curves = CoefficientCurves::new(table, case.interpolation);
    let at = |angle: f64| {
        let section = section_at(case, table, &curves, angle)?;
        Ok((angle, speeds(&ExactSection::from(&section), highest)))
    };
    case.angles.values().into_par_iter().map(at).collect()
}
