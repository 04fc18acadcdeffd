//! A system with a number for each parameter: its matrices, eigenvalues, shapes and verdict.

use std::collections::BTreeMap;

use nalgebra::DMatrix;
use num_complex::Complex;
use sextic_codegen::evaluator::Circular;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::budget::Budget;
use crate::algebra::determinant::determinant;
use crate::algebra::interval::{Interval, Intervals, KnownSign};
use crate::algebra::matrix::Matrix;
use crate::algebra::number::Rational;
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};
use crate::stability::approximation::approximate_eigenvalues;
use crate::stability::companion::companion_matrix;
use crate::stability::eigenvalue::{Eigenvalue, GOOD, Spectrum};
use crate::stability::enclosure::error_bounds;
use crate::stability::francis;
use crate::stability::half_plane::{MOST_PRODUCTS, Roots, roots_of_enclosed, roots_without_pairs};
use crate::stability::verdict::{Doubt, LONGEST_POLYNOMIAL, Verdict, verdict_by_errors};

use super::arithmetic::{Enclosures, NoValue, Sums, ball, rational};
use super::block::{Block, blocks};
use super::disc::{Enclosed, discs};
use super::entries::{Entries, Matrices, check};
use super::error::SystemError;
use super::parameter::{Parameters, chosen, names};
use super::pencil::Pencil;
use super::polynomial::{characteristic_polynomial, taylor};
use super::real::Real;
use super::state::state_matrix;
use super::vector::{Vector, shape, with_largest_one};
use super::{MOST_ROWS, System};

/// The digits with which matrices are enclosed: more where fewer leave an entry open.
const DIGITS: [usize; 3] = [256, 1024, 4096];

/// An entry is known well enough if its bound is below this share of it, or it is 0.
const CLOSE: f64 = 1e-12;

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
    exact: Option<Matrices<Sum>>,
    /// The entries in doubles with bounds.
    entries: Entries<Real>,
    /// K, C and M in doubles with bounds.
    matrices: Matrices<Real>,
    blocks: Vec<Block>,
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

/// An eigenvalue, and how the coordinates move with it.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemMode {
    /// λ, its imaginary part 0 or above.
    pub eigenvalue: Eigenvalue,
    /// q with (λ²M + λC + K) q = 0, its largest entry 1, for the coordinates in order; `None` for an eigenvalue that is
    /// not told from others, of which no shape is certain to be near.
    pub shape: Option<Vec<Complex<f64>>>,
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

/// The entries with as many digits as they need.
fn close_entries(
    system: &System,
    parameters: &Parameters<'_>,
    exact: Option<&Entries<Sum>>,
) -> Result<(Entries<Real>, Matrices<Real>), SystemError> {
    let mut found = Err(NoValue::NotExact);
    for bits in DIGITS {
        found = enclosed_entries(system, parameters, exact, &Intervals::new(bits));
        if is_close(&found) {
            break;
        }
    }
    found.map_err(cause)
}

/// Why a program has no value, for a reader.
pub(super) fn cause(reason: NoValue) -> SystemError {
    match reason {
        NoValue::Root => SystemError::Root,
        NoValue::Division | NoValue::NotExact => SystemError::Division,
    }
}

/// The entries in exact numbers; `None` where they have none, or too long ones.
fn exact_entries(
    system: &System,
    parameters: &Parameters<'_>,
) -> Result<Option<Entries<Sum>>, SystemError> {
    let sums = TrigonometricSums::new(Budget::new(LONGEST_POLYNOMIAL));
    let circular = |own: &Circular, angle: &Rational| {
        chosen(own.function, [Sum::cosine(angle), Sum::sine(angle)])
    };
    let inputs = parameters.inputs(|_, own| Sum::from(own.clone()), circular);
    match system.evaluator.program.run(&mut Sums(&sums), &inputs) {
        Ok(outputs) => Ok(Entries::new(system, &outputs)),
        Err(NoValue::NotExact) => Ok(None),
        Err(reason) => Err(cause(reason)),
    }
}

fn totals(entries: &Entries<Sum>) -> Option<Matrices<Sum>> {
    let sums = TrigonometricSums::new(Budget::new(LONGEST_POLYNOMIAL));
    entries.sums(&Sum::default(), |a, b| sums.sum(a, b)).ok()
}

/// The entries with so many digits.
fn intervals_of(
    system: &System,
    parameters: &Parameters<'_>,
    exact: Option<&Entries<Sum>>,
    intervals: &Intervals,
) -> Result<Entries<Interval>, NoValue> {
    if let Some(exact) = exact {
        return Ok(exact.map(|own| intervals.enclosure(own)));
    }
    let circular =
        |own: &Circular, angle: &Rational| chosen(own.function, intervals.cosine_and_sine(angle));
    let inputs = parameters.inputs(|_, own| intervals.rational(own), circular);
    let outputs = system
        .evaluator
        .program
        .run(&mut Enclosures(intervals), &inputs)?;
    Entries::new(system, &outputs).ok_or(NoValue::NotExact)
}

/// The entries and the sums of parts, in doubles with bounds.
fn enclosed_entries(
    system: &System,
    parameters: &Parameters<'_>,
    exact: Option<&Entries<Sum>>,
    intervals: &Intervals,
) -> Result<(Entries<Real>, Matrices<Real>), NoValue> {
    let entries = intervals_of(system, parameters, exact, intervals)?;
    let Ok(matrices) = entries.sums(&intervals.zero(), |a, b| intervals.sum(a, b));
    let round = |own: &Interval| ball(own, intervals);
    Ok((entries.map(round), matrices.map(|_, own| round(own))))
}

