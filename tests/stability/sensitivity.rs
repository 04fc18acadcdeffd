//! Where structural damping does harm, against differences of the eigenvalues.

use sextic::stability::coordinate::{Coordinate, FreeCoordinates};
use sextic::stability::model::Model;
use sextic::stability::section::{Coefficients, Parameters, Section};
use sextic::stability::sensitivity::weakened_by;
use sextic::stability::state_matrix;

use super::sections::{Numbers, section};

/// S, and what weakens the section.
fn stability(parameters: Parameters) -> (f64, Vec<(Coordinate, f64)>) {
    let section = Section::new(parameters).expect("a section");
    let model = Model::new(&section).expect("a model");
    let spectrum = state_matrix::eigenvalues(&model).expect("eigenvalues");
    let (value, _) = spectrum.damping_coefficient(&section).expect("wind");
    (value, weakened_by(&model, &spectrum))
}

fn more_damping(parameters: Parameters, coordinate: Coordinate, more: f64) -> Parameters {
    let mut damped = parameters;
    damped.damping_ratios[coordinate.index()] += more;
    damped
}

#[test]
fn slopes_are_those_of_differences() {
    const MORE: f64 = 1e-6;
    let mut numbers = Numbers::new(21);
    let mut harmful = 0;
    for _ in 0..300 {
        let usual = Parameters {
            aerodynamic_stiffness: numbers.between(0.0, 1.0) < 0.5,
            ..section(&mut numbers)
        };
        let (value, weakened) = stability(usual);
        for coordinate in Coordinate::ALL {
            let slope = weakened.iter().find(|(own, _)| *own == coordinate);
            let difference = (stability(more_damping(usual, coordinate, MORE)).0 - value) / MORE;
            match slope {
                Some((_, slope)) => {
                    harmful += 1;
                    assert!(
                        (difference - slope).abs() < 1e-3 * (1.0 + slope.abs()),
                        "{difference} {slope}"
                    );
                }
                None => assert!(difference > -1e-3, "{coordinate:?}: {difference}"),
            }
        }
    }
    assert!(harmful > 10, "{harmful}");
}

#[test]
fn the_counterexample_of_the_extensions_is_found() {
    let usual = section(&mut Numbers::new(22));
    let sway_and_heave = Parameters {
        free: FreeCoordinates::new(&[Coordinate::X, Coordinate::Y]).expect("two"),
        mass_centre_distance: 0.0,
        aerodynamic_centre_distance: 0.0,
        natural_frequencies: [6.0; 3],
        damping_ratios: [0.0; 3],
        wind_angle: 0.0,
        attitude: 0.0,
        wind_speed: 1.0,
        forces: Coefficients {
            drag: 1.0,
            lift: -1.0,
            drag_slope: 1.0,
            lift_slope: -2.0,
            ..Coefficients::default()
        }
        .into(),
        ..usual
    };
    let (value, weakened) = stability(sway_and_heave);
    assert!(value > 0.0, "stable without damping: {value}");
    // Its modes have one real part: first the damping of either motion helps, much of it does harm.
    let wind = sway_and_heave.air_density * sway_and_heave.reference_dimension
        / (2.0 * sway_and_heave.mass);
    let damped = more_damping(sway_and_heave, Coordinate::X, 3.0 * wind / (2.0 * 6.0));
    let (damped, of_damped) = stability(damped);
    assert!(damped < 0.0, "unstable with it: {damped}");
    assert!(weakened.is_empty() && of_damped.iter().any(|(own, _)| *own == Coordinate::X));
}
