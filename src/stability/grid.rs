//! A case at all combinations of values of some of its quantities.

use super::axis::Axis;
use super::case::Case;
use super::closed_form::{Estimate, closed_form_of};
use super::coefficient_table::CoefficientTable;
use super::companion;
use super::comparison::{NO_WIND, Value, modes_of};
use super::coordinate::Coordinate;
use super::given::Given;
use super::input::{InputError, Place};
use super::interpolation::CoefficientCurves;
use super::model::Model;
use super::section::{Parameters, Section};
use super::state_matrix;
use super::uniform_form::uniform_form;
use super::variable::Variable;

/// The most points of a grid.
pub const MOST_POINTS: u64 = 1_000_000_000;

/// The methods that are asked at each point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Methods {
    /// The state matrix, Eq. (16).
    pub exact: bool,
    /// The companion matrix of the characteristic polynomial, Eq. (19).
    pub companion: bool,
    /// The closed forms, Eqs. (21)–(23).
    pub closed: bool,
    /// The uniform form, for every eccentricity.
    pub uniform: bool,
}

/// What a row of a grid stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rows {
    /// A combination of values with an angle.
    Points,
    /// A combination of values: the angle with the smallest S.
    WorstAngles,
}

/// What the methods say at a point of a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct GridPoint {
    /// The values of the axes, in order; that of the angle, in degrees, last: NaN if none is the worst.
    pub values: Vec<f64>,
    /// S by the state matrix; `None` if it is not asked, or has no bounded answer.
    pub exact: Option<Value>,
    /// S by the companion matrix.
    pub companion: Option<Value>,
    /// S by the closed forms (21)–(23).
    pub closed: Estimate,
    /// S by the uniform form.
    pub uniform: Estimate,
    /// The frequency in Hz of the mode with the least damping, and the coordinate that moves most in it.
    pub critical: Option<(f64, Coordinate)>,
}

/// A case at all combinations of the values of its axes, computed point by point: nothing of it is kept.
#[derive(Clone, Debug)]
pub struct Grid<'a> {
    case: &'a Case,
    axes: Vec<Axis>,
    /// The case at each angle.
    angles: Vec<Given<f64>>,
    /// Whether an axis turns the section or its aerodynamic centre.
    turns: bool,
    rows: Rows,
    methods: Methods,
}

impl<'a> Grid<'a> {
    /// A grid of a case.
    ///
    /// The first axis changes slowest. The angle of attack is the last one whatever its place, with the
    /// values of the case's sweep if it is not among the axes.
    ///
    /// # Errors
    ///
    /// If two axes set the same quantity or one sets nothing, if there are more than [`MOST_POINTS`]
    /// points, if an angle is outside of the table, or if a section at a corner of the grid is not possible
    /// or has no wind: else none within is in doubt.
    pub fn new(
        case: &'a Case,
        table: &CoefficientTable,
        mut axes: Vec<Axis>,
        rows: Rows,
        methods: Methods,
    ) -> Result<Self, InputError> {
        let wrong = |what: String, help: &str| InputError::new(Place::file(&case.file), what, help);
        for (place, axis) in axes.iter().enumerate() {
            let name = axis.variable.name;
            let clash = axes[..place]
                .iter()
                .find(|other| axis.variable.clashes(other.variable));
            if let Some(other) = clash {
                let what = match other.variable.name == name {
                    true => format!("{name} is varied twice"),
                    false => format!("{} and {name} set the same quantity", other.variable.name),
                };
                return Err(wrong(what, "vary every quantity by one name"));
            }
            let mut set = case.set.iter().map(|own| own.variable);
            if let Some(other) = set.find(|own| own.clashes(axis.variable)) {
                let what = format!("{name} is varied, and {} is set", other.name);
                return Err(wrong(what, "vary a quantity or set it"));
            }
            if axis.variable.is_held(&case.parameters) {
                let what = format!("{name} does nothing: its coordinate is held");
                return Err(wrong(what, "see `free` in the case"));
            }
        }
        if !axes.iter().any(|axis| axis.variable.is_angle()) {
            axes.push(Axis::at(Variable::ANGLE, case.angles.values()));
        }
        axes.sort_by_key(|axis| axis.variable.is_angle());
        let mut counts = axes.iter().map(|axis| axis.values().len() as u64);
        let points = counts.try_fold(1_u64, |points, count| points.checked_mul(count));
        if points.is_none_or(|points| points > MOST_POINTS) {
            let what = format!("the grid has more than {MOST_POINTS} points");
            return Err(wrong(what, "take fewer values, or sweep a part of it"));
        }
        let mut grid = Grid {
            case,
            axes,
            angles: Vec::new(),
            turns: false,
            rows,
            methods,
        };
        grid.angles = grid.case_at_angles(table)?;
        grid.turns = grid.turns();
        grid.check_corners()?;
        Ok(grid)
    }

