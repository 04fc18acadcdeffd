//! Elements of the ring become expressions that a person can read and a parser can read back.

use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::monomial::Monomial;
use crate::algebra::number::{Integer, Rational};
use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::Ring;
use crate::algebra::symbol::Symbol;

use super::scope::{Meaning, Scope, SymbolKind};
use crate::language::syntax::{BinaryOperator, Expression, Name, Node};

/// Longer polynomials are not taken apart into factors.
const MOST_TERMS_TO_FACTOR: usize = 400;

/// Longer sums are written in groups of this many terms.
const LONGEST_SUM: usize = 200;

/// Writes elements of a ring with the names of a scope.
pub struct Presenter<'a> {
    /// The ring.
    pub ring: &'a Ring,
    /// The names.
    pub scope: &'a Scope,
}

impl Presenter<'_> {
    /// The element as an expression: factored where that is affordable, each factor in its shortest
    /// form.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`]
    pub fn element(&self, element: &Fraction) -> Result<Expression, AlgebraError> {
        if element.numerator().len().max(element.denominator().len()) > MOST_TERMS_TO_FACTOR {
            return self.expanded(element);
        }
        let factored = self.ring.factored(element)?;
        if element.is_zero() {
            return Ok(Expression::number(Rational::ZERO));
        }
        let negative = factored.coefficient < Rational::ZERO;
        let size = if negative {
            -factored.coefficient
        } else {
            factored.coefficient
        };
        let (integer_above, integer_below) = size.into_parts();
        let (mut above, mut below) = (Vec::new(), Vec::new());
        if integer_above != Integer::ONE {
            above.push(Expression::made(Node::Number(Rational::from(
                integer_above,
            ))));
        }
        if integer_below != Integer::ONE.try_into().unwrap_or_default() {
            below.push(Expression::made(Node::Number(Rational::from(
                integer_below,
            ))));
        }
        // Single symbols come first, as one writes products.
        let (single, sums): (Vec<_>, Vec<_>) = factored
            .factors
            .iter()
            .partition(|(factor, _)| factor.len() == 1);
        let single = single.into_iter().rev();
        for (factor, exponent) in single.chain(sums) {
            let base = self.polynomial(factor)?;
            let power = raised(base, exponent.unsigned_abs());
            if *exponent > 0 {
                &mut above
            } else {
                &mut below
            }
            .push(power);
        }
        let above = if negative {
            negative_product(above)
        } else {
            product(above)
        };
        Ok(match below.is_empty() {
            true => above,
            false => Expression::binary(BinaryOperator::Divide, above, product(below)),
        })
    }

    /// The element as the ring holds it: sums above and below the line.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`]
    pub fn expanded(&self, element: &Fraction) -> Result<Expression, AlgebraError> {
        let above = self.polynomial(element.numerator())?;
        Ok(match element.denominator().as_constant() {
            Some(one) if one == Integer::ONE => above,
            _ => {
                let below = self.polynomial(element.denominator())?;
                Expression::binary(BinaryOperator::Divide, above, below)
            }
        })
    }

    /// The polynomial as a sum of its terms.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`]
    pub fn polynomial(&self, polynomial: &Polynomial) -> Result<Expression, AlgebraError> {
        let mut terms = Vec::new();
        for (monomial, coefficient) in polynomial.terms() {
            let negative = *coefficient < Integer::ZERO;
            let size = if negative {
                -coefficient
            } else {
                coefficient.clone()
            };
            terms.push((negative, self.factors(monomial, size)?));
        }
        // A long sum becomes a sum of sums: what walks through expressions is recursive.
        while terms.len() > LONGEST_SUM {
            let mut rest = terms.into_iter().peekable();
            let mut parts = Vec::new();
            while rest.peek().is_some() {
                parts.push((false, vec![sum(rest.by_ref().take(LONGEST_SUM))]));
            }
            terms = parts;
        }
        Ok(sum(terms))
    }

    fn factors(&self, monomial: &Monomial, size: Integer) -> Result<Vec<Expression>, AlgebraError> {
        let mut factors = Vec::new();
        if size != Integer::ONE {
            factors.push(Expression::made(Node::Number(Rational::from(size))));
        }
        for (symbol, exponent) in monomial.factors() {
            factors.push(raised(self.symbol(symbol)?, u64::from(exponent)));
        }
        Ok(factors)
    }

    fn declared(&self, ascii: &str) -> Name {
        let entry = self.scope.spelled(ascii);
        entry.map_or_else(|| Name::new(ascii), |entry| entry.name.clone())
    }

    /// One symbol.
    pub(crate) fn symbol(&self, symbol: Symbol) -> Result<Expression, AlgebraError> {
        let call =
            |function: &str, argument| Expression::call(Name::new(function), 0, vec![argument]);
        Ok(match self.ring.generator(symbol) {
            Generator::Constant { name } | Generator::Angle { name } => {
                Expression::name(self.declared(name))
            }
            Generator::Coordinate { name, order, .. } => {
                let coordinate = Expression::name(self.declared(name));
                (0..*order).fold(coordinate, |inner, _| call("dt", inner))
            }
            Generator::ImaginaryUnit => {
                let imaginary = |entry: &&super::scope::Entry| {
                    self.scope.kind_of(&entry.name.ascii) == Some(SymbolKind::Imaginary)
                };
                let declared = self.scope.entries().find(imaginary);
                Expression::name(declared.map_or(Name::new("i"), |entry| entry.name.clone()))
            }
            Generator::Cosine { angle } => call(
                "cos",
                self.polynomial(self.ring.angle_element(angle).numerator())?,
            ),
            Generator::Sine { angle } => call(
                "sin",
                self.polynomial(self.ring.angle_element(angle).numerator())?,
            ),
            Generator::Root { radicand } => {
                call("sqrt", self.element(&Fraction::from(radicand.clone()))?)
            }
            Generator::Direction { x, y, .. } => {
                let arguments = vec![self.element(x)?, self.element(y)?];
                Expression::call(Name::new("angle"), 0, arguments)
            }
            Generator::FunctionValue {
                name,
                order,
                argument,
            } => {
                let name = self.declared(name);
                let at_reference = match self.scope.get(&name).map(|entry| &entry.meaning) {
                    Some(Meaning::Function {
                        argument: reference,
                        ..
                    }) => reference.value == *argument,
                    _ => false,
                };
                match (at_reference, order) {
                    (true, 0) => Expression::name(name),
                    (true, order) => Expression::made(Node::Derivative(name, *order)),
                    (false, order) => Expression::call(name, *order, vec![self.element(argument)?]),
                }
            }
        })
    }
}

