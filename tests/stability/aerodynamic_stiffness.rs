//! Aerodynamic stiffness, against differences of the forces, a state matrix written out, and by hand.

use nalgebra::{DMatrix, Matrix3, Vector3};
use sextic::stability::closed_form::closed_form;
use sextic::stability::coordinate::{Coordinate, FreeCoordinates};
use sextic::stability::critical_speed::{CriticalSpeed, Stability, speeds};
use sextic::stability::error::StabilityError;
use sextic::stability::exact_modes::{self, Fallback};
use sextic::stability::exact_section::ExactSection;
use sextic::stability::forces::Forces;
use sextic::stability::interpolation::CoefficientCurves;
use sextic::stability::limitation::Limitation;
use sextic::stability::model::Model;
use sextic::stability::section::{Coefficients, Parameters, Section};
use sextic::stability::validity::validity;
use sextic::stability::{companion, state_matrix};

use super::cases::shipped_case;
use super::sections::{Numbers, section};

/// Turns the option on in a case that comes with the project.
const ON: (&str, &str) = ("rho = 1.25", "rho = 1.25\naerodynamic_stiffness = true");

fn with_stiffness(p: Parameters) -> Parameters {
    Parameters {
        aerodynamic_stiffness: true,
        ..p
    }
}

fn model(p: Parameters) -> Model {
    Model::new(&Section::new(p).expect("a possible section")).expect("a model")
}

/// F_x, F_y and F_θ on a section at rest in the wind.
fn forces(p: &Parameters, c: Coefficients) -> Vector3<f64> {
    let pressure = p.air_density * p.reference_dimension * p.wind_speed.powi(2) / 2.0;
    let (sin, cos) = p.wind_angle.sin_cos();
    let along = Vector3::new(cos, sin, 0.0) * c.drag;
    let across = Vector3::new(-sin, cos, 0.0) * c.lift;
    let moment = Vector3::z() * (p.reference_dimension * c.moment);
    (along + across + moment) * pressure
}

#[test]
fn it_is_what_the_forces_of_a_table_lose_by_a_turn() {
    for turn in ["\"section\"", "\"wind\""] {
        let (case, table) = shipped_case("detuned.toml", &[ON, ("\"section\"", turn)]);
        let curves = CoefficientCurves::new(&table, case.interpolation).expect("curves");
        for angle in [3.0, 47.0, 100.0, 161.0] {
            let coefficients = |turned: f64| curves.at(angle + turned).expect("in the table");
            let section = case.section(angle, coefficients(0.0)).expect("a section");
            let p = section.parameters();
            let step = 0.01_f64;
            let difference = forces(p, coefficients(step)) - forces(p, coefficients(-step));
            let expected = -difference / (2.0 * step.to_radians());
            let found = Model::new(&section)
                .expect("a model")
                .aerodynamic_stiffness();
            assert_eq!(found.view((0, 0), (3, 2)), DMatrix::zeros(3, 2));
            for i in 0..3 {
                let error = (found[(i, 2)] - expected[i]).abs();
                assert!(
                    error < 1e-6 * expected.norm(),
                    "{angle}: {found} {expected}"
                );
            }
        }
    }
}

#[test]
fn eigenvalues_are_those_of_a_state_matrix_written_out() {
    let mut numbers = Numbers::new(71);
    for _ in 0..200 {
        let p = with_stiffness(section(&mut numbers));
        let Forces::Coefficients(c) = p.forces else {
            panic!("coefficients");
        };
        let (m, r, l_g) = (p.mass, p.radius_of_gyration, p.mass_centre_distance);
        let (s, k) = (p.mass_centre_angle + p.attitude).sin_cos();
        let mass = Matrix3::new(
            1.0,
            0.0,
            l_g * s,
            0.0,
            1.0,
            l_g * k,
            l_g * s,
            l_g * k,
            r * r,
        ) * m;
        let own = p.natural_frequencies;
        let stiffness = Vector3::new(
            m * own[0].powi(2),
            m * own[1].powi(2),
            m * (r * own[2]).powi(2),
        );
        let mut stiffness = Matrix3::from_diagonal(&stiffness);
        // C_L′ lifts it across the wind, and so on: the forces of slopes in place of coefficients.
        let slopes = Coefficients {
            drag: c.drag_slope,
            lift: c.lift_slope,
            moment: c.moment_slope,
            ..c
        };
        let turned = stiffness.column(2) - forces(&p, slopes);
        stiffness.set_column(2, &turned);
        let model = model(p);
        let damping = model.structural_damping() + model.aerodynamic_damping();
        let inverse = mass.try_inverse().expect("a mass");
        let mut state = DMatrix::zeros(6, 6);
        state.view_mut((0, 3), (3, 3)).fill_with_identity();
        state
            .view_mut((3, 0), (3, 3))
            .copy_from(&(-inverse * stiffness));
        state
            .view_mut((3, 3), (3, 3))
            .copy_from(&(-inverse * damping));
        let difference = &state - model.state_matrix();
        assert!(difference.norm() < 1e-12 * state.norm(), "{difference}");
        let expected = state.complex_eigenvalues();
        let size = expected.iter().map(|own| own.norm()).fold(0.0, f64::max);
        let spectra = [
            state_matrix::eigenvalues(&model).expect("eigenvalues"),
            companion::eigenvalues(&model).expect("eigenvalues"),
        ];
        for own in spectra.iter().flat_map(|spectrum| &spectrum.eigenvalues) {
            let distances = expected.iter().map(|other| (other - own.value).norm());
            let distance = distances.fold(f64::INFINITY, f64::min);
            assert!(distance <= 1e-9 * size + own.error, "{own:?} {expected}");
        }
    }
}

