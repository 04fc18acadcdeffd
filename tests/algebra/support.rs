//! What the tests of the algebra share: arbitrary elements and an independent oracle.

use proptest::prelude::*;
use sextic::algebra::budget::Budget;
use sextic::algebra::fraction::Fraction;
use sextic::algebra::monomial::Monomial;
use sextic::algebra::number::Integer;
use sextic::algebra::polynomial::Polynomial;
use sextic::algebra::symbol::Symbol;

/// The number of symbols of arbitrary elements.
pub const SYMBOLS: u16 = 3;

/// Enough steps for every element tested, and few enough to notice a runaway.
pub fn budget() -> Budget {
    Budget::new(50_000_000)
}

/// The product of powers of the first symbols.
pub fn monomial(exponents: &[u16]) -> Monomial {
    let powers = (0..)
        .zip(exponents)
        .map(|(index, &e)| Monomial::power(Symbol::new(index), e));
    powers.fold(Monomial::one(), |product, power| {
        product.product(&power).unwrap()
    })
}

/// Integers of every length that takes a path of its own.
pub fn integer() -> impl Strategy<Value = Integer> {
    prop_oneof![
        6 => (-9_i64..=9).prop_map(Integer::from),
        1 => any::<i64>().prop_map(Integer::from),
        1 => (any::<i64>(), any::<i64>()).prop_map(|(a, b)| Integer::from(a) * Integer::from(b)),
        1 => any::<[i64; 4]>().prop_map(|parts| parts.into_iter().map(Integer::from).product()),
    ]
}

/// Polynomials in `SYMBOLS` symbols of degree at most `degree` in each.
pub fn polynomial(terms: usize, degree: u16) -> impl Strategy<Value = Polynomial> {
    let exponents = prop::collection::vec(0..=degree, usize::from(SYMBOLS));
    let term = (
        exponents.prop_map(|exponents| monomial(&exponents)),
        integer(),
    );
    prop::collection::vec(term, 0..=terms).prop_map(Polynomial::from_terms)
}

/// Polynomials with coefficients of one digit.
pub fn small_polynomial(terms: usize, degree: u16) -> impl Strategy<Value = Polynomial> {
    let exponents = prop::collection::vec(0..=degree, usize::from(SYMBOLS));
    let coefficient = (-3_i64..=3).prop_map(Integer::from);
    let term = (
        exponents.prop_map(|exponents| monomial(&exponents)),
        coefficient,
    );
    prop::collection::vec(term, 0..=terms).prop_map(Polynomial::from_terms)
}

/// Fractions of small polynomials.
pub fn fraction() -> impl Strategy<Value = Fraction> {
    (small_polynomial(3, 1), small_polynomial(3, 1))
        .prop_filter_map("denominator zero", |(n, d)| {
            Fraction::new(n, d, &budget()).ok()
        })
}

/// The value at a point, term by term, power by repeated multiplication.
pub fn value(polynomial: &Polynomial, point: &[i64]) -> Integer {
    let mut sum = Integer::ZERO;
    for (monomial, coefficient) in polynomial.terms() {
        let mut product = coefficient.clone();
        for (symbol, exponent) in monomial.factors() {
            for _ in 0..exponent {
                product *= Integer::from(point[symbol.index()]);
            }
        }
        sum += product;
    }
    sum
}

/// So many points in every direction that polynomials of at most this degree
/// in every symbol are equal if their values there are.
pub fn grid(degree: i64) -> impl Iterator<Item = [i64; SYMBOLS as usize]> {
    let range = move || (0..=degree).map(move |step| step - degree / 2);
    range().flat_map(move |a| range().flat_map(move |b| range().map(move |c| [a, b, c])))
}
