//! Coefficients as linear forms in the unknowns.

use crate::algebra::differential::Differential;
use crate::algebra::fraction::Fraction;
use crate::algebra::monomial::Monomial;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::symbol::Symbol;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::elaboration::error::algebra;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::notation::Notation;
use crate::language::syntax::{Matching, Span};

impl Elaborator {
    /// (a, −a₀) of a₀ + Σ aⱼ bⱼ.
    pub(super) fn linear_form(
        &mut self,
        difference: &Fraction,
        unknowns: &[Symbol],
        matching: &Matching,
        span: &Span,
    ) -> Result<(Vec<Fraction>, Fraction), Diagnostic> {
        let degree = |monomial: &Monomial| -> u32 {
            unknowns
                .iter()
                .map(|unknown| monomial.exponent(*unknown))
                .sum()
        };
        let numerator = difference.numerator();
        let nonlinear = numerator
            .terms()
            .iter()
            .find(|(monomial, _)| degree(monomial) > 1);
        let below = unknowns
            .iter()
            .any(|unknown| difference.denominator().contains(*unknown));
        if nonlinear.is_some() || below {
            let term = nonlinear.map(|(monomial, coefficient)| {
                Polynomial::from_terms([(monomial.clone(), coefficient.clone())])
            });
            let presenter = self.presenter();
            let shown = term.and_then(|term| presenter.polynomial(&term).ok());
            let shown = shown.map(|term| Notation::Unicode.expression(&term));
            let label = shown.map_or("an unknown stands below a line".into(), |term| {
                format!("contains the term {term}")
            });
            let names: Vec<String> = matching
                .unknowns
                .iter()
                .map(|unknown| unknown.value.to_string())
                .collect();
            let message = format!("this coefficient is not linear in {}", names.join(", "));
            return Err(
                Diagnostic::new(DiagnosticKind::NotLinear, span.clone(), message)
                    .with_label(label)
                    .with_help("use another power, or say what is small enough with `neglect …`"),
            );
        }
        let wrap = |error| algebra(error, span);
        let mut row = Vec::new();
        let mut rest = numerator.clone();
        for unknown in unknowns {
            let slope = numerator
                .coefficients_in(*unknown)
                .remove(&1)
                .unwrap_or_default();
            rest = rest
                .coefficients_in(*unknown)
                .remove(&0)
                .unwrap_or_default();
            row.push(
                self.ring
                    .fraction(&slope, difference.denominator())
                    .map_err(wrap)?,
            );
        }
        let constant = self
            .ring
            .fraction(&rest, difference.denominator())
            .map_err(wrap)?;
        // What is left may still contain unknowns under roots, in angles or in functions.
        for (unknown, spanned) in unknowns.iter().zip(&matching.unknowns) {
            let partial = Differential::partial(*unknown, &self.ring);
            for part in row.iter().chain([&constant]) {
                if !self
                    .ring
                    .differentiate(part, &partial)
                    .map_err(wrap)?
                    .is_zero()
                {
                    let message = format!("this coefficient is not linear in {}", spanned.value);
                    return Err(
                        Diagnostic::new(DiagnosticKind::NotLinear, span.clone(), message)
                            .with_label(
                                "an unknown stands under a root, in an angle or in a function",
                            )
                            .with_help(
                                "use another power, or take what stands there, such as the root \
                                 itself, as the unknown",
                            ),
                    );
                }
            }
        }
        Ok((row, constant.negative()))
    }
}
