//! Products and powers of polynomials.
//!
//! A product is collected in the cheapest representation that provably holds
//! it: monomials packed into 64 or 128 bits where the degrees allow, and
//! coefficients as machine integers where no sum of products can overflow.

use std::collections::hash_map::Entry;

use dashu_base::BitTest;
use rustc_hash::FxHashMap;

use super::budget::{Budget, Exhausted, check_bits, check_terms, words};
use super::coefficient::Coefficient;
use super::degrees::Degrees;
use super::monomial::Monomial;
use super::number::Integer;
use super::packing::{Key, Layout};
use super::polynomial::{Polynomial, Term, Terms};

/// Up to so many products of terms are sorted; more are hashed, as many of
/// them are likely to meet in the same term.
const MOST_SORTED: usize = 256;

/// What it costs to keep a term, and how many terms of a product cost nothing.
const STEPS_FOR_A_TERM: u64 = 10;
const MOST_FREE: usize = 100;

impl Polynomial {
    /// `self · other`.
    ///
    /// Takes `n·m` steps for `n` and `m` terms, times the lengths of the
    /// coefficients in words, and `t·log t` comparisons for `t` terms of the
    /// result.
    ///
    /// # Errors
    ///
    /// [`Exhausted`] if `budget` does not allow these steps, or if the product
    /// would have too many terms, too long coefficients or too large exponents.
    pub fn multiply(&self, other: &Self, budget: &Budget) -> Result<Self, Exhausted> {
        if self.is_zero() || other.is_zero() {
            return Ok(Polynomial::zero());
        }
        if self.is_one() || other.is_one() {
            return Ok(if self.is_one() { other } else { self }.clone());
        }
        budget.spend(length(self).saturating_mul(length(other)))?;
        // A term of the product is a sum of at most one product for each term
        // of the shorter factor.
        let summands = self.len().min(other.len());
        let bits = widest(self) + widest(other) + summands.ilog2() as usize + 1;
        check_bits(bits)?;
        let product = match (self.terms(), other.terms()) {
            ([term], _) => other.times_term(term),
            (_, [term]) => self.times_term(term),
            _ => {
                let layout = Layout::new(&Degrees::of(self).sum(&Degrees::of(other))?, 0);
                match layout.bits() {
                    ..=64 => collect_in::<u64>(self, other, &layout, bits),
                    65..=128 => collect_in::<u128>(self, other, &layout, bits),
                    _ => collect::<Monomial, Integer>(self, other, &layout),
                }
            }
        }?;
        budget.spend(STEPS_FOR_A_TERM * product.len().saturating_sub(MOST_FREE) as u64)?;
        Ok(product)
    }

    /// `self^exponent`; `0^0` is 1.
    ///
    /// Two terms are raised by the binomial theorem, in as many steps as the result has words, more
    /// terms by repeated squaring.
    ///
    /// # Errors
    ///
    /// [`Exhausted`] as for [`multiply`](Polynomial::multiply).
    pub fn power(&self, exponent: u32, budget: &Budget) -> Result<Self, Exhausted> {
        if let ([first, second], 2..) = (self.terms(), exponent) {
            return binomial(first, second, exponent, budget);
        }
        let mut power = Polynomial::one();
        for place in (0..u32::BITS - exponent.leading_zeros()).rev() {
            power = power.multiply(&power, budget)?;
            if exponent >> place & 1 == 1 {
                power = power.multiply(self, budget)?;
            }
        }
        Ok(power)
    }

    fn times_term(&self, (monomial, factor): &Term) -> Result<Self, Exhausted> {
        let mut terms = Terms::with_capacity(self.len());
        for (own, coefficient) in self.terms() {
            terms.push((own.product(monomial)?, coefficient * factor));
        }
        Ok(Polynomial::from_sorted(terms))
    }
}

