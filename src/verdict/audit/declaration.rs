//! Declarations: what statements make names mean, and what they assume.

use std::sync::Arc;

use dashu_base::Signed;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::sign::Signs;
use crate::derivation::condition::Conditions;
use crate::derivation::elaboration::error::{algebra, sides};
use crate::derivation::quantity::{Quantity, common_unit};
use crate::derivation::scope::{Meaning, SymbolKind};
use crate::language::built_in;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::mention::Mention;
use crate::language::syntax::{
    Comparison, Expression, Name, Place, Relation, Replacement, Sign, Span, Spanned, Statement,
    StatementKind,
};
use crate::language::unit::Unit;

use super::reader::Reader;
use super::{Assumption, Declaration};

/// What a statement says of the symbols that it declares.
struct Symbols<'a> {
    names: &'a [Spanned<Name>],
    unit: Unit,
    kind: SymbolKind,
    sign: Option<Sign>,
    description: &'a Option<String>,
}

impl Reader<'_> {
    /// Declares what a statement declares; other statements declare nothing.
    pub(super) fn declare(&mut self, statement: &Statement) -> Result<(), Diagnostic> {
        match &statement.kind {
            StatementKind::Parameter { .. }
            | StatementKind::Complex { .. }
            | StatementKind::Angle { .. }
            | StatementKind::Coordinate { .. } => self.declare_symbols(&statement.kind),
            StatementKind::Imaginary { name } => {
                let names = std::slice::from_ref(name);
                let one = Symbols::new(names, Unit::one(), SymbolKind::Imaginary, &None);
                self.symbols(&one, |_| Generator::ImaginaryUnit)
            }
            StatementKind::Function { .. } => self.declare_functions(&statement.kind),
            StatementKind::Assume {
                relation,
                description,
            } => {
                self.assume(relation)?;
                self.assumptions.push(Assumption {
                    relation: relation.clone(),
                    description: description.clone(),
                    place: self.here.clone(),
                });
                Ok(())
            }
            StatementKind::Definition {
                names,
                arguments,
                values,
            } => self.define(names, arguments, values),
            StatementKind::Substitution { name, replacements } => {
                self.declare_substitution(name, replacements, &statement.span)
            }
            StatementKind::Import { .. }
            | StatementKind::Assertion { .. }
            | StatementKind::Eigenpair { .. }
            | StatementKind::Match(_)
            | StatementKind::Domain(_)
            | StatementKind::Show { .. }
            | StatementKind::System(_)
            | StatementKind::Evaluator { .. } => Ok(()),
        }
    }

    /// Declares numbers, real and complex ones, angles and coordinates.
    fn declare_symbols(&mut self, kind: &StatementKind) -> Result<(), Diagnostic> {
        let constant = |name| Generator::Constant { name };
        match kind {
            StatementKind::Parameter {
                names,
                unit,
                sign,
                description,
            } => {
                let unit = Unit::parse(unit)?;
                let own = Symbols {
                    sign: *sign,
                    ..Symbols::new(names, unit, SymbolKind::Parameter, description)
                };
                self.symbols(&own, constant)?;
                self.declarations.extend(sign.map(|sign| Declaration {
                    names: names.iter().map(|name| name.value.clone()).collect(),
                    sign,
                    place: self.here.clone(),
                }));
                Ok(())
            }
            StatementKind::Complex {
                names,
                unit,
                description,
            } => {
                let unit = Unit::parse(unit)?;
                let own = Symbols::new(names, unit, SymbolKind::Complex, description);
                self.symbols(&own, constant)
            }
            StatementKind::Angle { names, description } => {
                let own = Symbols::new(names, Unit::one(), SymbolKind::Angle, description);
                self.symbols(&own, |name| Generator::Angle { name })
            }
            StatementKind::Coordinate {
                names,
                unit,
                description,
            } => {
                let angular = unit.value.trim() == "rad";
                let kind = match angular {
                    true => SymbolKind::AngularCoordinate,
                    false => SymbolKind::Coordinate,
                };
                let own = Symbols::new(names, Unit::parse(unit)?, kind, description);
                self.symbols(&own, |name| Generator::Coordinate {
                    name,
                    order: 0,
                    angular,
                })
            }
            _ => Ok(()),
        }
    }

    /// Declares functions of one argument.
    fn declare_functions(&mut self, kind: &StatementKind) -> Result<(), Diagnostic> {
        let StatementKind::Function {
            names,
            reference,
            unit,
            description,
        } = kind
        else {
            return Ok(());
        };
        let unit = Unit::parse(unit)?;
        let argument = self.elaborator.scalar(reference)?;
        let conditions = std::mem::take(&mut self.elaborator.conditions);
        for name in names {
            let meaning = Meaning::Function {
                reference: reference.clone(),
                argument: argument.clone(),
                conditions: conditions.clone(),
                unit: unit.clone(),
            };
            let scope = &mut self.elaborator.scope;
            scope.declare(name, meaning, description.clone())?;
        }
        Ok(())
    }

    fn declare_substitution(
        &mut self,
        name: &Spanned<Name>,
        replacements: &[Replacement],
        span: &Span,
    ) -> Result<(), Diagnostic> {
        let place = Place::Replacements(replacements.to_vec());
        self.elaborator.substitution(&place, span)?;
        // What each replacement needs is asked for where it is made.
        let meaning = Meaning::Substitution {
            replacements: replacements.to_vec(),
            conditions: Conditions::default(),
            sources: Vec::new(),
        };
        self.elaborator.scope.declare(name, meaning, None)
    }

    /// Declares symbols of the ring, by what each is there.
    fn symbols(
        &mut self,
        own: &Symbols<'_>,
        generator: impl Fn(String) -> Generator,
    ) -> Result<(), Diagnostic> {
        for name in own.names {
            let ring = &mut self.elaborator.ring;
            let symbol = ring.symbol(generator(name.value.ascii.clone()));
            let symbol = symbol.map_err(|error| algebra(error, &name.span))?;
            let assumptions = ring.assumptions_mut();
            assumptions.assume_symbol(symbol, signs(own.sign));
            if own.kind == SymbolKind::Complex {
                assumptions.assume_complex(symbol);
            }
            let meaning = Meaning::Symbol {
                symbol,
                unit: own.unit.clone(),
                kind: own.kind,
            };
            let scope = &mut self.elaborator.scope;
            scope.declare(name, meaning, own.description.clone())?;
        }
        Ok(())
    }

    fn assume(&mut self, relation: &Relation) -> Result<(), Diagnostic> {
        let span = &(relation.left.span.start..relation.right.span.end);
        let difference = self.right_less_left(relation, span)?;
        if !self.is_over_positive(&difference, span)? {
            let message = "an assumption must be an inequality between polynomials";
            return Err(unsupported(span, message)
                .with_help("multiply it by its denominator, whose sign must be known"));
        }
        let signs = assumed(relation.comparison, span)?;
        let ring = &mut self.elaborator.ring;
        let above = difference.numerator().clone();
        let known = ring.polynomial_signs(&above);
        let known = known.map_err(|error| algebra(error, span))?;
        if known.intersection(signs) == Signs::NONE {
            return Err(contradiction("assumption", known, span));
        }
        let (above, signs) = match signs.negative {
            true => (-&above, signs.opposite()),
            false => (above, signs),
        };
        let assumptions = ring.assumptions_mut();
        // Of a name, a sine or a function's value alone it serves wherever that occurs.
        if let [(monomial, coefficient)] = above.terms()
            && monomial.degree() == 1
            && let Some((symbol, _)) = monomial.factors().next()
        {
            let of_symbol = match coefficient.is_positive() {
                true => signs,
                false => signs.opposite(),
            };
            assumptions.assume_symbol(symbol, of_symbol);
        }
        assumptions.assume_polynomial(above, signs);
        Ok(())
    }

    /// A condition under which an evaluator is used must be between real numbers that have an order, and possible.
    pub(super) fn check_condition(&mut self, relation: &Relation) -> Result<(), Diagnostic> {
        self.elaborator.fresh();
        let span = &(relation.left.span.start..relation.right.span.end);
        let difference = self.right_less_left_in_si(relation, span)?;
        // Unlike an assumption, it may be about a quotient whose sign nobody knows.
        if !self.is_over_positive(&difference, span)? {
            return Ok(());
        }
        let wanted = assumed(relation.comparison, span)?;
        let known = self
            .elaborator
            .ring
            .polynomial_signs(difference.numerator());
        let known = known.map_err(|error| algebra(error, span))?;
        match known.intersection(wanted) == Signs::NONE {
            true => Err(contradiction("condition", known, span)
                .with_help("nothing would ever satisfy it: correct one of the two")),
            false => Ok(()),
        }
    }

    /// The right side less the left, which must be real numbers of one unit.
    fn right_less_left(
        &mut self,
        relation: &Relation,
        span: &Span,
    ) -> Result<Fraction, Diagnostic> {
        let (left, right) = self.real_sides(relation)?;
        common_unit(&left.unit, &right.unit)
            .map_err(|error| sides(error, &relation.left, &relation.right, span))?;
        self.difference(&left, &right, span)
    }

    /// The same of a condition, in which numbers are in SI units, as those of a domain: a document has no other way to
    /// write 10 m.
    fn right_less_left_in_si(
        &mut self,
        relation: &Relation,
        span: &Span,
    ) -> Result<Fraction, Diagnostic> {
        let (left, right) = self.real_sides(relation)?;
        let is_number = |own: &Quantity| own.value.as_constant().is_some();
        match is_number(&left) || is_number(&right) {
            true => self.difference(&left, &right, span),
            false => self.right_less_left(relation, span),
        }
    }

    fn real_sides(&mut self, relation: &Relation) -> Result<(Quantity, Quantity), Diagnostic> {
        let left = self.elaborator.scalar(&relation.left)?;
        let right = self.elaborator.scalar(&relation.right)?;
        for (side, quantity) in [(&relation.left, &left), (&relation.right, &right)] {
            if !self.elaborator.ring.is_real(&quantity.value) {
                return Err(algebra(AlgebraError::NotReal, &side.span)
                    .with_label("complex numbers have no order"));
            }
        }
        Ok((left, right))
    }

    fn difference(
        &self,
        left: &Quantity,
        right: &Quantity,
        span: &Span,
    ) -> Result<Fraction, Diagnostic> {
        let difference = self.elaborator.ring.difference(&right.value, &left.value);
        difference.map_err(|error| algebra(error, span))
    }

    fn is_over_positive(&self, own: &Fraction, span: &Span) -> Result<bool, Diagnostic> {
        let below = self.elaborator.ring.polynomial_signs(own.denominator());
        Ok(below.map_err(|error| algebra(error, span))?.is_positive())
    }

    fn define(
        &mut self,
        names: &[Spanned<Name>],
        arguments: &[Spanned<Name>],
        values: &[Expression],
    ) -> Result<(), Diagnostic> {
        for (place, argument) in arguments.iter().enumerate() {
            self.require_no_function(argument)?;
            if let Some(earlier) = arguments[..place]
                .iter()
                .find(|e| e.value == argument.value)
            {
                let message = format!("two arguments are called `{}`", argument.value);
                return Err(Diagnostic::new(
                    DiagnosticKind::Duplicate,
                    argument.span.clone(),
                    message,
                )
                .with_label("the same again")
                .with_secondary(earlier.span.clone(), "the first one")
                .with_help("give each argument a name of its own"));
            }
        }
        for (name, expression) in names.iter().zip(values) {
            let meaning = if arguments.is_empty() {
                self.elaborator.fresh();
                let value = self.elaborator.value(expression)?;
                self.elaborator.keep(&value, &expression.span)?;
                Meaning::Definition {
                    expression: expression.clone(),
                    value,
                    conditions: std::mem::take(&mut self.elaborator.conditions),
                }
            } else {
                self.require_known(expression, arguments)?;
                Meaning::Template {
                    arguments: arguments
                        .iter()
                        .map(|argument| argument.value.clone())
                        .collect(),
                    expression: Arc::new(expression.clone()),
                }
            };
            self.elaborator.scope.declare(name, meaning, None)?;
        }
        Ok(())
    }

    /// Sees that an argument is not called like what is called with arguments: it would not be plain
    /// which of the two `C'` and `C(0)` mean.
    fn require_no_function(&self, argument: &Spanned<Name>) -> Result<(), Diagnostic> {
        let name = &argument.value;
        let entry = self.elaborator.scope.get(name);
        let is_declared = entry.is_some_and(|entry| {
            matches!(
                entry.meaning,
                Meaning::Function { .. } | Meaning::Template { .. }
            )
        });
        if !is_declared && !built_in::is_built_in(&name.ascii) {
            return Ok(());
        }
        let message = format!("the argument `{name}` has the name of a function");
        Err(
            Diagnostic::new(DiagnosticKind::Duplicate, argument.span.clone(), message)
                .with_label("a function of this name is known")
                .with_help("give the argument another name"),
        )
    }

    /// Sees that a definition with arguments mentions only them and what is declared above it: what it
    /// rests on must not change later.
    fn require_known(
        &self,
        body: &Expression,
        arguments: &[Spanned<Name>],
    ) -> Result<(), Diagnostic> {
        let mut mentions = Vec::new();
        body.collect_mentions(&mut mentions);
        for Mention { name, .. } in mentions {
            let is_argument = arguments.iter().any(|argument| argument.value == name);
            if !is_argument && !built_in::is_built_in(&name.ascii) {
                let entry = self.elaborator.scope.find(&name, &body.span);
                entry.map_err(|error| {
                    error.with_help(
                        "a definition mentions its arguments and what is declared above it",
                    )
                })?;
            }
        }
        Ok(())
    }
}

