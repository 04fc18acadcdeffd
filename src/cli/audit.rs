//! `sextic audit`: the verdicts on documents.

use std::collections::{BTreeMap, BTreeSet};
use std::time::{Duration, SystemTime};

use clap::Args;

use crate::certificate::document::mark;
use crate::derivation::matching::Matched;
use crate::report::{json, latex, markdown, text, words};
use crate::verdict::audit::Audit;
use crate::verdict::claim::Claim;

use super::Outcome;
use super::output::{Format, finish, stream, unwritten, width, wrong};
use super::source::{Audited, audit_again, audit_all};

/// How often documents that are watched are looked at.
const LOOK: Duration = Duration::from_millis(100);

/// How many identifiers are suggested for a misspelt one.
const SUGGESTIONS: usize = 3;
/// How alike a suggestion must be, from 0 to 1.
const LEAST_LIKENESS: f64 = 0.6;

/// Gives a verdict on every assertion of a document
///
/// Every `claim`, `eigenpair`, `refute`, `approximate` and `ill-formed` of a document is decided twice: by comparing
/// normal forms, and by exact evaluation at random points. A verdict names the conditions that its
/// steps needed, what an approximation leaves out, or a point at which the two sides differ. A mistake
/// in a statement is told with its place; what builds on that statement is skipped, and all else is judged.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Markdown documents, `-` for standard input; without any, those that come with the command
    #[arg(value_name = "DOC")]
    documents: Vec<String>,

    /// How the verdicts are written
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    /// Show the steps behind one verdict, by the id or the label of its assertion
    #[arg(long, value_name = "ID")]
    explain: Option<String>,

    /// Mark with ⊢ what has a theorem that Coq can check (see `sextic certify`)
    #[arg(long)]
    certified: bool,

    /// Judge documents again whenever they change, until the command is interrupted; one that did not change, and
    /// imports none that did, is not judged again
    #[arg(long, conflicts_with = "explain")]
    watch: bool,

    /// How many columns text may fill (at least 40); as many as the terminal has if not given
    #[arg(long, value_name = "COLUMNS", value_parser = clap::value_parser!(u16).range(40..))]
    width: Option<u16>,
}

const EXAMPLES: &str = "\
Examples:
  sextic audit                          the documents that come with the command
  sextic audit paper.md                 a document of your own
  sextic audit paper.md --watch         the same whenever it is saved
  sextic audit --certified              which verdicts have theorems for Coq
  sextic audit --explain 12             how the verdict on equation (12) was reached
  sextic audit --format json | jq '.documents[].claims[] | select(.verdict == \"refuted\") | .id'";

/// Audits documents and writes the verdicts.
pub fn run(arguments: &Arguments) -> Outcome {
    if arguments.watch {
        return watch(arguments);
    }
    let mut audited = audit_all(&arguments.documents);
    if arguments.certified {
        audited.audits.iter_mut().for_each(mark);
    }
    match &arguments.explain {
        Some(wanted) => explain(wanted, &audited.audits, audited.outcome, arguments),
        None => write(&audited, arguments).0,
    }
}

/// Judges documents whenever they change, as long as somebody reads that.
fn watch(arguments: &Arguments) -> Outcome {
    let paths = &arguments.documents;
    if paths.is_empty() || paths.iter().any(|path| path == "-") {
        return wrong(
            "what comes with the command, or from standard input, does not change",
            "name the documents that are to be watched",
        );
    }
    let mut earlier = Vec::new();
    let mut asked: BTreeSet<String> = paths.iter().cloned().collect();
    loop {
        let before = stamps(&asked);
        let mut audited = audit_again(paths, earlier);
        if arguments.certified {
            audited.audits.iter_mut().for_each(mark);
        }
        let (outcome, is_read) = write(&audited, arguments);
        if !is_read {
            return outcome;
        }
        (earlier, asked) = (audited.audits, audited.asked);
        let seen = stamps(&asked);
        let differs = |(path, own)| seen.get(path).is_some_and(|now| now != own);
        // What was saved meanwhile may not have been read.
        let is_late = before.iter().any(differs);
        while !is_late && stamps(&asked) == seen {
            std::thread::sleep(LOOK);
        }
    }
}

/// When files were written last, and how long they are; nothing for those that are not there.
fn stamps(paths: &BTreeSet<String>) -> BTreeMap<String, Option<(SystemTime, u64)>> {
    let stamp = |path: &String| {
        let found = std::fs::metadata(path).ok()?;
        Some((found.modified().ok()?, found.len()))
    };
    let all = paths.iter();
    all.map(|path| (path.clone(), stamp(path))).collect()
}

