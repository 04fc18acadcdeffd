//! All twists in balance within a range, each apart from the others.

use std::cmp::Ordering;

use super::arc::{Arc, Course};
use super::balance::Balance;

/// A range of twists that holds one in balance, or of which nothing is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Range {
    /// From the least to the largest twist, in rad.
    pub ends: [f64; 2],
    pub kind: Kind,
}

impl Range {
    /// Whether it may hold the balance without a twist.
    pub fn holds_no_twist(&self) -> bool {
        let [least, most] = self.ends;
        least <= 0.0 && 0.0 <= most
    }

    /// The range seen from the other side.
    pub fn mirrored(self) -> Self {
        let [least, most] = self.ends;
        Range {
            ends: [-most, -least],
            ..self
        }
    }
}

/// What a range of twists holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// One balance, which is stable: the excess rises through 0 there, and all over the range.
    Stable,
    /// One balance, which is not: the excess falls.
    Unstable,
    /// It is not known how many.
    Unclear,
}

/// So often an arc is halved, and into so many parts all of them are at most.
const HALVINGS: u32 = 24;
const MOST_PARTS: usize = 4096;

/// A part of the range, with the signs of the excess at its ends where they are known.
#[derive(Clone, Copy, Debug)]
struct Part {
    ends: [f64; 2],
    signs: [Option<Ordering>; 2],
    course: Option<Course>,
}

/// The ranges that hold balances on arcs that follow each other, in their order: outside of them there is none.
pub(super) fn balances(arcs: &[Arc], balance: &Balance) -> Vec<Range> {
    let mut parts = Vec::new();
    for arc in arcs {
        add_parts(*arc, balance, HALVINGS, &mut parts);
    }
    let is_apart = |own: &Part| matches!(own.course, Some(Course::Apart(_)));
    // What rises, or falls, from part to part does so all over them; else each part is looked at by itself.
    let runs = parts.chunk_by(|one, next| one.course == next.course && !is_apart(one));
    let runs: Vec<Part> = runs.map(joined).collect();
    let known = (0..runs.len()).map(|place| with_signs_beside(&runs, place));
    joined_unclear(known.filter_map(range))
}

/// An arc in parts on which the excess is seen to be apart from 0, to rise or to fall.
fn add_parts(arc: Arc, balance: &Balance, halvings: u32, parts: &mut Vec<Part>) {
    let course = arc.course(balance);
    let excess = arc.excess(balance);
    // Where rounding hides the excess, smaller parts show no more of it.
    let is_hidden = excess.iter().all(|own| own.value.abs() <= own.error);
    if course.is_none() && halvings > 0 && !is_hidden && parts.len() < MOST_PARTS {
        for half in arc.halves() {
            add_parts(half, balance, halvings - 1, parts);
        }
        return;
    }
    let (from, to) = (arc.from(), arc.to());
    parts.push(Part {
        ends: [from.value - from.error, to.value + to.error],
        signs: [excess[0].sign(), excess[3].sign()],
        course,
    });
}

/// Parts of one course, each beginning where the one before ends.
fn joined(parts: &[Part]) -> Part {
    let (first, last) = (parts[0], parts[parts.len() - 1]);
    Part {
        ends: [first.ends[0], last.ends[1]],
        signs: [first.signs[0], last.signs[1]],
        course: first.course,
    }
}

/// A part whose ends have the signs of the parts beside, where these are apart from 0.
///
/// Where the table ends in balance only one side of it is known, and is all that counts.
fn with_signs_beside(parts: &[Part], place: usize) -> Part {
    let sign = |place: Option<usize>| match parts.get(place?)?.course {
        Some(Course::Apart(sign)) => Some(sign),
        _ => None,
    };
    let own = parts[place];
    let beside = [sign(place.checked_sub(1)), sign(Some(place + 1))];
    let is_last = [place == 0, place + 1 == parts.len()];
    let signs = [0, 1].map(|end| match (own.signs[end], own.signs[1 - end]) {
        (Some(Ordering::Equal), Some(other)) if is_last[end] => Some(other.reverse()),
        (sign, _) => sign.or(beside[end]),
    });
    Part { signs, ..own }
}

/// What a part holds, if it holds a balance or is not known to hold none.
fn range(part: Part) -> Option<Range> {
    use Ordering::{Greater, Less};
    let kind = match (part.course, part.signs) {
        (Some(Course::Apart(_)), _) => return None,
        (Some(Course::Rising), [Some(Less), Some(Greater)]) => Kind::Stable,
        (Some(Course::Falling), [Some(Greater), Some(Less)]) => Kind::Unstable,
        (Some(Course::Rising | Course::Falling), [Some(one), Some(other)])
            if one == other && one != Ordering::Equal =>
        {
            return None;
        }
        _ => Kind::Unclear,
    };
    Some(Range {
        ends: part.ends,
        kind,
    })
}

/// Neighbours of which nothing is known, as one range.
fn joined_unclear(ranges: impl Iterator<Item = Range>) -> Vec<Range> {
    let mut all: Vec<Range> = Vec::new();
    for own in ranges {
        match all.last_mut() {
            Some(last) if last.kind == Kind::Unclear && own.kind == Kind::Unclear => {
                last.ends[1] = own.ends[1];
            }
            _ => all.push(own),
        }
    }
    all
}
