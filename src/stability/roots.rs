//! The roots of a polynomial with complex coefficients.

use nalgebra::Schur;
use num_complex::Complex;
use polynomial::Polynomial;

use super::companion::companion_matrix;
use super::cubic;

/// The most iterations of the decomposition; 30 are plenty where it converges.
const MOST_ITERATIONS: usize = 200;

/// The n complex z with zⁿ + c_1 zⁿ⁻¹ + … + c_n = 0, multiple ones repeated: of a cubic by its formula, of another
/// polynomial as the eigenvalues of its companion matrix. `None` for coefficients that are not finite, and where
/// nothing converged.
///
/// ```
/// use num_complex::Complex;
/// use sextic::stability::roots::roots;
///
/// // (z − 1)(z − i)
/// let coefficients = [Complex::new(-1.0, -1.0), Complex::i()];
/// let found = roots(&coefficients).expect("finite coefficients");
/// for root in [Complex::ONE, Complex::i()] {
///     assert!(found.iter().any(|own| (own - root).norm() < 1e-14));
/// }
/// ```
pub fn roots(coefficients: &[Complex<f64>]) -> Option<Vec<Complex<f64>>> {
    if !coefficients.iter().all(|own| own.is_finite()) {
        return None;
    }
    match <[Complex<f64>; 3]>::try_from(coefficients) {
        Ok(coefficients) => Some(cubic::roots(coefficients)?.to_vec()),
        Err(_) => by_companion(coefficients),
    }
}

/// With z in units of the largest |c_k|^(1/k), so that no entry of the matrix is large.
fn by_companion(coefficients: &[Complex<f64>]) -> Option<Vec<Complex<f64>>> {
    let numbered = || (1..).zip(coefficients);
    let sizes = numbered().map(|(power, own)| own.norm().powf(1.0 / f64::from(power)));
    let size = sizes.fold(0.0, f64::max);
    if size == 0.0 {
        return Some(coefficients.to_vec());
    }
    // A power of 2 rounds nothing.
    let unit = size.log2().floor().exp2();
    let scaled = numbered().map(|(power, own)| own / unit.powi(power));
    let mut ascending: Vec<_> = [Complex::ONE].into_iter().chain(scaled).collect();
    ascending.reverse();
    let matrix = companion_matrix(&Polynomial::new(ascending));
    let schur = Schur::try_new(matrix, f64::EPSILON, MOST_ITERATIONS)?;
    let roots = schur.eigenvalues()?;
    let roots = roots.iter().map(|root| root * unit);
    let are_finite = roots.clone().all(|root| root.is_finite());
    are_finite.then(|| roots.collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn complex() -> impl Strategy<Value = Complex<f64>> {
        let part = prop_oneof![-1.0..1.0f64, Just(0.0)];
        (part.clone(), part).prop_map(|(re, im)| Complex::new(re, im))
    }

    /// Below the leading 1, that of the highest power first.
    fn coefficients(roots: &[Complex<f64>]) -> Vec<Complex<f64>> {
        let mut product = vec![Complex::ONE];
        for root in roots {
            let shifted: Vec<_> = product.iter().map(|own| -own * root).collect();
            product.push(Complex::ZERO);
            let lower = product[1..].iter_mut().zip(shifted);
            lower.for_each(|(own, less)| *own += less);
        }
        product.split_off(1)
    }

    fn require_same(own: &[Complex<f64>], found: &[Complex<f64>], size: f64) {
        assert_eq!(own.len(), found.len());
        for (power, (own, found)) in (1..).zip(own.iter().zip(found)) {
            let bound = 1e-12 * size.powi(power);
            assert!((own - found).norm() <= bound, "{own} {found} {power}");
        }
    }

    proptest! {
        #[test]
        fn roots_give_the_polynomial(
            own in proptest::collection::vec(complex(), 1..=8),
            scale in -40..40,
        ) {
            let own: Vec<_> = own.iter().map(|root| root * f64::powi(2.0, scale)).collect();
            let size = 2.0 * own.iter().map(|root| root.norm()).fold(0.0, f64::max);
            let given = coefficients(&own);
            require_same(&given, &coefficients(&roots(&given).expect("roots")), size);
        }

        #[test]
        fn a_cubic_has_the_roots_of_its_companion_matrix(own in proptest::collection::vec(complex(), 3)) {
            let given = coefficients(&own);
            let found = by_companion(&given).expect("roots");
            require_same(&given, &coefficients(&found), 2.0);
            require_same(&given, &coefficients(&roots(&given).expect("roots")), 2.0);
        }
    }

    #[test]
    fn what_is_not_finite_has_no_roots() {
        let nan = Complex::new(f64::NAN, 0.0);
        let infinite = Complex::new(0.0, f64::INFINITY);
        for bad in [nan, infinite] {
            assert_eq!(roots(&[bad]), None);
            assert_eq!(roots(&[Complex::ONE, bad]), None);
            assert_eq!(roots(&[Complex::ONE, Complex::ONE, bad]), None);
        }
    }
}
