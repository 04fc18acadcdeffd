//! The mean twist, against a search in small steps, closed forms, and sections that were turned by hand.

use proptest::prelude::*;
use sextic::stability::axis::Axis;
use sextic::stability::case::Case;
use sextic::stability::coefficient_table::CoefficientTable;
use sextic::stability::coefficient_table::reading::Reading;
use sextic::stability::comparison::{Point, compare};
use sextic::stability::critical_speed::speeds_of;
use sextic::stability::grid::{Grid, Methods, Rows};
use sextic::stability::interpolation::{CoefficientCurves, Interpolation};
use sextic::stability::mean_twist::{BOUND, NoTwist, Twist};
use sextic::stability::sections::Sections;
use sextic::stability::validity::validity;
use sextic::stability::variable::Variable;
use sextic::stability::verdict::{Doubt, Verdict};

use super::cases::{read, shipped};

/// `detuned.toml` with a mean twist and edits.
fn case(edits: &[(&str, &str)]) -> Case {
    let text = read(&shipped().join("detuned.toml"));
    let on = ("rho = 1.25", "rho = 1.25\nmean_twist = true");
    let edits = std::iter::once(&on).chain(edits);
    let text = edits.fold(text, |text, (old, new)| {
        assert!(text.contains(old), "{old}");
        text.replace(old, new)
    });
    Case::read("case.toml", &text).expect("a case")
}

fn formulas() -> CoefficientTable {
    let text = read(&shipped().join("formulas.csv"));
    CoefficientTable::read("formulas.csv", &text).expect("a table")
}

/// Rad of twist for a moment coefficient of 1, by hand.
fn softness(case: &Case) -> f64 {
    let p = &case.parameters;
    let spring = p.mass * p.radius_of_gyration.powi(2) * p.natural_frequencies[2].powi(2);
    0.5 * p.air_density * p.wind_speed.powi(2) * p.reference_dimension.powi(2) / spring
}

/// The first balance in small steps from no twist on, to where the moment turns, by bisection; and how many there are.
fn by_steps(softness: f64, moment: &dyn Fn(f64) -> Option<f64>) -> (Option<f64>, usize) {
    let excess = |twist: f64| Some(twist - softness * moment(twist.to_degrees())?);
    let sign = if moment(0.0).expect("a moment") > 0.0 {
        1.0
    } else {
        -1.0
    };
    let step = 5e-4;
    let count = (std::f64::consts::PI / step) as i32;
    let root = |from: f64| {
        let (mut below, mut above) = (from, from + step);
        for _ in 0..60 {
            let middle = f64::midpoint(below, above);
            match (excess(middle) < Some(0.0)) == (excess(below) < Some(0.0)) {
                true => below = middle,
                false => above = middle,
            }
        }
        below
    };
    // No step begins at 0.
    let places: Vec<f64> = (-count..=count)
        .map(|own| (f64::from(own) + 0.123) * step)
        .collect();
    let is_below: Vec<bool> = places.iter().map(|own| excess(*own) < Some(0.0)).collect();
    let changes = (0..places.len() - 1).filter(|own| is_below[*own] != is_below[own + 1]);
    let roots: Vec<f64> = changes.map(|own| root(places[own])).collect();
    let ahead = roots.iter().copied().filter(|own| own * sign > 0.0);
    let first = ahead.min_by(|one, other| one.abs().total_cmp(&other.abs()));
    (first, roots.len())
}

fn twists(case: &Case, table: &CoefficientTable) -> Vec<(f64, Twist)> {
    let found = compare(case, table).expect("a comparison");
    found
        .points
        .iter()
        .map(|own| (own.angle, own.twist.expect("a twist")))
        .collect()
}

