//! The equations of motion of a section, M q̈ + (C_s + C_a) q̇ + (K + K_a) q = 0, Eqs. (9), (10) and (12).

use nalgebra::{DMatrix, Matrix3};

use super::ball::{Ball, cosine_and_sine, quotient, rounded};
use super::coordinate::Coordinate;
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
/// K_a = −ρ D U²/2 [0, 0, C_D′ c − C_L′ s;  0, 0, C_D′ s + C_L′ c;  0, 0, D C_M′]
/// ```
///
/// K_a, with c = cos α_0 and s = sin α_0, is the aerodynamic stiffness of `derivations/extensions.md`,
/// section 3: 0 unless the parameters ask for it, since the paper leaves it out.
///
/// Rows and columns of coordinates that are held are left out: with n free coordinates the matrices
/// are n×n. Inside, rθ stands in place of θ, all is divided by m, and time is counted in units of a power
/// of 2, which rounds nothing.
#[derive(Clone, Debug)]
pub struct Model {
    section: Section,
    /// A power of 2 near the largest natural frequency, in rad/s.
    pub(super) frequency_unit: f64,
    /// iω of the free coordinates, scaled.
    frequencies: [Ball; 3],
    pub(super) mass: Matrix,
    structural_damping: Matrix,
    aerodynamic_damping: Matrix,
    stiffness: Matrix,
    aerodynamic_stiffness: Matrix,
}

/// A matrix for up to three free coordinates: with n of them only the first n rows and columns count.
type Matrix = [[Ball; 3]; 3];

