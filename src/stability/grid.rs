//! A case at all combinations of values of some of its quantities.

mod rows;

pub use rows::GridRows;

use std::ops::Range;

use super::axis::Axis;
use super::batch::Batch;
use super::case::Case;
use super::coefficient_table::CoefficientTable;
use super::columns::{Columns, Row};
use super::comparison::{NO_WIND, angle};
use super::exact_modes;
use super::given::Given;
use super::input::{InputError, Place};
use super::mean_twist::Twist;
use super::section::{Coefficients, Open, Parameters, Section};
use super::sections::Sections;
use super::uniform_form::Order;
use super::variable::Variable;

/// The most points of a grid.
pub const MOST_POINTS: u64 = 1_000_000_000;

/// The methods that are asked at each point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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

/// A case at all combinations of the values of its axes, computed as it is asked for: no row of it is kept.
///
/// Points that follow each other differ in the value of one axis, the moving one. So the columns that depend on it
/// are known once for all, and the others are the same at all of them.
#[derive(Clone, Debug)]
pub struct Grid<'a> {
    case: &'a Case,
    axes: Vec<Axis>,
    /// The values of the axes as they are shown.
    shown: Vec<Vec<f64>>,
    /// The case at each angle, without its mean twist.
    angles: Vec<Given<f64>>,
    /// What twists it, if it is twisted: at each point by itself.
    twisting: Option<Sections<'a>>,
    /// What is open of its directions and of S_a there; `None` if that depends on an axis besides the angle.
    open: Option<Vec<[f64; 2]>>,
    /// Whether an axis besides the angle turns the section or its aerodynamic centre.
    turns: bool,
    /// The place of the moving axis: the last one with several values.
    moving: usize,
    /// Its columns, at the first values of the others; `None` if another axis changes one of them, too.
    moved: Option<Moved>,
    rows: Rows,
    methods: Methods,
}

/// The columns that depend on the moving axis, with a number for each of its values.
#[derive(Clone, Debug)]
struct Moved(Vec<Option<Vec<f64>>>);

