//! Numbers of twice the digits of a double, as the unrounded sum of two, to judge doubles by.

use std::ops::{Add, Mul, Neg, Sub};

/// The sum of two doubles, the second below half a unit in the last place of the first.
#[derive(Clone, Copy)]
pub struct Double(pub f64, pub f64);

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (sum, rest) = sum(self.0, other.0);
        let (low, lowest) = self::sum(self.1, other.1);
        let (sum, rest) = self::sum(sum, rest + low);
        let (sum, rest) = self::sum(sum, rest + lowest);
        Double(sum, rest)
    }
}

impl Neg for Double {
    type Output = Self;

    fn neg(self) -> Self {
        Double(-self.0, -self.1)
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = self.0 * other.0;
        let rest = self.0.mul_add(other.0, -product);
        let (product, rest) = sum(product, rest + (self.0 * other.1 + self.1 * other.0));
        Double(product, rest)
    }
}

/// A sum and what it rounds away.
fn sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let from_b = sum - a;
    (sum, (a - (sum - from_b)) + (b - from_b))
}

/// A complex number of such parts.
#[derive(Clone, Copy)]
pub struct Complex(pub Double, pub Double);

impl Complex {
    /// A number in doubles.
    pub fn new(re: f64, im: f64) -> Self {
        Complex(Double(re, 0.0), Double(im, 0.0))
    }
}

impl Add for Complex {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Complex(self.0 + other.0, self.1 + other.1)
    }
}

impl Sub for Complex {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Complex(self.0 - other.0, self.1 - other.1)
    }
}

impl Mul for Complex {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Complex(
            self.0 * other.0 - self.1 * other.1,
            self.0 * other.1 + self.1 * other.0,
        )
    }
}
