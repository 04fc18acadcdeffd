//! Expansion in small quantities.

use super::arithmetic::Arithmetic;
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::polynomial::Polynomial;
use super::ring::Ring;
use super::series::Expansion;
use super::symbol::Symbol;

impl Ring {
    /// The terms of total degree 0, 1, …, `order` of an element in the small quantities q.
    ///
    /// They are those of the power series in q, as far as the element is smooth at q = 0.
    ///
    /// Complexity: for each degree one pass over the terms of a polynomial in q; of anything else, the
    /// square of the order in products for each symbol that depends on q.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] where the element or a derivative has no value at q = 0,
    /// and those of the arithmetic.
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
    fn expand_until(
        &mut self,
        element: &Fraction,
        small: &[Symbol],
        required: u32,
        order: u32,
        last: impl Fn(u32, &Fraction) -> bool,
    ) -> Result<Vec<Fraction>, AlgebraError> {
        let polynomial = self.is_polynomial_in(element, small);
        let mut reached = required;
        loop {
            let mut parts = match polynomial {
                true => self.parts_to(element, small, reached)?,
                false => Expansion::new(self, small, reached).parts(element)?,
            };
            if parts.len() <= required as usize {
                return Err(AlgebraError::DivisionByZero);
            }
            let found = (0..)
                .zip(&parts)
                .position(|(degree, part)| last(degree, part));
            if let Some(found) = found {
                parts.truncate(found + 1);
            }
            // Behind a part that does not exist there is none.
            if found.is_some() || reached >= order || parts.len() <= reached as usize {
                return Ok(parts);
            }
            reached = (2 * reached).max(reached + 2).min(order);
        }
    }

    /// Whether the small quantities appear above the line only, and in no other symbol's meaning.
    fn is_polynomial_in(&self, element: &Fraction, small: &[Symbol]) -> bool {
        let is_small = |symbol: &Symbol| small.contains(symbol);
        let mut symbols = element.numerator().symbols();
        symbols.retain(|symbol| !is_small(symbol));
        symbols.append(&mut element.denominator().symbols());
        let constituents = self.unknown_constituents(symbols, |_| false);
        !constituents.iter().any(is_small)
    }

    /// The terms of each total degree up to an order, of a polynomial in the small quantities.
    fn parts_to(
        &self,
        element: &Fraction,
        small: &[Symbol],
        order: u32,
    ) -> Result<Vec<Fraction>, AlgebraError> {
        (0..=order)
            .map(|degree| self.part_of_degree(element, small, degree))
            .collect()
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
