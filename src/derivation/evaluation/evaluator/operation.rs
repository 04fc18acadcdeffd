//! Sums, products, quotients, powers and roots at a point.

use crate::algebra::number::{Integer, Rational};
use crate::derivation::evaluation::elimination::solution;
use crate::derivation::evaluation::number::Number;
use crate::derivation::evaluation::sample::Sample;
use crate::derivation::evaluation::table::{
    Table, identity, numbers, only, product, samples, single, zip_with,
};
use crate::derivation::syntax::{BinaryOperator, Expression};

use super::context::Context;
use super::{Evaluator, Failure};

impl<'a> Evaluator<'a> {
    /// The value of two expressions with an operator between them.
    pub(super) fn binary(
        &mut self,
        operator: BinaryOperator,
        left: &'a Expression,
        right: &'a Expression,
        context: Context,
    ) -> Result<Table, Failure> {
        let a = self.table(left, context)?;
        let b = self.table(right, context)?;
        match operator {
            BinaryOperator::Add => Ok(zip_with(&a, &b, Sample::sum)),
            BinaryOperator::Subtract => Ok(zip_with(&a, &b, Sample::difference)),
            BinaryOperator::Multiply => Ok(product(&a, &b, &self.point.extension)),
            BinaryOperator::Divide => {
                let inverse = self.reciprocal(&only(&b)?.number)?;
                Ok(product(&a, &single(inverse), &self.point.extension))
            }
            BinaryOperator::Power => {
                let exponent = only(&b)?.number.as_rational();
                self.power(&a, &exponent.ok_or("an exponent is no number")?)
            }
        }
    }

    fn power(&mut self, base: &Table, exponent: &Rational) -> Result<Table, Failure> {
        if base.len() > 1 {
            let count = i64::try_from(exponent.numerator().clone()).map_err(|_| "too large")?;
            let identity = identity(base.len());
            if count < 0 {
                return self.solve(base, &identity);
            }
            let extension = &self.point.extension;
            return Ok((0..count).fold(identity, |power, _| product(&power, base, extension)));
        }
        let number = only(base)?.number.clone();
        let twice = exponent + exponent;
        let (mut base, mut count) = if exponent.is_int() {
            (number, exponent.numerator().clone())
        } else {
            (self.root(&number)?, twice.numerator().clone())
        };
        if count < Integer::ZERO {
            base = self.reciprocal(&base)?;
            count = -count;
        }
        let count = u64::try_from(count).map_err(|_| "an exponent is too large")?;
        Ok(single(self.point.extension.power(&base, count)))
    }

    /// √a, which is real for a ≥ 0.
    pub(super) fn root(&mut self, square: &Number) -> Result<Number, Failure> {
        if square
            .base()
            .as_rational()
            .is_some_and(|square| square < Rational::ZERO)
        {
            return Err("the root of a negative number".into());
        }
        if self.nilpotents > 0 && square.base().is_zero() {
            return Err("a root of what vanishes with a small quantity".into());
        }
        let root = self.point.extension.square_root(square);
        root.ok_or("a root that exact numbers cannot follow".into())
    }

    /// A⁻¹B.
    pub(super) fn solve(&self, matrix: &Table, right: &Table) -> Result<Table, Failure> {
        let solved = solution(&numbers(matrix), &numbers(right), &self.point.extension);
        solved.map(samples).ok_or("a matrix is singular".into())
    }
}
