//! Greatest common divisors.

mod interpolation;
mod subresultant;

use std::collections::BTreeMap;

use dashu_base::Abs;
use smallvec::smallvec;

use super::budget::{Budget, Exhausted, steps_of_division};
use super::degrees::Degrees;
use super::image::degrees_of_gcd;
use super::monomial::Monomial;
use super::polynomial::{Polynomial, Term, Terms, integer_gcd};
use super::symbol::Symbol;

impl Polynomial {
    /// The greatest common divisor over the integers, with positive leading
    /// coefficient; zero for two zeros.
    ///
    /// Constants count: the gcd of `4·a` and `6·a` is `2·a`.
    ///
    /// Cheap arguments come first: common monomials and integers, then the
    /// degree of the gcd in every symbol from images modulo a prime, which
    /// takes linear time and settles coprime arguments. A symbol that the gcd
    /// does not contain is eliminated by passing to coefficients. If all this
    /// leaves two polynomials neither of which divides the other, the gcd is
    /// interpolated from images modulo primes, whose number is a product of
    /// degrees; where that would be too many, the sequence of subresultants in
    /// one symbol decides, whose cost grows exponentially with the number of
    /// symbols of the gcd.
    ///
    /// ```
    /// use sextic::algebra::{budget::Budget, polynomial::Polynomial, symbol::Symbol};
    ///
    /// let budget = Budget::new(10_000);
    /// let a = Polynomial::symbol(Symbol::new(0));
    /// let b = Polynomial::symbol(Symbol::new(1));
    /// let sum = &a + &b;
    /// let left = sum.multiply(&a, &budget)?;
    /// let right = sum.multiply(&b, &budget)?;
    /// assert_eq!(left.gcd(&right, &budget)?, sum);
    /// # Ok::<(), sextic::algebra::budget::Exhausted>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Exhausted`] if `budget` does not allow the steps, or if a polynomial on
    /// the way would be too large.
    pub fn gcd(&self, other: &Self, budget: &Budget) -> Result<Self, Exhausted> {
        if self.is_zero() || other.is_zero() || self == other {
            let present = if self.is_zero() { other } else { self };
            return Ok(present.clone().with_positive_leading());
        }
        budget.spend((self.len() + other.len()) as u64)?;
        if let ([term], others) | (others, [term]) = (self.terms(), other.terms()) {
            return gcd_with_term(term, others, budget);
        }
        let (left, right) = (self.content(), other.content());
        let integer = integer_gcd(&left, &right);
        let (left, right) = (self.over_integer(&left), other.over_integer(&right));
        let (left_monomial, right_monomial) = (left.monomial_content(), right.monomial_content());
        let monomial = left_monomial.gcd(&right_monomial);
        let left = left.over_monomial(&left_monomial);
        let right = right.over_monomial(&right_monomial);
        let rest = primitive_gcd(&left, &right, budget)?;
        rest.multiply(&Polynomial::from_terms([(monomial, integer)]), budget)
    }
}

/// The gcd of a term and of a sum of others, which is a term; most sums show soon that it is 1.
fn gcd_with_term(
    (monomial, coefficient): &Term,
    others: &[Term],
    budget: &Budget,
) -> Result<Polynomial, Exhausted> {
    let mut common = (monomial.clone(), coefficient.abs());
    for (monomial, coefficient) in others {
        if common.0.is_one() && common.1.is_one() {
            break;
        }
        budget.spend(steps_of_division(&common.1, coefficient))?;
        common = (common.0.gcd(monomial), integer_gcd(&common.1, coefficient));
    }
    Ok(Polynomial::from_sorted(smallvec![common]))
}

/// The gcd of the polynomials of a list, zero for none.
pub(super) fn gcd_of_all<'a>(
    polynomials: impl IntoIterator<Item = &'a Polynomial>,
    budget: &Budget,
) -> Result<Polynomial, Exhausted> {
    // The shortest ones bound the gcd soonest.
    let mut polynomials: Vec<&Polynomial> = polynomials.into_iter().collect();
    polynomials.sort_by_key(|polynomial| polynomial.len());
    let mut gcd = Polynomial::zero();
    for polynomial in polynomials {
        gcd = gcd.gcd(polynomial, budget)?;
        if gcd.is_one() {
            break;
        }
    }
    Ok(gcd)
}

