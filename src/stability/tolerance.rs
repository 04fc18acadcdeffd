//! What is certain of a section for all coefficients within their errors.

use nalgebra::DMatrix;
use num_complex::Complex;

use super::approximation::approximate_eigenvalues;
use super::ball::Ball;
use super::error::StabilityError;
use super::forces::{Coefficients, Forces, Matrix};
use super::model::Model;
use super::section::{Parameters, Section};
use super::shape::mode_shape;
use super::state_matrix::eigenvalues;
use super::verdict::{Verdict, verdict};

/// What is known of all sections whose coefficients are within their errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// Every one of them is stable.
    Stable,
    /// Every one of them is unstable.
    Unstable,
    /// Of two of them, which were found, one is stable and the other is not.
    Depends,
    /// None of these is shown.
    Open,
}

impl Certainty {
    /// `stable`, `unstable`, `depends` or `open`.
    pub fn name(self) -> &'static str {
        match self {
            Certainty::Stable => "stable",
            Certainty::Unstable => "unstable",
            Certainty::Depends => "depends",
            Certainty::Open => "open",
        }
    }
}

/// What is known of all sections whose coefficients are within their errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Whether they are stable.
    pub certainty: Certainty,
    /// Between which numbers S of every one of them lies; `None` without wind, and where modes are too close.
    pub damping: Option<[f64; 2]>,
}

/// More than what is lost where bounds are added up.
const ABOVE: f64 = 1.0 + 1e-12;

/// Eigenvectors are good enough for their inverse if it is one up to this.
const INVERSE: f64 = 1e-3;

/// What is certain of a section for all coefficients that differ from its own by at most `errors`, in the units of
/// each: C_D ± ΔC_D, C_L ± ΔC_L, C_M ± ΔC_M, and their slopes.
///
/// With A = \[0, I; −K − K_a, −C_s − C_a\], B = diagonal(I, M), the eigenvectors X of the section itself and Y near
/// (B X)⁻¹, the eigenvalues of every such section are those of
///
/// ```text
/// Λ + (Y B X)⁻¹ Y (A X − B X Λ + Σ_k Δ_k A_k X),   |Δ_k| ≤ errors_k,
/// ```
///
/// as the forces are linear in the coefficients. The diagonal moves the eigenvalues, and discs about them hold what the
/// rest does (Gershgorin): each is scaled until it is as small as its distance to the others allows, so that its radius is
/// of second order in the errors. All products are taken in numbers with bounds. Where that decides nothing, the
/// coefficients at the ends of their errors at which each mode is best and worst damped are looked at, with proof; then the
/// errors are halved, that first which matters most, and both halves looked at.
///
/// Some 8 products of matrices with 2n rows; at most 64 times as many, and 1 + 4n verdicts, where that decides nothing.
///
/// # Errors
///
/// As [`Model::new`]; [`StabilityError::StiffnessWithoutCoefficients`] if S_a is given, which has no coefficients.
pub fn tolerance(section: &Section, errors: &Coefficients) -> Result<Tolerance, StabilityError> {
    let Forces::Coefficients(middle) = section.parameters().forces else {
        return Err(StabilityError::StiffnessWithoutCoefficients);
    };
    let whole = Part {
        middle: numbers(&middle),
        errors: numbers(errors).map(f64::abs),
    };
    let mut search = Search {
        section,
        whole,
        rest: Vec::new(),
        looked_at: 0,
        is_stable: false,
        is_unstable: false,
        is_open: false,
    };
    let family = search.look(whole)?;
    if search.is_open() {
        search.look_at_ends(family.as_ref())?;
    }
    // Asked before a part is taken: the last one leaves nothing behind it, and is looked at all the same.
    while search.is_open() {
        let Some(part) = search.rest.pop() else { break };
        search.look(part)?;
    }
    let certainty = search.certainty();
    let damping = family.and_then(|own| own.damping(section));
    // Parts of the errors may tell more than the bounds of all.
    let damping = damping.map(|[least, most]| match certainty {
        Certainty::Stable => [least.max(0.0), most],
        Certainty::Unstable => [least, most.min(0.0)],
        Certainty::Depends | Certainty::Open => [least, most],
    });
    Ok(Tolerance { certainty, damping })
}

