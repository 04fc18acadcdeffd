//! Determinants and linear systems by elimination without fractions (Bareiss).

use super::budget::{Budget, Exhausted};
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::gcd::quotient;
use super::linear_system::Solution;
use super::matrix::Matrix;
use super::polynomial::Polynomial;
use super::ring::Ring;

impl Ring {
    /// |A| of a square matrix, as [`determinant`](super::determinant::determinant) gives it, for matrices
    /// that are too large for minors: of numbers, or with few symbols or few entries.
    ///
    /// Complexity: n³/3 products and exact quotients of minors for n rows.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] where the budget or a polynomial's size runs out.
    ///
    /// # Panics
    ///
    /// If the matrix is not square.
    pub fn eliminated_determinant(
        &self,
        matrix: &Matrix<Fraction>,
    ) -> Result<Fraction, AlgebraError> {
        let cleared = self.cleared(matrix, None)?;
        let mut elimination = Elimination::new(cleared.rows, self.budget());
        elimination.run(false)?;
        self.fraction(&elimination.determinant(), &cleared.below)
    }

    /// The solution of A·X = B with any number of columns in B, as
    /// [`solve`](super::linear_system::solve) gives it but without numerators where A is singular, for
    /// matrices that are too large for minors.
    ///
    /// Complexity: n²·(n + m) products and exact quotients of minors for n rows and m columns in B.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] for a singular matrix, [`AlgebraError::Exhausted`] where the
    /// budget or a polynomial's size runs out.
    ///
    /// # Panics
    ///
    /// If the matrix is not square, or B has not as many rows.
    pub fn eliminated_solution(
        &self,
        matrix: &Matrix<Fraction>,
        right: &Matrix<Fraction>,
    ) -> Result<Solution<Fraction>, AlgebraError> {
        let (size, count) = right.shape();
        let cleared = self.cleared(matrix, Some(right))?;
        let mut elimination = Elimination::new(cleared.rows, self.budget());
        elimination.run(true)?;
        let determinant = elimination.determinant();
        if determinant.is_zero() {
            return Err(AlgebraError::DivisionByZero);
        }
        let numerators = Matrix::try_from_fn(size, count, |row, column| {
            self.fraction(&elimination.numerator(row, column), &cleared.below)
        })?;
        Ok(Solution {
            numerators,
            determinant: self.fraction(&determinant, &cleared.below)?,
        })
    }

    /// The rows of a matrix, each times its common denominator, and the product of these.
    fn cleared(
        &self,
        matrix: &Matrix<Fraction>,
        right: Option<&Matrix<Fraction>>,
    ) -> Result<Cleared, AlgebraError> {
        let mut cleared = Cleared {
            rows: Vec::new(),
            below: Polynomial::one(),
        };
        for row in 0..matrix.rows() {
            let entries = (0..matrix.columns()).map(|column| matrix.at(row, column));
            let behind = right
                .into_iter()
                .flat_map(|right| (0..right.columns()).map(move |column| right.at(row, column)));
            let entries: Vec<&Fraction> = entries.chain(behind).collect();
            let mut common = Polynomial::one();
            for entry in &entries {
                let shared = common.gcd(entry.denominator(), self.budget())?;
                let missing = quotient(entry.denominator(), &shared, self.budget())?;
                common = common.multiply(&missing, self.budget())?;
            }
            let mut line = Vec::new();
            for entry in &entries {
                let factor = quotient(&common, entry.denominator(), self.budget())?;
                line.push(entry.numerator().multiply(&factor, self.budget())?);
            }
            cleared.rows.push(line);
            cleared.below = cleared.below.multiply(&common, self.budget())?;
        }
        Ok(cleared)
    }
}

/// A matrix of polynomials, and what it was multiplied by.
struct Cleared {
    rows: Vec<Vec<Polynomial>>,
    below: Polynomial,
}

