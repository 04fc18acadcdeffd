//! `sextic match`: polynomials matched coefficient by coefficient.

use clap::Args;

use crate::derivation::matching::Matched;
use crate::report::{json, latex, markdown, text};
use crate::verdict::audit::Audit;

use super::Outcome;
use super::output::{Format, complain, finish, width};
use super::source::{Audited, audit_all};

/// Shows the matchings of a document, power by power
///
/// A `match` of a document equates the coefficients of a known polynomial with those of an assumed
/// product, and solves for the unknowns of the product. Shown are both coefficients of every power,
/// what the solution leaves of them, what was neglected, and where the equations are singular.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A Markdown document; without one, those that come with the command
    #[arg(value_name = "DOC")]
    document: Option<String>,

    /// How the matchings are written
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    /// How many columns text may fill (at least 40); as many as the terminal has if not given
    #[arg(long, value_name = "COLUMNS", value_parser = clap::value_parser!(u16).range(40..))]
    width: Option<u16>,
}

const EXAMPLES: &str = "\
Examples:
  sextic match                          the matchings of the documents that come with the command
  sextic match paper.md                 those of a document of your own
  sextic match --format json | jq '.matchings[0].solution'";

/// Carries out the matchings of a document and writes them.
pub fn run(arguments: &Arguments) -> Outcome {
    let Audited {
        audits,
        messages,
        outcome,
        ..
    } = audit_all(arguments.document.as_slice());
    let has_none = |audit: &Audit| audit.matchings.is_empty() && audit.mistakes.is_empty();
    if !audits.is_empty() && audits.iter().all(has_none) {
        complain("the document matches no polynomials: it has no `match`\n");
    }
    for skipped in audits.iter().flat_map(|audit| &audit.skipped) {
        if skipped.what.starts_with("the matching") {
            let reason = &skipped.basis.reason;
            complain(&format!(
                "line {}: {} is skipped: it {reason}\n",
                skipped.line, skipped.what
            ));
        }
    }
    let width = width(arguments.width);
    let written = match arguments.format {
        Format::Text => joined(&audits, |path, matched| {
            text::matching(path, matched, width)
        }),
        Format::Json => json::matchings(&audits, &messages),
        Format::Markdown => joined(&audits, markdown::matching),
        Format::Latex => latex::matchings(&audits),
    };
    finish(&written, outcome)
}

/// All matchings, with an empty line between them.
fn joined(audits: &[Audit], write: impl Fn(&str, &Matched) -> String) -> String {
    let matchings = audits.iter().flat_map(|audit| {
        let matchings = audit.matchings.iter();
        matchings.map(|matched| (audit.path.as_str(), matched))
    });
    let written: Vec<String> = matchings
        .map(|(path, matched)| write(path, matched))
        .collect();
    written.join("\n")
}
