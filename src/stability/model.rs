//! The equations of motion of a section, M q̈ + (C_s + C_a) q̇ + K q = 0, Eqs. (9), (10) and (12).

use nalgebra::DMatrix;
use num_complex::Complex;
use sextic_evaluators::aerodynamic_damping::{
    AerodynamicDampingAngles, AerodynamicDampingInputs, aerodynamic_damping_with_bound,
};
use sextic_evaluators::bounded::Bounded;

use super::ball::Ball;
use super::error::StabilityError;
use super::section::Section;

/// The matrices of a section for its free coordinates.
///
/// He & Macdonald (2017), Eqs. (9), (12) and (17), with φ = α_g + θ_0 and S_a of Eq. (18):
///
/// ```text
/// M   = m [1, 0, L_g sin φ;  0, 1, L_g cos φ;  L_g sin φ, L_g cos φ, r²]
/// C_s = diagonal(2 m ω_x ζ_x, 2 m ω_y ζ_y, 2 m r² ω_θ ζ_θ)
/// C_a = ρ D U/2 · diagonal(1, 1, r) S_a diagonal(1, 1, r)
/// K   = diagonal(m ω_x², m ω_y², m r² ω_θ²)
/// ```
///
/// Rows and columns of coordinates that are held are left out: with n free coordinates the matrices
/// are n×n. Aerodynamic stiffness is left out, as in the paper. Inside, rθ stands in place of θ, all
/// is divided by m, and time is counted in units of a power of 2, which rounds nothing.
#[derive(Clone, Debug)]
pub struct Model {
    section: Section,
    /// A power of 2 near the largest natural frequency, in rad/s.
    pub(super) frequency_unit: f64,
    pub(super) mass: Vec<Vec<Ball>>,
    structural_damping: Vec<Vec<Ball>>,
    aerodynamic_damping: Vec<Vec<Ball>>,
    pub(super) stiffness: Vec<Vec<Ball>>,
}

impl Model {
    /// The model of a section.
    ///
    /// # Errors
    ///
    /// [`StabilityError::OutOfRange`] if a matrix overflows.
    pub fn new(section: &Section) -> Result<Self, StabilityError> {
        let p = section.parameters();
        let free: Vec<usize> = section.free().iter().map(|free| free.index()).collect();
        let largest = free
            .iter()
            .map(|&i| p.natural_frequencies[i])
            .fold(0.0, f64::max);
        let unit = largest.log2().floor().exp2();
        let [omega_x, omega_y, omega_theta] =
            p.natural_frequencies.map(|omega| rounded(omega / unit));
        let omega = [omega_x, omega_y, omega_theta];
        let e = rounded(section.eccentricity());
        let angle = p.mass_centre_angle + p.attitude;
        let (sin, cos) = (e * rounded(angle.sin()), e * rounded(angle.cos()));
        let wind = p.air_density * p.reference_dimension * p.wind_speed / (2.0 * p.mass) / unit;
        let delta = Ball::real(wind, 4.0 * f64::EPSILON * wind + f64::MIN_POSITIVE);
        let s_a = scaled_aerodynamic_damping(section);

        let mass = [
            [Ball::ONE, Ball::ZERO, sin],
            [Ball::ZERO, Ball::ONE, cos],
            [sin, cos, Ball::ONE],
        ];
        let two = Ball::real(2.0, 0.0);
        let ratio = |i: usize| Ball::real(p.damping_ratios[i], 0.0);
        let matrix = |entry: &dyn Fn(usize, usize) -> Ball| -> Vec<Vec<Ball>> {
            let row = |&i: &usize| free.iter().map(|&j| entry(i, j)).collect();
            free.iter().map(row).collect()
        };
        let diagonal = |i, j, entry: Ball| if i == j { entry } else { Ball::ZERO };
        let model = Model {
            section: section.clone(),
            frequency_unit: unit,
            mass: matrix(&|i, j| mass[i][j]),
            structural_damping: matrix(&|i, j| diagonal(i, j, two * ratio(i) * omega[i])),
            aerodynamic_damping: matrix(&|i, j| delta * s_a[i][j]),
            stiffness: matrix(&|i, j| diagonal(i, j, omega[i] * omega[i])),
        };
        if model.is_finite() {
            Ok(model)
        } else {
            Err(StabilityError::OutOfRange)
        }
    }

