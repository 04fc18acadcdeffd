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
use crate::derivation::syntax::Name;

use super::polynomial::Polynomial;
use super::translation::{Obstacle, Translator};

impl Translator<'_> {
    /// An element as a polynomial in the variable that is collected, if there is one: each factor by
    /// Horner's rule.
    pub(super) fn element(
        &mut self,
        element: &Fraction,
        variable: Option<&str>,
    ) -> Result<Polynomial, Obstacle> {
        let variable = variable.and_then(|name| self.symbol_of(name));
        if element.is_zero() {
            return Ok(Polynomial::default());
        }
        let exhausted = |error| Obstacle::Refused(format!("{error}"));
        let factored = self.elaborator.ring.factored(element).map_err(exhausted)?;
        let constant = self.program.constant(factored.coefficient);
        let mut value = Polynomial::monomial(0, constant);
        let mut below: Option<Node> = None;
        for (factor, exponent) in &factored.factors {
            let base = self.sum_of_terms(factor, variable)?;
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

    fn symbol_of(&self, ascii: &str) -> Option<Symbol> {
        match self.elaborator.scope.get(&Name::new(ascii))?.meaning {
            Meaning::Symbol { symbol, .. } => Some(symbol),
            _ => None,
        }
    }

    fn sum_of_terms(
        &mut self,
        element: &Element,
        variable: Option<Symbol>,
    ) -> Result<Polynomial, Obstacle> {
        let parts = match variable {
            Some(variable) => element.coefficients_in(variable),
            None => BTreeMap::from([(0, element.clone())]),
        };
        let mut sum = Polynomial::default();
        for (power, part) in parts {
            let mut terms: Vec<Term> = Vec::new();
            for (monomial, coefficient) in part.terms() {
                let mut powers = BTreeMap::new();
                for (symbol, exponent) in monomial.factors() {
                    powers.insert(self.symbol(symbol)?, exponent);
                }
                terms.push((Rational::from(coefficient.clone()), powers));
            }
            let node = horner(&mut self.program, &terms);
            let term = Polynomial::monomial(power, node);
            sum = sum.sum(&term, &mut self.program);
        }
        Ok(sum)
    }

    /// The value of a symbol: an input, or the root of one.
    fn symbol(&mut self, symbol: Symbol) -> Result<Node, Obstacle> {
        if let Generator::Root { radicand } = self.elaborator.ring.generator(symbol).clone() {
            let radicand = self.sum_of_terms(&radicand, None)?;
            let radicand = radicand.constant().flatten();
            let radicand = radicand.ok_or(Obstacle::Refused("the root of 0".into()))?;
            return Ok(self.program.push(Operation::SquareRoot(radicand)));
        }
        self.input(symbol)
    }
}
