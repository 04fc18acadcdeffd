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
        self.require_degree_1(difference, unknowns, matching, span)?;
        let over = |numerator: &Polynomial| {
            let fraction = self.ring.fraction(numerator, difference.denominator());
            fraction.map_err(|error| algebra(error, span))
        };
        let numerator = difference.numerator();
        let part = |of: &Polynomial, unknown: &Symbol, power: u32| {
            let mut all = of.coefficients_in(*unknown);
            all.remove(&power).unwrap_or_default()
        };
        let slopes = unknowns
            .iter()
            .map(|unknown| over(&part(numerator, unknown, 1)));
        let row = slopes.collect::<Result<Vec<_>, _>>()?;
        let rest = unknowns
            .iter()
            .fold(numerator.clone(), |rest, unknown| part(&rest, unknown, 0));
        let constant = over(&rest)?;
        self.require_no_unknown(row.iter().chain([&constant]), unknowns, matching, span)?;
        Ok((row, constant.negative()))
    }

    /// Sees that no product of unknowns, and none below a line, is a factor of a term.
    fn require_degree_1(
        &self,
        difference: &Fraction,
        unknowns: &[Symbol],
        matching: &Matching,
        span: &Span,
    ) -> Result<(), Diagnostic> {
        let degree = |monomial: &Monomial| -> u32 {
            let exponents = unknowns.iter().map(|unknown| monomial.exponent(*unknown));
            exponents.sum()
        };
        let mut terms = difference.numerator().terms().iter();
        let label = match terms.find(|(monomial, _)| degree(monomial) > 1) {
            Some(term) => {
                let term = Polynomial::from_terms([term.clone()]);
                let shown = self.presenter().polynomial(&term);
                shown.map_or("contains a product of unknowns".to_string(), |term| {
                    format!("contains the term {}", Notation::Unicode.expression(&term))
                })
            }
            None => {
                let mut below = unknowns.iter();
                if !below.any(|unknown| difference.denominator().contains(*unknown)) {
                    return Ok(());
                }
                "an unknown stands below a line".to_string()
            }
        };
        let names = matching.unknowns.iter();
        let names: Vec<String> = names.map(|unknown| unknown.value.to_string()).collect();
        Err(not_linear(&names.join(", "), span)
            .with_label(label)
            .with_help("use another power, or say what is small enough with `neglect …`"))
    }

    /// Sees that no unknown is left under roots, in angles or in functions.
    fn require_no_unknown<'a>(
        &mut self,
        parts: impl Iterator<Item = &'a Fraction> + Clone,
        unknowns: &[Symbol],
        matching: &Matching,
        span: &Span,
    ) -> Result<(), Diagnostic> {
        for (unknown, spanned) in unknowns.iter().zip(&matching.unknowns) {
            let partial = Differential::partial(*unknown, &self.ring);
            for part in parts.clone() {
                let slope = self.ring.differentiate(part, &partial);
                if !slope.map_err(|error| algebra(error, span))?.is_zero() {
                    return Err(not_linear(&spanned.value.to_string(), span)
                        .with_label("an unknown stands under a root, in an angle or in a function")
                        .with_help(
                            "use another power, or take what stands there, such as the root itself, as the \
                             unknown",
                        ));
                }
            }
        }
        Ok(())
    }
}

fn not_linear(names: &str, span: &Span) -> Diagnostic {
    let message = format!("this coefficient is not linear in {names}");
    Diagnostic::new(DiagnosticKind::NotLinear, span.clone(), message)
}
