//! Numbers with bounds.

/// A number and a bound of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// The number.
    pub value: f64,
    /// What is exact is no farther away.
    pub error: f64,
}
