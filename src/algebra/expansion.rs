//! Expansion in small quantities.

use std::collections::BTreeMap;

use super::arithmetic::{Arithmetic, Division};
use super::differential::Differential;
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::generator::Generator;
use super::number::{Integer, Rational};
use super::polynomial::Polynomial;
use super::ring::Ring;
use super::substitution::Substitution;
use super::symbol::Symbol;

impl Ring {
    /// The terms of total degree 0, 1, …, `order` of an element in the small quantities q.
    ///
    /// The part of degree k is Dᵏf/k! at q = 0, with D the derivative along q: it maps each qᵢ to a
    /// constant δᵢ, which is read as qᵢ in the end.
    ///
    /// Complexity: one pass over the terms of a polynomial in q; `order` differentials, each of an
    /// element that grows with the degree before, of anything else.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] where the element or a derivative has no value at q = 0,
    /// and those of [`Ring::substitute`].
    ///
    /// ```
    /// use sextic::algebra::{
    ///     arithmetic::{Arithmetic, Division}, budget::Budget, generator::Generator, ring::Ring,
    /// };
    ///
    /// let mut ring = Ring::new(Budget::new(10_000));
    /// let q = ring.symbol(Generator::Constant { name: "q".into() })?;
    /// let one_minus_q = ring.difference(&ring.one(), &ring.element(q))?;
    /// // 1/(1 − q) = 1 + q + …
    /// let parts = ring.expand(&ring.quotient(&ring.one(), &one_minus_q)?, &[q], 1)?;
    /// assert_eq!(parts, [ring.one(), ring.element(q)]);
    /// # Ok::<(), sextic::algebra::error::AlgebraError>(())
    /// ```
    pub fn expand(
        &mut self,
        element: &Fraction,
        small: &[Symbol],
        order: u32,
    ) -> Result<Vec<Fraction>, AlgebraError> {
        self.expand_until(element, small, order, order, |_, _| false)
    }

    /// The parts of an element as [`Ring::expand`] gives them, up to the first that may be the last, or
    /// to the degree behind which there are none, if all that are required exist.
    ///
    /// The part of degree k is Dᵏf/k! at q = 0, with D the derivative along q: it maps each qᵢ to a
    /// constant δᵢ, which is read as qᵢ in the end.
    fn expand_until(
        &mut self,
        element: &Fraction,
        small: &[Symbol],
        required: u32,
        order: u32,
        last: impl Fn(u32, &Fraction) -> bool,
    ) -> Result<Vec<Fraction>, AlgebraError> {
        let mut along = BTreeMap::new();
        let mut at_zero = Substitution::new();
        let mut back = Substitution::new();
        for symbol in small {
            let direction = self.symbol(Generator::Constant {
                name: format!("δ{}", symbol.index()),
            })?;
            along.insert(*symbol, self.element(direction));
            at_zero.insert(*symbol, self.zero());
            back.insert(direction, self.element(*symbol));
        }
        let along = Differential::Images(along);
        let polynomial = self.is_polynomial_in(element, small, &along)?;
        let mut derivative = element.clone();
        let mut factorial = Integer::ONE;
        let mut parts = Vec::new();
        for degree in 0..=order {
            let part = if polynomial {
                self.part_of_degree(element, small, degree)?
            } else {
                if degree > 0 {
                    derivative = self.differentiate(&derivative, &along)?;
                    factorial *= degree;
                }
                let value = match self.substitute(&derivative, &at_zero) {
                    // Beyond what is required the expansion may end.
                    Err(AlgebraError::DivisionByZero) if degree > required => break,
                    value => value?,
                };
                let value = self.substitute(&value, &back)?;
                self.quotient(&value, &Fraction::from(Rational::from(factorial.clone())))?
            };
            let enough = last(degree, &part);
            parts.push(part);
            if enough {
                break;
            }
        }
        Ok(parts)
    }

    /// Whether the small quantities appear above the line only, and in no other symbol's meaning.
    fn is_polynomial_in(
        &mut self,
        element: &Fraction,
        small: &[Symbol],
        along: &Differential,
    ) -> Result<bool, AlgebraError> {
        let below = element.denominator().symbols();
        for symbol in below.iter().copied().chain(element.numerator().symbols()) {
            let is_small = small.contains(&symbol);
            if is_small && below.contains(&symbol) {
                return Ok(false);
            }
            if !is_small && !self.image(symbol, along)?.is_zero() {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The terms of one total degree in the small quantities, of a polynomial in them.
    fn part_of_degree(
        &self,
        element: &Fraction,
        small: &[Symbol],
        degree: u32,
    ) -> Result<Fraction, AlgebraError> {
        let terms = element.numerator().terms().iter().filter(|(monomial, _)| {
            small
                .iter()
                .map(|symbol| monomial.exponent(*symbol))
                .sum::<u32>()
                == degree
        });
        self.fraction(
            &Polynomial::from_terms(terms.cloned()),
            element.denominator(),
        )
    }

    /// The element up to terms of total degree `order` in the small quantities.
    ///
    /// Complexity: that of [`Ring::expand`].
    ///
    /// # Errors
    ///
    /// Those of [`Ring::expand`].
    pub fn truncate(
        &mut self,
        element: &Fraction,
        small: &[Symbol],
        order: u32,
    ) -> Result<Fraction, AlgebraError> {
        let parts = self.expand(element, small, order)?;
        parts
            .iter()
            .try_fold(self.zero(), |sum, part| self.sum(&sum, part))
    }

    /// The least degree in the small quantities at which an element has a term, and that term, looking
    /// no further than `highest`; the expansion must exist up to the degree `stated`.
    ///
    /// Complexity: that of [`Ring::expand`] to the degree `highest`.
    ///
    /// # Errors
    ///
    /// Those of [`Ring::expand`].
    pub fn leading_part(
        &mut self,
        element: &Fraction,
        small: &[Symbol],
        stated: u32,
        highest: u32,
    ) -> Result<Option<(u32, Fraction)>, AlgebraError> {
        let parts = self.expand_until(element, small, stated, highest, |degree, part| {
            degree >= stated && !part.is_zero()
        })?;
        Ok((0..).zip(parts).find(|(_, part)| !part.is_zero()))
    }
}
