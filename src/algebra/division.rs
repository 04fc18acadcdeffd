//! Exact division and division with remainder.

use std::collections::BinaryHeap;

use dashu_base::{BitTest, DivRem};

use super::budget::{
    Budget, Exhausted, check_bits, check_exponent, check_terms, steps_of_division, words,
};
use super::degrees::Degrees;
use super::monomial::Monomial;
use super::number::Integer;
use super::packing::{Frame, Key, Layout};
use super::polynomial::{Polynomial, Term, Terms};
use super::product::encode;
use super::symbol::Symbol;

impl Polynomial {
    /// The `quotient` with `quotient · divisor = self`, or `None` where there
    /// is none; only zero divides by zero, and gives zero.
    ///
    /// Takes `q·d` steps for `q` terms of the quotient and `d` terms of the
    /// divisor, times the lengths of the coefficients in words, and a factor
    /// of `log q` for keeping the products in order. Where the degrees or the
    /// outermost terms already rule a quotient out, the time is linear.
    ///
    /// ```
    /// use sextic::algebra::{budget::Budget, polynomial::Polynomial, symbol::Symbol};
    ///
    /// let budget = Budget::new(1_000);
    /// let a = Polynomial::symbol(Symbol::new(0));
    /// let square = a.power(2, &budget)?;
    /// let divisor = &a + &Polynomial::one();
    /// let quotient = (&square - &Polynomial::one()).divide_exact(&divisor, &budget)?;
    /// assert_eq!(quotient, Some(&a - &Polynomial::one()));
    /// assert_eq!(square.divide_exact(&divisor, &budget)?, None);
    /// # Ok::<(), sextic::algebra::budget::Exhausted>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Exhausted`] if `budget` does not allow these steps, or if the quotient
    /// would have too many terms or too long coefficients.
    pub fn divide_exact(&self, divisor: &Self, budget: &Budget) -> Result<Option<Self>, Exhausted> {
        budget.spend(self.len() as u64)?;
        let (Some(first), Some(last)) = (divisor.terms().first(), divisor.terms().last()) else {
            return Ok(self.is_zero().then(Polynomial::zero));
        };
        let ends = [(self.terms().first(), first), (self.terms().last(), last)];
        for (dividend, divisor) in ends {
            let Some(dividend) = dividend else {
                return Ok(Some(Polynomial::zero()));
            };
            if divide_term(dividend, divisor).is_none() {
                return Ok(None);
            }
        }
        if let [term] = divisor.terms() {
            return self.divide_by_term(term, budget);
        }
        let degrees = Degrees::of(self);
        let Some(bound) = degrees.difference(&Degrees::of(divisor)) else {
            return Ok(None);
        };
        let bound = bound.monomial()?;
        let layout = Layout::new(&degrees, 1);
        match layout.bits() {
            ..=64 => divide::<u64>(self, divisor, &layout, &bound, budget),
            65..=128 => divide::<u128>(self, divisor, &layout, &bound, budget),
            _ => divide::<Monomial>(self, divisor, &layout, &bound, budget),
        }
    }

    fn divide_by_term(&self, term: &Term, budget: &Budget) -> Result<Option<Self>, Exhausted> {
        let steps = self.terms().iter();
        budget.spend(steps.map(|(_, own)| steps_of_division(own, &term.1)).sum())?;
        let quotients = self.terms().iter().map(|own| divide_term(own, term));
        let terms: Option<Terms> = quotients.collect();
        Ok(terms.map(Polynomial::from_sorted))
    }

