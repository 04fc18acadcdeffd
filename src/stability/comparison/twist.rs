//! What is said of the mean twists of a case.

use super::point::Point;
use super::range::{listed, ranges};
use crate::stability::case::Case;
use crate::stability::input::{Place, Remark};
use crate::stability::mean_twist::Twist;

/// A stiffness of the turn below this, over that of the springs, is close to static divergence.
const WEAK: f64 = 0.1;

/// What may be odd about a twist, and what is said of it.
type Oddity = (fn(&Twist) -> bool, &'static str);

/// Where a twist is not the only one in balance, is not reached without a jump, or close to divergence.
pub(super) fn remarks(case: &Case, points: &[Point]) -> impl Iterator<Item = Remark> {
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
    parts.into_iter().filter_map(|(is_so, what)| {
        let is_so = |point: &Point| point.twist.as_ref().is_some_and(is_so);
        let count = points.iter().filter(|own| is_so(own)).count();
        (count > 0).then(|| Remark {
            place: Place::file(&case.file),
            what: format!(
                "at {count} of {} angles ({}): {what}",
                points.len(),
                listed(&ranges(points, is_so))
            ),
        })
    })
}
