//! Reads emitted Rust with `syn`.

use syn::{BinOp, Block, Expr, File, Item, Lit, Member, Pat, Stmt, UnOp};

use super::{Reading, Term, Unreadable, decimal};

/// Reads the body of the evaluator of this name: the function `<name>_body` of one argument `inputs`.
///
/// # Errors
///
/// [`Unreadable`] where the text is no Rust, or anything but assignments and a returned structure.
pub fn read(text: &str, name: &str) -> Result<Reading, Unreadable> {
    let file: File = syn::parse_file(text).map_err(|error| Unreadable::new(error.to_string()))?;
    let wanted = format!("{name}_body");
    let mut found = file.items.iter().filter_map(|item| match item {
        Item::Fn(function) if function.sig.ident == wanted => Some(function),
        _ => None,
    });
    match (found.next(), found.next()) {
        (Some(function), None) => body(&function.block),
        (None, _) => Err(Unreadable::new(format!("there is no function `{wanted}`"))),
        (Some(_), Some(_)) => Err(Unreadable::new(format!(
            "there are two functions `{wanted}`"
        ))),
    }
}

fn body(block: &Block) -> Result<Reading, Unreadable> {
    let mut reading = Reading::default();
    let Some((last, statements)) = block.stmts.split_last() else {
        return Err(Unreadable::new("an empty body"));
    };
    for statement in statements {
        let Stmt::Local(local) = statement else {
            return Err(Unreadable::new("a statement that is no `let`"));
        };
        let name = variable(&local.pat)?;
        let Some(init) = local.init.as_ref().filter(|init| init.diverge.is_none()) else {
            return Err(Unreadable::new(format!("`{name}` has no plain value")));
        };
        match input_field(&init.expr) {
            Some(field) if reading.assignments.is_empty() => reading.inputs.push((field, name)),
            Some(_) => return Err(Unreadable::new("an input is read behind the first value")),
            None => reading.assignments.push((name, term(&init.expr)?)),
        }
    }
    let Stmt::Expr(Expr::Struct(returned), None) = last else {
        return Err(Unreadable::new("the body does not end in a structure"));
    };
    if returned.rest.is_some() {
        return Err(Unreadable::new(
            "the returned structure takes fields from another",
        ));
    }
    for field in &returned.fields {
        let Member::Named(name) = &field.member else {
            return Err(Unreadable::new("a field without a name"));
        };
        reading.outputs.push((name.to_string(), term(&field.expr)?));
    }
    Ok(reading)
}

fn variable(pattern: &Pat) -> Result<String, Unreadable> {
    match pattern {
        Pat::Ident(name) if name.by_ref.is_none() && name.mutability.is_none() => {
            Ok(name.ident.to_string())
        }
        _ => Err(Unreadable::new("a pattern that is no plain variable")),
    }
}

/// `m` of `inputs.m`
fn input_field(expression: &Expr) -> Option<String> {
    let Expr::Field(field) = expression else {
        return None;
    };
    let (Expr::Path(base), Member::Named(name)) = (field.base.as_ref(), &field.member) else {
        return None;
    };
    base.path.is_ident("inputs").then(|| name.to_string())
}

fn term(expression: &Expr) -> Result<Term, Unreadable> {
    let boxed = |expression: &Expr| Ok(Box::new(term(expression)?));
    match expression {
        Expr::Paren(inner) => term(&inner.expr),
        Expr::Path(path) => match path.path.get_ident() {
            Some(name) => Ok(Term::Name(name.to_string())),
            None => Err(Unreadable::new("a path that is no variable")),
        },
        Expr::Lit(literal) => match &literal.lit {
            Lit::Float(number) if number.suffix().is_empty() => decimal(number.base10_digits())
                .map(Term::Number)
                .ok_or_else(|| Unreadable::new(format!("the number {number}"))),
            _ => Err(Unreadable::new(
                "a literal that is no plain floating-point number",
            )),
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
                _ => Err(Unreadable::new("an operator that is not one of + − · /")),
            }
        }
        Expr::MethodCall(call) => {
            let receiver = boxed(&call.receiver)?;
            let arguments: Vec<&Expr> = call.args.iter().collect();
            match (call.method.to_string().as_str(), arguments.as_slice()) {
                ("multiply_add", [factor, summand]) => Ok(Term::Add(
                    Box::new(Term::Multiply(receiver, boxed(factor)?)),
                    boxed(summand)?,
                )),
                ("sqrt" | "square_root", []) => Ok(Term::SquareRoot(receiver)),
                (name, _) => Err(Unreadable::new(format!("a call of `{name}`"))),
            }
        }
        Expr::Call(call) => constant(call),
        _ => Err(Unreadable::new("an expression that is no arithmetic")),
    }
}

/// `T::constant(2.0)`
fn constant(call: &syn::ExprCall) -> Result<Term, Unreadable> {
    let Expr::Path(function) = call.func.as_ref() else {
        return Err(Unreadable::new("a call of what is no function"));
    };
    let segments: Vec<String> = function
        .path
        .segments
        .iter()
        .map(|segment| segment.ident.to_string())
        .collect();
    let arguments: Vec<&Expr> = call.args.iter().collect();
    match (segments.as_slice(), arguments.as_slice()) {
        ([of, name], [value]) if of == "T" && name == "constant" => match term(value)? {
            number @ Term::Number(_) => Ok(number),
            Term::Negative(inner) if matches!(*inner, Term::Number(_)) => Ok(Term::Negative(inner)),
            _ => Err(Unreadable::new("a constant that is no literal")),
        },
        _ => Err(Unreadable::new(format!(
            "a call of `{}`",
            segments.join("::")
        ))),
    }
}
