//! The laws of graphs, on arbitrary ones: what is computed of a node is what the arithmetic of power
//! series computes of the tree that it was built from, without a graph.

use std::sync::Arc;

use proptest::prelude::*;

use super::derivative::{By, Derivative};
use super::evaluation::Evaluation;
use super::graph::{Graph, Kind, Made, NodeId, Variable, VariableId};
use super::number::Number;
use super::real::exact_root;
use super::search::{Purpose, Search};
use super::sheet::Sheet;
use super::substitution::Substitution;
use super::{Failure, NoValue, Unknown};
use crate::algebra::number::Rational;
use crate::algebra::sign::Signs;

/// What stands in a tree.
const VARIABLES: [(&str, Kind, Signs); 5] = [
    ("x", Kind::Real, Signs::POSITIVE),
    ("y", Kind::Real, Signs::NEGATIVE),
    ("z", Kind::Real, Signs::ANY),
    ("w", Kind::Complex, Signs::ANY),
    ("alpha", Kind::Angle, Signs::ANY),
];
const X: usize = 0;
const Z: usize = 2;
const ALPHA: usize = 4;

#[derive(Clone, Debug)]
enum Tree {
    Number(Rational),
    ImaginaryUnit,
    Variable(usize),
    Cosine,
    Sine,
    Sum(Box<Tree>, Box<Tree>),
    Product(Box<Tree>, Box<Tree>),
    Quotient(Box<Tree>, Box<Tree>),
    Power(Box<Tree>, i64),
    Root(Box<Tree>),
}

fn leaf() -> impl Strategy<Value = Tree> {
    prop_oneof![
        (-3_i64..=3, 1_i64..=3)
            .prop_map(|(a, b)| Tree::Number(Rational::from(a) / Rational::from(b))),
        Just(Tree::ImaginaryUnit),
        (0..ALPHA).prop_map(Tree::Variable),
        Just(Tree::Cosine),
        Just(Tree::Sine),
    ]
}

fn tree() -> impl Strategy<Value = Tree> {
    leaf().prop_recursive(5, 24, 2, |inner| {
        let one = inner.clone().prop_map(Box::new);
        let two = (one.clone(), one.clone());
        prop_oneof![
            3 => two.clone().prop_map(|(a, b)| Tree::Sum(a, b)),
            3 => two.clone().prop_map(|(a, b)| Tree::Product(a, b)),
            2 => two.prop_map(|(a, b)| Tree::Quotient(a, b)),
            1 => (one.clone(), -2_i64..=4).prop_map(|(a, n)| Tree::Power(a, n)),
            1 => one.clone().prop_map(Tree::Root),
            2 => one.prop_map(|a| Tree::Root(Box::new(Tree::Power(a, 2)))),
        ]
    })
}

/// A complex number.
type Complex = (Rational, Rational);

fn real(number: Rational) -> Complex {
    (number, Rational::ZERO)
}

fn plus(a: &Complex, b: &Complex) -> Complex {
    (&a.0 + &b.0, &a.1 + &b.1)
}

fn times(a: &Complex, b: &Complex) -> Complex {
    (&a.0 * &b.0 - &a.1 * &b.1, &a.0 * &b.1 + &a.1 * &b.0)
}

fn inverse(a: &Complex) -> Option<Complex> {
    let square = &a.0 * &a.0 + &a.1 * &a.1;
    (!square.is_zero()).then(|| (&a.0 / &square, -&a.1 / &square))
}

/// The first coefficients of a power series.
type Series = Vec<Complex>;

/// How many coefficients are followed.
const LENGTH: usize = 4;

fn constant(number: Complex) -> Series {
    let mut series = vec![real(Rational::ZERO); LENGTH];
    series[0] = number;
    series
}

/// Σ aⱼ bₖ₋ⱼ for j in a range.
fn convolution(a: &Series, b: &Series, k: usize, range: std::ops::Range<usize>) -> Complex {
    let terms = range.map(|j| times(&a[j], &b[k - j]));
    terms.fold(real(Rational::ZERO), |sum, term| plus(&sum, &term))
}

