//! Reads documents into one scope, statement by statement.

use std::collections::{BTreeMap, BTreeSet};

use sha2::{Digest, Sha256};

use crate::algebra::budget::Budget;
use crate::algebra::sign::Signs;
use crate::derivation::assertion::{Assertion, Finding};
use crate::derivation::domain::Domain;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::matching::Matched;
use crate::derivation::quantity::Quantity;
use crate::derivation::scope::Meaning;
use crate::derivation::shown::Shown;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind, SourceFile};
use crate::language::evaluator::Evaluator;
use crate::language::foreign::cured;
use crate::language::intent::{Intent, Unread};
use crate::language::line_end::unified;
use crate::language::name::Aliases;
use crate::language::notation::Notation;
use crate::language::syntax::{
    BinaryOperator, Comparison, Expectation, Expression, Name, Relation, Span, Spanned, Statement,
    StatementKind,
};
use crate::language::system::System;
use crate::points::Salt;
use crate::verdict::claim::{Claim, Verdict};
use crate::verdict::judge::matching::MatchingCheck;

use super::failed::{Failed, FailedMatchings};
use super::refusal::{Reason, Refusals};
use super::{Assumption, Audit, Declaration, Library, Part, Place, Rejected, STEPS, Skipped};

/// Reads documents into one scope.
pub(super) struct Reader<'a> {
    pub(super) elaborator: Elaborator,
    pub(super) library: &'a dyn Library,
    /// The documents that were audited before.
    pub(super) earlier: &'a [Audit],
    pub(super) assumptions: Vec<Assumption>,
    pub(super) declarations: Vec<Declaration>,
    /// The documents that are being read, each imported by the one before it.
    pub(super) open: Vec<String>,
    /// The documents that were imported, each behind those that it imports.
    pub(super) finished: Vec<SourceFile>,
    /// Those of them of which nothing could be read.
    pub(super) unreadable: BTreeSet<String>,
    pub(super) aliases: Aliases,
    /// What the documents want compiled, imported ones included.
    pub(super) evaluators: Vec<Evaluator>,
    /// The systems that the documents want computed, imported ones included.
    pub(super) systems: Vec<System>,
    /// Where the quantities lie in practice.
    pub(super) domain: Domain,
    /// What is wrong, and what that leaves without a meaning.
    pub(super) refusals: Refusals,
    /// Matchings that do not stand at points, as an earlier reading showed.
    failed: FailedMatchings,
    /// The statements that are read, if not all are.
    part: Option<&'a Part>,
    /// The statement that is being read.
    pub(super) here: Place,
    /// The texts that were read.
    texts: Sha256,
}

/// What a document says beyond its declarations.
#[derive(Default)]
pub(super) struct Read {
    pub(super) title: Option<String>,
    pub(super) findings: Vec<Finding>,
    /// What refutations say of their sides, by their places among the findings.
    pub(super) differences: BTreeMap<usize, Finding>,
    pub(super) matchings: Vec<Matched>,
    pub(super) evaluators: Vec<Evaluator>,
    pub(super) systems: Vec<System>,
    pub(super) shown: Vec<Shown>,
    pub(super) checks: Vec<MatchingCheck>,
    /// Assertions that build on refused statements.
    pub(super) skipped_claims: Vec<Claim>,
    pub(super) skipped: Vec<Skipped>,
}

/// What is read in turn.
enum Item {
    Statement(Box<Statement>),
    Unread(Box<Unread>),
}

impl Item {
    fn start(&self) -> usize {
        match self {
            Item::Statement(statement) => statement.span.start,
            Item::Unread(unread) => unread.span.start,
        }
    }
}