/// `(a + b)^n` of two terms a > b: a sum of `n + 1` terms, which do not meet.
fn binomial(a: &Term, b: &Term, n: u32, budget: &Budget) -> Result<Polynomial, Exhausted> {
    let bits = (a.1.bit_len() + b.1.bit_len() + 1).saturating_mul(n as usize);
    // Each coefficient is a product of three, one of them from the one before it.
    let steps = 4 * (bits as u64).div_ceil(64);
    budget.spend(steps.saturating_mul(u64::from(n) + 1))?;
    check_bits(bits)?;
    check_terms(n as usize + 1)?;
    let second_powers: Vec<Integer> = powers(&b.1, n);
    let mut first_powers = powers(&a.1, n);
    let mut ways = Integer::ONE;
    let mut terms = Terms::with_capacity(n as usize + 1);
    for (k, second_power) in (0..=n).zip(second_powers) {
        let monomial = a.0.raised(n - k)?.product(&b.0.raised(k)?)?;
        let first_power = first_powers.pop().unwrap_or(Integer::ONE);
        terms.push((monomial, &ways * first_power * second_power));
        ways = ways * Integer::from(n - k) / Integer::from(k + 1);
    }
    Ok(Polynomial::from_sorted(terms))
}

/// 1, c, …, cⁿ.
fn powers(base: &Integer, n: u32) -> Vec<Integer> {
    let next = |power: &Integer| Some(power * base);
    std::iter::successors(Some(Integer::ONE), next)
        .take(n as usize + 1)
        .collect()
}

/// The number of words of all coefficients.
pub(super) fn length(polynomial: &Polynomial) -> u64 {
    polynomial
        .terms()
        .iter()
        .map(|(_, coefficient)| words(coefficient))
        .sum()
}

/// The number of bits of the longest coefficient.
pub(super) fn widest(polynomial: &Polynomial) -> usize {
    let lengths = polynomial
        .terms()
        .iter()
        .map(|(_, coefficient)| coefficient.bit_len());
    lengths.max().unwrap_or(0)
}

/// Collects with the narrowest coefficients in which sums of `bits` bits fit.
fn collect_in<K: Key>(
    left: &Polynomial,
    right: &Polynomial,
    layout: &Layout,
    bits: usize,
) -> Result<Polynomial, Exhausted> {
    match bits {
        ..=63 => collect::<K, i64>(left, right, layout),
        64..=127 => collect::<K, i128>(left, right, layout),
        _ => collect::<K, Integer>(left, right, layout),
    }
}

/// Collects the product of two polynomials in the given representation.
fn collect<K: Key, C: Coefficient>(
    left: &Polynomial,
    right: &Polynomial,
    layout: &Layout,
) -> Result<Polynomial, Exhausted> {
    let (left, right) = (encode::<K, C>(left, layout), encode::<K, C>(right, layout));
    let sums = if left.len() * right.len() <= MOST_SORTED {
        sorted(&left, &right)?
    } else {
        hashed(&left, &right)?
    };
    let mut terms = Terms::with_capacity(sums.len());
    let sums = sums.into_iter().filter(|(_, sum)| !sum.is_zero());
    terms.extend(sums.map(|(key, sum)| (key.decode(layout), sum.into_integer())));
    Ok(Polynomial::from_sorted(terms))
}

/// The terms of a polynomial in the given representation.
pub(super) fn encode<K: Key, C: Coefficient>(
    polynomial: &Polynomial,
    layout: &Layout,
) -> Vec<(K, C)> {
    let terms = polynomial.terms().iter();
    let encode =
        |(monomial, coefficient): &Term| Some((K::encode(monomial, layout), C::read(coefficient)?));
    let encoded: Vec<(K, C)> = terms.filter_map(encode).collect();
    debug_assert_eq!(encoded.len(), polynomial.len());
    encoded
}

