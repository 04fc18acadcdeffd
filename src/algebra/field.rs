//! The field of fractions of a ring: its arithmetic.

use std::borrow::Borrow;

use smallvec::SmallVec;

use super::arithmetic::{Arithmetic, Division, SignedProduct, one_by_one};
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::generator::Generator;
use super::number::Rational;
use super::ring::Ring;

impl Ring {
    /// A result of the arithmetic of fractions with its squares folded away.
    fn fold(&self, element: Fraction) -> Result<Fraction, AlgebraError> {
        if self.is_reduced(element.numerator()) && self.is_reduced(element.denominator()) {
            return Ok(element);
        }
        self.fraction(element.numerator(), element.denominator())
    }

    /// Whether an element contains no symbol whose square is another.
    fn is_free(&self, element: &Fraction) -> bool {
        let sides = [element.numerator(), element.denominator()];
        sides
            .iter()
            .all(|side| self.last_symbol(side, 1, Generator::is_quadratic).is_none())
    }

    /// aⁿ, for negative n as well; a⁰ = 1.
    ///
    /// Complexity: at most 2·log₂|n| products.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] for a negative power of 0, [`AlgebraError::Exhausted`] where
    /// the budget or a polynomial's size runs out.
    pub fn power(&self, base: &Fraction, exponent: i64) -> Result<Fraction, AlgebraError> {
        if exponent < 0 {
            let inverse = self.quotient(&self.one(), base)?;
            return self.power(&inverse, exponent.saturating_neg());
        }
        if let Ok(exponent) = i32::try_from(exponent)
            && self.is_free(base)
        {
            return base.power(exponent, self.budget());
        }
        let (mut result, mut square, mut rest) = (self.one(), base.clone(), exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                result = self.product(&result, &square)?;
            }
            rest /= 2;
            if rest > 0 {
                square = self.product(&square, &square)?;
            }
        }
        Ok(result)
    }
}

impl Arithmetic for Ring {
    type Element = Fraction;
    type Error = AlgebraError;

    fn zero(&self) -> Fraction {
        Fraction::from(Rational::ZERO)
    }

    fn one(&self) -> Fraction {
        Fraction::from(Rational::ONE)
    }

    fn is_zero(&self, a: &Fraction) -> bool {
        a.is_zero()
    }

    fn sum(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        self.fold(a.sum(b, self.budget())?)
    }

    fn negative(&self, a: &Fraction) -> Fraction {
        a.negative()
    }

    fn product(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        self.fold(a.product(b, self.budget())?)
    }

    /// Where only integers stand below the lines the sum is found and folded at once.
    fn sum_of_products<L: Borrow<Fraction>, R: Borrow<Fraction>>(
        &self,
        products: impl Iterator<Item = Result<SignedProduct<L, R>, AlgebraError>>,
    ) -> Result<Fraction, AlgebraError> {
        let products = products.collect::<Result<SmallVec<[_; 8]>, _>>()?;
        let borrowed: SmallVec<[_; 8]> = products.iter().map(SignedProduct::borrowed).collect();
        match Fraction::sum_of_products(&borrowed, self.budget())? {
            Some(sum) => self.fold(sum),
            None => one_by_one(self, borrowed.into_iter().map(Ok)),
        }
    }
}

impl Division for Ring {
    fn quotient(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        let inverse = match self.last_symbol(b.numerator(), 1, Generator::is_irrational) {
            None => b.reciprocal()?,
            Some(_) => self.fraction(b.denominator(), b.numerator())?,
        };
        self.product(a, &inverse)
    }
}

#[cfg(test)]
mod tests {
    use super::super::budget::Budget;
    use super::*;

    #[test]
    fn a_power_of_what_has_no_root_is_that_of_its_sides() {
        let mut ring = Ring::new(Budget::new(10_000));
        let [x, y] = ["x", "y"].map(|name| {
            let name = name.into();
            let symbol = ring.symbol(Generator::Constant { name }).unwrap();
            ring.element(symbol)
        });
        let sum = ring.sum(&x, &y).unwrap();
        let (before, sides) = (ring.budget().spent(), Budget::new(10_000));
        let power = ring.power(&sum, 9).unwrap();
        assert_eq!(power, sum.power(9, &sides).unwrap());
        assert_eq!(ring.budget().spent() - before, sides.spent());
    }
}
