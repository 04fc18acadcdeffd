//! The eigenvalues of an instance with bounds, by the state matrix and by the companion matrix, and shapes.

use nalgebra::DMatrix;
use num_complex::Complex;

use crate::algebra::interval::Intervals;
use crate::stability::approximation::approximate_eigenvalues;
use crate::stability::ball::Ball;
use crate::stability::companion::companion_matrix;
use crate::stability::eigenvalue::{Eigenvalue, GOOD, Spectrum};
use crate::stability::enclosure::error_bounds;
use crate::stability::francis;

use super::MOST_ROWS;
use super::arithmetic::ball;
use super::disc::{Enclosed, discs};
use super::entries::Block;
use super::error::SystemError;
use super::evaluation::DIGITS;
use super::instance::Instance;
use super::pencil::Pencil;
use super::polynomial::taylor;
use super::state::state_matrix;
use super::vector::{Vector, shape, with_largest_one};

/// An eigenvalue, and how the coordinates move with it.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemMode {
    /// λ, its imaginary part 0 or above.
    pub eigenvalue: Eigenvalue,
    /// q with (λ²M + λC + K) q = 0, its largest entry 1, for the coordinates in order; `None` for an eigenvalue that is
    /// not told from others, of which no shape is certain to be near.
    pub shape: Option<Vec<Complex<f64>>>,
}

