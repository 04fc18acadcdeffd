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
    /// a + b
    fn sum(&self, a: &Self::Element, b: &Self::Element) -> Result<Self::Element, Self::Error>;
    /// −a
    fn negative(&self, a: &Self::Element) -> Self::Element;
    /// a·b
    fn product(&self, a: &Self::Element, b: &Self::Element) -> Result<Self::Element, Self::Error>;

    /// a − b
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
    /// a/b; an error where b = 0.
    fn quotient(&self, a: &Self::Element, b: &Self::Element) -> Result<Self::Element, Self::Error>;
}
