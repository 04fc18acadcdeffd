//! Expressions become elements of the ring: the first of the two routes to a verdict.

mod call;
mod complex;
pub(crate) mod error;
pub(crate) mod limit;
pub(crate) mod matrix;
mod operation;
mod substitution;

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::budget::Budget;
use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::number::Rational;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::Ring;
use crate::algebra::symbol::Symbol;

use super::condition::Conditions;
use super::presentation::Presenter;
use super::quantity::{Quantities, Quantity, Value, common_unit};
use super::scope::{Meaning, Scope};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Expression, Name, Node, Span, Spanned};
use crate::language::unit::{Unit, small_integer};

use error::{algebra, different, quantity as quantity_error, shape};
use limit::{MOST_PARTS, MOST_ROWS, check_nesting, check_terms};
use substitution::KnownSubstitution;

/// Turns expressions into elements of its ring, with units, and collects the conditions under which
/// they exist.
#[derive(Clone, Debug)]
pub struct Elaborator {
    /// The ring of the document.
    pub ring: Ring,
    /// The names of the document.
    pub scope: Scope,
    /// What the steps since the last [`Elaborator::fresh`] needed.
    pub conditions: Conditions,
    /// Whether replacements need only be possible under the assumptions: who makes them answers for it
    /// that the assumptions remain true.
    pub trusts_replacements: bool,
    /// The arguments of the calls that one is in, and what must hold for each to exist.
    arguments: Vec<BTreeMap<String, Argument>>,
    /// The named substitutions that were used, by ASCII name.
    substitutions: BTreeMap<String, KnownSubstitution>,
    /// The complex symbols that stand for names that were declared real, by ASCII name.
    twins: BTreeMap<String, Symbol>,
    /// The definitions that were elaborated with these, by ASCII name.
    twin_values: BTreeMap<String, (Value, Conditions)>,
    nesting: usize,
}

/// What it costs to keep a term of a value, and one that is written out as an expression: with these the
/// budget of a document bounds its memory.
const STEPS_FOR_A_KEPT_TERM: u64 = 50;
const STEPS_FOR_A_WRITTEN_TERM: u64 = 1_000;

/// What stands for a name within a call.
#[derive(Clone, Debug)]
struct Argument {
    value: Value,
    conditions: Conditions,
    /// The ASCII names of the symbols and functions that its text rests on, also those that cancel.
    rests_on: BTreeSet<String>,
}

impl Elaborator {
    /// An elaborator that knows no names; every statement may take as many steps as the budget has.
    pub fn new(budget: Budget) -> Self {
        Elaborator {
            ring: Ring::new(budget),
            scope: Scope::default(),
            conditions: Conditions::default(),
            trusts_replacements: false,
            arguments: Vec::new(),
            substitutions: BTreeMap::new(),
            twins: BTreeMap::new(),
            twin_values: BTreeMap::new(),
            nesting: 0,
        }
    }

    /// Begins a new statement: a full budget, no conditions.
    pub fn fresh(&mut self) {
        self.ring.budget().refill();
        self.conditions = Conditions::default();
        self.arguments.clear();
        self.twins.clear();
        self.twin_values.clear();
        self.nesting = 0;
    }

    /// What an expression is.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] at the part that has no value.
    pub fn value(&mut self, expression: &Expression) -> Result<Value, Diagnostic> {
        let span = &expression.span;
        let budget = self.ring.budget();
        budget
            .spend(budget.limit() / MOST_PARTS)
            .map_err(|exhausted| algebra(exhausted.into(), span))?;
        check_nesting(self.nesting, span)?;
        self.nesting += 1;
        let value = self.value_of_node(expression, span);
        self.nesting -= 1;
        let value = value?;
        check_terms(&value, span)?;
        Ok(value)
    }

