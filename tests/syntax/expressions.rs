//! How expressions are read and written.

use proptest::prelude::*;
use sextic::algebra::number::Rational;
use sextic::language::expression_parser::parse_expression;
use sextic::language::notation::Notation;
use sextic::language::syntax::{
    BinaryOperator, Comparison, Expression, Name, Node, Place, Relation, Replacement,
};

fn parsed(text: &str) -> Expression {
    parse_expression(text).unwrap_or_else(|error| panic!("{text}: {}", error.message))
}

fn written(text: &str, notation: Notation) -> String {
    notation.expression(&parsed(text))
}

#[test]
fn operators_bind_as_in_mathematics() {
    for (text, bracketed) in [
        ("a + b*c", "a + (b*c)"),
        ("a - b - c", "(a - b) - c"),
        ("a/b*c", "(a/b)*c"),
        ("a/b/c", "(a/b)/c"),
        ("-a^2", "-(a^2)"),
        ("-a*b", "(-a)*b"),
        ("-a + b", "(-a) + b"),
        ("--a", "-(-a)"),
        ("a*-b^c", "a*(-(b^c))"),
        ("a^b^c", "a^(b^c)"),
        ("a**b**c", "a^(b^c)"),
        ("a^-b^c", "a^(-(b^c))"),
        ("a^-b*c", "(a^(-b))*c"),
        ("a²^c", "(a^2)^c"),
        ("a^b²", "a^(b^2)"),
        ("-a²", "-(a^2)"),
        ("M⁻¹", "M^(-1)"),
        ("x¹⁰", "x^10"),
        ("a^M[1]", "a^(M[1])"),
        ("M²[1, 2]", "(M^2)[1, 2]"),
        ("a + b at rest", "(a + b) at rest"),
        ("a at rest at still", "(a at rest) at still"),
        ("a − b × c · d", "a - ((b*c)*d)"),
        ("√(x)²", "(sqrt(x))^2"),
        ("|A|·|B|", "det(A)*det(B)"),
        ("||A|*b|", "det(det(A)*b)"),
        ("ẍ", "dt(dt(x))"),
        ("θ̇_d²", "dt(theta_d)^2"),
        ("C_D'(a)", "C_D′(a)"),
        ("C_D''", "C_D″"),
        ("a (b)", "a(b)"),
        ("(\na\n+ b)", "a + b"),
    ] {
        assert_eq!(parsed(text), parsed(bracketed), "{text}");
    }
}

#[test]
fn numbers_are_exact() {
    let quarter = Rational::from(1) / Rational::from(4);
    assert_eq!(parsed("0.250").node, Node::Number(quarter));
    assert_ne!(parsed("1/4"), parsed("0.25"));
}

#[test]
fn unicode_is_for_people() {
    for (text, expected) in [
        ("rho*D*U/(8*m)", "ρ·D·U/(8·m)"),
        ("dt(x)^2 + dt(dt(theta_d))", "ẋ² + θ̈_d"),
        ("dt(dt(dt(x)))", "dt(ẍ)"),
        ("dt(x + y)", "dt(x + y)"),
        ("sqrt(1 - e^-2)", "√(1 − e⁻²)"),
        ("det(M - lambda*I)", "|M − λ·I|"),
        ("a - (b - c)", "a − (b − c)"),
        ("a - (b*c)", "a − b·c"),
        ("(a*b)/c", "a·b/c"),
        ("a*(b/c)", "a·(b/c)"),
        ("a + (-b)", "a + (−b)"),
        ("a + -b*c", "a + (−b·c)"),
        ("-b*c + a", "−b·c + a"),
        ("-(b*c)", "−(b·c)"),
        ("(a^b)^c", "(a^b)^c"),
        ("(-a)^2", "(−a)²"),
        ("a^(b + 1)", "a^(b + 1)"),
        ("x^0.5", "x^0.5"),
        ("(a at rest) + b", "(a at rest) + b"),
        ("[a, b at rest; c, d][1, 2]", "[a, b at rest; c, d][1, 2]"),
        ("a at (x = 1, dt(y) = 0)", "a at (x = 1, ẏ = 0)"),
        ("C_D'' - C_D'(alpha)", "C_D″ − C_D′(α)"),
    ] {
        assert_eq!(written(text, Notation::Unicode), expected);
    }
}

