//! A section in the wind: its parameters, checked.

use super::coordinate::{Coordinate, FreeCoordinates};
use super::error::StabilityError;
use super::forces::Forces;
use super::quantity::Quantity;

/// The parameters of a section in the wind, in SI units and radians; nothing is checked yet.
///
/// Frequencies and damping ratios stand in the order x, y, θ. Those of a coordinate that is held
/// are not used. The numbers are doubles, or exact ones.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parameters<T = f64> {
    /// m: mass per unit length, in kg/m.
    pub mass: T,
    /// r: radius of gyration about the elastic centre O, in m.
    pub radius_of_gyration: T,
    /// L_g: distance of the mass centre G from O, in m.
    pub mass_centre_distance: T,
    /// α_g: angle of G from the reference line, in rad.
    pub mass_centre_angle: T,
    /// L_a: distance of the aerodynamic centre A from O, in m.
    pub aerodynamic_centre_distance: T,
    /// γ_r: angle of A from the reference line, in rad.
    pub aerodynamic_centre_angle: T,
    /// D: reference dimension, in m.
    pub reference_dimension: T,
    /// ω_x, ω_y, ω_θ: circular natural frequencies of the uncoupled motions, in rad/s.
    pub natural_frequencies: [T; 3],
    /// ζ_x, ζ_y, ζ_θ: structural damping ratios.
    pub damping_ratios: [T; 3],
    /// ρ: density of air, in kg/m³.
    pub air_density: T,
    /// U: wind speed, in m/s; may be 0.
    pub wind_speed: T,
    /// α_0: angle of the wind to the x axis, in rad.
    pub wind_angle: T,
    /// θ_0: turn of the section at rest, in rad.
    pub attitude: T,
    /// The forces at the angle of attack α_0 + θ_0.
    pub forces: Forces<T>,
    /// The coordinates that are free.
    pub free: FreeCoordinates,
    /// Whether the angle of attack follows the turn of the section as it moves: the paper leaves that out.
    pub aerodynamic_stiffness: bool,
}

impl<T> Parameters<T> {
    /// The same parameters in other numbers.
    pub fn map<U>(&self, number: impl Fn(&T) -> U) -> Parameters<U> {
        Parameters {
            mass: number(&self.mass),
            radius_of_gyration: number(&self.radius_of_gyration),
            mass_centre_distance: number(&self.mass_centre_distance),
            mass_centre_angle: number(&self.mass_centre_angle),
            aerodynamic_centre_distance: number(&self.aerodynamic_centre_distance),
            aerodynamic_centre_angle: number(&self.aerodynamic_centre_angle),
            reference_dimension: number(&self.reference_dimension),
            natural_frequencies: self.natural_frequencies.each_ref().map(&number),
            damping_ratios: self.damping_ratios.each_ref().map(&number),
            air_density: number(&self.air_density),
            wind_speed: number(&self.wind_speed),
            wind_angle: number(&self.wind_angle),
            attitude: number(&self.attitude),
            forces: self.forces.map(&number),
            free: self.free,
            aerodynamic_stiffness: self.aerodynamic_stiffness,
        }
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
}
