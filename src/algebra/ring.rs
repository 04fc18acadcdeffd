//! The ring everything lives in: polynomials modulo quadratic relations, and their fractions.

use super::angle::{Angle, Decomposition, decompose};
use super::arithmetic::{Arithmetic, Division};
use super::budget::Budget;
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::generator::Generator;
use super::monomial::Monomial;
use super::number::{Integer, Rational};
use super::polynomial::Polynomial;
use super::sign::{Assumptions, Signs};
use super::symbol::Symbol;

/// A ring of polynomials in named symbols, modulo sin²A + cos²A = 1, i² = −1 and w² = p, with its
/// field of fractions.
///
/// Each relation gives the square of one symbol in terms of earlier ones. Their leading terms have
/// no symbol in common, so folding squares away is a normal form of polynomials: an element is 0
/// exactly if its numerator folds to 0.
#[derive(Debug)]
pub struct Ring {
    generators: Vec<Generator>,
    assumptions: Assumptions,
    basis: Vec<BasisAngle>,
    budget: Budget,
}

/// An angle whose cosine and sine are symbols.
#[derive(Clone, Debug)]
pub struct BasisAngle {
    /// The angle.
    pub angle: Angle,
    /// Its cosine.
    pub cosine: Symbol,
    /// Its sine.
    pub sine: Symbol,
}

impl Ring {
    /// A ring without symbols, whose computations may take as many steps as the budget has.
    pub fn new(budget: Budget) -> Self {
        Ring { generators: Vec::new(), assumptions: Assumptions::default(), basis: Vec::new(), budget }
    }

    /// The budget that the ring's computations draw from.
    pub fn budget(&self) -> &Budget {
        &self.budget
    }

    /// What is assumed of the symbols.
    pub fn assumptions(&self) -> &Assumptions {
        &self.assumptions
    }

    /// What is assumed of the symbols, to assume more.
    pub fn assumptions_mut(&mut self) -> &mut Assumptions {
        &mut self.assumptions
    }

    /// What a symbol stands for.
    ///
    /// # Panics
    ///
    /// If the symbol is of another ring.
    pub fn generator(&self, symbol: Symbol) -> &Generator {
        &self.generators[symbol.index()]
    }

    /// The angles whose sines and cosines are symbols.
    pub fn basis(&self) -> &[BasisAngle] {
        &self.basis
    }

    /// The symbol that stands for a generator, a new one if there is none yet.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::TooManySymbols`] where the ring is full.
    pub fn symbol(&mut self, generator: Generator) -> Result<Symbol, AlgebraError> {
        if let Some(known) = self.generators.iter().position(|known| *known == generator) {
            return Ok(Symbol::new(known as u16));
        }
        let index = u16::try_from(self.generators.len()).map_err(|_| AlgebraError::TooManySymbols)?;
        let symbol = Symbol::new(index);
        if generator == Generator::ImaginaryUnit {
            self.assumptions.assume_complex(symbol);
        }
        self.generators.push(generator);
        Ok(symbol)
    }

    /// What the square of a symbol is, if a relation gives it.
    fn square_of(&self, symbol: Symbol) -> Option<Polynomial> {
        match self.generator(symbol) {
            Generator::ImaginaryUnit => Some(-&Polynomial::one()),
            Generator::Sine { angle } => {
                let basis = self.basis.iter().find(|basis| basis.angle == *angle)?;
                let cosine_squared =
                    Polynomial::from_terms([(Monomial::power(basis.cosine, 2), Integer::ONE)]);
                Some(&Polynomial::one() - &cosine_squared)
            }
            Generator::Root { radicand } => Some(radicand.clone()),
            _ => None,
        }
    }

    /// The symbols of a polynomial whose squares a relation gives, the last made first.
    fn quadratic_symbols(&self, polynomial: &Polynomial) -> Vec<Symbol> {
        let symbols = polynomial.symbols().into_iter().rev();
        symbols.filter(|symbol| self.generator(*symbol).is_quadratic()).collect()
    }

    /// The normal form of a polynomial: at most linear in every symbol whose square is known.
    ///
    /// Complexity: for each such symbol, one pass over the terms and a product with a power of its
    /// square for each power above the first.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`]
    pub fn reduce(&self, polynomial: &Polynomial) -> Result<Polynomial, AlgebraError> {
        let mut reduced = polynomial.clone();
        loop {
            let symbols = self.quadratic_symbols(&reduced);
            let Some(symbol) = symbols.into_iter().find(|symbol| reduced.degree_in(*symbol) > 1) else {
                return Ok(reduced);
            };
            let Some(square) = self.square_of(symbol) else { return Ok(reduced) };
            // Horner's rule in the square, for the even and the odd powers apart.
            let coefficients = reduced.coefficients_in(symbol);
            let mut parts = [Polynomial::zero(), Polynomial::zero()];
            for exponent in (0..=reduced.degree_in(symbol)).rev() {
                let part = &mut parts[exponent as usize % 2];
                let mut next = part.multiply(&square, &self.budget)?;
                if let Some(coefficient) = coefficients.get(&exponent) {
                    next = &next + coefficient;
                }
                *part = next;
            }
            let [even, odd] = parts;
            reduced = &even + &odd.multiply(&Polynomial::symbol(symbol), &self.budget)?;
        }
    }

