//! Reads emitted Rust: the module by its shape, its body with `syn`.

use std::collections::BTreeSet;

use syn::{BinOp, Block, Expr, Lit, Local, Member, Pat, Stmt, Type, UnOp};

use super::body::{Door, Reading, Source, Term, Unreadable};
use super::cursor::{Cursor, is_word};
use super::literal::decimal;
use super::names::{Name, Names, quantity};
use super::reader::Reader;
use super::shape::{Hole, follow, taken};
use super::token::{Dialect, tokens};

/// What a module is.
const MODULE: &str = include_str!("shapes/rust.txt");

/// The signs of a body; no attribute, macro or reference can be written with them.
const SIGNS: [&str; 13] = [
    "=", ";", "+", "-", "*", "/", ".", ",", "::", ":", "(", ")", "{",
];

/// How deep brackets and signs may be nested.
const DEEPEST: usize = 64;

/// How many tokens a value may have.
const LONGEST: usize = 1_000;

/// Modules of a crate.
pub(super) const READER: Reader = Reader {
    ending: "rs",
    read: |texts, names| {
        let (reading, door) = texts.read("rs", |text| read(text, names))?;
        Ok((
            vec![(texts.place("rs", "_body"), reading)],
            (texts.place("rs", "Inputs::from"), door),
        ))
    },
};

/// Reads a module: structures with exactly the fields of the evaluator, and the functions on them.
///
/// # Errors
///
/// [`Unreadable`] at the first token that is not as it must be, and for the first statement of the body
/// that is no assignment of a value.
fn read(text: &str, names: &mut Names) -> Result<(Reading, Door), Unreadable> {
    let tokens = tokens(text, Dialect::Rust)?;
    let mut cursor = Cursor::new(&tokens);
    let mut taken = taken(MODULE, Dialect::Rust, names)?;
    // What a variable would be taken for in a pattern.
    taken.extend(["Err", "None", "Ok", "Some"].map(String::from));
    let (mut reading, mut door) = (Reading::default(), Door::default());
    follow(
        MODULE,
        Dialect::Rust,
        names,
        &mut cursor,
        &mut |hole, names, cursor| {
            let line = cursor.line();
            let unreadable = |reason| Unreadable { line, reason };
            match hole {
                Hole::Body => {
                    reading = body(&block(text, cursor)?, names, &taken).map_err(unreadable)?;
                }
                Hole::Door => {
                    door = door_body(&block(text, cursor)?, names, &taken).map_err(unreadable)?;
                }
                _ => return Err(cursor.refuse("one body")),
            }
            Ok(())
        },
    )?;
    Ok((reading, door))
}

/// Everything before the brace that ends the function, if it is not too deep for a parser.
fn block(text: &str, cursor: &mut Cursor<'_, '_>) -> Result<Block, Unreadable> {
    let line = cursor.line();
    let start = cursor.token().map_or(text.len(), |token| token.start);
    let (mut braces, mut parentheses, mut signs, mut length) = (0_usize, 0_usize, 0, 0);
    loop {
        let Some(token) = cursor.token() else {
            return Err(cursor.refuse("the end of the body"));
        };
        match token.text {
            "}" if braces == 0 => break,
            "}" => braces -= 1,
            "{" => braces += 1,
            "(" => parentheses += 1,
            ")" => parentheses = parentheses.saturating_sub(1),
            word if is_word(word) || word.starts_with(|first: char| first.is_ascii_digit()) => {}
            sign if SIGNS.contains(&sign) => {}
            _ => return Err(cursor.refuse("a statement")),
        }
        signs = if token.text == "-" { signs + 1 } else { 0 };
        let is_behind_value = token.text == ";" || (token.text == "," && parentheses == 0);
        length = if is_behind_value { 0 } else { length + 1 };
        if braces + parentheses + signs > DEEPEST || length > LONGEST {
            return Err(cursor.refuse("an expression that is shorter and less deep"));
        }
        cursor.advance();
    }
    let end = cursor.token().map_or(text.len(), |token| token.start);
    syn::parse_str(&format!("{{{}}}", &text[start..end])).map_err(|error| Unreadable {
        line,
        reason: error.to_string(),
    })
}

