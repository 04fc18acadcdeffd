//! Products of powers of symbols.

use std::fmt;

use smallvec::SmallVec;

use super::budget::{Exhausted, check_exponent};
use super::symbol::Symbol;

/// A product of powers of symbols, such as `a²·b`; the empty product is one.
///
/// Monomials are ordered lexicographically: the symbol with the lowest index
/// decides first, and there the higher exponent is the greater one. The order
/// respects products: `p < q` implies `p·m < q·m`.
///
/// ```
/// use sextic::algebra::{monomial::Monomial, symbol::Symbol};
///
/// let (a, b) = (Symbol::new(0), Symbol::new(1));
/// assert!(Monomial::power(a, 1) > Monomial::power(b, 5));
/// assert!(Monomial::power(b, 5) > Monomial::one());
/// ```
#[derive(Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial {
    /// By increasing symbol, none with exponent zero. As a lower symbol is a
    /// greater [`Power`], comparing these lists *is* the lexicographic order.
    powers: SmallVec<[Power; 12]>,
}

/// A power of one symbol: in the upper half the number of the symbol counted
/// from the end, in the lower half the exponent.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
struct Power(u32);

impl Power {
    fn new(symbol: Symbol, exponent: u16) -> Self {
        Power(u32::from(!symbol.number()) << 16 | u32::from(exponent))
    }

    fn symbol(self) -> Symbol {
        Symbol::new(!((self.0 >> 16) as u16))
    }

    fn exponent(self) -> u16 {
        self.0 as u16
    }
}

impl Monomial {
    /// The empty product.
    pub fn one() -> Self {
        Monomial::default()
    }

    /// `symbol^exponent`.
    pub fn power(symbol: Symbol, exponent: u16) -> Self {
        let mut power = Monomial::one();
        power.push(symbol, exponent);
        power
    }

    /// Whether this is the empty product.
    pub fn is_one(&self) -> bool {
        self.powers.is_empty()
    }

    /// The exponent of `symbol`, zero where it does not occur.
    pub fn exponent(&self, symbol: Symbol) -> u32 {
        let found = self.powers.iter().find(|power| power.symbol() == symbol);
        found.map_or(0, |power| u32::from(power.exponent()))
    }

    /// The symbols that occur, in increasing order, with their exponents.
    pub fn factors(&self) -> impl Iterator<Item = (Symbol, u32)> + '_ {
        let factor = |power: &Power| (power.symbol(), u32::from(power.exponent()));
        self.powers.iter().map(factor)
    }

    /// The sum of all exponents.
    pub fn degree(&self) -> u32 {
        self.factors().map(|(_, exponent)| exponent).sum()
    }

    /// `self · other`.
    ///
    /// # Errors
    ///
    /// [`Exhausted`] if an exponent exceeds
    /// [`LARGEST_EXPONENT`](super::budget::LARGEST_EXPONENT).
    pub fn product(&self, other: &Self) -> Result<Self, Exhausted> {
        if self.is_one() || other.is_one() {
            return Ok(if self.is_one() { other } else { self }.clone());
        }
        let mut product = Monomial::one();
        for (symbol, left, right) in self.aligned(other) {
            product.push(symbol, check_exponent(u64::from(left) + u64::from(right))?);
        }
        Ok(product)
    }

    /// `self^exponent`.
    ///
    /// # Errors
    ///
    /// [`Exhausted`] if an exponent exceeds
    /// [`LARGEST_EXPONENT`](super::budget::LARGEST_EXPONENT).
    pub fn raised(&self, exponent: u32) -> Result<Self, Exhausted> {
        let mut power = Monomial::one();
        for (symbol, own) in self.factors() {
            let product = u64::from(own) * u64::from(exponent);
            if product > 0 {
                power.push(symbol, check_exponent(product)?);
            }
        }
        Ok(power)
    }

    /// `self / divisor`, or `None` where it does not divide.
    pub fn quotient(&self, divisor: &Self) -> Option<Self> {
        let mut quotient = Monomial::one();
        for (symbol, left, right) in self.aligned(divisor) {
            quotient.push(symbol, left.checked_sub(right)?);
        }
        Some(quotient)
    }

    /// `self / gcd(self, divisor)`.
    pub(super) fn over(&self, divisor: &Self) -> Self {
        let mut quotient = Monomial::one();
        for (symbol, left, right) in self.aligned(divisor) {
            quotient.push(symbol, left.saturating_sub(right));
        }
        quotient
    }

    /// The greatest common divisor.
    pub fn gcd(&self, other: &Self) -> Self {
        let mut gcd = Monomial::one();
        if self.is_one() || other.is_one() {
            return gcd;
        }
        for (symbol, left, right) in self.aligned(other) {
            gcd.push(symbol, left.min(right));
        }
        gcd
    }

    /// `self` with every power of `symbol` left out.
    pub fn without(&self, symbol: Symbol) -> Self {
        let mut others = self.clone();
        others.powers.retain(|power| power.symbol() != symbol);
        others
    }

    /// Splits into the powers of the symbols that `chosen` picks and the others.
    pub(super) fn partition(&self, chosen: impl Fn(Symbol) -> bool) -> (Self, Self) {
        let (mut picked, mut others) = (Monomial::one(), Monomial::one());
        for &power in &self.powers {
            let part = if chosen(power.symbol()) {
                &mut picked
            } else {
                &mut others
            };
            part.powers.push(power);
        }
        (picked, others)
    }

    /// Multiplies by the power of a symbol beyond all those that occur.
    pub(super) fn push(&mut self, symbol: Symbol, exponent: u16) {
        debug_assert!(self.powers.last().is_none_or(|last| last.symbol() < symbol));
        if exponent != 0 {
            self.powers.push(Power::new(symbol, exponent));
        }
    }

    /// Every symbol of either, in increasing order, with its exponent in both.
    fn aligned<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = (Symbol, u16, u16)> + 'a {
        let (mut left, mut right) = (&*self.powers, &*other.powers);
        std::iter::from_fn(move || {
            let symbol = match (left.first(), right.first()) {
                (Some(left), Some(right)) => left.symbol().min(right.symbol()),
                (Some(power), None) | (None, Some(power)) => power.symbol(),
                (None, None) => return None,
            };
            Some((
                symbol,
                take_exponent(&mut left, symbol),
                take_exponent(&mut right, symbol),
            ))
        })
    }
}

