//! The quantities of a case that a grid may vary, and that a command may set.

use std::f64::consts::TAU;
use std::fmt;

use super::coordinate::Coordinate;
use super::forces::Forces;
use super::section::{Coefficients, Parameters};

/// A quantity of a case, by the name and in the unit of the case file, or by that of the command line in
/// SI units and radians.
#[derive(Clone, Copy, Debug)]
pub struct Variable {
    /// Its name: `L_g`, `alpha_g_deg`, `alpha_g`.
    pub name: &'static str,
    set: Set,
}

#[derive(Clone, Copy, Debug)]
enum Set {
    /// The angle of attack, at which the table is read.
    Angle,
    Parameter(fn(&mut Parameters, f64)),
    /// In place of what the table says.
    Coefficient(fn(&mut Coefficients, f64)),
}

/// A quantity of a case, and the value that it is given.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The quantity.
    pub variable: Variable,
    /// Its value, in the unit of its name.
    pub value: f64,
}

impl PartialEq for Setting {
    fn eq(&self, other: &Self) -> bool {
        (self.variable.name, self.value) == (other.variable.name, other.value)
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} = {}", self.variable.name, self.value)
    }
}

const fn parameter(name: &'static str, set: fn(&mut Parameters, f64)) -> Variable {
    let set = Set::Parameter(set);
    Variable { name, set }
}

const fn coefficient(name: &'static str, set: fn(&mut Coefficients, f64)) -> Variable {
    let set = Set::Coefficient(set);
    Variable { name, set }
}

impl Variable {
    /// The angle of attack, in degrees.
    pub const ANGLE: Variable = Variable {
        name: "alpha_deg",
        set: Set::Angle,
    };

    /// All of them.
    pub const ALL: [Variable; 30] = [
        Variable::ANGLE,
        parameter("D", |p, value| p.reference_dimension = value),
        parameter("m", |p, value| p.mass = value),
        parameter("r", |p, value| p.radius_of_gyration = value),
        parameter("L_g", |p, value| p.mass_centre_distance = value),
        parameter("alpha_g_deg", |p, value| {
            p.mass_centre_angle = value.to_radians()
        }),
        parameter("alpha_g", |p, value| p.mass_centre_angle = value),
        parameter("L_a", |p, value| p.aerodynamic_centre_distance = value),
        parameter("gamma_r_deg", |p, value| {
            p.aerodynamic_centre_angle = value.to_radians()
        }),
        parameter("gamma_r", |p, value| p.aerodynamic_centre_angle = value),
        parameter("f", |p, value| p.natural_frequencies = [TAU * value; 3]),
        parameter("f_x", |p, value| p.natural_frequencies[0] = TAU * value),
        parameter("f_y", |p, value| p.natural_frequencies[1] = TAU * value),
        parameter("f_theta", |p, value| p.natural_frequencies[2] = TAU * value),
        parameter("omega_n", |p, value| p.natural_frequencies = [value; 3]),
        parameter("omega_x", |p, value| p.natural_frequencies[0] = value),
        parameter("omega_y", |p, value| p.natural_frequencies[1] = value),
        parameter("omega_theta", |p, value| p.natural_frequencies[2] = value),
        parameter("zeta", |p, value| p.damping_ratios = [value; 3]),
        parameter("zeta_x", |p, value| p.damping_ratios[0] = value),
        parameter("zeta_y", |p, value| p.damping_ratios[1] = value),
        parameter("zeta_theta", |p, value| p.damping_ratios[2] = value),
        parameter("rho", |p, value| p.air_density = value),
        parameter("U", |p, value| p.wind_speed = value),
        coefficient("C_D", |c, value| c.drag = value),
        coefficient("C_L", |c, value| c.lift = value),
        coefficient("C_M", |c, value| c.moment = value),
        coefficient("dC_D", |c, value| c.drag_slope = value),
        coefficient("dC_L", |c, value| c.lift_slope = value),
        coefficient("dC_M", |c, value| c.moment_slope = value),
    ];

    /// The variable with a name.
    ///
    /// ```
    /// use sextic::stability::variable::Variable;
    ///
    /// assert!(Variable::named("L_g").is_some());
    /// assert!(Variable::named("L_q").is_none());
    /// ```
    pub fn named(name: &str) -> Option<Self> {
        Variable::ALL.into_iter().find(|own| own.name == name)
    }

    /// Whether it is the angle of attack.
    pub fn is_angle(self) -> bool {
        matches!(self.set, Set::Angle)
    }

    /// Whether it and another one set the same quantity: then their order matters.
    pub(super) fn clashes(self, other: Variable) -> bool {
        let mut one = Parameters::default();
        let mut two = Parameters::default();
        self.set(&mut one, 1.0);
        other.set(&mut one, 2.0);
        other.set(&mut two, 2.0);
        self.set(&mut two, 1.0);
        one != two || self.name == other.name
    }

    /// Whether it sets nothing of a section but what belongs to coordinates that are held.
    pub(super) fn is_held(self, parameters: &Parameters) -> bool {
        if self.is_angle() {
            return false;
        }
        let mut changed = *parameters;
        self.set(&mut changed, f64::INFINITY);
        for coordinate in Coordinate::ALL {
            if !parameters.free.as_slice().contains(&coordinate) {
                let place = coordinate.index();
                changed.natural_frequencies[place] = parameters.natural_frequencies[place];
                changed.damping_ratios[place] = parameters.damping_ratios[place];
            }
        }
        changed == *parameters
    }

    /// Gives it a value; the angle of attack is for the case to set, with the coefficients there.
    pub(super) fn set(self, parameters: &mut Parameters, value: f64) {
        match (self.set, &mut parameters.forces) {
            (Set::Parameter(set), _) => set(parameters, value),
            (Set::Coefficient(set), Forces::Coefficients(coefficients)) => set(coefficients, value),
            (Set::Coefficient(_), Forces::ScaledDamping(_)) | (Set::Angle, _) => {}
        }
    }
}
