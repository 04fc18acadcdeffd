//! `{"forms": [{"document", "evaluator", "system", "approximates", "by_roots", "domain", "points", "errors": {"median",
//! "90", "99", "largest"}, "decided", "wrong_signs", "overdamped", "without_value", "worst", "first_wrong"}]}`

use serde::Serialize;

use crate::report::closeness::FormCompared;
use crate::stability::closeness::Point;

use super::pairs::Pairs;
use super::write;

#[derive(Serialize)]
struct Forms<'a> {
    forms: Vec<Form<'a>>,
}

#[derive(Serialize)]
struct Form<'a> {
    document: &'a str,
    evaluator: &'a str,
    system: &'a str,
    approximates: &'a str,
    by_roots: bool,
    domain: &'a str,
    points: usize,
    errors: Errors,
    decided: usize,
    wrong_signs: usize,
    overdamped: usize,
    without_value: usize,
    worst: Option<Pairs<String>>,
    first_wrong: Option<Pairs<String>>,
}

#[derive(Serialize)]
struct Errors {
    median: Option<f64>,
    #[serde(rename = "90")]
    nine_tenths: Option<f64>,
    #[serde(rename = "99")]
    nearly_all: Option<f64>,
    largest: Option<f64>,
}

/// The errors of closed forms, over the largest number of the system that they stand for; points as fractions.
pub fn closeness(forms: &[FormCompared]) -> String {
    write(&Forms {
        forms: forms.iter().map(form).collect(),
    })
}

fn form(found: &FormCompared) -> Form<'_> {
    let own = &found.closeness;
    Form {
        document: &found.document,
        evaluator: &found.form,
        system: &found.system,
        approximates: found.quantities(),
        by_roots: found.by_roots,
        domain: &found.domain,
        points: own.points,
        errors: Errors {
            median: own.quantile(0.5),
            nine_tenths: own.quantile(0.9),
            nearly_all: own.quantile(0.99),
            largest: own.quantile(1.0),
        },
        decided: own.decided,
        wrong_signs: own.wrong_signs,
        overdamped: own.overdamped,
        without_value: own.without_value,
        worst: own.worst.as_ref().map(fractions),
        first_wrong: own.first_wrong.as_ref().map(fractions),
    }
}

fn fractions(point: &Point) -> Pairs<String> {
    let quantities = point.iter();
    Pairs(
        quantities
            .map(|(name, value)| (name.clone(), value.to_string()))
            .collect(),
    )
}