/// The gcd of two polynomials without common divisors of all their
/// coefficients, and without monomials that divide them.
fn primitive_gcd(
    left: &Polynomial,
    right: &Polynomial,
    budget: &Budget,
) -> Result<Polynomial, Exhausted> {
    let bounds = degrees_of_gcd(left, right, budget)?;
    if bounds.iter().next().is_none() {
        return Ok(Polynomial::one());
    }
    let (left_degrees, right_degrees) = (Degrees::of(left), Degrees::of(right));
    let absent = |symbol: Symbol| bounds.get(symbol) == 0;
    if [&left_degrees, &right_degrees]
        .iter()
        .any(|degrees| degrees.iter().any(|(s, _)| absent(s)))
    {
        let mut parts = coefficients_by(left, absent);
        parts.extend(coefficients_by(right, absent));
        return gcd_of_all(&parts, budget);
    }
    for (divisor, degrees, dividend) in
        [(left, &left_degrees, right), (right, &right_degrees, left)]
    {
        if *degrees == bounds && dividend.divide_exact(divisor, budget)?.is_some() {
            return Ok(divisor.clone().with_positive_leading());
        }
    }
    // The fewer remainders there are down to the gcd, the less they grow.
    let effort = |&(symbol, bound): &(Symbol, u32)| {
        let degree = left_degrees.get(symbol).min(right_degrees.get(symbol));
        (degree - bound, degree)
    };
    let Some((symbol, bound)) = bounds.iter().min_by_key(effort) else {
        return Ok(Polynomial::one());
    };
    let (left_content, left) = split_content(left, symbol, budget)?;
    let (right_content, right) = split_content(right, symbol, budget)?;
    let content = left_content.gcd(&right_content, budget)?;
    let main = match interpolation::gcd(&left, &right, symbol, &bounds, budget)? {
        Some(main) => main,
        None => subresultant::gcd(left, right, symbol, bound, budget)?,
    };
    Ok(content.multiply(&main, budget)?.with_positive_leading())
}

/// The coefficients of the monomials in the symbols that `chosen` picks.
fn coefficients_by(polynomial: &Polynomial, chosen: impl Fn(Symbol) -> bool) -> Vec<Polynomial> {
    let mut groups = BTreeMap::<Monomial, Terms>::new();
    for (monomial, coefficient) in polynomial.terms() {
        let (picked, others) = monomial.partition(&chosen);
        groups
            .entry(picked)
            .or_default()
            .push((others, coefficient.clone()));
    }
    groups.into_values().map(Polynomial::from_sorted).collect()
}

/// The gcd of the coefficients with respect to `symbol`, and what is left of
/// the polynomial without it.
pub(super) fn split_content(
    polynomial: &Polynomial,
    symbol: Symbol,
    budget: &Budget,
) -> Result<(Polynomial, Polynomial), Exhausted> {
    let content = gcd_of_all(polynomial.coefficients_in(symbol).values(), budget)?;
    if content.is_one() {
        return Ok((content, polynomial.clone()));
    }
    let rest = quotient(polynomial, &content, budget)?;
    Ok((content, rest))
}

