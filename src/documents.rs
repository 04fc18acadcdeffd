//! The documents that come with the command.

use crate::language::diagnostic::SourceFile;
use crate::verdict::audit::Library;

/// Paths and texts, in the order in which they are audited.
const SHIPPED: &[(&str, &str)] = &[
    (
        "derivations/he-macdonald-2017.md",
        include_str!("../derivations/he-macdonald-2017.md"),
    ),
    (
        "derivations/uniform.md",
        include_str!("../derivations/uniform.md"),
    ),
    (
        "derivations/exact-modes.md",
        include_str!("../derivations/exact-modes.md"),
    ),
    (
        "derivations/extensions.md",
        include_str!("../derivations/extensions.md"),
    ),
];

/// The documents that come with the command, in the order in which they are audited.
pub fn shipped() -> impl Iterator<Item = SourceFile> {
    SHIPPED
        .iter()
        .map(|(path, text)| SourceFile::new(*path, *text))
}

/// The documents that come with the command, as a library: they import each other and nothing else.
#[derive(Clone, Copy, Debug, Default)]
pub struct ShippedLibrary;

impl Library for ShippedLibrary {
    fn read(&self, path: &str, from: &str) -> Result<SourceFile, String> {
        let wanted = resolve(path, from);
        shipped()
            .find(|document| document.path == wanted)
            .ok_or_else(|| format!("no document `{wanted}` comes with the command"))
    }
}

/// The path that a document means by a path: relative to the folder of the document itself, without
/// `.` and `..` where that can be.
pub fn resolve(path: &str, from: &str) -> String {
    let folder = from.rsplit_once('/').map_or("", |(folder, _)| folder);
    let (root, joined) = match path.strip_prefix('/') {
        Some(path) => ("/", path.to_owned()),
        None => match folder.strip_prefix('/') {
            Some(folder) => ("/", format!("{folder}/{path}")),
            None if from.starts_with('/') => ("/", path.to_owned()),
            None => ("", format!("{folder}/{path}")),
        },
    };
    let mut parts: Vec<&str> = Vec::new();
    for part in joined.split('/') {
        match part {
            "" | "." => {}
            ".." if parts.last().is_some_and(|last| *last != "..") => {
                parts.pop();
            }
            _ => parts.push(part),
        }
    }
    format!("{root}{}", parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_relative_to_the_document_that_imports() {
        for (path, from, expected) in [
            ("b.md", "a.md", "b.md"),
            ("b.md", "derivations/a.md", "derivations/b.md"),
            ("../b.md", "derivations/a.md", "b.md"),
            ("../../b.md", "derivations/a.md", "../b.md"),
            ("./c/../b.md", "/home/a.md", "/home/b.md"),
            ("b.md", "/a.md", "/b.md"),
            ("/b.md", "derivations/a.md", "/b.md"),
        ] {
            assert_eq!(resolve(path, from), expected);
        }
    }

    #[test]
    fn shipped_documents_import_only_each_other() {
        let (path, from) = ("he-macdonald-2017.md", "derivations/other.md");
        assert!(ShippedLibrary.read(path, from).is_ok());
        assert!(ShippedLibrary.read("/etc/passwd", from).is_err());
    }
}
