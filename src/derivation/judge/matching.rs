//! The second route for a matching: its residuals at points.

use std::collections::BTreeMap;

use crate::derivation::diagnostic::{Diagnostic, DiagnosticKind};
use crate::derivation::evaluation::evaluator::{Evaluator, Failure};
use crate::derivation::evaluation::number::Number;
use crate::derivation::matching::Matched;
use crate::derivation::syntax::{Expression, Node, Place, Span};

use super::Checked;

/// What is evaluated at points to check a matching: exact − assumed against the residual, power by
/// power, with the solution put in.
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
        let residuals = matched
            .table
            .iter()
            .map(|row| (row.power, row.residual.clone()));
        MatchingCheck {
            exact,
            assumed,
            variable: matched.variable.ascii.clone(),
            residuals: residuals.collect(),
            span: span.clone(),
        }
    }

    /// Compares the residuals at a point.
    pub fn check<'a>(&'a self, evaluator: &mut Evaluator<'a>) -> Checked {
        let power = match self.differs(evaluator) {
            Ok(None) => return Ok(Ok(())),
            Ok(Some(power)) => power,
            Err(reason) => return Ok(Err(reason)),
        };
        let message = "the matching fails at a random point";
        Err(
            Diagnostic::new(DiagnosticKind::Disagreement, self.span.clone(), message)
                .with_label(format!("at the power {power}"))
                .with_help("this is a mistake of sextic, not of the document: please report it"),
        )
    }

    /// What the points come to: an error where there are too few.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] with the reason.
    pub fn conclude(&self, points: Result<usize, Failure>) -> Result<(), Diagnostic> {
        points.map(drop).map_err(|reason| {
            let message = "this matching cannot be checked at a point";
            Diagnostic::new(DiagnosticKind::Unsupported, self.span.clone(), message)
                .with_label(reason)
        })
    }

    /// The first power at which the residual is not what it was found to be.
    fn differs<'a>(&'a self, evaluator: &mut Evaluator<'a>) -> Result<Option<u32>, Failure> {
        let exact = evaluator.coefficients(&self.exact, &self.variable)?;
        let assumed = evaluator.coefficients(&self.assumed, &self.variable)?;
        for (power, residual) in &self.residuals {
            let of = |side: &[Number]| side.get(*power as usize).cloned().unwrap_or_default();
            let difference = of(&exact).difference(&of(&assumed));
            if evaluator.evaluate(residual)?[0][0] != difference {
                return Ok(Some(*power));
            }
        }
        Ok(None)
    }
}
