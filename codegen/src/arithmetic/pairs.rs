//! Sums of two doubles with rigorous bounds: all that most points need, at a fraction of the cost of exact
//! arithmetic.

use dashu_base::Abs;

use crate::program::Rational;

use super::Arithmetic;

/// Half a unit in the last place of a double, squared, is 2⁻¹⁰⁶; sums and products of pairs are off by at
/// most five such units.
const UNIT: f64 = 1.0 / (1_u128 << 103) as f64;

/// What the bounds themselves are rounded by.
const ABOVE: f64 = 1.0 + 1.0 / (1_u64 << 48) as f64;

/// Beyond these, products of halves may overflow or lose bits.
const RANGE: std::ops::Range<f64> = 1e-250..1e250;

/// Far below all values in range, and far above what underflow costs a bound.
const TINY: f64 = 1e-290;

/// A number within `error` of `high + low`, where `low` is at most half a unit of `high`.
#[derive(Clone, Copy, Debug)]
pub struct Close {
    high: f64,
    low: f64,
    error: f64,
}

/// s + e = a + b, and s is the nearest double.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let other = sum - a;
    (sum, (a - (sum - other)) + (b - other))
}

/// The same for |a| ≥ |b|.
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// A double as a sum of two with half as many bits.
fn halves(a: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// p + e = a·b, and p is the nearest double; without fused operations, which not every machine has.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let (a, b) = (halves(a), halves(b));
    let rest = ((a.0 * b.0 - product) + a.0 * b.1 + a.1 * b.0) + a.1 * b.1;
    (product, rest)
}

impl Close {
    /// A double; none if it is out of range.
    pub fn exact(value: f64) -> Option<Self> {
        Close::new((value, 0.0), 0.0)
    }

    /// An exact number; none if the double next to it is out of range.
    pub fn of(value: &Rational) -> Option<Self> {
        let high = value.to_f64().value();
        let rest = value - Rational::try_from(high).ok()?;
        let low = rest.to_f64().value();
        let rest = (rest - Rational::try_from(low).ok()?).abs();
        let error = match rest.is_zero() {
            true => 0.0,
            false => rest.to_f64().value() * ABOVE + TINY,
        };
        Close::new(fast_two_sum(high, low), error)
    }

    /// None beyond the range in which the bounds hold.
    fn new((high, low): (f64, f64), error: f64) -> Option<Self> {
        let in_range = high == 0.0 || RANGE.contains(&high.abs());
        (in_range && error.is_finite()).then_some(Close { high, low, error })
    }

    fn is_exactly_0(self) -> bool {
        self.high == 0.0 && self.error == 0.0
    }

    fn magnitude(self) -> f64 {
        self.high.abs() + self.low.abs()
    }

    /// A bound from below that is not 0, where the sign is beyond doubt.
    fn least(self) -> Option<f64> {
        let high = self.high.abs();
        (self.error < high / 4.0).then_some((high - self.low.abs() - self.error) / ABOVE)
    }

    fn negative(self) -> Self {
        Close {
            high: -self.high,
            low: -self.low,
            error: self.error,
        }
    }

    fn sum(self, other: Self) -> Option<Self> {
        let (high, rest) = two_sum(self.high, other.high);
        let (low, last) = two_sum(self.low, other.low);
        let (high, rest) = fast_two_sum(high, rest + low);
        let sum = fast_two_sum(high, last + rest);
        let inherited = self.error + other.error;
        // A sum of two doubles is exact as a pair.
        let own = match self.low == 0.0 && other.low == 0.0 {
            true => 0.0,
            false => sum.0.abs() * UNIT + TINY,
        };
        Close::new(sum, (inherited + own) * ABOVE)
    }

    fn difference(self, other: Self) -> Option<Self> {
        self.sum(other.negative())
    }

    fn product(self, other: Self) -> Option<Self> {
        if self.is_exactly_0() || other.is_exactly_0() {
            return Close::exact(0.0);
        }
        let (high, rest) = two_product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        let product = fast_two_sum(high, rest + cross);
        let inherited = self.magnitude() * other.error + other.magnitude() * self.error;
        // A product of two doubles is exact as a pair, unless it underflows.
        let own = match self.low == 0.0 && other.low == 0.0 && high != 0.0 {
            true => 0.0,
            false => high.abs() * UNIT + TINY,
        };
        let both = self.error * other.error;
        Close::new(product, (inherited + both + own) * ABOVE)
    }