#[test]
fn twists_are_those_of_a_search_in_small_steps() {
    for (wind, interpolation) in [
        ("U = 2", "cubic"),
        ("U = 5", "cubic"),
        ("U = 7.5", "linear"),
        ("U = 8", "smooth"),
    ] {
        let step = ("step = 0.5", "step = 7");
        let case = case(&[
            ("U = 9", wind),
            ("\"cubic\"", &format!("\"{interpolation}\"")),
            step,
        ]);
        let table = formulas();
        let curves = CoefficientCurves::new(&table, case.interpolation).expect("curves");
        for (angle, found) in twists(&case, &table) {
            if angle == 0.0 {
                // Without a moment, exactly; a curve that is smoothed has hardly any.
                let exactly = (found.angle, found.error) == (0.0, 0.0);
                let nearly = found.angle.abs() < 1e-3 && found.error == BOUND;
                assert!(
                    if interpolation == "smooth" {
                        nearly
                    } else {
                        exactly
                    },
                    "{found:?}"
                );
                continue;
            }
            let moment =
                |degrees: f64| Some(curves.at(angle + degrees).expect("on the circle").moment);
            let (expected, count) = by_steps(softness(&case), &moment);
            let expected = expected.expect("a balance");
            assert!(
                (found.angle - expected).abs() < 1e-9,
                "{wind} {angle}: {found:?} {expected}"
            );
            assert_eq!(
                found.is_only,
                count == 1,
                "{wind} {angle}: {found:?} {count}"
            );
            assert_eq!(found.error, BOUND);
            let slope = curves
                .at(angle + found.angle.to_degrees())
                .expect("on the circle")
                .moment_slope;
            assert!(
                (found.stiffness - (1.0 - softness(&case) * slope)).abs() < 1e-6,
                "{wind} {angle}"
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]
    #[test]
    fn twists_of_any_table_are_those_of_a_search(
        heights in prop::collection::vec(-1.0..1.0_f64, 12),
        speed in 1.0..12.0_f64,
        is_linear in any::<bool>(),
    ) {
        let rows = heights.iter().enumerate();
        let rows = rows.map(|(place, own)| format!("{},0,1,{own:e}\n", 30 * place));
        let text = "alpha_deg,CL,CD,CM\n".to_string() + &rows.collect::<String>();
        let table = CoefficientTable::read("any.csv", &text).expect("a table");
        let interpolation = if is_linear { Interpolation::Linear } else { Interpolation::Cubic };
        let mut case = case(&[]);
        case.interpolation = interpolation;
        case.parameters.wind_speed = speed;
        let curves = CoefficientCurves::new(&table, interpolation).expect("curves");
        let sections = Sections::new(&case, &table).expect("sections");
        for angle in [3.0, 150.0, 240.5] {
            let moment = |degrees: f64| Some(curves.at(angle + degrees).expect("on the circle").moment);
            let (expected, count) = by_steps(softness(&case), &moment);
            match (sections.at(angle, &table), expected) {
                (Ok((_, Some(found))), Some(expected)) => {
                    prop_assert!((found.angle - expected).abs() < 1e-9, "{angle} {found:?} {expected}");
                    // Two that are closer than the steps are not seen by them.
                    prop_assert!(found.is_only == (count == 1) || !found.is_only, "{angle} {found:?} {count}");
                    let slope = curves.at(angle + found.angle.to_degrees()).expect("on the circle").moment_slope;
                    prop_assert!(is_linear || (found.stiffness - (1.0 - softness(&case) * slope)).abs() < 1e-6);
                }
                (Err(error), None) => prop_assert!(error.what.contains("half a turn"), "{error}"),
                // What is nearly a double root.
                (Err(error), Some(_)) => prop_assert!(error.what.contains("not certain"), "{error}"),
                (found, expected) => prop_assert!(false, "{angle}: {found:?} {expected:?}"),
            }
        }
    }
}

/// Where C_M = a + b α, θ_s = κ (a + b α)/(1 − κ b).
#[test]
fn a_straight_line_has_a_closed_form() {
    let (a, b) = (0.02, 0.3);
    let rows = (-12..=12).map(|own| 5.0 * f64::from(own));
    let rows = rows.map(|alpha: f64| {
        format!(
            "{alpha},{:e},1,{:e}\n",
            alpha.to_radians(),
            a + b * alpha.to_radians()
        )
    });
    let text = "alpha_deg,CL,CD,CM\n".to_string() + &rows.collect::<String>();
    let table = CoefficientTable::read("line.csv", &text).expect("a table");
    for interpolation in ["linear", "cubic", "smooth"] {
        for turn in ["section", "wind"] {
            let (interpolated, turned) = (format!("\"{interpolation}\""), format!("\"{turn}\""));
            let edits = [
                ("U = 9", "U = 5"),
                ("\"cubic\"", interpolated.as_str()),
                ("\"section\"", turned.as_str()),
                (
                    "from = 0, to = 180, step = 0.5",
                    "from = -20, to = 20, step = 4",
                ),
            ];
            let case = case(&edits);
            let softness = softness(&case);
            for (angle, found) in twists(&case, &table) {
                let expected = softness * (a + b * angle.to_radians()) / (1.0 - softness * b);
                let error = (found.angle - expected).abs();
                assert!(
                    error <= 1e-8 && found.is_only && found.is_steady,
                    "{angle}: {found:?} {expected}"
                );
                assert!(
                    interpolation == "smooth" || error <= BOUND,
                    "{angle}: {error:e}"
                );
                assert!((found.stiffness - (1.0 - softness * b)).abs() < 1e-8);
            }
        }
    }
    // 1 = κ b: beyond it the table ends before there is a balance.
    let divergence = 5.0 / (softness(&case(&[("U = 9", "U = 5")])) * b).sqrt();
    for (share, words) in [
        (0.999, ""),
        (1.0 - 1e-14, "to where the table ends"),
        (1.01, "to where the table ends"),
    ] {
        let wind = format!("U = {}", share * divergence);
        let case = case(&[
            ("U = 9", &wind),
            (
                "from = 0, to = 180, step = 0.5",
                "from = 10, to = 10, step = 1",
            ),
        ]);
        match compare(&case, &table) {
            Ok(_) => panic!("at {share} of divergence the twist is beyond the table"),
            Err(error) => assert!(
                error.what.contains(words) && error.what.contains("twist"),
                "{error}"
            ),
        }
    }
    // Without a moment there is a balance, but it is not stable, or not certain.
    let level = text.lines().map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        match cells[0].parse::<f64>() {
            Ok(alpha) => format!("{alpha},0,1,{:e}\n", b * alpha.to_radians()),
            Err(_) => format!("{line}\n"),
        }
    });
    let level = CoefficientTable::read("level.csv", &level.collect::<String>()).expect("a table");
    for (share, words) in [
        (0.9, None),
        (1.0, Some("not certain")),
        (1.1, Some("turns the section over")),
    ] {
        let wind = format!("U = {}", share * divergence);
        let case = case(&[
            ("U = 9", &wind),
            ("\"cubic\"", "\"linear\""),
            (
                "from = 0, to = 180, step = 0.5",
                "from = 0, to = 0, step = 1",
            ),
        ]);
        match (compare(&case, &level), words) {
            (Ok(found), None) => assert_eq!(found.points[0].twist.map(|own| own.angle), Some(0.0)),
            (Err(error), Some(words)) => assert!(error.what.contains(words), "{share}: {error}"),
            (found, _) => panic!("{share}: {found:?}"),
        }
    }
}

