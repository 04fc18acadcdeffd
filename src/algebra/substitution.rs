//! Substitutions of the free symbols of a ring.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

use super::angle::Angle;
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
    /// Who substitutes in many elements asks one [`Replacing`].
    ///
    /// Complexity: one product at most for each term and each symbol that changes in it; each symbol in
    /// what others stand for is looked at once.
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
        Replacing::by(substitution).image(element, self)
    }
}

/// A substitution at work, which keeps the images of the symbols that it has met for the elements to
/// come.
///
/// ```
/// use sextic::algebra::{
///     arithmetic::Arithmetic, budget::Budget, generator::Generator, ring::Ring,
///     substitution::{Replacing, Substitution},
/// };
///
/// let mut ring = Ring::new(Budget::new(10_000));
/// let [x, y] = ["x", "y"].map(|name| Generator::Constant { name: name.into() });
/// let (x, y) = (ring.symbol(x)?, ring.symbol(y)?);
/// let root = ring.square_root(&ring.sum(&ring.one(), &ring.element(x))?)?;
/// let substitution = Substitution::from([(x, ring.element(y))]);
/// let mut replacing = Replacing::by(&substitution);
/// assert_eq!(replacing.image(&ring.element(x), &mut ring)?, ring.element(y));
/// let image = replacing.image(&root, &mut ring)?;
/// assert_eq!(ring.product(&image, &image)?, ring.sum(&ring.one(), &ring.element(y))?);
/// # Ok::<(), sextic::algebra::error::AlgebraError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Replacing {
    /// The image of each symbol that was met; nothing where it stays.
    known: BTreeMap<Symbol, Option<Fraction>>,
}

impl Replacing {
    /// The substitution, of which nothing was asked yet.
    pub fn by(substitution: &Substitution) -> Self {
        let images = substitution.iter();
        Replacing {
            known: images
                .map(|(symbol, image)| (*symbol, Some(image.clone())))
                .collect(),
        }
    }

    /// The image of an element, as [`Ring::substitute`] gives it.
    ///
    /// # Errors
    ///
    /// Those of [`Ring::substitute`].
    pub fn image(&mut self, element: &Fraction, ring: &mut Ring) -> Result<Fraction, AlgebraError> {
        let symbols = element.symbols();
        if !symbols.iter().all(|symbol| self.known.contains_key(symbol)) {
            self.find(&symbols, ring)?;
        }
        if symbols.iter().all(|symbol| self.stays(symbol)) {
            return Ok(element.clone());
        }
        let numerator = self.image_of_polynomial(element.numerator(), ring)?;
        let denominator = self.image_of_polynomial(element.denominator(), ring)?;
        ring.quotient(&numerator, &denominator)
    }

    /// Finds the images of symbols, after those of all that they stand for.
    fn find(&mut self, symbols: &BTreeSet<Symbol>, ring: &mut Ring) -> Result<(), AlgebraError> {
        let known = |symbol: &Symbol| self.known.contains_key(symbol);
        for symbol in ring.unknown_constituents(symbols.clone(), known) {
            ring.budget().spend(1)?;
            let image = self.image_of_symbol(symbol, ring)?;
            self.known.insert(symbol, image);
        }
        Ok(())
    }

    fn stays(&self, symbol: &Symbol) -> bool {
        matches!(self.known.get(symbol), None | Some(None))
    }

    /// The image of an element; nothing where it stays.
    fn changed(
        &mut self,
        element: &Fraction,
        ring: &mut Ring,
    ) -> Result<Option<Fraction>, AlgebraError> {
        let image = self.image(element, ring)?;
        Ok((image != *element).then_some(image))
    }

    /// The image of a symbol that is not known yet, though all that it stands for are; nothing where it
    /// stays.
    fn image_of_symbol(
        &mut self,
        symbol: Symbol,
        ring: &mut Ring,
    ) -> Result<Option<Fraction>, AlgebraError> {
        if ring.parts_of(symbol).iter().all(|part| self.stays(part)) {
            return Ok(None);
        }
        match ring.generator(symbol).clone() {
            Generator::Constant { .. }
            | Generator::Angle { .. }
            | Generator::Coordinate { .. }
            | Generator::ImaginaryUnit => Ok(None),
            Generator::Cosine { angle } => Ok(self.turned(&angle, ring)?.map(|(cosine, _)| cosine)),
            Generator::Sine { angle } => Ok(self.turned(&angle, ring)?.map(|(_, sine)| sine)),
            Generator::Root { radicand } => {
                let image = self.changed(&radicand.into(), ring)?;
                image.map(|image| ring.square_root(&image)).transpose()
            }
            Generator::Direction { x, y, .. } => {
                let (image_x, image_y) = (self.image(&x, ring)?, self.image(&y, ring)?);
                let changes = image_x != *x || image_y != *y;
                changes
                    .then(|| ring.direction(&image_x, &image_y))
                    .transpose()
            }
            Generator::FunctionValue {
                name,
                order,
                argument,
            } => {
                let image = self.changed(&argument, ring)?;
                image
                    .map(|image| ring.function_value(&name, order, &image))
                    .transpose()
            }
        }
    }

    /// The cosine and sine of the image of an angle; nothing where it stays.
    fn turned(
        &mut self,
        angle: &Angle,
        ring: &mut Ring,
    ) -> Result<Option<(Fraction, Fraction)>, AlgebraError> {
        let Some(image) = self.changed(&ring.angle_element(angle), ring)? else {
            return Ok(None);
        };
        let image = ring.angle(&image).ok_or(AlgebraError::NotAnAngle)?;
        ring.cosine_and_sine(&image).map(Some)
    }

    /// The image of a polynomial in known symbols.
    fn image_of_polynomial(
        &self,
        polynomial: &Polynomial,
        ring: &Ring,
    ) -> Result<Fraction, AlgebraError> {
        let symbols = polynomial.symbols().into_iter();
        let mut images: Vec<(Symbol, &Fraction)> = symbols
            .filter_map(|symbol| Some((symbol, self.known.get(&symbol)?.as_ref()?)))
            .collect();
        // What becomes 0 goes first, and takes its terms with it; long images are multiplied last.
        images.sort_by_key(|(_, image)| {
            let terms = image.numerator().len() + image.denominator().len();
            (!image.is_zero(), Reverse(terms))
        });
        horner(polynomial, &images, ring)
    }
}

/// The value of a polynomial with images in place of some of its symbols, by Horner's rule in the
/// first of them, with coefficients that are found in the same way from the others.
fn horner(
    polynomial: &Polynomial,
    images: &[(Symbol, &Fraction)],
    ring: &Ring,
) -> Result<Fraction, AlgebraError> {
    let Some(((symbol, image), others)) = images.split_first() else {
        return Ok(Fraction::from(polynomial.clone()));
    };
    ring.budget().spend(polynomial.len() as u64)?;
    let coefficients = polynomial.coefficients_in(*symbol);
    if image.is_zero() {
        let constant = coefficients.get(&0);
        return constant.map_or(Ok(ring.zero()), |constant| horner(constant, others, ring));
    }
    let mut value = ring.zero();
    let mut reached = coefficients.keys().last().copied().unwrap_or(0);
    for (exponent, coefficient) in coefficients.iter().rev() {
        let lowered = ring.product(&value, &ring.power(image, i64::from(reached - exponent))?)?;
        value = ring.sum(&lowered, &horner(coefficient, others, ring)?)?;
        reached = *exponent;
    }
    ring.product(&value, &ring.power(image, i64::from(reached))?)
}
