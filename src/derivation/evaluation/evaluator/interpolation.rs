//! The coefficients of polynomials by interpolation.

use crate::algebra::number::Rational;
use crate::derivation::evaluation::number::Number;
use crate::derivation::evaluation::point::Key;
use crate::derivation::syntax::Expression;

use super::context::{Change, Context};
use super::{Evaluator, Failure};

/// The most nodes a polynomial is sampled at to find its coefficients.
const MOST_NODES: i64 = 40;

/// How many further nodes must confirm them.
const CONFIRMATIONS: usize = 3;

impl<'a> Evaluator<'a> {
    /// The coefficients of a polynomial from its values at a, a + h, a + 2h, …, h = ±1, by Newton's divided
    /// differences, until some more values change nothing.
    pub(super) fn interpolation(
        &mut self,
        polynomial: &'a Expression,
        key: &Key,
        context: Context,
    ) -> Result<Vec<Number>, Failure> {
        let mut differences: Vec<Number> = Vec::new();
        let mut newton: Vec<Number> = Vec::new();
        // The nodes begin where no document's polynomial is likely to have its zeros, and have the sign
        // that the variable has at the point.
        let first = self.point.first_node();
        let value = self.point.value(key).as_rational();
        let sign = if value.is_some_and(|value| value < Rational::ZERO) {
            -1
        } else {
            1
        };
        for node in 0..MOST_NODES {
            let place = Number::from(sign * (first + node));
            let inside = self.changed(context, Change::Set(key.clone(), place));
            // f[xₙ₋ⱼ, …, xₙ] = (f[xₙ₋ⱼ₊₁, …, xₙ] − f[xₙ₋ⱼ, …, xₙ₋₁])/(j h)
            let mut current = vec![self.number(polynomial, inside)?];
            for (j, previous) in (1..).zip(&differences) {
                let change = current[j - 1].difference(previous);
                current.push(change.scale(&(Rational::ONE / Rational::from(sign * j as i64))));
            }
            newton.extend(current.last().cloned());
            differences = current;
            let last = newton.iter().rev().take(CONFIRMATIONS);
            if newton.len() > CONFIRMATIONS && last.clone().all(Number::is_zero) {
                return Ok(expand_newton(&newton, sign * first, sign));
            }
        }
        Err("it is no polynomial of a degree below 37".into())
    }
}

/// Σ cₖ (λ − a)(λ − a − h)…(λ − a − (k − 1)h) by powers of λ, by Horner's rule.
fn expand_newton(newton: &[Number], first: i64, step: i64) -> Vec<Number> {
    let mut coefficients: Vec<Number> = Vec::new();
    for (index, leading) in newton.iter().enumerate().rev() {
        let node = index as i64 * step + first;
        // p ← p·(λ − node) + c
        let mut next = vec![Number::default(); coefficients.len() + 1];
        for (power, coefficient) in coefficients.iter().enumerate() {
            next[power + 1] = next[power + 1].sum(coefficient);
            next[power] = next[power].difference(&coefficient.scale(&Rational::from(node)));
        }
        next[0] = next[0].sum(leading);
        coefficients = next;
    }
    while coefficients.len() > 1 && coefficients.last().is_some_and(Number::is_zero) {
        coefficients.pop();
    }
    coefficients
}

/// The leading principal minor of Hurwitz' matrix (a₁, a₃, …; a₀, a₂, …; 0, a₁, …) of
/// a₀λⁿ + a₁λⁿ⁻¹ + … + aₙ, from the coefficients, the lowest first.
pub(super) fn hurwitz(coefficients: &[Number], size: usize) -> Vec<Vec<Number>> {
    let degree = coefficients.len() - 1;
    let entry = |row: usize, column: usize| {
        let index = (2 * column + 2)
            .checked_sub(row + 1)
            .filter(|index| *index <= degree);
        index
            .map(|index| coefficients[degree - index].clone())
            .unwrap_or_default()
    };
    (0..size)
        .map(|row| (0..size).map(|column| entry(row, column)).collect())
        .collect()
}
