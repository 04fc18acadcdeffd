//! The audit of the paper in process: from the text of the document to all verdicts.
#![allow(missing_docs, clippy::unwrap_used)]

use sextic::documents::{ShippedLibrary, shipped};
use sextic::verdict::audit::{Audit, audit};

fn main() {
    divan::main();
}

#[divan::bench]
fn he_macdonald_2017() -> Audit {
    let paper = shipped()
        .find(|document| document.path.ends_with("he-macdonald-2017.md"))
        .unwrap();
    audit(&paper, &ShippedLibrary).unwrap()
}
