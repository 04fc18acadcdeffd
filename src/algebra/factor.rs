//! Factors that come apart without a full factorisation.

mod square_root;

use std::collections::BTreeMap;

use super::budget::{Budget, Exhausted};
use super::degrees::Degrees;
use super::gcd::{quotient, split_content};
use super::number::Integer;
use super::polynomial::Polynomial;

impl Polynomial {
    /// Factors with their multiplicities, whose product times the
    /// [`signed_content`](Polynomial::signed_content) is `self`.
    ///
    /// The factors are not constant, without integer content, with positive
    /// leading coefficient, without multiple factors and without common ones.
    /// They are as far apart as greatest common divisors and square roots take
    /// them: into factors with different multiplicities, into factors with
    /// different sets of symbols as far as contents show them, and into the
    /// halves of whatever is quadratic in a power of a symbol. So
    /// `a²·c − b²·c` comes apart into `a − b`, `a + b` and `c`, but
    /// `a³ − b³` stays as it is. They come in the order of polynomials, which
    /// is the same every time; zero has none.
    ///
    /// The cost is that of some gcds for every symbol.
    ///
    /// # Errors
    ///
    /// [`Exhausted`] as for [`gcd`](Polynomial::gcd).
    pub fn square_free(&self, budget: &Budget) -> Result<Vec<(Self, u32)>, Exhausted> {
        let mut factors = Factors::default();
        let monomial = self.monomial_content();
        for (symbol, exponent) in monomial.factors() {
            factors.add(Polynomial::symbol(symbol), exponent);
        }
        let rest = self.over_monomial(&monomial).primitive_part();
        split_by_contents(rest.with_positive_leading(), &mut factors, budget)?;
        Ok(factors.multiplicities.into_iter().collect())
    }

    /// The quotient by the highest power of `factor` that divides, and the
    /// exponent of that power.
    ///
    /// The exponent is zero where it would not be bounded: for zero, and for
    /// the factors `0`, `1` and `-1`.
    ///
    /// # Errors
    ///
    /// [`Exhausted`] as for [`divide_exact`](Polynomial::divide_exact).
    pub fn divide_out(&self, factor: &Self, budget: &Budget) -> Result<(Self, u32), Exhausted> {
        let mut rest = self.clone();
        let mut multiplicity = 0;
        let unit = factor.is_one() || (-factor).is_one();
        if self.is_zero() || factor.is_zero() || unit {
            return Ok((rest, multiplicity));
        }
        while let Some(quotient) = rest.divide_exact(factor, budget)? {
            rest = quotient;
            multiplicity += 1;
        }
        Ok((rest, multiplicity))
    }
}

/// The factors found so far with their multiplicities.
#[derive(Default)]
struct Factors {
    multiplicities: BTreeMap<Polynomial, u32>,
}

impl Factors {
    fn add(&mut self, factor: Polynomial, multiplicity: u32) {
        *self.multiplicities.entry(factor).or_default() += multiplicity;
    }
}

/// Takes out, symbol by symbol, the factors that do not contain the symbol.
fn split_by_contents(
    polynomial: Polynomial,
    factors: &mut Factors,
    budget: &Budget,
) -> Result<(), Exhausted> {
    let mut rest = polynomial;
    let mut degrees: Vec<_> = Degrees::of(&rest).iter().collect();
    degrees.sort_by_key(|&(_, degree)| degree);
    for (symbol, degree) in degrees {
        let (content, without) = split_content(&rest, symbol, budget)?;
        if !content.is_one() {
            split_by_contents(content, factors, budget)?;
            rest = without;
        }
        if degree == 1 {
            // Linear in a symbol and without content: irreducible.
            factors.add(rest, 1);
            return Ok(());
        }
    }
    // Now every factor of the rest contains every symbol of the rest.
    split_by_multiplicity(rest, factors, budget)
}

/// Yun's algorithm, for a polynomial without content in any of its symbols.
fn split_by_multiplicity(
    polynomial: Polynomial,
    factors: &mut Factors,
    budget: &Budget,
) -> Result<(), Exhausted> {
    let degrees = Degrees::of(&polynomial);
    let Some((symbol, _)) = degrees.iter().min_by_key(|&(_, degree)| degree) else {
        return Ok(());
    };
    let derivative = polynomial.derivative(symbol);
    let repeated = polynomial.gcd(&derivative, budget)?;
    // The invariant: with f = product of fᵢ^i, all fᵢ for i below the current
    // multiplicity m taken out, `radical` is the product of the fᵢ, and `slope`
    // the sum over i of (i − m + 1)·fᵢ' times the product of the other ones.
    let mut radical = quotient(&polynomial, &repeated, budget)?;
    let mut slope = quotient(&derivative, &repeated, budget)?;
    for multiplicity in 1.. {
        let rest = &slope - &radical.derivative(symbol);
        let factor = radical.gcd(&rest, budget)?;
        split_quadratics(factor.clone(), multiplicity, factors, budget)?;
        if rest.is_zero() {
            break;
        }
        radical = quotient(&radical, &factor, budget)?;
        slope = quotient(&rest, &factor, budget)?;
    }
    Ok(())
}