/// The sums of the products with equal keys, by decreasing key; all products
/// are in memory at once.
fn sorted<K: Key, C: Coefficient>(
    left: &[(K, C)],
    right: &[(K, C)],
) -> Result<Vec<(K, C)>, Exhausted> {
    let mut products = Vec::with_capacity(left.len() * right.len());
    for (left_key, left_value) in left {
        for (right_key, right_value) in right {
            products.push((
                left_key.product(right_key)?,
                C::product(left_value, right_value),
            ));
        }
    }
    products.sort_unstable_by(|(left, _), (right, _)| right.cmp(left));
    products.dedup_by(|(key, value), (kept, sum)| {
        let same = key == kept;
        if same {
            sum.plus(value);
        }
        same
    });
    Ok(products)
}

/// The sums of the products with equal keys, by decreasing key; only the sums
/// are in memory.
fn hashed<K: Key, C: Coefficient>(
    left: &[(K, C)],
    right: &[(K, C)],
) -> Result<Vec<(K, C)>, Exhausted> {
    let mut sums = FxHashMap::<K, C>::default();
    for (left_key, left_value) in left {
        for (right_key, right_value) in right {
            let product = C::product(left_value, right_value);
            match sums.entry(left_key.product(right_key)?) {
                Entry::Occupied(sum) => sum.into_mut().plus(&product),
                Entry::Vacant(place) => {
                    place.insert(product);
                }
            }
        }
        check_terms(sums.len())?;
    }
    let mut sums: Vec<(K, C)> = sums.into_iter().collect();
    sums.sort_unstable_by(|(left, _), (right, _)| right.cmp(left));
    Ok(sums)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::budget::{MOST_BITS, Resource};
    use super::super::polynomial::notation::{arbitrary, polynomial, symbol};
    use super::*;

    proptest! {
        #[test]
        fn every_representation_gives_the_same_product(
            left in arbitrary(20, 300, 29), right in arbitrary(20, 100, 29),
        ) {
            let layout = Layout::new(&Degrees::of(&left).sum(&Degrees::of(&right)).unwrap(), 0);
            let generic = collect::<Monomial, Integer>(&left, &right, &layout).unwrap();
            let product = left.multiply(&right, &Budget::unlimited()).unwrap();
            prop_assert_eq!(&product, &generic);
            prop_assert_eq!(&collect::<u128, i64>(&left, &right, &layout).unwrap(), &generic);
            prop_assert_eq!(&collect::<u128, i128>(&left, &right, &layout).unwrap(), &generic);
            if layout.bits() <= 64 {
                prop_assert_eq!(&collect::<u64, i64>(&left, &right, &layout).unwrap(), &generic);
            }
        }

        #[test]
        fn powers_are_repeated_products(base in arbitrary(3, 300, 70), exponent in 0_u32..7) {
            let budget = Budget::unlimited();
            let repeated = (0..exponent).fold(Polynomial::one(), |product, _| {
                product.multiply(&base, &budget).unwrap()
            });
            prop_assert_eq!(base.power(exponent, &budget).unwrap(), repeated);
        }

        #[test]
        fn long_coefficients_do_not_overflow(
            left in arbitrary(20, 2, 62), right in arbitrary(20, 2, 120), other in arbitrary(20, 2, 62),
        ) {
            for right in [right, other] {
                let layout = Layout::new(&Degrees::of(&left).sum(&Degrees::of(&right)).unwrap(), 0);
                let generic = collect::<Monomial, Integer>(&left, &right, &layout).unwrap();
                prop_assert_eq!(left.multiply(&right, &Budget::unlimited()).unwrap(), generic);
            }
        }

        #[test]
        fn sorting_and_hashing_give_the_same_sums(
            left in arbitrary(12, 2, 20), right in arbitrary(12, 2, 20),
        ) {
            let layout = Layout::new(&Degrees::of(&left).sum(&Degrees::of(&right)).unwrap(), 0);
            let (left, right) = (encode::<u64, i64>(&left, &layout), encode::<u64, i64>(&right, &layout));
            prop_assert_eq!(sorted(&left, &right), hashed(&left, &right));
        }
    }

    #[test]
    fn a_product_costs_a_step_for_each_pair_of_words() {
        let of = |terms: u16| {
            let term =
                |k| Polynomial::from_terms([(Monomial::power(symbol('a'), k), Integer::ONE)]);
            (0..terms)
                .map(term)
                .fold(Polynomial::zero(), |sum, term| &sum + &term)
        };
        let long = of(3).scale(&(Integer::ONE << 100));
        let kept = STEPS_FOR_A_TERM * (119 - MOST_FREE as u64);
        for (left, right, steps) in [
            (of(0), of(3), 0),
            (of(3), Polynomial::one(), 0),
            (Polynomial::one(), of(3), 0),
            (of(3), of(2), 6),
            (long, of(2), 12),
            (of(60), of(41), 60 * 41),
            (of(60), of(60), 60 * 60 + kept),
        ] {
            let budget = Budget::new(100_000);
            left.multiply(&right, &budget).unwrap();
            assert_eq!(budget.spent(), steps);
        }
        // Four times the words of the result, and its terms.
        let budget = Budget::new(100_000);
        of(2).power(9, &budget).unwrap();
        assert_eq!(budget.spent(), 4 * 10);
    }

    #[test]
    fn the_largest_sums_of_every_width_fit() {
        // The middle coefficient of the square of c + c·a + c·a² is 3·c².
        for bits in 28..66 {
            let coefficient = (Integer::ONE << bits) - Integer::ONE;
            let factor = polynomial("a^2 + a + 1").scale(&coefficient);
            let square = factor.power(2, &Budget::unlimited()).unwrap();
            let middle = &coefficient * &coefficient * Integer::from(3);
            assert_eq!(
                square.coefficient_in(symbol('a'), 2).as_constant(),
                Some(middle)
            );
        }
    }

    #[test]
    fn what_is_too_large_is_refused_before_it_is_computed() {
        let budget = Budget::unlimited();
        let resource = |outcome: Result<Polynomial, Exhausted>| outcome.unwrap_err().resource;
        let sum = polynomial("a + b + c + 1");
        assert_eq!(
            resource(sum.multiply(&sum, &Budget::new(15))),
            Resource::Steps
        );
        let high = polynomial("a^40000 + b");
        assert_eq!(resource(high.multiply(&high, &budget)), Resource::Exponent);
        assert_eq!(
            resource(polynomial("a").power(65_536, &budget)),
            Resource::Exponent
        );
        assert_eq!(
            resource(polynomial("3").power(u32::MAX, &budget)),
            Resource::Bits
        );
        assert_eq!(
            resource(polynomial("a + b").power(u32::MAX, &Budget::new(1 << 20))),
            Resource::Steps
        );
        let long = Polynomial::constant(Integer::ONE << (MOST_BITS - 1));
        assert_eq!(resource(long.multiply(&long, &budget)), Resource::Bits);
        let row = |letter| {
            let terms = (0..1_000).map(|e| (Monomial::power(letter, e), Integer::ONE));
            Polynomial::from_terms(terms)
        };
        let [a, b] = ['a', 'b'].map(symbol);
        assert_eq!(resource(row(a).multiply(&row(b), &budget)), Resource::Terms);
    }

    #[test]
    fn high_powers_of_two_terms_are_cheap() {
        let power = polynomial("a + 1")
            .power(2_000, &Budget::new(1_000_000))
            .unwrap();
        assert_eq!(power.len(), 2_001);
        // At a = 1 it is 2²⁰⁰⁰.
        let sum = power
            .terms()
            .iter()
            .fold(Integer::ZERO, |sum, (_, c)| sum + c);
        assert_eq!(sum, Integer::ONE << 2_000);
    }

    #[test]
    fn the_zeroth_power_is_one() {
        for text in ["0", "2", "a - b"] {
            assert!(
                polynomial(text)
                    .power(0, &Budget::unlimited())
                    .unwrap()
                    .is_one()
            );
        }
    }
}
