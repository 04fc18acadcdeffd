//! Quotients of polynomials.

use std::borrow::Cow;
use std::collections::BTreeSet;

use dashu_base::UnsignedAbs;
use smallvec::SmallVec;

use super::arithmetic::SignedProduct;
use super::budget::{Budget, Exhausted};
use super::error::AlgebraError;
use super::gcd::quotient;
use super::number::{Integer, Rational};
use super::polynomial::{Polynomial, integer_gcd};
use super::symbol::Symbol;

/// A quotient of two polynomials, always in lowest terms.
///
/// Equal quotients have equal representations, so `==` decides equality.
///
/// Every operation takes time for greatest common divisors, which are kept
/// small: of the denominators first, and only across the operands, as each of
/// them is in lowest terms already. Where both denominators are 1 there is
/// nothing to do.
///
/// ```
/// use sextic::algebra::{budget::Budget, fraction::Fraction, symbol::Symbol};
///
/// let budget = Budget::new(10_000);
/// let a = Fraction::symbol(Symbol::new(0));
/// let b = Fraction::symbol(Symbol::new(1));
/// let difference = a.power(2, &budget)?.difference(&b.power(2, &budget)?, &budget)?;
/// let quotient = difference.quotient(&a.sum(&b, &budget)?, &budget)?;
/// assert_eq!(quotient, a.difference(&b, &budget)?);
/// # Ok::<(), sextic::algebra::error::AlgebraError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Fraction {
    numerator: Polynomial,
    /// With positive leading coefficient, and without a common divisor with
    /// the numerator; 1 where the numerator is zero.
    denominator: Polynomial,
}

impl Fraction {
    /// `numerator / denominator` in lowest terms.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] if the denominator is zero, and
    /// [`AlgebraError::Exhausted`] if `budget` does not allow the steps of the
    /// gcd.
    pub fn new(
        numerator: Polynomial,
        denominator: Polynomial,
        budget: &Budget,
    ) -> Result<Self, AlgebraError> {
        if denominator.is_zero() {
            return Err(AlgebraError::DivisionByZero);
        }
        Fraction::reduced(numerator, denominator, budget)
    }

    /// `numerator / denominator` in lowest terms, with a denominator that is not zero.
    fn reduced(
        numerator: Polynomial,
        denominator: Polynomial,
        budget: &Budget,
    ) -> Result<Self, AlgebraError> {
        let common = common_divisor(&numerator, &denominator, budget)?;
        Ok(match common {
            None => Fraction::from_coprime(numerator, denominator),
            Some(common) => Fraction::from_coprime(
                quotient(&numerator, &common, budget)?,
                quotient(&denominator, &common, budget)?,
            ),
        })
    }

    /// The fraction without symbols of this value.
    pub fn constant(value: Rational) -> Self {
        Fraction::from(value)
    }

    /// The fraction that is just this symbol.
    pub fn symbol(symbol: Symbol) -> Self {
        Fraction::from(Polynomial::symbol(symbol))
    }

    /// Takes over polynomials without common divisor, of which the second one
    /// is not zero.
    fn from_coprime(numerator: Polynomial, denominator: Polynomial) -> Self {
        let fraction = if numerator.is_zero() {
            Fraction::from(numerator)
        } else if denominator.is_negative() {
            Fraction {
                numerator: -&numerator,
                denominator: -&denominator,
            }
        } else {
            Fraction {
                numerator,
                denominator,
            }
        };
        debug_assert!(fraction.is_valid());
        fraction
    }

    /// The part of the invariant that is cheap to check: all but the gcd of
    /// polynomials that are not constant.
    fn is_valid(&self) -> bool {
        let content = Polynomial::constant(self.numerator.content());
        let cofactor = Polynomial::constant(self.denominator.content());
        let coprime = content.gcd(&cofactor, &Budget::unlimited());
        let monomials = self
            .numerator
            .monomial_content()
            .gcd(&self.denominator.monomial_content());
        !self.denominator.is_zero()
            && !self.denominator.is_negative()
            && coprime.is_ok_and(|gcd| gcd.is_one())
            && (self.is_zero() || monomials.is_one())
    }

