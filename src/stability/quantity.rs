//! The quantities of a section, in one table: what each is called, where it stands among the parameters, which
//! numbers it may be, its unit, what it belongs to, when it is needed, and where a case has it.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use super::coordinate::{Coordinate, FreeCoordinates};
use super::error::StabilityError;
use super::forces::{Coefficients, Forces};
use super::parameters::Parameters;

/// Which finite numbers a quantity may be.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Range {
    Above0,
    AtLeast0,
    Any,
}

/// The unit of a quantity in a case; on the command line it is in SI units and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Unit {
    KilogramPerMetre,
    KilogramPerCubicMetre,
    Metre,
    MetrePerSecond,
    Degree,
    Hertz,
    /// Of critical damping.
    Fraction,
    /// That of the command line.
    Si,
}

/// What a quantity belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Owner {
    /// The section, whatever is free.
    Section,
    /// Its turn, and counts where it turns: levers, and moments about O.
    Lever,
    /// A coordinate: it is not used where that is held.
    Motion(Coordinate),
}

/// When a quantity is needed, in the order in which quantities are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Need {
    Always,
    /// Unless structural damping is left out, as by the closed forms.
    Damping,
    /// Always: at 0 it is calm, and nothing that follows is needed.
    Speed,
    Air,
    Size,
    /// For the forces, unless S_a is given.
    Forces,
    /// In place of what the forces need.
    ScaledDamping,
}

/// A key of a case file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Key {
    pub table: &'static str,
    pub name: &'static str,
    /// What it holds, where no case does without it.
    pub holds: Option<&'static str>,
}