/// Writes the verdicts: the outcome, and whether more of them would be read.
fn write(audited: &Audited, arguments: &Arguments) -> (Outcome, bool) {
    let Audited {
        audits, messages, ..
    } = audited;
    let mut outcome = audited.outcome;
    if !audits.iter().all(Audit::as_expected) {
        outcome = outcome.max(Outcome::Differs);
    }
    let width = width(arguments.width);
    let written = match arguments.format {
        Format::Text => joined(audits.iter().map(|audit| text::audit(audit, width))),
        Format::Json => json::audits(audits, messages),
        Format::Markdown => joined(audits.iter().map(markdown::audit)),
        Format::Latex => latex::audits(audits),
    };
    match stream(&written) {
        Ok(is_read) => (outcome, is_read),
        Err(error) => (outcome.max(unwritten(&error)), false),
    }
}

fn explain(wanted: &str, audits: &[Audit], outcome: Outcome, arguments: &Arguments) -> Outcome {
    let id = identifier(wanted);
    let claims = || {
        audits
            .iter()
            .flat_map(|audit| audit.claims.iter().map(move |claim| (audit, claim)))
    };
    let found: Vec<(&Audit, &Claim)> = claims().filter(|(_, claim)| claim.label.id == id).collect();
    if found.is_empty() {
        // Where no document could be read, its diagnostics have said all.
        if audits.is_empty() {
            return outcome;
        }
        if let Some(matched) = matchings(audits).find(|matched| matched.label.id == id) {
            let label = words::label(&matched.label);
            return wrong(
                &format!("{label} is a matching, not an assertion"),
                "`sextic match` shows it",
            );
        }
        let known = claims().map(|(_, claim)| claim.label.id.as_str());
        let known = known.chain(matchings(audits).map(|matched| matched.label.id.as_str()));
        return unknown(wanted, &nearest_identifiers(&id, known));
    }
    let width = width(arguments.width);
    let is_expected = found.iter().all(|(_, claim)| claim.as_expected());
    let outcome = if is_expected {
        outcome
    } else {
        outcome.max(Outcome::Differs)
    };
    let explanations = found.into_iter();
    let written = match arguments.format {
        Format::Text => {
            joined(explanations.map(|(audit, claim)| text::explanation(audit, claim, width)))
        }
        Format::Json => explanations
            .map(|(audit, claim)| json::explanation(audit, claim))
            .collect(),
        Format::Markdown | Format::Latex => {
            return wrong(
                "an explanation has no such format",
                "use `--format text` or `json`",
            );
        }
    };
    finish(&written, outcome)
}

fn matchings(audits: &[Audit]) -> impl Iterator<Item = &Matched> {
    audits.iter().flat_map(|audit| &audit.matchings)
}

/// The identifier that is meant by an identifier or by a label, with its brackets or without.
fn identifier(wanted: &str) -> String {
    let inner = wanted.trim().trim_matches(['(', ')', '[', ']']);
    let words = inner.split(|letter: char| !letter.is_alphanumeric() && letter != '.');
    let words: Vec<String> = words
        .filter(|word| !word.is_empty())
        .map(str::to_lowercase)
        .collect();
    words.join("-")
}

fn unknown(wanted: &str, near: &[&str]) -> Outcome {
    let help = match near {
        [] => "`sextic audit --format json` lists all ids".to_owned(),
        near => format!("did you mean {}?", near.join(", ")),
    };
    wrong(&format!("no assertion is called `{wanted}`"), &help)
}

/// The identifiers most like a misspelt one, the most likely first.
fn nearest_identifiers<'a>(
    wanted: &str,
    identifiers: impl Iterator<Item = &'a str>,
) -> Vec<&'a str> {
    let mut near: Vec<(f64, &str)> = identifiers
        .map(|identifier| (strsim::jaro_winkler(wanted, identifier), identifier))
        .filter(|(likeness, _)| *likeness >= LEAST_LIKENESS)
        .collect();
    near.sort_by(|(left, _), (right, _)| right.total_cmp(left));
    near.into_iter()
        .map(|(_, identifier)| identifier)
        .take(SUGGESTIONS)
        .collect()
}

/// Texts with an empty line between them.
fn joined(texts: impl Iterator<Item = String>) -> String {
    texts.collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_accepted_for_identifiers() {
        for wanted in ["8-printed", "(8, printed)", "8, printed"] {
            assert_eq!(identifier(wanted), "8-printed");
        }
        assert_eq!(identifier("[centre of mode 1]"), "centre-of-mode-1");
        assert_eq!(identifier("A.3"), "a.3");
    }

    #[test]
    fn the_nearest_identifiers_come_first() {
        let identifiers = ["8", "8-printed", "den-hartog", "18-printed"];
        let near = nearest_identifiers("8-prnted", identifiers.into_iter());
        assert_eq!(near.first(), Some(&"8-printed"));
        assert!(!near.contains(&"den-hartog"));
    }
}
