//! What statements of several documents build on.

use std::collections::{BTreeMap, BTreeSet};

use crate::language::intent::Intent;
use crate::language::syntax::{Name, Statement, StatementKind};
use crate::verdict::audit::{Audit, Part};

/// The statements of documents that import each other, and which of them each builds on.
pub(super) struct Dependence {
    statements: Vec<Dependent>,
    /// What is declared in each document.
    declared: Vec<Declared>,
}

/// A statement and what it builds on.
struct Dependent {
    /// The place of its document among all.
    document: usize,
    path: String,
    /// The line on which it begins.
    line: usize,
    is_judged: bool,
    is_import: bool,
    needs: BTreeSet<usize>,
}

impl Dependence {
    /// Of audited documents, with what each says.
    pub(super) fn new(audits: &[Audit], documents: &[Vec<Statement>]) -> Self {
        let mut statements = Vec::new();
        let mut declared: Vec<Declared> = Vec::new();
        for (document, (audit, own)) in audits.iter().zip(documents).enumerate() {
            let mut names = Declared::imported(audit, &audits[..document], &declared);
            for statement in own {
                names.declare(&Intent::of(statement), statements.len());
                statements.push(Dependent {
                    document,
                    path: audit.path.clone(),
                    line: audit.line_of(statement),
                    is_judged: is_judged(&statement.kind),
                    is_import: matches!(statement.kind, StatementKind::Import { .. }),
                    needs: names.needed(statement),
                });
            }
            declared.push(names);
        }
        let mut dependence = Dependence {
            statements,
            declared,
        };
        let all = documents.iter().flatten().enumerate();
        let assumptions = all.filter(|(_, own)| matches!(own.kind, StatementKind::Assume { .. }));
        for (place, _) in assumptions.collect::<Vec<_>>() {
            dependence.assume(place);
        }
        dependence
    }

    /// What is assumed of a name counts wherever that is mentioned.
    fn assume(&mut self, assumption: usize) {
        for place in self.needed([assumption]) {
            if place != assumption {
                self.statements[place].needs.insert(assumption);
            }
        }
    }

    /// What these statements build on, and themselves.
    fn needed(&self, statements: impl IntoIterator<Item = usize>) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        let mut open: Vec<usize> = statements.into_iter().collect();
        while let Some(next) = open.pop() {
            if found.insert(next) {
                open.extend(&self.statements[next].needs);
            }
        }
        found
    }

    /// The claims that build on a statement, those on the nearest lines of its document first.
    fn claims_on(&self, statement: usize) -> Vec<usize> {
        let own = &self.statements[statement];
        let all = 0..self.statements.len();
        let claims = all.filter(|place| self.statements[*place].is_judged);
        let mut claims: Vec<usize> = claims
            .filter(|place| self.needed([*place]).contains(&statement))
            .collect();
        claims.sort_by_key(|place| {
            let claim = &self.statements[*place];
            (
                claim.document != own.document,
                claim.document,
                claim.line.abs_diff(own.line),
            )
        });
        claims
    }

    /// What is judged after an edit of a statement, one part after the other: the nearest claims that build on it, up to
    /// so many of them each time, then the others, then those of each other document; the places of the documents beside.
    pub(super) fn parts(&self, statement: usize, first: &[usize]) -> Vec<(usize, Part)> {
        let claims = self.claims_on(statement);
        let document = self.statements[statement].document;
        let is_own = |place: &&usize| self.statements[**place].document == document;
        let count = claims.iter().take_while(is_own).count();
        let (here, elsewhere) = claims.split_at(count);
        // The statement itself may be refused, whether or not a claim builds on it.
        let alone = here.is_empty().then_some(here);
        let others = elsewhere.chunk_by(|one, other| {
            self.statements[*one].document == self.statements[*other].document
        });
        let all = alone.into_iter().chain(pieces(here, first)).chain(others);
        all.map(|claims| {
            let own = claims.first().unwrap_or(&statement);
            let part = self.part(claims.iter().chain([&statement]));
            (self.statements[*own].document, part)
        })
        .collect()
    }

    /// The statement that gives a name its meaning in a document.
    pub(super) fn declaring(&self, document: usize, name: &Name) -> Option<usize> {
        self.declared[document].declaring(name)
    }

    /// A part with one more statement, and what that needs; a whole document has it already.
    pub(super) fn with(&self, part: &Part, statement: Option<usize>) -> Part {
        let mut part = part.clone();
        let needed = self.needed(statement.filter(|_| !part.is_empty()));
        for own in needed.into_iter().map(|place| &self.statements[place]) {
            part.entry(own.path.clone()).or_default().insert(own.line);
        }
        part
    }

    /// Statements without a claim, and one that was added on another line of the document of the first.
    pub(super) fn alone(&self, statements: impl IntoIterator<Item = usize>, added: usize) -> Part {
        let statements: Vec<usize> = statements.into_iter().collect();
        let mut part = self.part(&statements);
        let path = statements.first().map(|own| &self.statements[*own].path);
        let lines = part.entry(path.cloned().unwrap_or_default()).or_default();
        let moved = |line: usize| if line < added { line } else { line + 1 };
        *lines = lines.iter().copied().map(moved).chain([added]).collect();
        part
    }

    /// Statements with all that they need, and the imports.
    fn part<'a>(&self, statements: impl IntoIterator<Item = &'a usize>) -> Part {
        let needed = self.needed(statements.into_iter().copied());
        let mut part = Part::new();
        for (place, own) in self.statements.iter().enumerate() {
            let lines = part.entry(own.path.clone()).or_default();
            if own.is_import || needed.contains(&place) {
                lines.insert(own.line);
            }
        }
        part
    }
}

