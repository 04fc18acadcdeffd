//! The integration tests, in one binary.

mod algebra;
mod command;
mod derivation;
mod paper;
mod syntax;