/// Reads the statements of a body; why they are none, otherwise.
fn body(block: &Block, names: &Names, taken: &BTreeSet<String>) -> Result<Reading, String> {
    let mut reading = Reading::default();
    let fields = statements(block, names, "Outputs", |local| {
        assignment(local, "inputs", &names.inputs, taken, &mut reading)
    })?;
    for (name, value) in fields {
        let Some(output) = quantity(&names.outputs, &name) else {
            return Err(format!("`{name}` is no output"));
        };
        let value = term(value).map_err(|reason| format!("{reason} in `{name}`"))?;
        reading.outputs.push((output.to_string(), value));
    }
    Ok(reading)
}

/// Reads the statements of the function that takes angles.
fn door_body(block: &Block, names: &Names, taken: &BTreeSet<String>) -> Result<Door, String> {
    let mut door = Door::default();
    let fields = statements(block, names, "Inputs", |local| {
        assignment(local, "angles", &names.asked, taken, &mut door.angles)
    })?;
    for (name, value) in fields {
        let Some(input) = quantity(&names.inputs, &name) else {
            return Err(format!("`{name}` is no input"));
        };
        let source =
            source(value, &names.asked).map_err(|reason| format!("{reason} in `{name}`"))?;
        door.inputs.push((input.to_string(), source));
    }
    Ok(door)
}

/// `angles.m`, `(alpha + beta).cos()`
fn source(expression: &Expr, asked: &[Name]) -> Result<Source, String> {
    if let Some(field) = field_of(expression, "angles") {
        let name = quantity(asked, &field);
        return name
            .map(|name| Source::Given(name.to_string()))
            .ok_or(format!("`{field}`"));
    }
    match expression {
        Expr::MethodCall(call) if call.args.is_empty() && call.turbofish.is_none() => {
            let angle = term(&call.receiver)?;
            match call.method.to_string().as_str() {
                "cos" => Ok(Source::Cosine(angle)),
                "sin" => Ok(Source::Sine(angle)),
                name => Err(format!("a call of `{name}`")),
            }
        }
        _ => Err("what is neither given nor a sine or cosine".into()),
    }
}

/// Reads `let` by `let`, and gives the fields of the structure at the end.
fn statements<'b>(
    block: &'b Block,
    names: &Names,
    kind: &str,
    mut read: impl FnMut(&Local) -> Result<(), String>,
) -> Result<Vec<(String, &'b Expr)>, String> {
    let Some((last, statements)) = block.stmts.split_last() else {
        return Err("an empty body".into());
    };
    for statement in statements {
        let Stmt::Local(local) = statement else {
            return Err("a statement that is no `let`".into());
        };
        read(local)?;
    }
    let Stmt::Expr(Expr::Struct(returned), None) = last else {
        return Err("the body does not end in a structure".into());
    };
    let wanted = format!("{}{kind}", names.type_prefix());
    if returned.rest.is_some() || !returned.path.is_ident(&wanted) {
        return Err(format!("the body does not end in a structure `{wanted}`"));
    }
    let fields = returned.fields.iter().map(|field| match &field.member {
        Member::Named(name) => Ok((name.to_string(), &field.expr)),
        Member::Unnamed(_) => Err("a field without a name".to_string()),
    });
    fields.collect()
}