impl<'a> Reader<'a> {
    /// A reader that has read nothing.
    pub(super) fn new(
        library: &'a dyn Library,
        earlier: &'a [Audit],
        failed: FailedMatchings,
        part: Option<&'a Part>,
    ) -> Self {
        Reader {
            elaborator: Elaborator::new(Budget::new(STEPS)),
            library,
            earlier,
            assumptions: Vec::new(),
            declarations: Vec::new(),
            open: Vec::new(),
            finished: Vec::new(),
            unreadable: BTreeSet::new(),
            aliases: Aliases::default(),
            evaluators: Vec::new(),
            systems: Vec::new(),
            domain: Domain::default(),
            refusals: Refusals::default(),
            failed,
            part,
            here: Place {
                path: String::new(),
                line: 1,
            },
            texts: Sha256::new(),
        }
    }

    /// Reads a document and what it imports.
    ///
    /// # Errors
    ///
    /// [`Rejected`] where nothing of the document itself can be read.
    pub(super) fn read(&mut self, source: &SourceFile) -> Result<Read, Box<Rejected>> {
        let (document, failed) = self.read_with_imports(source)?;
        self.texts.update(&source.text);
        self.aliases.extend(&document.aliases);
        let mut read = Read {
            title: document.title,
            ..Read::default()
        };
        let statements = document.statements.into_iter().map(Box::new);
        let statements = statements.map(Item::Statement);
        let unread = document.unread.into_iter().map(Box::new).map(Item::Unread);
        let mut items: Vec<Item> = statements.chain(unread).collect();
        items.sort_by_key(Item::start);
        let lines = lines(&unified(&source.text), items.iter().map(Item::start));
        for (item, line) in items.iter().zip(&lines) {
            if let Some(import) = failed.get(&item.start()) {
                self.step_to(source, *line);
                self.lose_import(import);
            }
        }
        self.elaborator.scope.leave_document();
        for (item, line) in items.into_iter().zip(lines) {
            self.step_to(source, line);
            match item {
                Item::Statement(_) if !self.is_read() => {}
                Item::Statement(statement) => self.step(&statement, source, &mut read),
                Item::Unread(unread) => self.refuse(unread.diagnostic, &unread.intent),
            }
        }
        Ok(read)
    }

    /// Whether the statement that stands here belongs to what is read.
    fn is_read(&self) -> bool {
        let lines = self.part.and_then(|part| part.get(&self.here.path));
        lines.is_none_or(|lines| lines.contains(&self.here.line))
    }

    fn step_to(&mut self, source: &SourceFile, line: usize) {
        let path = source.path.clone();
        self.here = Place { path, line };
    }

    fn lose_import(&mut self, import: &Failed) {
        if let Some(diagnostic) = &import.diagnostic {
            self.refusals.note(diagnostic.clone(), &self.here.path);
        }
        let scope = &self.elaborator.scope;
        self.refusals
            .lose_import(&import.path.value, &self.here, scope);
    }

    /// Carries out a statement, or says why not.
    fn step(&mut self, statement: &Statement, source: &SourceFile, read: &mut Read) {
        self.elaborator.fresh();
        if let Some(reason) = self.refusals.reason(statement, &self.elaborator.scope) {
            return self.pass_over(statement, &reason, read);
        }
        if let Err(diagnostic) = self.execute(statement, read) {
            self.elaborator.scope.forget(&statement.span);
            if let Some((name, span)) = self.guilty_template(&diagnostic, statement) {
                self.refuse_template(diagnostic, name, &span, source);
                let scope = &self.elaborator.scope;
                if let Some(reason) = self.refusals.reason(statement, scope) {
                    self.pass_over(statement, &reason, read);
                }
                return;
            }
            match self.missing_assumption(statement, diagnostic.kind) {
                Some(reason) => self.pass_over(statement, &reason, read),
                None => self.refuse(
                    cured(diagnostic, &unified(&source.text)),
                    &Intent::of(statement),
                ),
            }
        }
    }

