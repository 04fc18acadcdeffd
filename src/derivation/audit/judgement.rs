//! The verdicts on what a document asserts, where a statement that fails costs only what builds on it.

use std::collections::BTreeMap;
use std::slice::from_ref;

use crate::derivation::assertion::Finding;
use crate::derivation::diagnostic::{Diagnostic, DiagnosticKind};
use crate::derivation::judge::Judge;
use crate::derivation::syntax::Relation;
use crate::derivation::verdict::{Claim, Verdict};

use super::Skipped;
use super::reader::{Read, Reader};
use super::refusal::Reason;

/// What is wrong with matchings, by their document and the place of their label.
pub(super) type FailedMatchings = BTreeMap<(String, usize), Diagnostic>;

impl Reader<'_> {
    /// The verdicts on what was read, in the order of the document, and what is wrong with matchings that
    /// do not stand at points: then nothing that builds on them may count.
    pub(super) fn judge(&mut self, read: &mut Read) -> (Vec<Claim>, FailedMatchings) {
        let relations = self.assumptions.iter().map(|own| own.relation.clone());
        let relations: Vec<Relation> = relations.collect();
        let scope = &self.elaborator.scope;
        let mut judge = Judge::new(scope, &relations, self.signs());
        let (mut claims, failed) = judged(&mut judge, read, &self.here.path);
        for (claim, finding) in claims.iter().zip(&read.findings) {
            if claim.fault {
                let diagnostic = disagreement(finding);
                self.refusals.note(diagnostic, &self.here.path);
            }
        }
        self.withhold(&mut claims, read);
        claims.append(&mut read.skipped_claims);
        claims.sort_by_key(|claim| claim.label.span.start);
        read.skipped.sort_by_key(|skipped| skipped.line);
        (claims, failed)
    }

    /// Withholds the verdict on what is not true but may be so under an assumption that is refused.
    fn withhold(&mut self, claims: &mut [Claim], read: &mut Read) {
        let scope = &self.elaborator.scope;
        let uncertain = self.refusals.uncertain(&self.assumptions, scope);
        let is_open = |claim: &&mut Claim| {
            matches!(claim.verdict, Verdict::Refuted | Verdict::Undecided) && !claim.fault
        };
        for claim in claims.iter_mut().filter(is_open) {
            let mut mentions = Vec::new();
            claim.statement.left.collect_mentions(&mut mentions);
            claim.statement.right.collect_mentions(&mut mentions);
            let names = mentions.iter().map(|mention| &mention.name);
            if let Some(reason) = uncertain.reason(names, scope) {
                let skipped = skip(claim, &reason, &self.here.path);
                read.skipped.push(skipped);
            }
        }
    }
}

/// Takes the verdict from a claim.
fn skip(claim: &mut Claim, reason: &Reason, path: &str) -> Skipped {
    let basis = reason.basis(path);
    claim.verdict = Verdict::Skipped;
    claim.reason = Some(format!("it {}", basis.reason));
    claim.witness = None;
    Skipped {
        span: claim.label.span.clone(),
        is_claim: true,
        line: claim.line,
        what: format!("the claim {}", claim.label.written()),
        basis,
    }
}

/// The verdicts on all findings at once, and each by itself where one of them, or a matching, fails.
fn judged<'a>(judge: &mut Judge<'a>, read: &'a Read, path: &str) -> (Vec<Claim>, FailedMatchings) {
    if let Ok(claims) = judge.judge_all(&read.findings, &read.checks) {
        return (claims, FailedMatchings::new());
    }
    let claims = read.findings.iter().map(|finding| {
        let judged = judge.judge_all(from_ref(finding), &[]);
        let claim = judged.ok().and_then(|mut claims| claims.pop());
        claim.unwrap_or_else(|| fault(finding))
    });
    let claims: Vec<Claim> = claims.collect();
    let matchings = read.matchings.iter().zip(&read.checks);
    let failed = matchings.filter_map(|(matched, check)| {
        let diagnostic = judge.judge_all(&[], from_ref(check)).err()?;
        Some(((path.to_string(), matched.label.span.start), diagnostic))
    });
    (claims, failed.collect())
}

/// Whose mistake it is, and what to do.
const FAULT: &str = "this is a mistake of sextic, not of the document: please report it";

/// A claim on which the routes disagree.
fn fault(finding: &Finding) -> Claim {
    Claim {
        reason: Some(format!("the two routes to a verdict disagree: {FAULT}")),
        fault: true,
        ..Claim::undecided(&finding.assertion)
    }
}

fn disagreement(finding: &Finding) -> Diagnostic {
    let (kind, span) = (DiagnosticKind::Disagreement, finding.assertion.span.clone());
    Diagnostic::new(kind, span, "the two routes to a verdict disagree")
        .with_label("equal in normal form, different at a point")
        .with_help(FAULT)
}

#[cfg(test)]
mod tests {
    use crate::derivation::audit::audit;
    use crate::derivation::diagnostic::SourceFile;
    use crate::derivation::verdict::Verdict;
    use crate::documents::ShippedLibrary;

    use super::super::judgement::FailedMatchings;
    use super::*;

    const DOCUMENT: &str = "```sextic
parameter x, y : 1
claim (1): (x + y)^2 == x^2 + 2*x*y + y^2
claim (2): x + y == y + x
refute (3): x == y
```
";

    /// The routes are made to disagree by giving the second one another relation than the first one was
    /// asked about.
    #[test]
    fn a_disagreement_costs_one_claim() {
        let source = SourceFile::new("a.md", DOCUMENT);
        let alone = audit(&source, &ShippedLibrary).expect("a document");
        let mut reader = Reader::new(&ShippedLibrary, &[], FailedMatchings::new());
        let mut read = reader.read(&source).expect("a document");
        read.findings[0].assertion.relation.right =
            read.findings[1].assertion.relation.right.clone();
        let (claims, _) = reader.judge(&mut read);
        assert!(claims[0].fault && claims[0].verdict == Verdict::Undecided);
        assert!(
            claims[0]
                .reason
                .as_ref()
                .is_some_and(|reason| reason.contains(FAULT))
        );
        for (claim, same) in claims.iter().zip(&alone.claims).skip(1) {
            assert!(!claim.fault);
            assert_eq!(
                (claim.verdict, &claim.witness),
                (same.verdict, &same.witness)
            );
        }
        let mistakes = reader.refusals.mistakes;
        assert_eq!(mistakes.len(), 1);
        assert_eq!(mistakes[0].diagnostic.kind, DiagnosticKind::Disagreement);
    }
}
