//! Sections in wind, drawn at random from the domain that the paper's document states.

mod column;

use std::collections::BTreeMap;

use nalgebra::{Complex, Matrix3, Matrix6, Schur};
use sextic_evaluators::aerodynamic_damping::{AerodynamicDampingInputs, aerodynamic_damping};

pub use column::Column;

/// Where each quantity is drawn from; the cosines and sines of the angles come on top.
const DOMAIN: [(&str, f64, f64); 19] = [
    ("m", 1.0, 50.0),
    ("r", 0.01, 0.1),
    ("L_g", 0.0001, 0.009),
    ("L_a", 0.0, 0.05),
    ("D", 0.01, 0.2),
    ("rho", 1.1, 1.3),
    ("U", 1.0, 40.0),
    ("omega_x", 1.0, 20.0),
    ("omega_y", 1.0, 20.0),
    ("omega_theta", 1.0, 20.0),
    // Not 0: without damping the eigenvalue solve may never end.
    ("zeta_x", 0.001, 0.02),
    ("zeta_y", 0.001, 0.02),
    ("zeta_theta", 0.001, 0.02),
    ("C_D", 0.2, 2.0),
    ("C_L", -1.5, 1.5),
    ("C_M", -0.5, 0.5),
    ("dC_D", -10.0, 10.0),
    ("dC_L", -10.0, 10.0),
    ("dC_M", -5.0, 5.0),
];

const ANGLES: [(&str, &str); 3] = [
    ("cos_alpha_0", "sin_alpha_0"),
    ("cos_alpha_g_plus_theta_0", "sin_alpha_g_plus_theta_0"),
    ("cos_gamma_r_plus_theta_0", "sin_gamma_r_plus_theta_0"),
];

/// The largest number of steps of an eigenvalue solve; the default is no bound at all.
const STEPS: usize = 10_000;

/// Which frequencies the sections have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frequencies {
    /// Three of their own.
    Any,
    /// One, as the closed form assumes.
    Equal,
}

/// Sections by quantity: slices of one length.
pub struct Sections {
    values: BTreeMap<&'static str, Column>,
}

impl Sections {
    /// As many sections, the same in every run.
    pub fn draw(points: usize, frequencies: Frequencies) -> Self {
        let mut state = 1_u64;
        let mut within = |from: f64, to: f64| {
            // Knuth's MMIX generator; the upper half of its bits is random enough here.
            state = state.wrapping_mul(6_364_136_223_846_793_005);
            state = state.wrapping_add(1_442_695_040_888_963_407);
            from + (to - from) * ((state >> 32) as f64 / 2.0_f64.powi(32))
        };
        let mut values: BTreeMap<&'static str, Vec<f64>> = BTreeMap::new();
        for (name, from, to) in DOMAIN {
            values.insert(name, (0..points).map(|_| within(from, to)).collect());
        }
        if frequencies == Frequencies::Equal {
            values.insert("omega_y", values["omega_x"].clone());
            values.insert("omega_theta", values["omega_x"].clone());
        }
        for (cosine, sine) in ANGLES {
            let angles: Vec<f64> = (0..points)
                .map(|_| within(0.0, std::f64::consts::TAU))
                .collect();
            values.insert(cosine, angles.iter().map(|angle| angle.cos()).collect());
            values.insert(sine, angles.iter().map(|angle| angle.sin()).collect());
        }
        let mut sections = Sections {
            values: BTreeMap::new(),
        };
        sections.add(values);
        let damping = sections.damping(points);
        sections.add(damping);
        sections
    }

    fn add(&mut self, columns: BTreeMap<&'static str, Vec<f64>>) {
        for (name, values) in columns {
            let mut column = Column::zeros(values.len(), self.values.len());
            column.copy_from_slice(&values);
            self.values.insert(name, column);
        }
    }

    /// S of Eq. (18) at every section.
    fn damping(&self, points: usize) -> BTreeMap<&'static str, Vec<f64>> {
        let mut columns: BTreeMap<&'static str, Vec<f64>> = BTreeMap::new();
        for point in 0..points {
            let at = |name: &str| self.of(name)[point];
            macro_rules! damping {
                ($($input:ident)*; $($output:ident)*) => {{
                    let found = aerodynamic_damping(&AerodynamicDampingInputs {
                        $($input: at(stringify!($input)),)*
                    });
                    $(columns.entry(stringify!($output)).or_default().push(found.$output);)*
                }};
            }
            damping!(r cos_alpha_0 sin_alpha_0 cos_gamma_r_plus_theta_0 sin_gamma_r_plus_theta_0
                     D L_a
                     C_D C_L dC_D dC_L C_M dC_M;
                     S_xx S_xy S_yx S_yy S_xt S_yt S_tx S_ty S_tt);
        }
        columns
    }

    /// A quantity at all sections.
    pub fn of(&self, name: &str) -> &[f64] {
        &self.values[name]
    }

    /// The state matrix of Eq. (16) at one section.
    pub fn state_matrix(&self, point: usize) -> Matrix6<f64> {
        let at = |name: &str| self.of(name)[point];
        let (m, r, offset) = (at("m"), at("r"), at("L_g"));
        let x = offset * at("sin_alpha_g_plus_theta_0");
        let y = offset * at("cos_alpha_g_plus_theta_0");
        let mass = m * Matrix3::new(1.0, 0.0, x, 0.0, 1.0, y, x, y, r * r);
        let weights = [m, m, m * r * r];
        let frequencies = ["omega_x", "omega_y", "omega_theta"].map(at);
        let ratios = ["zeta_x", "zeta_y", "zeta_theta"].map(at);
        let wind = 0.5 * at("rho") * at("D") * at("U");
        let names = [
            ["S_xx", "S_xy", "S_xt"],
            ["S_yx", "S_yy", "S_yt"],
            ["S_tx", "S_ty", "S_tt"],
        ];
        let arm = [1.0, 1.0, r];
        let mut stiffness = Matrix3::zeros();
        let mut damping =
            Matrix3::from_fn(|row, column| wind * arm[row] * arm[column] * at(names[row][column]));
        for place in 0..3 {
            let (weight, frequency) = (weights[place], frequencies[place]);
            stiffness[(place, place)] = weight * frequency * frequency;
            damping[(place, place)] += 2.0 * weight * frequency * ratios[place];
        }
        let inverse = mass.try_inverse().unwrap();
        let mut state = Matrix6::zeros();
        state.fixed_view_mut::<3, 3>(0, 3).fill_with_identity();
        state
            .fixed_view_mut::<3, 3>(3, 0)
            .copy_from(&(-inverse * stiffness));
        state
            .fixed_view_mut::<3, 3>(3, 3)
            .copy_from(&(-inverse * damping));
        state
    }
}

/// The eigenvalues by nalgebra; None if they are not found in many steps.
pub fn eigenvalues_if_found(matrix: &Matrix6<f64>) -> Option<[Complex<f64>; 6]> {
    let schur = Schur::try_new(*matrix, f64::EPSILON, STEPS)?;
    Some(schur.complex_eigenvalues().into())
}
