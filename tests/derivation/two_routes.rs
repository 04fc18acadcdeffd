//! What the first route finds and the second contradicts is undecided and told as a fault; what the
//! second does not see is not refuted.
//!
//! The routes are made to disagree by giving the second one another relation than the first one was
//! asked about.

use std::collections::BTreeMap;

use sextic::algebra::budget::Budget;
use sextic::algebra::generator::Generator;
use sextic::algebra::sign::Signs;
use sextic::derivation::assertion::{Assertion, Finding};
use sextic::derivation::elaboration::Elaborator;
use sextic::derivation::matching::Matched;
use sextic::derivation::scope::{Meaning, SymbolKind};
use sextic::language::diagnostic::{DiagnosticKind, SourceFile};
use sextic::language::document::parse_document;
use sextic::language::expression_parser::parse_expression;
use sextic::language::syntax::{Name, Spanned, StatementKind};
use sextic::language::unit::Unit;
use sextic::points::Salt;
use sextic::verdict::claim::{Claim, Verdict};
use sextic::verdict::judge::Judge;
use sextic::verdict::judge::matching::MatchingCheck;

use super::block;

/// Numbers that no text of these tests was written for.
const SALT: Salt = [[0, 1], [2, 3]];

/// An elaborator that knows the numbers x, y, λ and b and the angular coordinate θ.
fn elaborator() -> Elaborator {
    let mut elaborator = Elaborator::new(Budget::new(1_000_000));
    let constant = |name: &str| {
        (
            Generator::Constant { name: name.into() },
            SymbolKind::Parameter,
        )
    };
    let theta = Generator::Coordinate {
        name: "theta".into(),
        order: 0,
        angular: true,
    };
    for (name, (generator, kind)) in [
        ("x", constant("x")),
        ("y", constant("y")),
        ("λ", constant("lamda")),
        ("b", constant("b")),
        ("θ", (theta, SymbolKind::AngularCoordinate)),
    ] {
        let symbol = elaborator.ring.symbol(generator).unwrap();
        let name = Spanned {
            value: Name::new(name),
            span: 0..0,
        };
        let unit = Unit::one();
        let meaning = Meaning::Symbol { symbol, unit, kind };
        elaborator.scope.declare(&name, meaning, None).unwrap();
    }
    elaborator
}

fn statement(text: &str) -> StatementKind {
    let source = SourceFile::new("test.md", block(text));
    let document = parse_document(&source).unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
    document.statements[0].kind.clone()
}

fn assertion(text: &str) -> Assertion {
    let StatementKind::Assertion {
        expectation,
        label,
        relation,
        difference,
        order,
        description,
    } = statement(text)
    else {
        panic!("{text} asserts nothing");
    };
    Assertion {
        label,
        expectation,
        relation,
        difference,
        order,
        description,
        line: 1,
        span: 0..0,
    }
}

/// What the second route makes of what the first one found.
fn judged_by_points(
    elaborator: &Elaborator,
    findings: &[Finding],
    matchings: &[MatchingCheck],
) -> Result<Vec<Claim>, DiagnosticKind> {
    let judge = Judge::new(
        &elaborator.scope,
        &[],
        BTreeMap::<String, Signs>::new(),
        SALT,
    );
    let (claims, wrong) = judge.judge_all(findings, matchings);
    match wrong.into_iter().flatten().next() {
        Some(error) => Err(error.kind),
        None => Ok(claims),
    }
}

/// What becomes of a finding about one assertion when another one is evaluated at points: the verdict, and
/// whether a fault of the tool is told.
fn judged(found: &str, evaluated: &str) -> (Verdict, bool) {
    let mut elaborator = elaborator();
    let mut finding = elaborator.find(&assertion(found)).expect(found);
    finding.assertion = assertion(evaluated);
    let claims = judged_by_points(&elaborator, &[finding], &[]).expect(found);
    (claims[0].verdict, claims[0].fault)
}

#[test]
fn a_disagreement_is_told_as_a_fault() {
    for (found, verdict, evaluated) in [
        (
            "claim (1): (x + y)^2 == x^2 + 2*x*y + y^2",
            Verdict::Holds,
            "claim (1): (x + y)^2 == x^2 + y^2",
        ),
        (
            "claim (1): x/x == 1",
            Verdict::HoldsWhere,
            "claim (1): x/x == 2",
        ),
        (
            "claim (1): [x, y] == [x, y]",
            Verdict::Holds,
            "claim (1): [x, y] == [x, x]",
        ),
        ("claim (1): x^2 >= 0", Verdict::Holds, "claim (1): x^2 <= 0"),
        (
            "claim (1): x^2 + 1 > 0",
            Verdict::Holds,
            "claim (1): x^2 + 1 < 0",
        ),
        // A difference of 1 in what are numbers of six digits.
        (
            "claim (1): sin(θ)^2 + cos(θ)^2 == 1",
            Verdict::Holds,
            "claim (1): x == x + 1",
        ),
        (
            "approximate (1): sin(θ) ≈ θ to order 2 in θ",
            Verdict::Approximate,
            "approximate (1): sin(θ) ≈ 2*θ to order 2 in θ",
        ),
        // Beyond the order, nothing is compared; at the order, everything is.
        (
            "approximate (1): cos(θ) ≈ 1 - θ^2/2 to order 2 in θ",
            Verdict::Approximate,
            "approximate (1): cos(θ) ≈ 1 to order 2 in θ",
        ),
    ] {
        assert_eq!(judged(found, found), (verdict, false), "{found}");
        let outcome = judged(found, evaluated);
        assert_eq!(outcome, (Verdict::Undecided, true), "{evaluated}");
    }
}

