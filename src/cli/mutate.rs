//! `sextic mutate`: edits that no verdict notices.

use std::collections::BTreeMap;

use clap::Args;
use indicatif::ProgressBar;
use rayon::prelude::*;

use crate::documents::resolve;
use crate::language::diagnostic::SourceFile;
use crate::report::mutation::Mutated;
use crate::report::{json, text};
use crate::verdict::audit::{Audit, Library};
use crate::verdict::mutation::{Edit, Fate, Mutation, Subject};

use super::Outcome;
use super::output::{Results, finish, wrong};
use super::progress;
use super::source::audit_all;

/// Finds what no verdict of a document would notice if it were wrong
///
/// Every edit of one token is made in definitions, substitutions, assumptions, systems and evaluators: another sign,
/// factor, index or exponent, a sine for a cosine, a name for the next of its sort and unit, a prime more or
/// less. Neighbours are exchanged, too: outputs of an evaluator, entries of a matrix, what several names are
/// defined as. What builds on an edit is judged again. It is noticed if a verdict is another one than the
/// author expects, or a statement is refused; it survives if all is as before.
/// Definitions that are equal before and after are told apart.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Markdown documents, with the imports that are to be judged too; without any, those that come with
    /// the command
    #[arg(value_name = "DOC")]
    documents: Vec<String>,

    /// How the survivors are written
    #[arg(long, value_enum, default_value_t = Results::Text)]
    format: Results,
}

const EXAMPLES: &str = "\
Examples:
  sextic mutate                    the documents that come with the command
  sextic mutate paper.md           a document of your own
  sextic mutate base.md paper.md   a document that another one imports, whose verdicts count too

Members of --format json:
  documents    path, mutants (how many edits), noticed, equal, and survivors, each with line, from,
               to and statement

Exit status:
  0  every edit is noticed, or leaves what it defines equal
  1  some survive
  2  the input is wrong, or a verdict is not as expected before anything is edited";

/// Makes the edits and writes those that survive.
pub fn run(arguments: &Arguments) -> Outcome {
    let audited = audit_all(&arguments.documents);
    if audited.outcome != Outcome::AsExpected {
        return audited.outcome;
    }
    let audits = in_order(audited.audits);
    if let Some(audit) = audits.iter().find(|own| !own.as_expected()) {
        return wrong(
            &format!(
                "{} is not as its author expects before anything is edited",
                audit.path
            ),
            "`sextic audit` shows the verdicts that differ",
        );
    }
    let library = Held::of(&audits);
    let mutation = Mutation::new(&audits, &library);
    let subjects: Vec<Vec<Subject>> = (0..audits.len())
        .map(|place| mutation.subjects(place))
        .collect();
    let edits = subjects.iter().flatten().map(|own| own.edits.len());
    let progress = progress::bar(edits.sum::<usize>() as u64, "edits");
    let found = audits.iter().zip(subjects);
    let found: Vec<Mutated> = found
        .map(|(audit, subjects)| mutated(&mutation, audit, subjects, &progress))
        .collect();
    progress.finish_and_clear();
    let outcome = match found.iter().all(|own| own.survivors.is_empty()) {
        true => Outcome::AsExpected,
        false => Outcome::Differs,
    };
    let written = match arguments.format {
        Results::Text => text::mutations(&found),
        Results::Json => json::mutations(&found),
    };
    finish(&written, outcome)
}

/// All edits of a document, whose statements these are.
fn mutated(
    mutation: &Mutation<'_>,
    audit: &Audit,
    subjects: Vec<Subject>,
    progress: &ProgressBar,
) -> Mutated {
    let fates = subjects.par_iter().map(|own| {
        let fates = mutation.fates(own);
        progress.inc(fates.len() as u64);
        fates
    });
    let fates: Vec<Fate> = fates.collect::<Vec<_>>().concat();
    let count = |wanted: Fate| fates.iter().filter(|own| **own == wanted).count();
    let [noticed, equal] = [Fate::Noticed, Fate::Equal].map(count);
    let edits = subjects.into_iter().flat_map(|own| own.edits);
    let survivors = edits.zip(&fates);
    let survivors = survivors.filter(|(_, fate)| **fate == Fate::Survives);
    let survivors: Vec<Edit> = survivors.map(|(edit, _)| edit).collect();
    Mutated {
        source: audit.source().clone(),
        mutants: fates.len(),
        noticed,
        equal,
        survivors,
    }
}

/// Documents, each behind those that it imports.
fn in_order(mut audits: Vec<Audit>) -> Vec<Audit> {
    audits.sort_by_key(|own| own.sources.len());
    audits
}

/// Documents that were read, as a library.
struct Held(BTreeMap<String, SourceFile>);

impl Held {
    fn of(audits: &[Audit]) -> Self {
        let sources = audits.iter().flat_map(|own| &own.sources);
        Held(sources.map(|own| (own.path.clone(), own.clone())).collect())
    }
}

impl Library for Held {
    fn read(&self, path: &str, from: &str) -> Result<SourceFile, String> {
        let found = self.0.get(&resolve(path, from));
        found.cloned().ok_or_else(|| "it was not read".to_string())
    }
}
