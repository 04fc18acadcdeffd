//! Products of polynomials, sums of them, and powers.
//!
//! A sum of products is collected in the cheapest representation that provably holds
//! it: monomials packed into 64 or 128 bits where the degrees allow, and
//! coefficients as machine integers where no sum of products can overflow.

use dashu_base::BitTest;
use smallvec::SmallVec;

use super::arithmetic::SignedProduct;
use super::budget::{Budget, Exhausted, check_bits, check_terms, words};
use super::coefficient::Coefficient;
use super::degrees::Degrees;
use super::monomial::Monomial;
use super::number::Integer;
use super::packing::{Key, Layout};
use super::polynomial::{Polynomial, Term, Terms};

/// Up to so many products of terms are sorted, which is quicker for few.
const MOST_SORTED: usize = 64;

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
        let product = [SignedProduct {
            is_negative: false,
            left: self,
            right: other,
        }];
        match (self.terms(), other.terms()) {
            ([term], _) => paid(&product, budget, |_| other.times_term(term)),
            (_, [term]) => paid(&product, budget, |_| self.times_term(term)),
            _ => Polynomial::sum_of_products(&product, budget),
        }
    }

    /// `Σ ±a·b`, without the single products.
    ///
    /// Takes the steps of all products, and `n·log r` comparisons for the `n` products of terms, where
    /// the shorter factors have `r` terms together.
    ///
    /// # Errors
    ///
    /// [`Exhausted`] as for [`multiply`](Polynomial::multiply).
    pub(super) fn sum_of_products(
        products: &[SignedProduct<&Self, &Self>],
        budget: &Budget,
    ) -> Result<Self, Exhausted> {
        paid(products, budget, |bits| {
            let layout = Layout::new(&degrees(products)?, 0);
            match layout.bits() {
                ..=64 => collect_in::<u64>(products, &layout, bits),
                65..=128 => collect_in::<u128>(products, &layout, bits),
                _ => collect::<Monomial, Integer>(products, &layout),
            }
        })
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

/// A sum of products, made with so many bits as its coefficients may have, for the steps that it takes.
fn paid(
    products: &[SignedProduct<&Polynomial, &Polynomial>],
    budget: &Budget,
    sum: impl FnOnce(usize) -> Result<Polynomial, Exhausted>,
) -> Result<Polynomial, Exhausted> {
    let steps = products
        .iter()
        .map(|product| length(product.left).saturating_mul(length(product.right)));
    budget.spend(steps.fold(0, u64::saturating_add))?;
    let bits = bits(products);
    check_bits(bits)?;
    let sum = sum(bits)?;
    budget.spend(STEPS_FOR_A_TERM * sum.len().saturating_sub(MOST_FREE) as u64)?;
    Ok(sum)
}

/// So many bits have the coefficients of a sum of products at most.
fn bits(products: &[SignedProduct<&Polynomial, &Polynomial>]) -> usize {
    // A term of a product is a sum of at most one product for each term of the shorter factor.
    let summands = products
        .iter()
        .map(|product| product.left.len().min(product.right.len()));
    let longest = products
        .iter()
        .map(|product| widest(product.left) + widest(product.right));
    longest.max().unwrap_or(0) + summands.sum::<usize>().max(1).ilog2() as usize + 1
}

/// Degrees that no term of a sum of products exceeds: quickly found ones if they are not too large, else
/// the least ones.
fn degrees(products: &[SignedProduct<&Polynomial, &Polynomial>]) -> Result<Degrees, Exhausted> {
    let left = Degrees::of_all(products.iter().map(|product| product.left));
    let right = Degrees::of_all(products.iter().map(|product| product.right));
    left.sum(&right).or_else(|_| least_degrees(products))
}

/// The highest degrees of all products.
fn least_degrees(
    products: &[SignedProduct<&Polynomial, &Polynomial>],
) -> Result<Degrees, Exhausted> {
    let mut highest = Degrees::default();
    for product in products {
        highest.raise(&Degrees::of(product.left).sum(&Degrees::of(product.right))?);
    }
    Ok(highest)
}

/// Collects with the narrowest coefficients in which sums of `bits` bits fit.
fn collect_in<K: Key>(
    products: &[SignedProduct<&Polynomial, &Polynomial>],
    layout: &Layout,
    bits: usize,
) -> Result<Polynomial, Exhausted> {
    match bits {
        ..=63 => collect::<K, i64>(products, layout),
        64..=127 => collect::<K, i128>(products, layout),
        _ => collect::<K, Integer>(products, layout),
    }
}

/// Collects a sum of products in the given representation.
fn collect<K: Key, C: Coefficient>(
    products: &[SignedProduct<&Polynomial, &Polynomial>],
    layout: &Layout,
) -> Result<Polynomial, Exhausted> {
    let factors: SmallVec<[_; 4]> = products
        .iter()
        .map(|product| factors::<K, C>(product, layout))
        .collect();
    let mut rows = Vec::with_capacity(factors.iter().map(|(few, _)| few.len()).sum());
    for (few, terms) in &factors {
        rows.extend(few.iter().map(|factor| Row { factor, terms }));
    }
    let sums = gather(&rows)?;
    let mut terms = Terms::with_capacity(sums.len());
    let sums = sums.into_iter().filter(|(_, sum)| !sum.is_zero());
    terms.extend(sums.map(|(key, sum)| (key.decode(layout), sum.into_integer())));
    Ok(Polynomial::from_sorted(terms))
}

/// The terms of a polynomial in a representation.
type Encoded<K, C> = Vec<(K, C)>;

/// The factors of a product in the given representation: first the shorter one, which has the sign.
fn factors<K: Key, C: Coefficient>(
    product: &SignedProduct<&Polynomial, &Polynomial>,
    layout: &Layout,
) -> (Encoded<K, C>, Encoded<K, C>) {
    let (mut few, mut many) = (
        encode::<K, C>(product.left, layout),
        encode(product.right, layout),
    );
    if few.len() > many.len() {
        std::mem::swap(&mut few, &mut many);
    }
    if product.is_negative {
        for (_, coefficient) in &mut few {
            *coefficient = coefficient.negative();
        }
    }
    (few, many)
}

/// The terms of a polynomial in the given representation.
pub(super) fn encode<K: Key, C: Coefficient>(
    polynomial: &Polynomial,
    layout: &Layout,
) -> Vec<(K, C)> {
    let encode =
        |(monomial, coefficient): &Term| Some((K::encode(monomial, layout), C::read(coefficient)?));
    let mut encoded = Vec::with_capacity(polynomial.len());
    encoded.extend(polynomial.terms().iter().filter_map(encode));
    debug_assert_eq!(encoded.len(), polynomial.len());
    encoded
}

/// One term times others, which are by decreasing key; and so are then the products.
struct Row<'a, K, C> {
    factor: &'a (K, C),
    terms: &'a [(K, C)],
}

