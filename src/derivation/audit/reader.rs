//! Reads documents into one scope, statement by statement.

use std::collections::BTreeMap;

use crate::algebra::budget::Budget;
use crate::algebra::sign::Signs;
use crate::derivation::assertion::{Assertion, Finding};
use crate::derivation::diagnostic::{Diagnostic, DiagnosticKind, SourceFile};
use crate::derivation::document::{Document, parse_document_with};
use crate::derivation::domain::Domain;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::evaluator::Evaluator;
use crate::derivation::judge::matching::MatchingCheck;
use crate::derivation::line_end::unified;
use crate::derivation::matching::Matched;
use crate::derivation::name::Aliases;
use crate::derivation::quantity::Quantity;
use crate::derivation::scope::Meaning;
use crate::derivation::syntax::{
    BinaryOperator, Comparison, Expectation, Expression, Relation, Statement, StatementKind,
};

use super::{Audit, Library, Rejected, STEPS, rejected};

/// Reads documents into one scope.
pub(super) struct Reader<'a> {
    pub(super) elaborator: Elaborator,
    pub(super) library: &'a dyn Library,
    /// The documents that were audited before.
    pub(super) earlier: &'a [Audit],
    pub(super) assumptions: Vec<Relation>,
    /// The documents that are being read, each imported by the one before it.
    pub(super) open: Vec<String>,
    /// The documents that were imported, each behind those that it imports.
    pub(super) finished: Vec<SourceFile>,
    pub(super) aliases: Aliases,
    /// What the documents want compiled, imported ones included.
    pub(super) evaluators: Vec<Evaluator>,
    /// Where the quantities lie in practice.
    pub(super) domain: Domain,
}

/// What a document says beyond its declarations.
#[derive(Default)]
pub(super) struct Read {
    pub(super) title: Option<String>,
    pub(super) findings: Vec<Finding>,
    pub(super) matchings: Vec<Matched>,
    pub(super) evaluators: Vec<Evaluator>,
    pub(super) checks: Vec<MatchingCheck>,
}

impl<'a> Reader<'a> {
    /// A reader that has read nothing.
    pub(super) fn new(library: &'a dyn Library, earlier: &'a [Audit]) -> Self {
        Reader {
            elaborator: Elaborator::new(Budget::new(STEPS)),
            library,
            earlier,
            assumptions: Vec::new(),
            open: Vec::new(),
            finished: Vec::new(),
            aliases: Aliases::default(),
            evaluators: Vec::new(),
            domain: Domain::default(),
        }
    }

    /// Reads a document and what it imports.
    pub(super) fn read(&mut self, source: &SourceFile) -> Result<Read, Box<Rejected>> {
        let reject = |diagnostics| rejected(source, diagnostics);
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
        let text = unified(&source.text);
        let (mut line, mut counted) = (1, 0);
        for statement in &document.statements {
            self.elaborator.fresh();
            let between = text.get(counted..statement.span.start);
            line += between.unwrap_or_default().matches('\n').count();
            counted = statement.span.start;
            self.execute(statement, line, &mut read)
                .map_err(|error| reject(vec![error]))?;
        }
        Ok(read)
    }

    fn execute(
        &mut self,
        statement: &Statement,
        line: usize,
        read: &mut Read,
    ) -> Result<(), Diagnostic> {
        if let Some(assertion) = self.assertion(statement, line)? {
            read.findings.push(self.elaborator.find(&assertion)?);
            return Ok(());
        }
        if let StatementKind::Match(matching) = &statement.kind {
            let matched = self.elaborator.match_coefficients(matching, line)?;
            read.checks
                .push(MatchingCheck::new(&matched, &statement.span));
            read.matchings.push(matched);
            return Ok(());
        }
        if let Some(evaluator) = Evaluator::of(statement, &self.evaluators)? {
            self.evaluators.push(evaluator.clone());
            read.evaluators.push(evaluator);
            return Ok(());
        }
        if let StatementKind::Domain(stated) = &statement.kind {
            return self.domain.extend(stated, &mut self.elaborator);
        }
        self.declare(statement)
    }

    /// What a statement asserts, if it does; of an eigenpair A·v = λ·B·v.
    fn assertion(
        &mut self,
        statement: &Statement,
        line: usize,
    ) -> Result<Option<Assertion>, Diagnostic> {
        let span = statement.span.clone();
        match &statement.kind {
            StatementKind::Assertion {
                expectation,
                label,
                relation,
                order,
                description,
            } => Ok(Some(Assertion {
                label: label.clone(),
                expectation: *expectation,
                relation: relation.clone(),
                order: order.clone(),
                description: description.clone(),
                line,
                span,
            })),
            StatementKind::Eigenpair {
                label,
                stiffness,
                mass,
                value,
                vector,
                description,
            } => {
                self.non_zero_vector(vector)?;
                let product = |a: &Expression, b: Expression| {
                    Expression::binary(BinaryOperator::Multiply, a.clone(), b)
                };
                Ok(Some(Assertion {
                    label: label.clone(),
                    expectation: Expectation::Holds,
                    relation: Relation {
                        left: product(stiffness, vector.clone()),
                        comparison: Comparison::Equal,
                        right: product(value, product(mass, vector.clone())),
                    },
                    order: None,
                    description: description.clone(),
                    line,
                    span,
                }))
            }
            _ => Ok(None),
        }
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
        let mut others = value.entries().iter().filter(|entry| !zero(entry));
        match (others.next(), others.next()) {
            (Some(only), None) => self.elaborator.require_non_zero(&only.value, &vector.span),
            _ => Ok(()),
        }
    }

    /// What is known of the signs of symbols, by ASCII name.
    pub(super) fn signs(&self) -> BTreeMap<String, Signs> {
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
