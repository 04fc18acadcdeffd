//! Critical wind speeds, against bisection and by hand.

use sextic::stability::coordinate::{Coordinate, FreeCoordinates};
use sextic::stability::critical_speed::{Stability, speeds};
use sextic::stability::eigenvalue::Spectrum;
use sextic::stability::exact_section::ExactSection;
use sextic::stability::model::Model;
use sextic::stability::section::{Coefficients, Parameters, Section};
use sextic::stability::state_matrix;

use super::sections::{Numbers, section};

const HIGHEST: f64 = 60.0;

fn spectrum(p: &Parameters, speed: f64) -> Spectrum {
    let section = Section::new(Parameters {
        wind_speed: speed,
        ..*p
    })
    .expect("a section");
    let spectrum = state_matrix::eigenvalues(&Model::new(&section).expect("a model"));
    spectrum.expect("eigenvalues")
}

/// The largest real part at a wind speed, and its error.
fn largest_real_part(p: &Parameters, speed: f64) -> (f64, f64) {
    spectrum(p, speed).largest_real_part()
}

/// The largest eigenvalue that is real.
fn largest_real_eigenvalue(p: &Parameters, speed: f64) -> Option<f64> {
    let spectrum = spectrum(p, speed);
    let real = spectrum
        .eigenvalues
        .iter()
        .filter(|own| own.value.im == 0.0);
    real.map(|own| own.value.re).max_by(f64::total_cmp)
}

/// Where the largest real part changes its sign, by bisection between the points of a grid.
fn by_bisection(p: &Parameters) -> Vec<f64> {
    let is_stable = |speed: f64| largest_real_part(p, speed).0 < 0.0;
    let grid: Vec<f64> = (1..=600)
        .map(|own| f64::from(own) * HIGHEST / 600.0)
        .collect();
    let changes = grid
        .windows(2)
        .filter(|pair| is_stable(pair[0]) != is_stable(pair[1]));
    let root = |pair: &[f64]| {
        let (mut low, mut high, below) = (pair[0], pair[1], is_stable(pair[0]));
        for _ in 0..50 {
            let middle = (low + high) / 2.0;
            match is_stable(middle) == below {
                true => low = middle,
                false => high = middle,
            }
        }
        (low + high) / 2.0
    };
    changes.map(root).collect()
}

fn lightly_damped(numbers: &mut Numbers) -> Parameters {
    let usual = section(numbers);
    let free = match numbers.between(0.0, 3.0) as usize {
        0 => FreeCoordinates::new(&[Coordinate::Y, Coordinate::Theta]).expect("two"),
        _ => FreeCoordinates::all(),
    };
    Parameters {
        natural_frequencies: [(); 3].map(|()| numbers.between(5.0, 7.0)),
        damping_ratios: [(); 3].map(|()| numbers.between(0.001, 0.02)),
        mass: numbers.scale(2.0, 20.0),
        aerodynamic_stiffness: numbers.between(0.0, 1.0) < 0.5,
        free,
        ..usual
    }
}

#[test]
fn critical_speeds_are_those_of_bisection() {
    let mut numbers = Numbers::new(51);
    let (mut roots, mut returns, mut divergent) = (0, 0, 0);
    for _ in 0..120 {
        let p = lightly_damped(&mut numbers);
        let section = Section::new(p).expect("a possible section");
        let found = speeds(&ExactSection::from(&section), HIGHEST);
        let critical = found.critical();
        for expected in by_bisection(&p) {
            let near = |own: f64| (own - expected).abs() < 1e-7 * HIGHEST;
            assert!(
                critical.iter().any(|own| near(own.speed)),
                "{expected} {found:?} {p:?}"
            );
        }
        for own in &critical {
            assert!(own.error < 1e-9, "{own:?}");
            roots += 1;
            returns += usize::from(own.becomes == Stability::Stable);
            divergent += usize::from(own.becomes == Stability::Divergent);
        }
        // What is said of a range is so within it.
        for range in &found.ranges {
            for part in [0.001, 0.3, 0.5, 0.999] {
                let speed = range.from + part * (range.to - range.from);
                let (largest, error) = largest_real_part(&p, speed);
                let is_wrong = match range.stability {
                    Stability::Stable => largest > error,
                    Stability::Unstable => largest < -error,
                    Stability::Divergent => largest_real_eigenvalue(&p, speed) <= Some(0.0),
                    Stability::Undecided => true,
                };
                assert!(!is_wrong, "{range:?} {largest} {p:?}");
            }
        }
        let (first, last) = (found.ranges.first(), found.ranges.last());
        assert_eq!(
            first.map(|own| (own.from, own.stability)),
            Some((0.0, Stability::Stable))
        );
        assert_eq!(last.map(|own| own.to), Some(HIGHEST));
    }
    assert!(
        roots > 40 && returns > 0 && divergent > 10,
        "{roots} roots, {returns} returns, {divergent} divergent"
    );
}

