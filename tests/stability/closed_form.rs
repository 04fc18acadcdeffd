//! The closed forms against the eigenvalues, and where they do not apply.

use sextic::stability::closed_form::closed_form;
use sextic::stability::coordinate::{Coordinate, FreeCoordinates};
use sextic::stability::limitation::Limitation;
use sextic::stability::model::Model;
use sextic::stability::section::{Parameters, Section};
use sextic::stability::state_matrix;

use super::sections::{Numbers, section};

fn model(parameters: Parameters) -> Model {
    let section = Section::new(parameters).expect("a possible section");
    Model::new(&section).expect("a model")
}

/// Perfectly tuned, without structural damping.
fn tuned(numbers: &mut Numbers) -> Parameters {
    let usual = section(numbers);
    Parameters {
        natural_frequencies: [6.0; 3],
        damping_ratios: [0.0; 3],
        ..usual
    }
}

#[test]
fn closed_forms_are_the_eigenvalues_to_first_order() {
    let mut numbers = Numbers::new(4);
    for _ in 0..200 {
        let usual = tuned(&mut numbers);
        let parameters = Parameters {
            wind_speed: 1e-4,
            mass_centre_distance: 0.3 * usual.radius_of_gyration,
            ..usual
        };
        let model = model(parameters);
        let closed = closed_form(model.section()).expect("tuned and free");
        assert_eq!(closed.warnings, []);
        let exact = state_matrix::eigenvalues(&model).expect("eigenvalues");
        let size = 1e-4
            * closed
                .eigenvalues
                .iter()
                .map(|own| own.re.abs())
                .fold(1e-9, f64::max);
        for (own, other) in closed.eigenvalues.iter().zip(exact.one_of_each_pair()) {
            assert!(
                (own.re - other.value.re).abs() < size + other.error,
                "{own} {other:?}"
            );
            assert!((own.im - other.value.im).abs() < 1e-6, "{own} {other:?}");
        }
    }
}

#[test]
fn limitations_are_named() {
    let tuned = tuned(&mut Numbers::new(5));
    let free = FreeCoordinates::new(&[Coordinate::Y, Coordinate::Theta]).expect("two");
    let held = Parameters { free, ..tuned };
    assert_eq!(
        closed_form(model(held).section()),
        Err(Limitation::NotAllFree)
    );
    let detuned = Parameters {
        natural_frequencies: [6.0, 6.0, 6.1],
        ..tuned
    };
    assert_eq!(
        closed_form(model(detuned).section()),
        Err(Limitation::NotTuned)
    );
    let damped = Parameters {
        damping_ratios: [0.0, 0.01, 0.0],
        mass_centre_distance: 0.0,
        wind_speed: 0.1,
        ..tuned
    };
    let warnings = closed_form(model(damped).section())
        .expect("it applies")
        .warnings;
    assert_eq!(warnings[0], Limitation::StructuralDamping);
    assert!(matches!(
        warnings[1],
        Limitation::Eccentricity {
            eccentricity: 0.0,
            ..
        }
    ));
    assert_eq!(warnings.len(), 2);
    let hasty = Parameters {
        mass_centre_distance: (1.0 - 1e-9) * tuned.radius_of_gyration,
        ..tuned
    };
    let warnings = closed_form(model(hasty).section())
        .expect("it applies")
        .warnings;
    let is_strong = |own: &Limitation| matches!(own, Limitation::StrongDamping { .. });
    assert!(warnings.iter().any(is_strong), "{warnings:?}");
}

/// Warnings are many enough: without one the sign is right; and not too many.
#[test]
fn without_a_warning_the_sign_is_right() {
    let mut numbers = Numbers::new(8);
    let (mut silent, mut wrong) = (0, 0);
    for _ in 0..100_000 {
        let usual = tuned(&mut numbers);
        let speed = 2.0 * usual.mass * usual.natural_frequencies[0]
            / (usual.air_density * usual.reference_dimension);
        let model = model(Parameters {
            mass_centre_distance: numbers.scale(1e-4, 0.999) * usual.radius_of_gyration,
            wind_speed: numbers.scale(1e-5, 0.03) * speed,
            damping_ratios: [0.0; 3],
            ..usual
        });
        let exact = state_matrix::eigenvalues(&model).expect("eigenvalues");
        let (exact, bound) = exact.largest_real_part();
        let form = closed_form(model.section()).expect("it applies");
        let is_wrong = exact.abs() > bound && (form.largest_real_part() > 0.0) != (exact > 0.0);
        if form.warnings.is_empty() {
            assert!(!is_wrong, "{:?}", model.section());
            silent += 1;
        }
        wrong += usize::from(is_wrong);
    }
    assert!(
        silent > 40_000 && wrong > 5_000,
        "{silent} silent, {wrong} wrong"
    );
}
