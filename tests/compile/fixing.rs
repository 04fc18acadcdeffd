//! Fixed quantities: by the algebra of the document, and by partial evaluation of the general program.

use std::collections::BTreeMap;

use sextic::compile::fixed::Fixed;
use sextic::compile::specification::{Refusal, Specification};
use sextic_codegen::arithmetic::rationals::evaluate_exactly;
use sextic_codegen::optimiser::specialise::specialise;
use sextic_codegen::program::{Program, Rational};

use super::{paper, specifications};

fn fixed(text: &str) -> Fixed {
    text.parse().expect("a quantity and its number")
}

/// A number of a name's own.
fn number(name: &str) -> Rational {
    let letters = name
        .bytes()
        .fold(7_u32, |sum, letter| 31 * sum % 1009 + u32::from(letter));
    Rational::from(letters) / Rational::from(100 + letters % 13)
}

/// The outputs of a program at such numbers, sines and cosines at points of the circle.
fn outputs(program: &Program) -> Vec<Option<Rational>> {
    let value = |name: &String| {
        let circular = name.strip_prefix("cos_").or(name.strip_prefix("sin_"));
        let Some(angle) = circular else {
            return number(name);
        };
        let tangent = number(angle);
        let square = &tangent * &tangent;
        let above = match name.starts_with("cos_") {
            true => Rational::ONE - &square,
            false => Rational::from(2) * tangent,
        };
        above / (Rational::ONE + square)
    };
    let inputs: Vec<Rational> = program.inputs().iter().map(value).collect();
    evaluate_exactly(program, &inputs)
}

#[test]
fn what_is_fixed_is_what_partial_evaluation_gives() {
    let audit = paper();
    let general = specifications(&audit);
    let evaluators = &audit.evaluators;
    let mut count = 0;
    for (evaluator, general) in evaluators.iter().zip(&general) {
        for name in ["zeta_x", "L_a", "C_M", "dC_L", "S_xy", "C_D", "m", "U"] {
            for value in ["0", "1", "-1"] {
                let fix = fixed(&format!("{name}={value}"));
                let special = match Specification::of(evaluator, &audit, std::slice::from_ref(&fix))
                {
                    Ok(special) => special,
                    // 0 < m, say.
                    Err(Refusal::Number(..)) => continue,
                    Err(refusal) => panic!("{name}={value}: {refusal:?}"),
                };
                if !general.rests_on(name) {
                    assert!(special.fixed.is_empty());
                    continue;
                }
                let program = &general.evaluator.program;
                let partial = specialise(program, &BTreeMap::from([(name.to_owned(), fix.value)]));
                let expected = outputs(&partial);
                assert_eq!(
                    outputs(&special.evaluator.program),
                    expected,
                    "{}, {name}={value}",
                    general.evaluator.name
                );
                assert!(!special.rests_on(name), "{name} is gone");
                count += 1;
            }
        }
    }
    assert!(count > 60, "{count} programs only");
}

#[test]
fn other_numbers_are_constants_with_bounds() {
    let audit = paper();
    let evaluators = &audit.evaluators;
    let in_wind = evaluators
        .iter()
        .find(|known| known.name.ascii == "closed_form_in_wind");
    let in_wind = in_wind.expect("it is compiled");
    let fixes = ["r=0.0178", "alpha_g=-0.2094", "theta_0=0.1", "alpha_0=1/3"].map(fixed);
    let special = Specification::of(in_wind, &audit, &fixes).expect("all are allowed");
    let names: Vec<&str> = special
        .constants
        .iter()
        .map(|known| known.name.as_str())
        .collect();
    assert_eq!(
        names,
        [
            "r",
            "cos_alpha_0",
            "sin_alpha_0",
            "cos_alpha_g_plus_theta_0",
            "sin_alpha_g_plus_theta_0",
        ]
    );
    for constant in &special.constants {
        assert!(constant.lower <= constant.upper);
        assert!(
            special
                .inputs
                .iter()
                .all(|(name, _)| *name != constant.name)
        );
    }
    // γ_r + θ_0 is not known without γ_r.
    assert!(
        special
            .inputs
            .iter()
            .any(|(name, _)| name == "cos_gamma_r_plus_theta_0")
    );
}

#[test]
fn fixing_at_zero_moves_the_functions_with_the_angle() {
    let audit = paper();
    let evaluators = &audit.evaluators;
    let [general, along_x] = [
        "characteristic_polynomial",
        "characteristic_polynomial_along_x",
    ]
    .map(|name| {
        evaluators
            .iter()
            .find(|known| known.name.ascii == name)
            .expect("compiled")
    });
    let fixed_along_x = Specification::of(general, &audit, &[fixed("alpha_0=0")]);
    let fixed_along_x = fixed_along_x.expect("it is allowed");
    let written = Specification::of(along_x, &audit, &[]).expect("it is compiled");
    assert_eq!(fixed_along_x.outputs, written.outputs);
    assert_eq!(fixed_along_x.evaluator.program, written.evaluator.program);
}
