//! The mean twist: where springs and the mean moment of the wind are in balance (`derivations/extensions.md`, section 5).

mod arc;
mod balance;
mod course;

use std::cmp::Ordering;
use std::f64::consts::PI;
use std::fmt;

use sextic_evaluators::bounded::Bounded;

use self::arc::{Arc, hull};
use self::balance::Balance;
use self::course::{Kind, Range, balances};
use super::interpolation::{CoefficientCurves, MomentPiece};
use super::parameters::Parameters;

/// A twist at which springs and wind are in balance, found with proof for the curve of C_M.
///
/// It is that which a wind that rises slowly from nothing reaches first: of all balances on the side to which the moment
/// turns the section, the one with the smallest twist. It is stable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist {
    /// θ_s, in rad.
    pub angle: f64,
    /// The balance is no farther from it, in rad: [`BOUND`], or 0 where it is known exactly.
    pub error: f64,
    /// The stiffness of the turn there, that of the wind included, over that of the springs: at 0 the section diverges.
    pub stiffness: f64,
    /// Whether no other twist is in balance, up to half a turn and as far as the table goes.
    pub is_only: bool,
    /// Whether the twist grows there without a jump as the wind rises: else the section snaps over on its way.
    pub is_steady: bool,
}

impl Twist {
    /// `only`, `several` or `jump`: whether it is the only one in balance; a jump on the way to it is said before.
    pub fn word(&self) -> &'static str {
        match (self.is_steady, self.is_only) {
            (false, _) => "jump",
            (true, false) => "several",
            (true, true) => "only",
        }
    }
}

/// The bound of the error of a twist, in rad.
pub const BOUND: f64 = 1.0 / (1_u64 << 38) as f64;

/// Why there is no twist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoTwist {
    /// No balance before the table ends, at this angle in degrees.
    BeyondTable(f64),
    /// No balance before the coefficients jump, at this angle in degrees.
    AtJump(f64),
    /// No balance within half a turn.
    BeyondHalfTurn,
    /// Springs and wind are nearly in balance at several twists, so that none is certain to [`BOUND`].
    NotCertain,
    /// Without a moment there is no twist, but the wind turns the section over: static divergence.
    Unstable,
}

impl fmt::Display for NoTwist {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoTwist::BeyondTable(end) => write!(
                formatter,
                "the mean moment twists the section beyond {end}°, to where the table ends"
            ),
            NoTwist::AtJump(end) => write!(
                formatter,
                "the mean moment twists the section to {end}°, where the coefficients of the table jump and springs and \
                 wind are not in balance"
            ),
            NoTwist::BeyondHalfTurn => {
                formatter.write_str("the mean moment twists the section by more than half a turn")
            }
            NoTwist::NotCertain => formatter.write_str(
                "the mean twist is not certain: springs and wind are nearly in balance over a range of twists, close to static divergence",
            ),
            NoTwist::Unstable => formatter.write_str(
                "without mean moment there is no mean twist, but the wind turns the section over: static divergence",
            ),
        }
    }
}

impl std::error::Error for NoTwist {}

impl NoTwist {
    /// What to do about it.
    pub fn help(&self) -> &'static str {
        match self {
            NoTwist::AtJump(_) => {
                "correct the rows there, as lift and moment of what is its own mirror image are 0 at 0° and 180°; lower the \
                 wind speed, stiffen the turn, or leave `mean_twist` out"
            }
            NoTwist::BeyondTable(_) => {
                "complete the table, lower the wind speed, stiffen the turn, or leave `mean_twist` out"
            }
            _ => "lower the wind speed, stiffen the turn, or leave `mean_twist` out",
        }
    }
}

/// The moment coefficient of a table, for the twists of sections.
#[derive(Clone, Debug)]
pub(super) struct MomentCurve {
    pieces: Vec<MomentPiece>,
    /// The largest |C_M| of each.
    largest: Vec<f64>,
    is_whole: bool,
    /// The ends of the table, where it closes with a jump.
    jump: Option<[f64; 2]>,
}

/// Half a turn, in degrees.
const HALF_TURN: f64 = 180.0;

/// π/180.
const RADIAN: Bounded = Bounded {
    value: PI / 180.0,
    error: f64::EPSILON * (PI / 180.0),
};

