//! A section by the names of its quantities, as they stand on the command line.

use std::collections::BTreeMap;

use super::coordinate::FreeCoordinates;
use super::forces::{Forces, SCALED_DAMPING};
use super::section::{Coefficients, Parameters};

/// The names of what a section always needs, in SI units and radians.
const STRUCTURE: [&str; 8] = [
    "m",
    "r",
    "L_g",
    "alpha_g",
    "theta_0",
    "omega_x",
    "omega_y",
    "omega_theta",
];

/// The structural damping ratios, which the closed forms leave out.
const DAMPING: [&str; 3] = ["zeta_x", "zeta_y", "zeta_theta"];

/// What is needed where there is wind.
const WIND: [&str; 2] = ["rho", "D"];

/// What is needed for the forces of the wind, unless S_a is given; derivatives are per radian.
const COEFFICIENTS: [&str; 9] = [
    "alpha_0", "L_a", "gamma_r", "C_D", "C_L", "C_M", "dC_D", "dC_L", "dC_M",
];

/// The names of all quantities of a section.
pub fn names() -> impl Iterator<Item = &'static str> {
    let groups: [&[&str]; 4] = [&STRUCTURE, &DAMPING, &["U"], &WIND];
    let scaled = SCALED_DAMPING.into_iter().flatten();
    groups
        .into_iter()
        .flatten()
        .copied()
        .chain(COEFFICIENTS)
        .chain(scaled)
}

/// Whether an entry of the scaled damping matrix is among the values: it stands in place of coefficients.
fn has_scaled_damping<T>(values: &BTreeMap<String, T>) -> bool {
    let mut entries = SCALED_DAMPING.into_iter().flatten();
    entries.any(|name| values.contains_key(name))
}

/// The names of what is needed for a section with these values: without wind, and without structural
/// damping, less; of the coefficients and the scaled damping matrix, only the one or the other.
pub fn needed(values: &BTreeMap<String, f64>, with_damping: bool) -> Vec<&'static str> {
    let is_calm = values.get("U") == Some(&0.0);
    let is_scaled = has_scaled_damping(values);
    let is_needed = |name: &&str| match name {
        name if DAMPING.contains(name) => with_damping,
        name if WIND.contains(name) => !is_calm,
        name if COEFFICIENTS.contains(name) => !is_calm && !is_scaled,
        name if SCALED_DAMPING.as_flattened().contains(name) => !is_calm && is_scaled,
        _ => true,
    };
    names().filter(is_needed).collect()
}

/// The parameters of a section with all coordinates free and without aerodynamic stiffness. What is not among
/// the values is 0, or 1 where it may not be 0: it is for the caller to ask for what is [`needed`]. The numbers
/// are doubles, or exact ones.
///
/// ```
/// use std::collections::BTreeMap;
/// use sextic::stability::quantities::parameters;
///
/// let values = BTreeMap::from([("m".to_string(), 3.5), ("omega_y".to_string(), 5.3)]);
/// let parameters = parameters(&values);
/// assert_eq!(parameters.mass, 3.5);
/// assert_eq!(parameters.natural_frequencies[1], 5.3);
/// ```
pub fn parameters<T: Clone + From<u8>>(values: &BTreeMap<String, T>) -> Parameters<T> {
    let or = |name: &str, other: u8| values.get(name).cloned().unwrap_or_else(|| other.into());
    let of = |name: &str| or(name, 0);
    Parameters {
        mass: of("m"),
        radius_of_gyration: of("r"),
        mass_centre_distance: of("L_g"),
        mass_centre_angle: of("alpha_g"),
        aerodynamic_centre_distance: of("L_a"),
        aerodynamic_centre_angle: of("gamma_r"),
        reference_dimension: or("D", 1),
        natural_frequencies: [of("omega_x"), of("omega_y"), of("omega_theta")],
        damping_ratios: [of("zeta_x"), of("zeta_y"), of("zeta_theta")],
        air_density: or("rho", 1),
        wind_speed: of("U"),
        wind_angle: of("alpha_0"),
        attitude: of("theta_0"),
        forces: if has_scaled_damping(values) {
            Forces::ScaledDamping(SCALED_DAMPING.map(|row| row.map(of)))
        } else {
            Forces::Coefficients(Coefficients {
                drag: of("C_D"),
                lift: of("C_L"),
                moment: of("C_M"),
                drag_slope: of("dC_D"),
                lift_slope: of("dC_L"),
                moment_slope: of("dC_M"),
            })
        },
        free: FreeCoordinates::all(),
        aerodynamic_stiffness: false,
    }
}
