//! Where the closed forms of a case may be trusted: their errors over eccentricity and wind.

use rayon::prelude::*;

use super::case::Case;
use super::closed_form::{ClosedForm, closed_form};
use super::coefficient_table::CoefficientTable;
use super::comparison::NO_WIND;
use super::eigenvalue::Spectrum;
use super::error::StabilityError;
use super::exact_modes;
use super::input::{InputError, Place};
use super::interpolation::CoefficientCurves;
use super::limitation::Limitation;
use super::model::Model;
use super::section::{Coefficients, Parameters, Section};
use super::uniform_form::{Order, uniform_form_of};
use super::verdict::{Doubt, Verdict, verdict, verdict_by_errors};

/// A form whose errors are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// The closed forms, Eqs. (21)–(23).
    Closed,
    /// The uniform form of the first order in the damping.
    UniformFirst,
    /// The uniform form of the second order.
    UniformSecond,
}

impl Form {
    /// All of them, in the order of results.
    pub const ALL: [Form; 3] = [Form::Closed, Form::UniformFirst, Form::UniformSecond];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Form::Closed => "closed form (21)–(23)",
            Form::UniformFirst => "uniform form, first order",
            Form::UniformSecond => "uniform form, second order",
        }
    }

    /// In one word, as in tables for programs.
    pub fn word(self) -> &'static str {
        match self {
            Form::Closed => "closed",
            Form::UniformFirst => "uniform_first",
            Form::UniformSecond => "uniform_second",
        }
    }

    /// The order of what it leaves out of S/|S_a|: (δ|S_a|/e)², δ|S_a| or (δ|S_a|)², by
    /// `derivations/uniform.md`.
    pub fn order(self, eccentricity: f64, damping: f64) -> f64 {
        match self {
            Form::Closed => (damping / eccentricity).powi(2),
            Form::UniformFirst => damping,
            Form::UniformSecond => damping * damping,
        }
    }

    fn of(self, model: &Model) -> Result<ClosedForm, Limitation> {
        match self {
            Form::Closed => closed_form(model.section()),
            Form::UniformFirst => uniform_form_of(Order::First, model),
            Form::UniformSecond => uniform_form_of(Order::Second, model),
        }
    }
}

/// How far a form is from the exact modes at some angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// The largest error of S over |S_a|, the Frobenius norm of the scaled damping matrix (18).
    pub error: f64,
    /// The angle where it is that, in degrees.
    pub angle: f64,
    /// At so many angles S has the wrong sign for certain.
    pub wrong_signs: usize,
    /// At so many more it is not known whether it has: the exact S is within its error of 0.
    pub open_signs: usize,
    /// At so many angles the form has an answer.
    pub answers: usize,
}

/// The errors of all forms; `None` where one does not apply.
pub type Departures = [Option<Departure>; 3];

/// The errors of the forms over eccentricity e = L_g/r and wind δ = ρDU/(2mω_n).
///
/// The map is of the case perfectly tuned to the frequency of heave and without structural damping, which is
/// what the closed forms are for, at all of its angles: of many angles it has fewer places.
#[derive(Clone, Debug)]
pub struct Validity {
    /// The case.
    pub case: Case,
    /// e and δ of the case as it is.
    pub own: [f64; 2],
    /// The errors for the case as it is, at all of its angles.
    pub own_departures: Departures,
    /// The number of its angles, which are those of the map.
    pub angles: usize,
    /// The largest |S_a| at these.
    pub strength: f64,
    /// The eccentricities of the map, from the smallest on.
    pub eccentricities: Vec<f64>,
    /// The values of δ of the map, from the smallest on.
    pub winds: Vec<f64>,
    /// The errors: for each δ those at all eccentricities.
    pub cells: Vec<[Departure; 3]>,
    /// Where the closed form has errors of at most [`TOLERANCE`]: from this eccentricity on, at the wind
    /// of the case; `None` if nowhere on the map.
    pub least_eccentricity: Option<f64>,
    /// Up to this δ, at the eccentricity of the case.
    pub largest_wind: Option<f64>,
}

