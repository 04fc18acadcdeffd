//! Eigenvalues on a range of a parameter: discs whose centres move with it.
//!
//! For a pencil A − λB whose entries are known to second order in δ, |δ| ≤ h, with X, Y and Λ at δ = 0 as in
//! `disc`, and with D and E, where E_ij = D_ij/(λ_j − λ_i),
//!
//! ```text
//! H(δ) = (Y B X)⁻¹ Y (A X − B X Λ) = δD + rest
//! (Λ + δD)(I + δE) = (I + δE)(Λ + δ diagonal(D)) + δ² (D E − E diagonal(D))
//! ```
//!
//! so that at every δ the eigenvalues lie in discs about λᵢ + δD_ii whose radii are of second order.

use num_complex::Complex;

use super::dense::{
    ABOVE, Coefficient, Complexes, MOST, absolute, add, complex_product, left_inverse, product,
    scaled, subtract, sums, weighted,
};
use super::entries::Matrices;
use super::jet::Jet;
use super::pencil::Pencil;
use super::real::Real;
use super::state::{state_matrix, stiffness_over_mass};
use super::vector::{Vector, shape};
use crate::stability::francis::eigenvalues;

/// A disc that moves: its centre is value + δ slope.
#[derive(Clone, Copy, Debug)]
pub(super) struct Disc {
    pub value: Complex<f64>,
    pub slope: Complex<f64>,
    pub radius: f64,
}

/// Eigenvalues and a vector for each.
type Approximations = (Vec<Complex<f64>>, Vec<Long>);

/// A vector q, or (q, λq).
type Long = [Complex<f64>; MOST];

fn long(vector: &Vector) -> Long {
    let mut long = [Complex::ZERO; MOST];
    long[..vector.len()].copy_from_slice(vector);
    long
}

/// Eigenvalues and vectors (q, λq).
pub(super) fn values(pencil: &Pencil) -> Option<Approximations> {
    let n = pencil.size;
    let values = eigenvalues(2 * n, &state_matrix(pencil)?)?[..2 * n].to_vec();
    let vector = |(number, value): (usize, &Complex<f64>)| {
        let mut vector = long(&of_pair(pencil, *value, *value, number)?);
        for place in 0..n {
            vector[n + place] = vector[place] * value;
        }
        Some(vector)
    };
    let vectors = values
        .iter()
        .enumerate()
        .map(vector)
        .collect::<Option<Vec<_>>>()?;
    Some((values, vectors))
}

/// Eigenvalues s = λ² of a block without damping, and their vectors.
pub(super) fn squares(pencil: &Pencil) -> Option<Approximations> {
    let n = pencil.size;
    let values = eigenvalues(n, &stiffness_over_mass(pencil)?)?[..n].to_vec();
    let vector = |(number, value): (usize, &Complex<f64>)| {
        Some(long(&of_pair(pencil, *value, value.sqrt(), number)?))
    };
    let vectors = values
        .iter()
        .enumerate()
        .map(vector)
        .collect::<Option<Vec<_>>>()?;
    Some((values, vectors))
}

/// The vector at λ, for a value whose conjugate has the conjugate vector; a real one for a real value.
fn of_pair(
    pencil: &Pencil,
    value: Complex<f64>,
    lambda: Complex<f64>,
    number: usize,
) -> Option<Vector> {
    match value.im {
        im if im < 0.0 => {
            Some(shape(pencil, lambda.conj(), number.saturating_sub(1))?.map(|own| own.conj()))
        }
        im if im > 0.0 => shape(pencil, lambda, number),
        // λ² is real, and so is the vector but for a factor that is 1 where it is largest.
        _ => Some(shape(pencil, lambda, number)?.map(|own| Complex::new(own.re, 0.0))),
    }
}

/// A and B of a pencil A − λB in powers of δ: entries and bounds of their errors, that of δ² for the whole range.
pub(super) struct Linear {
    size: usize,
    a: [Coefficient; 3],
    b: [Coefficient; 3],
}

