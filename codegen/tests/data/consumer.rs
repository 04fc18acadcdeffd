//! Uses the emitted crate: checks batches against scalars, then answers a line for each line of points.
#![allow(non_snake_case)]

use sextic_evaluators::arithmetic::Arithmetic;
use sextic_evaluators::dispatch::{Level, LengthMismatch, Mode};
use sextic_evaluators::{determinant, match_, quadratic_form, rod};

/// Equal bits; any NaN equals any other.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

fn data(seed: usize, length: usize) -> Vec<f64> {
    (0..length).map(|point| ((point * 37 + seed * 101) % 211) as f64 / 17.0 - 5.1).collect()
}

macro_rules! evaluator {
    ($check:ident, $answer:ident, $module:ident, $Inputs:ident, $Slices:ident, $SlicesMut:ident,
     $batch_at:ident, $batch:ident, $with_bound:ident, [$($input:ident),*], [$($output:ident),*]) => {
        fn $check() {
            for level in Level::available() {
                for length in 0..=20 {
                    for mode in [Mode::Strict, Mode::Fused] {
                        let mut seed = 0;
                        $(seed += 1; let $input = data(seed, length);)*
                        let inputs = $module::$Slices { $($input: &$input),* };
                        // One value more than there are points: it must not be touched.
                        struct Found { $($output: Vec<f64>),* }
                        let mut found = Found { $($output: vec![-77.0; length + 1]),* };
                        let mut outputs = $module::$SlicesMut {
                            $($output: &mut found.$output[..length]),*
                        };
                        $module::$batch_at(level, &inputs, &mut outputs, mode).unwrap();
                        $(assert_eq!(found.$output[length], -77.0);)*
                        for point in 0..length {
                            let inputs = $module::$Inputs { $($input: $input[point]),* };
                            let expected = $module::$module(&inputs);
                            $(
                                let (one, other) = (found.$output[point], expected.$output);
                                let close = match mode {
                                    Mode::Strict => same(one, other),
                                    Mode::Fused => {
                                        let bound = $module::$with_bound(&inputs).$output.error;
                                        same(one, other) || (one - other).abs() <= 2.0 * bound
                                    }
                                };
                                assert!(close, "{level} {mode:?} {length} {point}: {one} {other}");
                            )*
                        }
                    }
                }
            }
            // Lengths that differ are an error, and nothing is written.
            struct Short { $($output: Vec<f64>),* }
            let mut short = Short { $($output: vec![-77.0; 3]),* };
            let values = vec![1.0; 4];
            let inputs = $module::$Slices { $($input: &values),* };
            let mut outputs = $module::$SlicesMut { $($output: &mut short.$output),* };
            let LengthMismatch { expected, found, .. } =
                $module::$batch(&inputs, &mut outputs, Mode::Strict).unwrap_err();
            assert_eq!((expected, found), (4, 3));
            $(assert_eq!(short.$output, [-77.0; 3]);)*
        }

        fn $answer(values: &[f64]) -> Vec<(f64, f64)> {
            let mut values = values.iter().copied();
            $(let $input = values.next().unwrap();)*
            let inputs = $module::$Inputs { $($input),* };
            let plain = $module::$module(&inputs);
            let bounded = $module::$with_bound(&inputs);
            $(assert!(same(plain.$output, bounded.$output.value));)*
            vec![$((bounded.$output.value, bounded.$output.error)),*]
        }
    };
}

evaluator!(
    check_determinant, answer_determinant, determinant, DeterminantInputs, DeterminantSlices,
    DeterminantSlicesMut, determinant_batch_at, determinant_batch, determinant_with_bound,
    [m_11, m_12, m_13, m_21, m_22, m_23, m_31, m_32, m_33], [quotient, trace]
);
evaluator!(
    check_quadratic_form, answer_quadratic_form, quadratic_form, QuadraticFormInputs,
    QuadraticFormSlices, QuadraticFormSlicesMut, quadratic_form_batch_at, quadratic_form_batch,
    quadratic_form_with_bound, [a, b, c, x, y], [value, slope]
);
evaluator!(
    check_match, answer_match, match_, MatchInputs, MatchSlices, MatchSlicesMut, match__batch_at,
    match__batch, match__with_bound, [I, lambda, t1, fn_, double, unused],
    [I, nested, again, same, three]
);
evaluator!(
    check_rod, answer_rod, rod, RodInputs, RodSlices, RodSlicesMut, rod_batch_at, rod_batch,
    rod_with_bound,
    [L, cos_alpha_g_plus_theta_0, sin_alpha_g_plus_theta_0, cos_2_beta_minus_theta_0],
    [reach, height, scale, ratio]
);

/// The inputs at angles, as they are printed.
#[cfg(feature = "std")]
fn at_angles(values: &[f64]) -> Vec<f64> {
    let angles = rod::RodAngles { L: values[0], theta_0: values[1], beta: values[2] };
    let inputs = rod::RodInputs::from(&angles);
    vec![
        inputs.L,
        inputs.cos_alpha_g_plus_theta_0,
        inputs.sin_alpha_g_plus_theta_0,
        inputs.cos_2_beta_minus_theta_0,
    ]
}

/// `core` has no sine.
#[cfg(not(feature = "std"))]
fn at_angles(values: &[f64]) -> Vec<f64> {
    let angles = rod::RodAngles { L: values[0], theta_0: values[1], beta: values[2] };
    vec![angles.L]
}

fn main() {
    check_rod();
    check_determinant();
    check_quadratic_form();
    check_match();
    for level in Level::available() {
        eprintln!("level {level}");
    }
    for line in std::io::stdin().lines() {
        let line = line.unwrap();
        let mut words = line.split(' ');
        let name = words.next().unwrap();
        let values: Vec<f64> = words
            .map(|word| f64::from_bits(u64::from_str_radix(word, 16).unwrap()))
            .collect();
        if name == "angles" {
            let inputs = at_angles(&values);
            let words: Vec<String> = inputs.iter().map(|value| format!("{:x}", value.to_bits())).collect();
            println!("{}", words.join(" "));
            continue;
        }
        let answers = match name {
            "rod" => answer_rod(&values),
            "determinant" => answer_determinant(&values),
            "quadratic_form" => answer_quadratic_form(&values),
            "match" => answer_match(&values),
            // The root of this crate against that of the standard library.
            "root" => vec![(<f64 as Arithmetic>::square_root(values[0]), values[0].sqrt())],
            _ => panic!("{name}"),
        };
        let answers: Vec<String> = answers
            .iter()
            .map(|(value, error)| format!("{:x} {:x}", value.to_bits(), error.to_bits()))
            .collect();
        println!("{}", answers.join(" "));
    }
}
