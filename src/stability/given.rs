//! A section in the numbers that something is wanted in, bound to the inputs of emitted functions.
//!
//! Here, and nowhere else, the names of a section meet those of what was derived.

use std::cell::RefCell;

use sextic_evaluators::aerodynamic_damping::AerodynamicDampingInputs;
use sextic_evaluators::characteristic_polynomial::CharacteristicPolynomialInputs;
use sextic_evaluators::closed_form::ClosedFormInputs;
use sextic_evaluators::damping_coefficient::{DampingCoefficientInputs, damping_coefficient};
use sextic_evaluators::exact_modes::ExactModesInputs;
use sextic_evaluators::mean_twist::MeanTwistInputs;
use sextic_evaluators::no_wind_modes::NoWindModesInputs;
use sextic_evaluators::section_matrices::SectionMatricesInputs;
use sextic_evaluators::small_motion::{SmallMotionAngles, SmallMotionInputs};
use sextic_evaluators::small_quantities::{
    SmallQuantitiesInputs, SmallQuantitiesOutputs, small_quantities,
};
use sextic_evaluators::turn_stiffness::TurnStiffnessInputs;

use super::forces::{Coefficients, Matrix};
use super::parameters::Parameters;

/// A section in the numbers that its equations are wanted in; its angles count by their directions only.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given<T> {
    pub parameters: Parameters<T>,
    /// cos and sin of α_0.
    pub wind: [T; 2],
    /// cos and sin of α_g + θ_0.
    pub mass_centre: [T; 2],
    /// cos and sin of γ_r + θ_0.
    pub aerodynamic_centre: [T; 2],
}

impl<T> Given<T> {
    /// Parameters, by a function for numbers, and one for cosine and sine of a sum of angles.
    pub fn new<N>(
        p: &Parameters<N>,
        number: impl Fn(&N) -> T,
        direction: impl Fn(&[&N]) -> [T; 2],
    ) -> Self {
        Given {
            parameters: p.map(number),
            wind: direction(&[&p.wind_angle]),
            mass_centre: direction(&[&p.mass_centre_angle, &p.attitude]),
            aerodynamic_centre: direction(&[&p.aerodynamic_centre_angle, &p.attitude]),
        }
    }

    /// The same in other numbers.
    pub fn map<U>(&self, number: impl Fn(&T) -> U) -> Given<U> {
        let both = |own: &[T; 2]| own.each_ref().map(&number);
        Given {
            wind: both(&self.wind),
            mass_centre: both(&self.mass_centre),
            aerodynamic_centre: both(&self.aerodynamic_centre),
            parameters: self.parameters.map(&number),
        }
    }

    /// Its numbers in one order for all sections, and the places that they have there.
    pub fn flattened(&self) -> (Given<usize>, Vec<T>)
    where
        T: Clone,
    {
        let values = RefCell::new(Vec::new());
        let places = self.map(|own| {
            let mut values = values.borrow_mut();
            values.push(own.clone());
            values.len() - 1
        });
        (places, values.into_inner())
    }
}

impl Parameters {
    /// As [`Section::damping_coefficient`](super::section::Section::damping_coefficient), without a check of the parameters.
    pub fn damping_coefficient(&self, real_part: f64) -> Option<f64> {
        let coefficient = damping_coefficient(&self.damping_coefficient_inputs(real_part));
        (self.wind_speed > 0.0 && coefficient.S.is_finite()).then_some(coefficient.S)
    }

    /// e = L_g/r and δ = ρDU/(2mω) with the frequency of the first free coordinate, without a check of the parameters.
    pub fn small_quantities(&self) -> SmallQuantitiesOutputs<f64> {
        let omega = self.natural_frequencies[self.free.as_slice()[0].index()];
        small_quantities(&self.small_quantities_inputs(omega))
    }

    /// A power of 2 near the largest natural frequency of a free coordinate, in rad/s.
    pub(super) fn frequency_unit(&self) -> f64 {
        let free = self.free.as_slice().iter();
        let frequencies = free.map(|free| self.natural_frequencies[free.index()]);
        frequencies.fold(0.0, f64::max).log2().floor().exp2()
    }
}

