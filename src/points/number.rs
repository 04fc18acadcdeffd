//! Complex numbers, most of which are real.

use crate::algebra::number::Rational;

use super::real::{Real, Reals};
use super::{Failure, NoValue, Unknown};

/// A number; one without an imaginary part is known to be real.
#[derive(Clone, Debug)]
pub struct Number {
    /// The real part.
    pub real: Real,
    /// The imaginary part, which is not known to be 0.
    pub imaginary: Option<Real>,
}

impl From<Real> for Number {
    fn from(real: Real) -> Self {
        Number {
            real,
            imaginary: None,
        }
    }
}

impl Number {
    /// A number of two parts.
    pub fn new(real: Real, imaginary: Real) -> Self {
        let imaginary = (!imaginary.is_zero()).then_some(imaginary);
        Number { real, imaginary }
    }

    /// The real number that it is, if it is known to be one.
    pub fn as_real(&self) -> Option<&Real> {
        match self.imaginary {
            None => Some(&self.real),
            Some(_) => None,
        }
    }

    /// Why one that is not known to be real is not taken as a real number.
    pub fn not_real(&self) -> Failure {
        let imaginary = self.imaginary.as_ref().and_then(Real::sign);
        match imaginary.is_some() {
            true => NoValue::NotReal.into(),
            false => Unknown::Sign.into(),
        }
    }

    /// Whether enough of it is known to be shown.
    pub fn is_legible(&self) -> bool {
        self.real.is_legible() && self.imaginary.as_ref().is_none_or(Real::is_legible)
    }

    /// How long its fractions are, in words.
    pub fn words(&self) -> usize {
        self.real.words() + self.imaginary.as_ref().map_or(0, Real::words)
    }

    /// Both parts.
    fn parts(&self) -> (Real, Real) {
        let zero = Real::Exact(Rational::ZERO);
        (self.real.clone(), self.imaginary.clone().unwrap_or(zero))
    }

    /// Whether the two may be one number.
    pub fn may_be(&self, other: &Number) -> bool {
        let ((a, b), (c, d)) = (self.parts(), other.parts());
        a.may_be(&c) && b.may_be(&d)
    }

    /// Whether it is known to be 0.
    pub fn is_zero(&self) -> bool {
        self.imaginary.is_none() && self.real.is_zero()
    }

    /// Whether it is known not to be 0.
    pub fn differs_from_zero(&self) -> bool {
        !self.may_be(&Number::from(Real::Exact(Rational::ZERO)))
    }

    /// Whether both parts are known exactly.
    pub fn is_exact(&self) -> bool {
        let is_exact = |part: &Real| part.as_rational().is_some();
        is_exact(&self.real) && self.imaginary.as_ref().is_none_or(is_exact)
    }

    /// Whether a number that may be 0 is known to so many binary digits, beside another one.
    pub fn is_narrow(&self, beside: &Number, digits: i64) -> bool {
        let ((a, b), (c, d)) = (self.parts(), beside.parts());
        let size = Reals { longest: 0 };
        let square = size.sum(&size.product(&c, &c), &size.product(&d, &d));
        let square = square.enclosure();
        let size = square.square_root().unwrap_or(square.into_owned());
        a.enclosure().is_narrow(&size, digits) && b.enclosure().is_narrow(&size, digits)
    }

    /// As a person reads it: `3/2 + 5*i`.
    pub fn display(&self) -> String {
        let Some(imaginary) = &self.imaginary else {
            return self.real.display();
        };
        let imaginary = imaginary.display();
        let (sign, size) = match imaginary.strip_prefix('-') {
            Some(size) => ("-", size.to_owned()),
            None => ("+", imaginary),
        };
        let term = match size.as_str() {
            "1" => "i".to_owned(),
            size => format!("{size}*i"),
        };
        match (self.real.is_zero(), sign) {
            (true, "-") => format!("-{term}"),
            (true, _) => term,
            (false, sign) => format!("{} {sign} {term}", self.real.display()),
        }
    }
}

impl Reals {
    /// a + b of complex numbers.
    pub fn total(self, a: &Number, b: &Number) -> Number {
        let real = self.sum(&a.real, &b.real);
        match (&a.imaginary, &b.imaginary) {
            (None, None) => Number::from(real),
            (Some(part), None) | (None, Some(part)) => Number::new(real, part.clone()),
            (Some(one), Some(other)) => Number::new(real, self.sum(one, other)),
        }
    }

    /// a·b of complex numbers.
    pub fn times(self, a: &Number, b: &Number) -> Number {
        let real = self.product(&a.real, &b.real);
        match (&a.imaginary, &b.imaginary) {
            (None, None) => Number::from(real),
            (Some(part), None) => Number::new(real, self.product(part, &b.real)),
            (None, Some(part)) => Number::new(real, self.product(&a.real, part)),
            (Some(one), Some(other)) => {
                let across = self.sum(&self.product(&a.real, other), &self.product(one, &b.real));
                let square = self.negative(&self.product(one, other));
                Number::new(self.sum(&real, &square), across)
            }
        }
    }

    /// 1/a of a complex number; nothing where it may be 0.
    pub fn inverse(self, a: &Number) -> Option<Number> {
        let Some(imaginary) = &a.imaginary else {
            return self.reciprocal(&a.real).map(Number::from);
        };
        let square = self.sum(&self.power(&a.real, 2), &self.power(imaginary, 2));
        let inverse = self.reciprocal(&square)?;
        let below = self.negative(&self.product(imaginary, &inverse));
        Some(Number::new(self.product(&a.real, &inverse), below))
    }

    /// aⁿ of a complex number.
    pub fn raised(self, a: &Number, exponent: u32) -> Number {
        if a.imaginary.is_none() {
            return Number::from(self.power(&a.real, exponent));
        }
        let one = Number::from(Real::Exact(Rational::ONE));
        let (mut result, mut square, mut rest) = (one, a.clone(), exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                result = self.times(&result, &square);
            }
            rest /= 2;
            if rest > 0 {
                square = self.times(&square, &square);
            }
        }
        result
    }
}
