//! Assertions, and what the first route tells of them.

pub(crate) mod comparison;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::polynomial::Polynomial;

use super::condition::Condition;
use super::condition::Conditions;
use super::elaboration::Elaborator;
use super::elaboration::error::{algebra, unexpandable};
use super::elaboration::limit::check_order;
use super::quantity::{Value, common_unit};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{
    BinaryOperator, Comparison, Expectation, Expression, Label, Order, Relation, Span,
};
use crate::language::unit::Unit;

/// An assertion as the document makes it.
#[derive(Clone, Debug)]
pub struct Assertion {
    /// How it is called.
    pub label: Label,
    /// What the author expects.
    pub expectation: Expectation,
    /// What is asserted.
    pub relation: Relation,
    /// Of a refutation: what left − right is.
    pub difference: Option<Expression>,
    /// Of an approximation.
    pub order: Option<Order>,
    /// In words.
    pub description: Option<String>,
    /// The line on which it stands, counted from 1.
    pub line: usize,
    /// Where it stands.
    pub span: Span,
}

impl Assertion {
    /// That left − right is what the author says it is, if that is said.
    pub(crate) fn of_difference(&self) -> Option<Self> {
        let Relation { left, right, .. } = self.relation.clone();
        Some(Assertion {
            expectation: Expectation::Holds,
            relation: Relation {
                left: Expression::binary(BinaryOperator::Subtract, left, right),
                comparison: Comparison::Equal,
                right: self.difference.clone()?,
            },
            difference: None,
            ..self.clone()
        })
    }
}

/// What the first route tells of an assertion.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The assertion.
    pub assertion: Assertion,
    /// What the normal forms show.
    pub(crate) outcome: Outcome,
    /// What the steps needed.
    pub(crate) conditions: Vec<Condition>,
    /// Of an approximation, the leading term of left − right.
    pub(crate) residual: Option<Expression>,
    /// The normal forms of both sides; nothing where they cannot be compared.
    pub(crate) sides: Option<(Value, Value)>,
}

/// What does not fit together in an assertion.
#[derive(Clone, Debug, PartialEq)]
pub enum Misfit {
    /// The shapes of matrices.
    Shapes,
    /// The units of two expressions that are added or compared, which are known if they stand in the assertion itself.
    Units(Option<Box<(Expression, Expression)>>),
}

/// What the normal forms of both sides show.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Outcome {
    /// Units or shapes do not match.
    IllFormed { reason: String, misfit: Misfit },
    /// The normal forms agree, or the inequality follows from the assumptions.
    True,
    /// The normal forms agree up to the order; the degree behind it at which they do not, if one was found.
    TrueToOrder(Option<u32>),
    /// The normal forms differ, at the given degree in the small quantities for an approximation.
    Different(Option<u32>),
    /// The assumptions do not decide an inequality.
    Open,
}

impl Outcome {
    /// The degree at which an approximation is found to be false.
    pub(crate) const fn degree(&self) -> Option<u32> {
        match self {
            Outcome::Different(degree) => *degree,
            _ => None,
        }
    }
}

/// Why an assertion has no meaning, in words, and what does not fit.
type IllFormed = (String, Misfit);

impl Misfit {
    /// What a mistake of units or shapes in a relation is about; it labels the expressions.
    fn of(error: &Diagnostic, relation: &Relation) -> Self {
        if error.kind == DiagnosticKind::Shape {
            return Misfit::Shapes;
        }
        let part = |place: usize| {
            let (span, _) = error
                .secondary
                .get(place)
                .filter(|(own, _)| !own.is_empty())?;
            let mut sides = [&relation.left, &relation.right].into_iter();
            sides.find_map(|side| side.part_at(span)).cloned()
        };
        Misfit::Units(part(0).zip(part(1)).map(Box::new))
    }
}

