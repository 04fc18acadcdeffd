//! Linear equations in doubles, without bounds: what is found is checked elsewhere.

use nalgebra::ComplexField;

/// L and U of a square matrix with its rows in another order, for any complex or real numbers.
pub(super) struct Factors<T, const MOST: usize> {
    size: usize,
    entries: [[T; MOST]; MOST],
    order: [usize; MOST],
}

impl<T: ComplexField<RealField = f64> + Copy, const MOST: usize> Factors<T, MOST> {
    /// Of the first `size` rows and columns; a pivot that vanishes becomes `least`, so that what nearly has no inverse
    /// has a large one. `None` if all else is 0 and `least` too, or the entries are no numbers.
    ///
    /// Complexity: n³/3 products.
    pub fn new(size: usize, mut entries: [[T; MOST]; MOST], least: f64) -> Option<Self> {
        let mut order: [usize; MOST] = std::array::from_fn(|row| row);
        for step in 0..size {
            let magnitude = |row: &usize| entries[*row][step].norm1();
            let pivot = (step..size).max_by(|a, b| magnitude(a).total_cmp(&magnitude(b)))?;
            entries.swap(step, pivot);
            order.swap(step, pivot);
            if entries[step][step].norm1() <= least {
                entries[step][step] = T::from_real(least);
            }
            let inverse = T::one() / entries[step][step];
            if !inverse.is_finite() {
                return None;
            }
            let (above, below) = entries.split_at_mut(step + 1);
            let own = &above[step];
            for row in &mut below[..size - step - 1] {
                let factor = row[step] * inverse;
                row[step] = factor;
                for column in step + 1..size {
                    row[column] -= factor * own[column];
                }
            }
        }
        Some(Factors {
            size,
            entries,
            order,
        })
    }

    /// The solution for a right-hand side. Complexity: n² products.
    pub fn solve(&self, right: &[T; MOST]) -> [T; MOST] {
        let mut solution = [T::zero(); MOST];
        for row in 0..self.size {
            let known = dot(&self.entries[row][..row], &solution);
            solution[row] = right[self.order[row]] - known;
        }
        for row in (0..self.size).rev() {
            let own = &self.entries[row];
            let known = dot(&own[row + 1..self.size], &solution[row + 1..]);
            solution[row] = (solution[row] - known) / own[row];
        }
        solution
    }
}

/// Σ aᵢ bᵢ over the first of both.
fn dot<T: ComplexField<RealField = f64> + Copy>(a: &[T], b: &[T]) -> T {
    let products = a.iter().zip(b).map(|(a, b)| *a * *b);
    products.fold(T::zero(), |sum, own| sum + own)
}

/// The inverse of the first `size` rows and columns of a real matrix; `None` if a pivot is 0.
///
/// Complexity: n³ products, along rows.
pub(super) fn inverse<const MOST: usize>(
    size: usize,
    matrix: &[[f64; MOST]; MOST],
) -> Option<[[f64; MOST]; MOST]> {
    let factors = Factors::new(size, *matrix, 0.0)?;
    let mut rows = [[0.0; MOST]; MOST];
    for (row, original) in factors.order[..size].iter().enumerate() {
        rows[row][*original] = 1.0;
    }
    for row in 0..size {
        let (above, below) = rows.split_at_mut(row);
        subtract(size, &mut below[0], above, &factors.entries[row][..row]);
    }
    for row in (0..size).rev() {
        let (above, below) = rows.split_at_mut(row + 1);
        subtract(
            size,
            &mut above[row],
            below,
            &factors.entries[row][row + 1..size],
        );
        let pivot = 1.0 / factors.entries[row][row];
        rows[row].iter_mut().for_each(|own| *own *= pivot);
    }
    Some(rows)
}

/// Takes multiples of other rows from a row.
fn subtract<const MOST: usize>(
    size: usize,
    row: &mut [f64; MOST],
    others: &[[f64; MOST]],
    factors: &[f64],
) {
    for (other, factor) in others.iter().zip(factors) {
        for (own, entry) in row[..size].iter_mut().zip(other) {
            *own -= factor * entry;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex;
    use proptest::prelude::*;

    const MOST: usize = 16;

    proptest! {
        #[test]
        fn solutions_solve_and_inverses_invert(
            entries in prop::collection::vec(-1.0..1.0f64, 2 * MOST * MOST), size in 1..=MOST,
        ) {
            let real: [[f64; MOST]; MOST] = std::array::from_fn(|i| std::array::from_fn(|j| entries[i * MOST + j] + if i == j { 4.0 } else { 0.0 }));
            let complex: [[Complex<f64>; MOST]; MOST] = std::array::from_fn(|i| std::array::from_fn(|j| Complex::new(real[i][j], entries[MOST * MOST + i * MOST + j])));
            let inverse = inverse(size, &real).unwrap();
            let right: [Complex<f64>; MOST] = std::array::from_fn(|i| Complex::new(entries[i], entries[MOST + i]));
            let solution = Factors::new(size, complex, 0.0).unwrap().solve(&right);
            for i in 0..size {
                let sum: Complex<f64> = (0..size).map(|j| complex[i][j] * solution[j]).sum();
                prop_assert!((sum - right[i]).norm() < 1e-10);
                let product = |j: usize| -> f64 { (0..size).map(|k| real[i][k] * inverse[k][j]).sum() };
                let expected = |j: usize| if i == j { 1.0 } else { 0.0 };
                prop_assert!((0..size).all(|j| (product(j) - expected(j)).abs() < 1e-10));
            }
        }
    }

    #[test]
    fn what_has_no_inverse_has_a_large_one_or_none() {
        let singular = [[1.0; MOST]; MOST];
        assert!(inverse(3, &singular).is_none());
        let factors = Factors::new(3, singular, 1e-16).unwrap();
        let mut right = [0.0; MOST];
        right[..3].copy_from_slice(&[1.0, 2.0, 4.0]);
        assert!(factors.solve(&right).iter().any(|own| own.abs() > 1e15));
    }
}
