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

/// The force across the section is ρDU² cos²α f(t)/2 with t = tan α and f = Σ a_k tᵏ (Parkinson & Smith 1964).
const FORCE: [(i32, f64); 4] = [(1, 2.69), (3, -168.0), (5, 6270.0), (7, -59900.0)];

/// f(t)
fn force(t: f64) -> f64 {
    FORCE.iter().map(|(k, a)| a * t.powi(*k)).sum()
}

/// S_1D without structural damping: −f′(t) cos α.
fn aerodynamic(angle: f64) -> f64 {
    let alpha = angle.to_radians();
    let slopes = FORCE
        .iter()
        .map(|(k, a)| f64::from(*k) * a * alpha.tan().powi(k - 1));
    -slopes.sum::<f64>() * alpha.cos()
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
        let alpha = row.angle.to_radians();
        let own = -(row.lift + row.drag * alpha.tan()) / alpha.cos();
        let expected = force(alpha.tan());
        assert!(
            (own - expected).abs() < 6e-7,
            "{own} {expected} at {}°",
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
    let expected = structural(&case) / FORCE[0].1;
    assert!(
        (critical.speed / expected - 1.0).abs() < 1e-4,
        "{critical:?} {expected}"
    );
}
