//! Expansion in small quantities.

use std::collections::BTreeMap;

use super::arithmetic::{Arithmetic, Division};
use super::differential::Differential;
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::generator::Generator;
use super::number::{Integer, Rational};
use super::ring::Ring;
use super::substitution::Substitution;
use super::symbol::Symbol;

impl Ring {
    /// The terms of total degree 0, 1, …, `order` of an element in the small quantities q.
    ///
    /// The part of degree k is Dᵏf/k! at q = 0, with D the derivative along q: it maps each qᵢ to a
    /// constant δᵢ, which is read as qᵢ in the end.
    ///
    /// Complexity: `order` differentials, each of an element that grows with the degree before, and two
    /// substitutions for each degree.
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
        let mut along = BTreeMap::new();
        let mut at_zero = Substitution::new();
        let mut back = Substitution::new();
        for symbol in small {
            let direction = self.symbol(Generator::Constant { name: format!("δ{}", symbol.index()) })?;
            along.insert(*symbol, self.element(direction));
            at_zero.insert(*symbol, self.zero());
            back.insert(direction, self.element(*symbol));
        }
        let along = Differential::Images(along);
        let mut derivative = element.clone();
        let mut factorial = Integer::ONE;
        let mut parts = Vec::new();
        for degree in 0..=order {
            if degree > 0 {
                derivative = self.differentiate(&derivative, &along)?;
                factorial *= degree;
            }
            let value = self.substitute(&derivative, &at_zero)?;
            let value = self.substitute(&value, &back)?;
            let factorial = Fraction::from(Rational::from(factorial.clone()));
            parts.push(self.quotient(&value, &factorial)?);
        }
        Ok(parts)
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
        parts.iter().try_fold(self.zero(), |sum, part| self.sum(&sum, part))
    }

    /// The least degree in the small quantities at which an element has a term, and that term, looking
    /// no further than `highest`.
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
        highest: u32,
    ) -> Result<Option<(u32, Fraction)>, AlgebraError> {
        let parts = self.expand(element, small, highest)?;
        Ok((0..).zip(parts).find(|(_, part)| !part.is_zero()))
    }
}