fn product(a: &Series, b: &Series) -> Series {
    (0..LENGTH)
        .map(|k| convolution(a, b, k, 0..k + 1))
        .collect()
}

fn minus(a: &Complex) -> Complex {
    (-&a.0, -&a.1)
}

/// q with q·b = a.
fn quotient(a: &Series, b: &Series) -> Option<Series> {
    let inverse = inverse(&b[0])?;
    let mut result = constant(real(Rational::ZERO));
    for k in 0..LENGTH {
        let known = convolution(&result, b, k, 0..k);
        result[k] = times(&plus(&a[k], &minus(&known)), &inverse);
    }
    Some(result)
}

/// r ≥ 0 with r·r = a, if its first coefficient is a fraction > 0.
fn root(a: &Series) -> Option<Series> {
    let first = a[0].1.is_zero().then(|| exact_root(&a[0].0))??;
    let half = inverse(&real(&first + &first))?;
    let mut result = constant(real(first));
    for k in 1..LENGTH {
        let known = convolution(&result, &result, k, 1..k);
        result[k] = times(&plus(&a[k], &minus(&known)), &half);
    }
    Some(result)
}

/// What variables, cos α and sin α are.
#[derive(Clone, Debug)]
struct Surroundings {
    variables: Vec<Series>,
    circle: [Series; 2],
}

impl Tree {
    fn series(&self, at: &Surroundings) -> Option<Series> {
        match self {
            Tree::Number(number) => Some(constant(real(number.clone()))),
            Tree::ImaginaryUnit => Some(constant((Rational::ZERO, Rational::ONE))),
            Tree::Variable(place) => Some(at.variables[*place].clone()),
            Tree::Cosine => Some(at.circle[0].clone()),
            Tree::Sine => Some(at.circle[1].clone()),
            Tree::Sum(a, b) => {
                let (a, b) = (a.series(at)?, b.series(at)?);
                Some(a.iter().zip(&b).map(|(a, b)| plus(a, b)).collect())
            }
            Tree::Product(a, b) => Some(product(&a.series(at)?, &b.series(at)?)),
            Tree::Quotient(a, b) => quotient(&a.series(at)?, &b.series(at)?),
            Tree::Power(a, n) => {
                let (a, one) = (a.series(at)?, constant(real(Rational::ONE)));
                let power = (0..n.unsigned_abs()).fold(one.clone(), |power, _| product(&power, &a));
                if *n < 0 {
                    quotient(&one, &power)
                } else {
                    Some(power)
                }
            }
            Tree::Root(a) => root(&a.series(at)?),
        }
    }

    fn has_z(&self) -> bool {
        match self {
            Tree::Variable(place) => *place == Z,
            Tree::Sum(a, b) | Tree::Product(a, b) | Tree::Quotient(a, b) => a.has_z() || b.has_z(),
            Tree::Power(a, _) | Tree::Root(a) => a.has_z(),
            _ => false,
        }
    }

    /// Whether it is written as a polynomial in z.
    fn is_polynomial(&self) -> bool {
        match self {
            Tree::Sum(a, b) | Tree::Product(a, b) => a.is_polynomial() && b.is_polynomial(),
            Tree::Quotient(a, b) => a.is_polynomial() && !b.has_z(),
            Tree::Power(a, n) if *n >= 0 => a.is_polynomial(),
            _ => matches!(self, Tree::Variable(_)) || !self.has_z(),
        }
    }

    fn node(&self, graph: &mut Graph) -> Made {
        match self {
            Tree::Number(number) => graph.number(number.clone()),
            Tree::ImaginaryUnit => graph.imaginary_unit(),
            Tree::Variable(place) => {
                let id = variable(*place, graph);
                graph.free(id)
            }
            Tree::Cosine => {
                let id = variable(ALPHA, graph);
                graph.cosine(id)
            }
            Tree::Sine => {
                let id = variable(ALPHA, graph);
                graph.sine(id)
            }
            Tree::Sum(a, b) => {
                let (a, b) = (a.node(graph)?, b.node(graph)?);
                graph.sum(a, b)
            }
            Tree::Product(a, b) => {
                let (a, b) = (a.node(graph)?, b.node(graph)?);
                graph.product(a, b)
            }
            Tree::Quotient(a, b) => {
                let (a, b) = (a.node(graph)?, b.node(graph)?);
                graph.quotient(a, b)
            }
            Tree::Power(a, n) => {
                let a = a.node(graph)?;
                graph.power(a, *n)
            }
            Tree::Root(a) => {
                let a = a.node(graph)?;
                graph.root(a)
            }
        }
    }
}

