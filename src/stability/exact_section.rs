//! A section in exact numbers: its characteristic polynomial as it is given, without any rounding.

use dashu_base::BitTest;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::budget::Budget;
use crate::algebra::determinant::determinant;
use crate::algebra::interval::{Intervals, KnownSign};
use crate::algebra::matrix::Matrix;
use crate::algebra::number::{Integer, Rational};
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};
use crate::algebra::univariate::Univariate;

use super::equations::Equations;
use super::error::StabilityError;
use super::given::Given;
use super::in_speed::{Coefficients, InSpeed, InSpeeds};
use super::section::{Parameters, Section};
use super::system::arithmetic::NoValue;

/// The parameters of a section as exact numbers: possible ones, as for a [`Section`].
///
/// ```
/// use sextic::algebra::number::Rational;
/// use sextic::stability::exact_section::ExactSection;
/// use sextic::stability::section::Parameters;
///
/// let tenth = Rational::from(1) / Rational::from(10);
/// let parameters = Parameters {
///     mass: Rational::from(3),
///     radius_of_gyration: tenth.clone(),
///     reference_dimension: tenth.clone(),
///     air_density: Rational::ONE,
///     natural_frequencies: [1, 2, 3].map(Rational::from),
///     ..Parameters::default()
/// };
/// assert!(ExactSection::new(parameters.clone()).is_ok());
/// let impossible = Parameters { mass_centre_distance: tenth, ..parameters };
/// assert!(ExactSection::new(impossible).is_err());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ExactSection(Parameters<Rational>);

/// The binary digits with which the sign of the stiffness is told.
const DIGITS: usize = 256;

/// The products of machine words that its determinant may cost: more than the longest numbers that are read need.
const MOST_PRODUCTS: u64 = 100_000_000;

impl ExactSection {
    /// Checks the parameters, by the doubles nearest to them.
    ///
    /// # Errors
    ///
    /// As [`Section::new`].
    pub fn new(parameters: Parameters<Rational>) -> Result<Self, StabilityError> {
        let nearest = parameters.map(|own| own.to_f64().value());
        Section::new(nearest)?;
        Ok(ExactSection(parameters))
    }

    /// The parameters.
    pub fn parameters(&self) -> &Parameters<Rational> {
        &self.0
    }

    /// Whether it stands for others besides, whose attitude and coefficients are near its own.
    pub fn is_open(&self) -> bool {
        self.0.open.as_ref().is_some_and(|own| !own.is_nothing())
    }

    /// Whether the wind turns the section over: static divergence, where the determinant of the stiffness is below 0,
    /// so that a real eigenvalue is above 0. What grows otherwise gallops, whether it oscillates or not.
    pub fn diverges(&self) -> bool {
        // Without it the stiffness is that of the springs, which are above 0. Of several sections nothing is shown here.
        if !self.0.aerodynamic_stiffness || self.is_open() {
            return false;
        }
        let sums = TrigonometricSums::new(Budget::new(MOST_PRODUCTS));
        let determinant = self.stiffness_determinant(&sums);
        let sign = |own: Sum| Intervals::new(DIGITS).enclosure(&own).sign();
        determinant.map(sign) == Ok(KnownSign::Negative)
    }

    /// |K + K_a| over the mass at the speed of the section.
    fn stiffness_determinant(&self, sums: &TrigonometricSums) -> Result<Sum, NoValue> {
        let given = self.given(&self.0.wind_speed, sums);
        let [structure, wind] = given.stiffness_in(&mut InSpeeds(sums))?;
        let in_speed = Univariate(sums);
        let stiffness = self.matrix(|i, j| in_speed.sum(&structure[i][j], &wind[i][j]))?;
        at_speed(&determinant(&stiffness, &in_speed)?, sums)
    }

    /// The unit of frequency: a power of 2 near the largest natural frequency of a free coordinate.
    pub(super) fn frequency_unit(&self) -> Rational {
        let free = self.0.free.as_slice().iter();
        let frequencies = free.map(|own| &self.0.natural_frequencies[own.index()]);
        let largest = frequencies.max().cloned().unwrap_or(Rational::ONE);
        let (above, below) = (largest.numerator(), largest.denominator());
        let power = |digits: usize| Rational::from(Integer::ONE << digits);
        power(above.bit_len()) / power(below.bit_len())
    }

