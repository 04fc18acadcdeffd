//! C99: a header and a source for each evaluator.

use std::collections::BTreeSet;

use serde::Serialize;

use super::documentation::{self, Comments};
use super::literal::Decimal;
use super::statements::{self, Binding, Body, Notation, Sign, Text};
use super::{Error, Field, File, Named, render};
use crate::evaluator::Evaluator;
use crate::optimiser::prune::prune;

const HEADER: &str = include_str!("../../templates/c/header.h.tera");
const SOURCE: &str = include_str!("../../templates/c/source.c.tera");
const BOUNDED: &str = include_str!("../../templates/c/sextic_bounded.h");

/// Keywords of C up to 2023 and of C++ (the header is for both), and macros that a compiler or the
/// included headers define.
const RESERVED: [&str; 128] = [
    "EOF",
    "HUGE_VAL",
    "I",
    "INFINITY",
    "NAN",
    "NULL",
    "_Bool",
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "char",
    "char16_t",
    "char32_t",
    "char8_t",
    "class",
    "co_await",
    "co_return",
    "co_yield",
    "compl",
    "complex",
    "concept",
    "const",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "continue",
    "decltype",
    "default",
    "delete",
    "do",
    "double",
    "dynamic_cast",
    "else",
    "enum",
    "errno",
    "explicit",
    "export",
    "extern",
    "fabs",
    "false",
    "float",
    "for",
    "fortran",
    "friend",
    "goto",
    "i386",
    "if",
    "imaginary",
    "inline",
    "inputs",
    "int",
    "isfinite",
    "isnan",
    "linux",
    "long",
    "math_errhandling",
    "mutable",
    "namespace",
    "new",
    "nextafter",
    "noexcept",
    "noreturn",
    "not",
    "not_eq",
    "nullptr",
    "offsetof",
    "operator",
    "or",
    "or_eq",
    "outputs",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "requires",
    "restrict",
    "return",
    "sextic_bounded",
    "sextic_exact",
    "short",
    "signbit",
    "signed",
    "size_t",
    "sizeof",
    "sqrt",
    "static",
    "static_assert",
    "static_cast",
    "struct",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "typeof",
    "typeof_unqual",
    "union",
    "unix",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
    "sextic_add",
    "sextic_divide",
    "sextic_multiply",
    "sextic_negative",
    "sextic_subtract",
];

/// Functions that a program has already.
const FUNCTIONS: [&str; 32] = [
    "abs", "acos", "asin", "atan", "cbrt", "ceil", "cos", "cosh", "erf", "exp", "floor", "fma",
    "fmax", "fmin", "fmod", "frexp", "gamma", "hypot", "j0", "j1", "ldexp", "log", "main", "modf",
    "pow", "round", "sin", "sinh", "tan", "tanh", "y0", "y1",
];

const COMMENTS: Comments = Comments {
    prose: harmless,
    code: harmless,
    heading: |heading| format!("{heading}:"),
};

/// Neither begins nor ends a comment, and is no trigraph.
fn harmless(text: &str) -> String {
    text.replace("*/", "* /")
        .replace("/*", "/ *")
        .replace("??", "? ?")
}

/// The usual signs.
#[derive(Clone, Copy, Debug)]
pub struct Infix;

impl Notation for Infix {
    const WIDTH: usize = 72;

    fn literal(&self, decimal: &Decimal) -> Text {
        statements::plain_literal(decimal)
    }

    fn binary(&self, sign: Sign, left: &Text, right: &Text) -> Text {
        statements::infix(sign, left, right)
    }

    fn negative(&self, operand: &Text) -> Text {
        statements::prefix(operand)
    }

    fn square_root(&self, operand: &Text) -> Text {
        Text::new(format!("sqrt({})", operand.text), Binding::Atom)
    }
}

/// Calls of the functions of `sextic_bounded.h`.
#[derive(Clone, Copy, Debug)]
pub struct Calls;

impl Notation for Calls {
    const WIDTH: usize = 72;

    fn literal(&self, decimal: &Decimal) -> Text {
        Text::new(format!("sextic_exact({})", decimal.text), Binding::Atom)
    }

    fn binary(&self, sign: Sign, left: &Text, right: &Text) -> Text {
        let function = match sign {
            Sign::Add => "sextic_add",
            Sign::Subtract => "sextic_subtract",
            Sign::Multiply => "sextic_multiply",
            Sign::Divide => "sextic_divide",
        };
        let text = format!("{function}({}, {})", left.text, right.text);
        Text::new(text, Binding::Atom)
    }

