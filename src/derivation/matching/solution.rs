//! The solution of a matching, and where it is singular.

use crate::algebra::arithmetic::{Arithmetic, Division};
use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::linear_system::{Solution, solve};
use crate::algebra::matrix::Matrix;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::Ring;
use crate::derivation::condition::Conditions;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::elaboration::error::algebra;
use crate::derivation::elaboration::limit::check_minors_of;
use crate::derivation::scope::Meaning;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Expression, Matching, Name, Replacement, Span};

use super::equations::Equations;
use super::{Existence, Singularity};

/// Where the powers stand whose coefficients are used.
fn of_powers(matching: &Matching) -> Span {
    match (matching.powers.first(), matching.powers.last()) {
        (Some(first), Some(last)) => first.span.start..last.span.end,
        _ => matching.name.span.clone(),
    }
}

impl Elaborator {
    /// The solution of as many equations as there are unknowns, checked in the others, and the
    /// determinant.
    pub(super) fn solve_equations(
        &mut self,
        matching: &Matching,
        equations: &Equations,
        count: usize,
    ) -> Result<(Vec<Fraction>, Fraction), Diagnostic> {
        let span = &of_powers(matching);
        if equations.rows.len() < count {
            let given = equations.rows.len();
            let s = if given == 1 { "" } else { "s" };
            let message = format!("{given} equation{s} for {count} unknowns");
            return Err(singular(message, span)
                .with_help("name at least as many powers behind `at` as there are unknowns"));
        }
        let Some(solved) = self.solution_of(equations, count, span)? else {
            let message = "the matching is singular: its determinant is identically 0";
            return Err(singular(message.to_string(), span));
        };
        let quotient = |numerator| self.ring.quotient(numerator, &solved.determinant);
        let solution = solved.numerators.entries().iter().map(quotient);
        let solution: Result<Vec<Fraction>, _> = solution.collect();
        let solution = solution.map_err(|error| algebra(error, span))?;
        self.require_satisfied(matching, equations, &solution)?;
        Ok((solution, solved.determinant))
    }

    /// The solution of the first equations; nothing if their determinant is 0.
    fn solution_of(
        &mut self,
        equations: &Equations,
        count: usize,
        span: &Span,
    ) -> Result<Option<Solution<Fraction>>, Diagnostic> {
        let entry = |row: usize, column: usize| equations.rows[row][column].clone();
        let matrix = Matrix::from_fn(count, count, entry);
        let is_zero = |row: usize, column: usize| equations.rows[row][column].is_zero();
        let few = check_minors_of((count, count), is_zero, count + 1, span).is_ok();
        let right = Matrix::from_fn(count, 1, |row, _| equations.right[row].clone());
        let solved = match few {
            true => solve(&matrix, &right, &self.ring),
            false => self.ring.eliminated_solution(&matrix, &right),
        };
        match solved {
            Err(AlgebraError::DivisionByZero) => Ok(None),
            Err(error) => Err(algebra(error, span)),
            Ok(solved) => Ok(Some(solved).filter(|solved| !solved.determinant.is_zero())),
        }
    }

    /// Sees that the equations beyond the first are satisfied, too.
    fn require_satisfied(
        &self,
        matching: &Matching,
        equations: &Equations,
        solution: &[Fraction],
    ) -> Result<(), Diagnostic> {
        let wrap = |error| algebra(error, &of_powers(matching));
        let all = equations.rows.iter().zip(&equations.right);
        for ((row, right), power) in all.zip(&matching.powers).skip(solution.len()) {
            let mut left = self.ring.zero();
            for (slope, value) in row.iter().zip(solution) {
                let term = self.ring.product(slope, value).map_err(wrap)?;
                left = self.ring.sum(&left, &term).map_err(wrap)?;
            }
            if !self.ring.difference(&left, right).map_err(wrap)?.is_zero() {
                let message = "this coefficient contradicts the ones before it";
                let kind = DiagnosticKind::Inconsistent;
                return Err(Diagnostic::new(kind, power.span.clone(), message)
                    .with_label("not satisfied by the solution of the others")
                    .with_help("use as many powers as there are unknowns"));
            }
        }
        Ok(())
    }

    /// The factors of a determinant that may vanish.
    pub(super) fn singularities(
        &mut self,
        determinant: &Fraction,
        solution: &[Fraction],
        span: &Span,
    ) -> Result<Vec<Singularity>, Diagnostic> {
        let wrap = |error| algebra(error, span);
        let mut factors = Vec::new();
        for (factor, exponent) in self.ring.factored(determinant).map_err(wrap)?.factors {
            let signs = self.ring.polynomial_signs(&factor).map_err(wrap)?;
            if exponent > 0 && !signs.is_non_zero() {
                factors.push(factor);
            }
        }
        let mut found = Vec::new();
        for (place, factor) in factors.iter().enumerate() {
            let others = factors.iter().enumerate().filter(|(at, _)| *at != place);
            let elsewhere: Vec<&Polynomial> = others.map(|(_, other)| other).collect();
            let existence = existence_at(&self.ring, factor, solution, &elsewhere).map_err(wrap)?;
            let factor = self.presenter().polynomial(factor).map_err(wrap)?;
            found.push(Singularity { factor, existence });
        }
        Ok(found)
    }

