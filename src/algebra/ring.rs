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
/// no symbol in common, so folding squares away is a normal form; and a denominator is freed of
/// such symbols by its conjugates. Hence an element has one form, N/D: N at most linear in every
/// sin A, i and w, D free of them, gcd(N, D) = 1 and the leading coefficient of D positive.
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

    /// The normal form of a product.
    fn multiply(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, AlgebraError> {
        self.reduce(&a.multiply(b, &self.budget)?)
    }

    /// The one form of N/D.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] where D is 0, [`AlgebraError::Exhausted`].
    pub fn fraction(
        &self,
        numerator: &Polynomial,
        denominator: &Polynomial,
    ) -> Result<Fraction, AlgebraError> {
        let mut numerator = self.reduce(numerator)?;
        let mut denominator = self.reduce(denominator)?;
        while let Some(symbol) = self.quadratic_symbols(&denominator).first().copied() {
            // D = a + b w; times its conjugate a − b w it is free of w.
            let mut coefficients = denominator.coefficients_in(symbol);
            if let Some(linear) = coefficients.get_mut(&1) {
                *linear = -&*linear;
            }
            let conjugate = Polynomial::from_coefficients_in(symbol, &coefficients)?;
            numerator = self.multiply(&numerator, &conjugate)?;
            denominator = self.multiply(&denominator, &conjugate)?;
        }
        Fraction::new(numerator, denominator, &self.budget)
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
        // The angle of a vector (x, y) of length w has the cosine x/w and the sine y/w.
        let mut free = angle.clone();
        for (symbol, k) in angle.coefficients() {
            if let Generator::Direction { x, y, length } = self.generator(symbol) {
                let pair = (self.quotient(x, length)?, self.quotient(y, length)?);
                result = self.turn(result, &self.multiple(&pair, k)?)?;
                free = free.split_off(symbol).0;
            }
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
                let angle = if negative { free.negative() } else { free };
                let cosine = self.symbol(Generator::Cosine { angle: angle.clone() })?;
                let sine = self.symbol(Generator::Sine { angle: angle.clone() })?;
                self.basis.push(BasisAngle { angle, cosine, sine });
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
        // Reduced numerators over denominators free of roots stay so.
        a.sum(b, &self.budget)
    }

    fn negative(&self, a: &Fraction) -> Fraction {
        a.negative()
    }

    fn product(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        let product = a.product(b, &self.budget)?;
        let squares = self.quadratic_symbols(product.numerator()).into_iter();
        if squares.map(|symbol| product.numerator().degree_in(symbol)).all(|degree| degree < 2) {
            return Ok(product);
        }
        let numerator = self.reduce(product.numerator())?;
        Fraction::new(numerator, product.denominator().clone(), &self.budget)
    }
}

impl Division for Ring {
    fn quotient(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, AlgebraError> {
        let inverse = self.fraction(b.denominator(), b.numerator())?;
        self.product(a, &inverse)
    }
}
