//! Functions of a parameter near a number, to second order with a bound of the rest.

use sextic_codegen::arithmetic::Arithmetic;

use crate::algebra::number::Rational;

use super::arithmetic::{NoValue, nearest};
use super::real::Real;

/// f(x) = f₀ + f₁ δ + f₂(δ) δ² for all |δ| ≤ h, where δ = x − x₀ and h belongs to the [`Jets`].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Jet {
    /// f₀
    pub value: Real,
    /// f₁
    pub slope: Real,
    /// All values of f₂.
    pub rest: Real,
}

impl Jet {
    pub const fn constant(value: Real) -> Self {
        Jet {
            value,
            slope: Real::ZERO,
            rest: Real::ZERO,
        }
    }

    /// The parameter itself.
    pub const fn parameter(value: Real) -> Self {
        Jet {
            value,
            slope: Real::ONE,
            rest: Real::ZERO,
        }
    }

    /// cos and sin of k x + b, by those at x₀: second derivatives are at most k².
    pub fn circular(count: i32, [cosine, sine]: [Real; 2]) -> [Self; 2] {
        let k = Real::exact(f64::from(count));
        let rest = Real::new(0.0, (k * k).largest() / 2.0);
        [(cosine, -k * sine), (sine, k * cosine)].map(|(value, slope)| Jet {
            value,
            slope,
            rest: if count == 0 { Real::ZERO } else { rest },
        })
    }

    /// Whether it is 0 for every δ, as far as it is known.
    pub fn is_zero(&self) -> bool {
        self.value.is_zero() && self.slope.is_zero() && self.rest.is_zero()
    }

    /// Its product with a power of 2.
    pub fn scaled(&self, power: f64) -> Self {
        Jet {
            value: self.value.scaled(power),
            slope: self.slope.scaled(power),
            rest: self.rest.scaled(power),
        }
    }

    pub fn sum(&self, other: &Jet) -> Jet {
        Jet {
            value: self.value + other.value,
            slope: self.slope + other.slope,
            rest: self.rest + other.rest,
        }
    }

    fn negative(&self) -> Jet {
        Jet {
            value: -self.value,
            slope: -self.slope,
            rest: -self.rest,
        }
    }
}

/// The arithmetic of [`Jet`]s for |δ| ≤ h.
pub(super) struct Jets {
    /// Between −h and h.
    pub step: Real,
}

impl Jets {
    /// For |δ| ≤ h.
    pub fn new(h: f64) -> Self {
        Jets {
            step: Real::new(0.0, h),
        }
    }

    /// All values.
    pub fn range(&self, own: &Jet) -> Real {
        own.value + self.step * (own.slope + self.step * own.rest)
    }
}

impl Arithmetic for Jets {
    type Value = Jet;
    type Error = NoValue;

    fn constant(&mut self, value: &Rational) -> Result<Jet, NoValue> {
        Ok(Jet::constant(nearest(value)))
    }

    fn negative(&mut self, a: &Jet) -> Result<Jet, NoValue> {
        Ok(a.negative())
    }

    fn sum(&mut self, a: &Jet, b: &Jet) -> Result<Jet, NoValue> {
        Ok(a.sum(b))
    }

    fn difference(&mut self, a: &Jet, b: &Jet) -> Result<Jet, NoValue> {
        Ok(a.sum(&b.negative()))
    }

    /// a₀b₀ + (a₀b₁ + a₁b₀) δ + (a₀b₂ + a₁b₁ + a₂b₀ + δ (a₁b₂ + a₂b₁) + δ² a₂b₂) δ²
    fn product(&mut self, a: &Jet, b: &Jet) -> Result<Jet, NoValue> {
        let own = a.value * b.rest + a.slope * b.slope + a.rest * b.value;
        let higher = a.slope * b.rest + a.rest * b.slope + self.step * a.rest * b.rest;
        Ok(Jet {
            value: a.value * b.value,
            slope: a.value * b.slope + a.slope * b.value,
            rest: own + self.step * higher,
        })
    }

    /// q₀ = a₀/b₀, q₁ = (a₁ − q₀b₁)/b₀, q₂ = (a₂ − q₀b₂ − q₁b₁ − δ q₁b₂)/b
    fn quotient(&mut self, a: &Jet, b: &Jet) -> Result<Jet, NoValue> {
        let over = |above: Real, below: Real| above.quotient(below).ok_or(NoValue::Division);
        let value = over(a.value, b.value)?;
        let slope = over(a.slope - value * b.slope, b.value)?;
        let rest = a.rest - value * b.rest - slope * b.slope - self.step * slope * b.rest;
        Ok(Jet {
            value,
            slope,
            rest: over(rest, self.range(b))?,
        })
    }

    /// s₀ = √a₀, s₁ = a₁/(2s₀), s₂ = (a₂ − s₁²)/(s + s₀ + s₁δ)
    fn square_root(&mut self, a: &Jet) -> Result<Jet, NoValue> {
        if a.is_zero() {
            return Ok(*a);
        }
        let root = |own: Real| own.square_root().ok_or(NoValue::Root);
        let over = |above: Real, below: Real| above.quotient(below).ok_or(NoValue::Root);
        let value = root(a.value)?;
        let slope = over(a.slope, value + value)?;
        let below = root(self.range(a))? + value + self.step * slope;
        Ok(Jet {
            value,
            slope,
            rest: over(a.rest - slope * slope, below)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Of √(x + 3) (2 − x)/(x² + 1), and of its sines, at points of a range.
        #[test]
        fn a_jet_holds_the_function_on_its_range(at in -2.0..2.0f64, h in 1e-6..0.3f64, share in -1.0..=1.0f64) {
            let mut jets = Jets::new(h);
            let number = |own: i32| Jet::constant(Real::exact(f64::from(own)));
            let x = Jet::parameter(Real::exact(at));
            let found = (|| {
                let sum = jets.sum(&x, &number(3))?;
                let root = jets.square_root(&sum)?;
                let factor = jets.difference(&number(2), &x)?;
                let above = jets.product(&root, &factor)?;
                let square = jets.product(&x, &x)?;
                let below = jets.sum(&square, &number(1))?;
                jets.quotient(&above, &below)
            })();
            let delta = share * h;
            let function = |x: f64| (x + 3.0).sqrt() * (2.0 - x) / (x * x + 1.0);
            if let Ok(own) = found {
                let near = own.value.centre + own.slope.centre * delta + own.rest.centre * delta * delta;
                let error = own.value.radius + own.slope.radius * h + own.rest.radius * delta * delta + 1e-14;
                prop_assert!((near - function(at + delta)).abs() <= error);
                prop_assert!(own.slope.radius < 1e-12 && own.value.radius < 1e-13);
            } else {
                prop_assert!(h > 0.05, "{found:?}");
            }
            let angle = Real::exact((3.0 * at).cos());
            let [cosine, _] = Jet::circular(3, [angle, Real::exact((3.0 * at).sin())]);
            let near = cosine.value.centre + cosine.slope.centre * delta;
            prop_assert!((near - (3.0 * (at + delta)).cos()).abs() <= cosine.rest.radius * delta * delta + 1e-14);
        }
    }
}