/// The most parts of the errors that are looked at.
const MOST_PARTS: usize = 64;

/// Coefficients that are no farther from some than these errors.
#[derive(Clone, Copy, Debug)]
struct Part {
    middle: [f64; 6],
    errors: [f64; 6],
}

/// A half that is no smaller than this share of the whole, for its rounding, is none.
const SMALLER: f64 = 0.6;

impl Part {
    /// The halves along one coefficient, which hold all of it, and whose middles are among the coefficients of `whole`; none
    /// if rounding does not allow that, or makes them as large as it is.
    fn halves(self, along: usize, whole: &Part) -> Option<[Part; 2]> {
        let (middle, error) = (self.middle[along], self.errors[along]);
        // Both halves hold the middle, whatever was rounded.
        let half = (0.5 * error + f64::EPSILON * (middle.abs() + error)) * ABOVE;
        let ends = [-0.5, 0.5].map(|towards| middle + towards * error);
        let is_good = half < SMALLER * error && ends.iter().all(|own| whole.holds(along, *own));
        is_good.then(|| {
            ends.map(|end| {
                let mut part = self;
                part.middle[along] = end;
                part.errors[along] = half;
                part
            })
        })
    }

    /// Whether a coefficient is certain to be one of these, whatever is rounded here.
    fn holds(&self, along: usize, coefficient: f64) -> bool {
        let error = self.errors[along];
        coefficient == self.middle[along]
            || (coefficient - self.middle[along]).abs() <= error * (1.0 - 1e-12)
    }
}

/// What was found of the sections with all coefficients, part by part.
struct Search<'a> {
    section: &'a Section,
    whole: Part,
    /// What is to be looked at.
    rest: Vec<Part>,
    looked_at: usize,
    /// Whether some are stable.
    is_stable: bool,
    /// Whether some are unstable.
    is_unstable: bool,
    /// Whether nothing is known of some.
    is_open: bool,
}

impl Search<'_> {
    /// Looks at a part, and puts off its halves where that decides nothing.
    fn look(&mut self, part: Part) -> Result<Option<Family>, StabilityError> {
        self.looked_at += 1;
        let own = with(self.section, part.middle)?;
        let family = Family::about(&Model::new(&own)?, part.errors)?;
        match family.as_ref().and_then(Family::certainty) {
            Some(true) => self.is_stable = true,
            Some(false) => self.is_unstable = true,
            None => self.put_off(part, family.as_ref()),
        }
        Ok(family)
    }

    fn put_off(&mut self, part: Part, family: Option<&Family>) {
        let left = MOST_PARTS.saturating_sub(self.looked_at + self.rest.len());
        let halves = family.and_then(|own| part.halves(own.widest(), &self.whole));
        match halves.filter(|_| left >= 2) {
            Some(halves) => self.rest.extend(halves),
            None => self.is_open = true,
        }
    }

    /// Looks at the coefficients in the middle, and at those at which each mode is best and worst damped.
    fn look_at_ends(&mut self, family: Option<&Family>) -> Result<(), StabilityError> {
        let ends = family.into_iter().flat_map(|own| own.ends(&self.whole));
        for end in std::iter::once(self.whole.middle).chain(ends) {
            let own = with(self.section, end)?;
            match verdict(&own, &eigenvalues(&Model::new(&own)?)?) {
                Verdict::Stable(_) => self.is_stable = true,
                Verdict::Unstable(_) => self.is_unstable = true,
                Verdict::Undecided(_) => {}
            }
        }
        // All errors are 0, and the middle is all that there is.
        if self.whole.errors == [0.0; 6] && (self.is_stable || self.is_unstable) {
            self.is_open = false;
            self.rest.clear();
        }
        Ok(())
    }

    /// Whether more is to be found out.
    fn is_open(&self) -> bool {
        !(self.is_stable && self.is_unstable) && (self.is_open || !self.rest.is_empty())
    }

    fn certainty(&self) -> Certainty {
        match (self.is_stable, self.is_unstable) {
            (true, true) => Certainty::Depends,
            _ if self.is_open() => Certainty::Open,
            (true, false) => Certainty::Stable,
            (false, true) => Certainty::Unstable,
            (false, false) => Certainty::Open,
        }
    }
}