    /// The case at all angles, which must be in the table.
    fn case_at_angles(&self, table: &CoefficientTable) -> Result<Vec<Given<f64>>, InputError> {
        let curves = CoefficientCurves::new(table, self.case.interpolation);
        let (angles, _) = self.angles_and_others();
        let at = |&angle: &f64| {
            let coefficients = curves.at(angle).map_err(|outside| {
                let help = "vary alpha_deg within the table, or complete it";
                InputError::new(Place::file(table.file()), outside.to_string(), help)
            })?;
            Ok(Given::of(&self.case.parameters_at(angle, coefficients)))
        };
        angles.iter().map(at).collect()
    }

    /// Whether directions depend on an axis besides the angle.
    fn turns(&self) -> bool {
        let (_, others) = self.angles_and_others();
        let mut moved = Parameters::default();
        for axis in others {
            axis.variable.set(&mut moved, f64::NAN);
        }
        let given = Given::of(&moved);
        let directions = [given.wind, given.mass_centre, given.aerodynamic_centre];
        directions.as_flattened().iter().any(|own| own.is_nan())
    }

    /// All corners are possible sections.
    fn check_corners(&self) -> Result<(), InputError> {
        let (_, others) = self.angles_and_others();
        // Each limit is on one quantity, or on L_g against r: the corners keep it if all points do.
        let mut corners = vec![Vec::new()];
        for axis in others {
            let values = axis.values();
            let mut ends = vec![values[0], values[values.len() - 1]];
            ends.dedup();
            let with = |corner: &Vec<f64>| -> Vec<Vec<f64>> {
                ends.iter()
                    .map(|&end| [corner.as_slice(), &[end]].concat())
                    .collect()
            };
            corners = corners.iter().flat_map(with).collect();
        }
        for corner in corners {
            let refuse = |error: &str| {
                let named = others.iter().zip(&corner);
                let named = named.map(|(axis, value)| format!("{} = {value}", axis.variable.name));
                let what = match others.is_empty() {
                    true => format!("the case as it is: {error}"),
                    false => format!("with {}: {error}", named.collect::<Vec<_>>().join(", ")),
                };
                InputError::new(
                    Place::file(&self.case.file),
                    what,
                    "correct --vary or the case",
                )
            };
            let parameters = self.given(&corner, 0).parameters;
            Section::new(parameters).map_err(|error| refuse(&error.to_string()))?;
            if parameters.wind_speed == 0.0 {
                return Err(refuse(NO_WIND));
            }
        }
        Ok(())
    }

    fn angles_and_others(&self) -> (&[f64], &[Axis]) {
        match self.axes.split_last() {
            Some((angles, others)) => (angles.values(), others),
            None => (&[], &[]),
        }
    }

    /// The quantities in the order of a point's values, the angle last.
    pub fn variables(&self) -> impl Iterator<Item = Variable> {
        self.axes.iter().map(|axis| axis.variable)
    }

    /// The methods that are asked.
    pub fn methods(&self) -> Methods {
        self.methods
    }

    /// How many rows there are.
    pub fn rows(&self) -> u64 {
        let (angles, others) = self.angles_and_others();
        let combinations: u64 = others
            .iter()
            .map(|axis| axis.values().len() as u64)
            .product();
        match self.rows {
            Rows::Points => combinations * angles.len() as u64,
            Rows::WorstAngles => combinations,
        }
    }

