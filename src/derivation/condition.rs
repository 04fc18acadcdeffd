//! What must hold for a value to exist.

use std::collections::BTreeSet;

use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::number::Rational;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::Ring;
use crate::algebra::substitution::Substitution;

/// What a polynomial must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Requirement {
    /// ≠ 0: something was divided by it.
    NonZero,
    /// > 0: the root of it was taken.
    Positive,
}

/// Conditions in lowest terms: of a product that must not vanish, each factor is a condition of its
/// own, and what the assumptions give is left out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Conditions {
    required: BTreeSet<(Requirement, Polynomial)>,
}

impl Conditions {
    /// Whether nothing is required.
    pub fn is_empty(&self) -> bool {
        self.required.is_empty()
    }

    /// The polynomials and what they must be; what must be above 0 need not be told to differ from it.
    pub fn iter(&self) -> impl Iterator<Item = &(Requirement, Polynomial)> {
        let is_positive = |polynomial: &Polynomial| {
            let positive = (Requirement::Positive, polynomial.clone());
            self.required.contains(&positive)
        };
        self.required
            .iter()
            .filter(move |(requirement, polynomial)| {
                *requirement == Requirement::Positive || !is_positive(polynomial)
            })
    }

    /// Adds all of the others.
    pub fn extend(&mut self, others: &Conditions) {
        self.required.extend(others.required.iter().cloned());
    }

    /// Requires that an element is not 0, factor by factor; a root is 0 where its radicand is.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`]
    pub fn require_non_zero(
        &mut self,
        element: &Fraction,
        ring: &Ring,
    ) -> Result<(), AlgebraError> {
        for (factor, exponent) in ring.factored(element)?.factors {
            if exponent > 0 && !ring.polynomial_signs(&ring.norm(&factor)?)?.is_non_zero() {
                match ring.radicand(&factor) {
                    Some(radicand) => self.require_non_zero(&radicand.clone().into(), ring)?,
                    None => drop(self.required.insert((Requirement::NonZero, factor))),
                }
            }
        }
        Ok(())
    }

    /// Requires that an element is above 0, without the factors whose signs are known.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`]
    pub fn require_positive(
        &mut self,
        element: &Fraction,
        ring: &Ring,
    ) -> Result<(), AlgebraError> {
        if ring.signs(element)?.is_positive() {
            return Ok(());
        }
        let factored = ring.factored(element)?;
        let mut rest = match factored.coefficient < Rational::ZERO {
            true => -&Polynomial::one(),
            false => Polynomial::one(),
        };
        for (factor, exponent) in factored.factors {
            let signs = ring.polynomial_signs(&factor)?;
            if exponent % 2 == 0 {
                self.require_non_zero(&factor.into(), ring)?;
            } else if signs.opposite().is_positive() {
                rest = -&rest;
            } else if !signs.is_positive() {
                rest = rest.multiply(&factor, ring.budget())?;
            }
        }
        let rest = ring.shorten(&ring.reduce(&rest)?)?;
        if !rest.is_one() {
            self.required.insert((Requirement::Positive, rest));
        }
        Ok(())
    }

    /// The conditions after a substitution.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] where something that must not vanish becomes 0, and those of
    /// [`Ring::substitute`].
    pub fn substitute(
        &self,
        substitution: &Substitution,
        ring: &mut Ring,
    ) -> Result<Conditions, AlgebraError> {
        let mut conditions = Conditions::default();
        for (requirement, polynomial) in &self.required {
            let element = ring.fraction(polynomial, &Polynomial::one())?;
            let image = ring.substitute(&element, substitution)?;
            match requirement {
                Requirement::NonZero if image.is_zero() => {
                    return Err(AlgebraError::DivisionByZero);
                }
                Requirement::NonZero => conditions.require_non_zero(&image, ring)?,
                // The root of 0 is 0; a slope there is another condition.
                Requirement::Positive if image.is_zero() => {}
                Requirement::Positive => conditions.require_positive(&image, ring)?,
            }
        }
        Ok(conditions)
    }
}
