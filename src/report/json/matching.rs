//! The JSON of `sextic match`.

use serde::Serialize;

use crate::derivation::matching::{Matched, Neglected, Row, Singularity};
use crate::language::notation::Notation;
use crate::report::refusals::{Message, Messages};
use crate::report::words;
use crate::verdict::audit::Audit;

use super::ascii;
use super::audit::{SkippedObject, skipped};
use super::pairs::{Pairs, definitions, pairs};

#[derive(Serialize)]
struct Matchings<'a> {
    matchings: Vec<MatchingObject<'a>>,
    /// What builds on a refused statement, by document.
    skipped: Vec<SkippedIn<'a>>,
    diagnostics: &'a [Message],
    /// How many mistakes are not among the diagnostics.
    diagnostics_left_out: usize,
}

#[derive(Serialize)]
struct SkippedIn<'a> {
    path: &'a str,
    statements: Vec<SkippedObject<'a>>,
}

#[derive(Serialize)]
struct MatchingObject<'a> {
    id: &'a str,
    equation: Option<&'a str>,
    name: &'a str,
    path: &'a str,
    line: usize,
    description: Option<&'a str>,
    variable: &'a str,
    exact: String,
    assumed: String,
    definitions: Pairs,
    unknowns: Vec<&'a str>,
    powers: &'a [u32],
    solution: Pairs,
    determinant: String,
    singular_where: Vec<String>,
    /// Whether the solution certainly stays finite wherever the linear equations are singular.
    finite: bool,
    singularities: Vec<SingularityObject>,
    neglected: Vec<String>,
    neglected_terms: Vec<NeglectedObject>,
    small: Vec<&'a str>,
    table: Vec<RowObject>,
}

#[derive(Serialize)]
struct SingularityObject {
    factor: String,
    finite: bool,
}

#[derive(Serialize)]
struct NeglectedObject {
    expression: String,
    power: u32,
    factor: String,
}

#[derive(Serialize)]
struct RowObject {
    power: u32,
    exact: String,
    assumed: String,
    residual: String,
    order: Option<u32>,
    used: bool,
}

/// Writes the matchings of documents.
pub fn matchings(audits: &[Audit], messages: &Messages) -> String {
    let matchings = audits.iter().flat_map(|audit| {
        audit
            .matchings
            .iter()
            .map(|matched| matching_object(&audit.path, matched))
    });
    let is_worse = |audit: &&Audit| !audit.skipped.is_empty();
    let worse = audits.iter().filter(is_worse).map(|audit| SkippedIn {
        path: &audit.path,
        statements: audit.skipped.iter().map(skipped).collect(),
    });
    super::write(&Matchings {
        matchings: matchings.collect(),
        skipped: worse.collect(),
        diagnostics: &messages.told,
        diagnostics_left_out: messages.left_out,
    })
}

fn matching_object<'a>(path: &'a str, matched: &'a Matched) -> MatchingObject<'a> {
    let singular = matched.singular_where.iter();
    MatchingObject {
        id: &matched.label.id,
        equation: matched.label.equation.as_deref(),
        name: &matched.name.ascii,
        path,
        line: matched.line,
        description: matched.description.as_deref(),
        variable: &matched.variable.ascii,
        exact: ascii(&matched.polynomials.0),
        assumed: ascii(&matched.polynomials.1),
        definitions: definitions(&matched.definitions),
        unknowns: matched
            .solution
            .iter()
            .map(|(name, _)| name.ascii.as_str())
            .collect(),
        powers: &matched.powers,
        solution: pairs(&matched.solution),
        determinant: ascii(&matched.determinant),
        singular_where: singular
            .clone()
            .map(|singularity| words::singularity(singularity, Notation::Ascii))
            .collect(),
        finite: singular.clone().all(Singularity::is_finite),
        singularities: singular.map(singularity_object).collect(),
        neglected: matched
            .neglected
            .iter()
            .map(|one| ascii(&one.expression))
            .collect(),
        neglected_terms: matched.neglected.iter().map(neglected_object).collect(),
        small: matched
            .small
            .iter()
            .map(|name| name.ascii.as_str())
            .collect(),
        table: matched.table.iter().map(row_object).collect(),
    }
}

fn singularity_object(singularity: &Singularity) -> SingularityObject {
    SingularityObject {
        factor: ascii(&singularity.factor),
        finite: singularity.is_finite(),
    }
}

fn neglected_object(neglected: &Neglected) -> NeglectedObject {
    NeglectedObject {
        expression: ascii(&neglected.expression),
        power: neglected.power,
        factor: ascii(&neglected.factor),
    }
}

fn row_object(row: &Row) -> RowObject {
    RowObject {
        power: row.power,
        exact: ascii(&row.exact),
        assumed: ascii(&row.assumed),
        residual: ascii(&row.residual),
        order: row.order,
        used: row.used,
    }
}