/// An elimination under way, over polynomials without relations: these are folded in the end, since a
/// determinant is a polynomial in the entries.
///
/// After k steps every entry that is left is a minor of k + 1 rows, so that the division by the pivot
/// before, a minor of k − 1, is exact.
struct Elimination<'a> {
    rows: Vec<Vec<Polynomial>>,
    budget: &'a Budget,
    /// Where the columns of the matrix stood.
    columns: Vec<usize>,
    negative: bool,
    /// The last pivot.
    pivot: Polynomial,
}

impl<'a> Elimination<'a> {
    fn new(rows: Vec<Vec<Polynomial>>, budget: &'a Budget) -> Self {
        let columns = (0..rows.len()).collect();
        Elimination {
            rows,
            budget,
            columns,
            negative: false,
            pivot: Polynomial::one(),
        }
    }

    /// Eliminates until all rows are used up or a pivot is 0; in all rows, or in those below the pivots.
    fn run(&mut self, everywhere: bool) -> Result<(), Exhausted> {
        let size = self.rows.len();
        for step in 0..size {
            let Some((row, column)) = self.best_pivot(step) else {
                self.pivot = Polynomial::zero();
                return Ok(());
            };
            self.bring(row, column, step);
            let pivot_row = self.rows[step].clone();
            let first = if everywhere { 0 } else { step + 1 };
            for row in (first..size).filter(|row| *row != step) {
                self.eliminate(row, step, &pivot_row)?;
            }
            self.pivot = pivot_row[step].clone();
        }
        Ok(())
    }

    /// The place of the entry that makes the fewest others, and is short.
    fn best_pivot(&self, step: usize) -> Option<(usize, usize)> {
        let size = self.rows.len();
        let left = || step..size;
        let filled = |row: usize, column: usize| !self.rows[row][column].is_zero();
        let in_row: Vec<usize> = left()
            .map(|row| left().filter(|c| filled(row, *c)).count())
            .collect();
        let in_column: Vec<usize> = left()
            .map(|column| left().filter(|r| filled(*r, column)).count())
            .collect();
        let places = left().flat_map(|row| left().map(move |column| (row, column)));
        places
            .filter(|(row, column)| filled(*row, *column))
            .min_by_key(|(row, column)| {
                let others = (in_row[row - step] - 1) * (in_column[column - step] - 1);
                (
                    self.rows[*row][*column].len() > 1,
                    others,
                    self.rows[*row][*column].len(),
                )
            })
    }

    /// Exchanges rows and columns so that a pivot stands on the diagonal.
    fn bring(&mut self, row: usize, column: usize, step: usize) {
        self.negative ^= (row != step) ^ (column != step);
        self.rows.swap(row, step);
        self.columns.swap(column, step);
        self.rows
            .iter_mut()
            .for_each(|line| line.swap(column, step));
    }

    fn eliminate(
        &mut self,
        row: usize,
        step: usize,
        pivot_row: &[Polynomial],
    ) -> Result<(), Exhausted> {
        let budget = self.budget;
        let line = &mut self.rows[row];
        let factor = std::mem::take(&mut line[step]);
        // The columns before are those of pivots: there only this row's own is not 0.
        for (place, entry) in line
            .iter_mut()
            .enumerate()
            .filter(|(place, _)| *place != step)
        {
            let above = &pivot_row[place];
            if entry.is_zero() && (above.is_zero() || factor.is_zero()) {
                continue;
            }
            let kept = entry.multiply(&pivot_row[step], budget)?;
            let difference = &kept - &above.multiply(&factor, budget)?;
            *entry = quotient(&difference, &self.pivot, budget)?;
        }
        Ok(())
    }

    fn determinant(&self) -> Polynomial {
        match self.negative {
            true => -&self.pivot,
            false => self.pivot.clone(),
        }
    }

