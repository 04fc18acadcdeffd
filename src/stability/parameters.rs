//! The parameters of a section in the wind.

use super::coordinate::FreeCoordinates;
use super::forces::{Coefficients, Forces};

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
    /// How far attitude and coefficients may be from these; `None` where they are these.
    pub open: Option<Open<T>>,
}

/// How far an attitude, and coefficients there, may be from some: what is certain is so for all of them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Open<T = f64> {
    /// Of θ_0, in rad.
    pub attitude: T,
    /// Of the coefficients and their slopes.
    pub coefficients: Coefficients<T>,
}

impl<T: Default + PartialEq> Open<T> {
    /// Whether nothing is open.
    pub fn is_nothing(&self) -> bool {
        *self == Open::default()
    }
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
            open: self.open.as_ref().map(|own| Open {
                attitude: number(&own.attitude),
                coefficients: own.coefficients.map(&number),
            }),
        }
    }
}