/// Errors of S over |S_a| that an engineer may neglect.
pub const TOLERANCE: f64 = 0.01;

/// Columns and rows of a map, and points along a line, at most; and at least.
const MOST: [usize; 3] = [45, 33, 145];
const FEWEST: usize = 3;

/// A map that is as fine as can be has so many sections at most.
const MOST_SECTIONS: f64 = 600_000.0;

/// Columns, rows and points for so many angles.
fn sizes(angles: usize) -> [usize; 3] {
    let [columns, rows, _] = MOST;
    let share = (MOST_SECTIONS / (columns * rows * angles) as f64).sqrt();
    MOST.map(|most| ((share.min(1.0) * most as f64) as usize).max(FEWEST))
}

/// What a map shows of e and δ at least, and what it does not go below.
const ECCENTRICITIES: [f64; 2] = [1e-3, 0.9];
const WINDS: [f64; 2] = [1e-5, 0.1];
const LEAST: f64 = 1e-9;

/// The map of a case.
///
/// Some 640,000 sections by all methods for 361 angles, on all cores.
///
/// # Errors
///
/// If there is no wind, a coordinate is held, there is aerodynamic stiffness, an angle is outside of the table,
/// or a section has no answer.
pub fn validity(case: &Case, table: &CoefficientTable) -> Result<Validity, InputError> {
    let wrong = |what: &str, help: &str| InputError::new(Place::file(&case.file), what, help);
    if case.parameters.wind_speed == 0.0 {
        let what = format!("U = 0: {NO_WIND}");
        return Err(wrong(&what, "give a wind speed above 0"));
    }
    if !case.parameters.free.are_all() {
        let help = "leave `free` out of the case";
        return Err(wrong(
            "the closed forms need x, y and theta to be free",
            help,
        ));
    }
    if case.parameters.aerodynamic_stiffness {
        let help =
            "leave `aerodynamic_stiffness` out of the case: the map is of what the forms count";
        return Err(wrong("the forms leave aerodynamic stiffness out", help));
    }
    let no_answer =
        |error: StabilityError| wrong(&error.to_string(), "correct the case or its table");
    let own = Sections::of(case, table)?;
    let map = own.tuned();
    let [columns, rows, points] = sizes(map.sections.len());
    let place = own.place();
    let eccentricities = logarithmic(around(ECCENTRICITIES, place[0]), columns);
    let winds = logarithmic(around(WINDS, place[1]), rows);
    let places: Vec<[f64; 2]> = winds
        .iter()
        .flat_map(|&wind| eccentricities.iter().map(move |&e| [e, wind]))
        .collect();
    let cells: Result<Vec<_>, _> = places.par_iter().map(|&place| map.at(place)).collect();
    let is_close = |point: [f64; 2]| -> Result<bool, StabilityError> {
        Ok(map.at(point)?[0].error <= TOLERANCE)
    };
    let line = logarithmic(around(ECCENTRICITIES, place[0]), points);
    let from_above = line.iter().rev().copied();
    let least_eccentricity = last_while(from_above, |e| is_close([e, place[1]]));
    let line = logarithmic(around(WINDS, place[1]), points);
    let largest_wind = last_while(line.iter().copied(), |wind| is_close([place[0], wind]));
    Ok(Validity {
        case: case.clone(),
        own: place,
        own_departures: own
            .departures(|section, spectrum| Some(verdict(section, spectrum)))
            .map_err(no_answer)?,
        angles: own.sections.len(),
        strength: map.strength(),
        eccentricities,
        winds,
        cells: cells.map_err(no_answer)?,
        least_eccentricity: least_eccentricity.map_err(no_answer)?,
        largest_wind: largest_wind.map_err(no_answer)?,
    })
}

impl Validity {
    /// The largest error of a form on the map over its order, where that is at most 1: a measured bound of
    /// what the derivation gives the order of.
    pub fn constant(&self, form: Form) -> f64 {
        let places = self.winds.iter().flat_map(|wind| {
            let places = self.eccentricities.iter();
            places.map(move |e| (*e, wind * self.strength))
        });
        let ratios = places.zip(&self.cells).filter_map(|((e, damping), cell)| {
            let (order, error) = (form.order(e, damping), cell[form as usize].error);
            (order <= 1.0 && error > ROUNDING).then(|| error / order)
        });
        ratios.fold(0.0, f64::max)
    }