impl Moved {
    /// The values of some points.
    fn part(&self, points: Range<usize>) -> Vec<Option<&[f64]>> {
        let columns = self.0.iter().map(Option::as_deref);
        columns.map(|own| Some(&own?[points.clone()])).collect()
    }
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
            case.check_moment(axis.variable)?;
            if axis.variable.is_held(&case.parameters) {
                return Err(wrong(
                    axis.variable.does_nothing(),
                    "see `free` in the case",
                ));
            }
        }
        let is_form_alone =
            (methods.closed || methods.uniform) && !methods.exact && !methods.companion;
        if is_form_alone && !case.parameters.free.are_all() {
            let what = "the closed and the uniform form need x, y and theta to be free".into();
            let help = "leave `--method` away: the state matrix applies to every section";
            return Err(wrong(what, help));
        }
        if !case.reference.is_usual() && axes.iter().any(|own| own.variable == Variable::DIMENSION)
        {
            let what =
                "D is varied, and `reference` converts the table to the D of the case".into();
            let help = "set D: the case is then read with it; or leave `reference` out, with coefficients over D";
            return Err(wrong(what, help));
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
        let shown = |own: &Axis| match own.variable.is_angle() {
            true => own.values().iter().copied().map(angle).collect(),
            false => own.values().to_vec(),
        };
        let mut grid = Grid {
            case,
            shown: axes.iter().map(shown).collect(),
            axes,
            angles: Vec::new(),
            twisting: None,
            open: None,
            turns: false,
            moving: 0,
            moved: None,
            rows,
            methods,
        };
        let sections = Sections::new(case, table)?;
        grid.angles = grid.case_at_angles(&sections, table)?;
        grid.twisting = Some(sections).filter(Sections::are_twisted);
        grid.check_corners()?;
        if grid.twisting.is_none() {
            grid.find_what_moves();
        }
        Ok(grid)
    }

    /// Finds what depends on which axis.
    fn find_what_moves(&mut self) {
        let has_several = |own: &Axis| own.values().len() > 1;
        let last = self.axes.len() - 1;
        self.moving = self.axes.iter().rposition(has_several).unwrap_or(last);
        let probes: Vec<Given<f64>> = (0..=last).map(|axis| self.probe(axis)).collect();
        let others = &probes[..last];
        let is_nan = |own: &[f64]| own.iter().any(|own| own.is_nan());
        let turned = |own: &Given<f64>| [own.wind, own.mass_centre, own.aerodynamic_centre];
        self.turns = others.iter().any(|own| is_nan(turned(own).as_flattened()));
        let opened = |own: &Given<f64>| {
            is_nan(&own.mass_centre) || is_nan(own.scaled_damping().as_flattened())
        };
        if self.methods.exact && !others.iter().any(opened) {
            self.open = Some(
                self.angles
                    .iter()
                    .map(|own| exact_modes::open(&own.parameters))
                    .collect(),
            );
        }
        self.moved = self.moved(&probes);
    }

    /// The case at the first values of all axes, with no number for this one.
    fn probe(&self, place: usize) -> Given<f64> {
        let nothing = f64::NAN;
        let mut parameters = self.angles[0].parameters;
        if self.axes[place].variable.is_angle() {
            let nowhere = Coefficients::default().map(|_: &f64| nothing);
            parameters = self.case.parameters_at(nothing, nowhere);
        }
        for (other, axis) in self.axes.iter().enumerate() {
            let value = if other == place {
                nothing
            } else {
                axis.values()[0]
            };
            axis.variable.set(&mut parameters, value);
        }
        Given::of(&parameters)
    }

    /// The columns of the moving axis, unless another one changes one of them.
    fn moved(&self, probes: &[Given<f64>]) -> Option<Moved> {
        let moves = |own: &Given<f64>| -> Vec<bool> {
            own.flattened().1.iter().map(|own| own.is_nan()).collect()
        };
        let moves: Vec<Vec<bool>> = probes.iter().map(moves).collect();
        let is_moved = &moves[self.moving];
        let mut others = moves
            .iter()
            .enumerate()
            .filter(|(place, _)| *place != self.moving);
        let is_shared =
            |(_, other): (usize, &Vec<bool>)| is_moved.iter().zip(other).any(|(a, b)| *a && *b);
        if others.any(is_shared) {
            return None;
        }
        let count = self.axes[self.moving].values().len() as u64;
        let mut columns: Vec<Option<Vec<f64>>> =
            is_moved.iter().map(|own| own.then(Vec::new)).collect();
        for row in (0..count).map(|point| self.row_of(point)) {
            for (column, value) in columns.iter_mut().zip(row) {
                if let Some(column) = column {
                    column.push(value);
                }
            }
        }
        Some(Moved(columns))
    }

    /// The case at all angles, which must be in the table.
    fn case_at_angles(
        &self,
        sections: &Sections<'_>,
        table: &CoefficientTable,
    ) -> Result<Vec<Given<f64>>, InputError> {
        let (angles, _) = self.angles_and_others();
        let at = |&angle: &f64| {
            let coefficients = sections.curves().at(angle).map_err(|outside| {
                let help = "take angles within the table, or complete it";
                InputError::new(Place::file(table.file()), outside.to_string(), help)
            })?;
            Ok(Given::of(&self.case.parameters_at(angle, coefficients)))
        };
        angles.iter().map(at).collect()
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
                    "correct the case, or what is varied",
                )
            };
            let mut parameters = self.angles[0].parameters;
            for (axis, &value) in others.iter().zip(&corner) {
                axis.variable.set(&mut parameters, value);
            }
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

    /// Whether each point has a mean twist.
    pub fn has_twists(&self) -> bool {
        self.twisting.is_some()
    }

    /// The methods that are asked.
    pub fn methods(&self) -> Methods {
        self.methods
    }

    /// Whether a row is that of the worst angle, which there may not be.
    pub fn has_worst_angles(&self) -> bool {
        self.rows == Rows::WorstAngles
    }

    /// How many rows there are.
    pub fn rows(&self) -> u64 {
        let (angles, others) = self.angles_and_others();
        let combinations = self.points_of(others);
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

    /// The rows with these numbers from 0.
    ///
    /// Closed forms and exact eigenvalues run on several rows at once: about 40 and 500 operations a row.
    pub fn rows_at(&self, rows: Range<u64>) -> GridRows {
        let points = self.points_in_a_row();
        let found = self.points(rows.start * points..rows.end * points);
        match self.rows {
            Rows::Points => found,
            Rows::WorstAngles => found.worst_of_each(points as usize),
        }
    }

    fn points(&self, points: Range<u64>) -> GridRows {
        let twisted: Option<Vec<Twisted>> = self.twisting.as_ref().map(|own| {
            let points = points.clone();
            points.map(|point| self.twisted(own, point)).collect()
        });
        let batch = match &twisted {
            Some(rows) => Batch::new(columns_of(rows)),
            None => self.batch(points.clone()),
        };
        let asked = self.methods;
        let mut found = GridRows {
            values: self.values(&points),
            twists: twisted.iter().flatten().map(|own| own.twist).collect(),
            ..GridRows::default()
        };
        if asked.exact {
            let [direction, damping] = match &twisted {
                Some(rows) => open_of(rows),
                None => self.open(&points),
            };
            (found.exact, found.critical) = batch.exact([&direction, &damping]);
        }
        if asked.companion {
            found.companion = batch.companion();
        }
        if asked.closed {
            found.closed = batch.closed_forms();
        }
        if asked.uniform {
            [found.uniform] = batch.uniform_forms([Order::Second]);
        }
        found
    }

    /// The values of each axis.
    fn values(&self, points: &Range<u64>) -> Vec<Vec<f64>> {
        let mut stride = self.points_of(&self.axes);
        let column = |values: &Vec<f64>| {
            stride /= values.len() as u64;
            repeated(values, stride, points)
        };
        self.shown.iter().map(column).collect()
    }

    /// At how many points some axes meet.
    fn points_of(&self, axes: &[Axis]) -> u64 {
        axes.iter().map(|axis| axis.values().len() as u64).product()
    }

    /// The sections of points.
    pub(super) fn batch(&self, points: Range<u64>) -> Batch {
        Batch::new(self.sections(points))
    }

    fn sections(&self, points: Range<u64>) -> Columns {
        let mut columns = Columns::like(&self.angles[0], (points.end - points.start) as usize);
        let Some(moved) = &self.moved else {
            for point in points {
                let row = self.row_of(point);
                columns.extend(&row, &vec![None; row.len()], 1);
            }
            return columns;
        };
        let count = self.axes[self.moving].values().len() as u64;
        let mut next = points.start;
        while next < points.end {
            let first = next % count;
            let end = points.end.min(next - first + count);
            let part = first as usize..(end - next + first) as usize;
            columns.extend(&self.row_of(next), &moved.part(part), (end - next) as usize);
            next = end;
        }
        columns
    }

    /// What is open of directions, and of S_a.
    pub(super) fn open(&self, points: &Range<u64>) -> [Vec<f64>; 2] {
        let angles = self.angles.len() as u64;
        let open = |point: u64| match &self.open {
            Some(known) => known[(point % angles) as usize],
            None => exact_modes::open(&self.given(point).parameters),
        };
        let (directions, damping) = points.clone().map(|point| open(point).into()).unzip();
        [directions, damping]
    }

    /// The section of a point, twisted by its mean moment; of numbers that are none where it has no certain twist.
    fn twisted(&self, sections: &Sections<'_>, point: u64) -> Twisted {
        let (angles, _) = self.angles_and_others();
        let angle = angles[(point % angles.len() as u64) as usize];
        let found = sections.twisted(angle, self.given(point).parameters);
        let (mut parameters, twist) = found.unwrap_or_else(|_| {
            let nothing = Coefficients::default().map(|_: &f64| f64::NAN);
            let none = Parameters {
                forces: nothing.into(),
                open: Some(Open::default()),
                ..self.given(point).parameters
            };
            (none, None)
        });
        if twist.is_some() {
            self.vary(&mut parameters, point, Variable::is_of_table);
        }
        Twisted {
            given: Given::of(&parameters),
            twist,
        }
    }

    /// The section of a point, without its mean twist.
    fn given(&self, point: u64) -> Given<f64> {
        let mut given = self.angles[(point % self.angles.len() as u64) as usize];
        self.vary(&mut given.parameters, point, |_| true);
        match self.turns {
            true => Given::of(&given.parameters),
            false => given,
        }
    }

    /// Gives some of the axes their values at a point.
    fn vary(&self, parameters: &mut Parameters, point: u64, is_varied: impl Fn(Variable) -> bool) {
        let mut rest = point;
        for axis in self.axes.iter().rev() {
            let count = axis.values().len() as u64;
            if is_varied(axis.variable) {
                axis.variable
                    .set(parameters, axis.values()[(rest % count) as usize]);
            }
            rest /= count;
        }
    }

    fn row_of(&self, point: u64) -> Row {
        self.given(point).flattened().1
    }
}