impl Model {
    /// The model of a section.
    ///
    /// # Errors
    ///
    /// [`StabilityError::OutOfRange`] if a matrix overflows.
    pub fn new(section: &Section) -> Result<Self, StabilityError> {
        let p = section.parameters();
        let free = section.free().iter().map(|free| free.index());
        let largest = free.map(|i| p.natural_frequencies[i]).fold(0.0, f64::max);
        let unit = largest.log2().floor().exp2();
        let [omega_x, omega_y, omega_theta] =
            p.natural_frequencies.map(|omega| rescaled(omega / unit));
        let omega = [omega_x, omega_y, omega_theta];
        let e = rounded(section.eccentricity());
        let [cos, sin] = cosine_and_sine(&[p.attitude, p.mass_centre_angle]).map(|own| e * own);
        let wind = p.air_density * p.reference_dimension * p.wind_speed / (2.0 * p.mass) / unit;
        // What is subnormal has lost digits, and what is too large is lost.
        let products = [
            2.0 * p.mass,
            p.air_density * p.reference_dimension,
            p.air_density * p.reference_dimension * p.wind_speed,
        ];
        let is_usual = |product: f64| product.is_normal();
        if !products[..2].iter().copied().all(is_usual)
            || !(is_usual(products[2]) || p.wind_speed == 0.0)
        {
            return Err(StabilityError::OutOfRange);
        }
        let delta = Ball::real(wind, 4.0 * f64::EPSILON * wind + f64::MIN_POSITIVE);
        let s_a = section.scaled_damping_with_bound();
        let k_a = section.turn_stiffness_with_bound();
        // ρDU²/(2mr), for the turn rθ.
        let pressure = delta * rescaled(p.wind_speed / unit) * quotient(1.0, p.radius_of_gyration);

        let mass = [
            [Ball::ONE, Ball::ZERO, sin],
            [Ball::ZERO, Ball::ONE, cos],
            [sin, cos, Ball::ONE],
        ];
        let two = Ball::real(2.0, 0.0);
        let ratio = |i: usize| Ball::real(p.damping_ratios[i], 0.0);
        let matrix = |entry: &dyn Fn(usize, usize) -> Ball| -> Matrix {
            let own = |place: usize| section.free().get(place).map(|free| free.index());
            let entry = |row, column| match (own(row), own(column)) {
                (Some(i), Some(j)) => entry(i, j),
                _ => Ball::ZERO,
            };
            std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column)))
        };
        let diagonal = |i, j, entry: Ball| if i == j { entry } else { Ball::ZERO };
        let model = Model {
            section: *section,
            frequency_unit: unit,
            frequencies: std::array::from_fn(|place| {
                let own = section.free().get(place);
                own.map_or(Ball::ZERO, |own| omega[own.index()].turned())
            }),
            mass: matrix(&|i, j| mass[i][j]),
            structural_damping: matrix(&|i, j| diagonal(i, j, two * omega[i] * ratio(i))),
            aerodynamic_damping: matrix(&|i, j| delta * s_a[i][j]),
            stiffness: matrix(&|i, j| diagonal(i, j, omega[i] * omega[i])),
            aerodynamic_stiffness: matrix(&|i, j| match (k_a, j) {
                (Some(k_a), 2) => pressure * k_a[i],
                _ => Ball::ZERO,
            }),
        };
        if model.is_finite() {
            Ok(model)
        } else {
            Err(StabilityError::OutOfRange)
        }
    }

    fn is_finite(&self) -> bool {
        let damping = [&self.structural_damping, &self.aerodynamic_damping];
        let stiffness = [&self.stiffness, &self.aerodynamic_stiffness];
        let matrices = [&self.mass].into_iter().chain(damping).chain(stiffness);
        let mut entries = matrices.flatten().flatten();
        self.frequency_unit.is_normal() && entries.all(|ball| ball.is_finite())
    }

    /// The section.
    pub fn section(&self) -> &Section {
        &self.section
    }

    /// n, the number of free coordinates: 1, 2 or 3.
    pub fn freedom(&self) -> usize {
        self.section.free().len()
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

    /// K_a, the aerodynamic stiffness matrix, n×n: in N/m², N/m and N; 0 where it is left out.
    ///
    /// A displacement q of the section adds −K_a q to the forces of the wind.
    pub fn aerodynamic_stiffness(&self) -> DMatrix<f64> {
        self.in_si(&self.aerodynamic_stiffness, 2)
    }

    /// A = \[0, I; −M⁻¹(K + K_a), −M⁻¹(C_s + C_a)\], the state matrix of Eq. (16) with structural damping
    /// and aerodynamic stiffness, 2n×2n, for the state (q, q̇) in SI units.
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
        let damping =
            self.centres(&self.structural_damping) + self.centres(&self.aerodynamic_damping);
        let stiffness = self.centres(&self.stiffness) + self.centres(&self.aerodynamic_stiffness);
        let mut matrix = DMatrix::zeros(2 * n, 2 * n);
        matrix.view_mut((0, n), (n, n)).fill_with_identity();
        matrix
            .view_mut((n, 0), (n, n))
            .copy_from(&(-&inverse * stiffness));
        matrix
            .view_mut((n, n), (n, n))
            .copy_from(&(-&inverse * damping));
        matrix
    }

    /// M for three free coordinates, scaled.
    pub(super) fn scaled_mass(&self) -> Matrix3<f64> {
        Matrix3::from_fn(|i, j| self.mass[i][j].centre.re)
    }

    /// The median ω_0 of three natural frequencies, and K − ω_0² M, scaled, where nearly equal frequencies lose
    /// no digits.
    pub(super) fn shifted_stiffness(&self) -> (f64, Matrix3<f64>) {
        let omega = self.frequencies.map(|own| own.centre.im);
        let [x, y, theta] = omega;
        let median = x.min(y).max(x.max(y).min(theta));
        let entry = |i: usize, j: usize| match i == j {
            true => (omega[i] - median) * (omega[i] + median),
            false => -median * median * self.mass[i][j].centre.re,
        };
        (median, Matrix3::from_fn(entry))
    }

    /// C_s + C_a for three free coordinates, scaled.
    pub(super) fn scaled_damping(&self) -> Matrix3<f64> {
        let damping = |i: usize, j: usize| {
            self.structural_damping[i][j].centre.re + self.aerodynamic_damping[i][j].centre.re
        };
        Matrix3::from_fn(damping)
    }

    /// M⁻¹, scaled: M = I + N with N³ = |N|² N has the inverse I + (N² − N)/(1 − |N|²), where |N|² is
    /// the square of the inertial coupling to the turn.
    fn inverse_mass(&self) -> DMatrix<f64> {
        let n = self.freedom();
        let identity = DMatrix::identity(n, n);
        let coupling = self.centres(&self.mass) - &identity;
        let square = &coupling * &coupling;
        let strength = square[(n - 1, n - 1)];
        identity + (square - coupling) / (1.0 - strength)
    }

    /// c²M + cC + K, 2cM + C and M: the coefficients of B(c + μ) in powers of μ, where
    /// B(λ) = λ²M + λC + K, scaled, with all damping in C and all stiffness in K. For coordinates that are
    /// held it is the unit matrix.
    pub(super) fn dynamic_stiffness(&self, c: Ball) -> [[Quadratic; 3]; 3] {
        let entry = |i: usize, j: usize| {
            if i.max(j) >= self.freedom() {
                let unit = if i == j { Ball::ONE } else { Ball::ZERO };
                return [unit, Ball::ZERO, Ball::ZERO];
            }
            let (m, k_a) = (self.mass[i][j], self.aerodynamic_stiffness[i][j]);
            let damping = self.structural_damping[i][j] + self.aerodynamic_damping[i][j];
            let once = c * m + damping;
            let constant = if i == j {
                // Near an eigenvalue this loses nothing, but c² + ω² nearly all.
                let natural = self.frequencies[i];
                (c + -natural) * (c + natural) + (c * damping + k_a)
            } else {
                c * once + k_a
            };
            [constant, c * m + once, m]
        };
        std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
    }

    /// det B(c + μ) in powers of μ, scaled, that of μ⁰ first; beyond 2n they are 0.
    pub(super) fn taylor(&self, c: Ball) -> [Ball; 7] {
        determinant(&self.dynamic_stiffness(c))
    }

    /// 2ω, by which a damping ratio enters the scaled damping of its coordinate.
    pub(super) fn structural_damping_rate(&self, coordinate: Coordinate) -> Ball {
        let omega = self.section.parameters().natural_frequencies[coordinate.index()];
        Ball::real(2.0, 0.0) * rescaled(omega / self.frequency_unit)
    }

    /// The length that turns coordinate `index` of the free ones into a length: r for θ, else 1.
    pub(super) fn length(&self, index: usize) -> f64 {
        match self.section.free()[index] {
            Coordinate::Theta => self.section.parameters().radius_of_gyration,
            _ => 1.0,
        }
    }

    /// A scaled matrix with its `rates` powers of the unit of frequency in SI units.
    fn in_si(&self, matrix: &Matrix, rates: i32) -> DMatrix<f64> {
        let factor = self.section.parameters().mass * self.frequency_unit.powi(rates);
        let n = self.freedom();
        DMatrix::from_fn(n, n, |i, j| {
            factor * matrix[i][j].centre.re * self.length(i) * self.length(j)
        })
    }

    fn centres(&self, matrix: &Matrix) -> DMatrix<f64> {
        DMatrix::from_fn(self.freedom(), self.freedom(), |i, j| {
            matrix[i][j].centre.re
        })
    }
}

