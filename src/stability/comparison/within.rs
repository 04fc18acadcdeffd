//! What is certain of a case within the errors of its coefficients, or within the scatter of its table.

use rayon::prelude::*;

use super::point::Point;
use super::range::{AngleRange, listed, ranges};
use crate::stability::case::Case;
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::coefficient_table::scatter::scatter;
use crate::stability::input::{InputError, Place, Remark};
use crate::stability::interpolation::{CoefficientCurves, Interpolation};
use crate::stability::section::Section;
use crate::stability::smoothing::MOST_POINTS;
use crate::stability::tolerance::{Certainty, Tolerance, tolerance};

/// What is certain at the angles of a case for all coefficients that a table leaves open.
#[derive(Clone, Debug, PartialEq)]
pub struct Within {
    /// What leaves them open.
    pub cause: Cause,
    /// What is known at each angle, in order.
    pub tolerances: Vec<Tolerance>,
}

/// Why coefficients may be other ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// The table or the case gives errors.
    Errors,
    /// The table scatters about smooth curves, with these standard deviations of C_D, C_L and C_M: it is asked whether
    /// two of them can turn a verdict.
    Scatter([f64; 3]),
}

impl Within {
    /// Whether the table or the case gives errors.
    pub fn has_errors(&self) -> bool {
        self.cause == Cause::Errors
    }

    /// Where something holds of what is known.
    pub fn ranges(&self, points: &[Point], holds: impl Fn(&Tolerance) -> bool) -> Vec<AngleRange> {
        let angles = points.iter().zip(&self.tolerances);
        let angles: Vec<f64> = angles
            .filter(|(_, own)| holds(own))
            .map(|(point, _)| point.angle)
            .collect();
        ranges(points, |point| angles.contains(&point.angle))
    }

    /// That the scatter of the table alone may turn verdicts, if it may.
    pub(super) fn remark(
        &self,
        case: &Case,
        table: &CoefficientTable,
        points: &[Point],
    ) -> Option<Remark> {
        let Cause::Scatter(found) = self.cause else {
            return None;
        };
        let may_turn =
            |own: &Tolerance| matches!(own.certainty, Certainty::Depends | Certainty::Open);
        let count = self.tolerances.iter().filter(|own| may_turn(own)).count();
        let turned = self.ranges(points, may_turn);
        let parts = ["CD", "CL", "CM"].into_iter().zip(found);
        let parts: Vec<String> = parts
            .filter(|(_, own)| *own > 0.0)
            .map(|(name, own)| format!("{name} by {own:.1e}"))
            .collect();
        (count > 0).then(|| Remark {
            place: Place::file(table.file()),
            what: format!(
                "the numbers scatter about smooth curves ({}); twice that, in each row by itself, may turn the \
                 verdict at {count} of {} angles ({}): {}give the `errors` of the coefficients; of these the worst are \
                 taken in all rows at once, which may turn it at more angles",
                parts.join(", "),
                points.len(),
                listed(&turned),
                match case.interpolation {
                    Interpolation::Smooth => "",
                    _ => "say `interpolation = \"smooth\"`, or ",
                },
            ),
        })
    }
}

/// So many standard deviations may be off.
const DEVIATIONS: f64 = 2.0;

/// What coefficients a table leaves open, and why.
pub struct Open<'a> {
    case: &'a Case,
    cause: Cause,
    curves: CoefficientCurves,
}

impl<'a> Open<'a> {
    /// By the errors of a table, or by its scatter where there is some; `None` where the coefficients are as they are.
    ///
    /// # Errors
    ///
    /// If the errors of so many rows are not followed through splines, or would move a mean twist.
    pub fn of(case: &'a Case, table: &CoefficientTable) -> Result<Option<Self>, InputError> {
        let cause = match (table.has_errors(), scatter(table)) {
            (true, _) if case.is_twisted() => return Err(twisted(case)),
            // How scatter moves the twist is not followed.
            (false, _) if case.is_twisted() => return Ok(None),
            (true, _) => Cause::Errors,
            // Of derivatives that the table gives no scatter is known.
            (false, _) if case.errors.is_some() || table.has_slopes() => return Ok(None),
            (false, [0.0, 0.0, 0.0]) => return Ok(None),
            (false, found) => Cause::Scatter(found),
        };
        let open = match cause {
            Cause::Errors => table.clone(),
            Cause::Scatter(found) => table.clone().with_errors(found.map(|own| DEVIATIONS * own)),
        };
        let curves = CoefficientCurves::new(&open, case.interpolation)?;
        match (cause, curves.follows_errors()) {
            (_, true) => Ok(Some(Open {
                case,
                cause,
                curves,
            })),
            (Cause::Scatter(_), false) => Ok(None),
            (Cause::Errors, false) => Err(too_many(table)),
        }
    }

    /// Whether the table or the case gives errors.
    pub fn has_errors(&self) -> bool {
        self.cause == Cause::Errors
    }

    /// What is certain of a section, which is that at an angle in degrees.
    pub fn tolerance(&self, angle: f64, section: &Section) -> Tolerance {
        let errors = match self.cause {
            Cause::Errors => self.curves.errors_at(angle),
            Cause::Scatter(_) => self.curves.scatter_at(angle),
        };
        // The section has been found there.
        let errors = self.case.errors_of_table(errors.unwrap_or_default());
        tolerance(section, &errors).unwrap_or(Tolerance {
            certainty: Certainty::Open,
            damping: None,
        })
    }
}

/// What is certain at angles in degrees, if the table leaves coefficients open.
pub(super) fn within(
    case: &Case,
    table: &CoefficientTable,
    angles: &[f64],
    section_at: &(impl Fn(f64) -> Result<Section, InputError> + Sync),
) -> Result<Option<Within>, InputError> {
    let Some(open) = Open::of(case, table)? else {
        return Ok(None);
    };
    let at = |&angle: &f64| Ok(open.tolerance(angle, &section_at(angle)?));
    let tolerances = angles
        .par_iter()
        .map(at)
        .collect::<Result<_, InputError>>()?;
    Ok(Some(Within {
        cause: open.cause,
        tolerances,
    }))
}

fn twisted(case: &Case) -> InputError {
    let what = "errors of C_M move the mean twist, and this is not followed";
    let help = "leave out `mean_twist`, or the errors of the coefficients";
    InputError::new(Place::file(&case.file), what, help)
}

fn too_many(table: &CoefficientTable) -> InputError {
    let what = format!(
        "the errors of {} rows are not followed through splines",
        table.rows().len()
    );
    let help = format!(
        "leave rows out, of which at most {MOST_POINTS} are followed, or write `interpolation = \"linear\"`"
    );
    InputError::new(Place::file(table.file()), what, help)
}
