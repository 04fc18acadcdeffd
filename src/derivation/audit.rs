//! A document, read from its first statement to its last.

use std::collections::BTreeMap;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::budget::Budget;
use crate::algebra::generator::Generator;
use crate::algebra::sign::Signs;

use super::assertion::{Assertion, Finding};
use super::diagnostic::{Diagnostic, DiagnosticKind, SourceFile};
use super::document::{Document, parse_document_with};
use super::elaboration::Elaborator;
use super::elaboration::error::algebra;
use super::judge::Judge;
use super::matching::Matched;
use super::matching::check::MatchingCheck;
use super::name::Aliases;
use super::quantity::Quantity;
use super::scope::{Meaning, SymbolKind};
use super::syntax::{
    BinaryOperator, Comparison, Expectation, Expression, Name, Place, Relation, Sign, Span,
    Spanned, Statement, StatementKind,
};
use super::unit::Unit;
use super::verdict::Claim;

/// How many steps of the algebra one statement may take.
pub const STEPS: u64 = 50_000_000;

/// Where imported documents come from; the derivation itself reads no files.
pub trait Library {
    /// The document that `path` names when `from` imports it.
    ///
    /// # Errors
    ///
    /// Why it cannot be had, in a few words.
    fn read(&self, path: &str, from: &str) -> Result<SourceFile, String>;
}

/// What became of a document.
#[derive(Clone, Debug)]
pub struct Audit {
    /// How the document is called.
    pub path: String,
    /// Its first heading.
    pub title: Option<String>,
    /// Its assertions, in order.
    pub claims: Vec<Claim>,
    /// Its matchings, in order.
    pub matchings: Vec<Matched>,
}

impl Audit {
    /// Whether every verdict is the one that the author expects.
    pub fn as_expected(&self) -> bool {
        self.claims.iter().all(Claim::as_expected)
    }
}

/// A document that could not be read to its end: the file in which the mistakes are, and the mistakes.
#[derive(Clone, Debug)]
pub struct Rejected {
    /// The document, or one that it imports.
    pub source: SourceFile,
    /// What is wrong with it.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a document and gives the verdict on each of its assertions.
///
/// # Errors
///
/// [`Rejected`] where the document, or one that it imports, does not make sense.
pub fn audit(source: &SourceFile, library: &dyn Library) -> Result<Audit, Box<Rejected>> {
    let mut reader = Reader {
        elaborator: Elaborator::new(Budget::new(STEPS)),
        library,
        assumptions: Vec::new(),
        open: Vec::new(),
        finished: Vec::new(),
        aliases: Aliases::default(),
    };
    let read = reader.read(source)?;
    let signs = reader.signs();
    let mut judge = Judge::new(&reader.elaborator.scope, &reader.assumptions, signs);
    let rejected = |diagnostic| {
        Box::new(Rejected {
            source: source.clone(),
            diagnostics: vec![diagnostic],
        })
    };
    let mut claims = Vec::new();
    for finding in &read.findings {
        claims.push(judge.judge(finding).map_err(rejected)?);
    }
    for check in &read.checks {
        check.confirm(&mut judge).map_err(rejected)?;
    }
    Ok(Audit {
        path: source.path.clone(),
        title: read.title,
        claims,
        matchings: read.matchings,
    })
}

/// Reads documents into one scope.
struct Reader<'a> {
    elaborator: Elaborator,
    library: &'a dyn Library,
    assumptions: Vec<Relation>,
    open: Vec<String>,
    finished: Vec<String>,
    aliases: Aliases,
}

/// What a document says beyond its declarations.
#[derive(Default)]
struct Read {
    title: Option<String>,
    findings: Vec<Finding>,
    matchings: Vec<Matched>,
    checks: Vec<MatchingCheck>,
}

