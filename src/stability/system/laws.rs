//! What must hold of any system: its eigenvalues beside exact polynomials, its verdicts beside those by hand.

use std::collections::BTreeMap;

use num_complex::Complex;
use proptest::prelude::*;
use sextic_codegen::evaluator::{Angle, Circular, Evaluator, Function, Origin, Quantity};
use sextic_codegen::program::{Node, Operation, Program};

use crate::algebra::number::Rational;
use crate::stability::eigenvalue::Spectrum;
use crate::stability::verdict::{Doubt, Proof, Verdict};

use super::System;
use super::error::SystemError;

pub(super) fn rational(above: i64, below: i64) -> Rational {
    Rational::from(above) / Rational::from(below)
}

fn exact(value: f64) -> Rational {
    Rational::try_from(value).expect("a finite double is a rational number")
}

/// Values by name, each above/below.
pub(super) fn values(list: &[(&str, i64, i64)]) -> BTreeMap<String, Rational> {
    list.iter()
        .map(|(name, above, below)| (name.to_string(), rational(*above, *below)))
        .collect()
}

/// A program that is written as sums of products: each entry is a list of factors, of which a number is one.
pub(super) struct Writer {
    pub program: Program,
}

impl Writer {
    pub fn new(names: &[&str]) -> Self {
        Writer {
            program: Program::new(names.iter().map(|name| name.to_string())),
        }
    }

    pub fn number(&mut self, above: i64, below: i64) -> Node {
        self.program.constant(rational(above, below))
    }

    pub fn input(&self, name: &str) -> Node {
        self.program.input(name).expect("an input")
    }

    pub fn times(&mut self, a: Node, b: Node) -> Node {
        self.program.push(Operation::Multiply(a, b))
    }

    pub fn plus(&mut self, a: Node, b: Node) -> Node {
        self.program.push(Operation::Add(a, b))
    }

    pub fn minus(&mut self, a: Node, b: Node) -> Node {
        self.program.push(Operation::Subtract(a, b))
    }

    pub fn over(&mut self, a: Node, b: Node) -> Node {
        self.program.push(Operation::Divide(a, b))
    }

    /// The system with M, C and K, row by row.
    pub fn system(mut self, matrices: [&[Node]; 3]) -> System {
        let size = matrices[0].len().isqrt();
        for (matrix, nodes) in ["M", "C", "K"].iter().zip(matrices) {
            for (place, node) in nodes.iter().enumerate() {
                self.program.output(format!("{matrix}_{place}"), *node);
            }
        }
        System {
            evaluator: Evaluator::plain("system", self.program),
            coordinates: (1..=size).map(|place| format!("q_{place}")).collect(),
            damping: vec![String::new()],
            stiffness: vec![String::new()],
        }
    }
}

/// A system of numbers.
pub(super) fn constant(matrices: [&[Rational]; 3]) -> System {
    let mut writer = Writer::new(&[]);
    let nodes = matrices.map(|own| -> Vec<Node> {
        own.iter()
            .map(|entry| writer.program.constant(entry.clone()))
            .collect()
    });
    writer.system([&nodes[0], &nodes[1], &nodes[2]])
}

/// |λ²M + λC + K| in powers of λ by values at 2n + 1 numbers, each by elimination, and Newton's differences: another
/// way than minors of polynomials.
fn polynomial(size: usize, [mass, damping, stiffness]: [&[Rational]; 3]) -> Vec<Rational> {
    let points: Vec<Rational> = (0..=2 * size as i64).map(|own| rational(own, 1)).collect();
    let value = |at: &Rational| {
        let entry = |place: usize| (&mass[place] * at + &damping[place]) * at + &stiffness[place];
        by_elimination(size, (0..size * size).map(entry).collect())
    };
    let mut table: Vec<Rational> = points.iter().map(value).collect();
    for level in 1..points.len() {
        for place in (level..points.len()).rev() {
            table[place] =
                (&table[place] - &table[place - 1]) / (&points[place] - &points[place - level]);
        }
    }
    let mut found: Vec<Rational> = vec![Rational::ZERO; points.len()];
    for (difference, point) in table.iter().zip(&points).rev() {
        // p (x − point) + difference
        let mut next: Vec<Rational> = vec![Rational::ZERO; points.len()];
        for power in 0..points.len() {
            next[power] = &next[power] - &found[power] * point;
            if power + 1 < points.len() {
                next[power + 1] = &next[power + 1] + &found[power];
            }
        }
        next[0] = &next[0] + difference;
        found = next;
    }
    found
}

