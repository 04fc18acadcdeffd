//! The wind speeds at which a section begins and ceases to gallop, all of them.

use rayon::prelude::*;

use crate::algebra::budget::Budget;
use crate::algebra::interval::Intervals;
use crate::algebra::number::Rational;
use crate::algebra::trigonometric_sum::TrigonometricSums;

use super::case::Case;
use super::coefficient_table::CoefficientTable;
use super::exact_section::ExactSection;
use super::in_speed::InSpeed;
use super::input::{InputError, Place};
use super::neutral::{enclosure, may_divide, without_pairs};
use super::sections::Sections;
pub use super::speed_part::Stability;
use super::speed_part::{Found, LOWEST, Part};
use super::speed_search::parts;
use super::system::arithmetic::NoValue;

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

impl SpeedRange {
    /// Whether it begins with the lowest speeds of any range, `highest` being the highest speed of all.
    pub fn is_lowest(&self, highest: f64) -> bool {
        self.from <= (highest * 0.5_f64.powi(i32::from(LOWEST))).next_up()
    }
}

/// A wind speed at which stability changes: a simple root of Hurwitz' last determinant but one, or of the
/// determinant of the stiffness; or what these leave open, if less than 2⁻³² of itself, between speeds at which
/// stability differs for certain, so that it changes within.
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
    /// Ranges in order. Speeds below 2⁻¹⁰⁰ of the highest may be in none of them.
    pub ranges: Vec<SpeedRange>,
    /// The speeds at which stability changes for certain, in order, each between two ranges.
    pub critical: Vec<CriticalSpeed>,
    /// Whether a motion neither grows nor dies out at any speed, exactly: then nothing is stable, and what is called
    /// undecided between critical speeds has no motion that grows.
    pub is_neutral: bool,
}

impl Speeds {
    /// Ranges and critical speeds by what is known of each part of the speeds up to a highest one.
    fn new(parts: &[Part], highest: f64, is_neutral: bool) -> Self {
        let mut speeds = Speeds {
            ranges: Vec::new(),
            critical: Vec::new(),
            is_neutral,
        };
        let mut below = None;
        let mut rest = parts;
        while !rest.is_empty() {
            let count = rest
                .iter()
                .take_while(|own| own.certain().is_none())
                .count();
            let (open, others) = rest.split_at(count);
            let above = others.first().and_then(Part::certain);
            match changed(open, below, above) {
                Some(above) => speeds.add_critical(open, highest, above),
                None => open.iter().for_each(|own| speeds.add_open(own, highest)),
            }
            if let (Some(own), Some(stability)) = (others.first(), above) {
                let is_continued = count == 0 && below == Some(stability);
                speeds.add(own, highest, stability, is_continued);
            }
            (below, rest) = (above, others.get(1..).unwrap_or_default());
        }
        speeds
    }

    /// Where a motion is neutral nothing is stable.
    fn shown(&self, stability: Stability) -> Stability {
        match stability {
            Stability::Stable if self.is_neutral => Stability::Undecided,
            other => other,
        }
    }

    fn add_critical(&mut self, parts: &[Part], highest: f64, above: Stability) {
        let (Some(first), Some(last)) = (parts.first(), parts.last()) else {
            return;
        };
        let (low, high) = (speed(&first.from, highest), speed(&last.to, highest));
        self.critical.push(CriticalSpeed {
            speed: (low + high) / 2.0,
            error: (high.next_up() - low) / 2.0 + high * f64::EPSILON,
            becomes: self.shown(above),
        });
    }

    fn add_open(&mut self, part: &Part, highest: f64) {
        if !part.is_negligible() {
            let is_continued = self.ranges.last().is_some_and(|last| {
                last.stability == Stability::Undecided
                    && last.to.next_up() == speed(&part.from, highest)
            });
            self.add(part, highest, Stability::Undecided, is_continued);
        }
    }

    fn add(&mut self, part: &Part, highest: f64, stability: Stability, is_continued: bool) {
        let stability = self.shown(stability);
        let to = match part.to == Rational::ONE {
            true => highest,
            false => speed(&part.to, highest).next_down(),
        };
        let from = match part.from.is_zero() {
            true => 0.0,
            false => speed(&part.from, highest).next_up(),
        };
        match self.ranges.last_mut() {
            Some(last) if is_continued && last.stability == stability => last.to = to,
            _ => self.ranges.push(SpeedRange {
                from,
                to,
                stability,
            }),
        }
    }
}

/// A part is a multiple of a power of 2 of 41 digits, so that only the product is rounded.
fn speed(part: &Rational, highest: f64) -> f64 {
    part.to_f64().value() * highest
}

