//! Angles: sums of angular symbols with integer coefficients, and a basis of them.

use std::collections::{BTreeMap, BTreeSet};

use dashu_base::{Gcd, UnsignedAbs};
use dashu_int::UBig;

use super::number::{Integer, Rational};
use super::symbol::Symbol;

/// Σ kᵢ aᵢ with integers kᵢ ≠ 0 and angular symbols aᵢ.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Angle {
    coefficients: BTreeMap<Symbol, Integer>,
}

impl Angle {
    /// The angle with the given coefficients; zeros are dropped.
    pub fn new(coefficients: impl IntoIterator<Item = (Symbol, Integer)>) -> Self {
        let coefficients = coefficients
            .into_iter()
            .filter(|(_, coefficient)| !coefficient.is_zero())
            .collect();
        Angle { coefficients }
    }

    /// The symbols and their coefficients, in order of the symbols.
    pub fn coefficients(&self) -> impl Iterator<Item = (Symbol, &Integer)> {
        self.coefficients.iter().map(|(symbol, k)| (*symbol, k))
    }

    /// Whether the angle is 0.
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// (B, k) with A = k·B for A ≠ 0, where the coefficients of B have no common divisor and the first
    /// of them is positive; (0, 0) for A = 0.
    pub fn primitive(&self) -> (Self, Integer) {
        let magnitude = self.coefficients.values().fold(UBig::ZERO, |divisor, k| {
            if divisor.is_zero() {
                k.unsigned_abs()
            } else {
                divisor.gcd(k.unsigned_abs())
            }
        });
        let negative = self
            .coefficients
            .values()
            .next()
            .is_some_and(|first| *first < Integer::ZERO);
        let k = if negative {
            -Integer::from(magnitude)
        } else {
            Integer::from(magnitude)
        };
        (
            Angle::new(self.coefficients().map(|(symbol, own)| (symbol, own / &k))),
            k,
        )
    }

    /// A without the given symbol, and that symbol's coefficient.
    pub fn split_off(&self, symbol: Symbol) -> (Self, Integer) {
        let mut rest = self.clone();
        let coefficient = rest.coefficients.remove(&symbol).unwrap_or(Integer::ZERO);
        (rest, coefficient)
    }
}

/// How an angle stands to a basis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Decomposition {
    /// It is Σ kᵢ Bᵢ with these integers.
    Integral(Vec<Integer>),
    /// It is Σ qᵢ Bᵢ, but not all qᵢ are integers: its sine is not a polynomial in the basis' sines.
    Fractional,
    /// It is no combination of the basis.
    Independent,
}

/// Writes an angle as a combination of linearly independent basis angles.
///
/// Complexity: one elimination of a matrix with a row for each symbol and a column for each basis
/// angle.
///
/// ```
/// use sextic::algebra::{angle::{Angle, Decomposition, decompose}, symbol::Symbol};
///
/// let [a, b] = [Symbol::new(0), Symbol::new(1)];
/// let angle = |k: i32, l: i32| Angle::new([(a, k.into()), (b, l.into())]);
/// // b = (a + b) − a
/// let found = decompose(&angle(0, 1), &[angle(1, 1), angle(1, 0)]);
/// assert_eq!(found, Decomposition::Integral(vec![1.into(), (-1).into()]));
/// ```
pub fn decompose(angle: &Angle, basis: &[Angle]) -> Decomposition {
    let symbols: BTreeSet<Symbol> = basis
        .iter()
        .chain([angle])
        .flat_map(|angle| angle.coefficients.keys().copied())
        .collect();
    let coefficient = |angle: &Angle, symbol: &Symbol| {
        Rational::from(angle.coefficients.get(symbol).cloned().unwrap_or_default())
    };
    // One row for each symbol: the basis' coefficients, then the angle's.
    let mut rows: Vec<Vec<Rational>> = symbols
        .iter()
        .map(|symbol| {
            let columns = basis.iter().chain([angle]);
            columns.map(|column| coefficient(column, symbol)).collect()
        })
        .collect();
    for column in 0..basis.len() {
        let Some(pivot) = (column..rows.len()).find(|&row| !rows[row][column].is_zero()) else {
            return Decomposition::Independent;
        };
        rows.swap(column, pivot);
        let pivot_row = rows[column].clone();
        for (index, row) in rows.iter_mut().enumerate() {
            if index != column && !row[column].is_zero() {
                let factor = &row[column] / &pivot_row[column];
                for (entry, pivot_entry) in row.iter_mut().zip(&pivot_row) {
                    *entry = &*entry - &factor * pivot_entry;
                }
            }
        }
    }
    if rows[basis.len()..]
        .iter()
        .any(|row| !row[basis.len()].is_zero())
    {
        return Decomposition::Independent;
    }
    let combination: Option<Vec<Integer>> = (0..basis.len())
        .map(|index| {
            let value = &rows[index][basis.len()] / &rows[index][index];
            value.is_int().then(|| value.into_parts().0)
        })
        .collect();
    combination.map_or(Decomposition::Fractional, Decomposition::Integral)
}
