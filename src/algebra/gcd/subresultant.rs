//! The gcd from the sequence of subresultants.

use super::{quotient, split_content};
use crate::algebra::budget::{Budget, Exhausted};
use crate::algebra::polynomial::Polynomial;
use crate::algebra::symbol::Symbol;

/// The gcd of two polynomials without contents in `symbol`, by the sequence of
/// their subresultants; its degree is known not to exceed `bound`.
///
/// A member of the sequence whose degree is `bound` is tried as soon as it
/// appears: if it divides both without its content, it is the gcd, and the
/// last and most expensive remainder need not be computed.
pub(super) fn gcd(
    left: Polynomial,
    right: Polynomial,
    symbol: Symbol,
    bound: u32,
    budget: &Budget,
) -> Result<Polynomial, Exhausted> {
    let (mut high, mut low) = if left.degree_in(symbol) < right.degree_in(symbol) {
        (right.clone(), left.clone())
    } else {
        (left.clone(), right.clone())
    };
    // The names are those of Brown's algorithm: g is the leading coefficient
    // of the last but one remainder, h the one of its subresultant.
    let (mut g, mut h) = (Polynomial::one(), Polynomial::one());
    loop {
        let degree = low.degree_in(symbol);
        if degree == 0 {
            return Ok(if low.is_zero() {
                split_content(&high, symbol, budget)?.1
            } else {
                Polynomial::one()
            });
        }
        if degree == bound {
            let candidate = split_content(&low, symbol, budget)?.1;
            if left.divide_exact(&candidate, budget)?.is_some()
                && right.divide_exact(&candidate, budget)?.is_some()
            {
                return Ok(candidate);
            }
        }
        let gap = high.degree_in(symbol) - degree;
        let remainder = high.pseudo_remainder(&low, symbol, budget)?;
        let divisor = g.multiply(&h.power(gap, budget)?, budget)?;
        high = std::mem::replace(&mut low, quotient(&remainder, &divisor, budget)?);
        g = high.coefficient_in(symbol, degree);
        if let Some(less) = gap.checked_sub(1) {
            h = quotient(&g.power(gap, budget)?, &h.power(less, budget)?, budget)?;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::polynomial::notation::{polynomial, symbol};

    #[test]
    fn the_sequence_ends_at_the_gcd_whatever_the_bound_is() {
        for (left, right, expected, degree) in [
            ("a^2 - b^2", "a^2 + 2*a*b + b^2", "a + b", 1),
            ("a^2 + b", "a^3 + b", "1", 0),
            // Knuth's example: coprime, with a long sequence of remainders.
            (
                "a^8 + a^6 - 3*a^4 - 3*a^3 + 8*a^2 + 2*a - 5",
                "3*a^6 + 5*a^4 - 4*a^2 - 9*a + 21",
                "1",
                0,
            ),
            ("a^5 - b^5", "a^7 - b^7", "a - b", 1),
            ("b*a^3 + a^2 + b*a + 1", "b^2*a^2 - 1", "b*a + 1", 1),
        ] {
            let (left, right) = (polynomial(left), polynomial(right));
            for bound in degree
                ..=left
                    .degree_in(symbol('a'))
                    .min(right.degree_in(symbol('a')))
            {
                let budget = Budget::new(100_000);
                let found = gcd(left.clone(), right.clone(), symbol('a'), bound, &budget).unwrap();
                assert_eq!(found.with_positive_leading(), polynomial(expected));
            }
        }
    }

    #[test]
    fn coefficients_stay_as_short_as_determinants() {
        // Without dividing by the right factors they double in length with
        // every remainder, and there are fifteen.
        let left = (0..=15).map(|e| polynomial(&format!("{}*a^{e}", e * e % 7 + 1)));
        let left = left.fold(Polynomial::zero(), |sum, term| &sum + &term);
        let right = &left.derivative(symbol('a')) + &Polynomial::one();
        let budget = Budget::new(20_000);
        let found = gcd(left, right, symbol('a'), 0, &budget);
        assert_eq!(found, Ok(Polynomial::one()));
    }
}
