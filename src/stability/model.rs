//! The equations of motion of a section in doubles, with bounds of all rounding.

use std::ops::{Add, Mul, Neg};

use nalgebra::DMatrix;
use sextic_evaluators::bounded::Bounded;

use super::ball::{Ball, cosine_and_sine};
use super::coordinate::Coordinate;
use super::error::StabilityError;
use super::forces::{Coefficients, Forces, Matrix};
use super::given::Given;
use super::section::{Open, Parameters, Section};

/// The matrices of a section for its free coordinates, Eqs. (9), (12), (17) and (18): those of
/// `derivations/exact-modes.md`, with the aerodynamic stiffness of `derivations/extensions.md`, section 3, where
/// the parameters ask for it.
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
    pub(super) mass: Matrix<Ball>,
    pub(super) structural_damping: Matrix<Ball>,
    pub(super) aerodynamic_damping: Matrix<Ball>,
    pub(super) stiffness: Matrix<Ball>,
    pub(super) aerodynamic_stiffness: Matrix<Ball>,
}

impl Model {
    /// The model of a section.
    ///
    /// # Errors
    ///
    /// [`StabilityError::OutOfRange`] if a matrix overflows.
    pub fn new(section: &Section) -> Result<Self, StabilityError> {
        let frequencies = section.parameters().natural_frequencies;
        let unit = section.parameters().frequency_unit();
        let own = given_with_bounds(section.parameters(), unit)
            .equations()
            .map(|own| Ball::from(*own));
        let matrix = |own: &Matrix<Ball>| free_entries(own, section.free());
        let model = Model {
            section: *section,
            frequency_unit: unit,
            frequencies: std::array::from_fn(|place| {
                let free = section.free().get(place);
                free.map_or(Ball::ZERO, |free| {
                    Ball::from(rescaled(frequencies[free.index()] / unit)).turned()
                })
            }),
            mass: matrix(&own.mass),
            structural_damping: matrix(&own.structural_damping),
            aerodynamic_damping: matrix(&own.aerodynamic_damping),
            stiffness: matrix(&own.stiffness),
            aerodynamic_stiffness: matrix(&own.aerodynamic_stiffness),
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
        let mass = self.centres(&self.mass);
        let inverse = mass
            .try_inverse()
            .unwrap_or_else(|| DMatrix::from_element(n, n, f64::NAN));
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

    /// c²M + cC + K, 2cM + C and M: the coefficients of B(c + μ) in powers of μ, where
    /// B(λ) = λ²M + λC + K, scaled, with all damping in C and all stiffness in K. For coordinates that are
    /// held it is the unit matrix.
    pub(super) fn dynamic_stiffness(&self, c: Ball) -> [[Quadratic; 3]; 3] {
        let entry = |i: usize, j: usize| {
            if i.max(j) >= self.freedom() {
                let unit = if i == j { Ball::ONE } else { Ball::ZERO };
                return [unit, Ball::ZERO, Ball::ZERO];
            }
            let m = self.mass[i][j];
            let damping = self.structural_damping[i][j] + self.aerodynamic_damping[i][j];
            let natural = (i == j).then_some(self.frequencies[i]);
            let constant = impedance(c, m, damping, natural) + self.aerodynamic_stiffness[i][j];
            [constant, c * m + (c * m + damping), m]
        };
        std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
    }

    /// det B(c + μ) in powers of μ, scaled, that of μ⁰ first; beyond 2n they are 0.
    pub(super) fn taylor(&self, c: Ball) -> [Ball; 7] {
        determinant(&self.dynamic_stiffness(c))
    }

    /// Whether the wind turns the section over, by the sign of |K + K_a|; `None` where rounding leaves it open.
    ///
    /// See [`ExactSection::diverges`](super::exact_section::ExactSection::diverges).
    pub fn diverges(&self) -> Option<bool> {
        if !self.section.parameters().aerodynamic_stiffness {
            return Some(false);
        }
        let Ball { centre, radius } = self.taylor(Ball::ZERO)[0];
        (centre.re.abs() > radius).then_some(centre.re < 0.0)
    }

    /// By what the scaled damping of each free coordinate grows with its damping ratio.
    pub(super) fn structural_damping_rates(&self) -> [Ball; 3] {
        let mut given = given_with_bounds(self.section.parameters(), self.frequency_unit);
        // C_s is linear in the ratios, and does not know of the wind.
        given.parameters.damping_ratios = [Bounded::exact(1.0); 3];
        given.parameters.forces = Forces::ScaledDamping([[Bounded::exact(0.0); 3]; 3]);
        let rates = given.equations().structural_damping;
        let rate = |place: usize| {
            let own = self.section.free().get(place);
            own.map_or(Ball::ZERO, |own| {
                Ball::from(rates[own.index()][own.index()])
            })
        };
        std::array::from_fn(rate)
    }

    /// The length that turns coordinate `index` of the free ones into a length: r for θ, else 1.
    pub(super) fn length(&self, index: usize) -> f64 {
        match self.section.free()[index] {
            Coordinate::Theta => self.section.parameters().radius_of_gyration,
            _ => 1.0,
        }
    }

    /// A scaled matrix with its `rates` powers of the unit of frequency in SI units.
    fn in_si(&self, matrix: &Matrix<Ball>, rates: i32) -> DMatrix<f64> {
        let factor = self.section.parameters().mass * self.frequency_unit.powi(rates);
        let n = self.freedom();
        DMatrix::from_fn(n, n, |i, j| {
            factor * matrix[i][j].centre.re * self.length(i) * self.length(j)
        })
    }

    fn centres(&self, matrix: &Matrix<Ball>) -> DMatrix<f64> {
        DMatrix::from_fn(self.freedom(), self.freedom(), |i, j| {
            matrix[i][j].centre.re
        })
    }
}

/// λ²m + λc, and on the diagonal (λ − iω)(λ + iω) + λc with the mass 1 and iω: near an eigenvalue this loses nothing,
/// but λ² + ω² nearly all.
pub(super) fn impedance<T>(lambda: T, mass: T, damping: T, natural: Option<T>) -> T
where
    T: Copy + Add<Output = T> + Mul<Output = T> + Neg<Output = T>,
{
    match natural {
        Some(natural) => (lambda + -natural) * (lambda + natural) + lambda * damping,
        None => lambda * (lambda * mass + damping),
    }
}

/// A section in doubles with bounds, time being counted in units of 1/unit, a power of 2.
pub(super) fn given_with_bounds(p: &Parameters, unit: f64) -> Given<Bounded> {
    let number = |own: &f64| Bounded::exact(*own);
    let mut given = Given::new(p, number, |angles| {
        let angles: Vec<f64> = angles.iter().copied().copied().collect();
        cosine_and_sine(&angles)
    });
    if let Some(open) = &p.open {
        widen(&mut given, open);
    }
    let per_unit = |own: f64| rescaled(own / unit);
    given.parameters.natural_frequencies = p.natural_frequencies.map(per_unit);
    given.parameters.wind_speed = per_unit(p.wind_speed);
    given
}

/// Adds what is open to the bounds of directions and coefficients: a cosine or sine moves by no more than its angle.
fn widen(given: &mut Given<Bounded>, open: &Open) {
    let directions = [&mut given.mass_centre, &mut given.aerodynamic_centre];
    for own in directions.into_iter().flatten() {
        *own = widened(*own, open.attitude);
    }
    if let Forces::Coefficients(own) = &mut given.parameters.forces {
        let by = &open.coefficients;
        *own = Coefficients {
            drag: widened(own.drag, by.drag),
            lift: widened(own.lift, by.lift),
            moment: widened(own.moment, by.moment),
            drag_slope: widened(own.drag_slope, by.drag_slope),
            lift_slope: widened(own.lift_slope, by.lift_slope),
            moment_slope: widened(own.moment_slope, by.moment_slope),
        };
    }
}

fn widened(own: Bounded, by: f64) -> Bounded {
    let error = match by == 0.0 {
        true => own.error,
        false => (own.error + by).next_up(),
    };
    Bounded { error, ..own }
}

/// A number over a power of two, which rounds nothing but what becomes subnormal.
fn rescaled(value: f64) -> Bounded {
    let error = match value == 0.0 || value.is_normal() {
        true => 0.0,
        false => f64::MIN_POSITIVE,
    };
    Bounded { value, error }
}

/// The rows and columns of the free coordinates, before zeros.
fn free_entries(matrix: &Matrix<Ball>, free: &[Coordinate]) -> Matrix<Ball> {
    let own = |place: usize| free.get(place).map(|free| free.index());
    std::array::from_fn(|row| {
        std::array::from_fn(|column| match (own(row), own(column)) {
            (Some(i), Some(j)) => matrix[i][j],
            _ => Ball::ZERO,
        })
    })
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