/// Where a case has a quantity.
#[derive(Clone, Copy, Debug)]
pub(super) enum Source {
    Key(Key),
    /// In its sweep, with this `turn`.
    Sweep(&'static str),
    /// In its table of coefficients.
    Table,
    Nowhere,
}

use Source::{Nowhere, Sweep, Table};

impl Key {
    pub const fn new(table: &'static str, name: &'static str, holds: Option<&'static str>) -> Self {
        Key { table, name, holds }
    }
}

const fn key(table: &'static str, name: &'static str, holds: &'static str) -> Source {
    Source::Key(Key::new(table, name, Some(holds)))
}

/// What is known of a quantity.
pub(super) struct Row {
    pub name: &'static str,
    range: Range,
    pub unit: Unit,
    pub owner: Owner,
    need: Need,
    pub source: Source,
}

macro_rules! quantities {
    ($own:ident: $(
        $name:ident $place:tt $range:ident $unit:ident $owner:ident$(($coordinate:ident))? $need:ident $source:expr;
    )*) => {
        /// A quantity of a section, by its name.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[allow(non_camel_case_types)]
        pub(super) enum Quantity { $($name),* }

        const ROWS: &[Row] = &[$(Row {
            name: stringify!($name),
            range: Range::$range,
            unit: Unit::$unit,
            owner: Owner::$owner$((Coordinate::$coordinate))?,
            need: Need::$need,
            source: $source,
        }),*];

        impl Quantity {
            /// All of them, in the order of a case.
            pub const ALL: &'static [Quantity] = &[$(Quantity::$name),*];

            /// Refuses the first that is out of its range. Each is looked up when this is compiled: a section is
            /// checked at every point of a grid.
            pub fn check_all(parameters: &Parameters) -> Result<(), StabilityError> {
                $(Quantity::$name.check(parameters)?;)*
                Ok(())
            }

            /// Its value; `None` if the forces are given by others.
            #[inline(always)]
            pub fn of<T>(self, parameters: &Parameters<T>) -> Option<&T> {
                match (self, parameters) {
                    $((Quantity::$name, Parameters $place) => Some($own),)*
                    _ => None,
                }
            }

            /// The same, to be changed.
            pub fn of_mut<T>(self, parameters: &mut Parameters<T>) -> Option<&mut T> {
                match (self, parameters) {
                    $((Quantity::$name, Parameters $place) => Some($own),)*
                    _ => None,
                }
            }
        }
    };
}

quantities! { own:
    // name, place among the parameters, range, unit in a case, what it belongs to, when it is needed, where a case has it
    D           { reference_dimension: own, .. }            Above0   Metre          Section       Size
                key("section", "D", "the reference dimension in m");
    m           { mass: own, .. }                           Above0   KilogramPerMetre  Section    Always
                key("section", "m", "the mass in kg/m");
    r           { radius_of_gyration: own, .. }             Above0   Metre          Lever         Always
                key("section", "r", "the radius of gyration in m");
    L_g         { mass_centre_distance: own, .. }           AtLeast0 Metre          Lever         Always
                key("section", "L_g", "from the elastic centre to the mass centre in m");
    alpha_g     { mass_centre_angle: own, .. }              Any      Degree         Lever         Always
                key("section", "alpha_g_deg", "and its angle in degrees");
    theta_0     { attitude: own, .. }                       Any      Degree         Section       Always    Sweep("section");
    alpha_0     { wind_angle: own, .. }                     Any      Degree         Section       Forces    Sweep("wind");
    L_a         { aerodynamic_centre_distance: own, .. }    AtLeast0 Metre          Lever         Forces
                key("section", "L_a", "from the elastic centre to the aerodynamic centre in m");
    gamma_r     { aerodynamic_centre_angle: own, .. }       Any      Degree         Lever         Forces
                key("section", "gamma_r_deg", "and its angle in degrees");

    omega_x     { natural_frequencies: [own, _, _], .. }    Above0   Hertz          Motion(X)     Always
                key("structure", "f_x", "a frequency in Hz");
    omega_y     { natural_frequencies: [_, own, _], .. }    Above0   Hertz          Motion(Y)     Always
                key("structure", "f_y", "a frequency in Hz");
    omega_theta { natural_frequencies: [_, _, own], .. }    Above0   Hertz          Motion(Theta) Always
                key("structure", "f_theta", "a frequency in Hz");
    zeta_x      { damping_ratios: [own, _, _], .. }         AtLeast0 Fraction       Motion(X)     Damping
                key("structure", "zeta_x", "a damping ratio, which may be 0");
    zeta_y      { damping_ratios: [_, own, _], .. }         AtLeast0 Fraction       Motion(Y)     Damping
                key("structure", "zeta_y", "a damping ratio, which may be 0");
    zeta_theta  { damping_ratios: [_, _, own], .. }         AtLeast0 Fraction       Motion(Theta) Damping
                key("structure", "zeta_theta", "a damping ratio, which may be 0");

    rho         { air_density: own, .. }                    Above0   KilogramPerCubicMetre Section Air
                key("wind", "rho", "the density of air, about 1.25 kg/m³");
    U           { wind_speed: own, .. }                     AtLeast0 MetrePerSecond Section       Speed
                key("wind", "U", "the wind speed in m/s");

    C_D  { forces: Forces::Coefficients(Coefficients { drag: own, .. }), .. }         Any Si Section Forces Table;
    C_L  { forces: Forces::Coefficients(Coefficients { lift: own, .. }), .. }         Any Si Section Forces Table;
    C_M  { forces: Forces::Coefficients(Coefficients { moment: own, .. }), .. }       Any Si Lever   Forces Table;
    dC_D { forces: Forces::Coefficients(Coefficients { drag_slope: own, .. }), .. }   Any Si Section Forces Table;
    dC_L { forces: Forces::Coefficients(Coefficients { lift_slope: own, .. }), .. }   Any Si Section Forces Table;
    dC_M { forces: Forces::Coefficients(Coefficients { moment_slope: own, .. }), .. } Any Si Lever   Forces Table;

    S_xx { forces: Forces::ScaledDamping([[own, _, _], _, _]), .. } Any Si Section ScaledDamping Nowhere;
    S_xy { forces: Forces::ScaledDamping([[_, own, _], _, _]), .. } Any Si Section ScaledDamping Nowhere;
    S_xt { forces: Forces::ScaledDamping([[_, _, own], _, _]), .. } Any Si Section ScaledDamping Nowhere;
    S_yx { forces: Forces::ScaledDamping([_, [own, _, _], _]), .. } Any Si Section ScaledDamping Nowhere;
    S_yy { forces: Forces::ScaledDamping([_, [_, own, _], _]), .. } Any Si Section ScaledDamping Nowhere;
    S_yt { forces: Forces::ScaledDamping([_, [_, _, own], _]), .. } Any Si Section ScaledDamping Nowhere;
    S_tx { forces: Forces::ScaledDamping([_, _, [own, _, _]]), .. } Any Si Section ScaledDamping Nowhere;
    S_ty { forces: Forces::ScaledDamping([_, _, [_, own, _]]), .. } Any Si Section ScaledDamping Nowhere;
    S_tt { forces: Forces::ScaledDamping([_, _, [_, _, own]]), .. } Any Si Section ScaledDamping Nowhere;
}

impl Unit {
    /// What a number in this unit is in SI units and radians.
    pub fn to_si(self, value: f64) -> f64 {
        match self {
            Unit::Degree => value.to_radians(),
            Unit::Hertz => TAU * value,
            _ => value,
        }
    }