impl Elaborator {
    /// Compares the sides of an assertion in normal form.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where a side has no value for another reason than units and shapes.
    pub fn find(&mut self, assertion: &Assertion) -> Result<Finding, Diagnostic> {
        let span = &assertion.span;
        let relation = &assertion.relation;
        if let Some(order) = &assertion.order {
            check_order(order.order.value, &order.order.span)?;
            if relation.comparison != Comparison::Equal {
                let message = "only an equation can hold to an order";
                return Err(
                    Diagnostic::new(DiagnosticKind::Unsupported, span.clone(), message)
                        .with_label("an inequality")
                        .with_help("leave out `to order …`, or compare with `==`"),
                );
            }
        }
        let (left, right) = match self.sides(relation)? {
            Ok(sides) => sides,
            Err((reason, misfit)) => {
                return Ok(Finding {
                    assertion: assertion.clone(),
                    outcome: Outcome::IllFormed { reason, misfit },
                    conditions: Vec::new(),
                    residual: None,
                    sides: None,
                });
            }
        };
        let pairs = left.entries().iter().zip(right.entries());
        let differences: Vec<Fraction> = pairs
            .map(|(a, b)| self.ring.difference(&a.value, &b.value))
            .collect::<Result<_, _>>()
            .map_err(|error| algebra(error, span))?;
        let (outcome, residual) = match (relation.comparison, &assertion.order) {
            (Comparison::Equal, None) => (self.compare(&differences), None),
            (Comparison::Equal, Some(order)) => self.compare_to_order(&differences, order, span)?,
            (comparison, _) => {
                self.require_real([(&left, &relation.left), (&right, &relation.right)])?;
                (
                    self.compare_signs(&differences, comparison, relation)?,
                    None,
                )
            }
        };
        // What is equal to every order is equal, on the conditions of both sides.
        if let Some(order) = assertion
            .order
            .as_ref()
            .filter(|_| outcome != Outcome::True)
        {
            self.require_where_small_vanish(order, span)?;
        }
        self.keep(&left, span)?;
        self.keep(&right, span)?;
        let needed = std::mem::take(&mut self.conditions);
        Ok(Finding {
            assertion: assertion.clone(),
            outcome,
            conditions: self.present_conditions(&needed, span)?,
            residual: residual
                .map(|residual| self.present(&residual, span))
                .transpose()?,
            sides: Some((left, right)),
        })
    }

    /// The conditions of an approximation: those of both sides and of their expansions, where the small
    /// quantities vanish.
    fn require_where_small_vanish(&mut self, order: &Order, span: &Span) -> Result<(), Diagnostic> {
        let small = self.variables(&order.small)?;
        let names: Vec<String> = order.small.iter().map(|s| s.value.to_string()).collect();
        let needed = std::mem::take(&mut self.conditions);
        self.require_expansion(needed, &small, span)
            .map_err(|error| unexpandable(error, &names, span))
    }

    /// Sees that values are real: complex numbers have no order.
    pub(crate) fn require_real(&self, sides: [(&Value, &Expression); 2]) -> Result<(), Diagnostic> {
        for (value, expression) in sides {
            let entries = value.entries().iter();
            if !entries
                .map(|entry| &entry.value)
                .all(|entry| self.ring.is_real(entry))
            {
                return Err(algebra(AlgebraError::NotReal, &expression.span)
                    .with_label("complex numbers have no order"));
            }
        }
        Ok(())
    }

    /// Both sides, or why they cannot be compared: their units or shapes do not match.
    fn sides(
        &mut self,
        relation: &Relation,
    ) -> Result<Result<(Value, Value), IllFormed>, Diagnostic> {
        let sides = self
            .value(&relation.left)
            .and_then(|left| Ok((left, self.value(&relation.right)?)));
        let (left, right) = match sides {
            Ok(sides) => sides,
            Err(error) if matches!(error.kind, DiagnosticKind::Unit | DiagnosticKind::Shape) => {
                let misfit = Misfit::of(&error, relation);
                return Ok(Err((error.message, misfit)));
            }
            Err(error) => return Err(error),
        };
        let contrast =
            |a: String, b: String, misfit| Ok(Err((format!("left {a}, right {b}"), misfit)));
        if left.shape() != right.shape() {
            let shape = |value: &Value| format!("{}×{}", value.rows(), value.columns());
            return contrast(shape(&left), shape(&right), Misfit::Shapes);
        }
        for (a, b) in left.entries().iter().zip(right.entries()) {
            if common_unit(&a.unit, &b.unit).is_err() {
                let unit = |unit: &Option<Unit>| {
                    unit.as_ref().map(ToString::to_string).unwrap_or_default()
                };
                let sides = Box::new((relation.left.clone(), relation.right.clone()));
                return contrast(unit(&a.unit), unit(&b.unit), Misfit::Units(Some(sides)));
            }
        }
        Ok(Ok((left, right)))
    }

    pub(crate) fn present_conditions(
        &self,
        conditions: &Conditions,
        span: &Span,
    ) -> Result<Vec<Condition>, Diagnostic> {
        let present = |(requirement, polynomial): &(_, Polynomial)| {
            Ok(Condition {
                expression: self.present_polynomial(polynomial, span)?,
                requirement: *requirement,
            })
        };
        let open = conditions.open(&self.ring);
        let open = open.map_err(|error| algebra(error, span))?;
        open.iter().map(present).collect()
    }
}
