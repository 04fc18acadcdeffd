//! Shorter forms of an element than its normal form, for reading and for finding signs.

use std::collections::BTreeMap;

use super::error::AlgebraError;
use super::fraction::Fraction;
use super::monomial::Monomial;
use super::number::{Integer, Rational};
use super::polynomial::Polynomial;
use super::ring::{BasisAngle, Ring};
use super::sign::Signs;
use super::symbol::Symbol;

/// An element as a person writes it: c·Π fᵢ^eᵢ with negative exponents for what is below the line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Factored {
    /// The integers above and below the line.
    pub coefficient: Rational,
    /// The other factors and their exponents.
    pub factors: Vec<(Polynomial, i64)>,
}

impl Ring {
    /// An equal polynomial with the fewest terms that exchanging cos² and 1 − sin² finds: terms that
    /// differ in one angle alone are rewritten together, to whichever form is shorter.
    ///
    /// Complexity: for each angle of the basis, one pass over the terms and a product with a power of
    /// 1 − sin² for each power of the cosine.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] where the budget or a polynomial's size runs out.
    ///
    /// ```
    /// # use sextic::algebra::{
    /// #     angle::Angle, arithmetic::{Arithmetic, Division}, budget::Budget, generator::Generator,
    /// #     ring::Ring,
    /// # };
    /// # let mut ring = Ring::new(Budget::new(10_000));
    /// # let alpha = ring.symbol(Generator::Angle { name: "α".into() })?;
    /// let (_, sine) = ring.cosine_and_sine(&Angle::new([(alpha, 1.into())]))?;
    /// let square = ring.product(&sine, &sine)?;
    /// assert_eq!(square.numerator().len(), 2); // 1 − cos²α
    /// assert_eq!(ring.shorten(square.numerator())?.len(), 1); // sin²α
    /// # Ok::<(), sextic::algebra::error::AlgebraError>(())
    /// ```
    pub fn shorten(&self, polynomial: &Polynomial) -> Result<Polynomial, AlgebraError> {
        let mut shortest = polynomial.clone();
        let symbols = polynomial.symbols();
        for BasisAngle { cosine, sine, .. } in self.basis() {
            if symbols.contains(cosine) || symbols.contains(sine) {
                shortest = self.shorten_angle(&shortest, *cosine, *sine)?;
            }
        }
        Ok(shortest)
    }

    fn shorten_angle(
        &self,
        polynomial: &Polynomial,
        cosine: Symbol,
        sine: Symbol,
    ) -> Result<Polynomial, AlgebraError> {
        let mut groups: BTreeMap<Monomial, Vec<(Monomial, Integer)>> = BTreeMap::new();
        for (monomial, coefficient) in polynomial.terms() {
            let rest = monomial.without(cosine).without(sine);
            groups
                .entry(rest)
                .or_default()
                .push((monomial.clone(), coefficient.clone()));
        }
        let mut shortened = Polynomial::zero();
        for group in groups.into_values() {
            let group = Polynomial::from_terms(group);
            let other = self.fold_square(&group, cosine, sine)?;
            shortened = &shortened
                + if other.len() < group.len() {
                    &other
                } else {
                    &group
                };
        }
        Ok(shortened)
    }

    /// The polynomial with cos² replaced by 1 − sin².
    fn fold_square(
        &self,
        polynomial: &Polynomial,
        cosine: Symbol,
        sine: Symbol,
    ) -> Result<Polynomial, AlgebraError> {
        let sine_squared = Polynomial::from_terms([(Monomial::power(sine, 2), Integer::ONE)]);
        let square = &Polynomial::one() - &sine_squared;
        let mut sum = Polynomial::zero();
        for (exponent, coefficient) in polynomial.coefficients_in(cosine) {
            let even = square.power(exponent / 2, self.budget())?;
            let mut term = coefficient.multiply(&even, self.budget())?;
            if exponent % 2 == 1 {
                term = term.multiply(&Polynomial::symbol(cosine), self.budget())?;
            }
            sum = &sum + &term;
        }
        Ok(sum)
    }

    /// The element as a product of factors, each as short as [`Ring::shorten`] makes it.
    ///
    /// Complexity: one gcd of both sides of the line, and a square-free factorisation of each.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] where the budget or a polynomial's size runs out.
    ///
    /// ```
    /// # use sextic::algebra::{
    /// #     angle::Angle, arithmetic::{Arithmetic, Division}, budget::Budget, generator::Generator,
    /// #     ring::Ring,
    /// # };
    /// # let mut ring = Ring::new(Budget::new(10_000));
    /// # let alpha = ring.symbol(Generator::Angle { name: "α".into() })?;
    /// let (_, sine) = ring.cosine_and_sine(&Angle::new([(alpha, 1.into())]))?;
    /// let inverse = ring.quotient(&ring.one(), &ring.product(&sine, &sine)?)?;
    /// assert_eq!(ring.factored(&inverse)?.factors, [(sine.numerator().clone(), -2)]);
    /// # Ok::<(), sextic::algebra::error::AlgebraError>(())
    /// ```
    pub fn factored(&self, element: &Fraction) -> Result<Factored, AlgebraError> {
        let reduced = self.shortened(element)?;
        let mut exponents: BTreeMap<Polynomial, i64> = BTreeMap::new();
        for (side, sign) in [(reduced.numerator(), 1), (reduced.denominator(), -1)] {
            for (factor, multiplicity) in side.square_free(self.budget())? {
                *exponents.entry(factor).or_default() += sign * i64::from(multiplicity);
            }
        }
        let above = reduced.numerator().signed_content();
        let below = reduced.denominator().signed_content();
        Ok(Factored {
            coefficient: Rational::from(above) / Rational::from(below),
            factors: exponents.into_iter().collect(),
        })
    }