    /// What a number in SI units and radians is in this one.
    pub fn of_si(self, value: f64) -> f64 {
        match self {
            Unit::Degree => value.to_degrees(),
            Unit::Hertz => value / TAU,
            _ => value,
        }
    }

    /// What is said of it to who may have mistaken it.
    pub fn help(self) -> &'static str {
        match self {
            Unit::KilogramPerMetre => "in kg/m",
            Unit::KilogramPerCubicMetre => "in kg/m³; air at the ground has about 1.2",
            Unit::Metre => "lengths are in m",
            Unit::MetrePerSecond => "in m/s",
            Unit::Degree => "angles are in degrees",
            Unit::Hertz => "frequencies are in Hz",
            Unit::Fraction => "damping ratios are fractions: 0.8 % is 0.008",
            Unit::Si => "in SI units",
        }
    }
}

impl Quantity {
    /// What is known of it.
    pub fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }

    /// The quantity with a name.
    pub fn named(name: &str) -> Option<Self> {
        let mut all = Quantity::ALL.iter().copied();
        all.find(|own| own.row().name == name)
    }

    /// Its key in a case file.
    pub fn key(self) -> Option<Key> {
        match self.row().source {
            Source::Key(key) => Some(key),
            _ => None,
        }
    }

    /// Gives it a value, unless the forces are given by others.
    pub fn set<T>(self, parameters: &mut Parameters<T>, value: T) {
        if let Some(place) = self.of_mut(parameters) {
            *place = value;
        }
    }

    /// Refuses a value out of its range.
    #[inline(always)]
    fn check(self, parameters: &Parameters) -> Result<(), StabilityError> {
        let value = self.of(parameters);
        let Some(&value) = value.filter(|_| self.is_used(parameters.free)) else {
            return Ok(());
        };
        match self.row().range {
            _ if !value.is_finite() => Err(self.must_be("finite", value)),
            Range::Above0 if value <= 0.0 => Err(self.must_be("above 0", value)),
            Range::AtLeast0 if value < 0.0 => Err(self.must_be("0 or above", value)),
            _ => Ok(()),
        }
    }

    /// Why its value is refused.
    pub fn must_be(self, what: &str, value: f64) -> StabilityError {
        StabilityError::Parameter {
            name: self.row().name,
            value,
            must_be: what.into(),
        }
    }

    /// Whether something hangs on it with these free coordinates.
    pub fn acts(self, free: FreeCoordinates) -> bool {
        let turns = free.as_slice().contains(&Coordinate::Theta);
        self.is_used(free) && (turns || self.row().owner != Owner::Lever)
    }

    /// Whether it is one of the section with these free coordinates.
    pub fn is_used(self, free: FreeCoordinates) -> bool {
        match self.row().owner {
            Owner::Motion(own) => free.as_slice().contains(&own),
            Owner::Section | Owner::Lever => true,
        }
    }
}

/// The names of all quantities of a section.
pub fn names() -> impl Iterator<Item = &'static str> {
    in_order_of_need().into_iter().map(|own| own.row().name)
}

fn in_order_of_need() -> Vec<Quantity> {
    let mut all = Quantity::ALL.to_vec();
    all.sort_by_key(|own| own.row().need);
    all
}

/// Whether an entry of the scaled damping matrix is among the values: it stands in place of coefficients.
fn has_scaled_damping<T>(values: &BTreeMap<String, T>) -> bool {
    let mut given = values.keys().filter_map(|name| Quantity::named(name));
    given.any(|own| own.row().need == Need::ScaledDamping)
}

/// The names of what is needed for a section with these values: without wind, and without structural
/// damping, less; of the coefficients and the scaled damping matrix, only the one or the other.
pub fn needed(values: &BTreeMap<String, f64>, with_damping: bool) -> Vec<&'static str> {
    let is_windy = values.get("U") != Some(&0.0);
    let is_scaled = has_scaled_damping(values);
    let is_needed = |own: &Quantity| match own.row().need {
        Need::Always | Need::Speed => true,
        Need::Damping => with_damping,
        Need::Air | Need::Size => is_windy,
        Need::Forces => is_windy && !is_scaled,
        Need::ScaledDamping => is_windy && is_scaled,
    };
    let needed = in_order_of_need().into_iter().filter(is_needed);
    needed.map(|own| own.row().name).collect()
}

