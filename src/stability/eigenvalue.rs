//! Eigenvalues with a bound of their error.

use num_complex::Complex;

use super::enclosure::Bounds;
use super::error::StabilityError;
use super::section::{Parameters, Section};

/// An eigenvalue λ of a section, in 1/s, and a bound of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eigenvalue {
    /// λ = λ_R + i ω: the motion grows like exp(λ_R t) and has the circular frequency ω.
    pub value: Complex<f64>,
    /// The exact eigenvalue is no farther away than this, in 1/s.
    pub error: f64,
}

/// The 2n eigenvalues of a section, or of a derived system, with n free coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// All of them, complex ones beside their conjugates: first those with a positive imaginary part,
    /// the highest frequency first, then their conjugates, then real ones, the largest first.
    pub eigenvalues: Vec<Eigenvalue>,
}

impl Spectrum {
    /// Eigenvalues in their order.
    pub(super) fn new(mut eigenvalues: Vec<Eigenvalue>) -> Self {
        let rank = |own: &Eigenvalue| match own.value.im {
            im if im > 0.0 => 0,
            im if im < 0.0 => 1,
            _ => 2,
        };
        eigenvalues.sort_by(|a, b| {
            let frequency = b.value.im.abs().total_cmp(&a.value.im.abs());
            let real_part = b.value.re.total_cmp(&a.value.re);
            rank(a).cmp(&rank(b)).then(frequency).then(real_part)
        });
        Spectrum { eigenvalues }
    }

    /// That of which one eigenvalue of each pair is given.
    pub(super) fn of_pairs(found: impl IntoIterator<Item = Eigenvalue>) -> Self {
        let pair = |own: Eigenvalue| {
            let conjugate = own.value.conj();
            [own.value, conjugate].map(|value| Eigenvalue { value, ..own })
        };
        Spectrum::new(found.into_iter().flat_map(pair).collect())
    }

    /// The largest real part and a bound of its error, in 1/s.
    pub fn largest_real_part(&self) -> (f64, f64) {
        largest_real_part(&self.eigenvalues)
    }

    /// S_3D = −4 m max λ_R/(ρ D U) of a section (S_2D with two free coordinates) and a bound of its
    /// error, Eq. (13); `None` without wind.
    pub fn damping_coefficient(&self, section: &Section) -> Option<(f64, f64)> {
        damping_coefficient(section.parameters(), self.largest_real_part())
    }

    /// Those whose imaginary part is computed as 0 or above: one of each pair, and the real ones.
    pub fn one_of_each_pair(&self) -> impl Iterator<Item = &Eigenvalue> {
        self.eigenvalues.iter().filter(|own| own.value.im >= 0.0)
    }
}

/// The largest real part of some eigenvalues, one of each pair at least, and a bound of its error, in 1/s.
pub(super) fn largest_real_part(eigenvalues: &[Eigenvalue]) -> (f64, f64) {
    let largest = |number: fn(&Eigenvalue) -> f64| {
        let numbers = eigenvalues.iter().map(number);
        numbers.fold(f64::NEG_INFINITY, f64::max)
    };
    let part = largest(|own| own.value.re);
    // What may exceed the largest computed one is an eigenvalue with a larger bound.
    let above = largest(|own| own.value.re + own.error);
    let below = largest(|own| own.value.re - own.error);
    // What is lost by rounding here is less.
    let error = (above - part).max(part - below);
    let rounding = 4.0 * f64::EPSILON * part.abs();
    (part, (error + rounding) * (1.0 + 8.0 * f64::EPSILON))
}

/// S of a real part with a bound of its error, Eq. (13), and a bound of the error of S; `None` without wind.
pub(super) fn damping_coefficient(p: &Parameters, (part, error): (f64, f64)) -> Option<(f64, f64)> {
    let coefficient = p.damping_coefficient(part)?;
    let error = p.damping_coefficient(error)?.abs();
    let rounding = 8.0 * f64::EPSILON * coefficient.abs();
    Some((coefficient, (error + rounding) * (1.0 + 8.0 * f64::EPSILON)))
}

/// The best of several approximations: values in units of `unit`, errors as `bounds` finds them.
///
/// The first whose errors are all below [`GOOD`] is taken, or that are roots as far as is known; otherwise that with
/// the smallest error.
pub(super) fn best_spectrum(
    approximations: impl Iterator<Item = Vec<Complex<f64>>>,
    bounds: impl Fn(&[Complex<f64>]) -> Option<Bounds>,
    unit: f64,
) -> Result<Spectrum, StabilityError> {
    let mut best: Option<(f64, Vec<Eigenvalue>)> = None;
    for values in approximations {
        let Some(Bounds { errors, are_roots }) = bounds(&values) else {
            continue;
        };
        let worst = errors.iter().copied().fold(0.0, f64::max);
        if !best.as_ref().is_some_and(|(least, _)| *least <= worst) {
            let pairs = values.iter().zip(&errors);
            let scaled = |(value, error): (&Complex<f64>, &f64)| Eigenvalue {
                value: value * unit,
                error: error * unit,
            };
            best = Some((worst, pairs.map(scaled).collect()));
        }
        if worst <= GOOD || are_roots {
            break;
        }
    }
    let (_, eigenvalues) = best
        .filter(|(worst, _)| worst.is_finite())
        .ok_or(StabilityError::NoEigenvalues)?;
    Ok(Spectrum::new(eigenvalues))
}

/// An error, relative to the unit of frequency, that needs no second attempt: it leaves ten digits, and the
/// rounding of the coefficients alone costs the companion matrix as much.
pub(super) const GOOD: f64 = 1e-11;