    /// The definition with arguments in whose text an unknown name stands, and where that is declared;
    /// what it mentions need not be known before it is used.
    fn guilty_template(
        &self,
        diagnostic: &Diagnostic,
        statement: &Statement,
    ) -> Option<(Name, Span)> {
        let place = diagnostic.span.start;
        if diagnostic.kind != DiagnosticKind::UnknownName || statement.span.contains(&place) {
            return None;
        }
        self.elaborator.scope.entries().find_map(|entry| {
            let Meaning::Template { expression, .. } = &entry.meaning else {
                return None;
            };
            let span = entry.span.clone()?;
            let is_guilty = expression.span.contains(&place);
            is_guilty.then(|| (entry.name.clone(), span))
        })
    }

    fn refuse_template(
        &mut self,
        diagnostic: Diagnostic,
        name: Name,
        span: &Span,
        source: &SourceFile,
    ) {
        let intent = Intent {
            declares: vec![name],
            is_template: true,
            ..Intent::default()
        };
        let place = Place {
            path: source.path.clone(),
            line: source.line_and_column(span).0,
        };
        let scope = &self.elaborator.scope;
        self.refusals.refuse(diagnostic, &intent, &place, scope);
    }

    /// The assumption that is not made and from which a sign may follow without which a statement is not
    /// understood.
    fn missing_assumption(&self, statement: &Statement, kind: DiagnosticKind) -> Option<Reason> {
        let scope = &self.elaborator.scope;
        if kind != DiagnosticKind::Unsupported {
            return None;
        }
        let uncertain = self.refusals.uncertain(&self.assumptions, scope);
        let mentions = statement.mentions();
        let names = mentions.iter().map(|mention| &mention.name);
        uncertain.reason(names, scope)
    }

    fn refuse(&mut self, diagnostic: Diagnostic, intent: &Intent) {
        let scope = &self.elaborator.scope;
        self.refusals.refuse(diagnostic, intent, &self.here, scope);
    }

    fn pass_over(&mut self, statement: &Statement, reason: &Reason, read: &mut Read) {
        let basis = reason.basis(&self.here.path);
        let assertion = asserted(statement, self.here.line);
        let is_claim = assertion.is_some();
        if let Some(assertion) = assertion {
            let reason = Some(format!("it {}", basis.reason));
            read.skipped_claims.push(Claim {
                verdict: Verdict::Skipped,
                reason,
                ..Claim::undecided(&assertion)
            });
        }
        read.skipped.push(Skipped {
            span: statement.span.clone(),
            is_claim,
            line: self.here.line,
            what: what(&statement.kind),
            basis,
        });
        let scope = &self.elaborator.scope;
        self.refusals
            .pass_over(statement, reason, &self.here, scope);
    }