/// Heave alone: 2ωζ + ρDU/(2m) (C_D + C_L′) = 0.
#[test]
fn the_critical_speed_of_heave_alone_is_den_hartogs() {
    let p = Parameters {
        mass: 2.0,
        radius_of_gyration: 1.0,
        reference_dimension: 0.5,
        natural_frequencies: [0.0, 4.0, 0.0],
        damping_ratios: [0.0, 0.01, 0.0],
        air_density: 1.25,
        forces: Coefficients {
            drag: 1.0,
            lift_slope: -3.0,
            ..Coefficients::default()
        }
        .into(),
        free: FreeCoordinates::new(&[Coordinate::Y]).expect("one"),
        ..Parameters::default()
    };
    let section = Section::new(p).expect("a possible section");
    let found = speeds(&ExactSection::from(&section), 10.0);
    let [critical] = found.critical()[..] else {
        panic!("{found:?}");
    };
    let expected = 4.0 * 2.0 * 4.0 * 0.01 / (1.25 * 0.5 * 2.0);
    assert!((critical.speed - expected).abs() <= critical.error + 1e-15);
    assert_eq!(critical.becomes, Stability::Unstable);
    // Without structural damping it gallops at every speed, and without forces it is neutral.
    let undamped = Parameters {
        damping_ratios: [0.0; 3],
        ..p
    };
    let found = speeds(
        &ExactSection::from(&Section::new(undamped).expect("a section")),
        10.0,
    );
    assert_eq!(found.ranges.len(), 1);
    assert_eq!(found.ranges[0].stability, Stability::Unstable);
    let idle = Parameters {
        forces: Coefficients::default().into(),
        ..undamped
    };
    let found = speeds(
        &ExactSection::from(&Section::new(idle).expect("a section")),
        10.0,
    );
    assert!(found.is_neutral && found.ranges[0].stability == Stability::Undecided);
}

/// Perfectly tuned and centred, without structural damping: one motion is neutral at every speed, and the
/// determinants have roots that are not simple.
#[test]
fn what_is_neutral_at_every_speed_is_said() {
    let mut numbers = Numbers::new(53);
    let mut seen = [0; 2];
    for _ in 0..10 {
        let p = Parameters {
            natural_frequencies: [6.0; 3],
            damping_ratios: [0.0; 3],
            mass_centre_distance: 0.0,
            ..section(&mut numbers)
        };
        let found = speeds(
            &ExactSection::from(&Section::new(p).expect("a section")),
            HIGHEST,
        );
        assert!(found.is_neutral);
        let [range] = found.ranges[..] else {
            panic!("{found:?} {p:?}");
        };
        let (largest, error) = largest_real_part(&p, 10.0);
        let is_unstable = largest > error;
        assert_eq!(range.stability == Stability::Unstable, is_unstable);
        seen[usize::from(is_unstable)] += 1;
    }
    assert!(seen[0] > 0 && seen[1] > 0, "{seen:?}");
}

#[test]
fn speeds_that_make_no_sense_have_no_ranges() {
    let section = Section::new(section(&mut Numbers::new(3))).expect("a section");
    let section = ExactSection::from(&section);
    for highest in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(speeds(&section, highest).ranges.is_empty());
    }
    for highest in [1e-300, 1e300] {
        assert!(!speeds(&section, highest).ranges.is_empty());
    }
}
