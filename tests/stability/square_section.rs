//! The square section, whose answers are known in closed form.

use std::f64::consts::TAU;

use sextic::stability::case::Case;
use sextic::stability::coefficient_table::CoefficientTable;
use sextic::stability::coefficient_table::remarks::remarks;
use sextic::stability::comparison::compare;
use sextic::stability::critical_speed::{Stability, speeds_of};

use super::cases::shipped_case;

fn square() -> (Case, CoefficientTable) {
    shipped_case("square.toml", &[])
}

/// S_1D without structural damping, as the force across the section has it: with t = tan α and the force
/// ρDU² cos²α f(t)/2, f = 2.69 t − 168 t³ + 6270 t⁵ − 59900 t⁷ (Parkinson & Smith 1964), it is −f′(t) cos α.
fn aerodynamic(angle: f64) -> f64 {
    let (sine, cosine) = angle.to_radians().sin_cos();
    let t = sine / cosine;
    let slope =
        2.69 - 3.0 * 168.0 * t.powi(2) + 5.0 * 6270.0 * t.powi(4) - 7.0 * 59900.0 * t.powi(6);
    -slope * cosine
}

/// 4mω_yζ_y/(ρD), in m/s: what structural damping adds to S_1D at 1 m/s.
fn structural(case: &Case) -> f64 {
    let p = &case.parameters;
    let damping = p.natural_frequencies[1] * p.damping_ratios[1];
    4.0 * p.mass * damping / (p.air_density * p.reference_dimension)
}

/// −(C_L + C_D tan α)/cos α = f(tan α)
#[test]
fn its_table_is_that_of_its_formula() {
    let (_, table) = square();
    assert!(remarks(&table).is_empty());
    assert_eq!(table.rows().len(), 65);
    for row in table.rows() {
        let (sine, cosine) = row.angle.to_radians().sin_cos();
        let t = sine / cosine;
        let force = 2.69 * t - 168.0 * t.powi(3) + 6270.0 * t.powi(5) - 59900.0 * t.powi(7);
        let own = -(row.lift + row.drag * t) / cosine;
        assert!(
            (own - force).abs() < 6e-7,
            "{own} {force} at {}°",
            row.angle
        );
        assert_eq!((row.drag, row.moment), (2.05, 0.0));
    }
}

#[test]
fn its_damping_is_the_slope_of_the_force_across_it() {
    let (case, table) = square();
    assert!((case.parameters.natural_frequencies[1] - 6.0 * TAU).abs() < 1e-12);
    let comparison = compare(&case, &table).expect("an answer");
    assert_eq!(comparison.points.len(), 121);
    for point in &comparison.points {
        let added = structural(&case) / case.parameters.wind_speed;
        let expected = aerodynamic(point.angle) + added;
        let difference = (point.exact.value - expected).abs();
        // A spline of six decimals; it is coarser near the ends of the table.
        let allowed = if point.angle.abs() > 13.0 {
            0.02
        } else {
            0.001
        };
        assert!(difference < allowed, "{difference} at {}°", point.angle);
    }
}

/// Glauert and Den Hartog: U = 4mω_yζ_y/(ρD A_1).
#[test]
fn its_critical_speed_is_that_of_den_hartog() {
    let (mut case, table) = square();
    case.angles.from = 0.0;
    case.angles.to = 0.0;
    let found = speeds_of(&case, &table, 20.0).expect("speeds");
    let [(_, speeds)] = found.as_slice() else {
        panic!("{found:?}")
    };
    let [critical] = speeds.critical.as_slice() else {
        panic!("{speeds:?}")
    };
    assert_eq!(critical.becomes, Stability::Unstable);
    let expected = structural(&case) / 2.69;
    assert!(
        (critical.speed / expected - 1.0).abs() < 1e-4,
        "{critical:?} {expected}"
    );
}