fn by_elimination(size: usize, mut entries: Vec<Rational>) -> Rational {
    let mut product = Rational::ONE;
    for step in 0..size {
        let Some(pivot) = (step..size).find(|row| !entries[row * size + step].is_zero()) else {
            return Rational::ZERO;
        };
        if pivot != step {
            (0..size).for_each(|column| entries.swap(pivot * size + column, step * size + column));
            product = -product;
        }
        let own = entries[step * size + step].clone();
        product *= &own;
        for row in step + 1..size {
            let factor = &entries[row * size + step] / &own;
            for column in step..size {
                let taken = &factor * &entries[step * size + column];
                entries[row * size + column] = &entries[row * size + column] - taken;
            }
        }
    }
    product
}

/// The absolute values of the coefficients of a polynomial about a complex number, exactly before they are rounded.
fn sizes_about(polynomial: &[Rational], point: Complex<f64>) -> Vec<f64> {
    let (x, y) = (exact(point.re), exact(point.im));
    let mut shifted: Vec<[Rational; 2]> = polynomial
        .iter()
        .map(|own| [own.clone(), Rational::ZERO])
        .collect();
    for lowest in 0..shifted.len() {
        for power in (lowest + 1..shifted.len()).rev() {
            let [a, b] = shifted[power].clone();
            let [c, d] = &shifted[power - 1];
            shifted[power - 1] = [c + (&a * &x - &b * &y), d + (&a * &y + &b * &x)];
        }
    }
    shifted
        .iter()
        .map(|[a, b]| a.to_f64().value().hypot(b.to_f64().value()))
        .collect()
}

/// No root is within a bound for certain: |q₀| > Σ |q_k| Rᵏ.
fn is_refuted(polynomial: &[Rational], point: Complex<f64>, radius: f64) -> bool {
    let sizes = sizes_about(polynomial, point);
    let others = sizes[1..]
        .iter()
        .rev()
        .fold(0.0, |sum, own| (sum + own) * radius);
    sizes[0] > others * (1.0 + 1e-9)
}

fn sum(spectrum: &Spectrum) -> (Complex<f64>, f64) {
    let values = spectrum.eigenvalues.iter();
    values.fold((Complex::ZERO, 0.0), |(sum, error), own| {
        (sum + own.value, error + own.error)
    })
}

/// Entries of a matrix from −1 to 1, in sixteenths.
fn entries() -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec((-16_i64..=16).prop_map(|own| rational(own, 16)), 64)
}

/// A Aᵀ + I, of the first rows and columns.
fn positive(size: usize, entries: &[Rational]) -> Vec<Rational> {
    let at = |row: usize, column: usize| &entries[8 * row + column];
    let entry = |place: usize| {
        let (row, column) = (place / size, place % size);
        let own = if row == column {
            Rational::ONE
        } else {
            Rational::ZERO
        };
        (0..size)
            .map(|k| at(row, k) * at(column, k))
            .fold(own, |sum, own| sum + own)
    };
    (0..size * size).map(entry).collect()
}

