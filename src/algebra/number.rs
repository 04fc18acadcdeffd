//! The exact numbers everything is made of.

/// An integer of any size.
pub type Integer = dashu_int::IBig;

/// A quotient of integers, in lowest terms.
pub type Rational = dashu_ratio::RBig;
