//! The JSON of `sextic audit`.

use serde::Serialize;

use crate::derivation::audit::Audit;
use crate::derivation::notation::Notation;
use crate::derivation::syntax::Expression;
use crate::derivation::verdict::{Claim, Witness};
use crate::report::details::{neglected, route};
use crate::report::words;

use super::ascii;
use super::pairs::{Pairs, definitions};

#[derive(Serialize)]
struct Documents<'a> {
    documents: Vec<DocumentObject<'a>>,
}

#[derive(Serialize)]
struct DocumentObject<'a> {
    path: &'a str,
    title: Option<&'a str>,
    claims: Vec<ClaimObject<'a>>,
    /// The ids of the matchings, which `sextic match` shows.
    matchings: Vec<&'a str>,
    as_expected: bool,
}

#[derive(Serialize)]
struct ClaimObject<'a> {
    id: &'a str,
    equation: Option<&'a str>,
    label: String,
    line: usize,
    description: Option<&'a str>,
    statement: String,
    expected: &'static str,
    verdict: &'static str,
    as_expected: bool,
    conditions: Vec<String>,
    neglected: Vec<String>,
    residual: Option<String>,
    witness: Option<WitnessObject<'a>>,
    reason: Option<&'a str>,
}

#[derive(Serialize)]
struct WitnessObject<'a> {
    point: Pairs,
    entry: Option<(usize, usize)>,
    left: &'a str,
    right: &'a str,
}

#[derive(Serialize)]
struct ExplanationObject<'a> {
    path: &'a str,
    claim: ClaimObject<'a>,
    definitions: Pairs,
    left: Vec<Option<String>>,
    right: Vec<Option<String>>,
    unit: Option<&'a str>,
    points: usize,
    route: String,
}

/// Writes the verdicts on documents.
pub fn audits(audits: &[Audit]) -> String {
    let documents = audits.iter().map(|audit| DocumentObject {
        path: &audit.path,
        title: audit.title.as_deref(),
        claims: audit.claims.iter().map(claim_object).collect(),
        matchings: matching_ids(audit).collect(),
        as_expected: audit.as_expected(),
    });
    super::write(&Documents {
        documents: documents.collect(),
    })
}

/// Writes how the verdict on a claim of a document was reached.
pub fn explanation(audit: &Audit, claim: &Claim) -> String {
    let explanation = audit.explain(claim);
    super::write(&ExplanationObject {
        path: &audit.path,
        claim: claim_object(claim),
        definitions: definitions(&explanation.definitions),
        left: normal_forms(&explanation.left),
        right: normal_forms(&explanation.right),
        unit: explanation.unit.as_deref(),
        points: claim.points,
        route: route(claim),
    })
}

fn matching_ids(audit: &Audit) -> impl Iterator<Item = &str> {
    let matchings = audit.matchings.iter();
    matchings.map(|matched| matched.label.id.as_str())
}

fn claim_object(claim: &Claim) -> ClaimObject<'_> {
    let conditions = claim.conditions.iter();
    ClaimObject {
        id: &claim.label.id,
        equation: claim.label.equation.as_deref(),
        label: words::label(&claim.label),
        line: claim.line,
        description: claim.description.as_deref(),
        statement: Notation::Ascii.relation(&claim.statement),
        expected: words::expectation(claim.expectation),
        verdict: claim.verdict.text(),
        as_expected: claim.as_expected(),
        conditions: conditions
            .map(|one| words::condition(one, Notation::Ascii))
            .collect(),
        neglected: neglected(claim, Notation::Ascii)
            .iter()
            .map(|words| words.plain())
            .collect(),
        residual: claim.residual.as_ref().map(ascii),
        witness: claim.witness.as_ref().map(witness_object),
        reason: claim.reason.as_deref(),
    }
}

fn witness_object(witness: &Witness) -> WitnessObject<'_> {
    let point = witness.point.iter();
    let point = point.map(|one| {
        (
            Notation::Ascii.expression(&one.name),
            words::assigned(one, Notation::Ascii),
        )
    });
    WitnessObject {
        point: Pairs(point.collect()),
        entry: witness.entry,
        left: &witness.left,
        right: &witness.right,
    }
}

fn normal_forms(entries: &[Option<Expression>]) -> Vec<Option<String>> {
    entries
        .iter()
        .map(|entry| entry.as_ref().map(ascii))
        .collect()
}