fn square(size: usize, entries: &[Rational], factor: i64) -> Vec<Rational> {
    (0..size * size)
        .map(|place| &entries[8 * (place / size) + place % size] * rational(factor, 1))
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// No radius is false, none is much larger than rounding, and the eigenvalues are all there.
    #[test]
    fn eigenvalues_are_those_of_the_exact_polynomial(
        size in 1_usize..=8, a in entries(), c in entries(), k in entries(), stiff in 1_i64..1000,
    ) {
        let matrices = [positive(size, &a), square(size, &c, 1), square(size, &k, stiff)];
        let matrices = matrices.each_ref().map(Vec::as_slice);
        let system = constant(matrices);
        let instance = system.at(&BTreeMap::new()).unwrap();
        let spectrum = instance.spectrum().unwrap();
        let polynomial = polynomial(size, matrices);
        prop_assert_eq!(spectrum.eigenvalues.len(), 2 * size);
        let largest = spectrum.eigenvalues.iter().map(|own| own.value.norm()).fold(0.0, f64::max);
        for own in &spectrum.eigenvalues {
            prop_assert!(!is_refuted(&polynomial, own.value, own.error), "{own:?}");
            // A third of the bound is refuted where it is sharp; it is at least no more than this.
            prop_assert!(own.error <= 1e-7 * largest + 1e-300, "{own:?} of {largest}");
        }
        // Σλ = −tr(M⁻¹C)
        let (total, error) = sum(&spectrum);
        let expected = -(&polynomial[2 * size - 1] / &polynomial[2 * size]).to_f64().value();
        prop_assert!((total - expected).norm() <= error + 1e-12 * largest, "{total} {expected} {error}");
        // The textbook's way agrees within its bounds.
        let companion = instance.companion().unwrap();
        for own in &companion.eigenvalues {
            prop_assert!(!is_refuted(&polynomial, own.value, own.error), "{own:?}");
        }
    }

    /// Without damping, with symmetric matrices, every motion oscillates: all eigenvalues are imaginary.
    #[test]
    fn eigenvalues_without_damping_are_imaginary(size in 1_usize..=8, a in entries(), k in entries()) {
        let zero = vec![Rational::ZERO; size * size];
        let (mass, stiffness) = (positive(size, &a), positive(size, &k));
        let system = constant([&mass, &zero, &stiffness]);
        let instance = system.at(&BTreeMap::new()).unwrap();
        for own in &instance.spectrum().unwrap().eigenvalues {
            prop_assert!(own.value.re.abs() <= own.error && own.value.im != 0.0, "{own:?}");
        }
        prop_assert_eq!(instance.verdict(), Verdict::Undecided(Doubt::Neutral));
        prop_assert_eq!(instance.diverges(), Some(false));
        // With damping that is positive definite every motion dies out (Kelvin).
        let system = constant([&mass, &stiffness, &stiffness]);
        prop_assert_eq!(system.at(&BTreeMap::new()).unwrap().verdict().name(), "stable");
    }

    /// Shapes are null vectors.
    #[test]
    fn shapes_are_null_vectors(size in 1_usize..=8, a in entries(), c in entries(), k in entries()) {
        let matrices = [positive(size, &a), square(size, &c, 1), positive(size, &k)];
        let system = constant(matrices.each_ref().map(Vec::as_slice));
        let instance = system.at(&BTreeMap::new()).unwrap();
        let matrices = instance.matrices();
        let of = |own: &nalgebra::DMatrix<f64>| own.map(|entry| Complex::new(entry, 0.0));
        for mode in instance.modes().unwrap() {
            let Some(shape) = mode.shape else { continue };
            let value = mode.eigenvalue.value;
            let matrix = (of(&matrices.mass) * value + of(&matrices.damping)) * value + of(&matrices.stiffness);
            let rest = (&matrix * nalgebra::DVector::from_vec(shape.clone())).amax_norm();
            let size = (matrices.mass.norm() * value.norm() + matrices.damping.norm()) * value.norm() + matrices.stiffness.norm();
            prop_assert!(rest <= 1e-12 * size, "{rest} {size}");
            let largest = shape.iter().map(|own| own.norm()).fold(0.0, f64::max);
            prop_assert!((largest - 1.0).abs() < 0.5 && shape.contains(&Complex::ONE));
        }
    }
}

