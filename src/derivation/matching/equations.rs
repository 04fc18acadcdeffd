//! The linear equations of a matching, and what is left out of them.

use crate::algebra::arithmetic::{Arithmetic, Division};
use crate::algebra::fraction::Fraction;
use crate::algebra::monomial::Monomial;
use crate::algebra::polynomial::Polynomial;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::elaboration::error::algebra;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Matching, Span};

use super::Coefficients;

/// The linear equations for the unknowns, and what was left out of them.
#[derive(Default)]
pub(super) struct Equations {
    pub(super) rows: Vec<Vec<Fraction>>,
    pub(super) right: Vec<Fraction>,
    /// Its place among what the document neglects, the power, and the factor.
    pub(super) neglected: Vec<(usize, u32, Fraction)>,
}

impl Elaborator {
    /// The coefficients that are used, as equations for the unknowns.
    pub(super) fn equations(
        &mut self,
        matching: &Matching,
        coefficients: &Coefficients,
    ) -> Result<Equations, Diagnostic> {
        let mut equations = Equations::default();
        let mut seen = vec![false; matching.neglected.len()];
        for power in &matching.powers {
            let span = &power.span;
            let wrap = |error| algebra(error, span);
            let (exact, assumed) = coefficients.at(power.value);
            let mut difference = self.ring.difference(&exact, &assumed).map_err(wrap)?;
            for (index, neglected) in matching.neglected.iter().enumerate() {
                let value = self.scalar(neglected)?.value;
                if value.is_zero() {
                    seen[index] = true;
                    continue;
                }
                let part = self.occurrence(&difference, &value, coefficients, &neglected.span)?;
                let Some(part) = part else { continue };
                seen[index] = true;
                difference = self.ring.difference(&difference, &part).map_err(wrap)?;
                let factor = self.ring.quotient(&part, &value).map_err(wrap)?;
                equations.neglected.push((index, power.value, factor));
            }
            let (row, right) =
                self.linear_form(&difference, &coefficients.unknowns, matching, span)?;
            equations.rows.push(row);
            equations.right.push(right);
        }
        match seen.iter().position(|seen| !seen) {
            None => Ok(equations),
            Some(index) => {
                let span = matching.neglected[index].span.clone();
                let message = "what is to be neglected occurs in none of the coefficients used";
                Err(Diagnostic::new(DiagnosticKind::Arguments, span, message)
                    .with_label("not found")
                    .with_help(
                        "leave it out, or check the powers behind `at` and the small quantities",
                    ))
            }
        }
    }

    /// The part of a difference that is a multiple of something to be neglected: its terms with the
    /// same powers of the unknowns and the same degree in the small quantities.
    fn occurrence(
        &mut self,
        difference: &Fraction,
        neglected: &Fraction,
        coefficients: &Coefficients,
        span: &Span,
    ) -> Result<Option<Fraction>, Diagnostic> {
        let Coefficients {
            unknowns, small, ..
        } = coefficients;
        let class = |monomial: &Monomial| {
            let powers: Vec<u32> = unknowns
                .iter()
                .map(|unknown| monomial.exponent(*unknown))
                .collect();
            let degree: u32 = small.iter().map(|small| monomial.exponent(*small)).sum();
            (powers, degree)
        };
        let mut classes = neglected
            .numerator()
            .terms()
            .iter()
            .map(|(monomial, _)| class(monomial));
        let wanted = classes.next();
        if classes.any(|other| Some(other) != wanted) {
            let message = "what is neglected must be of one degree";
            return Err(
                Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                    .with_label(
                        "terms of different degrees in the unknowns or the small quantities",
                    )
                    .with_help("neglect its parts one by one"),
            );
        }
        let terms = difference.numerator().terms().iter();
        let part = terms
            .filter(|(monomial, _)| Some(class(monomial)) == wanted)
            .cloned();
        let part = Polynomial::from_terms(part);
        if part.is_zero() {
            return Ok(None);
        }
        let part = self.ring.fraction(&part, difference.denominator());
        let part = part.map_err(|error| algebra(error, span))?;
        let ratio = self
            .ring
            .quotient(&part, neglected)
            .map_err(|error| algebra(error, span))?;
        let free = unknowns.iter().chain(small).all(|symbol| {
            !ratio.numerator().contains(*symbol) && !ratio.denominator().contains(*symbol)
        });
        // What is neglected must be a factor of what is left out, not only of the same degree.
        let shared = ratio
            .denominator()
            .gcd(neglected.numerator(), self.ring.budget())
            .map_err(|error| algebra(error.into(), span))?;
        Ok((free && shared.as_constant().is_some()).then_some(part))
    }
}
