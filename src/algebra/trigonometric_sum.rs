//! Sums of sines and cosines of rational angles, exactly.

use std::collections::BTreeMap;

use dashu_base::BitTest;

use super::arithmetic::Arithmetic;
use super::budget::{Budget, Exhausted};
use super::number::Rational;

/// Σ aₖ cos αₖ + bₖ sin αₖ with rational numbers aₖ, bₖ and rational angles αₖ ≥ 0, in radians.
///
/// Equal numbers have equal representations: by the theorem of Lindemann and Weierstrass 1 and the sines
/// and cosines of different positive rational angles are linearly independent over the rationals. So such
/// a number is 0 exactly where it has no term, which no enclosure could tell.
///
/// ```
/// use sextic::algebra::arithmetic::Arithmetic;
/// use sextic::algebra::budget::Budget;
/// use sextic::algebra::number::Rational;
/// use sextic::algebra::trigonometric_sum::{TrigonometricSum, TrigonometricSums};
///
/// let sums = TrigonometricSums::new(Budget::new(100));
/// let third = Rational::from(1) / Rational::from(3);
/// let (cos, sin) = (TrigonometricSum::cosine(&third), TrigonometricSum::sine(&third));
/// let one = sums.sum(&sums.product(&cos, &cos)?, &sums.product(&sin, &sin)?)?;
/// assert_eq!(one, sums.one());
/// # Ok::<(), sextic::algebra::budget::Exhausted>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TrigonometricSum {
    /// αₖ, and aₖ and bₖ, not both 0; bₖ = 0 at αₖ = 0.
    terms: BTreeMap<Rational, [Rational; 2]>,
}

impl TrigonometricSum {
    /// cos α
    pub fn cosine(angle: &Rational) -> Self {
        let mut sum = TrigonometricSum::default();
        sum.add(angle.clone(), [Rational::ONE, Rational::ZERO]);
        sum
    }

    /// sin α
    pub fn sine(angle: &Rational) -> Self {
        let mut sum = TrigonometricSum::default();
        sum.add(angle.clone(), [Rational::ZERO, Rational::ONE]);
        sum
    }

    /// αₖ with aₖ and bₖ, the angles increasing.
    pub fn terms(&self) -> impl Iterator<Item = (&Rational, &[Rational; 2])> {
        self.terms.iter()
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Its product with a rational number.
    pub fn scaled(&self, factor: &Rational) -> Self {
        let mut sum = TrigonometricSum::default();
        for (angle, [a, b]) in &self.terms {
            sum.add(angle.clone(), [a * factor, b * factor]);
        }
        sum
    }

    /// The machine words of all its numbers, about.
    fn words(&self) -> u64 {
        let bits = |own: &Rational| own.numerator().bit_len() + own.denominator().bit_len();
        let words = |[a, b]: &[Rational; 2]| 1 + (bits(a) + bits(b)) as u64 / 128;
        self.terms.values().map(words).sum()
    }

    /// Adds a cos α + b sin α.
    fn add(&mut self, angle: Rational, [a, b]: [Rational; 2]) {
        let (angle, b) = match angle.partial_cmp(&Rational::ZERO) {
            Some(std::cmp::Ordering::Less) => (-angle, -b),
            Some(std::cmp::Ordering::Equal) => (angle, Rational::ZERO),
            _ => (angle, b),
        };
        let [x, y] = self.terms.remove(&angle).unwrap_or_default();
        let sum = [x + a, y + b];
        if sum.iter().any(|own| !own.is_zero()) {
            self.terms.insert(angle, sum);
        }
    }
}

impl From<Rational> for TrigonometricSum {
    fn from(number: Rational) -> Self {
        let mut sum = TrigonometricSum::default();
        sum.add(Rational::ZERO, [number, Rational::ZERO]);
        sum
    }
}

/// The ring of [`TrigonometricSum`]s; a product costs a step for each pair of machine words.
#[derive(Clone, Debug)]
pub struct TrigonometricSums {
    budget: Budget,
}

impl TrigonometricSums {
    /// The ring, with a supply of steps.
    pub fn new(budget: Budget) -> Self {
        TrigonometricSums { budget }
    }
}

impl Arithmetic for TrigonometricSums {
    type Element = TrigonometricSum;
    type Error = Exhausted;

    fn zero(&self) -> TrigonometricSum {
        TrigonometricSum::default()
    }

    fn one(&self) -> TrigonometricSum {
        TrigonometricSum::from(Rational::ONE)
    }

    fn is_zero(&self, a: &TrigonometricSum) -> bool {
        a.is_zero()
    }

    fn sum(
        &self,
        a: &TrigonometricSum,
        b: &TrigonometricSum,
    ) -> Result<TrigonometricSum, Exhausted> {
        let (mut sum, other) = if a.terms.len() < b.terms.len() {
            (b.clone(), a)
        } else {
            (a.clone(), b)
        };
        for (angle, factors) in &other.terms {
            sum.add(angle.clone(), factors.clone());
        }
        Ok(sum)
    }

    fn negative(&self, a: &TrigonometricSum) -> TrigonometricSum {
        let negative = |(angle, [a, b]): (&Rational, &[Rational; 2])| (angle.clone(), [-a, -b]);
        TrigonometricSum {
            terms: a.terms.iter().map(negative).collect(),
        }
    }

