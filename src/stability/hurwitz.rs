//! Hurwitz' determinants over any exact numbers.

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::determinant::determinant;
use crate::algebra::matrix::Matrix;

/// H_1 to H_n of a polynomial of degree n, given by its coefficients, that of λ⁰ first.
///
/// ```text
/// H_k = |a_1 a_3 a_5 …; a_0 a_2 a_4 …; 0 a_1 a_3 …; …|, k×k, for a_0 λⁿ + a_1 λⁿ⁻¹ + … + a_n
/// ```
///
/// With a_0 > 0 all are positive exactly where every root has a negative real part (Hurwitz).
///
/// Complexity: at most n·2ⁿ products.
///
/// # Errors
///
/// Those of the arithmetic.
pub(super) fn hurwitz_determinants<A: Arithmetic>(
    coefficients: &[A::Element],
    arithmetic: &A,
) -> Result<Vec<A::Element>, A::Error> {
    let degree = coefficients.len().saturating_sub(1);
    let entry = |row: usize, column: usize| {
        let place = (2 * column + 1).checked_sub(row);
        let power = place.and_then(|place| degree.checked_sub(place));
        power.map_or_else(|| arithmetic.zero(), |power| coefficients[power].clone())
    };
    (1..=degree)
        .map(|size| determinant(&Matrix::from_fn(size, size, entry), arithmetic))
        .collect()
}
