//! The wind speeds at which a section begins and ceases to gallop, all of them.

use rayon::prelude::*;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::budget::{Budget, Exhausted};
use crate::algebra::interval::{Interval, Intervals, KnownSign};
use crate::algebra::number::{Integer, Rational};
use crate::algebra::trigonometric_sum::TrigonometricSums;
use crate::algebra::univariate::Univariate;

use super::bernstein::Bernstein;
use super::case::Case;
use super::coefficient_table::CoefficientTable;
use super::comparison::section_at;
use super::exact_section::{ExactSection, InSpeed};
use super::hurwitz::hurwitz_determinants;
use super::input::InputError;
use super::interpolation::CoefficientCurves;

/// What is certain of a section at all wind speeds of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// All eigenvalues have negative real parts.
    Stable,
    /// An eigenvalue has a positive real part: the section gallops.
    Unstable,
    /// A real eigenvalue is above 0: static divergence, whether the section gallops beside it or not.
    Divergent,
    /// None of these is shown.
    Undecided,
}

impl Stability {
    /// `stable`, `unstable`, `divergent` or `undecided`.
    pub fn name(self) -> &'static str {
        match self {
            Stability::Stable => "stable",
            Stability::Unstable => "unstable",
            Stability::Divergent => "divergent",
            Stability::Undecided => "undecided",
        }
    }
}

/// Wind speeds in m/s, all of one stability.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedRange {
    /// The lowest speed.
    pub from: f64,
    /// The highest speed.
    pub to: f64,
    /// What is certain at every speed between.
    pub stability: Stability,
}

/// A wind speed at which stability changes: a simple root of Hurwitz' last determinant but one, or of the
/// determinant of the stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalSpeed {
    /// The speed, in m/s.
    pub speed: f64,
    /// What is exact is no farther away.
    pub error: f64,
    /// What the section is above it.
    pub becomes: Stability,
}

/// The wind speeds above 0 up to a highest one.
#[derive(Clone, Debug, PartialEq)]
pub struct Speeds {
    /// Ranges in order. Between two that are decided and differ there is one critical speed.
    pub ranges: Vec<SpeedRange>,
    /// Whether a motion neither grows nor dies out at any speed, exactly: then nothing is stable.
    pub is_neutral: bool,
}

impl Speeds {
    /// The speeds at which stability changes for certain, in order.
    pub fn critical(&self) -> Vec<CriticalSpeed> {
        let changes = self
            .ranges
            .windows(2)
            .filter(|pair| pair.iter().all(|own| own.stability != Stability::Undecided));
        let critical = |pair: &[SpeedRange]| CriticalSpeed {
            speed: (pair[0].to + pair[1].from) / 2.0,
            error: (pair[1].from - pair[0].to).next_up() / 2.0 + pair[1].from * f64::EPSILON,
            becomes: pair[1].stability,
        };
        changes.map(critical).collect()
    }
}

/// The digits of the enclosures; more where fewer leave something open.
const DIGITS: [usize; 2] = [256, 1024];

/// Products of machine words in the exact coefficients.
const MOST_PRODUCTS: u64 = 1_000_000;

/// The wind speeds at which a section is stable and unstable, above 0 and up to `highest` in m/s.
///
/// The characteristic polynomial is a polynomial in U with exact coefficients, and so are Hurwitz'
/// determinants. On a range of speeds they are above 0, or one is below, if their Bernstein coefficients
/// are; a range on which neither is so is halved, down to 2⁻⁴⁰ of the highest speed. What is left is a
/// critical speed where the last determinant but one, which alone vanishes where a pair of roots becomes
/// imaginary (Orlando), is monotonous and the earlier ones are above 0; else it is undecided. Speeds below
/// the smallest part are not told from 0.
///
/// Likewise with the constant coefficient, the determinant of the stiffness, which aerodynamic stiffness may
/// make negative: then an odd number of real roots is above 0, and where it vanishes one of them passes 0.
///
/// Without a highest speed above 0 there are no ranges. Bounded: at most 20,000 ranges are looked at.
pub fn speeds(section: &ExactSection, highest: f64) -> Speeds {
    let unit = Rational::try_from(highest).unwrap_or_default();
    if unit <= Rational::ZERO {
        return Speeds {
            ranges: Vec::new(),
            is_neutral: false,
        };
    }
    let undecided = Speeds {
        ranges: vec![SpeedRange {
            from: 0.0,
            to: highest,
            stability: Stability::Undecided,
        }],
        is_neutral: false,
    };
    let sums = TrigonometricSums::new(Budget::new(MOST_PRODUCTS));
    let Ok(polynomial) = section.characteristic_polynomial(&unit, &sums) else {
        return undecided;
    };
    let stiffness = polynomial.first().cloned().unwrap_or_default();
    let Ok((polynomial, is_neutral)) = without_neutral_pairs(section, polynomial, &sums) else {
        return undecided;
    };
    let mut found = undecided;
    for bits in DIGITS {
        let intervals = Intervals::new(bits);
        let mut ranges = ranges(&polynomial, &stiffness, &intervals, highest);
        if is_neutral {
            let stable = |own: &&mut SpeedRange| own.stability == Stability::Stable;
            ranges
                .iter_mut()
                .filter(stable)
                .for_each(|own| own.stability = Stability::Undecided);
        }
        let is_open = ranges
            .iter()
            .any(|own| own.stability == Stability::Undecided);
        found = Speeds { ranges, is_neutral };
        if !is_open || is_neutral {
            break;
        }
    }
    found
}