trait AmaxNorm {
    fn amax_norm(&self) -> f64;
}

impl AmaxNorm for nalgebra::DVector<Complex<f64>> {
    fn amax_norm(&self) -> f64 {
        self.iter().map(|own| own.norm()).fold(0.0, f64::max)
    }
}

fn numbers(list: &[i64]) -> Vec<Rational> {
    list.iter().map(|own| rational(*own, 1)).collect()
}

/// Identical, defective and far apart eigenvalues, with what the largest bound may be.
#[test]
fn eigenvalues_that_coincide_have_bounds() {
    for (mass, damping, stiffness, most) in [
        // Critical damping: −1 twice, one vector.
        (vec![1], vec![2], vec![1], 1e-7),
        // Three times the same oscillator, uncoupled and rotated.
        (
            vec![1, 0, 0, 0, 1, 0, 0, 0, 1],
            vec![0; 9],
            vec![4, 0, 0, 0, 4, 0, 0, 0, 4],
            1e-13,
        ),
        (
            vec![3, 1, 1, 3],
            vec![3, 1, 1, 3],
            vec![12, 4, 4, 12],
            1e-12,
        ),
        // A chain: the same eigenvalue twice, one vector, but triangular.
        (vec![1, 0, 0, 1], vec![2, 5, 0, 2], vec![9, 1, 0, 9], 1e-13),
        // Nothing holds it: 0 four times.
        (vec![2, 1, 1, 2], vec![0; 4], vec![0; 4], 1e-4),
        // λ⁴ − 2λ² + 1 by gyroscopic coupling: ±1 twice each, defective.
        (
            vec![1, 0, 0, 1],
            vec![0, 2, -2, 0],
            vec![-1, 0, 0, -1],
            1e-4,
        ),
        (
            vec![1, 0, 0, 1],
            vec![1, 0, 0, 1],
            vec![1, 1, 1, 1_000_000_000_000],
            1e-3,
        ),
    ] {
        let [mass, damping, stiffness] = [mass, damping, stiffness].map(|own| numbers(&own));
        let size = mass.len().isqrt();
        let system = constant([&mass, &damping, &stiffness]);
        let spectrum = system.at(&BTreeMap::new()).unwrap().spectrum().unwrap();
        let polynomial = polynomial(size, [&mass, &damping, &stiffness]);
        for own in &spectrum.eigenvalues {
            assert!(!is_refuted(&polynomial, own.value, own.error), "{own:?}");
            assert!(own.error <= most, "{own:?} {damping:?} {stiffness:?}");
        }
    }
}

/// Ziegler's pendulum: two rods of length 1 with masses 2 and 1, springs k, dampers c, a force P that follows the end.
///
/// M = [3, 1; 1, 1], C = c [2, −1; −1, 1], K = [2k − P, P − k; −k, k].
pub(super) fn ziegler() -> System {
    let mut writer = Writer::new(&["k", "c", "P"]);
    let [k, c, force] = ["k", "c", "P"].map(|name| writer.input(name));
    let [one, two, three] = [1, 2, 3].map(|own| writer.number(own, 1));
    let (twice_k, twice_c) = (writer.times(two, k), writer.times(two, c));
    let minus_c = writer.program.push(Operation::Negative(c));
    let minus_k = writer.program.push(Operation::Negative(k));
    let first = writer.minus(twice_k, force);
    let second = writer.minus(force, k);
    writer.system([
        &[three, one, one, one],
        &[twice_c, minus_c, minus_c, c],
        &[first, second, minus_k, k],
    ])
}

