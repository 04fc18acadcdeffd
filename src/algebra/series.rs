//! Power series in small quantities, cut off behind an order.

use std::collections::{BTreeMap, BTreeSet};

use super::arithmetic::{Arithmetic, Division};
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::generator::Generator;
use super::number::{Integer, Rational};
use super::polynomial::Polynomial;
use super::ring::Ring;
use super::symbol::Symbol;

/// The parts of degree 0, 1, … of an element in the small quantities, as far as they are known: what
/// is left out is of a smaller order than the last of them.
#[derive(Clone, Debug)]
struct Series {
    parts: Vec<Fraction>,
}

/// Elements as power series in small quantities up to an order.
pub(super) struct Expansion<'a> {
    ring: &'a mut Ring,
    small: &'a [Symbol],
    order: usize,
    /// The series of the symbols that were met; nothing for one that does not depend on the small
    /// quantities.
    known: BTreeMap<Symbol, Option<Series>>,
}

impl<'a> Expansion<'a> {
    pub(super) fn new(ring: &'a mut Ring, small: &'a [Symbol], order: u32) -> Self {
        Expansion {
            ring,
            small,
            order: order as usize,
            known: BTreeMap::new(),
        }
    }

    /// The parts of an element of degree 0, 1, …, as far as it is smooth; the first always exists.
    ///
    /// Complexity: for each symbol that depends on the small quantities, and each quotient, the square
    /// of the order in products.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] where the element has no value where the small quantities vanish,
    /// and those of the arithmetic.
    pub(super) fn parts(&mut self, element: &Fraction) -> Result<Vec<Fraction>, AlgebraError> {
        Ok(self.element(element)?.parts)
    }

    fn element(&mut self, element: &Fraction) -> Result<Series, AlgebraError> {
        let above = self.polynomial(element.numerator())?;
        let below = self.polynomial(element.denominator())?;
        self.quotient(&above, &below)
    }

    fn polynomial(&mut self, polynomial: &Polynomial) -> Result<Series, AlgebraError> {
        self.find(polynomial.symbols())?;
        let symbols = polynomial.symbols().into_iter();
        let moving: Vec<Symbol> = symbols.filter(|symbol| self.moves(symbol)).collect();
        self.horner(polynomial, &moving)
    }

    fn moves(&self, symbol: &Symbol) -> bool {
        matches!(self.known.get(symbol), Some(Some(_)))
    }

    /// Finds the series of symbols, after those of all that they stand for.
    fn find(&mut self, symbols: BTreeSet<Symbol>) -> Result<(), AlgebraError> {
        let known = |symbol: &Symbol| self.known.contains_key(symbol);
        for symbol in self.ring.unknown_constituents(symbols, known) {
            self.ring.budget().spend(1)?;
            let parts = self.ring.parts_of(symbol);
            let moves = self.small.contains(&symbol) || parts.iter().any(|part| self.moves(part));
            let series = moves.then(|| self.symbol(symbol)).transpose()?;
            self.known.insert(symbol, series);
        }
        Ok(())
    }

    /// Horner's rule in one symbol, with coefficients that are found in the same way from the others.
    fn horner(&self, polynomial: &Polynomial, moving: &[Symbol]) -> Result<Series, AlgebraError> {
        let known = |(symbol, others): (&Symbol, _)| {
            let series = self.known.get(symbol)?.as_ref()?;
            Some((*symbol, series, others))
        };
        let Some((symbol, image, others)) = moving.split_first().and_then(known) else {
            return Ok(self.constant(Fraction::from(polynomial.clone())));
        };
        self.ring.budget().spend(polynomial.len() as u64)?;
        let mut coefficients = polynomial.coefficients_in(symbol);
        let highest = coefficients.keys().last().copied().unwrap_or(0);
        let mut sum = self.constant(self.ring.zero());
        for exponent in (0..=highest).rev() {
            sum = self.product(&sum, image)?;
            if let Some(coefficient) = coefficients.remove(&exponent) {
                sum = self.sum(&sum, &self.horner(&coefficient, others)?)?;
            }
        }
        Ok(sum)
    }

