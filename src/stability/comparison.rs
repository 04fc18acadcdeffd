//! A case at all its angles, by every method, side by side.

mod agreement;
mod following;
mod point;
mod range;
mod twist;
mod value;
mod within;

pub use agreement::{Agreement, Method, Reason};
pub use following::FollowedMode;
pub(super) use following::{Following, Modes, modes_of};
pub use point::Point;
pub use range::{AngleRange, UnstableRange, angle, listed};
pub use twist::NoBalance;
pub use value::Value;
pub use within::{Cause, Open, Within};

use rayon::prelude::*;

use super::case::Case;
use super::coefficient_table::CoefficientTable;
use super::coefficient_table::remarks::remarks;
use super::coordinate::Coordinate;
use super::input::{InputError, Place, Remark};
use super::model::Model;
use super::section::Section;
use super::sections::Sections;
use super::state_matrix;

/// What the methods say of a case, at the angles of its sweep.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The case.
    pub case: Case,
    /// The angles in order, with the answers of all methods.
    pub points: Vec<Point>,
    /// The other angles, at which there is no certain mean twist, and so no section.
    pub without_balance: Vec<NoBalance>,
    /// Where the section gallops or diverges for certain.
    pub unstable: Vec<UnstableRange>,
    /// Where it is neither stable nor unstable for certain.
    pub undecided: Vec<AngleRange>,
    /// How each of the other methods agrees with the state matrix.
    pub agreements: Vec<Agreement>,
    /// What is certain within the errors of the coefficients, or turned by the scatter of the table.
    pub within: Option<Within>,
    /// How the table is read, in words.
    pub reading: String,
    /// What is odd about the input.
    pub remarks: Vec<Remark>,
}

/// Why there is no S without wind.
pub(super) const NO_WIND: &str = "there is no wind, and S is a damping over the wind speed";

/// So many angles are answered before their modes are followed: their matrices need little memory.
const BLOCK: usize = 1024;

/// So many are answered by a core at once.
const AT_ONCE: usize = 64;

/// Compares the methods at all angles of a case.
///
/// The curve of S is the damping coefficient −4 m max λ_R/(ρ D U), Eq. (13): the exact one by the state
/// matrix, Eq. (16), with the structural damping as given; that of the companion matrix, Eq. (19); that of
/// the closed forms (21)–(23) and of the uniform form, where they apply. Modes are numbered by their frequency at the
/// first angle, the highest first, and followed by their shapes; one that begins later takes the lowest free number.
///
/// Linear in the number of angles: at each, two eigenvalue problems of at most 6×6 and two of 3×3, on all cores.
///
/// # Errors
///
/// If there is no wind, if an angle is outside of the table, if a section has no answer, or if none has a certain mean
/// twist.
pub fn compare(case: &Case, table: &CoefficientTable) -> Result<Comparison, InputError> {
    let file = Place::file(&case.file);
    if case.parameters.wind_speed == 0.0 {
        let what = format!("U = 0: {NO_WIND}");
        return Err(InputError::new(file, what, "give a wind speed above 0"));
    }
    let sections = Sections::new(case, table)?;
    let angles = case.angles.values();
    let section = |angle: f64| Ok(sections.at(angle, table)?.0);
    let places: Vec<(usize, f64)> = angles.iter().copied().enumerate().collect();
    let answers = |places: &[(usize, f64)]| answers(places, &sections, table);
    let mut points = Vec::with_capacity(angles.len());
    let mut without_balance = Vec::new();
    let mut following = Following::default();
    for block in places.chunks(BLOCK) {
        let found: Vec<_> = block.par_chunks(AT_ONCE).map(answers).collect();
        // The first error, not the one that was found first.
        let found: Vec<Answers> = found.into_iter().collect::<Result<_, _>>()?;
        let (found, none): (Vec<_>, Vec<_>) = found.into_iter().unzip();
        without_balance.extend(none.into_iter().flatten());
        let (own, modes): (Vec<Point>, Vec<Modes>) = found.into_iter().flatten().unzip();
        let numbers = following.numbers(&modes);
        let numbered = modes
            .iter()
            .zip(&numbers)
            .map(|(own, numbers)| own.numbered(numbers));
        let numbered = own.into_iter().zip(numbered);
        points.extend(numbered.map(|(point, modes)| Point { modes, ..point }));
    }
    if let ([], [first, ..]) = (points.as_slice(), without_balance.as_slice()) {
        return Err(sections.without_twist(first.angle, first.reason));
    }
    let at: Vec<f64> = points.iter().map(|own| own.angle).collect();
    let within = within::within(case, table, &at, &section)?;
    // What overturns verdicts is said first; scatter that turns none is not said.
    let scattered = match &within {
        Some(own) if !own.has_errors() => own.remark(case, table, &points),
        _ => case.scatter_remark(table),
    };
    let mut remarks: Vec<Remark> = scattered.into_iter().collect();
    remarks.extend(twist::remarks_without_balance(
        case,
        &without_balance,
        angles.len(),
    ));
    remarks.extend(self::remarks(table));
    remarks.extend(case.remarks());
    remarks.extend(weakened(case, &section, &points));
    remarks.extend(twist::remarks(case, &points, angles.len()));
    let corners = match case.is_twisted() {
        true => 0,
        false => sections.curves().corners(&angles),
    };
    if corners > 0 {
        remarks.push(Remark {
            place: file,
            what: format!(
                "{corners} of the {} angles of the sweep are corners of the straight lines through the table; \
                 the derivative there is that of the cell above",
                angles.len()
            ),
        });
    }
    Ok(Comparison {
        case: case.clone(),
        within,
        unstable: range::unstable(&points),
        undecided: range::undecided(&points),
        agreements: agreement::agreements(&points),
        points,
        without_balance,
        reading: format!(
            "{}: {}; {}",
            table.file(),
            table.reading(),
            case.interpolation
        ),
        remarks,
    })
}

