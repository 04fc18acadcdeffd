//! Coefficients over other lengths than D: they are those of a table that was converted by hand.

use sextic::stability::case::Case;
use sextic::stability::coefficient_table::CoefficientTable;
use sextic::stability::forces::Forces;
use sextic::stability::interpolation::CoefficientCurves;
use sextic::stability::section::Coefficients;

use super::cases::{read, shipped};

/// What stands in [section] besides.
fn case(lines: &str) -> Case {
    let text = read(&shipped().join("detuned.toml"));
    let text = text.replace("interpolation =", &format!("{lines}\ninterpolation ="));
    Case::read("case.toml", &text).expect("a case")
}

/// A table with slopes or errors, its coefficients times these factors.
fn text([drag, lift, moment]: [f64; 3], with_slopes: bool) -> String {
    let more = if with_slopes {
        "dCD,dCL,dCM"
    } else {
        "CD_error,CL_error,CM_error"
    };
    let mut text = format!("alpha_deg,CD,CL,CM,{more}\n");
    for step in 0..36_u32 {
        let angle = 10.0 * f64::from(step);
        let (sin, cos) = angle.to_radians().sin_cos();
        let (d, l, m) = (
            (1.2 + 0.3 * cos) * drag,
            (sin - 0.2) * lift,
            0.1 * sin * moment,
        );
        let (a, b, c) = match with_slopes {
            true => (-0.3 * sin * drag, cos * lift, 0.1 * cos * moment),
            false => (0.01 * drag, 0.02 * lift, 0.03 * moment),
        };
        text += &format!("{angle},{d:e},{l:e},{m:e},{a:e},{b:e},{c:e}\n");
    }
    text
}

fn numbers(c: Coefficients) -> [f64; 6] {
    [
        c.drag,
        c.lift,
        c.moment,
        c.drag_slope,
        c.lift_slope,
        c.moment_slope,
    ]
}

#[test]
fn a_converted_table_is_that_converted_by_hand() {
    // D is 0.05 m: powers of 2 lose no bit.
    for (lines, factors, apart) in [
        (
            "reference = { CD = 0.1, CL = 0.2, CM = [0.2, 0.1] }",
            [2.0, 4.0, 8.0],
            0.0,
        ),
        ("reference = { CL = 0.025 }", [1.0, 0.5, 1.0], 0.0),
        (
            "reference = { CD = 0.05, CL = 0.31, CM = [0.31, 0.31] }",
            [1.0, 6.2, 38.44],
            4e-14,
        ),
        ("reference = { CM = [0.31, 0.05] }", [1.0, 1.0, 6.2], 4e-14),
    ] {
        for interpolation in ["linear", "cubic", "smooth"] {
            for with_slopes in [true, false] {
                let lines = match with_slopes {
                    true => format!("{lines}\nslopes = true"),
                    false => lines.to_string(),
                };
                let [own, by_hand] = [
                    lines.as_str(),
                    lines.split_once('\n').map_or("", |own| own.1),
                ]
                .map(case);
                let [own, by_hand] =
                    [(own, [1.0; 3]), (by_hand, factors)].map(|(case, factors)| {
                        let table = case
                            .read_table("table.csv", &text(factors, with_slopes))
                            .expect("a table");
                        let interpolation = match interpolation {
                            "linear" => sextic::stability::interpolation::Interpolation::Linear,
                            "cubic" => sextic::stability::interpolation::Interpolation::Cubic,
                            _ => sextic::stability::interpolation::Interpolation::Smooth,
                        };
                        CoefficientCurves::new(&table, interpolation).expect("curves")
                    });
                for angle in [0.0, 33.0, 190.0, 355.0] {
                    let both = [&own, &by_hand].map(|own| {
                        let (at, errors) = (own.at(angle), own.errors_at(angle));
                        (
                            numbers(at.expect("in the table")),
                            numbers(errors.expect("in the table")),
                        )
                    });
                    let [(at, errors), (at_by_hand, errors_by_hand)] = both;
                    let all = at.into_iter().chain(errors);
                    for (own, by_hand) in all.zip(at_by_hand.into_iter().chain(errors_by_hand)) {
                        let size =
                            own.abs() + factors.iter().fold(1.0, |most: f64, own| most.max(*own));
                        // What is smoothed is found by a search.
                        let apart = if interpolation == "smooth" {
                            f64::max(apart, 1e-9)
                        } else {
                            apart
                        };
                        assert!(
                            (own - by_hand).abs() <= apart * size,
                            "{lines} {interpolation} {angle}: {own} {by_hand}"
                        );
                    }
                }
            }
        }
    }
}

/// What the wind does hangs on the force alone, not on what it is divided by.
#[test]
fn forces_do_not_depend_on_the_length_they_are_divided_by() {
    let given = case("errors = { CD = 0.01, CL = 0.02, CM = 0.01 }");
    let other = case(
        "reference = { CD = 0.1, CL = 0.1, CM = [0.1, 0.1] }\nerrors = { CD = 0.005, CL = 0.01, CM = 0.0025 }",
    );
    let plain = "alpha_deg,CD,CL,CM\n0,1,0.5,0.2\n1,1.5,0.5,0.1\n2,1,0.25,0\n3,1,0,0.1\n";
    let halved =
        "alpha_deg,CD,CL,CM\n0,0.5,0.25,0.05\n1,0.75,0.25,0.025\n2,0.5,0.125,0\n3,0.5,0,0.025\n";
    let at = |case: &Case, text: &str| {
        let table: CoefficientTable = case.read_table("table.csv", text).expect("a table");
        // Remarks speak of the numbers of the file.
        assert!(text.contains(&format!("{}", table.rows()[1].moment)));
        let curves = CoefficientCurves::new(&table, case.interpolation).expect("curves");
        let errors = curves.errors_at(1.5).expect("in the table");
        let section = case
            .section(1.5, curves.at(1.5).expect("in the table"))
            .expect("a section");
        let Forces::Coefficients(own) = section.parameters().forces else {
            panic!("no coefficients")
        };
        (numbers(own), numbers(errors))
    };
    let (own, other) = (at(&given, plain), at(&other, halved));
    for (own, other) in own
        .0
        .iter()
        .chain(&own.1)
        .zip(other.0.iter().chain(&other.1))
    {
        assert!(
            (own - other).abs() <= 1e-15 * (1.0 + own.abs()),
            "{own} {other}"
        );
    }
}
