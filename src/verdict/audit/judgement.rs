//! The verdicts on what a document asserts, where a statement that fails costs only what builds on it.

use crate::derivation::assertion::Finding;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::Relation;
use crate::verdict::claim::{Claim, Verdict};
use crate::verdict::judge::{FAULT, Judge};

use super::Skipped;
use super::failed::FailedMatchings;
use super::reader::{Read, Reader};
use super::refusal::Reason;

impl Reader<'_> {
    /// The verdicts on what was read, in the order of the document, and what is wrong with matchings that
    /// do not stand at points: then nothing that builds on them may count.
    pub(super) fn judge(&mut self, read: &mut Read) -> (Vec<Claim>, FailedMatchings) {
        let relations = self.assumptions.iter().map(|own| own.relation.clone());
        let relations: Vec<Relation> = relations.collect();
        let scope = &self.elaborator.scope;
        let judge = Judge::new(scope, &relations, self.signs(), self.salt());
        let (mut claims, wrong) = judge.judge_all(&read.findings, &read.checks);
        let differences: Vec<Finding> = read.differences.values().cloned().collect();
        let (differences, _) = judge.judge_all(&differences, &[]);
        let wrong = read.matchings.iter().zip(wrong);
        let failed = wrong.filter_map(|(matched, diagnostic)| {
            let place = (self.here.path.clone(), matched.label.span.start);
            Some((place, diagnostic?))
        });
        let failed = failed.collect();
        for (claim, finding) in claims.iter().zip(&read.findings) {
            if claim.fault {
                let diagnostic = disagreement(finding);
                self.refusals.note(diagnostic, &self.here.path);
            }
        }
        for (place, own) in read.differences.keys().zip(&differences) {
            claims[*place].differ_by(own);
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

fn disagreement(finding: &Finding) -> Diagnostic {
    let (kind, span) = (DiagnosticKind::Disagreement, finding.assertion.span.clone());
    Diagnostic::new(kind, span, "the two routes to a verdict disagree")
        .with_label("equal in normal form, different at a point")
        .with_help(FAULT)
}

#[cfg(test)]
mod tests {
    use crate::documents::ShippedLibrary;
    use crate::language::diagnostic::SourceFile;
    use crate::verdict::audit::audit;
    use crate::verdict::claim::Verdict;

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
        let mut reader = Reader::new(&ShippedLibrary, &[], FailedMatchings::new(), None);
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
