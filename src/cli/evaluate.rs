//! `sextic evaluate`: what a document derives, at one point.

use std::collections::BTreeMap;

use clap::Args;
use sextic_codegen::arithmetic::doubles;
use sextic_codegen::language::literal::Decimal;

use crate::compile::fixed::Fixed;
use crate::compile::generation::{Failure, specifications};
use crate::compile::specification::Specification;
use crate::report::evaluation::Evaluation;
use crate::report::{json, text};
use crate::verdict::audit::Audit;

use super::Outcome;
use super::generate::{FixedParser, differs, mistaken, refused, unknown};
use super::output::{Results, complain, finish, width, wrong};
use super::source::{Audited, audit_all};
use super::vocabulary::Vocabulary;

/// Computes what a document derives, at one point
///
/// The evaluators are those that `sextic generate` writes, and the numbers are the same bit for bit.
/// What the document says of an evaluator, such as where its formula may be used, stands above them.
/// Quantities are in SI units, angles in radians; `alpha_deg` is alpha in degrees, and `f_x` omega_x in
/// hertz. Numbers are decimals or fractions.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// The name of an evaluator
    #[arg(value_name = "NAME", required_unless_present = "list")]
    name: Option<String>,

    /// A quantity and its value; may be given several times
    #[arg(long, value_name = "NAME=VALUE", value_parser = FixedParser, allow_hyphen_values = true)]
    set: Vec<Fixed>,

    /// A Markdown document; without one, those that come with the command
    #[arg(long, value_name = "DOC")]
    document: Option<String>,

    /// List the evaluators, or the one that is named, with what they need and give
    #[arg(long, conflicts_with = "set")]
    list: bool,

    /// How the numbers are written
    #[arg(long, value_enum, default_value_t = Results::Text)]
    format: Results,
}

const EXAMPLES: &str = "\
Examples:
  sextic evaluate --list
  sextic evaluate no_wind_modes --set r=0.0178 --set L_g=0.004 --set omega_n=5.3 \\
    --set alpha_g=0.2 --set theta_0=0
  sextic evaluate no_wind_modes … --format json | jq .outputs";

/// Evaluates, or lists what can be evaluated.
pub fn run(arguments: &Arguments) -> Outcome {
    let Audited {
        audits, outcome, ..
    } = audit_all(arguments.document.as_slice());
    if outcome != Outcome::AsExpected {
        return mistaken(outcome);
    }
    let Some(name) = &arguments.name else {
        return list(&audits, &[], arguments.format);
    };
    let is_there = |audit: &&Audit| {
        let mut evaluators = audit.evaluators.iter();
        evaluators.any(|evaluator| evaluator.name.ascii == *name)
    };
    let Some(audit) = audits.iter().find(is_there) else {
        let evaluators = audits.iter().flat_map(|audit| &audit.evaluators);
        let known: Vec<String> = evaluators
            .map(|evaluator| evaluator.name.ascii.clone())
            .collect();
        return unknown(&format!("there is no evaluator `{name}`"), name, &known);
    };
    if arguments.list {
        let name = std::slice::from_ref(name);
        return list(std::slice::from_ref(audit), name, arguments.format);
    }
    if !audit.as_expected() {
        return differs(audit);
    }
    match evaluate(name, &arguments.set, audit) {
        Err(outcome) => outcome,
        Ok(evaluation) => {
            if !evaluation.unused.is_empty() {
                let unused = evaluation.unused.join(", ");
                complain(&format!("{name} does not need {unused}\n"));
            }
            let written = match arguments.format {
                Results::Text => text::evaluation(&evaluation, width(None)),
                Results::Json => json::evaluation(&evaluation),
            };
            finish(&written, Outcome::AsExpected)
        }
    }
}

