//! The moment coefficient over a range of twists, with bounds of all rounding.

use std::cmp::Ordering;

use sextic_evaluators::bounded::Bounded;

use super::balance::Balance;

/// Four numbers bⱼ: the cubic Σ bⱼ (3 over j) tʲ (1 − t)³⁻ʲ, whose values lie between the least and the largest of them.
pub(super) type Cubic = [Bounded; 4];

/// C_M over twists in rad, both as cubics in one parameter t from 0 to 1, in which the twist is linear.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    pub twist: Cubic,
    pub moment: Cubic,
}

/// What the excess of twist does on an arc, for certain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Course {
    /// It has this sign.
    Apart(Ordering),
    /// It grows with the twist.
    Rising,
    /// It falls.
    Falling,
}

impl Arc {
    /// C_M from one twist to another.
    pub fn new(from: Bounded, to: Bounded, moment: Cubic) -> Self {
        let third = (to - from) / 3.0;
        Arc {
            twist: [from, from + third, to - third, to],
            moment,
        }
    }

    pub fn from(&self) -> Bounded {
        self.twist[0]
    }

    pub fn to(&self) -> Bounded {
        self.twist[3]
    }

    /// Whether it may hold twists between two.
    pub fn may_meet(&self, [least, most]: [f64; 2]) -> bool {
        let [from, to] = [self.from(), self.to()];
        from.value - from.error <= most && least <= to.value + to.error
    }

    /// Its halves.
    pub fn halves(&self) -> [Arc; 2] {
        let half = Bounded::exact(0.5);
        let [twist, moment] = [split(&self.twist, half), split(&self.moment, half)];
        [0, 1].map(|part| Arc {
            twist: twist[part],
            moment: moment[part],
        })
    }

    /// C_M at a twist; beyond its ends the arc goes on.
    pub fn moment_at(&self, twist: f64) -> Bounded {
        // At a row of the table nothing is rounded.
        for end in [0, 3] {
            if self.twist[end] == Bounded::exact(twist) {
                return self.moment[end];
            }
        }
        let share = (Bounded::exact(twist) - self.from()) / (self.to() - self.from());
        split(&self.moment, share)[0][3]
    }

    /// C_M′, per radian, at a twist.
    pub fn slope_at(&self, twist: f64) -> Bounded {
        let share = (Bounded::exact(twist) - self.from()) / (self.to() - self.from());
        let between = |one: Bounded, other: Bounded| one + (other - one) * share;
        let [a, b, c] = self.slopes();
        between(between(a, b), between(b, c))
    }

    /// C_M′, per radian, lies between these.
    fn slopes(&self) -> [Bounded; 3] {
        let width = self.to() - self.from();
        let [a, b, c, d] = self.moment;
        [b - a, c - b, d - c].map(|own| own * 3.0 / width)
    }

    /// By how much each twist is too much: affine in the twist and its moment, and so a cubic as they are.
    pub fn excess(&self, balance: &Balance) -> Cubic {
        [0, 1, 2, 3].map(|place| balance.excess(self.twist[place], self.moment[place]))
    }

    /// What that does; `None` where it is not seen.
    pub fn course(&self, balance: &Balance) -> Option<Course> {
        let excess = self.excess(balance);
        let rises: Vec<Bounded> = excess.windows(2).map(|pair| pair[1] - pair[0]).collect();
        match (common_sign(&excess), common_sign(&rises)) {
            (Some(sign @ (Ordering::Less | Ordering::Greater)), _) => Some(Course::Apart(sign)),
            (_, Some(Ordering::Greater)) => Some(Course::Rising),
            (_, Some(Ordering::Less)) => Some(Course::Falling),
            _ => None,
        }
    }

    /// The sign that the growth of the twist with the wind has all over the arc, if that is seen.
    pub fn growth(&self, balance: &Balance) -> Option<Ordering> {
        let [twist, moment] = [hull(&self.twist), hull(&self.moment)];
        balance.growth(twist, moment, hull(&self.slopes())).sign()
    }
}

/// A cubic from 0 to a share of its range, and from there to 1, by de Casteljau.
fn split([a, b, c, d]: &Cubic, share: Bounded) -> [Cubic; 2] {
    let between = |one: Bounded, other: Bounded| one + (other - one) * share;
    let [p, q, r] = [between(*a, *b), between(*b, *c), between(*c, *d)];
    let [u, v] = [between(p, q), between(q, r)];
    let middle = between(u, v);
    [[*a, p, u, middle], [middle, v, r, *d]]
}

/// The one sign of all, if there is one.
fn common_sign(own: &[Bounded]) -> Option<Ordering> {
    let first = own.first()?.sign()?;
    own.iter()
        .all(|own| own.sign() == Some(first))
        .then_some(first)
}

/// More than what is lost as the ends of a range are added.
const ABOVE: f64 = 1.0 + 8.0 * f64::EPSILON;

/// All numbers between the least and the largest that any of these may be.
pub(super) fn hull(own: &[Bounded]) -> Bounded {
    let least = own.iter().map(|own| own.value - own.error);
    let most = own.iter().map(|own| own.value + own.error);
    let [least, most] = [
        least.fold(f64::INFINITY, f64::min),
        most.fold(f64::NEG_INFINITY, f64::max),
    ];
    let value = f64::midpoint(least, most);
    let lost = f64::EPSILON * (least.abs() + most.abs());
    Bounded {
        value,
        error: (0.5 * (most - least) + lost) * ABOVE,
    }
}
