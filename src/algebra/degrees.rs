//! The highest exponents of all symbols at once.

use std::collections::BTreeSet;

use super::budget::{Exhausted, check_exponent};
use super::monomial::Monomial;
use super::polynomial::Polynomial;
use super::symbol::Symbol;

/// So many symbols take one allocation.
const USUAL_SYMBOLS: usize = 64;

/// The highest exponent of every symbol in a polynomial.
///
/// Degrees of a product are the sums of the degrees of its factors, as the
/// leading coefficients cannot cancel.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Degrees {
    /// By the index of the symbol; those beyond the end are zero.
    by_index: Vec<u32>,
}

impl Polynomial {
    /// The symbols that occur.
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        Degrees::of(self).iter().map(|(symbol, _)| symbol).collect()
    }
}

impl Degrees {
    /// The degrees of a polynomial.
    pub(super) fn of(polynomial: &Polynomial) -> Self {
        Degrees::of_all([polynomial].into_iter())
    }

    /// The highest degrees of several polynomials.
    pub(super) fn of_all<'p>(polynomials: impl Iterator<Item = &'p Polynomial>) -> Self {
        let mut degrees = Degrees {
            by_index: Vec::with_capacity(USUAL_SYMBOLS),
        };
        for (monomial, _) in polynomials.flat_map(Polynomial::terms) {
            for (symbol, exponent) in monomial.factors() {
                let degree = degrees.entry(symbol);
                *degree = exponent.max(*degree);
            }
        }
        degrees
    }

    /// The degree in `symbol`.
    pub(super) fn get(&self, symbol: Symbol) -> u32 {
        self.by_index.get(symbol.index()).copied().unwrap_or(0)
    }

    /// The place of the degree in `symbol`.
    pub(super) fn entry(&mut self, symbol: Symbol) -> &mut u32 {
        let index = symbol.index();
        if index >= self.by_index.len() {
            self.by_index.resize(index + 1, 0);
        }
        &mut self.by_index[index]
    }

    /// No more symbols than this have a positive degree.
    pub(super) fn len(&self) -> usize {
        self.by_index.len()
    }

    /// The symbols of positive degree, in increasing order, with their degrees.
    pub(super) fn iter(&self) -> impl Iterator<Item = (Symbol, u32)> + '_ {
        let all = self.by_index.iter().enumerate();
        let present = all.filter(|&(_, degree)| *degree != 0);
        present.map(|(index, degree)| (Symbol::new(index as u16), *degree))
    }

    /// Makes every degree at least that of the other.
    pub(super) fn raise(&mut self, other: &Self) {
        for (symbol, degree) in other.iter() {
            let entry = self.entry(symbol);
            *entry = degree.max(*entry);
        }
    }

    /// The degrees of a product of polynomials of these degrees.
    pub(super) fn sum(&self, other: &Self) -> Result<Self, Exhausted> {
        let mut sum = self.clone();
        for (symbol, degree) in other.iter() {
            let entry = sum.entry(symbol);
            *entry = check_exponent(u64::from(*entry) + u64::from(degree))?.into();
        }
        Ok(sum)
    }

    /// The degrees of a quotient of polynomials of these degrees, `None` if one
    /// of them is negative.
    pub(super) fn difference(&self, other: &Self) -> Option<Self> {
        let mut difference = self.clone();
        for (symbol, degree) in other.iter() {
            let entry = difference.entry(symbol);
            *entry = entry.checked_sub(degree)?;
        }
        Some(difference)
    }

    /// The least monomial of these degrees.
    pub(super) fn monomial(&self) -> Result<Monomial, Exhausted> {
        let mut monomial = Monomial::one();
        for (symbol, degree) in self.iter() {
            monomial.push(symbol, check_exponent(degree.into())?);
        }
        Ok(monomial)
    }
}

#[cfg(test)]
mod tests {
    use super::super::polynomial::notation::{polynomial, symbol};
    use super::*;

    #[test]
    fn degrees_add_and_subtract_like_those_of_products() {
        let (left, right) = (
            Degrees::of(&polynomial("a^2*c + b")),
            Degrees::of(&polynomial("c^3 + 1")),
        );
        let sum = left.sum(&right).unwrap();
        assert_eq!(
            ['a', 'b', 'c', 'd'].map(|letter| sum.get(symbol(letter))),
            [2, 1, 4, 0]
        );
        assert_eq!(sum.difference(&right).unwrap().monomial(), left.monomial());
        assert_eq!(left.difference(&right), None);
        let high = Degrees::of(&polynomial("a^65535"));
        assert!(high.sum(&left).is_err());
    }
}
