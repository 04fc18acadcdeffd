//! Closed forms beside the eigenvalues of their systems.

use crate::stability::closeness::{Approximated, Closeness};

/// A closed form of a document, and how far it is from its system.
#[derive(Clone, Debug)]
pub struct FormCompared {
    /// The document.
    pub document: String,
    /// The evaluator.
    pub form: String,
    /// The system.
    pub system: String,
    /// What the outputs of the evaluator stand for.
    pub approximated: Approximated,
    /// Whether they are the coefficients of a polynomial whose roots do.
    pub by_roots: bool,
    /// The intervals that the points are drawn from, in words.
    pub domain: String,
    /// How far it is.
    pub closeness: Closeness,
}

impl FormCompared {
    /// `real parts` or `eigenvalues`.
    pub fn quantities(&self) -> &'static str {
        match self.approximated {
            Approximated::RealParts => "real parts",
            Approximated::Eigenvalues => "eigenvalues",
        }
    }
}