impl MomentCurve {
    /// That of some curves.
    pub fn of(curves: &CoefficientCurves) -> Self {
        let (pieces, is_whole) = curves.moment_pieces();
        let largest = |own: &MomentPiece| {
            let sizes = own.cubics.as_flattened().iter();
            sizes.fold(0.0, |most: f64, own| most.max(own.value.abs() + own.error))
        };
        MomentCurve {
            largest: pieces.iter().map(largest).collect(),
            pieces,
            is_whole,
            jump: curves.jump(),
        }
    }

    /// The twist of a section whose angle of attack would be at this place of a piece, in degrees, without it.
    ///
    /// Linear in the cells of the table that the largest moment can twist the section over.
    ///
    /// # Errors
    ///
    /// If there is no balance, or none that is certain.
    pub fn twist(
        &self,
        parameters: &Parameters,
        (piece, place): (usize, f64),
    ) -> Result<Twist, NoTwist> {
        let balance = Balance::of(parameters);
        // Every balance is within this.
        let reach = balance.largest_twist(self.largest[piece]).to_degrees() * (1.0 + 1e-12);
        let arcs = self.arcs(&self.pieces[piece], place, reach.min(HALF_TURN));
        let search = Search {
            balances: balances(&arcs, &balance),
            arcs,
            balance,
        };
        search.twist().map_err(|none| match none {
            NoTwist::BeyondHalfTurn => self.beyond((piece, place), search.direction()),
            other => other,
        })
    }

    /// What ends the search from a place of a piece, where the excess without twist has this sign: the table, a jump of it,
    /// or half a turn.
    pub fn beyond(&self, (piece, place): (usize, f64), excess: Option<Ordering>) -> NoTwist {
        let [first, last] = self.pieces[piece].ends();
        let end = match excess {
            Some(Ordering::Greater) => first,
            _ => last,
        };
        let jumps = self.jump.is_some_and(|ends| ends.contains(&end));
        match (self.is_whole || (end - place).abs() >= HALF_TURN, jumps) {
            (true, _) => NoTwist::BeyondHalfTurn,
            (false, true) => NoTwist::AtJump(end),
            (false, false) => NoTwist::BeyondTable(end),
        }
    }

    /// The arcs that begin or end within a reach of a place, in degrees, from the lowest to the highest: round the circle
    /// where the curve goes on.
    fn arcs(&self, piece: &MomentPiece, place: f64, reach: f64) -> Vec<Arc> {
        let count = piece.cubics.len() as isize;
        let [first, last] = piece.ends();
        let turn = sum(Bounded::exact(last), -first);
        let twist = |cell: usize, turns: isize| {
            let angle = sum(times(turn, turns), piece.angles[cell]);
            sum(angle, -place) * RADIAN
        };
        let arc = |own: isize| {
            let (cell, turns) = (own.rem_euclid(count) as usize, own.div_euclid(count));
            let [from, to] = [twist(cell, turns), twist(cell + 1, turns)];
            Arc::new(from, to, piece.cubics[cell])
        };
        let is_there = |own: &isize| self.is_whole || (0..count).contains(own);
        let start = piece.cell(place) as isize;
        let reach = reach.to_radians();
        let below = (0..).map(|steps| start - 1 - steps).take_while(is_there);
        let below = below.map(arc).take_while(|own| own.to().value > -reach);
        let above = (0..).map(|steps| start + steps).take_while(is_there);
        let above = above.map(arc).take_while(|own| own.from().value < reach);
        let mut arcs: Vec<Arc> = below.collect();
        arcs.reverse();
        arcs.extend(above);
        arcs
    }
}

/// So many times a number: exact for a turn, back or forth, and for none.
fn times(own: Bounded, count: isize) -> Bounded {
    match count {
        0 => Bounded::exact(0.0),
        1 => own,
        -1 => -own,
        other => own * other as f64,
    }
}

/// A sum with what rounding takes from it, which is nothing where it is exact.
fn sum(own: Bounded, other: f64) -> Bounded {
    let value = own.value + other;
    let added = value - own.value;
    let lost = (own.value - (value - added)) + (other - added);
    let error = (own.error + lost.abs()) * (1.0 + 2.0 * f64::EPSILON);
    Bounded { value, error }
}

/// The balances of a section, and where they were sought.
struct Search {
    arcs: Vec<Arc>,
    balances: Vec<Range>,
    balance: Balance,
}

/// So often an arc is halved to see that the twist grows along it.
const HALVINGS: u32 = 12;

/// The most steps to a root: halving alone would need no more.
const STEPS: usize = 100;

