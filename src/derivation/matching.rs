//! Matching two polynomials coefficient by coefficient.

mod equations;
mod linear_form;
mod residual;
mod solution;

use std::collections::BTreeMap;

use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::number::Rational;
use crate::algebra::substitution::Substitution;
use crate::algebra::symbol::Symbol;

use super::elaboration::Elaborator;
use super::elaboration::error::{algebra, different, units};
use super::foundation::Foundation;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Expression, Label, Matching, Name, Spanned};

/// What a matching found.
#[derive(Clone, Debug)]
pub struct Matched {
    /// How the document calls it.
    pub label: Label,
    /// How its solution is called as a substitution.
    pub name: Name,
    /// In words.
    pub description: Option<String>,
    /// The line on which it stands, counted from 1.
    pub line: usize,
    /// The polynomial that is known, and the form it is assumed to have.
    pub polynomials: (Expression, Expression),
    /// The definitions that both rest on, each before those that use it.
    pub definitions: Vec<(Expression, Expression)>,
    /// The variable whose powers are compared.
    pub variable: Name,
    /// What was solved for, and the solution in lowest terms.
    pub solution: Vec<(Name, Expression)>,
    /// The powers whose coefficients were used.
    pub powers: Vec<u32>,
    /// The determinant of the linear system.
    pub determinant: Expression,
    /// Where the system is singular, and whether the solution stays finite there.
    pub singular_where: Vec<Singularity>,
    /// What was left out of the coefficients that were used.
    pub neglected: Vec<Neglected>,
    /// The quantities by whose degree the residuals are ordered.
    pub small: Vec<Name>,
    /// Every power of the variable, the highest first.
    pub table: Vec<Row>,
}

/// Where a linear system is singular.
#[derive(Clone, Debug, PartialEq)]
pub struct Singularity {
    /// The system is singular where this is 0.
    pub factor: Expression,
    /// Whether the solution exists there, as long as no other of the factors is 0.
    pub existence: Existence,
}

impl Singularity {
    /// Whether the solution certainly stays finite.
    pub fn is_finite(&self) -> bool {
        self.existence == Existence::Stays
    }
}

/// Whether a solution exists where the determinant of its equations vanishes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Existence {
    /// It has a value there, for certain.
    Stays,
    /// It has a denominator that is 0 there, as it is shown.
    Lost,
    /// Neither was shown.
    Unknown,
}

/// Something left out of a coefficient.
#[derive(Clone, Debug, PartialEq)]
pub struct Neglected {
    /// What the document names.
    pub expression: Expression,
    /// The power in whose coefficient it stands.
    pub power: u32,
    /// By what it is multiplied there (exact − assumed).
    pub factor: Expression,
}

/// The coefficients of one power.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The power.
    pub power: u32,
    /// The coefficient of the known polynomial.
    pub exact: Expression,
    /// The coefficient of the assumed form, in the unknowns.
    pub assumed: Expression,
    /// exact − assumed with the solution put in.
    pub residual: Expression,
    /// The degree in the small quantities at which the residual begins; nothing for a residual 0.
    pub order: Option<u32>,
    /// Whether it was used to solve for the unknowns.
    pub used: bool,
}

/// The coefficients of both polynomials by power, and the symbols in them that the document names.
struct Coefficients {
    exact: BTreeMap<u32, Fraction>,
    assumed: BTreeMap<u32, Fraction>,
    unknowns: Vec<Symbol>,
    small: Vec<Symbol>,
}

impl Coefficients {
    /// The highest power of either polynomial.
    fn degree(&self) -> u32 {
        let powers = self.exact.keys().chain(self.assumed.keys());
        powers.max().copied().unwrap_or(0)
    }

    /// Both coefficients of a power.
    fn at(&self, power: u32) -> (Fraction, Fraction) {
        let of = |side: &BTreeMap<u32, Fraction>| {
            side.get(&power)
                .cloned()
                .unwrap_or(Fraction::from(Rational::ZERO))
        };
        (of(&self.exact), of(&self.assumed))
    }
}

