//! Evaluators written by hand, with everything that a printer can meet.

use sextic_codegen::evaluator::{
    Angle, Circular, Evaluator, Fixed, Function, Input, Origin, Quantity, Rounding,
};
use sextic_codegen::optimiser::optimise;
use sextic_codegen::program::{Node, Operation, Program, Rational};

use Operation::{Add, Divide, Multiply, Negative, SquareRoot, Subtract};

/// p/q
pub fn rational(above: i64, below: i64) -> Rational {
    Rational::from(above) / Rational::from(below)
}

/// The values of a program's inputs.
pub fn inputs(program: &Program) -> Vec<Node> {
    program
        .inputs()
        .iter()
        .filter_map(|name| program.input(name))
        .collect()
}

fn named(names: &[&str]) -> Program {
    Program::new(names.iter().map(|name| (*name).to_owned()))
}

/// x² a/3 + x y b − y² c/2, and half its derivative by x.
pub fn quadratic_form() -> Evaluator {
    let mut program = named(&["a", "b", "c", "x", "y"]);
    let [a, b, c, x, y] = inputs(&program)[..] else {
        panic!("five inputs");
    };
    let third = program.constant(rational(1, 3));
    let half = program.constant(rational(1, 2));
    let ax = program.push(Multiply(a, x));
    let ax = program.push(Multiply(third, ax));
    let by = program.push(Multiply(b, y));
    let cy = program.push(Multiply(c, y));
    let first = program.push(Add(ax, by));
    let first = program.push(Multiply(first, x));
    let last = program.push(Multiply(half, cy));
    let last = program.push(Multiply(last, y));
    let value = program.push(Subtract(first, last));
    let slope = program.push(Multiply(half, by));
    let slope = program.push(Add(ax, slope));
    program.output("value", value);
    program.output("slope", slope);
    let mut evaluator = Evaluator::plain("quadratic_form", optimise(&program));
    evaluator.title = "a quadratic form and half its slope".into();
    evaluator.description = "The form x² a/3 + x y b − y² c/2 with a coefficient that is no double, \
        so that one constant is a quotient. The word */ does not end a comment of C, nor does \"\"\" end \
        a text of Python, and [brackets] are no link."
        .into();
    evaluator.formula = vec!["value = x²·a/3 + x·y·b − y²·c/2".into()];
    evaluator.equations = vec!["1".into(), "2".into()];
    evaluator.source = "Written by hand for the tests".into();
    evaluator.inputs[3].quantity = Quantity {
        name: "x".into(),
        symbol: "ξ".into(),
        unit: "m".into(),
        description: "the first coordinate".into(),
    };
    evaluator.inputs[4].quantity.unit = "1".into();
    evaluator.inputs[4].quantity.description = "x axis, y axis: no words begin here".into();
    evaluator.assumptions = vec!["b > 0".into()];
    evaluator.conditions = vec!["a ≠ 0".into()];
    evaluator.command = "sextic generate samples.md --out DIR --language rust".into();
    evaluator.document = "samples.md".into();
    evaluator.hash = "00c0ffee".into();
    evaluator.proof = Some("Proven equal to the form by hand.".into());
    evaluator.rounding = Some(Rounding {
        points: 1000,
        domain: "the unit cube".into(),
        largest: vec![12.5e7, 0.75],
        percentile_99: vec![9.25, 0.5],
    });
    evaluator
}

/// The determinant of a matrix of nine inputs, divided by its trace, and the trace.
pub fn determinant() -> Evaluator {
    let names = [
        "m_11", "m_12", "m_13", "m_21", "m_22", "m_23", "m_31", "m_32", "m_33",
    ];
    let mut program = named(&names);
    let m = inputs(&program);
    let mut total = None;
    for column in 0..3 {
        let (next, last) = ((column + 1) % 3, (column + 2) % 3);
        let left = program.push(Multiply(m[3 + next], m[6 + last]));
        let right = program.push(Multiply(m[3 + last], m[6 + next]));
        let minor = program.push(Subtract(left, right));
        let term = program.push(Multiply(m[column], minor));
        total = Some(match total {
            Some(total) => program.push(Add(total, term)),
            None => term,
        });
    }
    let trace = program.push(Add(m[0], m[4]));
    let trace = program.push(Add(trace, m[8]));
    let total = total.expect("three columns");
    let quotient = program.push(Divide(total, trace));
    program.output("quotient", quotient);
    program.output("trace", trace);
    let mut evaluator = Evaluator::plain("determinant", optimise(&program));
    evaluator.title = "A determinant over a trace".into();
    evaluator.conditions = vec!["m_11 + m_22 + m_33 ≠ 0".into()];
    evaluator
}

