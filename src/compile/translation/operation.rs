//! Sums, products, quotients and powers.

use sextic_codegen::program::Operation;

use crate::algebra::number::Rational;
use crate::language::syntax::{BinaryOperator, Expression};

use super::{Context, Obstacle, Polynomial, Table, Translator, divisor, scalar};

impl Translator<'_> {
    /// The value of an operation.
    pub(super) fn binary(
        &mut self,
        operator: BinaryOperator,
        left: &Expression,
        right: &Expression,
        context: Context,
    ) -> Result<Table, Obstacle> {
        if operator == BinaryOperator::Power {
            return self.power(left, right, context);
        }
        let a = self.table(left, context)?;
        let b = self.table(right, context)?;
        match operator {
            BinaryOperator::Add => self.zip(&a, &b, Polynomial::sum),
            BinaryOperator::Subtract => self.zip(&a, &b, Polynomial::difference),
            BinaryOperator::Multiply => self.product(&a, &b),
            BinaryOperator::Divide | BinaryOperator::Power => {
                let [b] = b.entries() else {
                    return Err(Obstacle::Structure);
                };
                let divisor = divisor(b)?;
                Ok(self.each(&a, |entry, program| entry.quotient(divisor, program)))
            }
        }
    }

    fn power(
        &mut self,
        base: &Expression,
        exponent: &Expression,
        context: Context,
    ) -> Result<Table, Obstacle> {
        let exponent = self.passed(exponent, context.frame);
        let exponent = self.elaborator.scalar(&exponent);
        let exponent = exponent.map_err(|error| Obstacle::Refused(error.message))?;
        let exponent = exponent.value.as_constant();
        let whole = exponent.filter(Rational::is_int);
        let count = whole.and_then(|whole| i32::try_from(whole.numerator().clone()).ok());
        let Some(count) = count.filter(|count| count.abs() <= 64) else {
            return Err(Obstacle::Structure);
        };
        let base = self.single(base, context)?;
        let one = self.program.constant(1.into());
        let mut power = Polynomial::monomial(0, one);
        for _ in 0..count.unsigned_abs() {
            power = power.product(&base, &mut self.program);
        }
        if count >= 0 {
            return Ok(scalar(power));
        }
        let divisor = divisor(&power)?;
        let inverse = self.program.push(Operation::Divide(one, divisor));
        Ok(scalar(Polynomial::monomial(0, inverse)))
    }
}