    fn is_finite(&self) -> bool {
        let damping = [&self.structural_damping, &self.aerodynamic_damping];
        let matrices = [&self.mass, &self.stiffness].into_iter().chain(damping);
        let mut entries = matrices.flatten().flatten();
        self.frequency_unit.is_normal() && entries.all(|ball| ball.is_finite())
    }

    /// The section.
    pub fn section(&self) -> &Section {
        &self.section
    }

    /// n, the number of free coordinates: 1, 2 or 3.
    pub fn freedom(&self) -> usize {
        self.mass.len()
    }

    /// M, the mass matrix of Eq. (9), n×n: in kg/m, kg and kg·m.
    pub fn mass(&self) -> DMatrix<f64> {
        self.in_si(&self.mass, 0)
    }

    /// C_s, the structural damping matrix of Eq. (9), n×n: in N·s/m², N·s/m and N·s.
    pub fn structural_damping(&self) -> DMatrix<f64> {
        self.in_si(&self.structural_damping, 1)
    }

    /// C_a, the aerodynamic damping matrix of Eq. (12), n×n: in N·s/m², N·s/m and N·s.
    pub fn aerodynamic_damping(&self) -> DMatrix<f64> {
        self.in_si(&self.aerodynamic_damping, 1)
    }

    /// K, the stiffness matrix of Eq. (9), n×n: in N/m², N/m and N.
    pub fn stiffness(&self) -> DMatrix<f64> {
        self.in_si(&self.stiffness, 2)
    }

    /// A = \[0, I; −M⁻¹K, −M⁻¹(C_s + C_a)\], the state matrix of Eq. (16) with structural damping,
    /// 2n×2n, for the state (q, q̇) in SI units.
    pub fn state_matrix(&self) -> DMatrix<f64> {
        let (n, unit) = (self.freedom(), self.frequency_unit);
        let mut matrix = self.scaled_state_matrix();
        for (row, column) in (0..2 * n).flat_map(|row| (0..2 * n).map(move |column| (row, column)))
        {
            // Velocities in units of length times the unit of frequency, turns in units of length.
            let scale = |index: usize| {
                let rate = if index < n { 1.0 } else { unit };
                rate / self.length(index % n)
            };
            matrix[(row, column)] *= unit * scale(row) / scale(column);
        }
        matrix
    }

    /// The state matrix for rθ in place of θ, and time in units of 1/frequency_unit.
    pub(super) fn scaled_state_matrix(&self) -> DMatrix<f64> {
        let n = self.freedom();
        let inverse = self.inverse_mass();
        let damping = centres(&self.structural_damping) + centres(&self.aerodynamic_damping);
        let mut matrix = DMatrix::zeros(2 * n, 2 * n);
        matrix.view_mut((0, n), (n, n)).fill_with_identity();
        matrix
            .view_mut((n, 0), (n, n))
            .copy_from(&(-&inverse * centres(&self.stiffness)));
        matrix
            .view_mut((n, n), (n, n))
            .copy_from(&(-&inverse * damping));
        matrix
    }

    /// δ|S| with δ = ρ D U/(2 m ω_n), and the Frobenius norm of S_a.
    pub(super) fn relative_aerodynamic_damping(&self, omega_n: f64) -> f64 {
        centres(&self.aerodynamic_damping).norm() * self.frequency_unit / omega_n
    }

    /// M⁻¹, scaled: M = I + N with N³ = |N|² N has the inverse I + (N² − N)/(1 − |N|²), where |N|² is
    /// the square of the inertial coupling to the turn.
    fn inverse_mass(&self) -> DMatrix<f64> {
        let n = self.freedom();
        let identity = DMatrix::identity(n, n);
        let coupling = centres(&self.mass) - &identity;
        let square = &coupling * &coupling;
        let strength = square[(n - 1, n - 1)];
        identity + (square - coupling) / (1.0 - strength)
    }

