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
/// own, and what the assumptions give is left out; [`Conditions::distinct`] lists each once.
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
    /// [`AlgebraError::NegativeRadicand`] for one that cannot be, [`AlgebraError::Exhausted`]
    pub fn require_positive(
        &mut self,
        element: &Fraction,
        ring: &Ring,
    ) -> Result<(), AlgebraError> {
        let signs = ring.signs(element)?;
        if signs.is_positive() {
            return Ok(());
        }
        if !signs.positive {
            return Err(AlgebraError::NegativeRadicand);
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

    /// The same conditions, each once: what must not vanish comes apart by common divisors, and what
    /// follows from another condition is left out.
    ///
    /// Complexity: a gcd for each pair of polynomials that must not vanish.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`]
    pub fn distinct(&self, ring: &Ring) -> Result<Conditions, AlgebraError> {
        let of = |wanted| {
            let required = self.required.iter().filter(move |(is, _)| *is == wanted);
            required.map(|(_, polynomial)| polynomial.clone())
        };
        let mut distinct = Conditions::default();
        let positive = of(Requirement::Positive).map(|positive| (Requirement::Positive, positive));
        distinct.required.extend(positive);
        // A complex number is 0 where the square of its magnitude is, which its conjugate shares.
        let mut magnitudes: Vec<Polynomial> = of(Requirement::Positive).collect();
        for factor in coprime(of(Requirement::NonZero).collect(), ring)? {
            let magnitude = ring.norm(&factor)?;
            let mut follows = false;
            for known in &magnitudes {
                follows |= known.divide_exact(&magnitude, ring.budget())?.is_some();
            }
            if !follows {
                distinct.required.insert((Requirement::NonZero, factor));
                magnitudes.push(magnitude);
            }
        }
        Ok(distinct)
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

/// Polynomials without common divisors that vanish where one of the given ones does.
fn coprime(polynomials: Vec<Polynomial>, ring: &Ring) -> Result<Vec<Polynomial>, AlgebraError> {
    let (mut waiting, mut apart) = (polynomials, Vec::<Polynomial>::new());
    while let Some(polynomial) = waiting.pop() {
        let mut shared = None;
        for (place, known) in apart.iter().enumerate() {
            let common = known.gcd(&polynomial, ring.budget())?;
            if common.as_constant().is_none() {
                shared = Some((place, common));
                break;
            }
        }
        let Some((place, common)) = shared else {
            apart.push(polynomial);
            continue;
        };
        // Their degrees together sink by that of the divisor, so that this ends.
        let known = apart.swap_remove(place);
        for side in [&known, &polynomial] {
            let rest = side.divide_exact(&common, ring.budget())?;
            waiting.extend(rest.filter(|rest| rest.as_constant().is_none()));
        }
        waiting.push(common);
    }
    Ok(apart)
}
