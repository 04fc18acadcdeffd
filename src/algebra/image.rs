//! Images of polynomials modulo a prime, to learn about a gcd cheaply.
//!
//! Fix a symbol `x`, put numbers modulo a prime `p` for all other symbols, and
//! `f` becomes a polynomial in `x` alone. The image of `gcd(f, g)` divides the
//! gcd of the images. If the leading coefficient of `f` or of `g` in `x` does
//! not vanish, the image of the gcd has the degree of the gcd itself. Then
//! the degree of the gcd of the images is an upper bound on it that is certain,
//! and is nearly always equal to it.

use super::budget::{Budget, Exhausted};
use super::degrees::Degrees;
use super::modular::{Field, power, reduce, residue, times, trim};
use super::polynomial::Polynomial;
use super::symbol::Symbol;

/// An upper bound on the degree of `gcd(left, right)` in every symbol, for
/// polynomials that are not zero.
///
/// Takes as many steps as there are powers of symbols in both, and for each
/// symbol that they share the product of the two degrees.
pub(super) fn degrees_of_gcd(
    left: &Polynomial,
    right: &Polynomial,
    budget: &Budget,
) -> Result<Degrees, Exhausted> {
    let (left, right) = (Image::new(left, budget)?, Image::new(right, budget)?);
    let mut bounds = Degrees::default();
    for (symbol, left_degree) in left.degrees.iter() {
        let right_degree = right.degrees.get(symbol);
        if right_degree == 0 {
            continue;
        }
        let (first, second) = (left.along(symbol), right.along(symbol));
        let certain = first.len() as u64 > u64::from(left_degree)
            || second.len() as u64 > u64::from(right_degree);
        let least = left_degree.min(right_degree);
        *bounds.entry(symbol) = if certain {
            budget.spend(u64::from(left_degree) * u64::from(right_degree))?;
            (Field::FIRST.gcd(first, second).len().saturating_sub(1) as u32).min(least)
        } else {
            least
        };
    }
    Ok(bounds)
}

/// The values of the terms of a polynomial at one point.
struct Image<'a> {
    polynomial: &'a Polynomial,
    degrees: Degrees,
    values: Vec<u64>,
}

impl<'a> Image<'a> {
    fn new(polynomial: &'a Polynomial, budget: &Budget) -> Result<Self, Exhausted> {
        let degrees = Degrees::of(polynomial);
        let mut values = Vec::with_capacity(polynomial.len());
        for (monomial, coefficient) in polynomial.terms() {
            let mut value = residue(coefficient);
            let mut factors = 1;
            for (symbol, exponent) in monomial.factors() {
                value = times(value, power(Field::FIRST.node(symbol, 0), exponent));
                factors += 1;
            }
            budget.spend(factors)?;
            values.push(value);
        }
        Ok(Image {
            polynomial,
            degrees,
            values,
        })
    }

    /// The coefficients of the image along `symbol`, from the lowest, the last
    /// of them not zero.
    ///
    /// The symbol `x` stands for `x₀·y` here, with its coordinate `x₀` and a new
    /// symbol `y`, which has no influence on the degree of a gcd.
    fn along(&self, symbol: Symbol) -> Vec<u64> {
        let mut coefficients = vec![0; self.degrees.get(symbol) as usize + 1];
        for ((monomial, _), &value) in self.polynomial.terms().iter().zip(&self.values) {
            let sum = &mut coefficients[monomial.exponent(symbol) as usize];
            *sum = reduce(*sum + value);
        }
        trim(&mut coefficients);
        coefficients
    }
}

#[cfg(test)]
mod tests {
    use super::super::modular::PRIME;
    use super::super::number::Integer;
    use super::super::polynomial::notation::{polynomial, symbol};
    use super::*;

    #[test]
    fn the_bounds_are_the_degrees_of_the_gcd() {
        for (left, right, expected) in [
            ("a^2 - b^2", "a + b", [1, 1, 0]),
            ("a^2 + b^2", "a + b", [0, 0, 0]),
            ("a*c + b*c", "a*c^2 + b*c^2", [1, 1, 1]),
            ("a^4 - 1", "a^6 - 1", [2, 0, 0]),
        ] {
            let (left, right) = (polynomial(left), polynomial(right));
            let bounds = degrees_of_gcd(&left, &right, &Budget::new(1_000)).unwrap();
            assert_eq!(
                ['a', 'b', 'c'].map(|letter| bounds.get(symbol(letter))),
                expected
            );
        }
    }

    #[test]
    fn bounds_cost_the_powers_and_the_products_of_degrees() {
        let (left, right) = (polynomial("a^4 - 1"), polynomial("a^6*b - b"));
        let budget = Budget::new(1_000);
        degrees_of_gcd(&left, &right, &budget).unwrap();
        let (of_left, of_right) = (2 + 1, 3 + 2);
        assert_eq!(budget.spent(), of_left + of_right + 4 * 6);
    }

    #[test]
    fn vanishing_leading_coefficients_leave_the_trivial_bound() {
        // Both leading coefficients are multiples of the prime.
        let prime = Polynomial::constant(Integer::from(PRIME));
        let a = polynomial("a");
        let budget = Budget::unlimited();
        let left = &a.multiply(&prime, &budget).unwrap() + &Polynomial::one();
        let right = &left + &Polynomial::one();
        let bounds = degrees_of_gcd(&left, &right, &budget).unwrap();
        assert_eq!(bounds.get(symbol('a')), 1);
        assert!(left.gcd(&right, &budget).unwrap().is_one());
    }
}
