//! Polynomials in one unknown over any [`Arithmetic`].

use std::borrow::Borrow;

use super::arithmetic::{Arithmetic, SignedProduct};

/// The ring of polynomials in one unknown, with coefficients of another ring.
///
/// A polynomial is the list of its coefficients, that of the power 0 first; the last one is not 0. Over
/// polynomials again it has a second unknown, and [`determinant`](super::determinant::determinant) serves
/// them all.
///
/// ```
/// use sextic::algebra::arithmetic::Arithmetic;
/// use sextic::algebra::budget::Budget;
/// use sextic::algebra::number::Rational;
/// use sextic::algebra::trigonometric_sum::{TrigonometricSum, TrigonometricSums};
/// use sextic::algebra::univariate::Univariate;
///
/// let numbers = TrigonometricSums::new(Budget::new(100));
/// let polynomials = Univariate(&numbers);
/// let number = |n: i32| TrigonometricSum::from(Rational::from(n));
/// // (x − 1) (x + 1) = x² − 1
/// let product = polynomials.product(&vec![number(-1), number(1)], &vec![number(1), number(1)])?;
/// assert_eq!(product, [number(-1), number(0), number(1)]);
/// # Ok::<(), sextic::algebra::budget::Exhausted>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Univariate<'a, A>(pub &'a A);

/// The coefficients of a polynomial, that of the power 0 first.
pub type Coefficients<A> = Vec<<A as Arithmetic>::Element>;

impl<A: Arithmetic> Univariate<'_, A> {
    /// The polynomial with these coefficients, without leading zeros.
    pub fn polynomial(&self, mut coefficients: Vec<A::Element>) -> Vec<A::Element> {
        while coefficients.last().is_some_and(|last| self.0.is_zero(last)) {
            coefficients.pop();
        }
        coefficients
    }

    /// The products of coefficients that have the given power in a product of polynomials.
    fn of_power<'e>(
        &self,
        product: SignedProduct<&'e [A::Element], &'e [A::Element]>,
        power: usize,
    ) -> impl Iterator<Item = SignedProduct<&'e A::Element, &'e A::Element>> {
        let lowest = (power + 1).saturating_sub(product.right.len());
        let lefts = product.left.iter().enumerate().take(power + 1);
        let pairs = lefts
            .skip(lowest)
            .map(move |(own, left)| (left, &product.right[power - own]));
        let pairs = pairs
            .filter(|(left, right)| !self.0.is_negligible(left) && !self.0.is_negligible(right));
        pairs.map(move |(left, right)| SignedProduct {
            is_negative: product.is_negative,
            left,
            right,
        })
    }

    /// The derivative.
    ///
    /// # Errors
    ///
    /// Those of the coefficients.
    pub fn derivative(&self, a: &[A::Element]) -> Result<Vec<A::Element>, A::Error> {
        let mut power = self.0.zero();
        let mut slopes = Vec::with_capacity(a.len());
        for coefficient in a.iter().skip(1) {
            power = self.0.sum(&power, &self.0.one())?;
            slopes.push(self.0.product(&power, coefficient)?);
        }
        Ok(self.polynomial(slopes))
    }

    /// The value at a number, by Horner's rule.
    ///
    /// # Errors
    ///
    /// Those of the coefficients.
    pub fn value(&self, a: &[A::Element], at: &A::Element) -> Result<A::Element, A::Error> {
        let step = |sum, own| self.0.sum(&self.0.product(&sum, at)?, own);
        a.iter().rev().try_fold(self.0.zero(), step)
    }

    /// The coefficients of a(x + h), by repeated division.
    ///
    /// # Errors
    ///
    /// Those of the coefficients.
    pub fn shifted(&self, a: &[A::Element], h: &A::Element) -> Result<Coefficients<A>, A::Error> {
        let mut shifted = a.to_vec();
        for lowest in 0..shifted.len() {
            for power in (lowest + 1..shifted.len()).rev() {
                let product = self.0.product(&shifted[power], h)?;
                shifted[power - 1] = self.0.sum(&shifted[power - 1], &product)?;
            }
        }
        Ok(shifted)
    }

    /// q and s with lᵏ·a = q·b + s, where l is the leading coefficient of b, k is even, and s has a lower
    /// degree than b: nothing is divided, and lᵏ is not negative where l is real.
    ///
    /// # Errors
    ///
    /// Those of the coefficients.
    ///
    /// # Panics
    ///
    /// If b is 0.
    pub fn pseudo_division(
        &self,
        a: &[A::Element],
        b: &[A::Element],
    ) -> Result<(Coefficients<A>, Coefficients<A>), A::Error> {
        let leading = b.last().expect("what is divided by is not 0");
        let (mut quotient, mut rest) = (self.zero(), a.to_vec());
        let mut is_even = true;
        loop {
            let is_done = rest.len() < b.len();
            if is_done && is_even {
                return Ok((quotient, rest));
            }
            // The leading terms cancel; once they are gone only the factor is made even.
            let constant = vec![leading.clone()];
            let mut term = self.zero();
            if let (false, Some(last)) = (is_done, rest.last()) {
                term = vec![self.0.zero(); rest.len() - b.len()];
                term.push(last.clone());
            }
            let taken = self.product(&term, &b.to_vec())?;
            quotient = self.sum(&self.product(&constant, &quotient)?, &term)?;
            let length = rest.len();
            rest = self.difference(&self.product(&constant, &rest)?, &taken)?;
            if !is_done {
                rest.truncate(length - 1);
                rest = self.polynomial(rest);
            }
            is_even = !is_even;
        }
    }
}

