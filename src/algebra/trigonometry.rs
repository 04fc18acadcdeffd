//! Sines and cosines of sums of angles, and the angles of vectors.

use std::collections::BTreeSet;

use super::angle::{Angle, Decomposition, decompose};
use super::arithmetic::{Arithmetic, Division};
use super::differential::Differential;
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::generator::Generator;
use super::monomial::Monomial;
use super::number::{Integer, Rational};
use super::polynomial::Polynomial;
use super::ring::{BasisAngle, Ring};
use super::symbol::Symbol;

impl Ring {
    /// The element as an angle, where it is a sum of angular symbols with integer coefficients.
    pub fn angle(&self, element: &Fraction) -> Option<Angle> {
        if element.denominator().as_constant()? != Integer::ONE {
            return None;
        }
        let terms = element.numerator().terms().iter();
        let coefficients: Option<Vec<(Symbol, Integer)>> = terms
            .map(|(monomial, coefficient)| {
                let (symbol, _) = monomial
                    .factors()
                    .next()
                    .filter(|_| monomial.degree() == 1)?;
                self.generator(symbol)
                    .is_angular()
                    .then(|| (symbol, coefficient.clone()))
            })
            .collect();
        Some(Angle::new(coefficients?))
    }

    /// The angle as an element.
    pub fn angle_element(&self, angle: &Angle) -> Fraction {
        let terms = angle
            .coefficients()
            .map(|(symbol, k)| (Monomial::power(symbol, 1), k.clone()));
        Fraction::from(Polynomial::from_terms(terms))
    }

    /// (cos A, sin A), by the addition formulas from the basis; an angle that is independent of the
    /// basis joins it.
    ///
    /// With A = Σ kᵢ Bᵢ over the angles Bᵢ of the basis, cos A + i sin A = Π (cos Bᵢ + i sin Bᵢ)^kᵢ.
    ///
    /// Complexity: one elimination with a row for each symbol and a column for each angle of the
    /// basis, then four products for each unit of each kᵢ.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::FractionalAngle`] where A is a fraction of what the basis holds,
    /// [`AlgebraError::TooManySymbols`] where the ring is full, [`AlgebraError::Exhausted`] where the
    /// budget runs out.
    ///
    /// ```
    /// use sextic::algebra::{
    ///     angle::Angle, arithmetic::Arithmetic, budget::Budget, generator::Generator, ring::Ring,
    /// };
    ///
    /// let mut ring = Ring::new(Budget::new(10_000));
    /// let alpha = ring.symbol(Generator::Angle { name: "α".into() })?;
    /// let [once, twice] = [1, 2].map(|k| Angle::new([(alpha, k.into())]));
    /// let (cosine, sine) = ring.cosine_and_sine(&once)?;
    /// let product = ring.product(&cosine, &sine)?;
    /// assert_eq!(ring.cosine_and_sine(&twice)?.1, ring.sum(&product, &product)?);
    /// # Ok::<(), sextic::algebra::error::AlgebraError>(())
    /// ```
    pub fn cosine_and_sine(&mut self, angle: &Angle) -> Result<(Fraction, Fraction), AlgebraError> {
        let mut result = (self.one(), self.zero());
        let mut free = angle.clone();
        for (symbol, k) in angle.coefficients() {
            let pair = match self.generator(symbol).clone() {
                // The angle of a vector (x, y) of length w has the cosine x/w and the sine y/w.
                Generator::Direction { x, y, length } => {
                    (self.quotient(&x, &length)?, self.quotient(&y, &length)?)
                }
                // What changes with time stands apart from what does not.
                Generator::Coordinate { .. } => {
                    let angle = Angle::new([(symbol, Integer::ONE)]);
                    let BasisAngle { cosine, sine, .. } = self.basis_angle(angle)?;
                    (self.element(cosine), self.element(sine))
                }
                _ => continue,
            };
            result = self.turn(result, &self.multiple(&pair, k)?)?;
            free = free.split_off(symbol).0;
        }
        if free.is_zero() {
            return Ok(result);
        }
        let known: Vec<Angle> = self.basis.iter().map(|basis| basis.angle.clone()).collect();
        let multiples = match decompose(&free, &known) {
            Decomposition::Integral(multiples) => multiples,
            Decomposition::Fractional => return Err(AlgebraError::FractionalAngle),
            Decomposition::Independent => {
                let (primitive, k) = free.primitive();
                self.basis_angle(primitive)?;
                known.iter().map(|_| Integer::ZERO).chain([k]).collect()
            }
        };
        for (basis, k) in self
            .basis
            .iter()
            .zip(&multiples)
            .filter(|(_, k)| !k.is_zero())
        {
            let pair = (self.element(basis.cosine), self.element(basis.sine));
            result = self.turn(result, &self.multiple(&pair, k)?)?;
        }
        Ok(result)
    }

    /// The cosine and sine of an angle of the basis, which joins it if it is new.
    fn basis_angle(&mut self, angle: Angle) -> Result<BasisAngle, AlgebraError> {
        if let Some(known) = self.basis.iter().find(|known| known.angle == angle) {
            return Ok(known.clone());
        }
        let cosine = self.symbol(Generator::Cosine {
            angle: angle.clone(),
        })?;
        let sine = self.symbol(Generator::Sine {
            angle: angle.clone(),
        })?;
        self.basis.push(BasisAngle {
            angle,
            cosine,
            sine,
        });
        self.basis
            .last()
            .cloned()
            .ok_or(AlgebraError::TooManySymbols)
    }

