//! Expressions in the words of the kernel, as the document writes them.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::number::{Integer, Rational};
use crate::language::built_in::{BuiltIn, Circular, Declared};
use crate::language::syntax::{BinaryOperator, Expression, Name, Node, Place, Replacement};

use super::name::Names;

/// Why something is not said in a certificate.
pub type Withheld = String;

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Strength {
    /// `x at […]`
    Place,
    /// `a + b`
    Sum,
    /// `a*b`
    Product,
    /// `-a`
    Sign,
    /// `a^2`
    Power,
    /// `sin a`
    Call,
    /// `a`
    Single,
}

/// A text and how tightly it holds together.
struct Text(String, Strength);

impl Text {
    fn single(text: impl Into<String>) -> Self {
        Text(text.into(), Strength::Single)
    }

    /// In brackets if it holds together less tightly than it must.
    fn within(self, least: Strength) -> String {
        if self.1 < least {
            format!("({})", self.0)
        } else {
            self.0
        }
    }
}

/// A function of the document.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its number.
    pub number: usize,
    /// Where its bare name is taken, in the words of the kernel.
    pub reference: String,
}

/// What expressions are written with.
#[derive(Clone, Debug, Default)]
pub struct Writer {
    /// The names of the document.
    pub names: Names,
    /// Its functions, by ASCII name.
    pub functions: BTreeMap<String, Function>,
    /// What is not said of names, by ASCII name.
    pub withheld: BTreeMap<String, Withheld>,
    /// Under which hypotheses arguments of functions are compared.
    pub hypotheses: String,
    /// Its constant angles, by ASCII name.
    pub angles: BTreeSet<String>,
    /// The named places that replace angles or values of functions, by ASCII name.
    pub function_places: BTreeSet<String>,
    /// The degrees of polynomials, by the text of `p` and of its variable.
    pub degrees: Vec<(Expression, Expression, usize)>,
}

type Written = Result<Text, Withheld>;

impl Writer {
    /// An expression that can stand as an argument.
    ///
    /// # Errors
    ///
    /// Why it cannot be said.
    pub fn argument(&self, expression: &Expression) -> Result<String, Withheld> {
        Ok(self.text(expression)?.within(Strength::Single))
    }

    /// An expression that can stand as a side of a statement.
    ///
    /// # Errors
    ///
    /// Why it cannot be said.
    pub fn side(&self, expression: &Expression) -> Result<String, Withheld> {
        Ok(self.text(expression)?.within(Strength::Sum))
    }

    fn operand(&self, expression: &Expression, least: Strength) -> Result<String, Withheld> {
        Ok(self.text(expression)?.within(least))
    }

    fn text(&self, expression: &Expression) -> Written {
        match &expression.node {
            Node::Number(number) => Ok(rational(number)),
            Node::Name(name) => self.name(name, 0),
            Node::Derivative(name, order) => self.name(name, *order),
            Node::Negative(operand) => {
                let operand = self.operand(operand, Strength::Power)?;
                Ok(Text(format!("- {operand}"), Strength::Sign))
            }
            Node::Binary(operator, left, right) => self.binary(*operator, left, right),
            Node::Call {
                function,
                order,
                arguments,
            } => self.call(function, *order, arguments),
            Node::Matrix(rows) => {
                let rows = rows.iter().map(|row| self.list(row));
                let rows = rows.collect::<Result<Vec<_>, _>>()?;
                Ok(Text(
                    format!("blocks [{}]", rows.join("; ")),
                    Strength::Call,
                ))
            }
            Node::Index(base, indices) => self.index(base, indices),
            Node::At(inner, place) => self.at(inner, place),
        }
    }

    fn list(&self, row: &[Expression]) -> Result<String, Withheld> {
        let row = row.iter().map(|entry| self.operand(entry, Strength::Sum));
        Ok(format!(
            "[{}]",
            row.collect::<Result<Vec<_>, _>>()?.join("; ")
        ))
    }