    /// The wind speed of a δ, in m/s.
    pub fn wind_speed(&self, wind: f64) -> f64 {
        wind * speed_of_unit(&self.case.parameters)
    }
}

/// A case at some angles.
struct Sections {
    sections: Vec<(f64, Parameters)>,
}

impl Sections {
    fn of(case: &Case, table: &CoefficientTable) -> Result<Self, InputError> {
        let curves = CoefficientCurves::new(table, case.interpolation)?;
        let section = |angle: f64| -> Result<(f64, Parameters), InputError> {
            let coefficients: Coefficients = curves.at(angle).map_err(|outside| {
                let help = "shorten the sweep of the case, or complete the table";
                InputError::new(Place::file(table.file()), outside.to_string(), help)
            })?;
            Ok((angle, case.parameters_at(angle, coefficients)))
        };
        let sections: Result<_, _> = case.angles.values().into_iter().map(section).collect();
        Ok(Sections {
            sections: sections?,
        })
    }

    /// Perfectly tuned to the frequency of heave, and without structural damping.
    fn tuned(&self) -> Self {
        self.with(|parameters| Parameters {
            natural_frequencies: [parameters.natural_frequencies[1]; 3],
            damping_ratios: [0.0; 3],
            ..parameters
        })
    }

    fn with(&self, change: impl Fn(Parameters) -> Parameters) -> Self {
        let changed = |&(angle, parameters): &(f64, Parameters)| (angle, change(parameters));
        Sections {
            sections: self.sections.iter().map(changed).collect(),
        }
    }

    /// e and δ.
    fn place(&self) -> [f64; 2] {
        let small = self.sections[0].1.small_quantities();
        [small.e, small.delta]
    }

    /// The largest |S_a|.
    fn strength(&self) -> f64 {
        let sections = self.sections.iter();
        let norms = sections.filter_map(|(_, parameters)| {
            Some(Section::new(*parameters).ok()?.scaled_damping_norm())
        });
        norms.fold(0.0, f64::max)
    }

    /// The errors with another eccentricity and wind, infinite for a form that has no answer at one of the
    /// angles; all apply to perfectly tuned sections.
    fn at(&self, [eccentricity, wind]: [f64; 2]) -> Result<[Departure; 3], StabilityError> {
        let moved = self.with(|parameters| Parameters {
            mass_centre_distance: distance(eccentricity, parameters.radius_of_gyration),
            wind_speed: wind * speed_of_unit(&parameters),
            ..parameters
        });
        let none = Departure {
            error: f64::INFINITY,
            angle: self.sections[0].0,
            wrong_signs: 0,
            open_signs: 0,
            answers: 0,
        };
        let is_whole = |own: &Departure| own.answers == self.sections.len();
        Ok(moved
            .departures(|_, spectrum| verdict_by_errors(spectrum))?
            .map(|own| own.filter(is_whole).unwrap_or(none)))
    }

    fn departures(&self, decide: Decide) -> Result<Departures, StabilityError> {
        let sections = self.sections.par_iter();
        let shifts = sections.map(|&(angle, parameters)| Ok((angle, shifts(parameters, decide)?)));
        let shifts: Vec<(f64, Shifts)> = shifts.collect::<Result<_, StabilityError>>()?;
        Ok(Form::ALL.map(|form| {
            let own = |(angle, shifts): &(f64, Shifts)| Some((*angle, shifts[form as usize]?));
            let all = shifts.iter().filter_map(own);
            all.fold(None, |found, (angle, shift)| {
                let found = found.unwrap_or(Departure {
                    error: 0.0,
                    angle,
                    wrong_signs: 0,
                    open_signs: 0,
                    answers: 0,
                });
                let is_larger = shift.error > found.error;
                Some(Departure {
                    error: found.error.max(shift.error),
                    angle: if is_larger { angle } else { found.angle },
                    wrong_signs: found.wrong_signs + usize::from(shift.sign == Sign::Wrong),
                    open_signs: found.open_signs + usize::from(shift.sign == Sign::Open),
                    answers: found.answers + 1,
                })
            })
        }))
    }
}