    /// (cos(A + B), sin(A + B)).
    fn turn(
        &self,
        (cos_a, sin_a): (Fraction, Fraction),
        (cos_b, sin_b): &(Fraction, Fraction),
    ) -> Result<(Fraction, Fraction), AlgebraError> {
        let cosine =
            self.difference(&self.product(&cos_a, cos_b)?, &self.product(&sin_a, sin_b)?)?;
        let sine = self.sum(&self.product(&sin_a, cos_b)?, &self.product(&cos_a, sin_b)?)?;
        Ok((cosine, sine))
    }

    /// (cos kA, sin kA).
    fn multiple(
        &self,
        (cosine, sine): &(Fraction, Fraction),
        k: &Integer,
    ) -> Result<(Fraction, Fraction), AlgebraError> {
        let count = i64::try_from(k).map_err(|_| AlgebraError::FractionalAngle)?;
        let sine = if count < 0 {
            self.negative(sine)
        } else {
            sine.clone()
        };
        let step = (cosine.clone(), sine);
        let mut result = (self.one(), self.zero());
        for _ in 0..count.unsigned_abs() {
            self.budget().spend(1)?;
            result = self.turn(result, &step)?;
        }
        Ok(result)
    }

    /// The angle of the vector (x, y): a sum A of angular symbols with whole coefficients where the vector
    /// is parallel to (cos A, sin A), else a symbol of its own.
    ///
    /// Complexity: for each angular symbol in the sines and cosines of x and y a derivative of both, then
    /// one [`Ring::square_root`].
    ///
    /// # Errors
    ///
    /// [`AlgebraError::NotReal`] where x or y is not real, [`AlgebraError::DivisionByZero`] for the vector
    /// (0, 0), and those of [`Ring::square_root`] and [`Ring::differentiate`].
    pub fn direction(&mut self, x: &Fraction, y: &Fraction) -> Result<Fraction, AlgebraError> {
        let (x, y) = (&self.canonical(x)?, &self.canonical(y)?);
        self.real(x)?;
        self.real(y)?;
        let square = self.sum(&self.product(x, x)?, &self.product(y, y)?)?;
        if square.is_zero() {
            return Err(AlgebraError::DivisionByZero);
        }
        if let Some(angle) = self.turns(x, y, &square)?
            && self.is_parallel(x, y, &angle)?
        {
            return Ok(self.angle_element(&angle));
        }
        let length = self.square_root(&square)?;
        let [x, y, length] = [x.clone(), y.clone(), length].map(Box::new);
        let symbol = self.symbol(Generator::Direction { x, y, length })?;
        Ok(self.element(symbol))
    }

    /// The only sum of angular symbols with whole coefficients that may be the angle of the vector
    /// (x, y): its slopes (x dy − y dx)/(x² + y²) are the coefficients.
    fn turns(
        &mut self,
        x: &Fraction,
        y: &Fraction,
        square: &Fraction,
    ) -> Result<Option<Angle>, AlgebraError> {
        let mut coefficients = Vec::new();
        for symbol in self.turning_symbols(&[x, y]) {
            let by = Differential::partial(symbol, self);
            let (dx, dy) = (self.differentiate(x, &by)?, self.differentiate(y, &by)?);
            let across = self.difference(&self.product(x, &dy)?, &self.product(y, &dx)?)?;
            let slope = self.quotient(&across, square)?.as_constant();
            let Some(whole) = slope.filter(Rational::is_int) else {
                return Ok(None);
            };
            coefficients.push((symbol, whole.into_parts().0));
        }
        Ok(Some(Angle::new(coefficients)))
    }

    /// The declared angles and coordinates of which sines and cosines are taken in some elements.
    fn turning_symbols(&self, elements: &[&Fraction]) -> BTreeSet<Symbol> {
        let constituents = elements
            .iter()
            .flat_map(|element| self.constituents(element));
        let circular = constituents.filter(|symbol| {
            let generator = self.generator(*symbol);
            matches!(generator, Generator::Cosine { .. } | Generator::Sine { .. })
        });
        circular.flat_map(|symbol| self.parts_of(symbol)).collect()
    }

    /// Whether (x, y) is parallel to (cos A, sin A): x sin A = y cos A and x cos A + y sin A > 0.
    fn is_parallel(
        &mut self,
        x: &Fraction,
        y: &Fraction,
        angle: &Angle,
    ) -> Result<bool, AlgebraError> {
        let (cosine, sine) = match self.cosine_and_sine(angle) {
            Err(AlgebraError::FractionalAngle) => return Ok(false),
            found => found?,
        };
        let across = self.difference(&self.product(x, &sine)?, &self.product(y, &cosine)?)?;
        if !across.is_zero() {
            return Ok(false);
        }
        let along = self.sum(&self.product(x, &cosine)?, &self.product(y, &sine)?)?;
        Ok(self.signs(&along)?.is_positive())
    }
}
