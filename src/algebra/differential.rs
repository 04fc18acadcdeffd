//! Differentials of a ring, given by the images of its free symbols.

use std::collections::{BTreeMap, BTreeSet};

use super::arithmetic::{Arithmetic, Division};
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::generator::Generator;
use super::polynomial::Polynomial;
use super::ring::Ring;
use super::symbol::Symbol;

/// What a differential does to the free symbols; it carries over to all others by the rules of
/// [`Generator`].
#[derive(Clone, Debug)]
pub enum Differential {
    /// d/dt: every coordinate becomes its next time derivative, constants become 0.
    Time,
    /// The given symbols have the given images, all other free symbols 0. With the image 1 for one
    /// symbol this is the partial derivative with respect to it.
    Images(BTreeMap<Symbol, Fraction>),
}

impl Differential {
    /// ∂/∂q.
    pub fn partial(symbol: Symbol, ring: &Ring) -> Self {
        Differential::Images(BTreeMap::from([(symbol, ring.one())]))
    }
}

impl Ring {
    /// What stands under the roots of an element that a differential moves: dw = dp/(2w) asks that it is
    /// not 0.
    ///
    /// Complexity: that of [`Ring::differentiate`] for each radicand.
    ///
    /// # Errors
    ///
    /// Those of [`Ring::differentiate`].
    pub fn moving_radicands(
        &mut self,
        element: &Fraction,
        differential: &Differential,
    ) -> Result<Vec<Polynomial>, AlgebraError> {
        let symbols_of = |element: &Fraction| {
            let mut symbols = element.numerator().symbols();
            symbols.extend(element.denominator().symbols());
            symbols
        };
        let mut open: Vec<Symbol> = symbols_of(element).into_iter().collect();
        let (mut seen, mut moving) = (BTreeSet::new(), Vec::new());
        while let Some(symbol) = open.pop() {
            if !seen.insert(symbol) {
                continue;
            }
            match self.generator(symbol).clone() {
                Generator::Root { radicand } => {
                    open.extend(radicand.symbols());
                    let change = self.differentiate_polynomial(&radicand, differential)?;
                    if !change.is_zero() {
                        moving.push(radicand);
                    }
                }
                Generator::FunctionValue { argument, .. } => open.extend(symbols_of(&argument)),
                Generator::Direction { x, y, .. } => {
                    open.extend(symbols_of(&x));
                    open.extend(symbols_of(&y));
                }
                Generator::Cosine { angle } | Generator::Sine { angle } => {
                    open.extend(angle.coefficients().map(|(inside, _)| inside));
                }
                _ => {}
            }
        }
        Ok(moving)
    }

    /// The image of an element under a differential.
    ///
    /// d(N/D) = dN/D − (N/D)·(dD/D) with dP = Σ_g ∂P/∂g · dg over the symbols g of P, and dg the image
    /// of g.
    ///
    /// Complexity: for each symbol of the element, one pass over its terms and one product.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] where the budget or a polynomial's size runs out,
    /// [`AlgebraError::TooManySymbols`] where the ring has no room for a time derivative or the next
    /// derivative of a function.
    ///
    /// ```
    /// use sextic::algebra::{
    ///     arithmetic::Arithmetic, budget::Budget, differential::Differential,
    ///     generator::Generator, ring::Ring,
    /// };
    ///
    /// let mut ring = Ring::new(Budget::new(10_000));
    /// let coordinate = |order| Generator::Coordinate { name: "x".into(), order, angular: false };
    /// let (x, speed) = (ring.symbol(coordinate(0))?, ring.symbol(coordinate(1))?);
    /// let (x, speed) = (ring.element(x), ring.element(speed));
    /// // d(x²)/dt = 2 x ẋ
    /// let change = ring.differentiate(&ring.product(&x, &x)?, &Differential::Time)?;
    /// let product = ring.product(&x, &speed)?;
    /// assert_eq!(change, ring.sum(&product, &product)?);
    /// # Ok::<(), sextic::algebra::error::AlgebraError>(())
    /// ```
    pub fn differentiate(
        &mut self,
        element: &Fraction,
        differential: &Differential,
    ) -> Result<Fraction, AlgebraError> {
        let numerator = self.differentiate_polynomial(element.numerator(), differential)?;
        let denominator = self.differentiate_polynomial(element.denominator(), differential)?;
        let below = Fraction::from(element.denominator().clone());
        let change = self.quotient(&numerator, &below)?;
        if denominator.is_zero() {
            return Ok(change);
        }
        let relative = self.quotient(&denominator, &below)?;
        self.difference(&change, &self.product(element, &relative)?)
    }

