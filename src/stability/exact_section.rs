//! A section in exact numbers: its characteristic polynomial as it is given, without any rounding.

use dashu_base::BitTest;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::budget::Exhausted;
use crate::algebra::determinant::determinant;
use crate::algebra::matrix::Matrix;
use crate::algebra::number::{Integer, Rational};
use crate::algebra::trigonometric_sum::{TrigonometricSum as Sum, TrigonometricSums};
use crate::algebra::univariate::Univariate;

use super::coordinate::Coordinate;
use super::error::StabilityError;
use super::forces::Forces;
use super::scaled_damping::{Ingredients, scaled_damping};
use super::section::{Parameters, Section};

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

/// A polynomial in the wind speed.
pub(super) type InSpeed = Vec<Sum>;

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

    /// Whether the wind turns the section over: static divergence, where the determinant of the stiffness is below 0,
    /// so that a real eigenvalue is above 0. It is that of the turn alone, m r² ω_θ² − ρD²U²C_M′/2, since stiffness
    /// couples nothing to the turn (`derivations/extensions.md`, section 3). What grows otherwise gallops, whether it
    /// oscillates or not.
    pub fn diverges(&self) -> bool {
        let p = &self.0;
        let (Forces::Coefficients(c), true) = (&p.forces, p.aerodynamic_stiffness) else {
            return false;
        };
        let radius = &p.radius_of_gyration * &p.natural_frequencies[Coordinate::Theta.index()];
        let own = Rational::from(2) * &p.mass * &radius * &radius;
        let length = &p.reference_dimension * &p.wind_speed;
        let turning = &p.air_density * &length * &length * &c.moment_slope;
        p.free.as_slice().contains(&Coordinate::Theta) && own < turning
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
    /// the square of [the unit](Self::frequency_unit): ω² for a natural frequency ω, and ω²/(1 ± e), with the
    /// eccentricity e, for motions that frequencies of one size couple.
    pub(super) fn natural_squares(&self) -> Vec<Rational> {
        let (unit, one) = (self.frequency_unit(), Rational::ONE);
        let e = &self.0.mass_centre_distance / &self.0.radius_of_gyration;
        let free = self.0.free.as_slice();
        let is_coupled = free.len() > 1 && free.contains(&Coordinate::Theta) && !e.is_zero();
        let mut squares = Vec::new();
        for coordinate in free {
            let omega = &self.0.natural_frequencies[coordinate.index()] / &unit;
            let own = &omega * &omega;
            if is_coupled {
                squares.extend([&one + &e, &one - &e].map(|mass| &own / mass));
            }
            squares.push(own);
        }
        squares.sort();
        squares.dedup();
        squares
    }

    /// The square of the frequency of the turn alone, ω_θ² + K_a/(m r²), in powers of U over `speed_unit` and over
    /// the square of [the unit](Self::frequency_unit): λ² and this are a divisor where nothing damps the turn and
    /// inertia does not couple it. `None` without aerodynamic stiffness.
    pub(super) fn square_of_the_turn(
        &self,
        speed_unit: &Rational,
        sums: &TrigonometricSums,
    ) -> Result<Option<InSpeed>, Exhausted> {
        let p = &self.0;
        if !p.aerodynamic_stiffness || !p.free.as_slice().contains(&Coordinate::Theta) {
            return Ok(None);
        }
        let omega = &p.natural_frequencies[Coordinate::Theta.index()] / self.frequency_unit();
        let [_, _, stiffness] = self.turn_stiffness(sums)?;
        let square = vec![
            Sum::from(&omega * &omega),
            Sum::default(),
            stiffness.scaled(&self.pressure(speed_unit)),
        ];
        Ok(Some(Univariate(sums).polynomial(square)))
    }

    /// ρDU²/(2mr), for the turn rθ, at `speed_unit` and over the square of the unit of frequency.
    fn pressure(&self, speed_unit: &Rational) -> Rational {
        let (p, unit) = (&self.0, self.frequency_unit());
        let speed = speed_unit / unit;
        &p.air_density * &p.reference_dimension * &speed * &speed
            / (Rational::from(2) * &p.mass * &p.radius_of_gyration)
    }

    /// |λ²M + λ(C_s + C_a) + K + K_a| over powers of m and r, in powers of λ over
    /// [the unit](Self::frequency_unit); each coefficient in powers of U over `speed_unit`.
    ///
    /// The matrices are those of [`Model`](super::model::Model), with S_a by Eq. (18).
    ///
    /// # Errors
    ///
    /// If the sums of sines and cosines become too long.
    pub(super) fn characteristic_polynomial(
        &self,
        speed_unit: &Rational,
        sums: &TrigonometricSums,
    ) -> Result<Vec<InSpeed>, Exhausted> {
        let p = &self.0;
        let unit = self.frequency_unit();
        let omega = p.natural_frequencies.each_ref().map(|own| own / &unit);
        let two = Rational::from(2);
        let wind = &p.air_density * &p.reference_dimension * speed_unit / (&two * &p.mass * &unit);
        let scaled_damping = self.scaled_damping(sums)?;
        let turn_stiffness = self.turn_stiffness(sums)?;
        let pressure = self.pressure(speed_unit);
        let eccentricity = &p.mass_centre_distance / &p.radius_of_gyration;
        let angle = &p.mass_centre_angle + &p.attitude;
        let coupling = [Sum::sine(&angle), Sum::cosine(&angle)];
        let coupling = coupling.map(|own| own.scaled(&eccentricity));

        let in_speed = Univariate(sums);
        let in_lambda = Univariate(&in_speed);
        let constant = |sum: Sum| in_speed.polynomial(vec![sum]);
        let entry = |i: usize, j: usize| {
            let is_own = i == j;
            let own = |number: Rational| match is_own {
                true => Sum::from(number),
                false => Sum::default(),
            };
            let mass = match (i, j) {
                _ if is_own => Sum::from(Rational::ONE),
                (2, side) | (side, 2) => coupling[side].clone(),
                _ => Sum::default(),
            };
            let structural = own(&two * &omega[i] * &p.damping_ratios[i]);
            let damping = vec![structural, scaled_damping[i][j].scaled(&wind)];
            let aerodynamic = match j {
                2 => turn_stiffness[i].scaled(&pressure),
                _ => Sum::default(),
            };
            let stiffness = vec![own(&omega[i] * &omega[i]), Sum::default(), aerodynamic];
            in_lambda.polynomial(vec![
                in_speed.polynomial(stiffness),
                in_speed.polynomial(damping),
                constant(mass),
            ])
        };
        let free = p.free.as_slice();
        let matrix = Matrix::from_fn(free.len(), free.len(), |row, column| {
            entry(free[row].index(), free[column].index())
        });
        determinant(&matrix, &in_lambda)
    }

    /// The column of θ of K_a over ρDU²/2, as [`Model`](super::model::Model) has it: for x, y and rθ.
    fn turn_stiffness(&self, sums: &TrigonometricSums) -> Result<[Sum; 3], Exhausted> {
        let p = &self.0;
        let (Forces::Coefficients(c), true) = (&p.forces, p.aerodynamic_stiffness) else {
            return Ok(Default::default());
        };
        let (cos, sin) = (Sum::cosine(&p.wind_angle), Sum::sine(&p.wind_angle));
        let kappa = &p.reference_dimension / &p.radius_of_gyration;
        let minus = |slope: &Rational| -slope.clone();
        let along = [cos.scaled(&minus(&c.drag_slope)), sin.scaled(&c.lift_slope)];
        let across = [
            sin.scaled(&minus(&c.drag_slope)),
            cos.scaled(&minus(&c.lift_slope)),
        ];
        Ok([
            sums.sum(&along[0], &along[1])?,
            sums.sum(&across[0], &across[1])?,
            Sum::from(kappa * minus(&c.moment_slope)),
        ])
    }

    /// S_a, for the coordinates x, y and rθ.
    pub(super) fn scaled_damping(
        &self,
        sums: &TrigonometricSums,
    ) -> Result<[[Sum; 3]; 3], Exhausted> {
        let p = &self.0;
        let c = match &p.forces {
            Forces::ScaledDamping(rows) => {
                return Ok(rows.clone().map(|row| row.map(Sum::from)));
            }
            Forces::Coefficients(c) => c,
        };
        let lever = &p.aerodynamic_centre_distance / &p.radius_of_gyration;
        let centre = &p.wind_angle + &p.attitude + &p.aerodynamic_centre_angle;
        let number = |own: &Rational| Sum::from(own.clone());
        let of = Ingredients {
            coefficients: c.map(number),
            kappa: Sum::from(&p.reference_dimension / &p.radius_of_gyration),
            wind: [Sum::cosine(&p.wind_angle), Sum::sine(&p.wind_angle)],
            centre: [Sum::cosine(&centre), Sum::sine(&centre)].map(|own| own.scaled(&lever)),
        };
        scaled_damping(&of, sums)
    }
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
    use crate::algebra::budget::Budget;
    use crate::algebra::interval::Intervals;
    use crate::stability::section::Coefficients;
    use proptest::prelude::*;

    proptest! {
        /// Eq. (18) is that of the evaluator that is proven, and the stiffness lies within its bounds.
        #[test]
        fn the_forces_are_those_of_the_doubles(
            c in prop::array::uniform6(-3.0..3.0f64),
            angles in prop::array::uniform3(prop_oneof![-7.0..7.0f64, -1000.0..1000.0f64]),
            lever in 0.0..2.0f64,
        ) {
            let parameters = Parameters {
                mass: 1.0,
                radius_of_gyration: 0.3,
                aerodynamic_centre_distance: lever,
                aerodynamic_centre_angle: angles[0],
                reference_dimension: 0.7,
                natural_frequencies: [1.0; 3],
                air_density: 1.0,
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
            let sums = TrigonometricSums::new(Budget::new(100_000));
            let exact = ExactSection::from(&section).scaled_damping(&sums).expect("short sums");
            let intervals = Intervals::new(100);
            let stiffness = ExactSection::from(&section).turn_stiffness(&sums).expect("short sums");
            let bounds = section.scaled_damping_with_bound();
            // The product of both factors is what is derived and proven.
            let evaluated = section.scaled_damping();
            for (own, ball) in evaluated.iter().flatten().zip(bounds.iter().flatten()) {
                prop_assert!((own - ball.centre.re).abs() < 1e-9, "{own} {ball:?}");
            }
            let turn_bounds = section.turn_stiffness_with_bound().expect("it is on");
            let pairs = exact.iter().flatten().zip(bounds.iter().flatten());
            for (own, ball) in pairs.chain(stiffness.iter().zip(&turn_bounds)) {
                let number = |value: f64| Rational::try_from(value).expect("finite");
                for bound in intervals.bounds(&intervals.enclosure(own)) {
                    let apart = bound - number(ball.centre.re);
                    let radius = number(ball.radius);
                    prop_assert!(-&radius <= apart && apart <= radius);
                }
            }
        }
    }
}