    fn name(&self, name: &Name, order: u32) -> Written {
        if let Some(reason) = self.withheld.get(&name.ascii) {
            return Err(format!("`{name}` is withheld: {reason}"));
        }
        if order > 0 {
            let function = self.function(name)?;
            let written = format!(
                "function_ {} {order} ({})",
                function.number, function.reference
            );
            return Ok(Text(written, Strength::Call));
        }
        let known = self.names.get(&name.ascii);
        let known = known.ok_or_else(|| format!("`{name}` is no name of the certificate"))?;
        Ok(Text::single(known))
    }

    fn function(&self, name: &Name) -> Result<&Function, Withheld> {
        let function = self.functions.get(&name.ascii);
        function.ok_or_else(|| format!("`{name}` is no function of the certificate"))
    }

    fn binary(&self, operator: BinaryOperator, left: &Expression, right: &Expression) -> Written {
        let (sign, own, least) = match operator {
            BinaryOperator::Add => (" + ", Strength::Sum, Strength::Product),
            BinaryOperator::Subtract => (" - ", Strength::Sum, Strength::Product),
            BinaryOperator::Multiply => ("*", Strength::Product, Strength::Power),
            BinaryOperator::Divide => ("/", Strength::Product, Strength::Power),
            BinaryOperator::Power => return self.power(left, right),
        };
        let left = self.operand(left, own)?;
        let right = self.operand(right, least)?;
        Ok(Text(format!("{left}{sign}{right}"), own))
    }

    fn power(&self, base: &Expression, exponent: &Expression) -> Written {
        let number = constant(exponent).ok_or("an exponent that is not written as a number")?;
        let twice = number.clone() * Rational::from(2);
        if !twice.is_int() {
            return Err("an exponent that is no whole number and no half".into());
        }
        let base = self.operand(base, Strength::Single)?;
        let (base, number) = match number.is_int() {
            true => (base, number),
            false => (format!("(sqrt {base})"), twice),
        };
        let size = number.clone().into_parts().0;
        Ok(match number < Rational::ZERO {
            true => Text(format!("power_minus {base} {}", -size), Strength::Call),
            false => Text(format!("{base}^{size}"), Strength::Power),
        })
    }

    fn index(&self, base: &Expression, indices: &[Expression]) -> Written {
        let base = self.operand(base, Strength::Single)?;
        let indices = indices.iter().map(natural).collect::<Result<Vec<_>, _>>()?;
        let written = match indices.as_slice() {
            [only] => format!("component {base} {only}"),
            [row, column] => format!("at_entry {base} {row} {column}"),
            _ => return Err("an entry with more than two indices".into()),
        };
        Ok(Text(written, Strength::Call))
    }

    fn at(&self, inner: &Expression, place: &Place) -> Written {
        let inner = self.operand(inner, Strength::Single)?;
        let written = match place {
            Place::Named(name) => {
                let ascii = &name.value.ascii;
                if let Some(reason) = self.withheld.get(ascii) {
                    return Err(format!("`{}` is withheld: {reason}", name.value));
                }
                let known = self.names.get(ascii);
                known
                    .ok_or_else(|| format!("`{}` is no place of the certificate", name.value))?
                    .to_owned()
            }
            Place::Replacements(replacements) => self.replacements(replacements)?,
        };
        let inner = match self.replaces_functions(place) {
            false => inner,
            true => format!("(settled {} {inner})", self.hypotheses),
        };
        let place = written;
        Ok(Text(format!("{inner} at {place}"), Strength::Place))
    }

    /// Whether a place replaces angles or values of functions: what arguments and angles of vectors are must be
    /// settled before.
    fn replaces_functions(&self, place: &Place) -> bool {
        !self.functions.is_empty()
            && match place {
                Place::Named(name) => self.function_places.contains(&name.value.ascii),
                Place::Replacements(all) => self.replace_functions(all),
            }
    }

