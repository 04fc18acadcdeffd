//! The second route to a verdict: exact evaluation at points, sharing nothing with the first but the
//! numbers and the syntax.
//!
//! Every expression is evaluated as it stands in the document, at a point of the relations: rational
//! numbers for the parameters, rational points of the circle for the angles. Derivatives come from
//! nilpotent numbers (ε² = 0), roots and i from numbers with a given square.

mod determinant;
mod elimination;
pub mod evaluator;
pub mod number;
pub mod point;
mod sample;
mod table;
