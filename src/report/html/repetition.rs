//! How everything on the page is had again.

use std::slice::from_ref;

use serde::Serialize;

use super::{CaseFiles, Request};
use crate::compile::fingerprint::fingerprint;
use crate::language::diagnostic::SourceFile;

/// Commands, and the files that they read.
#[derive(Serialize)]
pub struct Repetition {
    commands: Vec<CommandView>,
    files: Vec<FileView>,
}

#[derive(Serialize)]
struct CommandView {
    command: String,
    gives: &'static str,
}

#[derive(Serialize)]
struct FileView {
    path: String,
    what: &'static str,
    sha256: String,
}

impl Repetition {
    /// What made the page, and each part of it.
    pub fn new(request: &Request) -> Self {
        let document = argument("", request.document);
        let set = request.case.map_or(String::new(), settings);
        let mut commands = match request.audits.is_empty() {
            true => Vec::new(),
            false => of_documents(request, &document),
        };
        commands.extend(request.case.iter().flat_map(|case| of_case(case, &set)));
        let case = request.case.map(|case| case.files[0].path.as_str());
        let case = argument(" --case", case);
        let only = match request.audits.is_empty() {
            true => " --only-case",
            false => "",
        };
        commands.push((
            format!("sextic report{document}{case}{only}{set} --out report.html"),
            "this page",
        ));
        let view = |(command, gives)| CommandView { command, gives };
        Repetition {
            commands: commands.into_iter().map(view).collect(),
            files: files(request),
        }
    }
}

/// What was set, as a shell reads it.
fn settings(case: &CaseFiles) -> String {
    let set = case.comparison.case.set.iter();
    set.map(|own| {
        let assigned = format!("{}={}", own.variable.name, own.value);
        argument(" --set", Some(&assigned))
    })
    .collect()
}

fn file(source: &SourceFile, what: &'static str) -> FileView {
    FileView {
        path: source.path.clone(),
        what,
        sha256: fingerprint(from_ref(source)),
    }
}

/// An option with its value as a shell reads it; nothing where there is no value.
fn argument(option: &str, value: Option<&str>) -> String {
    value.map_or(String::new(), |value| format!("{option} {}", quoted(value)))
}

/// A word as a POSIX shell reads it.
fn quoted(word: &str) -> String {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "./_-+,=@%:".contains(letter);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

/// A command and what it gives.
type Command = (String, &'static str);

fn of_documents(request: &Request, document: &str) -> Vec<Command> {
    let mut commands = vec![
        (
            format!("sextic audit{document}"),
            "every verdict with its conditions, neglected terms and counterexamples",
        ),
        (
            format!("sextic audit{document} --explain ID"),
            "the steps behind one verdict; the ID stands below it",
        ),
    ];
    let mut audits = request.audits.iter();
    if audits.any(|audit| !audit.matchings.is_empty()) {
        commands.push((
            format!("sextic match{document}"),
            "the matching, power by power",
        ));
    }
    commands
}

fn of_case(case: &CaseFiles, set: &str) -> Vec<Command> {
    let path = argument("", Some(&case.files[0].path));
    let mut commands = vec![
        (
            format!("sextic stability{path}{set}"),
            "the unstable ranges and how the methods agree",
        ),
        (
            format!("sextic stability{path}{set} --plot curves.svg"),
            "the curves",
        ),
        (
            format!("sextic stability{path}{set} --format json"),
            "every angle with every method and the bounds of all errors",
        ),
    ];
    if case.speeds.is_ok() {
        commands.push((
            format!("sextic speeds{path}{set} --plot speeds.svg"),
            "the critical wind speeds",
        ));
    }
    if case.validity.is_ok() {
        commands.push((
            format!("sextic validity{path}{set} --plot validity.svg"),
            "the errors of the closed forms, and their maps",
        ));
    }
    commands
}

/// The documents, each once though they import each other, the case and its table.
fn files(request: &Request) -> Vec<FileView> {
    let mut files: Vec<FileView> = Vec::new();
    for source in request.audits.iter().flat_map(|audit| &audit.sources) {
        if !files.iter().any(|known| known.path == source.path) {
            files.push(file(source, "document"));
        }
    }
    if let Some(CaseFiles {
        files: [case, table],
        ..
    }) = request.case
    {
        files.push(file(case, "case"));
        files.push(file(table, "table of coefficients"));
    }
    files
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_quoted_where_a_shell_would_split_them() {
        assert_eq!(quoted("a/b-1.md"), "a/b-1.md");
        assert_eq!(quoted("my case's.toml"), r"'my case'\''s.toml'");
        assert_eq!(argument(" --case", None), "");
    }
}
