//! Arithmetic with adjoined roots.

use std::cell::Cell;
use std::cmp::Ordering;

use dashu_base::{BitTest, SquareRoot, UnsignedAbs};

use crate::algebra::number::Rational;

use super::{MOST_ROOTS, NILPOTENT, NILPOTENTS, Number};

/// How much work may be done between two calls of [`Extension::refill`]: products of machine words.
const MOST_WORK: u64 = 20_000_000;

/// The most machine words of a rational number.
const LONGEST: u64 = 20_000;

/// The adjoined roots, by their squares.
#[derive(Clone, Debug, Default)]
pub struct Extension {
    pub(super) squares: Vec<Rational>,
    work: Cell<u64>,
}

impl Extension {
    /// Allows more work.
    pub fn refill(&mut self) {
        self.work.set(0);
    }

    /// Whether too much work was asked for; products were left out then.
    pub fn is_exhausted(&self) -> bool {
        self.work.get() > MOST_WORK
    }

    /// a·b; 0 where that is too much work, see [`Extension::is_exhausted`].
    pub fn product(&self, a: &Number, b: &Number) -> Number {
        let (left, right) = (words(a), words(b));
        let work = if left.max(right) > LONGEST {
            u64::MAX
        } else {
            left * right
        };
        self.work.set(self.work.get().saturating_add(work));
        if self.is_exhausted() {
            return Number::default();
        }
        let pairs = a
            .parts
            .iter()
            .flat_map(|left| b.parts.iter().map(move |right| (left, right)));
        let products = pairs.filter_map(|((left, x), (right, y))| {
            let twice = left & right;
            if twice & NILPOTENT != 0 {
                return None;
            }
            let squares = self.squares.iter().enumerate();
            let squares =
                squares.filter(|(index, _)| twice & 1 << (NILPOTENTS + *index as u32) != 0);
            Some((
                left ^ right,
                squares.fold(x * y, |value, (_, square)| value * square),
            ))
        });
        Number::collect(products)
    }