    /// The numerator in lowest terms, which carries the sign.
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The denominator in lowest terms; its leading coefficient is positive.
    pub fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// The symbols that occur on either side of the line.
    ///
    /// Complexity: one pass over the terms.
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        let mut symbols = self.numerator.symbols();
        if !self.denominator.is_one() {
            symbols.append(&mut self.denominator.symbols());
        }
        symbols
    }

    /// Whether this is zero.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// The value of a fraction without symbols, `None` for every other one.
    pub fn as_constant(&self) -> Option<Rational> {
        let (numerator, denominator) = (
            self.numerator.as_constant()?,
            self.denominator.as_constant()?,
        );
        // A denominator is not zero.
        Some(Rational::from_parts(numerator, denominator.unsigned_abs()))
    }

    /// `self + other`.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] if `budget` does not allow the steps.
    pub fn sum(&self, other: &Self, budget: &Budget) -> Result<Self, AlgebraError> {
        self.combine(other, |left, right| left + right, budget)
    }

    /// `self - other`.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] if `budget` does not allow the steps.
    pub fn difference(&self, other: &Self, budget: &Budget) -> Result<Self, AlgebraError> {
        self.combine(other, |left, right| left - right, budget)
    }

    /// `self · other`.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] if `budget` does not allow the steps.
    pub fn product(&self, other: &Self, budget: &Budget) -> Result<Self, AlgebraError> {
        let (left, right) = (self, other);
        // What is common can only be so across: each operand has none itself.
        let first = common_divisor(&left.numerator, &right.denominator, budget)?;
        let second = common_divisor(&right.numerator, &left.denominator, budget)?;
        let over = |side, common| over(side, common, budget);
        let numerator =
            over(&left.numerator, &first)?.multiply(&*over(&right.numerator, &second)?, budget)?;
        let denominator = over(&left.denominator, &second)?
            .multiply(&*over(&right.denominator, &first)?, budget)?;
        Ok(Fraction::from_coprime(numerator, denominator))
    }

    /// `Σ ±a·b` at once, where nothing but integers stands below the lines; else `None`.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] if `budget` does not allow the steps.
    pub(super) fn sum_of_products(
        products: &[SignedProduct<&Self, &Self>],
        budget: &Budget,
    ) -> Result<Option<Self>, AlgebraError> {
        let is_whole = |fraction: &Self| fraction.denominator.is_one();
        if products
            .iter()
            .all(|product| is_whole(product.left) && is_whole(product.right))
        {
            let numerators: SmallVec<[_; 8]> = products.iter().map(numerators).collect();
            return Ok(Some(
                Polynomial::sum_of_products(&numerators, budget)?.into(),
            ));
        }
        let below = products.iter().map(|product| {
            let below = product.left.denominator.as_constant()?;
            Some(below * product.right.denominator.as_constant()?)
        });
        let Some(below) = below.collect::<Option<SmallVec<[Integer; 8]>>>() else {
            return Ok(None);
        };
        let multiple = below.iter().fold(Integer::ONE, |multiple, own| {
            &multiple / integer_gcd(&multiple, own) * own
        });
        let factors = below.iter().map(|own| &multiple / own);
        let numerator = scaled_sum(products, factors, budget)?;
        Fraction::reduced(numerator, Polynomial::constant(multiple), budget).map(Some)
    }

    /// `self / other`.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] if `other` is zero, and
    /// [`AlgebraError::Exhausted`] if `budget` does not allow the steps.
    pub fn quotient(&self, other: &Self, budget: &Budget) -> Result<Self, AlgebraError> {
        self.product(&other.reciprocal()?, budget)
    }

    /// `1 / self`.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] if `self` is zero.
    pub fn reciprocal(&self) -> Result<Self, AlgebraError> {
        if self.is_zero() {
            return Err(AlgebraError::DivisionByZero);
        }
        Ok(Fraction::from_coprime(
            self.denominator.clone(),
            self.numerator.clone(),
        ))
    }

    /// `-self`.
    pub fn negative(&self) -> Self {
        Fraction {
            numerator: -&self.numerator,
            denominator: self.denominator.clone(),
        }
    }

    /// `self^exponent`; `0^0` is 1.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] for a negative power of zero, and
    /// [`AlgebraError::Exhausted`] if `budget` does not allow the steps.
    pub fn power(&self, exponent: i32, budget: &Budget) -> Result<Self, AlgebraError> {
        let base = if exponent < 0 {
            self.reciprocal()?
        } else {
            self.clone()
        };
        // Powers of polynomials without common divisor have none either.
        let numerator = base.numerator.power(exponent.unsigned_abs(), budget)?;
        let denominator = base.denominator.power(exponent.unsigned_abs(), budget)?;
        Ok(Fraction::from_coprime(numerator, denominator))
    }

    /// The sum or the difference, as `operation` has it for polynomials.
    ///
    /// With `g` the gcd of the denominators `g·d` and `g·e`, the result is
    /// `(n·e ± m·d) / (g·d·e)`, and a common divisor can only be one of `g`.
    fn combine(
        &self,
        other: &Self,
        operation: impl Fn(&Polynomial, &Polynomial) -> Polynomial,
        budget: &Budget,
    ) -> Result<Self, AlgebraError> {
        let (left, right) = (self, other);
        if left.denominator == right.denominator {
            let numerator = operation(&left.numerator, &right.numerator);
            return Fraction::reduced(numerator, left.denominator.clone(), budget);
        }
        let common = common_divisor(&left.denominator, &right.denominator, budget)?;
        let d = over(&left.denominator, &common, budget)?;
        let e = over(&right.denominator, &common, budget)?;
        let numerator = operation(
            &left.numerator.multiply(&e, budget)?,
            &right.numerator.multiply(&d, budget)?,
        );
        let Some(common) = common else {
            return Ok(Fraction::from_coprime(numerator, d.multiply(&e, budget)?));
        };
        let rest = Fraction::reduced(numerator, common, budget)?;
        let denominator = rest
            .denominator
            .multiply(&d, budget)?
            .multiply(&e, budget)?;
        Ok(Fraction::from_coprime(rest.numerator, denominator))
    }
}

