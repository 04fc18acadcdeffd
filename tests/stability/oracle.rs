//! Eigenvalues in exact and long arithmetic: the characteristic polynomial over the rationals, its
//! roots by Aberth's iteration with 600 binary digits. Shares nothing with the code under test.

use dashu_base::{Abs, BitTest};
use dashu_int::IBig;
use dashu_ratio::RBig;
use sextic::stability::forces::Forces;
use sextic::stability::section::Parameters;

/// Binary digits behind the point.
const DIGITS: usize = 600;

fn exact(value: f64) -> RBig {
    RBig::try_from(value).expect("a finite double is rational")
}

/// Coefficients of a polynomial, that of the power 0 first.
type Coefficients = Vec<RBig>;

fn product(a: &[RBig], b: &[RBig]) -> Coefficients {
    let mut sum = vec![RBig::ZERO; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            sum[i + j] += x * y;
        }
    }
    sum
}

/// The determinant as the sum over all permutations.
fn determinant(matrix: &[Vec<Coefficients>]) -> Coefficients {
    let n = matrix.len();
    let mut sum = vec![RBig::ZERO; 2 * n + 1];
    for (permutation, is_even) in permutations(n) {
        let start = vec![if is_even { RBig::ONE } else { -RBig::ONE }];
        let term = (0..n).fold(start, |term, i| product(&term, &matrix[i][permutation[i]]));
        for (power, coefficient) in term.into_iter().enumerate() {
            sum[power] += coefficient;
        }
    }
    sum
}

/// All permutations of 0..n, and whether they are even.
pub fn permutations(n: usize) -> Vec<(Vec<usize>, bool)> {
    if n == 0 {
        return vec![(Vec::new(), true)];
    }
    let mut all = Vec::new();
    for (shorter, is_even) in permutations(n - 1) {
        for place in 0..n {
            let mut longer = shorter.clone();
            longer.insert(place, n - 1);
            all.push((longer, is_even == ((n - 1 - place).is_multiple_of(2))));
        }
    }
    all
}

/// |λ²M + λ(C_s + C_a) + K + K_a| of the free coordinates, Eqs. (9), (17) and (18), over m and with rθ for θ;
/// sines and cosines count as the doubles to which they are rounded.
pub fn characteristic_polynomial(p: &Parameters) -> Coefficients {
    let [m, r, rho, d, u] = [
        p.mass,
        p.radius_of_gyration,
        p.air_density,
        p.reference_dimension,
        p.wind_speed,
    ]
    .map(exact);
    let e = exact(p.mass_centre_distance) / &r;
    let phi = p.mass_centre_angle + p.attitude;
    let (s_g, c_g) = (&e * exact(phi.sin()), &e * exact(phi.cos()));
    let (s, c) = (exact(p.wind_angle.sin()), exact(p.wind_angle.cos()));
    let beta = p.aerodynamic_centre_angle + p.attitude;
    let (s_b, c_b) = (exact(beta.sin()), exact(beta.cos()));
    // A moves with the body; the angle of the wind to it is what Eq. (18) calls αθγ.
    let (s_a, c_a) = (&s * &c_b + &c * &s_b, &c * &c_b - &s * &s_b);
    let epsilon = exact(p.aerodynamic_centre_distance) / &r;
    let kappa = &d / &r;
    let (f, matrix) = match p.forces {
        Forces::Coefficients(f) => (f, None),
        Forces::ScaledDamping(matrix) => (Default::default(), Some(matrix)),
    };
    let [cd, cl, cm, dd, dl, dm] = [
        f.drag,
        f.lift,
        f.moment,
        f.drag_slope,
        f.lift_slope,
        f.moment_slope,
    ]
    .map(exact);
    let two = RBig::from(2);
    // Forces along the wind and across it by velocities along and across, then turned to x and y.
    let (along, across) = ([&two * &cd, &dd - &cl], [&two * &cl, &dl + &cd]);
    let moment = [&two * &kappa * &cm, &kappa * &dm];
    // Velocity of A along and across the wind, by the rates of x, y and rθ.
    let velocity = [
        [c.clone(), -&s],
        [s.clone(), c.clone()],
        [&epsilon * &s_a, &epsilon * &c_a],
    ];
    let damping = |i: usize, j: usize| -> RBig {
        if let Some(matrix) = matrix {
            return exact(matrix[i][j]);
        }
        let [v, w] = &velocity[j];
        let (drag, lift) = (
            &along[0] * v + &along[1] * w,
            &across[0] * v + &across[1] * w,
        );
        match i {
            0 => &c * drag - &s * lift,
            1 => &s * drag + &c * lift,
            _ => &moment[0] * v + &moment[1] * w,
        }
    };
    let delta = rho * d * &u / (two.clone() * m);
    // What the turn alone does: the forces by the angle of attack, turned to x and y.
    let turning = |i: usize| -> RBig {
        let slope = match i {
            0 => &c * &dd - &s * &dl,
            1 => &s * &dd + &c * &dl,
            _ => &kappa * &dm,
        };
        -(&delta * &u / &r * slope)
    };
    let free: Vec<usize> = p.free.as_slice().iter().map(|free| free.index()).collect();
    let entry = |i: usize, j: usize| -> Coefficients {
        let omega = exact(p.natural_frequencies[i]);
        let mass = match (i.min(j), i.max(j)) {
            (0, 2) => s_g.clone(),
            (1, 2) => c_g.clone(),
            _ if i == j => RBig::ONE,
            _ => RBig::ZERO,
        };
        let mut rate = &delta * damping(i, j);
        let mut stiffness = RBig::ZERO;
        if i == j {
            rate += &two * exact(p.damping_ratios[i]) * &omega;
            stiffness = &omega * &omega;
        }
        if p.aerodynamic_stiffness && j == 2 {
            stiffness += turning(i);
        }
        vec![stiffness, rate, mass]
    };
    let matrix: Vec<Vec<Coefficients>> = free
        .iter()
        .map(|&i| free.iter().map(|&j| entry(i, j)).collect())
        .collect();
    determinant(&matrix)
}

