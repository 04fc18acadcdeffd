//! A notation for polynomials in tests, and arbitrary polynomials.

use proptest::prelude::*;

use super::Polynomial;
use crate::algebra::monomial::Monomial;
use crate::algebra::number::Integer;
use crate::algebra::symbol::Symbol;

/// The symbol written as this letter; `a` is the most significant one.
pub fn symbol(letter: char) -> Symbol {
    Symbol::new(letter as u16 - 'a' as u16)
}

/// Reads a sum such as `2*a^2*b - c + 3`, with spaces around signs only.
pub fn polynomial(text: &str) -> Polynomial {
    let text = text.replace("- ", "+ -");
    let terms = text
        .split("+ ")
        .map(str::trim)
        .filter(|term| !term.is_empty());
    Polynomial::from_terms(terms.map(|term| {
        let (sign, factors) = match term.strip_prefix('-') {
            Some(factors) => (-1, factors),
            None => (1, term),
        };
        let mut coefficient = Integer::from(sign);
        let mut monomial = Monomial::one();
        for factor in factors.split('*') {
            let (base, exponent) = factor.split_once('^').unwrap_or((factor, "1"));
            match base.parse::<Integer>() {
                Ok(number) => coefficient *= number,
                Err(_) => {
                    let letter = symbol(base.chars().next().unwrap());
                    let power = Monomial::power(letter, exponent.parse().unwrap());
                    monomial = monomial.product(&power).unwrap();
                }
            }
        }
        (monomial, coefficient)
    }))
}

/// Polynomials in five symbols with coefficients of up to `bits` bits.
pub fn arbitrary(terms: usize, degree: u16, bits: usize) -> impl Strategy<Value = Polynomial> {
    let exponents = prop::collection::vec(prop_oneof![Just(0), 0..=degree], 5);
    let monomial = exponents.prop_map(|exponents| {
        let powers = (0..)
            .zip(exponents)
            .map(|(index, e)| Monomial::power(Symbol::new(index), e));
        powers.fold(Monomial::one(), |product, power| {
            product.product(&power).unwrap()
        })
    });
    let long = any::<[i64; 4]>().prop_map(|parts| parts.into_iter().map(Integer::from).product());
    let coefficient = long.prop_map(move |long: Integer| long >> (255 - bits));
    prop::collection::vec((monomial, coefficient), 0..=terms).prop_map(Polynomial::from_terms)
}

#[test]
fn the_notation_is_read() {
    let read = polynomial("2*a^2*b - c + 3 - 2*a^2*b");
    assert_eq!(format!("{read:?}"), "-1*x2 + 3*1");
    assert!(polynomial("0").is_zero());
}
