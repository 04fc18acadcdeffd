//! Rational numbers extended by elements with a given rational square.

pub mod extension;

use smallvec::{SmallVec, smallvec};

use crate::algebra::number::Rational;

use extension::Extension;

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