    /// Whether replacements have angles or values of functions among their targets.
    pub fn replace_functions(&self, replacements: &[Replacement]) -> bool {
        replacements.iter().any(|one| match &one.target.node {
            Node::Name(name) | Node::Derivative(name, _) => {
                self.functions.contains_key(&name.ascii) || self.angles.contains(&name.ascii)
            }
            _ => false,
        })
    }

    /// `[x |-> 0; y |-> 2*x]`
    ///
    /// # Errors
    ///
    /// Why it cannot be said.
    pub fn replacements(&self, replacements: &[Replacement]) -> Result<String, Withheld> {
        let written = replacements.iter().map(|one| {
            let target = self.operand(&one.target, Strength::Single)?;
            let value = self.operand(&one.value, Strength::Sum)?;
            Ok(format!("{target} |-> {value}"))
        });
        let written = written.collect::<Result<Vec<_>, Withheld>>()?;
        Ok(format!("[{}]", written.join("; ")))
    }

    fn call(&self, function: &Name, order: u32, arguments: &[Expression]) -> Written {
        if self.functions.contains_key(&function.ascii) {
            let known = self.function(function)?;
            let [argument] = arguments else {
                return Err("a function of several arguments".into());
            };
            let argument = self.operand(argument, Strength::Single)?;
            let written = format!("function_ {} {order} {argument}", known.number);
            return Ok(Text(written, Strength::Call));
        }
        if let Some(reason) = self.withheld.get(&function.ascii) {
            return Err(format!("`{function}` is withheld: {reason}"));
        }
        let plain = |word: &str, arguments: &[&Expression]| {
            let arguments = arguments
                .iter()
                .map(|own| self.operand(own, Strength::Single));
            let arguments = arguments.collect::<Result<Vec<_>, _>>()?;
            Ok(Text(
                format!("{word} {}", arguments.join(" ")),
                Strength::Call,
            ))
        };
        let Some(built_in) = Declared::of(&function.ascii).and_then(|own| own.call(arguments))
        else {
            let word = self.names.get(&function.ascii);
            let word = word.ok_or_else(|| format!("`{function}` is no name of the certificate"))?;
            return plain(word, &arguments.iter().collect::<Vec<_>>());
        };
        match built_in {
            BuiltIn::Circular(Circular::Sine, a) => plain("sin", &[a]),
            BuiltIn::Circular(Circular::Cosine, a) => plain("cos", &[a]),
            BuiltIn::Circular(Circular::Tangent, a) => plain("tan", &[a]),
            BuiltIn::Circular(Circular::Cotangent, a) => plain("cot", &[a]),
            BuiltIn::Root(a) => plain("sqrt", &[a]),
            BuiltIn::Direction(a, b) => plain("angle", &[a, b]),
            BuiltIn::Rate(a) => plain("dt", &[a]),
            BuiltIn::Jacobian(a, b) => plain("d", &[a, b]),
            BuiltIn::Determinant(a) => plain("det", &[a]),
            BuiltIn::Transpose(a) => plain("transpose", &[a]),
            BuiltIn::Inverse(a) => plain("inverse", &[a]),
            BuiltIn::Adjugate(a) => plain("adjugate", &[a]),
            BuiltIn::Trace(a) => plain("trace", &[a]),
            BuiltIn::Diagonal(all) => Ok(Text(
                format!("diagonal {}", self.list(all)?),
                Strength::Call,
            )),
            BuiltIn::Identity(n) => numbered("identity", &[], &[n]),
            BuiltIn::Zero(n, k) => numbered("zero", &[], &[n, k]),
            BuiltIn::Row(m, n) => numbered("row", &[self.argument(m)?], &[n]),
            BuiltIn::Column(m, n) => numbered("column", &[self.argument(m)?], &[n]),
            BuiltIn::Submatrix(m, rows, columns) => {
                let m = self.operand(m, Strength::Single)?;
                let written = format!("submatrix {m} {} {}", naturals(rows)?, naturals(columns)?);
                Ok(Text(written, Strength::Call))
            }
            BuiltIn::Solution(m, b) => plain("solve", &[m, b]),
            BuiltIn::Coefficient(p, variable, n) => match &n.node {
                // The order is an argument of the definition.
                Node::Name(_) => plain("coefficient_by", &[p, variable, n]),
                _ => numbered(
                    "coefficient",
                    &[self.argument(p)?, self.argument(variable)?],
                    &[n],
                ),
            },
            BuiltIn::Truncation(p, variables, n) => numbered(
                "truncate",
                &[self.argument(p)?, self.argument(variables)?],
                &[n],
            ),
            BuiltIn::Hurwitz(p, variable, n) => {
                let mut known = self.degrees.iter();
                let degree = known.find(|(own, by, _)| own == p && by == variable);
                let (_, _, degree) = degree.ok_or("a polynomial whose degree is not known")?;
                let arguments = [
                    self.argument(p)?,
                    self.argument(variable)?,
                    degree.to_string(),
                ];
                numbered("hurwitz", &arguments, &[n])
            }
            BuiltIn::Kernel(_) => Err("`kernel` is not in the kernel's vocabulary".into()),
        }
    }
}

