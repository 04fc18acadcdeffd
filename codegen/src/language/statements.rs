//! A program as statements: which value gets a name, and which stands where it is used.

use super::Error;
use super::literal::{Decimal, Literal};
use super::notation::{Binding, Fused, Notation, Sign, Text};
use crate::program::{Node, Operation, Program, Rational};

/// A value that gets a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    /// The name.
    pub name: String,
    /// The value.
    pub text: String,
}

/// A program as text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Body {
    /// The values that get a name, each before it is used.
    pub statements: Vec<Statement>,
    /// The outputs in order: names, or literals.
    pub results: Vec<String>,
}

/// Prints a program.
///
/// A value that is used once stands where it is used as long as the text stays short; any other is
/// called as the output that it is, where `outputs` has a name for it, or t1, t2, ….
///
/// # Errors
///
/// If a constant is beyond the doubles.
pub fn statements<N: Notation>(
    program: &Program,
    inputs: &[String],
    outputs: &[Option<String>],
    notation: &N,
) -> Result<Body, Error> {
    let mut printer = Printer {
        program,
        notation,
        names: vec![None; program.operations().len()],
        literals: vec![None; program.operations().len()],
        body: Body::default(),
        temporaries: 0,
    };
    let mut uses = vec![0_usize; program.operations().len()];
    for operand in program.operations().iter().flat_map(Operation::operands) {
        uses[operand.index()] += 1;
    }
    for (_, node) in program.outputs() {
        uses[node.index()] += 1;
    }
    for (node, operation) in program.nodes() {
        match operation {
            Operation::Input(place) => {
                printer.names[node.index()] = inputs.get(*place as usize).cloned();
            }
            Operation::Constant(value) => {
                printer.literals[node.index()] = Some(printer.constant(value)?);
            }
            _ => {
                printer.shorten(node);
                let place = program
                    .outputs()
                    .iter()
                    .position(|(_, output)| *output == node);
                let name = place.and_then(|place| outputs.get(place).cloned().flatten());
                if place.is_some() || uses[node.index()] != 1 {
                    printer.name(node, name);
                }
            }
        }
    }
    printer.body.results = program
        .outputs()
        .iter()
        .map(|(_, node)| printer.text(*node).text)
        .collect();
    Ok(printer.body)
}

struct Printer<'a, N> {
    program: &'a Program,
    notation: &'a N,
    names: Vec<Option<String>>,
    literals: Vec<Option<Text>>,
    body: Body,
    temporaries: usize,
}

impl<N: Notation> Printer<'_, N> {
    fn constant(&self, value: &Rational) -> Result<Text, Error> {
        let literal = Literal::of(value).ok_or_else(|| Error::Constant(value.to_string()))?;
        if let Some(decimal) = literal.single() {
            return Ok(self.notation.literal(decimal));
        }
        let sum = |terms: &[Decimal]| {
            let texts = terms.iter().map(|term| self.notation.literal(term));
            texts.reduce(|left, right| self.notation.binary(Sign::Add, &left, &right))
        };
        Ok(match (sum(&literal.above), sum(&literal.below)) {
            (Some(above), Some(below)) => self.notation.binary(Sign::Divide, &above, &below),
            (Some(above), None) => above,
            (None, _) => return Err(Error::Constant(value.to_string())),
        })
    }

    /// Whether a value is printed where it is used.
    fn stands_inside(&self, node: Node) -> bool {
        self.names[node.index()].is_none() && self.literals[node.index()].is_none()
    }

    /// The factors of a product that has no name.
    fn product(&self, node: Node) -> Option<(Node, Node)> {
        match self.program.operation(node) {
            Operation::Multiply(a, b) if N::FUSES && self.stands_inside(node) => Some((*a, *b)),
            _ => None,
        }
    }

    /// The product, whether it is subtracted, the other summand, and whether that one is.
    fn fusion(&self, operation: &Operation) -> Option<((Node, Node), bool, Node, bool)> {
        let (left, right, minus) = match operation {
            Operation::Add(a, b) => (*a, *b, false),
            Operation::Subtract(a, b) => (*a, *b, true),
            _ => return None,
        };
        let first = self
            .product(left)
            .map(|factors| (factors, false, right, minus));
        first.or_else(|| Some((self.product(right)?, minus, left, false)))
    }

    fn text(&self, node: Node) -> Text {
        if let Some(name) = &self.names[node.index()] {
            return Text::new(name.clone(), Binding::Atom);
        }
        if let Some(literal) = &self.literals[node.index()] {
            return literal.clone();
        }
        let operation = self.program.operation(node);
        if let Some(((a, b), negative_product, addend, negative_addend)) = self.fusion(operation) {
            return self.notation.fused(&Fused {
                factors: (&self.text(a), &self.text(b)),
                negative_product,
                addend: &self.text(addend),
                negative_addend,
            });
        }
        let binary =
            |sign, a: &Node, b: &Node| self.notation.binary(sign, &self.text(*a), &self.text(*b));
        match operation {
            Operation::Add(a, b) => binary(Sign::Add, a, b),
            Operation::Subtract(a, b) => binary(Sign::Subtract, a, b),
            Operation::Multiply(a, b) => binary(Sign::Multiply, a, b),
            Operation::Divide(a, b) => binary(Sign::Divide, a, b),
            Operation::Negative(a) => self.notation.negative(&self.text(*a)),
            Operation::SquareRoot(a) => self.notation.square_root(&self.text(*a)),
            // Inputs have names and constants are literals.
            Operation::Input(_) | Operation::Constant(_) => Text::new("", Binding::Atom),
        }
    }

    /// Names parts of a value, the longest first, until its text is short.
    fn shorten(&mut self, node: Node) {
        while self.text(node).text.len() > N::WIDTH {
            let operation = self.program.operation(node);
            let parts: Vec<Node> = match self.fusion(operation) {
                Some(((a, b), _, addend, _)) => vec![a, b, addend],
                None => operation.operands().collect(),
            };
            let longest = parts
                .into_iter()
                .filter(|part| self.stands_inside(*part))
                .max_by_key(|part| (self.text(*part).text.len(), std::cmp::Reverse(*part)));
            match longest {
                Some(part) => self.name(part, None),
                None => return,
            }
        }
    }

    fn name(&mut self, node: Node, name: Option<String>) {
        let name = name.unwrap_or_else(|| {
            self.temporaries += 1;
            format!("t{}", self.temporaries)
        });
        let text = self.text(node).text;
        self.names[node.index()] = Some(name.clone());
        self.body.statements.push(Statement { name, text });
    }
}