/// The product of the numerators of a product.
fn numerators<'a>(
    product: &SignedProduct<&'a Fraction, &'a Fraction>,
) -> SignedProduct<&'a Polynomial, &'a Polynomial> {
    SignedProduct {
        is_negative: product.is_negative,
        left: &product.left.numerator,
        right: &product.right.numerator,
    }
}

/// The sum of the products of numerators, each times a factor.
fn scaled_sum(
    products: &[SignedProduct<&Fraction, &Fraction>],
    factors: impl Iterator<Item = Integer>,
    budget: &Budget,
) -> Result<Polynomial, Exhausted> {
    let factors = products.iter().zip(factors);
    let scaled: SmallVec<[_; 8]> = factors
        .map(|(product, factor)| product.left.numerator.scale(&factor))
        .collect();
    let products = products.iter().zip(&scaled);
    let products: SmallVec<[_; 8]> = products
        .map(|(product, left)| SignedProduct {
            left,
            ..numerators(product)
        })
        .collect();
    Polynomial::sum_of_products(&products, budget)
}

/// The gcd of two polynomials, where it is not 1; the second one is not zero.
fn common_divisor(
    left: &Polynomial,
    right: &Polynomial,
    budget: &Budget,
) -> Result<Option<Polynomial>, Exhausted> {
    if left.is_one() || right.is_one() {
        return Ok(None);
    }
    let common = left.gcd(right, budget)?;
    Ok((!common.is_one()).then_some(common))
}

