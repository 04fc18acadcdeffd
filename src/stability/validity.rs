//! Where the closed forms of a case may be trusted: their errors over eccentricity and wind.

mod departure;
mod form;
mod map;

pub use departure::{Departure, Departures};
pub use form::Form;

use self::departure::ROUNDING;
use self::map::Map;
use super::axis::Axis;
use super::case::Case;
use super::coefficient_table::CoefficientTable;
use super::comparison::NO_WIND;
use super::error::StabilityError;
use super::input::{InputError, Place};
use super::section::Parameters;
use super::variable::Variable;

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
/// If there is no wind, a coordinate is held, there is aerodynamic stiffness or a mean twist, an angle is outside of the table,
/// or a section has no answer.
pub fn validity(case: &Case, table: &CoefficientTable) -> Result<Validity, InputError> {
    check(case)?;
    let no_answer = |error: StabilityError| wrong(case, &error.to_string(), CORRECT);
    let own = Map::new(case, table, Vec::new())?;
    let tuned = tuned(case);
    let cells = |eccentricities: &[f64], winds: &[f64]| -> Result<Vec<_>, InputError> {
        let axes = axes(&tuned.parameters, eccentricities, winds);
        Ok(Map::new(&tuned, table, axes)?.cells())
    };
    let small = case.parameters.small_quantities();
    let [columns, rows, points] = sizes(own.angles());
    let eccentricities = logarithmic(around(ECCENTRICITIES, small.e), columns);
    let winds = logarithmic(around(WINDS, small.delta), rows);
    let all: Result<_, _> = cells(&eccentricities, &winds)?.into_iter().collect();
    let mut from_above = logarithmic(around(ECCENTRICITIES, small.e), points);
    from_above.reverse();
    let least_eccentricity = reach(&from_above, cells(&from_above, &[small.delta])?);
    let from_below = logarithmic(around(WINDS, small.delta), points);
    let largest_wind = reach(&from_below, cells(&[small.e], &from_below)?);
    Ok(Validity {
        case: case.clone(),
        own: [small.e, small.delta],
        own_departures: own.own_departures().map_err(no_answer)?,
        angles: own.angles(),
        strength: own.strength(),
        eccentricities,
        winds,
        cells: all.map_err(no_answer)?,
        least_eccentricity: least_eccentricity.map_err(no_answer)?,
        largest_wind: largest_wind.map_err(no_answer)?,
    })
}

const CORRECT: &str = "correct the case or its table";

fn wrong(case: &Case, what: &str, help: &str) -> InputError {
    InputError::new(Place::file(&case.file), what, help)
}

/// The closed forms apply to the case, tuned.
fn check(case: &Case) -> Result<(), InputError> {
    let p = &case.parameters;
    if p.wind_speed == 0.0 {
        let what = format!("U = 0: {NO_WIND}");
        return Err(wrong(case, &what, "give a wind speed above 0"));
    }
    if !p.free.are_all() {
        let what =
            "the closed forms are of sections whose x, y and theta are free, and not all are";
        let help = "leave `free` out of the case if nothing is held; what is held is computed by `sextic stability`, and \
                    needs no closed form";
        return Err(wrong(case, what, help));
    }
    if case.is_twisted() {
        let what = "each wind of the map twists the section otherwise";
        let help = "leave `mean_twist` out of the case: the map is of one attitude";
        return Err(wrong(case, what, help));
    }
    if p.aerodynamic_stiffness {
        let what = "the forms leave aerodynamic stiffness out";
        let help =
            "leave `aerodynamic_stiffness` out of the case: the map is of what the forms count";
        return Err(wrong(case, what, help));
    }
    Ok(())
}

/// The case perfectly tuned to the frequency of heave, and without structural damping.
fn tuned(case: &Case) -> Case {
    let mut tuned = case.clone();
    let p = &mut tuned.parameters;
    p.natural_frequencies = [p.natural_frequencies[1]; 3];
    p.damping_ratios = [0.0; 3];
    // What was set may be varied all the same; coefficients are set at each angle.
    tuned.set.retain(|own| own.variable.is_of_table());
    tuned
}

/// The places of these e and δ, the winds changing slowest.
fn axes(p: &Parameters, eccentricities: &[f64], winds: &[f64]) -> Vec<Axis> {
    let lengths = eccentricities.iter();
    let lengths = lengths.map(|e| distance(*e, p.radius_of_gyration));
    let speeds = winds.iter().map(|wind| wind * speed_of_unit(p));
    vec![
        Axis::at(Variable::WIND_SPEED, speeds.collect()),
        Axis::at(Variable::MASS_CENTRE_DISTANCE, lengths.collect()),
    ]
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

/// The last of the numbers up to which the closed form is close at all of them.
fn reach(
    numbers: &[f64],
    cells: Vec<Result<[Departure; 3], StabilityError>>,
) -> Result<Option<f64>, StabilityError> {
    let mut last = None;
    for (number, cell) in numbers.iter().zip(cells) {
        if cell?[Form::Closed as usize].error > TOLERANCE {
            break;
        }
        last = Some(*number);
    }
    Ok(last)
}