    /// A quotient q of a and b is off by (a − q·b)/b.
    fn quotient(self, other: Self) -> Option<Self> {
        let least = other.least()?;
        if self.is_exactly_0() {
            return Some(self);
        }
        let first = self.high / other.high;
        let rest = self.difference(other.product(Close::exact(first)?)?)?;
        let quotient = Close::new(fast_two_sum(first, rest.high / other.high), 0.0)?;
        let rest = self.difference(other.product(quotient)?)?;
        let error = (rest.magnitude() + rest.error) / least;
        Close::new((quotient.high, quotient.low), error * ABOVE + TINY)
    }

    /// A root s of a is off by (a − s²)/(√a + s).
    fn square_root(self) -> Option<Self> {
        if self.is_exactly_0() {
            return Some(self);
        }
        if self.high < 0.0 || self.least().is_none() {
            return None;
        }
        let first = Close::exact(self.high.sqrt())?;
        let rest = self.difference(first.product(first)?)?;
        let root = fast_two_sum(first.high, rest.high / (2.0 * first.high));
        let root = Close::new(root, 0.0)?;
        let rest = self.difference(root.product(root)?)?;
        let error = (rest.magnitude() + rest.error) / (root.high - root.low.abs());
        Close::new((root.high, root.low), error * ABOVE + TINY)
    }

    /// Two numbers that it is between.
    pub fn bounds(self) -> Option<[Rational; 2]> {
        let exact = |part: f64| Rational::try_from(part).ok();
        let (middle, error) = (exact(self.high)? + exact(self.low)?, exact(self.error)?);
        Some([&middle - &error, middle + error])
    }

    /// The distance of a double in units in the last place of the number, if the bounds decide which these
    /// are and give the distance to a millionth.
    pub fn units(self, found: f64) -> Option<f64> {
        if self.is_exactly_0() && found == 0.0 {
            return Some(0.0);
        }
        // 2ⁿ and the distance to the next double, where the number is in [2ⁿ, 2ⁿ⁺¹). It is on the same side
        // of all powers of two as its nearest double, unless that is one of them.
        let power = f64::from_bits(self.high.to_bits() & (0x7ff << 52));
        let unit = power * f64::EPSILON;
        let is_double = self.low == 0.0 && self.error == 0.0;
        if self.high == 0.0 || self.high.abs() == power && !is_double {
            return None;
        }
        if !found.is_finite() {
            return Some(f64::INFINITY);
        }
        let distance = self.difference(Close::exact(found)?)?;
        let is_decided = distance.error <= 1e-6 * unit;
        is_decided.then_some((distance.high + distance.low).abs() / unit)
    }
}

/// Sums of two doubles with bounds of their errors.
#[derive(Clone, Copy, Debug)]
pub struct Pairs;

/// A value is out of range, a divisor may be 0 or a radicand negative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unknown;

impl Arithmetic for Pairs {
    type Value = Close;
    type Error = Unknown;

    fn constant(&mut self, value: &Rational) -> Result<Close, Unknown> {
        Close::of(value).ok_or(Unknown)
    }

    fn negative(&mut self, a: &Close) -> Result<Close, Unknown> {
        Ok(a.negative())
    }

    fn sum(&mut self, a: &Close, b: &Close) -> Result<Close, Unknown> {
        a.sum(*b).ok_or(Unknown)
    }

    fn difference(&mut self, a: &Close, b: &Close) -> Result<Close, Unknown> {
        a.difference(*b).ok_or(Unknown)
    }

    fn product(&mut self, a: &Close, b: &Close) -> Result<Close, Unknown> {
        a.product(*b).ok_or(Unknown)
    }

    fn quotient(&mut self, a: &Close, b: &Close) -> Result<Close, Unknown> {
        a.quotient(*b).ok_or(Unknown)
    }

    fn square_root(&mut self, a: &Close) -> Result<Close, Unknown> {
        a.square_root().ok_or(Unknown)
    }
}
