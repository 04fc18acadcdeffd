//! In which half of the plane the roots of a real polynomial lie, exactly.

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::budget::Exhausted;
use crate::algebra::interval::{Interval, Intervals, KnownSign};
use crate::algebra::number::Rational;
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};
use crate::algebra::univariate::Univariate;

use super::doubt::Doubt;
use super::hurwitz::{hurwitz_determinants, routh_signs};
use super::neutral::without_pairs;

/// The products of machine words for what the parts of a polynomial have in common; tens of milliseconds.
pub(super) const MOST_PRODUCTS: u64 = 100_000;

/// The digits of the enclosures, one after the other; common divisors are sought after the first.
const DIGITS: [usize; 4] = [256, 512, 1024, 4096];

/// The highest degree whose determinants are computed one by one: their cost doubles with each degree.
const LARGEST_DETERMINANT: usize = 10;

/// Where the roots of a polynomial lie, given by its coefficients, that of λ⁰ first, after those that are imaginary
/// since a motion is not damped are taken out: λ² + ν for likely ν.
pub(super) fn roots_without_pairs(
    polynomial: Vec<Sum>,
    squares: impl Iterator<Item = Sum>,
    sums: &TrigonometricSums,
) -> Result<Roots, Doubt> {
    let enclosed = |intervals: &Intervals| enclosures(&polynomial, intervals);
    if let Ok(known) = roots_by_determinants(enclosed, &DIGITS[..1], false) {
        return Ok(known);
    }
    let squares: Vec<_> = squares.map(|square| vec![square]).collect();
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

/// Where the roots of a polynomial lie whose coefficients are enclosed, but not known exactly.
pub(super) fn roots_of_enclosed(
    enclosed: impl Fn(&Intervals) -> Option<Vec<Interval>>,
) -> Result<Roots, Doubt> {
    roots_by_determinants(enclosed, &DIGITS, false)
}

fn enclosures(polynomial: &[Sum], intervals: &Intervals) -> Option<Vec<Interval>> {
    Some(
        polynomial
            .iter()
            .map(|own| intervals.enclosure(own))
            .collect(),
    )
}

/// Where the roots of a polynomial lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Roots {
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
    let enclosed = |intervals: &Intervals| enclosures(polynomial, intervals);
    if let Ok(known) = roots_by_determinants(enclosed, &DIGITS[..1], false) {
        return Ok(known);
    }
    match common_divisor(polynomial, sums) {
        Ok(common) if common.len() > 1 => signs_with_pairs(polynomial, &common, sums),
        // No root is imaginary: if a determinant is 0 all the same, not all roots are to the left.
        Ok(_) => roots_by_determinants(enclosed, &DIGITS[1..], is_one_zero(polynomial, sums)),
        Err(_) => roots_by_determinants(enclosed, &DIGITS[1..], false),
    }
}

/// Whether a determinant is 0, exactly; not looked at where there are too many of them.
fn is_one_zero(polynomial: &[Sum], sums: &TrigonometricSums) -> bool {
    if polynomial.len() > LARGEST_DETERMINANT + 1 {
        return false;
    }
    let exact = hurwitz_determinants(polynomial, polynomial.len(), sums).unwrap_or_default();
    exact.iter().any(Sum::is_zero)
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
fn roots_by_determinants(
    enclosed: impl Fn(&Intervals) -> Option<Vec<Interval>>,
    digits: &[usize],
    not_all_left: bool,
) -> Result<Roots, Doubt> {
    for &bits in digits {
        let intervals = Intervals::new(bits);
        let known = enclosed(&intervals).and_then(|own| with_positive_leading(own, &intervals));
        match known.and_then(|own| roots_by_signs(&own, &intervals, not_all_left)) {
            Some(known) => return Ok(known),
            None => continue,
        }
    }
    Err(Doubt::Digits(digits.last().copied().unwrap_or_default()))
}

/// A polynomial or its negative; `None` where the sign of the leading coefficient is not known.
fn with_positive_leading(
    polynomial: Vec<Interval>,
    intervals: &Intervals,
) -> Option<Vec<Interval>> {
    match polynomial.last()?.sign() {
        KnownSign::Positive => Some(polynomial),
        KnownSign::Negative => Some(
            polynomial
                .iter()
                .map(|own| intervals.negative(own))
                .collect(),
        ),
        _ => None,
    }
}

/// What the signs decide: first by Routh's scheme, which is quick, then by the determinants after one that is not
/// told from 0.
fn roots_by_signs(
    polynomial: &[Interval],
    intervals: &Intervals,
    not_all_left: bool,
) -> Option<Roots> {
    let degree = polynomial.len().saturating_sub(1);
    let mut signs = routh_signs(polynomial, intervals);
    let is_cut = signs.len() < degree || signs.contains(&KnownSign::Unknown);
    if is_cut && degree <= LARGEST_DETERMINANT {
        let Ok(determinants) = hurwitz_determinants(polynomial, degree, intervals);
        signs = determinants.iter().map(Interval::sign).collect();
    }
    let are_all = signs.len() == degree && signs.iter().all(|own| *own == KnownSign::Positive);
    match are_all {
        true => Some(Roots::Left),
        false => (signs.contains(&KnownSign::Negative) || not_all_left).then_some(Roots::Right),
    }
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
        (large, small) = (small, shortened(rest));
    }
    Ok(large)
}

/// A multiple of a polynomial whose leading coefficient is 1 where that is rational: else the digits of the rests
/// double with each step.
fn shortened(polynomial: Vec<Sum>) -> Vec<Sum> {
    let inverse = polynomial
        .last()
        .and_then(rational)
        .map(|own| Rational::ONE / own);
    match inverse {
        Some(inverse) => polynomial.iter().map(|own| own.scaled(&inverse)).collect(),
        None => polynomial,
    }
}

/// A sum without sines as the number that it is, unless it is 0.
fn rational(sum: &Sum) -> Option<&Rational> {
    let mut terms = sum.terms();
    match (terms.next(), terms.next()) {
        (Some((angle, [own, _])), None) if angle.is_zero() => Some(own),
        _ => None,
    }
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
