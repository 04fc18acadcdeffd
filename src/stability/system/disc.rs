//! Discs that hold eigenvalues for certain, from approximate eigenvalues and eigenvectors.
//!
//! With q for the coordinates and q̇ the eigenvalues of λ²M + λC + K are those of A − λB, where A = [0, I; −K, −C] and
//! B = diagonal(I, M). For any X, Y and Λ, with E = I − Y B X and F = Y (A X − B X Λ), where E is small,
//!
//! ```text
//! A x = λ B x,  x = X v   ⇒   (Λ + H) v = λ v,  H = (I − E)⁻¹ F,  |H| ≤ |F| + |E| (I − |E|)⁻¹ |F|
//! ```
//!
//! and a disc about each λᵢ with the sum of row i of |H| as its radius holds eigenvalues: k discs that do not touch the
//! others hold k of them (Gershgorin). That M has an inverse follows, as Y B X has one. X, Y and Λ may be anything; where
//! they are good, F and E are as small as rounding. They are real: a complex pair stands as the real and the imaginary
//! part of its vector, and sums of rows are those of complex vectors.

use num_complex::Complex;

use super::MOST_COORDINATES;
use super::linear_equations::inverse;
use super::pencil::Pencil;
use super::vector::shape;

/// 2n at most.
pub(super) const MOST: usize = 2 * MOST_COORDINATES;

/// Rows of which the first n count, with an entry for each eigenvalue.
type Wide = [[f64; MOST]; MOST_COORDINATES];

/// More than what is lost where bounds are computed: some hundred additions and products.
const ABOVE: f64 = 1.0 + 1e-12;

/// A bound of the rounding of a sum of so many products, over the sum of their absolute values.
fn rounding(products: usize) -> f64 {
    (products + 2) as f64 * f64::EPSILON
}

/// More than what underflows in a sum of products.
const UNDERFLOW: f64 = 64.0 * f64::MIN_POSITIVE;

/// A real eigenvalue or a pair, in the columns of X.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column {
    /// The first column.
    pub first: usize,
    /// The value; its imaginary part is above 0 for a pair.
    pub value: Complex<f64>,
}

impl Column {
    fn is_pair(&self) -> bool {
        self.value.im != 0.0
    }

    fn width(&self) -> usize {
        if self.is_pair() { 2 } else { 1 }
    }
}

/// What is known of eigenvalues that are approximated: one disc for a real value, two for a pair.
#[derive(Clone, Debug)]
pub(super) struct Discs {
    /// The values.
    pub columns: Vec<Column>,
    /// The radius of each.
    pub radii: Vec<f64>,
}

/// Real values and one of each pair; `None` if a complex one has no conjugate beside it.
pub(super) fn columns(values: &[Complex<f64>]) -> Option<Vec<Column>> {
    let mut first = 0;
    let mut columns = Vec::with_capacity(values.len());
    for &value in values.iter().filter(|own| own.im >= 0.0) {
        columns.push(Column { first, value });
        first += if value.im > 0.0 { 2 } else { 1 };
    }
    (first == values.len()).then_some(columns)
}

/// Discs about approximate eigenvalues; `None` if no bound is found.
///
/// Complexity: 16 n³ products for the bounds, and n⁴/3 complex ones at most for the vectors.
pub(super) fn discs(pencil: &Pencil, values: &[Complex<f64>]) -> Option<Discs> {
    let columns = columns(values)?;
    let shapes = columns
        .iter()
        .map(|own| shape(pencil, own.value, own.first))
        .collect::<Option<Vec<_>>>()?;
    let radii = radii(pencil, &columns, &shapes)?;
    Some(Discs { columns, radii })
}

/// Bounds by approximate vectors.
pub(super) fn radii(
    pencil: &Pencil,
    columns: &[Column],
    shapes: &[super::vector::Vector],
) -> Option<Vec<f64>> {
    let n = pencil.size;
    let mut v: Wide = [[0.0; MOST]; MOST_COORDINATES];
    for (column, shape) in columns.iter().zip(shapes) {
        for (row, entry) in v[..n].iter_mut().zip(shape) {
            row[column.first] = entry.re;
            if column.is_pair() {
                row[column.first + 1] = entry.im;
            }
        }
    }
    let w = times_values(n, &v, columns);
    let z = times_values(n, &w.product, columns);
    let [stiffness, damping, mass] = [&pencil.powers[0], &pencil.powers[1], &pencil.powers[2]];
    // B X = [V; M W]
    let mut u: Wide = [[0.0; MOST]; MOST_COORDINATES];
    add_product(n, &mut u, &mass.centre, &w.product);
    let y = inverse(2 * n, &stacked(n, &v, &u))?;
    // −(A X − B X Λ) below is K V + C W + M W Λ; above it is V Λ − W, which is rounding.
    let mut s: Wide = [[0.0; MOST]; MOST_COORDINATES];
    add_product(n, &mut s, &stiffness.centre, &v);
    add_product(n, &mut s, &damping.centre, &w.product);
    add_product(n, &mut s, &mass.centre, &z.product);
    let sums = [sizes(n, &v), sizes(n, &w.product), sizes(n, &z.product)];
    let mut below = [0.0; MOST_COORDINATES];
    let mut inertia = [0.0; MOST_COORDINATES];
    for row in 0..n {
        let of = |power: usize, factor: f64, sums: &[f64; MOST_COORDINATES]| -> f64 {
            let matrix = &pencil.powers[power];
            let pairs = matrix.centre[row][..n].iter().zip(&matrix.radius[row]);
            let bound = |(centre, radius): (&f64, &f64)| centre.abs() * factor + radius;
            pairs.map(bound).zip(sums).map(|(own, sum)| own * sum).sum()
        };
        let rounded = rounding(3 * n);
        below[row] = of(0, rounded, &sums[0])
            + of(1, rounded, &sums[1])
            + of(2, rounded, &sums[2])
            + of(2, 1.0, &z.lost)
            + UNDERFLOW;
        inertia[row] = of(2, rounding(n), &sums[1]) + UNDERFLOW;
    }
    bounds(
        n,
        columns,
        &Parts {
            y,
            v,
            u,
            s,
            above: w.lost,
            below,
            inertia,
        },
    )
}