/// Names that are unsafe in some language, roots, signs, constants, an input that is an output.
pub fn awkward() -> Evaluator {
    let mut program = named(&["I", "lambda", "t1", "fn", "double", "unused"]);
    let [i, lambda, t1, function, double, _] = inputs(&program)[..] else {
        panic!("six inputs");
    };
    let large = program.constant(rational((1 << 53) + 1, 7));
    let small = program.constant(rational(3, 1 << 40));
    let two = program.constant(rational(-2, 1));
    let square = program.push(Multiply(i, i));
    let other = program.push(Multiply(lambda, lambda));
    let sum = program.push(Add(square, other));
    let root = program.push(SquareRoot(sum));
    let negative = program.push(Negative(t1));
    let scaled = program.push(Multiply(negative, large));
    let offset = program.push(Add(scaled, two));
    let right = program.push(Subtract(function, double));
    let right = program.push(Subtract(offset, right));
    let tiny = program.push(Multiply(small, right));
    let nested = program.push(Divide(root, double));
    let nested = program.push(Divide(tiny, nested));
    let twice = program.push(Multiply(two, t1));
    let twice = program.push(Subtract(nested, twice));
    program.output("I", root);
    program.output("nested", twice);
    program.output("again", twice);
    program.output("same", function);
    program.output("three", small);
    let mut evaluator = Evaluator::plain("match", program);
    evaluator.title = "Awkward names and numbers".into();
    evaluator
}

/// A rod that is turned: fixed numbers and angles, sines and cosines of sums, what rests on constants
/// alone.
pub fn rod() -> Evaluator {
    let mut program = named(&[
        "r",
        "L",
        "cos_alpha_g",
        "cos_alpha_g_plus_theta_0",
        "k",
        "sin_alpha_g_plus_theta_0",
        "cos_2_beta_minus_theta_0",
    ]);
    let [r, length, turn, cosine, k, sine, other] = inputs(&program)[..] else {
        panic!("seven inputs");
    };
    let one = program.constant(rational(1, 1));
    let across = program.push(Multiply(length, cosine));
    let along = program.push(Multiply(length, sine));
    let root = program.push(SquareRoot(r));
    let above = program.push(Multiply(root, turn));
    let below = program.push(Add(r, one));
    let scale = program.push(Divide(above, below));
    let reach = program.push(Multiply(scale, across));
    let last = program.push(Multiply(k, r));
    let reach = program.push(Subtract(reach, last));
    let below = program.push(Add(scale, k));
    let height = program.push(Divide(along, below));
    let last = program.push(Multiply(scale, other));
    let height = program.push(Add(height, last));
    program.output("reach", reach);
    program.output("height", height);
    program.output("scale", scale);
    program.output("ratio", k);

    let mut evaluator = Evaluator::plain("rod", optimise(&program));
    evaluator.title = "where a turned rod ends".into();
    let angle = |name: &str, symbol: &str, description: &str, fixed| Angle {
        quantity: Quantity {
            name: name.into(),
            symbol: symbol.into(),
            unit: "rad".into(),
            description: description.into(),
        },
        fixed,
    };
    let fixed = |value: &str, text: &str| Fixed {
        value: value.parse().unwrap(),
        text: text.into(),
    };
    let turn = fixed("3/10", "α_g = 0.3");
    evaluator.angles = vec![
        angle("alpha_g", "α_g", "angle of the mass centre", Some(turn)),
        angle("theta_0", "θ_0", "turn of the section at rest", None),
        angle("beta", "β", "", None),
        angle("unused", "unused", "", None),
    ];
    let circular = |function, parts: &[(i32, &str)]| {
        let parts = parts
            .iter()
            .map(|(count, name)| (*count, (*name).to_owned()));
        Origin::Circular(Circular {
            function,
            angle: parts.collect(),
        })
    };
    // cos(0.3), closer than 2^-100.
    let cosine = "955336489125606019642310227568049898440/1000000000000000000000000000000000000000";
    let sum = [(1, "alpha_g"), (1, "theta_0")];
    let origins = [
        ("r", "1", Origin::Fixed(fixed("89/5000", "r = 0.0178"))),
        ("L", "m", Origin::Given),
        (
            "cos(α_g)",
            "1",
            Origin::Fixed(fixed(cosine, "cos(α_g) at α_g = 0.3")),
        ),
        ("cos(α_g + θ_0)", "1", circular(Function::Cosine, &sum)),
        ("k", "", Origin::Fixed(fixed("-1/3", "k = -1/3"))),
        ("sin(α_g + θ_0)", "1", circular(Function::Sine, &sum)),
        (
            "cos(2·β − θ_0)",
            "1",
            circular(Function::Cosine, &[(2, "beta"), (-1, "theta_0")]),
        ),
    ];
    for (input, (symbol, unit, origin)) in evaluator.inputs.iter_mut().zip(origins) {
        input.quantity.symbol = symbol.into();
        input.quantity.unit = unit.into();
        input.origin = origin;
    }
    evaluator.inputs[0].quantity.description = "radius of gyration".into();
    evaluator.assumptions = vec!["L > 0".into()];
    evaluator
}

/// The values of all inputs where the free ones have these.
pub fn with_fixed(evaluator: &Evaluator, free: &[f64]) -> Vec<f64> {
    let mut free = free.iter();
    let value = |input: &Input| match input.fixed() {
        Some(fixed) => fixed.value.to_f64().value(),
        None => *free.next().expect("a value for each free input"),
    };
    evaluator.inputs.iter().map(value).collect()
}

/// All of them.
pub fn all() -> Vec<Evaluator> {
    vec![quadratic_form(), determinant(), awkward(), rod()]
}
