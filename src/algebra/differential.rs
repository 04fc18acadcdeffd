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
        Changes::by(differential, self).of(element)
    }
}

/// A differential at work, which keeps the changes of the symbols that it has met.
struct Changes<'a> {
    differential: &'a Differential,
    ring: &'a mut Ring,
    known: BTreeMap<Symbol, Fraction>,
}

impl<'a> Changes<'a> {
    fn by(differential: &'a Differential, ring: &'a mut Ring) -> Self {
        let known = match differential {
            Differential::Time => BTreeMap::new(),
            Differential::Images(images) => images.clone(),
        };
        Changes {
            differential,
            ring,
            known,
        }
    }

    /// d(N/D)
    fn of(&mut self, element: &Fraction) -> Result<Fraction, AlgebraError> {
        self.find(element.symbols())?;
        let numerator = self.of_polynomial(element.numerator())?;
        let denominator = self.of_polynomial(element.denominator())?;
        let below = Fraction::from(element.denominator().clone());
        let change = self.ring.quotient(&numerator, &below)?;
        if denominator.is_zero() {
            return Ok(change);
        }
        let relative = self.ring.quotient(&denominator, &below)?;
        let product = self.ring.product(element, &relative)?;
        self.ring.difference(&change, &product)
    }

    /// Finds the changes of symbols, after those of all that they stand for.
    fn find(&mut self, symbols: BTreeSet<Symbol>) -> Result<(), AlgebraError> {
        let known = |symbol: &Symbol| self.known.contains_key(symbol);
        for symbol in self.ring.unknown_constituents(symbols, known) {
            self.ring.budget().spend(1)?;
            let change = self.of_symbol(symbol)?;
            self.known.insert(symbol, change);
        }
        Ok(())
    }

    /// dP of a polynomial in known symbols.
    fn of_polynomial(&self, polynomial: &Polynomial) -> Result<Fraction, AlgebraError> {
        let mut sum = self.ring.zero();
        let symbols = polynomial.symbols();
        let width = symbols.len().max(8);
        for symbol in symbols {
            let Some(change) = self.known.get(&symbol).filter(|change| !change.is_zero()) else {
                continue;
            };
            // Derivatives and sums cost steps for their terms, more for long ones.
            let terms = polynomial.len() + sum.numerator().len();
            self.ring.budget().spend((width * terms) as u64)?;
            let slope = Fraction::from(polynomial.derivative(symbol));
            sum = self.ring.sum(&sum, &self.ring.product(&slope, change)?)?;
        }
        Ok(sum)
    }

    /// dg of a symbol g that is not known yet, though all that it stands for are.
    fn of_symbol(&mut self, symbol: Symbol) -> Result<Fraction, AlgebraError> {
        match self.ring.generator(symbol).clone() {
            Generator::Constant { .. } | Generator::Angle { .. } | Generator::ImaginaryUnit => {
                Ok(self.ring.zero())
            }
            Generator::Coordinate { name, order, .. } => self.of_coordinate(name, order),
            Generator::Cosine { angle } => self.along(&self.ring.angle_element(&angle), |ring| {
                let (_, sine) = ring.cosine_and_sine(&angle)?;
                Ok(ring.negative(&sine))
            }),
            Generator::Sine { angle } => self.along(&self.ring.angle_element(&angle), |ring| {
                Ok(ring.cosine_and_sine(&angle)?.0)
            }),
            Generator::Root { radicand } => self.along(&radicand.into(), |ring| {
                let root = ring.element(symbol);
                ring.quotient(&ring.one(), &ring.sum(&root, &root)?)
            }),
            Generator::Direction { x, y, length } => self.of_direction(&x, &y, &length),
            Generator::FunctionValue {
                name,
                order,
                argument,
            } => self.along(&argument, |ring| {
                ring.function_value(&name, order + 1, &argument)
            }),
        }
    }

    /// The next time derivative of a coordinate, which changes with time alone.
    fn of_coordinate(&mut self, name: String, order: u32) -> Result<Fraction, AlgebraError> {
        let Differential::Time = self.differential else {
            return Ok(self.ring.zero());
        };
        let next = Generator::Coordinate {
            name,
            order: order + 1,
            angular: false,
        };
        let next = self.ring.symbol(next)?;
        Ok(self.ring.element(next))
    }

    /// f′(a) da, where the slope f′(a) is asked for only if a changes.
    fn along(
        &mut self,
        argument: &Fraction,
        slope: impl FnOnce(&mut Ring) -> Result<Fraction, AlgebraError>,
    ) -> Result<Fraction, AlgebraError> {
        let change = self.of(argument)?;
        if change.is_zero() {
            return Ok(change);
        }
        let slope = slope(self.ring)?;
        self.ring.product(&slope, &change)
    }

    /// (x dy − y dx)/w²
    fn of_direction(
        &mut self,
        x: &Fraction,
        y: &Fraction,
        length: &Fraction,
    ) -> Result<Fraction, AlgebraError> {
        let (dx, dy) = (self.of(x)?, self.of(y)?);
        let ring = &self.ring;
        let across = ring.difference(&ring.product(x, &dy)?, &ring.product(y, &dx)?)?;
        ring.quotient(&across, &ring.product(length, length)?)
    }
}
