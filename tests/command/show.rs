//! `sextic show`, and `show` as a statement, as a user sees them.

use std::process::Command;
use std::sync::OnceLock;

use serde_json::{Value, json};

use super::{block, document, sextic};

const STATEMENTS: &str = "
parameter x, y : 1 > 0
angle α
c := a/b
M := [x, 0; sin(α)^2, y/x]
square(q) := q^2
show (x^2 - y^2)/(x + 1) \"a quotient\"
claim [one]: c == a/b
show M";

/// The document, which is written once: tests run beside each other.
fn path() -> &'static str {
    static PATH: OnceLock<String> = OnceLock::new();
    PATH.get_or_init(|| {
        let path = document("show.md", &block(STATEMENTS));
        path.to_str().expect("a path").to_owned()
    })
}

/// The exit status, standard output and standard error.
fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = sextic(arguments);
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

fn show(expression: &str) -> (Option<i32>, String, String) {
    run(&["show", expression, "--document", path(), "--width", "80"])
}

fn shown(expression: &str) -> Value {
    let (status, out, errors) =
        run(&["show", expression, "--document", path(), "--format", "json"]);
    assert_eq!((status, errors.as_str()), (Some(0), ""), "{expression}");
    serde_json::from_str(&out).expect("JSON")
}

#[test]
fn an_expression_is_shown_with_all_that_it_is() {
    let (status, out, errors) = show("(x^2 - y^2)/c");
    assert_eq!((status, errors.as_str()), (Some(0), ""));
    let shown = out.split_once("\n\n").expect("two paragraphs").1;
    assert_eq!(
        shown,
        "  normal form  (b·x² − b·y²)/a
  factored     b·(x − y)·(x + y)/a
  unit         a pure number; 2 terms
  conditions   b ≠ 0 and a ≠ 0
"
    );
}

#[test]
fn programs_read_every_member() {
    let value = shown("square(c) + x");
    assert_eq!(value["expression"], "square(c) + x");
    assert_eq!([&value["rows"], &value["columns"]], [1, 1]);
    assert_eq!(value["conditions"], json!(["b != 0"]));
    let entry = &value["entries"][0];
    assert_eq!(entry["normal_form"], "(a**2 + b**2*x)/b**2");
    assert_eq!(entry["unit"], "1");
    assert_eq!([&entry["terms"], &entry["terms_below"]], [2, 1]);
    let matrix = shown("M");
    assert_eq!([&matrix["rows"], &matrix["columns"]], [2, 2]);
    let entries = matrix["entries"].as_array().expect("entries");
    assert_eq!(entries.len(), 4);
    assert_eq!(entries[1]["unit"], Value::Null);
    assert_eq!([&entries[2]["row"], &entries[2]["column"]], [2, 1]);
    assert_eq!(entries[2]["factored"], "sin(alpha)**2");
}

#[test]
fn an_expression_may_begin_with_a_sign_and_names_tell_their_meaning() {
    assert_eq!(shown("-a")["entries"][0]["unit"], "m");
    let (_, out, _) = run(&["show", "m"]);
    assert!(out.starts_with("m\nmass per unit length\n"), "{out}");
}

#[test]
fn what_is_wrong_is_marked_in_the_expression() {
    for (expression, said) in [
        ("a + xx", ["EXPR:1:5", "`xx`", "Help"]),
        ("a + x", ["EXPR:1:1", "unit", "Help"]),
        (
            "a +",
            [
                "EXPR:1:4",
                "expected an expression",
                "complete the expression",
            ],
        ),
        ("square", ["EXPR:1:1", "needs arguments", "square(…)"]),
        ("1/(a - a)", ["EXPR:1:3", "identically 0", "Help"]),
        (
            "",
            [
                "EXPR:1:1",
                "expected an expression",
                "complete the expression",
            ],
        ),
        ("a\u{1b}[31m", ["EXPR:1:2", "no meaning", "Error"]),
    ] {
        let (status, out, errors) = show(expression);
        assert_eq!((status, out.as_str()), (Some(2), ""), "{expression}");
        let plain = anstream::adapter::strip_str(&errors).to_string();
        for said in said {
            assert!(plain.contains(said), "{expression}: no {said}:\n{plain}");
        }
        assert!(!plain.contains('\u{1b}'), "{plain:?}");
    }
}

