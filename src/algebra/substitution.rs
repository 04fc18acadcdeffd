//! Substitutions of the free symbols of a ring.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use super::arithmetic::{Arithmetic, Division};
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::generator::Generator;
use super::polynomial::Polynomial;
use super::ring::Ring;
use super::symbol::Symbol;

/// What replaces what, all at once; symbols that are not named stay.
pub type Substitution = BTreeMap<Symbol, Fraction>;

impl Ring {
    /// The image of an element under a substitution of free symbols (or of values of functions known
    /// only through their derivatives).
    ///
    /// The other symbols follow by what they stand for: a sine becomes the sine of the image of its
    /// angle, a root the root of the image of its radicand.
    ///
    /// Complexity: one product at most for each term and each symbol that changes in it.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] where the denominator becomes 0,
    /// [`AlgebraError::NotAnAngle`] where an angle is replaced by something that is none, and those
    /// of [`Ring::cosine_and_sine`] and [`Ring::square_root`].
    ///
    /// ```
    /// use sextic::algebra::{
    ///     arithmetic::Arithmetic, budget::Budget, generator::Generator, ring::Ring,
    ///     substitution::Substitution,
    /// };
    ///
    /// let mut ring = Ring::new(Budget::new(10_000));
    /// let alpha = ring.symbol(Generator::Angle { name: "α".into() })?;
    /// let angle = ring.angle(&ring.element(alpha)).expect("α is an angle");
    /// let (cosine, _) = ring.cosine_and_sine(&angle)?;
    /// // cos 0 = 1
    /// let at_zero = Substitution::from([(alpha, ring.zero())]);
    /// assert_eq!(ring.substitute(&cosine, &at_zero)?, ring.one());
    /// # Ok::<(), sextic::algebra::error::AlgebraError>(())
    /// ```
    pub fn substitute(
        &mut self,
        element: &Fraction,
        substitution: &Substitution,
    ) -> Result<Fraction, AlgebraError> {
        let numerator = self.substitute_polynomial(element.numerator(), substitution)?;
        let denominator = self.substitute_polynomial(element.denominator(), substitution)?;
        self.quotient(&numerator, &denominator)
    }

    fn substitute_polynomial(
        &mut self,
        polynomial: &Polynomial,
        substitution: &Substitution,
    ) -> Result<Fraction, AlgebraError> {
        let mut images = Vec::new();
        for symbol in polynomial.symbols() {
            if let Some(image) = self.substituted(symbol, substitution)? {
                images.push((symbol, image));
            }
        }
        // What becomes 0 goes first, and takes its terms with it; long images are multiplied last.
        images.sort_by_key(|(_, image)| {
            let terms = image.numerator().len() + image.denominator().len();
            (!image.is_zero(), Reverse(terms))
        });
        self.horner(polynomial, &images)
    }

    /// The value of a polynomial with images in place of some of its symbols, by Horner's rule in the
    /// first of them, with coefficients that are found in the same way from the others.
    fn horner(
        &self,
        polynomial: &Polynomial,
        images: &[(Symbol, Fraction)],
    ) -> Result<Fraction, AlgebraError> {
        let Some(((symbol, image), others)) = images.split_first() else {
            return Ok(Fraction::from(polynomial.clone()));
        };
        self.budget().spend(polynomial.len() as u64)?;
        let coefficients = polynomial.coefficients_in(*symbol);
        if image.is_zero() {
            let constant = coefficients.get(&0);
            return constant.map_or(Ok(self.zero()), |constant| self.horner(constant, others));
        }
        let mut value = self.zero();
        let mut reached = coefficients.keys().last().copied().unwrap_or(0);
        for (exponent, coefficient) in coefficients.iter().rev() {
            let lowered =
                self.product(&value, &self.power(image, i64::from(reached - exponent))?)?;
            value = self.sum(&lowered, &self.horner(coefficient, others)?)?;
            reached = *exponent;
        }
        self.product(&value, &self.power(image, i64::from(reached))?)
    }

    /// The image of one symbol; nothing where it stays.
    fn substituted(
        &mut self,
        symbol: Symbol,
        substitution: &Substitution,
    ) -> Result<Option<Fraction>, AlgebraError> {
        if let Some(image) = substitution.get(&symbol) {
            return Ok(Some(image.clone()));
        }
        match self.generator(symbol).clone() {
            Generator::Constant { .. }
            | Generator::Angle { .. }
            | Generator::Coordinate { .. }
            | Generator::ImaginaryUnit => Ok(None),
            Generator::Cosine { angle } => {
                let turned = self.substituted_angle(&self.angle_element(&angle), substitution)?;
                Ok(turned.map(|(cosine, _)| cosine))
            }
            Generator::Sine { angle } => {
                let turned = self.substituted_angle(&self.angle_element(&angle), substitution)?;
                Ok(turned.map(|(_, sine)| sine))
            }
            Generator::Root { radicand } => {
                let radicand = Fraction::from(radicand);
                let image = self.substitute(&radicand, substitution)?;
                if image == radicand {
                    Ok(None)
                } else {
                    self.square_root(&image).map(Some)
                }
            }
            Generator::Direction { x, y, .. } => {
                let image_x = self.substitute(&x, substitution)?;
                let image_y = self.substitute(&y, substitution)?;
                if image_x == x && image_y == y {
                    Ok(None)
                } else {
                    self.direction(&image_x, &image_y).map(Some)
                }
            }
            Generator::FunctionValue {
                name,
                order,
                argument,
            } => {
                let image = self.substitute(&argument, substitution)?;
                if image == argument {
                    Ok(None)
                } else {
                    self.function_value(&name, order, &image).map(Some)
                }
            }
        }
    }

    /// The cosine and sine of the image of an angle; nothing where it stays.
    fn substituted_angle(
        &mut self,
        angle: &Fraction,
        substitution: &Substitution,
    ) -> Result<Option<(Fraction, Fraction)>, AlgebraError> {
        let image = self.substitute(angle, substitution)?;
        if image == *angle {
            return Ok(None);
        }
        let image = self.angle(&image).ok_or(AlgebraError::NotAnAngle)?;
        self.cosine_and_sine(&image).map(Some)
    }
}
