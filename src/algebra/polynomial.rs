//! Polynomials in many symbols with integer coefficients.

mod content;
#[cfg(test)]
pub(super) mod notation;
mod sum;

use std::collections::BTreeMap;
use std::fmt;

use dashu_base::Signed;
use smallvec::{SmallVec, smallvec};

use super::budget::{Exhausted, check_exponent};
use super::monomial::Monomial;
use super::number::Integer;
use super::symbol::Symbol;

pub(super) use content::integer_gcd;

/// One summand of a polynomial.
pub(super) type Term = (Monomial, Integer);

/// The summands of a polynomial; most polynomials below a line are 1, and need no allocation.
pub(super) type Terms = SmallVec<[Term; 1]>;

/// A polynomial with integer coefficients, expanded.
///
/// Equal polynomials have equal representations, so `==` decides equality.
/// Sums and negation are operators on references and take time proportional to
/// the number of terms. Whatever can cost more draws from a
/// [`Budget`](super::budget::Budget) and is a method.
///
/// ```
/// use sextic::algebra::{budget::Budget, polynomial::Polynomial, symbol::Symbol};
///
/// let budget = Budget::new(1_000);
/// let a = Polynomial::symbol(Symbol::new(0));
/// let b = Polynomial::symbol(Symbol::new(1));
/// let product = (&a + &b).multiply(&(&a - &b), &budget)?;
/// assert_eq!(product, &a.power(2, &budget)? - &b.power(2, &budget)?);
/// # Ok::<(), sextic::algebra::budget::Exhausted>(())
/// ```
#[derive(Clone, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Polynomial {
    /// By strictly decreasing monomial, without zero coefficients.
    terms: Terms,
}

impl Polynomial {
    /// The polynomial without terms.
    pub fn zero() -> Self {
        Polynomial::default()
    }

    /// The constant 1.
    pub fn one() -> Self {
        Polynomial::constant(Integer::ONE)
    }

    /// The polynomial of degree zero with this value.
    pub fn constant(value: Integer) -> Self {
        if value.is_zero() {
            return Polynomial::zero();
        }
        Polynomial::from_sorted(smallvec![(Monomial::one(), value)])
    }

    /// The polynomial that is just this symbol.
    pub fn symbol(symbol: Symbol) -> Self {
        Polynomial::from(Monomial::power(symbol, 1))
    }

    /// The sum of these terms, which may come in any order, repeat and cancel.
    ///
    /// Takes `n·log n` comparisons for `n` terms.
    pub fn from_terms(terms: impl IntoIterator<Item = (Monomial, Integer)>) -> Self {
        let mut terms: Terms = terms.into_iter().collect();
        terms.sort_by(|(left, _), (right, _)| right.cmp(left));
        terms.dedup_by(|(monomial, coefficient), (kept, sum)| {
            let same = monomial == kept;
            if same {
                *sum += &*coefficient;
            }
            same
        });
        terms.retain(|(_, coefficient)| !coefficient.is_zero());
        Polynomial::from_sorted(terms)
    }

    /// Takes over terms that already are as the invariant wants them.
    pub(super) fn from_sorted(mut terms: Terms) -> Self {
        // What many terms were collected in may have room for many more.
        const MOST_SPARE: usize = 64;
        if terms.capacity() > MOST_SPARE + 2 * terms.len() {
            terms.shrink_to_fit();
        }
        let polynomial = Polynomial { terms };
        debug_assert!(polynomial.is_valid());
        polynomial
    }

    /// The invariant: monomials strictly decrease, no coefficient is zero.
    fn is_valid(&self) -> bool {
        let ordered = self
            .terms
            .is_sorted_by(|(left, _), (right, _)| left > right);
        ordered
            && self
                .terms
                .iter()
                .all(|(_, coefficient)| !coefficient.is_zero())
    }

    /// The terms by strictly decreasing monomial; no coefficient is zero.
    pub fn terms(&self) -> &[(Monomial, Integer)] {
        &self.terms
    }

    /// The number of terms.
    #[expect(clippy::len_without_is_empty, reason = "it is called `is_zero`")]
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether this is the zero polynomial.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether this is the constant 1.
    pub fn is_one(&self) -> bool {
        matches!(&*self.terms, [(monomial, coefficient)] if monomial.is_one() && coefficient.is_one())
    }