/// Whether more digits would say no more.
fn is_close(found: &Result<(Entries<Real>, Matrices<Real>), NoValue>) -> bool {
    let Ok((_, matrices)) = found else {
        return false;
    };
    let is_close = |own: &Real| own.radius <= CLOSE * own.centre.abs();
    matrices.powers.iter().flatten().all(is_close)
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
    fn block_eigenvalues(&self, block: &Block, pencil: &Pencil) -> Option<Vec<Enclosed>> {
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
        let none = || vec![crate::stability::ball::Ball::ZERO; polynomial.len()];
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

    /// Whether the system is stable, with proof, for its parameters as they are written: by the errors of the eigenvalues
    /// where these decide it, else as [`Instance::exact_verdict`].
    pub fn verdict(&self) -> Verdict {
        let by_errors = self.spectrum().ok().and_then(|own| verdict_by_errors(&own));
        by_errors.unwrap_or_else(|| self.exact_verdict())
    }

    /// The verdict by the determinants of the characteristic polynomial, block by block: in exact sums of sines and
    /// cosines where the matrices have such entries, so that what is exactly 0 is known to be, else in enclosures with up
    /// to 4096 binary digits.
    ///
    /// Complexity: bounded, as [`exact_verdict`](crate::stability::verdict::exact_verdict) of a section, for each block.
    pub fn exact_verdict(&self) -> Verdict {
        let found = self.blocks.iter().map(|block| self.roots_of(block));
        let mut all = Ok(Roots::Left);
        for own in found {
            all = match (all, own) {
                (Ok(Roots::Right), _) | (_, Ok(Roots::Right)) => Ok(Roots::Right),
                (Err(doubt), _) | (_, Err(doubt)) => Err(doubt),
                (Ok(Roots::OnAxis), _) | (_, Ok(Roots::OnAxis)) => Ok(Roots::OnAxis),
                _ => Ok(Roots::Left),
            };
        }
        Verdict::from(all)
    }

    /// Where the roots of the polynomial of a block lie.
    fn roots_of(&self, block: &Block) -> Result<Roots, Doubt> {
        let pencil = self.pencil(Some(block));
        let enclosed = |intervals: &Intervals| self.scaled_polynomial(block, &pencil, intervals);
        let sums = TrigonometricSums::new(Budget::new(LONGEST_POLYNOMIAL));
        let Some(polynomial) = self.exact_polynomial(block, &pencil, &sums) else {
            return roots_of_enclosed(enclosed);
        };
        let squares = self.natural_squares(block, &pencil).into_iter();
        roots_without_pairs(
            polynomial,
            squares,
            &TrigonometricSums::new(Budget::new(MOST_PRODUCTS)),
        )
        .or_else(|doubt| roots_of_enclosed(enclosed).map_err(|_| doubt))
    }

    /// ν for the divisors λ² + ν that are likely where a motion is not damped: k/m of a coordinate alone.
    fn natural_squares(&self, block: &Block, pencil: &Pencil) -> Vec<Sum> {
        let Some(exact) = &self.exact else {
            return Vec::new();
        };
        let unit = Rational::try_from(pencil.unit * pencil.unit).unwrap_or(Rational::ONE);
        let own = |place: &usize| {
            let [stiffness, mass] = [0, 2].map(|power| rational(exact.at(power, *place, *place)));
            let mass = mass.filter(|own| !own.is_zero())?;
            Some(stiffness? / mass / &unit)
        };
        let mut squares: Vec<Rational> = block.iter().filter_map(own).collect();
        squares.sort();
        squares.dedup();
        squares.into_iter().map(Sum::from).collect()
    }

    /// Whether a real eigenvalue is above 0, so that a motion leaves without oscillating: by the signs of the determinants
    /// of K and M, an odd number of them; else by the signs of the coefficients, of which there is none without a change
    /// (Descartes), or by eigenvalues that stand alone. `None` if that leaves it open.
    pub fn diverges(&self) -> Option<bool> {
        let found: Vec<Option<bool>> = self
            .blocks
            .iter()
            .map(|own| self.block_diverges(own))
            .collect();
        match found.contains(&Some(true)) {
            true => Some(true),
            false => found.iter().all(Option::is_some).then_some(false),
        }
    }

    fn block_diverges(&self, block: &Block) -> Option<bool> {
        let intervals = Intervals::new(DIGITS[1]);
        let pencil = self.pencil(Some(block));
        let polynomial = self.scaled_polynomial(block, &pencil, &intervals)?;
        let signs: Vec<KnownSign> = polynomial.iter().map(Interval::sign).collect();
        let (first, last) = (signs.first()?, signs.last()?);
        match (first, last) {
            (KnownSign::Negative, KnownSign::Positive)
            | (KnownSign::Positive, KnownSign::Negative) => return Some(true),
            _ => (),
        }
        if signs
            .iter()
            .all(|own| own == last || *own == KnownSign::Zero)
        {
            return Some(false);
        }
        let eigenvalues = self.block_eigenvalues(block, &pencil)?;
        // What stands alone and is complex has a conjugate elsewhere, so that it is not real.
        let may_be_real = |own: &&Enclosed| !own.is_alone || own.value.im == 0.0;
        let mut real = eigenvalues.iter().filter(may_be_real);
        if real
            .clone()
            .any(|own| own.is_alone && own.value.re > own.radius)
        {
            return Some(true);
        }
        real.all(|own| own.value.re < -own.radius).then_some(false)
    }

    /// The pencil of a block, or of all coordinates.
    fn pencil(&self, block: Option<&Block>) -> Pencil {
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
    fn scaled_polynomial(
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
    fn exact_polynomial(
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
