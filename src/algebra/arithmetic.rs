//! What a matrix needs of its entries.

/// A commutative ring, as far as matrices need one: the context in which entries are added and
/// multiplied.
///
/// One determinant serves polynomials, fractions modulo relations and quantities with units,
/// because each is an `Arithmetic`.
pub trait Arithmetic {
    /// The entries.
    type Element: Clone;
    /// Why an operation could not be done.
    type Error;

    /// 0
    fn zero(&self) -> Self::Element;
    /// 1
    fn one(&self) -> Self::Element;
    /// Whether a = 0.
    fn is_zero(&self, a: &Self::Element) -> bool;
    /// Whether a = 0, and a and its multiples change no sum: a 0 with a unit asks of the other summands
    /// that they have it, too.
    fn is_negligible(&self, a: &Self::Element) -> bool {
        self.is_zero(a)
    }
    /// a + b
    ///
    /// # Errors
    ///
    /// Where the sum would cost more than is allowed, or does not exist.
    fn sum(&self, a: &Self::Element, b: &Self::Element) -> Result<Self::Element, Self::Error>;
    /// −a
    fn negative(&self, a: &Self::Element) -> Self::Element;
    /// a·b
    ///
    /// # Errors
    ///
    /// Where the product would cost more than is allowed.
    fn product(&self, a: &Self::Element, b: &Self::Element) -> Result<Self::Element, Self::Error>;

    /// a − b
    ///
    /// # Errors
    ///
    /// Those of [`Arithmetic::sum`].
    fn difference(
        &self,
        a: &Self::Element,
        b: &Self::Element,
    ) -> Result<Self::Element, Self::Error> {
        self.sum(a, &self.negative(b))
    }
}

/// An [`Arithmetic`] in which one can divide by everything but 0.
pub trait Division: Arithmetic {
    /// a/b
    ///
    /// # Errors
    ///
    /// Where b = 0, and those of [`Arithmetic::product`].
    fn quotient(&self, a: &Self::Element, b: &Self::Element) -> Result<Self::Element, Self::Error>;
}
