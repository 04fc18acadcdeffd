//! Matching two polynomials coefficient by coefficient.

use std::collections::BTreeMap;

use crate::algebra::arithmetic::{Arithmetic, Division};
use crate::algebra::differential::Differential;
use crate::algebra::fraction::Fraction;
use crate::algebra::linear_system::solve;
use crate::algebra::matrix::Matrix;
use crate::algebra::monomial::Monomial;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::substitution::Substitution;
use crate::algebra::symbol::Symbol;

use super::condition::Conditions;
use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::elaboration::Elaborator;
use super::elaboration::error::{algebra, units};
use super::foundation::Foundation;
use super::presentation::Presenter;
use super::scope::Meaning;
use super::syntax::{Expression, Label, Matching, Name, Replacement, Span, Spanned};

/// How far beyond the linear terms the order of a residual is looked for.
const HIGHEST_ORDER: u32 = 6;

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
    /// Whether no denominator of the solution vanishes there.
    pub finite: bool,
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

/// The linear equations for the unknowns, and what was left out of them.
struct Equations {
    rows: Vec<Vec<Fraction>>,
    right: Vec<Fraction>,
    neglected: Vec<(usize, u32, Fraction)>,
}

/// Requires that nothing is named twice.
fn different(things: Vec<(String, Span)>) -> Result<(), Diagnostic> {
    for (place, (thing, span)) in things.iter().enumerate() {
        if let Some((_, earlier)) = things[..place].iter().find(|(known, _)| known == thing) {
            let message = format!("`{thing}` is named twice");
            return Err(
                Diagnostic::new(DiagnosticKind::Duplicate, span.clone(), message)
                    .with_label("the same again")
                    .with_secondary(earlier.clone(), "the first one")
                    .with_help("name it once"),
            );
        }
    }
    Ok(())
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
        let names = |names: &[Spanned<Name>]| {
            names
                .iter()
                .map(|name| (name.value.to_string(), name.span.clone()))
                .collect()
        };
        different(names(&matching.unknowns))?;
        different(names(&matching.small))?;
        let power = |power: &Spanned<u32>| (format!("power {}", power.value), power.span.clone());
        different(matching.powers.iter().map(power).collect())?;
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
        let exact = self.coefficients_of(&exact.value, variable, &matching.exact.span)?;
        let assumed = self.coefficients_of(&assumed.value, variable, &matching.assumed.span)?;

        let equations = self.equations(matching, &exact, &assumed, &unknowns, &small)?;
        let (solution, determinant) = self.solve_equations(matching, &equations, unknowns.len())?;
        let substitution: Substitution = unknowns.iter().copied().zip(solution.clone()).collect();

        let mut table = Vec::new();
        let highest = exact
            .keys()
            .chain(assumed.keys())
            .max()
            .copied()
            .unwrap_or(0);
        for power in (0..=highest).rev() {
            let of = |side: &BTreeMap<u32, Fraction>| side.get(&power).cloned();
            let exact = of(&exact).unwrap_or(self.ring.zero());
            let assumed = of(&assumed).unwrap_or(self.ring.zero());
            let used = matching.powers.iter().any(|used| used.value == power);
            table.push(self.row(
                power,
                &exact,
                &assumed,
                &substitution,
                &small,
                used,
                matching,
            )?);
        }
        let mut conditions = std::mem::take(&mut self.conditions);
        let span = &matching.name.span;
        conditions
            .require_non_zero(&determinant, &self.ring)
            .map_err(|error| algebra(error, span))?;
        let singular_where = self.singularities(&determinant, &solution, span)?;

        let present = |element: &Fraction| {
            Presenter {
                ring: &self.ring,
                scope: &self.scope,
            }
            .element(element)
            .map_err(|error| algebra(error, span))
        };
        let names = matching
            .unknowns
            .iter()
            .map(|unknown| unknown.value.clone());
        let values: Result<Vec<Expression>, Diagnostic> = solution.iter().map(present).collect();
        let solution: Vec<(Name, Expression)> = names.zip(values?).collect();
        let neglected: Result<Vec<Neglected>, Diagnostic> = equations
            .neglected
            .iter()
            .map(|(index, power, factor)| {
                Ok(Neglected {
                    expression: matching.neglected[*index].clone(),
                    power: *power,
                    factor: present(factor)?,
                })
            })
            .collect();
        let polynomials = [&matching.exact, &matching.assumed];
        let definitions = Foundation::of(&self.scope, polynomials);
        let matched = Matched {
            definitions,
            label: matching.label.clone(),
            name: matching.name.value.clone(),
            description: matching.description.clone(),
            line,
            polynomials: (matching.exact.clone(), matching.assumed.clone()),
            variable: matching.variable.value.clone(),
            powers: matching.powers.iter().map(|power| power.value).collect(),
            determinant: present(&determinant)?,
            singular_where,
            neglected: neglected?,
            small: matching
                .small
                .iter()
                .map(|small| small.value.clone())
                .collect(),
            table,
            solution,
        };
        self.declare_solution(matching, &matched.solution, conditions)?;
        Ok(matched)
    }

    fn declare_solution(
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

    fn equations(
        &mut self,
        matching: &Matching,
        exact: &BTreeMap<u32, Fraction>,
        assumed: &BTreeMap<u32, Fraction>,
        unknowns: &[Symbol],
        small: &[Symbol],
    ) -> Result<Equations, Diagnostic> {
        let mut equations = Equations {
            rows: Vec::new(),
            right: Vec::new(),
            neglected: Vec::new(),
        };
        let mut seen = vec![false; matching.neglected.len()];
        for power in &matching.powers {
            let span = &power.span;
            let wrap = |error| algebra(error, span);
            let zero = self.ring.zero();
            let of = |side: &BTreeMap<u32, Fraction>| side.get(&power.value).cloned();
            let (a, b) = (
                of(exact).unwrap_or(zero.clone()),
                of(assumed).unwrap_or(zero),
            );
            let mut difference = self.ring.difference(&a, &b).map_err(wrap)?;
            for (index, neglected) in matching.neglected.iter().enumerate() {
                let value = self.scalar(neglected)?.value;
                if value.is_zero() {
                    seen[index] = true;
                    continue;
                }
                let part =
                    self.occurrence(&difference, &value, unknowns, small, &neglected.span)?;
                let Some(part) = part else { continue };
                seen[index] = true;
                difference = self.ring.difference(&difference, &part).map_err(wrap)?;
                let factor = self.ring.quotient(&part, &value).map_err(wrap)?;
                equations.neglected.push((index, power.value, factor));
            }
            let (row, right) = self.linear_form(&difference, unknowns, matching, span)?;
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
        unknowns: &[Symbol],
        small: &[Symbol],
        span: &Span,
    ) -> Result<Option<Fraction>, Diagnostic> {
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

    /// (a, −a₀) of a₀ + Σ aⱼ bⱼ.
    fn linear_form(
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
            let presenter = Presenter {
                ring: &self.ring,
                scope: &self.scope,
            };
            let shown = term.and_then(|term| presenter.polynomial(&term).ok());
            let shown = shown.map(|term| super::notation::Notation::Unicode.expression(&term));
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
                            .with_help("use another power"),
                    );
                }
            }
        }
        Ok((row, constant.negative()))
    }

    /// The solution of as many equations as there are unknowns, checked in the others, and the
    /// determinant.
    fn solve_equations(
        &mut self,
        matching: &Matching,
        equations: &Equations,
        count: usize,
    ) -> Result<(Vec<Fraction>, Fraction), Diagnostic> {
        let span = &matching.name.span;
        let wrap = |error| algebra(error, span);
        let singular = |message: String| {
            Diagnostic::new(DiagnosticKind::Singular, span.clone(), message)
                .with_label("these equations do not determine the unknowns")
                .with_help("use other powers behind `at`")
        };
        if equations.rows.len() < count {
            let given = equations.rows.len();
            let s = if given == 1 { "" } else { "s" };
            return Err(
                singular(format!("{given} equation{s} for {count} unknowns"))
                    .with_help("name at least as many powers behind `at` as there are unknowns"),
            );
        }
        let matrix = Matrix::from_fn(count, count, |row, column| {
            equations.rows[row][column].clone()
        });
        let right = Matrix::from_fn(count, 1, |row, _| equations.right[row].clone());
        let solved = solve(&matrix, &right, &self.ring).map_err(wrap)?;
        if solved.determinant.is_zero() {
            return Err(singular(
                "the matching is singular: its determinant is identically 0".into(),
            ));
        }
        let solution: Result<Vec<Fraction>, _> = solved
            .numerators
            .entries()
            .iter()
            .map(|numerator| self.ring.quotient(numerator, &solved.determinant))
            .collect();
        let solution = solution.map_err(wrap)?;
        for ((row, right), power) in equations
            .rows
            .iter()
            .zip(&equations.right)
            .zip(&matching.powers)
            .skip(count)
        {
            let mut left = self.ring.zero();
            for (slope, value) in row.iter().zip(&solution) {
                let term = self.ring.product(slope, value).map_err(wrap)?;
                left = self.ring.sum(&left, &term).map_err(wrap)?;
            }
            if !self.ring.difference(&left, right).map_err(wrap)?.is_zero() {
                let message = "this coefficient contradicts the ones before it";
                return Err(Diagnostic::new(
                    DiagnosticKind::Inconsistent,
                    power.span.clone(),
                    message,
                )
                .with_label("not satisfied by the solution of the others")
                .with_help("use as many powers as there are unknowns"));
            }
        }
        Ok((solution, solved.determinant))
    }

    #[expect(
        clippy::too_many_arguments,
        reason = "one row needs all of the matching"
    )]
    fn row(
        &mut self,
        power: u32,
        exact: &Fraction,
        assumed: &Fraction,
        solution: &Substitution,
        small: &[Symbol],
        used: bool,
        matching: &Matching,
    ) -> Result<Row, Diagnostic> {
        let wrap = |error| algebra(error, &matching.exact.span);
        let solved = self.ring.substitute(assumed, solution).map_err(wrap)?;
        let residual = self.ring.difference(exact, &solved).map_err(wrap)?;
        let order = if small.is_empty() {
            None
        } else {
            self.ring
                .leading_part(&residual, small, HIGHEST_ORDER)
                .map_err(wrap)?
        };
        let presenter = Presenter {
            ring: &self.ring,
            scope: &self.scope,
        };
        Ok(Row {
            power,
            exact: presenter.element(exact).map_err(wrap)?,
            assumed: presenter.element(assumed).map_err(wrap)?,
            residual: presenter.element(&residual).map_err(wrap)?,
            order: order.map(|(degree, _)| degree),
            used,
        })
    }

    /// The factors of a determinant that may vanish.
    fn singularities(
        &mut self,
        determinant: &Fraction,
        solution: &[Fraction],
        span: &Span,
    ) -> Result<Vec<Singularity>, Diagnostic> {
        let wrap = |error| algebra(error, span);
        let mut found = Vec::new();
        for (factor, exponent) in self.ring.factored(determinant).map_err(wrap)?.factors {
            let signs = self.ring.polynomial_signs(&factor).map_err(wrap)?;
            if exponent < 0 || signs.is_non_zero() {
                continue;
            }
            let mut finite = true;
            for value in solution {
                let shared = value.denominator().gcd(&factor, self.ring.budget());
                finite &= shared
                    .map_err(|error| wrap(error.into()))?
                    .as_constant()
                    .is_some();
            }
            let presenter = Presenter {
                ring: &self.ring,
                scope: &self.scope,
            };
            let factor = presenter.polynomial(&factor).map_err(wrap)?;
            found.push(Singularity { factor, finite });
        }
        Ok(found)
    }
}
