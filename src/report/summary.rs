//! A document's verdicts at a glance.

use crate::derivation::matching::Matched;
use crate::language::diagnostic::DiagnosticKind;
use crate::verdict::audit::{Audit, Mistake};
use crate::verdict::claim::{Claim, Verdict};

use super::words;

/// The verdicts, in the order in which they are counted.
const VERDICTS: [Verdict; 7] = [
    Verdict::Holds,
    Verdict::HoldsWhere,
    Verdict::Approximate,
    Verdict::Refuted,
    Verdict::IllFormed,
    Verdict::Undecided,
    Verdict::Skipped,
];

/// What a document's verdicts come to.
#[derive(Clone, Debug)]
pub struct Summary<'a> {
    /// How often each verdict was given; those that were not given are left out.
    pub counts: Vec<(Verdict, usize)>,
    /// Equations of the source that do not hold as it prints them.
    pub equations: Vec<&'a Claim>,
    /// Statements of the source that do not hold.
    pub statements: Vec<&'a Claim>,
    /// Claims whose verdict is not the one that the author expects.
    pub surprises: Vec<&'a Claim>,
    /// What was matched.
    pub matchings: &'a [Matched],
    /// How many assertions were judged.
    total: usize,
    /// How many mistakes there are in the document and in its imports.
    mistakes: usize,
    /// How many statements are skipped for them.
    skipped: usize,
}

/// Whether a mistake is one of the document, and not of this program.
fn is_of_document(mistake: &&Mistake) -> bool {
    mistake.diagnostic.kind != DiagnosticKind::Disagreement
}

impl<'a> Summary<'a> {
    /// Sums up what became of a document.
    pub fn new(audit: &'a Audit) -> Self {
        let count = |verdict| {
            audit
                .claims
                .iter()
                .filter(|claim| claim.verdict == verdict)
                .count()
        };
        let counts = VERDICTS.map(|verdict| (verdict, count(verdict)));
        let failing = audit
            .claims
            .iter()
            .filter(|claim| claim.is_quotation() && words::fails(claim.verdict));
        let (equations, statements) =
            failing.partition(|claim| claim.label.text.ends_with("printed"));
        Summary {
            counts: counts.into_iter().filter(|(_, count)| *count > 0).collect(),
            equations,
            statements,
            surprises: audit
                .claims
                .iter()
                .filter(|claim| words::is_surprise(claim))
                .collect(),
            matchings: &audit.matchings,
            total: audit.claims.len() - count(Verdict::Skipped),
            mistakes: audit.mistakes.iter().filter(is_of_document).count(),
            skipped: audit.skipped.len(),
        }
    }

    /// What does not hold, under a heading each.
    pub fn failures(&self) -> impl Iterator<Item = (&'static str, &[&'a Claim])> {
        let lists = [
            (
                "Printed equations that do not hold",
                self.equations.as_slice(),
            ),
            ("Statements that do not hold", self.statements.as_slice()),
        ];
        lists.into_iter().filter(|(_, claims)| !claims.is_empty())
    }

    /// Whether all is as the document expects, in a sentence; mistakes in one before it.
    pub fn conclusion(&self) -> String {
        let mistakes = words::counted(self.mistakes, "mistake");
        let skipped = match self.skipped {
            1 => "1 statement is".to_string(),
            count => format!("{count} statements are"),
        };
        match (self.mistakes, self.skipped) {
            (0, _) => self.verdicts(),
            (1, 0) => format!("There is 1 mistake. {}", self.verdicts()),
            (1, _) => format!(
                "There is 1 mistake; {skipped} skipped for it. {}",
                self.verdicts()
            ),
            (_, 0) => format!("There are {mistakes}. {}", self.verdicts()),
            _ => format!(
                "There are {mistakes}; {skipped} skipped for them. {}",
                self.verdicts()
            ),
        }
    }

    /// Whether what was judged is as the document expects, in a sentence.
    fn verdicts(&self) -> String {
        match (self.total, self.surprises.len()) {
            (0, _) if self.mistakes > 0 => "No assertion was judged.".into(),
            (0, _) if self.matchings.is_empty() => {
                "Nothing was checked: the document only declares, and asserts and matches nothing."
                    .into()
            }
            (0, _) => "The document asserts nothing; it has a matching only.".into(),
            (1, 0) => "The one verdict is as the document expects.".into(),
            (total, 0) => format!("All {total} verdicts are as the document expects."),
            (total, 1) => format!("1 of {total} verdicts is NOT as the document expects."),
            (total, surprises) => {
                format!("{surprises} of {total} verdicts are NOT as the document expects.")
            }
        }
    }
}
