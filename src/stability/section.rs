//! A section in the wind: parameters that are checked.

use super::coordinate::Coordinate;
use super::error::StabilityError;
pub use super::forces::Coefficients;
use super::forces::{Forces, norm};
use super::given::Given;
pub use super::parameters::{Open, Parameters};
use super::quantity::Quantity;

/// A section whose parameters are possible: L_g < r, m, r, D, ρ and the frequencies above 0, all finite.
///
/// ```
/// use sextic::stability::coordinate::FreeCoordinates;
/// use sextic::stability::section::{Coefficients, Parameters, Section};
///
/// let parameters = Parameters {
///     mass: 2.99,
///     radius_of_gyration: 0.014,
///     mass_centre_distance: 0.002,
///     mass_centre_angle: 0.3,
///     aerodynamic_centre_distance: 0.0,
///     aerodynamic_centre_angle: 0.0,
///     reference_dimension: 0.0325,
///     natural_frequencies: [6.28, 6.28, 6.28],
///     damping_ratios: [0.0, 0.0, 0.0],
///     air_density: 1.25,
///     wind_speed: 9.0,
///     wind_angle: 0.0,
///     attitude: 0.7,
///     forces: Coefficients { drag: 1.2, lift_slope: -3.0, ..Coefficients::default() }.into(),
///     free: FreeCoordinates::all(),
///     aerodynamic_stiffness: false,
///     open: None,
/// };
/// assert!(Section::new(parameters.clone()).is_ok());
///
/// let impossible = Parameters { mass_centre_distance: 0.02, ..parameters };
/// let error = Section::new(impossible).unwrap_err();
/// assert!(error.to_string().starts_with("L_g = 0.02 must be below r = 0.014"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section(Parameters);

impl Section {
    /// Checks the parameters.
    ///
    /// # Errors
    ///
    /// For the first parameter that is out of its range: which, its value, what it must be.
    /// [`StabilityError::StiffnessWithoutCoefficients`] if S_a is given with aerodynamic stiffness.
    pub fn new(parameters: Parameters) -> Result<Self, StabilityError> {
        let p = &parameters;
        Quantity::check_all(p)?;
        let r = p.radius_of_gyration;
        if p.mass_centre_distance >= r {
            let below = format!("below r = {r}, or the moment of inertia about G is not positive");
            return Err(Quantity::L_g.must_be(&below, p.mass_centre_distance));
        }
        if p.aerodynamic_stiffness && matches!(p.forces, Forces::ScaledDamping(_)) {
            return Err(StabilityError::StiffnessWithoutCoefficients);
        }
        Ok(Section(parameters))
    }

    /// The parameters.
    pub fn parameters(&self) -> &Parameters {
        &self.0
    }

    /// The free coordinates, in order.
    pub fn free(&self) -> &[Coordinate] {
        self.0.free.as_slice()
    }

    /// e = L_g/r, the eccentricity: at least 0, below 1.
    pub fn eccentricity(&self) -> f64 {
        self.0.small_quantities().e
    }

    /// δ = ρDU/(2mω), ω being that of the first free coordinate.
    pub fn relative_wind(&self) -> f64 {
        self.0.small_quantities().delta
    }

    /// S, the damping coefficient of a real part in 1/s, Eq. (13) and §4.2;
    /// `None` without wind, or if it is beyond the doubles.
    ///
    /// With the largest real part of all modes it is S_3D (S_2D for two free coordinates), with the
    /// error of that real part its error but for the sign. The section gallops if S_3D < 0.
    pub fn damping_coefficient(&self, real_part: f64) -> Option<f64> {
        self.0.damping_coefficient(real_part)
    }

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
