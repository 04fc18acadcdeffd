//! Enclosures of real numbers: intervals between dyadic fractions.

use std::convert::Infallible;

use dashu_base::{BitTest, DivEuclid, RemEuclid, SquareRoot, UnsignedAbs};

use super::arithmetic::Arithmetic;
use super::number::{Integer, Rational};
use super::trigonometric_sum::TrigonometricSum;

/// All numbers from `low` to `high`, both in units of 2⁻ᵇ with the b of the [`Intervals`] it belongs to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    low: Integer,
    high: Integer,
}

/// What is known of the sign of an enclosed number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KnownSign {
    /// It is below 0.
    Negative,
    /// It is 0.
    Zero,
    /// It is above 0.
    Positive,
    /// The interval holds 0 and other numbers.
    Unknown,
}

impl Interval {
    /// What is known of the sign.
    pub fn sign(&self) -> KnownSign {
        if self.low > Integer::ZERO {
            KnownSign::Positive
        } else if self.high < Integer::ZERO {
            KnownSign::Negative
        } else if self.low.is_zero() && self.high.is_zero() {
            KnownSign::Zero
        } else {
            KnownSign::Unknown
        }
    }

    /// What is known of the sign of the difference to another one.
    pub fn compared(&self, other: &Interval) -> KnownSign {
        Interval {
            low: &self.low - &other.high,
            high: &self.high - &other.low,
        }
        .sign()
    }

    /// All numbers from the least to the largest of two intervals.
    #[must_use]
    pub fn hull(&self, other: &Interval) -> Interval {
        Interval {
            low: (&self.low).min(&other.low).clone(),
            high: (&self.high).max(&other.high).clone(),
        }
    }

    /// The middle of two intervals: half the sum.
    #[must_use]
    pub fn middle(&self, other: &Interval) -> Interval {
        Interval {
            low: (&self.low + &other.low) >> 1,
            high: -(-(&self.high + &other.high) >> 1),
        }
    }
}

/// Interval arithmetic with so many binary digits behind the point: outward rounding to multiples of
/// 2⁻ᵇ, and no rounding of sums.
///
/// ```
/// use sextic::algebra::interval::{Intervals, KnownSign};
/// use sextic::algebra::number::Rational;
/// use sextic::algebra::trigonometric_sum::TrigonometricSum;
///
/// let intervals = Intervals::new(128);
/// // sin 22 is negative, 22 being a little less than 7π.
/// let sine = TrigonometricSum::sine(&Rational::from(22));
/// assert_eq!(intervals.enclosure(&sine).sign(), KnownSign::Negative);
/// let [low, _] = intervals.bounds(&intervals.enclosure(&sine));
/// assert!(low > Rational::from(-1) / Rational::from(100));
/// ```
#[derive(Clone, Debug)]
pub struct Intervals {
    bits: usize,
}

impl Intervals {
    /// Arithmetic with so many binary digits.
    pub fn new(bits: usize) -> Self {
        Intervals { bits }
    }

    /// The number of binary digits behind the point.
    pub fn bits(&self) -> usize {
        self.bits
    }

    /// The least interval around a number.
    pub fn rational(&self, number: &Rational) -> Interval {
        let scaled = number.numerator() << self.bits;
        let below = Integer::from(number.denominator().clone());
        Interval {
            low: (&scaled).div_euclid(&below),
            high: -(-scaled).div_euclid(&below),
        }
    }

    /// The bounds of an interval.
    pub fn bounds(&self, own: &Interval) -> [Rational; 2] {
        let unit = Rational::from(Integer::ONE << self.bits);
        [&own.low, &own.high].map(|bound| Rational::from(bound.clone()) / &unit)
    }

    /// An interval around a sum of sines and cosines.
    ///
    /// Linear in the number of its terms; each costs about b/5 products of b digits.
    pub fn enclosure(&self, sum: &TrigonometricSum) -> Interval {
        let mut enclosure = self.zero();
        for (angle, [a, b]) in sum.terms() {
            if angle.is_zero() {
                enclosure = self.plus(&enclosure, &self.rational(a));
                continue;
            }
            let [cosine, sine] = self.cosine_and_sine(angle);
            for (factor, value) in [(a, cosine), (b, sine)] {
                let term = self.times(&self.rational(factor), &value);
                enclosure = self.plus(&enclosure, &term);
            }
        }
        enclosure
    }