/// What the section is above some parts that are open, if stability changes within: what is below and above
/// differs, and they are so small together that they enclose the change, or hold just one.
fn changed(open: &[Part], below: Option<Stability>, above: Option<Stability>) -> Option<Stability> {
    let ([first, ..], Some(below), Some(above)) = (open, below, above) else {
        return None;
    };
    let is_one = matches!(open, [only] if only.found == Found::Change([below, above]));
    let last = open.last()?;
    let width = &last.to - &first.from;
    let is_small = width * Rational::from(NARROW) <= last.to;
    (below != above && (is_one || is_small)).then_some(above)
}

/// Speeds that lie within this share of themselves are an enclosure of one.
const NARROW: u64 = 1 << 32;

/// The digits of the enclosures; more where fewer leave something open.
const DIGITS: [usize; 2] = [256, 1024];

/// Products of machine words in the exact coefficients.
const MOST_PRODUCTS: u64 = 1_000_000;

/// The wind speeds at which a section is stable and unstable, above 0 and up to `highest` in m/s.
///
/// The characteristic polynomial is a polynomial in U whose coefficients are enclosed first, and exact where enclosures
/// leave something open; so are Hurwitz' determinants. On a range of speeds they are above 0, or one is below, if their Bernstein coefficients
/// are; a range on which neither is so is halved, down to 2⁻⁴⁰ of the speeds in it. What is left is a
/// critical speed where the last determinant but one, which alone vanishes where a pair of roots becomes
/// imaginary (Orlando), is monotonous and the earlier ones are above 0. Else the roots are compared with lines
/// beside the imaginary axis, by the determinants of the shifted polynomial; what that leaves is undecided.
///
/// Likewise with the constant coefficient, the determinant of the stiffness, which aerodynamic stiffness may
/// make negative: then an odd number of real roots is above 0, and where it vanishes one of them passes 0.
///
/// Without a highest speed above 0 there are no ranges. Bounded: at most 20,000 ranges are halved, with 256
/// binary digits and, where these leave something open, with 1024.
pub fn speeds(section: &ExactSection, highest: f64) -> Speeds {
    let unit = Rational::try_from(highest).unwrap_or_default();
    if unit <= Rational::ZERO {
        return Speeds::new(&[], highest, false);
    }
    if let Some(parts) = enclosed_parts(section, &unit) {
        return Speeds::new(&parts, highest, false);
    }
    let mut found = Speeds::new(&[Part::undecided()], highest, false);
    let sums = TrigonometricSums::new(Budget::new(MOST_PRODUCTS));
    let Ok(polynomial) = section.characteristic_polynomial(&unit, &sums) else {
        return found;
    };
    let stiffness = polynomial.first().cloned().unwrap_or_default();
    let Ok((polynomial, is_neutral)) = without_neutral_pairs(section, polynomial, &unit, &sums)
    else {
        return found;
    };
    for bits in DIGITS {
        let intervals = Intervals::new(bits);
        let polynomial: Vec<_> = polynomial
            .iter()
            .map(|own| enclosure(own, &intervals))
            .collect();
        let parts = parts(&polynomial, &enclosure(&stiffness, &intervals), &intervals);
        found = Speeds::new(&parts, highest, is_neutral);
        if !parts.iter().any(is_open) {
            break;
        }
    }
    found
}

/// Whether more digits may tell more: a single change is isolated as well as it can be.
fn is_open(part: &Part) -> bool {
    part.found == Found::Certain(Stability::Undecided) && !part.is_negligible()
}

/// The parts if enclosures of the coefficients leave nothing open, and tell that no motion is neutral at all speeds: no
/// exact number is needed then.
fn enclosed_parts(section: &ExactSection, unit: &Rational) -> Option<Vec<Part>> {
    let intervals = Intervals::new(DIGITS[0]);
    let polynomial = section.characteristic_polynomial(unit, &intervals).ok()?;
    let parts = parts(&polynomial, polynomial.first()?, &intervals);
    if parts.iter().any(is_open) {
        return None;
    }
    let is_stable = |own: &Part| own.certain() == Some(Stability::Stable);
    if parts.iter().any(is_stable) {
        return Some(parts);
    }
    let is_damped = polynomial
        .iter()
        .skip(1)
        .step_by(2)
        .any(|own| !own.is_empty());
    let squares = section.likely_squares(unit, &intervals).ok()?;
    let mut squares = squares.iter();
    let divides = squares.any(|own| may_divide(own, &polynomial, &intervals));
    (is_damped && !divides).then_some(parts)
}

