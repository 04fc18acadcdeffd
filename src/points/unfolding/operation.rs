//! Sums, products, quotients and powers.

use crate::algebra::number::Rational;
use crate::derivation::syntax::{BinaryOperator, Expression};
use crate::points::matrix::{Table, is_single};
use crate::points::{Failure, Unknown};

use super::{Unfolding, single};

/// The largest power of a matrix.
const LARGEST_POWER: i64 = 64;

impl<'a> Unfolding<'a> {
    /// Two expressions with an operator between them.
    pub(super) fn binary(
        &mut self,
        operator: BinaryOperator,
        left: &'a Expression,
        right: &'a Expression,
    ) -> Result<Table, Failure> {
        let (a, b) = (self.table(left)?, self.table(right)?);
        match operator {
            BinaryOperator::Add | BinaryOperator::Subtract => self.added(operator, &a, &b),
            BinaryOperator::Multiply => self.sheet.table_product(&a, &b),
            BinaryOperator::Divide if is_single(&b) => self
                .sheet
                .each(&a, |sheet, entry| sheet.graph.quotient(entry, b[0][0])),
            BinaryOperator::Power if is_single(&b) => {
                let exponent = match self.sheet.graph.as_number(b[0][0]) {
                    Some(exponent) => exponent.clone(),
                    None => self.constant(b[0][0])?,
                };
                self.power(&a, &exponent)
            }
            BinaryOperator::Divide | BinaryOperator::Power => Err(Unknown::Unsupported.into()),
        }
    }

    fn added(&mut self, operator: BinaryOperator, a: &Table, b: &Table) -> Result<Table, Failure> {
        let mut rows = Table::new();
        for (left, right) in a.iter().zip(b) {
            let mut row = Vec::new();
            for (x, y) in left.iter().zip(right) {
                row.push(match operator {
                    BinaryOperator::Add => self.sheet.graph.sum(*x, *y)?,
                    _ => self.sheet.graph.difference(*x, *y)?,
                });
            }
            rows.push(row);
        }
        Ok(rows)
    }

    fn power(&mut self, base: &Table, exponent: &Rational) -> Result<Table, Failure> {
        let whole = |number: &Rational| {
            let number = number.is_int().then(|| number.numerator().clone());
            number.and_then(|number| i64::try_from(number).ok())
        };
        if is_single(base) {
            let base = base[0][0];
            if let Some(exponent) = whole(exponent) {
                return Ok(single(self.sheet.graph.power(base, exponent)?));
            }
            let halves = whole(&(exponent + exponent)).ok_or(Unknown::Unsupported)?;
            let root = self.sheet.graph.root(base)?;
            return Ok(single(self.sheet.graph.power(root, halves)?));
        }
        let count = whole(exponent).ok_or(Unknown::Unsupported)?;
        let mut power = self.sheet.identity(base.len())?;
        match count {
            -1 => return self.sheet.solve(base, &power),
            0 => return self.sheet.of_whole(&power, base),
            1..=LARGEST_POWER => {}
            _ => return Err(Unknown::Unsupported.into()),
        }
        for _ in 0..count {
            power = self.sheet.table_product(&power, base)?;
        }
        Ok(power)
    }
}