#[allow(non_snake_case)]
impl<T: Copy> Parameters<T> {
    /// With a real part.
    pub(super) fn damping_coefficient_inputs(&self, lamda_R: T) -> DampingCoefficientInputs<T> {
        DampingCoefficientInputs {
            m: self.mass,
            rho: self.air_density,
            D: self.reference_dimension,
            U: self.wind_speed,
            lamda_R,
        }
    }

    /// With a twist, and the moment coefficient and its slope there.
    pub(super) fn mean_twist_inputs(&self, theta_s: T, C_M: T, dC_M: T) -> MeanTwistInputs<T> {
        MeanTwistInputs {
            m: self.mass,
            r: self.radius_of_gyration,
            omega_theta: self.natural_frequencies[2],
            rho: self.air_density,
            D: self.reference_dimension,
            U: self.wind_speed,
            theta_s,
            C_M,
            dC_M,
        }
    }

    /// With the frequency that small quantities are beside.
    pub(super) fn small_quantities_inputs(&self, omega_n: T) -> SmallQuantitiesInputs<T> {
        SmallQuantitiesInputs {
            r: self.radius_of_gyration,
            L_g: self.mass_centre_distance,
            m: self.mass,
            omega_n,
            rho: self.air_density,
            D: self.reference_dimension,
            U: self.wind_speed,
        }
    }
}

impl Given<f64> {
    /// A section in doubles.
    pub fn of(parameters: &Parameters) -> Self {
        Given::new(parameters, f64::clone, |angles| {
            let sum: f64 = angles.iter().copied().sum();
            [sum.cos(), sum.sin()]
        })
    }

    /// With a point of the body, at a distance from O and an angle from the line through O and G, and a motion.
    #[allow(non_snake_case)]
    pub fn small_motion_inputs(
        &self,
        L_b: f64,
        angle: f64,
        [a_x, a_y, a_theta]: [f64; 3],
    ) -> SmallMotionInputs<f64> {
        SmallMotionInputs::from(&SmallMotionAngles {
            theta_0: self.parameters.attitude,
            L_b,
            beta_b: self.parameters.mass_centre_angle + angle,
            a_x,
            a_y,
            a_theta,
        })
    }

    /// The same with time in units of 1/unit, a power of 2, which rounds nothing.
    pub fn in_units_of(mut self, unit: f64) -> Self {
        let p = &mut self.parameters;
        p.natural_frequencies = p.natural_frequencies.map(|own| own / unit);
        // The damping of the wind goes with U over the unit of frequency.
        p.wind_speed /= unit;
        self
    }
}

#[allow(non_snake_case)]
impl<T: Copy> Given<T> {
    /// With S_a.
    pub fn section_matrices_inputs(&self, s_a: &Matrix<T>) -> SectionMatricesInputs<T> {
        let p = &self.parameters;
        let [cosine, sine] = self.mass_centre;
        let [omega_x, omega_y, omega_theta] = p.natural_frequencies;
        let [zeta_x, zeta_y, zeta_theta] = p.damping_ratios;
        let [[S_xx, S_xy, S_xt], [S_yx, S_yy, S_yt], [S_tx, S_ty, S_tt]] = *s_a;
        SectionMatricesInputs {
            m: p.mass,
            r: p.radius_of_gyration,
            L_g: p.mass_centre_distance,
            cos_alpha_g_plus_theta_0: cosine,
            sin_alpha_g_plus_theta_0: sine,
            omega_x,
            omega_y,
            omega_theta,
            zeta_x,
            zeta_y,
            zeta_theta,
            rho: p.air_density,
            D: p.reference_dimension,
            U: p.wind_speed,
            S_xx,
            S_xy,
            S_yx,
            S_yy,
            S_xt,
            S_yt,
            S_tx,
            S_ty,
            S_tt,
        }
    }

    /// With S_a, and what is open of directions and of S_a.
    pub fn exact_modes_inputs(
        &self,
        s_a: &Matrix<T>,
        [direction_error, damping_error]: [T; 2],
    ) -> ExactModesInputs<T> {
        ExactModesInputs {
            section: self.section_matrices_inputs(s_a),
            direction_error,
            damping_error,
        }
    }

