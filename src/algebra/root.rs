//! Square roots of elements.

use dashu_base::{SquareRoot, UnsignedAbs};

use super::arithmetic::{Arithmetic, Division};
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::generator::Generator;
use super::number::Integer;
use super::polynomial::Polynomial;
use super::ring::Ring;
use super::sign::Signs;

impl Ring {
    /// √a ≥ 0 of a real element a ≥ 0.
    ///
    /// √(N/D) = √(N·D)/|D|; squares of factors whose sign is known are taken out of N·D, and what is
    /// left under the root becomes a symbol w with w² = what is left.
    ///
    /// Complexity: one square-free factorisation of N·D, and what it takes to find the signs of its
    /// factors.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::UnknownSign`] where a is a square, but of a factor whose sign is not known, or
    /// where a is negative; [`AlgebraError::TooManySymbols`] where the ring is full;
    /// [`AlgebraError::Exhausted`] where the budget or a polynomial's size runs out.
    ///
    /// ```
    /// use sextic::algebra::{
    ///     arithmetic::{Arithmetic, Division}, budget::Budget, fraction::Fraction, number::Rational,
    ///     ring::Ring,
    /// };
    ///
    /// let mut ring = Ring::new(Budget::new(10_000));
    /// let number = |n: i32| Fraction::from(Rational::from(n));
    /// // √8 = 2 √2
    /// let (root, half) = (ring.square_root(&number(8))?, ring.square_root(&number(2))?);
    /// assert_eq!(root, ring.product(&number(2), &half)?);
    /// # Ok::<(), sextic::algebra::error::AlgebraError>(())
    /// ```
    pub fn square_root(&mut self, element: &Fraction) -> Result<Fraction, AlgebraError> {
        if element.is_zero() {
            return Ok(self.zero());
        }
        if !self.signs(element)?.positive {
            return Err(AlgebraError::UnknownSign);
        }
        let under = element.numerator().multiply(element.denominator(), self.budget())?;
        let under = self.reduce(&under)?;
        let (mut outside, mut inside) = integer_square_part(&under.content());
        if under.leading().is_some_and(|(_, leading)| *leading < Integer::ZERO) {
            inside = -inside;
        }
        let mut radicand = Polynomial::constant(inside);
        let mut root = Polynomial::one();
        for (factor, multiplicity) in under.square_free(self.budget())? {
            let signs = self.polynomial_signs(&factor)?;
            let sign = if signs.is_non_negative() {
                Integer::ONE
            } else if !signs.positive {
                -Integer::ONE
            } else {
                let kept = factor.power(multiplicity, self.budget())?;
                radicand = radicand.multiply(&kept, self.budget())?;
                continue;
            };
            let power = factor.power(multiplicity / 2, self.budget())?;
            root = root.multiply(&power, self.budget())?;
            outside *= if multiplicity / 2 % 2 == 1 { sign } else { Integer::ONE };
            if multiplicity % 2 == 1 {
                radicand = radicand.multiply(&factor, self.budget())?;
            }
        }
        let mut numerator = Fraction::from(root.scale(&outside));
        if radicand != Polynomial::one() {
            if radicand.square_root(self.budget())?.is_some() {
                return Err(AlgebraError::UnknownSign);
            }
            let strictly = self.polynomial_signs(&radicand)?.is_positive();
            let symbol = self.symbol(Generator::Root { radicand })?;
            let signs = if strictly { Signs::POSITIVE } else { Signs::NON_NEGATIVE };
            self.assumptions_mut().assume_symbol(symbol, signs);
            numerator = self.product(&numerator, &self.element(symbol))?;
        }
        let denominator = Fraction::from(element.denominator().clone());
        let root = self.quotient(&numerator, &denominator)?;
        let below = self.polynomial_signs(element.denominator())?;
        if below.is_positive() {
            Ok(root)
        } else if !below.positive {
            Ok(self.negative(&root))
        } else {
            Err(AlgebraError::UnknownSign)
        }
    }
}

/// √n of a square.
fn exact_square_root(n: &Integer) -> Option<Integer> {
    let root = Integer::from(n.unsigned_abs().sqrt());
    (&root * &root == *n).then_some(root)
}

/// (a, b) with n = a²·b for n > 0, b as small as trial division by small primes and a test for
/// squares find it.
fn integer_square_part(n: &Integer) -> (Integer, Integer) {
    const LARGEST_DIVISOR: u32 = 1000;
    let (mut root, mut rest) = (Integer::ONE, n.clone());
    for divisor in 2..=LARGEST_DIVISOR {
        let square = Integer::from(divisor * divisor);
        while (&rest % &square).is_zero() {
            rest /= &square;
            root *= divisor;
        }
    }
    match exact_square_root(&rest) {
        Some(exact) => (root * exact, Integer::ONE),
        None => (root, rest),
    }
}