/// Claims up to each of these ends, and behind the last one; none is empty.
fn pieces<'a>(claims: &'a [usize], ends: &[usize]) -> Vec<&'a [usize]> {
    let mut start = 0;
    let ends = ends.iter().copied().chain([claims.len()]);
    let pieces = ends.map(|end| {
        let end = end.clamp(start, claims.len());
        let piece = &claims[start..end];
        start = end;
        piece
    });
    pieces.filter(|own| !own.is_empty()).collect()
}

/// Which statement gives a name its meaning; evaluators and systems have names of their own.
#[derive(Clone, Default)]
struct Declared {
    names: BTreeMap<String, usize>,
    compiled: BTreeMap<String, usize>,
}

impl Declared {
    /// What a document takes from others.
    fn imported(audit: &Audit, earlier: &[Audit], declared: &[Declared]) -> Self {
        let mut all = Declared::default();
        let known = earlier.iter().zip(declared);
        for (_, own) in known.filter(|(own, _)| audit.imports(&own.path)) {
            all.names.extend(own.names.clone());
            all.compiled.extend(own.compiled.clone());
        }
        all
    }

    fn declare(&mut self, intent: &Intent, place: usize) {
        let at = |name: &Name| (name.ascii.clone(), place);
        self.names.extend(intent.declares.iter().map(at));
        self.compiled.extend(intent.compiled.iter().map(at));
    }

    /// The statement that gives a name its meaning, if there is one.
    fn declaring(&self, name: &Name) -> Option<usize> {
        let place = match name.of_output() {
            Some((owner, _)) => self.compiled.get(&owner.ascii),
            None => self.names.get(&name.ascii),
        };
        place.copied()
    }

    /// On what a statement builds.
    fn needed(&self, statement: &Statement) -> BTreeSet<usize> {
        let mentions = statement.mentions().into_iter();
        let names = mentions.filter_map(|own| self.names.get(&own.name.ascii));
        let bases = statement.compiled_bases().into_iter();
        let compiled = bases.filter_map(|own| self.compiled.get(&own.ascii));
        names.chain(compiled).copied().collect()
    }
}

/// Whether a statement has a verdict, or is refused where what it names is not as it must be.
fn is_judged(kind: &StatementKind) -> bool {
    matches!(
        kind,
        StatementKind::Assertion { .. }
            | StatementKind::Eigenpair { .. }
            | StatementKind::Match(_)
            | StatementKind::System(_)
            | StatementKind::Evaluator { .. }
    )
}
