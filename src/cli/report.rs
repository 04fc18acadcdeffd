//! `sextic report`: a derivation and a case as one page.

use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PathBufValueParser, TypedValueParser};

use crate::certificate::document::mark;
use crate::compile::fixed::Fixed;
use crate::report::gallery::of_case;
use crate::report::html::{self, CaseFiles, Request};
use crate::report::speeds::SpeedsFound;
use crate::report::summary::Summary;
use crate::stability::comparison::compare;
use crate::stability::critical_speed::speeds_of;
use crate::stability::validity::validity;

use super::Outcome;
use super::case::{refuse, set_case_and_files};
use super::file::{promising, spare, write_made};
use super::generate::FixedParser;
use super::output::{complain, finish, wrong};
use super::source::{Audited, audit_all};
use super::speeds::USUAL_HIGHEST;

/// Writes a derivation, its verdicts and a case as one HTML file
///
/// The page has the prose of the document, its equations typeset, every assertion with its verdict,
/// conditions, neglected terms or counterexample, the matching, and with `--case` the curves of a section,
/// where it gallops, how the methods agree, its critical wind speeds, and where the closed forms may be
/// trusted. It names the commands and the SHA-256 of the files that give each number again. It needs no
/// network and no script.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A Markdown document; without one, those that come with the command
    #[arg(value_name = "DOC")]
    document: Option<String>,

    /// A case file: `sextic stability --help` shows one
    #[arg(long, value_name = "CASE.toml")]
    case: Option<PathBuf>,

    /// Leave the documents out: the page is about the case alone
    #[arg(long, requires = "case", conflicts_with = "document")]
    only_case: bool,

    /// A quantity of the case, by a name of `sextic sweep`, and its value; may be given several times
    #[arg(long, value_name = "NAME=VALUE", value_parser = FixedParser, allow_hyphen_values = true, requires = "case")]
    set: Vec<Fixed>,

    /// The file to write
    #[arg(long, value_name = "FILE.html", value_parser = PathBufValueParser::new().try_map(html))]
    out: PathBuf,
}

fn html(path: PathBuf) -> Result<PathBuf, String> {
    promising("html", path)
}

const EXAMPLES: &str = "\
Examples:
  sextic report --out report.html                     the documents that come with the command
  sextic report --case case.toml --out report.html    and a case
  sextic report --case case.toml --only-case --out case.html
  sextic report paper.md --out paper.html             a document of your own

Exit status:
  0  the report is written, and all is as the document expects
  1  the report is written, and a verdict differs
  2  the input is wrong, where the report shows what is skipped; or the file cannot be written";

/// Writes the report.
pub fn run(arguments: &Arguments) -> Outcome {
    let document = arguments.document.as_deref();
    if let Some(case) = document.filter(|own| own.ends_with(".toml")) {
        return wrong(
            &format!("{case} is a case and no document"),
            &format!(
                "`sextic report --case {case} --only-case --out case.html` is a page about it alone"
            ),
        );
    }
    // The case is read first: it is quickly refused.
    let case = arguments.case.as_ref().map(|path| {
        let (case, table, files) =
            set_case_and_files(path, &arguments.set, std::slice::from_ref(&arguments.out))?;
        let comparison = compare(&case, &table).map_err(|error| refuse(&error))?;
        let gallery = of_case(&comparison, &table).map_err(|error| refuse(&error))?;
        let found = |angles| SpeedsFound {
            angles,
            case: case.clone(),
            highest: USUAL_HIGHEST,
        };
        // That the speed twists the section is no reason against the rest of the page.
        let speeds = match speeds_of(&case, &table, USUAL_HIGHEST) {
            Err(error) if case.is_twisted() => Err(error.what),
            other => Ok(found(other.map_err(|error| refuse(&error))?)),
        };
        // That a coordinate is held is no reason against the rest of the page.
        let validity = validity(&case, &table).map_err(|error| error.what);
        Ok(CaseFiles {
            comparison,
            figures: gallery.figures,
            speeds,
            validity,
            files,
        })
    });
    let case = match case.transpose() {
        Ok(case) => case,
        Err(outcome) => return outcome,
    };
    let Audited {
        mut audits,
        mut outcome,
        ..
    } = match arguments.only_case {
        true => Audited::nothing(),
        false => audit_all(arguments.document.as_slice()),
    };
    if audits.is_empty() && !arguments.only_case {
        return outcome;
    }
    audits.iter_mut().for_each(mark);
    let request = Request {
        document: arguments.document.as_deref(),
        audits: &audits,
        case: case.as_ref(),
        version: env!("CARGO_PKG_VERSION"),
    };
    let path = &arguments.out;
    let sources = audits.iter().flat_map(|audit| &audit.sources);
    let read: Vec<&Path> = sources.map(|own| Path::new(&own.path)).collect();
    if let Err(outcome) = spare(path, &read).and_then(|()| write_made(path, html::page(&request))) {
        return outcome;
    }
    for audit in audits.iter().filter(|audit| !audit.as_expected()) {
        outcome = outcome.max(Outcome::Differs);
        complain(&format!(
            "{}: {}\n",
            audit.path,
            Summary::new(audit).conclusion()
        ));
    }
    finish(&format!("{}\n", path.display()), outcome)
}