#[test]
fn verdicts_by_hand() {
    let neutral = Verdict::Undecided(Doubt::Neutral);
    let unstable = Verdict::Unstable(Proof::Errors);
    let system = ziegler();
    for (k, c, force, expected) in [
        // Without damping up to (7/2 − √2) k, with damping up to 41/28 k + c²/2.
        ((1, 1), (0, 1), (2, 1), neutral),
        ((1, 1), (0, 1), (21, 10), unstable),
        (
            (1, 1),
            (1, 1000),
            (1464, 1000),
            Verdict::Stable(Proof::Errors),
        ),
        ((1, 1), (1, 1000), (1465, 1000), unstable),
        // Exactly there: 41/28 + c²/2.
        ((1, 1), (1, 1), (55, 28), neutral),
        (
            (1, 1),
            (1, 1),
            (55_000_000_000_000_001, 28_000_000_000_000_000),
            Verdict::Unstable(Proof::Determinants),
        ),
        (
            (1, 1),
            (1, 1),
            (54_999_999_999_999_999, 28_000_000_000_000_000),
            Verdict::Stable(Proof::Determinants),
        ),
    ] {
        let given = values(&[("k", k.0, k.1), ("c", c.0, c.1), ("P", force.0, force.1)]);
        let instance = system.at(&given).unwrap();
        assert_eq!(instance.verdict(), expected, "{given:?}");
        assert_eq!(instance.diverges(), Some(false));
    }
}

/// Four numbers a row: M, C, K of systems with small integers, and what is known of them.
#[test]
fn verdicts_of_small_systems() {
    let neutral = Verdict::Undecided(Doubt::Neutral);
    for (mass, damping, stiffness, expected, diverges) in [
        (vec![1], vec![1], vec![1], "stable", false),
        (vec![1], vec![-1], vec![1], "unstable", false),
        (vec![1], vec![1], vec![-1], "unstable", true),
        (vec![-1], vec![-1], vec![-1], "stable", false),
        // Gyroscopic stabilisation: λ⁴ + 7λ² + 1, all imaginary.
        (
            vec![1, 0, 0, 1],
            vec![0, 3, -3, 0],
            vec![-1, 0, 0, -1],
            "neutral",
            false,
        ),
        // Too weak: λ⁴ − λ² + 1.
        (
            vec![1, 0, 0, 1],
            vec![0, 1, -1, 0],
            vec![-1, 0, 0, -1],
            "unstable",
            false,
        ),
        // Two equal oscillators with a coupling one way: it grows like t, but no eigenvalue is to the right.
        (
            vec![1, 0, 0, 1],
            vec![0; 4],
            vec![1, 1, 0, 1],
            "neutral",
            false,
        ),
        // Follower forces: a negative square under the root.
        (
            vec![1, 0, 0, 1],
            vec![0; 4],
            vec![1, 1, -1, 1],
            "unstable",
            false,
        ),
        // One coordinate is damped and another one not, apart and coupled.
        (
            vec![1, 0, 0, 1],
            vec![1, 0, 0, 0],
            vec![1, 0, 0, 4],
            "neutral",
            false,
        ),
        (
            vec![1, 0, 0, 1],
            vec![1, 0, 0, 0],
            vec![2, 1, 1, 4],
            "stable",
            false,
        ),
        (
            vec![1, 0, 0, 1],
            vec![1, 0, 0, 0],
            vec![2, -1, 0, 4],
            "neutral",
            false,
        ),
        // Free to move away: 0 is an eigenvalue.
        (
            vec![1, 0, 0, 1],
            vec![1, 0, 0, 1],
            vec![1, -1, -1, 1],
            "neutral",
            false,
        ),
    ] {
        let [mass, damping, stiffness] = [mass, damping, stiffness].map(|own| numbers(&own));
        let system = constant([&mass, &damping, &stiffness]);
        let instance = system.at(&BTreeMap::new()).unwrap();
        let verdict = instance.exact_verdict();
        match expected {
            "neutral" => assert_eq!(verdict, neutral, "{damping:?} {stiffness:?}"),
            name => assert_eq!(
                (verdict.name(), instance.verdict().name()),
                (name, name),
                "{damping:?} {stiffness:?}"
            ),
        }
        if !(expected == "neutral" && instance.diverges().is_none()) {
            assert_eq!(
                instance.diverges(),
                Some(diverges),
                "{damping:?} {stiffness:?}"
            );
        }
    }
}

