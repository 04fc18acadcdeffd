//! Complex numbers over any real ones.

use crate::algebra::arithmetic::Arithmetic;

/// The ring of a + bi with a and b of another ring.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gaussian<'a, A>(pub &'a A);

impl<A: Arithmetic> Arithmetic for Gaussian<'_, A> {
    /// a and b.
    type Element = [A::Element; 2];
    type Error = A::Error;

    fn zero(&self) -> Self::Element {
        [self.0.zero(), self.0.zero()]
    }

    fn one(&self) -> Self::Element {
        [self.0.one(), self.0.zero()]
    }

    fn is_zero(&self, own: &Self::Element) -> bool {
        own.iter().all(|part| self.0.is_zero(part))
    }

    fn sum(
        &self,
        [a, b]: &Self::Element,
        [c, d]: &Self::Element,
    ) -> Result<Self::Element, A::Error> {
        Ok([self.0.sum(a, c)?, self.0.sum(b, d)?])
    }

    fn negative(&self, own: &Self::Element) -> Self::Element {
        own.each_ref().map(|part| self.0.negative(part))
    }

    fn product(
        &self,
        [a, b]: &Self::Element,
        [c, d]: &Self::Element,
    ) -> Result<Self::Element, A::Error> {
        let of = |x, y| self.0.product(x, y);
        let real = self.0.difference(&of(a, c)?, &of(b, d)?)?;
        Ok([real, self.0.sum(&of(a, d)?, &of(b, c)?)?])
    }
}
