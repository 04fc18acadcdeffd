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

use super::MOST_COORDINATES;
use super::arithmetic::Reals;
use super::entries::Matrices;
use super::jet::{Jet, Jets};
use super::linear_equations::Factors;
use super::pencil::Pencil;
use super::polynomial::characteristic_polynomial;
use super::real::Real;
use super::state::{state_matrix, stiffness_over_mass};
use super::vector::{Vector, shape};
use crate::stability::francis::eigenvalues;

/// 2n at most.
const MOST: usize = 2 * MOST_COORDINATES;

/// More than what is lost where bounds are computed.
const ABOVE: f64 = 1.0 + 1e-12;

type Complexes = [[Complex<f64>; MOST]; MOST];
type Bounds = [f64; MOST];

/// What is certain of the eigenvalues of a block on a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Motion {
    /// All real parts are below 0.
    Damped,
    /// All real parts are 0, and no eigenvalue is: the block has no damping.
    Neutral,
    /// Nothing.
    Unknown,
    /// A real part is above 0.
    Growing,
    /// A real eigenvalue is above 0.
    Divergent,
}

/// A disc that moves: its centre is value + δ slope.
#[derive(Clone, Copy, Debug)]
struct Disc {
    value: Complex<f64>,
    slope: Complex<f64>,
    radius: f64,
}

/// What is certain of a block with these matrices for |δ| ≤ h: by discs and, where these leave it open, as about
/// eigenvalues that coincide and have one vector, by the characteristic polynomial.
pub(super) fn motion(matrices: &Matrices<Jet>, h: f64) -> Motion {
    match by_discs(matrices, h) {
        Motion::Unknown => by_polynomial(matrices, h),
        known => known,
    }
}

/// What the signs of the characteristic polynomial show on the whole range.
fn by_polynomial(matrices: &Matrices<Jet>, h: f64) -> Motion {
    let jets = Jets::new(h);
    let pencil = pencil_of(matrices);
    let range = matrices
        .map(|[power, row, column], own| jets.range(own).scaled(pencil.factor(power, row, column)));
    let Ok(polynomial) = characteristic_polynomial(&range, &Reals);
    let is_negative = |own: &Real| own.centre < -own.radius;
    let is_positive = |own: &Real| own.centre > own.radius;
    let polynomial: Vec<Real> = match polynomial.last() {
        Some(last) if is_positive(last) => polynomial,
        Some(last) if is_negative(last) => polynomial.into_iter().map(|own| -own).collect(),
        _ => return Motion::Unknown,
    };
    if is_negative(&polynomial[0]) {
        return Motion::Divergent;
    }
    by_routh(polynomial)
}

/// What the signs of Routh's scheme show, as far as it goes.
fn by_routh(polynomial: Vec<Real>) -> Motion {
    let degree = polynomial.len() - 1;
    let row = |first: usize| -> Vec<Real> {
        polynomial
            .iter()
            .rev()
            .skip(first)
            .step_by(2)
            .copied()
            .collect()
    };
    let (mut above, mut own) = (row(0), row(1));
    for _ in 0..degree {
        let first = own.first().copied().unwrap_or(Real::ZERO);
        let is_positive = first.centre > first.radius;
        let factor = match above[0].quotient(first) {
            Some(factor) if is_positive => factor,
            _ if first.centre < -first.radius => return Motion::Growing,
            _ => return Motion::Unknown,
        };
        let entry = |(place, upper): (usize, &Real)| {
            *upper - factor * own.get(place + 1).copied().unwrap_or(Real::ZERO)
        };
        let next = above.iter().skip(1).enumerate().map(entry).collect();
        (above, own) = (own, next);
    }
    Motion::Damped
}

fn pencil_of(matrices: &Matrices<Jet>) -> Pencil {
    Pencil::new(matrices.size, |power, row, column| {
        matrices.at(power, row, column).value
    })
}

/// What discs show.
fn by_discs(matrices: &Matrices<Jet>, h: f64) -> Motion {
    let pencil = pencil_of(matrices);
    let scaled =
        matrices.map(|[power, row, column], own| own.scaled(pencil.factor(power, row, column)));
    let is_undamped = scaled.powers[1].iter().all(Jet::is_zero);
    let found = match is_undamped {
        true => squares(&pencil).and_then(|(values, vectors)| {
            let linear = Linear::of_squares(&scaled);
            Some(of_squares(&discs(&linear, &values, &vectors, h)?, h))
        }),
        false => values(&pencil).and_then(|(values, vectors)| {
            let linear = Linear::of_states(&scaled);
            Some(of_states(&discs(&linear, &values, &vectors, h)?, h))
        }),
    };
    found.unwrap_or(Motion::Unknown)
}

/// Eigenvalues and a vector for each.
type Approximations = (Vec<Complex<f64>>, Vec<Vector>);

