//! Elements of the ring become operations of a program: what has no structure to keep.

use std::collections::BTreeMap;

use sextic_codegen::horner::{Term, horner};
use sextic_codegen::program::{Node, Operation};

use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::number::Rational;
use crate::algebra::polynomial::Polynomial as Element;
use crate::algebra::symbol::Symbol;
use crate::derivation::scope::Meaning;

use super::{Context, Obstacle, Polynomial, Translator};

impl Translator<'_> {
    /// An element as a polynomial in the variable that is collected, if there is one: each factor by
    /// Horner's rule.
    pub(super) fn element(
        &mut self,
        element: &Fraction,
        context: Context,
    ) -> Result<Polynomial, Obstacle> {
        if element.is_zero() {
            return Ok(Polynomial::default());
        }
        let exhausted = |error| Obstacle::Refused(format!("{error}"));
        let factored = self.elaborator.ring.factored(element).map_err(exhausted)?;
        let constant = self.program.constant(factored.coefficient);
        let mut value = Polynomial::monomial(0, constant);
        let mut below: Option<Node> = None;
        for (factor, exponent) in &factored.factors {
            let base = self.sum_of_terms(factor, context)?;
            for _ in 0..exponent.unsigned_abs() {
                if *exponent > 0 {
                    value = value.product(&base, &mut self.program);
                    continue;
                }
                let Some(Some(divisor)) = base.constant() else {
                    return Err(Obstacle::Refused(
                        "the variable stands below the line".into(),
                    ));
                };
                below = Some(match below {
                    Some(below) => self.program.push(Operation::Multiply(below, divisor)),
                    None => divisor,
                });
            }
        }
        Ok(match below {
            Some(divisor) => value.quotient(divisor, &mut self.program),
            None => value,
        })
    }

    /// The symbol of the variable whose powers are kept apart.
    fn variable_symbol(&self, context: Context) -> Option<Symbol> {
        let name = self.variable(context)?;
        match self.elaborator.scope.spelled(name)?.meaning {
            Meaning::Symbol { symbol, .. } => Some(symbol),
            _ => None,
        }
    }

    fn sum_of_terms(
        &mut self,
        element: &Element,
        context: Context,
    ) -> Result<Polynomial, Obstacle> {
        let parts = match self.variable_symbol(context) {
            Some(variable) => element.coefficients_in(variable),
            None => BTreeMap::from([(0, element.clone())]),
        };
        let mut sum = Polynomial::default();
        for (power, part) in parts {
            let mut terms: Vec<Term> = Vec::new();
            for (monomial, coefficient) in part.terms() {
                let mut powers = BTreeMap::new();
                for (symbol, exponent) in monomial.factors() {
                    powers.insert(self.value_of(symbol, context)?, exponent);
                }
                terms.push((Rational::from(coefficient.clone()), powers));
            }
            let node = horner(&mut self.program, &terms);
            let term = Polynomial::monomial(power, node);
            sum = sum.sum(&term, &mut self.program);
        }
        Ok(sum)
    }

    /// The value of a symbol, which may be a root.
    fn value_of(&mut self, symbol: Symbol, context: Context) -> Result<Node, Obstacle> {
        if let Generator::Root { radicand } = self.elaborator.ring.generator(symbol).clone() {
            let radicand = self.sum_of_terms(&radicand, context)?;
            let radicand = radicand.constant().flatten();
            let radicand = radicand.ok_or(Obstacle::Refused("the root of 0".into()))?;
            return Ok(self.program.push(Operation::SquareRoot(radicand)));
        }
        self.symbol(symbol, context)
    }
}
