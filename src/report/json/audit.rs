//! The JSON of `sextic audit`.

use serde::Serialize;

use crate::language::notation::Notation;
use crate::language::syntax::Expression;
use crate::report::details::{neglected, route};
use crate::report::premises::{Premises, premises};
use crate::report::refusals::{Message, Messages};
use crate::report::words;
use crate::verdict::audit::{Audit, Skipped};
use crate::verdict::claim::{Claim, Witness};

use super::ascii;
use super::pairs::{Pairs, definitions};
use super::shown::{StatementObject, statement};

#[derive(Serialize)]
struct Documents<'a> {
    documents: Vec<DocumentObject<'a>>,
    diagnostics: &'a [Message],
    /// How many mistakes are not among the diagnostics.
    diagnostics_left_out: usize,
}

#[derive(Serialize)]
struct DocumentObject<'a> {
    path: &'a str,
    title: Option<&'a str>,
    declarations: Vec<DeclarationObject<'a>>,
    assumptions: Vec<AssumptionObject<'a>>,
    /// The lines of what would be assumed and is refused.
    refused_assumptions: Vec<usize>,
    imports: Vec<ImportObject<'a>>,
    claims: Vec<ClaimObject<'a>>,
    /// The ids of the matchings, which `sextic match` shows.
    matchings: Vec<&'a str>,
    /// What the document shows.
    shown: Vec<StatementObject<'a>>,
    /// What builds on a refused statement; assertions are among the claims too.
    skipped: Vec<SkippedObject<'a>>,
    as_expected: bool,
}

/// A sign that is declared.
#[derive(Serialize)]
struct DeclarationObject<'a> {
    names: Vec<&'a str>,
    sign: &'static str,
}

#[derive(Serialize)]
struct AssumptionObject<'a> {
    line: usize,
    statement: String,
    description: Option<&'a str>,
}

#[derive(Serialize)]
struct ImportObject<'a> {
    path: &'a str,
    declarations: Vec<DeclarationObject<'a>>,
    assumptions: Vec<AssumptionObject<'a>>,
    refused_assumptions: Vec<usize>,
}

/// A statement that builds on a refused one.
#[derive(Serialize)]
pub(super) struct SkippedObject<'a> {
    line: usize,
    what: &'a str,
    reason: &'a str,
    /// The refused statement.
    rests_on: BasisObject<'a>,
}

#[derive(Serialize)]
struct BasisObject<'a> {
    /// The name that it would declare; nothing for an assumption.
    name: Option<&'a str>,
    path: &'a str,
    line: usize,
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
    /// Of a refutation, what left − right is, if that is said and so.
    #[serde(skip_serializing_if = "Option::is_none")]
    difference: Option<String>,
    witness: Option<WitnessObject<'a>>,
    reason: Option<&'a str>,
    /// Whether its certificate states it as a theorem, where that is asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    certified: Option<bool>,
    /// Whether it is undecided by a mistake of this program.
    fault: bool,
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

/// Writes the verdicts on documents, and what is wrong with them.
pub fn audits(audits: &[Audit], messages: &Messages) -> String {
    super::write(&Documents {
        documents: audits.iter().map(document).collect(),
        diagnostics: &messages.told,
        diagnostics_left_out: messages.left_out,
    })
}

fn document(audit: &Audit) -> DocumentObject<'_> {
    let (own, imports) = premises(audit);
    let imports = imports.iter().map(|import| ImportObject {
        path: import.path,
        declarations: declarations(import),
        assumptions: assumptions(import),
        refused_assumptions: import.refused.clone(),
    });
    DocumentObject {
        path: &audit.path,
        title: audit.title.as_deref(),
        declarations: declarations(&own),
        assumptions: assumptions(&own),
        refused_assumptions: own.refused.clone(),
        imports: imports.collect(),
        claims: audit.claims.iter().map(claim_object).collect(),
        matchings: matching_ids(audit).collect(),
        shown: audit.shown.iter().map(statement).collect(),
        skipped: audit.skipped.iter().map(skipped).collect(),
        as_expected: audit.as_expected(),
    }
}

fn declarations<'a>(premises: &Premises<'a>) -> Vec<DeclarationObject<'a>> {
    let signs = premises
        .signs
        .iter()
        .map(|(sign, names)| DeclarationObject {
            names: names.iter().map(|name| name.ascii.as_str()).collect(),
            sign: words::sign(*sign, Notation::Ascii),
        });
    signs.collect()
}

fn assumptions<'a>(premises: &Premises<'a>) -> Vec<AssumptionObject<'a>> {
    let assumptions = premises.assumptions.iter().map(|own| AssumptionObject {
        line: own.place.line,
        statement: Notation::Ascii.relation(&own.relation),
        description: own.description.as_deref(),
    });
    assumptions.collect()
}

/// A statement that builds on a refused one.
pub(super) fn skipped(skipped: &Skipped) -> SkippedObject<'_> {
    let basis = &skipped.basis;
    SkippedObject {
        line: skipped.line,
        what: &skipped.what,
        reason: &basis.reason,
        rests_on: BasisObject {
            name: basis.name.as_ref().map(|name| name.ascii.as_str()),
            path: &basis.place.path,
            line: basis.place.line,
        },
    }
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
        difference: claim.difference.as_ref().map(ascii),
        witness: claim.witness.as_ref().map(witness_object),
        reason: claim.reason.as_deref(),
        certified: claim.is_certified,
        fault: claim.fault,
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