    fn execute(&mut self, statement: &Statement, read: &mut Read) -> Result<(), Diagnostic> {
        self.declare_matrices(statement)?;
        self.elaborator.fresh();
        if let Some(assertion) = asserted(statement, self.here.line) {
            if let StatementKind::Eigenpair { vector, .. } = &statement.kind {
                self.non_zero_vector(vector)?;
            }
            let finding = self.elaborator.find(&assertion)?;
            if let Some(difference) = assertion.of_difference() {
                self.elaborator.fresh();
                let finding = self.elaborator.find(&difference)?;
                read.differences.insert(read.findings.len(), finding);
            }
            read.findings.push(finding);
            return Ok(());
        }
        if let StatementKind::Match(matching) = &statement.kind {
            let label = (self.here.path.clone(), matching.label.span.start);
            if let Some(diagnostic) = self.failed.get(&label) {
                return Err(diagnostic.clone());
            }
            let matched = self
                .elaborator
                .match_coefficients(matching, self.here.line)?;
            read.checks
                .push(MatchingCheck::new(&matched, &statement.span));
            read.matchings.push(matched);
            return Ok(());
        }
        if self.show(statement, read)? || self.ask_for(statement, read)? {
            return Ok(());
        }
        if let StatementKind::Domain(stated) = &statement.kind {
            return self.domain.extend(stated, &mut self.elaborator);
        }
        self.declare(statement)
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

    /// Numbers that nobody can know who writes the text that they depend on.
    pub(super) fn salt(&self) -> Salt {
        let imported = self.finished.iter();
        let texts = imported.fold(self.texts.clone(), |texts, source| {
            texts.chain_update(&source.text)
        });
        let digest = texts.finalize();
        let word = |place: usize| {
            let bytes = digest[8 * place..8 * place + 8].iter();
            bytes.fold(0, |number, byte| number << 8 | u64::from(*byte))
        };
        [[word(0), word(1)], [word(2), word(3)]]
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

/// The lines of places that follow each other, counted from 1.
fn lines(text: &str, places: impl Iterator<Item = usize>) -> Vec<usize> {
    let (mut line, mut counted) = (1, 0);
    let mut line_of = |place: usize| {
        let between = text.as_bytes().get(counted..place).unwrap_or_default();
        line += between.iter().filter(|byte| **byte == b'\n').count();
        counted = counted.max(place);
        line
    };
    places.map(&mut line_of).collect()
}

/// What a statement asserts, if it does; of an eigenpair A·v = λ·B·v.
fn asserted(statement: &Statement, line: usize) -> Option<Assertion> {
    let span = statement.span.clone();
    match &statement.kind {
        StatementKind::Assertion {
            expectation,
            label,
            relation,
            difference,
            order,
            description,
        } => Some(Assertion {
            label: label.clone(),
            expectation: *expectation,
            relation: relation.clone(),
            difference: difference.clone(),
            order: order.clone(),
            description: description.clone(),
            line,
            span,
        }),
        StatementKind::Eigenpair {
            label,
            stiffness,
            mass,
            value,
            vector,
            description,
        } => {
            let product = |a: &Expression, b: Expression| {
                Expression::binary(BinaryOperator::Multiply, a.clone(), b)
            };
            Some(Assertion {
                label: label.clone(),
                expectation: Expectation::Holds,
                relation: Relation {
                    left: product(stiffness, vector.clone()),
                    comparison: Comparison::Equal,
                    right: product(value, product(mass, vector.clone())),
                },
                difference: None,
                order: None,
                description: description.clone(),
                line,
                span,
            })
        }
        _ => None,
    }
}

/// What a statement is, in words.
fn what(statement: &StatementKind) -> String {
    let list = |names: &[Spanned<Name>]| {
        let names: Vec<String> = names
            .iter()
            .map(|name| format!("`{}`", name.value))
            .collect();
        names.join(", ")
    };
    match statement {
        StatementKind::Import { path } => format!("the import of `{}`", path.value),
        StatementKind::Parameter { names, .. }
        | StatementKind::Complex { names, .. }
        | StatementKind::Angle { names, .. }
        | StatementKind::Coordinate { names, .. }
        | StatementKind::Function { names, .. } => format!("the declaration of {}", list(names)),
        StatementKind::Imaginary { name } => format!("the declaration of `{}`", name.value),
        StatementKind::Assume { relation, .. } => {
            format!("the assumption {}", Notation::Unicode.relation(relation))
        }
        StatementKind::Definition { names, .. } => format!("the definition of {}", list(names)),
        StatementKind::Substitution { name, .. } => format!("the substitution `{}`", name.value),
        StatementKind::Assertion { label, .. } => format!("the claim {}", label.written()),
        StatementKind::Eigenpair { label, .. } => format!("the eigenpair {}", label.written()),
        StatementKind::Match(own) => {
            format!("the matching {} `{}`", own.label.written(), own.name.value)
        }
        StatementKind::System(own) => {
            format!("the system {} `{}`", own.label.written(), own.name.value)
        }
        StatementKind::Evaluator { label, name, .. } => {
            format!("the evaluator {} `{}`", label.written(), name.value)
        }
        StatementKind::Domain(_) => "the domain".to_string(),
        StatementKind::Show { expression, .. } => {
            format!("`show {}`", Notation::Unicode.expression(expression))
        }
    }
}