    /// The series of a symbol that depends on the small quantities, where those of all that it stands
    /// for are known.
    fn symbol(&mut self, symbol: Symbol) -> Result<Series, AlgebraError> {
        if self.small.contains(&symbol) {
            let mut series = self.constant(self.ring.zero());
            if let Some(linear) = series.parts.get_mut(1) {
                *linear = self.ring.element(symbol);
            }
            return Ok(series);
        }
        match self.ring.generator(symbol).clone() {
            Generator::Cosine { angle } => Ok(self.circle(&self.ring.angle_element(&angle))?.0),
            Generator::Sine { angle } => Ok(self.circle(&self.ring.angle_element(&angle))?.1),
            Generator::Root { radicand } => self.root(&radicand),
            Generator::Direction { x, y, .. } => self.direction(&x, &y),
            Generator::FunctionValue {
                name,
                order,
                argument,
            } => self.function(&name, order, &argument),
            _ => Ok(self.constant(self.ring.element(symbol))),
        }
    }

    /// cos A and sin A, from dcos A = −sin A dA and dsin A = cos A dA.
    fn circle(&mut self, angle: &Fraction) -> Result<(Series, Series), AlgebraError> {
        let angle = self.element(angle)?;
        let first = self
            .ring
            .angle(&angle.parts[0])
            .ok_or(AlgebraError::NotAnAngle)?;
        let (cosine, sine) = self.ring.cosine_and_sine(&first)?;
        let (mut cosines, mut sines) = (vec![cosine], vec![sine]);
        let slope = self.euler(&angle)?;
        for degree in 1..slope.parts.len() {
            let cosine = self.convolution(&slope.parts, &sines, degree)?;
            let sine = self.convolution(&slope.parts, &cosines, degree)?;
            cosines.push(self.over(&self.ring.negative(&cosine), degree)?);
            sines.push(self.over(&sine, degree)?);
        }
        Ok((Series { parts: cosines }, Series { parts: sines }))
    }

    /// w with w² = p; where p vanishes with the small quantities, w does, and has no slope.
    fn root(&mut self, radicand: &Polynomial) -> Result<Series, AlgebraError> {
        let under = self.polynomial(radicand)?;
        let mut parts = vec![self.ring.square_root(&under.parts[0])?];
        if parts[0].is_zero() {
            return Ok(Series { parts });
        }
        let twice = self.ring.sum(&parts[0], &parts[0])?;
        for degree in 1..under.parts.len() {
            // The ends of Σ wᵢ wₙ₋ᵢ are what is looked for.
            let known = match degree.checked_sub(2) {
                Some(least) => self.convolution(&parts[1..], &parts[1..], least)?,
                None => self.ring.zero(),
            };
            let rest = self.ring.difference(&under.parts[degree], &known)?;
            parts.push(self.ring.quotient(&rest, &twice)?);
        }
        Ok(Series { parts })
    }

    /// The angle of (x, y), from dβ = (x dy − y dx)/(x² + y²).
    fn direction(&mut self, x: &Fraction, y: &Fraction) -> Result<Series, AlgebraError> {
        let (x, y) = (self.element(x)?, self.element(y)?);
        let mut parts = vec![self.ring.direction(&x.parts[0], &y.parts[0])?];
        let across = self.product(&y, &self.euler(&x)?)?;
        let along = self.product(&x, &self.euler(&y)?)?;
        let turned = self.sum(&along, &self.negative(&across))?;
        let square = self.sum(&self.product(&x, &x)?, &self.product(&y, &y)?)?;
        let slope = self.quotient(&turned, &square)?;
        for (degree, part) in slope.parts.iter().enumerate().skip(1) {
            parts.push(self.over(part, degree)?);
        }
        Ok(Series { parts })
    }

    /// f⁽ⁿ⁾(A) by Taylor's formula about the value of A where the small quantities vanish.
    fn function(
        &mut self,
        name: &str,
        order: u32,
        argument: &Fraction,
    ) -> Result<Series, AlgebraError> {
        let mut change = self.element(argument)?;
        let place = std::mem::replace(&mut change.parts[0], self.ring.zero());
        let mut power = self.constant(self.ring.one());
        let mut sum = self.constant(self.ring.zero());
        let highest = change.parts.len();
        for taken in 0..highest {
            let slope = self
                .ring
                .function_value(name, order + taken as u32, &place)?;
            let term = self.product(&power, &self.constant(slope))?;
            sum = self.sum(&sum, &term)?;
            power = self.product(&power, &change)?;
            for part in &mut power.parts {
                *part = self.over(part, taken + 1)?;
            }
        }
        sum.parts.truncate(highest);
        Ok(sum)
    }

