//! The exact modes of many sections, against eigenvalue solves; what is said of their accuracy is checked first.
#![allow(missing_docs, clippy::unwrap_used)]

mod double_double;
mod mixture;
mod side_by_side;

use std::hint::black_box;

use double_double::{Complex, Double};
use nalgebra::Matrix6;
use sextic::stability::model::Model;
use sextic::stability::section::Section;
use sextic::stability::{exact_modes, state_matrix};
use sextic_evaluators::dispatch::{Level, Mode};
use sextic_evaluators::exact_modes_batch::{ModesSlicesMut, exact_modes_batch_at};
use sextic_evaluators::section_matrices::SectionMatricesInputs;
use side_by_side::{Contender, compare};

const POINTS: usize = 1024;

/// How often a batch is computed in a turn, so that its turns are about as long as those of the others and
/// as often interrupted.
const TIMES: usize = 40;

/// Real and imaginary parts and radii, three each.
type Results = Vec<Vec<f64>>;

fn main() {
    for (name, delta) in [
        ("δ from 1e-5 to 0.1, each:", (1e-5, 0.1)),
        ("δ from 1e-5 to 0.01, each:", (1e-5, 0.01)),
        ("δ from 1e-3 to 0.03, each:", (1e-3, 0.03)),
    ] {
        run(name, &mixture::sections(POINTS, delta));
    }
}

fn run(name: &str, sections: &[Section]) {
    let columns = mixture::Columns::of(sections);
    let slices = columns.slices();
    let models: Vec<Model> = sections
        .iter()
        .map(|own| Model::new(own).unwrap())
        .collect();
    let matrices: Vec<Matrix6<f64>> = models
        .iter()
        .map(|own| Matrix6::from_iterator(own.state_matrix().iter().copied()))
        .collect();
    let batch = |level: Level, mode: Mode, results: &mut Results| {
        let [a, b, c, d, e, f, g, h, i] = &mut results[..] else {
            unreachable!()
        };
        let mut modes = ModesSlicesMut {
            real: [a, b, c],
            frequency: [d, e, f],
            radius: [g, h, i],
        };
        exact_modes_batch_at(level, black_box(&slices), &mut modes, mode).unwrap();
    };
    let ways = Level::available().flat_map(|level| {
        let both = [(level, Mode::Strict), (level, Mode::Fused)];
        let count = if level == Level::BASELINE { 1 } else { 2 };
        both.into_iter().take(count)
    });
    let ways: Vec<(Level, Mode)> = ways.collect();
    for &(level, mode) in &ways {
        let mut results = vec![vec![0.0; POINTS]; 9];
        batch(level, mode, &mut results);
        check(&format!("{level}, {mode:?}"), sections, &matrices, &results);
    }
    let mut contenders = vec![Contender::new(
        "nalgebra, complex_eigenvalues",
        POINTS,
        || {
            for matrix in &matrices {
                black_box(black_box(matrix).complex_eigenvalues());
            }
        },
    )];
    for (level, mode) in ways {
        let title = format!("exact modes, {level}, {mode:?}").to_lowercase();
        let mut results = vec![vec![0.0; POINTS]; 9];
        let batch = &batch;
        contenders.push(Contender::new(title, TIMES * POINTS, move || {
            for _ in 0..TIMES {
                batch(level, mode, &mut results);
            }
        }));
    }
    contenders.push(Contender::new("one by one, with bounds", POINTS, || {
        for model in &models {
            black_box(exact_modes::eigenvalues(model).unwrap());
        }
    }));
    contenders.push(Contender::new("state matrix with bounds", POINTS, || {
        for model in &models {
            black_box(state_matrix::eigenvalues(model).unwrap());
        }
    }));
    compare(name, contenders);
}

