//! Whether a section is stable, with proof.

use std::fmt;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::budget::{Budget, Exhausted};
use crate::algebra::interval::{Interval, Intervals, KnownSign};
use crate::algebra::number::Rational;
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};
use crate::algebra::univariate::Univariate;

use super::eigenvalue::Spectrum;
use super::exact_section::ExactSection;
use super::hurwitz::hurwitz_determinants;
use super::neutral::without_pairs;
use super::section::Section;

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

/// Why there is no verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doubt {
    /// An eigenvalue is imaginary, exactly, and none has a positive real part.
    Neutral,
    /// A determinant is not told from 0 with so many binary digits, and too long to be known exactly.
    Digits(usize),
    /// The coefficients of the characteristic polynomial have too many digits or terms.
    TooLong,
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
            Verdict::Unstable(Proof::Determinants) => formatter
                .write_str("the Hurwitz determinants show a positive real part, in exact arithmetic"),
            Verdict::Undecided(Doubt::Neutral) => formatter.write_str(
                "a motion neither grows nor dies out: its real part is exactly 0, and none is above 0",
            ),
            Verdict::Undecided(Doubt::Digits(bits)) => write!(
                formatter,
                "a Hurwitz determinant is not told from 0 by {bits} binary digits"
            ),
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
    let (part, error) = spectrum.largest_real_part();
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
/// Bounded: at most 2,100,000 products of machine words in exact sums, and 4096 binary digits.
pub fn exact_verdict(section: &ExactSection) -> Verdict {
    let sums = |steps: u64| TrigonometricSums::new(Budget::new(steps));
    let found = polynomial_at_speed(section, &sums(LONGEST_POLYNOMIAL))
        .map_err(|_| Doubt::TooLong)
        .and_then(|polynomial| without_natural_pairs(section, polynomial, &sums(MOST_PRODUCTS)));
    match found {
        Ok(Roots::Left) => Verdict::Stable(Proof::Determinants),
        Ok(Roots::Right) => Verdict::Unstable(Proof::Determinants),
        Ok(Roots::OnAxis) => Verdict::Undecided(Doubt::Neutral),
        Err(doubt) => Verdict::Undecided(doubt),
    }
}

/// The products of machine words for the characteristic polynomial.
const LONGEST_POLYNOMIAL: u64 = 2_000_000;

/// The products of machine words for what its parts have in common; tens of milliseconds.
const MOST_PRODUCTS: u64 = 100_000;

/// The digits of the enclosures, one after the other; common divisors are sought after the first.
const DIGITS: [usize; 4] = [256, 512, 1024, 4096];

/// Where the roots lie, after those that are imaginary since a motion is not damped are taken out.
fn without_natural_pairs(
    section: &ExactSection,
    polynomial: Vec<Sum>,
    sums: &TrigonometricSums,
) -> Result<Roots, Doubt> {
    if let Ok(known) = by_determinants(&polynomial, &DIGITS[..1], false) {
        return Ok(known);
    }
    let constant = |square: Rational| vec![Sum::from(square)];
    let squares: Vec<_> = section
        .natural_squares()
        .into_iter()
        .map(constant)
        .collect();
    let constants = polynomial.iter().map(|own| match own.is_zero() {
        true => Vec::new(),
        false => vec![own.clone()],
    });
    let (rest, count) =
        without_pairs(constants.collect(), &squares, sums).map_err(|_| Doubt::Digits(DIGITS[0]))?;
    let rest: Vec<Sum> = rest
        .into_iter()
        .map(|own| own.into_iter().next().unwrap_or_default())
        .collect();
    match (signs_of_roots(&rest, sums)?, count) {
        (Roots::Left, 1..) => Ok(Roots::OnAxis),
        (roots, _) => Ok(roots),
    }
}

/// The characteristic polynomial at the speed of the section.
fn polynomial_at_speed(
    section: &ExactSection,
    sums: &TrigonometricSums,
) -> Result<Vec<Sum>, Exhausted> {
    let speed = &section.parameters().wind_speed;
    let polynomial = section.characteristic_polynomial(speed, sums)?;
    polynomial
        .iter()
        .map(|powers| {
            powers
                .iter()
                .try_fold(sums.zero(), |sum, own| sums.sum(&sum, own))
        })
        .collect()
}

/// Where the roots of a polynomial lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Roots {
    /// All have negative real parts.
    Left,
    /// None has a positive real part, and some are imaginary.
    OnAxis,
    /// One has a positive real part.
    Right,
}