#[test]
fn what_rests_on_a_mistake_is_not_shown() {
    let text = block("c := a + unknown\nd := 2*c");
    let path = document("show-mistaken.md", &text);
    let path = path.to_str().expect("a path");
    let (status, out, errors) = run(&["show", "d + a", "--document", path]);
    assert_eq!((status, out.as_str()), (Some(2), ""));
    let plain = anstream::adapter::strip_str(&errors).to_string();
    assert!(plain.contains("builds on `d`, and so on `c`"), "{plain}");
    // What does not rest on it is shown, and the document is wrong all the same.
    let (status, out, _) = run(&["show", "a", "--document", path]);
    assert_eq!(status, Some(2));
    assert!(out.starts_with("a\n"), "{out}");
}

fn audited(format: &str) -> String {
    let (status, out, errors) = run(&["audit", "--format", format, "--width", "80", path()]);
    assert_eq!((status, errors.as_str()), (Some(0), ""), "{format}");
    out
}

#[test]
fn a_document_shows_in_every_format_and_claims_nothing() {
    let text = audited("text");
    let places = ["a quotient", "[one]", "a 2×2 matrix", "All"].map(|words| text.find(words));
    assert!(places[..3].is_sorted() && places[0].is_some(), "{text}");
    assert!(text.contains("The one verdict is as"), "{text}");
    assert!(text.contains("[2, 1] −cos(α)² + 1"), "{text}");
    assert!(audited("markdown").contains("## Shown"));
    assert!(audited("latex").contains("\\subsection*{Shown}"));
    let json: Value = serde_json::from_str(&audited("json")).expect("JSON");
    let shown = &json["documents"][0]["shown"];
    assert_eq!(shown[0]["description"], "a quotient");
    assert_eq!(
        shown[0]["entries"][0]["factored"],
        "(x - y)*(x + y)/(x + 1)"
    );
    assert_eq!(shown[1]["rows"], 2);
    assert_eq!(
        json["documents"][0]["claims"].as_array().map(Vec::len),
        Some(1)
    );
}

#[cfg(feature = "stability")]
#[test]
fn the_page_shows_too() {
    let page = std::path::PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("shown.html");
    let out = page.to_str().expect("a path");
    let (status, _, errors) = run(&["report", path(), "--out", out]);
    assert_eq!((status, errors.as_str()), (Some(0), ""));
    let page = std::fs::read_to_string(page).expect("a page");
    assert!(page.contains("a 2×2 matrix") && page.contains("<dt>normal form</dt>"));
}

#[test]
fn a_statement_that_shows_what_has_no_value_is_a_mistake() {
    let text = block("show a + 1\nshow unknown\nclaim [one]: a == a");
    let path = document("show-wrong.md", &text);
    let (status, out, errors) = run(&["audit", path.to_str().expect("a path")]);
    assert_eq!(status, Some(2));
    let plain = anstream::adapter::strip_str(&errors).to_string();
    assert!(plain.contains("show-wrong.md:5:6"), "{plain}");
    assert!(plain.contains("show-wrong.md:6:6"), "{plain}");
    assert!(out.contains("✓ holds"), "{out}");
}

