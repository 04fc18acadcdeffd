//! What the symbols of a ring stand for.

use super::angle::Angle;
use super::fraction::Fraction;
use super::polynomial::Polynomial;

/// What one symbol of a [`Ring`](super::ring::Ring) stands for.
///
/// The first three are free; the others are tied to earlier symbols by a relation, and every
/// differential and every substitution of the free ones carries over to them by the rule given here.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Generator {
    /// A constant.
    Constant {
        /// How it is called.
        name: String,
    },
    /// An angle that does not change with time.
    Angle {
        /// How it is called.
        name: String,
    },
    /// A function of time, or its time derivative of some order.
    Coordinate {
        /// How the function itself is called.
        name: String,
        /// How often it is differentiated.
        order: u32,
        /// Whether it is an angle, so that its sine may be taken.
        angular: bool,
    },
    /// i, with i² = −1.
    ImaginaryUnit,
    /// cos A, with dcos A = −sin A dA.
    Cosine {
        /// A
        angle: Angle,
    },
    /// sin A, with sin²A = 1 − cos²A and dsin A = cos A dA.
    Sine {
        /// A
        angle: Angle,
    },
    /// w ≥ 0 with w² = p and dw = dp/(2w).
    Root {
        /// p
        radicand: Polynomial,
    },
    /// The angle β of the vector (x, y), with cos β = x/w, sin β = y/w, w² = x² + y² and
    /// dβ = (x dy − y dx)/w².
    Direction {
        /// x
        x: Box<Fraction>,
        /// y
        y: Box<Fraction>,
        /// w
        length: Box<Fraction>,
    },
    /// f⁽ᵏ⁾(A) of a function known only through its derivatives, with df⁽ᵏ⁾(A) = f⁽ᵏ⁺¹⁾(A) dA.
    FunctionValue {
        /// How f is called.
        name: String,
        /// k
        order: u32,
        /// A
        argument: Fraction,
    },
}

impl Generator {
    /// How a parameter, an angle, a coordinate or a function is called.
    pub fn name(&self) -> Option<&str> {
        match self {
            Generator::Constant { name }
            | Generator::Angle { name }
            | Generator::Coordinate { name, .. }
            | Generator::FunctionValue { name, .. } => Some(name),
            _ => None,
        }
    }

    /// Whether sines and cosines of the symbol may be taken.
    pub fn is_angular(&self) -> bool {
        match self {
            Generator::Angle { .. } | Generator::Direction { .. } => true,
            Generator::Coordinate { order, angular, .. } => *order == 0 && *angular,
            _ => false,
        }
    }

    /// Whether the symbol is a root or i, which no denominator contains.
    pub fn is_irrational(&self) -> bool {
        matches!(self, Generator::Root { .. } | Generator::ImaginaryUnit)
    }

    /// Whether the symbol is bound to others by a quadratic relation, so that it appears at most
    /// linearly in a normal form.
    pub fn is_quadratic(&self) -> bool {
        matches!(
            self,
            Generator::ImaginaryUnit | Generator::Sine { .. } | Generator::Root { .. }
        )
    }
}