    /// The value of a polynomial without symbols, `None` for every other one.
    pub fn as_constant(&self) -> Option<Integer> {
        match &*self.terms {
            [] => Some(Integer::ZERO),
            [(monomial, coefficient)] if monomial.is_one() => Some(coefficient.clone()),
            _ => None,
        }
    }

    /// The term with the greatest monomial, `None` for zero.
    pub fn leading(&self) -> Option<&(Monomial, Integer)> {
        self.terms.first()
    }

    /// Whether the leading coefficient is below zero.
    pub(super) fn is_negative(&self) -> bool {
        self.leading()
            .is_some_and(|(_, coefficient)| coefficient.is_negative())
    }

    /// The one of `self` and `-self` whose leading coefficient is positive.
    pub(super) fn with_positive_leading(self) -> Self {
        if self.is_negative() { -&self } else { self }
    }

    /// Whether `symbol` occurs.
    pub fn contains(&self, symbol: Symbol) -> bool {
        self.degree_in(symbol) != 0
    }

    /// The highest exponent of `symbol`, zero for the zero polynomial.
    pub fn degree_in(&self, symbol: Symbol) -> u32 {
        let exponents = self
            .terms
            .iter()
            .map(|(monomial, _)| monomial.exponent(symbol));
        exponents.max().unwrap_or(0)
    }

    /// The coefficients of the powers of `symbol`, by exponent; those that are
    /// zero are left out.
    pub fn coefficients_in(&self, symbol: Symbol) -> BTreeMap<u32, Polynomial> {
        let mut coefficients = BTreeMap::<u32, Polynomial>::new();
        for (monomial, coefficient) in &self.terms {
            // Terms with the same power of the symbol stay in order without it.
            let part = coefficients.entry(monomial.exponent(symbol)).or_default();
            part.terms
                .push((monomial.without(symbol), coefficient.clone()));
        }
        debug_assert!(coefficients.values().all(Polynomial::is_valid));
        coefficients
    }

    /// The sum of `coefficient·symbol^exponent` over `coefficients`, the
    /// inverse of [`coefficients_in`](Polynomial::coefficients_in).
    ///
    /// # Errors
    ///
    /// [`Exhausted`] if an exponent of the sum is too large.
    pub fn from_coefficients_in(
        symbol: Symbol,
        coefficients: &BTreeMap<u32, Polynomial>,
    ) -> Result<Self, Exhausted> {
        let mut terms = Terms::new();
        for (&exponent, part) in coefficients {
            let power = Monomial::power(symbol, check_exponent(u64::from(exponent))?);
            terms.append(&mut part.times_monomial(&power)?.terms);
        }
        Ok(Polynomial::from_terms(terms))
    }

    /// The coefficient of `symbol^exponent`.
    pub(super) fn coefficient_in(&self, symbol: Symbol, exponent: u32) -> Self {
        let here = self
            .terms
            .iter()
            .filter(|(monomial, _)| monomial.exponent(symbol) == exponent);
        let without =
            |(monomial, coefficient): &Term| (monomial.without(symbol), coefficient.clone());
        Polynomial::from_sorted(here.map(without).collect())
    }

    /// The terms below a power of `symbol`, and the others.
    pub(super) fn split_at(&self, symbol: Symbol, exponent: u32) -> (Self, Self) {
        let terms = self.terms.iter().cloned();
        let (below, above) = terms.partition(|(monomial, _)| monomial.exponent(symbol) < exponent);
        (
            Polynomial::from_sorted(below),
            Polynomial::from_sorted(above),
        )
    }

    /// `factor · self`.
    pub fn scale(&self, factor: &Integer) -> Self {
        if factor.is_zero() {
            return Polynomial::zero();
        }
        self.map_terms(|(monomial, coefficient)| (monomial.clone(), coefficient * factor))
    }

    /// `monomial · self`.
    ///
    /// # Errors
    ///
    /// [`Exhausted`] if an exponent of the product is too large.
    pub fn times_monomial(&self, monomial: &Monomial) -> Result<Self, Exhausted> {
        let mut terms = Terms::with_capacity(self.len());
        for (own, coefficient) in &self.terms {
            terms.push((own.product(monomial)?, coefficient.clone()));
        }
        Ok(Polynomial::from_sorted(terms))
    }

