//! Square roots of elements.

use dashu_base::{SquareRoot, UnsignedAbs};

use super::arithmetic::{Arithmetic, Division};
use super::error::AlgebraError;
use super::fraction::Fraction;
use super::generator::Generator;
use super::number::Integer;
use super::polynomial::Polynomial;
use super::ring::Ring;
use super::sign::Signs;

impl Ring {
    /// √a ≥ 0 of a real element, right wherever a ≥ 0.
    ///
    /// √(N/D) = √(N·D)/|D|. Of N·D, squares of factors whose sign is known are taken out, and fourth
    /// powers of the others; every other factor p of known sign becomes a symbol w with w² = p, so that
    /// √a·√b is √(a·b), and what has no known sign becomes one such symbol together. The sign of a
    /// single such factor follows from a ≥ 0. Where the sign of a factor U of D does not, √(N·D·U²) is
    /// taken in place of √(N·D)·|U|.
    ///
    /// Complexity: one square-free factorisation of N·D and of D, and what it takes to find the signs of
    /// their factors.
    ///
    /// # Errors
    ///
    /// [`AlgebraError::NotReal`] where a is not real; [`AlgebraError::NegativeRadicand`] where a is negative; [`AlgebraError::UnknownSign`] where it may
    /// not be positive, or is a square, but of a factor whose sign is not known;
    /// [`AlgebraError::TooManySymbols`] where the ring is full; [`AlgebraError::Exhausted`] where the
    /// budget or a polynomial's size runs out.
    ///
    /// ```
    /// use sextic::algebra::{
    ///     arithmetic::{Arithmetic, Division}, budget::Budget, fraction::Fraction, number::Rational,
    ///     ring::Ring,
    /// };
    ///
    /// let mut ring = Ring::new(Budget::new(10_000));
    /// let number = |n: i32| Fraction::from(Rational::from(n));
    /// // √8 = 2 √2
    /// let (root, half) = (ring.square_root(&number(8))?, ring.square_root(&number(2))?);
    /// assert_eq!(root, ring.product(&number(2), &half)?);
    /// # Ok::<(), sextic::algebra::error::AlgebraError>(())
    /// ```
    pub fn square_root(&mut self, element: &Fraction) -> Result<Fraction, AlgebraError> {
        if element.is_zero() {
            return Ok(self.zero());
        }
        self.real(element)?;
        let signs = self.signs(element)?;
        if !signs.positive {
            return Err(match signs.zero {
                true => AlgebraError::UnknownSign,
                false => AlgebraError::NegativeRadicand,
            });
        }
        let below = element.denominator();
        let product = element.numerator().multiply(below, self.budget())?;
        let product = self.reduce(&product)?;
        let (mut under, divisor) = (self.by_signs(&product)?, self.by_signs(below)?);
        let (mut below, mut negative) = (below.clone(), divisor.negative);
        let open: Vec<&Polynomial> = divisor.odd().collect();
        if open.len() == 1 && under.odd().eq(open.iter().copied()) {
            negative ^= under.negative;
        } else if !open.is_empty() {
            let mut completed = product;
            for factor in open {
                below = below.multiply(factor, self.budget())?;
                completed = completed.multiply(&factor.power(2, self.budget())?, self.budget())?;
            }
            under = self.by_signs(&self.reduce(&completed)?)?;
        }
        let root = self.root_of_factors(under)?;
        let root = self.quotient(&root, &Fraction::from(below))?;
        Ok(match negative {
            true => self.negative(&root),
            false => root,
        })
    }

    /// The factors of a polynomial by what is known of their signs.
    fn by_signs(&self, polynomial: &Polynomial) -> Result<SignedFactors, AlgebraError> {
        let shortened = self.shorten(polynomial)?;
        let mut factors = SignedFactors {
            negative: shortened.signed_content() < Integer::ZERO,
            content: shortened.content(),
            known: Vec::new(),
            open: Vec::new(),
        };
        for (factor, multiplicity) in shortened.square_free(self.budget())? {
            let signs = self.polynomial_signs(&factor)?;
            if signs.is_non_negative() {
                factors.known.push((factor, multiplicity));
            } else if !signs.positive {
                factors.negative ^= multiplicity % 2 == 1;
                factors.known.push((-&factor, multiplicity));
            } else {
                factors.open.push((factor, multiplicity));
            }
        }
        Ok(factors)
    }

