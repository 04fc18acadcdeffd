//! Values with units.

use std::borrow::Borrow;

use crate::algebra::arithmetic::{Arithmetic, Division, SignedProduct};
use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::matrix::Matrix;
use crate::algebra::number::Rational;
use crate::algebra::ring::Ring;

use crate::language::unit::Unit;

/// An element of the ring and its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// The element.
    pub value: Fraction,
    /// Its unit; none for the number 0 as it is written and for products with it, which fit every unit.
    pub unit: Option<Unit>,
}

/// A value of a document; a scalar is a matrix with one row and one column.
pub type Value = Matrix<Quantity>;

impl Quantity {
    /// A quantity with a unit.
    pub fn new(value: Fraction, unit: Unit) -> Self {
        Quantity {
            value,
            unit: Some(unit),
        }
    }

    /// A pure number; 0 fits every unit.
    pub fn number(number: Rational) -> Self {
        let unit = (!number.is_zero()).then(Unit::one);
        Quantity {
            value: Fraction::from(number),
            unit,
        }
    }

    /// Whether the quantity is a 0 without a unit.
    pub fn fits_every_unit(&self) -> bool {
        self.unit.is_none() && self.value.is_zero()
    }

    /// The quantity as a value.
    pub fn scalar(self) -> Value {
        Matrix::from_fn(1, 1, |_, _| self.clone())
    }
}

/// The unit that two quantities share, if they do.
pub fn common_unit(a: &Option<Unit>, b: &Option<Unit>) -> Result<Option<Unit>, QuantityError> {
    match (a, b) {
        (Some(a), Some(b)) if a != b => Err(QuantityError::Units(a.clone(), b.clone())),
        (Some(unit), _) | (None, Some(unit)) => Ok(Some(unit.clone())),
        (None, None) => Ok(None),
    }
}

/// The unit of a product, which has none where a factor is the number 0.
fn unit_of_product(a: &Quantity, b: &Quantity) -> Option<Unit> {
    let units = a.unit.as_ref().zip(b.unit.as_ref());
    units.map(|(a, b)| a.product(b))
}

/// Why two quantities could not be combined.
#[derive(Clone, Debug)]
pub enum QuantityError {
    /// The algebra could not.
    Algebra(AlgebraError),
    /// Quantities of these units were added.
    Units(Unit, Unit),
}

impl From<AlgebraError> for QuantityError {
    fn from(error: AlgebraError) -> Self {
        QuantityError::Algebra(error)
    }
}

/// The arithmetic of quantities over a ring: values as in the ring, sums only of equal units.
#[derive(Clone, Copy)]
pub struct Quantities<'a>(pub &'a Ring);

impl Quantities<'_> {
    /// Takes steps for going over the terms of an element and keeping them, which costs more than
    /// the products that they came from.
    fn pay_for(&self, element: &Fraction) -> Result<(), AlgebraError> {
        const STEPS_FOR_A_TERM: u64 = 20;
        let terms = element.numerator().len() + element.denominator().len();
        Ok(self.0.budget().spend(STEPS_FOR_A_TERM * terms as u64)?)
    }
}

impl Arithmetic for Quantities<'_> {
    type Element = Quantity;
    type Error = QuantityError;

    fn zero(&self) -> Quantity {
        Quantity::number(Rational::ZERO)
    }

    fn one(&self) -> Quantity {
        Quantity::number(Rational::ONE)
    }

    fn is_zero(&self, a: &Quantity) -> bool {
        a.value.is_zero()
    }

    fn is_negligible(&self, a: &Quantity) -> bool {
        a.fits_every_unit()
    }

    fn sum(&self, a: &Quantity, b: &Quantity) -> Result<Quantity, QuantityError> {
        let unit = common_unit(&a.unit, &b.unit)?;
        self.pay_for(&a.value)?;
        self.pay_for(&b.value)?;
        Ok(Quantity {
            value: self.0.sum(&a.value, &b.value)?,
            unit,
        })
    }

    fn negative(&self, a: &Quantity) -> Quantity {
        Quantity {
            value: a.value.negative(),
            unit: a.unit.clone(),
        }
    }

    fn product(&self, a: &Quantity, b: &Quantity) -> Result<Quantity, QuantityError> {
        let value = self.0.product(&a.value, &b.value)?;
        self.pay_for(&value)?;
        let unit = unit_of_product(a, b);
        Ok(Quantity { value, unit })
    }

    /// The values at once, if their units agree.
    fn sum_of_products<L: Borrow<Quantity>, R: Borrow<Quantity>>(
        &self,
        products: impl Iterator<Item = Result<SignedProduct<L, R>, QuantityError>>,
    ) -> Result<Quantity, QuantityError> {
        let products = products.collect::<Result<Vec<_>, _>>()?;
        let products = products.iter().map(SignedProduct::borrowed::<Quantity>);
        let unit = products.clone().try_fold(None, |unit, product| {
            common_unit(&unit, &unit_of_product(product.left, product.right))
        })?;
        let values = products.map(|product| SignedProduct {
            is_negative: product.is_negative,
            left: &product.left.value,
            right: &product.right.value,
        });
        let value = self.0.sum_of_products(values.map(Ok))?;
        self.pay_for(&value)?;
        Ok(Quantity { value, unit })
    }
}

impl Division for Quantities<'_> {
    fn quotient(&self, a: &Quantity, b: &Quantity) -> Result<Quantity, QuantityError> {
        let unit = a
            .unit
            .as_ref()
            .zip(b.unit.as_ref())
            .map(|(a, b)| a.product(&b.inverse()));
        Ok(Quantity {
            value: self.0.quotient(&a.value, &b.value)?,
            unit,
        })
    }
}
