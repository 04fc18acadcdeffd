//! The engine: what documents mean, and what becomes of their assertions.

mod bad_meaning;
mod conditions;
mod explosions;
mod identities;
mod matching;
mod mutants;
mod recovery;
mod two_routes;
mod verdicts;

use std::path::{Component, Path, PathBuf};

use sextic::language::diagnostic::{SourceFile, render};
use sextic::verdict::audit::{Audit, Library, Mistake, audit};

/// Documents in a folder; paths are relative to it.
pub struct Folder(pub PathBuf);

impl Library for Folder {
    fn read(&self, path: &str, from: &str) -> Result<SourceFile, String> {
        let joined = Path::new(from).parent().unwrap_or(Path::new("")).join(path);
        let mut parts: Vec<String> = Vec::new();
        for part in joined.components() {
            match part {
                Component::ParentDir => drop(parts.pop()),
                Component::Normal(name) => parts.push(name.to_string_lossy().into_owned()),
                _ => {}
            }
        }
        let name = parts.join("/");
        let text = std::fs::read_to_string(self.0.join(&name));
        text.map(|text| SourceFile::new(name, text))
            .map_err(|_| "no such file".into())
    }
}

/// What becomes of a text that imports nothing.
fn audit_text(text: &str) -> Result<Audit, String> {
    audit_in(
        &SourceFile::new("document.md", text),
        &Folder(PathBuf::new()),
    )
}

/// What becomes of a document, or what is wrong with it.
pub fn audit_in(source: &SourceFile, folder: &Folder) -> Result<Audit, String> {
    let messages: Vec<String> = match audit(source, folder) {
        Ok(audit) if audit.mistakes.is_empty() => return Ok(audit),
        Ok(audit) => {
            let render = |mistake: &Mistake| {
                let source = audit.source_of(mistake).expect("a source");
                render(&mistake.diagnostic, source, false)
            };
            audit.mistakes.iter().map(render).collect()
        }
        Err(rejected) => {
            let render = |own| render(own, &rejected.source, false);
            rejected.diagnostics.iter().map(render).collect()
        }
    };
    Err(messages.join("\n"))
}

/// A block of statements as a document.
pub fn block(statements: &str) -> String {
    format!("# Test\n\n```sextic\n{statements}\n```\n")
}

/// Where the data of the tests are.
fn data(folder: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data")
        .join(folder)
}