#[test]
fn what_has_no_value_somewhere_is_a_disagreement() {
    for evaluated in [
        "0*(1/x) == 0",
        "0*(1/(x - y)) == 0",
        "0*(1/(x*(x + y)*(y + 1))) == 0",
        "0*(1/(1 + cos(θ))) == 0",
        "0*(1/sin(θ)) == 0",
        "0*sqrt(-x^2 - 1) == 0",
        "0*sqrt(x) == 0",
        "0*angle(x, y) == 0",
        "0*d(sqrt(x^2 + y^2), x) == 0",
        "0*d(angle(x, y), y) == 0",
        "0*inverse([x, y; y, x])[1, 2] == 0",
        "(0*(1/(x - y)) at (x = y)) == 0",
        "truncate(0*(1/(x + y)), [x; y], 1) == 0",
        "truncate(0*sqrt(x), [x], 1) == 0",
        // A matrix has a value where all of its entries have one.
        "[x, 1/y][1] == x",
        "trace([x, 1/y; 0, 0]) == x",
        "row([x; 1/y], 1) == x",
        "column([x, 1/y], 1) == x",
        "submatrix([x, 1/y], 1, 1) == x",
        "adjugate([0, 1/y; 0, x])[1, 1] == x",
        "adjugate([1/y]) == 1",
        "([1, 1/y; 0, 1]^0)[1, 1] == 1",
        "kernel([1, 0, 1/y; 0, 0, 0])[2, 1] == 1",
    ] {
        let outcome = judged("claim (1): x == x", &format!("claim (1): {evaluated}"));
        assert_eq!(outcome, (Verdict::Undecided, true), "{evaluated}");
    }
}

#[test]
fn what_is_not_known_is_no_disagreement() {
    for (found, verdict) in [
        // The step 1/x² finds the coefficient, which exists where x is 0.
        (
            "coefficient(λ*((x*λ)^2 + 1)/((x*λ)^2 + 1), λ, 1) == 1",
            Verdict::Holds,
        ),
        (
            "hurwitz((λ^2 + λ + 1)*((x*λ)^2 + 1)/((x*λ)^2 + 1), λ, 1) == 1",
            Verdict::Holds,
        ),
        // A root that does not move has a slope where it is 0.
        (
            "d(x*sqrt((y + 1)^2 - y^2 - 2*y - 1), y) == 0",
            Verdict::Holds,
        ),
        ("x/x == 1", Verdict::HoldsWhere),
        ("angle(x, y) == angle(x, y)", Verdict::HoldsWhere),
    ] {
        let found = format!("claim (1): {found}");
        assert_eq!(judged(&found, &found), (verdict, false), "{found}");
    }
}

#[test]
fn what_is_no_polynomial_has_no_coefficients() {
    for evaluated in [
        "coefficient(λ^2 + 1/λ, λ, 2) == 1",
        "coefficient(1/(1 + λ), λ, 0) == 1",
        "hurwitz(λ^2 + 2*λ + 3 + 1/λ, λ, 1) == 2",
    ] {
        let (verdict, _) = judged("claim (1): x == x", &format!("claim (1): {evaluated}"));
        assert_eq!(verdict, Verdict::Undecided, "{evaluated}");
    }
}

#[test]
fn nothing_is_refuted_without_a_point() {
    for (found, evaluated) in [
        ("claim (1): x == y", "claim (1): x == x"),
        ("claim (1): x > y", "claim (1): x == x"),
        ("claim (1): x == y", "claim (1): x/0 == y"),
        (
            "approximate (1): sin(θ) ≈ 2*θ to order 2 in θ",
            "approximate (1): sin(θ) ≈ θ to order 2 in θ",
        ),
    ] {
        assert_eq!(judged(found, found), (Verdict::Refuted, false), "{found}");
        assert_eq!(
            judged(found, evaluated),
            (Verdict::Undecided, false),
            "{found}"
        );
    }
}

#[test]
fn a_matching_with_wrong_residuals_is_refused() {
    let mut elaborator = elaborator();
    let text = "match (1) s: λ^2 + x*λ + y with (λ + b)*(λ + x) in λ unknown b at λ^1";
    let StatementKind::Match(matching) = statement(text) else {
        panic!("{text} matches nothing");
    };
    let matched = elaborator.match_coefficients(&matching, 1).expect(text);
    let confirm = |matched: &Matched| {
        let check = MatchingCheck::new(matched, &(0..0));
        judged_by_points(&elaborator, &[], &[check]).map(drop)
    };
    assert_eq!(confirm(&matched), Ok(()));
    assert_eq!(matched.table.len(), 3);
    for row in 0..3 {
        let mut wrong = matched.clone();
        wrong.table[row].residual = parse_expression("x").unwrap();
        assert_eq!(confirm(&wrong), Err(DiagnosticKind::Disagreement), "{row}");
    }
}
