//! Discs that hold eigenvalues for certain.
//!
//! Pellet's theorem: if |q_k| R^k > Σ_{j≠k} |q_j| R^j, the polynomial Σ q_j μ^j has exactly k roots
//! in |μ| < R. With the Taylor coefficients of the characteristic polynomial about an approximate
//! eigenvalue this needs no condition number, and holds for multiple and defective eigenvalues too.

use num_complex::Complex;

use super::ball::Ball;

/// A group of approximate eigenvalues, and a disc that holds as many exact ones.
struct Group {
    members: Vec<usize>,
    centre: Complex<f64>,
    /// `None` if no disc about the centre is known to hold just so many.
    radius: Option<f64>,
    /// Whether the polynomial is not told from 0 at the centre.
    is_root: bool,
}

/// Bounds of the errors of approximate eigenvalues.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Bounds {
    /// One for each.
    pub errors: Vec<f64>,
    /// Whether the polynomial is not told from 0 at any of them: no others are known to be better.
    pub are_roots: bool,
}

/// Bounds of the errors of approximate eigenvalues: there is a one-to-one assignment of the exact
/// eigenvalues, none farther from its approximation than this.
///
/// `taylor` gives the coefficients of the characteristic polynomial, which is real, about a point; it has as
/// many roots as there are values, and its further coefficients are 0. Disjoint discs are sought: what is not
/// known to be apart becomes one group. `None` if the coefficients are not finite.
///
/// N values cost at most N² expansions, and N if they are well apart.
pub(super) fn error_bounds<T: AsRef<[Ball]>>(
    values: &[Complex<f64>],
    taylor: impl Fn(Complex<f64>) -> T,
) -> Option<Bounds> {
    let group = |members: Vec<usize>| {
        let sum: Complex<f64> = members.iter().map(|&index| values[index]).sum();
        let centre = sum / members.len() as f64;
        let about = taylor(centre);
        let about = about.as_ref();
        Group {
            radius: pellet_radius(about, members.len()),
            is_root: about.first().is_none_or(|own| own.smallest() == 0.0),
            members,
            centre,
        }
    };
    let mut groups: Vec<Group> = Vec::with_capacity(values.len());
    for (index, value) in values.iter().enumerate() {
        // The polynomial is real: the disc of a conjugate is as large.
        let known = groups.iter().find(|known| known.centre == value.conj());
        groups.push(match known {
            Some(known) => Group {
                members: vec![index],
                centre: *value,
                ..*known
            },
            None => group(vec![index]),
        });
    }
    let are_roots = groups.iter().all(|own| own.is_root);
    // Each round leaves one group less.
    for _ in 0..values.len() {
        let Some((first, second)) = not_apart(&groups) else {
            break;
        };
        let joined = groups.swap_remove(second).members;
        let members = [std::mem::take(&mut groups[first].members), joined].concat();
        groups[first] = group(members);
    }
    let mut errors = vec![f64::INFINITY; values.len()];
    for group in &groups {
        for &index in &group.members {
            let distance = (values[index] - group.centre).norm();
            errors[index] = (distance + group.radius?) * (1.0 + 8.0 * f64::EPSILON);
        }
    }
    Some(Bounds { errors, are_roots })
}

/// Two groups whose discs are not known to be disjoint, the first before the second; for a group
/// without a disc, the nearest one.
fn not_apart(groups: &[Group]) -> Option<(usize, usize)> {
    let pairs =
        || (1..groups.len()).flat_map(|second| (0..second).map(move |first| (first, second)));
    let distance = |&(a, b): &(usize, usize)| (groups[a].centre - groups[b].centre).norm();
    let overlap = |&(a, b): &(usize, usize)| match (groups[a].radius, groups[b].radius) {
        (Some(one), Some(other)) => distance(&(a, b)) <= (one + other) * (1.0 + 8.0 * f64::EPSILON),
        _ => true,
    };
    let nearest =
        |one: &(usize, usize), other: &(usize, usize)| distance(one).total_cmp(&distance(other));
    pairs().filter(overlap).min_by(nearest)
}