/// A section that is twisted is that which stands at the angle with the twist.
#[test]
fn a_twisted_section_is_one_that_was_turned_by_hand() {
    let table = formulas();
    for stiffness in ["", "\naerodynamic_stiffness = true"] {
        let rho = format!("rho = 1.25{stiffness}");
        let twisted = case(&[
            ("U = 9", "U = 6"),
            ("step = 0.5", "step = 15"),
            ("rho = 1.25", &rho),
        ]);
        for own in compare(&twisted, &table).expect("a comparison").points {
            let twist = own.twist.expect("a twist");
            let mut turned = twisted.clone();
            turned.mean_twist = false;
            let angle = own.angle + twist.angle.to_degrees();
            (turned.angles.from, turned.angles.to) = (angle, angle);
            let other = &compare(&turned, &table).expect("a comparison").points[0];
            assert!(
                (own.exact.value - other.exact.value).abs() < 1e-9,
                "{own:?} {other:?}"
            );
            // The bound of the twist is in that of S.
            let allowed = if twist.error == 0.0 { 0.0 } else { 1e-13 };
            assert!(own.exact.error >= allowed, "{own:?} {other:?}");
            assert_eq!(own.verdict.name(), other.verdict.name());
            assert_eq!(own.diverges, other.diverges);
        }
    }
}