/// A pendulum on an arm at an angle: M = 1, C = c cos(2α), K = k sin α + √k/w, where α, k, c and w are given.
fn with_angle() -> System {
    let mut writer = Writer::new(&["k", "w", "cosine", "sine"]);
    let [k, w, cosine, sine] = ["k", "w", "cosine", "sine"].map(|name| writer.input(name));
    let one = writer.number(1, 1);
    let root = writer.program.push(Operation::SquareRoot(k));
    let quotient = writer.over(root, w);
    let product = writer.times(k, sine);
    let stiffness = writer.plus(product, quotient);
    let mut system = writer.system([&[one], &[cosine], &[stiffness]]);
    let circular = |function, count| {
        Origin::Circular(Circular {
            function,
            angle: vec![(count, "α".to_string())],
        })
    };
    system.evaluator.inputs[2].origin = circular(Function::Cosine, 2);
    system.evaluator.inputs[3].origin = circular(Function::Sine, 1);
    system.evaluator.angles = vec![Angle {
        quantity: Quantity::plain("α"),
        fixed: None,
    }];
    system
}

#[test]
fn parameters_are_angles_and_not_their_sines() {
    let system = with_angle();
    assert_eq!(system.names(), ["k", "w", "α"]);
    for (k, angle) in [((9, 1), (1, 2)), ((2, 1), (1, 2)), ((2, 1), (5, 4))] {
        let given = values(&[("k", k.0, k.1), ("w", 7, 1), ("α", angle.0, angle.1)]);
        let instance = system.at(&given).unwrap();
        let (k, angle) = (k.0 as f64, angle.0 as f64 / angle.1 as f64);
        let matrices = instance.matrices();
        assert!((matrices.damping[(0, 0)] - (2.0 * angle).cos()).abs() < 1e-15);
        assert!(
            (matrices.stiffness[(0, 0)] - (k * angle.sin() + k.sqrt() / 7.0)).abs() < 1e-15 * k
        );
        let expected = if angle > 0.8 { "unstable" } else { "stable" };
        assert_eq!(instance.verdict().name(), expected);
        // Without what the errors say: exact where the root is, else by enclosures.
        assert_eq!(instance.exact_verdict().name(), expected);
    }
}

#[test]
fn what_is_wrong_is_told() {
    let system = with_angle();
    let error = |list: &[(&str, i64, i64)]| system.at(&values(list)).unwrap_err();
    let missing = error(&[("k", 1, 1)]);
    assert_eq!(
        missing,
        SystemError::Missing {
            names: vec!["w".to_string(), "α".to_string()]
        }
    );
    assert_eq!(missing.to_string(), "w and α have no value: give w=…, α=…");
    let unknown = error(&[("k", 1, 1), ("w", 1, 1), ("α", 1, 1), ("cosine", 1, 1)]);
    assert_eq!(
        unknown.to_string(),
        "cosine is no parameter of the system; its parameters are k, w, α"
    );
    assert_eq!(
        error(&[("k", 2, 1), ("w", 0, 1), ("α", 1, 1)]),
        SystemError::Division
    );
    assert_eq!(
        error(&[("k", -2, 1), ("w", 1, 1), ("α", 1, 1)]),
        SystemError::Root
    );
    let mut huge = values(&[("k", 2, 1), ("w", 1, 1), ("α", 1, 1)]);
    let power = (0..400).fold(Rational::ONE, |power, _| power * Rational::from(10));
    huge.insert("k".to_string(), power.clone());
    assert_eq!(
        system.at(&huge).unwrap_err(),
        SystemError::TooLarge {
            name: "k".to_string()
        }
    );
    let zero = numbers(&[0]);
    let singular = constant([
        &numbers(&[1, 2, 2, 4]),
        &numbers(&[0; 4]),
        &numbers(&[1, 0, 0, 1]),
    ]);
    assert_eq!(
        singular.at(&BTreeMap::new()).unwrap_err(),
        SystemError::SingularMass
    );
    let overflow = constant([&numbers(&[1]), &zero, &[power]]);
    assert_eq!(
        overflow.at(&BTreeMap::new()).unwrap_err(),
        SystemError::Entry {
            matrix: 'K',
            row: 1,
            column: 1
        }
    );
    let mut short = with_angle();
    short.damping.clear();
    assert_eq!(
        short.at(&huge).unwrap_err(),
        SystemError::Outputs {
            found: 3,
            expected: 2
        }
    );
    short.coordinates.clear();
    assert_eq!(
        short.at(&huge).unwrap_err(),
        SystemError::Coordinates { found: 0 }
    );
}