    fn negative(&self, operand: &Text) -> Text {
        Text::new(format!("sextic_negative({})", operand.text), Binding::Atom)
    }

    fn square_root(&self, operand: &Text) -> Text {
        Text::new(
            format!("sextic_square_root({})", operand.text),
            Binding::Atom,
        )
    }
}

#[derive(Serialize)]
struct Module {
    header: Vec<String>,
    guard: String,
    function: String,
    inputs: Vec<Field>,
    outputs: Vec<Field>,
    body: Vec<String>,
    bounded_body: Vec<String>,
    documentation: Vec<String>,
}

/// The headers and sources, in no particular order.
///
/// # Errors
///
/// If a name is no identifier or occurs twice, or a constant is beyond the doubles.
pub fn emit(evaluators: &[Evaluator]) -> Result<Vec<File>, Error> {
    let mut files = vec![File {
        path: "sextic_bounded.h".to_owned(),
        text: BOUNDED.to_owned(),
    }];
    let all = Named::all(evaluators, &RESERVED, &FUNCTIONS)?;
    // There is one space of names.
    let mut taken = BTreeSet::new();
    for named in &all {
        for suffix in [
            "",
            "_batch",
            "_body",
            "_bounds",
            "_inputs",
            "_outputs",
            "_slices",
            "_slices_mut",
            "_with_bound",
        ] {
            let name = format!("{}{suffix}", named.function);
            if taken.contains(&name) || name.starts_with("sextic_") {
                return Err(Error::Twice(name));
            }
            taken.insert(name);
        }
    }
    for (evaluator, named) in evaluators.iter().zip(&all) {
        let module = module(evaluator, named)?;
        for (template, ending) in [(HEADER, "h"), (SOURCE, "c")] {
            files.push(File {
                path: format!("{}.{ending}", named.function),
                text: render(template, &module)?,
            });
        }
    }
    Ok(files)
}

fn module(evaluator: &Evaluator, named: &Named) -> Result<Module, Error> {
    let program = prune(&evaluator.program);
    let names = &named.inputs.names;
    let used = super::used(evaluator, &program, names);

    let infix = statements::statements(&program, names, &named.values, &Infix)?;
    let opening = used
        .iter()
        .map(|name| format!("const double {name} = inputs->{name};"));
    let mut body: Vec<String> = opening.collect();
    body.extend(lines("double", &infix));
    body.extend(result(&named.function, "outputs", named, &infix));

    let calls = statements::statements(&program, names, &named.values, &Calls)?;
    let opening = used
        .iter()
        .map(|name| format!("const sextic_bounded {name} = sextic_exact(inputs->{name});"));
    let mut bounded_body: Vec<String> = opening.collect();
    bounded_body.extend(lines("sextic_bounded", &calls));
    bounded_body.extend(result(&named.function, "bounds", named, &calls));

    let (mut inputs, mut outputs) = named.fields(evaluator, &COMMENTS);
    for field in inputs.iter_mut().chain(&mut outputs) {
        field.documentation = block(&field.documentation);
    }
    Ok(Module {
        header: super::spaced(super::header(evaluator, &COMMENTS)),
        guard: format!("SEXTIC_{}_H", named.function.to_ascii_uppercase()),
        function: named.function.clone(),
        inputs,
        outputs,
        body,
        bounded_body,
        documentation: super::spaced(documentation::function(
            evaluator,
            names,
            &named.outputs.names,
            &COMMENTS,
        )),
    })
}

fn lines(kind: &str, body: &Body) -> Vec<String> {
    let statements = body.statements.iter();
    statements
        .map(|statement| format!("const {kind} {} = {};", statement.name, statement.text))
        .collect()
}

fn result(function: &str, kind: &str, named: &Named, body: &Body) -> Vec<String> {
    let mut lines = vec![format!("return ({function}_{kind}){{")];
    let fields = named.outputs.names.iter().zip(&body.results);
    lines.extend(fields.map(|(name, text)| format!("    .{name} = {text},")));
    lines.push("};".to_owned());
    lines
}

/// Lines as a comment.
fn block(lines: &[String]) -> Vec<String> {
    let last = lines.len().saturating_sub(1);
    let line = |(place, line): (usize, &String)| {
        let start = if place == 0 { "/*" } else { " *" };
        let end = if place == last { " */" } else { "" };
        format!("{start} {line}{end}")
    };
    lines.iter().enumerate().map(line).collect()
}