    /// A series that ends behind its first part.
    fn constant(&self, value: Fraction) -> Series {
        let mut parts = vec![self.ring.zero(); self.order + 1];
        parts[0] = value;
        Series { parts }
    }

    fn sum(&self, a: &Series, b: &Series) -> Result<Series, AlgebraError> {
        let pairs = a.parts.iter().zip(&b.parts);
        let parts = pairs
            .map(|(a, b)| self.ring.sum(a, b))
            .collect::<Result<_, _>>()?;
        Ok(Series { parts })
    }

    fn negative(&self, a: &Series) -> Series {
        Series {
            parts: a
                .parts
                .iter()
                .map(|part| self.ring.negative(part))
                .collect(),
        }
    }

    fn product(&self, a: &Series, b: &Series) -> Result<Series, AlgebraError> {
        let last = self.last_of_product(a, b);
        let parts = (0..=last).map(|degree| self.convolution(&a.parts, &b.parts, degree));
        Ok(Series {
            parts: parts.collect::<Result<_, _>>()?,
        })
    }

    /// The degree up to which a product is known: (p + o(qᵐ))·(r + o(qⁿ)) is known up to the least of
    /// the first degree in p and n, of the first degree in r and m, and of m + n.
    fn last_of_product(&self, a: &Series, b: &Series) -> usize {
        let first = |series: &Series| series.parts.iter().position(|part| !part.is_zero());
        let last = |series: &Series| Some(series.parts.len() - 1).filter(|last| *last < self.order);
        let bounds = [
            first(a).zip(last(b)),
            first(b).zip(last(a)),
            last(a).zip(last(b)),
        ];
        let bounds = bounds.into_iter().flatten().map(|(one, other)| one + other);
        bounds.min().unwrap_or(self.order).min(self.order)
    }

    fn quotient(&self, a: &Series, b: &Series) -> Result<Series, AlgebraError> {
        if b.parts[1..].iter().all(Fraction::is_zero) && b.parts.len() > self.order {
            let parts = a
                .parts
                .iter()
                .map(|part| self.ring.quotient(part, &b.parts[0]));
            return Ok(Series {
                parts: parts.collect::<Result<_, _>>()?,
            });
        }
        let first = self.ring.quotient(&self.ring.one(), &b.parts[0])?;
        let slope = self.ring.negative(&first);
        let mut inverse = vec![first];
        for degree in 1..b.parts.len() {
            let known = self.convolution(&b.parts[1..], &inverse, degree - 1)?;
            inverse.push(self.ring.product(&known, &slope)?);
        }
        self.product(a, &Series { parts: inverse })
    }

    /// Σ aᵢ bₙ₋ᵢ over what there is.
    fn convolution(
        &self,
        a: &[Fraction],
        b: &[Fraction],
        degree: usize,
    ) -> Result<Fraction, AlgebraError> {
        let mut sum = self.ring.zero();
        for (place, part) in a.iter().enumerate() {
            let partner = degree.checked_sub(place).and_then(|other| b.get(other));
            let Some(partner) = partner.filter(|other| !part.is_zero() && !other.is_zero()) else {
                continue;
            };
            sum = self.ring.sum(&sum, &self.ring.product(part, partner)?)?;
        }
        Ok(sum)
    }

    /// Each part times its degree: the derivative along the small quantities.
    fn euler(&self, a: &Series) -> Result<Series, AlgebraError> {
        let parts = a.parts.iter().enumerate().map(|(degree, part)| {
            let degree = Fraction::from(Rational::from(degree));
            self.ring.product(part, &degree)
        });
        Ok(Series {
            parts: parts.collect::<Result<_, _>>()?,
        })
    }

    fn over(&self, part: &Fraction, number: usize) -> Result<Fraction, AlgebraError> {
        let number = Fraction::from(Rational::from(Integer::from(number)));
        self.ring.quotient(part, &number)
    }
}
