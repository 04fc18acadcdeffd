//! The comparison of methods: locked, and against what NumPy makes of the forces themselves.

use std::collections::BTreeMap;
use std::path::Path;

use sextic::report::{csv, stability_figure, text};
use sextic::stability::comparison::{Comparison, Method, compare};

use super::cases::{read, shipped_case, snapshots};

/// Edits of a case file: what is there, and what is to be there.
type Edits = &'static [(&'static str, &'static str)];

/// The variants of the cases that come with the project, as in `reference.py`.
const VARIANTS: [(&str, &str, Edits); 8] = [
    ("tuned", "tuned.toml", &[]),
    (
        "tuned, no eccentricity",
        "tuned.toml",
        &[("L_g = 0.00385 ", "L_g = 0 ")],
    ),
    ("tuned, strong wind", "tuned.toml", &[("U = 9 ", "U = 90 ")]),
    (
        "tuned, wind turned",
        "tuned.toml",
        &[
            ("\"section\"", "\"wind\""),
            ("alpha_g_deg = 0", "alpha_g_deg = 20"),
        ],
    ),
    ("detuned", "detuned.toml", &[]),
    (
        "detuned, no eccentricity",
        "detuned.toml",
        &[("L_g = 0.004", "L_g = 0")],
    ),
    (
        "detuned, no damping",
        "detuned.toml",
        &[
            ("zeta_x = 0.008", "zeta_x = 0"),
            ("zeta_y = 0.008", "zeta_y = 0"),
            ("zeta_theta = 0.03", "zeta_theta = 0"),
        ],
    ),
    (
        "detuned, heave and turn",
        "detuned.toml",
        &[("[\"x\", \"y\", \"theta\"]", "[\"y\", \"theta\"]")],
    ),
];

/// A variant every 10°.
fn compared(name: &str) -> Comparison {
    let (_, file, edits) = VARIANTS
        .iter()
        .find(|(own, _, _)| *own == name)
        .expect("a variant");
    let mut edits = edits.to_vec();
    edits.push(("step = 0.5", "step = 10"));
    let (case, table) = shipped_case(file, &edits);
    compare(&case, &table).expect("an answer")
}

#[test]
fn every_comparison_is_locked() {
    for (name, _, _) in VARIANTS {
        let comparison = compared(name);
        let page = anstream::adapter::strip_str(&text::comparison(&comparison, 100)).to_string();
        let both = format!("{page}\n{}", without_bounds(&csv::comparison(&comparison)));
        snapshots("comparisons", || {
            insta::assert_snapshot!(name.replace(", ", "_").replace(' ', "_"), both)
        });
    }
}

/// The rows without the columns of bounds, which the rounding of another machine may change.
fn without_bounds(rows: &str) -> String {
    let keep = |line: &str| -> String {
        let cells = line.split(',').enumerate();
        let cells = cells.filter(|(place, _)| !(5..=6).contains(place));
        cells.map(|(_, cell)| cell).collect::<Vec<_>>().join(",")
    };
    rows.lines().map(|line| keep(line) + "\n").collect()
}

#[test]
fn numbers_are_those_of_another_program() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/stability/reference.csv");
    let mut points = BTreeMap::new();
    for (name, _, _) in VARIANTS {
        points.insert(name, compared(name).points);
    }
    let mut count = 0;
    for line in read(&path).lines().skip(1) {
        let cells: Vec<&str> = line.split(';').collect();
        let number = |cell: &str| cell.parse::<f64>().expect("a number");
        let (angle, exact) = (number(cells[1]), number(cells[2]));
        let point = points[cells[0]]
            .iter()
            .find(|point| (point.angle - angle).abs() < 1e-9)
            .expect("an angle");
        // Central differences of forces are right to about nine digits.
        let is_close = |one: f64, other: f64| (one - other).abs() < 1e-7 * (1.0 + other.abs());
        assert!(
            is_close(point.exact.value, exact),
            "{line}: {}",
            point.exact.value
        );
        match (point.closed, cells[3]) {
            (None, "") => {}
            (Some(closed), cell) => assert!(is_close(closed, number(cell)), "{line}: {closed}"),
            (None, _) => panic!("{line}: no closed form"),
        }
        count += 1;
    }
    assert_eq!(count, 19 * VARIANTS.len());
}

#[test]
fn methods_agree_within_their_errors_or_say_why_not() {
    for (name, _, _) in VARIANTS {
        let comparison = compared(name);
        for point in &comparison.points {
            let companion = point.companion.expect("an answer");
            let difference = (companion.value - point.exact.value).abs();
            assert!(
                difference <= companion.error + point.exact.error,
                "{name}: {point:?}"
            );
            let critical = point.critical().expect("a mode");
            assert!((critical.damping.value - point.exact.value).abs() <= point.exact.error);
        }
        for own in &comparison.agreements {
            let is_wrong = !own.differs.is_empty() || !own.opposite.is_empty();
            let is_silent = own.answers < comparison.points.len();
            assert_eq!(
                is_wrong || is_silent,
                !own.reasons.is_empty(),
                "{name}: {own:?}"
            );
            assert!(own.method == Method::Closed || !is_wrong, "{name}: {own:?}");
        }
    }
}

#[test]
fn the_figure_has_its_labels_and_refers_to_nothing() {
    let svg = stability_figure::figure(&compared("tuned"))
        .svg()
        .expect("a figure");
    for label in [
        "angle of attack",
        "state matrix",
        "companion matrix",
        "closed form",
        "unstable",
    ] {
        assert!(svg.contains(label), "{label}");
    }
    assert!(!svg.contains("href") && !svg.contains("url("));
    let held = stability_figure::figure(&compared("detuned, heave and turn"));
    assert_eq!(held.curves.len(), 2);
}

#[test]
fn modes_are_followed_without_a_jump() {
    let (case, table) = shipped_case("tuned.toml", &[]);
    let comparison = compare(&case, &table).expect("an answer");
    for pair in comparison.points.windows(2) {
        for (one, next) in pair[0].modes.iter().zip(&pair[1].modes) {
            assert_eq!(one.label, next.label);
            let jump = (one.damping.value - next.damping.value).abs();
            assert!(
                jump < 0.1,
                "mode {} at {}: {jump}",
                one.label,
                pair[1].angle
            );
        }
    }
}

#[test]
fn without_wind_or_table_there_is_no_answer() {
    let (case, table) = shipped_case("tuned.toml", &[("U = 9 ", "U = 0 ")]);
    let error = compare(&case, &table).expect_err("no wind").to_string();
    assert!(error.contains("U = 0"), "{error}");
}

#[test]
fn the_picture_is_that_of_the_command() {
    let (case, table) = shipped_case("tuned.toml", &[]);
    let comparison = compare(&case, &table).expect("an answer");
    let svg = stability_figure::figure(&comparison)
        .svg()
        .expect("a figure");
    let shown = read(&super::cases::shipped().join("tuned.svg"));
    assert!(
        svg == shown,
        "derivations/cases/tuned.svg is old: draw it again as the README says"
    );
}
