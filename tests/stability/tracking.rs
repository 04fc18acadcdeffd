//! Modes are followed by their shapes, through crossings and through veering.

use sextic::stability::coordinate::{Coordinate, FreeCoordinates};
use sextic::stability::model::Model;
use sextic::stability::section::{Parameters, Section};
use sextic::stability::state_matrix;
use sextic::stability::tracking::{Mode, follow, overlap};

use super::sections::{Numbers, section};

/// Heave and turn with the frequency of heave at 6 rad/s, without wind, and G off O by e r.
fn modes_at(omega_theta: f64, eccentricity: f64) -> (Model, Vec<Mode>) {
    let usual = section(&mut Numbers::new(6));
    let parameters = Parameters {
        free: FreeCoordinates::new(&[Coordinate::Y, Coordinate::Theta]).expect("two"),
        natural_frequencies: [6.0, 6.0, omega_theta],
        damping_ratios: [0.0; 3],
        wind_speed: 0.0,
        mass_centre_distance: eccentricity * usual.radius_of_gyration,
        mass_centre_angle: -usual.attitude,
        ..usual
    };
    let model = Model::new(&Section::new(parameters).expect("a section")).expect("a model");
    let spectrum = state_matrix::eigenvalues(&model).expect("eigenvalues");
    let of = |value| Mode::new(&model, value, None).expect("a shape");
    let modes = spectrum
        .one_of_each_pair()
        .map(|own| of(own.value))
        .collect();
    (model, modes)
}

/// The modes at the end that continue the first and the second one, over `steps` steps.
fn followed(eccentricity: f64, steps: usize) -> (Vec<Mode>, Vec<Mode>) {
    let start = modes_at(5.9, eccentricity).1;
    let mut now = start.clone();
    for step in 1..=steps {
        let (model, next) = modes_at(5.9 + 0.2 * step as f64 / steps as f64, eccentricity);
        let [before, after] = [&now, &next].map(|modes| modes.iter().collect::<Vec<_>>());
        let places = follow(&model, &before, &after).expect("as many modes");
        now = places.iter().map(|&place| next[place].clone()).collect();
    }
    (start, now)
}

#[test]
fn modes_that_cross_keep_their_shapes() {
    let (start, end) = followed(0.0, 41);
    let (model, _) = modes_at(6.1, 0.0);
    for (own, other) in start.iter().zip(&end) {
        assert!(overlap(&model, own, other) > 0.999999);
    }
    // Heave was the higher one, and is the lower one now.
    assert!(start[0].value.im > start[1].value.im && end[0].value.im < end[1].value.im);
}

#[test]
fn modes_that_veer_keep_their_order_in_small_steps_and_their_shapes_in_one() {
    let (start, end) = followed(0.002, 200);
    let (model, _) = modes_at(6.1, 0.002);
    assert!(end[0].value.im > end[1].value.im);
    assert!(overlap(&model, &start[0], &end[0]) < 0.1);
    let (start, end) = followed(0.002, 1);
    assert!(end[0].value.im < end[1].value.im);
    assert!(overlap(&model, &start[0], &end[0]) > 0.9);
}

#[test]
fn a_shape_is_the_same_by_the_adjugate_and_by_singular_values() {
    let mut numbers = Numbers::new(8);
    for _ in 0..200 {
        let section = Section::new(section(&mut numbers)).expect("a section");
        let model = Model::new(&section).expect("a model");
        for own in state_matrix::eigenvalues(&model)
            .expect("values")
            .one_of_each_pair()
        {
            let mode = |place| Mode::new(&model, own.value, place).expect("a shape");
            let alike = overlap(&model, &mode(None), &mode(Some(0)));
            assert!((alike - 1.0).abs() < 1e-9, "{alike} at {}", own.value);
        }
    }
}
