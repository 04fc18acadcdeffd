//! A section at many angles by every method, and a sweep by closed form.
//!
//! All contenders of a table take turns, as in `evaluators`.
#![allow(missing_docs, clippy::unwrap_used)]

mod side_by_side;

use std::hint::black_box;
use std::io::Write as _;

use nalgebra::Schur;
use num_complex::Complex;
use rayon::prelude::*;
use sextic::report::columns::of_grid;
use sextic::report::csv::{comparison, rows};
use sextic::stability::axis::Axis;
use sextic::stability::case::Case;
use sextic::stability::closed_form::{closed_form, inputs};
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
use sextic::stability::{companion, cubic, state_matrix};
use sextic_evaluators::closed_form::closed_form as closed_form_evaluator;
use sextic_evaluators::modal_damping::{ModalDampingInputs, modal_damping};
use sextic_evaluators::uniform_cubic::{UniformCubicInputs, uniform_cubic};
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
    uniform_forms(
        &Case::read("tuned.toml", &read("tuned.toml")).unwrap(),
        &table,
    );
    sweep(
        &Case::read("tuned.toml", &read("tuned.toml")).unwrap(),
        &table,
    );
}

/// The sections of a case at all its angles, and their models.
fn sections_and_models(case: &Case, table: &CoefficientTable) -> (Vec<Section>, Vec<Model>) {
    let curves = CoefficientCurves::new(table, case.interpolation).expect("curves");
    let section = |angle: f64| case.section(angle, curves.at(angle).unwrap()).unwrap();
    let sections = case.angles.values().into_iter().map(section);
    sections.map(|own| (own, Model::new(&own).unwrap())).unzip()
}

/// Everything that `sextic stability` computes, and its parts.
fn all_methods(case: &Case, table: &CoefficientTable) {
    let (sections, models) = sections_and_models(case, table);
    let spectra: Vec<_> = models
        .iter()
        .map(|model| state_matrix::eigenvalues(model).unwrap())
        .collect();
    let matrices: Vec<_> = models.iter().map(Model::state_matrix).collect();
    let count = sections.len();
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

/// The closed forms and one complex cubic, and the uniform form of the second order, for perfect tuning: by what
/// is compiled; and by the library, which finds the modes of any frequencies.
fn uniform_forms(case: &Case, table: &CoefficientTable) {
    let (sections, models) = sections_and_models(case, table);
    let closed: Vec<_> = sections.iter().map(inputs).collect();
    let uniform: Vec<_> = sections.iter().map(modal_damping_inputs).collect();
    let cubics: Vec<_> = uniform.iter().map(second_order_cubic).collect();
    for ((inputs, cubic), model) in uniform.iter().zip(&cubics).zip(&models) {
        let [a, b, c] = cubic::roots(*cubic).unwrap();
        let largest = a.re.max(b.re).max(c.re);
        let other = uniform_form(model).unwrap().largest_real_part();
        assert!((largest - other).abs() <= 1e-12 * inputs.omega_n);
    }
    let count = sections.len();
    compare(
        "tuned.toml by closed form and by the uniform form, each angle:",
        vec![
            Contender::new("(21)-(23) and one complex cubic", count, || {
                for (inputs, coefficients) in closed.iter().zip(&cubics) {
                    black_box(closed_form_evaluator(black_box(inputs)));
                    black_box(cubic::roots(*black_box(coefficients)));
                }
            }),
            Contender::new("uniform form, second order, compiled", count, || {
                for inputs in &uniform {
                    black_box(cubic::roots(second_order_cubic(black_box(inputs))));
                }
            }),
            Contender::new("(21)-(23) alone", count, || {
                for inputs in &closed {
                    black_box(closed_form_evaluator(black_box(inputs)));
                }
            }),
            Contender::new("uniform form, any frequencies", count, || {
                for model in &models {
                    let _ = black_box(uniform_form(model));
                }
            }),
        ],
    );
}

#[allow(non_snake_case)]
fn modal_damping_inputs(section: &Section) -> ModalDampingInputs<f64> {
    let p = section.parameters();
    let own = inputs(section);
    let [zeta_x, zeta_y, zeta_theta] = p.damping_ratios;
    ModalDampingInputs {
        m: own.m,
        r: own.r,
        L_g: own.L_g,
        cos_alpha_g_plus_theta_0: own.cos_alpha_g_plus_theta_0,
        sin_alpha_g_plus_theta_0: own.sin_alpha_g_plus_theta_0,
        zeta_x,
        zeta_y,
        zeta_theta,
        rho: own.rho,
        D: own.D,
        U: own.U,
        omega_n: p.natural_frequencies[0],
        S_xx: own.S_xx,
        S_xy: own.S_xy,
        S_yx: own.S_yx,
        S_yy: own.S_yy,
        S_xt: own.S_xt,
        S_yt: own.S_yt,
        S_tx: own.S_tx,
        S_ty: own.S_ty,
        S_tt: own.S_tt,
    }
}

/// The coefficients of μ², μ and 1.
fn second_order_cubic(inputs: &ModalDampingInputs<f64>) -> [Complex<f64>; 3] {
    let own = modal_damping(inputs);
    let cubic = uniform_cubic(&UniformCubicInputs {
        second: 1.0,
        nu_2: own.nu_2,
        B_11: own.B_11,
        B_12: own.B_12,
        B_13: own.B_13,
        B_21: own.B_21,
        B_22: own.B_22,
        B_23: own.B_23,
        B_31: own.B_31,
        B_32: own.B_32,
        B_33: own.B_33,
        Delta_1: own.Delta_1,
        Delta_3: own.Delta_3,
    });
    [
        Complex::new(cubic.re_1, cubic.im_1),
        Complex::new(cubic.re_2, cubic.im_2),
        Complex::new(cubic.re_3, cubic.im_3),
    ]
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
    let all = 0..grid.rows();
    let columns = of_grid(&grid, all.clone());
    let text = rows(&columns);
    let mut file = tempfile::tempfile().unwrap();
    compare(
        "a sweep by closed form, a row:",
        vec![
            Contender::new("computed", POINTS, || {
                for start in all.clone().step_by(1024) {
                    black_box(grid.rows_at(start..(start + 1024).min(all.end)));
                }
            }),
            Contender::new("set as text", POINTS, || {
                black_box(rows(black_box(&columns)));
            }),
            Contender::new("written to a file", POINTS, || {
                std::io::Seek::rewind(&mut file).unwrap();
                file.write_all(text.as_bytes()).unwrap();
            }),
            Contender::new("computed and set, on all cores", POINTS, || {
                let starts: Vec<u64> = all.clone().step_by(1024).collect();
                let part = |start: u64| rows(&of_grid(&grid, start..(start + 1024).min(all.end)));
                black_box(starts.into_par_iter().map(part).collect::<Vec<String>>());
            }),
        ],
    );
}