fn sum(terms: impl IntoIterator<Item = (bool, Vec<Expression>)>) -> Expression {
    let mut sum: Option<Expression> = None;
    for (negative, factors) in terms {
        sum = Some(match (sum, negative) {
            (None, false) => product(factors),
            (None, true) => negative_product(factors),
            (Some(sum), false) => Expression::binary(BinaryOperator::Add, sum, product(factors)),
            (Some(sum), true) => {
                Expression::binary(BinaryOperator::Subtract, sum, product(factors))
            }
        });
    }
    sum.unwrap_or_else(|| Expression::number(Rational::ZERO))
}

fn raised(base: Expression, exponent: u64) -> Expression {
    match exponent {
        1 => base,
        _ => Expression::binary(
            BinaryOperator::Power,
            base,
            Expression::made(Node::Number(Rational::from(exponent))),
        ),
    }
}

fn product(factors: Vec<Expression>) -> Expression {
    factors
        .into_iter()
        .reduce(|left, right| Expression::binary(BinaryOperator::Multiply, left, right))
        .unwrap_or_else(|| Expression::number(Rational::ONE))
}

/// −a·b is (−a)·b to a reader, and needs no brackets.
fn negative_product(mut factors: Vec<Expression>) -> Expression {
    let first = match factors.is_empty() {
        true => Expression::number(Rational::ONE),
        false => factors.remove(0),
    };
    factors.insert(0, Expression::made(Node::Negative(Box::new(first))));
    product(factors)
}