fn variable(place: usize, graph: &mut Graph) -> VariableId {
    let (name, kind, signs) = VARIABLES[place];
    graph.variable_id(Variable {
        name: name.to_owned(),
        order: 0,
        kind,
        signs,
    })
}

/// An evaluation at an assignment of short numbers.
fn evaluation(place: u64, purpose: Purpose) -> Evaluation {
    let signs = VARIABLES
        .iter()
        .map(|(name, _, signs)| (name.to_string(), *signs));
    let search = Search {
        signs: Arc::new(signs.collect()),
        measured: Arc::default(),
        assumed: Vec::new(),
        purpose,
    };
    let found = search.find(&Graph::default(), place, &mut usize::MAX.clone());
    found.expect("nothing is assumed")
}

/// A sheet with nothing on it.
fn sheet() -> Sheet {
    let generic = (0..4)
        .map(|place| evaluation(place, Purpose::Trust))
        .collect();
    Sheet::new(Graph::default(), generic, [[1, 2], [3, 4]])
}

fn exact(number: &Number) -> Complex {
    let of = |part: &super::real::Real| part.as_rational().expect("a fraction").clone();
    (
        of(&number.real),
        number.imaginary.as_ref().map_or(Rational::ZERO, of),
    )
}

/// What everything is at an assignment.
fn surroundings(evaluation: &mut Evaluation, graph: &mut Graph) -> Surroundings {
    let mut at = |node: NodeId, graph: &Graph| {
        constant(exact(&evaluation.value(graph, node).expect("a value")))
    };
    let variables = (0..ALPHA).map(|place| {
        let node = Tree::Variable(place).node(graph).expect("a variable");
        at(node, graph)
    });
    let variables = variables.collect();
    let circle = [Tree::Cosine, Tree::Sine].map(|tree| {
        let node = tree.node(graph).expect("of an angle");
        at(node, graph)
    });
    Surroundings { variables, circle }
}

/// Whether a node has this value, or none.
fn is(evaluation: &mut Evaluation, graph: &Graph, node: Made, expected: Option<&Complex>) -> bool {
    let value = node.and_then(|node| evaluation.value(graph, node));
    match (value, expected) {
        (Ok(value), Some((a, b))) => {
            let expected = Number::new(a.clone().into(), b.clone().into());
            value.may_be(&expected) && value.is_narrow(&value, 64)
        }
        (Err(_), None) => true,
        _ => false,
    }
}

