//! Modes are followed by their shapes, through crossings and through veering.

use sextic::stability::coordinate::{Coordinate, FreeCoordinates};
use sextic::stability::model::Model;
use sextic::stability::section::{Parameters, Section};
use sextic::stability::state_matrix;
use sextic::stability::tracking::{Mode, Place, follow, overlap};

use super::sections::{Numbers, section};

/// Heave and turn with the frequency of heave at 6 rad/s, without wind, and G off O by e r.
fn modes_at(omega_theta: f64, eccentricity: f64) -> (Model, Vec<Mode>) {
    modes_of(|usual| Parameters {
        natural_frequencies: [6.0, 6.0, omega_theta],
        mass_centre_distance: eccentricity * usual.radius_of_gyration,
        mass_centre_angle: -usual.attitude,
        ..usual
    })
}

/// Heave and turn without eccentricity and wind, with a damping ratio of heave.
fn modes_with(damping_ratio: f64) -> (Model, Vec<Mode>) {
    modes_of(|usual| Parameters {
        natural_frequencies: [6.0, 6.0, 5.0],
        damping_ratios: [0.0, damping_ratio, 0.01],
        mass_centre_distance: 0.0,
        ..usual
    })
}

/// The modes of heave and turn of a section without wind and damping, but for what is changed.
fn modes_of(change: impl Fn(Parameters) -> Parameters) -> (Model, Vec<Mode>) {
    let parameters = change(Parameters {
        free: FreeCoordinates::new(&[Coordinate::Y, Coordinate::Theta]).expect("two"),
        damping_ratios: [0.0; 3],
        wind_speed: 0.0,
        ..section(&mut Numbers::new(6))
    });
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
        let places = follow(&model, &before, &after).expect("few modes");
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
fn a_mode_goes_on_where_another_ends_or_begins() {
    // Heave oscillates, and does not any more; the turn is the second mode before and, by its frequency, the first after.
    let (pairs, reals) = (modes_with(0.999), modes_with(1.001));
    let [before, after] = [&pairs.1, &reals.1].map(|modes| modes.iter().collect::<Vec<_>>());
    assert_eq!((before.len(), after.len()), (2, 3));
    let turn = |modes: &[&Mode]| {
        modes
            .iter()
            .position(|own| (own.value.im - 5.0).abs() < 0.1)
    };
    let [old, new] = [&before, &after].map(|modes| turn(modes).expect("a turn"));
    let forth = follow(&reals.0, &before, &after).expect("few modes");
    assert_eq!(forth[old], new);
    assert!(forth[1 - old] < 3 && forth[1 - old] != new);
    // One of the two real ones ends.
    let back = follow(&pairs.0, &after, &before).expect("few modes");
    assert_eq!(back[new], old);
    let mut places = back.to_vec();
    places.sort_unstable();
    assert_eq!(places, [0, 1, 2]);
    assert_eq!(follow(&pairs.0, &[], &before).map(<[_]>::len), Some(0));
    assert_eq!(follow(&pairs.0, &[&pairs.1[0]; 7], &before), None);
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
            let place = Place {
                first: own.value,
                number: 0,
            };
            let alike = overlap(&model, &mode(None), &mode(Some(place)));
            assert!((alike - 1.0).abs() < 1e-9, "{alike} at {}", own.value);
        }
    }
}
