//! The integration tests, in one binary.

mod adversary;
mod algebra;
mod certificate;
mod command;
mod compile;
mod derivation;
mod documentation;
mod fuzz;
mod paper;
#[cfg(feature = "stability")]
mod stability;
mod syntax;