/// How signs are known: by exact arithmetic where need be, or only as far as the errors of the eigenvalues tell.
type Decide = fn(&Section, &Spectrum) -> Option<Verdict>;

/// The error of S over |S_a|, and what is known of its sign.
#[derive(Clone, Copy)]
struct Shift {
    error: f64,
    sign: Sign,
}

/// What is known of the sign of S.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sign {
    /// It is not wrong, or so small that its rounding may be.
    Right,
    /// It is wrong for certain.
    Wrong,
    /// Nothing.
    Open,
}

impl Sign {
    fn of(value: f64, rounding: f64, verdict: Option<Verdict>) -> Self {
        match verdict {
            Some(own) if own.refutes(value, rounding) => Sign::Wrong,
            Some(
                Verdict::Stable(_) | Verdict::Unstable(_) | Verdict::Undecided(Doubt::Neutral),
            ) => Sign::Right,
            _ if value.abs() <= rounding => Sign::Right,
            _ => Sign::Open,
        }
    }
}

/// Those of all forms; `None` where one has no answer.
type Shifts = [Option<Shift>; 3];

/// What the forms make of a section, beside its exact modes and a certain verdict.
fn shifts(parameters: Parameters, decide: Decide) -> Result<Shifts, StabilityError> {
    let section = Section::new(parameters)?;
    let model = Model::new(&section)?;
    let spectrum = exact_modes::eigenvalues(&model)?.spectrum;
    let exact = spectrum.damping_coefficient(&section);
    let (exact, bound) = exact.ok_or(StabilityError::OutOfRange)?;
    let size = section.scaled_damping_norm();
    if size == 0.0 {
        // Without forces there is nothing to be wrong about.
        let right = Shift {
            error: 0.0,
            sign: Sign::Right,
        };
        return Ok([Some(right); 3]);
    }
    if bound > LARGEST_BOUND * size {
        return Err(StabilityError::WeakWind);
    }
    let verdict = decide(&section, &spectrum);
    Ok(Form::ALL.map(|form| {
        let value = form.of(&model).ok()?.largest_real_part();
        let value = section.damping_coefficient(value)?;
        Some(Shift {
            error: (value - exact).abs() / size,
            sign: Sign::of(value, ROUNDING * size, verdict),
        })
    }))
}

/// S must be known to this share of |S_a|.
const LARGEST_BOUND: f64 = 1e-3;

/// Less than this share of |S_a| is rounding.
const ROUNDING: f64 = 1e-12;

/// L_g = e r, below r whatever the rounding.
fn distance(eccentricity: f64, radius_of_gyration: f64) -> f64 {
    (eccentricity * radius_of_gyration).min(radius_of_gyration.next_down())
}

/// The wind speed at which δ = 1, to which it is proportional.
fn speed_of_unit(parameters: &Parameters) -> f64 {
    let slow = Parameters {
        wind_speed: 1.0,
        ..*parameters
    };
    1.0 / slow.small_quantities().delta
}

/// A range that has a number within it; one that is too small changes nothing.
fn around([least, largest]: [f64; 2], number: f64) -> [f64; 2] {
    match number >= LEAST {
        true => [least.min(number), largest.max(number)],
        false => [least, largest],
    }
}

/// Numbers from one to another, in even steps of their logarithm.
fn logarithmic([first, last]: [f64; 2], count: usize) -> Vec<f64> {
    let step = (last.ln() - first.ln()) / (count - 1) as f64;
    (0..count)
        .map(|place| (first * (step * place as f64).exp()).min(last))
        .collect()
}

/// The last of the numbers up to which all have a property.
fn last_while(
    numbers: impl Iterator<Item = f64>,
    holds: impl Fn(f64) -> Result<bool, StabilityError>,
) -> Result<Option<f64>, StabilityError> {
    let mut last = None;
    for number in numbers {
        if !holds(number)? {
            break;
        }
        last = Some(number);
    }
    Ok(last)
}