    fn value_of_node(&mut self, expression: &Expression, span: &Span) -> Result<Value, Diagnostic> {
        match &expression.node {
            Node::Number(number) => Ok(Quantity::number(number.clone()).scalar()),
            Node::Name(name) => self.named(name, span),
            Node::Derivative(name, order) => self.function_value(name, *order, None, span),
            Node::Negative(inner) => {
                let value = self.value(inner)?;
                Ok(value.map(|entry| Quantities(&self.ring).negative(entry)))
            }
            Node::Binary(operator, left, right) => self.binary(*operator, left, right, span),
            Node::Call {
                function,
                order,
                arguments,
            } => self.call(function, *order, arguments, span),
            Node::Matrix(rows) => self.blocks(rows, span),
            Node::Index(matrix, indices) => self.entry(matrix, indices, span),
            Node::At(inner, place) => self.at(inner, place, span),
        }
    }

    /// What an expression with one entry is.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where it has no value or more than one entry.
    pub fn scalar(&mut self, expression: &Expression) -> Result<Quantity, Diagnostic> {
        let value = self.value(expression)?;
        if value.shape() != (1, 1) {
            let (rows, columns) = value.shape();
            return Err(shape(
                &expression.span,
                format!("this is a {rows}×{columns} matrix"),
            )
            .with_help("a single number is needed here; take an entry with [row, column]"));
        }
        Ok(value.at(0, 0).clone())
    }

    /// The free symbol that an expression stands for.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where it is anything else.
    pub fn symbol(&mut self, quantity: &Quantity, span: &Span) -> Result<Symbol, Diagnostic> {
        let single = self.ring.as_symbol(&quantity.value).filter(|symbol| {
            matches!(
                self.ring.generator(*symbol),
                Generator::Constant { .. }
                    | Generator::Angle { .. }
                    | Generator::Coordinate { .. }
                    | Generator::FunctionValue { .. }
            )
        });
        single.ok_or_else(|| {
            let message = "a variable is needed here";
            Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                .with_label("not a parameter, an angle, a coordinate, its time derivative or a function's value")
                .with_help("give the bare name of a variable, such as `x` or `dt(x)`")
        })
    }

    /// The symbol of a variable that is given by name.
    pub(crate) fn variable(&mut self, name: &Spanned<Name>) -> Result<Symbol, Diagnostic> {
        let expression = Expression {
            node: Node::Name(name.value.clone()),
            span: name.span.clone(),
        };
        let quantity = self.scalar(&expression)?;
        self.symbol(&quantity, &name.span)
    }

    /// The symbols of variables that are given by name, each of them once.
    pub(crate) fn variables(&mut self, names: &[Spanned<Name>]) -> Result<Vec<Symbol>, Diagnostic> {
        let written = |name: &Spanned<Name>| (name.value.to_string(), name.span.clone());
        different(&names.iter().map(written).collect::<Vec<_>>())?;
        names.iter().map(|name| self.variable(name)).collect()
    }

    /// The number that an expression is, if it is one; it has no unit.
    pub(crate) fn number(
        &mut self,
        expression: &Expression,
    ) -> Result<Option<Rational>, Diagnostic> {
        let quantity = self.scalar(expression)?;
        common_unit(&quantity.unit, &Some(Unit::one()))
            .map_err(|error| quantity_error(error, &expression.span))?;
        Ok(quantity.value.as_constant())
    }

    /// A small natural number.
    pub fn natural(&mut self, expression: &Expression) -> Result<usize, Diagnostic> {
        let number = self.number(expression)?;
        let whole = number.filter(|number| number.is_int() && *number >= Rational::ZERO);
        let kind = match whole {
            Some(_) => DiagnosticKind::Budget,
            None => DiagnosticKind::Arguments,
        };
        let small = whole.as_ref().and_then(small_integer);
        small
            .and_then(|n| usize::try_from(n).ok())
            .filter(|n| *n <= MOST_ROWS)
            .ok_or_else(|| {
                let message = "a small whole number is needed here";
                Diagnostic::new(kind, expression.span.clone(), message)
                    .with_label(format!("not one of 0, 1, …, {MOST_ROWS}"))
                    .with_help("places, sizes, powers and orders are plain numbers, and not larger")
            })
    }

