//! Eq. (18), the scaled damping matrix, over any numbers: exact sums of sines, and balls.

use crate::algebra::arithmetic::Arithmetic;

use super::section::Coefficients;

/// What S_a is made of.
pub(super) struct Ingredients<T> {
    /// C_D, C_L, C_M and their slopes.
    pub coefficients: Coefficients<T>,
    /// κ = D/r.
    pub kappa: T,
    /// cos and sin of the angle α_0 of the wind.
    pub wind: [T; 2],
    /// L_a/r cos and L_a/r sin of the angle α_0 + θ_0 + γ_r of A from the wind.
    pub centre: [T; 2],
}

/// S_a for the coordinates x, y and rθ, as the product of its two factors.
///
/// # Errors
///
/// Those of the arithmetic.
pub(super) fn scaled_damping<A: Arithmetic>(
    of: &Ingredients<A::Element>,
    arithmetic: &A,
) -> Result<[[A::Element; 3]; 3], A::Error> {
    let (forces, winds) = (force_factor(of, arithmetic)?, wind_factor(of, arithmetic)?);
    let mut product = [(); 3].map(|()| [(); 3].map(|()| arithmetic.zero()));
    for (row, forces) in product.iter_mut().zip(&forces) {
        for (factor, winds) in forces.iter().zip(&winds) {
            let Some(factor) = factor else { continue };
            for (sum, wind) in row.iter_mut().zip(winds) {
                *sum = arithmetic.sum(sum, &arithmetic.product(factor, wind)?)?;
            }
        }
    }
    Ok(product)
}

/// A row of the left factor; nothing where it is 0.
type Forces<T> = [Option<T>; 6];

/// The left factor.
fn force_factor<A: Arithmetic>(
    of: &Ingredients<A::Element>,
    arithmetic: &A,
) -> Result<[Forces<A::Element>; 3], A::Error> {
    let c = &of.coefficients;
    let twice = |own: &A::Element| arithmetic.sum(own, own);
    let minus = |own: &A::Element| arithmetic.negative(own);
    let (drag, lift, moment) = (twice(&c.drag)?, twice(&c.lift)?, twice(&c.moment)?);
    let normal = arithmetic.sum(&c.lift_slope, &c.drag)?;
    let along = arithmetic.difference(&c.lift, &c.drag_slope)?;
    let turning = |own: &A::Element| arithmetic.product(&of.kappa, own);
    let (still, moving) = (turning(&moment)?, turning(&c.moment_slope)?);
    let across = [minus(&drag), minus(&normal)];
    let [less_drag, less_normal] = across;
    Ok([
        [
            Some(drag),
            Some(lift.clone()),
            Some(normal),
            Some(along.clone()),
            None,
            None,
        ],
        [
            Some(lift),
            Some(less_drag),
            Some(along),
            Some(less_normal),
            None,
            None,
        ],
        [None, None, None, None, Some(still), Some(moving)],
    ])
}

/// The right factor.
fn wind_factor<A: Arithmetic>(
    of: &Ingredients<A::Element>,
    arithmetic: &A,
) -> Result<[[A::Element; 3]; 6], A::Error> {
    let ([c, s], [cosine, sine]) = (&of.wind, &of.centre);
    let minus = |own: &A::Element| arithmetic.negative(own);
    let times = |one: &A::Element, other: &A::Element| arithmetic.product(one, other);
    let (cc, cs, ss) = (times(c, c)?, times(c, s)?, times(s, s)?);
    Ok([
        [cc.clone(), cs.clone(), times(sine, c)?],
        [minus(&cs), minus(&ss), minus(&times(sine, s)?)],
        [ss, minus(&cs), minus(&times(cosine, s)?)],
        [cs, minus(&cc), minus(&times(cosine, c)?)],
        [c.clone(), s.clone(), sine.clone()],
        [minus(s), c.clone(), cosine.clone()],
    ])
}