#[test]
fn ascii_is_for_python() {
    for (text, expected) in [
        ("ρ·D·U/(8·m)", "rho*D*U/(8*m)"),
        ("ẋ² − λ", "dt(x)**2 - lamda"),
        ("√(1 − e⁻²)", "sqrt(1 - e**(-2))"),
        ("|M|", "det(M)"),
        ("C_D′ + C_D″(α)", "dC_D + d2C_D(alpha)"),
        ("a^b^c", "a**b**c"),
        ("S_xθ", "S_xtheta"),
    ] {
        assert_eq!(written(text, Notation::Ascii), expected);
    }
}

#[test]
fn latex_is_for_print() {
    for (text, expected) in [
        ("ρ*D*U/(8*m)", r"\frac{\rho\,D\,U}{8\,m}"),
        ("ẋ^2 + θ̈_d", r"\dot{x}^{2} + \ddot{\theta}_{d}"),
        ("ω_n*2", r"\omega_{n} \cdot 2"),
        (
            "sin(θ)^2 - cos(2*θ)",
            r"\sin^{2}\left(\theta\right) - \cos\left(2\,\theta\right)",
        ),
        ("(a/b)^2", r"\left(\frac{a}{b}\right)^{2}"),
        ("a^(b + 1)", "a^{b + 1}"),
        ("-(a*b)", r"-a\,b"),
        ("a - (b + c)", r"a - \left(b + c\right)"),
        ("a*(-b)", r"a\,\left(-b\right)"),
        (
            "[a, b; c, d]",
            r"\begin{bmatrix} a & b \\ c & d \end{bmatrix}",
        ),
        ("M_a[1, 2]", r"\left(M_{a}\right)_{1,2}"),
        ("v[2]^2 - v_2", r"\left(v\right)_{2}^{2} - v_{2}"),
        ("ẋ[2] - ẋ_2", r"\left(\dot{x}\right)_{2} - \dot{x}_{2}"),
        ("C_D′ + C_D″(α)", r"C_{D}' + C_{D}''\left(\alpha\right)"),
        ("d(L, ẋ)", r"\frac{\partial L}{\partial \dot{x}}"),
        (
            "dt(x + y)",
            r"\frac{\mathrm{d}}{\mathrm{d}t}\left(x + y\right)",
        ),
        ("inverse(M)*transpose(v)", r"M^{-1}\,v^{\mathsf{T}}"),
        ("√(x)", r"\sqrt{x}"),
        (
            "S_xθ + wing_area_max",
            r"S_{x\theta} + \mathit{wing}_{\mathrm{area},\mathrm{max}}",
        ),
        ("hurwitz(p)", r"\mathrm{hurwitz}\left(p\right)"),
        ("x at rest", r"\left.x\right|_{\mathrm{rest}}"),
    ] {
        assert_eq!(written(text, Notation::Latex), expected);
    }
}

#[test]
fn relations_and_numbers_are_written() {
    let relation = Relation {
        left: parsed("a"),
        comparison: Comparison::LessOrEqual,
        right: parsed("-b"),
    };
    assert_eq!(Notation::Unicode.relation(&relation), "a ≤ −b");
    assert_eq!(Notation::Ascii.relation(&relation), "a <= -b");
    assert_eq!(Notation::Latex.relation(&relation), r"a \le -b");
    let number = Rational::from(-3) / Rational::from(4);
    assert_eq!(Notation::Unicode.number(&number), "−3/4");
    assert_eq!(Notation::Ascii.number(&number), "-3/4");
    assert_eq!(Notation::Latex.number(&number), r"-\frac{3}{4}");
}