    /// Declares the solution as a substitution.
    pub(super) fn declare_solution(
        &mut self,
        matching: &Matching,
        solution: &[(Name, Expression)],
        conditions: Conditions,
    ) -> Result<(), Diagnostic> {
        let replacements = solution.iter().map(|(name, value)| Replacement {
            target: Expression::name(name.clone()),
            value: value.clone(),
        });
        let mut sources = vec![matching.exact.clone(), matching.assumed.clone()];
        sources.extend(matching.neglected.iter().cloned());
        let replacements = replacements.collect();
        let meaning = Meaning::Substitution {
            replacements,
            conditions,
            sources,
        };
        self.scope
            .declare(&matching.name, meaning, matching.description.clone())
    }
}

/// What becomes of a solution where a factor is 0, and none of some others is.
fn existence_at(
    ring: &Ring,
    factor: &Polynomial,
    solution: &[Fraction],
    elsewhere: &[&Polynomial],
) -> Result<Existence, AlgebraError> {
    let mut existence = Existence::Stays;
    for value in solution {
        // As it is shown: sin α, not (1 − cos²α)/sin α.
        let value = ring.shortened(value)?;
        if vanishes_with(ring, value.denominator(), factor)? {
            return Ok(Existence::Lost);
        }
        if !has_a_value_off(ring, &value, elsewhere)? || !has_total_symbols(ring, &value)? {
            existence = Existence::Unknown;
        }
    }
    Ok(existence)
}

/// Whether a polynomial is a multiple of a factor in the ring, so that it vanishes wherever that does.
fn vanishes_with(
    ring: &Ring,
    polynomial: &Polynomial,
    factor: &Polynomial,
) -> Result<bool, AlgebraError> {
    if polynomial.as_constant().is_some() {
        return Ok(false);
    }
    let ratio = ring.quotient(&polynomial.clone().into(), &factor.clone().into())?;
    let ratio = ring.canonical(&ratio)?;
    Ok(ratio.denominator().as_constant().is_some())
}

/// Whether an element certainly has a value wherever none of some polynomials is 0.
///
/// The proof is a form of it without a denominator: its product with powers of these polynomials. That
/// the denominator in lowest terms has no factor in common with what vanishes is none, as
/// 1 − cos²α = sin²α and y² − x = (y − √x)·(y + √x) hide theirs.
fn has_a_value_off(
    ring: &Ring,
    value: &Fraction,
    polynomials: &[&Polynomial],
) -> Result<bool, AlgebraError> {
    let mut cleared = value.clone();
    for polynomial in polynomials {
        let polynomial = Fraction::from((*polynomial).clone());
        loop {
            let multiple = ring.product(&cleared, &polynomial)?;
            if total_degree(multiple.denominator()) >= total_degree(cleared.denominator()) {
                break;
            }
            cleared = multiple;
        }
    }
    let below = ring.shorten(cleared.denominator())?;
    for (factor, _) in below.square_free(ring.budget())? {
        if !ring.polynomial_signs(&ring.norm(&factor)?)?.is_non_zero() {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Whether all that an element is made of has a value under every assignment: what stands within its
/// functions, roots and angles is divided by nothing that may be 0, and roots are not those of what may
/// be negative.
fn has_total_symbols(ring: &Ring, value: &Fraction) -> Result<bool, AlgebraError> {
    for symbol in ring.constituents(value) {
        let is_total = match ring.generator(symbol) {
            Generator::Root { radicand } => ring.polynomial_signs(radicand)?.is_non_negative(),
            Generator::FunctionValue { argument, .. } => has_a_value_off(ring, argument, &[])?,
            Generator::Direction { .. } => false,
            _ => true,
        };
        if !is_total {
            return Ok(false);
        }
    }
    Ok(true)
}

fn total_degree(polynomial: &Polynomial) -> u32 {
    let degrees = polynomial
        .terms()
        .iter()
        .map(|(monomial, _)| monomial.degree());
    degrees.max().unwrap_or(0)
}

fn singular(message: String, span: &Span) -> Diagnostic {
    Diagnostic::new(DiagnosticKind::Singular, span.clone(), message)
        .with_label("these equations do not determine the unknowns")
        .with_help("use other powers behind `at`")
}
