//! The second route to a verdict: expressions at assignments.
//!
//! An expression is unfolded into a graph of operations on variables, once. The graph is evaluated at
//! assignments: real numbers that are exact fractions as long as these are short, and enclosures with
//! rigorous bounds otherwise. So an angle and its sine belong together, roots may stand within roots, and
//! a difference that is seen is one.
//!
//! This route knows the syntax of documents and exact numbers, and nothing of the ring.

#![deny(clippy::float_arithmetic)]

mod angle;
pub mod assignment;
mod derivative;
mod describe;
pub mod enclosure;
pub mod evaluation;
mod failure;
mod formal;
pub mod graph;
#[cfg(test)]
mod laws;
mod matrix;
pub mod meaning;
pub mod number;
mod polynomial;
pub mod real;
mod search;
mod series;
mod sheet;
mod substitution;
pub mod table;
pub mod unfolding;

pub use failure::{Failure, NoValue, Unknown};
pub use search::{Assumed, DEGENERATE_PLACES, Purpose, Search, measured};
pub use sheet::{Salt, Sheet};
pub use table::Table;
