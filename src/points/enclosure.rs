//! Enclosures of real numbers, with as many binary digits wherever the point stands.

use std::cmp::Ordering;

use dashu_base::{Abs, BitTest, Signed, SquareRoot, UnsignedAbs};

use crate::algebra::interval::Intervals;
use crate::algebra::number::{Integer, Rational};

/// How many binary digits a bound has.
pub const DIGITS: usize = 256;

/// Behind which power of 2 the sine of an enclosed angle is not looked for.
const LARGEST_ANGLE: i64 = 512;

/// How often an angle is halved before its arctangent is summed.
const HALVINGS: u32 = 12;

/// All numbers from low·2ᵉ to high·2ᵉ.
#[derive(Clone, Debug)]
pub struct Enclosure {
    low: Integer,
    high: Integer,
    exponent: i64,
}

/// a/2ⁿ, rounded down.
fn lowered(a: &Integer, places: usize) -> Integer {
    a >> places
}

/// a/2ⁿ, rounded up.
fn raised(a: &Integer, places: usize) -> Integer {
    -((-a) >> places)
}

/// How a·2ᵉ and b·2ᶠ compare.
fn compared((a, e): (&Integer, i64), (b, f): (&Integer, i64)) -> Ordering {
    let height = |a: &Integer, exponent: i64| match a.cmp(&Integer::ZERO) {
        Ordering::Less => (-1, -(exponent + a.bit_len() as i64)),
        Ordering::Equal => (0, 0),
        Ordering::Greater => (1, exponent + a.bit_len() as i64),
    };
    let finest = e.min(f);
    let units = |a: &Integer, exponent: i64| a << (exponent - finest) as usize;
    // Numbers of one height are shifted by no more than the digits of one of them.
    let heights = height(a, e).cmp(&height(b, f));
    heights.then_with(|| units(a, e).cmp(&units(b, f)))
}

impl Enclosure {
    /// The bounds with at most [`DIGITS`] digits, rounded outwards.
    fn new(low: Integer, high: Integer, exponent: i64) -> Self {
        let excess = low.bit_len().max(high.bit_len()).saturating_sub(DIGITS);
        if excess == 0 {
            return Enclosure {
                low,
                high,
                exponent,
            };
        }
        Enclosure {
            low: lowered(&low, excess),
            high: raised(&high, excess),
            exponent: exponent + excess as i64,
        }
    }

    /// The bounds in units of another power of 2, rounded outwards.
    fn in_units(&self, exponent: i64) -> (Integer, Integer) {
        match usize::try_from(self.exponent - exponent) {
            Ok(places) => (&self.low << places, &self.high << places),
            Err(_) => {
                let places = (exponent - self.exponent).unsigned_abs().min(1 << 30) as usize;
                (lowered(&self.low, places), raised(&self.high, places))
            }
        }
    }

    /// The position of the highest digit; far below everything for 0.
    fn magnitude(&self) -> i64 {
        match self.low.bit_len().max(self.high.bit_len()) {
            0 => i64::MIN / 4,
            digits => self.exponent + digits as i64,
        }
    }

    /// Whether its numbers are too large or too small to be worked with.
    pub fn is_extreme(&self) -> bool {
        const LARGEST: i64 = 1 << 20;
        let is_zero = self.low.is_zero() && self.high.is_zero();
        !is_zero && (self.exponent.abs() > LARGEST || self.magnitude() > LARGEST)
    }

    /// Whether every number in it is above 0.
    pub fn is_positive(&self) -> bool {
        self.low > Integer::ZERO
    }

    /// Whether every number in it is below 0.
    pub fn is_negative(&self) -> bool {
        self.high < Integer::ZERO
    }

    /// Whether every number in it is below every number in another one.
    pub fn is_below(&self, other: &Self) -> bool {
        compared((&self.high, self.exponent), (&other.low, other.exponent)).is_lt()
    }

    /// Whether the two have a number in common.
    pub fn meets(&self, other: &Self) -> bool {
        !self.is_below(other) && !other.is_below(self)
    }

    /// Whether every number in it is in another one.
    pub fn is_within(&self, other: &Self) -> bool {
        let bound = |bound, own: &Self| (bound, own.exponent);
        compared((&other.low, other.exponent), bound(&self.low, self)).is_le()
            && compared(bound(&self.high, self), (&other.high, other.exponent)).is_le()
    }

    /// All numbers in the two and between them.
    pub fn joined(&self, other: &Self) -> Self {
        let exponent = self.exponent.min(other.exponent);
        let ((low, high), (least, most)) = (self.in_units(exponent), other.in_units(exponent));
        Enclosure::new(low.min(least), high.max(most), exponent)
    }

