//! What each form of statement says, and where statements and blocks begin and end.

use sextic::language::diagnostic::SourceFile;
use sextic::language::document::{Document, parse_document, parse_document_with};
use sextic::language::markdown::blocks;
use sextic::language::notation::Notation;
use sextic::language::syntax::{
    EvaluatorBody, Expression, Label, Name, Part, Replacement, Spanned, Statement, StatementKind,
    SystemBody,
};

fn document(text: &str) -> Document {
    parse_document(&SourceFile::new("document.md", text))
        .unwrap_or_else(|errors| panic!("{text}: {errors:?}"))
}

fn statements(block: &str) -> Vec<String> {
    let document = document(&format!("# Title\n\n```sextic\n{block}\n```\n"));
    document.statements.iter().map(summary).collect()
}

fn names(names: &[Spanned<Name>]) -> String {
    let names: Vec<_> = names.iter().map(|name| name.value.ascii.clone()).collect();
    names.join(" ")
}

fn expressions(expressions: &[Expression]) -> String {
    let written: Vec<_> = expressions
        .iter()
        .map(|one| Notation::Ascii.expression(one))
        .collect();
    written.join(", ")
}

fn replacements(replacements: &[Replacement]) -> String {
    let written = replacements.iter().map(|one| {
        let (target, value) = (&one.target, &one.value);
        format!(
            "{} <- {}",
            Notation::Ascii.expression(target),
            Notation::Ascii.expression(value)
        )
    });
    written.collect::<Vec<_>>().join(", ")
}

fn label(label: &Label) -> String {
    format!("{}/{:?}/{}", label.text, label.equation, label.id)
}