impl<A: Arithmetic> Arithmetic for Univariate<'_, A> {
    type Element = Vec<A::Element>;
    type Error = A::Error;

    fn zero(&self) -> Self::Element {
        Vec::new()
    }

    fn one(&self) -> Self::Element {
        vec![self.0.one()]
    }

    fn is_zero(&self, a: &Self::Element) -> bool {
        a.is_empty()
    }

    fn sum(&self, a: &Self::Element, b: &Self::Element) -> Result<Self::Element, Self::Error> {
        let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
        let mut sum = long.clone();
        for (own, other) in sum.iter_mut().zip(short) {
            *own = self.0.sum(own, other)?;
        }
        Ok(self.polynomial(sum))
    }

    fn negative(&self, a: &Self::Element) -> Self::Element {
        a.iter().map(|own| self.0.negative(own)).collect()
    }

    fn product(&self, a: &Self::Element, b: &Self::Element) -> Result<Self::Element, Self::Error> {
        let product = SignedProduct {
            is_negative: false,
            left: a,
            right: b,
        };
        self.sum_of_products([Ok(product)].into_iter())
    }

    /// Power by power, each coefficient as one sum of products.
    fn sum_of_products<L: Borrow<Self::Element>, R: Borrow<Self::Element>>(
        &self,
        products: impl Iterator<Item = Result<SignedProduct<L, R>, Self::Error>>,
    ) -> Result<Self::Element, Self::Error> {
        let products = products.collect::<Result<Vec<_>, _>>()?;
        let factors = products.iter().map(|product| SignedProduct {
            is_negative: product.is_negative,
            left: &product.left.borrow()[..],
            right: &product.right.borrow()[..],
        });
        let lengths = factors
            .clone()
            .map(|product| product.left.len() + product.right.len());
        let powers = 0..lengths.max().unwrap_or(0).saturating_sub(1);
        let coefficient = |power| {
            let parts = factors
                .clone()
                .flat_map(|product| self.of_power(product, power));
            self.0.sum_of_products(parts.map(Ok))
        };
        Ok(self.polynomial(powers.map(coefficient).collect::<Result<_, _>>()?))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::algebra::budget::Budget;
    use crate::algebra::number::Rational;
    use crate::algebra::trigonometric_sum::{TrigonometricSum, TrigonometricSums};

    fn number(own: i64) -> TrigonometricSum {
        TrigonometricSum::from(Rational::from(own))
    }

    proptest! {
        #[test]
        fn a_shifted_polynomial_has_the_values_farther_on(
            coefficients in prop::collection::vec(-9_i64..10, 0..8), by in -5_i64..6, at in -5_i64..6,
        ) {
            let numbers = TrigonometricSums::new(Budget::new(10_000));
            let polynomials = Univariate(&numbers);
            let powers = (0..).map(|power| (at + by).pow(power));
            let value: i64 = coefficients.iter().zip(powers).map(|(own, power)| own * power).sum();
            let polynomial = polynomials.polynomial(coefficients.into_iter().map(number).collect());
            let shifted = polynomials.shifted(&polynomial, &number(by)).unwrap();
            prop_assert_eq!(polynomials.value(&shifted, &number(at)).unwrap(), number(value));
            prop_assert_eq!(polynomials.value(&polynomial, &number(at + by)).unwrap(), number(value));
        }

        #[test]
        fn products_quotients_and_slopes_have_their_values(
            a in prop::collection::vec(-9_i64..10, 0..6), b in prop::collection::vec(-9_i64..10, 1..4), at in -5_i64..6,
        ) {
            let numbers = TrigonometricSums::new(Budget::new(1_000_000));
            let polynomials = Univariate(&numbers);
            let of = |own: &[i64]| polynomials.polynomial(own.iter().copied().map(number).collect());
            let value = |own: &[i64]| own.iter().rev().fold(0_i128, |sum, own| sum * i128::from(at) + i128::from(*own));
            let found = |own: &Vec<TrigonometricSum>| polynomials.value(own, &number(at)).unwrap();
            let expected = |own: i128| TrigonometricSum::from(Rational::from(own));
            let product = polynomials.product(&of(&a), &of(&b)).unwrap();
            prop_assert_eq!(found(&product), expected(value(&a) * value(&b)));
            prop_assert!(product.last().is_none_or(|last| !last.is_zero()));
            let slopes: Vec<i64> = (0..).zip(&a).skip(1).map(|(power, own)| power * own).collect();
            prop_assert_eq!(polynomials.derivative(&of(&a)).unwrap(), of(&slopes));
            let divisor = of(&b);
            prop_assume!(!divisor.is_empty());
            let (quotient, rest) = polynomials.pseudo_division(&of(&a), &divisor).unwrap();
            prop_assert!(rest.len() < divisor.len());
            let leading = i128::from(*b.iter().rfind(|own| **own != 0).unwrap());
            let [quotient, rest] = [quotient, rest].map(|own| found(&own));
            let sum = numbers.sum(&numbers.product(&quotient, &expected(value(&b))).unwrap(), &rest).unwrap();
            let multiple = |power: u32| expected(value(&a) * leading.pow(2 * power));
            prop_assert!((0..=4).any(|power| sum == multiple(power)));
        }
    }
}