/// The sums of the products with equal keys, by decreasing key; some may be 0.
///
/// Many products are gathered half of the rows at a time, so that no more than sums are kept.
fn gather<K: Key, C: Coefficient>(rows: &[Row<K, C>]) -> Result<Vec<(K, C)>, Exhausted> {
    let count = rows.iter().map(|row| row.terms.len()).sum();
    if count <= MOST_SORTED || rows.len() == 1 {
        return sorted(rows, count);
    }
    let (first, second) = rows.split_at(rows.len() / 2);
    let sums = merge(&gather(first)?, &gather(second)?);
    check_terms(sums.len())?;
    Ok(sums)
}

/// The same with all products in memory at once.
fn sorted<K: Key, C: Coefficient>(
    rows: &[Row<K, C>],
    count: usize,
) -> Result<Vec<(K, C)>, Exhausted> {
    let mut products = Vec::with_capacity(count);
    for Row { factor, terms } in rows {
        for (key, coefficient) in *terms {
            products.push((factor.0.product(key)?, C::product(&factor.1, coefficient)));
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

/// The terms of both, by decreasing key.
///
/// Which of them comes next cannot be predicted, so there is no branch for it.
fn merge<K: Key, C: Coefficient>(mut left: &[(K, C)], mut right: &[(K, C)]) -> Vec<(K, C)> {
    let mut sums = Vec::with_capacity(left.len() + right.len());
    while let ([first, ..], [second, ..]) = (left, right) {
        let (is_left, is_right) = (first.0 >= second.0, second.0 >= first.0);
        let mut sum = first.1.if_taken(is_left);
        sum.plus(&second.1.if_taken(is_right));
        let key = if is_left { &first.0 } else { &second.0 };
        sums.push((key.clone(), sum));
        (left, right) = (
            &left[usize::from(is_left)..],
            &right[usize::from(is_right)..],
        );
    }
    sums.extend_from_slice(left);
    sums.extend_from_slice(right);
    sums
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
            let factors = [SignedProduct { is_negative: false, left: &left, right: &right }];
            let layout = Layout::new(&degrees(&factors).unwrap(), 0);
            let generic = collect::<Monomial, Integer>(&factors, &layout).unwrap();
            let product = left.multiply(&right, &Budget::unlimited()).unwrap();
            prop_assert_eq!(&product, &generic);
            prop_assert_eq!(&collect::<u128, i64>(&factors, &layout).unwrap(), &generic);
            prop_assert_eq!(&collect::<u128, i128>(&factors, &layout).unwrap(), &generic);
            if layout.bits() <= 64 {
                prop_assert_eq!(&collect::<u64, i64>(&factors, &layout).unwrap(), &generic);
            }
        }

        #[test]
        fn a_sum_of_products_is_the_products_summed(
            factors in prop::collection::vec((any::<bool>(), arbitrary(12, 300, 62), arbitrary(6, 40, 62)), 0..6),
        ) {
            let budget = Budget::unlimited();
            let summed = factors.iter().fold(Polynomial::zero(), |sum, (is_negative, left, right)| {
                let product = left.multiply(right, &budget).unwrap();
                if *is_negative { &sum - &product } else { &sum + &product }
            });
            let products: Vec<_> = factors
                .iter()
                .map(|(is_negative, left, right)| SignedProduct { is_negative: *is_negative, left, right })
                .collect();
            prop_assert_eq!(Polynomial::sum_of_products(&products, &budget).unwrap(), summed);
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
                let factors = [SignedProduct { is_negative: false, left: &left, right: &right }];
                let layout = Layout::new(&degrees(&factors).unwrap(), 0);
                let generic = collect::<Monomial, Integer>(&factors, &layout).unwrap();
                prop_assert_eq!(left.multiply(&right, &Budget::unlimited()).unwrap(), generic);
            }
        }

        #[test]
        fn sorting_and_merging_give_the_same_sums(
            left in arbitrary(20, 2, 20), right in arbitrary(12, 2, 20),
        ) {
            let layout = Layout::new(&Degrees::of(&left).sum(&Degrees::of(&right)).unwrap(), 0);
            let (left, terms) = (encode::<u64, i64>(&left, &layout), encode::<u64, i64>(&right, &layout));
            let rows: Vec<_> = left.iter().map(|factor| Row { factor, terms: &terms }).collect();
            let sorted = sorted(&rows, left.len() * terms.len()).unwrap();
            prop_assert_eq!(gather(&rows).unwrap(), sorted.clone());
            let merged = rows.iter().fold(Vec::new(), |sums, row| {
                merge(&sums, &super::sorted(std::slice::from_ref(row), terms.len()).unwrap())
            });
            prop_assert_eq!(merged, sorted);
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
    fn the_largest_sums_of_several_products_fit() {
        for bits in 28..66 {
            let coefficient = (Integer::ONE << bits) - Integer::ONE;
            let [left, right] = ["a", "-b"].map(|text| polynomial(text).scale(&coefficient));
            let product = SignedProduct {
                is_negative: true,
                left: &left,
                right: &right,
            };
            let sum = Polynomial::sum_of_products(&[product; 3], &Budget::unlimited()).unwrap();
            let expected = &coefficient * &coefficient * Integer::from(3);
            assert_eq!(sum, polynomial("a*b").scale(&expected));
        }
    }

    #[test]
    fn factors_of_different_products_may_have_large_exponents() {
        let [a, high] = ["a", "a^65534"].map(polynomial);
        let product = |left, right| SignedProduct {
            is_negative: false,
            left,
            right,
        };
        let both = [product(&high, &a), product(&a, &high)];
        let sum = Polynomial::sum_of_products(&both, &Budget::unlimited());
        assert_eq!(sum.unwrap(), polynomial("2*a^65535"));
        let refused = Polynomial::sum_of_products(&[product(&high, &high)], &Budget::unlimited());
        assert_eq!(refused.unwrap_err().resource, Resource::Exponent);
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