impl Instance<'_> {
    /// A = \[0, I; −M⁻¹K, −M⁻¹C\], 2n×2n, for the state (q, q̇); `None` where it is not finite in doubles.
    pub fn state_matrix(&self) -> Option<DMatrix<f64>> {
        let pencil = self.pencil(None);
        let n = pencil.size;
        let mut matrix = dense(n, &state_matrix(&pencil)?);
        for row in 0..2 * n {
            for column in 0..2 * n {
                let scale = |index: usize| {
                    let rate = if index < n { 1.0 } else { pencil.unit };
                    rate * pencil.columns[index % n]
                };
                matrix[(row, column)] *= pencil.unit * scale(row) / scale(column);
            }
        }
        matrix.iter().all(|own| own.is_finite()).then_some(matrix)
    }

    /// The 2n eigenvalues λ with |λ²M + λC + K| = 0, with bounds of their errors: there is a one-to-one assignment of the
    /// exact ones to these, none farther away than its error.
    ///
    /// Coordinates that do not couple are taken apart. The eigenvalues of a block are approximated by a Schur decomposition
    /// with a bound on its iterations, the vectors by inverse iteration, and discs follow from both
    /// (Gershgorin, in numbers with bounds). Where these are no good, as for eigenvalues that coincide and have one vector,
    /// the polynomial about them, enclosed with 256 binary digits or more, bounds the errors (Pellet).
    ///
    /// Complexity: some 30 n³ operations; n 2ⁿ⁻¹ products of polynomials in long numbers where the discs are no good.
    ///
    /// # Errors
    ///
    /// [`SystemError::NoEigenvalues`] if nothing converged or no error could be bounded: no bound is ever infinite.
    pub fn spectrum(&self) -> Result<Spectrum, SystemError> {
        let all = self.enclosed_eigenvalues()?;
        Ok(Spectrum::new(all.into_iter().map(|(own, _)| own).collect()))
    }

    /// The eigenvalues, and whether each is certain to be a simple one.
    fn enclosed_eigenvalues(&self) -> Result<Vec<(Eigenvalue, bool)>, SystemError> {
        let mut all = Vec::with_capacity(2 * self.matrices.size);
        for block in &self.blocks {
            let pencil = self.pencil(Some(block));
            let own = self
                .block_eigenvalues(block, &pencil)
                .ok_or(SystemError::NoEigenvalues)?;
            all.extend(
                own.into_iter()
                    .map(|own| (in_units(&own, pencil.unit), own.is_alone)),
            );
        }
        let is_bounded =
            |(own, _): &(Eigenvalue, bool)| own.value.is_finite() && own.error.is_finite();
        match all.iter().all(is_bounded) {
            true => Ok(all),
            false => Err(SystemError::NoEigenvalues),
        }
    }

    /// Those of a block, by discs where they are good, else by the polynomial.
    pub(super) fn block_eigenvalues(
        &self,
        block: &Block,
        pencil: &Pencil,
    ) -> Option<Vec<Enclosed>> {
        let matrix = state_matrix(pencil)?;
        let matrix = dense(pencil.size, &matrix);
        let mut best: Option<(f64, Vec<Enclosed>)> = None;
        let mut values = None;
        for approximate in approximate_eigenvalues(&matrix) {
            let found = discs(pencil, &approximate).map(|own| own.eigenvalues());
            values.get_or_insert(approximate);
            take_better(&mut best, found);
            if best.as_ref().is_some_and(|(worst, _)| *worst <= GOOD) {
                return best.map(|(_, own)| own);
            }
        }
        let found = self.by_polynomial(block, pencil, &values?);
        take_better(&mut best, found);
        best.map(|(_, own)| own)
    }

    /// Bounds of approximations by the polynomial about them.
    fn by_polynomial(
        &self,
        block: &Block,
        pencil: &Pencil,
        values: &[Complex<f64>],
    ) -> Option<Vec<Enclosed>> {
        let intervals = Intervals::new(DIGITS[0]);
        let polynomial = self.scaled_polynomial(block, pencil, &intervals)?;
        let none = || vec![Ball::ZERO; polynomial.len()];
        let about = |point| taylor(&polynomial, point, &intervals).unwrap_or_else(none);
        let errors = error_bounds(values, about)?.errors;
        let enclosed = |(value, radius): (&Complex<f64>, &f64)| Enclosed {
            value: *value,
            radius: *radius,
            is_alone: false,
        };
        let mut all: Vec<Enclosed> = values.iter().zip(&errors).map(enclosed).collect();
        let apart = |a: &Enclosed, b: &Enclosed| {
            (a.value - b.value).norm() > (a.radius + b.radius) * (1.0 + 1e-12)
        };
        let alone: Vec<bool> = (0..all.len())
            .map(|own| (0..all.len()).all(|other| own == other || apart(&all[own], &all[other])))
            .collect();
        all.iter_mut()
            .zip(alone)
            .for_each(|(own, is_alone)| own.is_alone = is_alone);
        Some(all)
    }

    /// The 2n eigenvalues as roots of the characteristic polynomial in doubles, by its companion matrix: the textbook's
    /// way, with its loss of digits stated in the errors.
    ///
    /// # Errors
    ///
    /// As [`Instance::spectrum`].
    pub fn companion(&self) -> Result<Spectrum, SystemError> {
        let all: Block = (0..self.matrices.size).collect();
        let (pencil, intervals) = (self.pencil(None), Intervals::new(DIGITS[0]));
        let polynomial = self
            .scaled_polynomial(&all, &pencil, &intervals)
            .ok_or(SystemError::NoEigenvalues)?;
        let rounded: Vec<f64> = polynomial
            .iter()
            .map(|own| ball(own, &intervals).centre)
            .collect();
        let leading = rounded.last().copied().unwrap_or(1.0);
        let monic = polynomial::Polynomial::new(rounded.iter().map(|own| own / leading).collect());
        let mut best = None;
        for values in approximate_eigenvalues(&companion_matrix(&monic)) {
            let found = self.by_polynomial(&all, &pencil, &values);
            take_better(&mut best, found);
            if best.as_ref().is_some_and(|(worst, _)| *worst <= GOOD) {
                break;
            }
        }
        let (_, found) = best.ok_or(SystemError::NoEigenvalues)?;
        Ok(Spectrum::new(
            found.iter().map(|own| in_units(own, pencil.unit)).collect(),
        ))
    }

    /// One eigenvalue of each pair and the real ones, each with its shape, in the order of the spectrum.
    ///
    /// # Errors
    ///
    /// As [`Instance::spectrum`].
    pub fn modes(&self) -> Result<Vec<SystemMode>, SystemError> {
        let all = self.enclosed_eigenvalues()?;
        let pencil = self.pencil(None);
        let values: Vec<Eigenvalue> = all.iter().map(|(own, _)| *own).collect();
        let near = |a: &Eigenvalue, b: &Eigenvalue| {
            (a.value - b.value).norm() <= (a.error + b.error) * (1.0 + 1e-12)
        };
        let is_simple =
            |own: &Eigenvalue| values.iter().filter(|other| near(own, other)).count() == 1;
        let mode = |own: &Eigenvalue| SystemMode {
            eigenvalue: *own,
            shape: is_simple(own)
                .then(|| self.shape(&pencil, own.value))
                .flatten(),
        };
        let spectrum = Spectrum::new(values.clone());
        Ok(spectrum.one_of_each_pair().map(mode).collect())
    }

    /// The shape of an eigenvalue that stands alone.
    fn shape(&self, pencil: &Pencil, value: Complex<f64>) -> Option<Vec<Complex<f64>>> {
        let mut vector: Vector = shape(pencil, value / pencil.unit, 0)?;
        vector
            .iter_mut()
            .zip(&pencil.columns)
            .for_each(|(own, unit)| *own *= unit);
        let shape = with_largest_one(pencil.size, &vector)?;
        Some(shape[..pencil.size].to_vec())
    }
}

/// Keeps the eigenvalues with the smaller of the largest bounds.
fn take_better(best: &mut Option<(f64, Vec<Enclosed>)>, found: Option<Vec<Enclosed>>) {
    let Some(found) = found else { return };
    let worst = found.iter().map(|own| own.radius).fold(0.0, f64::max);
    let is_better = best.as_ref().is_none_or(|(least, _)| worst < *least);
    if is_better && worst.is_finite() {
        *best = Some((worst, found));
    }
}

fn in_units(own: &Enclosed, unit: f64) -> Eigenvalue {
    Eigenvalue {
        value: own.value * unit,
        error: own.radius * unit,
    }
}

fn dense(n: usize, matrix: &francis::Matrix<MOST_ROWS>) -> DMatrix<f64> {
    DMatrix::from_fn(2 * n, 2 * n, |row, column| matrix[row][column])
}