/// The section of a point, and its mean twist if there is one that is certain.
struct Twisted {
    given: Given<f64>,
    twist: Option<Twist>,
}

/// The sections in columns.
fn columns_of(rows: &[Twisted]) -> Columns {
    let Some(first) = rows.first() else {
        return Columns::like(&Given::of(&Parameters::default()), 0);
    };
    let mut columns = Columns::like(&first.given, rows.len());
    for own in rows {
        let row = own.given.flattened().1;
        columns.extend(&row, &vec![None; row.len()], 1);
    }
    columns
}

/// What is open of directions, and of S_a.
fn open_of(rows: &[Twisted]) -> [Vec<f64>; 2] {
    let open = rows
        .iter()
        .map(|own| exact_modes::open(&own.given.parameters).into());
    let (directions, damping) = open.unzip();
    [directions, damping]
}

/// The values of an axis at points, of which so many have the same.
fn repeated(values: &[f64], stride: u64, points: &Range<u64>) -> Vec<f64> {
    let mut column = Vec::with_capacity((points.end - points.start) as usize);
    let mut next = points.start;
    while next < points.end {
        let place = (next / stride) as usize % values.len();
        let left = points.end - next;
        next += if stride == 1 {
            let count = (values.len() - place).min(left as usize);
            column.extend_from_slice(&values[place..place + count]);
            count as u64
        } else {
            let count = left.min(stride - next % stride);
            column.resize(column.len() + count as usize, values[place]);
            count
        };
    }
    column
}
