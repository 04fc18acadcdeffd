//! The maps of validity against comparisons of the cases that their places stand for.

use sextic::report::validity_figure::map;
use sextic::stability::case::Case;
use sextic::stability::closed_form::Estimate;
use sextic::stability::coefficient_table::CoefficientTable;
use sextic::stability::comparison::{Comparison, Point, compare};
use sextic::stability::interpolation::CoefficientCurves;
use sextic::stability::validity::{Departure, Form, TOLERANCE, Validity, validity};

use super::cases::{read, shipped, shipped_case};

fn of(name: &str, edits: &[(&str, &str)]) -> (Case, CoefficientTable, Validity) {
    let (case, table) = shipped_case(name, edits);
    let validity = validity(&case, &table).expect("a map");
    (case, table, validity)
}

/// The case, perfectly tuned and undamped, with another eccentricity and wind.
fn compared(case: &Case, table: &CoefficientTable, [e, wind]: [f64; 2]) -> Comparison {
    let mut case = case.clone();
    let p = &mut case.parameters;
    let omega = p.natural_frequencies[1];
    (p.natural_frequencies, p.damping_ratios) = ([omega; 3], [0.0; 3]);
    p.mass_centre_distance = e * p.radius_of_gyration;
    p.wind_speed = wind * 2.0 * p.mass * omega / (p.air_density * p.reference_dimension);
    compare(&case, table).expect("an answer")
}

/// The largest error of S over |S_a| and its angle, and at how many angles its sign is wrong.
fn departure(
    comparison: &Comparison,
    table: &CoefficientTable,
    of: impl Fn(&Point) -> &Estimate,
) -> Departure {
    let case = &comparison.case;
    let curves = CoefficientCurves::new(table, case.interpolation).expect("curves");
    let mut found = Departure {
        error: 0.0,
        angle: comparison.points[0].angle,
        wrong_signs: 0,
        open_signs: 0,
        answers: comparison.points.len(),
    };
    for point in &comparison.points {
        let coefficients = curves.at(point.angle).expect("an angle of the table");
        let section = case.section(point.angle, coefficients).expect("a section");
        let (own, exact) = (of(point).value.expect("it applies"), point.exact.value);
        let error = (own - exact).abs() / section.scaled_damping_norm();
        if error > found.error {
            (found.error, found.angle) = (error, point.angle);
        }
        found.wrong_signs += usize::from((own < 0.0) != (exact < 0.0));
    }
    found
}

#[test]
fn places_of_the_map_are_the_cases_that_they_stand_for() {
    for name in ["light.toml", "detuned.toml"] {
        let (case, table, validity) = of(name, &[]);
        assert_eq!(validity.angles, 361, "{name}");
        for (row, column) in [(3, 5), (15, 30), (20, 2), (28, 12), (32, 44)] {
            let (e, wind) = (validity.eccentricities[column], validity.winds[row]);
            let cell = validity.cells[row * validity.eccentricities.len() + column];
            let comparison = compared(&case, &table, [e, wind]);
            for (form, estimate) in [
                (
                    Form::Closed,
                    (|point| &point.closed) as fn(&Point) -> &Estimate,
                ),
                (Form::UniformSecond, |point| &point.uniform),
            ] {
                let own = cell[form as usize];
                let expected = departure(&comparison, &table, estimate);
                // L_g and U are rounded otherwise.
                let rounding = 1e-8 * expected.error + 1e-13 / wind;
                assert!(
                    (own.error - expected.error).abs() <= rounding,
                    "{name} {form:?} {e} {wind}: {own:?} {expected:?}"
                );
                assert_eq!(own.wrong_signs, expected.wrong_signs);
                assert_eq!(own.answers, expected.answers);
                assert!(own.angle == expected.angle || expected.error < 1e-9);
            }
        }
    }
}

#[test]
fn errors_have_the_orders_that_are_derived() {
    let (_, _, validity) = of("light.toml", &[]);
    let columns = validity.eccentricities.len();
    // Winds about ten times apart; the eccentricity is well above the damping, and not near 1.
    let apart = 8;
    let ratio = validity.winds[apart] / validity.winds[0];
    for (form, order, rows) in [
        (Form::Closed, 2, [2, 10]),
        (Form::UniformFirst, 2, [10, 18]),
        (Form::UniformSecond, 2, [16, 24]),
    ] {
        let column = columns * 3 / 4;
        let [low, high] = rows.map(|row| validity.cells[row * columns + column][form as usize]);
        let found = (high.error / low.error).ln() / ratio.ln();
        assert!((found - f64::from(order)).abs() < 0.1, "{form:?}: {found}");
        // It is the largest of all angles of the case.
        let constant = validity.constant(form);
        assert!(constant < 0.2, "{form:?}: {constant}");
    }
}

#[test]
fn what_is_known_of_the_lightly_iced_cable_is_on_its_map() {
    let (case, table, validity) = of("light.toml", &[]);
    let [closed, first, second] = validity.own_departures.map(|own| own.expect("it applies"));
    assert!(closed.error > 0.1 && first.error < 2e-3 && second.error < 1e-6);
    assert_eq!(
        [closed, first, second].map(|own| own.wrong_signs > 0),
        [true, false, false]
    );
    // Just within its reach the closed form has the error that is allowed, and beyond it more.
    let (least, speed) = (
        validity.least_eccentricity.expect("a reach"),
        validity.largest_wind.expect("a reach"),
    );
    let [e, wind] = validity.own;
    for (within, beyond) in [
        ([least, wind], [least * 0.9, wind]),
        ([e, speed], [e, speed * 1.1]),
    ] {
        let error = |place| {
            let comparison = compared(&case, &table, place);
            departure(&comparison, &table, |point| &point.closed).error
        };
        assert!(error(within) <= TOLERANCE && error(beyond) > TOLERANCE);
    }
}

#[test]
fn without_eccentricity_there_is_a_map() {
    let (_, _, validity) = of("light.toml", &[("L_g = 0.000178 ", "L_g = 0 ")]);
    assert_eq!(validity.own[0], 0.0);
    assert_eq!(validity.largest_wind, None);
    assert!(map(&validity).svg().is_ok_and(|svg| !svg.contains("NaN")));
}

#[test]
fn the_map_is_that_of_the_command() {
    let (_, _, validity) = of("light.toml", &[]);
    let svg = map(&validity).svg().expect("a figure");
    assert!(
        svg == read(&shipped().join("light.svg")),
        "derivations/cases/light.svg is old: draw it again as docs/sections.md says"
    );
}

#[test]
fn held_coordinates_and_calm_air_have_no_map() {
    for (old, new, message) in [
        ("U = 9 ", "U = 0 ", "there is no wind"),
        ("U = 9 ", "U = 1e-9 ", "the wind is so weak"),
        (
            "zeta_theta = 0",
            "zeta_theta = 0\nfree = [\"y\"]",
            "whose x, y and theta are free, and not all are",
        ),
    ] {
        let (case, table) = shipped_case("light.toml", &[(old, new)]);
        let error = validity(&case, &table).expect_err("no map").to_string();
        assert!(error.contains(message), "{error}");
    }
}
