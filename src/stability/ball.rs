//! Complex numbers with a bound of their error.

use std::ops::{Add, Mul};

use num_complex::Complex;
use sextic_evaluators::bounded::Bounded;

/// More than the rounding error of a complex product by the product of the absolute values,
/// and than that of a sum by its absolute value; half of it is needed.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// More than what is lost when the radius itself is computed.
const ABOVE: f64 = 1.0 + 16.0 * f64::EPSILON;

/// More than an absolute value loses where squares underflow: √(2·2⁻¹⁰²²) = 2.1e-154.
const UNDERFLOW: f64 = 3e-154;

/// All complex numbers within `radius` of `centre`.
///
/// A sum or product holds all sums or products of what its operands hold. The radius is infinite
/// or NaN after an overflow; no comparison with such a radius decides anything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ball {
    pub centre: Complex<f64>,
    pub radius: f64,
}

impl Ball {
    pub const ZERO: Ball = Ball::exact(Complex::new(0.0, 0.0));
    pub const ONE: Ball = Ball::exact(Complex::new(1.0, 0.0));

    pub const fn exact(centre: Complex<f64>) -> Self {
        Ball {
            centre,
            radius: 0.0,
        }
    }

    /// A real number.
    pub const fn exactly(value: f64) -> Self {
        Ball::real(value, 0.0)
    }

    /// A real number and a bound of its error.
    pub const fn real(value: f64, radius: f64) -> Self {
        Ball {
            centre: Complex::new(value, 0.0),
            radius,
        }
    }

    /// The conjugates of what it holds.
    pub fn conjugate(self) -> Self {
        Ball {
            centre: self.centre.conj(),
            ..self
        }
    }

    /// i times what it holds.
    pub fn turned(self) -> Self {
        Ball {
            centre: Complex::new(-self.centre.im, self.centre.re),
            ..self
        }
    }

    /// No number of the ball is larger.
    pub fn largest(self) -> f64 {
        (self.centre.norm_sqr().sqrt() + UNDERFLOW + self.radius) * ABOVE
    }

    /// No number of the ball is smaller; 0 if it may hold 0.
    pub fn smallest(self) -> f64 {
        (self.centre.norm() / ABOVE - self.radius * ABOVE).max(0.0)
    }

    pub fn is_finite(self) -> bool {
        self.centre.is_finite() && self.radius.is_finite()
    }
}

impl From<Bounded> for Ball {
    /// Infinite where nothing is known.
    fn from(own: Bounded) -> Self {
        Ball::real(own.value, own.error)
    }
}

/// cos and sin of a sum of angles: what rounding takes from the sum moves them by as much, and each is right to a unit
/// in the last place for the sum that is taken.
pub(super) fn cosine_and_sine(angles: &[f64]) -> [Bounded; 2] {
    let (mut sum, mut lost) = (0.0_f64, 0.0);
    for angle in angles {
        let next = sum + angle;
        // What is added to 0, or adds 0, is exact.
        if sum != 0.0 && *angle != 0.0 {
            lost += f64::EPSILON / 2.0 * next.abs();
        }
        sum = next;
    }
    if sum == 0.0 && lost == 0.0 {
        return [1.0, 0.0].map(Bounded::exact);
    }
    [sum.cos(), sum.sin()].map(|value| {
        let own = f64::EPSILON * value.abs() + f64::MIN_POSITIVE;
        let error = (own + lost) * ABOVE;
        Bounded { value, error }
    })
}

/// |re| + |im|, which is not below the absolute value, nor much above it: most numbers here are nearly real
/// or imaginary, and the exact value would cost most of the time.
fn above_norm(number: Complex<f64>) -> f64 {
    number.re.abs() + number.im.abs()
}

impl Add for Ball {
    type Output = Ball;

    fn add(self, other: Ball) -> Ball {
        let centre = self.centre + other.centre;
        let inherited = self.radius + other.radius;
        Ball {
            centre,
            radius: (inherited + ROUNDING * above_norm(centre)) * ABOVE,
        }
    }
}

impl std::ops::Neg for Ball {
    type Output = Ball;

    fn neg(self) -> Ball {
        Ball {
            centre: -self.centre,
            ..self
        }
    }
}

impl Mul for Ball {
    type Output = Ball;

    fn mul(self, other: Ball) -> Ball {
        let (a, b) = (above_norm(self.centre), above_norm(other.centre));
        let inherited = a * other.radius + b * self.radius + self.radius * other.radius;
        // What underflows is less than the smallest normal number.
        let rounding = ROUNDING * a * b + 4.0 * f64::MIN_POSITIVE;
        Ball {
            centre: self.centre * other.centre,
            radius: (inherited + rounding) * ABOVE,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::interval::Intervals;
    use dashu_ratio::RBig as Rational;
    use proptest::prelude::*;

    fn exact(value: f64) -> Rational {
        Rational::try_from(value).expect("a finite double is a rational number")
    }

    /// Whether the exact number lies in the ball.
    fn holds(ball: Ball, re: &Rational, im: &Rational) -> bool {
        let (x, y) = (re - exact(ball.centre.re), im - exact(ball.centre.im));
        let radius = exact(ball.radius);
        &x * &x + &y * &y <= &radius * &radius
    }

    fn complex() -> impl Strategy<Value = Complex<f64>> {
        let part = prop_oneof![-1e3..1e3f64, -1e-9..1e-9f64, Just(0.0)];
        (part.clone(), part).prop_map(|(re, im)| Complex::new(re, im))
    }

    proptest! {
        #[test]
        fn sums_and_products_are_enclosed(a in complex(), b in complex(), c in complex()) {
            let [p, q, s] = [a, b, c].map(|z| (exact(z.re), exact(z.im)));
            // (a b + c) b
            let (re, im) = (&p.0 * &q.0 - &p.1 * &q.1 + &s.0, &p.0 * &q.1 + &p.1 * &q.0 + &s.1);
            let (re, im) = (&re * &q.0 - &im * &q.1, &re * &q.1 + &im * &q.0);
            let [a, b, c] = [a, b, c].map(Ball::exact);
            let ball = (a * b + c) * b;
            prop_assert!(holds(ball, &re, &im));
            let size = (a.largest() * b.largest() + c.largest()) * b.largest();
            prop_assert!(ball.radius <= 1e-14 * size + 1e-300);
        }

        /// Of the sum of the doubles themselves, however large they are beside it.
        #[test]
        fn sines_of_sums_are_enclosed(
            angles in prop::collection::vec(prop_oneof![-7.0..7.0_f64, -2000.0..2000.0_f64, Just(0.0), -1e-9..1e-9_f64], 1..4),
        ) {
            let sum = angles.iter().fold(Rational::ZERO, |sum, own| sum + exact(*own));
            let intervals = Intervals::new(200);
            let expected = intervals.cosine_and_sine(&sum.to_string().parse().expect("a number"));
            for (ball, expected) in cosine_and_sine(&angles).iter().zip(expected) {
                let [low, high] = intervals.bounds(&expected).map(|bound| -> Rational {
                    bound.to_string().parse().expect("a number")
                });
                let (centre, radius) = (exact(ball.value), exact(ball.error));
                prop_assert!(low <= &centre + &radius && &centre - &radius <= high, "{ball:?} {angles:?}");
                let size: f64 = angles.iter().map(|own| own.abs()).sum();
                prop_assert!(ball.error <= 1e-15 * (1.0 + size));
            }
        }
    }
}