    /// Intervals around cos α and sin α of an angle in radians.
    ///
    /// With k the integer nearest to 2α/π and β = α − kπ/2, a quarter turn k times from cos β and sin β.
    pub fn cosine_and_sine(&self, angle: &Rational) -> [Interval; 2] {
        // kπ/2 has as many digits before the point as the angle, and is to be as exact as it behind.
        let whole = angle
            .numerator()
            .bit_len()
            .saturating_sub(angle.denominator().bit_len());
        let fine = Intervals::new(self.bits + whole + 16);
        let (alpha, quarter) = (fine.rational(angle), fine.quarter_turn());
        let half = &quarter.low >> 1;
        let turns = (&alpha.low + half).div_euclid(&quarter.low);
        let turned = fine.plus(
            &alpha,
            &fine.negative(&fine.times(&fine.rational(&turns.clone().into()), &quarter)),
        );
        let [cosine, sine] = fine.series(&turned);
        let minus = |own: &Interval| fine.negative(own);
        let [cosine, sine] = match u8::try_from(turns.rem_euclid(Integer::from(4))) {
            Ok(0) => [cosine, sine],
            Ok(1) => [minus(&sine), cosine],
            Ok(2) => [minus(&cosine), minus(&sine)],
            _ => [sine, minus(&cosine)],
        };
        [cosine, sine].map(|own| self.rounded(&own, &fine))
    }

    /// π/2 = 8 arctan(1/5) − 2 arctan(1/239), by Machin.
    pub fn quarter_turn(&self) -> Interval {
        let [fifth, other] = [5_u32, 239].map(|inverse| self.arctangent(inverse));
        Interval {
            low: (fifth.low << 3) - (other.high << 1),
            high: (fifth.high << 3) - (other.low << 1),
        }
    }

    /// arctan(1/n) = Σ (−1)ᵏ/((2k + 1) n²ᵏ⁺¹)
    fn arctangent(&self, inverse: u32) -> Interval {
        let square = Integer::from(inverse) * Integer::from(inverse);
        let mut power = (Integer::ONE << self.bits) / Integer::from(inverse);
        let (mut sum, mut odd, mut is_added) = (Integer::ZERO, 1_u32, true);
        while !power.is_zero() {
            let term = &power / Integer::from(odd);
            sum = if is_added { sum + term } else { sum - term };
            (power, odd, is_added) = (power / &square, odd + 2, !is_added);
        }
        // A term loses less than a unit to the division of its power, whose error it divides, and one to its
        // own; what is left out is less than a unit.
        around(&sum, &Integer::from(odd + 1))
    }

    /// cos β and sin β for |β| < 1, by Taylor series about 0 at the lower bound of β.
    fn series(&self, beta: &Interval) -> [Interval; 2] {
        let mut sums = [Integer::ZERO, Integer::ZERO];
        let (mut term, mut power) = (Integer::ONE << self.bits, 0_u32);
        // Rounding down makes a negative term end at −1.
        while term > Integer::ONE || term < Integer::NEG_ONE {
            let place = (power % 2) as usize;
            if power % 4 < 2 {
                sums[place] += &term;
            } else {
                sums[place] -= &term;
            }
            power += 1;
            term = ((term * &beta.low) >> self.bits).div_euclid(Integer::from(power));
        }
        // Each term is off by less than 4 units: (4|β| + 1)/k + 1 where that before it is; the rest of an
        // alternating series is less than its first term, and slopes are at most 1.
        let error = Integer::from(4 * power + 8) + (&beta.high - &beta.low);
        sums.map(|sum| around(&sum, &error))
    }

    /// a/b; `None` if b may be 0.
    ///
    /// ```
    /// use sextic::algebra::interval::Intervals;
    /// use sextic::algebra::number::Rational;
    ///
    /// let intervals = Intervals::new(64);
    /// let [one, three] = [1, 3].map(|own| intervals.rational(&Rational::from(own)));
    /// let third = intervals.quotient(&one, &three).unwrap();
    /// let [low, high] = intervals.bounds(&third);
    /// assert!(low < Rational::from(1) / Rational::from(3) && Rational::from(1) / Rational::from(3) < high);
    /// assert!(intervals.quotient(&one, &intervals.rational(&Rational::ZERO)).is_none());
    /// ```
    pub fn quotient(&self, a: &Interval, b: &Interval) -> Option<Interval> {
        let (a, b) = match b.sign() {
            KnownSign::Positive => (a.clone(), b.clone()),
            KnownSign::Negative => (self.negative(a), self.negative(b)),
            KnownSign::Zero | KnownSign::Unknown => return None,
        };
        // The least quotient of a number above 0 has the largest divisor, that of one below 0 the least.
        let least = if a.low < Integer::ZERO {
            &b.low
        } else {
            &b.high
        };
        let largest = if a.high < Integer::ZERO {
            &b.high
        } else {
            &b.low
        };
        Some(Interval {
            low: (&a.low << self.bits).div_euclid(least),
            high: -(-(&a.high << self.bits)).div_euclid(largest),
        })
    }

