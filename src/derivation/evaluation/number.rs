//! Rational numbers extended by elements with a given rational square.

use std::collections::BTreeMap;

use crate::algebra::number::Rational;

/// The first elements are nilpotent: ε² = 0.
const NILPOTENTS: u32 = 20;

/// The bits of all nilpotent elements.
const NILPOTENT: u32 = (1 << NILPOTENTS) - 1;

/// How many roots may be adjoined.
const MOST_ROOTS: usize = (u32::BITS - NILPOTENTS) as usize;

/// Σ qₛ eₛ over sets S of adjoined elements, eₛ being their product; no qₛ is 0.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Number {
    parts: BTreeMap<u32, Rational>,
}

/// The adjoined roots, by their squares.
#[derive(Clone, Debug, Default)]
pub struct Extension {
    squares: Vec<Rational>,
}

impl From<Rational> for Number {
    fn from(value: Rational) -> Self {
        Number::part(0, value)
    }
}

impl From<i64> for Number {
    fn from(value: i64) -> Self {
        Number::from(Rational::from(value))
    }
}

impl Number {
    fn part(set: u32, value: Rational) -> Self {
        let parts = if value.is_zero() { BTreeMap::new() } else { BTreeMap::from([(set, value)]) };
        Number { parts }
    }

    /// The nilpotent element of an index, if there are so many.
    pub fn nilpotent(index: u32) -> Option<Self> {
        (index < NILPOTENTS).then(|| Number::part(1 << index, Rational::ONE))
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.parts.is_empty()
    }

    /// The rational number this is, if it is one.
    pub fn as_rational(&self) -> Option<Rational> {
        match self.parts.len() {
            0 => Some(Rational::ZERO),
            1 => self.parts.get(&0).cloned(),
            _ => None,
        }
    }

    /// What is left when every nilpotent element becomes 0.
    pub fn base(&self) -> Self {
        let parts = self.parts.iter().filter(|(set, _)| *set & NILPOTENT == 0);
        Number { parts: parts.map(|(set, value)| (*set, value.clone())).collect() }
    }

    /// The coefficient of the product of the nilpotent elements with the given indices.
    pub fn coefficient(&self, indices: std::ops::Range<u32>) -> Self {
        let wanted = indices.fold(0, |set, index| set | 1 << index);
        let parts = self.parts.iter().filter(|(set, _)| *set & wanted == wanted);
        Number { parts: parts.map(|(set, value)| (set & !wanted, value.clone())).collect() }
    }

    /// The terms free of the nilpotent elements with the given indices.
    pub fn without(&self, indices: std::ops::Range<u32>) -> Self {
        let unwanted = indices.fold(0, |set, index| set | 1 << index);
        let parts = self.parts.iter().filter(|(set, _)| *set & unwanted == 0);
        Number { parts: parts.map(|(set, value)| (*set, value.clone())).collect() }
    }

    /// a + b
    pub fn sum(&self, other: &Self) -> Self {
        let mut parts = self.parts.clone();
        for (set, value) in &other.parts {
            *parts.entry(*set).or_default() += value;
        }
        parts.retain(|_, value| !value.is_zero());
        Number { parts }
    }

    /// −a
    pub fn negative(&self) -> Self {
        Number { parts: self.parts.iter().map(|(set, value)| (*set, -value.clone())).collect() }
    }

    /// a − b
    pub fn difference(&self, other: &Self) -> Self {
        self.sum(&other.negative())
    }

    /// q·a
    pub fn scale(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Number::default();
        }
        Number { parts: self.parts.iter().map(|(set, value)| (*set, value * factor)).collect() }
    }

    /// As a person reads it: `3/2 + 5*sqrt(2)`.
    pub fn display(&self, extension: &Extension) -> String {
        let mut text = String::new();
        for (set, value) in &self.parts {
            let roots = (0..MOST_ROOTS).filter(|root| set & (1 << (NILPOTENTS + *root as u32)) != 0);
            let roots = roots.filter_map(|root| extension.squares.get(root));
            let roots: Vec<String> = roots.map(|square| format!("sqrt({square})")).collect();
            let sign = match (text.is_empty(), *value < Rational::ZERO) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            let size = if *value < Rational::ZERO { -value.clone() } else { value.clone() };
            text += sign;
            text += &match roots.len() {
                0 => size.to_string(),
                _ if size == Rational::ONE => roots.join("*"),
                _ => format!("{size}*{}", roots.join("*")),
            };
        }
        if text.is_empty() { "0".into() } else { text }
    }
}

impl Extension {
    /// a·b
    pub fn product(&self, a: &Number, b: &Number) -> Number {
        let mut parts: BTreeMap<u32, Rational> = BTreeMap::new();
        for (left, x) in &a.parts {
            for (right, y) in &b.parts {
                let twice = left & right;
                if twice & NILPOTENT != 0 {
                    continue;
                }
                let mut value = x * y;
                for (index, square) in self.squares.iter().enumerate() {
                    if twice & (1 << (NILPOTENTS + index as u32)) != 0 {
                        value *= square;
                    }
                }
                *parts.entry(left ^ right).or_default() += value;
            }
        }
        parts.retain(|_, value| !value.is_zero());
        Number { parts }
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
        let step = self.product(&a.base().difference(a), &base);
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
            if below.parts.keys().any(|set| set & root != 0) {
                let mut conjugate = below.clone();
                for (set, value) in &mut conjugate.parts {
                    if set & root != 0 {
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

    /// √a ≥ 0, with a new root adjoined where a rational number has none; nothing for nested roots,
    /// for 0 + ε, and when there is no room.
    pub fn square_root(&mut self, a: &Number) -> Option<Number> {
        if a.is_zero() {
            return Some(Number::default());
        }
        let square = a.base().as_rational().filter(|square| !square.is_zero())?;
        let root = self.rational_root(&square)?;
        // √(b + n) = √b Σ binomial(1/2, k) (n/b)ᵏ, a finite sum.
        let step = a.difference(&a.base()).scale(&(Rational::ONE / &square));
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

    /// The element with the given square, adjoined if it is not there yet and there is room.
    pub fn adjoin(&mut self, square: Rational) -> Option<Number> {
        let known = self.squares.iter().position(|known| *known == square);
        let index = known.unwrap_or(self.squares.len());
        if index >= MOST_ROOTS {
            return None;
        }
        if known.is_none() {
            self.squares.push(square);
        }
        Some(Number::part(1 << (NILPOTENTS + index as u32), Rational::ONE))
    }
}

/// √q ≥ 0 of the square of a rational number.
fn exact_root(square: &Rational) -> Option<Rational> {
    if *square < Rational::ZERO {
        return None;
    }
    use dashu_base::{SquareRoot, UnsignedAbs};
    let (above, below) = (square.numerator(), square.denominator());
    let (a, b) = (above.clone().unsigned_abs().sqrt(), below.sqrt());
    let root = Rational::from_parts(a.into(), b);
    (&root * &root == *square).then_some(root)
}