/// A section with other coefficients.
fn with(section: &Section, coefficients: [f64; 6]) -> Result<Section, StabilityError> {
    Section::new(Parameters {
        forces: from_numbers(coefficients).into(),
        ..*section.parameters()
    })
}

/// The sections, seen from the eigenvectors of the one in their middle.
struct Family {
    /// The unit of what is scaled, in 1/s.
    unit: f64,
    /// Λ, scaled.
    values: Vec<Complex<f64>>,
    /// What the real part of each eigenvalue may move by at first order.
    reach: Vec<f64>,
    /// What it moves by with each coefficient at the upper end of its error.
    slopes: Vec<[f64; 6]>,
    /// Bounds of the entries of what is added to Λ, those of the diagonal without what moves the real part.
    entries: DMatrix<f64>,
}

type Balls = DMatrix<Ball>;
type Vectors = DMatrix<Complex<f64>>;

impl Family {
    /// `None` if there are no eigenvectors that are apart from each other.
    fn about(model: &Model, errors: [f64; 6]) -> Result<Option<Self>, StabilityError> {
        let Some((values, vectors)) = eigenvectors(model) else {
            return Ok(None);
        };
        let [a, b] = pencil(model);
        let x = vectors.map(Ball::exact);
        let b_x = product(&b, &x);
        let Some(inverse) = b_x.map(|own| own.centre).try_inverse() else {
            return Ok(None);
        };
        let y = inverse.map(Ball::exact);
        let scaled = DMatrix::from_fn(b_x.nrows(), b_x.ncols(), |row, column| {
            b_x[(row, column)] * Ball::exact(-values[column])
        });
        let residual = product(&y, &sum(&product(&a, &x), &scaled));
        let changes: Vec<Balls> = changes(model, errors)?
            .iter()
            .map(|own| product(&y, &product(own, &x)))
            .collect();
        let away = product(&y, &b_x);
        let away = DMatrix::from_fn(away.nrows(), away.ncols(), |row, column| {
            let one = if row == column { -1.0 } else { 0.0 };
            (away[(row, column)] + Ball::exactly(one)).largest()
        });
        let away = (0..away.nrows()).map(|row| away.row(row).sum());
        let away = away.fold(0.0, f64::max) * ABOVE;
        if away.is_nan() || away >= INVERSE {
            return Ok(None);
        }
        let unit = model.frequency_unit;
        Ok(Some(Family::new(unit, values, &residual, &changes, away)))
    }

    fn new(
        unit: f64,
        values: Vec<Complex<f64>>,
        residual: &Balls,
        changes: &[Balls],
        away: f64,
    ) -> Self {
        let size = values.len();
        let all = |row: usize, column: usize| -> f64 {
            let parts = changes.iter().map(|own| own[(row, column)].largest());
            (residual[(row, column)].largest() + parts.sum::<f64>()) * ABOVE
        };
        let whole = DMatrix::from_fn(size, size, all);
        // What the inverse of Y B X adds to a column.
        let more = away / (1.0 - away) * ABOVE;
        let lost = |column: usize| more * whole.column(column).max();
        let real = |own: &Balls, place: usize| {
            let own = own[(place, place)];
            own.centre.re.abs() + own.radius
        };
        let reach = |place: usize| {
            let moved: f64 = changes.iter().map(|own| real(own, place)).sum();
            (moved + residual[(place, place)].largest() + lost(place)) * ABOVE
        };
        Family {
            unit,
            reach: (0..size).map(reach).collect(),
            slopes: (0..size)
                .map(|place| std::array::from_fn(|k| changes[k][(place, place)].centre.re))
                .collect(),
            entries: DMatrix::from_fn(size, size, |row, column| {
                (whole[(row, column)] + lost(column)) * ABOVE
            }),
            values,
        }
    }

