//! Derivatives and expansions by nilpotent numbers: f(x + ε) with ε² = 0.

use std::collections::BTreeSet;

use crate::algebra::number::Rational;
use crate::derivation::evaluation::number::Number;
use crate::derivation::evaluation::point::Key;
use crate::derivation::evaluation::sample::Sample;
use crate::derivation::evaluation::table::{Table, samples};
use crate::derivation::syntax::Expression;

use super::context::{Change, Context};
use super::{Evaluator, Failure};

impl<'a> Evaluator<'a> {
    /// A nilpotent number that nothing else uses.
    fn nilpotent(&mut self) -> Result<Number, Failure> {
        let number = Number::nilpotent(self.nilpotents);
        self.nilpotents += 1;
        number.ok_or("derivatives are nested too deeply".into())
    }

    /// What a change by ε adds to an expression, as the coefficients of ε.
    pub(super) fn differential(
        &mut self,
        expression: &'a Expression,
        change: impl FnOnce(Number) -> Change<'a>,
        context: Context,
    ) -> Result<Vec<Vec<Number>>, Failure> {
        let index = self.nilpotents;
        let step = self.nilpotent()?;
        let inside = self.changed(context, change(step));
        let table = self.table(expression, inside)?;
        self.nilpotents = index;
        let slope = |entry: &Sample| entry.number.coefficient(index..index + 1);
        Ok(table
            .iter()
            .map(|row| row.iter().map(slope).collect())
            .collect())
    }

    /// ∂fᵢ/∂qⱼ: a row for each entry of f, a column for each entry of q.
    pub(super) fn jacobian(
        &mut self,
        value: &'a Expression,
        variables: &'a Expression,
        context: Context,
    ) -> Result<Table, Failure> {
        let mut columns: Vec<Vec<Number>> = Vec::new();
        for key in self.keys(variables, context)? {
            let column = self.differential(value, |step| Change::Shift(key, step), context)?;
            columns.push(column.into_iter().flatten().collect());
        }
        let height = columns.first().map_or(0, Vec::len);
        let row = |row: usize| columns.iter().map(|column| column[row].clone()).collect();
        Ok(samples((0..height).map(row).collect()))
    }

    /// The parts of degree 0, …, `order` in small symbols: with q(ε₁ + … + εₙ) in place of q, the
    /// part of degree k is the coefficient of ε₁…ε_k over k!.
    pub(super) fn expansion(
        &mut self,
        value: &'a Expression,
        small: BTreeSet<Key>,
        order: u32,
        context: Context,
    ) -> Result<Vec<Vec<Vec<Number>>>, Failure> {
        let first = self.nilpotents;
        let mut step = Number::default();
        for _ in 0..order {
            step = step.sum(&self.nilpotent()?);
        }
        let inside = self.changed(context, Change::Scale(small, step));
        let table = self.table(value, inside)?;
        self.nilpotents = first;
        let mut factorial = Rational::ONE;
        let mut parts = Vec::new();
        for degree in 0..=order {
            if degree > 0 {
                factorial /= Rational::from(degree);
            }
            let part = |sample: &Sample| {
                let coefficient = sample.number.coefficient(first..first + degree);
                coefficient.without(first..first + order).scale(&factorial)
            };
            parts.push(
                table
                    .iter()
                    .map(|row| row.iter().map(part).collect())
                    .collect(),
            );
        }
        Ok(parts)
    }
}