/// The critical values of a search, with what it becomes there.
fn critical(
    system: &System,
    given: &[(&str, i64, i64)],
    over: &str,
    from: i64,
    to: i64,
) -> super::critical::Ranges {
    system
        .critical(&values(given), over, &rational(from, 1), &rational(to, 1))
        .unwrap()
}

#[test]
fn critical_loads_are_those_by_hand() {
    use super::critical::Stability::{Divergent, Neutral, Stable, Undecided, Unstable};
    let system = ziegler();
    let without = 3.5 - std::f64::consts::SQRT_2;
    for (over, from, to, given, expected, kinds) in [
        (
            "P",
            0,
            4,
            vec![("k", 1, 1), ("c", 0, 1)],
            vec![without],
            vec![Neutral, Unstable],
        ),
        (
            "P",
            -1,
            4,
            vec![("k", 1, 1), ("c", 1, 1)],
            vec![55.0 / 28.0],
            vec![Stable, Unstable],
        ),
        (
            "P",
            0,
            4,
            vec![("k", 1, 1), ("c", 1, 1000)],
            vec![41.0 / 28.0 + 5e-7],
            vec![Stable, Unstable],
        ),
        (
            "c",
            0,
            4,
            vec![("k", 1, 1), ("P", 55, 28)],
            vec![1.0],
            vec![Unstable, Stable],
        ),
        (
            "k",
            1,
            40,
            vec![("c", 1, 1), ("P", 24, 1)],
            vec![(24.0 - 0.5) * 28.0 / 41.0],
            vec![Unstable, Stable],
        ),
    ] {
        let found = critical(&system, &given, over, from, to);
        let kept: Vec<_> = found
            .ranges
            .iter()
            .filter(|own| own.stability != Undecided)
            .collect();
        let found_kinds: Vec<_> = kept.iter().map(|own| own.stability).collect();
        assert_eq!(
            found_kinds.last(),
            kinds.last(),
            "{over} {given:?} {found:?}"
        );
        assert_eq!(
            found.critical.len(),
            expected.len(),
            "{over} {given:?} {found:?}"
        );
        for (own, expected) in found.critical.iter().zip(expected) {
            assert!(
                (own.value - expected).abs() <= own.error + 1e-15 * expected,
                "{own:?} {expected}"
            );
            assert!(own.error < 1e-9, "{own:?}");
        }
    }
    // A coordinate that a falling stiffness lets go: static divergence at k = 0.
    let mut writer = Writer::new(&["k"]);
    let (k, one) = (writer.input("k"), writer.number(1, 1));
    let system = writer.system([&[one], &[one], &[k]]);
    let found = critical(&system, &[], "k", -3, 5);
    assert_eq!(
        found
            .ranges
            .iter()
            .map(|own| own.stability)
            .collect::<Vec<_>>(),
        [Divergent, Stable]
    );
    assert!(
        found.critical[0].value.abs() <= found.critical[0].error && found.critical[0].error < 1e-12
    );
    // Over an angle: C = cos 2α changes at π/4.
    let found = critical(&with_angle(), &[("k", 2, 1), ("w", 7, 1)], "α", 0, 2);
    let quarter = std::f64::consts::FRAC_PI_4;
    assert!(
        (found.critical[0].value - quarter).abs() <= found.critical[0].error + 1e-16,
        "{found:?}"
    );
    assert_eq!(found.critical.len(), 1, "{found:?}");
}