/// What bounds are made of: Y, V, M W and −(A X − B X Λ), and bounds of the sums of rows of what they lack.
struct Parts {
    y: [[f64; MOST]; MOST],
    v: Wide,
    u: Wide,
    s: Wide,
    /// Of V Λ − W.
    above: [f64; MOST_COORDINATES],
    /// Of K V + C W + M W Λ beside S.
    below: [f64; MOST_COORDINATES],
    /// Of M W beside U.
    inertia: [f64; MOST_COORDINATES],
}

/// The radii by E and F.
fn bounds(n: usize, columns: &[Column], parts: &Parts) -> Option<Vec<f64>> {
    let (sum_v, sum_u, sum_s) = (sizes(n, &parts.v), sizes(n, &parts.u), sizes(n, &parts.s));
    let mut found = Vec::with_capacity(columns.len());
    let (mut most_e, mut most_f) = (0.0_f64, 0.0_f64);
    for column in columns {
        let (mut e, mut f) = (Rows::default(), Rows::default());
        for place in 0..column.width() {
            let row = &parts.y[column.first + place];
            let (upper, lower) = row[..2 * n].split_at(n);
            let (e_row, f_row) = (&mut e.rows[place], &mut f.rows[place]);
            e_row[column.first + place] = 1.0;
            for (factor, (v, u)) in upper
                .iter()
                .zip(lower)
                .zip(parts.v.iter().zip(&parts.u))
                .map(|((a, b), own)| ([*a, *b], own))
            {
                for (own, (v, u)) in e_row[..2 * n].iter_mut().zip(v.iter().zip(u)) {
                    *own -= factor[0] * v + factor[1] * u;
                }
            }
            for (factor, s) in lower.iter().zip(&parts.s) {
                for (own, s) in f_row[..2 * n].iter_mut().zip(s) {
                    *own -= factor * s;
                }
            }
            for k in 0..n {
                let (a, b) = (upper[k].abs(), lower[k].abs());
                e.lost +=
                    rounding(2 * n + 2) * (a * sum_v[k] + b * sum_u[k]) + b * parts.inertia[k];
                f.lost += rounding(n + 1) * b * sum_s[k] + a * parts.above[k] + b * parts.below[k];
            }
            // The 1 on the diagonal takes part in the last sum of so many products.
            e.lost += rounding(2 * n + 2) + UNDERFLOW;
            f.lost += UNDERFLOW;
        }
        let [e, f] = [e, f].map(|own| own.size(column, columns));
        (most_e, most_f) = (most_e.max(e), most_f.max(f));
        found.push([e, f]);
    }
    let inverse = 1.0 / (1.0 - most_e * ABOVE) * ABOVE;
    // Not so where a number is none.
    if !(most_e * ABOVE < 1.0 && found.iter().flatten().all(|own| own.is_finite())) {
        return None;
    }
    Some(
        found
            .iter()
            .map(|[e, f]| (f + e * most_f * inverse) * ABOVE)
            .collect(),
    )
}

/// One row of a matrix, or the two of a pair, and a bound of what they lack in sum.
#[derive(Default)]
struct Rows {
    rows: [[f64; MOST]; 2],
    lost: f64,
}

impl Rows {
    /// The sum of the absolute values of a row of the same matrix for complex vectors p ± iq in place of p and q.
    fn size(&self, own: &Column, columns: &[Column]) -> f64 {
        let [p, q] = &self.rows;
        let mut sum = 0.0;
        for column in columns {
            let at = column.first;
            sum += match (own.is_pair(), column.is_pair()) {
                (false, false) => p[at].abs(),
                // h₁ ± i h₂
                (false, true) => 2.0 * (p[at].abs() + p[at + 1].abs()),
                // (h₁ ± i h₂)/2
                (true, false) => (p[at].abs() + q[at].abs()) / 2.0,
                // ((h₁₁ + h₂₂) ± i (h₁₂ − h₂₁))/2 and ((h₁₁ − h₂₂) ± i (h₁₂ + h₂₁))/2
                (true, true) => p[at].abs().max(q[at + 1].abs()) + p[at + 1].abs().max(q[at].abs()),
            };
        }
        // A complex row has at most twice the sum of a real one, and at most that of both.
        (sum + 2.0 * self.lost) * ABOVE
    }
}