    /// Whether it is narrow: by `digits` binary digits smaller than another number, or than 1.
    pub fn is_narrow(&self, beside: &Self, digits: i64) -> bool {
        let width = Enclosure::new(Integer::ZERO, &self.high - &self.low, self.exponent);
        width.magnitude() <= beside.magnitude().max(0) - digits
    }

    /// −a
    pub fn negative(&self) -> Self {
        Enclosure {
            low: -&self.high,
            high: -&self.low,
            exponent: self.exponent,
        }
    }

    /// a + b
    pub fn sum(&self, other: &Self) -> Self {
        let digits = 2 * DIGITS as i64;
        let finest = self.exponent.min(other.exponent);
        let coarsest = self.magnitude().max(other.magnitude()) - digits;
        let exponent = finest.max(coarsest);
        let ((low, high), (more, most)) = (self.in_units(exponent), other.in_units(exponent));
        Enclosure::new(low + more, high + most, exponent)
    }

    /// a·b
    pub fn product(&self, other: &Self) -> Self {
        let exponent = self.exponent + other.exponent;
        if self.low >= Integer::ZERO && other.low >= Integer::ZERO {
            return Enclosure::new(&self.low * &other.low, &self.high * &other.high, exponent);
        }
        let products = [
            &self.low * &other.low,
            &self.low * &other.high,
            &self.high * &other.low,
            &self.high * &other.high,
        ];
        let low = products.iter().min().cloned().unwrap_or_default();
        let high = products.into_iter().max().unwrap_or_default();
        Enclosure::new(low, high, exponent)
    }

    /// 1/a; nothing where 0 is in a.
    pub fn reciprocal(&self) -> Option<Self> {
        if self.is_negative() {
            return Some(self.negative().reciprocal()?.negative());
        }
        if !self.is_positive() {
            return None;
        }
        let places = DIGITS + self.high.bit_len();
        let one = Integer::ONE << places;
        let (below, above) = (
            &one / &self.high,
            (one - Integer::ONE) / &self.low + Integer::ONE,
        );
        Some(Enclosure::new(below, above, -self.exponent - places as i64))
    }

    /// √a; nothing where a number below 0 is in a.
    pub fn square_root(&self) -> Option<Self> {
        if self.low < Integer::ZERO {
            return None;
        }
        let mut places = (2 * DIGITS).saturating_sub(self.high.bit_len());
        if (self.exponent - places as i64) % 2 != 0 {
            places += 1;
        }
        let (low, high) = (&self.low << places, &self.high << places);
        let (low, root) = (low.unsigned_abs().sqrt(), (&high).unsigned_abs().sqrt());
        let is_exact = Integer::from(&root * &root) == high;
        let high = Integer::from(root) + Integer::from(u8::from(!is_exact));
        let exponent = (self.exponent - places as i64) / 2;
        Some(Enclosure::new(low.into(), high, exponent))
    }

    /// The number in the middle.
    pub fn middle(&self) -> Rational {
        let twice = Rational::from(&self.low + &self.high);
        let unit = Rational::from(Integer::ONE << self.exponent.unsigned_abs() as usize);
        let half = twice / Rational::from(2);
        match self.exponent < 0 {
            true => half / unit,
            false => half * unit,
        }
    }

    /// What is between two numbers with so many binary digits behind the point.
    fn of_bounds([low, high]: [Rational; 2]) -> Self {
        let sum = Enclosure::from(&low);
        let other = Enclosure::from(&high);
        let exponent = sum.exponent.min(other.exponent);
        let ((low, _), (_, high)) = (sum.in_units(exponent), other.in_units(exponent));
        Enclosure::new(low, high, exponent)
    }

    /// (cos a, sin a); nothing for an angle that is too large or not known well.
    pub fn cosine_and_sine(&self) -> Option<(Self, Self)> {
        let width = Enclosure::new(Integer::ZERO, &self.high - &self.low, self.exponent);
        if self.magnitude() > LARGEST_ANGLE || width.magnitude() > 0 {
            return None;
        }
        // Sines and cosines change no faster than their angle.
        let spread = Enclosure {
            low: -width.high.clone(),
            ..width
        };
        let (cosine, sine) = circle_point(&self.middle());
        Some((cosine.sum(&spread), sine.sum(&spread)))
    }