impl Elaborator {
    /// Carries out a matching and declares its solution as a substitution.
    ///
    /// The difference of the two polynomials is taken power by power; in the powers that are used,
    /// what is to be neglected is taken out, the rest must be linear in the unknowns and is solved
    /// exactly; then every power's residual is formed with the solution put in.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where an expression is no polynomial, the equations are not linear, or they
    /// are singular or contradict each other.
    pub fn match_coefficients(
        &mut self,
        matching: &Matching,
        line: usize,
    ) -> Result<Matched, Diagnostic> {
        let coefficients = self.coefficients_to_match(matching)?;
        let Coefficients { unknowns, .. } = &coefficients;
        let equations = self.equations(matching, &coefficients)?;
        let (values, determinant) = self.solve_equations(matching, &equations, unknowns.len())?;
        let substitution: Substitution = unknowns.iter().copied().zip(values.clone()).collect();
        self.require_admitted(matching, &substitution)?;
        let table = self.residuals(matching, &coefficients, &substitution)?;

        let mut conditions = std::mem::take(&mut self.conditions);
        let span = &matching.name.span;
        let singular_where = self.singularities(&determinant, &values, span)?;
        conditions
            .divide(&determinant, &self.ring)
            .map_err(|error| algebra(error, span))?;

        let mut solution = Vec::new();
        for (unknown, value) in matching.unknowns.iter().zip(&values) {
            solution.push((unknown.value.clone(), self.present(value, span)?));
        }
        let mut neglected = Vec::new();
        for (index, power, factor) in &equations.neglected {
            neglected.push(Neglected {
                expression: matching.neglected[*index].clone(),
                power: *power,
                factor: self.present(factor, span)?,
            });
        }
        let small = matching.small.iter().map(|small| small.value.clone());
        let matched = Matched {
            label: matching.label.clone(),
            name: matching.name.value.clone(),
            description: matching.description.clone(),
            line,
            polynomials: (matching.exact.clone(), matching.assumed.clone()),
            definitions: Foundation::of(&self.scope, [&matching.exact, &matching.assumed]),
            variable: matching.variable.value.clone(),
            solution,
            powers: matching.powers.iter().map(|power| power.value).collect(),
            determinant: self.present(&determinant, span)?,
            singular_where,
            neglected,
            small: small.collect(),
            table,
        };
        self.declare_solution(matching, &matched.solution, conditions)?;
        Ok(matched)
    }

    /// Sees that the solution is one that the unknowns may have: of a declared sign, and real where they
    /// are. The polynomials were read with both.
    fn require_admitted(
        &mut self,
        matching: &Matching,
        solution: &Substitution,
    ) -> Result<(), Diagnostic> {
        for (unknown, value) in solution {
            if !self.ring.assumptions().is_complex(*unknown) && !self.ring.is_real(value) {
                return Err(algebra(AlgebraError::NotReal, &matching.name.span)
                    .with_label("the solution is not real")
                    .with_help("declare the unknown with `complex`"));
            }
        }
        self.respect_assumptions(solution, |signs| signs, &matching.name.span)
    }

    /// The coefficients of both polynomials, which must have equal units.
    fn coefficients_to_match(&mut self, matching: &Matching) -> Result<Coefficients, Diagnostic> {
        let power = |power: &Spanned<u32>| {
            let written = match power.value {
                0 => "1".to_string(),
                1 => matching.variable.value.to_string(),
                value => format!("{}^{value}", matching.variable.value),
            };
            (written, power.span.clone())
        };
        different(&matching.powers.iter().map(power).collect::<Vec<_>>())?;
        let variable = self.variable(&matching.variable)?;
        let unknowns = self.variables(&matching.unknowns)?;
        if let Some(place) = unknowns.iter().position(|unknown| *unknown == variable) {
            let message = "the variable of the polynomials cannot be one of the unknowns";
            let span = matching.unknowns[place].span.clone();
            return Err(Diagnostic::new(DiagnosticKind::Arguments, span, message)
                .with_label("the variable")
                .with_help("the unknowns are what the coefficients are solved for"));
        }
        let small = self.variables(&matching.small)?;
        let exact = self.scalar(&matching.exact)?;
        let assumed = self.scalar(&matching.assumed)?;
        if let (Some(a), Some(b)) = (&exact.unit, &assumed.unit)
            && a != b
        {
            return Err(units(a, b, &matching.assumed.span)
                .with_secondary(matching.exact.span.clone(), a.to_string()));
        }
        Ok(Coefficients {
            exact: self.coefficients_of(&exact.value, variable, &matching.exact.span)?,
            assumed: self.coefficients_of(&assumed.value, variable, &matching.assumed.span)?,
            unknowns,
            small,
        })
    }
}