    /// N/D with both sides in normal form, in lowest terms, and with no root and no i below the line.
    ///
    /// It is 0 exactly if its numerator is the polynomial 0.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] where D is 0, [`AlgebraError::Exhausted`].
    pub fn fraction(
        &self,
        numerator: &Polynomial,
        denominator: &Polynomial,
    ) -> Result<Fraction, AlgebraError> {
        self.rationalize(numerator, denominator, |generator| {
            matches!(generator, Generator::Root { .. } | Generator::ImaginaryUnit)
        })
    }

    /// The one form that equal elements share: no sine is left below the line either.
    ///
    /// Arithmetic does without it, because freeing a denominator of sines can make it very long.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`]
    pub fn canonical(&self, element: &Fraction) -> Result<Fraction, AlgebraError> {
        self.rationalize(element.numerator(), element.denominator(), Generator::is_quadratic)
    }

    /// N/D, freed of unwanted symbols w below the line: D = a + b w times its conjugate a − b w is
    /// free of w.
    fn rationalize(
        &self,
        numerator: &Polynomial,
        denominator: &Polynomial,
        unwanted: impl Fn(&Generator) -> bool,
    ) -> Result<Fraction, AlgebraError> {
        let mut numerator = self.reduce(numerator)?;
        let mut denominator = self.reduce(denominator)?;
        loop {
            let symbols = self.quadratic_symbols(&denominator).into_iter();
            let Some(symbol) = symbols.into_iter().find(|symbol| unwanted(self.generator(*symbol)))
            else {
                return Fraction::new(numerator, denominator, &self.budget);
            };
            let mut coefficients = denominator.coefficients_in(symbol);
            if let Some(linear) = coefficients.get_mut(&1) {
                *linear = -&*linear;
            }
            let conjugate = Polynomial::from_coefficients_in(symbol, &coefficients)?;
            numerator = self.reduce(&numerator.multiply(&conjugate, &self.budget)?)?;
            denominator = self.reduce(&denominator.multiply(&conjugate, &self.budget)?)?;
        }
    }

    /// A result of the arithmetic of fractions with its squares folded away.
    fn fold(&self, element: Fraction) -> Result<Fraction, AlgebraError> {
        let folded = |side: &Polynomial| {
            self.quadratic_symbols(side).into_iter().all(|symbol| side.degree_in(symbol) < 2)
        };
        if folded(element.numerator()) && folded(element.denominator()) {
            return Ok(element);
        }
        self.fraction(element.numerator(), element.denominator())
    }

