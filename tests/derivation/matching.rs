//! What is said of a solution where its equations are singular, against numbers near such places.

use std::collections::BTreeMap;

use proptest::prelude::*;

use sextic::algebra::number::{Integer, Rational};
use sextic::derivation::matching::{Existence, Matched};
use sextic::language::syntax::{BinaryOperator, Expression, Node};

use super::{audit_text, block};

/// Factors as a document writes them, with sines and roots; some vanish together, some hide in others.
const FACTORS: [&str; 15] = [
    "sin(α)",
    "cos(α)",
    "(1 - cos(α))",
    "(1 + cos(α))",
    "(3*sin(α) - 4*cos(α))",
    "(sin(α) - y)",
    "(2 + sin(α))",
    "sqrt(x)",
    "(y - sqrt(x))",
    "(y + sqrt(x))",
    "(1 + sqrt(x))",
    "x",
    "y",
    "(y - x)",
    "(y^2 - x)",
];

fn matched(exact: &str, assumed: &str) -> Matched {
    let declared = "parameter u, λ, b, y : 1\nparameter x : 1 >= 0\nangle α";
    let text =
        format!("{declared}\nmatch (1) m: λ + u*{exact} with λ + {assumed}*b in λ unknown b at 1");
    let audit = audit_text(&block(&text)).unwrap_or_else(|message| panic!("{text}\n{message}"));
    audit.matchings[0].clone()
}

fn whole(number: i64) -> Rational {
    Rational::from(Integer::from(number))
}

/// A point by the half-tangent of α, the root of x, and y; `turned` adds π to the angle.
#[derive(Clone, Debug)]
struct Near {
    tangent: Rational,
    root: Rational,
    y: Rational,
    turned: bool,
}

impl Near {
    fn moved(&self, by: &Rational) -> Near {
        Near {
            tangent: &self.tangent + by * whole(3),
            root: &self.root + by * whole(5),
            y: &self.y + by * whole(7),
            turned: self.turned,
        }
    }

    fn values(&self) -> BTreeMap<&'static str, Rational> {
        let square = &self.tangent * &self.tangent;
        let sign = whole(if self.turned { -1 } else { 1 });
        let below = &sign * (whole(1) + &square);
        BTreeMap::from([
            ("cos", (whole(1) - square) / &below),
            ("sin", whole(2) * &self.tangent / &below),
            ("sqrt", self.root.clone()),
            ("x", &self.root * &self.root),
            ("y", self.y.clone()),
            ("u", whole(1)),
        ])
    }
}

/// The value of an expression in the few names of these documents; none where it divides by 0.
fn value(expression: &Expression, values: &BTreeMap<&str, Rational>) -> Option<Rational> {
    match &expression.node {
        Node::Number(number) => Some(number.clone()),
        Node::Name(name) => Some(values[name.ascii.as_str()].clone()),
        Node::Call { function, .. } => Some(values[function.ascii.as_str()].clone()),
        Node::Negative(inner) => Some(-value(inner, values)?),
        Node::Binary(operator, left, right) => {
            let (a, b) = (value(left, values)?, value(right, values)?);
            match operator {
                BinaryOperator::Add => Some(a + b),
                BinaryOperator::Subtract => Some(a - b),
                BinaryOperator::Multiply => Some(a * b),
                BinaryOperator::Divide => (b != whole(0)).then(|| a / b),
                BinaryOperator::Power => {
                    let count = i64::try_from(b.numerator()).ok()?;
                    Some((0..count).fold(whole(1), |power, _| power * &a))
                }
            }
        }
        other => panic!("{other:?} in a matching of these documents"),
    }
}

/// All combinations of values at which some of the factors vanish.
fn places() -> Vec<Near> {
    let half = |n: &i64| whole(*n) / whole(2);
    let mut places = Vec::new();
    for tangent in [0, 1, 2, -2].iter().map(half) {
        for root in [0, 1, 2, 4].iter().map(half) {
            for y in [0, 1, -1, 2, -2, 4, 8].iter().map(half) {
                places.extend([false, true].map(|turned| Near {
                    tangent: tangent.clone(),
                    root: root.clone(),
                    y: y.clone(),
                    turned,
                }));
            }
        }
    }
    places
}

