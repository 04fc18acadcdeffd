//! A system with a number for each parameter: its matrices.

use std::collections::BTreeMap;

use nalgebra::DMatrix;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::determinant::determinant;
use crate::algebra::interval::{Interval, Intervals, KnownSign};
use crate::algebra::matrix::Matrix;
use crate::algebra::number::Rational;
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};

use super::System;
use super::block::blocks;
use super::entries::{Block, Entries, Matrices, check};
use super::error::SystemError;
use super::evaluation::{DIGITS, close_entries, exact_entries, intervals_of, totals};
use super::parameter::{Parameters, names};
use super::pencil::Pencil;
use super::polynomial::characteristic_polynomial;
use super::real::Real;

/// A system with numbers for its parameters, for which its matrices are known.
///
/// ```
/// use std::collections::BTreeMap;
/// use sextic::algebra::number::Rational;
/// use sextic::stability::system::System;
/// use sextic_codegen::evaluator::Evaluator;
/// use sextic_codegen::program::{Operation, Program};
///
/// // q̈ + c q̇ + k q = 0
/// let mut program = Program::new(["c".to_string(), "k".to_string()]);
/// let [c, k] = ["c", "k"].map(|name| program.input(name).unwrap());
/// let one = program.constant(Rational::ONE);
/// for (name, node) in [("M", one), ("C", c), ("K", k)] {
///     program.output(name, node);
/// }
/// let system = System {
///     evaluator: Evaluator::plain("oscillator", program),
///     coordinates: vec!["q".to_string()],
///     damping: vec![String::new()],
///     stiffness: vec![String::new()],
/// };
/// assert_eq!(system.names(), ["c", "k"]);
/// let values = [("c", 2), ("k", 26)].map(|(name, own)| (name.to_string(), Rational::from(own)));
/// let instance = system.at(&BTreeMap::from(values))?;
/// let spectrum = instance.spectrum()?;
/// // λ = −1 ± 5i
/// assert!((spectrum.eigenvalues[0].value.im - 5.0).abs() <= spectrum.eigenvalues[0].error);
/// assert_eq!(instance.verdict().name(), "stable");
/// # Ok::<(), sextic::stability::system::error::SystemError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Instance<'a> {
    system: &'a System,
    parameters: Parameters<'a>,
    /// The entries in exact numbers, if they have some.
    pub(super) exact: Option<Matrices<Sum>>,
    /// The entries in doubles with bounds.
    entries: Entries<Real>,
    /// K, C and M in doubles with bounds.
    pub(super) matrices: Matrices<Real>,
    pub(super) blocks: Vec<Block>,
}

/// The matrices of a system in doubles, each n×n, in the units of its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemMatrices {
    /// M
    pub mass: DMatrix<f64>,
    /// C, the sum of its parts.
    pub damping: DMatrix<f64>,
    /// K, the sum of its parts.
    pub stiffness: DMatrix<f64>,
    /// The parts of C, with their names.
    pub damping_parts: Vec<(String, DMatrix<f64>)>,
    /// The parts of K, with their names.
    pub stiffness_parts: Vec<(String, DMatrix<f64>)>,
}

impl System {
    /// The names of what must be given, in order: inputs of the program, and angles rather than their sines.
    pub fn names(&self) -> Vec<String> {
        names(&self.evaluator)
    }

    /// The system with a number for each parameter, as it is written: nothing is rounded before the matrices are known.
    ///
    /// The program runs in exact sums of sines and cosines and, where a quotient or a root has no such value, in
    /// enclosures with 256 to 4096 binary digits. The doubles of the matrices are the nearest to what they enclose, within
    /// a bound that all that follows counts.
    ///
    /// Complexity: one or some runs of the program, with at most 2,000,000 products of machine words in exact sums, and a
    /// determinant of M.
    ///
    /// # Errors
    ///
    /// Parameters that are missing (all of them), unknown or beyond the doubles; matrices that have no value there, or
    /// none that is told; entries beyond the doubles; a mass matrix whose determinant is 0 or not told from it.
    pub fn at(&self, values: &BTreeMap<String, Rational>) -> Result<Instance<'_>, SystemError> {
        check(self)?;
        let parameters = Parameters::new(&self.evaluator, values)?;
        let exact = exact_entries(self, &parameters)?;
        let (entries, matrices) = close_entries(self, &parameters, exact.as_ref())?;
        let instance = Instance {
            system: self,
            parameters,
            exact: exact.and_then(|own| totals(&own)),
            entries,
            blocks: blocks(&matrices),
            matrices,
        };
        instance.checked()
    }
}