/// The quotient by a polynomial that is known to divide.
///
/// # Panics
///
/// If it does not divide: any other answer would be a wrong one.
pub(super) fn quotient(
    dividend: &Polynomial,
    divisor: &Polynomial,
    budget: &Budget,
) -> Result<Polynomial, Exhausted> {
    let quotient = dividend.divide_exact(divisor, budget)?;
    assert!(
        quotient.is_some(),
        "{divisor:?} does not divide {dividend:?}"
    );
    Ok(quotient.unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::polynomial::notation::{arbitrary, polynomial, symbol};
    use super::*;

    #[test]
    fn greatest_common_divisors_are_found() {
        for (left, right, expected) in [
            ("0", "0", "0"),
            ("0", "-2*a", "2*a"),
            ("4*a", "-6*a", "2*a"),
            ("12", "18", "6"),
            ("a*b^2", "a^2*b", "a*b"),
            ("-a + b", "a - b", "a - b"),
            ("a^2 - b^2", "a^2 + 2*a*b + b^2", "a + b"),
            ("2*a^2 - 2*b^2", "4*a*c + 4*b*c", "2*a + 2*b"),
            ("a*c + b*c + a + b", "a*d + b*d + a + b", "a + b"),
            ("a + b", "c + d", "1"),
            ("a^4 - b^4", "a^6 - b^6", "a^2 - b^2"),
            ("2*a + 4*b", "3*a + 6*b", "a + 2*b"),
        ] {
            let (left, right) = (polynomial(left), polynomial(right));
            let gcd = left.gcd(&right, &Budget::new(10_000)).unwrap();
            assert_eq!(gcd, polynomial(expected), "gcd of {left:?} and {right:?}");
        }
    }

    proptest! {
        #[test]
        fn both_ways_find_the_gcd_of_multiples(
            left in arbitrary(5, 4, 6), right in arbitrary(5, 4, 6), common in arbitrary(5, 4, 70),
        ) {
            let budget = Budget::unlimited();
            let product = |factor: &Polynomial| factor.multiply(&common, &budget).unwrap();
            let (left, right) = (product(&left), product(&right));
            let found = left.gcd(&right, &budget).unwrap();
            prop_assert!(found.is_zero() || found.divide_exact(&common, &budget).unwrap().is_some());
            // What is left has no common divisor: with one more factor there is no more in common.
            if !found.is_zero() {
                let [left, right] = [&left, &right].map(|side| quotient(side, &found, &budget).unwrap());
                let bounds = degrees_of_gcd(&left, &right, &budget).unwrap();
                prop_assert!(bounds.iter().next().is_none());
            }
        }
    }

    proptest! {
        /// A wrong grid is not seen in a gcd, since the subresultants find what it misses.
        #[test]
        fn a_grid_shows_what_is_common(
            left in arbitrary(3, 1, 20), right in arbitrary(3, 1, 20), common in arbitrary(4, 2, 100),
            letter in prop_oneof![Just('a'), Just('c'), Just('e')],
        ) {
            let (budget, symbol) = (Budget::unlimited(), symbol(letter));
            // A grid has an axis for every symbol.
            let common = &common + &polynomial("3*a + b + c + d + 2*e");
            let main = |own: Polynomial| split_content(&own.primitive_part(), symbol, &budget).unwrap().1;
            let common = main(common);
            let [left, right] = [left, right].map(|side| main(side.multiply(&common, &budget).unwrap()));
            prop_assume!(!left.is_zero() && !right.is_zero());
            let bounds = degrees_of_gcd(&left, &right, &budget).unwrap();
            let found = interpolation::gcd(&left, &right, symbol, &bounds, &budget).unwrap();
            let found = found.expect("a small grid");
            prop_assert!(found.divide_exact(&common, &budget).unwrap().is_some());
        }
    }

    #[test]
    fn a_grid_costs_its_points_times_the_terms() {
        let powers = |factor: fn(i64) -> i64| {
            let term = |k: i64| (Monomial::power(symbol('a'), k as u16), factor(k).into());
            Polynomial::from_terms((0..=60).map(term))
        };
        let (common, budget) = (polynomial("a + b"), Budget::unlimited());
        let sides = [powers(|_| 1), powers(|k| k + 1)];
        let [left, right] = sides.map(|side| side.multiply(&common, &budget).unwrap());
        let bounds = degrees_of_gcd(&left, &right, &budget).unwrap();
        let budget = Budget::new(100_000);
        let found = interpolation::gcd(&left, &right, symbol('a'), &bounds, &budget).unwrap();
        assert_eq!(found, Some(common));
        // Two points, at each of which both have 62 powers.
        let least = 2 * 62 * 62;
        assert!(
            (least..2 * least).contains(&budget.spent()),
            "{}",
            budget.spent()
        );
    }

    #[test]
    fn multiples_of_five_terms_are_cheap() {
        let common = polynomial("3*a^3*b*e - 7*b^2*c^2*d + 5*c^3*e^2 + 2*a*d^3 - 11");
        let left = polynomial("2*a^2*b^3 - 5*c*d*e^2 + 7*b*d^3 - 3*a*c^2*e + 13*d");
        let right = polynomial("9*b^3*e + 4*a^2*c*d - 6*c^3 + a*b*e^3 - 17*e");
        let budget = Budget::unlimited();
        let product = |factor: &Polynomial| factor.multiply(&common, &budget).unwrap();
        let gcd = product(&left).gcd(&product(&right), &Budget::new(10_000_000));
        assert_eq!(gcd, Ok(common));
    }

    #[test]
    fn a_gcd_stops_when_the_budget_is_used_up() {
        let sum = polynomial("a + b^2 + c + 2");
        let budget = Budget::unlimited();
        let left = sum.power(3, &budget).unwrap();
        let right = &left + &polynomial("a");
        assert!(left.gcd(&right, &budget).unwrap().is_one());
        assert!(left.gcd(&right, &Budget::new(50)).is_err());
    }
}