/// Adds a factor without multiple factors and contents, in two halves where it
/// is quadratic in a power of a symbol and splits.
fn split_quadratics(
    factor: Polynomial,
    multiplicity: u32,
    factors: &mut Factors,
    budget: &Budget,
) -> Result<(), Exhausted> {
    let mut waiting = vec![factor];
    while let Some(factor) = waiting.pop() {
        if factor.as_constant().is_some() {
            continue;
        }
        match halves(&factor, budget)? {
            Some(halves) => waiting.extend(halves),
            None => factors.add(factor, multiplicity),
        }
    }
    Ok(())
}

/// Two factors of a polynomial `a·y² + b·y + c` in some power `y` of a symbol,
/// whose discriminant is a square: the parts without content of
/// `2a·y + b ± √(b² − 4ac)`.
fn halves(polynomial: &Polynomial, budget: &Budget) -> Result<Option<[Polynomial; 2]>, Exhausted> {
    let degrees = Degrees::of(polynomial);
    if degrees.iter().any(|(_, degree)| degree == 1) {
        // Linear in a symbol and without content: irreducible.
        return Ok(None);
    }
    for (symbol, degree) in degrees.iter() {
        let power = degree / 2;
        let mut coefficients = polynomial.coefficients_in(symbol);
        let mut take = |exponent| coefficients.remove(&exponent).unwrap_or_default();
        let (a, b, c) = (take(2 * power), take(power), take(0));
        if !coefficients.is_empty() {
            continue;
        }
        let four_products = a.multiply(&c, budget)?.scale(&Integer::from(4));
        let discriminant = &b.multiply(&b, budget)? - &four_products;
        if let Some(root) = discriminant.square_root(budget)? {
            let half = |constant: Polynomial| {
                let slope = a.scale(&Integer::from(2));
                let coefficients = BTreeMap::from([(0, constant), (power, slope)]);
                let multiple = Polynomial::from_coefficients_in(symbol, &coefficients)?;
                let (_, half) = split_content(&multiple, symbol, budget)?;
                Ok(half.with_positive_leading())
            };
            return Ok(Some([half(&b + &root)?, half(&b - &root)?]));
        }
        if degree == 2 {
            // Without a root in this symbol, and linear factors are all it could have.
            return Ok(None);
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::super::polynomial::notation::polynomial;
    use super::*;

    fn product(factors: &[&str], budget: &Budget) -> Polynomial {
        let times = |product: Polynomial, factor: &&str| {
            product.multiply(&polynomial(factor), budget).unwrap()
        };
        factors.iter().fold(Polynomial::one(), times)
    }

    #[test]
    fn products_come_apart() {
        let budget = Budget::new(1_000_000);
        for (factors, expected) in [
            (vec!["0"], vec![]),
            (vec!["-12"], vec![]),
            (vec!["6", "a^2", "b"], vec![("b", 1), ("a", 2)]),
            (vec!["a^2 - b^2"], vec![("a - b", 1), ("a + b", 1)]),
            (
                vec!["a^4 - b^4"],
                vec![("a - b", 1), ("a + b", 1), ("a^2 + b^2", 1)],
            ),
            (vec!["a^2 + b^2"], vec![("a^2 + b^2", 1)]),
            (
                vec!["a - b", "c", "a + d"],
                vec![("c", 1), ("a + d", 1), ("a - b", 1)],
            ),
            (
                vec!["a - b", "a - b", "b + c", "2*a + 1"],
                vec![("b + c", 1), ("a - b", 2), ("2*a + 1", 1)],
            ),
            (
                vec!["6*a^2 + 5*a*b + b^2"],
                vec![("2*a + b", 1), ("3*a + b", 1)],
            ),
            (vec!["a^3 - b^3"], vec![("a^3 - b^3", 1)]),
            (vec!["b - a", "b - a", "b - a"], vec![("a - b", 3)]),
        ] {
            let expected: Vec<_> = expected
                .into_iter()
                .map(|(f, m)| (polynomial(f), m))
                .collect();
            assert_eq!(
                product(&factors, &budget).square_free(&budget),
                Ok(expected),
                "{factors:?}"
            );
        }
    }

    #[test]
    fn a_factor_is_divided_out_as_often_as_it_occurs() {
        let budget = Budget::new(10_000);
        for (factors, factor, rest, multiplicity) in [
            (vec!["a - b", "a - b", "c"], "a - b", "c", 2),
            (vec!["a - b"], "b - a", "-1", 1),
            (vec!["a - b"], "a + b", "a - b", 0),
            (vec!["12"], "2", "3", 2),
            (vec!["a"], "-1", "a", 0),
            (vec!["a"], "0", "a", 0),
            (vec!["0"], "a", "0", 0),
        ] {
            let found = product(&factors, &budget).divide_out(&polynomial(factor), &budget);
            assert_eq!(found, Ok((polynomial(rest), multiplicity)));
        }
    }
}
