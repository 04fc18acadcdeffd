//! `sextic compare`: closed forms beside the eigenvalues of their systems.

use std::collections::BTreeMap;

use clap::Args;
use sextic_codegen::rounding::Interval;

use crate::compile::fixed::written;
use crate::compile::generation::{intervals, specifications};
use crate::language::evaluator::Evaluator;
use crate::language::syntax::{Approximated as Stated, Quantities};
use crate::report::closeness::FormCompared;
use crate::report::{json, text};
use crate::stability::closeness::{Approximated, ClosedForm};
use crate::stability::system::error::SystemError;
use crate::verdict::audit::Audit;

use super::Outcome;
use super::evaluate::failed;
use super::generate::{differs, mistaken};
use super::output::{Results, finish, wrong};
use super::source::{Audited, audit_all};
use super::system::{compiled, in_numbers, refuse};

/// Shows how far closed forms are from the eigenvalues of their systems
///
/// An evaluator of a document may say which numbers of a system it approximates. Both are computed at points
/// of the domain that the document states, the same in every run: the form in doubles, the eigenvalues with
/// bounds of their errors, and stability with proof.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Markdown documents; without one, those that come with the command
    #[arg(value_name = "DOC")]
    documents: Vec<String>,

    /// How many points are drawn for each closed form
    #[arg(long, value_name = "COUNT", default_value_t = USUAL_POINTS, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    points: u32,

    /// How the numbers are written
    #[arg(long, value_enum, default_value_t = Results::Text)]
    format: Results,
}

const USUAL_POINTS: u32 = 1000;

const EXAMPLES: &str = "\
In a document:
  system (3) bridge: mass M damping C stiffness K in h, a
  evaluator (7) formula: r_1 = f, r_2 = g approximates real parts of bridge
  evaluator (8) quadratic: c = [p; q], d = [s; t] approximates real parts of bridge by roots
  domain m = [1, 50], U = [1, 40]

By roots, the outputs are coefficients of a polynomial whose roots stand for the eigenvalues, here
z² + (p + i s) z + (q + i t): all real parts, that of the highest power first, then all imaginary
ones.

Errors are distances over the largest number of the system: of all real parts, where real parts are
approximated. A form is wrong about stability where the sign of its largest real part is, and the
exact verdict is certain.

Examples:
  sextic compare
  sextic compare mine.md --points 10000 --format json | jq '.forms[].errors'";

/// Compares and writes what was found.
pub fn run(arguments: &Arguments) -> Outcome {
    let Audited {
        audits, outcome, ..
    } = audit_all(&arguments.documents);
    if outcome != Outcome::AsExpected {
        return mistaken(outcome);
    }
    match all(&audits, arguments.points as usize) {
        Err(outcome) => outcome,
        Ok(forms) if forms.is_empty() => wrong(
            "no evaluator approximates a system",
            "write `evaluator … approximates real parts of NAME` for a `system` in a block",
        ),
        Ok(forms) => {
            let written = match arguments.format {
                Results::Text => text::closeness(&forms),
                Results::Json => json::closeness(&forms),
            };
            finish(&written, Outcome::AsExpected)
        }
    }
}

fn all(audits: &[Audit], points: usize) -> Result<Vec<FormCompared>, Outcome> {
    let mut forms = Vec::new();
    for audit in audits {
        if !audit.as_expected() {
            return Err(differs(audit));
        }
        for evaluator in &audit.evaluators {
            if let Some(stated) = &evaluator.approximated {
                forms.push(compare(evaluator, stated, audit, points)?);
            }
        }
    }
    Ok(forms)
}

fn compare(
    evaluator: &Evaluator,
    stated: &Stated,
    audit: &Audit,
    points: usize,
) -> Result<FormCompared, Outcome> {
    let name = evaluator.name.ascii.clone();
    let found = specifications(
        std::slice::from_ref(audit),
        std::slice::from_ref(&name),
        &[],
    );
    let mut found = found.map_err(|failure| failed(&failure, std::slice::from_ref(audit)))?;
    let form = found.remove(0).evaluator;
    // The audit refuses what approximates no system.
    let meant = audit
        .all_systems
        .iter()
        .find(|own| own.name == stated.system.value);
    let meant = meant.ok_or(Outcome::WrongInput)?;
    let system = in_numbers(compiled(meant, Some(stated), audit)?);
    let approximated = match stated.quantities {
        Quantities::RealParts => Approximated::RealParts,
        Quantities::Eigenvalues => Approximated::Eigenvalues,
    };
    let domain = intervals(audit);
    let compared = ClosedForm {
        evaluator: &form,
        approximated,
        by_roots: stated.by_roots,
        system: &system,
        domain: &domain,
    };
    let closeness = compared.closeness(points).map_err(|error| match error {
        SystemError::Missing { names } => wrong(
            &format!("{} has no interval for {}", audit.path, names.join(", ")),
            "state where each quantity lies: `domain m = [1, 50], U = [1, 40]`",
        ),
        other => refuse(&other),
    })?;
    Ok(FormCompared {
        document: audit.path.clone(),
        form: name,
        system: meant.name.ascii.clone(),
        approximated,
        by_roots: stated.by_roots,
        domain: in_words(&compared.names(), &domain),
        closeness,
    })
}

/// The intervals of quantities; those of others are angles.
fn in_words(names: &[String], domain: &BTreeMap<String, Interval>) -> String {
    let quantities = names.iter().filter_map(|name| {
        let Interval { from, to } = domain.get(name)?;
        Some(format!("{name} in [{}, {}]", written(from), written(to)))
    });
    let mut quantities: Vec<String> = quantities.collect();
    if quantities.len() < names.len() {
        quantities.push("angles all around the circle".to_string());
    }
    quantities.join(", ")
}