/// Names that Python needs itself, or SymPy has, beside everything that a normal form is made of.
const ODD: &str = "
imaginary i
complex λ : 1
angle β
parameter pass, class, sympy, S, E : 1 > 0
coordinate y_d : 1
function C at β : 1
odd := 1/2*pass*class^2/(3*sympy) + 2/3*S*sqrt(1 + E)
mixed := [dt(y_d)*C', dt(dt(y_d))*C(2*β); 0, i*λ*cos(β)]";

/// Where numbers stand for names, in the words of a document and of SymPy.
const POINT: [(&str, &str); 7] = [
    ("pass", "2"),
    ("class", "3"),
    ("sympy", "5/7"),
    ("S", "1/11"),
    ("E", "8"),
    ("a", "13"),
    ("b", "17/3"),
];

#[test]
fn sympy_runs_what_it_is_given() {
    let found = Command::new("python3")
        .args(["-c", "import sympy"])
        .output();
    if !found.is_ok_and(|output| output.status.success()) {
        eprintln!("SKIPPED: python3 -c 'import sympy' does not run here");
        return;
    }
    let path = document("show-odd.md", &block(ODD));
    let path = path.to_str().expect("a path");
    let ask = |expression: &str, format| {
        let (status, out, errors) =
            run(&["show", expression, "--document", path, "--format", format]);
        assert_eq!((status, errors.as_str()), (Some(0), ""), "{expression}");
        out
    };
    let places: Vec<String> = POINT
        .iter()
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    for expression in [
        "odd",
        "class",
        "-1/2",
        "-(a - b)^2/(3*class*a^2) + 1/pass^3",
        "2/3*pass - E/7",
    ] {
        let script = ask(expression, "sympy");
        let wanted = ask(
            &format!("({expression}) at ({})", places.join(", ")),
            "json",
        );
        let wanted: Value = serde_json::from_str(&wanted).expect("JSON");
        let wanted = wanted["entries"][0]["normal_form"]
            .as_str()
            .expect("a text")
            .to_owned();
        let check = format!(
            "value = list(globals().values())[-1]
point = {{sympy.Symbol(name): sympy.Rational(number) for name, number in {POINT:?}}}
found, wanted = sympy.S(value).subs(point), sympy.sympify({wanted:?})
assert not found.has(sympy.Float) and found == wanted, (value, found, wanted)
"
        );
        let script = script + &check;
        let output = Command::new("python3").args(["-c", &script]).output();
        let output = output.expect("it runs");
        let messages = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{script}\n{messages}");
    }
}

#[test]
fn latex_and_sympy_are_text_to_paste() {
    let path = document("show-odd.md", &block(ODD));
    let path = path.to_str().expect("a path");
    for (expression, format, expected) in [
        ("a/(2*b)", "latex", "\\frac{a}{2\\,b} = \\frac{a}{2\\,b}\n"),
        (
            "a/(2*b)",
            "sympy",
            "import sympy\n\na = sympy.Symbol(\"a\")\nb = sympy.Symbol(\"b\")\nvalue = a/(2*b)\n",
        ),
        (
            "pass/3*dt(y_d)",
            "sympy",
            "import sympy\n\npass_ = sympy.Symbol(\"pass\")\ndt_y_d = sympy.Symbol(\"dt(y_d)\")\n\
             value = pass_*dt_y_d/3\n",
        ),
        (
            "mixed",
            "sympy",
            "import sympy\n\ndt_y_d = sympy.Symbol(\"dt(y_d)\")\ndC = sympy.Symbol(\"dC\")\n\
             dt_dt_y_d = sympy.Symbol(\"dt(dt(y_d))\")\nbeta = sympy.Symbol(\"beta\")\n\
             lamda = sympy.Symbol(\"lamda\")\nmixed = sympy.Matrix([\n    [dt_y_d*dC, \
             dt_dt_y_d*sympy.Function(\"C\")(2*beta)],\n    [0, \
             sympy.I*lamda*sympy.cos(beta)],\n])\n",
        ),
        ("1/3", "sympy", "import sympy\n\nvalue = sympy.S(1)/3\n"),
        (
            "[a, 0; 1, b]",
            "latex",
            "\\begin{bmatrix} a & 0 \\\\ 1 & b \\end{bmatrix} = \\begin{bmatrix} a & 0 \\\\ 1 & b \\end{bmatrix}\n",
        ),
    ] {
        let (status, out, errors) =
            run(&["show", expression, "--document", path, "--format", format]);
        assert_eq!((status, errors.as_str()), (Some(0), ""), "{expression}");
        assert_eq!(out, expected, "{expression}");
    }
}