    /// Whether all are stable, or none is; `None` where the discs do not show it.
    ///
    /// Each disc with a radius holds one eigenvalue of every section, and no two of them touch: that of one mode is apart
    /// from the unscaled ones of all others, which hold the scaled ones.
    fn certainty(&self) -> Option<bool> {
        let places = || 0..self.values.len();
        let reach = |place: usize| Some((self.reach[place] + self.radius(place)?) * ABOVE);
        let real = |place: usize| self.values[place].re;
        if places().any(|place| reach(place).is_some_and(|own| real(place) > own)) {
            return Some(false);
        }
        let is_left = |place: usize| reach(place).is_some_and(|own| real(place) < -own);
        places().all(is_left).then_some(true)
    }

    /// Between which numbers S lies.
    fn damping(&self, section: &Section) -> Option<[f64; 2]> {
        let radii: Option<Vec<f64>> = (0..self.values.len()).map(|own| self.radius(own)).collect();
        let moved = self.reach.iter().zip(radii?).map(|(own, more)| own + more);
        let ends = self.values.iter().zip(moved).map(|(value, moved)| {
            let own = value.re;
            [own - moved, own + moved]
        });
        let [least, most] = ends.fold([f64::NEG_INFINITY; 2], |[least, most], own| {
            [least.max(own[0]), most.max(own[1])]
        });
        let [above, below] = [least, most].map(|own| section.damping_coefficient(own * self.unit));
        // What is rounded here is less.
        let more = |own: f64| 64.0 * f64::EPSILON * own.abs();
        let (below, above) = (below?, above?);
        Some([below - more(below), above + more(above)])
    }

    /// The radius of a disc that holds just one eigenvalue, beside what the diagonal does; `None` if the others are too
    /// near.
    fn radius(&self, place: usize) -> Option<f64> {
        let others = || (0..self.values.len()).filter(move |other| *other != place);
        let row = |row: usize, without: usize| -> f64 {
            let all = (0..self.values.len()).filter(|own| *own != row && *own != without);
            all.map(|own| self.entries[(row, own)]).sum::<f64>() * ABOVE
        };
        // What is between the disc and another one if both had no radius, or that of the others alone.
        let room = |other: usize| {
            let distance = (self.values[place] - self.values[other]).norm() / ABOVE;
            let diagonal = self.entries[(place, place)] + self.entries[(other, other)];
            distance - (diagonal + row(other, place)) * ABOVE
        };
        let share = |other: usize| 2.0 * self.entries[(other, place)] / room(other);
        let scale = others().map(share).fold(f64::MIN_POSITIVE, f64::max);
        let radius = scale * row(place, place) * ABOVE;
        let is_apart = |other: usize| {
            let beside = self.entries[(other, place)] / scale;
            room(other) > (radius + beside) * ABOVE
        };
        (scale <= 1.0 && others().all(is_apart)).then_some(radius)
    }

    /// The coefficients at which each mode is worst and best damped, at first order.
    fn ends(&self, whole: &Part) -> Vec<[f64; 6]> {
        let one_of_each_pair = (0..self.values.len()).filter(|place| self.values[*place].im >= 0.0);
        let end = |place: usize, towards: f64| {
            std::array::from_fn(|k| {
                let error = whole.errors[k] * (1.0 - 1e-9);
                let moved = towards * self.slopes[place][k].signum() * error;
                let end = whole.middle[k] + moved;
                if whole.holds(k, end) {
                    end
                } else {
                    whole.middle[k]
                }
            })
        };
        one_of_each_pair
            .flat_map(|place| [end(place, 1.0), end(place, -1.0)])
            .collect()
    }

    /// The coefficient whose error moves the least damped mode most.
    fn widest(&self) -> usize {
        let damping = |place: &usize| self.values[*place].re + self.reach[*place];
        let places = 0..self.values.len();
        let worst = places.max_by(|one, other| damping(one).total_cmp(&damping(other)));
        let size = |k: &usize| worst.map_or(0.0, |place| self.slopes[place][*k].abs());
        let widest = (0..6).max_by(|one, other| size(one).total_cmp(&size(other)));
        widest.unwrap_or(0)
    }
}

/// Eigenvalues, scaled, and the vectors (q, λq) in columns.
fn eigenvectors(model: &Model) -> Option<(Vec<Complex<f64>>, Vectors)> {
    let n = model.freedom();
    let values = approximate_eigenvalues(&model.scaled_state_matrix()).next()?;
    let shape = |value: &Complex<f64>| mode_shape(model, value * model.frequency_unit, None);
    let shapes: Vec<Vec<Complex<f64>>> = values.iter().map(shape).collect::<Option<_>>()?;
    let vectors = DMatrix::from_fn(2 * n, 2 * n, |row, column| match row < n {
        true => shapes[column][row],
        false => shapes[column][row - n] * values[column],
    });
    Some((values, vectors))
}