    /// aⁿ
    pub fn power(&self, a: &Number, exponent: u64) -> Number {
        let (mut result, mut square, mut rest) = (Number::from(1), a.clone(), exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                result = self.product(&result, &square);
            }
            rest /= 2;
            if rest > 0 {
                square = self.product(&square, &square);
            }
        }
        result
    }

    /// 1/a, if a is invertible.
    pub fn inverse(&self, a: &Number) -> Option<Number> {
        let base = self.inverse_of_base(&a.base())?;
        // 1/(b + n) = (1/b) Σ (−n/b)ᵏ, a finite sum.
        let step = self.product(&a.step().negative(), &base);
        let (mut sum, mut power) = (Number::from(1), step.clone());
        while !power.is_zero() {
            sum = sum.sum(&power);
            power = self.product(&power, &step);
        }
        Some(self.product(&base, &sum))
    }

    /// 1/a of an a without nilpotent elements: by its conjugates, one root after the other.
    fn inverse_of_base(&self, a: &Number) -> Option<Number> {
        let (mut below, mut above) = (a.clone(), Number::from(1));
        for index in 0..self.squares.len() as u32 {
            let root = 1 << (NILPOTENTS + index);
            if below.parts.iter().any(|(set, _)| set & root != 0) {
                let mut conjugate = below.clone();
                for (set, value) in &mut conjugate.parts {
                    if *set & root != 0 {
                        *value *= -Rational::ONE;
                    }
                }
                above = self.product(&above, &conjugate);
                below = self.product(&below, &conjugate);
            }
        }
        let below = below.as_rational().filter(|below| !below.is_zero())?;
        Some(above.scale(&(Rational::ONE / below)))
    }

    /// How a compares with 0; nothing where it has no order, or where that is too much work.
    ///
    /// a + b√d with a and b of opposite signs has the sign of a times that of a² − b²d, the roots
    /// being taken off one after the other.
    pub fn order(&self, a: &Number) -> Option<Ordering> {
        let Some((highest, _)) = a.parts.last() else {
            return Some(Ordering::Equal);
        };
        if *highest == 0 {
            return a.as_rational().map(|a| a.cmp(&Rational::ZERO));
        }
        let top = u32::BITS - 1 - highest.leading_zeros();
        let root = 1 << top;
        let square = self.squares.get(top.checked_sub(NILPOTENTS)? as usize)?;
        if a.parts.iter().any(|(set, _)| set & NILPOTENT != 0) || *square < Rational::ZERO {
            return None;
        }
        let (rational, mut times) = (
            a.select(|set| set & root == 0),
            a.select(|set| set & root != 0),
        );
        times.parts.iter_mut().for_each(|(set, _)| *set &= !root);
        let (left, right) = (self.order(&rational)?, self.order(&times)?);
        if left == right || right == Ordering::Equal {
            return Some(left);
        }
        if left == Ordering::Equal {
            return Some(right);
        }
        let squares = self.product(&times, &times).scale(square);
        let norm = self.product(&rational, &rational).difference(&squares);
        let norm = self.order(&norm).filter(|_| !self.is_exhausted())?;
        Some(match left {
            Ordering::Greater => norm,
            _ => norm.reverse(),
        })
    }

    /// √a ≥ 0, with a new root adjoined where a rational number has none; nothing for nested roots,
    /// for 0 + ε, and when there is no room.
    pub fn square_root(&mut self, a: &Number) -> Option<Number> {
        if a.is_zero() {
            return Some(Number::default());
        }
        let square = a.base().as_rational().filter(|square| !square.is_zero())?;
        let root = self.rational_root(&square)?;
        // √(b + n) = √b Σ binomial(1/2, k) (n/b)ᵏ, a finite sum.
        let step = a.step().scale(&(Rational::ONE / &square));
        let (mut sum, mut power, mut coefficient) = (Number::from(1), step.clone(), Rational::ONE);
        let mut k = 1;
        while !power.is_zero() {
            let half = Rational::ONE / Rational::from(2);
            coefficient = coefficient * (half - Rational::from(k - 1)) / Rational::from(k);
            sum = sum.sum(&power.scale(&coefficient));
            power = self.product(&power, &step);
            k += 1;
        }
        Some(self.product(&root, &sum))
    }

    fn rational_root(&mut self, square: &Rational) -> Option<Number> {
        if let Some(root) = exact_root(square) {
            return Some(Number::from(root));
        }
        self.adjoin(square.clone())
    }

    /// The element with the given square that is not negative (or i, for −1): a rational multiple of a
    /// product of those that are there, if it is one, else a new one, if there is room.
    pub fn adjoin(&mut self, square: Rational) -> Option<Number> {
        let known = self.squares.len();
        if let Some(index) = self.squares.iter().position(|known| *known == square) {
            return Some(Number::part(
                1 << (NILPOTENTS + index as u32),
                Rational::ONE,
            ));
        }
        for set in 1..1_u32 << known {
            let chosen = (0..known).filter(|index| set & 1 << index != 0);
            let product = chosen.fold(Rational::ONE, |product, index| {
                product * &self.squares[index]
            });
            if product > Rational::ZERO
                && let Some(root) = exact_root(&(&product * &square))
            {
                return Some(Number::part(set << NILPOTENTS, root / product));
            }
        }
        (known < MOST_ROOTS).then(|| {
            self.squares.push(square);
            Number::part(1 << (NILPOTENTS + known as u32), Rational::ONE)
        })
    }
}

/// √q ≥ 0 of the square of a rational number.
fn exact_root(square: &Rational) -> Option<Rational> {
    if *square < Rational::ZERO {
        return None;
    }
    let (above, below) = (square.numerator(), square.denominator());
    let (a, b) = (above.clone().unsigned_abs().sqrt(), below.sqrt());
    let root = Rational::from_parts(a.into(), b);
    (&root * &root == *square).then_some(root)
}

/// The machine words of a number's parts.
fn words(number: &Number) -> u64 {
    let of =
        |value: &Rational| (value.numerator().bit_len() + value.denominator().bit_len()) / 64 + 1;
    number
        .parts
        .iter()
        .map(|(_, value)| of(value))
        .sum::<usize>() as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_of_roots_are_ordered() {
        let mut extension = Extension::default();
        let mut root = |n: i64| extension.square_root(&Number::from(n)).unwrap();
        let (two, three, five) = (root(2), root(3), root(5));
        let imaginary = extension.adjoin(-Rational::ONE).unwrap();
        let number =
            |above: i64, below: i64| Number::from(Rational::from(above) / Rational::from(below));
        for (difference, expected) in [
            (two.difference(&number(3, 2)), Some(Ordering::Less)),
            (two.difference(&number(7, 5)), Some(Ordering::Greater)),
            (
                two.sum(&three).difference(&number(22, 7)),
                Some(Ordering::Greater),
            ),
            (two.sum(&three).difference(&five), Some(Ordering::Greater)),
            (five.difference(&two.sum(&three)), Some(Ordering::Less)),
            (number(0, 1), Some(Ordering::Equal)),
            (three.sum(&imaginary), None),
            (Number::nilpotent(0).unwrap(), None),
        ] {
            assert_eq!(extension.order(&difference), expected);
        }
    }
}
