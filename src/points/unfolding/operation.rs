//! Sums, products, quotients and powers.

use crate::algebra::number::Rational;
use crate::language::syntax::{BinaryOperator, Expression};
use crate::points::table::Table;
use crate::points::{Failure, Unknown};

use super::Unfolding;

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
        let graph = &mut self.sheet.graph;
        match (operator, b.as_single()) {
            (BinaryOperator::Add, _) => a.zipped(&b, |x, y| graph.sum(x, y)),
            (BinaryOperator::Subtract, _) => a.zipped(&b, |x, y| graph.difference(x, y)),
            (BinaryOperator::Multiply, _) => self.sheet.table_product(&a, &b),
            (BinaryOperator::Divide, Some(b)) => a.each(|entry| graph.quotient(entry, b)),
            (BinaryOperator::Power, Some(b)) => {
                let exponent = match graph.as_number(b) {
                    Some(exponent) => exponent.clone(),
                    None => self.constant(b)?,
                };
                self.power(&a, &exponent)
            }
            (BinaryOperator::Divide | BinaryOperator::Power, None) => Err(Unknown::Shape.into()),
        }
    }

    fn power(&mut self, base: &Table, exponent: &Rational) -> Result<Table, Failure> {
        let whole = |number: &Rational| {
            let number = number.is_int().then(|| number.numerator().clone());
            number.and_then(|number| i64::try_from(number).ok())
        };
        if let Some(base) = base.as_single() {
            if let Some(exponent) = whole(exponent) {
                return Ok(Table::single(self.sheet.graph.power(base, exponent)?));
            }
            let halves = whole(&(exponent + exponent)).ok_or(Unknown::Unsupported)?;
            let root = self.sheet.graph.root(base)?;
            return Ok(Table::single(self.sheet.graph.power(root, halves)?));
        }
        let count = whole(exponent).ok_or(Unknown::Unsupported)?;
        let mut power = self.sheet.identity(base.size()?)?;
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