/// A polynomial divided by one that divides it, if there is one.
fn over<'a>(
    dividend: &'a Polynomial,
    divisor: &Option<Polynomial>,
    budget: &Budget,
) -> Result<Cow<'a, Polynomial>, Exhausted> {
    match divisor {
        None => Ok(Cow::Borrowed(dividend)),
        Some(divisor) => Ok(Cow::Owned(quotient(dividend, divisor, budget)?)),
    }
}

impl From<Polynomial> for Fraction {
    fn from(polynomial: Polynomial) -> Self {
        Fraction {
            numerator: polynomial,
            denominator: Polynomial::one(),
        }
    }
}

impl From<Rational> for Fraction {
    fn from(value: Rational) -> Self {
        let (numerator, denominator) = value.into_parts();
        Fraction {
            numerator: Polynomial::constant(numerator),
            denominator: Polynomial::constant(Integer::from(denominator)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::polynomial::notation::polynomial;
    use super::*;

    fn fraction(numerator: &str, denominator: &str) -> Result<Fraction, AlgebraError> {
        Fraction::new(
            polynomial(numerator),
            polynomial(denominator),
            &Budget::new(100_000),
        )
    }

    #[test]
    fn the_invariant_is_checked() {
        for (numerator, denominator, is_valid) in [
            ("a", "b", true),
            ("0", "1", true),
            ("3*a", "2", true),
            ("a", "0", false),
            ("a", "-b", false),
            ("4*a", "6*b", false),
            ("a*b", "b*c", false),
            ("0", "2", false),
        ] {
            let fraction = Fraction {
                numerator: polynomial(numerator),
                denominator: polynomial(denominator),
            };
            assert_eq!(fraction.is_valid(), is_valid, "{fraction:?}");
        }
    }

    #[test]
    fn what_has_no_denominator_costs_no_gcd() {
        let budget = Budget::new(100_000);
        let [left, right] = ["a + b", "c + d"].map(|text| Fraction::from(polynomial(text)));
        left.product(&right, &budget).unwrap();
        assert_eq!(budget.spent(), 4);
        left.quotient(&fraction("1", "c + d").unwrap(), &budget)
            .unwrap();
        assert_eq!(budget.spent(), 8);
    }

    #[test]
    fn fractions_are_reduced() {
        for (n, d, numerator, denominator) in [
            ("0", "-a", "0", "1"),
            ("4*a", "-6*a*b", "-2", "3*b"),
            ("a^2 - b^2", "b - a", "-a - b", "1"),
            ("a", "b", "a", "b"),
        ] {
            let fraction = fraction(n, d).unwrap();
            assert_eq!(*fraction.numerator(), polynomial(numerator));
            assert_eq!(*fraction.denominator(), polynomial(denominator));
        }
    }

    #[test]
    fn there_is_no_division_by_zero() {
        let budget = Budget::unlimited();
        let (zero, a) = (fraction("0", "a").unwrap(), fraction("a", "1").unwrap());
        let refused = Err(AlgebraError::DivisionByZero);
        assert_eq!(fraction("a", "0"), refused);
        assert_eq!(a.quotient(&zero, &budget), refused);
        assert_eq!(zero.power(-1, &budget), refused);
        assert_eq!(zero.reciprocal(), refused);
        assert_eq!(
            zero.power(0, &budget),
            Ok(Fraction::from(Polynomial::one()))
        );
    }

    #[test]
    fn constants_go_in_and_come_out() {
        let value = Rational::from_parts(Integer::from(-6), 4_u8.into());
        assert_eq!(
            Fraction::constant(value.clone()).as_constant(),
            Some(value.clone())
        );
        assert_eq!(fraction("-3*a", "2*a").unwrap(), Fraction::from(value));
        assert_eq!(fraction("a", "2").unwrap().as_constant(), None);
        assert_eq!(fraction("2", "a").unwrap().as_constant(), None);
    }
}
