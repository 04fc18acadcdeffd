//! Edits that no verdict notices, for a terminal.

use crate::report::mutation::Mutated;
use crate::report::words::counted;

/// Letters of a statement that are shown.
const SHOWN: usize = 72;

/// For each document how many edits are noticed, and a line for each that is not, under its statement.
pub fn mutations(found: &[Mutated]) -> String {
    let documents: Vec<String> = found.iter().map(document).collect();
    documents.join("\n")
}

fn document(own: &Mutated) -> String {
    let mut text = format!(
        "{}: {} of one token; {} noticed, {} equal, {} not noticed\n",
        own.source.path,
        counted(own.mutants, "edit"),
        own.noticed,
        own.equal,
        own.survivors.len()
    );
    let mut before = String::new();
    for edit in &own.survivors {
        let statement = edit.statement(&own.source.text);
        if statement != before {
            text += &format!("  {}\n", shortened(&statement));
        }
        let to = match edit.to.is_empty() {
            true => "nothing",
            false => &edit.to,
        };
        let from = match edit.from.is_empty() {
            true => "nothing",
            false => &edit.from,
        };
        text += &format!("    line {}: {from} → {to}\n", edit.line);
        before = statement;
    }
    text
}

fn shortened(text: &str) -> String {
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{} …", &text[..end]),
        None => text.to_string(),
    }
}