    /// At how many points the methods are asked for a row.
    pub fn points_in_a_row(&self) -> u64 {
        match self.rows {
            Rows::Points => 1,
            Rows::WorstAngles => self.angles_and_others().0.len() as u64,
        }
    }

    /// The row with a number from 0; beyond the last one they begin again.
    pub fn row(&self, number: u64) -> GridPoint {
        match self.rows {
            Rows::Points => self.point(number),
            Rows::WorstAngles => self.worst(number),
        }
    }

    /// The angle with the smallest S by one method for all of them: the first of state matrix, companion
    /// matrix, uniform form and closed forms that is asked. No angle where it has no answer at any.
    fn worst(&self, combination: u64) -> GridPoint {
        let angles = self.angles_and_others().0.len() as u64;
        let points = (0..angles).map(|angle| self.point(combination * angles + angle));
        let size = |point: &GridPoint| {
            let value = match self.methods {
                Methods { exact: true, .. } => point.exact.map(|own| own.value),
                Methods {
                    companion: true, ..
                } => point.companion.map(|own| own.value),
                Methods { uniform: true, .. } => point.uniform.value,
                _ => point.closed.value,
            };
            value.unwrap_or(f64::INFINITY)
        };
        let worse = |one: GridPoint, other: GridPoint| {
            if size(&other) < size(&one) {
                other
            } else {
                one
            }
        };
        let mut worst = points.reduce(worse).unwrap_or_else(|| self.point(0));
        if size(&worst) == f64::INFINITY {
            worst.critical = None;
            if let Some(angle) = worst.values.last_mut() {
                *angle = f64::NAN;
            }
        }
        worst
    }

    fn point(&self, number: u64) -> GridPoint {
        let mut values = vec![0.0; self.axes.len()];
        let mut rest = number;
        for (value, axis) in values.iter_mut().zip(&self.axes).rev() {
            let count = axis.values().len() as u64;
            *value = axis.values()[(rest % count) as usize];
            rest /= count;
        }
        let given = self.given(&values, (number % self.angles.len() as u64) as usize);
        let mut point = GridPoint {
            values,
            exact: None,
            companion: None,
            closed: Estimate::default(),
            uniform: Estimate::default(),
            critical: None,
        };
        if self.methods.closed {
            point.closed = Estimate::new(&given.parameters, closed_form_of(&given));
        }
        if self.methods.exact || self.methods.companion || self.methods.uniform {
            self.answer(&given.parameters, &mut point);
        }
        point
    }

    /// The case with these values, at the angle of this place.
    fn given(&self, values: &[f64], angle: usize) -> Given<f64> {
        let mut given = self.angles[angle];
        for (axis, &value) in self.axes.iter().zip(values) {
            axis.variable.set(&mut given.parameters, value);
        }
        match self.turns {
            true => Given::of(&given.parameters),
            false => given,
        }
    }

    /// What the methods say that take a model.
    fn answer(&self, parameters: &Parameters, point: &mut GridPoint) {
        let model = Section::new(*parameters).and_then(|section| Model::new(&section));
        let Ok(model) = model else {
            return;
        };
        let section = model.section();
        let value = |(value, error)| Value { value, error };
        if self.methods.uniform {
            point.uniform = Estimate::new(parameters, uniform_form(&model));
        }
        if self.methods.companion {
            let spectrum = companion::eigenvalues(&model).ok();
            point.companion = spectrum
                .and_then(|own| own.damping_coefficient(section))
                .map(value);
        }
        if !self.methods.exact {
            return;
        }
        if let Ok(spectrum) = state_matrix::eigenvalues(&model) {
            point.exact = spectrum.damping_coefficient(section).map(value);
            let modes = modes_of(&model, &spectrum)
                .into_iter()
                .map(|(mode, _)| mode);
            let critical = modes.max_by(|one, other| one.value.re.total_cmp(&other.value.re));
            point.critical = critical.map(|mode| (mode.frequency(), mode.mostly(section)));
        }
    }
}