/// Eigenvalues and vectors (q, λq).
fn values(pencil: &Pencil) -> Option<Approximations> {
    let n = pencil.size;
    let values = eigenvalues(2 * n, &state_matrix(pencil)?)?[..2 * n].to_vec();
    let vector = |(number, value): (usize, &Complex<f64>)| {
        let mut vector = of_pair(pencil, *value, *value, number)?;
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
fn squares(pencil: &Pencil) -> Option<Approximations> {
    let n = pencil.size;
    let values = eigenvalues(n, &stiffness_over_mass(pencil)?)?[..n].to_vec();
    let vector =
        |(number, value): (usize, &Complex<f64>)| of_pair(pencil, *value, value.sqrt(), number);
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
struct Linear {
    size: usize,
    a: [Coefficient; 3],
    b: [Coefficient; 3],
}

struct Coefficient {
    centre: [[f64; MOST]; MOST],
    radius: [[f64; MOST]; MOST],
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
    fn of_states(matrices: &Matrices<Jet>) -> Self {
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
    fn of_squares(matrices: &Matrices<Jet>) -> Self {
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
fn discs(
    linear: &Linear,
    values: &[Complex<f64>],
    vectors: &[Vector],
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

/// Discs of λ.
fn of_states(discs: &[Disc], h: f64) -> Motion {
    let reach = |own: &Disc| (h * own.slope.re.abs() + own.radius) * ABOVE;
    if discs.iter().all(|own| own.value.re < -reach(own)) {
        return Motion::Damped;
    }
    of_groups(
        discs,
        h,
        |own| own.value.re > reach(own),
        |own| own.value.re > reach(own),
    )
}

/// Discs of s = λ²: what is not real and below 0 has a root to the right.
fn of_squares(discs: &[Disc], h: f64) -> Motion {
    let groups = groups(discs, h);
    let reach = |own: &Disc| (h * own.slope.re.abs() + own.radius) * ABOVE;
    let is_neutral = |(place, own): (usize, &Disc)| {
        own.value.im == 0.0 && own.value.re < -reach(own) && is_alone(&groups, place)
    };
    if discs.iter().enumerate().all(is_neutral) {
        return Motion::Neutral;
    }
    let is_off = |own: &Disc| {
        own.value.re > reach(own)
            || own.value.im.abs() > (h * own.slope.im.abs() + own.radius) * ABOVE
    };
    of_groups(discs, h, is_off, |own| own.value.re > reach(own))
}

/// What discs show that touch no others.
fn of_groups(
    discs: &[Disc],
    h: f64,
    is_growing: impl Fn(&Disc) -> bool,
    is_right: impl Fn(&Disc) -> bool,
) -> Motion {
    let groups = groups(discs, h);
    let mut found = Motion::Unknown;
    for (place, own) in discs.iter().enumerate() {
        if own.value.im == 0.0 && is_right(own) && is_alone(&groups, place) {
            return Motion::Divergent;
        }
        let mut members = discs
            .iter()
            .zip(&groups)
            .filter(|(_, group)| **group == groups[place]);
        if members.all(|(member, _)| is_growing(member)) {
            found = Motion::Growing;
        }
    }
    found
}

fn is_alone(groups: &[usize], place: usize) -> bool {
    groups.iter().filter(|own| **own == groups[place]).count() == 1
}

/// The group of each disc: those in different ones do not touch at any |δ| ≤ h.
fn groups(discs: &[Disc], h: f64) -> Vec<usize> {
    let touch = |a: &Disc, b: &Disc| {
        let distance = (a.value - b.value).norm() - h * (a.slope - b.slope).norm() * ABOVE;
        distance
            <= (a.radius + b.radius) * ABOVE
                + 4.0 * f64::EPSILON * (a.value.norm() + b.value.norm())
    };
    let mut groups: Vec<usize> = (0..discs.len()).collect();
    for one in 0..discs.len() {
        for other in 0..one {
            if groups[one] != groups[other] && touch(&discs[one], &discs[other]) {
                let (from, to) = (groups[one], groups[other]);
                groups
                    .iter_mut()
                    .filter(|own| **own == from)
                    .for_each(|own| *own = to);
            }
        }
    }
    groups
}

/// The inverse of a complex matrix; `None` if there is none in doubles.
fn left_inverse(size: usize, matrix: &Complexes) -> Option<Complexes> {
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

fn product(size: usize, left: &[[f64; MOST]; MOST], right: &Complexes) -> Complexes {
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

fn complex_product(size: usize, left: &Complexes, right: &Complexes) -> Complexes {
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

fn subtract(size: usize, from: &mut Complexes, other: &Complexes) {
    for (own, row) in from[..size].iter_mut().zip(other) {
        own.iter_mut()
            .zip(row)
            .for_each(|(own, entry)| *own -= entry);
    }
}

/// The sums of the absolute values of rows.
fn sums(size: usize, matrix: &Complexes) -> Bounds {
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
fn weighted(size: usize, matrix: &Coefficient, factor: f64, vector: &Bounds) -> Bounds {
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
fn absolute(size: usize, y: &Complexes, vector: &Bounds) -> Bounds {
    std::array::from_fn(|row| {
        let pairs = y[row][..size].iter().zip(vector);
        pairs.map(|(own, size)| own.l1_norm() * size).sum::<f64>() * ABOVE
    })
}

fn add(a: &Bounds, b: &Bounds) -> Bounds {
    std::array::from_fn(|place| (a[place] + b[place]) * ABOVE)
}

fn scaled(a: &Bounds, factor: f64) -> Bounds {
    a.map(|own| own * factor)
}
