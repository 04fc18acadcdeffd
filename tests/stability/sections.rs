//! Sections at random, from fixed seeds.

use sextic::stability::coordinate::{Coordinate, FreeCoordinates};
use sextic::stability::forces::Forces;
use sextic::stability::section::{Coefficients, Parameters};

/// A small generator of numbers that look random: the same on every machine.
pub struct Numbers(u64);

impl Numbers {
    pub fn new(seed: u64) -> Self {
        Numbers(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// A number in `low..high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number whose logarithm is as likely anywhere.
    pub fn scale(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    pub fn one_of<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.between(0.0, list.len() as f64) as usize]
    }
}

/// A section within the usual ranges, detuned, damped and in wind, all coordinates free.
pub fn section(numbers: &mut Numbers) -> Parameters {
    let radius = numbers.scale(0.01, 0.1);
    let turn = std::f64::consts::PI;
    Parameters {
        open: None,
        mass: numbers.scale(0.5, 50.0),
        radius_of_gyration: radius,
        mass_centre_distance: radius * numbers.between(0.0, 0.5),
        mass_centre_angle: numbers.between(-turn, turn),
        aerodynamic_centre_distance: numbers.between(0.0, 0.05),
        aerodynamic_centre_angle: numbers.between(-turn, turn),
        reference_dimension: numbers.scale(0.01, 0.3),
        natural_frequencies: [(); 3].map(|()| numbers.between(1.0, 20.0)),
        damping_ratios: [(); 3].map(|()| numbers.between(0.0, 0.02)),
        air_density: 1.25,
        wind_speed: numbers.between(1.0, 40.0),
        wind_angle: numbers.between(-turn, turn),
        attitude: numbers.between(-turn, turn),
        forces: Forces::Coefficients(Coefficients {
            drag: numbers.between(0.2, 2.0),
            lift: numbers.between(-1.5, 1.5),
            moment: numbers.between(-0.5, 0.5),
            drag_slope: numbers.between(-10.0, 10.0),
            lift_slope: numbers.between(-10.0, 10.0),
            moment_slope: numbers.between(-5.0, 5.0),
        }),
        free: FreeCoordinates::all(),
        aerodynamic_stiffness: false,
    }
}

/// What makes eigenvalues hard to compute.
pub const KINDS: [&str; 9] = [
    "usual",
    "undamped, no wind",
    "tuned, no wind",
    "tuned, centred, no wind",
    "tuned, centred, hardly any wind",
    "tuned, hardly eccentric",
    "tuned, critically damped",
    "aerodynamic stiffness",
    "some are held",
];

/// A section of one of these kinds.
pub fn hard_section(kind: &str, numbers: &mut Numbers) -> Parameters {
    let usual = section(numbers);
    let omega = usual.natural_frequencies[0];
    let tuned = Parameters {
        natural_frequencies: [omega; 3],
        damping_ratios: [0.0; 3],
        ..usual
    };
    match kind {
        "usual" => usual,
        "undamped, no wind" => Parameters {
            damping_ratios: [0.0; 3],
            wind_speed: 0.0,
            ..usual
        },
        "tuned, no wind" => Parameters {
            wind_speed: 0.0,
            ..tuned
        },
        "tuned, centred, no wind" => Parameters {
            wind_speed: 0.0,
            mass_centre_distance: 0.0,
            ..tuned
        },
        "tuned, centred, hardly any wind" => Parameters {
            wind_speed: numbers.scale(1e-15, 1e-3),
            mass_centre_distance: 0.0,
            ..tuned
        },
        "tuned, hardly eccentric" => Parameters {
            wind_speed: numbers.scale(1e-4, 1.0),
            mass_centre_distance: tuned.radius_of_gyration * numbers.scale(1e-12, 1e-2),
            ..tuned
        },
        "aerodynamic stiffness" => Parameters {
            aerodynamic_stiffness: true,
            ..usual
        },
        // One eigenvalue of multiplicity 6, and defective.
        "tuned, critically damped" => Parameters {
            damping_ratios: [1.0; 3],
            wind_speed: 0.0,
            mass_centre_distance: 0.0,
            ..tuned
        },
        _ => {
            use Coordinate::{Theta, X, Y};
            let subsets: [&[Coordinate]; 6] =
                [&[X], &[Y], &[Theta], &[X, Y], &[X, Theta], &[Y, Theta]];
            let subset = *numbers.one_of(&subsets);
            let free = FreeCoordinates::new(subset).expect("not empty");
            let base = if numbers.between(0.0, 1.0) < 0.5 {
                tuned
            } else {
                usual
            };
            Parameters { free, ..base }
        }
    }
}
