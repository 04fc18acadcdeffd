//! Inputs that are fixed, and inputs that are sines and cosines.

use sextic_codegen::evaluator::{Circular, Evaluator, Fixed, Function, Origin};
use sextic_codegen::language::{Error, Language, emit};
use sextic_codegen::program::Rational;

use crate::samples;

/// What is refused, and why: by a change of the rod.
#[test]
fn what_is_fixed_must_have_a_value_and_angles_must_be_known() {
    type Change = fn(&mut Evaluator);
    let fixed = |value: Rational| {
        let text = String::new();
        Origin::Fixed(Fixed { value, text })
    };
    let table: [(Change, Error); 8] = [
        (
            |rod| set(rod, 0, Rational::from(-2)),
            Error::Fixed("rod".into()),
        ),
        (
            |rod| set(rod, 0, Rational::from(-1)),
            Error::Fixed("rod".into()),
        ),
        (
            |rod| {
                set(rod, 0, Rational::from(10).pow(308));
                set(rod, 4, Rational::from(10).pow(308));
            },
            Error::Fixed("rod".into()),
        ),
        (
            |rod| set(rod, 4, Rational::from(10).pow(-400)),
            Error::Constant(Rational::from(10).pow(-400).to_string()),
        ),
        (
            |rod| rod.angles.truncate(2),
            Error::Quantities("rod".into()),
        ),
        (
            |rod| {
                rod.inputs[3].origin = Origin::Circular(sum(&[]));
            },
            Error::Quantities("rod".into()),
        ),
        (
            |rod| {
                rod.inputs[3].origin = Origin::Circular(sum(&[(0, "beta")]));
            },
            Error::Quantities("rod".into()),
        ),
        (
            |rod| {
                // Asked for and fixed.
                rod.angles[0].quantity.name = "L".into();
                rod.inputs[3].origin = Origin::Circular(sum(&[(1, "L")]));
                rod.inputs[5].origin = Origin::Circular(sum(&[(1, "L")]));
            },
            Error::Quantities("rod".into()),
        ),
    ];
    for language in Language::ALL {
        for (place, (change, error)) in table.iter().enumerate() {
            let mut rod = samples::rod();
            change(&mut rod);
            let found = emit(&[rod], language).err();
            assert_eq!(found.as_ref(), Some(error), "{place}");
        }
        // Of a function of nothing nothing is asked, also no angles.
        let mut rod = samples::rod();
        for input in &mut rod.inputs {
            input.origin = fixed(Rational::ONE);
        }
        let files = emit(&[rod], language).unwrap();
        let rod = files.iter().find(|file| file.path.starts_with("rod."));
        let text = &rod.unwrap().text.to_lowercase();
        assert!(!text.contains("angles") && !text.contains("rodinputs"));
    }
}

fn set(rod: &mut Evaluator, place: usize, value: Rational) {
    let text = String::new();
    rod.inputs[place].origin = Origin::Fixed(Fixed { value, text });
}

fn sum(parts: &[(i32, &str)]) -> Circular {
    let parts = parts.iter();
    Circular {
        function: Function::Sine,
        angle: parts
            .map(|(count, name)| (*count, (*name).to_owned()))
            .collect(),
    }
}

#[test]
fn an_angle_that_is_an_input_too_is_asked_for_once() {
    // L is an angle now, and beta has the name of a function that C has.
    let mut rod = samples::rod();
    rod.angles[1].quantity.name = "L".into();
    rod.angles[2].quantity.name = "cos".into();
    for (place, parts) in [
        (3, sum(&[(1, "alpha_g"), (1, "L")])),
        (5, sum(&[(-1, "L"), (-3, "cos")])),
        (6, sum(&[(-2, "cos")])),
    ] {
        rod.inputs[place].origin = Origin::Circular(parts);
    }
    for (language, path, lines) in [
        (
            Language::Rust,
            "rod.rs",
            [
                "L: angles.L,",
                "sin_alpha_g_plus_theta_0: (-L - 3.0 * cos).sin(),",
            ],
        ),
        (
            Language::C,
            "rod.c",
            [
                ".L = angles->L,",
                ".sin_alpha_g_plus_theta_0 = sin(-L - 3.0 * cos_),",
            ],
        ),
        (
            Language::Python,
            "rod.py",
            ["L=L,", "sin_alpha_g_plus_theta_0=np.sin(-L - 3.0 * cos),"],
        ),
    ] {
        let files = emit(std::slice::from_ref(&rod), language).unwrap();
        let text = &files.iter().find(|file| file.path == path).unwrap().text;
        for line in lines {
            let count = text.lines().filter(|own| own.trim() == line).count();
            assert_eq!(count, 1, "{line} in {text}");
        }
    }
}
