//! A derived system in numbers: M q̈ + C q̇ + K q = 0, whose matrices are a program of its parameters.

pub(super) mod arithmetic;
mod block;
pub mod critical;
mod dense;
mod disc;
mod entries;
pub mod error;
mod evaluation;
mod gaussian;
pub mod instance;
mod jet;
#[cfg(test)]
mod laws;
mod linear_equations;
mod motion;
mod moving;
mod parameter;
mod pencil;
mod polynomial;
mod real;
pub mod spectrum;
mod state;
pub mod sweep;
mod vector;
mod verdict;

use sextic_codegen::evaluator::Evaluator;

/// A system of equations of motion M q̈ + C q̇ + K q = 0 with n coordinates q, as a document derives it.
///
/// C and K are sums of parts that may have names, such as what the structure and what the wind adds.
#[derive(Clone, Debug)]
pub struct System {
    /// The program of the matrices: its outputs are the entries of M, then those of each part of C, then
    /// those of each part of K, each matrix row by row.
    pub evaluator: Evaluator,
    /// The names of the coordinates, in order; their number is n.
    pub coordinates: Vec<String>,
    /// The names of the parts of C; a part without a name has an empty one.
    pub damping: Vec<String>,
    /// The names of the parts of K.
    pub stiffness: Vec<String>,
}

/// How many coordinates a system may have.
pub const MOST_COORDINATES: usize = 8;

/// The most rows of a state matrix.
pub(super) const MOST_ROWS: usize = 2 * MOST_COORDINATES;