    /// The numerator of an unknown; its row is that of the pivot in its column.
    fn numerator(&self, unknown: usize, column: usize) -> Polynomial {
        let size = self.rows.len();
        let row = self.columns.iter().position(|stood| *stood == unknown);
        let value = row.map(|row| &self.rows[row][size + column]);
        let value = value.cloned().unwrap_or_default();
        if self.negative { -&value } else { value }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::arithmetic::Arithmetic;
    use super::super::determinant::determinant;
    use super::super::generator::Generator;
    use super::super::linear_system::solve;
    use super::super::number::{Integer, Rational};
    use super::*;

    fn number(n: i32, d: i32) -> Fraction {
        Fraction::from(Rational::from(n) / Rational::from(d))
    }

    /// A ring with a parameter and the sine and cosine of an angle; entries by small numbers.
    fn entries(ring: &mut Ring) -> Vec<Fraction> {
        let x = ring
            .symbol(Generator::Constant { name: "x".into() })
            .unwrap();
        let angle = ring.symbol(Generator::Angle { name: "α".into() }).unwrap();
        let angle = ring.angle(&ring.element(angle)).unwrap();
        let (cosine, sine) = ring.cosine_and_sine(&angle).unwrap();
        let x = ring.element(x);
        vec![
            number(0, 1),
            number(1, 1),
            number(-2, 3),
            x.reciprocal().unwrap(),
            x,
            cosine,
            sine,
        ]
    }

    proptest! {
        #[test]
        fn elimination_and_minors_agree(places in prop::collection::vec(0_usize..7, 20), size in 1_usize..=4) {
            let mut ring = Ring::new(Budget::unlimited());
            let entries = entries(&mut ring);
            let matrix = Matrix::from_fn(size, size, |i, j| entries[places[4 * i + j]].clone());
            let right = Matrix::from_fn(size, 1, |i, _| entries[places[16 + i]].clone());
            let by_minors = determinant(&matrix, &ring).unwrap();
            let eliminated = ring.eliminated_determinant(&matrix).unwrap();
            prop_assert!(ring.difference(&by_minors, &eliminated).unwrap().is_zero());
            match ring.eliminated_solution(&matrix, &right) {
                Err(error) => prop_assert!(by_minors.is_zero(), "{error}"),
                Ok(solution) => {
                    let expected = solve(&matrix, &right, &ring).unwrap();
                    for (a, b) in expected.numerators.entries().iter().zip(solution.numerators.entries()) {
                        prop_assert!(ring.difference(a, b).unwrap().is_zero());
                    }
                }
            }
        }
    }

    #[test]
    fn sixty_four_rows_of_numbers_are_cheap() {
        // Σⱼ bⱼ³ with small pseudo-random entries, against the product of pivots modulo a prime.
        let mut state = 1_u64;
        let mut next = || {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            ((state >> 33) % 19) as i32 - 9
        };
        let numbers: Vec<Vec<i32>> = (0..64).map(|_| (0..64).map(|_| next()).collect()).collect();
        let matrix = Matrix::from_fn(64, 64, |i, j| number(numbers[i][j], 1));
        let ring = Ring::new(Budget::new(50_000_000));
        let found = ring
            .eliminated_determinant(&matrix)
            .unwrap()
            .as_constant()
            .unwrap();
        const PRIME: i64 = 1_000_003;
        let mut rows: Vec<Vec<i64>> = numbers
            .iter()
            .map(|row| row.iter().map(|n| i64::from(*n)).collect())
            .collect();
        let inverse = |n: i64| {
            (0..20).rev().fold(1, |power, bit| {
                let square = power * power % PRIME;
                if (PRIME - 2) >> bit & 1 == 1 {
                    square * n % PRIME
                } else {
                    square
                }
            })
        };
        let mut product = 1_i64;
        for k in 0..64 {
            let row = (k..64).find(|row| rows[*row][k] % PRIME != 0).unwrap();
            if row != k {
                rows.swap(row, k);
                product = -product;
            }
            product = product * rows[k][k] % PRIME;
            let pivot = rows[k].clone();
            for row in &mut rows[k + 1..] {
                let factor = row[k] * inverse(pivot[k].rem_euclid(PRIME)) % PRIME;
                for (entry, above) in row.iter_mut().zip(&pivot).skip(k) {
                    *entry = (*entry - factor * above) % PRIME;
                }
            }
        }
        let difference = found.numerator() - Integer::from(product);
        assert_eq!(difference % Integer::from(PRIME), Integer::ZERO);
    }
}