/// A complex number with a fixed number of digits behind the point.
#[derive(Clone, Debug)]
pub struct Long {
    re: IBig,
    im: IBig,
}

impl Long {
    fn rational(value: &RBig) -> Self {
        let scaled = (value.numerator() << DIGITS) / IBig::from(value.denominator().clone());
        Long {
            re: scaled,
            im: IBig::ZERO,
        }
    }

    fn new(re: f64, im: f64) -> Self {
        Long {
            re: Long::rational(&exact(re)).re,
            im: Long::rational(&exact(im)).re,
        }
    }

    fn plus(&self, other: &Long) -> Long {
        Long {
            re: &self.re + &other.re,
            im: &self.im + &other.im,
        }
    }

    fn minus(&self, other: &Long) -> Long {
        Long {
            re: &self.re - &other.re,
            im: &self.im - &other.im,
        }
    }

    fn times(&self, other: &Long) -> Long {
        Long {
            re: (&self.re * &other.re - &self.im * &other.im) >> DIGITS,
            im: (&self.re * &other.im + &self.im * &other.re) >> DIGITS,
        }
    }

    fn over(&self, other: &Long) -> Option<Long> {
        let size = &other.re * &other.re + &other.im * &other.im;
        (size != IBig::ZERO).then(|| Long {
            re: ((&self.re * &other.re + &self.im * &other.im) << DIGITS) / &size,
            im: ((&self.im * &other.re - &self.re * &other.im) << DIGITS) / &size,
        })
    }

    /// log₂ of the larger part; very negative for 0.
    fn magnitude(&self) -> isize {
        let bits = self
            .re
            .clone()
            .abs()
            .bit_len()
            .max(self.im.clone().abs().bit_len());
        bits as isize - DIGITS as isize
    }

    /// The real part, as a double.
    pub fn real(&self) -> f64 {
        let unit = RBig::from(IBig::ONE << DIGITS);
        (RBig::from(self.re.clone()) / unit).to_f64().value()
    }

