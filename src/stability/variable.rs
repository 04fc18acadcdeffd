//! The quantities of a case that a grid may vary, and that a command may set.

use std::fmt;

use super::quantity::{Owner, Quantity, Source, Unit};
use super::section::Parameters;

/// A quantity of a case, by the name and in the unit of the case file, or by that of the command line in
/// SI units and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variable {
    /// Its name: `L_g`, `alpha_g_deg`, `alpha_g`.
    pub name: &'static str,
    unit: Unit,
    /// What it is, or all three that are set to one value; none for the angle of attack, at which the table is read.
    quantities: &'static [Quantity],
}

/// A quantity of a case, and the value that it is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// The quantity.
    pub variable: Variable,
    /// Its value, in the unit of its name.
    pub value: f64,
}

impl fmt::Display for Setting {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} = {}", self.variable.name, self.value)
    }
}

/// What is common to x, y and θ, by the name for x alone.
const COMMON: [(&str, &str); 3] = [("f_x", "f"), ("omega_x", "omega_n"), ("zeta_x", "zeta")];

impl Variable {
    /// The angle of attack, in degrees.
    pub const ANGLE: Variable = Variable {
        name: "alpha_deg",
        unit: Unit::Degree,
        quantities: &[],
    };

    /// L_g, in m.
    pub const MASS_CENTRE_DISTANCE: Variable = Variable {
        name: "L_g",
        unit: Unit::Metre,
        quantities: &[Quantity::L_g],
    };

    /// D, in m.
    pub(super) const DIMENSION: Variable = Variable {
        name: "D",
        unit: Unit::Metre,
        quantities: &[Quantity::D],
    };

    /// U, in m/s.
    pub(super) const WIND_SPEED: Variable = Variable {
        name: "U",
        unit: Unit::MetrePerSecond,
        quantities: &[Quantity::U],
    };

    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> {
        let are_alike = |one: &Quantity, other: &Quantity| {
            let [one, other] = [one, other].map(|own| own.row().unit);
            one == other && matches!(one, Unit::Hertz | Unit::Fraction)
        };
        let groups = Quantity::ALL.chunk_by(are_alike);
        std::iter::once(Variable::ANGLE).chain(groups.flat_map(names_of))
    }

    /// The variable with a name.
    ///
    /// ```
    /// use sextic::stability::variable::Variable;
    ///
    /// assert!(Variable::named("L_g").is_some());
    /// assert!(Variable::named("L_q").is_none());
    /// ```
    pub fn named(name: &str) -> Option<Self> {
        Variable::all().find(|own| own.name == name)
    }

    /// Whether it is the angle of attack.
    pub fn is_angle(self) -> bool {
        self.quantities.is_empty()
    }

    /// Whether it sets C_M or its slope.
    pub(super) fn is_moment(self) -> bool {
        let moment = [Quantity::C_M, Quantity::dC_M];
        moment.iter().any(|own| self.quantities.contains(own))
    }

    /// Whether it sets what is otherwise read from the table.
    pub(super) fn is_of_table(self) -> bool {
        let is_of_table = |own: &Quantity| matches!(own.row().source, Source::Table);
        self.quantities.iter().any(is_of_table)
    }

    /// Whether it and another one set the same quantity: then their order matters.
    pub fn clashes(self, other: Variable) -> bool {
        let mut quantities = self.quantities.iter();
        quantities.any(|own| other.quantities.contains(own)) || self.name == other.name
    }

    /// Whether it sets nothing of a section but what belongs to coordinates that are held.
    pub(super) fn is_held(self, parameters: &Parameters) -> bool {
        let mut quantities = self.quantities.iter();
        !self.is_angle() && quantities.all(|own| !own.acts(parameters.free))
    }

    /// What is said of one that is.
    pub(super) fn does_nothing(self) -> String {
        let mut quantities = self.quantities.iter();
        let reason = match quantities.all(|own| own.row().owner == Owner::Lever) {
            true => "theta",
            false => "its coordinate",
        };
        format!("{} does nothing: {reason} is held", self.name)
    }

    /// Gives it a value; the angle of attack is for the case to set, with the coefficients there.
    pub(super) fn set(self, parameters: &mut Parameters, value: f64) {
        for own in self.quantities {
            own.set(parameters, self.unit.to_si(value));
        }
    }
}

/// The names of quantities that may have one value in common: those of a case file before those of the command line.
fn names_of(group: &'static [Quantity]) -> Vec<Variable> {
    let mut all = Vec::new();
    for is_in_case in [true, false] {
        for (own, quantities) in group.iter().zip(group.chunks(1)) {
            let Some((name, unit)) = spelling(*own, is_in_case) else {
                continue;
            };
            let variable = |name, quantities| Variable {
                name,
                unit,
                quantities,
            };
            let common = COMMON.iter().find(|(first, _)| *first == name);
            all.extend(common.map(|(_, name)| variable(name, group)));
            all.push(variable(name, quantities));
        }
    }
    all
}

/// The name and the unit of a quantity in a case file, or on the command line where it is another one.
fn spelling(own: Quantity, is_in_case: bool) -> Option<(&'static str, Unit)> {
    let row = own.row();
    match (row.source, is_in_case) {
        (Source::Key(key), true) => Some((key.name, row.unit)),
        (Source::Key(key), false) if key.name == row.name => None,
        (Source::Key(_) | Source::Table, false) => Some((row.name, Unit::Si)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_sets_one_quantity_or_that_of_all_coordinates() {
        let set = |name: &str, value| {
            let mut parameters = Parameters::default();
            let variable = Variable::named(name).expect("a variable");
            variable.set(&mut parameters, value);
            parameters
        };
        for (name, value, other, same) in [
            ("alpha_g_deg", 180.0, "alpha_g", std::f64::consts::PI),
            ("f_y", 1.0, "omega_y", std::f64::consts::TAU),
            ("f", 2.0, "omega_n", 2.0 * std::f64::consts::TAU),
        ] {
            assert_eq!(set(name, value), set(other, same), "{name}");
        }
        assert_eq!(set("omega_n", 3.0).natural_frequencies, [3.0; 3]);
        assert_eq!(set("zeta", 0.1).damping_ratios, [0.1; 3]);
        assert_eq!(set("L_a", 0.3).aerodynamic_centre_distance, 0.3);
        for name in ["alpha_0", "theta_0", "S_xx"] {
            assert!(Variable::named(name).is_none(), "{name}");
        }
    }
}
