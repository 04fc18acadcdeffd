//! Derives and audits closed-form stability criteria, exactly.
#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod algebra;
pub mod cli;
pub mod compile;
pub mod derivation;
pub mod documents;
pub mod language;
pub mod points;
pub mod report;
#[cfg(feature = "stability")]
pub mod stability;
pub mod verdict;
