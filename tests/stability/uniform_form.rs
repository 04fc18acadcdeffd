//! The uniform form against the eigenvalues: at every eccentricity, tuned or not, damped or not.

use sextic::stability::closed_form::{ClosedForm, closed_form};
use sextic::stability::coordinate::{Coordinate, FreeCoordinates};
use sextic::stability::limitation::Limitation;
use sextic::stability::model::Model;
use sextic::stability::section::{Parameters, Section};
use sextic::stability::state_matrix;
use sextic::stability::uniform_form::uniform_form;

use super::sections::{Numbers, section};

/// A section with an eccentricity whose aerodynamic damping δ|S_a| has a given size.
fn model(usual: Parameters, eccentricity: f64, damping: f64) -> Model {
    let parameters = Parameters {
        mass_centre_distance: eccentricity * usual.radius_of_gyration,
        ..usual
    };
    let size = Section::new(parameters)
        .expect("a section")
        .relative_aerodynamic_damping();
    let parameters = Parameters {
        wind_speed: parameters.wind_speed * damping / size,
        ..parameters
    };
    Model::new(&Section::new(parameters).expect("a section")).expect("a model")
}

fn tuned(usual: Parameters) -> Parameters {
    Parameters {
        natural_frequencies: [6.0; 3],
        damping_ratios: [0.0; 3],
        ..usual
    }
}

/// The largest real part, over the size of the damping.
fn error(model: &Model, form: &ClosedForm) -> f64 {
    let (exact, bound) = state_matrix::eigenvalues(model)
        .expect("eigenvalues")
        .largest_real_part();
    let size = model.section().relative_aerodynamic_damping() * 6.0;
    ((form.largest_real_part() - exact).abs() - bound).max(0.0) / size
}

#[test]
fn what_it_leaves_out_is_of_the_third_order_at_every_eccentricity() {
    let mut numbers = Numbers::new(11);
    for kind in ["tuned", "detuned", "damped"] {
        for eccentricity in [0.0, 1e-6, 1e-3, 0.03, 0.3, 0.9] {
            for damping in [1e-4, 1e-3, 1e-2] {
                let mut worst = 0.0_f64;
                for _ in 0..50 {
                    let usual = section(&mut numbers);
                    let usual = match kind {
                        "tuned" => tuned(usual),
                        "detuned" => Parameters {
                            natural_frequencies: [6.0, 6.02, 5.97],
                            ..tuned(usual)
                        },
                        _ => Parameters {
                            damping_ratios: [damping, 0.0, damping / 3.0],
                            ..tuned(usual)
                        },
                    };
                    let model = model(usual, eccentricity, damping);
                    let form = uniform_form(&model).expect("it applies");
                    worst = worst.max(error(&model, &form));
                }
                let bound = 3.0 * damping * damping / (1.0 - eccentricity).powi(2) + 1e-10;
                assert!(
                    worst <= bound,
                    "{kind}, e = {eccentricity}, {damping}: {worst} > {bound}"
                );
            }
        }
    }
}

#[test]
fn it_is_right_where_the_closed_form_calls_stable_what_is_not() {
    let mut numbers = Numbers::new(12);
    let (mut wrong, mut certain) = (0, 0);
    for _ in 0..500 {
        // A lightly iced cable: L_g/r of 1 %, damping of the same size.
        let model = model(tuned(section(&mut numbers)), 0.01, 0.02);
        let (exact, bound) = state_matrix::eigenvalues(&model)
            .expect("eigenvalues")
            .largest_real_part();
        if exact.abs() <= bound + 1e-4 * 0.02 {
            continue;
        }
        certain += 1;
        let sign = |form: &ClosedForm| form.largest_real_part() > 0.0;
        let uniform = uniform_form(&model).expect("it applies");
        assert_eq!(sign(&uniform), exact > 0.0);
        let closed = closed_form(model.section()).expect("it applies");
        wrong += usize::from(sign(&closed) != (exact > 0.0));
        let is_named = |own: &Limitation| matches!(own, Limitation::Eccentricity { .. });
        assert!(closed.warnings.iter().any(is_named));
    }
    assert!(
        certain > 400 && wrong > certain / 50,
        "{wrong} of {certain}"
    );
}

#[test]
fn its_errors_are_bounded_for_the_section_at_hand() {
    let mut numbers = Numbers::new(13);
    for damping in [1e-4, 1e-2] {
        let model = model(tuned(section(&mut numbers)), 0.1, damping);
        let form = uniform_form(&model).expect("it applies");
        let exact = state_matrix::eigenvalues(&model).expect("eigenvalues");
        let bounds = state_matrix::error_bounds_of(&model, &form.eigenvalues);
        for ((own, other), bound) in form
            .eigenvalues
            .iter()
            .zip(exact.one_of_each_pair())
            .zip(bounds)
        {
            let bound = bound.expect("a bound");
            assert!((own - other.value).norm() <= bound + other.error);
            assert!(bound <= 100.0 * damping.powi(3) * 6.0, "{bound}");
        }
    }
}

#[test]
fn where_it_does_not_apply_or_damping_is_strong_is_said() {
    let usual = tuned(section(&mut Numbers::new(14)));
    let free = FreeCoordinates::new(&[Coordinate::Y]).expect("one");
    let held = model(Parameters { free, ..usual }, 0.1, 0.01);
    assert_eq!(uniform_form(&held), Err(Limitation::NotAllFree));
    let strong = model(usual, 0.1, 2.0);
    let warnings = uniform_form(&strong).expect("it applies").warnings;
    assert!(
        matches!(warnings[..], [Limitation::StrongDamping { .. }]),
        "{warnings:?}"
    );
}
