//! How far another method agrees with the state matrix, and why it does not.

use std::cmp::Ordering;
use std::fmt;
use std::mem::discriminant;

use super::point::Point;
use super::range::{AngleRange, ranges};
use super::value::Value;
use crate::stability::closed_form::Estimate;
use crate::stability::limitation::Limitation;

/// A method other than the state matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The companion matrix of the characteristic polynomial, Eq. (19).
    Companion,
    /// The closed forms, Eqs. (21)–(23).
    Closed,
    /// The uniform form, for every eccentricity.
    Uniform,
}

impl Method {
    /// The name in files: `companion`, `closed`, `uniform`.
    pub fn name(self) -> &'static str {
        match self {
            Method::Companion => "companion",
            Method::Closed => "closed",
            Method::Uniform => "uniform",
        }
    }
}

/// Why a method differs from the state matrix, or has no answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reason {
    /// What speaks against a form, where it does so most.
    Limitation(Limitation),
    /// Nothing else: the closed forms leave out what is of second order in the damping.
    FirstOrder {
        /// The largest (δ|S_a|/e)² where they differ.
        second_order: f64,
    },
    /// Nothing else: the uniform form leaves out what is of third order in the damping.
    ThirdOrder,
    /// The rounding of the coefficients moves the roots.
    IllConditioned {
        /// The largest bound of the error of S.
        error: f64,
    },
    /// No eigenvalues with a bounded error were found.
    NoAnswer,
}

impl fmt::Display for Reason {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Reason::Limitation(own) => {
                let is_of_an_angle = matches!(
                    own,
                    Limitation::Eccentricity { .. } | Limitation::StrongDamping { .. }
                );
                let place = if is_of_an_angle {
                    " (at the worst angle)"
                } else {
                    ""
                };
                write!(formatter, "{own}{place}")
            }
            Reason::FirstOrder { second_order } => write!(
                formatter,
                "the closed form is of first order: what it leaves out is of the order of \
                 (δ|S_a| r/L_g)², up to {second_order:.2}"
            ),
            Reason::ThirdOrder => write!(
                formatter,
                "the uniform form leaves out what is of the third order in the damping"
            ),
            Reason::IllConditioned { error } => write!(
                formatter,
                "the companion matrix is ill-conditioned: rounding its coefficients moves S by up to {error:.0e}"
            ),
            Reason::NoAnswer => write!(formatter, "no eigenvalues with a bounded error were found"),
        }
    }
}

/// How a method agrees with the state matrix over a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Agreement {
    /// The method.
    pub method: Method,
    /// At how many angles it has an answer.
    pub answers: usize,
    /// The largest difference of S and its angle in degrees; `None` without an answer.
    pub largest_difference: Option<(f64, f64)>,
    /// The largest bound of the errors of both, if the method has one.
    pub largest_error: Option<f64>,
    /// Where it differs by more than the errors of both and 1 % of the largest |S|.
    pub differs: Vec<AngleRange>,
    /// Where it calls stable what is unstable for certain, or unstable what is not.
    pub opposite: Vec<AngleRange>,
    /// Why it differs or has no answer, in the order in which one should look.
    pub reasons: Vec<Reason>,
}

/// A method differs notably by this share of the largest |S| of the sweep.
const NOTABLE: f64 = 0.01;

/// Fewer certain digits than six, as a share of the largest |S|, are an ill-conditioned matrix.
const ILL_CONDITIONED: f64 = 1e-6;

/// How the other methods agree with the state matrix.
pub(super) fn agreements(points: &[Point]) -> Vec<Agreement> {
    // The forms have no bound of their rounding; it is far below what they leave out.
    let rounded = |point: &Point, estimate: &Estimate| {
        let value = estimate.value?;
        Some(Value {
            value,
            error: 1e-12 * (value.abs() + point.scaled_damping),
        })
    };
    vec![
        agreement(points, Method::Companion, |point| point.companion),
        agreement(points, Method::Closed, |point| {
            rounded(point, &point.closed)
        }),
        agreement(points, Method::Uniform, |point| {
            rounded(point, &point.uniform)
        }),
    ]
}

fn agreement(
    points: &[Point],
    method: Method,
    answer: impl Fn(&Point) -> Option<Value>,
) -> Agreement {
    let sizes = points.iter().map(|point| point.exact.value.abs());
    let size = sizes.fold(0.0, f64::max);
    let difference = |point: &Point| Some((answer(point)?.value - point.exact.value).abs());
    let errors = |point: &Point| Some(answer(point)?.error + point.exact.error);
    let differs = |point: &Point| {
        let both = difference(point).zip(errors(point));
        both.is_some_and(|(difference, errors)| difference > errors + NOTABLE * size)
    };
    let is_opposite = |point: &Point| {
        answer(point).is_some_and(|own| point.verdict.refutes(own.value, own.error))
    };
    let answers = points
        .iter()
        .filter(|point| answer(point).is_some())
        .count();
    let largest = |number: &dyn Fn(&Point) -> Option<f64>| {
        let numbers = points
            .iter()
            .filter_map(|point| Some((number(point)?, point.angle)));
        numbers.reduce(|one, other| if other.0 > one.0 { other } else { one })
    };
    let wrong: Vec<&Point> = points
        .iter()
        .filter(|point| differs(point) || is_opposite(point) || answer(point).is_none())
        .collect();
    let largest_error = largest(&errors).map(|(error, _)| error);
    let reasons = match method {
        Method::Closed => form_reasons(
            &wrong,
            |point| &point.closed,
            |second_order| Reason::FirstOrder { second_order },
        ),
        Method::Uniform => form_reasons(&wrong, |point| &point.uniform, |_| Reason::ThirdOrder),
        Method::Companion => {
            let ill = largest_error.filter(|error| *error > ILL_CONDITIONED * size);
            let none = (answers < points.len()).then_some(Reason::NoAnswer);
            let ill = ill.map(|error| Reason::IllConditioned { error });
            none.into_iter().chain(ill).collect()
        }
    };
    Agreement {
        method,
        answers,
        largest_difference: largest(&difference),
        largest_error: largest_error.filter(|_| method == Method::Companion),
        differs: ranges(points, differs),
        opposite: ranges(points, is_opposite),
        reasons,
    }
}

/// Why a form is wrong at these points: each kind of limitation at its worst, and the order of the form where none
/// explains it.
fn form_reasons(
    wrong: &[&Point],
    estimate: fn(&Point) -> &Estimate,
    order: impl Fn(f64) -> Reason,
) -> Vec<Reason> {
    // That the sign may be wrong is told by the order of what is left out.
    let explains = |own: &&Limitation| !matches!(own, Limitation::Sign { .. });
    let limitations = |point: &&Point| {
        let own = estimate(point).limitations.iter();
        own.filter(explains).copied().collect::<Vec<_>>()
    };
    let mut worst: Vec<Limitation> = wrong.iter().flat_map(limitations).collect();
    // No number is NaN: each was compared before.
    worst.sort_by(|one, other| other.partial_cmp(one).unwrap_or(Ordering::Equal));
    worst.dedup_by_key(|own| discriminant(own));
    let is_unexplained = wrong.iter().any(|point| limitations(point).is_empty());
    let second_order = wrong.iter().map(|point| point.second_order);
    let order = is_unexplained.then(|| order(second_order.fold(0.0, f64::max)));
    let reasons = worst.into_iter().rev().map(Reason::Limitation);
    reasons.chain(order).collect()
}