    /// ν for the divisors λ² + ν of the characteristic polynomial that are likely where a motion is not damped, over
    /// the square of [the unit](Self::frequency_unit): the square of the frequency of each coordinate alone, and those
    /// of Eq. (15) for motions that frequencies of one size couple; in powers of U over `speed_unit`.
    ///
    /// # Errors
    ///
    /// If the sums of sines and cosines become too long.
    pub(super) fn likely_squares<C: Coefficients>(
        &self,
        speed_unit: &Rational,
        coefficients: &C,
    ) -> Result<Vec<InSpeed<C::Element>>, NoValue>
    where
        C::Element: PartialEq,
    {
        let given = self.given(speed_unit, coefficients);
        let mut arithmetic = InSpeeds(coefficients);
        let [structure, wind] = given.stiffness_in(&mut arithmetic)?;
        let mut squares = given.squares_without_wind_in(&mut arithmetic)?;
        for free in self.0.free.as_slice().iter().map(|free| free.index()) {
            let own = Univariate(coefficients).sum(&structure[free][free], &wind[free][free]);
            squares.push(own.map_err(Into::into)?);
        }
        let mut different: Vec<InSpeed<C::Element>> = Vec::with_capacity(squares.len());
        for square in squares {
            if !different.contains(&square) {
                different.push(square);
            }
        }
        Ok(different)
    }

    /// |λ²M + λ(C_s + C_a) + K + K_a| over powers of m and r, in powers of λ over
    /// [the unit](Self::frequency_unit); each coefficient in powers of U over `speed_unit`.
    ///
    /// # Errors
    ///
    /// If coefficients are exact: where the sums of sines and cosines become too long.
    pub(super) fn characteristic_polynomial<C: Coefficients>(
        &self,
        speed_unit: &Rational,
        coefficients: &C,
    ) -> Result<Vec<InSpeed<C::Element>>, NoValue> {
        let own = self.equations(speed_unit, coefficients)?;
        let in_speed = Univariate(coefficients);
        let in_lambda = Univariate(&in_speed);
        let matrix = self.matrix(|i, j| {
            let stiffness = in_speed.sum(&own.stiffness[i][j], &own.aerodynamic_stiffness[i][j])?;
            let damping = in_speed.sum(
                &own.structural_damping[i][j],
                &own.aerodynamic_damping[i][j],
            )?;
            Ok(in_lambda.polynomial(vec![stiffness, damping, own.mass[i][j].clone()]))
        });
        let found = matrix.and_then(|matrix| determinant(&matrix, &in_lambda));
        found.map_err(Into::into)
    }

    /// A matrix for the free coordinates by its entries for all three.
    fn matrix<T: Clone, E>(
        &self,
        entry: impl Fn(usize, usize) -> Result<T, E>,
    ) -> Result<Matrix<T>, E> {
        let free = self.0.free.as_slice();
        Matrix::try_from_fn(free.len(), free.len(), |row, column| {
            entry(free[row].index(), free[column].index())
        })
    }

    /// The matrices, with time in units of 1 over [the unit](Self::frequency_unit), in powers of U over `speed_unit`.
    fn equations<C: Coefficients>(
        &self,
        speed_unit: &Rational,
        coefficients: &C,
    ) -> Result<Equations<InSpeed<C::Element>>, NoValue> {
        self.given(speed_unit, coefficients)
            .equations_in(&mut InSpeeds(coefficients))
    }

    fn given<C: Coefficients>(
        &self,
        speed_unit: &Rational,
        coefficients: &C,
    ) -> Given<InSpeed<C::Element>> {
        let unit = self.frequency_unit();
        let constant = |own: C::Element| InSpeeds(coefficients).constant(own);
        let direction = |angles: &[&Rational]| {
            let sum = angles
                .iter()
                .fold(Rational::ZERO, |sum, own| sum + (*own).clone());
            coefficients.direction(&sum).map(constant)
        };
        let number = |own: &Rational| constant(coefficients.number(own));
        let mut given = Given::new(&self.0, number, direction);
        let frequencies = self.0.natural_frequencies.each_ref();
        given.parameters.natural_frequencies = frequencies.map(|own| number(&(own / &unit)));
        let speed = coefficients.number(&(speed_unit / unit));
        let speed = vec![coefficients.zero(), speed];
        given.parameters.wind_speed = Univariate(coefficients).polynomial(speed);
        given
    }
}

