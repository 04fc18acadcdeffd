//! A matching of coefficients, power by power.

use serde::Serialize;

use super::mathematics::{expression, formula, phrase};
use crate::derivation::matching::{Matched, Row};
use crate::language::notation::Notation;
use crate::report::{residuals, words};

const NOTATION: Notation = Notation::Latex;

/// What the template is given of a matching; formulas are HTML.
#[derive(Serialize)]
pub struct MatchingView {
    anchor: String,
    label: String,
    name: String,
    description: Option<String>,
    line: usize,
    exact: String,
    assumed: String,
    warning: Option<&'static str>,
    table: Vec<RowView>,
    neglected: Vec<NeglectedView>,
    determinant: String,
    singularities: Vec<SingularityView>,
    solution: Vec<String>,
}

#[derive(Serialize)]
struct RowView {
    power: String,
    used: bool,
    exact: String,
    assumed: String,
    residual: Option<String>,
    remainder: String,
}

#[derive(Serialize)]
struct NeglectedView {
    expression: String,
    power: String,
    factor: String,
}

#[derive(Serialize)]
struct SingularityView {
    place: String,
    consequence: &'static str,
}

impl MatchingView {
    /// A matching of the document whose anchors begin with `prefix`.
    pub fn new(matched: &Matched, prefix: &str) -> Self {
        let (exact, assumed) = words::polynomials(matched, NOTATION);
        let power = |power| formula(&words::power(matched, power, NOTATION));
        let neglected = matched.neglected.iter().map(|one| NeglectedView {
            expression: expression(&one.expression),
            power: power(one.power),
            factor: expression(&one.factor),
        });
        let singularities = matched.singular_where.iter().map(|one| SingularityView {
            place: formula(&words::singularity(one, NOTATION)),
            consequence: words::at_singularity(one),
        });
        let solution = matched.solution.iter().map(|(name, value)| {
            let value = NOTATION.expression(value);
            formula(&format!("{} = {value}", NOTATION.name(name)))
        });
        MatchingView {
            anchor: format!("{prefix}-matching-{}", matched.label.id),
            label: words::label(&matched.label),
            name: matched.name.unicode.clone(),
            description: matched.description.clone(),
            line: matched.line,
            exact: formula(&exact),
            assumed: formula(&assumed),
            warning: residuals::warning(matched),
            table: matched.table.iter().map(|one| row(matched, one)).collect(),
            neglected: neglected.collect(),
            determinant: expression(&matched.determinant),
            singularities: singularities.collect(),
            solution: solution.collect(),
        }
    }
}

fn row(matched: &Matched, row: &Row) -> RowView {
    RowView {
        power: formula(&words::power(matched, row.power, NOTATION)),
        used: row.used,
        exact: expression(&row.exact),
        assumed: expression(&row.assumed),
        residual: (!words::is_zero(&row.residual)).then(|| expression(&row.residual)),
        remainder: phrase(&words::remainder(matched, row, NOTATION)),
    }
}
