//! The ring everything lives in: polynomials modulo quadratic relations, and their fractions.

use super::angle::Angle;
use super::budget::Budget;
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::generator::Generator;
use super::monomial::Monomial;
use super::number::Integer;
use super::polynomial::Polynomial;
use super::sign::Assumptions;
use super::symbol::Symbol;

/// A ring of polynomials in named symbols, modulo sin²A + cos²A = 1, i² = −1 and w² = p, with its
/// field of fractions.
///
/// Each relation gives the square of one symbol in terms of earlier ones. Their leading terms have
/// no symbol in common, so folding squares away is a normal form of polynomials: an element is 0
/// exactly if its numerator folds to 0.
///
/// Elements are [`Fraction`]s made by this ring; those of another one mean something else here.
///
/// ```
/// use sextic::algebra::{
///     arithmetic::Arithmetic, budget::Budget, generator::Generator, ring::Ring,
/// };
///
/// let mut ring = Ring::new(Budget::new(10_000));
/// let i = ring.symbol(Generator::ImaginaryUnit)?;
/// let i = ring.element(i);
/// assert_eq!(ring.product(&i, &i)?, ring.negative(&ring.one()));
/// # Ok::<(), sextic::algebra::error::AlgebraError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Ring {
    generators: Vec<Generator>,
    assumptions: Assumptions,
    pub(super) basis: Vec<BasisAngle>,
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
        Ring {
            generators: Vec::new(),
            assumptions: Assumptions::default(),
            basis: Vec::new(),
            budget,
        }
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
    /// Complexity: one comparison with each symbol of the ring.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::TooManySymbols`] where the ring is full.
    pub fn symbol(&mut self, generator: Generator) -> Result<Symbol, AlgebraError> {
        if let Some(known) = self.generators.iter().position(|known| *known == generator) {
            return Ok(Symbol::new(known as u16));
        }
        let index =
            u16::try_from(self.generators.len()).map_err(|_| AlgebraError::TooManySymbols)?;
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

    /// Whether a polynomial is at most linear in every symbol whose square is known.
    pub(super) fn is_reduced(&self, polynomial: &Polynomial) -> bool {
        let mut factors = polynomial
            .terms()
            .iter()
            .flat_map(|(monomial, _)| monomial.factors());
        factors.all(|(symbol, exponent)| exponent < 2 || !self.generator(symbol).is_quadratic())
    }

    /// The last made of the symbols of at least the given degree in a polynomial whose generators are
    /// such as wanted.
    pub(super) fn last_symbol(
        &self,
        polynomial: &Polynomial,
        least: u32,
        wanted: impl Fn(&Generator) -> bool,
    ) -> Option<Symbol> {
        let terms = polynomial.terms().iter();
        let symbols = terms
            .flat_map(|(monomial, _)| monomial.factors())
            .filter(|(_, exponent)| *exponent >= least)
            .map(|(symbol, _)| symbol);
        symbols
            .filter(|symbol| wanted(self.generator(*symbol)))
            .max()
    }

    /// The normal form of a polynomial: at most linear in every symbol whose square is known.
    ///
    /// Complexity: for each such symbol, one pass over the terms and a product with a power of its
    /// square for each power above the first.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] where the budget or a polynomial's size runs out.
    ///
    /// # Panics
    ///
    /// If a symbol is of another ring.
    pub fn reduce(&self, polynomial: &Polynomial) -> Result<Polynomial, AlgebraError> {
        let mut reduced = polynomial.clone();
        while let Some(symbol) = self.last_symbol(&reduced, 2, Generator::is_quadratic) {
            let Some(square) = self.square_of(symbol) else {
                break;
            };
            // Horner's rule in the square: an even power and the odd one above it at a time.
            let degree = reduced.degree_in(symbol);
            let (below, above) = reduced.split_at(symbol, degree - degree % 2);
            let lowered = above.over_monomial(&Monomial::power(symbol, 2));
            reduced = &below + &lowered.multiply(&square, &self.budget)?;
        }
        Ok(reduced)
    }

    /// N/D with both sides in normal form, in lowest terms, and with no root and no i below the line.
    ///
    /// It is 0 exactly if its numerator is the polynomial 0.
    ///
    /// Complexity: for each root and i in D, two products with a conjugate as long as D; then one
    /// gcd of N and D.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::DivisionByZero`] where D folds to 0, [`AlgebraError::Exhausted`] where the
    /// budget or a polynomial's size runs out.
    ///
    /// ```
    /// use sextic::algebra::polynomial::Polynomial;
    /// # use sextic::algebra::{budget::Budget, generator::Generator, ring::Ring};
    ///
    /// # let mut ring = Ring::new(Budget::new(10_000));
    /// let i = Polynomial::symbol(ring.symbol(Generator::ImaginaryUnit)?);
    /// let inverse = ring.fraction(&Polynomial::one(), &i)?;
    /// assert_eq!(inverse, (-&i).into());
    /// # Ok::<(), sextic::algebra::error::AlgebraError>(())
    /// ```
    pub fn fraction(
        &self,
        numerator: &Polynomial,
        denominator: &Polynomial,
    ) -> Result<Fraction, AlgebraError> {
        self.rationalize(numerator, denominator, Generator::is_irrational)
    }

    /// The one form that equal elements share: no sine is left below the line either.
    ///
    /// Over the cosines and the free symbols, the products of the other symbols are a basis of the
    /// field, and the form is the one numerator over the least common denominator. Arithmetic does
    /// without it, because freeing a denominator of sines can make it very long.
    ///
    /// Complexity: that of [`Ring::fraction`]; each sine in the denominator doubles the denominator's
    /// degree.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] where the budget or a polynomial's size runs out.
    ///
    /// ```
    /// # use sextic::algebra::{
    /// #     arithmetic::{Arithmetic, Division}, budget::Budget, generator::Generator, ring::Ring,
    /// # };
    /// # let mut ring = Ring::new(Budget::new(10_000));
    /// let alpha = ring.symbol(Generator::Angle { name: "α".into() })?;
    /// let angle = ring.angle(&ring.element(alpha)).expect("α is an angle");
    /// let (cosine, sine) = ring.cosine_and_sine(&angle)?;
    /// // 1/sin α and sin α/(1 − cos²α)
    /// let inverse = ring.quotient(&ring.one(), &sine)?;
    /// let square = ring.difference(&ring.one(), &ring.product(&cosine, &cosine)?)?;
    /// assert_eq!(ring.canonical(&inverse)?, ring.canonical(&ring.quotient(&sine, &square)?)?);
    /// # Ok::<(), sextic::algebra::error::AlgebraError>(())
    /// ```
    pub fn canonical(&self, element: &Fraction) -> Result<Fraction, AlgebraError> {
        self.rationalize(
            element.numerator(),
            element.denominator(),
            Generator::is_quadratic,
        )
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
        while let Some(symbol) = self.last_symbol(&denominator, 1, &unwanted) {
            let mut coefficients = denominator.coefficients_in(symbol);
            if let Some(linear) = coefficients.get_mut(&1) {
                *linear = -&*linear;
            }
            let conjugate = Polynomial::from_coefficients_in(symbol, &coefficients)?;
            numerator = self.reduce(&numerator.multiply(&conjugate, &self.budget)?)?;
            denominator = self.reduce(&denominator.multiply(&conjugate, &self.budget)?)?;
        }
        Fraction::new(numerator, denominator, &self.budget)
    }

    /// Whether a polynomial is real under every assignment: a normal form without i and without
    /// complex symbols.
    ///
    /// Complexity: one pass over its terms.
    pub fn is_real_polynomial(&self, polynomial: &Polynomial) -> bool {
        let mut symbols = polynomial.symbols().into_iter();
        symbols.all(|symbol| !self.assumptions.is_complex(symbol))
    }

    /// Whether an element is real under every assignment.
    ///
    /// Complexity: one pass over its terms.
    pub fn is_real(&self, element: &Fraction) -> bool {
        let sides = [element.numerator(), element.denominator()];
        sides.into_iter().all(|side| self.is_real_polynomial(side))
    }

    /// The element, if it is real.
    pub(super) fn real<'e>(&self, element: &'e Fraction) -> Result<&'e Fraction, AlgebraError> {
        match self.is_real(element) {
            true => Ok(element),
            false => Err(AlgebraError::NotReal),
        }
    }

    /// p² + q² of a polynomial p + q i with real p and q, which is 0 exactly where the polynomial is;
    /// the polynomial itself where it does not contain i, or where p or q is not real.
    ///
    /// Complexity: two products.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::Exhausted`] where the budget or a polynomial's size runs out.
    pub fn norm(&self, polynomial: &Polynomial) -> Result<Polynomial, AlgebraError> {
        let imaginary = |generator: &Generator| *generator == Generator::ImaginaryUnit;
        let Some(symbol) = self.last_symbol(polynomial, 1, imaginary) else {
            return Ok(polynomial.clone());
        };
        let parts = polynomial.coefficients_in(symbol);
        if !parts.values().all(|part| self.is_real_polynomial(part)) {
            return Ok(polynomial.clone());
        }
        let mut sum = Polynomial::zero();
        for part in parts.values() {
            sum = &sum + &part.multiply(part, &self.budget)?;
        }
        self.reduce(&sum)
    }

    /// What stands under the root that a polynomial is, if it is one.
    pub fn radicand(&self, polynomial: &Polynomial) -> Option<&Polynomial> {
        match self.generator(self.as_symbol(&Fraction::from(polynomial.clone()))?) {
            Generator::Root { radicand } => Some(radicand),
            _ => None,
        }
    }

    /// The symbol as an element.
    pub fn element(&self, symbol: Symbol) -> Fraction {
        Fraction::from(Polynomial::symbol(symbol))
    }

    /// The symbol that the element is, if it is one.
    pub fn as_symbol(&self, element: &Fraction) -> Option<Symbol> {
        let [(monomial, coefficient)] = element.numerator().terms() else {
            return None;
        };
        let (symbol, _) = monomial
            .factors()
            .next()
            .filter(|_| monomial.degree() == 1)?;
        (*coefficient == Integer::ONE && element.denominator().is_one()).then_some(symbol)
    }

    /// f⁽ᵏ⁾(A) of a function f known only by its name, with k the `order` and A the `argument`: a
    /// symbol of its own, the same one for equal arguments.
    ///
    /// Complexity: that of [`Ring::canonical`] for A.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::NotReal`] where A is not real, [`AlgebraError::TooManySymbols`] where the ring is
    /// full, [`AlgebraError::Exhausted`] where the budget runs out.
    pub fn function_value(
        &mut self,
        name: &str,
        order: u32,
        argument: &Fraction,
    ) -> Result<Fraction, AlgebraError> {
        let argument = self.canonical(argument)?;
        self.real(&argument)?;
        let symbol = self.symbol(Generator::FunctionValue {
            name: name.into(),
            order,
            argument,
        })?;
        Ok(self.element(symbol))
    }
}
