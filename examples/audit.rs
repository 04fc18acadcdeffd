//! Audits a document and prints the verdicts: `cargo run --example audit -- derivations/two-degrees.md`.

use std::error::Error;
use std::fs;

use sextic::documents::ShippedLibrary;
use sextic::language::diagnostic::{SourceFile, render};
use sextic::verdict::audit::audit;

/// A document that imports only what comes with the command.
const USUAL: &str = "derivations/two-degrees.md";

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or(USUAL.to_string());
    let document = SourceFile::new(path.clone(), fs::read_to_string(&path)?);
    let audit = audit(&document, &ShippedLibrary)?;
    for claim in &audit.claims {
        println!(
            "line {}: {} {}",
            claim.line,
            claim.label.written(),
            claim.verdict.text()
        );
    }
    for mistake in &audit.mistakes {
        if let Some(source) = audit.source_of(mistake) {
            print!("{}", render(&mistake.diagnostic, source, false));
        }
    }
    Ok(())
}
