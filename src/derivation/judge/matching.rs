//! The second route for a matching: its residuals at assignments.

use std::collections::BTreeMap;

use crate::derivation::diagnostic::{Diagnostic, DiagnosticKind};
use crate::derivation::matching::Matched;
use crate::derivation::syntax::{Expression, Node, Place, Span};
use crate::points::Failure;
use crate::points::unfolding::Unfolding;

use super::sides::DIGITS;
use super::{Checked, POINTS, fault};

/// What is evaluated to check a matching: exact − assumed against the residual, power by power, with the
/// solution put in.
pub struct MatchingCheck {
    exact: Expression,
    assumed: Expression,
    variable: String,
    residuals: BTreeMap<u32, Expression>,
    span: Span,
}

impl MatchingCheck {
    /// The check of a matching that stands at a place.
    pub fn new(matched: &Matched, span: &Span) -> Self {
        let (exact, assumed) = matched.polynomials.clone();
        let place = Place::named(matched.name.clone());
        let assumed = Expression::made(Node::At(Box::new(assumed), place));
        let rows = matched.table.iter();
        MatchingCheck {
            exact,
            assumed,
            variable: matched.variable.ascii.clone(),
            residuals: rows.map(|row| (row.power, row.residual.clone())).collect(),
            span: span.clone(),
        }
    }

    /// Compares the residuals at random assignments.
    pub fn check<'a>(&'a self, unfolding: &mut Unfolding<'a>) -> Result<Checked, Diagnostic> {
        let mut checked = Ok(POINTS);
        for (power, residual) in &self.residuals {
            match self.agrees(*power, residual, unfolding) {
                Ok(true) => {}
                Ok(false) => {
                    let message = "the matching fails at a random assignment";
                    let label = format!("at the power {power}");
                    return Err(fault(&self.span, message).with_label(label));
                }
                Err(failure) => checked = Err(failure.to_string()),
            }
        }
        Ok(checked)
    }

    /// Whether the residual of a power is what it was found to be.
    fn agrees<'a>(
        &'a self,
        power: u32,
        residual: &'a Expression,
        unfolding: &mut Unfolding<'a>,
    ) -> Result<bool, Failure> {
        let exact = unfolding.coefficient(&self.exact, &self.variable, power)?;
        let assumed = unfolding.coefficient(&self.assumed, &self.variable, power)?;
        let residual = unfolding.scalar(residual)?;
        let sheet = &mut unfolding.sheet;
        let difference = sheet.graph.difference(exact, assumed)?;
        sheet.agree(difference, residual, DIGITS)
    }

    /// What the points come to: an error where there are too few.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] with the reason.
    pub fn conclude(&self, checked: Result<Checked, Diagnostic>) -> Result<(), Diagnostic> {
        checked?.map(drop).map_err(|reason| {
            let message = "this matching cannot be checked at a point";
            Diagnostic::new(DiagnosticKind::Unsupported, self.span.clone(), message)
                .with_label(reason)
        })
    }
}
