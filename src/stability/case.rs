//! A case: a section in the wind and the angles at which it is looked at, as an engineer writes it down.

use toml::de::DeTable;

mod file;
mod keys;
mod scatter;
mod turn;

use self::file::File;
use self::keys::{Lines, REFERENCE, SWEEP, check_keys, not_read};
pub use self::turn::Turn;
use super::coefficient_table::CoefficientTable;
use super::coefficient_table::reading::Reading;
use super::coefficient_table::reference::Reference;
use super::coordinate::Coordinate;
use super::error::StabilityError;
use super::forces::Forces;
use super::input::{InputError, Place, Remark};
use super::interpolation::Interpolation;
use super::quantity::{Quantity, Unit};
use super::section::{Coefficients, Parameters, Section};
use super::variable::{Setting, Variable};

/// A case file, read and checked.
///
/// The file is TOML: lengths in m, masses in kg/m, frequencies in Hz, angles in degrees.
///
/// ```
/// use sextic::stability::case::Case;
///
/// let text = r#"
/// [section]
/// D = 0.05
/// m = 3.5
/// r = 0.0178
/// L_g = 0.004
/// alpha_g_deg = 10
/// L_a = 0.03
/// gamma_r_deg = 0
/// coefficients = "table.csv"
/// interpolation = "cubic"
/// [structure]
/// f_x = 0.96
/// f_y = 0.845
/// f_theta = 0.865
/// zeta_x = 0.008
/// zeta_y = 0.008
/// zeta_theta = 0.03
/// [wind]
/// rho = 1.25
/// U = 9
/// [sweep]
/// alpha_deg = { from = 0, to = 180, step = 0.5 }
/// turn = "section"
/// "#;
/// let case = Case::read("case.toml", text)?;
/// assert_eq!(case.angles.values().len(), 361);
///
/// let error = Case::read("case.toml", &text.replace("alpha_g_deg", "alpha_g")).unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "case.toml:7: there is no key `alpha_g` in [section]: write alpha_g_deg, in degrees"
/// );
/// # Ok::<(), sextic::stability::input::InputError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The file as the user named it.
    pub file: String,
    /// All that does not change with the angle; forces, α_0 and θ_0 are 0.
    pub parameters: Parameters,
    /// The coefficient table, relative to the folder of the case file.
    pub coefficients: String,
    /// What its columns mean, whether it is mirrored, and where derivatives are from.
    pub reading: Reading,
    /// The lengths that its coefficients stand over, where they are not D.
    pub reference: Reference,
    /// How the table is read between its angles.
    pub interpolation: Interpolation,
    /// How far C_D, C_L and C_M may be from those of the table, if the case says so.
    pub errors: Option<[f64; 3]>,
    /// Whether the mean moment of the wind twists the section.
    pub mean_twist: bool,
    /// The angles.
    pub angles: Angles,
    /// What was set in place of what the file and its table say.
    pub set: Vec<Setting>,
}

/// The angles of attack at which a section is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angles {
    /// The first angle, in degrees.
    pub from: f64,
    /// The last angle, in degrees, unless the steps miss it.
    pub to: f64,
    /// From one to the next, in degrees.
    pub step: f64,
    /// What is turned.
    pub turn: Turn,
}

/// Structural damping ratios above this are taken for percentages.
const MOST_USUAL_RATIO: f64 = 0.1;

/// In kg/m for a square metre: ten times that of a full square of lead.
const HEAVIEST: f64 = 113_400.0;

/// In kg/m³: that of air 20 km above the sea.
const THINNEST: f64 = 0.09;

/// No length of a section is this many times another one, but by a mistaken unit.
const MOST_USUAL_LENGTHS: f64 = 20.0;

/// The most angles of a sweep.
pub const MOST_ANGLES: usize = 1_000_000;

impl Angles {
    /// The angles in degrees: from, from + step, …, up to `to`.
    pub fn values(&self) -> Vec<f64> {
        // A step that fits but for its rounding still counts.
        let steps = ((self.to - self.from) / self.step + 1e-9).floor();
        let steps = (steps as usize).min(MOST_ANGLES - 1);
        (0..=steps)
            .map(|place| (self.from + place as f64 * self.step).min(self.to))
            .collect()
    }
}