    /// The distance from a number in doubles, to all digits of a double.
    pub fn distance(&self, re: f64, im: f64) -> f64 {
        let apart = self.minus(&Long::new(re, im));
        let size = &apart.re * &apart.re + &apart.im * &apart.im;
        double(&size, 2 * DIGITS as i32).sqrt()
    }

    /// The distance of the real part from a number in doubles.
    pub fn real_distance(&self, re: f64) -> f64 {
        double(&(&self.re - Long::new(re, 0.0).re), DIGITS as i32).abs()
    }

    /// The real part, to all digits of a double.
    pub fn real_part(&self) -> f64 {
        double(&self.re, DIGITS as i32)
    }

    /// The imaginary part, to all digits of a double.
    pub fn imaginary_part(&self) -> f64 {
        double(&self.im, DIGITS as i32)
    }
}

/// A whole number over a power of two.
fn double(number: &IBig, power: i32) -> f64 {
    // A double takes the leading digits of any number, but no more than 1023 of them.
    let bits = number.clone().abs().bit_len() as i32;
    let shift = (bits - 200).max(0);
    let leading = (number >> shift as usize).to_f64().value();
    // In two steps, neither of which underflows.
    let scale = |digits: i32| f64::from(digits).exp2();
    let half = (shift - power) / 2;
    leading * scale(half) * scale(shift - power - half)
}

/// All roots of a polynomial, multiple ones as often, to 90 binary digits.
pub fn roots(polynomial: &[RBig]) -> Vec<Long> {
    let degree = polynomial.len() - 1;
    let monic = monic(polynomial);
    // Within the bound of Fujiwara, at angles that no symmetry shares.
    let bound = (0..degree)
        .map(|power| monic[power].magnitude() as f64 / (degree - power) as f64)
        .fold(f64::NEG_INFINITY, f64::max)
        .exp2();
    let start = |k: usize| {
        let angle = 0.4 + std::f64::consts::TAU * k as f64 / degree as f64;
        (bound * angle.cos(), bound * angle.sin())
    };
    let start: Vec<(f64, f64)> = (0..degree).map(start).collect();
    roots_near(polynomial, &start).expect("the oracle converges")
}

/// All roots of a polynomial, sought from as many points; `None` if that takes too many steps.
pub fn roots_near(polynomial: &[RBig], start: &[(f64, f64)]) -> Option<Vec<Long>> {
    let degree = polynomial.len() - 1;
    assert_eq!(start.len(), degree);
    let monic = monic(polynomial);
    let slope: Vec<Long> = (1..=degree)
        .map(|power| monic[power].times(&Long::new(power as f64, 0.0)))
        .collect();
    let value = |terms: &[Long], at: &Long| {
        let zero = Long::new(0.0, 0.0);
        terms
            .iter()
            .rev()
            .fold(zero, |sum, term| sum.times(at).plus(term))
    };
    let mut roots: Vec<Long> = start.iter().map(|&(re, im)| Long::new(re, im)).collect();
    for _ in 0..1500 {
        let mut largest = isize::MIN;
        for i in 0..degree {
            // Aberth: Newton's step p/p′ with the other roots divided out.
            let p = value(&monic, &roots[i]);
            let Some(newton) = p.over(&value(&slope, &roots[i])) else {
                continue;
            };
            let mut others = Long::new(0.0, 0.0);
            for j in (0..degree).filter(|&j| j != i) {
                if let Some(one) = Long::new(1.0, 0.0).over(&roots[i].minus(&roots[j])) {
                    others = others.plus(&one);
                }
            }
            let below = Long::new(1.0, 0.0).minus(&newton.times(&others));
            let Some(step) = newton.over(&below) else {
                continue;
            };
            roots[i] = roots[i].minus(&step);
            largest = largest.max(step.magnitude());
        }
        if largest < -90 {
            return Some(roots);
        }
    }
    None
}

fn monic(polynomial: &[RBig]) -> Vec<Long> {
    let leading = &polynomial[polynomial.len() - 1];
    let over_leading = |own: &RBig| Long::rational(&(own / leading));
    polynomial.iter().map(over_leading).collect()
}
