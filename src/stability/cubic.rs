//! The roots of a cubic with complex coefficients.

use num_complex::Complex;

/// The three z with z³ + c_1 z² + c_2 z + c_3 = 0, multiple ones repeated, by Cardano's formula. `None` for
/// coefficients that are not finite.
///
/// With z = w − c_1/3 it is w³ + 3pw + 2q = 0, and w = u + v, where u³ = −q ± √(q² + p³) and uv = −p. The sign
/// that does not cancel makes the roots those of a cubic whose coefficients differ by rounding.
///
/// ```
/// use num_complex::Complex;
/// use sextic::stability::cubic::roots;
///
/// // (z − 1)(z − 2)(z − 3)
/// let coefficients = [-6.0, 11.0, -6.0].map(|own| Complex::new(own, 0.0));
/// let mut parts = roots(coefficients).expect("finite coefficients").map(|root| root.re);
/// parts.sort_by(f64::total_cmp);
/// assert!(parts.iter().zip([1.0, 2.0, 3.0]).all(|(own, root)| (own - root).abs() < 1e-14));
/// ```
pub fn roots(coefficients: [Complex<f64>; 3]) -> Option<[Complex<f64>; 3]> {
    let [c_1, c_2, c_3] = coefficients;
    // No root is larger than twice this.
    let size = c_1.norm().max(c_2.norm().sqrt()).max(c_3.norm().cbrt());
    if size == 0.0 {
        return Some([Complex::ZERO; 3]);
    }
    // A power of 2 rounds nothing.
    let unit = size.log2().floor().exp2();
    if !(unit * unit * unit).is_normal() {
        return None;
    }
    let mean = c_1 / (-3.0 * unit);
    let (c_2, c_3) = (c_2 / (unit * unit), c_3 / (unit * unit * unit));
    let p = c_2 / 3.0 - mean * mean;
    let q = (mean * (c_2 - 2.0 * mean * mean) + c_3) / 2.0;
    let root = (q * q + p * p * p).sqrt();
    let cancels = (q.conj() * root).re > 0.0;
    let u = (if cancels { -q - root } else { root - q }).cbrt();
    let v = if u == Complex::ZERO { u } else { -p / u };
    let third_of_a_turn = Complex::new(-0.5, 0.75_f64.sqrt());
    let roots = [Complex::ONE, third_of_a_turn, third_of_a_turn.conj()]
        .map(|turn| (mean + u * turn + v * turn.conj()) * unit);
    roots.iter().all(|root| root.is_finite()).then_some(roots)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn complex() -> impl Strategy<Value = Complex<f64>> {
        let part = prop_oneof![-1.0..1.0f64, -1e-9..1e-9f64, Just(0.0)];
        (part.clone(), part).prop_map(|(re, im)| Complex::new(re, im))
    }

    proptest! {
        #[test]
        fn roots_give_the_cubic(a in complex(), b in complex(), c in complex(), scale in -40..40) {
            let scale = f64::powi(2.0, scale);
            let [a, b, c] = [a, b, c].map(|root| root * scale);
            let of = |[a, b, c]: [Complex<f64>; 3]| [-(a + b + c), a * b + b * c + c * a, -a * b * c];
            let found = of(roots(of([a, b, c])).expect("roots"));
            let size = a.norm().max(b.norm()).max(c.norm());
            for (power, (own, found)) in of([a, b, c]).iter().zip(found).enumerate() {
                prop_assert!((own - found).norm() <= 1e-13 * size.powi(power as i32 + 1));
            }
        }
    }

    /// Three roots a third of a turn apart, but for a little: z³ + 3pz + 2q with a small p.
    #[test]
    fn nothing_cancels() {
        for p in [0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.1, 1.0] {
            for turn in 0..16 {
                let p = Complex::new(p, 0.0);
                let q = Complex::cis(f64::from(turn) * 0.4);
                let [a, b, c] = roots([Complex::ZERO, p * 3.0, q * 2.0]).expect("roots");
                assert!((a + b + c).norm() < 1e-15);
                assert!((a * b + b * c + c * a - p * 3.0).norm() < 1e-14, "{p} {q}");
                assert!((a * b * c + q * 2.0).norm() < 1e-14, "{p} {q}");
            }
        }
    }

    #[test]
    fn what_is_not_finite_has_no_roots() {
        let nan = Complex::new(f64::NAN, 0.0);
        assert_eq!(roots([nan, Complex::ONE, Complex::ONE]), None);
        assert_eq!(roots([Complex::ONE, nan, Complex::ONE]), None);
        let infinite = Complex::new(0.0, f64::INFINITY);
        assert_eq!(roots([Complex::ONE, Complex::ONE, infinite]), None);
    }
}
