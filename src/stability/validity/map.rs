//! The forms at all angles of a case, at the places of a map.

use std::ops::Range;

use rayon::prelude::*;

use super::departure::{Departure, Departures, Shift, joined, whole};
use crate::stability::axis::Axis;
use crate::stability::batch::model;
use crate::stability::case::Case;
use crate::stability::closed_form::Estimate;
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::eigenvalue::{Eigenvalue, Spectrum, damping_coefficient, largest_real_part};
use crate::stability::error::StabilityError;
use crate::stability::exact_modes;
use crate::stability::grid::{Grid, Methods, Rows};
use crate::stability::input::InputError;
use crate::stability::limitation::Limits;
use crate::stability::section::{Parameters, Section};
use crate::stability::uniform_form::Order;
use crate::stability::verdict::{Verdict, by_errors, verdict, verdict_by_errors};

/// So many sections are asked at once: their columns stay near a core.
const AT_ONCE: u64 = 1024;

/// S must be known to this share of |S_a|.
const LARGEST_BOUND: f64 = 1e-3;

/// How signs are known that the radii of the iteration leave open: by exact arithmetic where need be, or only as far
/// as the errors of the eigenvalues tell.
type Decide = fn(&Section, &Spectrum) -> Option<Verdict>;

/// A case at all combinations of the values of its axes; a place is one of them, with all angles.
pub(super) struct Map<'a> {
    grid: Grid<'a>,
    angles: Vec<f64>,
}

impl<'a> Map<'a> {
    /// # Errors
    ///
    /// Those of [`Grid::new`].
    pub fn new(
        case: &'a Case,
        table: &CoefficientTable,
        axes: Vec<Axis>,
    ) -> Result<Self, InputError> {
        let methods = Methods {
            exact: true,
            ..Methods::default()
        };
        Ok(Map {
            grid: Grid::new(case, table, axes, Rows::WorstAngles, methods)?,
            angles: case.angles.values(),
        })
    }

    /// The points of a place, a block after the other.
    fn blocks(&self, place: u64) -> impl Iterator<Item = Range<u64>> + use<> {
        let angles = self.grid.points_in_a_row();
        let end = (place + 1) * angles;
        let starts = (place * angles..end).step_by(AT_ONCE as usize);
        starts.map(move |start| start..end.min(start + AT_ONCE))
    }

    /// The largest |S_a| at the first place.
    pub fn strength(&self) -> f64 {
        let sizes = self
            .blocks(0)
            .flat_map(|block| self.grid.batch(block).sizes());
        sizes.fold(0.0, f64::max)
    }

    /// The number of angles.
    pub fn angles(&self) -> usize {
        self.angles.len()
    }

    /// The errors of the case as it is, at the first place: signs are known by exact arithmetic where need be.
    pub fn own_departures(&self) -> Result<Departures, StabilityError> {
        self.departures(0, |section, spectrum| Some(verdict(section, spectrum)))
    }

    /// The errors at each place, infinite for a form that has no answer at one of the angles.
    pub fn cells(&self) -> Vec<Result<[Departure; 3], StabilityError>> {
        let at = |place: u64| {
            let found = self.departures(place, |_, spectrum| verdict_by_errors(spectrum))?;
            Ok(whole(found, &self.angles))
        };
        (0..self.grid.rows()).into_par_iter().map(at).collect()
    }

    fn departures(&self, place: u64, decide: Decide) -> Result<Departures, StabilityError> {
        let blocks: Vec<_> = self.blocks(place).collect();
        let found = blocks
            .into_par_iter()
            .map(|block| self.of_block(block, decide));
        // The first error, not the one that was found first.
        let mut found = found.collect::<Vec<_>>().into_iter();
        found.try_fold([None; 3], |all, block| Ok(joined(all, block?)))
    }

    fn of_block(&self, block: Range<u64>, decide: Decide) -> Result<Departures, StabilityError> {
        let batch = self.grid.batch(block.clone());
        let [direction, damping] = self.grid.open(&block);
        let eigenvalues = batch.eigenvalues([&direction, &damping]);
        let [first, second] = batch.uniform_forms([Order::First, Order::Second]);
        let forms: [Vec<Estimate<Limits>>; 3] = [batch.closed_forms(), first, second];
        let sizes = batch.sizes();
        let at = |row: usize| -> Result<Departures, StabilityError> {
            let exact = || Exact::of(&batch.parameters(row), eigenvalues[row], sizes[row], decide);
            // Without forces there is nothing to be wrong about.
            let exact = (sizes[row] != 0.0).then(exact).transpose()?;
            let angle = self.angles[(block.start as usize + row) % self.angles.len()];
            let shift = |form: &Vec<Estimate<_>>| match &exact {
                Some(exact) => Some(exact.shift(form[row].value?)),
                None => Some(Shift::NONE),
            };
            let shifts = forms.each_ref().map(shift);
            Ok(shifts.map(|own| Some(Departure::of(angle, own?))))
        };
        (0..batch.rows()).try_fold([None; 3], |found, row| Ok(joined(found, at(row)?)))
    }
}

/// The exact S of a section.
struct Exact {
    value: f64,
    /// |S_a|
    size: f64,
    verdict: Option<Verdict>,
}

impl Exact {
    /// By the radii of the iteration; where they leave too much open, by the eigenvalues of the section alone.
    fn of(
        parameters: &Parameters,
        found: Option<[Eigenvalue; 3]>,
        size: f64,
        decide: Decide,
    ) -> Result<Self, StabilityError> {
        let certain = |found: [Eigenvalue; 3]| {
            let part = largest_real_part(&found);
            Exact::new(parameters, part, size, Some(by_errors(part)?)).ok()
        };
        if let Some(certain) = found.and_then(certain) {
            return Ok(certain);
        }
        let model = model(parameters)?;
        let spectrum = exact_modes::eigenvalues(&model)?.spectrum;
        let verdict = decide(model.section(), &spectrum);
        Exact::new(parameters, spectrum.largest_real_part(), size, verdict)
    }

    fn new(
        parameters: &Parameters,
        part: (f64, f64),
        size: f64,
        verdict: Option<Verdict>,
    ) -> Result<Self, StabilityError> {
        let coefficient = damping_coefficient(parameters, part);
        let (value, bound) = coefficient.ok_or(StabilityError::OutOfRange)?;
        if bound > LARGEST_BOUND * size {
            return Err(StabilityError::WeakWind);
        }
        Ok(Exact {
            value,
            size,
            verdict,
        })
    }

    fn shift(&self, value: f64) -> Shift {
        Shift::new(value, self.value, self.size, self.verdict)
    }
}