    /// The pseudo-remainder with respect to `symbol`: the `r` of lower degree
    /// than `divisor` with `c^(δ+1)·self = q·divisor + r`, where `c` is the
    /// leading coefficient of the divisor and `δ` the difference of the degrees.
    ///
    /// A dividend of lower degree is its own remainder, and so is every
    /// dividend where the divisor is zero.
    ///
    /// Takes the steps of `2(δ+1)` products with coefficients of the divisor;
    /// terms and coefficients of the remainder grow with every one.
    ///
    /// # Errors
    ///
    /// [`Exhausted`] as for [`multiply`](Polynomial::multiply).
    pub fn pseudo_remainder(
        &self,
        divisor: &Self,
        symbol: Symbol,
        budget: &Budget,
    ) -> Result<Self, Exhausted> {
        let degree = divisor.degree_in(symbol);
        let mut remainder = self.clone();
        let Some(mut owed) = (self.degree_in(symbol) + 1).checked_sub(degree) else {
            return Ok(remainder);
        };
        if divisor.is_zero() {
            return Ok(remainder);
        }
        let leading = divisor.coefficient_in(symbol, degree);
        // What is left of the divisor once its leading power is taken away.
        let tail = divisor - &leading.times_monomial(&power_of(symbol, degree)?)?;
        while owed > 0 && !remainder.is_zero() {
            let top = remainder.degree_in(symbol);
            let Some(gap) = top.checked_sub(degree) else {
                break;
            };
            let coefficient = remainder.coefficient_in(symbol, top);
            let rest = &remainder - &coefficient.times_monomial(&power_of(symbol, top)?)?;
            let subtracted = tail
                .multiply(&coefficient, budget)?
                .times_monomial(&power_of(symbol, gap)?)?;
            remainder = &rest.multiply(&leading, budget)? - &subtracted;
            owed -= 1;
        }
        remainder.multiply(&leading.power(owed, budget)?, budget)
    }
}

/// `symbol^exponent`.
fn power_of(symbol: Symbol, exponent: u32) -> Result<Monomial, Exhausted> {
    Ok(Monomial::power(symbol, check_exponent(exponent.into())?))
}

/// The quotient of two terms.
fn divide_term(dividend: &Term, divisor: &Term) -> Option<Term> {
    Some((
        dividend.0.quotient(&divisor.0)?,
        divide_integer(&dividend.1, &divisor.1)?,
    ))
}

/// The quotient of two integers where it is one.
fn divide_integer(dividend: &Integer, divisor: &Integer) -> Option<Integer> {
    let (quotient, remainder) = dividend.div_rem(divisor);
    remainder.is_zero().then_some(quotient)
}

