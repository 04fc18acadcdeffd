//! How far the forms are from the exact modes.

use super::form::Form;
use crate::stability::verdict::{Doubt, Verdict};

/// Less than this share of |S_a| is rounding.
pub(super) const ROUNDING: f64 = 1e-12;

/// How far a form is from the exact modes at some angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// The largest error of S over |S_a|, the Frobenius norm of the scaled damping matrix (18).
    pub error: f64,
    /// The angle where it is that, in degrees.
    pub angle: f64,
    /// At so many angles S has the wrong sign for certain.
    pub wrong_signs: usize,
    /// At so many more it is not known whether it has: the exact S is within its error of 0.
    pub open_signs: usize,
    /// At so many angles the form has an answer.
    pub answers: usize,
}

/// The errors of all forms; `None` where one does not apply.
pub type Departures = [Option<Departure>; 3];

impl Departure {
    /// Nothing yet, at an angle.
    fn none(angle: f64) -> Self {
        Departure {
            error: 0.0,
            angle,
            wrong_signs: 0,
            open_signs: 0,
            answers: 0,
        }
    }

    /// At one angle.
    pub(super) fn of(angle: f64, shift: Shift) -> Self {
        Departure {
            error: shift.error,
            wrong_signs: usize::from(shift.sign == Sign::Wrong),
            open_signs: usize::from(shift.sign == Sign::Open),
            answers: 1,
            ..Departure::none(angle)
        }
    }

    /// At these angles and at those that follow.
    fn and(self, other: Departure) -> Self {
        let larger = if other.error > self.error {
            other
        } else {
            self
        };
        Departure {
            wrong_signs: self.wrong_signs + other.wrong_signs,
            open_signs: self.open_signs + other.open_signs,
            answers: self.answers + other.answers,
            ..larger
        }
    }
}

/// Those at some angles and at others that follow.
pub(super) fn joined(some: Departures, others: Departures) -> Departures {
    Form::ALL.map(|form| match (some[form as usize], others[form as usize]) {
        (Some(some), Some(others)) => Some(some.and(others)),
        (some, others) => some.or(others),
    })
}

/// Those at all angles, infinite for a form that has no answer at one of them.
pub(super) fn whole(found: Departures, angles: &[f64]) -> [Departure; 3] {
    let none = Departure {
        error: f64::INFINITY,
        ..Departure::none(angles[0])
    };
    found.map(|own| {
        own.filter(|own| own.answers == angles.len())
            .unwrap_or(none)
    })
}

/// The error of S over |S_a|, and what is known of its sign.
#[derive(Clone, Copy)]
pub(super) struct Shift {
    error: f64,
    sign: Sign,
}

impl Shift {
    /// Without forces there is nothing to be wrong about.
    pub const NONE: Shift = Shift {
        error: 0.0,
        sign: Sign::Right,
    };

    /// That of an S from the exact one, on which there may be a verdict; `size` is |S_a|.
    pub fn new(value: f64, exact: f64, size: f64, verdict: Option<Verdict>) -> Self {
        Shift {
            error: (value - exact).abs() / size,
            sign: Sign::of(value, ROUNDING * size, verdict),
        }
    }
}

/// What is known of the sign of S.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sign {
    /// It is not wrong, or so small that its rounding may be.
    Right,
    /// It is wrong for certain.
    Wrong,
    /// Nothing.
    Open,
}

impl Sign {
    fn of(value: f64, rounding: f64, verdict: Option<Verdict>) -> Self {
        match verdict {
            Some(own) if own.refutes(value, rounding) => Sign::Wrong,
            Some(
                Verdict::Stable(_) | Verdict::Unstable(_) | Verdict::Undecided(Doubt::Neutral),
            ) => Sign::Right,
            _ if value.abs() <= rounding => Sign::Right,
            _ => Sign::Open,
        }
    }
}
