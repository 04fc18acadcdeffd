//! Several doubles that go through the same operations side by side.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::arithmetic::{Arithmetic, square_root};

/// `N` doubles; products and sums are rounded once together if `FUSED`, and twice if not.
///
/// Explicit arrays and loops of a fixed length: a compiler turns them into vector instructions more
/// reliably than a loop over points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes<const N: usize, const FUSED: bool>([f64; N]);

impl<const N: usize, const FUSED: bool> Lanes<N, FUSED> {
    /// Takes `N` values.
    ///
    /// # Panics
    ///
    /// If there are not `N` values from `start` on.
    #[inline(always)]
    pub fn load(values: &[f64], start: usize) -> Self {
        let mut lanes = [0.0; N];
        lanes.copy_from_slice(&values[start..start + N]);
        Lanes(lanes)
    }

    /// Takes the values from `start` on, and fills up with the last one.
    ///
    /// # Panics
    ///
    /// If there is no value from `start` on.
    #[inline(always)]
    pub fn load_tail(values: &[f64], start: usize) -> Self {
        let tail = &values[start..];
        let mut lanes = [tail[tail.len() - 1]; N];
        for (lane, value) in lanes.iter_mut().zip(tail) {
            *lane = *value;
        }
        Lanes(lanes)
    }

    /// Writes `N` values.
    ///
    /// # Panics
    ///
    /// If there is no room for `N` values from `start` on.
    #[inline(always)]
    pub fn store(self, values: &mut [f64], start: usize) {
        values[start..start + N].copy_from_slice(&self.0);
    }

    /// Writes as many values as there is room for.
    ///
    /// # Panics
    ///
    /// If `start` is beyond the end.
    #[inline(always)]
    pub fn store_tail(self, values: &mut [f64], start: usize) {
        for (value, lane) in values[start..].iter_mut().zip(self.0) {
            *value = lane;
        }
    }
}

// Loops and no closures: a closure is no part of the function that the instruction set is enabled for.
macro_rules! lanewise {
    ($trait:ident, $method:ident, $sign:tt) => {
        impl<const N: usize, const FUSED: bool> $trait for Lanes<N, FUSED> {
            type Output = Self;

            #[inline(always)]
            fn $method(mut self, other: Self) -> Self {
                for lane in 0..N {
                    self.0[lane] $sign other.0[lane];
                }
                self
            }
        }

        impl<const N: usize, const FUSED: bool> $trait<f64> for Lanes<N, FUSED> {
            type Output = Self;

            #[inline(always)]
            fn $method(mut self, other: f64) -> Self {
                for lane in 0..N {
                    self.0[lane] $sign other;
                }
                self
            }
        }
    };
}

lanewise!(Add, add, +=);
lanewise!(Sub, sub, -=);
lanewise!(Mul, mul, *=);
lanewise!(Div, div, /=);

impl<const N: usize, const FUSED: bool> Neg for Lanes<N, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn neg(mut self) -> Self {
        for lane in 0..N {
            self.0[lane] = -self.0[lane];
        }
        self
    }
}

impl<const N: usize, const FUSED: bool> Arithmetic for Lanes<N, FUSED> {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Lanes([value; N])
    }

    #[inline(always)]
    fn multiply_add(mut self, factor: Self, addend: Self) -> Self {
        for lane in 0..N {
            self.0[lane] = match FUSED {
                true => fused(self.0[lane], factor.0[lane], addend.0[lane]),
                false => self.0[lane] * factor.0[lane] + addend.0[lane],
            };
        }
        self
    }

    #[inline(always)]
    fn square_root(mut self) -> Self {
        for lane in 0..N {
            self.0[lane] = square_root(self.0[lane]);
        }
        self
    }
}

/// Only inside a function that fused multiply-add is enabled for; elsewhere it is a slow call.
#[cfg(feature = "std")]
#[inline(always)]
fn fused(left: f64, right: f64, addend: f64) -> f64 {
    left.mul_add(right, addend)
}

/// `core` has no fused multiply-add.
#[cfg(not(feature = "std"))]
#[inline(always)]
fn fused(left: f64, right: f64, addend: f64) -> f64 {
    left * right + addend
}