fn made(node: Node) -> Expression {
    Expression { node, span: 0..0 }
}

fn any_name() -> impl Strategy<Value = Name> {
    let words = [
        "a", "x", "M", "at", "ω_n", "θ_d", "S_xθ", "C_D", "lambda", "Λ_1", "i", "dt", "det",
    ];
    proptest::sample::select(words.to_vec()).prop_map(Name::new)
}

fn any_number() -> impl Strategy<Value = Node> {
    (0_u32..2000, 0_usize..4).prop_map(|(digits, places)| {
        let ten = Rational::from(10);
        let number = Rational::from(digits);
        Node::Number((0..places).fold(number, |number, _| number / &ten))
    })
}

fn any_expression(with_primes: bool) -> impl Strategy<Value = Expression> {
    let most_primes = if with_primes { 4_u32 } else { 0 };
    let leaf = prop_oneof![
        any_number(),
        any_name().prop_map(Node::Name),
        (any_name(), 0..=most_primes).prop_map(|(name, order)| match order {
            0 => Node::Name(name),
            _ => Node::Derivative(name, order),
        }),
    ]
    .prop_map(made);
    leaf.prop_recursive(6, 60, 4, move |inner| {
        let boxed = inner.clone().prop_map(Box::new);
        let list = proptest::collection::vec(inner.clone(), 1..3);
        let operator = prop_oneof![
            Just(BinaryOperator::Add),
            Just(BinaryOperator::Subtract),
            Just(BinaryOperator::Multiply),
            Just(BinaryOperator::Divide),
            Just(BinaryOperator::Power),
        ];
        let replacement = (inner.clone(), inner.clone())
            .prop_map(|(target, value)| Replacement { target, value });
        let place = prop_oneof![
            any_name().prop_map(Place::named),
            proptest::collection::vec(replacement, 1..3).prop_map(Place::Replacements),
        ];
        let function = prop_oneof![Just(Name::new("sqrt")), any_name()];
        prop_oneof![
            boxed.clone().prop_map(Node::Negative),
            (operator, boxed.clone(), boxed.clone())
                .prop_map(|(operator, left, right)| Node::Binary(operator, left, right)),
            (function, 0..=most_primes, list.clone()).prop_map(|(function, order, arguments)| {
                Node::Call {
                    function,
                    order,
                    arguments,
                }
            }),
            proptest::collection::vec(list.clone(), 1..3)
                .prop_map(Node::Matrix)
                .prop_filter("a row of rows is not read", |node| !is_row_of_rows(node)),
            (boxed.clone(), list).prop_map(|(base, indices)| Node::Index(base, indices)),
            (boxed, place).prop_map(|(inner, place)| Node::At(inner, place)),
        ]
        .prop_map(made)
    })
}

/// What other languages mean as rows of one matrix: `[[a, b], [c, d]]`.
fn is_row_of_rows(node: &Node) -> bool {
    let is_row = |own: &Expression| matches!(&own.node, Node::Matrix(rows) if rows.len() == 1);
    matches!(node, Node::Matrix(rows) if rows.len() == 1 && rows[0].len() > 1 && rows[0].iter().all(is_row))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn what_is_written_in_unicode_is_read_back(expression in any_expression(true)) {
        let text = Notation::Unicode.expression(&expression);
        prop_assert_eq!(parsed(&text), expression, "{}", text);
    }

    #[test]
    fn what_is_written_in_ascii_is_read_back(expression in any_expression(false)) {
        let text = Notation::Ascii.expression(&expression);
        prop_assert!(text.is_ascii());
        prop_assert_eq!(parsed(&text), expression, "{}", text);
    }

    #[test]
    fn latex_brackets_are_balanced(expression in any_expression(true)) {
        let text = Notation::Latex.expression(&expression);
        prop_assert_eq!(text.matches('{').count(), text.matches('}').count());
        prop_assert_eq!(text.matches(r"\left").count(), text.matches(r"\right").count());
    }
}