/// The evaluators of these names; all of them if there are none.
fn list(audits: &[Audit], names: &[String], format: Results) -> Outcome {
    match specifications(audits, names, &[]) {
        Ok(all) => {
            let written = match format {
                Results::Text => text::evaluators(&all, width(None)),
                Results::Json => json::evaluators(&all),
            };
            finish(&written, Outcome::AsExpected)
        }
        Err(failure) => failed(&failure, audits),
    }
}

/// Writes why nothing can be evaluated.
pub fn failed(failure: &Failure, audits: &[Audit]) -> Outcome {
    match failure {
        Failure::Refused(evaluator, path, refusal) => refused(evaluator, path, refusal, audits),
        _ => wrong(
            "nothing can be evaluated",
            "`sextic audit` shows the document",
        ),
    }
}

/// An evaluator at a point.
fn evaluate(name: &str, set: &[Fixed], audit: &Audit) -> Result<Evaluation, Outcome> {
    let audits = std::slice::from_ref(audit);
    let specification = specifications(audits, &[name.to_string()], &[]);
    let mut specification = match specification.map(|mut found| found.pop()) {
        Ok(Some(specification)) => specification,
        Ok(None) => return Err(failed(&Failure::NoEvaluator, audits)),
        Err(failure) => return Err(failed(&failure, audits)),
    };
    let known = Vocabulary::of([audit]);
    let set: Vec<Fixed> = set.iter().map(|own| known.in_si(own)).collect();
    let values = values(&set, &specification, &known)?;
    let numbers: Vec<&Fixed> = set.iter().collect();
    specification
        .admit(&numbers)
        .map_err(|refusal| refused(name, &audit.path, &refusal, std::slice::from_ref(audit)))?;
    let evaluator = &specification.evaluator;
    let found = doubles::evaluate_at(evaluator, &values).unwrap_or_default();
    let outputs = evaluator.outputs.iter().cloned().zip(found);
    let outputs: Vec<_> = outputs.collect();
    if let Some((output, _)) = outputs.iter().find(|(_, value)| !value.is_finite()) {
        return Err(wrong(
            &format!("{} is not a finite number at this point", output.symbol),
            "`sextic evaluate --list` names the conditions; very large and very small numbers leave the \
             range of a double",
        ));
    }
    let names = specification.names().map(str::to_string);
    Ok(Evaluation {
        evaluator: name.to_string(),
        equations: evaluator.equations.clone(),
        description: evaluator.title.clone(),
        inputs: names
            .filter_map(|name| Some((name.clone(), *values.get(&name)?)))
            .collect(),
        outputs,
        unused: numbers
            .iter()
            .filter(|number| !specification.rests_on(&number.name))
            .map(|number| number.name.clone())
            .collect(),
    })
}

/// The values by name, in doubles.
fn values(
    set: &[Fixed],
    specification: &Specification,
    known: &Vocabulary,
) -> Result<BTreeMap<String, f64>, Outcome> {
    let mut values = BTreeMap::new();
    for number in set {
        let name = &number.name;
        if !specification.rests_on(name) && !known.contains(name) {
            let names: Vec<String> = known.names().cloned().collect();
            return Err(unknown(
                &format!("nothing is called `{name}`"),
                name,
                &names,
            ));
        }
        let Some(value) = Decimal::nearest(&number.value) else {
            return Err(wrong(
                &format!("`{name}={}` is beyond the range of a double", number.text),
                "quantities are in SI units",
            ));
        };
        if values.insert(name.clone(), value.value).is_some() {
            return Err(wrong(&format!("`{name}` is set twice"), "set it once"));
        }
    }
    let missing: Vec<&str> = specification
        .names()
        .filter(|name| !values.contains_key(*name))
        .collect();
    match missing[..] {
        [] => Ok(values),
        _ => Err(wrong(
            &format!(
                "{} needs {} too",
                specification.evaluator.name,
                missing.join(", ")
            ),
            "`--set name=value`; `sextic evaluate --list` says what they are",
        )),
    }
}