/// ρD²U²C_M′/2 = m r² ω_θ², with any offset of the mass centre: by hand, and by `derivations/extensions.md`.
#[test]
fn the_speed_of_divergence_is_that_of_the_turn_alone() {
    let usual = Parameters {
        mass: 4.0,
        radius_of_gyration: 0.3,
        reference_dimension: 0.5,
        natural_frequencies: [5.0, 6.0, 7.0],
        damping_ratios: [0.02; 3],
        air_density: 1.25,
        mass_centre_angle: 0.3,
        forces: Coefficients {
            drag: 1.0,
            moment_slope: 0.8,
            ..Coefficients::default()
        }
        .into(),
        aerodynamic_stiffness: true,
        ..Parameters::default()
    };
    let expected = 0.3 * 7.0 * (2.0 * 4.0 / (1.25 * 0.25 * 0.8_f64)).sqrt();
    let found = |p: Parameters| -> Vec<CriticalSpeed> {
        let section = Section::new(p).expect("a possible section");
        let found = speeds(&ExactSection::from(&section), 40.0);
        let is_decided =
            |own: Stability| own != Stability::Undecided || p.damping_ratios == [0.0; 3];
        assert!(
            found.ranges.iter().all(|own| is_decided(own.stability)),
            "{found:?}"
        );
        found.critical
    };
    for offset in [0.0, 0.1, 0.25] {
        let critical = found(Parameters {
            mass_centre_distance: offset,
            ..usual
        });
        let divergent = critical
            .iter()
            .filter(|own| own.becomes == Stability::Divergent);
        let [divergence] = divergent.collect::<Vec<_>>()[..] else {
            panic!("{critical:?}");
        };
        let distance = (divergence.speed - expected).abs();
        assert!(
            distance <= divergence.error + 1e-14 * expected,
            "{divergence:?} {expected}"
        );
    }
    // The turn alone without damping: neutral, until it diverges.
    let alone = Parameters {
        free: FreeCoordinates::new(&[Coordinate::Theta]).expect("one"),
        damping_ratios: [0.0; 3],
        ..usual
    };
    let section = Section::new(alone).expect("a possible section");
    let ranges = speeds(&ExactSection::from(&section), 40.0).ranges;
    let verdicts: Vec<Stability> = ranges.iter().map(|own| own.stability).collect();
    assert_eq!(verdicts, [Stability::Undecided, Stability::Divergent]);
    assert!((ranges[1].from - expected).abs() < 1e-10, "{ranges:?}");
    // Without the option nothing diverges, nor with a moment that turns back.
    for p in [
        Parameters {
            aerodynamic_stiffness: false,
            ..usual
        },
        Parameters {
            forces: Coefficients {
                drag: 1.0,
                moment_slope: -0.8,
                ..Coefficients::default()
            }
            .into(),
            ..usual
        },
    ] {
        assert!(
            found(p)
                .iter()
                .all(|own| own.becomes != Stability::Divergent)
        );
    }
}

#[test]
fn what_cannot_count_it_says_so() {
    let p = with_stiffness(section(&mut Numbers::new(73)));
    let exact = exact_modes::eigenvalues(&model(p)).expect("eigenvalues");
    assert_eq!(exact.fallback, Some(Fallback::AerodynamicStiffness));
    let state = state_matrix::eigenvalues(&model(p)).expect("eigenvalues");
    assert_eq!(exact.spectrum, state);

    let tuned = Parameters {
        natural_frequencies: [6.0; 3],
        ..p
    };
    let section = Section::new(tuned).expect("a section");
    let warnings = closed_form(&section).expect("it applies").warnings;
    assert!(
        warnings.contains(&Limitation::AerodynamicStiffness),
        "{warnings:?}"
    );

    let given = Section::new(Parameters {
        forces: Forces::ScaledDamping([[1.0; 3]; 3]),
        ..p
    });
    assert_eq!(given, Err(StabilityError::StiffnessWithoutCoefficients));

    let (case, table) = shipped_case("light.toml", &[ON]);
    let error = validity(&case, &table)
        .expect_err("it is refused")
        .to_string();
    assert!(error.contains("aerodynamic_stiffness"), "{error}");
}