/// Where the roots of a polynomial lie.
///
/// With p(λ) = E(λ²) + λ O(λ²) and d the greatest common divisor of E and O, p = d(λ²) q(λ), and a root of
/// p on the imaginary axis is one of d(λ²), whose roots come in pairs ±λ. All roots of d are negative
/// exactly where d(λ²) + λ d′(λ²) has no root to the right of the axis (Hermite and Biehler).
fn signs_of_roots(polynomial: &[Sum], sums: &TrigonometricSums) -> Result<Roots, Doubt> {
    if polynomial.len() <= 1 {
        return Ok(Roots::Left);
    }
    if polynomial[0].is_zero() {
        return Ok(match signs_of_roots(&polynomial[1..], sums)? {
            Roots::Right => Roots::Right,
            Roots::Left | Roots::OnAxis => Roots::OnAxis,
        });
    }
    if let Ok(known) = by_determinants(polynomial, &DIGITS[..1], false) {
        return Ok(known);
    }
    match common_divisor(polynomial, sums) {
        Ok(common) if common.len() > 1 => signs_with_pairs(polynomial, &common, sums),
        // No root is imaginary: if a determinant is 0 all the same, not all roots are to the left.
        Ok(_) => {
            let exact = hurwitz_determinants(polynomial, sums).unwrap_or_default();
            let is_zero = exact.iter().any(Sum::is_zero);
            by_determinants(polynomial, &DIGITS[1..], is_zero)
        }
        Err(_) => by_determinants(polynomial, &DIGITS[1..], false),
    }
}

/// Where the roots of d(λ²) q(λ) lie.
fn signs_with_pairs(
    polynomial: &[Sum],
    common: &[Sum],
    sums: &TrigonometricSums,
) -> Result<Roots, Doubt> {
    let too_long = |_: Exhausted| Doubt::Digits(DIGITS[0]);
    let ring = Univariate(sums);
    let pairs = interleaved(common, &[]);
    let (others, _) = ring.pseudo_division(polynomial, &pairs).map_err(too_long)?;
    if signs_of_roots(&others, sums)? == Roots::Right {
        return Ok(Roots::Right);
    }
    let slope = ring.derivative(common).map_err(too_long)?;
    match signs_of_roots(&interleaved(common, &slope), sums)? {
        Roots::Right => Ok(Roots::Right),
        _ => Ok(Roots::OnAxis),
    }
}

/// What the signs of the determinants decide, enclosed with more and more digits, or what is known of one
/// that no root is to the left for certain.
fn by_determinants(
    polynomial: &[Sum],
    digits: &[usize],
    not_all_left: bool,
) -> Result<Roots, Doubt> {
    for &bits in digits {
        let intervals = Intervals::new(bits);
        let mut enclosed: Vec<_> = polynomial
            .iter()
            .map(|own| intervals.enclosure(own))
            .collect();
        match enclosed.last().map(Interval::sign) {
            Some(KnownSign::Positive) => (),
            Some(KnownSign::Negative) => {
                enclosed = enclosed.iter().map(|own| intervals.negative(own)).collect();
            }
            _ => continue,
        }
        let Ok(determinants) = hurwitz_determinants(&enclosed, &intervals);
        let signs: Vec<_> = determinants.iter().map(Interval::sign).collect();
        if signs.iter().all(|sign| *sign == KnownSign::Positive) {
            return Ok(Roots::Left);
        }
        if signs.contains(&KnownSign::Negative) || not_all_left {
            return Ok(Roots::Right);
        }
    }
    Err(Doubt::Digits(digits.last().copied().unwrap_or_default()))
}

/// A greatest common divisor of the even and the odd part, in powers of λ², by Euclid.
fn common_divisor(polynomial: &[Sum], sums: &TrigonometricSums) -> Result<Vec<Sum>, Exhausted> {
    let ring = Univariate(sums);
    let part = |first: usize| {
        let powers = polynomial.iter().skip(first).step_by(2);
        ring.polynomial(powers.cloned().collect())
    };
    let (even, odd) = (part(0), part(1));
    let (mut large, mut small) = match even.len() < odd.len() {
        true => (odd, even),
        false => (even, odd),
    };
    while !small.is_empty() {
        let (_, rest) = ring.pseudo_division(&large, &small)?;
        (large, small) = (small, rest);
    }
    Ok(large)
}

/// E(λ²) + λ O(λ²)
fn interleaved(even: &[Sum], odd: &[Sum]) -> Vec<Sum> {
    let mut polynomial =
        vec![Sum::default(); (2 * even.len()).saturating_sub(1).max(2 * odd.len())];
    for (power, own) in even.iter().enumerate() {
        polynomial[2 * power] = own.clone();
    }
    for (power, own) in odd.iter().enumerate() {
        polynomial[2 * power + 1] = own.clone();
    }
    polynomial
}