/// The characteristic polynomial in powers of λ and of the speed without pairs of imaginary roots, and whether there
/// are any at all speeds: a divisor λ² + ν, or all of it where there is no damping at all and the frequencies do not
/// depend on the speed.
fn without_neutral_pairs(
    section: &ExactSection,
    polynomial: Vec<InSpeed>,
    unit: &Rational,
    sums: &TrigonometricSums,
) -> Result<(Vec<InSpeed>, bool), NoValue> {
    let is_undamped = polynomial.iter().skip(1).step_by(2).all(Vec::is_empty);
    let is_still = is_undamped && polynomial.iter().all(|powers| powers.len() <= 1);
    let squares = section.likely_squares(unit, sums)?;
    let (polynomial, count) = without_pairs(polynomial, &squares, sums)?;
    Ok((polynomial, is_still || count > 0))
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
    if case.is_twisted() {
        let what =
            "the mean twist goes with the wind speed, and critical speeds are of one attitude";
        let help = "leave `mean_twist` out, or compute wind speeds one by one: `sextic sweep CASE --vary U=2:40:77`";
        return Err(InputError::new(Place::file(&case.file), what, help));
    }
    let sections = Sections::new(case, table)?;
    let at = |angle: f64| {
        let (section, _) = sections.at(angle, table)?;
        Ok((angle, speeds(&ExactSection::from(&section), highest)))
    };
    let found: Vec<Result<_, InputError>> = case.angles.values().into_par_iter().map(at).collect();
    // The first error, not the one that was found first.
    found.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parts that begin where the one before ends, each with its end in units of 2⁻⁴⁰.
    fn found(parts: &[(u64, Found)], is_neutral: bool) -> Speeds {
        let mut from = Rational::ZERO;
        let part = |&(to, found): &(u64, Found)| {
            let to = Rational::from(to) / Rational::from(1_u64 << 40);
            let part = Part {
                from: from.clone(),
                to: to.clone(),
                found,
            };
            from = to;
            part
        };
        let parts: Vec<Part> = parts.iter().map(part).collect();
        Speeds::new(&parts, 1.0, is_neutral)
    }

    #[test]
    fn what_is_open_between_stable_and_unstable_holds_a_critical_speed() {
        use Stability::{Divergent, Stable, Undecided, Unstable};
        let certain = Found::Certain;
        let (half, all) = (1_u64 << 39, 1_u64 << 40);
        let middle = [
            (half + 1, certain(Undecided)),
            (half + 2, Found::Change([Unstable, Stable])),
        ];
        for (parts, is_neutral, ranges, becomes) in [
            // What the determinants show, and what they leave open: one part or several.
            (
                vec![(half + 1, Found::Change([Stable, Unstable]))],
                false,
                vec![Stable, Unstable],
                vec![Unstable],
            ),
            (
                vec![(half + 1, certain(Undecided))],
                false,
                vec![Stable, Unstable],
                vec![Unstable],
            ),
            (
                middle.to_vec(),
                false,
                vec![Stable, Unstable],
                vec![Unstable],
            ),
            (
                middle.to_vec(),
                true,
                vec![Undecided, Unstable],
                vec![Unstable],
            ),
            // As many speeds as these enclose nothing.
            (
                vec![(half + half / 2, certain(Undecided))],
                false,
                vec![Stable, Undecided, Unstable],
                vec![],
            ),
        ] {
            let parts = [
                vec![(half, certain(Stable))],
                parts,
                vec![(all, certain(Unstable))],
            ]
            .concat();
            let speeds = found(&parts, is_neutral);
            let kinds: Vec<_> = speeds.ranges.iter().map(|own| own.stability).collect();
            let changes: Vec<_> = speeds.critical.iter().map(|own| own.becomes).collect();
            assert_eq!((kinds, changes), (ranges, becomes), "{parts:?}");
            for own in &speeds.critical {
                assert!(
                    (own.speed - 0.5).abs() <= own.error && own.error < 1e-11,
                    "{own:?}"
                );
            }
        }
        // Where the same is on both sides nothing need change.
        let parts = [
            (half, certain(Stable)),
            (half + 1, certain(Undecided)),
            (all, certain(Stable)),
        ];
        let speeds = found(&parts, false);
        assert_eq!(speeds.ranges.len(), 3);
        assert!(speeds.critical.is_empty());
        // A change that is proven to be one, however wide.
        let parts = [
            (half, certain(Unstable)),
            (half + half / 2, Found::Change([Unstable, Divergent])),
            (all, certain(Divergent)),
        ];
        assert_eq!(found(&parts, false).critical.len(), 1);
    }
}