impl Instance<'_> {
    /// Checks that the entries are doubles and M has an inverse.
    fn checked(self) -> Result<Self, SystemError> {
        let places = (0..3).flat_map(|power| {
            self.matrices.powers[power]
                .iter()
                .enumerate()
                .map(move |(place, own)| (power, place, own))
        });
        if let Some((power, place, _)) = places.into_iter().find(|(.., own)| !own.is_finite()) {
            return Err(SystemError::Entry {
                matrix: ['K', 'C', 'M'][power],
                row: place / self.matrices.size + 1,
                column: place % self.matrices.size + 1,
            });
        }
        let has_mass = |block: &Block| {
            DIGITS
                .into_iter()
                .any(|bits| self.has_mass(block, &Intervals::new(bits)))
        };
        match self.blocks.iter().all(has_mass) {
            true => Ok(self),
            false => Err(SystemError::SingularMass),
        }
    }

    /// The system.
    pub fn system(&self) -> &System {
        self.system
    }

    /// M, C, K and their parts in doubles, the nearest to their exact values up to a unit in the last place.
    pub fn matrices(&self) -> SystemMatrices {
        let size = self.matrices.size;
        let dense = |own: &[Real]| DMatrix::from_fn(size, size, |i, j| own[i * size + j].centre);
        let parts = |names: &[String], parts: &[Vec<Real>]| {
            let pairs = names.iter().zip(parts);
            pairs
                .map(|(name, own)| (name.clone(), dense(own)))
                .collect()
        };
        SystemMatrices {
            mass: dense(&self.matrices.powers[2]),
            damping: dense(&self.matrices.powers[1]),
            stiffness: dense(&self.matrices.powers[0]),
            damping_parts: parts(&self.system.damping, &self.entries.damping),
            stiffness_parts: parts(&self.system.stiffness, &self.entries.stiffness),
        }
    }

    /// The pencil of a block, or of all coordinates.
    pub(super) fn pencil(&self, block: Option<&Block>) -> Pencil {
        let matrices = match block {
            Some(block) => self.matrices.block(block),
            None => self.matrices.clone(),
        };
        Pencil::new(matrices.size, |power, row, column| {
            *matrices.at(power, row, column)
        })
    }

    /// K, C and M with so many digits.
    fn enclosed_matrices(&self, intervals: &Intervals) -> Option<Matrices<Interval>> {
        if let Some(exact) = &self.exact {
            return Some(exact.map(|_, own| intervals.enclosure(own)));
        }
        let entries = intervals_of(self.system, &self.parameters, None, intervals).ok()?;
        let Ok(matrices) = entries.sums(&intervals.zero(), |a, b| intervals.sum(a, b));
        Some(matrices)
    }

    /// Whether the determinant of the mass matrix of a block is told from 0 with so many digits.
    fn has_mass(&self, block: &Block, intervals: &Intervals) -> bool {
        let scaled = self.scaled_matrices(block, &self.pencil(Some(block)), intervals);
        let determinant = scaled.map(|own| {
            let entry = |row: usize, column: usize| own.at(2, row, column).clone();
            let Ok(found) = determinant(&Matrix::from_fn(own.size, own.size, entry), intervals);
            found.sign()
        });
        matches!(determinant, Some(KnownSign::Positive | KnownSign::Negative))
    }

    /// K, C and M of a block in units of its pencil.
    fn scaled_matrices(
        &self,
        block: &Block,
        pencil: &Pencil,
        intervals: &Intervals,
    ) -> Option<Matrices<Interval>> {
        let matrices = self.enclosed_matrices(intervals)?.block(block);
        Some(matrices.map(|[power, row, column], own| {
            let factor = intervals.rational(&factor(pencil, power, row, column));
            let Ok(scaled) = intervals.product(own, &factor);
            scaled
        }))
    }

    /// The polynomial of a block in units of its pencil.
    pub(super) fn scaled_polynomial(
        &self,
        block: &Block,
        pencil: &Pencil,
        intervals: &Intervals,
    ) -> Option<Vec<Interval>> {
        let scaled = self.scaled_matrices(block, pencil, intervals)?;
        let Ok(polynomial) = characteristic_polynomial(&scaled, intervals);
        Some(polynomial)
    }

    /// The same in exact numbers.
    pub(super) fn exact_polynomial(
        &self,
        block: &Block,
        pencil: &Pencil,
        sums: &TrigonometricSums,
    ) -> Option<Vec<Sum>> {
        let matrices = self.exact.as_ref()?.block(block);
        let scaled = matrices
            .map(|[power, row, column], own| own.scaled(&factor(pencil, power, row, column)));
        characteristic_polynomial(&scaled, sums).ok()
    }
}

fn factor(pencil: &Pencil, power: usize, row: usize, column: usize) -> Rational {
    Rational::try_from(pencil.factor(power, row, column)).unwrap_or(Rational::ONE)
}