/// X Λ, and a bound of the rounding of its rows in sum.
struct Product {
    product: Wide,
    lost: [f64; MOST_COORDINATES],
}

/// The columns p and q of a pair a ± ib become a p − b q and b p + a q.
fn times_values(n: usize, matrix: &Wide, columns: &[Column]) -> Product {
    let mut product = [[0.0; MOST]; MOST_COORDINATES];
    let mut lost = [0.0; MOST_COORDINATES];
    for (row, (own, lost)) in product.iter_mut().zip(&mut lost).enumerate().take(n) {
        for column in columns {
            let (at, a, b) = (column.first, column.value.re, column.value.im);
            if column.is_pair() {
                let (p, q) = (matrix[row][at], matrix[row][at + 1]);
                (own[at], own[at + 1]) = (a * p - b * q, b * p + a * q);
                *lost += (a.abs() + b.abs()) * (p.abs() + q.abs());
            } else {
                own[at] = a * matrix[row][at];
                *lost += own[at].abs();
            }
        }
        *lost = *lost * 2.0 * f64::EPSILON + UNDERFLOW;
    }
    Product { product, lost }
}

/// The sums of the absolute values of rows.
fn sizes(n: usize, matrix: &Wide) -> [f64; MOST_COORDINATES] {
    std::array::from_fn(|row| match row < n {
        true => matrix[row][..2 * n].iter().map(|own| own.abs()).sum(),
        false => 0.0,
    })
}

/// Adds a product of a square matrix and rows.
fn add_product(n: usize, sum: &mut Wide, left: &super::pencil::Square, right: &Wide) {
    for (own, factors) in sum[..n].iter_mut().zip(left) {
        for (factor, row) in factors[..n].iter().zip(right) {
            for (own, entry) in own[..2 * n].iter_mut().zip(row) {
                *own += factor * entry;
            }
        }
    }
}

/// \[V; U\]
fn stacked(n: usize, upper: &Wide, lower: &Wide) -> [[f64; MOST]; MOST] {
    std::array::from_fn(|row| match row {
        row if row < n => upper[row],
        row if row < 2 * n => lower[row - n],
        _ => [0.0; MOST],
    })
}

impl Discs {
    /// All eigenvalues with a bound of the error of each and whether its disc touches no other one: there is a one-to-one
    /// assignment of exact eigenvalues to these values, none farther away than the bound.
    pub fn eigenvalues(&self) -> Vec<Enclosed> {
        let mut all = Vec::with_capacity(2 * self.columns.len());
        for (column, radius) in self.columns.iter().zip(&self.radii) {
            let mut add = |value| {
                all.push(Enclosed {
                    value,
                    radius: *radius,
                    is_alone: true,
                });
            };
            add(column.value);
            if column.is_pair() {
                add(column.value.conj());
            }
        }
        with_bounds_of_groups(all)
    }
}

/// An approximate eigenvalue in units of a pencil.
#[derive(Clone, Copy, Debug)]
pub(super) struct Enclosed {
    pub value: Complex<f64>,
    /// A bound of its error.
    pub radius: f64,
    /// Whether it is certain to be a simple one: no other exact eigenvalue is within its radius.
    pub is_alone: bool,
}

/// Discs that touch hold as many eigenvalues together as they are: each of these may be any of them.
fn with_bounds_of_groups(all: Vec<Enclosed>) -> Vec<Enclosed> {
    let touch =
        |a: &Enclosed, b: &Enclosed| (a.value - b.value).norm() <= (a.radius + b.radius) * ABOVE;
    let mut groups: Vec<usize> = (0..all.len()).collect();
    for one in 0..all.len() {
        for other in 0..one {
            if groups[one] != groups[other] && touch(&all[one], &all[other]) {
                let (from, to) = (groups[one], groups[other]);
                groups
                    .iter_mut()
                    .filter(|own| **own == from)
                    .for_each(|own| *own = to);
            }
        }
    }
    let bounded = |(index, own): (usize, &Enclosed)| {
        let others = all
            .iter()
            .zip(&groups)
            .filter(|(_, group)| **group == groups[index]);
        let reach = |(other, _): (&Enclosed, &usize)| {
            ((other.value - own.value).norm() + other.radius) * ABOVE
        };
        let is_alone = groups
            .iter()
            .filter(|group| **group == groups[index])
            .count()
            == 1;
        let radius = others.map(reach).fold(0.0, f64::max);
        Enclosed {
            radius: if is_alone { own.radius } else { radius },
            is_alone,
            ..*own
        }
    };
    all.iter().enumerate().map(bounded).collect()
}