    fn named(&mut self, name: &Name, span: &Span) -> Result<Value, Diagnostic> {
        let arguments = self.arguments.last();
        if let Some(argument) = arguments.and_then(|known| known.get(&name.ascii)) {
            // They stand where the name does, so that replacements around it reach them.
            self.conditions.extend(&argument.conditions);
            return Ok(argument.value.clone());
        }
        match &self.scope.find(name, span)?.meaning {
            Meaning::Symbol { symbol, unit, .. } => {
                let symbol = self.twins.get(&name.ascii).unwrap_or(symbol);
                Ok(Quantity::new(self.ring.element(*symbol), unit.clone()).scalar())
            }
            Meaning::Function { .. } => self.function_value(name, 0, None, span),
            Meaning::Definition { expression, .. } if self.rests_on_twin(name) => {
                let expression = expression.clone();
                self.complex_definition(name, &expression)
            }
            Meaning::Definition {
                value, conditions, ..
            } => {
                self.conditions.extend(conditions);
                Ok(value.clone())
            }
            Meaning::Template { arguments, .. } => {
                let count = arguments.len();
                let message = format!("`{name}` needs arguments");
                Err(
                    Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                        .with_label(format!("{count} wanted"))
                        .with_help(format!("write `{name}(…)`")),
                )
            }
            Meaning::Substitution { .. } => {
                let message = format!("`{name}` is a substitution, not a value");
                Err(
                    Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                        .with_label("used as a value")
                        .with_help(format!("write `… at {name}`")),
                )
            }
        }
    }

    /// What writes the elements of the ring with the names of the document.
    pub(crate) fn presenter(&self) -> Presenter<'_> {
        Presenter {
            ring: &self.ring,
            scope: &self.scope,
        }
    }

    /// Pays for a value that is kept until the document ends.
    pub(crate) fn keep(&self, value: &Value, span: &Span) -> Result<(), Diagnostic> {
        let mut entries = value.entries().iter();
        entries.try_for_each(|entry| self.pay(&entry.value, STEPS_FOR_A_KEPT_TERM, span))
    }

    /// A polynomial as an expression, which is kept until the document ends.
    pub(crate) fn present_polynomial(
        &self,
        polynomial: &Polynomial,
        span: &Span,
    ) -> Result<Expression, Diagnostic> {
        self.pay(&polynomial.clone().into(), STEPS_FOR_A_WRITTEN_TERM, span)?;
        let expression = self.presenter().polynomial(polynomial);
        expression.map_err(|error| algebra(error, span))
    }

    fn pay(&self, element: &Fraction, price: u64, span: &Span) -> Result<(), Diagnostic> {
        let terms = element.numerator().len() + element.denominator().len();
        let paid = self.ring.budget().spend(price * terms as u64);
        paid.map_err(|exhausted| algebra(exhausted.into(), span))
    }

    /// An element as sums above and below the line, which is kept until the document ends.
    pub(crate) fn present_expanded(
        &self,
        element: &Fraction,
        span: &Span,
    ) -> Result<Expression, Diagnostic> {
        self.pay(element, STEPS_FOR_A_WRITTEN_TERM, span)?;
        let expression = self.presenter().expanded(element);
        expression.map_err(|error| algebra(error, span))
    }

    /// An element as an expression, which is kept until the document ends.
    pub(crate) fn present(
        &self,
        element: &Fraction,
        span: &Span,
    ) -> Result<Expression, Diagnostic> {
        self.pay(element, STEPS_FOR_A_WRITTEN_TERM, span)?;
        let expression = self.presenter().element(element);
        expression.map_err(|error| algebra(error, span))
    }
}