    /// The partial derivative with respect to `symbol`.
    pub fn derivative(&self, symbol: Symbol) -> Self {
        let unit = Monomial::power(symbol, 1);
        let terms = self.terms.iter().filter_map(|(monomial, coefficient)| {
            let exponent = Integer::from(monomial.exponent(symbol));
            Some((monomial.quotient(&unit)?, coefficient * exponent))
        });
        Polynomial::from_sorted(terms.collect())
    }

    /// Replaces terms by terms in the same order.
    fn map_terms(&self, replace: impl Fn(&Term) -> Term) -> Self {
        Polynomial::from_sorted(self.terms.iter().map(replace).collect())
    }
}

impl From<Monomial> for Polynomial {
    fn from(monomial: Monomial) -> Self {
        Polynomial::from_sorted(smallvec![(monomial, Integer::ONE)])
    }
}

impl fmt::Debug for Polynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.write_str("0");
        }
        for (place, (monomial, coefficient)) in self.terms.iter().enumerate() {
            let plus = if place == 0 { "" } else { " + " };
            write!(f, "{plus}{coefficient}*{monomial:?}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::notation::{polynomial, symbol};
    use super::*;

    #[test]
    fn terms_are_collected_and_ordered() {
        let sum = polynomial("b + 2*a - 3 + a*b + a - b");
        assert_eq!(format!("{sum:?}"), "1*x0*x1 + 3*x0 + -3*1");
        assert_eq!(
            sum.leading(),
            Some(&(
                Monomial::power(symbol('a'), 1)
                    .product(&Monomial::power(symbol('b'), 1))
                    .unwrap(),
                Integer::ONE
            ))
        );
        assert!(polynomial("a - a").is_zero());
    }

    #[test]
    fn terms_that_stand_twice_are_not_valid() {
        let (a, b) = (
            Monomial::power(symbol('a'), 1),
            Monomial::power(symbol('b'), 1),
        );
        for (first, second, coefficient, is_valid) in [
            (&a, &b, 1, true),
            (&a, &a, 1, false),
            (&b, &a, 1, false),
            (&a, &b, 0, false),
        ] {
            let terms = [
                (first.clone(), Integer::ONE),
                (second.clone(), coefficient.into()),
            ];
            let polynomial = Polynomial {
                terms: terms.into_iter().collect(),
            };
            assert_eq!(polynomial.is_valid(), is_valid, "{polynomial:?}");
        }
    }

    #[test]
    fn constants_are_recognised() {
        assert_eq!(Polynomial::zero().as_constant(), Some(Integer::ZERO));
        assert_eq!(polynomial("7").as_constant(), Some(Integer::from(7)));
        assert_eq!(polynomial("a").as_constant(), None);
        assert_eq!(polynomial("a + 7").as_constant(), None);
        assert!(Polynomial::one().is_one() && !polynomial("2").is_one());
        assert_eq!(Polynomial::zero().degree_in(symbol('a')), 0);
    }

    #[test]
    fn a_coefficient_is_the_one_of_its_power() {
        let sum = polynomial("a^3*b + 2*a^3 - a*c + b - 5");
        let a = symbol('a');
        let table = [(0, "b - 5"), (1, "-c"), (3, "b + 2")];
        let expected = table.map(|(exponent, text)| (exponent, polynomial(text)));
        assert_eq!(sum.coefficients_in(a), BTreeMap::from(expected));
        assert_eq!(sum.coefficient_in(a, 3), polynomial("b + 2"));
        assert_eq!(
            sum.symbols(),
            std::collections::BTreeSet::from(['a', 'b', 'c'].map(symbol))
        );
    }

    #[test]
    fn too_large_exponents_are_refused() {
        let a = symbol('a');
        let high = Polynomial::from(Monomial::power(a, u16::MAX));
        assert!(high.times_monomial(&Monomial::power(a, 1)).is_err());
        let coefficients = BTreeMap::from([(65_536, Polynomial::one())]);
        assert!(Polynomial::from_coefficients_in(a, &coefficients).is_err());
    }
}