/// The points at some angles, and those without a certain mean twist.
type Answers = (Vec<(Point, Modes)>, Vec<NoBalance>);

/// What all methods say at some angles with their places in the sweep.
fn answers(
    places: &[(usize, f64)],
    sections: &Sections<'_>,
    table: &CoefficientTable,
) -> Result<Answers, InputError> {
    let (mut at, mut found, mut twists) = (Vec::new(), Vec::new(), Vec::new());
    let mut without = Vec::new();
    for &(place, angle) in places {
        match sections.found(angle, table)? {
            Ok((section, twist)) => {
                at.push((place, angle));
                found.push(section);
                twists.push(twist);
            }
            Err(reason) => without.push(NoBalance {
                place,
                angle,
                reason,
            }),
        }
    }
    let points = point::points(&at, &found, &twists);
    let impossible = |(angle, error)| sections.impossible(angle, &error);
    Ok((points.map_err(impossible)?, without))
}

/// Where structural damping does harm, a remark for each coordinate.
fn weakened<'a>(
    case: &'a Case,
    section_at: &'a impl Fn(f64) -> Result<Section, InputError>,
    points: &'a [Point],
) -> impl Iterator<Item = Remark> + 'a {
    let remark = move |&coordinate: &Coordinate| {
        let slope = |point: &Point| {
            let mut found = point.weakened_by.iter();
            found
                .find(|(own, _)| *own == coordinate)
                .map(|(_, slope)| *slope)
        };
        let slopes = points
            .iter()
            .filter_map(|point| Some((slope(point)?, point)));
        let (_, steepest) =
            slopes.reduce(|one, other| if other.0 < one.0 { other } else { one })?;
        let change = with_more_damping(&section_at(steepest.angle).ok()?, coordinate)?
            - steepest.exact.value;
        // What leaves S and the verdict as they are is not said.
        if change.abs() < SMALL_CHANGE.min(steepest.exact.value.abs()) {
            return None;
        }
        let size = rounded_change(change);
        let change = match change < 0.0 {
            true => format!("lowers it by {size}"),
            false => format!("raises it by {size}, since only a little lowers it"),
        };
        let ranges = range::ranges(points, |point| slope(point).is_some());
        Some(Remark {
            place: Place::file(&case.file),
            what: format!(
                "a little more structural damping of {0} lowers S ({1}); at {2}°, where it does so most steeply, adding 0.01 to zeta_{0} {change}",
                coordinate.name(),
                listed(&ranges),
                angle(steepest.angle),
            ),
        })
    };
    case.parameters.free.as_slice().iter().filter_map(remark)
}

/// Changes of S below this are not seen in a figure.
const SMALL_CHANGE: f64 = 0.01;

/// The size of a change of S: with two decimals, or one digit of what is smaller.
fn rounded_change(change: f64) -> String {
    match change.abs() {
        size if size < SMALL_CHANGE => format!("{size:.0e}"),
        size => format!("{size:.2}"),
    }
}

/// S with a structural damping ratio larger by 0.01.
fn with_more_damping(section: &Section, coordinate: Coordinate) -> Option<f64> {
    let mut parameters = *section.parameters();
    parameters.damping_ratios[coordinate.index()] += 0.01;
    let section = Section::new(parameters).ok()?;
    let spectrum = state_matrix::eigenvalues(&Model::new(&section).ok()?).ok()?;
    Some(spectrum.damping_coefficient(&section)?.0)
}

impl Comparison {
    /// The most modes that any point has.
    pub fn mode_count(&self) -> usize {
        let labels = self.points.iter().flat_map(|point| &point.modes);
        labels.map(|mode| mode.label).max().unwrap_or(0)
    }

    /// How many angles the sweep has.
    pub fn angle_count(&self) -> usize {
        self.points.len() + self.without_balance.len()
    }

    /// All angles of the sweep in degrees, with the point there; `None` where there is no certain mean twist.
    pub fn at_all_angles(&self) -> Vec<(f64, Option<&Point>)> {
        let with = self.points.iter().map(|own| (own.angle, Some(own)));
        let mut all: Vec<_> = with.collect();
        for own in &self.without_balance {
            // They are in order, so that each finds those before it in their places.
            all.insert(own.place, (own.angle, None));
        }
        all
    }

    /// The free coordinates, in order.
    pub fn free(&self) -> &[Coordinate] {
        self.case.parameters.free.as_slice()
    }

    /// The name of the largest S of all modes: `S_3D`, `S_2D` or `S_1D`, after the free coordinates.
    pub fn coefficient_name(&self) -> &'static str {
        self.case.parameters.free.coefficient_name()
    }
}
