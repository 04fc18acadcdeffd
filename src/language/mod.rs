//! What a document says: Markdown, tokens, grammar, names, units, notation and mistakes.
//!
//! Nothing here knows what an expression is worth; of algebra it takes the numbers.

#![deny(clippy::float_arithmetic)]

mod blank;
pub mod built_in;
mod character;
mod cursor;
mod declaration_parser;
pub mod diagnostic;
pub mod document;
pub mod evaluator;
mod expression;
pub mod expression_parser;
pub(crate) mod foreign;
mod hidden;
pub mod intent;
mod keyword;
pub mod label;
pub(crate) mod lexer;
pub(crate) mod line_end;
pub(crate) mod look_alike;
pub mod markdown;
pub mod mention;
pub mod name;
pub mod notation;
mod statement_parser;
pub mod syntax;
pub mod system;
mod system_parser;
pub mod unit;
pub mod visit;
