//! The modes of a perfectly tuned section without wind, Eq. (15), and how they move the points of its body.

use sextic_evaluators::no_wind_modes::no_wind_modes;
use sextic_evaluators::small_motion::small_motion;

use super::given::Given;
use super::parameters::Parameters;

/// A perfectly tuned section without wind, in units of its radius of gyration r.
#[derive(Clone, Copy, Debug)]
pub struct TunedSection {
    given: Given<f64>,
}

/// One of its modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunedMode {
    /// ω/ω_n.
    pub frequency: f64,
    /// x/r, y/r and θ, up to a factor: all three are in phase.
    pub shape: [f64; 3],
}

/// A point of the body in a small motion, in units of r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyPoint {
    /// x and y at rest.
    pub at_rest: [f64; 2],
    /// How far the motion moves it, to first order.
    pub displacement: [f64; 2],
}

impl TunedSection {
    /// A section with e = L_g/r from 0 to below 1, and α_g + θ_0 in rad.
    pub fn new(eccentricity: f64, mass_centre_angle: f64) -> Self {
        let parameters = Parameters {
            radius_of_gyration: 1.0,
            mass_centre_distance: eccentricity,
            mass_centre_angle,
            ..Parameters::default()
        };
        TunedSection {
            given: Given::of(&parameters),
        }
    }

    /// Its three modes, the highest frequency first; without eccentricity the frequencies are one, and the shapes
    /// those that a small one gives.
    pub fn modes(&self) -> [TunedMode; 3] {
        let own = no_wind_modes(&self.given.no_wind_modes_inputs(1.0));
        let mode = |square: f64, shape| TunedMode {
            frequency: square.sqrt(),
            shape,
        };
        [
            mode(own.Omega_1, [own.phi_11, own.phi_21, own.phi_31]),
            mode(own.Omega_2, [own.phi_12, own.phi_22, own.phi_32]),
            mode(own.Omega_3, [own.phi_13, own.phi_23, own.phi_33]),
        ]
    }

    /// The point at a distance from O over r, at an angle in rad from the line through O and G, in a motion of O and
    /// the body by x/r, y/r and θ.
    pub fn point(&self, distance: f64, angle: f64, motion: [f64; 3]) -> BodyPoint {
        let own = small_motion(&self.given.small_motion_inputs(distance, angle, motion));
        BodyPoint {
            at_rest: [own.P_1, own.P_2],
            displacement: [own.u_1, own.u_2],
        }
    }

    /// The distance from O, towards G, of the point on the line through both that a motion leaves at rest; `None` if it
    /// moves all of them.
    pub fn centre_of_rotation(&self, motion: [f64; 3]) -> Option<f64> {
        // Displacements are linear along a line of the body.
        let at = |distance| self.point(distance, 0.0, motion).displacement;
        let (first, second) = (at(0.0), at(1.0));
        let change = [second[0] - first[0], second[1] - first[1]];
        let dot = |one: [f64; 2], other: [f64; 2]| one[0] * other[0] + one[1] * other[1];
        let distance = -dot(first, change) / dot(change, change);
        let rest = at(distance);
        let is_at_rest = dot(rest, rest) < 1e-24 * dot(motion_of(motion), motion_of(motion));
        is_at_rest.then_some(distance)
    }
}

/// x and y of a motion.
fn motion_of([x, y, _]: [f64; 3]) -> [f64; 2] {
    [x, y]
}
