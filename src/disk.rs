//! Documents on the disk, for the command and for the Python package; nothing else of the library reads a file.

pub mod regular_file;

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::io::{self, ErrorKind};
use std::path::Path;

use crate::documents::{resolve, shipped};
use crate::language::diagnostic::{Diagnostic, SourceFile};
use crate::language::document::MAXIMUM_SIZE;
use crate::verdict::audit::Library;

/// The documents on the disk, which import each other by paths relative to themselves.
///
/// It remembers what it was asked for.
#[derive(Default)]
pub struct Disk {
    /// The paths.
    pub asked: RefCell<BTreeSet<String>>,
}

impl Library for Disk {
    fn read(&self, path: &str, from: &str) -> Result<SourceFile, String> {
        let path = resolve(path, &slashes(from));
        self.asked.borrow_mut().insert(path.clone());
        let bytes = bytes_of(&path).map_err(|error| reason(&error))?;
        SourceFile::from_bytes(path, &bytes).map_err(|error| error.message)
    }
}

/// Why nothing is read.
pub enum Unread {
    /// There is no such file, say: what is wrong, and what to do about it.
    File(String, &'static str),
    /// The file is no text.
    Text(Box<(Diagnostic, SourceFile)>),
}

/// The document in a file.
///
/// # Errors
///
/// [`Unread`]
pub fn document(path: &str) -> Result<SourceFile, Unread> {
    // Spelled as an import would spell it, so that a document that imports itself is recognised.
    source(resolve(&slashes(path), ""), path, bytes_of(path))
}

/// The document of these bytes, which were read from a path, by the name that messages call it.
///
/// # Errors
///
/// [`Unread`]
pub fn source(name: String, path: &str, bytes: io::Result<Vec<u8>>) -> Result<SourceFile, Unread> {
    let bytes = bytes.map_err(|error| unreadable(path, &error))?;
    let source = SourceFile::from_bytes(&name, &bytes);
    source.map_err(|error| {
        let shown = SourceFile::from_bytes_lossy(&name, &bytes);
        Unread::Text(Box::new((error, shown)))
    })
}

/// The bytes of a file, and one more than a document may have of a larger one.
fn bytes_of(path: &str) -> io::Result<Vec<u8>> {
    regular_file::bytes(Path::new(path), MAXIMUM_SIZE as u64 + 1)
}

fn unreadable(path: &str, error: &io::Error) -> Unread {
    let is_shipped = shipped().any(|document| document.path == path);
    let help = match error.kind() {
        ErrorKind::IsADirectory => "name the documents in it",
        _ if is_shipped => "this document comes with the command: leave its path away",
        _ => "name a Markdown document, or none for those that come with the command",
    };
    Unread::File(format!("`{path}` cannot be read: {}", reason(error)), help)
}

/// A path with the separator that documents use.
fn slashes(path: &str) -> String {
    if cfg!(windows) {
        path.replace('\\', "/")
    } else {
        path.to_owned()
    }
}

/// Why a file cannot be read or written, in a few words.
pub fn reason(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "there is no such file or folder".to_owned(),
        ErrorKind::IsADirectory => "it is a folder".to_owned(),
        ErrorKind::AlreadyExists => "it is a file".to_owned(),
        ErrorKind::NotADirectory => "a part of the path is a file".to_owned(),
        ErrorKind::PermissionDenied => "permission denied".to_owned(),
        _ => error.to_string(),
    }
}
