//! What the wind does to a section.

/// A matrix for x, y and rθ.
pub(super) type Matrix<T> = [[T; 3]; 3];

/// What is known of the forces of the wind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Forces<T = f64> {
    /// Force coefficients and their derivatives at the angle of attack.
    Coefficients(Coefficients<T>),
    /// S_a, the scaled damping matrix of Eq. (18), for the coordinates x, y and rθ: the angles of the
    /// wind and of the aerodynamic centre do not matter then.
    ScaledDamping(Matrix<T>),
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

/// Force coefficients and their derivatives by the angle of attack, per radian.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Coefficients<T = f64> {
    /// C_D.
    pub drag: T,
    /// C_L.
    pub lift: T,
    /// C_M.
    pub moment: T,
    /// C_D′, per rad.
    pub drag_slope: T,
    /// C_L′, per rad.
    pub lift_slope: T,
    /// C_M′, per rad.
    pub moment_slope: T,
}

impl<T> Coefficients<T> {
    /// The same in other numbers.
    pub fn map<U>(&self, number: impl Fn(&T) -> U) -> Coefficients<U> {
        Coefficients {
            drag: number(&self.drag),
            lift: number(&self.lift),
            moment: number(&self.moment),
            drag_slope: number(&self.drag_slope),
            lift_slope: number(&self.lift_slope),
            moment_slope: number(&self.moment_slope),
        }
    }
}

impl Coefficients {
    /// The coefficients and their derivatives by the names of a command.
    pub fn named(&self) -> [(&'static str, f64); 6] {
        [
            ("C_D", self.drag),
            ("C_L", self.lift),
            ("C_M", self.moment),
            ("dC_D", self.drag_slope),
            ("dC_L", self.lift_slope),
            ("dC_M", self.moment_slope),
        ]
    }
}

impl<T> Forces<T> {
    /// The coefficients, if they are given.
    pub fn coefficients(&self) -> Option<&Coefficients<T>> {
        match self {
            Forces::Coefficients(own) => Some(own),
            Forces::ScaledDamping(_) => None,
        }
    }
}

impl<T> From<Coefficients<T>> for Forces<T> {
    fn from(coefficients: Coefficients<T>) -> Self {
        Forces::Coefficients(coefficients)
    }
}

/// The Frobenius norm.
pub(super) fn norm(matrix: &Matrix<f64>) -> f64 {
    let squares = matrix.as_flattened().iter().map(|own| own * own);
    squares.sum::<f64>().sqrt()
}
