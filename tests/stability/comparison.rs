//! The comparison of methods: locked, and against what NumPy makes of the forces themselves.

use std::collections::BTreeMap;
use std::path::Path;

use sextic::report::gallery;
use sextic::report::{csv, stability_figure, text};
use sextic::stability::comparison::{Comparison, Method, Reason, compare};
use sextic::stability::limitation::Limitation;
use sextic::stability::offset::against_offset;
use sextic::stability::sections::Sections;

use super::cases::{read, shipped_case, snapshots};

/// Edits of a case file: what is there, and what is to be there.
type Edits = &'static [(&'static str, &'static str)];

/// The variants of the cases that come with the project, as in `reference.py`.
const VARIANTS: [(&str, &str, Edits); 11] = [
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
    ("light", "light.toml", &[]),
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
    ("stiff", "stiff.toml", &[]),
    // Above the speed at which it diverges at some angles.
    ("stiff, strong wind", "stiff.toml", &[("U = 9", "U = 20")]),
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
        match (point.closed.value, cells[3]) {
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
            let is_left_out = own
                .reasons
                .contains(&Reason::Limitation(Limitation::AerodynamicStiffness));
            assert!(
                own.method == Method::Closed || is_left_out || !is_wrong,
                "{name}: {own:?}"
            );
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

/// A pair becomes real above another mode (its second number splits), and a number is free in between (1, 2, 4); the
/// circle has more angles than are answered at once.
#[test]
fn modes_keep_their_numbers_where_a_pair_becomes_real() {
    for (frequency, to, labels) in [
        (
            "f_theta = 1.3",
            "to = 180",
            &[&[1, 2, 3][..], &[1, 2, 3, 4]][..],
        ),
        ("f_theta = 1.0", "to = 360", &[&[1, 2, 3, 4], &[1, 2, 4]]),
    ] {
        let edits = [
            ("f_theta = 0.865", frequency),
            ("U = 9", "U = 12"),
            ("to = 180", to),
            ("step = 0.5", "step = 0.1"),
        ];
        let (case, table) = shipped_case("stiff.toml", &edits);
        let comparison = compare(&case, &table).expect("an answer");
        assert!(comparison.points.len() > 1800);
        let mut found: Vec<Vec<usize>> = Vec::new();
        for pair in comparison.points.windows(2) {
            let own: Vec<usize> = pair[0].modes.iter().map(|mode| mode.label).collect();
            if !found.contains(&own) {
                found.push(own);
            }
            for (one, next) in pair[0]
                .modes
                .iter()
                .filter_map(|one| Some((one, pair[1].mode(one.label)?)))
            {
                let jump = (one.frequency - next.frequency).abs();
                assert!(
                    jump < 0.06,
                    "mode {} at {}: {jump}",
                    one.label,
                    pair[1].angle
                );
            }
        }
        assert_eq!(found, labels, "{frequency}");
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
        "derivations/cases/tuned.svg is old: draw it again as docs/sections.md says"
    );
}

#[test]
fn the_offset_of_the_case_gives_its_modes() {
    let (case, table) = shipped_case("detuned.toml", &[("step = 0.5", "step = 10")]);
    let comparison = compare(&case, &table).expect("an answer");
    let e = case.parameters.mass_centre_distance / case.parameters.radius_of_gyration;
    let sections = Sections::new(&case, &table).expect("curves");
    let (section, _) = sections.at(130.0, &table).expect("a section");
    let offsets = against_offset(&section, 2.0 * e, 40);
    let offsets = offsets.expect("modes");
    let point = comparison.points.iter().find(|point| point.angle == 130.0);
    let (own, same) = (&offsets[20], point.expect("an angle"));
    for mode in &same.modes {
        let other = own.modes.iter().find(|other| {
            (other.frequency - mode.frequency).abs() < 1e-9
                && (other.damping.value - mode.damping.value).abs() < 1e-9
        });
        assert!(other.is_some(), "{mode:?}");
    }
    assert_eq!(offsets[0].eccentricity, 0.0);
}

#[test]
fn figures_without_wind_are_those_of_the_eigenvectors() {
    let (case, table) = shipped_case("detuned.toml", &[("step = 0.5", "step = 10")]);
    let gallery = gallery::figures(&case, &table).expect("figures");
    let figures = gallery.figures;
    let names: Vec<&str> = figures.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(
        names,
        [
            "frequencies_without_wind",
            "trajectory_of_mode_1",
            "trajectory_of_mode_2",
            "trajectory_of_mode_3",
            "stability",
            "coefficients",
            "slopes",
            "damping_of_modes",
            "frequencies_of_modes",
            "inertial_coupling",
            "damping_against_offset",
            "frequencies_against_offset",
            "closed_form",
        ]
    );
    assert_eq!(gallery.left_out, []);
    // (L_g − r) ω² + r ω_n² and (L_g + r) ω² − r ω_n² vanish, Eq. (15).
    for (curve, sign) in [(0, -1.0), (2, 1.0)] {
        for (e, frequency) in &figures[0].1.curves[curve].pieces[0] {
            assert!((frequency * frequency * (1.0 + sign * e) - 1.0).abs() < 1e-12);
        }
    }
    let e = case.parameters.mass_centre_distance / case.parameters.radius_of_gyration;
    for place in [0, 10, 11] {
        let own = figures[place].1.own.as_ref().expect("the case is marked");
        assert!((own.value - e).abs() < 1e-12, "{own:?}");
    }
    // (1) puts a point at a distance L under 30° from O at (−L cos 30°, L sin 30°).
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let on_line = |distance: f64| (-distance * cos, distance * sin);
    let is_near = |one: (f64, f64), other: (f64, f64)| {
        (one.0 - other.0).abs().max((one.1 - other.1).abs()) < 1e-12
    };
    // In modes 1 and 3 all lines of the body go through one point, which rests; in mode 2 they are parallel.
    for (mode, centre) in [(1, Some(1.0)), (2, None), (3, Some(-1.0))] {
        let figure = &figures[mode].1;
        let places: Vec<(f64, f64)> = figure.marks.iter().map(|own| own.place).collect();
        let expected = [Some(0.0), Some(e), centre];
        let expected: Vec<_> = expected.into_iter().flatten().map(on_line).collect();
        assert_eq!(places.len(), expected.len());
        for (one, other) in places.into_iter().zip(expected) {
            assert!(is_near(one, other), "mode {mode}: {one:?} {other:?}");
        }
        let lines = &figure.curves[0].pieces;
        assert!(lines.len() > 10);
        for line in lines {
            let [(x, y), (far_x, far_y)] = line[..] else {
                panic!("a line has two ends");
            };
            match centre {
                Some(distance) => {
                    let end = if distance > 0.0 { line[1] } else { line[0] };
                    assert!(is_near(end, on_line(distance)), "mode {mode}: {end:?}");
                }
                None => assert!(
                    is_near((far_x - x, far_y - y), (0.5 * sin, 0.5 * cos))
                        || is_near((far_x - x, far_y - y), (-0.5 * sin, -0.5 * cos))
                ),
            }
        }
        // O moves by x and y of the eigenvector, whose turn is 0.4 rad.
        let path = &figure.curves[1].pieces[0];
        let shape = [(-sin, -cos), (-cos, sin), (sin, cos)][mode - 1];
        assert!(is_near(path[0], (0.4 * shape.0, 0.4 * shape.1)), "{path:?}");
    }
}

/// Of every shipped case, whatever is free, and whether the mass centre is at O or not: no two drawings are alike, all
/// texts aside, and each of the eleven figures is there or is said to be left out.
#[test]
fn no_two_figures_are_alike() {
    let all_free = r#"free = ["x", "y", "theta"]"#;
    let free = ["x", "y", "theta", "x, y", "x, theta", "y, theta"];
    let free = free.map(|own| format!(r#"free = ["{}"]"#, own.replace(", ", r#"", ""#)));
    let (mut count, mut same) = (0, 0);
    for path in std::fs::read_dir(super::cases::shipped()).expect("cases") {
        let path = path.expect("a case").path();
        if path.extension().is_none_or(|own| own != "toml") {
            continue;
        }
        let name = path.file_name().expect("a name").to_string_lossy();
        let text = read(&path);
        let line = |key: &str| {
            let mut lines = text.lines();
            lines.find(|own| own.starts_with(key)).expect("a line")
        };
        let step = line("alpha_deg = ").rsplit_once("step").expect("a step").1;
        let steps = (step, " = 10 }");
        let offsets = [line("L_g ").to_string(), "L_g = 0".to_string()];
        // A case that does not say what is free has all of it so.
        let kept = text.lines().find(|own| own.starts_with("free "));
        let kept = kept.unwrap_or("[wind]").to_string();
        let is_all = kept == all_free || kept == "[wind]";
        let others: Vec<String> = match kept.as_str() {
            "[wind]" => free.iter().map(|own| format!("{own}\n[wind]")).collect(),
            _ => free.iter().filter(|_| is_all).cloned().collect(),
        };
        for free in others.iter().chain([&kept]) {
            // Without an offset it does not matter what else is free.
            let offsets = if *free == kept {
                &offsets[..]
            } else {
                &offsets[..1]
            };
            for offset in offsets {
                let edits = [steps, (offsets[0].as_str(), offset), (kept.as_str(), free)];
                let (case, table) = shipped_case(&name, &edits);
                let gallery = gallery::figures(&case, &table).expect("figures");
                assert_eq!(gallery.figures.len() + gallery.left_out.len(), 13, "{name}");
                same += gallery
                    .left_out
                    .iter()
                    .filter(|own| own.1.contains("the same"))
                    .count();
                let mut drawn = BTreeMap::new();
                for (own, figure) in &gallery.figures {
                    let svg = figure.svg().expect("a drawing");
                    let earlier = drawn.insert(lines_of(&svg), own);
                    assert_eq!(earlier, None, "{own} of {name}: {free}, {offset}");
                    count += 1;
                }
            }
        }
    }
    assert!(count > 150 && same > 0, "{count} {same}");
}

/// All that is drawn, without texts.
fn lines_of(svg: &str) -> String {
    let drawing = roxmltree::Document::parse(svg).expect("well-formed SVG");
    let is_text =
        |own: &roxmltree::Node| ["text", "tspan", "title", "desc"].contains(&own.tag_name().name());
    let drawn = drawing.root_element().children();
    let drawn = drawn.filter(|own| own.is_element() && !is_text(own));
    drawn.map(|own| &svg[own.range()]).collect()
}

#[test]
fn every_mode_is_drawn() {
    let overdamped = [
        ("zeta_x = 0.008", "zeta_x = 3"),
        ("zeta_y = 0.008", "zeta_y = 3"),
        ("zeta_theta = 0.03", "zeta_theta = 3"),
    ];
    for (file, edits, modes) in [("stiff.toml", &[][..], 4), ("detuned.toml", &overdamped, 6)] {
        let edits = [edits, &[("step = 0.5", "step = 10")]].concat();
        let (case, table) = shipped_case(file, &edits);
        let comparison = compare(&case, &table).expect("an answer");
        let most = comparison
            .points
            .iter()
            .map(|point| point.modes.len())
            .max();
        assert_eq!(most, Some(modes));
        let figures = gallery::figures(&case, &table).expect("figures").figures;
        for name in ["damping_of_modes", "frequencies_of_modes"] {
            let figure = figures.iter().find(|(own, _)| own == name);
            let (_, figure) = figure.expect("a figure");
            let drawn = figure
                .curves
                .iter()
                .flat_map(|curve| &curve.pieces)
                .flatten()
                .count();
            let all = comparison
                .points
                .iter()
                .map(|point| point.modes.len())
                .sum::<usize>();
            assert_eq!(drawn, all, "{name} of {file}");
        }
    }
}

#[test]
fn what_is_printed_holds_what_is_exact() {
    for (name, ..) in VARIANTS {
        let compared = compared(name);
        let rows = csv::comparison(&compared);
        for (row, point) in rows.lines().skip(1).zip(&compared.points) {
            let cells: Vec<&str> = row.split(',').collect();
            let number = |place: usize| cells[place].parse::<f64>().ok();
            for (value, printed, bound) in [
                (Some(point.exact), number(1), number(5)),
                (point.companion, number(2), number(6)),
            ] {
                let Some(value) = value else {
                    assert_eq!((printed, bound), (None, None));
                    continue;
                };
                let (printed, bound) = (printed.expect("a number"), bound.expect("a bound"));
                assert!(
                    (printed - value.value).abs() + value.error <= bound * (1.0 + 1e-9),
                    "{row}: {value:?}"
                );
            }
        }
    }
}
