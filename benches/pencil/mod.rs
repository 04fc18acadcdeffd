//! Matrices λ²M + λC + K to expand the determinants of.

use sextic::algebra::angle::Angle;
use sextic::algebra::arithmetic::Arithmetic;
use sextic::algebra::budget::Budget;
use sextic::algebra::determinant::determinant;
use sextic::algebra::fraction::Fraction;
use sextic::algebra::generator::Generator;
use sextic::algebra::matrix::Matrix;
use sextic::algebra::number::{Integer, Rational};
use sextic::algebra::ring::Ring;
use sextic::algebra::univariate::Univariate;

/// λ²M + λC + K over a ring.
pub struct Pencil {
    ring: Ring,
    /// Entry by entry, the coefficients of 1, λ and λ².
    matrix: Matrix<Vec<Fraction>>,
}

/// Whether sin² + cos² = 1 is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Circle {
    /// Sines and cosines are symbols like others.
    Free,
    /// Every product is folded by the relation.
    Folded,
}

impl Pencil {
    /// The section of the paper with three degrees of freedom and all 25 parameters symbolic, the sines
    /// and cosines of its three angles among them; M, C and K times 2, so that no fraction is left.
    pub fn section(circle: Circle) -> Self {
        let mut ring = Ring::new(Budget::unlimited());
        if circle == Circle::Folded {
            for name in ["wind", "mass centre", "aerodynamic centre"] {
                let angle = ring.symbol(Generator::Angle { name: name.into() }).unwrap();
                ring.cosine_and_sine(&Angle::new([(angle, Integer::ONE)]))
                    .unwrap();
            }
        }
        let damping = [
            ["2 CD", "2 CL", "dCL + CD", "CL - dCD", "", ""],
            ["2 CL", "- 2 CD", "CL - dCD", "- dCL - CD", "", ""],
            ["", "", "", "", "2 D CM", "D dCM"],
        ];
        let turns = [
            ["c0 c0", "c0 s0", "La sp c0"],
            ["- c0 s0", "- s0 s0", "- La sp s0"],
            ["s0 s0", "- c0 s0", "- La cp s0"],
            ["c0 s0", "- c0 c0", "- La cp c0"],
            ["c0", "s0", "La sp"],
            ["- s0", "c0", "La cp"],
        ];
        let mass = [
            ["2 m", "", "2 m Lg sf"],
            ["", "2 m", "2 m Lg cf"],
            ["2 m Lg sf", "2 m Lg cf", "2 m r r"],
        ];
        let structural = ["4 m ox zx", "4 m oy zy", "4 m r r ot zt"];
        let stiffness = ["2 m ox ox", "2 m oy oy", "2 m r r ot ot"];
        let mut read = |text: &str| read(text, &mut ring);
        let damping = Matrix::from_fn(3, 6, |row, column| read(damping[row][column]));
        let turns = Matrix::from_fn(6, 3, |row, column| read(turns[row][column]));
        let mass = Matrix::from_fn(3, 3, |row, column| read(mass[row][column]));
        let structural = structural.map(&mut read);
        let stiffness = stiffness.map(&mut read);
        let wind = read("rho D U");
        let aerodynamic = damping.product(&turns, &ring).unwrap();
        let matrix = Matrix::from_fn(3, 3, |row, column| {
            let mut damping = ring.product(&wind, aerodynamic.at(row, column)).unwrap();
            let mut rigid = ring.zero();
            if row == column {
                damping = ring.sum(&damping, &structural[row]).unwrap();
                rigid = stiffness[row].clone();
            }
            Univariate(&ring).polynomial(vec![rigid, damping, mass.at(row, column).clone()])
        });
        Pencil { ring, matrix }
    }

    /// A symbol in every entry of M, C and K, which have no symmetry.
    pub fn symbolic(size: usize) -> Self {
        let mut ring = Ring::new(Budget::unlimited());
        let matrix = Matrix::from_fn(size, size, |row, column| {
            let entry = |letter| read(&format!("{letter}{row}{column}"), &mut ring);
            ["k", "c", "m"].map(entry).to_vec()
        });
        Pencil { ring, matrix }
    }

    /// The coefficients of |λ²M + λC + K|, that of λ⁰ first.
    pub fn coefficients(&self) -> Vec<Fraction> {
        determinant(&self.matrix, &Univariate(&self.ring)).unwrap()
    }

    /// The number of terms of the expanded determinant.
    pub fn terms(&self) -> usize {
        self.coefficients()
            .iter()
            .map(|part| part.numerator().len())
            .sum()
    }
}

/// Reads sums of products: `2 m Lg sf - dCD`.
fn read(text: &str, ring: &mut Ring) -> Fraction {
    let (mut sum, mut term, mut negative) = (ring.zero(), None::<Fraction>, false);
    for word in text.split_whitespace().chain(["+"]) {
        let factor = match word.parse::<i64>() {
            _ if word == "+" || word == "-" => {
                let signed = |term: Fraction| if negative { term.negative() } else { term };
                sum = ring
                    .sum(&sum, &term.take().map_or(ring.zero(), signed))
                    .unwrap();
                negative = word == "-";
                continue;
            }
            Ok(number) => Fraction::from(Rational::from(number)),
            Err(_) => named(word, ring),
        };
        term = Some(match term {
            Some(term) => ring.product(&term, &factor).unwrap(),
            None => factor,
        });
    }
    sum
}

/// The cosines and sines of the angles of the ring, or a constant of its own.
fn named(name: &str, ring: &mut Ring) -> Fraction {
    let place = ["c0", "cf", "cp", "s0", "sf", "sp"]
        .iter()
        .position(|known| *known == name);
    if let Some(basis) = place.and_then(|place| ring.basis().get(place % 3).cloned()) {
        return ring.element(if name.starts_with('c') {
            basis.cosine
        } else {
            basis.sine
        });
    }
    let symbol = ring
        .symbol(Generator::Constant { name: name.into() })
        .unwrap();
    ring.element(symbol)
}