/// The value of a polynomial where the speed is 1.
///
/// # Errors
///
/// If the sum becomes too long.
pub(super) fn at_speed(powers: &InSpeed, sums: &TrigonometricSums) -> Result<Sum, NoValue> {
    let mut powers = powers.iter();
    let sum = powers.try_fold(sums.zero(), |sum, own| sums.sum(&sum, own));
    Ok(sum?)
}

impl From<&Section> for ExactSection {
    /// The doubles of a section as exact numbers.
    fn from(section: &Section) -> Self {
        // Parameters of a section are finite.
        let exact = |own: &f64| Rational::try_from(*own).unwrap_or_default();
        ExactSection(section.parameters().map(exact))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::model::given_with_bounds;
    use crate::stability::section::Coefficients;
    use proptest::prelude::*;

    /// However many digits the numbers have that a command reads.
    #[test]
    fn divergence_is_shown_of_long_numbers() {
        let long = |own: u64| {
            let digits = Rational::from(Integer::ONE << 3300);
            (Rational::from(own) * &digits + Rational::ONE) / (digits - Rational::ONE)
        };
        let section = |slope: u64| {
            let parameters = Parameters {
                mass: long(3),
                radius_of_gyration: long(2),
                mass_centre_distance: long(1),
                mass_centre_angle: long(1),
                aerodynamic_centre_distance: long(1),
                aerodynamic_centre_angle: long(2),
                reference_dimension: long(2),
                natural_frequencies: [1, 2, 3].map(long),
                damping_ratios: [1, 1, 1].map(long),
                air_density: long(1),
                wind_speed: long(5),
                wind_angle: long(1),
                attitude: long(2),
                forces: Coefficients {
                    drag: long(1),
                    lift: long(1),
                    moment: long(1),
                    drag_slope: long(3),
                    lift_slope: long(4),
                    moment_slope: long(slope),
                }
                .into(),
                aerodynamic_stiffness: true,
                ..Parameters::default()
            };
            ExactSection::new(parameters).expect("a possible section")
        };
        // 2m r² ω_θ² = 216, and ρD²U²C_M′ = 100 C_M′.
        assert!(!section(2).diverges());
        assert!(section(3).diverges());
    }

    proptest! {
        /// The exact matrices lie within the bounds of those in doubles.
        #[test]
        fn the_matrices_are_those_of_the_doubles(
            c in prop::array::uniform6(-3.0..3.0f64),
            angles in prop::array::uniform4(prop_oneof![-7.0..7.0f64, -1000.0..1000.0f64]),
            lever in 0.0..2.0f64,
            speed in 0.0..30.0f64,
        ) {
            let parameters = Parameters {
                mass: 1.7,
                radius_of_gyration: 0.3,
                mass_centre_distance: 0.1,
                mass_centre_angle: angles[3],
                aerodynamic_centre_distance: lever,
                aerodynamic_centre_angle: angles[0],
                reference_dimension: 0.7,
                natural_frequencies: [1.0, 1.3, 0.9],
                damping_ratios: [0.01, 0.0, 0.2],
                air_density: 1.2,
                wind_speed: speed,
                wind_angle: angles[1],
                attitude: angles[2],
                forces: Coefficients {
                    drag: c[0],
                    lift: c[1],
                    moment: c[2],
                    drag_slope: c[3],
                    lift_slope: c[4],
                    moment_slope: c[5],
                }
                .into(),
                aerodynamic_stiffness: true,
                ..Parameters::default()
            };
            let section = Section::new(parameters).expect("a possible section");
            let exact = ExactSection::from(&section);
            let sums = TrigonometricSums::new(Budget::new(1_000_000));
            let unit = exact.frequency_unit().to_f64().value();
            let bounds = given_with_bounds(section.parameters(), unit).equations().into_entries();
            let speed = exact.parameters().wind_speed.clone();
            let exact = exact.equations(&speed, &sums).expect("short sums").into_entries();
            let intervals = Intervals::new(100);
            let number = |value: f64| Rational::try_from(value).expect("finite");
            for (own, bounded) in exact.iter().zip(&bounds) {
                let own = at_speed(own, &sums).expect("short sums");
                for bound in intervals.bounds(&intervals.enclosure(&own)) {
                    let apart = bound - number(bounded.value);
                    let radius = number(bounded.error);
                    prop_assert!(-&radius <= apart && apart <= radius, "{bounded:?}");
                }
            }
        }
    }
}