    /// arctan a, which grows with a by its slope 1/(1 + a²) ≤ 1.
    fn arctangent(&self) -> Option<Self> {
        let one = Enclosure::from(&Rational::ONE);
        let slope = one.sum(&self.product(self)).reciprocal().unwrap_or(one);
        let low = Enclosure::new(self.low.clone(), self.low.clone(), self.exponent);
        let width = Enclosure::new(Integer::ZERO, &self.high - &self.low, self.exponent);
        Some(low.arctangent_of_point()?.sum(&width.product(&slope)))
    }

    /// arctan a for a single number, by tan(β/2) = tan β/(1 + √(1 + tan²β)) and Σ (−1)ᵏ t²ᵏ⁺¹/(2k + 1).
    fn arctangent_of_point(&self) -> Option<Self> {
        if self.low.is_zero() {
            return Some(self.clone());
        }
        if self.is_negative() {
            return Some(self.negative().arctangent_of_point()?.negative());
        }
        let one = Enclosure::from(&Rational::ONE);
        let mut tangent = self.clone();
        for _ in 0..HALVINGS {
            let secant = one.sum(&tangent.product(&tangent)).square_root()?;
            tangent = tangent.product(&one.sum(&secant).reciprocal()?);
        }
        let square = tangent.product(&tangent).negative();
        let (mut sum, mut power, mut odd) = (Enclosure::from(&Rational::ZERO), tangent, 1_u32);
        while power.magnitude() > -2 * DIGITS as i64 {
            let term = Enclosure::from(&(Rational::ONE / Rational::from(odd))).product(&power);
            sum = sum.sum(&term);
            (power, odd) = (power.product(&square), odd + 2);
        }
        // The rest of an alternating series is smaller than its first term.
        let rest = Enclosure::new(Integer::NEG_ONE, Integer::ONE, power.magnitude() + 1);
        let factor = Enclosure::from(&Rational::from(1_u32 << HALVINGS));
        Some(sum.sum(&rest).product(&factor))
    }

    /// The angle in −π < β ≤ π of the vector (x, y); nothing where its quadrant is not known.
    pub fn direction(x: &Self, y: &Self) -> Option<Self> {
        let quarter = Intervals::new(DIGITS).quarter_turn();
        let quarter = Enclosure::of_bounds(Intervals::new(DIGITS).bounds(&quarter));
        if x.is_positive() {
            return y.product(&x.reciprocal()?).arctangent();
        }
        if y.is_positive() {
            let beyond = x.negative().product(&y.reciprocal()?);
            return Some(quarter.sum(&beyond.arctangent()?));
        }
        if y.is_negative() {
            return Some(Enclosure::direction(x, &y.negative())?.negative());
        }
        let on_the_axis = y.low.is_zero() && y.high.is_zero() && x.is_negative();
        on_the_axis.then(|| quarter.sum(&quarter))
    }

    /// How many of its first decimal digits are known.
    fn digits_known(&self) -> usize {
        let width = Enclosure::new(Integer::ZERO, &self.high - &self.low, self.exponent);
        // log₁₀ 2 is about 0.301.
        let known = (self.magnitude() - width.magnitude()).clamp(0, 1 << 20) as usize * 301 / 1000;
        known.saturating_sub(1)
    }

    /// Whether its first digits are known, or that it is 0 as far as any are shown.
    pub fn is_legible(&self) -> bool {
        let may_be_zero = !self.is_positive() && !self.is_negative();
        self.digits_known() > 0 || (may_be_zero && self.is_narrow(self, DIGITS as i64 / 2))
    }

    /// As a person reads it: at most so many digits, as far as they are known.
    pub fn display(&self, digits: usize) -> String {
        match self.digits_known().min(digits) {
            0 => "0".to_owned(),
            known => decimal(&self.middle(), known),
        }
    }
}

/// cos a and sin a of a rational angle.
pub fn circle_point(angle: &Rational) -> (Enclosure, Enclosure) {
    let intervals = Intervals::new(DIGITS);
    let [cosine, sine] = intervals.cosine_and_sine(angle);
    let enclosure = |own| Enclosure::of_bounds(intervals.bounds(own));
    (enclosure(&cosine), enclosure(&sine))
}

