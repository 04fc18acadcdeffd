//! Square roots of perfect squares.

use dashu_base::{DivRem, Signed, SquareRootRem, UnsignedAbs};

use crate::algebra::budget::{Budget, Exhausted};
use crate::algebra::degrees::Degrees;
use crate::algebra::monomial::Monomial;
use crate::algebra::number::Integer;
use crate::algebra::polynomial::{Polynomial, Term};

impl Polynomial {
    /// The root with positive leading coefficient of a perfect square over the
    /// integers, `None` for anything else; the root of zero is zero.
    ///
    /// Takes about `s·(s + n)` steps for `n` terms here and `s` in the root.
    ///
    /// ```
    /// use sextic::algebra::{budget::Budget, polynomial::Polynomial, symbol::Symbol};
    ///
    /// let budget = Budget::new(1_000);
    /// let a = Polynomial::symbol(Symbol::new(0));
    /// let root = &a - &Polynomial::one();
    /// let square = root.power(2, &budget)?;
    /// assert_eq!(square.square_root(&budget)?, Some(root));
    /// assert_eq!(a.square_root(&budget)?, None);
    /// # Ok::<(), sextic::algebra::budget::Exhausted>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Exhausted`] if `budget` does not allow these steps.
    pub fn square_root(&self, budget: &Budget) -> Result<Option<Self>, Exhausted> {
        let (Some(first), Some(last)) = (self.terms().first(), self.terms().last()) else {
            return Ok(Some(Polynomial::zero()));
        };
        let degrees = Degrees::of(self);
        let even = degrees.iter().all(|(_, degree)| degree % 2 == 0);
        let Some(leading) = root_of_term(first).filter(|_| even && root_of_term(last).is_some())
        else {
            return Ok(None);
        };
        // Every term of the root divides the square root of this bound.
        let bound = degrees.monomial()?;
        let divisor: Term = (leading.0.clone(), &leading.1 * Integer::from(2));
        let leading = Polynomial::from_terms([leading]);
        let mut rest = self - &leading.multiply(&leading, budget)?;
        let mut twice_root = leading.scale(&Integer::from(2));
        while let Some((monomial, coefficient)) = rest.leading() {
            budget.spend((rest.len() + twice_root.len()) as u64)?;
            let Some(monomial) = monomial.quotient(&divisor.0) else {
                return Ok(None);
            };
            let fits = bound
                .quotient(&monomial)
                .is_some_and(|rest| rest.quotient(&monomial).is_some());
            let (coefficient, remainder) = coefficient.div_rem(&divisor.1);
            if !fits || !remainder.is_zero() {
                return Ok(None);
            }
            let term = Polynomial::from_terms([(monomial, coefficient)]);
            rest = &rest - &(&twice_root + &term).multiply(&term, budget)?;
            twice_root = &twice_root + &term.scale(&Integer::from(2));
        }
        Ok(Some(
            twice_root.over_integer(&Integer::from(2)).into_owned(),
        ))
    }
}

/// The root of a term that is a square.
fn root_of_term((monomial, coefficient): &Term) -> Option<Term> {
    if coefficient.is_negative() {
        return None;
    }
    let (root, remainder) = coefficient.unsigned_abs().sqrt_rem();
    if !remainder.is_zero() {
        return None;
    }
    let mut root_of_monomial = Monomial::one();
    for (symbol, exponent) in monomial.factors() {
        if exponent % 2 != 0 {
            return None;
        }
        root_of_monomial.push(symbol, u16::try_from(exponent / 2).ok()?);
    }
    Some((root_of_monomial, Integer::from(root)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::polynomial::notation::polynomial;

    #[test]
    fn roots_are_found_where_there_are_any() {
        for (square, root) in [
            ("0", Some("0")),
            ("9", Some("3")),
            ("-9", None),
            ("8", None),
            ("4*a^2*b^4", Some("2*a*b^2")),
            ("a^2*b", None),
            ("a^2 + 2*a*b + b^2", Some("a + b")),
            ("a^2 + 2*a*b - b^2", None),
            ("a^2 + b^2", None),
            ("a^2 + 3*a*b + b^2", None),
            ("a^4 - 2*a^3 + 3*a^2 - 2*a + 1", Some("a^2 - a + 1")),
            ("a^4 + c^2*a^2 + 1", None),
            // The square of the next term of a root would be too large a power.
            ("a^4 + 2*a^3*b^40000 + 1", None),
        ] {
            let found = polynomial(square).square_root(&Budget::new(1_000)).unwrap();
            assert_eq!(found, root.map(polynomial), "{square}");
        }
    }
}