impl Linear {
    fn new(size: usize, a: impl Fn(usize, usize) -> Jet, b: impl Fn(usize, usize) -> Jet) -> Self {
        let coefficients = |entry: &dyn Fn(usize, usize) -> Jet| {
            [0, 1, 2].map(|order| {
                let mut found = Coefficient {
                    centre: [[0.0; MOST]; MOST],
                    radius: [[0.0; MOST]; MOST],
                };
                for (row, column) in
                    (0..size).flat_map(|row| (0..size).map(move |column| (row, column)))
                {
                    let own = entry(row, column);
                    let own = [own.value, own.slope, own.rest][order];
                    found.centre[row][column] = own.centre;
                    found.radius[row][column] = own.radius;
                }
                found
            })
        };
        Linear {
            size,
            a: coefficients(&a),
            b: coefficients(&b),
        }
    }

    /// A = \[0, I; −K, −C\], B = diagonal(I, M)
    pub fn of_states(matrices: &Matrices<Jet>) -> Self {
        let n = matrices.size;
        let one = Jet::constant(Real::ONE);
        let unit = |is_one: bool| if is_one { one } else { Jet::default() };
        let a = |row: usize, column: usize| match (row < n, column < n) {
            (true, _) => unit(column == row + n),
            (false, true) => matrices.at(0, row - n, column).scaled(-1.0),
            (false, false) => matrices.at(1, row - n, column - n).scaled(-1.0),
        };
        let b = |row: usize, column: usize| match (row < n, column < n) {
            (false, false) => *matrices.at(2, row - n, column - n),
            _ => unit(row == column),
        };
        Linear::new(2 * n, a, b)
    }

    /// A = −K, B = M
    pub fn of_squares(matrices: &Matrices<Jet>) -> Self {
        let a = |row: usize, column: usize| matrices.at(0, row, column).scaled(-1.0);
        Linear::new(matrices.size, a, |row, column| *matrices.at(2, row, column))
    }
}

/// Bounds of the sums of rows of products of complex numbers, over the sums of the absolute values: some six roundings
/// an entry, and one for each summand.
fn rounding(summands: usize) -> f64 {
    (2 * summands + 12) as f64 * f64::EPSILON
}

/// Discs that hold as many eigenvalues as they are where they do not touch, at every |δ| ≤ h.
pub(super) fn discs(
    linear: &Linear,
    values: &[Complex<f64>],
    vectors: &[Long],
    h: f64,
) -> Option<Vec<Disc>> {
    let size = linear.size;
    let mut x: Complexes = [[Complex::ZERO; MOST]; MOST];
    for (column, vector) in vectors.iter().enumerate() {
        (0..size).for_each(|row| x[row][column] = vector[row]);
    }
    let mut xl = x;
    for row in &mut xl[..size] {
        row.iter_mut()
            .zip(values)
            .for_each(|(own, value)| *own *= value);
    }
    let y = left_inverse(size, &product(size, &linear.b[0].centre, &x))?;
    let (sum_x, sum_xl) = (sums(size, &x), sums(size, &xl));
    let exact = rounding(2 * size);
    // A X − B X Λ in powers of δ, and bounds of the rounding of rows in sum.
    let residual = |order: usize| {
        let (a, b) = (&linear.a[order], &linear.b[order]);
        let (mut own, taken) = (product(size, &a.centre, &x), product(size, &b.centre, &xl));
        subtract(size, &mut own, &taken);
        let lost = add(
            &weighted(size, a, exact, &sum_x),
            &weighted(size, b, exact, &sum_xl),
        );
        (own, lost)
    };
    let [zeroth, first] = [0, 1].map(|order| {
        let (own, lost) = residual(order);
        let found = complex_product(size, &y, &own);
        let lost = absolute(size, &y, &add(&lost, &scaled(&sums(size, &own), exact)));
        (found, lost)
    });
    let second = {
        let (a, b) = (&linear.a[2], &linear.b[2]);
        absolute(
            size,
            &y,
            &add(
                &weighted(size, a, 1.0, &sum_x),
                &weighted(size, b, 1.0, &sum_xl),
            ),
        )
    };
    // I − Y B X
    let mut e = complex_product(size, &y, &product(size, &linear.b[0].centre, &x));
    (0..size).for_each(|place| e[place][place] -= 1.0);
    let lost_e = absolute(
        size,
        &y,
        &scaled(&weighted(size, &linear.b[0], 1.0, &sum_x), exact),
    );
    let radius_e = absolute(size, &y, &weighted(size, &linear.b[0], 0.0, &sum_x));
    let [first_e, second_e] =
        [1, 2].map(|order| absolute(size, &y, &weighted(size, &linear.b[order], 1.0, &sum_x)));
    let (sum_e, sum_zeroth, sum_first) =
        (sums(size, &e), sums(size, &zeroth.0), sums(size, &first.0));
    let row = |own: usize| {
        let e = sum_e[own]
            + 2.0 * lost_e[own]
            + radius_e[own]
            + 8.0 * f64::EPSILON
            + h * (first_e[own] + h * second_e[own]);
        let zeroth = sum_zeroth[own] + zeroth.1[own] + f64::MIN_POSITIVE;
        let rest = zeroth + h * (first.1[own] + h * second[own]);
        [e * ABOVE, rest * ABOVE, (rest + h * sum_first[own]) * ABOVE]
    };
    let rows: Vec<[f64; 3]> = (0..size).map(row).collect();
    let largest = |place: usize| rows.iter().map(|own| own[place]).fold(0.0, f64::max);
    let (most_e, most_f) = (largest(0), largest(2));
    if !(most_e < 1.0 && most_f.is_finite() && rows.iter().flatten().all(|own| own.is_finite())) {
        return None;
    }
    let rest: Vec<f64> = rows
        .iter()
        .map(|[e, rest, _]| (rest + e * most_f / (1.0 - most_e) * ABOVE) * ABOVE)
        .collect();
    moved(values, &first.0, &rest, h)
}

