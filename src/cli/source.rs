//! Reading documents from the disk.

use std::collections::BTreeSet;
use std::io::{self, Read};

use crate::disk::{Disk, Unread, document, source};
use crate::documents::{ShippedLibrary, shipped};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind, SourceFile, render};
use crate::language::document::MAXIMUM_SIZE;
use crate::report::refusals::{MOST, Message, Messages};
use crate::report::words::counted;
use crate::verdict::audit::{Audit, Library, audit_after};

use super::Outcome;
use super::output::{complain, wrong};

/// What became of documents.
pub struct Audited {
    /// Those of which something could be read.
    pub audits: Vec<Audit>,
    /// What is wrong with them.
    pub messages: Messages,
    /// Whether something is.
    pub outcome: Outcome,
    /// Audits of earlier texts, from which those are taken that are what they would be now.
    earlier: Vec<Audit>,
    /// The paths of all that was read, or should have been.
    pub asked: BTreeSet<String>,
    /// The messages so far, since documents import each other.
    known: BTreeSet<(String, usize, String)>,
}

/// Audits the documents with these paths, or those that come with the command where there are none.
///
/// What is wrong with a document is written to standard error, and the others are audited all the same.
pub fn audit_all(paths: &[String]) -> Audited {
    audit_again(paths, Vec::new())
}

/// The same, where earlier audits are taken for documents that did not change, and import none that did.
pub fn audit_again(paths: &[String], earlier: Vec<Audit>) -> Audited {
    let mut audited = Audited {
        earlier,
        ..Audited::nothing()
    };
    if paths.is_empty() {
        shipped().for_each(|source| audited.audit(&source, &ShippedLibrary));
    }
    paths.iter().for_each(|path| audited.read(path));
    audited.tell_rest();
    audited
}

/// Audits the document with this path, or the paper that comes with the command.
///
/// What is wrong with it is written to standard error.
pub fn audit_one(path: Option<&str>) -> Audited {
    let mut audited = Audited::nothing();
    match path {
        Some(path) => audited.read(path),
        None => shipped()
            .take(1)
            .for_each(|source| audited.audit(&source, &ShippedLibrary)),
    }
    audited.tell_rest();
    audited
}

impl Audited {
    /// No document at all.
    pub fn nothing() -> Self {
        Audited {
            audits: Vec::new(),
            messages: Messages::default(),
            outcome: Outcome::AsExpected,
            earlier: Vec::new(),
            asked: BTreeSet::new(),
            known: BTreeSet::new(),
        }
    }

    /// Reads and audits a document on the disk.
    fn read(&mut self, path: &str) {
        self.asked.insert(path.to_string());
        match read(path) {
            Ok(source) => {
                let disk = Disk::default();
                self.audit(&source, &disk);
                self.asked.append(&mut disk.asked.into_inner());
            }
            Err(Unread::Text(mistake)) => self.tell(&mistake.0, &mistake.1),
            Err(Unread::File(message, help)) => {
                self.outcome = wrong(&message, help);
                self.messages.told.push(Message {
                    path: path.to_string(),
                    line: 1,
                    column: 1,
                    kind: DiagnosticKind::MissingFile.code(),
                    message,
                    help: Some(help.to_string()),
                });
            }
        }
    }

    /// Tells how many mistakes were not told.
    fn tell_rest(&self) {
        let left_out = self.messages.left_out;
        if left_out > 0 {
            complain(&format!("… and {}\n", counted(left_out, "more mistake")));
        }
    }

    fn audit(&mut self, source: &SourceFile, library: &dyn Library) {
        let audit = match self.unchanged(source, library) {
            Some(audit) => Ok(audit),
            None => audit_after(&self.audits, source, library),
        };
        match audit {
            Err(rejected) => {
                for diagnostic in &rejected.diagnostics {
                    self.tell(diagnostic, &rejected.source);
                }
            }
            Ok(audit) => {
                for mistake in &audit.mistakes {
                    if let Some(source) = audit.source_of(mistake) {
                        self.tell(&mistake.diagnostic, source);
                    }
                }
                self.audits.push(audit);
            }
        }
    }

    /// The earlier audit of a text, if neither that nor what it imports is another one now.
    fn unchanged(&mut self, source: &SourceFile, library: &dyn Library) -> Option<Audit> {
        let is_same = |own: &SourceFile| match own.path == source.path {
            true => own.text == source.text,
            false => library
                .read(&own.path, "")
                .is_ok_and(|now| now.text == own.text),
        };
        // What could not be read may be there now.
        let is_whole = |audit: &Audit| {
            let mut mistakes = audit.mistakes.iter();
            !mistakes.any(|own| own.diagnostic.kind == DiagnosticKind::MissingFile)
        };
        let is_it = |audit: &Audit| {
            audit.path == source.path && is_whole(audit) && audit.sources.iter().all(is_same)
        };
        let place = self.earlier.iter().position(is_it)?;
        Some(self.earlier.swap_remove(place))
    }

    /// Tells a mistake that was not told before.
    fn tell(&mut self, diagnostic: &Diagnostic, source: &SourceFile) {
        let place = diagnostic.span.start;
        let key = (source.path.clone(), place, diagnostic.message.clone());
        if !self.known.insert(key) {
            return;
        }
        // A disagreement of the two routes is a mistake of this program, not of the document.
        self.outcome = self.outcome.max(match diagnostic.kind {
            DiagnosticKind::Disagreement => Outcome::Differs,
            _ => Outcome::WrongInput,
        });
        if self.messages.told.len() >= MOST {
            self.messages.left_out += 1;
            return;
        }
        complain(&render(diagnostic, source, true));
        self.messages.told.push(Message::new(diagnostic, source));
    }
}

/// What stands for standard input where a document is named.
const STANDARD_INPUT: &str = "-";
/// How messages call it; what it imports is sought from the folder that one is in.
const NAME_OF_STANDARD_INPUT: &str = "standard input";

fn read(path: &str) -> Result<SourceFile, Unread> {
    match path {
        STANDARD_INPUT => source(NAME_OF_STANDARD_INPUT.to_string(), path, standard_input()),
        _ => document(path),
    }
}

/// What is written to the command, within the limit of documents.
fn standard_input() -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut limited = io::stdin().lock().take(MAXIMUM_SIZE as u64 + 1);
    limited.read_to_end(&mut bytes)?;
    Ok(bytes)
}
