//! Straight-line programs, their optimiser, and the source text that they become.
//!
//! A program knows named inputs, operations and named outputs, and nothing of the algebra that it was
//! made from.
#![forbid(unsafe_code)]
#![deny(missing_docs)]

pub mod cost;
pub mod horner;
pub mod optimiser;
pub mod program;