/// A number over a power of two, which rounds nothing but what becomes subnormal.
fn rescaled(value: f64) -> Ball {
    let error = if value.is_normal() {
        0.0
    } else {
        f64::MIN_POSITIVE
    };
    Ball::real(value, error)
}

/// The coefficients of μ⁰, μ¹ and μ².
type Quadratic = [Ball; 3];

/// The determinant of a matrix of polynomials in μ, by its first row.
fn determinant(rows: &[[Quadratic; 3]; 3]) -> [Ball; 7] {
    let [first, second, third] = rows;
    let mut sum = [Ball::ZERO; 7];
    for (column, entry) in first.iter().enumerate() {
        // The next columns in a circle give each minor its sign.
        let (next, last) = ((column + 1) % 3, (column + 2) % 3);
        let mut minor = [Ball::ZERO; 5];
        for (i, j) in pairs(3, 3) {
            let difference = second[next][i] * third[last][j] + -(second[last][i] * third[next][j]);
            minor[i + j] = minor[i + j] + difference;
        }
        for (i, j) in pairs(3, 5) {
            sum[i + j] = sum[i + j] + entry[i] * minor[j];
        }
    }
    sum
}

fn pairs(rows: usize, columns: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..rows).flat_map(move |row| (0..columns).map(move |column| (row, column)))
}
