//! Rows of many sections at once are those of each section alone.

use std::ops::Range;

use sextic::stability::axis::Axis;
use sextic::stability::case::Case;
use sextic::stability::closed_form::closed_form;
use sextic::stability::coefficient_table::CoefficientTable;
use sextic::stability::exact_modes;
use sextic::stability::grid::{Grid, GridRows, Methods, Rows};
use sextic::stability::interpolation::CoefficientCurves;
use sextic::stability::limitation::Limits;
use sextic::stability::model::Model;
use sextic::stability::section::Section;
use sextic::stability::uniform_form::uniform_form;
use sextic::stability::variable::Variable;

const ALL: Methods = Methods {
    exact: true,
    companion: false,
    closed: true,
    uniform: true,
};

fn case(name: &str) -> (Case, CoefficientTable) {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/cases");
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).expect("a file");
    let case = Case::read(name, &read(name)).expect("a case");
    let table = CoefficientTable::read(&case.coefficients, &read(&case.coefficients));
    (case, table.expect("a table"))
}

fn axes(varied: &[(&str, f64, f64, usize)]) -> Vec<Axis> {
    let axis = |&(name, from, to, count): &(&str, f64, f64, usize)| {
        let variable = Variable::named(name).expect("a variable");
        Axis::new(variable, from, to, count).expect("an axis")
    };
    varied.iter().map(axis).collect()
}

/// The sections of a grid of one axis and the angle, one by one: what is varied is set in the text of the case.
fn alone(name: &str, key: &str, values: &[f64], angles: &[f64]) -> Vec<Section> {
    let (case, table) = case(name);
    let curves = CoefficientCurves::new(&table, case.interpolation).expect("curves");
    let text = std::fs::read_to_string(
        std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("derivations/cases")
            .join(name),
    );
    let text = text.expect("a file");
    let mut sections = Vec::new();
    for value in values {
        let is_key = |line: &str| line.split('=').next().is_some_and(|own| own.trim() == key);
        let line = |line: &str| match is_key(line) {
            true => format!("{key} = {value:?}"),
            false => line.to_string(),
        };
        let lines: Vec<String> = text.lines().map(line).collect();
        let varied = Case::read(name, &lines.join("\n")).expect("a case");
        for angle in angles {
            let coefficients = curves.at(*angle).expect("within the table");
            sections.push(varied.section(*angle, coefficients).expect("a section"));
        }
    }
    sections
}

/// Rows `range` of a grid are those of the sections alone.
fn are_those_alone(found: &GridRows, sections: &[Section], range: Range<usize>) {
    assert_eq!(found.closed.len(), range.len());
    assert_eq!(found.exact.len(), range.len());
    for (row, section) in sections[range].iter().enumerate() {
        let (value, limits) = match closed_form(section) {
            Ok(form) => (
                section.damping_coefficient(form.largest_real_part()),
                form.warnings.into_iter().collect::<Limits>(),
            ),
            Err(limitation) => (None, [limitation].into_iter().collect()),
        };
        assert_eq!(found.closed[row].value, value, "{section:?}");
        assert_eq!(
            found.closed[row].limitations.words(),
            limits.words(),
            "{section:?}"
        );
        let model = Model::new(section).expect("a model");
        let uniform = uniform_form(&model).expect("it applies");
        let part = uniform.largest_real_part();
        let own = &found.uniform[row];
        assert_eq!(own.value, section.damping_coefficient(part), "{section:?}");
        let warnings = uniform.warnings.into_iter().collect::<Limits>();
        assert_eq!(own.limitations.words(), warnings.words(), "{section:?}");
        let spectrum = exact_modes::eigenvalues_for_tables(&model).expect("eigenvalues");
        let exact = spectrum.damping_coefficient(section);
        assert_eq!(
            found.exact[row].map(|own| (own.value, own.error)),
            exact,
            "{section:?}"
        );
        let (frequency, _) = found.critical[row].expect("a mode");
        let values = spectrum.one_of_each_pair().map(|own| own.value);
        let critical = values
            .max_by(|a, b| a.re.total_cmp(&b.re))
            .expect("an eigenvalue");
        assert_eq!(frequency, critical.im / std::f64::consts::TAU);
    }
}

#[test]
fn rows_do_not_depend_on_how_many_are_computed_at_once() {
    let angles = [0.0, 30.0, 60.0, 90.0, 120.0];
    for (name, key, from, to) in [
        ("tuned.toml", "U", 2.0, 40.0),
        ("tuned.toml", "L_g", 0.0, 0.01),
        // It changes S_a.
        ("tuned.toml", "r", 0.01, 0.05),
        // It turns with the angle.
        ("tuned.toml", "alpha_g_deg", 0.0, 50.0),
        ("detuned.toml", "gamma_r_deg", 0.0, 50.0),
        ("detuned.toml", "zeta_y", 0.0, 0.02),
        ("stiff.toml", "U", 2.0, 40.0),
    ] {
        let (case, table) = case(name);
        for angles in [&angles[..], &angles[1..2]] {
            let ends = [angles[0], angles[angles.len() - 1]];
            let varied = [
                (key, from, to, 7),
                ("alpha_deg", ends[0], ends[1], angles.len()),
            ];
            let grid = Grid::new(&case, &table, axes(&varied), Rows::Points, ALL).expect("a grid");
            let sections = alone(name, key, axes(&varied)[0].values(), angles);
            let rows = sections.len();
            assert_eq!(grid.rows(), rows as u64);
            for range in [0..rows, 0..1, 3..rows, rows - 2..rows, 2..2] {
                let found = grid.rows_at(range.start as u64..range.end as u64);
                are_those_alone(&found, &sections, range);
            }
        }
    }
}
