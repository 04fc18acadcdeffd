//! Comparisons of the first route: equal normal forms, leading terms, signs.

use std::collections::BTreeSet;

use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::sign::Signs;
use crate::algebra::symbol::Symbol;
use crate::derivation::diagnostic::{Diagnostic, DiagnosticKind};
use crate::derivation::elaboration::Elaborator;
use crate::derivation::elaboration::error::{algebra, expansion};
use crate::derivation::syntax::{Comparison, Order, Relation, Span};

use super::Outcome;

/// How far beyond the stated order the leading term of a residual is looked for.
const RESIDUAL_ORDERS: u32 = 3;

/// Why different normal forms do not refute an equation.
const DIRECTION: &str =
    "the difference contains the angle of a vector, which may be one of the other angles";

impl Elaborator {
    /// Whether all differences are 0.
    pub(super) fn compare(&self, differences: &[Fraction]) -> Outcome {
        if differences.iter().all(Fraction::is_zero) {
            return Outcome::True;
        }
        match self.rests_on_direction(differences) {
            true => Outcome::Unresolved(DIRECTION),
            false => Outcome::Different(None),
        }
    }

    /// Whether the angle of a vector occurs in elements: it may be one of the other angles.
    fn rests_on_direction(&self, elements: &[Fraction]) -> bool {
        let symbols = self.constituents(elements);
        symbols
            .into_iter()
            .any(|symbol| match self.ring.generator(symbol) {
                Generator::Direction { .. } => true,
                Generator::FunctionValue { argument, .. } => {
                    self.rests_on_direction(std::slice::from_ref(argument))
                }
                _ => false,
            })
    }

    /// The symbols of elements, and those in the roots among them.
    fn constituents(&self, elements: &[Fraction]) -> BTreeSet<Symbol> {
        let sides = elements
            .iter()
            .flat_map(|element| [element.numerator(), element.denominator()]);
        let mut open: Vec<Symbol> = sides.flat_map(Polynomial::symbols).collect();
        let mut found = BTreeSet::new();
        while let Some(symbol) = open.pop() {
            if found.insert(symbol)
                && let Generator::Root { radicand } = self.ring.generator(symbol)
            {
                open.extend(radicand.symbols());
            }
        }
        found
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
            Some((degree, _)) if degree <= stated => match self.rests_on_direction(differences) {
                true => (Outcome::Unresolved(DIRECTION), None),
                false => (Outcome::Different(Some(degree)), None),
            },
            Some((_, residual)) => (Outcome::TrueToOrder, Some(residual)),
            None => (Outcome::TrueToOrder, None),
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
            true if self.is_transcendental(difference) => Outcome::Unresolved(
                "the measure of an angle stands beside its sine or cosine, or is that of a vector, which \
                 a rational point cannot follow",
            ),
            true => Outcome::Open,
        })
    }

    /// Whether the measure of an angle stands beside a sine or cosine of it, or is that of a vector: a
    /// point of the relations gives them values that do not belong together, which shows nothing about
    /// an inequality.
    fn is_transcendental(&self, element: &Fraction) -> bool {
        let symbols = self.constituents(std::slice::from_ref(element));
        symbols
            .iter()
            .any(|symbol| match self.ring.generator(*symbol) {
                Generator::Cosine { angle } | Generator::Sine { angle } => angle
                    .coefficients()
                    .any(|(inside, _)| symbols.contains(&inside)),
                Generator::Direction { .. } => true,
                _ => false,
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