    /// √a; `None` if a may be below 0.
    ///
    /// ```
    /// use sextic::algebra::interval::Intervals;
    /// use sextic::algebra::number::Rational;
    ///
    /// let intervals = Intervals::new(64);
    /// let root = intervals.square_root(&intervals.rational(&Rational::from(2))).unwrap();
    /// let [low, high] = intervals.bounds(&root);
    /// assert!(&low * &low <= Rational::from(2) && Rational::from(2) <= &high * &high);
    /// assert!(intervals.square_root(&intervals.rational(&Rational::from(-2))).is_none());
    /// ```
    pub fn square_root(&self, a: &Interval) -> Option<Interval> {
        if a.low < Integer::ZERO {
            return None;
        }
        let root = |own: &Integer| Integer::from((own << self.bits).unsigned_abs().sqrt());
        let (low, high) = (root(&a.low), root(&a.high));
        let is_exact = &high * &high == &a.high << self.bits;
        let high = if is_exact { high } else { high + Integer::ONE };
        Some(Interval { low, high })
    }

    /// An interval of finer arithmetic, rounded outwards.
    fn rounded(&self, own: &Interval, finer: &Intervals) -> Interval {
        let digits = finer.bits - self.bits;
        Interval {
            low: &own.low >> digits,
            high: -(-&own.high >> digits),
        }
    }

    fn plus(&self, a: &Interval, b: &Interval) -> Interval {
        Interval {
            low: &a.low + &b.low,
            high: &a.high + &b.high,
        }
    }

    fn times(&self, a: &Interval, b: &Interval) -> Interval {
        let products = [
            &a.low * &b.low,
            &a.low * &b.high,
            &a.high * &b.low,
            &a.high * &b.high,
        ];
        let [mut low, mut high] = [&products[0], &products[0]];
        for product in &products[1..] {
            low = low.min(product);
            high = high.max(product);
        }
        Interval {
            low: low >> self.bits,
            high: -(-high >> self.bits),
        }
    }
}

/// All numbers at most so far from another one.
fn around(centre: &Integer, radius: &Integer) -> Interval {
    Interval {
        low: centre - radius,
        high: centre + radius,
    }
}

impl Arithmetic for Intervals {
    type Element = Interval;
    type Error = Infallible;

    fn zero(&self) -> Interval {
        around(&Integer::ZERO, &Integer::ZERO)
    }

    fn one(&self) -> Interval {
        around(&(Integer::ONE << self.bits), &Integer::ZERO)
    }

    /// Whether it holds nothing but 0.
    fn is_zero(&self, a: &Interval) -> bool {
        a.sign() == KnownSign::Zero
    }

    fn sum(&self, a: &Interval, b: &Interval) -> Result<Interval, Infallible> {
        Ok(self.plus(a, b))
    }

    fn negative(&self, a: &Interval) -> Interval {
        Interval {
            low: -&a.high,
            high: -&a.low,
        }
    }