/// A call with whole numbers behind its other arguments.
fn numbered(word: &str, arguments: &[String], numbers: &[&Expression]) -> Written {
    let numbers = numbers.iter().map(|number| natural(number));
    let numbers = numbers.collect::<Result<Vec<_>, _>>()?;
    let all: Vec<String> = arguments.iter().cloned().chain(numbers).collect();
    Ok(Text(format!("{word} {}", all.join(" ")), Strength::Call))
}

/// `[1; 2]`, of a row of whole numbers or of one.
fn naturals(expression: &Expression) -> Result<String, Withheld> {
    let numbers: Vec<&Expression> = match &expression.node {
        Node::Matrix(rows) => rows.iter().flatten().collect(),
        _ => vec![expression],
    };
    let numbers = numbers
        .into_iter()
        .map(natural)
        .collect::<Result<Vec<_>, _>>()?;
    Ok(format!("[{}]%nat", numbers.join("; ")))
}

fn natural(expression: &Expression) -> Result<String, Withheld> {
    let number = constant(expression).filter(|number| number.is_int() && *number >= Rational::ZERO);
    let number = number.ok_or("an index or an order that is not written as a number")?;
    Ok(number.into_parts().0.to_string())
}

/// A number that can stand as an operand.
pub(super) fn number(number: &Rational) -> String {
    rational(number).within(Strength::Single)
}

fn rational(number: &Rational) -> Text {
    let (above, below) = number.clone().into_parts();
    let size = |number: Integer| match number < Integer::ZERO {
        true => format!("- {}", -number),
        false => number.to_string(),
    };
    match number.is_int() {
        true if *number < Rational::ZERO => Text(size(above), Strength::Sign),
        true => Text::single(size(above)),
        false => Text(format!("{}/{below}", size(above)), Strength::Product),
    }
}

/// What a number, its opposite or a quotient of two is worth.
fn constant(expression: &Expression) -> Option<Rational> {
    match &expression.node {
        Node::Number(number) => Some(number.clone()),
        Node::Negative(operand) => Some(-constant(operand)?),
        Node::Binary(BinaryOperator::Divide, left, right) => {
            let below = constant(right).filter(|number| *number != Rational::ZERO)?;
            Some(constant(left)? / below)
        }
        Node::Binary(BinaryOperator::Power, left, right) => {
            let exponent = constant(right).filter(Rational::is_int)?.into_parts().0;
            let exponent = isize::try_from(exponent)
                .ok()
                .filter(|own| (0..=8).contains(own))?;
            Some(constant(left)?.pow(exponent))
        }
        _ => None,
    }
}
