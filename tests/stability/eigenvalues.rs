//! No section hangs, and no eigenvalue is farther from the exact one than it says.

use sextic::stability::companion;
use sextic::stability::eigenvalue::{Eigenvalue, Spectrum};
use sextic::stability::error::StabilityError;
use sextic::stability::exact_modes;
use sextic::stability::model::Model;
use sextic::stability::section::{Parameters, Section};
use sextic::stability::state_matrix;

use super::oracle::{Long, characteristic_polynomial, permutations, roots};
use super::sections::{KINDS, Numbers, hard_section, section};

/// How far the long arithmetic may be from an eigenvalue that stands three times, as a share of it.
const ORACLE: f64 = 1e-26;

/// The largest ratio of distance to stated error under the best assignment of exact eigenvalues.
pub fn exceeds(computed: &[Eigenvalue], exact: &[Long]) -> f64 {
    assert_eq!(computed.len(), exact.len());
    let ratio = |i: usize, j: usize| {
        let value = computed[i].value;
        let bound = computed[i].error + ORACLE * value.norm();
        exact[j].distance(value.re, value.im) / bound
    };
    let all = permutations(exact.len())
        .into_iter()
        .map(|(permutation, _)| {
            (0..exact.len())
                .map(|i| ratio(i, permutation[i]))
                .fold(0.0, f64::max)
        });
    all.fold(f64::INFINITY, f64::min)
}

fn is_as_exact_as_it_says(
    seed: u64,
    points: usize,
    eigenvalues: fn(&Model) -> Result<Spectrum, StabilityError>,
) {
    for kind in KINDS {
        let mut numbers = Numbers::new(seed);
        let (mut worst_ratio, mut worst_error) = (0.0_f64, 0.0_f64);
        for _ in 0..points {
            let parameters = hard_section(kind, &mut numbers);
            let section = Section::new(parameters).expect("a possible section");
            let model = Model::new(&section).expect("a model");
            let spectrum = eigenvalues(&model)
                .unwrap_or_else(|error| panic!("{kind}: {error} {parameters:?}"));
            let exact = roots(&characteristic_polynomial(&parameters));
            let ratio = exceeds(&spectrum.eigenvalues, &exact);
            assert!(ratio <= 1.0, "{kind}: {ratio} {parameters:?} {spectrum:?}");
            worst_ratio = worst_ratio.max(ratio);
            let size = spectrum.eigenvalues[0].value.norm();
            let errors = spectrum.eigenvalues.iter().map(|own| own.error / size);
            worst_error = errors.fold(worst_error, f64::max);
        }
        println!("{kind}: distance/bound at most {worst_ratio:.3}, bound {worst_error:.2e}");
    }
}

#[test]
fn eigenvalues_of_the_state_matrix_are_as_exact_as_they_say() {
    is_as_exact_as_it_says(1, 50, state_matrix::eigenvalues);
}

#[test]
fn roots_of_the_characteristic_polynomial_are_as_exact_as_they_say() {
    is_as_exact_as_it_says(2, 50, companion::eigenvalues);
}

#[test]
fn eigenvalues_for_tables_are_as_exact_as_they_say() {
    is_as_exact_as_it_says(5, 50, exact_modes::eigenvalues_for_tables);
}

#[test]
fn exact_modes_are_as_exact_as_they_say() {
    is_as_exact_as_it_says(4, 50, |model| {
        exact_modes::eigenvalues(model).map(|modes| modes.spectrum)
    });
}

#[test]
fn both_ways_agree_within_their_bounds_and_none_hangs() {
    for kind in KINDS {
        let mut numbers = Numbers::new(3);
        for _ in 0..2000 {
            let section = Section::new(hard_section(kind, &mut numbers)).expect("a section");
            let model = Model::new(&section).expect("a model");
            let (one, other) = (
                state_matrix::eigenvalues(&model),
                companion::eigenvalues(&model),
            );
            let (one, other) = (one.expect("eigenvalues"), other.expect("roots"));
            let (a, a_error) = one.largest_real_part();
            let (b, b_error) = other.largest_real_part();
            assert!(
                (a - b).abs() <= a_error + b_error,
                "{kind}: {a} and {b} at {section:?}"
            );
            let worst = one
                .eigenvalues
                .iter()
                .map(|own| own.error / own.value.norm());
            let is_defective = kind == "tuned, critically damped";
            assert!(
                is_defective || worst.fold(0.0, f64::max) < 1e-6,
                "{kind}: {one:?}"
            );
        }
    }
}

#[test]
fn wind_that_is_hardly_a_number_is_out_of_range() {
    let usual = section(&mut Numbers::new(31));
    let wind_speed = 1e-310;
    let section = Section::new(Parameters {
        wind_speed,
        ..usual
    });
    let section = section.expect("a section");
    // Its eigenvalues have bounds, but S, which is divided by it, has no digit.
    let model = Model::new(&section).expect("a model");
    let spectrum = state_matrix::eigenvalues(&model).expect("eigenvalues");
    assert_eq!(spectrum.damping_coefficient(&section), None);
}
