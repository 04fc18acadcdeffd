//! Real numbers with a bound of their error.

use std::ops::{Add, Mul, Neg, Sub};

/// More than half a unit in the last place of a rounded number, over it.
const UNIT: f64 = f64::EPSILON / 2.0;

/// More than what is lost when the radius itself is computed.
const ABOVE: f64 = 1.0 + 16.0 * f64::EPSILON;

/// All real numbers within `radius` of `centre`.
///
/// A sum, product, quotient or root holds all those of what its operands hold. The radius is infinite or NaN after an
/// overflow; no comparison with such a radius decides anything. What is exactly 0 stays exactly 0 in products.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Real {
    pub centre: f64,
    pub radius: f64,
}

impl Real {
    pub const ZERO: Real = Real::exact(0.0);
    pub const ONE: Real = Real::exact(1.0);

    pub const fn exact(centre: f64) -> Self {
        Real {
            centre,
            radius: 0.0,
        }
    }

    pub const fn new(centre: f64, radius: f64) -> Self {
        Real { centre, radius }
    }

    /// Whether it is 0 and nothing else.
    pub fn is_zero(self) -> bool {
        self.centre == 0.0 && self.radius == 0.0
    }

    pub fn is_finite(self) -> bool {
        self.centre.is_finite() && self.radius.is_finite()
    }

    /// No number of it is larger, up to its sign.
    pub fn largest(self) -> f64 {
        (self.centre.abs() + self.radius) * ABOVE
    }

    /// Its product with a power of 2, or with the negative of one, which rounds nothing but what becomes subnormal.
    pub fn scaled(self, power: f64) -> Self {
        let (centre, radius) = (self.centre * power, self.radius * power.abs());
        let lost = match centre.is_normal() || self.centre == 0.0 {
            true => 0.0,
            false => f64::MIN_POSITIVE,
        };
        let below = match radius.is_normal() || self.radius == 0.0 {
            true => 0.0,
            false => f64::MIN_POSITIVE,
        };
        Real::new(centre, (radius + lost + below) * ABOVE)
    }

    /// a/b; `None` if b may be 0.
    pub fn quotient(self, other: Real) -> Option<Real> {
        let least = other.centre.abs() / ABOVE - other.radius * ABOVE;
        if self.is_zero() && least > 0.0 {
            return Some(Real::ZERO);
        }
        let centre = self.centre / other.centre;
        // a'/b' − a/b = ((a' − a) − (a/b) (b' − b))/b'
        let inherited = (self.radius + centre.abs() * other.radius) / least;
        let radius = (inherited + UNIT * centre.abs() + f64::MIN_POSITIVE) * ABOVE;
        (least > 0.0).then_some(Real::new(centre, radius))
    }

    /// √a; `None` if a may be negative.
    pub fn square_root(self) -> Option<Real> {
        if self.is_zero() {
            return Some(Real::ZERO);
        }
        let root = self.centre.sqrt();
        // √a' − √a = (a' − a)/(√a' + √a)
        let radius = (self.radius / root + UNIT * root) * ABOVE;
        (self.centre - self.radius * ABOVE >= 0.0).then_some(Real::new(root, radius))
    }
}

impl Add for Real {
    type Output = Real;

    fn add(self, other: Real) -> Real {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other } else { self };
        }
        let centre = self.centre + other.centre;
        let radius = (self.radius + other.radius + UNIT * centre.abs()) * ABOVE;
        Real::new(centre, radius)
    }
}

impl Neg for Real {
    type Output = Real;

    fn neg(self) -> Real {
        Real::new(-self.centre, self.radius)
    }
}

impl Sub for Real {
    type Output = Real;

    fn sub(self, other: Real) -> Real {
        self + -other
    }
}

impl Mul for Real {
    type Output = Real;

    fn mul(self, other: Real) -> Real {
        if self.is_zero() || other.is_zero() {
            return Real::ZERO;
        }
        let centre = self.centre * other.centre;
        let (a, b) = (self.centre.abs(), other.centre.abs());
        let inherited = a * other.radius + b * self.radius + self.radius * other.radius;
        let radius = (inherited + UNIT * centre.abs() + f64::MIN_POSITIVE) * ABOVE;
        Real::new(centre, radius)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::number::Rational;
    use proptest::prelude::*;

    fn exact(value: f64) -> Rational {
        Rational::try_from(value).expect("a finite double is a rational number")
    }

    /// A ball, and a number in it.
    fn ball() -> impl Strategy<Value = (Real, Rational)> {
        let centre = prop_oneof![-1e3..1e3f64, -1e-9..1e-9f64, Just(0.0), Just(1.0)];
        let radius = prop_oneof![Just(0.0), 0.0..1e-9f64, 0.0..10.0f64];
        (centre, radius, -4_i64..=4).prop_map(|(centre, radius, place)| {
            let member = exact(centre) + exact(radius) * Rational::from(place) / Rational::from(4);
            (Real::new(centre, radius), member)
        })
    }

    fn holds(ball: Real, number: &Rational) -> bool {
        let apart = number - exact(ball.centre);
        let radius = exact(ball.radius);
        -&radius <= apart && apart <= radius
    }

    proptest! {
        #[test]
        fn results_hold_those_of_all_members((a, x) in ball(), (b, y) in ball()) {
            prop_assert!(holds(a + b, &(&x + &y)));
            prop_assert!(holds(a - b, &(&x - &y)));
            prop_assert!(holds(a * b, &(&x * &y)));
            prop_assert!(holds(a.scaled(0.25), &(&x / Rational::from(4))));
            prop_assert!(holds(a.scaled(-2.0), &(&x * Rational::from(-2))));
            if let Some(quotient) = a.quotient(b) {
                prop_assert!(!y.is_zero() && holds(quotient, &(&x / &y)));
            } else {
                prop_assert!(b.centre.abs() <= b.radius * (1.0 + 1e-12));
            }
            // √a holds what has its square in a.
            match (a * a).square_root() {
                Some(root) => {
                    let positive = if x < Rational::ZERO { -&x } else { x.clone() };
                    prop_assert!(holds(root, &positive), "{a:?} {root:?}");
                }
                None => prop_assert!(a.centre.abs() <= a.radius * 3.0 + 1e-150),
            }
        }
    }

    #[test]
    fn results_of_exact_numbers_are_as_exact_as_doubles() {
        let [a, b] = [1.0 / 3.0, 7.3].map(Real::exact);
        for own in [
            a + b,
            a * b,
            a.quotient(b).unwrap(),
            a.square_root().unwrap(),
        ] {
            assert!(own.radius <= 1.01 * UNIT * own.centre.abs(), "{own:?}");
        }
        assert_eq!(a.quotient(Real::ZERO), None);
        assert_eq!(a.quotient(Real::new(1.0, 2.0)), None);
        assert_eq!(Real::exact(-1.0).square_root(), None);
        assert_eq!(Real::exact(f64::NAN).square_root(), None);
        assert!((Real::ZERO * b).is_zero());
    }
}