/// How large the quotient of two products is at a distance of 10⁻ⁿ from a place.
fn size(above: &Expression, below: &Expression, place: &Near, n: usize) -> Rational {
    let distance = (0..n).fold(whole(1), |distance, _| distance / whole(10));
    let values = place.moved(&distance).values();
    let (above, below) = (value(above, &values), value(below, &values));
    let quotient = above.unwrap() / below.unwrap();
    if quotient < whole(0) {
        -quotient
    } else {
        quotient
    }
}

/// The verdict on each factor at which the equation below·b = above is singular, checked at all places
/// where that factor vanishes and no other does.
fn checked(above: &str, below: &str) -> Vec<Existence> {
    let matched = matched(above, below);
    // λ⁰ stands last: `u·above` and `below·b`.
    let row = matched.table.last().unwrap();
    let zeros = |at: &Near| -> Vec<bool> {
        let values = at.values();
        let factors = matched.singular_where.iter();
        factors
            .map(|one| value(&one.factor, &values).unwrap() == whole(0))
            .collect()
    };
    for place in places() {
        let zeros = zeros(&place);
        let Some(at) = zeros.iter().position(|zero| *zero) else {
            continue;
        };
        if zeros.iter().filter(|zero| **zero).count() == 1 && matched.singular_where[at].is_finite()
        {
            let [far, near] = [4, 8].map(|n| size(&row.exact, &matched.determinant, &place, n));
            assert!(
                near <= whole(10) * &far + whole(1),
                "{above} over {below} is said to stay finite at {place:?}: {far}, {near}"
            );
        }
    }
    matched
        .singular_where
        .iter()
        .map(|one| one.existence)
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn what_is_said_to_stay_finite_does(
        above in prop::collection::vec(0..FACTORS.len(), 0..3),
        below in prop::collection::vec(0..FACTORS.len(), 1..4),
    ) {
        let product = |factors: &[usize]| {
            let factors: Vec<&str> = factors.iter().map(|factor| FACTORS[*factor]).collect();
            if factors.is_empty() { "1".to_string() } else { factors.join("*") }
        };
        checked(&product(&above), &product(&below));
    }
}

#[test]
fn hidden_factors_are_found() {
    use Existence::{Lost, Stays};
    for (above, below, expected) in [
        ("1", "sin(α)^2", vec![Lost]),
        ("sin(α)^2", "sin(α)^2", vec![Stays]),
        ("sin(α)", "sin(α)^2", vec![Lost]),
        ("sin(α)^2", "(1 + cos(α))", vec![Stays]),
        ("1", "sqrt(x)", vec![Lost]),
        ("sqrt(x)", "sqrt(x)", vec![Stays]),
        ("x", "sqrt(x)", vec![Stays]),
        ("1", "(y - sqrt(x))", vec![Lost]),
        ("(y - x)", "(y - x)", vec![Stays]),
        ("(y^2 - x)", "(y - sqrt(x))", vec![Stays]),
        ("sin(α)", "sin(α)*y", vec![Stays, Lost]),
    ] {
        assert_eq!(checked(above, below), expected, "{above} over {below}");
    }
}

#[test]
fn a_solution_stays_where_all_that_it_is_made_of_has_a_value() {
    for (exact, factor, expected) in [
        ("y*C(1/y)", "y", Existence::Unknown),
        ("y*C(1/(1 + y^2))", "y", Existence::Stays),
        ("y*D", "y", Existence::Unknown),
        ("y*sqrt(y - 1)", "y", Existence::Unknown),
        ("y*sqrt(1 + y^2)", "y", Existence::Stays),
        ("(1 - cos(α))/sin(α)", "(1 - cos(α))", Existence::Unknown),
        ("(x^2 + y^2)/y", "(x^2 + y^2)", Existence::Unknown),
        ("sin(α)^2", "sin(α)", Existence::Stays),
        ("sin(α)", "sin(α)^2", Existence::Lost),
        ("1", "y", Existence::Lost),
    ] {
        let text = format!(
            "parameter x, y, b, λ : 1\nangle α\nfunction C at α : 1\nfunction D at 1/y : 1\n\
             match (1) m: λ^2 + {exact}*λ with λ^2 + {factor}*b*λ in λ unknown b at λ"
        );
        let audit = audit_text(&block(&text)).unwrap_or_else(|message| panic!("{text}\n{message}"));
        let found = audit.matchings[0].singular_where.first();
        assert_eq!(found.map(|one| one.existence), Some(expected), "{text}");
    }
}