/// The discs of Λ + δD + rest after the change of basis by E.
fn moved(values: &[Complex<f64>], d: &Complexes, rest: &[f64], h: f64) -> Option<Vec<Disc>> {
    let size = values.len();
    let (mut e, mut left) = ([[0.0_f64; MOST]; MOST], [0.0; MOST]);
    for row in 0..size {
        for column in (0..size).filter(|column| *column != row) {
            let (gap, own) = ((values[column] - values[row]).norm(), d[row][column].norm());
            // Where eigenvalues lie too close for this it is left as it is.
            let is_apart = gap > 8.0 * size as f64 * h * own;
            e[row][column] = if is_apart { own / gap * ABOVE } else { 0.0 };
            left[row] += if is_apart {
                16.0 * f64::EPSILON * own
            } else {
                own
            };
        }
    }
    let sum_e: Vec<f64> = e[..size]
        .iter()
        .map(|row| row.iter().sum::<f64>() * ABOVE)
        .collect();
    let most_e = h * sum_e.iter().copied().fold(0.0, f64::max) * ABOVE;
    let term = |row: usize| {
        let others = (0..size).filter(|column| *column != row);
        let second: f64 = others
            .map(|column| {
                d[row][column].norm() * sum_e[column]
                    + e[row][column] * (d[row][row] - d[column][column]).norm()
            })
            .sum();
        (h * (left[row] + h * second) + rest[row] * (1.0 + most_e)) * ABOVE
    };
    let terms: Vec<f64> = (0..size).map(term).collect();
    let most = terms.iter().copied().fold(0.0, f64::max);
    if !(most_e < 0.5 && most.is_finite()) {
        return None;
    }
    let disc = |row: usize| {
        let (value, mut slope) = (values[row], d[row][row]);
        let mut radius = (terms[row] + h * sum_e[row] * most / (1.0 - most_e)) * ABOVE;
        // A disc about a real number that holds one eigenvalue alone holds a real one.
        if value.im == 0.0 {
            radius = (radius + h * slope.im.abs()) * ABOVE;
            slope.im = 0.0;
        }
        Disc {
            value,
            slope,
            radius,
        }
    };
    Some((0..size).map(disc).collect())
}
