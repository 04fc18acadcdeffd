//! Which signs a quantity can have, and arithmetic with that knowledge.

use std::collections::BTreeMap;
use std::fmt;

use super::monomial::Monomial;
use super::number::Integer;
use super::polynomial::Polynomial;
use super::symbol::Symbol;

/// A set of signs: those a quantity may have as far as is known.
///
/// ```
/// use sextic::algebra::sign::Signs;
///
/// assert_eq!(Signs::POSITIVE.sum(Signs::NON_NEGATIVE), Signs::POSITIVE);
/// assert_eq!(Signs::POSITIVE.sum(Signs::NEGATIVE), Signs::ANY);
/// assert_eq!(Signs::NON_ZERO.power(2), Signs::POSITIVE);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signs {
    /// It may be below 0.
    pub negative: bool,
    /// It may be 0.
    pub zero: bool,
    /// It may be above 0.
    pub positive: bool,
}

impl Signs {
    /// Nothing is known.
    pub const ANY: Signs = Signs {
        negative: true,
        zero: true,
        positive: true,
    };
    /// There is no such number.
    pub const NONE: Signs = Signs {
        negative: false,
        zero: false,
        positive: false,
    };
    /// > 0
    pub const POSITIVE: Signs = Signs {
        negative: false,
        zero: false,
        positive: true,
    };
    /// < 0
    pub const NEGATIVE: Signs = Signs {
        negative: true,
        zero: false,
        positive: false,
    };
    /// = 0
    pub const ZERO: Signs = Signs {
        negative: false,
        zero: true,
        positive: false,
    };
    /// ≥ 0
    pub const NON_NEGATIVE: Signs = Signs {
        negative: false,
        zero: true,
        positive: true,
    };
    /// ≠ 0
    pub const NON_ZERO: Signs = Signs {
        negative: true,
        zero: false,
        positive: true,
    };

    /// The sign of a number.
    pub fn of_integer(value: &Integer) -> Signs {
        match value.cmp(&Integer::ZERO) {
            std::cmp::Ordering::Less => Signs::NEGATIVE,
            std::cmp::Ordering::Equal => Signs::ZERO,
            std::cmp::Ordering::Greater => Signs::POSITIVE,
        }
    }

    /// The signs a + b can have.
    pub fn sum(self, other: Signs) -> Signs {
        let opposed = (self.negative && other.positive) || (self.positive && other.negative);
        Signs {
            negative: opposed
                || (self.negative && (other.negative || other.zero))
                || (self.zero && other.negative),
            zero: opposed || (self.zero && other.zero),
            positive: opposed
                || (self.positive && (other.positive || other.zero))
                || (self.zero && other.positive),
        }
    }

    /// The signs a·b can have.
    pub fn product(self, other: Signs) -> Signs {
        Signs {
            negative: (self.negative && other.positive) || (self.positive && other.negative),
            zero: self.zero || other.zero,
            positive: (self.positive && other.positive) || (self.negative && other.negative),
        }
    }

    /// The signs −a can have.
    pub fn opposite(self) -> Signs {
        Signs {
            negative: self.positive,
            zero: self.zero,
            positive: self.negative,
        }
    }

    /// The signs aⁿ can have for a real a.
    pub fn power(self, exponent: u32) -> Signs {
        if exponent == 0 {
            Signs::POSITIVE
        } else if exponent.is_multiple_of(2) {
            Signs {
                negative: false,
                zero: self.zero,
                positive: self.positive || self.negative,
            }
        } else {
            self
        }
    }

    /// What is left when both are known to be true.
    pub fn intersection(self, other: Signs) -> Signs {
        Signs {
            negative: self.negative && other.negative,
            zero: self.zero && other.zero,
            positive: self.positive && other.positive,
        }
    }

    /// Whether every one of these signs is among the others.
    pub fn is_within(self, others: Signs) -> bool {
        self.intersection(others) == self
    }

    /// Whether a > 0 is certain.
    pub fn is_positive(self) -> bool {
        self == Signs::POSITIVE
    }

    /// Whether a ≥ 0 is certain.
    pub fn is_non_negative(self) -> bool {
        !self.negative
    }

    /// Whether a ≠ 0 is certain.
    pub fn is_non_zero(self) -> bool {
        !self.zero
    }
}

impl Signs {
    /// What is known, as one says it.
    pub fn in_words(self) -> &'static str {
        match (self.negative, self.zero, self.positive) {
            (true, true, true) => "any real number",
            (true, true, false) => "negative or 0",
            (true, false, true) => "not 0",
            (true, false, false) => "negative",
            (false, true, true) => "0 or positive",
            (false, true, false) => "0",
            (false, false, true) => "positive",
            (false, false, false) => "no number at all",
        }
    }
}

impl fmt::Display for Signs {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match (self.negative, self.zero, self.positive) {
            (true, true, true) => "real",
            (true, true, false) => "≤ 0",
            (true, false, true) => "≠ 0",
            (true, false, false) => "< 0",
            (false, true, true) => "≥ 0",
            (false, true, false) => "= 0",
            (false, false, true) => "> 0",
            (false, false, false) => "impossible",
        })
    }
}

/// What is assumed of symbols and of polynomials in them.
#[derive(Clone, Debug, Default)]
pub struct Assumptions {
    symbols: BTreeMap<Symbol, Signs>,
    complex: Vec<Symbol>,
    polynomials: Vec<(Polynomial, Signs)>,
}

impl Assumptions {
    /// Notes what is known of a symbol, on top of what was known before.
    pub fn assume_symbol(&mut self, symbol: Symbol, signs: Signs) {
        let known = self.of_symbol(symbol).intersection(signs);
        self.symbols.insert(symbol, known);
    }

    /// Notes that a symbol is not real, so that its even powers may be negative.
    pub fn assume_complex(&mut self, symbol: Symbol) {
        self.complex.push(symbol);
    }

    /// Whether a symbol may have values that are not real.
    pub fn is_complex(&self, symbol: Symbol) -> bool {
        self.complex.contains(&symbol)
    }

    /// Notes what is known of a polynomial.
    pub fn assume_polynomial(&mut self, polynomial: Polynomial, signs: Signs) {
        self.polynomials.push((polynomial, signs));
    }

    /// The polynomials of which something was assumed.
    pub fn polynomials(&self) -> &[(Polynomial, Signs)] {
        &self.polynomials
    }

    /// What is known of a symbol.
    pub fn of_symbol(&self, symbol: Symbol) -> Signs {
        self.symbols.get(&symbol).copied().unwrap_or(Signs::ANY)
    }

    /// What is known of a product of powers.
    fn of_monomial(&self, monomial: &Monomial) -> Signs {
        monomial
            .factors()
            .fold(Signs::POSITIVE, |signs, (symbol, exponent)| {
                let power = if self.complex.contains(&symbol) {
                    Signs::ANY
                } else {
                    self.of_symbol(symbol).power(exponent)
                };
                signs.product(power)
            })
    }

    /// What the signs of its terms tell of a polynomial.
    pub fn of_terms(&self, polynomial: &Polynomial) -> Signs {
        polynomial
            .terms()
            .iter()
            .fold(Signs::ZERO, |signs, (monomial, coefficient)| {
                let term = self
                    .of_monomial(monomial)
                    .product(Signs::of_integer(coefficient));
                signs.sum(term)
            })
    }
}