/// Coefficients of cos(α + ε) and sin(α + ε).
fn turned(circle: &[Series; 2]) -> [Series; 2] {
    let (c, s) = (&circle[0][0], &circle[1][0]);
    let over = |a: &Complex, n: i64| times(a, &real(Rational::ONE / Rational::from(n)));
    [
        vec![c.clone(), over(s, -1), over(c, -2), over(s, 6)],
        vec![s.clone(), over(c, 1), over(s, -2), over(c, -6)],
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn the_value_of_a_graph_is_that_of_the_tree(tree in tree(), place in 0_u64..20) {
        let mut sheet = sheet();
        let mut evaluation = evaluation(place, Purpose::Show);
        let at = surroundings(&mut evaluation, &mut sheet.graph);
        let series = tree.series(&at);
        let node = tree.node(&mut sheet.graph);
        // Of other roots the trees know nothing.
        if series.is_none() && node.is_ok() { return Ok(()) }
        prop_assert!(is(&mut evaluation, &sheet.graph, node, series.map(|own| own[0].clone()).as_ref()));
    }

    #[test]
    fn a_derivative_is_the_slope(tree in tree(), place in 0_u64..20, by in prop_oneof![0..=Z, Just(ALPHA)]) {
        let mut sheet = sheet();
        let mut evaluation = evaluation(place, Purpose::Show);
        let mut at = surroundings(&mut evaluation, &mut sheet.graph);
        match by {
            ALPHA => at.circle = turned(&at.circle),
            _ => at.variables[by][1] = real(Rational::ONE),
        }
        let Some(series) = tree.series(&at) else { return Ok(()) };
        let node = tree.node(&mut sheet.graph).expect("it has a value");
        let by = variable(by, &mut sheet.graph);
        let slope = Derivative::new(By::Variable(by)).of(node, &mut sheet);
        prop_assert!(is(&mut evaluation, &sheet.graph, slope, Some(&series[1])));
    }

    #[test]
    fn what_is_written_in_is_there(tree in tree(), other in tree(), place in 0_u64..20) {
        let mut sheet = sheet();
        let mut evaluation = evaluation(place, Purpose::Show);
        let mut at = surroundings(&mut evaluation, &mut sheet.graph);
        // What was found of a real z does not hold of another one.
        let written = other.series(&at).filter(|own| own[0].1.is_zero());
        let Some(written) = written else { return Ok(()) };
        let mut substitution = Substitution::default();
        let node = other.node(&mut sheet.graph).expect("it has a value");
        substitution.variables.insert(variable(Z, &mut sheet.graph), node);
        at.variables[Z] = written;
        let Some(series) = tree.series(&at) else { return Ok(()) };
        let Ok(node) = tree.node(&mut sheet.graph) else { return Ok(()) };
        let image = substitution.of(node, &mut sheet);
        prop_assert!(is(&mut evaluation, &sheet.graph, image, Some(&series[0])));
    }

    #[test]
    fn the_parts_of_an_expansion_are_those_of_the_series(tree in tree(), place in 0_u64..20, order in 0_usize..LENGTH) {
        let mut sheet = sheet();
        let mut evaluation = evaluation(place, Purpose::Show);
        let mut at = surroundings(&mut evaluation, &mut sheet.graph);
        let small = [X, Z].map(|place| variable(place, &mut sheet.graph));
        for place in [X, Z] {
            at.variables[place].rotate_right(1);
        }
        let Some(series) = tree.series(&at) else { return Ok(()) };
        let Ok(node) = tree.node(&mut sheet.graph) else { return Ok(()) };
        let parts = sheet.parts(node, &small, &[], order as u32);
        for (power, expected) in series.iter().enumerate().take(order + 1) {
            let part = parts.as_ref().map(|parts| parts[power]).map_err(|failure| *failure);
            prop_assert!(is(&mut evaluation, &sheet.graph, part, Some(expected)), "{:?}", parts);
        }
    }

    #[test]
    fn coefficients_are_those_of_the_series(tree in tree(), place in 0_u64..20, power in 0..LENGTH) {
        let mut sheet = sheet();
        let mut evaluation = evaluation(place, Purpose::Show);
        let mut at = surroundings(&mut evaluation, &mut sheet.graph);
        at.variables[Z] = constant(real(Rational::ZERO));
        at.variables[Z][1] = real(Rational::ONE);
        let Some(series) = tree.series(&at) else { return Ok(()) };
        let Ok(node) = tree.node(&mut sheet.graph) else { return Ok(()) };
        let by = By::Variable(variable(Z, &mut sheet.graph));
        let coefficient = sheet.coefficient(node, by, power as u32);
        if !tree.is_polynomial() && matches!(coefficient, Err(Failure::Unknown(_))) { return Ok(()) }
        prop_assert!(is(&mut evaluation, &sheet.graph, coefficient, Some(&series[power])), "{:?}", coefficient);
    }

    #[test]
    fn a_product_of_lines_has_the_coefficients_of_their_series(lines in prop::collection::vec((tree(), tree()), 1..LENGTH), place in 0_u64..20) {
        let mut sheet = sheet();
        let mut evaluation = evaluation(place, Purpose::Show);
        let mut at = surroundings(&mut evaluation, &mut sheet.graph);
        // The coefficients do not rest on z: y stands for it.
        at.variables[Z] = at.variables[1].clone();
        let line = |(a, b): &(Tree, Tree)| {
            let (mut a, b) = (a.series(&at)?, b.series(&at)?);
            a.rotate_right(1);
            Some(a.iter().zip(&b).map(|(a, b)| plus(a, b)).collect::<Series>())
        };
        let Some(series) = lines.iter().map(line).collect::<Option<Vec<Series>>>() else { return Ok(()) };
        let series = series.iter().fold(constant(real(Rational::ONE)), |all, one| product(&all, one));
        let [y, z] = [1, Z].map(|place| variable(place, &mut sheet.graph));
        let mut fixed = Substitution::default();
        let one = sheet.graph.free(y).expect("a variable");
        fixed.variables.insert(z, one);
        let mut node = sheet.graph.integer(1).expect("a number");
        for (a, b) in &lines {
            let Ok([a, b]) = (|| {
                let (a, b) = (a.node(&mut sheet.graph)?, b.node(&mut sheet.graph)?);
                Ok::<_, Failure>([fixed.of(a, &mut sheet)?, fixed.of(b, &mut sheet)?])
            })() else { return Ok(()) };
            let free = sheet.graph.free(z).expect("a variable");
            let term = sheet.graph.product(a, free).expect("a product");
            let line = sheet.graph.sum(term, b).expect("a sum");
            node = sheet.graph.product(node, line).expect("a product");
        }
        let found = match sheet.falling_coefficients(node, By::Variable(z)) {
            // Roots that vanish are not seen to.
            Err(Failure::Unknown(Unknown::Identity)) => return Ok(()),
            found => found.expect("a polynomial"),
        };
        prop_assert!(found.len() <= LENGTH);
        for (power, expected) in series.iter().enumerate() {
            let own = found.iter().rev().nth(power).copied();
            let own = own.map_or_else(|| sheet.graph.integer(0), Ok);
            prop_assert!(is(&mut evaluation, &sheet.graph, own, Some(expected)), "{:?}", found);
        }
    }
}

/// Signs are those of the parts, and roots of squares use them.
#[test]
fn signs_follow_from_those_of_the_parts() {
    let (x, y, z) = (Tree::Variable(X), Tree::Variable(1), Tree::Variable(Z));
    let number = |n: i64| Tree::Number(Rational::from(n));
    let of = |make: fn(Box<Tree>, Box<Tree>) -> Tree, a: &Tree, b: &Tree| {
        make(Box::new(a.clone()), Box::new(b.clone()))
    };
    let power = |a: &Tree, n| Tree::Power(Box::new(a.clone()), n);
    let root = |a: &Tree| Tree::Root(Box::new(a.clone()));
    for (tree, is_positive) in [
        (number(3), true),
        (number(-3), false),
        (number(0), false),
        (x.clone(), true),
        (y.clone(), false),
        (of(Tree::Sum, &x, &number(1)), true),
        (of(Tree::Sum, &x, &power(&z, 2)), true),
        (of(Tree::Sum, &x, &z), false),
        (of(Tree::Product, &y, &y), true),
        (of(Tree::Product, &number(-2), &y), true),
        (of(Tree::Product, &x, &y), false),
        (of(Tree::Quotient, &number(-1), &y), true),
        (of(Tree::Sum, &x, &root(&z)), true),
        (root(&x), true),
        (root(&z), false),
        (power(&y, 2), true),
        (power(&y, 3), false),
        (power(&z, 2), false),
        (power(&Tree::ImaginaryUnit, 2), false),
        (power(&Tree::Variable(3), 2), false),
    ] {
        let mut graph = Graph::default();
        let node = tree.node(&mut graph).expect("a node");
        assert_eq!(graph.is_positive(node), is_positive, "{tree:?}");
    }
    let minus = of(Tree::Product, &number(-1), &y);
    for (tree, simple) in [
        (root(&power(&x, 2)), x.clone()),
        (root(&power(&y, 2)), minus.clone()),
        (root(&power(&power(&z, 2), 2)), power(&z, 2)),
        (root(&power(&y, 6)), power(&minus, 3)),
        (root(&power(&root(&z), 2)), root(&z)),
        (root(&power(&x, 3)), root(&power(&x, 3))),
    ] {
        let mut graph = Graph::default();
        let nodes = [tree, simple].map(|tree| tree.node(&mut graph).expect("a node"));
        assert_eq!(nodes[0], nodes[1]);
    }
}

/// Two functions, two orders and two arguments make different values; real ones have one everywhere.
#[test]
fn values_of_functions_are_told_apart() {
    let mut sheet = sheet();
    let graph = &mut sheet.graph;
    let [x, y, w] = [X, 1, 3].map(|place| Tree::Variable(place).node(graph).expect("a node"));
    let [f, g] = ["f", "g"].map(|name| graph.function_id(name));
    let places = [(f, 0, x), (g, 0, x), (f, 1, x), (f, 0, y)];
    let mut value = |(f, k, a)| graph.function(f, k, a, x).expect("a value");
    let values = places.map(&mut value);
    let other = value((f, 0, w));
    assert!(values.iter().all(|value| sheet.graph.is_total(*value)));
    assert!(!sheet.graph.is_total(other));
    for (a, left) in values.into_iter().enumerate() {
        for (b, right) in values.into_iter().enumerate() {
            assert_eq!(sheet.is_same(left, right), Ok(a == b));
        }
    }
}

/// Degrees far above the first that is tried are found; beyond that, nothing is said.
#[test]
fn coefficients_of_high_powers_are_found() {
    for (degree, is_found) in [(0, true), (7, true), (8, true), (50, true), (70, false)] {
        let mut sheet = sheet();
        let z = variable(Z, &mut sheet.graph);
        let x = Tree::Variable(X)
            .node(&mut sheet.graph)
            .expect("a variable");
        let free = sheet.graph.free(z).expect("a variable");
        let sum = sheet.graph.sum(free, x).expect("a sum");
        let power = sheet.graph.power(sum, degree).expect("a power");
        let found = sheet.falling_coefficients(power, By::Variable(z));
        let length = found.as_ref().map(Vec::len);
        match is_found {
            true => assert_eq!(length, Ok(degree as usize + 1)),
            false => assert_eq!(length, Err(&Unknown::NoPolynomial.into())),
        }
    }
}

/// The polynomial 0 has no coefficients, however it is written.
#[test]
fn a_polynomial_that_vanishes_has_no_coefficients() {
    let mut sheet = sheet();
    let z = variable(Z, &mut sheet.graph);
    let free = sheet.graph.free(z).expect("a variable");
    let one = sheet.graph.integer(1).expect("a number");
    let sum = sheet.graph.sum(free, one).expect("a sum");
    let square = sheet.graph.power(sum, 2).expect("a square");
    let product = sheet.graph.product(sum, sum).expect("a product");
    let difference = sheet
        .graph
        .difference(square, product)
        .expect("a difference");
    assert_eq!(
        sheet.falling_coefficients(difference, By::Variable(z)),
        Ok(Vec::new())
    );
}

/// A power of a number is computed where it is short, and else left as it is.
#[test]
fn long_powers_are_not_computed() {
    let mut graph = Graph::default();
    let third = graph.number(Rational::ONE / Rational::from(3));
    let third = third.expect("a number");
    for (exponent, is_computed) in [(2, true), (1365, true), (1366, false), (1 << 30, false)] {
        let power = graph.power(third, exponent).expect("a power");
        assert_eq!(graph.as_number(power).is_some(), is_computed, "{exponent}");
    }
}

/// Identities are seen, and nothing else is.
#[test]
fn what_vanishes_is_told_from_what_does_not() {
    let (x, y, w) = (Tree::Variable(0), Tree::Variable(1), Tree::Variable(3));
    let number = |n: i64| Tree::Number(Rational::from(n));
    let sum = |a: &Tree, b: &Tree| Tree::Sum(Box::new(a.clone()), Box::new(b.clone()));
    let times = |a: &Tree, b: &Tree| Tree::Product(Box::new(a.clone()), Box::new(b.clone()));
    let over = |a: &Tree, b: &Tree| Tree::Quotient(Box::new(a.clone()), Box::new(b.clone()));
    let power = |a: &Tree, n| Tree::Power(Box::new(a.clone()), n);
    let minus = |a: &Tree, b: &Tree| sum(a, &times(&number(-1), b));
    let i = Tree::ImaginaryUnit;
    let (a, b) = (sum(&x, &times(&i, &y)), minus(&x, &times(&i, &y)));
    let square = sum(&power(&x, 2), &power(&y, 2));
    let circle = sum(&power(&Tree::Cosine, 2), &power(&Tree::Sine, 2));
    let twice = sum(&square, &times(&number(2), &times(&x, &y)));
    for (left, right, is_same) in [
        (&power(&sum(&x, &y), 2), &twice, true),
        (&power(&sum(&x, &y), 2), &square, false),
        (&times(&a, &b), &square, true),
        (&times(&a, &a), &square, false),
        (&over(&number(1), &a), &over(&b, &square), true),
        (&over(&number(1), &a), &over(&a, &square), false),
        (&circle, &number(1), true),
        (
            &minus(&circle, &times(&number(2), &power(&Tree::Sine, 2))),
            &number(1),
            false,
        ),
        (
            &power(&sum(&number(1), &i), 5),
            &times(&number(-4), &sum(&number(1), &i)),
            true,
        ),
        (&power(&w, 3), &times(&w, &power(&w, 2)), true),
        (&power(&w, 3), &power(&w, 2), false),
        (
            &over(&x, &number(3)),
            &times(&x, &Tree::Number(Rational::ONE / Rational::from(3))),
            true,
        ),
        (&over(&number(1), &power(&x, 2)), &power(&x, -2), true),
        (&x, &y, false),
        (&x, &w, false),
        (&Tree::Cosine, &Tree::Sine, false),
    ] {
        let mut sheet = sheet();
        let nodes = [left, right].map(|tree| tree.node(&mut sheet.graph).expect("a node"));
        assert_eq!(
            sheet.is_same(nodes[0], nodes[1]),
            Ok(is_same),
            "{left:?} and {right:?}"
        );
    }
}

/// Roots may depend on each other in ways that are not followed: then nothing is said.
#[test]
fn roots_that_agree_without_being_seen_to_are_not_told_apart() {
    let mut sheet = sheet();
    let graph = &mut sheet.graph;
    let number = |graph: &mut Graph, n: i64| graph.integer(n).expect("a number");
    let (one, two, three) = (number(graph, 1), number(graph, 2), number(graph, 3));
    let root = graph.root(two).expect("a root");
    let twice = graph.product(two, root).expect("a product");
    let sum = graph.sum(three, twice).expect("a sum");
    let nested = graph.root(sum).expect("a root");
    let same = graph.sum(one, root).expect("a sum");
    assert_eq!(sheet.is_same(nested, same), Err(Unknown::Identity.into()));
    assert_eq!(sheet.is_same(nested, root), Ok(false));
}

/// What rests on a detour may have a value where the detour fails.
#[test]
fn what_rests_on_a_detour_may_have_a_value() {
    let mut graph = Graph::default();
    let [x, z] = [X, Z].map(|place| Tree::Variable(place).node(&mut graph).expect("a node"));
    let one = graph.integer(1).expect("a number");
    let inverse = graph.quotient(one, z).expect("a quotient");
    let detour = graph.by_detour(inverse).expect("a node");
    let sum = graph.sum(detour, x).expect("a sum");
    let root = graph.root(sum).expect("a root");
    let failure = Failure::from(NoValue::DivisionByZero);
    for (node, expected) in [
        (inverse, failure),
        (detour, Unknown::Detour.into()),
        (sum, Unknown::Detour.into()),
        (root, Unknown::Detour.into()),
    ] {
        assert_eq!(graph.failure_within(node, failure), expected);
    }
    assert_eq!(graph.by_detour(x), Ok(x));
}