/// Prints how far the largest real part is from the right one, over the damping, here and by nalgebra.
///
/// # Panics
///
/// If a radius is smaller than the error, if one section of a hundred has none, or if the worst error is
/// above that of nalgebra.
fn check(way: &str, sections: &[Section], matrices: &[Matrix6<f64>], results: &Results) {
    let (mut unknown, mut own_worst, mut other_worst) = (0, 0.0_f64, 0.0_f64);
    for (point, (section, matrix)) in sections.iter().zip(matrices).enumerate() {
        if results[6][point].is_infinite() {
            unknown += 1;
            continue;
        }
        let found = [0, 1, 2].map(|k| (results[k][point], results[3 + k][point]));
        let inputs = exact_modes::inputs(section).section;
        let corrections = [0, 1, 2].map(|k| correction(&inputs, &found, k));
        for (k, correction) in corrections.iter().enumerate() {
            assert!(
                correction.abs() <= results[6 + k][point],
                "{way}: {section:?}"
            );
        }
        let largest = |values: [f64; 3]| values.into_iter().fold(f64::NEG_INFINITY, f64::max);
        // As a correction to the largest computed one, which is one of those that it may be.
        let computed = largest(found.map(|(real, _)| real));
        let right = [0, 1, 2].map(|k| (found[k].0 - computed) - corrections[k]);
        let right = largest(right);
        let damping = section.relative_aerodynamic_damping() * inputs.omega_x
            + largest([inputs.zeta_x, inputs.zeta_y, inputs.zeta_theta]) * inputs.omega_x;
        own_worst = own_worst.max(right.abs() / damping);
        let values = matrix.complex_eigenvalues();
        let other = values
            .iter()
            .fold(f64::NEG_INFINITY, |most, own| most.max(own.re));
        other_worst = other_worst.max(((other - computed) - right).abs() / damping);
    }
    println!(
        "{way}: largest real part wrong by {own_worst:.1e} of the damping at most, nalgebra {other_worst:.1e}; {unknown} without radius"
    );
    assert!(unknown * 100 <= POINTS && own_worst <= other_worst);
}

/// The real part of p(λ)/Π(λ − λ_j), the distance of a root from its approximation but for the square of it.
fn correction(own: &SectionMatricesInputs<f64>, found: &[(f64, f64); 3], place: usize) -> f64 {
    let double = |value: f64| Double(value, 0.0);
    let real = |value: Double| Complex(value, double(0.0));
    // 1/r and 1/(2m) with a correction of their rounding.
    let over = |value: f64| {
        let near = 1.0 / value;
        Double(near, -near.mul_add(value, -1.0) * near)
    };
    let (re, im) = found[place];
    let lambda = Complex::new(re, im);
    let square = lambda * lambda;
    let e = double(own.L_g) * over(own.r);
    let (x, y) = (
        e * double(own.sin_alpha_g_plus_theta_0),
        e * double(own.cos_alpha_g_plus_theta_0),
    );
    let wind = double(own.rho) * double(own.D) * double(own.U) * over(2.0 * own.m);
    let off = |s: f64| lambda * real(wind * double(s));
    let diagonal = |s: f64, omega: f64, zeta: f64| {
        let damping = wind * double(s) + double(2.0 * zeta) * double(omega);
        square + lambda * real(damping) + real(double(omega) * double(omega))
    };
    let rows = [
        [
            diagonal(own.S_xx, own.omega_x, own.zeta_x),
            off(own.S_xy),
            square * real(x) + off(own.S_xt),
        ],
        [
            off(own.S_yx),
            diagonal(own.S_yy, own.omega_y, own.zeta_y),
            square * real(y) + off(own.S_yt),
        ],
        [
            square * real(x) + off(own.S_tx),
            square * real(y) + off(own.S_ty),
            diagonal(own.S_tt, own.omega_theta, own.zeta_theta),
        ],
    ];
    let minor = |i: usize, j: usize| rows[1][i] * rows[2][j] - rows[1][j] * rows[2][i];
    let value = rows[0][0] * minor(1, 2) - rows[0][1] * minor(0, 2) + rows[0][2] * minor(0, 1);
    let complex = |re: f64, im: f64| nalgebra::Complex::new(re, im);
    let mut product = complex((double(1.0) - x * x - y * y).0, 0.0);
    for (other, &(other_re, other_im)) in found.iter().enumerate() {
        if other != place {
            product *= complex(re - other_re, im - other_im);
        }
        product *= complex(re - other_re, im + other_im);
    }
    (complex(value.0.0, value.1.0) / product).re
}