/// Everything that a statement says, in one line.
fn summary(statement: &Statement) -> String {
    match &statement.kind {
        StatementKind::Import { path } => format!("import {}", path.value),
        StatementKind::Parameter {
            names: declared,
            unit,
            sign,
            description,
        } => {
            format!(
                "parameter {} | {} | {sign:?} | {description:?}",
                names(declared),
                unit.value
            )
        }
        StatementKind::Complex {
            names: declared,
            unit,
            description,
        } => {
            format!(
                "complex {} | {} | {description:?}",
                names(declared),
                unit.value
            )
        }
        StatementKind::Angle {
            names: declared,
            description,
        } => {
            format!("angle {} | {description:?}", names(declared))
        }
        StatementKind::Coordinate {
            names: declared,
            unit,
            description,
        } => {
            format!(
                "coordinate {} | {} | {description:?}",
                names(declared),
                unit.value
            )
        }
        StatementKind::Function {
            names: declared,
            reference,
            unit,
            description,
        } => {
            let reference = Notation::Ascii.expression(reference);
            format!(
                "function {} | {reference} | {} | {description:?}",
                names(declared),
                unit.value
            )
        }
        StatementKind::Evaluator {
            label: called,
            name,
            body,
            approximated,
            conditions,
            description,
        } => {
            let approximated = approximated.as_ref().map(|own| {
                format!(
                    " approximates {:?} of {}{}{}",
                    own.quantities,
                    own.system.value.ascii,
                    own.place.as_ref().map_or("", |_| " at a place"),
                    if own.by_roots { " by roots" } else { "" }
                )
            });
            let conditions: Vec<String> = conditions
                .iter()
                .map(|condition| format!(" where {}", Notation::Ascii.relation(condition)))
                .collect();
            let body = match body {
                EvaluatorBody::Outputs(outputs) => {
                    let written = outputs.iter().map(|(name, value)| {
                        let value = Notation::Ascii.expression(value);
                        format!("{} = {value}", name.value.ascii)
                    });
                    written.collect::<Vec<_>>().join(", ")
                }
                EvaluatorBody::Special { general, .. } => {
                    format!("special {}", general.value.ascii)
                }
            };
            let (label, name) = (label(called), &name.value.ascii);
            let conditions = approximated.unwrap_or_default() + &conditions.concat();
            format!("evaluator {label} | {name} | {body}{conditions} | {description:?}")
        }
        StatementKind::System(system) => {
            let part = |part: &Part| {
                let name = part.name.as_ref();
                let name = name.map(|name| format!("{} = ", name.value.ascii));
                name.unwrap_or_default() + &Notation::Ascii.expression(&part.matrix)
            };
            let parts = |all: &[Part]| all.iter().map(part).collect::<Vec<_>>().join(", ");
            let body = match &system.body {
                SystemBody::Matrices {
                    mass,
                    damping,
                    stiffness,
                } => format!(
                    "{} | {} | {}",
                    Notation::Ascii.expression(mass),
                    parts(damping),
                    parts(stiffness)
                ),
                SystemBody::Equations { equations, .. } => {
                    format!("equations {}", Notation::Ascii.expression(equations))
                }
            };
            let (label, name) = (label(&system.label), &system.name.value.ascii);
            let coordinates = names(&system.coordinates);
            let description = &system.description;
            format!("system {label} | {name} | {body} | {coordinates} | {description:?}")
        }
        StatementKind::Imaginary { name } => format!("imaginary {}", name.value.ascii),
        StatementKind::Assume {
            relation,
            description,
        } => {
            format!(
                "assume {} | {description:?}",
                Notation::Ascii.relation(relation)
            )
        }
        StatementKind::Definition {
            names: defined,
            arguments,
            values,
        } => {
            format!(
                "define {} | {} | {}",
                names(defined),
                names(arguments),
                expressions(values)
            )
        }
        StatementKind::Substitution {
            name,
            replacements: all,
        } => {
            format!("substitution {} | {}", name.value.ascii, replacements(all))
        }
        StatementKind::Domain(all) => format!("domain {}", replacements(all)),
        StatementKind::Show {
            expression,
            description,
        } => {
            let expression = Notation::Ascii.expression(expression);
            format!("show {expression} | {description:?}")
        }
        StatementKind::Assertion {
            expectation,
            label: named,
            relation,
            order,
            description,
            ..
        } => {
            let relation = Notation::Ascii.relation(relation);
            let order = order
                .as_ref()
                .map(|order| format!("{} in {}", order.order.value, names(&order.small)));
            format!(
                "{expectation:?} {} | {relation} | {order:?} | {description:?}",
                label(named)
            )
        }
        StatementKind::Eigenpair {
            label: named,
            stiffness,
            mass,
            value,
            vector,
            description,
        } => {
            let all = [stiffness, mass, value, vector].map(|one| Notation::Ascii.expression(one));
            format!(
                "eigenpair {} | {} | {description:?}",
                label(named),
                all.join(" | ")
            )
        }
        StatementKind::Match(matching) => {
            let powers: Vec<_> = matching.powers.iter().map(|power| power.value).collect();
            format!(
                "match {} | {} | {} | {} | {} | {} | {powers:?} | {} | {} | {:?}",
                label(&matching.label),
                matching.name.value.ascii,
                Notation::Ascii.expression(&matching.exact),
                Notation::Ascii.expression(&matching.assumed),
                matching.variable.value.ascii,
                names(&matching.unknowns),
                expressions(&matching.neglected),
                names(&matching.small),
                matching.description,
            )
        }
    }
}

