//! Many sections by every method: several of them at once where functions are emitted, else one after the other.

use std::f64::consts::TAU;

use super::closed_form::Estimate;
use super::columns::{Columns, Results, norms};
use super::companion;
use super::comparison::{Value, modes_of};
use super::coordinate::Coordinate;
use super::eigenvalue::{Eigenvalue, Spectrum, damping_coefficient, largest_real_part};
use super::error::StabilityError;
use super::exact_modes::{self, ExactModes};
use super::forces::Forces;
use super::forces::Matrix;
use super::given::Given;
use super::limitation::Limitation;
use super::modal::Modal;
use super::model::Model;
use super::section::{Parameters, Section};
use super::shape::free_shape;
use super::tracking::mostly;
use super::uniform_form::Order;

/// Sections in columns, with their S_a.
#[derive(Clone, Debug)]
pub(super) struct Batch {
    columns: Columns,
    scaled_damping: Results<9>,
}

/// The frequency in Hz of the mode with the least damping, and the coordinate that moves most in it.
pub(super) type Critical = (f64, Coordinate);

impl Batch {
    /// These sections, which are possible ones.
    pub fn new(columns: Columns) -> Self {
        let scaled_damping = columns.given().scaled_damping_columns();
        Batch {
            columns,
            scaled_damping,
        }
    }

    /// Sections that are alike in which coordinates are free, and how their forces are given.
    pub fn of(sections: &[Section]) -> Self {
        let given: Vec<_> = sections
            .iter()
            .map(|own| Given::of(own.parameters()))
            .collect();
        let nothing = || Given::of(&Parameters::default());
        let alike = given.first().copied().unwrap_or_else(nothing);
        let mut columns = Columns::like(&alike, sections.len());
        for own in &given {
            let row = own.flattened().1;
            columns.extend(&row, &vec![None; row.len()], 1);
        }
        Batch::new(columns)
    }

    /// How many sections there are.
    pub fn rows(&self) -> usize {
        self.columns.given().rows()
    }

    /// One of them.
    pub fn parameters(&self, row: usize) -> Parameters {
        self.columns.row(row).parameters
    }

    fn s_a(&self) -> Matrix<&[f64]> {
        let [xx, xy, xt, yx, yy, yt, tx, ty, tt] = self.scaled_damping.columns();
        [[xx, xy, xt], [yx, yy, yt], [tx, ty, tt]]
    }

    /// |S_a| of each.
    pub fn sizes(&self) -> Vec<f64> {
        norms(&self.s_a())
    }

    /// S by the closed forms (21) to (23).
    pub fn closed_forms<L: FromIterator<Limitation> + Clone>(&self) -> Vec<Estimate<L>> {
        self.columns.given().closed_forms(&self.s_a())
    }

    /// S by uniform forms.
    pub fn uniform_forms<L: FromIterator<Limitation> + Clone, const N: usize>(
        &self,
        orders: [Order; N],
    ) -> [Vec<Estimate<L>>; N] {
        let modal: Vec<_> = (0..self.rows())
            .map(|row| Modal::new(&self.damped(row)))
            .collect();
        orders.map(|order| self.columns.given().uniform_forms(order, &modal))
    }

    /// One of the sections, with the S_a that is known.
    fn damped(&self, row: usize) -> Given<f64> {
        let mut given = self.columns.row(row);
        let s_a = self.s_a().map(|own| own.map(|column| column[row]));
        given.parameters.forces = Forces::ScaledDamping(s_a);
        given
    }

    /// S by the companion matrix.
    pub fn companion(&self) -> Vec<Option<Value>> {
        let coefficient = |row: usize| {
            let model = model(&self.parameters(row)).ok()?;
            coefficient(&companion::eigenvalues(&model).ok()?, &model)
        };
        (0..self.rows()).map(coefficient).collect()
    }

    /// One of each pair of exact eigenvalues, of sections whose directions and S_a are open by so much; `None` where
    /// the iteration has no radii, or does not apply.
    pub fn eigenvalues(&self, open: [&[f64]; 2]) -> Vec<Option<[Eigenvalue; 3]>> {
        let given = self.columns.given();
        let p = &given.parameters;
        if !p.free.are_all() || p.aerodynamic_stiffness {
            return vec![None; self.rows()];
        }
        let modes = given.exact_modes(&self.s_a(), open);
        modes.iter().map(exact_modes::eigenvalues_of).collect()
    }

    /// The same with what rounding leaves open of each.
    pub fn own_eigenvalues(&self) -> Vec<Option<[Eigenvalue; 3]>> {
        let open = |row: usize| exact_modes::open(&self.parameters(row)).into();
        let (directions, damping): (Vec<_>, Vec<_>) = (0..self.rows()).map(open).unzip();
        self.eigenvalues([&directions, &damping])
    }

    /// S by the exact eigenvalues, and the mode with the least damping: where the radii of the iteration leave too
    /// little of S certain, by [`exact_modes::eigenvalues`].
    pub fn exact(&self, open: [&[f64]; 2]) -> (Vec<Option<Value>>, Vec<Option<Critical>>) {
        let found = self.eigenvalues(open).into_iter().enumerate();
        let row = |(row, found): (usize, Option<[Eigenvalue; 3]>)| {
            let given = self.damped(row);
            match found.and_then(|own| known(&given, &own)) {
                Some((value, critical)) => (Some(value), Some(critical)),
                None => model(&self.parameters(row)).map_or((None, None), |model| alone(&model)),
            }
        };
        found.map(row).unzip()
    }
}

/// The model of a section.
pub(super) fn model(parameters: &Parameters) -> Result<Model, StabilityError> {
    Model::new(&Section::new(*parameters)?)
}

/// S by a spectrum.
fn coefficient(spectrum: &Spectrum, model: &Model) -> Option<Value> {
    let (value, error) = spectrum.damping_coefficient(model.section())?;
    Some(Value { value, error })
}

/// By these eigenvalues; `None` where they leave too little of S certain.
fn known(given: &Given<f64>, found: &[Eigenvalue; 3]) -> Option<(Value, Critical)> {
    let p = &given.parameters;
    let coefficient = damping_coefficient(p, largest_real_part(found));
    let (value, error) = coefficient.filter(|_| exact_modes::are_enough(coefficient))?;
    let values = found.iter().map(|own| own.value);
    let critical = values.max_by(|one, other| one.re.total_cmp(&other.re))?;
    let shape = free_shape(given, critical);
    let critical = (critical.im / TAU, mostly(p.free.as_slice(), &shape));
    Some((Value { value, error }, critical))
}

/// By the eigenvalues of a section alone.
fn alone(model: &Model) -> (Option<Value>, Option<Critical>) {
    let Ok(ExactModes { spectrum, .. }) = exact_modes::eigenvalues(model) else {
        return (None, None);
    };
    let modes = modes_of(model, &spectrum).into_iter().map(|(mode, _)| mode);
    let critical = modes.max_by(|one, other| one.value.re.total_cmp(&other.value.re));
    let critical = critical.map(|own| (own.frequency(), own.mostly(model.section())));
    (coefficient(&spectrum, model), critical)
}
