//! Approximate eigenvectors, by inverse iteration.

use num_complex::Complex;

use super::MOST_COORDINATES;
use super::linear_equations::Factors;
use super::pencil::Pencil;

/// A vector of which the first n entries count.
pub(super) type Vector = [Complex<f64>; MOST_COORDINATES];

/// A vector q with (λ²M + λC + K) q near 0 for an approximate eigenvalue λ, its largest entry 1; `None` if there is
/// none in doubles.
///
/// Two steps of inverse iteration: P(λ) q₁ = b, P(λ) q₂ = P′(λ) q₁. Eigenvalues that coincide have vectors of their
/// own if they have different numbers, which choose b. Complexity: n³/3 products.
pub(super) fn shape(pencil: &Pencil, value: Complex<f64>, number: usize) -> Option<Vector> {
    let n = pencil.size;
    let mut entries = [[Complex::ZERO; MOST_COORDINATES]; MOST_COORDINATES];
    let mut largest = 0.0_f64;
    for (row, own) in entries[..n].iter_mut().enumerate() {
        for (column, entry) in own[..n].iter_mut().enumerate() {
            let [k, c, m] = [0, 1, 2].map(|power| pencil.powers[power].centre[row][column]);
            *entry = (value * m + c) * value + k;
            largest = largest.max(entry.re.abs() + entry.im.abs());
        }
    }
    let least = f64::EPSILON * f64::EPSILON * largest.max(f64::MIN_POSITIVE);
    let factors = Factors::new(n, entries, least)?;
    let first = with_largest_one(n, &factors.solve(&start(n, number)))?;
    with_largest_one(n, &factors.solve(&slope(pencil, value, &first))).or(Some(first))
}

/// Some vector that no eigenvector is likely to have nothing of.
fn start(n: usize, number: usize) -> Vector {
    let mut start = [Complex::ZERO; MOST_COORDINATES];
    for (place, own) in start[..n].iter_mut().enumerate() {
        // The golden section spreads evenly.
        let spread = |count: usize| (count as f64 * 0.618_033_988_749_895).fract() - 0.5;
        *own = Complex::new(
            1.0 + spread(number * n + place + 1),
            spread(number + 3 * place + 1),
        );
        if (place + number) % 2 == 1 {
            *own = -*own;
        }
    }
    start
}

/// P′(λ) q = (2λM + C) q
fn slope(pencil: &Pencil, value: Complex<f64>, vector: &Vector) -> Vector {
    let n = pencil.size;
    let mut product = [Complex::ZERO; MOST_COORDINATES];
    for (row, own) in product[..n].iter_mut().enumerate() {
        for (column, entry) in vector[..n].iter().enumerate() {
            let [c, m] = [1, 2].map(|power| pencil.powers[power].centre[row][column]);
            *own += (value * (2.0 * m) + c) * entry;
        }
    }
    product
}

/// A multiple of a vector, its largest entry 1; `None` for 0 and what is not finite.
pub(super) fn with_largest_one(n: usize, vector: &Vector) -> Option<Vector> {
    let larger = |a: &usize, b: &usize| vector[*a].norm_sqr().total_cmp(&vector[*b].norm_sqr());
    let largest = (0..n).max_by(larger)?;
    let inverse = vector[largest].finv();
    let mut multiple = vector.map(|entry| entry * inverse);
    multiple[largest] = Complex::ONE;
    multiple[..n]
        .iter()
        .all(|own| own.is_finite())
        .then_some(multiple)
}