/// The exponent of a symbol that none comes before, whose power is taken away.
fn take_exponent(powers: &mut &[Power], symbol: Symbol) -> u16 {
    match powers {
        [first, rest @ ..] if first.symbol() == symbol => {
            *powers = rest;
            first.exponent()
        }
        _ => 0,
    }
}

impl Clone for Monomial {
    /// The derived one would copy power by power.
    fn clone(&self) -> Self {
        Monomial {
            powers: SmallVec::from_slice(&self.powers),
        }
    }
}

impl fmt::Debug for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_one() {
            return f.write_str("1");
        }
        for (place, (symbol, exponent)) in self.factors().enumerate() {
            let times = if place == 0 { "" } else { "*" };
            write!(f, "{times}x{}", symbol.index())?;
            if exponent != 1 {
                write!(f, "^{exponent}")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn monomial(exponents: &[u16]) -> Monomial {
        let mut monomial = Monomial::one();
        for (index, &exponent) in (0..).zip(exponents) {
            monomial.push(Symbol::new(index), exponent);
        }
        monomial
    }

    #[test]
    fn products_quotients_and_gcds_add_subtract_and_compare_exponents() {
        let (left, right) = (monomial(&[2, 0, 1]), monomial(&[1, 3]));
        assert_eq!(left.product(&right), Ok(monomial(&[3, 3, 1])));
        assert_eq!(left.quotient(&right), None);
        assert_eq!(left.quotient(&monomial(&[1, 0, 1])), Some(monomial(&[1])));
        assert_eq!(left.gcd(&right), monomial(&[1]));
        assert_eq!(left.degree(), 3);
        assert_eq!(left.exponent(Symbol::new(2)), 1);
        assert_eq!(left.exponent(Symbol::new(1)), 0);
        assert_eq!(left.without(Symbol::new(0)), monomial(&[0, 0, 1]));
        assert!(monomial(&[u16::MAX]).product(&monomial(&[1])).is_err());
    }

    #[test]
    fn the_order_is_lexicographic() {
        let ascending = [
            monomial(&[]),
            monomial(&[0, 0, 9]),
            monomial(&[0, 1]),
            monomial(&[0, 1, 1]),
            monomial(&[0, 2]),
            monomial(&[1]),
            monomial(&[1, 0, 7]),
            monomial(&[1, 1]),
            monomial(&[2]),
        ];
        assert!(ascending.is_sorted_by(|left, right| left < right));
    }

    #[test]
    fn a_symbol_of_any_index_comes_back() {
        for index in [0, 1, 255, 256, u16::MAX] {
            let factors: Vec<_> = Monomial::power(Symbol::new(index), 3).factors().collect();
            assert_eq!(factors, [(Symbol::new(index), 3)]);
        }
    }
}
