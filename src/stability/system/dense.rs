//! Small matrices of complex numbers, and of bounds.

use num_complex::Complex;

use super::MOST_COORDINATES;
use super::linear_equations::Factors;

/// 2n at most.
pub(super) const MOST: usize = 2 * MOST_COORDINATES;

/// More than what is lost where bounds are computed.
pub(super) const ABOVE: f64 = 1.0 + 1e-12;

/// Complex numbers, of which the first rows and columns are used.
pub(super) type Complexes = [[Complex<f64>; MOST]; MOST];
/// A bound for each row.
pub(super) type Bounds = [f64; MOST];

/// Entries, and bounds of their errors.
pub(super) struct Coefficient {
    pub centre: [[f64; MOST]; MOST],
    pub radius: [[f64; MOST]; MOST],
}

/// The inverse of a complex matrix; `None` if there is none in doubles.
pub(super) fn left_inverse(size: usize, matrix: &Complexes) -> Option<Complexes> {
    let factors = Factors::new(size, *matrix, 0.0)?;
    let mut inverse = [[Complex::ZERO; MOST]; MOST];
    for column in 0..size {
        let mut right = [Complex::ZERO; MOST];
        right[column] = Complex::ONE;
        let solution = factors.solve(&right);
        (0..size).for_each(|row| inverse[row][column] = solution[row]);
    }
    Some(inverse)
}

pub(super) fn product(size: usize, left: &[[f64; MOST]; MOST], right: &Complexes) -> Complexes {
    let mut product = [[Complex::ZERO; MOST]; MOST];
    for (own, factors) in product[..size].iter_mut().zip(left) {
        for (factor, row) in factors[..size]
            .iter()
            .zip(right)
            .filter(|(factor, _)| **factor != 0.0)
        {
            own[..size]
                .iter_mut()
                .zip(row)
                .for_each(|(own, entry)| *own += entry * factor);
        }
    }
    product
}

pub(super) fn complex_product(size: usize, left: &Complexes, right: &Complexes) -> Complexes {
    let mut product = [[Complex::ZERO; MOST]; MOST];
    for (own, factors) in product[..size].iter_mut().zip(left) {
        for (factor, row) in factors[..size].iter().zip(right) {
            own[..size]
                .iter_mut()
                .zip(row)
                .for_each(|(own, entry)| *own += entry * factor);
        }
    }
    product
}

pub(super) fn subtract(size: usize, from: &mut Complexes, other: &Complexes) {
    for (own, row) in from[..size].iter_mut().zip(other) {
        own.iter_mut()
            .zip(row)
            .for_each(|(own, entry)| *own -= entry);
    }
}

/// The sums of the absolute values of rows.
pub(super) fn sums(size: usize, matrix: &Complexes) -> Bounds {
    std::array::from_fn(|row| match row < size {
        true => {
            matrix[row][..size]
                .iter()
                .map(|own| own.l1_norm())
                .sum::<f64>()
                * ABOVE
        }
        false => 0.0,
    })
}

/// (factor |centre| + radius) times a vector.
pub(super) fn weighted(size: usize, matrix: &Coefficient, factor: f64, vector: &Bounds) -> Bounds {
    std::array::from_fn(|row| {
        let pairs = matrix.centre[row][..size].iter().zip(&matrix.radius[row]);
        let bound = |(centre, radius): (&f64, &f64)| centre.abs() * factor + radius;
        pairs
            .map(bound)
            .zip(vector)
            .map(|(own, size)| own * size)
            .sum::<f64>()
            * ABOVE
            + f64::MIN_POSITIVE * 64.0
    })
}

/// |Y| times a vector.
pub(super) fn absolute(size: usize, y: &Complexes, vector: &Bounds) -> Bounds {
    std::array::from_fn(|row| {
        let pairs = y[row][..size].iter().zip(vector);
        pairs.map(|(own, size)| own.l1_norm() * size).sum::<f64>() * ABOVE
    })
}

pub(super) fn add(a: &Bounds, b: &Bounds) -> Bounds {
    std::array::from_fn(|place| (a[place] + b[place]) * ABOVE)
}

pub(super) fn scaled(a: &Bounds, factor: f64) -> Bounds {
    a.map(|own| own * factor)
}
