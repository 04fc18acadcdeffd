//! Coefficients while a product or a quotient is computed.

use super::number::Integer;

/// A representation of integers that a sum of products can be collected in.
pub(super) trait Coefficient: Clone {
    /// Reads an integer, `None` where it is too long.
    fn read(integer: &Integer) -> Option<Self>;

    /// The integer.
    fn into_integer(self) -> Integer;

    /// Whether this is zero.
    fn is_zero(&self) -> bool;

    /// `self + other`, for values whose sum is known to fit.
    fn plus(&mut self, other: &Self);

    /// `left · right`, for values whose product is known to fit.
    fn product(left: &Self, right: &Self) -> Self;

    /// `-self`, for values of which it is known to fit.
    fn negative(&self) -> Self;

    /// `self` or 0; without a branch for machine words.
    fn if_taken(&self, is_taken: bool) -> Self;
}

macro_rules! machine_coefficient {
    ($word:ty) => {
        impl Coefficient for $word {
            fn read(integer: &Integer) -> Option<Self> {
                Self::try_from(integer).ok()
            }

            fn into_integer(self) -> Integer {
                Integer::from(self)
            }

            fn is_zero(&self) -> bool {
                *self == 0
            }

            fn plus(&mut self, other: &Self) {
                *self += other;
            }

            fn product(left: &Self, right: &Self) -> Self {
                left * right
            }

            fn negative(&self) -> Self {
                -self
            }

            fn if_taken(&self, is_taken: bool) -> Self {
                self * Self::from(is_taken)
            }
        }
    };
}

machine_coefficient!(i64);
machine_coefficient!(i128);

impl Coefficient for Integer {
    fn read(integer: &Integer) -> Option<Self> {
        Some(integer.clone())
    }

    fn into_integer(self) -> Integer {
        self
    }

    fn is_zero(&self) -> bool {
        Integer::is_zero(self)
    }

    fn plus(&mut self, other: &Self) {
        *self += other;
    }

    fn product(left: &Self, right: &Self) -> Self {
        left * right
    }

    fn negative(&self) -> Self {
        -self
    }

    fn if_taken(&self, is_taken: bool) -> Self {
        match is_taken {
            true => self.clone(),
            false => Integer::ZERO,
        }
    }
}