/// The first so many digits of a number, in a decimal fraction.
fn decimal(number: &Rational, digits: usize) -> String {
    let sign = if number.is_negative() { "-" } else { "" };
    let size = number.clone().abs();
    let whole = (size.numerator() / size.denominator()).to_string();
    let mut leading = 0;
    if whole == "0" && !size.is_zero() {
        let spare = size
            .denominator()
            .bit_len()
            .saturating_sub(size.numerator().bit_len());
        leading = spare * 30_103 / 100_000;
    }
    let places = match whole.as_str() {
        "0" => leading + digits,
        whole => digits.saturating_sub(whole.len()),
    };
    let scale = Integer::from(10).pow(places);
    let scaled = (size.numerator() * scale / Integer::from(size.denominator().clone())).to_string();
    let padded = format!("{scaled:0>width$}", width = places + 1);
    let (before, behind) = padded.split_at(padded.len() - places);
    match behind.trim_end_matches('0') {
        "" => format!("{sign}{before}"),
        behind => format!("{sign}{before}.{behind}"),
    }
}

impl From<&Rational> for Enclosure {
    fn from(number: &Rational) -> Self {
        let (above, below) = (
            number.numerator(),
            Integer::from(number.denominator().clone()),
        );
        if below == Integer::ONE {
            return Enclosure::new(above.clone(), above.clone(), 0);
        }
        let places = (DIGITS + below.bit_len()).saturating_sub(above.bit_len()) + 1;
        let scaled = above << places;
        let low = (&scaled - floor_remainder(&scaled, &below)) / &below;
        let is_exact = &low * &below == scaled;
        let high = &low + Integer::from(u8::from(!is_exact));
        Enclosure::new(low, high, -(places as i64))
    }
}