impl Case {
    /// Reads the text of a case file; `file` is its name in messages.
    ///
    /// # Errors
    ///
    /// What cannot be read, is not known, is missing or is out of its range, with its line.
    pub fn read(file: &str, text: &str) -> Result<Self, InputError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let not_read = |error| not_read(file, text, &error);
        let document = DeTable::parse(text).map_err(not_read)?.into_inner();
        let lines = check_keys(file, text, &document)?;
        let read = File::read(document).map_err(not_read)?;
        let free = read.free(file, &lines)?;
        lines.check_needed(file, free)?;
        let parameters = read.parameters(free);
        // What is missing now is not needed.
        let steps = read.alpha_deg.unwrap_or_default();
        let case = Case {
            file: file.into(),
            parameters,
            coefficients: read.coefficients.unwrap_or_default(),
            reading: read.reading,
            reference: read.reference,
            interpolation: read.interpolation.unwrap_or(Interpolation::Linear),
            errors: read.errors.map(|own| [own.drag, own.lift, own.moment]),
            mean_twist: read.mean_twist,
            angles: Angles {
                from: steps.from,
                to: steps.to,
                step: steps.step,
                turn: read.turn.unwrap_or(Turn::Section),
            },
            set: Vec::new(),
        };
        case.check(&lines)?;
        Ok(case)
    }

    /// The case with other values of some quantities; the angle of attack becomes the only one.
    ///
    /// # Errors
    ///
    /// If two set the same quantity, one sets nothing, or a value is not possible.
    pub fn with(&self, set: &[Setting]) -> Result<Self, InputError> {
        for (place, own) in set.iter().enumerate() {
            self.check_setting(own, &set[..place])?;
        }
        let mut case = Case {
            set: set.to_vec(),
            ..self.clone()
        };
        for own in set {
            if own.variable.is_angle() {
                (case.angles.from, case.angles.to) = (own.value, own.value);
            }
            own.variable.set(&mut case.parameters, own.value);
        }
        let place = || Place::file(&format!("--set {}", listed(set)));
        case.check(&Lines::default()).map_err(|error| InputError {
            place: place(),
            ..error
        })?;
        Ok(case)
    }

    /// The file, and what was set.
    pub fn title(&self) -> String {
        match self.set.is_empty() {
            true => self.file.clone(),
            false => format!("{} with {}", self.file, listed(&self.set)),
        }
    }

    /// What its coefficients stand over, after a semicolon; nothing where that is D.
    pub fn over_lengths(&self) -> String {
        match self.reference.is_usual() {
            true => String::new(),
            false => format!(
                "; {}, converted to D = {} m",
                self.reference, self.parameters.reference_dimension
            ),
        }
    }

    /// Whether the mean moment twists it: it asks for that, and is free to turn.
    pub fn is_twisted(&self) -> bool {
        let free = self.parameters.free.as_slice();
        self.mean_twist && free.contains(&Coordinate::Theta)
    }

    /// Refuses to give C_M or its slope one value, beside the curve that the mean twist follows.
    pub(super) fn check_moment(&self, variable: Variable) -> Result<(), InputError> {
        if !(self.is_twisted() && variable.is_moment()) {
            return Ok(());
        }
        Err(InputError::new(
            Place::file(&self.file),
            "C_M or its slope is given, and the mean twist follows the curve of the table",
            "set neither C_M nor dC_M, or leave `mean_twist` out of the case",
        ))
    }

    /// Sees that a quantity is set once, and that it is one.
    fn check_setting(&self, own: &Setting, earlier: &[Setting]) -> Result<(), InputError> {
        let (place, name) = (Place::file("--set"), own.variable.name);
        let mut earlier = earlier.iter().map(|other| other.variable);
        if let Some(other) = earlier.find(|other| own.variable.clashes(*other)) {
            let what = match other.name == name {
                true => format!("{name} is set twice"),
                false => format!("{} and {name} set the same quantity", other.name),
            };
            return Err(InputError::new(
                place,
                what,
                "set every quantity once, by one name",
            ));
        }
        self.check_moment(own.variable)?;
        if own.variable.is_held(&self.parameters) {
            let what = own.variable.does_nothing();
            return Err(InputError::new(place, what, "see `free` in the case"));
        }
        Ok(())
    }

    /// The section at an angle of attack in degrees, with the coefficients there.
    ///
    /// # Errors
    ///
    /// As [`Section::new`].
    pub fn section(
        &self,
        alpha_deg: f64,
        coefficients: Coefficients,
    ) -> Result<Section, StabilityError> {
        Section::new(self.parameters_at(alpha_deg, coefficients))
    }

    /// The parameters of that section, not checked.
    pub(super) fn parameters_at(&self, alpha_deg: f64, coefficients: Coefficients) -> Parameters {
        let alpha = alpha_deg.to_radians();
        let (wind_angle, attitude) = match self.angles.turn {
            Turn::Section => (0.0, alpha),
            Turn::Wind => (alpha, 0.0),
        };
        let mut parameters = Parameters {
            wind_angle,
            attitude,
            forces: coefficients.into(),
            ..self.parameters
        };
        // Coefficients are those of the table, unless they are set.
        for own in self.set.iter().filter(|own| own.variable.is_of_table()) {
            own.variable.set(&mut parameters, own.value);
        }
        parameters
    }

    /// Coefficients of the table, with what is set in place of them.
    pub(super) fn coefficients_as_set(&self, coefficients: Coefficients) -> Coefficients {
        self.with_set(coefficients, |own| own)
    }

    /// Errors of coefficients, without those of what is set in place of the table.
    pub(super) fn errors_of_table(&self, errors: Coefficients) -> Coefficients {
        self.with_set(errors, |_| 0.0)
    }

    /// Coefficients with another number in place of those that are set.
    fn with_set(&self, coefficients: Coefficients, number: impl Fn(f64) -> f64) -> Coefficients {
        let mut parameters = Parameters {
            forces: coefficients.into(),
            ..self.parameters
        };
        for own in self.set.iter().filter(|own| own.variable.is_of_table()) {
            own.variable.set(&mut parameters, number(own.value));
        }
        match parameters.forces {
            Forces::Coefficients(own) => own,
            // What is set is S_a.
            Forces::ScaledDamping(_) => Coefficients::default(),
        }
    }

    /// What is possible but odd about its numbers, as where a unit was mistaken.
    pub fn remarks(&self) -> Vec<Remark> {
        let p = &self.parameters;
        let mut remarks = Vec::new();
        let mut remark = |what: String| {
            let place = Place::file(&self.file);
            remarks.push(Remark { place, what });
        };
        let given = |own: Quantity| (own.row().name, own.of(p).copied().unwrap_or_default());
        let ratios = Quantity::ALL.iter().copied();
        let ratios = ratios.filter(|own| own.row().unit == Unit::Fraction);
        for (name, ratio) in ratios.map(given) {
            if ratio > MOST_USUAL_RATIO {
                remark(format!(
                    "{name} = {ratio} is a damping of {} % of critical; ratios are fractions, 0.8 % is 0.008",
                    ratio * 100.0
                ));
            }
        }
        let size = p.reference_dimension;
        // Hardly anything that stands in the wind weighs less than the air around it.
        if p.mass < p.air_density * size * size {
            remark(format!(
                "m = {} kg/m beside D = {size} m weighs less than the air in a square of that side; all lengths are in m, 50 mm is 0.05",
                p.mass
            ));
        }
        // No solid of that size weighs as much, though it be of lead and some times as wide as D.
        if p.mass > HEAVIEST * size * size {
            remark(format!(
                "m = {} kg/m beside D = {size} m is heavier than any metal; masses are in kg/m",
                p.mass
            ));
        }
        if p.air_density > 0.0 && p.air_density < THINNEST {
            remark(format!(
                "rho = {} kg/m³ is thinner than the air anything stands in; air has about 1.2 kg/m³",
                p.air_density
            ));
        }
        let lengths = [Quantity::r, Quantity::L_a].map(given).into_iter();
        let references = self.reference.lengths().into_iter();
        let references =
            references.map(|(name, own)| (format!("a reference length of {name}"), own));
        let lengths = lengths.map(|(name, own)| (name.to_string(), own));
        for (name, length) in lengths.chain(references) {
            // L_a may be as short as one likes.
            let is_short = name != "L_a" && size > MOST_USUAL_LENGTHS * length;
            if length > MOST_USUAL_LENGTHS * size || is_short {
                remark(format!(
                    "{name} = {length} m beside D = {size} m; all lengths are in m, 50 mm is 0.05"
                ));
            }
        }
        remarks
    }

    fn check(&self, lines: &Lines) -> Result<(), InputError> {
        Section::new(self.parameters).map_err(|error| self.impossible(&error, lines))?;
        self.check_errors(lines)?;
        self.check_reference(lines)?;
        let Angles { from, to, step, .. } = self.angles;
        let what = if ![from, to, step].iter().all(|number| number.is_finite()) {
            format!("the sweep from {from} to {to} in steps of {step} is not finite")
        } else if step <= 0.0 {
            format!("the step of the sweep is {step}, which is not above 0")
        } else if to < from {
            format!("the sweep ends at {to}, before it begins at {from}")
        } else if (to - from) / step >= MOST_ANGLES as f64 {
            format!("the sweep has more than {MOST_ANGLES} angles")
        } else {
            return Ok(());
        };
        let place = lines.place(&self.file, "sweep", "alpha_deg");
        Err(InputError::new(place, what, SWEEP))
    }

    fn check_errors(&self, lines: &Lines) -> Result<(), InputError> {
        let possible = |own: &f64| own.is_finite() && *own >= 0.0;
        match self.errors.iter().flatten().find(|own| !possible(own)) {
            None => Ok(()),
            Some(error) => Err(InputError::new(
                lines.place(&self.file, "section", "errors"),
                format!("an error of the coefficients is {error}"),
                "give how far each may be off, to both sides: errors = { CD = 0.01, CL = 0.02, CM = 0.005 }",
            )),
        }
    }

    fn check_reference(&self, lines: &Lines) -> Result<(), InputError> {
        let lengths = self.reference.lengths().into_iter();
        let mut impossible = lengths.filter(|(_, own)| !(own.is_finite() && *own > 0.0));
        match impossible.next() {
            None => Ok(()),
            Some((name, length)) => Err(InputError::new(
                lines.place(&self.file, "section", "reference"),
                format!("a reference length of {name} is {length} m, which is not above 0"),
                REFERENCE,
            )),
        }
    }

    /// Reads the text of the table as the case says, with the errors and the reference lengths that the case gives.
    ///
    /// # Errors
    ///
    /// As [`CoefficientTable::read_as`]; also if the table has errors of its own, or derivatives, of which no errors
    /// are known.
    pub fn read_table(&self, file: &str, text: &str) -> Result<CoefficientTable, InputError> {
        let table = CoefficientTable::read_as(file, text, &self.reading)?;
        let dimension = self.parameters.reference_dimension;
        let table = table.with_reference(&self.reference, dimension);
        let wrong = |what: String, help: &str| {
            let place = Place::file(&self.file);
            Err(InputError::new(place, what, help))
        };
        if table.has_slopes() && (self.errors.is_some() || table.has_errors()) {
            let what =
                "`slopes = true`, but how far the derivatives may be off is not known".into();
            return wrong(
                what,
                "leave out `slopes`, or the errors of the coefficients",
            );
        }
        match self.errors {
            None => Ok(table),
            Some(_) if table.has_errors() => {
                let what = format!("the case gives errors, and so does {}", table.file());
                wrong(what, "keep one of both")
            }
            Some(errors) => Ok(table.with_errors(errors)),
        }
    }

    /// Why there is no section, by the names and units of a case file.
    fn impossible(&self, error: &StabilityError, lines: &Lines) -> InputError {
        let place = || Place::file(&self.file);
        self.out_of_range(error, lines)
            .unwrap_or_else(|| InputError::new(place(), error.to_string(), "correct the case"))
    }

    fn out_of_range(&self, error: &StabilityError, lines: &Lines) -> Option<InputError> {
        let StabilityError::Parameter {
            name,
            value,
            must_be,
        } = error
        else {
            return None;
        };
        let own = Quantity::named(name)?;
        let (key, unit) = (own.key()?, own.row().unit);
        let place = lines.place(&self.file, key.table, key.name);
        let what = format!("{} = {} must be {must_be}", key.name, unit.of_si(*value));
        Some(InputError::new(place, what, unit.help()))
    }
}

/// `U = 12, m = 3`
fn listed(set: &[Setting]) -> String {
    let shown: Vec<String> = set.iter().map(ToString::to_string).collect();
    shown.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_angle_is_reached_in_spite_of_rounding() {
        let sweep = |from, to, step| {
            let turn = Turn::Section;
            Angles {
                from,
                to,
                step,
                turn,
            }
            .values()
        };
        assert_eq!(sweep(0.0, 0.3, 0.1).len(), 4);
        assert_eq!(sweep(0.0, 1.0, 0.3).last(), Some(&0.8999999999999999));
        assert_eq!(sweep(5.0, 5.0, 1.0), [5.0]);
        assert_eq!(sweep(0.0, 180.0, 0.05).len(), 3601);
        assert_eq!(sweep(0.0, 0.3, 0.1).last(), Some(&0.3));
    }
}