    fn product(&self, a: &Interval, b: &Interval) -> Result<Interval, Infallible> {
        Ok(self.times(a, b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rational(above: i64, below: i64) -> Rational {
        Rational::from(above) / Rational::from(below)
    }

    fn number() -> impl Strategy<Value = Rational> {
        (-10_000_i64..10_000, 1_i64..1000).prop_map(|(above, below)| rational(above, below))
    }

    fn holds(intervals: &Intervals, own: &Interval, number: &Rational) -> bool {
        let [low, high] = intervals.bounds(own);
        &low <= number && number <= &high
    }

    proptest! {
        #[test]
        fn sums_and_products_of_rationals_are_enclosed(a in number(), b in number(), c in number(), bits in 4_usize..200) {
            let intervals = Intervals::new(bits);
            let [x, y, z] = [&a, &b, &c].map(|own| intervals.rational(own));
            let own = intervals.times(&intervals.plus(&intervals.times(&x, &y), &intervals.negative(&z)), &x);
            let exact = (&a * &b - &c) * &a;
            prop_assert!(holds(&intervals, &own, &exact));
            prop_assert_eq!(intervals.one(), intervals.rational(&Rational::ONE));
            prop_assert!(intervals.is_zero(&intervals.zero()) && !intervals.is_zero(&intervals.one()));
            prop_assert_eq!(intervals.is_zero(&x), a.is_zero());
            let half = rational(1, 2) * (&a + &b);
            prop_assert!(holds(&intervals, &x.middle(&y), &half));
        }

        #[test]
        fn quotients_and_roots_are_enclosed(a in number(), b in number(), width in 0_i64..50, bits in 8_usize..200) {
            let intervals = Intervals::new(bits);
            let wide = intervals.rational(&b).hull(&intervals.rational(&(&b + rational(width, 10))));
            let dividend = intervals.rational(&a).hull(&intervals.rational(&(&a - rational(width, 7))));
            match intervals.quotient(&dividend, &wide) {
                Some(own) => {
                    let ends = [&b, &(&b + rational(width, 10))].map(|below| [&a / below, (&a - rational(width, 7)) / below]);
                    for end in ends.as_flattened() {
                        prop_assert!(holds(&intervals, &own, end));
                    }
                    let [low, high] = intervals.bounds(&own);
                    let least = ends.as_flattened().iter().min().unwrap();
                    prop_assert!(width > 0 || least - low < rational(1, 100) * (rational(1, 1) + &a * &a) && high >= *least || bits < 60);
                }
                None => prop_assert!(wide.sign() == KnownSign::Unknown || b.is_zero()),
            }
            match intervals.square_root(&dividend) {
                Some(own) => {
                    let [low, high] = intervals.bounds(&own);
                    prop_assert!(&low * &low <= &a - rational(width, 7) && a <= &high * &high);
                }
                None => prop_assert!(&a - rational(width, 7) < rational(1, 1)),
            }
        }

        #[test]
        fn sines_of_more_digits_lie_within_those_of_fewer(angle in number(), factor in prop_oneof![Just(1_i64), Just(1_000_000_007)], bits in 8_usize..80) {
            let angle = angle * Rational::from(factor);
            let (few, many) = (Intervals::new(bits), Intervals::new(400));
            for (own, better) in few.cosine_and_sine(&angle).iter().zip(&many.cosine_and_sine(&angle)) {
                let ([low, high], [lower, upper]) = (few.bounds(own), many.bounds(better));
                prop_assert!(low <= lower && upper <= high && lower <= upper);
                // Two units of each.
                prop_assert!(high - low <= rational(2, 1) / Rational::from(Integer::ONE << bits));
                prop_assert!(upper - lower <= rational(2, 1) / Rational::from(Integer::ONE << 400_usize));
            }
        }

        #[test]
        fn squares_of_sines_and_cosines_sum_to_one(angle in number()) {
            let intervals = Intervals::new(100);
            let [cosine, sine] = intervals.cosine_and_sine(&angle);
            let one = intervals.plus(&intervals.times(&cosine, &cosine), &intervals.times(&sine, &sine));
            prop_assert!(holds(&intervals, &one, &Rational::ONE));
        }
    }

    #[test]
    fn sines_are_those_of_a_table() {
        // 60 digits by mpmath: cos and sin of 1, 22, 1/3 and 10²².
        for (angle, cosine, sine) in [
            (
                "1",
                "0.540302305868139717400936607442976603732310420617922227670097",
                "0.841470984807896506652502321630298999622563060798371065672752",
            ),
            (
                "22",
                "-0.999960826394637126454174739212693774135988467479419293059382",
                "-0.00885130929040387592169025681577233246328920395133256644233084",
            ),
            (
                "1/3",
                "0.944956946314737664388284007675880607845852699565140737677646",
                "0.327194696796152244173344085267620606064301406893759791590056",
            ),
            (
                "10000000000000000000000",
                "0.523214785395138945497594473384709492140919972439387953527211",
                "-0.852200849767188801772705893753029368261762150410043656256509",
            ),
        ] {
            let read = |text: &str| -> Rational { text.parse().expect("a fraction") };
            let decimal = |text: &str| {
                let digits: Integer = text.replace('.', "").parse().expect("digits");
                let places = text.len() - text.find('.').expect("a point") - 1;
                Rational::from(digits) / Rational::from(Integer::from(10).pow(places))
            };
            let intervals = Intervals::new(180);
            for (own, expected) in intervals
                .cosine_and_sine(&read(angle))
                .iter()
                .zip([cosine, sine])
            {
                let [low, high] = intervals.bounds(own);
                let unit = Rational::ONE / Rational::from(Integer::from(10).pow(54));
                let expected = decimal(expected);
                assert!(
                    low > &expected - &unit && high < &expected + &unit,
                    "{angle}"
                );
            }
        }
    }
}
