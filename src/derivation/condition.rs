//! What must hold for a value to exist.

use std::collections::BTreeSet;

use crate::algebra::differential::Differential;
use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::number::Rational;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::Ring;
use crate::algebra::substitution::{Replacing, Substitution};
use crate::language::syntax::Expression;

/// What a polynomial must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Requirement {
    /// ≠ 0
    NonZero,
    /// > 0
    Positive,
}

/// A condition as a person reads it.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// The expression.
    pub expression: Expression,
    /// What it must be.
    pub requirement: Requirement,
}

/// What a step of a computation did with a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Step {
    /// It was divided by, so that it must not be 0.
    Division,
    /// Its root was taken, so that it must not be below 0.
    Root,
    /// Its root was differentiated, so that it must be above 0.
    Slope,
}

/// What all steps of a computation need, whatever became of them in the normal form.
///
/// The declared signs and the assumptions are not asked here but by [`Conditions::open`]: what they give
/// may fail where small quantities vanish, and what is above 0 may become 0 by a replacement.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Conditions {
    steps: BTreeSet<(Step, Polynomial)>,
}

impl Conditions {
    /// Adds all of the others.
    pub fn extend(&mut self, others: &Conditions) {
        self.steps.extend(others.steps.iter().cloned());
    }

    /// Notes that something is divided by an element, factor by factor; a root is 0 where its radicand is.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`], [`AlgebraError::Exhausted`]
    pub fn divide(&mut self, element: &Fraction, ring: &Ring) -> Result<(), AlgebraError> {
        if element.is_zero() {
            return Err(AlgebraError::DivisionByZero);
        }
        for (factor, exponent) in ring.factored(element)?.factors {
            match ring.radicand(&factor) {
                _ if exponent < 0 => {}
                Some(radicand) => self.divide(&radicand.clone().into(), ring)?,
                None => drop(self.steps.insert((Step::Division, factor))),
            }
        }
        Ok(())
    }

    /// Notes that the root of an element is taken.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::NegativeRadicand`] for one that is below 0, [`AlgebraError::Exhausted`]
    pub fn root(&mut self, element: &Fraction, ring: &Ring) -> Result<(), AlgebraError> {
        let signs = ring.signs(element)?;
        if !signs.positive && !signs.zero {
            return Err(AlgebraError::NegativeRadicand);
        }
        self.take(Step::Root, element, ring)
    }

    /// Notes that the root of an element is differentiated.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] for 0, [`AlgebraError::NegativeRadicand`] for one that cannot be
    /// above 0, [`AlgebraError::Exhausted`]
    fn slope(&mut self, element: &Fraction, ring: &Ring) -> Result<(), AlgebraError> {
        if element.is_zero() {
            return Err(AlgebraError::DivisionByZero);
        }
        if !ring.signs(element)?.positive {
            return Err(AlgebraError::NegativeRadicand);
        }
        self.take(Step::Slope, element, ring)
    }

    /// Notes a step with an element, whose sign is that of its numerator times its denominator.
    fn take(&mut self, step: Step, element: &Fraction, ring: &Ring) -> Result<(), AlgebraError> {
        let sides = element
            .numerator()
            .multiply(element.denominator(), ring.budget())?;
        let sides = ring.reduce(&sides)?;
        if sides.as_constant().is_none() {
            self.steps.insert((step, sides));
        }
        Ok(())
    }

    /// Notes that roots are differentiated, those which a differential moves.
    ///
    /// # Errors
    ///
    /// Those of [`Ring::differentiate`], and those of a root that has no slope.
    pub fn differentiate(
        &mut self,
        differential: &Differential,
        ring: &mut Ring,
    ) -> Result<(), AlgebraError> {
        let roots = self.steps.iter().filter(|(step, _)| *step == Step::Root);
        for (_, radicand) in roots.cloned().collect::<Vec<_>>() {
            let radicand = Fraction::from(radicand);
            if !ring.differentiate(&radicand, differential)?.is_zero() {
                self.slope(&radicand, ring)?;
            }
        }
        Ok(())
    }