impl<'a> Symbols<'a> {
    /// Symbols of which no sign is known.
    fn new(
        names: &'a [Spanned<Name>],
        unit: Unit,
        kind: SymbolKind,
        description: &'a Option<String>,
    ) -> Self {
        Symbols {
            names,
            unit,
            kind,
            sign: None,
            description,
        }
    }
}

/// The signs that a number with a declared one may have.
fn signs(sign: Option<Sign>) -> Signs {
    match sign {
        None => Signs::ANY,
        Some(Sign::Positive) => Signs::POSITIVE,
        Some(Sign::NonNegative) => Signs::NON_NEGATIVE,
        Some(Sign::NonZero) => Signs::NON_ZERO,
        Some(Sign::Negative) => Signs::NEGATIVE,
        Some(Sign::NonPositive) => Signs::NON_NEGATIVE.opposite(),
    }
}

/// The signs that an assumption gives the right side less the left.
fn assumed(comparison: Comparison, span: &Span) -> Result<Signs, Diagnostic> {
    match comparison {
        Comparison::Less => Ok(Signs::POSITIVE),
        Comparison::LessOrEqual => Ok(Signs::NON_NEGATIVE),
        Comparison::Greater => Ok(Signs::NEGATIVE),
        Comparison::GreaterOrEqual => Ok(Signs::NON_NEGATIVE.opposite()),
        Comparison::Equal => Err(unsupported(span, "only inequalities can be assumed")
            .with_label("an equation")
            .with_help("define one side by the other with `:=`")),
    }
}

fn unsupported(span: &Span, message: &str) -> Diagnostic {
    Diagnostic::new(DiagnosticKind::Unsupported, span.clone(), message)
}

/// An assumption that cannot be true beside what is declared and assumed above it.
fn contradiction(what: &str, known: Signs, span: &Span) -> Diagnostic {
    let message = format!("this {what} contradicts what is declared or assumed above it");
    Diagnostic::new(DiagnosticKind::Inconsistent, span.clone(), message)
        .with_label(format!(
            "the right side less the left is {} by what is above",
            known.in_words()
        ))
        .with_help("from a contradiction everything follows: correct one of the two")
}