#[test]
fn wrong_ranges_are_told() {
    let system = ziegler();
    let given = values(&[("k", 1, 1), ("c", 1, 1)]);
    let error = |over: &str, from: i64, to: i64| {
        system
            .critical(&given, over, &rational(from, 1), &rational(to, 1))
            .unwrap_err()
    };
    assert_eq!(
        error("P", 2, 2).to_string(),
        "the range of P has no width: give a last value above the first"
    );
    assert_eq!(
        error("Q", 1, 2).to_string(),
        "Q is no parameter of the system; its parameters are k, c, P"
    );
    assert_eq!(
        system
            .critical(
                &values(&[("k", 1, 1)]),
                "P",
                &rational(1, 1),
                &rational(2, 1)
            )
            .unwrap_err(),
        SystemError::Missing {
            names: vec!["c".to_string()]
        }
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// A system whose damping and stiffness move with a parameter: what is said of a range is so at its numbers.
    #[test]
    fn what_is_certain_of_a_range_is_so_at_every_value(
        size in 1_usize..=5, a in entries(), c in entries(), k in entries(), d in entries(), places in prop::collection::vec(0.0..1.0f64, 12),
    ) {
        let mut writer = Writer::new(&["p"]);
        let p = writer.input("p");
        let mut linear = |constant: &[Rational], slope: &[Rational]| -> Vec<Node> {
            constant.iter().zip(slope).map(|(constant, slope)| {
                let (constant, slope) = (writer.program.constant(constant.clone()), writer.program.constant(slope.clone()));
                let product = writer.times(slope, p);
                writer.plus(constant, product)
            }).collect()
        };
        let zero = vec![Rational::ZERO; size * size];
        let mass = linear(&positive(size, &a), &zero);
        let damping = linear(&positive(size, &c), &square(size, &d, 4));
        let stiffness = linear(&positive(size, &k), &square(size, &c, 1));
        let system = writer.system([&mass, &damping, &stiffness]);
        let found = system.critical(&BTreeMap::new(), "p", &rational(-1, 1), &rational(2, 1)).unwrap();
        let mut covered = 0.0;
        for range in &found.ranges {
            prop_assert!(range.from <= range.to);
            covered += range.to - range.from;
            for place in &places {
                let at = range.from + place * (range.to - range.from);
                let instance = system.at(&BTreeMap::from([("p".to_string(), exact(at.clamp(range.from, range.to)))])).unwrap();
                let verdict = instance.verdict().name();
                match range.stability {
                    super::critical::Stability::Stable => prop_assert_eq!(verdict, "stable", "{} {:?}", at, range),
                    super::critical::Stability::Unstable => prop_assert_eq!(verdict, "unstable", "{} {:?}", at, range),
                    super::critical::Stability::Divergent => {
                        prop_assert_eq!(verdict, "unstable", "{} {:?}", at, range);
                        prop_assert!(instance.diverges() != Some(false));
                    }
                    super::critical::Stability::Neutral => prop_assert!(false, "nothing is undamped"),
                    super::critical::Stability::Undecided => (),
                }
            }
        }
        prop_assert!((covered - 3.0).abs() < 1e-6 * 3.0);
        let undecided = found.ranges.iter().filter(|own| own.stability == super::critical::Stability::Undecided);
        prop_assert!(undecided.map(|own| own.to - own.from).sum::<f64>() < 0.01, "{found:?}");
    }
}
