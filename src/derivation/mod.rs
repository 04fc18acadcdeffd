//! A document becomes statements, statements become verdicts.

pub mod assertion;
pub mod audit;
pub mod condition;
mod cursor;
mod declaration_parser;
pub mod diagnostic;
pub mod document;
pub mod elaboration;
pub mod evaluation;
pub mod expression_parser;
mod foundation;
pub mod function;
mod judge;
pub mod label;
mod lexer;
pub mod markdown;
pub mod matching;
pub mod name;
pub mod notation;
pub mod presentation;
pub mod quantity;
pub mod scope;
mod statement_parser;
pub mod syntax;
pub mod unit;
pub mod verdict;
mod visit;
