//! Sections of all kinds: damping, eccentricity and detuning from hardly any to much.

use std::f64::consts::TAU;

use sextic::stability::coordinate::FreeCoordinates;
use sextic::stability::exact_modes::inputs;
use sextic::stability::forces::Forces;
use sextic::stability::section::{Coefficients, Parameters, Section};
use sextic_evaluators::exact_modes_batch::ExactModesSlices;
use sextic_evaluators::section_matrices::SectionMatricesInputs;

/// SplitMix64.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Any order of magnitude is as likely.
    fn scale(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    fn one_of(&mut self, choices: usize) -> usize {
        (self.bits() % choices as u64) as usize
    }
}

/// e = L_g/r in six classes.
const ECCENTRICITIES: [(f64, f64); 6] = [
    (0.0, 0.0),
    (1e-6, 1e-3),
    (1e-3, 1e-2),
    (1e-2, 0.1),
    (0.1, 0.5),
    (0.5, 0.9),
];

/// Sections in wind with δ = ρDU/(2mω) in a range, the same in every run: frequencies equal, or one or all
/// of them detuned by a share of 1e-6 to 0.3; without structural damping, with equal ratios, or any.
pub fn sections(count: usize, delta: (f64, f64)) -> Vec<Section> {
    let random = &mut Random(7);
    (0..count).map(|_| section(random, delta)).collect()
}

fn section(random: &mut Random, delta: (f64, f64)) -> Section {
    let base = TAU;
    let mut natural_frequencies = [base; 3];
    let detuned = [0, 1, 3][random.one_of(3)];
    for omega in natural_frequencies.iter_mut().take(detuned) {
        let sign = [-1.0, 1.0][random.one_of(2)];
        *omega *= 1.0 + sign * random.scale(1e-6, 0.3);
    }
    natural_frequencies.rotate_left(random.one_of(3));
    let damping_ratios = match random.one_of(3) {
        0 => [0.0; 3],
        1 => [random.scale(1e-4, 0.02); 3],
        _ => [(); 3].map(|()| random.scale(1e-4, 0.02)),
    };
    let radius_of_gyration = 0.0625;
    let e = match ECCENTRICITIES[random.one_of(6)] {
        (_, 0.0) => 0.0,
        (low, high) => random.scale(low, high),
    };
    let (mass, reference_dimension, air_density) = (2.75, 0.0375, 1.225);
    let parameters = Parameters {
        open: None,
        mass,
        radius_of_gyration,
        mass_centre_distance: e * radius_of_gyration,
        mass_centre_angle: random.between(0.0, TAU),
        aerodynamic_centre_distance: random.between(0.0, radius_of_gyration),
        aerodynamic_centre_angle: random.between(0.0, TAU),
        reference_dimension,
        natural_frequencies,
        damping_ratios,
        air_density,
        wind_speed: random.scale(delta.0, delta.1) * 2.0 * mass * base
            / (air_density * reference_dimension),
        wind_angle: random.between(0.0, TAU),
        attitude: 0.0,
        forces: Forces::Coefficients(Coefficients {
            drag: random.between(0.3, 2.0),
            lift: random.between(-1.5, 1.5),
            moment: random.between(-0.5, 0.5),
            drag_slope: random.between(-4.0, 4.0),
            lift_slope: random.between(-6.0, 6.0),
            moment_slope: random.between(-2.0, 2.0),
        }),
        free: FreeCoordinates::all(),
        aerodynamic_stiffness: false,
    };
    let forces = Section::new(parameters).unwrap().scaled_damping();
    let forces = Forces::ScaledDamping(forces);
    Section::new(Parameters {
        forces,
        ..parameters
    })
    .unwrap()
}

macro_rules! quantities {
    ($($name:ident)*) => {
        /// The quantities of the sections.
        #[allow(non_snake_case)]
        pub struct Columns {
            $($name: Vec<f64>,)*
            direction_error: Vec<f64>,
            damping_error: Vec<f64>,
        }

        impl Columns {
            pub fn of(sections: &[Section]) -> Self {
                let inputs: Vec<_> = sections.iter().map(inputs).collect();
                Columns {
                    $($name: inputs.iter().map(|own| own.section.$name).collect(),)*
                    direction_error: inputs.iter().map(|own| own.direction_error).collect(),
                    damping_error: inputs.iter().map(|own| own.damping_error).collect(),
                }
            }

            pub fn slices(&self) -> ExactModesSlices<'_> {
                ExactModesSlices {
                    section: SectionMatricesInputs { $($name: &self.$name),* },
                    direction_error: &self.direction_error,
                    damping_error: &self.damping_error,
                }
            }
        }
    };
}

quantities! {
    m r L_g cos_alpha_g_plus_theta_0 sin_alpha_g_plus_theta_0 omega_x omega_y omega_theta
    zeta_x zeta_y zeta_theta rho D U S_xx S_xy S_yx S_yy S_xt S_yt S_tx S_ty S_tt
}
