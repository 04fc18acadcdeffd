//! Rational numbers extended by elements with a given rational square.

use std::cell::Cell;

use smallvec::{SmallVec, smallvec};

use dashu_base::BitTest;

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
    /// By increasing set. Most numbers are rational: they have one part.
    parts: SmallVec<[(u32, Rational); 1]>,
}

/// The adjoined roots, by their squares.
#[derive(Clone, Debug, Default)]
pub struct Extension {
    squares: Vec<Rational>,
    work: Cell<u64>,
}

/// How much work may be done between two calls of [`Extension::refill`]: products of machine words.
const MOST_WORK: u64 = 20_000_000;

/// The most machine words of a rational number.
const LONGEST: u64 = 20_000;

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
        Number {
            parts: if value.is_zero() {
                SmallVec::new()
            } else {
                smallvec![(set, value)]
            },
        }
    }

    /// The sum of parts in any order.
    fn collect(parts: impl Iterator<Item = (u32, Rational)>) -> Self {
        let mut parts: SmallVec<[(u32, Rational); 1]> = parts.collect();
        parts.sort_by_key(|(set, _)| *set);
        parts.dedup_by(|(set, value), (kept, sum)| {
            let same = set == kept;
            if same {
                *sum += &*value;
            }
            same
        });
        parts.retain(|(_, value)| !value.is_zero());
        Number { parts }
    }

    /// The parts whose sets are wanted.
    fn select(&self, wanted: impl Fn(u32) -> bool) -> Self {
        Number {
            parts: self
                .parts
                .iter()
                .filter(|(set, _)| wanted(*set))
                .cloned()
                .collect(),
        }
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
        match &self.parts[..] {
            [] => Some(Rational::ZERO),
            [(0, value)] => Some(value.clone()),
            _ => None,
        }
    }

    /// What is left when every nilpotent element becomes 0.
    pub fn base(&self) -> Self {
        self.select(|set| set & NILPOTENT == 0)
    }

    /// What vanishes when every nilpotent element becomes 0.
    pub fn step(&self) -> Self {
        self.select(|set| set & NILPOTENT != 0)
    }

    /// The coefficient of the product of the nilpotent elements with the given indices.
    pub fn coefficient(&self, indices: std::ops::Range<u32>) -> Self {
        let wanted = indices.fold(0, |set, index| set | 1 << index);
        let mut coefficient = self.select(|set| set & wanted == wanted);
        coefficient
            .parts
            .iter_mut()
            .for_each(|(set, _)| *set &= !wanted);
        coefficient
    }

    /// The terms free of the nilpotent elements with the given indices.
    pub fn without(&self, indices: std::ops::Range<u32>) -> Self {
        let unwanted = indices.fold(0, |set, index| set | 1 << index);
        self.select(|set| set & unwanted == 0)
    }

    /// a + b
    pub fn sum(&self, other: &Self) -> Self {
        match (&self.parts[..], &other.parts[..]) {
            (_, []) => self.clone(),
            ([], _) => other.clone(),
            ([(set, a)], [(other, b)]) if set == other => Number::part(*set, a + b),
            (a, b) => Number::collect(a.iter().chain(b).cloned()),
        }
    }

    /// −a
    pub fn negative(&self) -> Self {
        Number {
            parts: self
                .parts
                .iter()
                .map(|(set, value)| (*set, -value.clone()))
                .collect(),
        }
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
        Number {
            parts: self
                .parts
                .iter()
                .map(|(set, value)| (*set, value * factor))
                .collect(),
        }
    }

    /// As a person reads it: `3/2 + 5*sqrt(2)`.
    pub fn display(&self, extension: &Extension) -> String {
        let mut text = String::new();
        for (set, value) in &self.parts {
            let roots =
                (0..MOST_ROOTS).filter(|root| set & (1 << (NILPOTENTS + *root as u32)) != 0);
            let roots = roots.filter_map(|root| extension.squares.get(root));
            let roots: Vec<String> = roots.map(|square| format!("sqrt({square})")).collect();
            let sign = match (text.is_empty(), *value < Rational::ZERO) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            let size = if *value < Rational::ZERO {
                -value.clone()
            } else {
                value.clone()
            };
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
    use dashu_base::{SquareRoot, UnsignedAbs};
    let (above, below) = (square.numerator(), square.denominator());
    let (a, b) = (above.clone().unsigned_abs().sqrt(), below.sqrt());
    let root = Rational::from_parts(a.into(), b);
    (&root * &root == *square).then_some(root)
}