/// The characteristic polynomial in powers of λ and of the speed, divided by λ² + ω² as often as a
/// natural frequency ω allows, and whether one did.
fn without_neutral_pairs(
    section: &ExactSection,
    mut polynomial: Vec<InSpeed>,
    sums: &TrigonometricSums,
) -> Result<(Vec<InSpeed>, bool), Exhausted> {
    let in_speed = Univariate(sums);
    let in_lambda = Univariate(&in_speed);
    let mut is_neutral = false;
    for pair in section.natural_pairs() {
        let powers = [&pair[0], &sums.zero(), &pair[1]];
        let pair: Vec<InSpeed> = powers
            .map(|own| in_speed.polynomial(vec![own.clone()]))
            .to_vec();
        let (quotient, rest) = in_lambda.pseudo_division(&polynomial, &pair)?;
        if rest.is_empty() {
            (polynomial, is_neutral) = (quotient, true);
        }
    }
    Ok((polynomial, is_neutral))
}

/// Ranges by the determinants H_1 to H_{n−1} of a polynomial of degree n, and the determinant of the stiffness,
/// which has the sign of the constant coefficient: H_n has the sign of its product with H_{n−1}.
fn ranges(
    polynomial: &[InSpeed],
    stiffness: &InSpeed,
    intervals: &Intervals,
    highest: f64,
) -> Vec<SpeedRange> {
    let in_speed = Univariate(intervals);
    let enclosed = |powers: &InSpeed| -> Vec<Interval> {
        in_speed.polynomial(powers.iter().map(|own| intervals.enclosure(own)).collect())
    };
    let coefficients: Vec<Vec<Interval>> = polynomial.iter().map(enclosed).collect();
    let Ok(mut determinants) = hurwitz_determinants(&coefficients, &in_speed);
    determinants.pop();
    let forms = Forms {
        stiffness: Bernstein::new(&enclosed(stiffness), intervals),
        determinants: determinants
            .iter()
            .map(|own| Bernstein::new(own, intervals))
            .collect(),
    };
    let vanishes = |own: &Vec<Interval>| {
        let unknown = |own: &Interval| matches!(own.sign(), KnownSign::Zero | KnownSign::Unknown);
        own.iter().all(unknown)
    };
    let mut search = Search {
        places: Vec::new(),
        boxes: 0,
        is_any_vanishing: determinants.last().is_some_and(vanishes),
    };
    search.look(&forms, Integer::ZERO, 0);
    search.ranges(highest)
}

/// What decides stability, as polynomials on a range of speeds.
struct Forms {
    /// The determinant of the stiffness.
    stiffness: Bernstein,
    /// H_1 to H_{n−1}.
    determinants: Vec<Bernstein>,
}

impl Forms {
    fn halves(&self) -> (Self, Self) {
        let (lower, upper) = self.stiffness.halves();
        let (below, above) = self.determinants.iter().map(Bernstein::halves).unzip();
        let forms = |stiffness, determinants| Forms {
            stiffness,
            determinants,
        };
        (forms(lower, below), forms(upper, above))
    }

    /// What is certain on the whole range but for divergence.
    fn by_determinants(&self) -> Stability {
        let signs: Vec<KnownSign> = self.determinants.iter().map(Bernstein::sign).collect();
        if signs.contains(&KnownSign::Negative) {
            Stability::Unstable
        } else if signs.iter().all(|own| *own == KnownSign::Positive) {
            Stability::Stable
        } else {
            Stability::Undecided
        }
    }

