//! Many sections in columns, a number of each in a row: emitted functions take several of them at once.

use std::array;

use sextic_evaluators::aerodynamic_damping::{
    AerodynamicDampingOutputs, aerodynamic_damping_batch,
};
use sextic_evaluators::closed_form::{ClosedFormOutputs, closed_form_batch};
use sextic_evaluators::damping_coefficient::{
    DampingCoefficientOutputs, damping_coefficient_batch,
};
use sextic_evaluators::dispatch::{LengthMismatch, Mode};
use sextic_evaluators::exact_modes::Modes;
use sextic_evaluators::exact_modes_batch::exact_modes_batch;
use sextic_evaluators::no_wind_modes::{NoWindModesOutputs, no_wind_modes_batch};
use sextic_evaluators::small_quantities::{SmallQuantitiesOutputs, small_quantities_batch};

use super::closed_form::{Estimate, Judged, are_tuned};
use super::forces::Forces;
use super::forces::Matrix;
use super::given::Given;
use super::limitation::Limitation;

/// Sections in columns of one length: what is the same in all of them stands in every row, too.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    /// The places of the columns.
    places: Given<usize>,
    /// Column by column, each with room for so many rows.
    cells: Vec<f64>,
    room: usize,
    rows: usize,
}

/// Numbers of a section in the order of its columns.
pub(super) type Row = Vec<f64>;

impl Columns {
    /// No sections, with room for so many, of coordinates and forces as those of this one.
    pub fn like(given: &Given<f64>, room: usize) -> Self {
        let (places, values) = given.flattened();
        Columns {
            places,
            cells: vec![f64::NAN; values.len() * room],
            room,
            rows: 0,
        }
    }

    /// Adds sections with these values, but those of other columns where `moving` has some.
    pub fn extend(&mut self, row: &Row, moving: &[Option<&[f64]>], count: usize) {
        let end = self.rows + count;
        let columns = self.cells.chunks_exact_mut(self.room.max(1));
        for ((column, value), moving) in columns.zip(row).zip(moving) {
            let cells = &mut column[self.rows..end];
            match moving {
                Some(values) => cells.copy_from_slice(values),
                None => cells.fill(*value),
            }
        }
        self.rows = end;
    }

    /// One of the sections.
    pub fn row(&self, row: usize) -> Given<f64> {
        self.places.map(|place| self.cells[place * self.room + row])
    }

    /// The sections.
    pub fn given(&self) -> Given<&[f64]> {
        self.places
            .map(|place| &self.cells[place * self.room..][..self.rows])
    }
}

/// N columns of results; no number stays where none is computed.
#[derive(Clone, Debug)]
pub(super) struct Results<const N: usize> {
    cells: Vec<f64>,
    rows: usize,
}

impl<const N: usize> Results<N> {
    /// No results yet for so many rows.
    pub fn new(rows: usize) -> Self {
        Results {
            cells: vec![f64::NAN; N * rows],
            rows,
        }
    }

    /// The columns.
    pub fn columns(&self) -> [&[f64]; N] {
        array::from_fn(|place| &self.cells[place * self.rows..][..self.rows])
    }

    pub fn columns_mut(&mut self) -> [&mut [f64]; N] {
        let mut rest = self.cells.as_mut_slice();
        array::from_fn(|_| rest.split_off_mut(..self.rows).unwrap_or_default())
    }
}

/// Columns have one length, so that no batch refuses them; what it would leave is no number.
pub(super) fn computed(batch: Result<(), LengthMismatch>) {
    debug_assert!(batch.is_ok(), "{batch:?}");
}

#[allow(non_snake_case)]
impl Given<&[f64]> {
    /// How many sections there are.
    pub fn rows(&self) -> usize {
        self.parameters.mass.len()
    }

    /// S_a, Eq. (18), row by row: as it is given, or from the coefficients.
    pub fn scaled_damping_columns(&self) -> Results<9> {
        let mut found = Results::new(self.rows());
        let c = match &self.parameters.forces {
            Forces::ScaledDamping(rows) => {
                for (column, given) in found.columns_mut().into_iter().zip(rows.as_flattened()) {
                    column.copy_from_slice(given);
                }
                return found;
            }
            Forces::Coefficients(c) => c,
        };
        let [S_xx, S_xy, S_xt, S_yx, S_yy, S_yt, S_tx, S_ty, S_tt] = found.columns_mut();
        let mut outputs = AerodynamicDampingOutputs {
            S_xx,
            S_xy,
            S_xt,
            S_yx,
            S_yy,
            S_yt,
            S_tx,
            S_ty,
            S_tt,
        };
        let inputs = self.aerodynamic_damping_inputs(c);
        computed(aerodynamic_damping_batch(
            &inputs,
            &mut outputs,
            Mode::Strict,
        ));
        found
    }