/// In wind that turns, the section alone is twisted: its centres, and the angle at which the table is read.
#[test]
fn in_turning_wind_the_twist_is_the_attitude() {
    let table = formulas();
    let twisted = case(&[
        ("U = 9", "U = 6"),
        ("step = 0.5", "step = 30"),
        ("\"section\"", "\"wind\""),
    ]);
    for own in compare(&twisted, &table).expect("a comparison").points {
        let twist = own.twist.expect("a twist").angle;
        let mut turned = twisted.clone();
        turned.mean_twist = false;
        turned.parameters.mass_centre_angle += twist;
        turned.parameters.aerodynamic_centre_angle += twist;
        let curves = CoefficientCurves::new(&table, turned.interpolation).expect("curves");
        let coefficients = curves
            .at(own.angle + twist.to_degrees())
            .expect("in the table");
        let section = turned.section(own.angle, coefficients).expect("a section");
        let model = sextic::stability::model::Model::new(&section).expect("a model");
        let spectrum = sextic::stability::state_matrix::eigenvalues(&model).expect("eigenvalues");
        let (damping, _) = spectrum.damping_coefficient(&section).expect("wind");
        assert!(
            (own.exact.value - damping).abs() < 1e-9,
            "{own:?} {damping}"
        );
    }
}

#[test]
fn a_grid_has_the_twist_of_each_point() {
    let table = formulas();
    let text = [("step = 0.5", "step = 45"), ("U = 9", "U = 4")];
    let own = case(&text);
    let speeds = [1.0, 4.0, 7.0];
    let methods = Methods {
        exact: true,
        companion: true,
        closed: true,
        uniform: true,
    };
    let drag = Variable::named("C_D").expect("a quantity");
    let axes = vec![
        Axis::new(Variable::named("U").expect("a quantity"), 1.0, 7.0, 3).expect("an axis"),
        Axis::new(drag, 1.3, 1.3, 1).expect("an axis"),
    ];
    let grid = Grid::new(&own, &table, axes, Rows::Points, methods).expect("a grid");
    let rows = grid.rows_at(0..grid.rows());
    let mut place = 0;
    for speed in speeds {
        let mut alone = own
            .with(&[sextic::stability::variable::Setting {
                variable: drag,
                value: 1.3,
            }])
            .expect("a case");
        alone.parameters.wind_speed = speed;
        let points: Vec<Point> = compare(&alone, &table).expect("a comparison").points;
        for point in points {
            assert_eq!(rows.twists[place], point.twist);
            let exact = rows.exact[place].expect("an answer");
            assert!(
                (exact.value - point.exact.value).abs() <= 2.0 * (exact.error + point.exact.error)
            );
            let uniform = rows.uniform[place].value.expect("an answer");
            assert!((uniform - point.uniform.value.expect("an answer")).abs() < 1e-12);
            place += 1;
        }
    }
    assert_eq!(place as u64, grid.rows());
    // Where the wind turns the section over, cells are empty.
    let strong =
        vec![Axis::new(Variable::named("U").expect("a quantity"), 4.0, 400.0, 2).expect("an axis")];
    for rows in [Rows::Points, Rows::WorstAngles] {
        let grid = Grid::new(&own, &table, strong.clone(), rows, methods).expect("a grid");
        let found = grid.rows_at(0..grid.rows());
        let none = found
            .twists
            .iter()
            .position(Option::is_none)
            .expect("no balance");
        assert!(
            found.exact[none].is_none()
                && found.uniform[none].value.is_none()
                && found.closed[none].value.is_none()
        );
        assert!(found.values.last().expect("angles")[none].is_finite());
    }
}