/// What is left of a when b > 0 is taken off it as often as the floor of a/b.
fn floor_remainder(a: &Integer, b: &Integer) -> Integer {
    let rest = a % b;
    match rest < Integer::ZERO {
        true => rest + b,
        false => rest,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rational(above: i64, below: i64) -> Rational {
        Rational::from(above) / Rational::from(below)
    }

    /// Fractions of a few digits and of many, of all sizes.
    fn number() -> impl Strategy<Value = Rational> {
        let short = (-10_000_i64..10_000, 1_i64..1000).prop_map(|(a, b)| rational(a, b));
        let long = (any::<[i64; 10]>(), any::<[u64; 6]>()).prop_map(|(above, below)| {
            let long = |words: &[Integer]| {
                let shifted = |number: Integer, word: &Integer| (number << 63) + word;
                words.iter().fold(Integer::ZERO, shifted)
            };
            let below = long(&below.map(Integer::from)) + Integer::ONE;
            Rational::from(long(&above.map(Integer::from))) / Rational::from(below)
        });
        (prop_oneof![short, long], -2000_i32..2000).prop_map(|(number, power)| {
            let scale = Rational::from(Integer::ONE << power.unsigned_abs() as usize);
            match power < 0 {
                true => number / scale,
                false => number * scale,
            }
        })
    }

    /// Enclosures, and a number in each: some hold one number, some more.
    fn enclosed() -> impl Strategy<Value = (Enclosure, Rational)> {
        let share = (0_i64..=16).prop_map(|sixteenths| rational(sixteenths, 16));
        (number(), number(), share, any::<bool>()).prop_map(
            |(a, b, share, is_point)| match is_point {
                true => (Enclosure::from(&a), a),
                false => {
                    let inner = &a + (&b - &a) * share;
                    (Enclosure::from(&a).joined(&Enclosure::from(&b)), inner)
                }
            },
        )
    }

    impl Enclosure {
        /// Whether a number lies within the bounds, exactly.
        fn contains(&self, number: &Rational) -> bool {
            let unit = Rational::from(Integer::ONE << self.exponent.unsigned_abs() as usize);
            let bound = |bound: &Integer| match self.exponent < 0 {
                true => Rational::from(bound.clone()) / &unit,
                false => Rational::from(bound.clone()) * &unit,
            };
            bound(&self.low) <= *number && *number <= bound(&self.high)
        }
    }

    fn size(number: Rational) -> Rational {
        match number < Rational::ZERO {
            true => -number,
            false => number,
        }
    }

    proptest! {
        #[test]
        fn arithmetic_encloses_that_of_fractions((x, a) in enclosed(), (y, b) in enclosed()) {
            prop_assert!(x.contains(&a) && y.contains(&b));
            prop_assert!(x.negative().contains(&-a.clone()));
            prop_assert!(x.sum(&y).contains(&(&a + &b)));
            prop_assert!(x.product(&y).contains(&(&a * &b)));
            prop_assert!(x.joined(&y).contains(&a) && x.joined(&y).contains(&b));
            if let Some(inverse) = y.reciprocal() {
                prop_assert!(inverse.contains(&(Rational::ONE / &b)));
            }
            // u ≤ √a ≤ v where u² ≤ a ≤ v².
            if let Some(root) = x.square_root() {
                let square = root.product(&root);
                prop_assert!(square.contains(&a), "{square:?}");
            }
            prop_assert!(!x.is_below(&y) || a < b);
            prop_assert!(!x.is_within(&y) || y.contains(&a));
        }

        #[test]
        fn points_are_narrow(a in number(), b in number()) {
            let (x, y) = (Enclosure::from(&a), Enclosure::from(&b));
            let is_narrow = |own: &Enclosure| {
                let width = Enclosure::new(Integer::ZERO, &own.high - &own.low, own.exponent);
                width.magnitude() <= own.magnitude() - 240
            };
            prop_assert!(is_narrow(&x) && is_narrow(&x.product(&y)));
            prop_assert_eq!(x.is_below(&y), a < b);
            if !a.is_zero() {
                prop_assert!(is_narrow(&x.reciprocal().expect("not 0")));
                let root = Enclosure::from(&size(a)).square_root().expect("a root");
                prop_assert!(is_narrow(&root));
            }
        }

        #[test]
        fn an_arctangent_grows((x, a) in enclosed(), b in number()) {
            let [arctangent, inner, other] =
                [&x, &Enclosure::from(&a), &Enclosure::from(&b)].map(Enclosure::arctangent);
            let (arctangent, inner) = (arctangent.expect("a value"), inner.expect("a value"));
            prop_assert!(arctangent.meets(&inner));
            prop_assert!(!inner.is_below(&other.expect("a value")) || a < b);
        }

        #[test]
        fn directions_have_the_sines_and_cosines_of_their_vectors(x in number(), y in number()) {
            prop_assume!(!x.is_zero() || !y.is_zero());
            let (x, y) = (Enclosure::from(&x), Enclosure::from(&y));
            let angle = Enclosure::direction(&x, &y).expect("a direction");
            let (cosine, sine) = angle.cosine_and_sine().expect("an angle");
            let length = x.product(&x).sum(&y.product(&y)).square_root().expect("a length");
            prop_assert!(length.product(&cosine).meets(&x), "{cosine:?}");
            prop_assert!(length.product(&sine).meets(&y), "{sine:?}");
            prop_assert!(angle.is_narrow(&angle, 200));
        }
    }

    #[test]
    fn what_is_hardly_known_is_not_shown() {
        let between =
            |a, b| Enclosure::from(&Rational::from(a)).joined(&Enclosure::from(&Rational::from(b)));
        assert!(!between(1, 900).is_legible() && !between(-1, 1).is_legible());
        assert!(between(0, 0).is_legible() && between(899, 900).is_legible());
        // What is 0 to half of all digits may be shown as 0.
        let around = |exponent| Enclosure::new(Integer::NEG_ONE, Integer::ONE, exponent);
        assert!(around(-200).is_legible() && !around(-100).is_legible());
        // An arctangent of what is no number ends.
        assert!(between(0, 1 << 23).arctangent().is_some());
    }

    #[test]
    fn the_middle_is_half_way_between_the_bounds() {
        for exponent in [-3, 0, 3, 400] {
            let middle = Enclosure::new(Integer::ONE, Integer::from(3), exponent).middle();
            assert_eq!(middle, Rational::from(2).pow(exponent as isize + 1));
        }
    }

    #[test]
    fn numbers_beyond_a_million_binary_digits_are_extreme() {
        for (exponent, is_extreme) in [
            (0, false),
            ((1 << 20) - 1, false),
            (1 << 20, true),
            ((1 << 20) + 1, true),
            (-(1 << 20), false),
            (-(1 << 20) - 1, true),
        ] {
            let one = Enclosure::new(Integer::ONE, Integer::ONE, exponent);
            assert_eq!(one.is_extreme(), is_extreme, "{exponent}");
            let zero = Enclosure::new(Integer::ZERO, Integer::ZERO, exponent);
            assert!(!zero.is_extreme());
        }
    }

    #[test]
    fn numbers_that_differ_do_not_meet() {
        let root = Enclosure::from(&Rational::from(2)).square_root().unwrap();
        let near = rational(1_414_213_562_373_095_048, 1_000_000_000_000_000_000);
        assert!(!root.meets(&Enclosure::from(&near)));
        assert!(
            root.product(&root)
                .meets(&Enclosure::from(&Rational::from(2)))
        );
        assert_eq!(root.display(20), "1.4142135623730950488");
        assert_eq!(root.negative().display(5), "-1.4142");
    }
}
