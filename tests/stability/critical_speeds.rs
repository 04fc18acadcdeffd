//! Critical wind speeds, against bisection and by hand.

use sextic::stability::coordinate::{Coordinate, FreeCoordinates};
use sextic::stability::critical_speed::{Speeds, Stability, speeds};
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
        let critical = &found.critical;
        for expected in by_bisection(&p) {
            let near = |own: f64| (own - expected).abs() < 1e-7 * HIGHEST;
            assert!(
                critical.iter().any(|own| near(own.speed)),
                "{expected} {found:?} {p:?}"
            );
        }
        for own in critical {
            assert!(own.error < 1e-9, "{own:?}");
            // It stands between two ranges, which differ.
            let beside = found.ranges.windows(2).filter(|pair| {
                pair[0].to <= own.speed + own.error
                    && own.speed - own.error <= pair[1].from
                    && pair[1].from - pair[0].to <= 2.0 * own.error * (1.0 + 1e-9)
                    && pair[0].stability != pair[1].stability
                    && pair[1].stability == own.becomes
            });
            assert_eq!(beside.count(), 1, "{own:?} {found:?}");
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

fn of(p: Parameters, highest: f64) -> Speeds {
    let section = Section::new(p).expect("a possible section");
    speeds(&ExactSection::from(&section), highest)
}

fn stabilities(found: &Speeds) -> Vec<Stability> {
    found.ranges.iter().map(|own| own.stability).collect()
}

/// Heave alone.
fn heave(damping_ratio: f64) -> Parameters {
    Parameters {
        mass: 2.0,
        radius_of_gyration: 1.0,
        reference_dimension: 0.5,
        natural_frequencies: [0.0, 4.0, 0.0],
        damping_ratios: [0.0, damping_ratio, 0.0],
        air_density: 1.25,
        forces: Coefficients {
            drag: 1.0,
            lift_slope: -3.0,
            ..Coefficients::default()
        }
        .into(),
        free: FreeCoordinates::new(&[Coordinate::Y]).expect("one"),
        ..Parameters::default()
    }
}

/// 2ωζ + ρDU/(2m) (C_D + C_L′) = 0, however low that speed is beside the highest one.
#[test]
fn the_critical_speed_of_heave_alone_is_den_hartogs() {
    for (ratio, highest) in [
        (0.01, 10.0),
        (0.01, 2e12),
        (0.01, 1e30),
        (1e-6, 3e8),
        (1e-12, 100.0),
        (1e-25, 100.0),
    ] {
        let found = of(heave(ratio), highest);
        assert_eq!(
            stabilities(&found),
            [Stability::Stable, Stability::Unstable],
            "{ratio} {highest}: {found:?}"
        );
        let [critical] = found.critical[..] else {
            panic!("{found:?}");
        };
        let expected = 4.0 * 2.0 * 4.0 * ratio / (1.25 * 0.5 * 2.0);
        let distance = (critical.speed - expected).abs();
        assert!(distance <= critical.error + 1e-15 * expected);
        assert!(
            critical.error <= 1e-11 * expected,
            "{critical:?} {ratio} {highest}"
        );
        assert_eq!(critical.becomes, Stability::Unstable);
    }
    // Lower than 2⁻¹²⁰ of the highest speed: in no range.
    let found = of(heave(1e-25), 1e30);
    assert_eq!(stabilities(&found), [Stability::Unstable]);
    assert!(found.ranges[0].from > 1e-7 && found.ranges[0].from < 1e-6);
    let p = heave(0.01);
    // Without structural damping it gallops at every speed, and without forces it is neutral.
    let undamped = Parameters {
        damping_ratios: [0.0; 3],
        ..p
    };
    let found = of(undamped, 10.0);
    let [range] = found.ranges[..] else {
        panic!("{found:?}");
    };
    assert_eq!((range.from, range.stability), (0.0, Stability::Unstable));
    let idle = Parameters {
        forces: Coefficients::default().into(),
        ..undamped
    };
    let found = of(idle, 10.0);
    assert!(found.is_neutral && found.ranges[0].stability == Stability::Undecided);
    // The same with all coordinates free and coupled.
    let coupled = Parameters {
        natural_frequencies: [3.0, 4.0, 5.0],
        mass_centre_distance: 0.3,
        free: FreeCoordinates::all(),
        ..idle
    };
    let found = of(coupled, 10.0);
    assert!(found.is_neutral && found.ranges[0].stability == Stability::Undecided);
}

/// A determinant touches 0 where two roots are as far to the right as two others to the left: nothing changes.
#[test]
fn where_roots_mirror_each_other_nothing_changes() {
    let p = Parameters {
        mass: 3.5,
        radius_of_gyration: 0.0178,
        reference_dimension: 0.05,
        natural_frequencies: [std::f64::consts::TAU; 3],
        damping_ratios: [0.2, 0.0, 0.002],
        air_density: 1.25,
        attitude: 0.5_f64.to_radians(),
        forces: Coefficients {
            drag: 1.0 + 0.5_f64.to_radians(),
            lift: -1.0 - 2.0 * 0.5_f64.to_radians(),
            drag_slope: 1.0,
            lift_slope: -2.0,
            ..Coefficients::default()
        }
        .into(),
        ..Parameters::default()
    };
    let found = of(p, 100.0);
    assert_eq!(stabilities(&found), [Stability::Unstable], "{found:?}");
}

/// Over all sizes of damping and speed, as far as doubles know it.
#[test]
fn critical_speeds_of_any_size_are_those_of_bisection() {
    let mut numbers = Numbers::new(54);
    let mut roots = 0;
    for _ in 0..60 {
        let size = numbers.scale(1e-9, 1e-3);
        let usual = lightly_damped(&mut numbers);
        let p = Parameters {
            damping_ratios: usual.damping_ratios.map(|own| own * size),
            aerodynamic_stiffness: false,
            ..usual
        };
        let found = of(p, HIGHEST);
        let is_stable = |speed: f64| largest_real_part(&p, speed).0 < 0.0;
        for own in &found.critical {
            let [below, above] = [own.speed * (1.0 - 1e-3), own.speed * (1.0 + 1e-3)];
            assert_eq!(is_stable(above), own.becomes == Stability::Stable, "{p:?}");
            assert_ne!(is_stable(below), is_stable(above), "{own:?} {p:?}");
            roots += 1;
        }
        let speeds = (0..200).map(|own| HIGHEST * 10_f64.powf(f64::from(own) / 20.0 - 10.0));
        for speed in speeds {
            let range = found
                .ranges
                .iter()
                .find(|own| own.from <= speed && speed <= own.to);
            let (largest, error) = largest_real_part(&p, speed);
            let expected = match (largest < -error, largest > error) {
                (true, _) => Stability::Stable,
                (_, true) => Stability::Unstable,
                _ => continue,
            };
            assert_eq!(
                range.map(|own| own.stability),
                Some(expected),
                "{speed} {p:?}"
            );
        }
    }
    assert!(roots > 20, "{roots} roots");
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
    // From hardly any wind on, and beyond all winds: what is between is as it is with another highest speed.
    let usual = speeds(&section, 100.0);
    let vast = speeds(&section, 1e30);
    assert!(!usual.critical.is_empty());
    for (own, other) in usual.critical.iter().zip(&vast.critical) {
        assert!((own.speed - other.speed).abs() <= own.error + other.error);
    }
    let faint = speeds(&section, 1e-300);
    assert_eq!(stabilities(&faint), [Stability::Stable]);
}

/// Perfectly tuned and undamped, with the aerodynamic centre as far from the elastic centre as the radius of
/// gyration: one motion is neutral at every speed, with a frequency that is none of the natural ones.
#[test]
fn what_gallops_gallops_beside_a_neutral_motion() {
    let mut numbers = Numbers::new(57);
    let (mut critical, mut unstable, mut neutral) = (0, 0, 0);
    for _ in 0..12 {
        let turn = numbers.between(0.0, std::f64::consts::PI);
        let p = Parameters {
            mass: 3.0,
            radius_of_gyration: 0.02,
            mass_centre_distance: 0.004,
            aerodynamic_centre_distance: 0.02,
            reference_dimension: 0.06,
            natural_frequencies: [6.5; 3],
            air_density: 1.25,
            attitude: turn,
            forces: Coefficients {
                drag: 1.1,
                lift: turn.sin(),
                moment: 0.1 * (2.0 * turn).sin(),
                drag_slope: 0.7 * (2.0 * turn).sin(),
                lift_slope: numbers.between(-6.0, 1.0),
                moment_slope: 0.2 * (2.0 * turn).cos(),
            }
            .into(),
            ..Parameters::default()
        };
        let found = of(p, 100.0);
        assert!(found.is_neutral, "{p:?}");
        critical += found.critical.len();
        for range in &found.ranges {
            for part in [0.01, 0.5, 0.99] {
                let speed = range.from + part * (range.to - range.from);
                let (largest, error) = largest_real_part(&p, speed);
                match range.stability {
                    Stability::Unstable => assert!(largest > -error, "{range:?} {p:?}"),
                    Stability::Undecided => assert!(largest <= error, "{range:?} {p:?}"),
                    other => panic!("{other:?} {p:?}"),
                }
            }
            unstable += usize::from(range.stability == Stability::Unstable);
            neutral += usize::from(range.stability == Stability::Undecided);
        }
        assert_eq!(found.critical.len() + 1, found.ranges.len(), "{found:?}");
    }
    assert!(
        unstable > 0 && neutral > 0,
        "{critical} {unstable} {neutral}"
    );
}

/// The turn alone is neutral, with a stiffness that the wind changes, beside a heave that gallops.
#[test]
fn a_turn_that_nothing_damps_is_neutral_until_it_diverges() {
    let p = Parameters {
        radius_of_gyration: 0.5,
        natural_frequencies: [0.0, 4.0, 6.0],
        aerodynamic_stiffness: true,
        forces: Coefficients {
            // No lift that follows the turn, which would couple both.
            drag: -2.0,
            moment_slope: 0.8,
            ..Coefficients::default()
        }
        .into(),
        free: FreeCoordinates::new(&[Coordinate::Y, Coordinate::Theta]).expect("two"),
        ..heave(0.01)
    };
    let found = of(p, 100.0);
    assert!(found.is_neutral);
    assert_eq!(
        stabilities(&found),
        [
            Stability::Undecided,
            Stability::Unstable,
            Stability::Divergent
        ]
    );
    let galloping = 4.0 * 2.0 * 4.0 * 0.01 / (1.25 * 0.5 * 2.0);
    let diverging = (2.0 * 2.0 * 0.25 * 36.0 / (1.25 * 0.25 * 0.8_f64)).sqrt();
    for (own, expected) in found.critical.iter().zip([galloping, diverging]) {
        assert!((own.speed - expected).abs() < 1e-9, "{own:?} {expected}");
    }
}

/// The mass centre as far out as it can be, almost, so that little mass is left to one motion.
#[test]
fn no_critical_speed_is_lost_between_stable_and_unstable() {
    let mut numbers = Numbers::new(58);
    let mut seen = 0;
    for _ in 0..20 {
        let turn = numbers.between(0.0, 0.3);
        let p = Parameters {
            mass: 240.0,
            radius_of_gyration: 0.5,
            mass_centre_distance: 0.49975,
            aerodynamic_centre_angle: -0.7,
            reference_dimension: 1.8,
            natural_frequencies: [0.7, 0.95, 0.68],
            damping_ratios: [0.005, 0.01, 0.016],
            air_density: 1.25,
            attitude: turn,
            forces: Coefficients {
                drag: 0.3 + turn * turn,
                lift: -turn,
                moment: -0.2 * turn,
                drag_slope: numbers.between(0.0, 0.6),
                lift_slope: -1.0,
                moment_slope: *numbers.one_of(&[0.0, -0.4]),
            }
            .into(),
            ..Parameters::default()
        };
        let found = of(p, 100.0);
        let decided = found.ranges.windows(2).filter(|pair| {
            let kinds = [pair[0].stability, pair[1].stability];
            kinds[0] != kinds[1] && !kinds.contains(&Stability::Undecided)
        });
        assert_eq!(decided.count(), found.critical.len(), "{found:?}");
        assert_eq!(found.critical.len() + 1, found.ranges.len(), "{found:?}");
        for own in &found.critical {
            let [below, above] = [own.speed * (1.0 - 1e-6), own.speed * (1.0 + 1e-6)];
            let is_stable = |speed: f64| largest_real_part(&p, speed).0 < 0.0;
            assert_ne!(is_stable(below), is_stable(above), "{own:?} {p:?}");
            seen += 1;
        }
    }
    assert!(seen > 10, "{seen}");
}