#[test]
fn what_hangs_on_less_than_the_bound_is_not_decided() {
    // Nothing damps the turn, exactly.
    let rows = (0..12).map(|own| format!("{},0,0,0.01\n", 30 * own));
    let text = "alpha_deg,CL,CD,CM\n".to_string() + &rows.collect::<String>();
    let table = CoefficientTable::read("neutral.csv", &text).expect("a table");
    let edits = [
        ("zeta_theta = 0.03", "zeta_theta = 0"),
        ("[\"x\", \"y\", \"theta\"]", "[\"theta\"]"),
        ("L_a = 0.03", "L_a = 0"),
        ("step = 0.5", "step = 90"),
    ];
    let mut case = case(&edits);
    for (is_twisted, doubt) in [(false, Doubt::Neutral), (true, Doubt::Open)] {
        case.mean_twist = is_twisted;
        for point in compare(&case, &table).expect("a comparison").points {
            assert_eq!(point.verdict, Verdict::Undecided(doubt));
        }
    }
}

#[test]
fn what_does_not_follow_the_twist_refuses_it() {
    let table = formulas();
    let case = case(&[("U = 9", "U = 4"), ("step = 0.5", "step = 45")]);
    let speeds = speeds_of(&case, &table, 100.0)
        .expect_err("no speeds")
        .to_string();
    assert!(
        speeds.contains("mean twist") && speeds.contains("sextic sweep"),
        "{speeds}"
    );
    let map = validity(&case, &table).expect_err("no map").to_string();
    assert!(map.contains("leave `mean_twist` out"), "{map}");
    let errors = compare(&case, &table.clone().with_errors([0.1; 3]))
        .expect_err("no errors")
        .to_string();
    assert!(
        errors.contains("errors of C_M move the mean twist"),
        "{errors}"
    );
    let moment = Variable::named("C_M").expect("a quantity");
    let set = case.with(&[sextic::stability::variable::Setting {
        variable: moment,
        value: 0.1,
    }]);
    assert!(
        set.expect_err("C_M")
            .to_string()
            .contains("follows the curve of the table")
    );
    // Where theta is held there is none, and nothing is refused.
    let mut held = case.clone();
    held.parameters.free = sextic::stability::coordinate::FreeCoordinates::new(&[
        sextic::stability::coordinate::Coordinate::Y,
    ])
    .expect("one");
    assert!(
        compare(&held, &table)
            .expect("a comparison")
            .points
            .iter()
            .all(|own| own.twist.is_none())
    );
    assert!(speeds_of(&held, &table, 100.0).is_ok());
}

/// C_M is 0.1 up to 10°, and 1 from 20° on: between them two balances vanish as the wind rises, and the twist jumps.
#[test]
fn several_balances_and_a_jump_are_told() {
    let rows = (0..36).map(|own| {
        let moment = if own < 2 { 0.1 } else { 1.0 };
        format!("{},0,1,{moment}\n", 10 * own)
    });
    let text = "alpha_deg,CL,CD,CM\n".to_string() + &rows.collect::<String>();
    let table = CoefficientTable::read("step.csv", &text).expect("a table");
    for (softness_wanted, twist, word) in [
        (0.1, 0.01, "only"),
        (0.5, 0.05, "several"),
        (2.0, 2.0, "jump"),
    ] {
        let mut case = case(&[("\"cubic\"", "\"linear\""), ("to = 180", "to = 0")]);
        case.parameters.wind_speed *= (softness_wanted / softness(&case)).sqrt();
        let found = twists(&case, &table)[0].1;
        assert!((found.angle - twist).abs() < 1e-11, "{found:?}");
        assert_eq!(found.word(), word);
        let said = compare(&case, &table).expect("a comparison").remarks;
        let words = match word {
            "several" => "at more than one mean twist",
            _ => "the section may snap over",
        };
        let is_said = said.iter().any(|own| own.what.contains(words));
        assert_eq!(is_said, word != "only");
    }
}