/// `let t1 = a * b;`, `let alpha: f64 = 0.5;`
fn assignment(
    local: &Local,
    argument: &str,
    names: &[Name],
    taken: &BTreeSet<String>,
    reading: &mut Reading,
) -> Result<(), String> {
    let pattern = match &local.pat {
        Pat::Type(typed) if argument == "angles" && is_double(&typed.ty) => typed.pat.as_ref(),
        pattern => pattern,
    };
    let variable = match pattern {
        Pat::Ident(name) if name.by_ref.is_none() && name.mutability.is_none() => {
            name.ident.to_string()
        }
        _ => return Err("a pattern that is no plain variable".into()),
    };
    if taken.contains(&variable) {
        return Err(format!("`{variable}` gets another meaning"));
    }
    let Some(init) = local.init.as_ref().filter(|init| init.diverge.is_none()) else {
        return Err(format!("`{variable}` has no plain value"));
    };
    match field_of(&init.expr, argument) {
        Some(field) => reading
            .load(names, &field, variable, 0)
            .map_err(|unreadable| unreadable.reason),
        None => {
            let value = term(&init.expr).map_err(|reason| format!("{reason} in `{variable}`"))?;
            reading.assignments.push((variable, value));
            Ok(())
        }
    }
}

/// Whether a type is that of doubles.
fn is_double(kind: &Type) -> bool {
    matches!(kind, Type::Path(path) if path.path.is_ident("f64"))
}

/// `m` of `inputs.m`
fn field_of(expression: &Expr, argument: &str) -> Option<String> {
    let Expr::Field(field) = expression else {
        return None;
    };
    let (Expr::Path(base), Member::Named(name)) = (field.base.as_ref(), &field.member) else {
        return None;
    };
    base.path.is_ident(argument).then(|| name.to_string())
}

fn term(expression: &Expr) -> Result<Term, String> {
    let boxed = |expression: &Expr| Ok::<_, String>(Box::new(term(expression)?));
    match expression {
        Expr::Paren(inner) => term(&inner.expr),
        Expr::Path(path) => match path.path.get_ident() {
            Some(name) => Ok(Term::Name(name.to_string())),
            None => Err("a path that is no variable".into()),
        },
        Expr::Lit(literal) => match &literal.lit {
            Lit::Float(number) => decimal(&number.to_string())
                .map(Term::Number)
                .ok_or_else(|| format!("the number {number}")),
            _ => Err("a literal that is no floating-point number".into()),
        },
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
            Ok(Term::Negative(boxed(&unary.expr)?))
        }
        Expr::Binary(binary) => {
            let (left, right) = (boxed(&binary.left)?, boxed(&binary.right)?);
            match binary.op {
                BinOp::Add(_) => Ok(Term::Add(left, right)),
                BinOp::Sub(_) => Ok(Term::Subtract(left, right)),
                BinOp::Mul(_) => Ok(Term::Multiply(left, right)),
                BinOp::Div(_) => Ok(Term::Divide(left, right)),
                _ => Err("an operator that is not one of + − · /".into()),
            }
        }
        Expr::MethodCall(call) if call.turbofish.is_none() => {
            let receiver = boxed(&call.receiver)?;
            let arguments: Vec<&Expr> = call.args.iter().collect();
            match (call.method.to_string().as_str(), arguments.as_slice()) {
                ("multiply_add", [factor, summand]) => Ok(Term::Add(
                    Box::new(Term::Multiply(receiver, boxed(factor)?)),
                    boxed(summand)?,
                )),
                ("square_root", []) => Ok(Term::SquareRoot(receiver)),
                (name, _) => Err(format!("a call of `{name}`")),
            }
        }
        Expr::Call(call) => constant(call),
        _ => Err("an expression that is no arithmetic".into()),
    }
}

/// `T::constant(2.0)`
fn constant(call: &syn::ExprCall) -> Result<Term, String> {
    let Expr::Path(function) = call.func.as_ref() else {
        return Err("a call of what is no function".into());
    };
    let segments = function.path.segments.iter();
    let segments: Vec<String> = segments.map(|segment| segment.ident.to_string()).collect();
    let arguments: Vec<&Expr> = call.args.iter().collect();
    match (segments.as_slice(), arguments.as_slice()) {
        ([of, name], [value]) if of == "T" && name == "constant" => match term(value)? {
            number @ Term::Number(_) => Ok(number),
            Term::Negative(inner) if matches!(*inner, Term::Number(_)) => Ok(Term::Negative(inner)),
            _ => Err("a constant that is no literal".into()),
        },
        _ => Err(format!("a call of `{}`", segments.join("::"))),
    }
}
