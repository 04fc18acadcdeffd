//! The wind speeds up to a highest one, cut into parts on which stability is known.

use dashu_base::BitTest;

use crate::algebra::interval::{Interval, Intervals, KnownSign};
use crate::algebra::number::{Integer, Rational};
use crate::algebra::univariate::Univariate;

use super::bernstein::Bernstein;
use super::hurwitz::hurwitz_determinants;
use super::in_speed::InSpeed;
use super::speed_part::{Found, Part, Stability, share};

/// A part next to 0 is halved somewhat more often than others.
const DEEPEST: usize = 120;

/// Any other one until it is less than this power of 1/2 of the speeds in it.
const DIGITS: usize = 40;

/// Where the last determinant vanishes ranges are halved so often.
const COARSE: usize = 6;

/// The most parts that are halved.
const MOST_HALVED: usize = 20_000;

/// The parts by the determinants H_1 to H_{n−1} of a polynomial of degree n, and the determinant of the stiffness,
/// which has the sign of the constant coefficient: H_n has the sign of its product with H_{n−1}.
pub(super) fn parts(
    polynomial: &[InSpeed<Interval>],
    stiffness: &InSpeed<Interval>,
    intervals: &Intervals,
) -> Vec<Part> {
    let in_speed = Univariate(intervals);
    let count = polynomial.len().saturating_sub(2);
    let Ok(determinants) = hurwitz_determinants(polynomial, count, &in_speed);
    let forms = Forms {
        stiffness: Bernstein::new(stiffness, intervals),
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
        parts: Vec::new(),
        halved: 0,
        is_last_vanishing: determinants.last().is_some_and(vanishes),
    };
    search.look(&forms, Integer::ZERO, 0);
    for part in &mut search.parts {
        if part.found == Found::Certain(Stability::Undecided) {
            let speeds = intervals.rational(&part.from);
            let speeds = speeds.hull(&intervals.rational(&part.to));
            let at = |powers: &Vec<Interval>| {
                let Ok(value) = in_speed.value(powers, &speeds);
                value
            };
            if at(stiffness).sign() == KnownSign::Positive {
                let polynomial: Vec<Interval> = polynomial.iter().map(at).collect();
                part.found = Found::Certain(beside_the_axis(&polynomial, intervals));
            }
        }
    }
    search.parts
}

/// Lines beside the imaginary axis, these powers of 1/2 of the unit of frequency away.
const LINES: [usize; 7] = [4, 8, 12, 16, 20, 24, 28];

/// Whether a root lies to the right of a line to the right of the axis, or all to the left of one to the left.
fn beside_the_axis(polynomial: &[Interval], intervals: &Intervals) -> Stability {
    let in_lambda = Univariate(intervals);
    let signs = |line: &Rational| -> Vec<KnownSign> {
        let Ok(shifted) = in_lambda.shifted(polynomial, &intervals.rational(line));
        let Ok(determinants) = hurwitz_determinants(&shifted, shifted.len(), intervals);
        determinants.iter().map(Interval::sign).collect()
    };
    for power in LINES {
        let line = share(Integer::ONE, power);
        if signs(&line).contains(&KnownSign::Negative) {
            return Stability::Unstable;
        }
        let are_left = signs(&-line);
        if are_left.iter().all(|own| *own == KnownSign::Positive) {
            return Stability::Stable;
        }
    }
    Stability::Undecided
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

struct Search {
    parts: Vec<Part>,
    halved: usize,
    /// Whether the last determinant vanishes at all speeds: then nothing can be isolated but divergence, and what
    /// other determinants show of it.
    is_last_vanishing: bool,
}

impl Search {
    /// Looks at the speeds from `place`/2^depth to one more.
    fn look(&mut self, forms: &Forms, place: Integer, depth: usize) {
        let certain = match (forms.stiffness.sign(), forms.by_determinants()) {
            (KnownSign::Negative, _) => Some(Stability::Divergent),
            (KnownSign::Positive, Stability::Undecided)
                if !self.is_last_vanishing || depth < COARSE =>
            {
                None
            }
            (KnownSign::Positive, decided) => Some(decided),
            _ => None,
        };
        let is_small = place.is_zero() && depth == DEEPEST || place.bit_len() > DIGITS;
        let found = if let Some(stability) = certain {
            Found::Certain(stability)
        } else if is_small || self.halved >= MOST_HALVED {
            let undecided = Found::Certain(Stability::Undecided);
            forms.change().map_or(undecided, Found::Change)
        } else {
            self.halved += 1;
            let (lower, upper) = forms.halves();
            let place = place << 1;
            self.look(&lower, place.clone(), depth + 1);
            self.look(&upper, place + Integer::ONE, depth + 1);
            return;
        };
        let [from, to] = [place.clone(), place + Integer::ONE].map(|own| share(own, depth));
        match self.parts.last_mut() {
            // What may be left out stays by itself.
            Some(last) if last.found == found && !last.is_negligible() => last.to = to,
            _ => self.parts.push(Part { from, to, found }),
        }
    }
}