    /// S by the closed forms (21) to (23), and what speaks against it, as [`closed_form`](super::closed_form::closed_form)
    /// says it of each section.
    pub fn closed_forms<L>(&self, s_a: &Matrix<&[f64]>) -> Vec<Estimate<L>>
    where
        L: FromIterator<Limitation> + Clone,
    {
        let p = &self.parameters;
        if !p.free.are_all() {
            return vec![Estimate::without(Limitation::NotAllFree); self.rows()];
        }
        let parts = self.closed_real_parts(s_a);
        let coefficients = self.damping_coefficients(&largest(&parts));
        let coefficients = coefficients.columns()[0];
        let shares = shares(&parts, &self.squares());
        let sizes = norms(s_a);
        let small = self.small_quantities();
        let [e, delta] = small.columns();
        let estimated = |row: usize| {
            if !are_tuned(p.natural_frequencies.map(|own| own[row])) {
                return Estimate::without(Limitation::NotTuned);
            }
            let judged = Judged {
                small: SmallQuantitiesOutputs {
                    e: e[row],
                    delta: delta[row],
                },
                size: sizes[row],
                coefficient: Some(coefficients[row]).filter(|own| own.is_finite()),
                share: shares[row],
                is_damped: p.damping_ratios.iter().any(|own| own[row] > 0.0),
                is_stiffened: p.aerodynamic_stiffness,
            };
            Estimate {
                value: judged.coefficient,
                limitations: judged.limitations().into_iter().flatten().collect(),
            }
        };
        (0..self.rows()).map(estimated).collect()
    }

    /// Eqs. (21) to (23).
    fn closed_real_parts(&self, s_a: &Matrix<&[f64]>) -> Results<3> {
        let mut found = Results::new(self.rows());
        let [lamda_R1, lamda_R2, lamda_R3] = found.columns_mut();
        let mut outputs = ClosedFormOutputs {
            lamda_R1,
            lamda_R2,
            lamda_R3,
        };
        let inputs = self.closed_form_inputs(s_a);
        computed(closed_form_batch(&inputs, &mut outputs, Mode::Strict));
        found
    }

    /// The squares of the frequencies without wind, Eq. (15), if all natural ones are that of x; and the shapes.
    fn squares(&self) -> Results<12> {
        let mut found = Results::new(self.rows());
        let [
            Omega_1,
            Omega_2,
            Omega_3,
            phi_11,
            phi_12,
            phi_13,
            phi_21,
            phi_22,
            phi_23,
            phi_31,
            phi_32,
            phi_33,
        ] = found.columns_mut();
        let mut outputs = NoWindModesOutputs {
            Omega_1,
            Omega_2,
            Omega_3,
            phi_11,
            phi_12,
            phi_13,
            phi_21,
            phi_22,
            phi_23,
            phi_31,
            phi_32,
            phi_33,
        };
        let inputs = self.no_wind_modes_inputs(self.parameters.natural_frequencies[0]);
        computed(no_wind_modes_batch(&inputs, &mut outputs, Mode::Strict));
        found
    }

    /// e and δ, with the frequency of x.
    fn small_quantities(&self) -> Results<2> {
        let mut found = Results::new(self.rows());
        let [e, delta] = found.columns_mut();
        let mut outputs = SmallQuantitiesOutputs { e, delta };
        let p = &self.parameters;
        let inputs = p.small_quantities_inputs(p.natural_frequencies[0]);
        computed(small_quantities_batch(&inputs, &mut outputs, Mode::Strict));
        found
    }

    /// S of real parts in 1/s, Eq. (13).
    pub fn damping_coefficients(&self, real_parts: &[f64]) -> Results<1> {
        let mut found = Results::new(self.rows());
        let [S] = found.columns_mut();
        let inputs = self.parameters.damping_coefficient_inputs(real_parts);
        let mut outputs = DampingCoefficientOutputs { S };
        computed(damping_coefficient_batch(
            &inputs,
            &mut outputs,
            Mode::Strict,
        ));
        found
    }

    /// The exact modes of each; directions and S_a are open by so much.
    pub fn exact_modes(&self, s_a: &Matrix<&[f64]>, open: [&[f64]; 2]) -> Vec<Modes<f64>> {
        let mut found = Results::<9>::new(self.rows());
        let [a, b, c, d, e, f, g, h, i] = found.columns_mut();
        let mut outputs = Modes {
            real: [a, b, c],
            frequency: [d, e, f],
            radius: [g, h, i],
        };
        let inputs = self.exact_modes_inputs(s_a, open);
        computed(exact_modes_batch(&inputs, &mut outputs, Mode::Strict));
        let modes = |row: usize| {
            let [a, b, c, d, e, f, g, h, i] = found.columns().map(|own| own[row]);
            Modes {
                real: [a, b, c],
                frequency: [d, e, f],
                radius: [g, h, i],
            }
        };
        (0..self.rows()).map(modes).collect()
    }
}

/// The largest number of each row.
fn largest(parts: &Results<3>) -> Vec<f64> {
    let [a, b, c] = parts.columns();
    let rows = a.iter().zip(b).zip(c);
    rows.map(|((a, b), c)| a.max(*b).max(*c)).collect()
}

/// The largest |λ_R|/ω of each row.
fn shares(parts: &Results<3>, squares: &Results<12>) -> Vec<f64> {
    let mut shares = vec![f64::NEG_INFINITY; parts.rows];
    for (parts, squares) in parts.columns().into_iter().zip(squares.columns()) {
        for ((share, part), square) in shares.iter_mut().zip(parts).zip(squares) {
            *share = share.max(part.abs() / square.sqrt());
        }
    }
    shares
}

/// The Frobenius norm of each row, summed in the order of [`norm`](super::forces::norm).
pub(super) fn norms(matrix: &Matrix<&[f64]>) -> Vec<f64> {
    let mut sums = vec![0.0; matrix[0][0].len()];
    for column in matrix.as_flattened() {
        for (sum, own) in sums.iter_mut().zip(*column) {
            *sum += own * own;
        }
    }
    sums.iter_mut().for_each(|own| *own = own.sqrt());
    sums
}
