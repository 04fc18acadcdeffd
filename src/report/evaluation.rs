//! An evaluator at one point.

use sextic_codegen::evaluator::Quantity;

/// The numbers that went in, and those that came out.
#[derive(Clone, Debug)]
pub struct Evaluation {
    /// The name of the evaluator.
    pub evaluator: String,
    /// The numbers of its equations.
    pub equations: Vec<String>,
    /// What the document says of it.
    pub description: String,
    /// The quantities that it needs, by name, in SI units.
    pub inputs: Vec<(String, f64)>,
    /// What it gives.
    pub outputs: Vec<(Quantity, f64)>,
    /// The names that were given and not needed.
    pub unused: Vec<String>,
}
