//! What the wind does to a section.

use super::given::Given;
use super::section::{Coefficients, Section};

/// What is known of the forces of the wind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Forces<T = f64> {
    /// Force coefficients and their derivatives at the angle of attack.
    Coefficients(Coefficients<T>),
    /// S_a, the scaled damping matrix of Eq. (18), for the coordinates x, y and rθ: the angles of the
    /// wind and of the aerodynamic centre do not matter then.
    ScaledDamping([[T; 3]; 3]),
}

impl<T> Forces<T> {
    /// The same in other numbers.
    pub(super) fn map<U>(&self, number: &impl Fn(&T) -> U) -> Forces<U> {
        match self {
            Forces::Coefficients(c) => Forces::Coefficients(c.map(number)),
            Forces::ScaledDamping(rows) => {
                Forces::ScaledDamping(rows.each_ref().map(|row| row.each_ref().map(number)))
            }
        }
    }
}

impl<T: Default> Default for Forces<T> {
    /// None.
    fn default() -> Self {
        Forces::Coefficients(Coefficients::default())
    }
}

impl<T> From<Coefficients<T>> for Forces<T> {
    fn from(coefficients: Coefficients<T>) -> Self {
        Forces::Coefficients(coefficients)
    }
}

impl Section {
    /// S_a of Eq. (18), dimensionless, for the coordinates x, y and rθ: as given, or from the coefficients.
    pub fn scaled_damping(&self) -> [[f64; 3]; 3] {
        Given::of(self.parameters()).scaled_damping()
    }

    /// δ|S_a| with [δ](Self::relative_wind) and the Frobenius norm of S_a: how much of itself a motion loses or
    /// gains in a radian.
    pub fn relative_aerodynamic_damping(&self) -> f64 {
        self.relative_wind() * self.scaled_damping_norm()
    }

    /// |S_a|, the Frobenius norm of [`Section::scaled_damping`].
    pub fn scaled_damping_norm(&self) -> f64 {
        norm(&self.scaled_damping())
    }
}

/// The Frobenius norm.
pub(super) fn norm(matrix: &[[f64; 3]; 3]) -> f64 {
    let squares = matrix.as_flattened().iter().map(|own| own * own);
    squares.sum::<f64>().sqrt()
}