    /// The one change that a range may hold on which not all is certain: what is below and what is above it.
    fn change(&self) -> Option<[Stability; 2]> {
        let (form, [negative, positive]) = match (self.stiffness.sign(), self.by_determinants()) {
            (KnownSign::Positive, Stability::Undecided) => {
                let (last, earlier) = self.determinants.split_last()?;
                let is_positive = |own: &Bernstein| own.sign() == KnownSign::Positive;
                if !earlier.iter().all(is_positive) {
                    return None;
                }
                (last, [Stability::Unstable, Stability::Stable])
            }
            (_, Stability::Undecided) => return None,
            (_, decided) => (&self.stiffness, [Stability::Divergent, decided]),
        };
        match form.slope_sign() {
            KnownSign::Positive => Some([negative, positive]),
            KnownSign::Negative => Some([positive, negative]),
            _ => None,
        }
    }
}

/// The smallest part of the highest speed is 2 to the power of minus this.
const DEPTH: usize = 40;

/// The most ranges that are looked at.
const MOST_BOXES: usize = 20_000;

/// What is known of the speeds from one multiple of the smallest part to another.
struct PlaceRange {
    from: Integer,
    to: Integer,
    found: Found,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Found {
    Certain(Stability),
    /// At most one change, from the one to the other.
    Change([Stability; 2]),
}

struct Search {
    places: Vec<PlaceRange>,
    boxes: usize,
    /// Whether a determinant vanishes at all speeds: then nothing can be isolated but divergence.
    is_any_vanishing: bool,
}

impl Search {
    /// Looks at the speeds from `place`/2^depth to one more.
    fn look(&mut self, forms: &Forms, place: Integer, depth: usize) {
        let certain = match (forms.stiffness.sign(), forms.by_determinants()) {
            (KnownSign::Negative, _) => Some(Stability::Divergent),
            (KnownSign::Positive, Stability::Undecided) if !self.is_any_vanishing => None,
            (KnownSign::Positive, decided) => Some(decided),
            _ => None,
        };
        let found = if let Some(stability) = certain {
            Found::Certain(stability)
        } else if depth == DEPTH || self.boxes >= MOST_BOXES {
            let undecided = Found::Certain(Stability::Undecided);
            forms.change().map_or(undecided, Found::Change)
        } else {
            self.boxes += 1;
            let (lower, upper) = forms.halves();
            let place = place << 1;
            self.look(&lower, place.clone(), depth + 1);
            self.look(&upper, place + Integer::ONE, depth + 1);
            return;
        };
        let width = DEPTH - depth;
        let (from, to) = (&place << width, (place + Integer::ONE) << width);
        match self.places.last_mut() {
            Some(last) if last.found == found => last.to = to,
            _ => self.places.push(PlaceRange { from, to, found }),
        }
    }

    /// The ranges in m/s; what holds the one change between its neighbours is left out.
    fn ranges(&self, highest: f64) -> Vec<SpeedRange> {
        let certain = |place: Option<&PlaceRange>| match place.map(|own| own.found) {
            Some(Found::Certain(stability)) => Some(stability),
            _ => None,
        };
        let mut ranges: Vec<SpeedRange> = Vec::new();
        for (index, own) in self.places.iter().enumerate() {
            let before = index
                .checked_sub(1)
                .and_then(|index| self.places.get(index));
            let stability = match own.found {
                Found::Certain(stability) => stability,
                Found::Change([low, high]) => {
                    let after = certain(self.places.get(index + 1));
                    if certain(before) == Some(low) && after == Some(high) {
                        continue;
                    }
                    Stability::Undecided
                }
            };
            // The first part is not told from 0.
            if own.from.is_zero() && own.to == Integer::ONE && stability == Stability::Undecided {
                continue;
            }
            ranges.push(SpeedRange {
                from: speed(&own.from, highest).next_up(),
                to: speed(&own.to, highest).next_down(),
                stability,
            });
        }
        // What lies at the ends is known to them.
        if let Some(first) = ranges.first_mut().filter(|own| own.from < highest * 1e-11) {
            first.from = 0.0;
        }
        if let Some(last) = ranges.last_mut() {
            last.to = highest;
        }
        ranges
    }
}

fn speed(place: &Integer, highest: f64) -> f64 {
    let part = Rational::from(place.clone()) / Rational::from(Integer::ONE << DEPTH);
    part.to_f64().value() * highest
}

/// The speeds of a case at all its angles, in degrees.
///
/// # Errors
///
/// If an angle is outside of the table, or no section is possible there.
pub fn speeds_of(
    case: &Case,
    table: &CoefficientTable,
    highest: f64,
) -> Result<Vec<(f64, Speeds)>, InputError> {
    let curves = CoefficientCurves::new(table, case.interpolation);
    let at = |angle: f64| {
        let section = section_at(case, table, &curves, angle)?;
        Ok((angle, speeds(&ExactSection::from(&section), highest)))
    };
    case.angles.values().into_par_iter().map(at).collect()
}
