//! The generated evaluators in batches, against C written by hand and against an eigenvalue solve.
//!
//! All contenders of a table take turns, which divan has no way to do: on a machine that is shared only
//! the ratios of such turns mean something.
#![allow(missing_docs, non_snake_case, clippy::unwrap_used)]

mod agreement;
mod hand_written;
mod section;
mod side_by_side;

use std::hint::black_box;

use hand_written::HandWritten;
use nalgebra::Matrix6;
use section::{Column, Frequencies, Sections};
use sextic_evaluators::characteristic_polynomial::{
    CharacteristicPolynomialSlices, CharacteristicPolynomialSlicesMut,
    characteristic_polynomial_batch_at,
};
use sextic_evaluators::closed_form::{
    ClosedFormSlices, ClosedFormSlicesMut, closed_form_batch, closed_form_batch_at,
};
use sextic_evaluators::dispatch::{Level, Mode};
use side_by_side::{Contender, compare};

/// Points of a batch of closed forms.
const CLOSED_FORMS: usize = 4096;

/// Points of a batch of characteristic polynomials: 25 inputs and 7 outputs of each stay in the cache.
const POLYNOMIALS: usize = 256;

const MODES: [(Mode, &str); 2] = [(Mode::Strict, "strict"), (Mode::Fused, "fused")];

macro_rules! slices {
    ($type:ident of $sections:ident: $($field:ident)*) => {
        $type { $($field: $sections.of(stringify!($field)),)* }
    };
}

fn main() {
    let tuned = Sections::draw(CLOSED_FORMS, Frequencies::Equal);
    closed_forms(&tuned);
    let sections = Sections::draw(POLYNOMIALS, Frequencies::Any);
    polynomials(&sections);
}

/// Results by output.
struct Results<const N: usize>([Column; N]);

impl<const N: usize> Results<N> {
    fn of(points: usize) -> Self {
        // Behind the 28 quantities of the sections.
        Results(std::array::from_fn(|place| {
            Column::zeros(points, 34 + place)
        }))
    }
}

impl Results<3> {
    fn slices(&mut self) -> ClosedFormSlicesMut<'_> {
        let [lamda_R1, lamda_R2, lamda_R3] = &mut self.0;
        ClosedFormSlicesMut {
            lamda_R1,
            lamda_R2,
            lamda_R3,
        }
    }
}

impl Results<7> {
    fn slices(&mut self) -> CharacteristicPolynomialSlicesMut<'_> {
        let [c_0, c_1, c_2, c_3, c_4, c_5, c_6] = &mut self.0;
        CharacteristicPolynomialSlicesMut {
            c_0,
            c_1,
            c_2,
            c_3,
            c_4,
            c_5,
            c_6,
        }
    }
}

/// The eigenvalue solve at the first points; making the matrices is not timed.
///
/// That the solve ends is known before: it has no bound of its steps, but does not compute the vectors,
/// which that with a bound does.
fn solving<'a>(matrices: &'a [Matrix6<f64>]) -> Contender<'a> {
    Contender::new("6x6 eigenvalues, nalgebra", matrices.len(), move || {
        for matrix in matrices {
            black_box(black_box(matrix).complex_eigenvalues());
        }
    })
}

fn closed_forms(sections: &Sections) {
    let inputs = slices!(ClosedFormSlices of sections:
        m r L_g cos_alpha_g_plus_theta_0 sin_alpha_g_plus_theta_0 rho D U
        S_xx S_xy S_yx S_yy S_xt S_yt S_tx S_ty S_tt);
    let matrices: Vec<Matrix6<f64>> = (0..64).map(|point| sections.state_matrix(point)).collect();
    let found = matrices.iter().map(section::eigenvalues_if_found);
    assert!(found.into_iter().all(|found| found.is_some()));
    let hand = HandWritten::build(&["-O3", "-march=native"]);
    let mut contenders = Vec::new();
    if let Some(hand) = &hand {
        let mut results = Results::<3>::of(CLOSED_FORMS);
        hand.run(&inputs, &mut results.slices());
        agreement::of_closed_forms(&inputs, &results.slices());
        let name = "C by hand, gcc -O3 -march=native";
        contenders.push(Contender::new(name, CLOSED_FORMS, move || {
            hand.run(black_box(&inputs), &mut results.slices());
            black_box(&results.0);
        }));
    }
    for level in Level::available() {
        for (mode, name) in MODES {
            let mut results = Results::<3>::of(CLOSED_FORMS);
            let name = format!("{level}, {name}");
            contenders.push(Contender::new(name, CLOSED_FORMS, move || {
                let outputs = &mut results.slices();
                closed_form_batch_at(level, black_box(&inputs), outputs, mode).unwrap();
                black_box(&results.0);
            }));
        }
    }
    compare("closed_form, 4096 points", contenders);

    let mut results = Results::<3>::of(CLOSED_FORMS);
    let batch = Contender::new("closed_form, strict", CLOSED_FORMS, move || {
        let outputs = &mut results.slices();
        closed_form_batch(black_box(&inputs), outputs, Mode::Strict).unwrap();
        black_box(&results.0);
    });
    compare("closed_form", vec![solving(&matrices), batch]);
}

fn polynomials(sections: &Sections) {
    let inputs = slices!(CharacteristicPolynomialSlices of sections:
        m r L_g cos_alpha_0 sin_alpha_0 cos_alpha_g_plus_theta_0 sin_alpha_g_plus_theta_0
        cos_gamma_r_plus_theta_0 sin_gamma_r_plus_theta_0 omega_x omega_y omega_theta
        zeta_x zeta_y zeta_theta rho D U L_a C_D C_L dC_D dC_L C_M dC_M);
    let points = 0..POLYNOMIALS;
    let matrices: Vec<Matrix6<f64>> = points.map(|point| sections.state_matrix(point)).collect();
    let mut results = Results::<7>::of(POLYNOMIALS);
    let outputs = &mut results.slices();
    characteristic_polynomial_batch_at(Level::best(), &inputs, outputs, Mode::Strict).unwrap();
    agreement::of_polynomials(&matrices, outputs);

    let mut contenders = vec![solving(&matrices)];
    for level in Level::available() {
        for (mode, name) in MODES {
            let mut results = Results::<7>::of(POLYNOMIALS);
            let name = format!("{level}, {name}");
            contenders.push(Contender::new(name, POLYNOMIALS, move || {
                let (inputs, outputs) = (black_box(&inputs), &mut results.slices());
                characteristic_polynomial_batch_at(level, inputs, outputs, mode).unwrap();
                black_box(&results.0);
            }));
        }
    }
    compare("characteristic_polynomial, 256 points", contenders);
}