#[test]
fn every_form_says_what_it_says() {
    for (text, expected) in [
        (r#"import "other.md""#, "import other.md"),
        (
            r#"show F_θ at rest "the moment""#,
            r#"show F_theta at rest | Some("the moment")"#,
        ),
        ("show (a + b)*c", "show (a + b)*c | None"),
        ("show := a", "define show |  | a"),
        ("show(x) := x^2", "define show | x | x**2"),
        (
            r#"system (9) section: mass M damping structural = C_s, wind = C_a stiffness K in x, y "two""#,
            r#"system 9/Some("9")/9 | section | M | structural = C_s, wind = C_a | K | x y | Some("two")"#,
        ),
        (
            "system [a] one: mass m stiffness k + l in x",
            "system a/None/a | one | m |  | k + l | x | None",
        ),
        (
            "system (9) section: equations [F; G] in x, y at rest",
            r#"system 9/Some("9")/9 | section | equations [F; G] | x y | None"#,
        ),
        (
            "evaluator (21) f: r = a, s = b approximates real parts of section at (x = 1) where a > 0",
            r#"evaluator 21/Some("21")/21 | f | r = a, s = b approximates RealParts of section at a place where a > 0 | None"#,
        ),
        (
            "evaluator (21) f: r = a, s = b approximates real parts of section at p by roots where a > 0",
            r#"evaluator 21/Some("21")/21 | f | r = a, s = b approximates RealParts of section at a place by roots where a > 0 | None"#,
        ),
        (
            "evaluator (21) f: e at p approximates eigenvalues of section",
            r#"evaluator 21/Some("21")/21 | f | special e approximates Eigenvalues of section | None"#,
        ),
        (
            r#"parameter m : kg/m > 0 "mass per unit length""#,
            r#"parameter m | kg/m | Some(Positive) | Some("mass per unit length")"#,
        ),
        (
            "parameter a, b : N*s/m^2 ≥ 0",
            "parameter a b | N*s/m^2 | Some(NonNegative) | None",
        ),
        (
            "parameter a : 1 ≠ 0",
            "parameter a | 1 | Some(NonZero) | None",
        ),
        (
            "parameter a : 1 < 0",
            "parameter a | 1 | Some(Negative) | None",
        ),
        (
            "parameter a : 1 <= 0",
            "parameter a | 1 | Some(NonPositive) | None",
        ),
        (
            r#"complex λ, S_xθ as S_xt : 1/s "eigenvalues""#,
            r#"complex lamda S_xt | 1/s | Some("eigenvalues")"#,
        ),
        ("complex := 3", "define complex |  | 3"),
        (
            "complex(z) := z[1] + i*z[2]",
            "define complex | z | z[1] + i*z[2]",
        ),
        (
            "parameter a:kg·m²  # words",
            "parameter a | kg·m² | None | None",
        ),
        (
            r#"parameter S_xθ as S_xt, S_yθ as S_yt : 1 "…""#,
            r#"parameter S_xt S_yt | 1 | None | Some("…")"#,
        ),
        (
            r#"angle α_g, θ_0 "…""#,
            r#"angle alpha_g theta_0 | Some("…")"#,
        ),
        (
            r#"coordinate x, y : m "…""#,
            r#"coordinate x y | m | Some("…")"#,
        ),
        (
            r#"function C_D, C_L at α_0 + θ_0 : 1 "…""#,
            r#"function C_D C_L | alpha_0 + theta_0 | 1 | Some("…")"#,
        ),
        ("imaginary i", "imaginary i"),
        (r#"assume L_g < r "…""#, r#"assume L_g < r | Some("…")"#),
        ("X := a + b", "define X |  | a + b"),
        ("u, v := [1, 2], 3", "define u v |  | [1, 2], 3"),
        (
            "R(β, γ) := cos(β)*γ",
            "define R | beta gamma | cos(beta)*gamma",
        ),
        ("claim := 3", "define claim |  | 3"),
        ("match, angle := 3, 4", "define match angle |  | 3, 4"),
        ("ill := formed - 1", "define ill |  | formed - 1"),
        (
            "substitution rest: ẋ = 0, dt(y) = 0",
            "substitution rest | dt(x) <- 0, dt(y) <- 0",
        ),
        (
            "claim (8, printed): a == b",
            r#"Holds 8, printed/Some("8")/8-printed | a == b | None | None"#,
        ),
        (
            r#"refute [centre of rotation]: a <= b at rest "why""#,
            r#"Refuted centre of rotation/None/centre-of-rotation | a <= b at rest | None | Some("why")"#,
        ),
        (
            r#"approximate (A.1): a ≈ b to order 1 in ρ, b_1 "why""#,
            r#"Approximate A.1/Some("A.1")/a.1 | a == b | Some("1 in rho b_1") | Some("why")"#,
        ),
        (
            "ill-formed (9): a > b",
            r#"IllFormed 9/Some("9")/9 | a > b | None | None"#,
        ),
        (
            r#"eigenpair (15, mode 1) of K, M: value ω_n^2 vector [0; 1; 0] "…""#,
            r#"eigenpair 15, mode 1/Some("15")/15-mode-1 | K | M | omega_n**2 | [0; 1; 0] | Some("…")"#,
        ),
        (
            "match (20) closed_form: p with q in λ unknown b_1, b_2 at λ^5, λ³, λ, 1 \
             neglect b_1*b_2, det(C) small ρ \"…\"",
            r#"match 20/Some("20")/20 | closed_form | p | q | lamda | b_1 b_2 | [5, 3, 1, 0] | b_1*b_2, det(C) | rho | Some("…")"#,
        ),
        (
            "match (20) f: p with q in x unknown b at x",
            r#"match 20/Some("20")/20 | f | p | q | x | b | [1] |  |  | None"#,
        ),
    ] {
        assert_eq!(statements(text), [expected], "{text}");
    }
}

#[test]
fn a_declared_spelling_is_known_from_then_on() {
    let text =
        "before := S_xθ\nparameter S_xθ as S_xt : 1\nafter := S_xθ + S_xtheta + S_xt + dt(S_xθ)";
    let said = statements(text);
    assert_eq!(said[0], "define before |  | S_xtheta");
    assert_eq!(said[2], "define after |  | S_xt + S_xt + S_xt + dt(S_xt)");

    let imported = document(&format!("```sextic\n{text}\n```\n")).aliases;
    let other = SourceFile::new("other.md", "```sextic\nX := S_xθ\n```\n");
    let document = parse_document_with(&other, &imported).unwrap();
    assert_eq!(summary(&document.statements[0]), "define X |  | S_xt");
}

#[test]
fn an_ascii_spelling_is_a_name_like_others() {
    let text = "parameter L as lambda : 1\nX := L + lamda + lambda + λ";
    assert_eq!(
        statements(text)[1],
        "define X |  | lamda + lamda + lamda + lamda"
    );
}

#[test]
fn a_statement_ends_with_its_line_unless_the_next_is_indented() {
    for (text, expected) in [
        ("X := a\nY := b", 2),
        ("X := [(a)]\nassume a > b", 2),
        ("X := a\n\n\n   + b\nY := b", 2),
        ("X := a\n# words\n\t+ b", 1),
        ("M := [x,\nangle,\nmatch; claim\n]\nY := b", 2),
        ("M := [a,\nb;\n\nc, d]\nY := b", 2),
        ("   X := a\n   + b", 1),
    ] {
        assert_eq!(statements(text).len(), expected, "{text:?}");
    }
}

#[test]
fn a_document_without_a_statement_is_an_error() {
    for text in [
        "",
        "# words",
        "```sextic\n```\n",
        "```sextic\n# a comment\n```\n",
    ] {
        let errors = parse_document(&SourceFile::new("document.md", text)).unwrap_err();
        let codes: Vec<_> = errors.iter().map(|error| error.kind.code()).collect();
        assert_eq!(codes, ["no-block"], "{text:?}");
    }
}

#[test]
fn an_open_bracket_spoils_only_its_own_statement() {
    for text in [
        "X := (a\nY := b",
        "X := [a\nclaim (1): a == b",
        "X := f(a\nangle b",
    ] {
        let text = format!("```sextic\n{text}\nZ := +\n```\n");
        let errors = parse_document(&SourceFile::new("document.md", text.as_str())).unwrap_err();
        let places: Vec<_> = errors
            .iter()
            .map(|error| &text[error.span.clone()])
            .collect();
        assert_eq!(places.len(), 2, "{text}");
        assert!(places[0] == "(" || places[0] == "[");
        assert_eq!(places[1], "+");
    }
}

#[test]
fn spans_are_places_in_the_file() {
    let text = "# Größe\n\nWords.\n\n```sextic\nX := α + b  # c\n```\n\n~~~sextic\nclaim (1): (X) == α^2\n~~~\n";
    let document = document(text);
    let said: Vec<_> = document
        .statements
        .iter()
        .map(|one| &text[one.span.clone()])
        .collect();
    assert_eq!(said, ["X := α + b", "claim (1): (X) == α^2"]);
    let StatementKind::Assertion {
        relation, label, ..
    } = &document.statements[1].kind
    else {
        panic!("an assertion");
    };
    assert_eq!(&text[relation.left.span.clone()], "(X)");
    assert_eq!(&text[relation.right.span.clone()], "α^2");
    assert_eq!(&text[label.span.clone()], "(1)");
    assert_eq!(document.title.as_deref(), Some("Größe"));
}

#[test]
fn blocks_are_found_as_a_markdown_reader_finds_them() {
    for (text, contents) in [
        ("```sextic\na\n```\n", vec!["a\n"]),
        ("```sextic\na\n```", vec!["a\n"]),
        ("```sextic\n```\n", vec![""]),
        ("````sextic\na\n````\n", vec!["a\n"]),
        ("~~~ sextic\na\n~~~~~~  \n\nwords\n", vec!["a\n"]),
        ("```sextic\r\na\r\n```\r\n", vec!["a\r\n"]),
        ("```sextant\na\n```\n", vec![]),
        (
            "> ```python\n> a\n> ```\n\n- b\n\n  ```rust\n  c\n  ```\n",
            vec![],
        ),
        ("````markdown\n```sextic\na\n```\n````\n", vec![]),
        ("<!-- a -->\n", vec![]),
        ("a ```sextic``` b\n", vec![]),
        (
            "```sextic\na\n```\nwords\n```sextic\nb\nc\n```\n",
            vec!["a\n", "b\nc\n"],
        ),
    ] {
        let (found, errors) = blocks(text);
        assert!(errors.is_empty(), "{text:?}: {errors:?}");
        let found: Vec<_> = found
            .blocks
            .iter()
            .map(|lines| text[lines.clone()].trim_start_matches('\n'))
            .collect();
        assert_eq!(found, contents, "{text:?}");
    }
    assert_eq!(
        blocks("A *b* `c`\n===\n\n# d\n").0.title.as_deref(),
        Some("A b c")
    );
}

#[test]
fn a_block_that_would_be_passed_over_is_an_error() {
    for language in [
        "sextix",
        "Sextic",
        "sextics",
        "{.sextic}",
        "sextic,ignore",
        "sextic more words",
    ] {
        let (_, errors) = blocks(&format!("```{language}\na\n```\n"));
        let codes: Vec<_> = errors.iter().map(|error| error.kind.code()).collect();
        assert_eq!(codes, ["syntax"], "{language}");
    }
}

#[test]
fn blocks_begin_at_the_margin() {
    for text in [
        "  ```sextic\n  a\n  ```\n",
        "- ```sextic\n  a\n  ```\n",
        "> ```sextic\n> a\n> ```\n",
    ] {
        let (_, errors) = blocks(text);
        let codes: Vec<_> = errors.iter().map(|error| error.kind.code()).collect();
        assert_eq!(codes, ["unsupported"], "{text:?}");
    }
}

#[test]
fn fences_that_do_not_pair_up_are_errors() {
    for text in [
        "```sextic",
        "```sextic\n",
        "```sextic\na\n",
        "```sextic\na\n``\n",
        "````sextic\na\n```\n",
        "```sextic\na\n~~~\n",
        "```sextic\na\n``` words\n",
        "```python\nwords\n",
        "> ```sextic\n> a\n\nwords\n",
        "```python\na\n\n```sextic\nb\n```\n",
    ] {
        let (_, errors) = blocks(text);
        let codes: Vec<_> = errors.iter().map(|error| error.kind.code()).collect();
        assert_eq!(codes, ["unbalanced-fence"], "{text:?}");
    }
}