    /// aⁿ, for negative n as well.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] for a negative power of 0, [`AlgebraError::Exhausted`].
    pub fn power(&self, base: &Fraction, exponent: i64) -> Result<Fraction, AlgebraError> {
        if exponent < 0 {
            let inverse = self.quotient(&self.one(), base)?;
            return self.power(&inverse, exponent.saturating_neg());
        }
        let (mut result, mut square, mut rest) = (self.one(), base.clone(), exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                result = self.product(&result, &square)?;
            }
            rest /= 2;
            if rest > 0 {
                square = self.product(&square, &square)?;
            }
        }
        Ok(result)
    }

    /// The symbol as an element.
    pub fn element(&self, symbol: Symbol) -> Fraction {
        Fraction::from(Polynomial::symbol(symbol))
    }

    /// The symbol that the element is, if it is one.
    pub fn as_symbol(&self, element: &Fraction) -> Option<Symbol> {
        let [(monomial, coefficient)] = element.numerator().terms() else { return None };
        let (symbol, _) = monomial.factors().next().filter(|_| monomial.degree() == 1)?;
        (*coefficient == Integer::ONE && element.denominator().is_one()).then_some(symbol)
    }

    /// The element as an angle, where it is a sum of angular symbols with integer coefficients.
    pub fn angle(&self, element: &Fraction) -> Option<Angle> {
        if element.denominator().as_constant()? != Integer::ONE {
            return None;
        }
        let terms = element.numerator().terms().iter();
        let coefficients: Option<Vec<(Symbol, Integer)>> = terms
            .map(|(monomial, coefficient)| {
                let (symbol, _) = monomial.factors().next().filter(|_| monomial.degree() == 1)?;
                self.generator(symbol).is_angular().then(|| (symbol, coefficient.clone()))
            })
            .collect();
        Some(Angle::new(coefficients?))
    }

    /// The angle as an element.
    pub fn angle_element(&self, angle: &Angle) -> Fraction {
        let terms = angle.coefficients().map(|(symbol, k)| (Monomial::power(symbol, 1), k.clone()));
        Fraction::from(Polynomial::from_terms(terms))
    }

    /// (cos A, sin A), by the addition formulas from the basis; an angle that is independent of the
    /// basis joins it.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::FractionalAngle`] where A is a fraction of what the basis holds,
    /// [`AlgebraError::Exhausted`], [`AlgebraError::TooManySymbols`].
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
                let negative = free.is_negative();
                self.basis_angle(if negative { free.negative() } else { free })?;
                let mut multiples = vec![Integer::ZERO; known.len()];
                multiples.push(if negative { -Integer::ONE } else { Integer::ONE });
                multiples
            }
        };
        for (basis, k) in self.basis.iter().zip(&multiples) {
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
        let cosine = self.symbol(Generator::Cosine { angle: angle.clone() })?;
        let sine = self.symbol(Generator::Sine { angle: angle.clone() })?;
        self.basis.push(BasisAngle { angle, cosine, sine });
        self.basis.last().cloned().ok_or(AlgebraError::TooManySymbols)
    }

    /// (cos(A + B), sin(A + B)).
    fn turn(
        &self,
        (cos_a, sin_a): (Fraction, Fraction),
        (cos_b, sin_b): &(Fraction, Fraction),
    ) -> Result<(Fraction, Fraction), AlgebraError> {
        let cosine = self.difference(&self.product(&cos_a, cos_b)?, &self.product(&sin_a, sin_b)?)?;
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
        let sine = if count < 0 { self.negative(sine) } else { sine.clone() };
        let step = (cosine.clone(), sine);
        let mut result = (self.one(), self.zero());
        for _ in 0..count.unsigned_abs() {
            self.budget.spend(1)?;
            result = self.turn(result, &step)?;
        }
        Ok(result)
    }

    /// The angle of the vector (x, y): one of the basis where it is parallel to it, else a symbol of
    /// its own.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] for the vector (0, 0), and those of
    /// [`Ring::square_root`].
    pub fn direction(&mut self, x: &Fraction, y: &Fraction) -> Result<Fraction, AlgebraError> {
        for index in 0..self.basis.len() {
            let BasisAngle { angle, cosine, sine } = self.basis[index].clone();
            let (cosine, sine) = (self.element(cosine), self.element(sine));
            let across = self.difference(&self.product(x, &sine)?, &self.product(y, &cosine)?)?;
            let along = self.sum(&self.product(x, &cosine)?, &self.product(y, &sine)?)?;
            if across.is_zero() && self.signs(&along)?.is_positive() {
                return Ok(self.angle_element(&angle));
            }
        }
        if y.is_zero() && self.signs(x)?.is_positive() {
            return Ok(self.zero());
        }
        let length = self.length(x, y)?;
        let (x, y) = (x.clone(), y.clone());
        let symbol = self.symbol(Generator::Direction { x, y, length })?;
        Ok(self.element(symbol))
    }

    /// √(x² + y²).
    fn length(&mut self, x: &Fraction, y: &Fraction) -> Result<Fraction, AlgebraError> {
        let square = self.sum(&self.product(x, x)?, &self.product(y, y)?)?;
        if square.is_zero() {
            return Err(AlgebraError::DivisionByZero);
        }
        self.square_root(&square)
    }

    /// f⁽ᵏ⁾(A), a symbol of its own.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::TooManySymbols`]
    pub fn function_value(
        &mut self,
        name: &str,
        order: u32,
        argument: &Fraction,
    ) -> Result<Fraction, AlgebraError> {
        let argument = argument.clone();
        let symbol = self.symbol(Generator::FunctionValue { name: name.into(), order, argument })?;
        Ok(self.element(symbol))
    }

    /// The signs an element can have under the assumptions.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`]
    pub fn signs(&self, element: &Fraction) -> Result<Signs, AlgebraError> {
        let numerator = self.polynomial_signs(element.numerator())?;
        Ok(numerator.product(self.polynomial_signs(element.denominator())?))
    }
}

impl Arithmetic for Ring {
    type Element = Fraction;
    type Error = AlgebraError;

    fn zero(&self) -> Fraction {
        Fraction::from(Rational::ZERO)
    }

    fn one(&self) -> Fraction {
        Fraction::from(Rational::ONE)
    }

    fn is_zero(&self, a: &Fraction) -> bool {
        a.is_zero()
    }

    fn sum(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        self.fold(a.sum(b, &self.budget)?)
    }

    fn negative(&self, a: &Fraction) -> Fraction {
        a.negative()
    }

    fn product(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        self.fold(a.product(b, &self.budget)?)
    }
}

impl Division for Ring {
    fn quotient(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        let inverse = self.fraction(b.denominator(), b.numerator())?;
        self.product(a, &inverse)
    }
}
