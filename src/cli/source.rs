//! Reading documents from the disk.

use std::fs;
use std::io::{ErrorKind, Read};

use crate::derivation::audit::{Audit, Library, Rejected, audit_after};
use crate::derivation::diagnostic::SourceFile;
use crate::derivation::document::MAXIMUM_SIZE;
use crate::documents::{ShippedLibrary, resolve, shipped};

use super::Outcome;
use super::output::{reason, reject, wrong};

/// Audits the documents with these paths, or those that come with the command where there are none.
///
/// What is wrong with a document is written to standard error, and the others are audited all the same.
pub fn audit_all(paths: &[String]) -> (Vec<Audit>, Outcome) {
    let mut audits = Vec::new();
    let mut outcome = Outcome::AsExpected;
    let mut take = |source: Result<SourceFile, Outcome>, library: &dyn Library| {
        let audited = source.and_then(|source| {
            audit_after(&audits, &source, library).map_err(|rejected| reject(&rejected))
        });
        match audited {
            Ok(audit) => audits.push(audit),
            Err(failed) => outcome = outcome.max(failed),
        }
    };
    if paths.is_empty() {
        shipped().for_each(|source| take(Ok(source), &ShippedLibrary));
    }
    for path in paths {
        take(read(path), &Disk);
    }
    (audits, outcome)
}

/// The documents on the disk, which import each other by paths relative to themselves.
struct Disk;

impl Library for Disk {
    fn read(&self, path: &str, from: &str) -> Result<SourceFile, String> {
        let path = resolve(path, &slashes(from));
        let bytes = bytes_of(&path).map_err(|error| reason(&error))?;
        SourceFile::from_bytes(path, &bytes).map_err(|error| error.message)
    }
}

fn read(path: &str) -> Result<SourceFile, Outcome> {
    // Spelled as an import would spell it, so that a document that imports itself is recognised.
    let name = resolve(&slashes(path), "");
    let bytes = bytes_of(path).map_err(|error| unreadable(path, &error))?;
    SourceFile::from_bytes(&name, &bytes).map_err(|error| {
        let source = SourceFile::from_bytes_lossy(&name, &bytes);
        reject(&Rejected {
            source,
            diagnostics: vec![error],
        })
    })
}

/// The bytes of a file, and one more than a document may have of a larger one.
fn bytes_of(path: &str) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let file = fs::File::open(path)?;
    file.take(MAXIMUM_SIZE as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn unreadable(path: &str, error: &std::io::Error) -> Outcome {
    let is_shipped = shipped().any(|document| document.path == path);
    let help = match error.kind() {
        ErrorKind::IsADirectory => "name the documents in it",
        _ if is_shipped => "this document comes with the command: leave its path away",
        _ => "name a Markdown document, or none for those that come with the command",
    };
    wrong(&format!("`{path}` cannot be read: {}", reason(error)), help)
}

/// A path with the separator that documents use.
fn slashes(path: &str) -> String {
    if cfg!(windows) {
        path.replace('\\', "/")
    } else {
        path.to_owned()
    }
}
