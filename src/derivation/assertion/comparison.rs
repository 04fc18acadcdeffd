//! Comparisons of the first route: equal normal forms, leading terms, signs.

use crate::algebra::fraction::Fraction;
use crate::algebra::sign::Signs;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::elaboration::error::{algebra, expansion};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Comparison, Order, Relation, Span};

use super::Outcome;

/// How far beyond the stated order the leading term of a residual is looked for.
const RESIDUAL_ORDERS: u32 = 3;

impl Elaborator {
    /// Whether all differences are 0.
    pub(super) fn compare(&self, differences: &[Fraction]) -> Outcome {
        match differences.iter().all(Fraction::is_zero) {
            true => Outcome::True,
            false => Outcome::Different(None),
        }
    }

    /// Whether all differences begin beyond an order in small quantities, and the leading term.
    pub(super) fn compare_to_order(
        &mut self,
        differences: &[Fraction],
        order: &Order,
        span: &Span,
    ) -> Result<(Outcome, Option<Fraction>), Diagnostic> {
        let small = self.variables(&order.small)?;
        let names: Vec<String> = order.small.iter().map(|s| s.value.to_string()).collect();
        let stated = order.order.value;
        let mut leading: Option<(u32, Fraction)> = None;
        for difference in differences {
            let found = self
                .ring
                .leading_part(difference, &small, stated, stated + RESIDUAL_ORDERS)
                .map_err(|error| expansion(error, &names, span))?;
            let earlier = leading
                .as_ref()
                .is_none_or(|(least, _)| found.as_ref().is_some_and(|(degree, _)| degree < least));
            if earlier && found.is_some() {
                leading = found;
            }
        }
        Ok(match leading {
            _ if differences.iter().all(Fraction::is_zero) => (Outcome::True, None),
            Some((degree, _)) if degree <= stated => (Outcome::Different(Some(degree)), None),
            Some((degree, residual)) => (Outcome::TrueToOrder(Some(degree)), Some(residual)),
            None => (Outcome::TrueToOrder(None), None),
        })
    }

    /// Whether the signs of a difference follow from the assumptions.
    pub(super) fn compare_signs(
        &mut self,
        differences: &[Fraction],
        comparison: Comparison,
        relation: &Relation,
    ) -> Result<Outcome, Diagnostic> {
        let span = &relation.left.span;
        let [difference] = differences else {
            let message = "matrices have no order";
            return Err(
                Diagnostic::new(DiagnosticKind::Shape, span.clone(), message)
                    .with_label("a matrix")
                    .with_help("compare their entries, such as `A[1, 2] < B[1, 2]`"),
            );
        };
        let signs = self
            .ring
            .signs(difference)
            .map_err(|error| algebra(error, span))?;
        let wanted = allowed(comparison);
        let possible = |sign: fn(Signs) -> bool| sign(signs) && !sign(wanted);
        let violated = possible(|signs| signs.negative)
            || possible(|signs| signs.zero)
            || possible(|signs| signs.positive);
        Ok(match violated {
            false => Outcome::True,
            true => Outcome::Open,
        })
    }
}

/// The signs that left − right may have.
fn allowed(comparison: Comparison) -> Signs {
    match comparison {
        Comparison::Equal => Signs::ZERO,
        Comparison::Less => Signs::NEGATIVE,
        Comparison::LessOrEqual => Signs::NON_NEGATIVE.opposite(),
        Comparison::Greater => Signs::POSITIVE,
        Comparison::GreaterOrEqual => Signs::NON_NEGATIVE,
    }
}
