//! Truncated power series in ε over the rationals and i: numbers that know their derivatives.

use sextic::algebra::number::Rational;

/// How many coefficients are kept.
pub const LENGTH: usize = 4;

/// a + b·i
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Complex(pub Rational, pub Rational);

impl Complex {
    pub fn real(value: Rational) -> Self {
        Complex(value, Rational::ZERO)
    }

    pub fn is_zero(&self) -> bool {
        self.0.is_zero() && self.1.is_zero()
    }

    pub fn plus(&self, other: &Self) -> Self {
        Complex(&self.0 + &other.0, &self.1 + &other.1)
    }

    pub fn times(&self, other: &Self) -> Self {
        Complex(
            &self.0 * &other.0 - &self.1 * &other.1,
            &self.0 * &other.1 + &self.1 * &other.0,
        )
    }

    fn inverse(&self) -> Option<Self> {
        let norm = &self.0 * &self.0 + &self.1 * &self.1;
        (!norm.is_zero()).then(|| Complex(&self.0 / &norm, -&self.1 / &norm))
    }
}

/// Σ_k a_k εᵏ up to ε to the power `LENGTH` − 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Series(pub Vec<Complex>);

impl Series {
    pub fn new(coefficients: impl IntoIterator<Item = Complex>) -> Self {
        let zeros = std::iter::repeat(Complex::real(Rational::ZERO));
        Series(coefficients.into_iter().chain(zeros).take(LENGTH).collect())
    }

    pub fn number(value: impl Into<Rational>) -> Self {
        Series::new([Complex::real(value.into())])
    }

    pub fn i() -> Self {
        Series::new([Complex(Rational::ZERO, Rational::ONE)])
    }

    pub fn rationals(coefficients: &[Rational]) -> Self {
        Series::new(coefficients.iter().cloned().map(Complex::real))
    }

    pub fn start(&self) -> &Complex {
        &self.0[0]
    }

    pub fn plus(&self, other: &Self) -> Self {
        Series::new(self.0.iter().zip(&other.0).map(|(a, b)| a.plus(b)))
    }

    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.times(&Series::number(-1)))
    }

    pub fn times(&self, other: &Self) -> Self {
        Series::new((0..LENGTH).map(|degree| {
            let pairs = (0..=degree).map(|k| self.0[k].times(&other.0[degree - k]));
            pairs.fold(Complex::real(Rational::ZERO), |sum, term| sum.plus(&term))
        }))
    }

    pub fn power(&self, exponent: u32) -> Self {
        (0..exponent).fold(Series::number(1), |product, _| product.times(self))
    }

    /// 1/a by a⁻¹ = Σ_k (1 − a/a₀)ᵏ/a₀; nothing where a₀ = 0.
    pub fn inverse(&self) -> Option<Self> {
        let inverse = Series::new([self.start().inverse()?]);
        let rest = Series::number(1).minus(&self.times(&inverse));
        Some(rest.geometric().times(&inverse))
    }

    fn geometric(&self) -> Self {
        (0..LENGTH as u32).fold(Series::number(0), |sum, k| sum.plus(&self.power(k)))
    }

    /// a without a₀.
    pub fn without_start(&self) -> Self {
        self.minus(&Series::new([self.start().clone()]))
    }

    /// (cos(B + δ), sin(B + δ)) of the series B + δ where cos B and sin B are given and δ begins with ε.
    pub fn turned(&self, (cosine, sine): &(Rational, Rational)) -> (Self, Self) {
        let (mut cos_d, mut sin_d) = (Series::number(0), Series::number(0));
        let mut term = Series::number(1);
        for k in 0..LENGTH {
            let signed = term.times(&Series::number(if k % 4 < 2 { 1 } else { -1 }));
            if k % 2 == 0 {
                cos_d = cos_d.plus(&signed)
            } else {
                sin_d = sin_d.plus(&signed)
            }
            let next = Rational::ONE / Rational::from(k as u32 + 1);
            term = term
                .times(&self.without_start())
                .times(&Series::number(next));
        }
        let (cosine, sine) = (Series::number(cosine.clone()), Series::number(sine.clone()));
        (
            cosine.times(&cos_d).minus(&sine.times(&sin_d)),
            sine.times(&cos_d).plus(&cosine.times(&sin_d)),
        )
    }

    /// √a ≥ 0 by Newton's iteration from √a₀; nothing where a₀ is no square of a rational above 0.
    pub fn square_root(&self) -> Option<Self> {
        let start = rational_square_root(&self.start().0).filter(|root| !root.is_zero())?;
        let half = Series::number(Rational::ONE / Rational::from(2));
        let mut root = Series::number(start);
        for _ in 0..LENGTH {
            root = root.plus(&self.times(&root.inverse()?)).times(&half);
        }
        Some(root)
    }

    /// da/dε, whose last coefficient is lost.
    pub fn derivative(&self) -> Self {
        Series::new((1..LENGTH).map(|k| self.0[k].times(&Complex::real(Rational::from(k as u32)))))
    }

    /// ∫a dε from 0.
    pub fn integral(&self) -> Self {
        let shifted = (1..LENGTH)
            .map(|k| self.0[k - 1].times(&Complex::real(Rational::ONE / Rational::from(k as u32))));
        Series::new(std::iter::once(Complex::real(Rational::ZERO)).chain(shifted))
    }
}

fn rational_square_root(value: &Rational) -> Option<Rational> {
    // Small enough to be looked for: the points are.
    let root = |n: &sextic::algebra::number::Integer| {
        let mut root = 0_u64;
        let square = |r: u64| sextic::algebra::number::Integer::from(u128::from(r) * u128::from(r));
        for bit in (0..40).rev() {
            if square(root | 1 << bit) <= *n {
                root |= 1 << bit;
            }
        }
        (square(root) == *n).then(|| Rational::from(root))
    };
    let denominator = value.denominator().clone().into();
    Some(root(value.numerator())? / root(&denominator)?)
}