impl Search {
    fn twist(&self) -> Result<Twist, NoTwist> {
        let direction = self.direction();
        let range = self.first(direction).ok_or(NoTwist::BeyondHalfTurn)?;
        match (range.kind, direction) {
            (Kind::Stable, Some(Ordering::Equal)) => Ok(self.found(0.0, 0.0)),
            (Kind::Stable, _) => self.certain(range),
            (Kind::Unstable, Some(Ordering::Equal)) => Err(NoTwist::Unstable),
            _ => Err(NoTwist::NotCertain),
        }
    }

    /// The sign of the excess without twist: the moment turns the section to where that falls to 0. `None` where rounding
    /// leaves it open.
    fn direction(&self) -> Option<Ordering> {
        self.excess(0.0).sign()
    }

    /// The first range on the side to which the moment turns; without a moment that which holds no twist.
    fn first(&self, direction: Option<Ordering>) -> Option<Range> {
        let mut all = self.balances.iter().copied();
        match direction {
            Some(Ordering::Less) => all.find(|own| is_ahead(*own)),
            Some(Ordering::Greater) => all.rev().find(|own| is_ahead(own.mirrored())),
            _ => all.find(Range::holds_no_twist),
        }
    }

    /// The balance of a range, certain to [`BOUND`].
    fn certain(&self, range: Range) -> Result<Twist, NoTwist> {
        let angle = self.root(range.ends);
        match [angle - BOUND, angle + BOUND].map(|own| self.excess(own).sign()) {
            [Some(Ordering::Less), Some(Ordering::Greater)] => Ok(self.found(angle, BOUND)),
            _ => Err(NoTwist::NotCertain),
        }
    }

    fn found(&self, angle: f64, error: f64) -> Twist {
        let slopes: Vec<Bounded> = self.at(angle).map(|own| own.slope_at(angle)).collect();
        Twist {
            angle,
            error,
            stiffness: self.balance.stiffness(hull(&slopes)).value,
            is_only: self.balances.len() == 1,
            is_steady: self.is_steady(angle),
        }
    }

    /// Whether the twist is seen to grow with the wind from nothing to here.
    fn is_steady(&self, angle: f64) -> bool {
        let Some(direction) = self.direction() else {
            return true;
        };
        let way = [angle.min(0.0), angle.max(0.0)];
        let grows = |arc: &Arc| {
            let growth = arc.growth(&self.balance);
            growth.map(Ordering::reverse) == Some(direction)
        };
        fn all(arc: &Arc, way: [f64; 2], grows: &dyn Fn(&Arc) -> bool, halvings: u32) -> bool {
            let halves = || {
                arc.halves()
                    .iter()
                    .all(|own| all(own, way, grows, halvings - 1))
            };
            !arc.may_meet(way) || grows(arc) || halvings > 0 && halves()
        }
        direction == Ordering::Equal || self.arcs.iter().all(|own| all(own, way, &grows, HALVINGS))
    }

    /// The arcs that may hold a twist.
    fn at(&self, twist: f64) -> impl Iterator<Item = &Arc> {
        self.arcs.iter().filter(move |own| own.may_meet([twist; 2]))
    }

    /// By how much a twist is too much.
    fn excess(&self, twist: f64) -> Bounded {
        let moments: Vec<Bounded> = self.at(twist).map(|own| own.moment_at(twist)).collect();
        self.balance.excess(Bounded::exact(twist), hull(&moments))
    }

    /// Near where the excess is 0 between two twists, below and above: by the rule of Illinois, and where that is slow by
    /// halving.
    fn root(&self, [mut below, mut above]: [f64; 2]) -> f64 {
        let value = |own: f64| self.excess(own).value;
        let (mut low, mut high) = (value(below), value(above));
        for step in 0..STEPS {
            let chord = below - low * (above - below) / (high - low);
            let is_within = below < chord && chord < above;
            let middle = match is_within && step % 4 != 3 {
                true => chord,
                false => f64::midpoint(below, above),
            };
            let own = value(middle);
            if own == 0.0 || above - below <= BOUND / 8.0 {
                return middle;
            }
            match own < 0.0 {
                true => (below, low, high) = (middle, own, 0.5 * high),
                false => (above, high, low) = (middle, own, 0.5 * low),
            }
        }
        f64::midpoint(below, above)
    }
}

/// Whether the balance of a range may lie above no twist, where the excess is below 0.
fn is_ahead(range: Range) -> bool {
    match range.ends {
        [least, _] if least >= 0.0 => true,
        [_, most] if most <= 0.0 => false,
        _ => range.kind != Kind::Unstable,
    }
}
