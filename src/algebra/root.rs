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
    /// √(N/D) = √(N·D)/|D|; squares of factors of N·D whose sign is known are taken out, every other
    /// such factor p becomes a symbol w with w² = p, so that √a·√b is √(a·b), and what has no known
    /// sign becomes one such symbol together.
    ///
    /// Complexity: one square-free factorisation of N·D, and what it takes to find the signs of its
    /// factors.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::NotReal`] where a is not real; [`AlgebraError::NegativeRadicand`] where a is negative; [`AlgebraError::UnknownSign`] where it may
    /// not be positive, or is a square, but of a factor whose sign is not known;
    /// [`AlgebraError::TooManySymbols`] where the ring is full; [`AlgebraError::Exhausted`] where the
    /// budget or a polynomial's size runs out.
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
        self.real(element)?;
        let signs = self.signs(element)?;
        if !signs.positive {
            return Err(match signs.zero {
                true => AlgebraError::UnknownSign,
                false => AlgebraError::NegativeRadicand,
            });
        }
        let under = element
            .numerator()
            .multiply(element.denominator(), self.budget())?;
        let under = self.reduce(&under)?;
        let (outside, mut single) = integer_square_part(&under.content());
        let mut root = Polynomial::constant(outside);
        // What has no known sign keeps one root together.
        let mut mixed = Polynomial::one();
        let mut negative = under.signed_content() < Integer::ZERO;
        for (factor, multiplicity) in under.square_free(self.budget())? {
            let signs = self.polynomial_signs(&factor)?;
            let factor = if signs.is_non_negative() {
                factor
            } else if !signs.positive {
                negative ^= multiplicity % 2 == 1;
                -&factor
            } else {
                let kept = factor.power(multiplicity, self.budget())?;
                mixed = mixed.multiply(&kept, self.budget())?;
                continue;
            };
            root = root.multiply(
                &factor.power(multiplicity / 2, self.budget())?,
                self.budget(),
            )?;
            if multiplicity % 2 == 1 {
                single.push(factor);
            }
        }
        if negative {
            mixed = -&mixed;
        }
        if mixed != Polynomial::one() {
            if mixed.as_constant().is_some() || mixed.square_root(self.budget())?.is_some() {
                return Err(AlgebraError::UnknownSign);
            }
            single.push(mixed);
        }
        let mut numerator = Fraction::from(root);
        for radicand in single {
            let strictly = self.polynomial_signs(&radicand)?.is_positive();
            let symbol = self.symbol(Generator::Root { radicand })?;
            let signs = if strictly {
                Signs::POSITIVE
            } else {
                Signs::NON_NEGATIVE
            };
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

/// (a, [b, c, …]) with n = a²·b·c·… for n > 0, where b, c, … are the primes that trial division finds
/// once, and the rest.
fn integer_square_part(n: &Integer) -> (Integer, Vec<Polynomial>) {
    const LARGEST_DIVISOR: u32 = 1000;
    let (mut root, mut single, mut rest) = (Integer::ONE, Vec::new(), n.clone());
    for divisor in (2..=LARGEST_DIVISOR).map(Integer::from) {
        let square = &divisor * &divisor;
        while (&rest % &square).is_zero() {
            rest /= &square;
            root *= &divisor;
        }
        if (&rest % &divisor).is_zero() {
            rest /= &divisor;
            single.push(Polynomial::constant(divisor));
        }
    }
    match exact_square_root(&rest) {
        Some(exact) => root *= exact,
        None => single.push(Polynomial::constant(rest)),
    }
    (root, single)
}
