//! A section at many angles by every method, and a sweep by closed form.
//!
//! All contenders of a table take turns, as in `evaluators`.
#![allow(missing_docs, clippy::unwrap_used)]

mod side_by_side;

use std::fmt::Write as _;
use std::hint::black_box;
use std::io::Write as _;

use nalgebra::Schur;
use rayon::prelude::*;
use sextic::report::csv::{comparison, grid_row};
use sextic::stability::axis::Axis;
use sextic::stability::case::Case;
use sextic::stability::closed_form::closed_form;
use sextic::stability::coefficient_table::CoefficientTable;
use sextic::stability::comparison::compare as compare_methods;
use sextic::stability::critical_speed::speeds;
use sextic::stability::exact_section::ExactSection;
use sextic::stability::grid::{Grid, Methods, Rows};
use sextic::stability::interpolation::CoefficientCurves;
use sextic::stability::model::Model;
use sextic::stability::section::Section;
use sextic::stability::tracking::Mode;
use sextic::stability::uniform_form::uniform_form;
use sextic::stability::variable::Variable;
use sextic::stability::verdict::{exact_verdict, verdict};
use sextic::stability::{companion, state_matrix};
use side_by_side::{Contender, compare};

/// From one angle to the next in degrees: 3,600 of them on half a circle.
const STEP: &str = "step = 0.05";

/// Points of a sweep by closed form, a part of a million.
const POINTS: usize = 10_000;

fn main() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/derivations/cases/");
    let read = |name: &str| std::fs::read_to_string(format!("{folder}{name}")).unwrap();
    let table = CoefficientTable::read("formulas.csv", &read("formulas.csv")).unwrap();
    for name in ["tuned.toml", "detuned.toml"] {
        let text = read(name)
            .replace("step = 0.5", STEP)
            .replace("to = 180", "to = 179.95");
        let case = Case::read(name, &text).unwrap();
        assert_eq!(case.angles.values().len(), 3600);
        all_methods(&case, &table);
    }
    sweep(
        &Case::read("tuned.toml", &read("tuned.toml")).unwrap(),
        &table,
    );
}

/// Everything that `sextic stability` computes, and its parts.
fn all_methods(case: &Case, table: &CoefficientTable) {
    let angles = case.angles.values();
    let curves = CoefficientCurves::new(table, case.interpolation);
    let section = |angle: &f64| case.section(*angle, curves.at(*angle).unwrap()).unwrap();
    let sections: Vec<Section> = angles.iter().map(section).collect();
    let models: Vec<Model> = sections
        .iter()
        .map(|section| Model::new(section).unwrap())
        .collect();
    let spectra: Vec<_> = models
        .iter()
        .map(|model| state_matrix::eigenvalues(model).unwrap())
        .collect();
    let matrices: Vec<_> = models.iter().map(Model::state_matrix).collect();
    let count = angles.len();
    let title = format!("{} at 3,600 angles, each:", case.file);
    compare(
        &title,
        vec![
            Contender::new("all methods, modes followed, on all cores", count, || {
                black_box(compare_methods(case, table).unwrap());
            }),
            Contender::new("its table as CSV", count, {
                let compared = compare_methods(case, table).unwrap();
                move || {
                    black_box(comparison(&compared));
                }
            }),
            Contender::new("matrices with bounds", count, || {
                for section in &sections {
                    black_box(Model::new(section).unwrap());
                }
            }),
            Contender::new("state matrix with bounds", count, || {
                for model in &models {
                    black_box(state_matrix::eigenvalues(model).unwrap());
                }
            }),
            Contender::new(
                "state matrix with bounds, and a certain verdict",
                count,
                || {
                    for (section, model) in sections.iter().zip(&models) {
                        let spectrum = state_matrix::eigenvalues(model).unwrap();
                        black_box(verdict(section, &spectrum));
                    }
                },
            ),
            Contender::new("a verdict in exact arithmetic", count / 900, || {
                for section in sections.iter().step_by(900) {
                    black_box(exact_verdict(&ExactSection::from(section)));
                }
            }),
            Contender::new(
                "all critical wind speeds up to 100 m/s",
                count / 900,
                || {
                    for section in sections.iter().step_by(900) {
                        black_box(speeds(&ExactSection::from(section), 100.0));
                    }
                },
            ),
            Contender::new("companion matrix with bounds", count, || {
                for model in &models {
                    black_box(companion::eigenvalues(model).unwrap());
                }
            }),
            Contender::new("shapes of three modes", count, || {
                for (model, spectrum) in models.iter().zip(&spectra) {
                    for own in spectrum.one_of_each_pair() {
                        black_box(Mode::new(model, own.value, None));
                    }
                }
            }),
            Contender::new("closed form, and its domain", count, || {
                for section in &sections {
                    let _ = black_box(closed_form(section));
                }
            }),
            Contender::new("uniform form", count, || {
                for model in &models {
                    let _ = black_box(uniform_form(model));
                }
            }),
            Contender::new("bare eigenvalues of the state matrix", count, || {
                for matrix in &matrices {
                    black_box(
                        Schur::try_new(matrix.clone(), f64::EPSILON, 200)
                            .unwrap()
                            .complex_eigenvalues(),
                    );
                }
            }),
        ],
    );
}

/// What a row of a sweep by closed form costs.
fn sweep(case: &Case, table: &CoefficientTable) {
    let axis =
        |name: &str, from, to| Axis::new(Variable::named(name).unwrap(), from, to, 100).unwrap();
    let angle = Axis::new(Variable::ANGLE, 30.0, 30.0, 1).unwrap();
    let axes = vec![axis("L_g", 0.0, 0.01), axis("U", 2.0, 40.0), angle];
    let methods = Methods {
        exact: false,
        companion: false,
        closed: true,
        uniform: false,
    };
    let grid = Grid::new(case, table, axes, Rows::Points, methods).unwrap();
    assert_eq!(grid.rows(), POINTS as u64);
    let points: Vec<_> = (0..grid.rows()).map(|row| grid.row(row)).collect();
    let rows: Vec<String> = points.iter().map(|point| grid_row(&grid, point)).collect();
    let mut file = tempfile::tempfile().unwrap();
    compare(
        "a sweep by closed form, a row:",
        vec![
            Contender::new("computed", POINTS, || {
                for row in 0..grid.rows() {
                    black_box(grid.row(row));
                }
            }),
            Contender::new("set as text", POINTS, || {
                for point in &points {
                    black_box(grid_row(&grid, point));
                }
            }),
            Contender::new("written to a file", POINTS, || {
                std::io::Seek::rewind(&mut file).unwrap();
                for rows in rows.chunks(512) {
                    let mut text = String::new();
                    for row in rows {
                        text.write_str(row).unwrap();
                    }
                    file.write_all(text.as_bytes()).unwrap();
                }
            }),
            Contender::new("computed and set, on all cores", POINTS, || {
                let rows = (0..POINTS).into_par_iter().with_min_len(8);
                let text =
                    |text: String, row: usize| text + &grid_row(&grid, &grid.row(row as u64));
                black_box(rows.fold(String::new, text).collect::<Vec<String>>());
            }),
        ],
    );
}