impl Reader<'_> {
    fn read(&mut self, source: &SourceFile) -> Result<Read, Box<Rejected>> {
        let reject = |diagnostics| {
            Box::new(Rejected {
                source: source.clone(),
                diagnostics,
            })
        };
        let mut read = Read::default();
        // Imports come first: they declare spellings that the rest is parsed with.
        let document: Document = loop {
            let document = parse_document_with(source, &self.aliases).map_err(reject)?;
            if self.import(&document, source)? == 0 {
                break document;
            }
        };
        self.aliases.extend(&document.aliases);
        self.elaborator.scope.leave_document();
        read.title.clone_from(&document.title);
        for statement in &document.statements {
            self.elaborator.fresh();
            let line = line_of(&source.text, statement.span.start);
            self.execute(statement, line, &mut read)
                .map_err(|error| reject(vec![error]))?;
        }
        Ok(read)
    }

    /// Reads the imports that were not read yet: how many there were.
    fn import(&mut self, document: &Document, source: &SourceFile) -> Result<usize, Box<Rejected>> {
        let mut count = 0;
        for statement in &document.statements {
            let StatementKind::Import { path } = &statement.kind else {
                continue;
            };
            let reject = |kind, message: String, label: String, help: &str| {
                let diagnostic = Diagnostic::new(kind, path.span.clone(), message)
                    .with_label(label)
                    .with_help(help);
                Box::new(Rejected {
                    source: source.clone(),
                    diagnostics: vec![diagnostic],
                })
            };
            let imported = self
                .library
                .read(&path.value, &source.path)
                .map_err(|reason| {
                    let message = format!("`{}` cannot be imported", path.value);
                    let help = "the path is relative to the document that imports";
                    reject(DiagnosticKind::MissingFile, message, reason, help)
                })?;
            if self.finished.contains(&imported.path) {
                continue;
            }
            if self.open.contains(&imported.path) || imported.path == source.path {
                let mut chain = self.open.clone();
                chain.extend([source.path.clone(), imported.path.clone()]);
                let message = format!("`{}` imports itself", imported.path);
                let help = "move what both need into a third document";
                return Err(reject(
                    DiagnosticKind::CircularImport,
                    message,
                    chain.join(" → "),
                    help,
                ));
            }
            self.open.push(source.path.clone());
            self.read(&imported)?;
            self.open.pop();
            self.finished.push(imported.path);
            count += 1;
        }
        Ok(count)
    }

    fn execute(
        &mut self,
        statement: &Statement,
        line: usize,
        read: &mut Read,
    ) -> Result<(), Diagnostic> {
        let span = &statement.span;
        match &statement.kind {
            StatementKind::Import { .. } => Ok(()),
            StatementKind::Parameter {
                names,
                unit,
                sign,
                description,
            } => {
                let unit = Unit::parse(unit)?;
                for name in names {
                    let generator = Generator::Constant {
                        name: name.value.ascii.clone(),
                    };
                    self.symbol(
                        name,
                        generator,
                        &unit,
                        SymbolKind::Parameter,
                        *sign,
                        description,
                    )?;
                }
                Ok(())
            }
            StatementKind::Angle { names, description } => {
                for name in names {
                    let generator = Generator::Angle {
                        name: name.value.ascii.clone(),
                    };
                    self.symbol(
                        name,
                        generator,
                        &Unit::one(),
                        SymbolKind::Angle,
                        None,
                        description,
                    )?;
                }
                Ok(())
            }
            StatementKind::Coordinate {
                names,
                unit,
                description,
            } => {
                let angular = unit.value.trim() == "rad";
                let unit = Unit::parse(unit)?;
                let kind = if angular {
                    SymbolKind::AngularCoordinate
                } else {
                    SymbolKind::Coordinate
                };
                for name in names {
                    let ascii = name.value.ascii.clone();
                    let generator = Generator::Coordinate {
                        name: ascii,
                        order: 0,
                        angular,
                    };
                    self.symbol(name, generator, &unit, kind, None, description)?;
                }
                Ok(())
            }
            StatementKind::Imaginary { name } => {
                let generator = Generator::ImaginaryUnit;
                self.symbol(
                    name,
                    generator,
                    &Unit::one(),
                    SymbolKind::Imaginary,
                    None,
                    &None,
                )
            }
            StatementKind::Function {
                names,
                reference,
                unit,
                description,
            } => {
                let unit = Unit::parse(unit)?;
                let argument = self.elaborator.scalar(reference)?;
                for name in names {
                    let meaning = Meaning::Function {
                        reference: reference.clone(),
                        argument: argument.clone(),
                        unit: unit.clone(),
                    };
                    self.elaborator
                        .scope
                        .declare(name, meaning, description.clone())?;
                }
                Ok(())
            }
            StatementKind::Assume { relation, .. } => self.assume(relation, span),
            StatementKind::Definition {
                names,
                arguments,
                values,
            } => self.define(names, arguments, values),
            StatementKind::Substitution { name, replacements } => {
                let place = Place::Replacements(replacements.clone());
                self.elaborator.substitution(&place, span)?;
                let meaning = Meaning::Substitution {
                    replacements: replacements.clone(),
                    conditions: std::mem::take(&mut self.elaborator.conditions),
                    sources: Vec::new(),
                };
                self.elaborator.scope.declare(name, meaning, None)
            }
            StatementKind::Assertion {
                expectation,
                label,
                relation,
                order,
                description,
            } => {
                let assertion = Assertion {
                    label: label.clone(),
                    expectation: *expectation,
                    relation: relation.clone(),
                    order: order.clone(),
                    description: description.clone(),
                    line,
                    span: span.clone(),
                };
                read.findings.push(self.elaborator.find(&assertion)?);
                Ok(())
            }
            StatementKind::Eigenpair {
                label,
                stiffness,
                mass,
                value,
                vector,
                description,
            } => {
                self.non_zero_vector(vector)?;
                let of = |matrix: &Expression| {
                    let (a, b) = (matrix.clone(), vector.clone());
                    Expression::binary(BinaryOperator::Multiply, a, b)
                };
                let right = Expression::binary(BinaryOperator::Multiply, value.clone(), of(mass));
                let assertion = Assertion {
                    label: label.clone(),
                    expectation: Expectation::Holds,
                    relation: Relation {
                        left: of(stiffness),
                        comparison: Comparison::Equal,
                        right,
                    },
                    order: None,
                    description: description.clone(),
                    line,
                    span: span.clone(),
                };
                read.findings.push(self.elaborator.find(&assertion)?);
                Ok(())
            }
            StatementKind::Match(matching) => {
                let matched = self.elaborator.match_coefficients(matching, line)?;
                read.checks
                    .push(MatchingCheck::new(&matched, &statement.span));
                read.matchings.push(matched);
                Ok(())
            }
        }
    }

    fn symbol(
        &mut self,
        name: &Spanned<Name>,
        generator: Generator,
        unit: &Unit,
        kind: SymbolKind,
        sign: Option<Sign>,
        description: &Option<String>,
    ) -> Result<(), Diagnostic> {
        let ring = &mut self.elaborator.ring;
        let symbol = ring
            .symbol(generator)
            .map_err(|error| algebra(error, &name.span))?;
        let signs = match sign {
            None => Signs::ANY,
            Some(Sign::Positive) => Signs::POSITIVE,
            Some(Sign::NonNegative) => Signs::NON_NEGATIVE,
            Some(Sign::NonZero) => Signs::NON_ZERO,
        };
        ring.assumptions_mut().assume_symbol(symbol, signs);
        let meaning = Meaning::Symbol {
            symbol,
            unit: unit.clone(),
            kind,
        };
        self.elaborator
            .scope
            .declare(name, meaning, description.clone())
    }

    fn assume(&mut self, relation: &Relation, span: &Span) -> Result<(), Diagnostic> {
        let left = self.elaborator.scalar(&relation.left)?;
        let right = self.elaborator.scalar(&relation.right)?;
        if let (Some(a), Some(b)) = (&left.unit, &right.unit)
            && a != b
        {
            return Err(super::elaboration::error::units(a, b, span));
        }
        let signs = match relation.comparison {
            Comparison::Less => Signs::POSITIVE,
            Comparison::LessOrEqual => Signs::NON_NEGATIVE,
            Comparison::Greater => Signs::NEGATIVE,
            Comparison::GreaterOrEqual => Signs::NON_NEGATIVE.opposite(),
            Comparison::Equal => {
                let message = "only inequalities can be assumed";
                return Err(
                    Diagnostic::new(DiagnosticKind::Unsupported, span.clone(), message)
                        .with_label("an equation")
                        .with_help("define one side by the other with `:=`"),
                );
            }
        };
        let ring = &mut self.elaborator.ring;
        let difference = ring.difference(&right.value, &left.value);
        let difference = difference.map_err(|error| algebra(error, span))?;
        let below = ring.polynomial_signs(difference.denominator());
        let below = below.map_err(|error| algebra(error, span))?;
        if !below.is_positive() {
            let message = "an assumption must be an inequality between polynomials";
            return Err(
                Diagnostic::new(DiagnosticKind::Unsupported, span.clone(), message)
                    .with_help("multiply it by its denominator, whose sign must be known"),
            );
        }
        let (above, signs) = (difference.numerator().clone(), signs);
        if signs.negative {
            ring.assumptions_mut()
                .assume_polynomial(-&above, signs.opposite());
        } else {
            ring.assumptions_mut().assume_polynomial(above, signs);
        }
        self.assumptions.push(relation.clone());
        Ok(())
    }

    fn define(
        &mut self,
        names: &[Spanned<Name>],
        arguments: &[Spanned<Name>],
        values: &[Expression],
    ) -> Result<(), Diagnostic> {
        for (place, argument) in arguments.iter().enumerate() {
            if let Some(earlier) = arguments[..place]
                .iter()
                .find(|e| e.value == argument.value)
            {
                let message = format!("two arguments are called `{}`", argument.value);
                return Err(Diagnostic::new(
                    DiagnosticKind::Duplicate,
                    argument.span.clone(),
                    message,
                )
                .with_label("the same again")
                .with_secondary(earlier.span.clone(), "the first one")
                .with_help("give each argument a name of its own"));
            }
        }
        for (name, expression) in names.iter().zip(values) {
            let meaning = if arguments.is_empty() {
                self.elaborator.fresh();
                let value = self.elaborator.value(expression)?;
                Meaning::Definition {
                    expression: expression.clone(),
                    value,
                    conditions: std::mem::take(&mut self.elaborator.conditions),
                }
            } else {
                Meaning::Template {
                    arguments: arguments
                        .iter()
                        .map(|argument| argument.value.clone())
                        .collect(),
                    expression: expression.clone(),
                }
            };
            self.elaborator.scope.declare(name, meaning, None)?;
        }
        Ok(())
    }

    fn non_zero_vector(&mut self, vector: &Expression) -> Result<(), Diagnostic> {
        let value = self.elaborator.value(vector)?;
        let zero = |entry: &Quantity| entry.value.is_zero();
        if value.entries().iter().all(zero) {
            let message = "an eigenvector must not be 0";
            return Err(Diagnostic::new(DiagnosticKind::Arguments, vector.span.clone(), message)
                .with_label("this is 0")
                .with_help("every value is an eigenvalue of 0; give a vector with an entry other than 0"));
        }
        Ok(())
    }

    /// What is known of the signs of symbols, by ASCII name.
    fn signs(&self) -> BTreeMap<String, Signs> {
        let assumptions = self.elaborator.ring.assumptions();
        let entries = self.elaborator.scope.entries();
        entries
            .filter_map(|entry| match &entry.meaning {
                Meaning::Symbol { symbol, .. } => {
                    Some((entry.name.ascii.clone(), assumptions.of_symbol(*symbol)))
                }
                _ => None,
            })
            .collect()
    }
}

/// The line of a byte of a text, counted from 1.
fn line_of(text: &str, offset: usize) -> usize {
    text.bytes()
        .take(offset)
        .filter(|byte| *byte == b'\n')
        .count()
        + 1
}
