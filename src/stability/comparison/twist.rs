//! What is said of the mean twists of a case.

use super::point::Point;
use super::range::{joined, listed, ranges};
use crate::stability::case::Case;
use crate::stability::input::{Place, Remark};
use crate::stability::mean_twist::{NoTwist, Twist};

/// An angle of the sweep at which there is no certain mean twist, and so no section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoBalance {
    /// Which angle of the sweep it is, from 0.
    pub place: usize,
    /// The angle, in degrees.
    pub angle: f64,
    /// Why there is none.
    pub reason: NoTwist,
}

/// Where there is no certain mean twist: a remark for each reason.
pub(super) fn remarks_without_balance(
    case: &Case,
    without: &[NoBalance],
    angles: usize,
) -> Vec<Remark> {
    let mut reasons: Vec<NoTwist> = Vec::new();
    for own in without {
        if !reasons.contains(&own.reason) {
            reasons.push(own.reason);
        }
    }
    let remark = |reason: NoTwist| {
        let own = without.iter().filter(|own| own.reason == reason);
        let places: Vec<(usize, f64)> = own.map(|own| (own.place, own.angle)).collect();
        let (count, ranges) = (places.len(), listed(&joined(&places)));
        Remark {
            place: Place::file(&case.file),
            what: format!(
                "at {count} of {angles} angles ({ranges}) there is no verdict: {reason}; {}",
                reason.help()
            ),
        }
    };
    reasons.into_iter().map(remark).collect()
}

/// A stiffness of the turn below this, over that of the springs, is close to static divergence.
const WEAK: f64 = 0.1;

/// What may be odd about a twist, and what is said of it.
type Oddity = (fn(&Twist) -> bool, &'static str);

/// Where a twist is not the only one in balance, is not reached without a jump, or close to divergence.
pub(super) fn remarks(
    case: &Case,
    points: &[Point],
    angles: usize,
) -> impl Iterator<Item = Remark> {
    let parts: [Oddity; 3] = [
        (
            |own| !own.is_only,
            "springs and wind are in balance at more than one mean twist, as far as is seen: that is taken which a rising \
             wind reaches first",
        ),
        (
            |own| !own.is_steady,
            "it is not seen that the mean twist grows there without a jump as the wind rises: at a lower wind speed the \
             section may snap over",
        ),
        (
            |own| own.stiffness < WEAK,
            "the wind takes more than 90 % of the stiffness of the turn at the mean twist: static divergence is close",
        ),
    ];
    parts.into_iter().filter_map(move |(is_so, what)| {
        let is_so = |point: &Point| point.twist.as_ref().is_some_and(is_so);
        let count = points.iter().filter(|own| is_so(own)).count();
        (count > 0).then(|| Remark {
            place: Place::file(&case.file),
            what: format!(
                "at {count} of {angles} angles ({}): {what}",
                listed(&ranges(points, is_so))
            ),
        })
    })
}
