//! The integration tests, in one binary.

mod algebra;
mod syntax;