/// A radius R about the point of expansion within which there are exactly `count` roots; nearly
/// the smallest that Pellet's theorem gives.
fn pellet_radius(taylor: &[Ball], count: usize) -> Option<f64> {
    let largest: Vec<f64> = taylor.iter().map(|own| own.largest()).collect();
    let dominant = taylor.get(count)?.smallest();
    if dominant <= 0.0 || !largest.iter().all(|size| size.is_finite()) {
        return None;
    }
    // Σ |q_j| R^j − |q_k| R^k < 0 by Horner's rule, with a margin far above its rounding.
    let mut terms = largest.clone();
    terms[count] = -dominant * (1.0 - 1e-12);
    let holds = |radius: f64| terms.iter().rev().fold(0.0, |sum, own| sum * radius + own) < 0.0;
    // No smaller radius can do: each lower term alone is as large.
    let alone = |power: usize| (largest[power] / dominant).powf(1.0 / (count - power) as f64);
    let least = (0..count).map(alone).fold(1e-30, f64::max);
    let mut radius = least * (1.0 + 1e-9);
    for _ in 0..STEPS {
        if holds(radius) {
            return Some(radius);
        }
        radius *= STEP;
    }
    None
}

/// How the radius grows while it is sought; the last is 1e6 times the least.
const STEP: f64 = 1.15;
const STEPS: usize = 100;

#[cfg(test)]
mod tests {
    use super::*;

    /// The Taylor coefficients of Π (z − root) about a point, and a bound of their rounding.
    fn expanded(roots: &[Complex<f64>], point: Complex<f64>) -> [Ball; 7] {
        let mut product = [Ball::ZERO; 7];
        product[0] = Ball::ONE;
        for &root in roots {
            let constant = Ball::exact(point) + -Ball::exact(root);
            for power in (0..7).rev() {
                let below = if power > 0 {
                    product[power - 1]
                } else {
                    Ball::ZERO
                };
                product[power] = product[power] * constant + below;
            }
        }
        product
    }

    fn bounds(values: &[(f64, f64)], roots: &[(f64, f64)]) -> Vec<f64> {
        let complex = |list: &[(f64, f64)]| -> Vec<Complex<f64>> {
            list.iter().map(|&(re, im)| Complex::new(re, im)).collect()
        };
        let roots = complex(roots);
        error_bounds(&complex(values), |point| expanded(&roots, point))
            .expect("bounds")
            .errors
    }

    #[test]
    fn bounds_are_as_large_as_the_errors_and_not_much_larger() {
        for (values, roots, errors) in [
            (
                vec![(1.001, 0.0), (3.0, 1.0)],
                vec![(1.0, 0.0), (3.0, 1.0)],
                vec![1e-3, 1e-15],
            ),
            // A double root, approximated as defective ones are.
            (
                vec![(1.0, 1e-8), (1.0, -1e-8)],
                vec![(1.0, 0.0), (1.0, 0.0)],
                vec![1e-8, 1e-8],
            ),
            // Both approximations are at one of two roots.
            (
                vec![(1.0, 0.0), (1.0, 0.0)],
                vec![(1.0, 0.0), (1.5, 0.0)],
                vec![0.5, 0.5],
            ),
            (vec![(0.0, 2.0); 3], vec![(0.0, 2.0); 3], vec![1e-15; 3]),
        ] {
            for (bound, error) in bounds(&values, &roots).into_iter().zip(errors) {
                assert!(
                    bound >= 0.9 * error || error < 1e-14,
                    "{bound} for {error} at {values:?}"
                );
                assert!(bound <= 8.0 * error, "{bound} for {error} at {values:?}");
            }
        }
    }

    #[test]
    fn what_is_not_finite_has_no_bound() {
        let taylor = |_| [Ball::real(f64::NAN, 0.0); 7];
        assert_eq!(error_bounds(&[Complex::new(0.0, 0.0)], taylor), None);
    }
}