    /// The root of a product that is not below 0.
    fn root_of_factors(&mut self, under: SignedFactors) -> Result<Fraction, AlgebraError> {
        let (outside, mut single) = integer_square_part(&under.content);
        let alone = under.odd().count() == 1;
        let (mut root, mut mixed) = (Polynomial::constant(outside), Polynomial::one());
        for (factor, multiplicity) in under.known {
            let outside = factor.power(multiplicity / 2, self.budget())?;
            root = root.multiply(&outside, self.budget())?;
            if multiplicity % 2 == 1 {
                single.push(self.reduce(&factor)?);
            }
        }
        let mut negative = under.negative;
        for (factor, multiplicity) in under.open {
            // The only odd one has the sign of all others together.
            let determined = alone && multiplicity % 2 == 1;
            let kept = multiplicity % if determined { 2 } else { 4 };
            let factor = match determined && std::mem::take(&mut negative) {
                true => -&factor,
                false => factor,
            };
            let outside = factor.power((multiplicity - kept) / 2, self.budget())?;
            root = root.multiply(&outside, self.budget())?;
            mixed = mixed.multiply(&factor.power(kept, self.budget())?, self.budget())?;
        }
        if negative {
            mixed = -&mixed;
        }
        if !mixed.is_one() {
            let mixed = self.reduce(&mixed)?;
            if mixed.as_constant().is_some() || mixed.square_root(self.budget())?.is_some() {
                return Err(AlgebraError::UnknownSign);
            }
            // What has no known sign keeps one root together.
            single.push(mixed);
        }
        let root = Fraction::from(self.reduce(&root)?);
        single.into_iter().try_fold(root, |product, radicand| {
            let symbol = self.root_symbol(radicand)?;
            self.product(&product, &symbol)
        })
    }

    /// w ≥ 0 with w² = p.
    fn root_symbol(&mut self, radicand: Polynomial) -> Result<Fraction, AlgebraError> {
        let signs = match self.polynomial_signs(&radicand)?.is_positive() {
            true => Signs::POSITIVE,
            false => Signs::NON_NEGATIVE,
        };
        let symbol = self.symbol(Generator::Root { radicand })?;
        self.assumptions_mut().assume_symbol(symbol, signs);
        Ok(self.element(symbol))
    }
}

/// A polynomial ±c·Π fᵢ^mᵢ with whole c > 0.
struct SignedFactors {
    /// Whether the product of all but the open factors is not above 0.
    negative: bool,
    /// c
    content: Integer,
    /// The factors that are not below 0.
    known: Vec<(Polynomial, u32)>,
    /// The factors of unknown sign.
    open: Vec<(Polynomial, u32)>,
}

impl SignedFactors {
    /// The factors whose signs decide that of the product.
    fn odd(&self) -> impl Iterator<Item = &Polynomial> {
        let odd = self
            .open
            .iter()
            .filter(|(_, multiplicity)| multiplicity % 2 == 1);
        odd.map(|(factor, _)| factor)
    }
}

/// √n of a square.
fn exact_square_root(n: &Integer) -> Option<Integer> {
    let root = Integer::from(n.unsigned_abs().sqrt());
    (&root * &root == *n).then_some(root)
}

/// (a, [b, c, …]) with n = a²·b·c·… for n > 0, where b, c, … are the primes that trial division finds
/// once, and the rest.
fn integer_square_part(n: &Integer) -> (Integer, Vec<Polynomial>) {
    const LARGEST_DIVISOR: u32 = 1000;
    let (mut root, mut single, mut rest) = (Integer::ONE, Vec::new(), n.clone());
    for divisor in (2..=LARGEST_DIVISOR).map(Integer::from) {
        let square = &divisor * &divisor;
        if square > rest {
            // What is left is 1 or a prime.
            break;
        }
        while (&rest % &square).is_zero() {
            rest /= &square;
            root *= &divisor;
        }
        if (&rest % &divisor).is_zero() {
            rest /= &divisor;
            single.push(Polynomial::constant(divisor));
        }
    }
    match exact_square_root(&rest) {
        Some(exact) => root *= exact,
        None => single.push(Polynomial::constant(rest)),
    }
    (root, single)
}
