//! What is shown as text in Python that SymPy runs.
//!
//! Every name becomes a symbol of the document's spelling in ASCII, and a variable that Python allows.
//! SymPy's own functions stand behind its name, so that `S`, `I` or `gamma` are free for a document.

use sextic_codegen::language::python::KEYWORDS;

use crate::algebra::number::{Integer, Rational};
use crate::derivation::shown::Shown;
use crate::language::notation::Notation;
use crate::language::syntax::{BinaryOperator, Expression, Name, Node};

use super::shown::left;

/// The functions that SymPy calls otherwise than a document, or has at all.
const FUNCTIONS: [(&str, &str); 3] = [
    ("cos", "sympy.cos"),
    ("sin", "sympy.sin"),
    ("sqrt", "sympy.sqrt"),
];

/// Writes what an expression is as a script; `is_imaginary` knows the root of −1.
pub fn shown(shown: &Shown, is_imaginary: &dyn Fn(&Name) -> bool) -> String {
    let mut script = Script {
        symbols: Vec::new(),
        is_imaginary,
    };
    let entries = shown.entries.iter();
    let entries: Vec<String> = entries.map(|own| script.written(&own.factored)).collect();
    let value = match entries.as_slice() {
        [only] => only.clone(),
        _ => matrix(&entries, shown.columns),
    };
    let symbols = script.symbols.iter();
    let symbols = symbols.map(|(symbol, name)| format!("{name} = sympy.Symbol(\"{symbol}\")\n"));
    let symbols: String = symbols.collect();
    let left = script.free(&title(shown));
    format!("import sympy\n\n{symbols}{left} = {value}\n")
}

/// What the value is called: as it is asked for, if that is a name or an entry.
fn title(shown: &Shown) -> String {
    let left = left(shown);
    match &left.node {
        Node::Name(_) | Node::Index(..) => Notation::Ascii.expression(&left),
        _ => "value".to_string(),
    }
}

/// A matrix of entries that are written row by row.
fn matrix(entries: &[String], columns: usize) -> String {
    let rows = entries.chunks(columns.max(1));
    let rows: Vec<String> = rows
        .map(|row| format!("    [{}],\n", row.join(", ")))
        .collect();
    format!("sympy.Matrix([\n{}])", rows.concat())
}

/// A script, as far as it is known.
struct Script<'s> {
    /// Symbols as SymPy shows them, and the variables that hold them.
    symbols: Vec<(String, String)>,
    is_imaginary: &'s dyn Fn(&Name) -> bool,
}

impl Script<'_> {
    fn written(&mut self, expression: &Expression) -> String {
        Notation::Ascii.expression(&self.in_python(expression))
    }

    /// The same, such that its ASCII notation is what Python must read.
    fn in_python(&mut self, expression: &Expression) -> Expression {
        if let Some(symbol) = self.symbol(expression) {
            return Expression::name(symbol);
        }
        match &expression.node {
            Node::Negative(inner) => {
                Expression::made(Node::Negative(Box::new(self.in_python(inner))))
            }
            Node::Binary(operator, left, right) => {
                let (left, right) = (self.in_python(left), self.in_python(right));
                Expression::binary(*operator, exact_left(*operator, left), right)
            }
            Node::Call {
                function,
                order,
                arguments,
            } => self.call(function, *order, arguments),
            Node::Number(number) => exact(number),
            _ => expression.clone(),
        }
    }

    fn call(&mut self, function: &Name, order: u32, arguments: &[Expression]) -> Expression {
        let mut arguments: Vec<Expression> =
            arguments.iter().map(|own| self.in_python(own)).collect();
        let own = FUNCTIONS.iter().find(|(name, _)| *name == function.ascii);
        let called = match (own, function.ascii.as_str()) {
            (Some((_, called)), _) => (*called).to_string(),
            (None, "angle") => {
                // The other way round than ours.
                arguments.reverse();
                "sympy.atan2".to_string()
            }
            (None, _) => {
                let name = Expression::made(match order {
                    0 => Node::Name(function.clone()),
                    _ => Node::Derivative(function.clone(), order),
                });
                format!("sympy.Function(\"{}\")", Notation::Ascii.expression(&name))
            }
        };
        Expression::call(spelled(&called), 0, arguments)
    }

    /// The variable of what is no more than a symbol.
    fn symbol(&mut self, expression: &Expression) -> Option<Name> {
        if let Node::Name(name) = &expression.node
            && (self.is_imaginary)(name)
        {
            return Some(spelled("sympy.I"));
        }
        let symbol = match &expression.node {
            // Rates: no normal form has another part that is neither an operation nor a call.
            Node::Number(_) | Node::Negative(_) | Node::Binary(..) => return None,
            Node::Call { function, .. } if function.ascii != "dt" => return None,
            _ => Notation::Ascii.expression(expression),
        };
        Some(spelled(&self.variable(symbol)))
    }

    /// The variable of a symbol; the same one each time.
    fn variable(&mut self, symbol: String) -> String {
        if let Some((_, known)) = self.symbols.iter().find(|(own, _)| *own == symbol) {
            return known.clone();
        }
        let variable = self.free(&symbol);
        self.symbols.push((symbol, variable.clone()));
        variable
    }

    /// A name like this one that Python allows and that nothing else has.
    fn free(&self, name: &str) -> String {
        let is_part = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
        let mut free = name.replace(|letter| !is_part(letter), "_");
        // `dt(x)` is `dt_x`.
        free.truncate(free.trim_end_matches('_').len());
        let is_taken = |name: &String| {
            let is_known = self.symbols.iter().any(|(_, own)| own == name);
            is_known || name == "sympy" || KEYWORDS.contains(&name.as_str())
        };
        while is_taken(&free) {
            free.push('_');
        }
        free
    }
}

/// A name as it is.
fn spelled(name: &str) -> Name {
    Name::with_ascii(name, name)
}

/// A number that Python does not round.
fn exact(number: &Rational) -> Expression {
    if number.is_int() {
        return Expression::number(number.clone());
    }
    let (above, below) = (number.numerator().clone(), number.denominator().clone());
    let parts = vec![
        Expression::number(Rational::from(above)),
        Expression::number(Rational::from(Integer::from(below))),
    ];
    Expression::call(spelled("sympy.Rational"), 0, parts)
}

/// A dividend or base: Python would divide whole numbers itself, and round.
fn exact_left(operator: BinaryOperator, left: Expression) -> Expression {
    let mut is_number = matches!(operator, BinaryOperator::Divide | BinaryOperator::Power);
    left.visit(&mut |part| {
        is_number &= !matches!(part.node, Node::Name(_) | Node::Call { .. });
    });
    match is_number {
        true => Expression::call(spelled("sympy.S"), 0, vec![left]),
        false => left,
    }
}