    /// The conditions after a substitution.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] where something that must not vanish becomes 0,
    /// [`AlgebraError::NegativeRadicand`] where a radicand becomes negative, and those of
    /// [`Ring::substitute`].
    pub fn substitute(
        &self,
        substitution: &Substitution,
        ring: &mut Ring,
    ) -> Result<Conditions, AlgebraError> {
        let mut conditions = Conditions::default();
        let mut replacing = Replacing::by(substitution);
        for (step, polynomial) in &self.steps {
            let symbols = ring.constituents(&polynomial.clone().into());
            if symbols
                .iter()
                .all(|symbol| !substitution.contains_key(symbol))
            {
                conditions.steps.insert((*step, polynomial.clone()));
                continue;
            }
            let element = ring.fraction(polynomial, &Polynomial::one())?;
            let image = replacing.image(&element, ring)?;
            match step {
                Step::Division => conditions.divide(&image, ring)?,
                Step::Root => conditions.root(&image, ring)?,
                Step::Slope => conditions.slope(&image, ring)?,
            }
        }
        Ok(conditions)
    }

    /// What remains to be asked for where the declared signs and the assumptions hold, each condition
    /// once: what must not vanish comes apart by common divisors, and what follows from another condition
    /// is left out.
    ///
    /// Complexity: the signs of each polynomial, and a gcd for each pair that must not vanish.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::NegativeRadicand`] for a root that never exists, [`AlgebraError::Exhausted`]
    pub fn open(&self, ring: &Ring) -> Result<Vec<(Requirement, Polynomial)>, AlgebraError> {
        let mut open = Open::default();
        for (step, polynomial) in &self.steps {
            match step {
                Step::Division => open.require_non_zero(polynomial.clone(), ring)?,
                Step::Root if ring.polynomial_signs(polynomial)?.is_non_negative() => {}
                // That a root of 0 exists is left out: what is said must be right, not all.
                Step::Root | Step::Slope => open.require_positive(polynomial, ring)?,
            }
        }
        open.distinct(ring)
    }
}

/// Conditions that do not follow from what is declared and assumed.
#[derive(Default)]
struct Open {
    positive: BTreeSet<Polynomial>,
    non_zero: BTreeSet<Polynomial>,
}

impl Open {
    fn require_non_zero(&mut self, factor: Polynomial, ring: &Ring) -> Result<(), AlgebraError> {
        if !ring.polynomial_signs(&ring.norm(&factor)?)?.is_non_zero() {
            self.non_zero.insert(factor);
        }
        Ok(())
    }

    /// Requires that a polynomial is above 0, without the factors whose signs are known.
    fn require_positive(
        &mut self,
        polynomial: &Polynomial,
        ring: &Ring,
    ) -> Result<(), AlgebraError> {
        let signs = ring.polynomial_signs(polynomial)?;
        if signs.is_positive() {
            return Ok(());
        }
        if !signs.positive {
            return Err(AlgebraError::NegativeRadicand);
        }
        let factored = ring.factored(&polynomial.clone().into())?;
        let mut rest = match factored.coefficient < Rational::ZERO {
            true => -&Polynomial::one(),
            false => Polynomial::one(),
        };
        for (factor, exponent) in factored.factors {
            let signs = ring.polynomial_signs(&factor)?;
            if exponent % 2 == 0 {
                self.require_non_zero(factor, ring)?;
            } else if signs.opposite().is_positive() {
                rest = -&rest;
            } else if !signs.is_positive() {
                rest = rest.multiply(&factor, ring.budget())?;
            }
        }
        let rest = ring.shorten(&ring.reduce(&rest)?)?;
        if !rest.is_one() {
            self.positive.insert(rest);
        }
        Ok(())
    }

    /// Each condition once; what must be above 0 need not be told to differ from it.
    fn distinct(self, ring: &Ring) -> Result<Vec<(Requirement, Polynomial)>, AlgebraError> {
        // A complex number is 0 where the square of its magnitude is, which its conjugate shares.
        let mut magnitudes: Vec<Polynomial> = self.positive.iter().cloned().collect();
        let mut distinct = Vec::new();
        for factor in coprime(self.non_zero.into_iter().collect(), ring)? {
            let magnitude = ring.norm(&factor)?;
            let mut follows = false;
            for known in &magnitudes {
                follows |= known.divide_exact(&magnitude, ring.budget())?.is_some();
            }
            if !follows {
                distinct.push((Requirement::NonZero, factor));
                magnitudes.push(magnitude);
            }
        }
        distinct.sort();
        let positive = self.positive.into_iter();
        distinct.extend(positive.map(|positive| (Requirement::Positive, positive)));
        Ok(distinct)
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
