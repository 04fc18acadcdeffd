//! What a matrix needs of its entries.

use std::borrow::Borrow;

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

    /// Σ ±a·b, where each product is asked for when those before it were added.
    ///
    /// # Errors
    ///
    /// The first of the products, and those of the sums.
    fn sum_of_products<L: Borrow<Self::Element>, R: Borrow<Self::Element>>(
        &self,
        products: impl Iterator<Item = Result<SignedProduct<L, R>, Self::Error>>,
    ) -> Result<Self::Element, Self::Error> {
        one_by_one(self, products)
    }
}

/// a·b or −a·b, as a part of a sum: not yet computed, since a sum that knows all its products can be
/// found at once.
#[derive(Clone, Copy, Debug)]
pub struct SignedProduct<L, R> {
    /// Whether it is −a·b.
    pub is_negative: bool,
    /// a
    pub left: L,
    /// b
    pub right: R,
}

impl<L, R> SignedProduct<L, R> {
    /// The product of what the factors refer to.
    pub fn borrowed<E>(&self) -> SignedProduct<&E, &E>
    where
        L: Borrow<E>,
        R: Borrow<E>,
    {
        SignedProduct {
            is_negative: self.is_negative,
            left: self.left.borrow(),
            right: self.right.borrow(),
        }
    }
}

/// Σ ±a·b by a product and a sum at a time.
pub(super) fn one_by_one<A: Arithmetic + ?Sized, L: Borrow<A::Element>, R: Borrow<A::Element>>(
    arithmetic: &A,
    products: impl Iterator<Item = Result<SignedProduct<L, R>, A::Error>>,
) -> Result<A::Element, A::Error> {
    let mut sum = arithmetic.zero();
    for product in products {
        let product = product?;
        let term = arithmetic.product(product.left.borrow(), product.right.borrow())?;
        sum = match product.is_negative {
            true => arithmetic.difference(&sum, &term)?,
            false => arithmetic.sum(&sum, &term)?,
        };
    }
    Ok(sum)
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
