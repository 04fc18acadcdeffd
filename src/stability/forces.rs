//! What the wind does to a section: its scaled damping matrix, and its stiffness.

use sextic_evaluators::aerodynamic_damping::{
    AerodynamicDampingAngles, AerodynamicDampingInputs, AerodynamicDampingOutputs,
    aerodynamic_damping,
};

use super::ball::{Ball, Balls, cosine_and_sine, quotient};
use super::scaled_damping::{Ingredients, scaled_damping};
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

/// The names of the entries of S_a by rows.
pub(super) const SCALED_DAMPING: [[&str; 3]; 3] = [
    ["S_xx", "S_xy", "S_xt"],
    ["S_yx", "S_yy", "S_yt"],
    ["S_tx", "S_ty", "S_tt"],
];

/// The names of coefficients.
const COEFFICIENTS: [[&str; 3]; 2] = [["C_D", "C_L", "C_M"], ["dC_D", "dC_L", "dC_M"]];

impl Forces {
    /// The numbers by their names.
    pub(super) fn entries(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let (names, values) = match *self {
            Forces::Coefficients(c) => {
                let (forces, slopes) = (
                    [c.drag, c.lift, c.moment],
                    [c.drag_slope, c.lift_slope, c.moment_slope],
                );
                (COEFFICIENTS.as_flattened(), [forces, slopes, [0.0; 3]])
            }
            Forces::ScaledDamping(matrix) => (SCALED_DAMPING.as_flattened(), matrix),
        };
        names.iter().copied().zip(values.into_iter().flatten())
    }
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
    /// S_a of Eq. (18), dimensionless, for the coordinates x, y and rθ: as given, or by the generated
    /// evaluator from the coefficients.
    pub fn scaled_damping(&self) -> [[f64; 3]; 3] {
        match self.parameters().forces {
            Forces::ScaledDamping(matrix) => matrix,
            Forces::Coefficients(c) => rows(aerodynamic_damping(&inputs(self, c))),
        }
    }

    /// S_a with bounds of all rounding, that of the angles' sums and of their sines included.
    pub(super) fn scaled_damping_with_bound(&self) -> [[Ball; 3]; 3] {
        let p = self.parameters();
        let c = match &p.forces {
            Forces::ScaledDamping(rows) => return rows.map(|row| row.map(Ball::exactly)),
            Forces::Coefficients(c) => c,
        };
        let lever = quotient(p.aerodynamic_centre_distance, p.radius_of_gyration);
        let centre = [p.attitude, p.aerodynamic_centre_angle, p.wind_angle];
        let of = Ingredients {
            coefficients: c.map(|own| Ball::exactly(*own)),
            kappa: quotient(p.reference_dimension, p.radius_of_gyration),
            wind: cosine_and_sine(&[p.wind_angle]),
            centre: cosine_and_sine(&centre).map(|own| lever * own),
        };
        let Ok(matrix) = scaled_damping(&of, &Balls);
        matrix
    }

    /// The column of θ of −∂F/∂(x, y, θ) over ρDU²/2, for the forces on x, y and rθ, with bounds of its
    /// rounding: how they follow the turn of the section (`derivations/extensions.md`, section 3). `None`
    /// where aerodynamic stiffness is left out.
    ///
    /// ```text
    /// −[C_D′ c − C_L′ s;  C_D′ s + C_L′ c;  κ C_M′],   c = cos α_0, s = sin α_0, κ = D/r
    /// ```
    pub(super) fn turn_stiffness_with_bound(&self) -> Option<[Ball; 3]> {
        let p = self.parameters();
        let (Forces::Coefficients(c), true) = (p.forces, p.aerodynamic_stiffness) else {
            return None;
        };
        let [drag, lift, moment] = [c.drag_slope, c.lift_slope, c.moment_slope].map(Ball::exactly);
        let [cos, sin] = cosine_and_sine(&[p.wind_angle]);
        let kappa = quotient(p.reference_dimension, p.radius_of_gyration);
        Some([
            lift * sin + -(drag * cos),
            -(drag * sin + lift * cos),
            -(kappa * moment),
        ])
    }

    /// δ = ρ D U/(2 m ω), ω that of the first free coordinate.
    pub fn relative_wind(&self) -> f64 {
        let p = self.parameters();
        let omega = p.natural_frequencies[self.free()[0].index()];
        p.air_density * p.reference_dimension * p.wind_speed / (2.0 * p.mass * omega)
    }

    /// δ|S_a| with [δ](Self::relative_wind) and the Frobenius norm of S_a: how much of itself a motion loses or
    /// gains in a radian.
    pub fn relative_aerodynamic_damping(&self) -> f64 {
        self.relative_wind() * self.scaled_damping_norm()
    }

    /// |S_a|, the Frobenius norm of [`Section::scaled_damping`].
    pub fn scaled_damping_norm(&self) -> f64 {
        let entries = self.scaled_damping();
        let squares = entries.as_flattened().iter().map(|own| own * own);
        squares.sum::<f64>().sqrt()
    }
}

fn inputs(section: &Section, c: Coefficients) -> AerodynamicDampingInputs<f64> {
    let p = section.parameters();
    AerodynamicDampingInputs::from(&AerodynamicDampingAngles {
        r: p.radius_of_gyration,
        alpha_0: p.wind_angle,
        gamma_r: p.aerodynamic_centre_angle,
        theta_0: p.attitude,
        D: p.reference_dimension,
        L_a: p.aerodynamic_centre_distance,
        C_D: c.drag,
        C_L: c.lift,
        dC_D: c.drag_slope,
        dC_L: c.lift_slope,
        C_M: c.moment,
        dC_M: c.moment_slope,
    })
}

fn rows<T>(s: AerodynamicDampingOutputs<T>) -> [[T; 3]; 3] {
    [
        [s.S_xx, s.S_xy, s.S_xt],
        [s.S_yx, s.S_yy, s.S_yt],
        [s.S_tx, s.S_ty, s.S_tt],
    ]
}
