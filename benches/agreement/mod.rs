//! Contenders compute the same, or nothing is timed.

use nalgebra::{Complex, Matrix6};
use sextic_evaluators::characteristic_polynomial::CharacteristicPolynomialSlicesMut;
use sextic_evaluators::closed_form::{
    ClosedFormInputs, ClosedFormSlices, ClosedFormSlicesMut, closed_form_with_bound,
};

use crate::section::eigenvalues_if_found;

/// Prints how far the C is from the evaluator, in units in the last place.
///
/// # Panics
///
/// If it is farther than the evaluator's bound of its own rounding error, twice: C rounds as often.
pub fn of_closed_forms(inputs: &ClosedFormSlices<'_>, found: &ClosedFormSlicesMut<'_>) {
    let mut units = Vec::new();
    for point in 0..inputs.m.len() {
        macro_rules! at {
            ($($input:ident)*) => {
                closed_form_with_bound(&ClosedFormInputs { $($input: inputs.$input[point],)* })
            };
        }
        let wanted = at!(m r L_g cos_alpha_g_plus_theta_0 sin_alpha_g_plus_theta_0 rho D U
                         S_xx S_xy S_yx S_yy S_xt S_yt S_tx S_ty S_tt);
        for (wanted, found) in [
            (wanted.lamda_R1, found.lamda_R1[point]),
            (wanted.lamda_R2, found.lamda_R2[point]),
            (wanted.lamda_R3, found.lamda_R3[point]),
        ] {
            let difference = (wanted.value - found).abs();
            assert!(difference <= 2.0 * wanted.error, "point {point}");
            let unit = wanted.value.abs().next_up() - wanted.value.abs();
            units.push(difference / unit);
        }
    }
    units.sort_by(f64::total_cmp);
    let (median, most) = (units[units.len() / 2], units[units.len() * 99 / 100]);
    println!(
        "closed forms in C: {median} ulp apart in the median, {most} at 99 of 100 points, {} at most, \
         all within the bounds",
        units[units.len() - 1]
    );
}

/// Prints how far the coefficients are from those of the polynomial with the eigenvalues as its roots.
///
/// # Panics
///
/// If an eigenvalue solve does not end, or a coefficient is not the same to six digits.
pub fn of_polynomials(matrices: &[Matrix6<f64>], found: &CharacteristicPolynomialSlicesMut<'_>) {
    let mut largest: f64 = 0.0;
    for (point, matrix) in matrices.iter().enumerate() {
        let roots = eigenvalues_if_found(matrix).expect("the eigenvalue solve ends");
        // By the power of λ; of the size of the sum of the absolute terms.
        let mut polynomial = [Complex::new(0.0, 0.0); 7];
        let mut sizes = [0.0; 7];
        (polynomial[0], sizes[0]) = (Complex::new(1.0, 0.0), 1.0);
        for root in roots {
            for power in (0..7_usize).rev() {
                let below = power.checked_sub(1);
                let lower = below.map_or(Complex::new(0.0, 0.0), |below| polynomial[below]);
                polynomial[power] = lower - polynomial[power] * root;
                sizes[power] = below.map_or(0.0, |below| sizes[below]) + sizes[power] * root.norm();
            }
        }
        let found = [
            &found.c_0, &found.c_1, &found.c_2, &found.c_3, &found.c_4, &found.c_5, &found.c_6,
        ];
        for power in 0..7 {
            let difference = (polynomial[power].re - found[power][point]).abs() / sizes[power];
            assert!(difference < 1e-6, "point {point}, power {power}");
            largest = largest.max(difference);
        }
    }
    println!("coefficients and eigenvalues agree to {largest:.1e}");
}