    /// c²M + cC + K, 2cM + C and M: the coefficients of B(c + μ) in powers of μ, where
    /// B(λ) = λ²M + λC + K, scaled.
    pub(super) fn dynamic_stiffness(&self, point: Complex<f64>) -> Vec<Vec<[Ball; 3]>> {
        let c = Ball::exact(point);
        let n = self.freedom();
        let entry = |i: usize, j: usize| {
            let (m, k) = (self.mass[i][j], self.stiffness[i][j]);
            let damping = self.structural_damping[i][j] + self.aerodynamic_damping[i][j];
            let once = c * m + damping;
            [c * once + k, c * m + once, m]
        };
        (0..n)
            .map(|i| (0..n).map(|j| entry(i, j)).collect())
            .collect()
    }

    /// det B(c + μ) in powers of μ, scaled: 2n + 1 coefficients, that of μ⁰ first.
    pub(super) fn taylor(&self, point: Complex<f64>) -> Vec<Ball> {
        let entries: Vec<Vec<Vec<Ball>>> = self
            .dynamic_stiffness(point)
            .into_iter()
            .map(|row| row.into_iter().map(Vec::from).collect())
            .collect();
        determinant(&entries)
    }

    /// The length that turns coordinate `index` of the free ones into a length: r for θ, else 1.
    pub(super) fn length(&self, index: usize) -> f64 {
        match self.section.free()[index] {
            super::coordinate::Coordinate::Theta => self.section.parameters().radius_of_gyration,
            _ => 1.0,
        }
    }

    /// A scaled matrix with its `rates` powers of the unit of frequency in SI units.
    fn in_si(&self, matrix: &[Vec<Ball>], rates: i32) -> DMatrix<f64> {
        let factor = self.section.parameters().mass * self.frequency_unit.powi(rates);
        let scaled = centres(matrix);
        let n = self.freedom();
        DMatrix::from_fn(n, n, |i, j| {
            factor * scaled[(i, j)] * self.length(i) * self.length(j)
        })
    }
}

/// S_a of Eq. (18), by the generated evaluator.
fn scaled_aerodynamic_damping(section: &Section) -> [[Ball; 3]; 3] {
    let (p, c) = (section.parameters(), section.parameters().coefficients);
    let s = aerodynamic_damping_with_bound(&AerodynamicDampingInputs::from(
        &AerodynamicDampingAngles {
            r: p.radius_of_gyration,
            alpha_0: p.wind_angle,
            gamma_r: p.aerodynamic_centre_angle,
            theta_0: p.attitude,
            D: p.reference_dimension,
            L_a: p.aerodynamic_centre_distance,
            C_D: c.drag,
            C_L: c.lift,
            dC_D: c.drag_slope,
            dC_L: c.lift_slope,
            C_M: c.moment,
            dC_M: c.moment_slope,
        },
    ));
    [
        [s.S_xx, s.S_xy, s.S_xt],
        [s.S_yx, s.S_yy, s.S_yt],
        [s.S_tx, s.S_ty, s.S_tt],
    ]
    .map(|row| row.map(derived))
}

/// What a generated evaluator gives, with a bound that counts the rounding of sines and cosines:
/// each of them enters at most four times, and not more heavily than the first product with it.
pub(super) fn derived(value: Bounded) -> Ball {
    Ball::real(
        value.value,
        8.0 * value.error + 4.0 * f64::EPSILON * value.value.abs(),
    )
}

/// A number that is rounded, or a sine: right to a unit in the last place.
fn rounded(value: f64) -> Ball {
    Ball::real(value, f64::EPSILON * value.abs())
}

fn centres(matrix: &[Vec<Ball>]) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.len(), matrix.len(), |i, j| matrix[i][j].centre.re)
}

/// The determinant of a matrix of polynomials, by its first row.
fn determinant(rows: &[Vec<Vec<Ball>>]) -> Vec<Ball> {
    let Some((first, below)) = rows.split_first() else {
        return vec![Ball::ONE];
    };
    let mut sum = vec![Ball::ZERO; 2 * rows.len() + 1];
    for (column, entry) in first.iter().enumerate() {
        let without = |row: &Vec<Vec<Ball>>| -> Vec<Vec<Ball>> {
            let mut row = row.clone();
            row.remove(column);
            row
        };
        let minor = determinant(&below.iter().map(without).collect::<Vec<_>>());
        for (i, &a) in entry.iter().enumerate() {
            for (j, &b) in minor.iter().enumerate() {
                let term = if column % 2 == 0 { a * b } else { -(a * b) };
                sum[i + j] = sum[i + j] + term;
            }
        }
    }
    sum
}
