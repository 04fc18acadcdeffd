//! Straight-line programs, their optimiser, and the source text that they become.
//!
//! A program knows named inputs, operations and named outputs, and nothing of the algebra that it was
//! made from. An [`Evaluator`](evaluator::Evaluator) is a program with all that its documentation says;
//! [`language::emit`] writes it.
#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod arithmetic;
pub mod cost;
pub mod evaluator;
pub mod horner;
pub mod language;
pub mod optimiser;
pub mod program;
pub mod random;
pub mod rounding;
