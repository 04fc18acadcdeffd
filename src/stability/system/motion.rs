//! Whether the motions of a block grow on a range of a parameter.

use super::arithmetic::Reals;
use super::dense::ABOVE;
use super::entries::Matrices;
use super::jet::{Jet, Jets};
use super::moving::{Disc, Linear, discs, squares, values};
use super::pencil::Pencil;
use super::polynomial::characteristic_polynomial;
use super::real::Real;

/// What is certain of the eigenvalues of a block on a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Motion {
    /// All real parts are below 0.
    Damped,
    /// All real parts are 0, and no eigenvalue is: the block has no damping.
    Neutral,
    /// Nothing.
    Unknown,
    /// A real part is above 0.
    Growing,
    /// A real eigenvalue is above 0.
    Divergent,
}

/// What is certain of a block with these matrices for |δ| ≤ h: by discs and, where these leave it open, as about
/// eigenvalues that coincide and have one vector, by the characteristic polynomial.
pub(super) fn motion(matrices: &Matrices<Jet>, h: f64) -> Motion {
    match by_discs(matrices, h) {
        Motion::Unknown => by_polynomial(matrices, h),
        known => known,
    }
}

/// What the signs of the characteristic polynomial show on the whole range.
fn by_polynomial(matrices: &Matrices<Jet>, h: f64) -> Motion {
    let jets = Jets::new(h);
    let pencil = pencil_of(matrices);
    let range = matrices
        .map(|[power, row, column], own| jets.range(own).scaled(pencil.factor(power, row, column)));
    let Ok(polynomial) = characteristic_polynomial(&range, &Reals);
    let is_negative = |own: &Real| own.centre < -own.radius;
    let is_positive = |own: &Real| own.centre > own.radius;
    let polynomial: Vec<Real> = match polynomial.last() {
        Some(last) if is_positive(last) => polynomial,
        Some(last) if is_negative(last) => polynomial.into_iter().map(|own| -own).collect(),
        _ => return Motion::Unknown,
    };
    if is_negative(&polynomial[0]) {
        return Motion::Divergent;
    }
    by_routh(polynomial)
}

/// What the signs of Routh's scheme show, as far as it goes.
fn by_routh(polynomial: Vec<Real>) -> Motion {
    let degree = polynomial.len() - 1;
    let row = |first: usize| -> Vec<Real> {
        polynomial
            .iter()
            .rev()
            .skip(first)
            .step_by(2)
            .copied()
            .collect()
    };
    let (mut above, mut own) = (row(0), row(1));
    for _ in 0..degree {
        let first = own.first().copied().unwrap_or(Real::ZERO);
        let is_positive = first.centre > first.radius;
        let factor = match above[0].quotient(first) {
            Some(factor) if is_positive => factor,
            _ if first.centre < -first.radius => return Motion::Growing,
            _ => return Motion::Unknown,
        };
        let entry = |(place, upper): (usize, &Real)| {
            *upper - factor * own.get(place + 1).copied().unwrap_or(Real::ZERO)
        };
        let next = above.iter().skip(1).enumerate().map(entry).collect();
        (above, own) = (own, next);
    }
    Motion::Damped
}

fn pencil_of(matrices: &Matrices<Jet>) -> Pencil {
    Pencil::new(matrices.size, |power, row, column| {
        matrices.at(power, row, column).value
    })
}

/// What discs show.
fn by_discs(matrices: &Matrices<Jet>, h: f64) -> Motion {
    let pencil = pencil_of(matrices);
    let scaled =
        matrices.map(|[power, row, column], own| own.scaled(pencil.factor(power, row, column)));
    let is_undamped = scaled.powers[1].iter().all(Jet::is_zero);
    let found = match is_undamped {
        true => squares(&pencil).and_then(|(values, vectors)| {
            let linear = Linear::of_squares(&scaled);
            Some(of_squares(&discs(&linear, &values, &vectors, h)?, h))
        }),
        false => values(&pencil).and_then(|(values, vectors)| {
            let linear = Linear::of_states(&scaled);
            Some(of_states(&discs(&linear, &values, &vectors, h)?, h))
        }),
    };
    found.unwrap_or(Motion::Unknown)
}

/// Discs of λ.
fn of_states(discs: &[Disc], h: f64) -> Motion {
    let reach = |own: &Disc| (h * own.slope.re.abs() + own.radius) * ABOVE;
    if discs.iter().all(|own| own.value.re < -reach(own)) {
        return Motion::Damped;
    }
    of_groups(
        discs,
        h,
        |own| own.value.re > reach(own),
        |own| own.value.re > reach(own),
    )
}

/// Discs of s = λ²: what is not real and below 0 has a root to the right.
fn of_squares(discs: &[Disc], h: f64) -> Motion {
    let groups = groups(discs, h);
    let reach = |own: &Disc| (h * own.slope.re.abs() + own.radius) * ABOVE;
    let is_neutral = |(place, own): (usize, &Disc)| {
        own.value.im == 0.0 && own.value.re < -reach(own) && is_alone(&groups, place)
    };
    if discs.iter().enumerate().all(is_neutral) {
        return Motion::Neutral;
    }
    let is_off = |own: &Disc| {
        own.value.re > reach(own)
            || own.value.im.abs() > (h * own.slope.im.abs() + own.radius) * ABOVE
    };
    of_groups(discs, h, is_off, |own| own.value.re > reach(own))
}

/// What discs show that touch no others.
fn of_groups(
    discs: &[Disc],
    h: f64,
    is_growing: impl Fn(&Disc) -> bool,
    is_right: impl Fn(&Disc) -> bool,
) -> Motion {
    let groups = groups(discs, h);
    let mut found = Motion::Unknown;
    for (place, own) in discs.iter().enumerate() {
        if own.value.im == 0.0 && is_right(own) && is_alone(&groups, place) {
            return Motion::Divergent;
        }
        let mut members = discs
            .iter()
            .zip(&groups)
            .filter(|(_, group)| **group == groups[place]);
        if members.all(|(member, _)| is_growing(member)) {
            found = Motion::Growing;
        }
    }
    found
}

fn is_alone(groups: &[usize], place: usize) -> bool {
    groups.iter().filter(|own| **own == groups[place]).count() == 1
}

/// The group of each disc: those in different ones do not touch at any |δ| ≤ h.
fn groups(discs: &[Disc], h: f64) -> Vec<usize> {
    let touch = |a: &Disc, b: &Disc| {
        let distance = (a.value - b.value).norm() - h * (a.slope - b.slope).norm() * ABOVE;
        distance
            <= (a.radius + b.radius) * ABOVE
                + 4.0 * f64::EPSILON * (a.value.norm() + b.value.norm())
    };
    let mut groups: Vec<usize> = (0..discs.len()).collect();
    for one in 0..discs.len() {
        for other in 0..one {
            if groups[one] != groups[other] && touch(&discs[one], &discs[other]) {
                let (from, to) = (groups[one], groups[other]);
                groups
                    .iter_mut()
                    .filter(|own| **own == from)
                    .for_each(|own| *own = to);
            }
        }
    }
    groups
}
