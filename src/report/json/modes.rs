//! `{"method", "eigenvalues": [{"re", "im", "error"}…], "s3d", "verdict", "reason", "warnings": […]}`.

use serde::Serialize;

use crate::report::modes::ModesFound;

use super::write;

#[derive(Serialize)]
struct Found<'a> {
    method: &'a str,
    eigenvalues: Vec<Eigenvalue>,
    s3d: Option<f64>,
    verdict: &'a str,
    reason: String,
    warnings: &'a [String],
}

#[derive(Serialize)]
struct Eigenvalue {
    re: f64,
    im: f64,
    error: Option<f64>,
}

/// One of each pair of conjugates, in 1/s; an error of `null` is a method that bounds none.
pub fn modes(found: &ModesFound) -> String {
    let eigenvalues = found.eigenvalues.iter();
    write(&Found {
        method: found.method,
        eigenvalues: eigenvalues
            .map(|&(value, error)| Eigenvalue {
                re: value.re,
                im: value.im,
                error,
            })
            .collect(),
        s3d: found.damping_coefficient.map(|(damping, _)| damping),
        verdict: found.verdict.name(),
        reason: found.verdict.to_string(),
        warnings: &found.warnings,
    })
}