    fn differentiate_polynomial(
        &mut self,
        polynomial: &Polynomial,
        differential: &Differential,
    ) -> Result<Fraction, AlgebraError> {
        let mut sum = self.zero();
        let symbols = polynomial.symbols();
        let width = symbols.len().max(8);
        for symbol in symbols {
            let image = self.image(symbol, differential)?;
            if image.is_zero() {
                continue;
            }
            // Derivatives and sums cost steps for their terms, more for long ones.
            let terms = polynomial.len() + sum.numerator().len();
            self.budget().spend((width * terms) as u64)?;
            let slope = Fraction::from(polynomial.derivative(symbol));
            sum = self.sum(&sum, &self.product(&slope, &image)?)?;
        }
        Ok(sum)
    }

    /// dg of one symbol g.
    pub(super) fn image(
        &mut self,
        symbol: Symbol,
        differential: &Differential,
    ) -> Result<Fraction, AlgebraError> {
        if let Differential::Images(images) = differential
            && let Some(image) = images.get(&symbol)
        {
            return Ok(image.clone());
        }
        match self.generator(symbol).clone() {
            Generator::Constant { .. } | Generator::Angle { .. } | Generator::ImaginaryUnit => {
                Ok(self.zero())
            }
            Generator::Coordinate { name, order, .. } => match differential {
                Differential::Time => {
                    let next = Generator::Coordinate {
                        name,
                        order: order + 1,
                        angular: false,
                    };
                    let next = self.symbol(next)?;
                    Ok(self.element(next))
                }
                Differential::Images(_) => Ok(self.zero()),
            },
            Generator::Cosine { angle } => {
                let turn = self.differentiate(&self.angle_element(&angle), differential)?;
                if turn.is_zero() {
                    return Ok(turn);
                }
                let (_, sine) = self.cosine_and_sine(&angle)?;
                self.product(&self.negative(&sine), &turn)
            }
            Generator::Sine { angle } => {
                let turn = self.differentiate(&self.angle_element(&angle), differential)?;
                if turn.is_zero() {
                    return Ok(turn);
                }
                let (cosine, _) = self.cosine_and_sine(&angle)?;
                self.product(&cosine, &turn)
            }
            Generator::Root { radicand } => {
                let change = self.differentiate_polynomial(&radicand, differential)?;
                if change.is_zero() {
                    return Ok(change);
                }
                let twice = self.sum(&self.element(symbol), &self.element(symbol))?;
                self.quotient(&change, &twice)
            }
            Generator::Direction { x, y, length } => {
                let (dx, dy) = (
                    self.differentiate(&x, differential)?,
                    self.differentiate(&y, differential)?,
                );
                let across = self.difference(&self.product(&x, &dy)?, &self.product(&y, &dx)?)?;
                self.quotient(&across, &self.product(&length, &length)?)
            }
            Generator::FunctionValue {
                name,
                order,
                argument,
            } => {
                let change = self.differentiate(&argument, differential)?;
                if change.is_zero() {
                    return Ok(change);
                }
                let slope = self.function_value(&name, order + 1, &argument)?;
                self.product(&slope, &change)
            }
        }
    }
}
