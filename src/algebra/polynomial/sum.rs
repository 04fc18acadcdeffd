//! Sums, differences and negatives of polynomials.

use std::cmp::Ordering;
use std::ops::{Add, Neg, Sub};

use super::{Polynomial, Terms};
use crate::algebra::number::Integer;

impl Polynomial {
    /// Merges the terms of `self` and of `other`, changed by `sign`.
    fn merge(&self, other: &Self, sign: impl Fn(&Integer) -> Integer) -> Self {
        let mut terms = Terms::with_capacity(self.len() + other.len());
        let (mut left, mut right) = (&*self.terms, &*other.terms);
        while let ([first, left_rest @ ..], [second, right_rest @ ..]) = (left, right) {
            match first.0.cmp(&second.0) {
                Ordering::Greater => {
                    terms.push(first.clone());
                    left = left_rest;
                }
                Ordering::Less => {
                    terms.push((second.0.clone(), sign(&second.1)));
                    right = right_rest;
                }
                Ordering::Equal => {
                    let sum = &first.1 + sign(&second.1);
                    if !sum.is_zero() {
                        terms.push((first.0.clone(), sum));
                    }
                    (left, right) = (left_rest, right_rest);
                }
            }
        }
        terms.extend(left.iter().cloned());
        terms.extend(
            right
                .iter()
                .map(|(monomial, coefficient)| (monomial.clone(), sign(coefficient))),
        );
        Polynomial::from_sorted(terms)
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;

    fn add(self, other: &Polynomial) -> Polynomial {
        self.merge(other, Integer::clone)
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;

    fn sub(self, other: &Polynomial) -> Polynomial {
        self.merge(other, |coefficient| -coefficient)
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;

    fn neg(self) -> Polynomial {
        self.map_terms(|(monomial, coefficient)| (monomial.clone(), -coefficient))
    }
}

#[cfg(test)]
mod tests {
    use super::super::notation::polynomial;

    #[test]
    fn sums_merge_and_cancel() {
        for (left, right, sum, difference) in [
            ("a + b", "a - b", "2*a", "2*b"),
            ("a^2 + c", "b", "a^2 + b + c", "a^2 - b + c"),
            ("0", "a - 1", "a - 1", "1 - a"),
            ("a", "a", "2*a", "0"),
        ] {
            let (left, right) = (polynomial(left), polynomial(right));
            assert_eq!(&left + &right, polynomial(sum));
            assert_eq!(&left - &right, polynomial(difference));
            assert_eq!(-&(&left - &right), &right - &left);
        }
    }
}