    /// An element with sin α in place of what 1 − cos²α has made of it, in lowest terms again.
    ///
    /// Complexity: that of [`Ring::shorten`] for both sides of the line, and a gcd.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] where the budget or a polynomial's size runs out.
    pub fn shortened(&self, element: &Fraction) -> Result<Fraction, AlgebraError> {
        let above = self.shorten(element.numerator())?;
        let below = self.shorten(element.denominator())?;
        // Shortening may have made a sine appear on both sides of the line.
        Fraction::new(above, below, self.budget())
    }

    /// The signs an element can have under the assumptions.
    ///
    /// Complexity: that of [`Ring::polynomial_signs`] for both sides of the line.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] where the budget or a polynomial's size runs out.
    pub fn signs(&self, element: &Fraction) -> Result<Signs, AlgebraError> {
        let numerator = self.polynomial_signs(element.numerator())?;
        Ok(numerator.product(self.polynomial_signs(element.denominator())?))
    }

    /// The signs a polynomial can have under the assumptions: from its terms, from those of equal
    /// forms, and from its factors.
    ///
    /// Complexity: a square-free factorisation; for each factor one pass over its terms for each angle
    /// of the basis and each polynomial assumption.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] where the budget or a polynomial's size runs out.
    pub fn polynomial_signs(&self, polynomial: &Polynomial) -> Result<Signs, AlgebraError> {
        if !self.is_real_polynomial(polynomial) {
            return Ok(Signs::ANY);
        }
        let whole = self.signs_by_terms(polynomial)?;
        if whole != Signs::ANY || polynomial.len() <= 1 {
            return Ok(whole);
        }
        let shortened = self.shorten(polynomial)?;
        let leading = match shortened.leading() {
            Some((_, leading)) => Signs::of_integer(leading),
            None => Signs::ZERO,
        };
        let factors = shortened.square_free(self.budget())?;
        factors
            .into_iter()
            .try_fold(leading, |signs, (factor, multiplicity)| {
                Ok(signs.product(self.signs_by_terms(&factor)?.power(multiplicity)))
            })
    }

    /// The signs that the terms of a polynomial and of equal forms of it allow.
    fn signs_by_terms(&self, polynomial: &Polynomial) -> Result<Signs, AlgebraError> {
        let assumptions = self.assumptions();
        let mut signs = assumptions.of_terms(polynomial);
        if signs != Signs::ANY {
            return Ok(signs);
        }
        signs = signs.intersection(assumptions.of_terms(&self.shorten(polynomial)?));
        signs = signs.intersection(self.signs_by_squares(polynomial)?);
        for (known, known_signs) in assumptions.polynomials() {
            if signs != Signs::ANY {
                break;
            }
            if known == polynomial {
                signs = *known_signs;
            } else if *known == -polynomial {
                signs = known_signs.opposite();
            } else if let Some(shifted) = self.shift(polynomial, known, *known_signs)? {
                signs = assumptions.of_terms(&self.shorten(&shifted)?);
            }
        }
        Ok(signs)
    }

    /// The signs that the terms of a polynomial allow, with the cosines or the sines of each angle squared
    /// away.
    fn signs_by_squares(&self, polynomial: &Polynomial) -> Result<Signs, AlgebraError> {
        let mut signs = Signs::ANY;
        for BasisAngle { cosine, sine, .. } in self.basis() {
            if polynomial.degree_in(*cosine) > 1 {
                let other = self.fold_square(polynomial, *cosine, *sine)?;
                signs = signs.intersection(self.assumptions().of_terms(&other));
            }
        }
        Ok(signs)
    }

    /// Of an assumption r − L > 0 with a positive symbol r alone in the polynomial's favour: the
    /// polynomial with r = L + t, where t > 0 is written as r again, since only its sign matters.
    fn shift(
        &self,
        polynomial: &Polynomial,
        known: &Polynomial,
        signs: Signs,
    ) -> Result<Option<Polynomial>, AlgebraError> {
        if !signs.is_positive() {
            return Ok(None);
        }
        let leads = known.terms().iter().find_map(|(monomial, coefficient)| {
            let symbol = monomial.factors().next().map(|(symbol, _)| symbol)?;
            let alone = monomial.degree() == 1 && known.degree_in(symbol) == 1;
            let positive = self.assumptions().of_symbol(symbol).is_positive();
            (alone && positive && *coefficient == Integer::ONE).then_some(symbol)
        });
        let Some(symbol) = leads.filter(|symbol| polynomial.contains(*symbol)) else {
            return Ok(None);
        };
        // r = known + rest, and the value of `known` is written as r.
        let rest = &Polynomial::symbol(symbol) - known;
        if rest.contains(symbol) {
            return Ok(None);
        }
        let shifted = &Polynomial::symbol(symbol) + &rest;
        let mut sum = Polynomial::zero();
        for (exponent, coefficient) in polynomial.coefficients_in(symbol) {
            let power = shifted.power(exponent, self.budget())?;
            sum = &sum + &coefficient.multiply(&power, self.budget())?;
        }
        Ok(Some(sum))
    }
}