    fn product(
        &self,
        one: &TrigonometricSum,
        other: &TrigonometricSum,
    ) -> Result<TrigonometricSum, Exhausted> {
        self.budget.spend(one.words() * other.words())?;
        let half = Rational::ONE / Rational::from(2);
        let mut product = TrigonometricSum::default();
        for (alpha, [cosine, sine]) in &one.terms {
            let (a, b) = (cosine * &half, sine * &half);
            for (beta, [c, d]) in &other.terms {
                // (a cos α + b sin α)(c cos β + d sin β), by the sum and the difference of the angles.
                let (ac, bd, ad, bc) = (&a * c, &b * d, &a * d, &b * c);
                product.add(alpha + beta, [&ac - &bd, &ad + &bc]);
                product.add(alpha - beta, [ac + bd, bc - ad]);
            }
        }
        Ok(product)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::interval::{Intervals, KnownSign};
    use crate::algebra::univariate::Univariate;
    use proptest::prelude::*;

    fn sum() -> impl Strategy<Value = TrigonometricSum> {
        prop::collection::vec((-3_i64..4, -3_i64..4, -2_i64..3), 0..4).prop_map(|terms| {
            let mut sum = TrigonometricSum::default();
            for (angle, a, b) in terms {
                let angle = Rational::from(angle) / Rational::from(2);
                sum.add(angle, [Rational::from(a), Rational::from(b)]);
            }
            sum
        })
    }

    fn sums() -> TrigonometricSums {
        TrigonometricSums::new(Budget::new(1_000_000))
    }

    #[test]
    fn a_product_costs_a_step_for_each_pair_of_words() {
        let term = |angle: u32| TrigonometricSum::sine(&Rational::from(angle));
        let all = |angles: std::ops::Range<u32>| {
            let plus = |a: TrigonometricSum, b| sums().sum(&a, &b).expect("short");
            angles.map(term).fold(TrigonometricSum::default(), plus)
        };
        let (three, four) = (all(1..4), all(1..5));
        let product = |steps| TrigonometricSums::new(Budget::new(steps)).product(&three, &four);
        assert!(product(12).is_ok());
        assert!(product(11).is_err());
        // 2⁵⁰⁰ has four words.
        let long = Rational::from(dashu_int::IBig::ONE << 500_usize);
        let long = TrigonometricSum::sine(&Rational::ONE).scaled(&long);
        let product = |steps| TrigonometricSums::new(Budget::new(steps)).product(&three, &long);
        assert!(product(12).is_ok());
        assert!(product(11).is_err());
    }

    proptest! {
        #[test]
        fn sums_of_sines_are_a_ring(a in sum(), b in sum(), c in sum()) {
            let ring = sums();
            let times = |a: &_, b: &_| ring.product(a, b).expect("short");
            let plus = |a: &_, b: &_| ring.sum(a, b).expect("short");
            prop_assert_eq!(times(&a, &b), times(&b, &a));
            prop_assert_eq!(times(&times(&a, &b), &c), times(&a, &times(&b, &c)));
            prop_assert_eq!(times(&a, &plus(&b, &c)), plus(&times(&a, &b), &times(&a, &c)));
            prop_assert!(plus(&a, &ring.negative(&a)).is_zero());
            prop_assert_eq!(times(&a, &ring.one()), a.clone());
            // No zero divisors, and what is not 0 is told from it by its digits.
            prop_assert_eq!(times(&a, &b).is_zero(), a.is_zero() || b.is_zero());
            let sign = Intervals::new(200).enclosure(&a).sign();
            prop_assert_eq!(a.is_zero(), sign == KnownSign::Zero);
            prop_assert!(sign != KnownSign::Unknown);
        }

        #[test]
        fn a_sum_has_the_value_of_its_terms(terms in prop::collection::vec((-9_i64..9, -3_i64..4, -3_i64..4), 0..6)) {
            let intervals = Intervals::new(100);
            let (mut sum, mut value) = (TrigonometricSum::default(), intervals.zero());
            for (angle, a, b) in terms {
                let [angle, a, b] = [angle, a, b].map(Rational::from);
                let circle = intervals.cosine_and_sine(&angle);
                for (factor, part) in [&a, &b].into_iter().zip(&circle) {
                    let Ok(term) = intervals.product(&intervals.rational(factor), part);
                    let Ok(total) = intervals.sum(&value, &term);
                    value = total;
                }
                sum.add(angle, [a, b]);
            }
            let difference = intervals.enclosure(&sum).compared(&value);
            prop_assert!(matches!(difference, KnownSign::Zero | KnownSign::Unknown));
        }

        #[test]
        fn products_are_those_of_their_values(a in sum(), b in sum()) {
            let (ring, intervals) = (sums(), Intervals::new(100));
            let product = intervals.enclosure(&ring.product(&a, &b).expect("short"));
            let Ok(expected) = intervals.product(&intervals.enclosure(&a), &intervals.enclosure(&b));
            prop_assert!(!matches!(product.compared(&expected), KnownSign::Positive | KnownSign::Negative));
        }

        #[test]
        fn a_pseudo_quotient_gives_the_dividend_back(a in prop::collection::vec(sum(), 0..5), b in prop::collection::vec(sum(), 1..4)) {
            let ring = sums();
            let polynomials = Univariate(&ring);
            let (a, b) = (polynomials.polynomial(a), polynomials.polynomial(b));
            prop_assume!(!b.is_empty());
            let (quotient, rest) = polynomials.pseudo_division(&a, &b).expect("short");
            prop_assert!(rest.len() < b.len());
            let product = polynomials.product(&quotient, &b).expect("short");
            let sum = polynomials.sum(&product, &rest).expect("short");
            // lᵏ a for some even k
            let square = polynomials.product(&vec![b[b.len() - 1].clone()], &vec![b[b.len() - 1].clone()]).expect("short");
            let mut multiple = a;
            let is_one = (0..=4).any(|_| {
                let is_equal = multiple == sum;
                multiple = polynomials.product(&multiple, &square).expect("short");
                is_equal
            });
            prop_assert!(is_one);
        }
    }
}
