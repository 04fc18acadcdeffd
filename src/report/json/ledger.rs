//! The JSON of `sextic certify`.

use serde::Serialize;

use crate::certificate::document::Certificate;

#[derive(Serialize)]
struct Ledger<'a> {
    claims: Vec<ClaimObject<'a>>,
}

#[derive(Serialize)]
struct ClaimObject<'a> {
    path: &'a str,
    id: &'a str,
    line: usize,
    /// What it is instead if it has none: `matching`, `emitted function`.
    verdict: &'static str,
    /// What kind of statement is certified; nothing if it is withheld.
    certificate: Option<&'static str>,
    /// Why it is withheld.
    reason: Option<&'a str>,
}

/// What is certified of each claim, and why the others are withheld.
pub fn ledger(certificates: &[Certificate]) -> String {
    let claims = certificates.iter().flat_map(|own| {
        own.entries.iter().map(|entry| ClaimObject {
            path: &own.path,
            id: &entry.id,
            line: entry.line,
            verdict: entry.subject.text(),
            certificate: entry.certificate.as_ref().ok().map(|kind| kind.text()),
            reason: entry.certificate.as_ref().err().map(String::as_str),
        })
    });
    super::write(&Ledger {
        claims: claims.collect(),
    })
}
