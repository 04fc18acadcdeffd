//! `{"documents": [{"path", "mutants", "noticed", "equal", "survivors": [{"line", "from", "to", "statement"}]}]}`.

use serde::Serialize;

use crate::report::mutation::Mutated;
use crate::verdict::mutation::Edit;

use super::write;

#[derive(Serialize)]
struct Documents<'a> {
    documents: Vec<Document<'a>>,
}

#[derive(Serialize)]
struct Document<'a> {
    path: &'a str,
    mutants: usize,
    noticed: usize,
    equal: usize,
    survivors: Vec<Survivor<'a>>,
}

#[derive(Serialize)]
struct Survivor<'a> {
    line: usize,
    from: &'a str,
    to: &'a str,
    statement: String,
}

/// What became of the edits of documents.
pub fn mutations(found: &[Mutated]) -> String {
    let documents = found.iter().map(document).collect();
    write(&Documents { documents })
}

fn document(own: &Mutated) -> Document<'_> {
    Document {
        path: &own.source.path,
        mutants: own.mutants,
        noticed: own.noticed,
        equal: own.equal,
        survivors: own
            .survivors
            .iter()
            .map(|edit| survivor(own, edit))
            .collect(),
    }
}

fn survivor<'a>(own: &Mutated, edit: &'a Edit) -> Survivor<'a> {
    Survivor {
        line: edit.line,
        from: &edit.from,
        to: &edit.to,
        statement: edit.statement(&own.source.text),
    }
}