/// Divides from the leading term down. The heap holds, for every term of the
/// quotient found so far, its next product with a term of the divisor; so the
/// terms of `quotient · divisor` come out in order, and only when they are due.
fn divide<K: Key>(
    dividend: &Polynomial,
    divisor: &Polynomial,
    layout: &Layout,
    bound: &Monomial,
    budget: &Budget,
) -> Result<Option<Polynomial>, Exhausted> {
    let dividend = encode::<K, Integer>(dividend, layout);
    let divisor = encode::<K, Integer>(divisor, layout);
    let frame: Frame<K> = K::frame(layout, bound);
    let [(leading_key, leading), tail @ ..] = &*divisor else {
        return Ok(None);
    };
    let mut dividend = dividend.into_iter().peekable();
    let mut products = BinaryHeap::<(K, usize, usize)>::new();
    let mut quotient = Vec::<(K, Integer)>::new();
    loop {
        let key = match (dividend.peek(), products.peek()) {
            (Some((own, _)), Some((product, ..))) => own.max(product).clone(),
            (Some((key, _)), None) | (None, Some((key, ..))) => key.clone(),
            (None, None) => break,
        };
        let own = dividend.next_if(|(own, _)| *own == key);
        let mut coefficient = own.map_or(Integer::ZERO, |(_, coefficient)| coefficient);
        while products.peek().is_some_and(|(product, ..)| *product == key) {
            let Some((_, place, index)) = products.pop() else {
                break;
            };
            let (partner_key, partner) = &quotient[place];
            budget.spend(words(partner) * words(&tail[index].1))?;
            coefficient -= partner * &tail[index].1;
            if let Some((next, _)) = tail.get(index + 1) {
                products.push((partner_key.product(next)?, place, index + 1));
            }
        }
        if coefficient.is_zero() {
            continue;
        }
        check_bits(coefficient.bit_len())?;
        let Some(term_key) = key.quotient(leading_key, &frame) else {
            return Ok(None);
        };
        budget.spend(steps_of_division(&coefficient, leading))?;
        let Some(coefficient) = divide_integer(&coefficient, leading) else {
            return Ok(None);
        };
        if let Some((next, _)) = tail.first() {
            products.push((term_key.product(next)?, quotient.len(), 0));
        }
        quotient.push((term_key, coefficient));
        check_terms(quotient.len())?;
    }
    let decode = |(key, coefficient): (K, Integer)| (key.decode(layout), coefficient);
    Ok(Some(Polynomial::from_sorted(
        quotient.into_iter().map(decode).collect(),
    )))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::polynomial::notation::{arbitrary, polynomial, symbol};
    use super::*;

    #[test]
    fn division_finds_the_quotient_or_that_there_is_none() {
        for (dividend, divisor, quotient) in [
            ("0", "a + b", Some("0")),
            ("0", "0", Some("0")),
            ("a", "0", None),
            ("6*a^2*b - 4*a*b", "2*a", Some("3*a*b - 2*b")),
            ("6*a^2*b - 4*b", "2*a", None),
            ("3*a", "2", None),
            ("a^2 - b^2", "a + b", Some("a - b")),
            ("a^2 + b^2", "a + b", None),
            ("a^2 - b^2", "2*a + 2*b", None),
            ("a^3 + a^2*b + a*b^2 + b^3", "a^2 + b^2", Some("a + b")),
            ("a^2 + c", "a + d", None),
            ("a^5 - 1", "a - 1", Some("a^4 + a^3 + a^2 + a + 1")),
        ] {
            let (dividend, divisor) = (polynomial(dividend), polynomial(divisor));
            let found = dividend
                .divide_exact(&divisor, &Budget::new(1_000))
                .unwrap();
            assert_eq!(
                found,
                quotient.map(polynomial),
                "{dividend:?} / {divisor:?}"
            );
        }
    }

    #[test]
    fn pseudo_remainders_are_as_defined() {
        for (dividend, divisor, remainder) in [
            ("a^2 + 1", "b*a + 1", "b^2 + 1"),
            ("a", "a^2", "a"),
            ("a^2 + 1", "0", "a^2 + 1"),
            ("a^3", "2*a", "0"),
            ("a^2", "3", "0"),
            ("a^3 + c", "b*a^2 - 1", "b*a + b^2*c"),
        ] {
            let (dividend, divisor) = (polynomial(dividend), polynomial(divisor));
            let found = dividend.pseudo_remainder(&divisor, symbol('a'), &Budget::new(1_000));
            assert_eq!(
                found,
                Ok(polynomial(remainder)),
                "{dividend:?} by {divisor:?}"
            );
        }
    }

    proptest! {
        #[test]
        fn every_representation_gives_the_same_quotient(
            left in arbitrary(8, 3, 40), right in arbitrary(8, 3, 40), error in arbitrary(1, 3, 2),
        ) {
            let dividend = &left.multiply(&right, &Budget::unlimited()).unwrap() + &error;
            let (budget, degrees) = (Budget::unlimited(), Degrees::of(&dividend));
            let found = dividend.divide_exact(&right, &budget).unwrap();
            prop_assert!(!error.is_zero() || right.is_zero() || found.as_ref() == Some(&left));
            let Some(bound) = degrees.difference(&Degrees::of(&right)) else {
                return Ok(());
            };
            let bound = bound.monomial().unwrap();
            let layout = Layout::new(&degrees, 1);
            let packed = divide::<u128>(&dividend, &right, &layout, &bound, &budget).unwrap();
            let generic = divide::<Monomial>(&dividend, &right, &layout, &bound, &budget).unwrap();
            prop_assert_eq!(&packed, &generic);
            prop_assert!(right.is_zero() || dividend.is_zero() || packed == found);
        }
    }
}
