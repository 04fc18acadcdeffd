//! What all terms of a polynomial have in common.

use std::borrow::Cow;

use dashu_base::{Abs, Gcd};

use super::Polynomial;
use crate::algebra::monomial::Monomial;
use crate::algebra::number::Integer;

impl Polynomial {
    /// The greatest common divisor of the coefficients, never negative.
    pub fn content(&self) -> Integer {
        let mut content = Integer::ZERO;
        for (_, coefficient) in &self.terms {
            content = integer_gcd(&content, coefficient);
            if content.is_one() {
                break;
            }
        }
        content
    }

    /// The [`content`](Polynomial::content) with the sign of the leading
    /// coefficient.
    pub fn signed_content(&self) -> Integer {
        let content = self.content();
        if self.is_negative() {
            -content
        } else {
            content
        }
    }

    /// The greatest monomial that divides every term, 1 for zero.
    pub fn monomial_content(&self) -> Monomial {
        let Some((first, rest)) = self.terms.split_first() else {
            return Monomial::one();
        };
        let mut content = first.0.clone();
        for (monomial, _) in rest {
            if content.is_one() {
                break;
            }
            content = content.gcd(monomial);
        }
        content
    }

    /// `self` divided by its [`content`](Polynomial::content); it keeps its sign.
    pub fn primitive_part(&self) -> Self {
        self.over_integer(&self.content()).into_owned()
    }

    /// `self / divisor` for an integer that divides every coefficient.
    pub(in crate::algebra) fn over_integer(&self, divisor: &Integer) -> Cow<'_, Self> {
        if divisor.is_one() || divisor.is_zero() {
            return Cow::Borrowed(self);
        }
        debug_assert!(self.terms.iter().all(|(_, c)| (c % divisor).is_zero()));
        Cow::Owned(
            self.map_terms(|(monomial, coefficient)| (monomial.clone(), coefficient / divisor)),
        )
    }

    /// `self / divisor` for a monomial that divides every term.
    pub(in crate::algebra) fn over_monomial(&self, divisor: &Monomial) -> Cow<'_, Self> {
        if divisor.is_one() {
            return Cow::Borrowed(self);
        }
        debug_assert!(
            self.terms
                .iter()
                .all(|(m, _)| m.quotient(divisor).is_some())
        );
        Cow::Owned(
            self.map_terms(|(monomial, coefficient)| (monomial.over(divisor), coefficient.clone())),
        )
    }
}

/// The greatest common divisor, zero for two zeros.
pub(in crate::algebra) fn integer_gcd(left: &Integer, right: &Integer) -> Integer {
    match right.is_zero() {
        true => left.abs(),
        false => Integer::from(left.gcd(right)),
    }
}

#[cfg(test)]
mod tests {
    use super::super::notation::polynomial;
    use super::*;

    #[test]
    fn contents_are_taken_out_with_their_signs() {
        for (text, signed, monomial, primitive) in [
            ("0", 0, "1", "0"),
            ("-6", -6, "1", "-1"),
            ("4*a^2*b - 6*a*b^2", 2, "a*b", "2*a^2*b - 3*a*b^2"),
            ("-4*a^2 - 6*b", -2, "1", "-2*a^2 - 3*b"),
        ] {
            let polynomial_here = polynomial(text);
            assert_eq!(polynomial_here.signed_content(), Integer::from(signed));
            assert_eq!(polynomial_here.content(), Integer::from(signed.abs()));
            assert_eq!(
                Polynomial::from(polynomial_here.monomial_content()),
                polynomial(monomial)
            );
            assert_eq!(polynomial_here.primitive_part(), polynomial(primitive));
        }
    }

    #[test]
    fn a_monomial_that_divides_is_taken_away() {
        let product = polynomial("a^2*b - a*b^2");
        let content = product.monomial_content();
        assert_eq!(*product.over_monomial(&content), polynomial("a - b"));
    }
}
