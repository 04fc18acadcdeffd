//! What is not known becomes a condition, and each condition is listed once.

use sextic::language::notation::Notation;

use super::{audit_text, block};

/// The verdict on a claim with its conditions, in one line.
fn verdict(claim: &str) -> String {
    let declared = "parameter k, ρ : 1 > 0\nparameter x, y, z, a, b : 1\nimaginary i\nangle β\n\
                    assume sin(β) > 0\nh := x^3*y - y^4 + z\ng := x*y*z + 4";
    let text = format!("{declared}\nclaim (1): {claim}");
    let audit = audit_text(&block(&text)).unwrap_or_else(|message| panic!("{message}"));
    let claim = &audit.claims[0];
    let conditions = claim.conditions.iter();
    let shown = conditions.map(|one| Notation::Unicode.expression(&one.expression));
    let shown: Vec<String> = shown.collect();
    format!("{}: {}", claim.verdict.text(), shown.join(", "))
}

#[test]
fn roots_of_unknown_sign_have_a_condition() {
    for (claim, expected) in [
        ("sqrt(a/b)^2 == a/b", "holds where: a·b"),
        ("sqrt(1/a) == sqrt(a)/a", "holds where: a"),
        ("sqrt(2*k/(ρ*a))^2 == 2*k/(ρ*a)", "holds where: a"),
        ("sqrt(x^4) == x^2", "holds: "),
        ("sqrt(x^5) == x^2*sqrt(x)", "holds where: x"),
        ("sqrt(-1/x) == -sqrt(-x)/x", "holds where: −x"),
        ("sqrt(a^3/b^5)^2 == a^3/b^5", "holds where: a·b"),
        ("sqrt(sin(β)^2) == sin(β)", "holds: "),
        ("sqrt(a/b)*b == sqrt(a*b)", "refuted: a·b"),
    ] {
        assert_eq!(verdict(claim), expected, "{claim}");
    }
}

#[test]
fn each_condition_is_listed_once() {
    let count = |claim: &str| verdict(claim).matches(", ").count() + 1;
    assert_eq!(count("x*g/(h*g) == x*(1/h)"), 2);
    assert_eq!(count("1/(h*g) + 1/g - 1/g == 1/(h*g)"), 2);
    assert_eq!(
        count("(1/(x + i*y) + 1/(x - i*y))/2*sqrt(x^2 + y^2) == x/sqrt(x^2 + y^2)"),
        1
    );
}