/// A and B, scaled.
fn pencil(model: &Model) -> [Balls; 2] {
    let n = model.freedom();
    let unit = |is_one: bool| if is_one { Ball::ONE } else { Ball::ZERO };
    let a = DMatrix::from_fn(2 * n, 2 * n, |row, column| match (row < n, column < n) {
        (true, _) => unit(column == row + n),
        (false, true) => {
            let [i, j] = [row - n, column];
            -(model.stiffness[i][j] + model.aerodynamic_stiffness[i][j])
        }
        (false, false) => {
            let [i, j] = [row - n, column - n];
            -(model.structural_damping[i][j] + model.aerodynamic_damping[i][j])
        }
    });
    let b = DMatrix::from_fn(2 * n, 2 * n, |row, column| match (row < n, column < n) {
        (false, false) => model.mass[row - n][column - n],
        _ => unit(row == column),
    });
    [a, b]
}

/// errors_k A_k: the change of A for each coefficient at the upper end of its error, since C_a and K_a are linear in the
/// coefficients.
fn changes(model: &Model, errors: [f64; 6]) -> Result<Vec<Balls>, StabilityError> {
    let n = model.freedom();
    let change = |k: usize| -> Result<Balls, StabilityError> {
        let mut alone = [0.0; 6];
        alone[k] = errors[k];
        let own = Model::new(&with(model.section(), alone)?)?;
        let entry = |matrix: &Matrix<Ball>, i: usize, j: usize| -matrix[i][j];
        Ok(DMatrix::from_fn(2 * n, 2 * n, |row, column| {
            match (row < n, column < n) {
                (true, _) => Ball::ZERO,
                (false, true) => entry(&own.aerodynamic_stiffness, row - n, column),
                (false, false) => entry(&own.aerodynamic_damping, row - n, column - n),
            }
        }))
    };
    (0..6).map(change).collect()
}

fn numbers(c: &Coefficients) -> [f64; 6] {
    [
        c.drag,
        c.lift,
        c.moment,
        c.drag_slope,
        c.lift_slope,
        c.moment_slope,
    ]
}

fn from_numbers(own: [f64; 6]) -> Coefficients {
    let [drag, lift, moment, drag_slope, lift_slope, moment_slope] = own;
    Coefficients {
        drag,
        lift,
        moment,
        drag_slope,
        lift_slope,
        moment_slope,
    }
}

fn product(left: &Balls, right: &Balls) -> Balls {
    DMatrix::from_fn(left.nrows(), right.ncols(), |row, column| {
        let terms = (0..left.ncols()).map(|k| left[(row, k)] * right[(k, column)]);
        terms.fold(Ball::ZERO, |sum, own| sum + own)
    })
}