/// The parameters of a section with all coordinates free and without aerodynamic stiffness. What is not among
/// the values is 0, or 1 where it may not be 0: it is for the caller to ask for what is [`needed`]. The numbers
/// are doubles, or exact ones.
///
/// ```
/// use std::collections::BTreeMap;
/// use sextic::stability::quantity::parameters;
///
/// let values = BTreeMap::from([("m".to_string(), 3.5), ("omega_y".to_string(), 5.3)]);
/// let parameters = parameters(&values);
/// assert_eq!(parameters.mass, 3.5);
/// assert_eq!(parameters.natural_frequencies[1], 5.3);
/// ```
pub fn parameters<T: Clone + Default + From<u8>>(values: &BTreeMap<String, T>) -> Parameters<T> {
    let mut parameters = Parameters {
        reference_dimension: 1.into(),
        air_density: 1.into(),
        ..Parameters::default()
    };
    if has_scaled_damping(values) {
        parameters.forces = Forces::ScaledDamping(Default::default());
    }
    for own in Quantity::ALL {
        if let Some(value) = values.get(own.row().name) {
            own.set(&mut parameters, value.clone());
        }
    }
    parameters
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::given::Given;
    use std::cell::RefCell;
    use std::collections::BTreeSet;

    /// Each quantity is a number of its own, by both kinds of forces.
    fn numbered(forces: Forces) -> Parameters {
        let mut parameters = Parameters {
            forces,
            ..Parameters::default()
        };
        for (number, own) in Quantity::ALL.iter().enumerate() {
            own.set(&mut parameters, 1.0 + number as f64);
        }
        parameters
    }

    fn both_forces() -> [Forces; 2] {
        [Forces::default(), Forces::ScaledDamping(Default::default())]
    }

    #[test]
    fn each_quantity_has_a_place_of_its_own_and_no_place_is_left() {
        for parameters in both_forces().map(numbered) {
            let values = Quantity::ALL.iter().map(|own| own.of(&parameters).copied());
            let numbers = values
                .enumerate()
                .filter_map(|(place, own)| Some((place, own?)));
            let numbers: Vec<(usize, f64)> = numbers.collect();
            for (place, number) in &numbers {
                assert_eq!(*number, 1.0 + *place as f64);
            }
            let places = RefCell::new(BTreeSet::new());
            parameters.map(|own| places.borrow_mut().insert(own.to_bits()));
            let numbers = numbers.iter().map(|(_, number)| number.to_bits());
            assert_eq!(places.into_inner(), numbers.collect());
        }
    }

    #[test]
    fn names_and_keys_name_one_quantity() {
        let mut all = BTreeSet::new();
        for own in Quantity::ALL {
            let key = own.key().map(|key| key.name);
            let others = key.filter(|key| *key != own.row().name);
            for name in others.into_iter().chain([own.row().name]) {
                assert!(all.insert(name), "{name}");
            }
        }
    }

    /// The other binding is that of fields to the inputs of emitted functions: both together lead from a name to
    /// the same name.
    #[test]
    fn names_are_those_of_what_was_derived() {
        let [windy, scaled] = both_forces().map(numbered).map(|own| Given::of(&own));
        let Forces::Coefficients(forces) = windy.parameters.forces else {
            unreachable!("they are coefficients")
        };
        let [one, other] = [
            format!("{:?}", windy.characteristic_polynomial_inputs(&forces)),
            format!(
                "{:?}",
                scaled.section_matrices_inputs(&scaled.scaled_damping())
            ),
        ];
        let inputs = (one + &other).replace(" }", ",");
        let value = |own: Quantity| {
            own.of(&windy.parameters)
                .or(own.of(&scaled.parameters))
                .copied()
        };
        for (name, value) in Quantity::ALL
            .iter()
            .map(|own| (own.row().name, value(*own)))
        {
            let is_there = inputs.contains(&format!(" {name}: {:?},", value.unwrap_or_default()));
            let is_angle = ["alpha_g", "theta_0", "alpha_0", "gamma_r"].contains(&name);
            assert!(is_there != is_angle, "{name} {value:?}: {inputs}");
        }
        let turned = |own| Some((value(own)? + value(Quantity::theta_0)?).cos());
        assert_eq!(value(Quantity::alpha_0).map(f64::cos), Some(windy.wind[0]));
        assert_eq!(turned(Quantity::alpha_g), Some(windy.mass_centre[0]));
        assert_eq!(turned(Quantity::gamma_r), Some(windy.aerodynamic_centre[0]));
    }

    #[test]
    fn units_go_both_ways() {
        for own in Quantity::ALL {
            let unit = own.row().unit;
            assert!((unit.of_si(unit.to_si(0.7)) - 0.7).abs() < 1e-15, "{own:?}");
        }
    }
}
