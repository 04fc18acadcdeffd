//! The sections of a case at its angles.

use super::case::Case;
use super::coefficient_table::CoefficientTable;
use super::coefficient_table::remarks::mistaken_unit;
use super::error::StabilityError;
use super::forces::Coefficients;
use super::input::{InputError, Place};
use super::interpolation::{CoefficientCurves, OutsideTable};
use super::mean_twist::{MomentCurve, NoTwist, Twist};
use super::parameters::{Open, Parameters};
use super::section::Section;

/// A case with the curves of its table.
#[derive(Clone, Debug)]
pub struct Sections<'a> {
    case: &'a Case,
    curves: CoefficientCurves,
    /// Of what the mean twist is found, where the case asks for it and the section can turn.
    moments: Option<MomentCurve>,
}

/// More than what is rounded as a twist is added to an angle, in rad.
const SUM: f64 = 2e-15;

/// Why there is no section at an angle, in degrees.
enum NoSection {
    Outside(OutsideTable),
    NoTwist(NoTwist),
}

impl<'a> Sections<'a> {
    /// The sections of a case with this table.
    ///
    /// # Errors
    ///
    /// As [`CoefficientCurves::new`].
    pub fn new(case: &'a Case, table: &CoefficientTable) -> Result<Self, InputError> {
        let curves = CoefficientCurves::new(table, case.interpolation)?;
        Ok(Sections {
            moments: case.is_twisted().then(|| MomentCurve::of(&curves)),
            case,
            curves,
        })
    }

    /// The curves.
    pub fn curves(&self) -> &CoefficientCurves {
        &self.curves
    }

    /// Whether the mean twist is found for each.
    pub(super) fn are_twisted(&self) -> bool {
        self.moments.is_some()
    }

    /// The section at an angle of attack in degrees, which is that without a mean twist, and its twist if the case asks for
    /// it.
    ///
    /// # Errors
    ///
    /// If the angle, or that with the twist, is outside of the table, there is no certain twist, or no section is possible
    /// there.
    pub fn at(
        &self,
        angle: f64,
        table: &CoefficientTable,
    ) -> Result<(Section, Option<Twist>), InputError> {
        let found = self.found(angle, table)?;
        found.map_err(|none| self.without_twist(angle, none))
    }

    /// The same, where it is no error that there is no certain twist.
    ///
    /// # Errors
    ///
    /// As [`Sections::at`].
    pub(super) fn found(
        &self,
        angle: f64,
        table: &CoefficientTable,
    ) -> Result<Result<(Section, Option<Twist>), NoTwist>, InputError> {
        let (parameters, twist) = match self.parameters(angle) {
            Ok(found) => found,
            Err(NoSection::NoTwist(none)) => return Ok(Err(none)),
            Err(NoSection::Outside(outside)) => return Err(self.outside(&outside, table)),
        };
        let section = Section::new(parameters);
        let section = section.map_err(|error| self.impossible(angle, &error))?;
        Ok(Ok((section, twist)))
    }

    /// That there is no section at an angle, since it has no certain twist.
    pub(super) fn without_twist(&self, angle: f64, none: NoTwist) -> InputError {
        self.wrong(angle, &none.to_string(), none.help())
    }

    fn parameters(&self, angle: f64) -> Result<(Parameters, Option<Twist>), NoSection> {
        let coefficients = self.curves.at(angle).map_err(NoSection::Outside)?;
        let parameters = self.case.parameters_at(angle, coefficients);
        self.twisted(angle, parameters).map_err(NoSection::NoTwist)
    }

    /// The parameters of a section that the mean moment has twisted, with the coefficients there; those of the angle itself
    /// if no twist is asked for.
    ///
    /// # Errors
    ///
    /// If there is no certain twist.
    pub(super) fn twisted(
        &self,
        angle: f64,
        parameters: Parameters,
    ) -> Result<(Parameters, Option<Twist>), NoTwist> {
        let (Some(moments), Some(place)) = (&self.moments, self.curves.piece_at(angle)) else {
            return Ok((parameters, None));
        };
        let twist = moments.twist(&parameters, place)?;
        let turned = place.1 + twist.angle.to_degrees();
        let error = if twist.error > 0.0 {
            twist.error + SUM
        } else {
            0.0
        };
        // It turns to where the excess without it is not.
        let excess = 0.0_f64.partial_cmp(&twist.angle);
        let beyond = |_: OutsideTable| moments.beyond(place, excess);
        let coefficients = self.curves.at(turned).map_err(beyond)?;
        let open = match error > 0.0 {
            true => self
                .curves
                .moved_by(turned, error.to_degrees())
                .map_err(beyond)?,
            false => Coefficients::default(),
        };
        let parameters = Parameters {
            attitude: parameters.attitude + twist.angle,
            forces: self.case.coefficients_as_set(coefficients).into(),
            open: Some(Open {
                attitude: error,
                coefficients: self.case.errors_of_table(open),
            }),
            ..parameters
        };
        Ok((parameters, Some(twist)))
    }

    fn outside(&self, outside: &OutsideTable, table: &CoefficientTable) -> InputError {
        let help = match mistaken_unit(table) {
            Some(remark) => remark.to_string(),
            None if table.is_circle() => "complete the table".to_string(),
            None => format!(
                "shorten the sweep in {}, complete the table, or write `mirror = true` if it is half of what is its own \
                 mirror image",
                self.case.file
            ),
        };
        InputError::new(Place::file(table.file()), outside.to_string(), help)
    }

    pub(super) fn impossible(&self, angle: f64, error: &StabilityError) -> InputError {
        self.wrong(angle, &error.to_string(), "correct the case or its table")
    }

    fn wrong(&self, angle: f64, what: &str, help: &str) -> InputError {
        let what = format!("at {angle}°: {what}");
        InputError::new(Place::file(&self.case.file), what, help)
    }
}