/// The rows of `formulas.csv` up to 180°, with a moment there that does not vanish.
fn half(moment: f64, reading: &Reading) -> CoefficientTable {
    let text = read(&shipped().join("formulas.csv"));
    let row = |line: &str| -> Option<String> {
        let Some((alpha, _)) = line.split_once(',') else {
            return Some(line.to_owned());
        };
        match alpha.parse::<f64>() {
            Ok(180.0) => Some(format!("180,0,0.7,{moment}")),
            Ok(own) => (own < 180.0).then(|| line.to_owned()),
            Err(_) => Some(line.to_owned()),
        }
    };
    let rows: Vec<String> = text.lines().filter_map(row).collect();
    CoefficientTable::read_as("half.csv", &rows.join("\n"), reading).expect("a table")
}

/// Of a balance at the end of a table one side is known, which is that of the whole curve here.
#[test]
fn where_the_table_ends_in_balance_one_side_counts() {
    let edits = [
        ("U = 9", "U = 5"),
        ("\"cubic\"", "\"linear\""),
        ("step = 0.5", "step = 180"),
    ];
    let case = case(&edits);
    let mirror = Reading {
        mirror: true,
        ..Reading::default()
    };
    let of = |table: &CoefficientTable| compare(&case, table).expect("a comparison").points;
    let [ended, whole] = [Reading::default(), mirror].map(|own| of(&half(0.0, &own)));
    for (one, other) in ended.iter().zip(&whole) {
        assert_eq!(one.twist, other.twist);
        assert_eq!(
            one.twist.map(|own| (own.angle, own.error)),
            Some((0.0, 0.0))
        );
        assert_eq!(one.verdict, other.verdict);
    }
    assert_eq!((ended.len(), whole.len()), (2, 2));
}

/// Half a table that does not end at 0 jumps where it is mirrored, and springs and wind may find no balance there.
#[test]
fn angles_without_a_balance_are_left_out_with_their_reason() {
    let mirror = Reading {
        mirror: true,
        ..Reading::default()
    };
    let table = half(0.05, &mirror);
    let angles = "from = 150, to = 210, step = 1";
    let edits = [
        ("from = 0, to = 180, step = 0.5", angles),
        ("zeta_x = 0.008", "zeta_x = 0"),
        ("zeta_y = 0.008", "zeta_y = 0"),
        ("zeta_theta = 0.03", "zeta_theta = 0"),
    ];
    let case = case(&edits);
    let found = compare(&case, &table).expect("a comparison");
    let left_out: Vec<f64> = found.without_balance.iter().map(|own| own.angle).collect();
    assert_eq!(left_out, [179.0, 180.0, 181.0]);
    assert_eq!(found.points.len() + left_out.len(), 61);
    for own in &found.without_balance {
        let end = if own.angle > 180.0 { -180.0 } else { 180.0 };
        assert_eq!(own.reason, NoTwist::AtJump(end), "{own:?}");
        let reason = own.reason.to_string();
        assert!(
            reason.contains("the coefficients of the table jump"),
            "{reason}"
        );
    }
    // All angles are there, in their order.
    let all: Vec<f64> = found.at_all_angles().iter().map(|own| own.0).collect();
    assert_eq!(all, case.angles.values());
    // The others are as they are alone, and curves and ranges do not pass over the gap.
    let sections = Sections::new(&case, &table).expect("sections");
    for own in &found.points {
        let (_, twist) = sections.at(own.angle, &table).expect("a section");
        assert_eq!(own.twist, twist);
    }
    let curve = &sextic::report::stability_figure::figure(&found).curves[0];
    assert_eq!(curve.pieces.len(), 2);
    let ranges = found.unstable.iter();
    let ranges: Vec<(f64, f64)> = ranges.map(|own| (own.angles.from, own.angles.to)).collect();
    assert_eq!(ranges, [(150.0, 178.0), (182.0, 210.0)]);
}

/// Where the table ends, and does not jump, that is the reason.
#[test]
fn the_end_of_a_table_is_named() {
    let case = case(&[(
        "from = 0, to = 180, step = 0.5",
        "from = 150, to = 180, step = 1",
    )]);
    let table = half(0.05, &Reading::default());
    let found = compare(&case, &table).expect("a comparison");
    assert!(!found.without_balance.is_empty());
    for own in &found.without_balance {
        assert_eq!(own.reason, NoTwist::BeyondTable(180.0), "{own:?}");
    }
}
