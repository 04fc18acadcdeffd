//! The second route for a matching: its residuals at assignments.

use std::collections::BTreeMap;

use crate::derivation::matching::Matched;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Expression, Node, Place, Span};
use crate::points::Failure;
use crate::points::unfolding::Unfolding;

use super::fault;
use super::sides::DIGITS;

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
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where one is not what it was found to be, or cannot be looked at.
    pub fn check<'a>(&'a self, unfolding: &mut Unfolding<'a>) -> Result<(), Diagnostic> {
        for (power, residual) in &self.residuals {
            match self.agrees(*power, residual, unfolding) {
                Ok(true) => {}
                Ok(false) => {
                    let message = "the matching fails at a random assignment";
                    let label = format!("at the power {power}");
                    return Err(fault(&self.span, message).with_label(label));
                }
                Err(failure) => return Err(self.unchecked(failure)),
            }
        }
        Ok(())
    }

    fn unchecked(&self, failure: Failure) -> Diagnostic {
        let message = "this matching cannot be checked at a point";
        Diagnostic::new(DiagnosticKind::Unsupported, self.span.clone(), message)
            .with_label(failure.to_string())
            .with_help("match less at once, or let a `parameter` stand for a part")
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
}