fn sum(one: &Balls, other: &Balls) -> Balls {
    one.zip_map(other, |own, more| own + more)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::coordinate::FreeCoordinates;
    use crate::stability::exact_section::ExactSection;
    use crate::stability::verdict::{Proof, exact_verdict};
    use proptest::prelude::*;

    fn parameters() -> impl Strategy<Value = Parameters> {
        let coefficient = || prop_oneof![-4.0..4.0_f64, -0.5..0.5_f64];
        let forces = prop::collection::vec(coefficient(), 6);
        let angles = prop::collection::vec(-3.0..3.0_f64, 4);
        (
            forces,
            angles,
            0.0..0.9_f64,
            0.5..30.0_f64,
            prop::collection::vec(0.8..1.2_f64, 3),
            0.0..0.02_f64,
            any::<bool>(),
        )
            .prop_map(|(c, angles, e, speed, f, zeta, is_stiff)| Parameters {
                mass: 3.0,
                radius_of_gyration: 0.02,
                mass_centre_distance: 0.02 * e,
                mass_centre_angle: angles[0],
                aerodynamic_centre_distance: 0.02,
                aerodynamic_centre_angle: angles[1],
                reference_dimension: 0.05,
                natural_frequencies: [6.0 * f[0], 6.0 * f[1], 6.0 * f[2]],
                damping_ratios: [zeta; 3],
                air_density: 1.25,
                wind_speed: speed,
                wind_angle: angles[2],
                attitude: angles[3],
                forces: from_numbers([c[0], c[1], c[2], c[3], c[4], c[5]]).into(),
                free: FreeCoordinates::all(),
                aerodynamic_stiffness: is_stiff,
                open: None,
            })
    }

    fn verdict_at(parameters: Parameters, c: [f64; 6]) -> Verdict {
        let parameters = Parameters {
            forces: from_numbers(c).into(),
            ..parameters
        };
        exact_verdict(&ExactSection::from(&Section::new(parameters).unwrap()))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        /// What is certain of all is so of some that are drawn, and of those at all corners.
        #[test]
        fn what_is_certain_holds_for_all(
            parameters in parameters(),
            size in prop_oneof![0.0..0.05_f64, 0.0..1.0_f64],
            shares in prop::collection::vec(prop::collection::vec(-1.0..1.0_f64, 6), 6),
            corner in 0_u32..64,
        ) {
            let errors = [1.0, 1.0, 0.3, 2.0, 2.0, 0.5].map(|own: f64| own * size);
            let section = Section::new(parameters).unwrap();
            let Tolerance { certainty: found, damping } = tolerance(&section, &from_numbers(errors)).unwrap();
            let Forces::Coefficients(middle) = parameters.forces else { unreachable!() };
            let middle = numbers(&middle);
            let ends = (0..6).map(|k| if corner >> k & 1 == 0 { -1.0 } else { 1.0 }).collect();
            for share in shares.into_iter().chain([ends]) {
                let own: [f64; 6] = std::array::from_fn(|k| middle[k] + share[k] * errors[k]);
                let verdict = verdict_at(parameters, own);
                match found {
                    Certainty::Stable => prop_assert!(matches!(verdict, Verdict::Stable(_)), "{verdict:?}"),
                    Certainty::Unstable => prop_assert!(matches!(verdict, Verdict::Unstable(_)), "{verdict:?}"),
                    Certainty::Depends | Certainty::Open => {}
                }
                if let Some([least, most]) = damping {
                    let own = with(&section, own).unwrap();
                    let spectrum = eigenvalues(&Model::new(&own).unwrap()).unwrap();
                    let (value, error) = spectrum.damping_coefficient(&own).unwrap();
                    prop_assert!(value + error >= least && value - error <= most, "{value} {least} {most}");
                }
            }
        }
    }

    /// Without errors it is the verdict, and with large ones it depends: nothing is open for most sections.
    #[test]
    fn most_sections_are_decided() {
        use proptest::strategy::ValueTree;
        use proptest::test_runner::TestRunner;
        let mut runner = TestRunner::deterministic();
        let mut counts = [[0; 4]; 3];
        for _ in 0..300 {
            let parameters = parameters().new_tree(&mut runner).unwrap().current();
            let section = Section::new(parameters).unwrap();
            for (size, counts) in [0.0, 0.03, 0.3].iter().zip(&mut counts) {
                let errors = [1.0, 1.0, 0.3, 2.0, 2.0, 0.5].map(|own: f64| own * size);
                let found = tolerance(&section, &from_numbers(errors))
                    .unwrap()
                    .certainty;
                counts[found as usize] += 1;
                if *size == 0.0 {
                    let verdict = exact_verdict(&ExactSection::from(&section));
                    let is_same = match found {
                        Certainty::Stable => verdict == Verdict::Stable(Proof::Determinants),
                        Certainty::Unstable => verdict == Verdict::Unstable(Proof::Determinants),
                        Certainty::Depends => false,
                        Certainty::Open => true,
                    };
                    assert!(is_same, "{found:?}, {verdict:?}");
                }
            }
        }
        let open = Certainty::Open as usize;
        println!("{counts:?}");
        assert!(counts[0][open] < 10, "{counts:?}");
        assert!(counts[1][open] < 60, "{counts:?}");
        assert!(counts[2][Certainty::Depends as usize] > 30, "{counts:?}");
    }
}