    /// With S_a.
    pub fn closed_form_inputs(&self, s_a: &Matrix<T>) -> ClosedFormInputs<T> {
        let own = self.section_matrices_inputs(s_a);
        ClosedFormInputs {
            m: own.m,
            r: own.r,
            L_g: own.L_g,
            cos_alpha_g_plus_theta_0: own.cos_alpha_g_plus_theta_0,
            sin_alpha_g_plus_theta_0: own.sin_alpha_g_plus_theta_0,
            rho: own.rho,
            D: own.D,
            U: own.U,
            S_xx: own.S_xx,
            S_xy: own.S_xy,
            S_yx: own.S_yx,
            S_yy: own.S_yy,
            S_xt: own.S_xt,
            S_yt: own.S_yt,
            S_tx: own.S_tx,
            S_ty: own.S_ty,
            S_tt: own.S_tt,
        }
    }

    /// With coefficients.
    pub fn aerodynamic_damping_inputs(&self, c: &Coefficients<T>) -> AerodynamicDampingInputs<T> {
        let p = &self.parameters;
        AerodynamicDampingInputs {
            r: p.radius_of_gyration,
            cos_alpha_0: self.wind[0],
            sin_alpha_0: self.wind[1],
            cos_gamma_r_plus_theta_0: self.aerodynamic_centre[0],
            sin_gamma_r_plus_theta_0: self.aerodynamic_centre[1],
            D: p.reference_dimension,
            L_a: p.aerodynamic_centre_distance,
            C_D: c.drag,
            C_L: c.lift,
            dC_D: c.drag_slope,
            dC_L: c.lift_slope,
            C_M: c.moment,
            dC_M: c.moment_slope,
        }
    }

    /// With coefficients.
    pub fn turn_stiffness_inputs(&self, c: &Coefficients<T>) -> TurnStiffnessInputs<T> {
        let p = &self.parameters;
        TurnStiffnessInputs {
            m: p.mass,
            r: p.radius_of_gyration,
            cos_alpha_0: self.wind[0],
            sin_alpha_0: self.wind[1],
            rho: p.air_density,
            D: p.reference_dimension,
            U: p.wind_speed,
            dC_D: c.drag_slope,
            dC_L: c.lift_slope,
            dC_M: c.moment_slope,
        }
    }

    /// With the natural frequency of all motions.
    pub fn no_wind_modes_inputs(&self, omega_n: T) -> NoWindModesInputs<T> {
        NoWindModesInputs {
            r: self.parameters.radius_of_gyration,
            L_g: self.parameters.mass_centre_distance,
            cos_alpha_g_plus_theta_0: self.mass_centre[0],
            sin_alpha_g_plus_theta_0: self.mass_centre[1],
            omega_n,
        }
    }

    /// With coefficients.
    pub fn characteristic_polynomial_inputs(
        &self,
        c: &Coefficients<T>,
    ) -> CharacteristicPolynomialInputs<T> {
        let p = &self.parameters;
        let [omega_x, omega_y, omega_theta] = p.natural_frequencies;
        let [zeta_x, zeta_y, zeta_theta] = p.damping_ratios;
        CharacteristicPolynomialInputs {
            m: p.mass,
            r: p.radius_of_gyration,
            L_g: p.mass_centre_distance,
            cos_alpha_0: self.wind[0],
            sin_alpha_0: self.wind[1],
            cos_alpha_g_plus_theta_0: self.mass_centre[0],
            sin_alpha_g_plus_theta_0: self.mass_centre[1],
            cos_gamma_r_plus_theta_0: self.aerodynamic_centre[0],
            sin_gamma_r_plus_theta_0: self.aerodynamic_centre[1],
            omega_x,
            omega_y,
            omega_theta,
            zeta_x,
            zeta_y,
            zeta_theta,
            rho: p.air_density,
            D: p.reference_dimension,
            U: p.wind_speed,
            L_a: p.aerodynamic_centre_distance,
            C_D: c.drag,
            C_L: c.lift,
            dC_D: c.drag_slope,
            dC_L: c.lift_slope,
            C_M: c.moment,
            dC_M: c.moment_slope,
        }
    }
}
