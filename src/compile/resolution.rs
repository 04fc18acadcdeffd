//! A body that was read back becomes a program: its names are resolved, and its literals are checked.

use std::collections::BTreeMap;

use sextic_codegen::program::{Node, Operation, Program};

use crate::algebra::number::Rational;

use super::constant::Constant;
use super::double::is_double;
use super::doubt::Reason;
use super::reading::names::is_spelling;
use super::reading::{Reading, Term};
use super::specification::Specification;

/// The program that a body is: its inputs are those of [`Specification::elements`], its outputs those of
/// the evaluator, both in order. A quantity that is fixed is an input, whose literal is checked here.
///
/// # Errors
///
/// [`Reason`] where an input or output is missing or occurs twice, a name has no value or a second one,
/// or a literal is no double or not the number that is fixed.
pub fn resolve(reading: &Reading, specification: &Specification) -> Result<Program, Reason> {
    let free = specification.inputs.iter().map(|(name, _)| name.as_str());
    let mut resolution = Resolution::of(reading, free, &specification.constants)?;
    let mut terms: BTreeMap<&str, &Term> = BTreeMap::new();
    for (output, term) in &reading.outputs {
        if terms.insert(output, term).is_some() {
            let reason = format!("the output `{output}` is given twice");
            return Err(Reason::Interface(reason));
        }
    }
    for (output, _) in &specification.outputs {
        let missing = || Reason::Interface(format!("the output `{output}` is not given"));
        let term = terms.remove(output.as_str()).ok_or_else(missing)?;
        resolution.output(output, term)?;
    }
    match terms.keys().next() {
        Some(surplus) => Err(Reason::Interface(format!("`{surplus}` is no output"))),
        None => Ok(resolution.program),
    }
}

/// The program so far, and the values of the variables in it.
pub(super) struct Resolution<'r> {
    pub(super) program: Program,
    known: BTreeMap<&'r str, Node>,
}

impl<'r> Resolution<'r> {
    /// What is read and assigned. The inputs are those that are free, and behind them the fixed ones.
    pub(super) fn of<'n>(
        reading: &'r Reading,
        free: impl Iterator<Item = &'n str>,
        constants: &[Constant],
    ) -> Result<Self, Reason> {
        let mut unread: Vec<&str> = free.collect();
        let free = unread.iter().map(|name| (*name).to_string());
        let fixed = constants.iter().map(|constant| constant.name.clone());
        let mut resolution = Resolution {
            program: Program::new(free.chain(fixed)),
            known: BTreeMap::new(),
        };
        for (input, variable) in &reading.inputs {
            let Some(place) = unread.iter().position(|name| name == input) else {
                let reason = format!("`{input}` is no input, or is read twice");
                return Err(Reason::Interface(reason));
            };
            unread.swap_remove(place);
            let node = resolution.input(input)?;
            resolution.assign(variable, node)?;
        }
        for (variable, term) in &reading.assignments {
            let node = match named_after(variable, constants) {
                Some(constant) => resolution.constant(constant, term)?,
                None => resolution.node(term)?,
            };
            resolution.assign(variable, node)?;
        }
        Ok(resolution)
    }

    /// Names the value of a term as an output.
    pub(super) fn output(&mut self, name: &str, term: &Term) -> Result<(), Reason> {
        let node = self.node(term)?;
        self.program.output(name, node);
        Ok(())
    }

    fn input(&self, name: &str) -> Result<Node, Reason> {
        let node = self.program.input(name);
        node.ok_or_else(|| Reason::Interface(format!("`{name}` is no input")))
    }

    fn assign(&mut self, variable: &'r str, node: Node) -> Result<(), Reason> {
        match self.known.insert(variable, node) {
            None => Ok(()),
            Some(_) => Err(Reason::Name(format!("`{variable}` is assigned twice"))),
        }
    }

    /// The input that a literal stands for.
    fn constant(&self, constant: &Constant, term: &Term) -> Result<Node, Reason> {
        let name = &constant.name;
        match literal(term).filter(|literal| constant.may_be(literal)) {
            Some(_) => self.input(name),
            None => {
                let reason = format!("`{name}` is not the number that it is fixed at");
                Err(Reason::Literal(reason))
            }
        }
    }

    fn node(&mut self, term: &Term) -> Result<Node, Reason> {
        let operation = match term {
            Term::Name(name) => {
                let node = self.known.get(name.as_str()).copied();
                return node
                    .ok_or_else(|| Reason::Name(format!("`{name}` is not assigned before")));
            }
            Term::Number(number) if is_double(number) => Operation::Constant(number.clone()),
            Term::Number(number) => {
                return Err(Reason::Literal(format!("{number} is no double")));
            }
            Term::Negative(a) => Operation::Negative(self.node(a)?),
            Term::Add(a, b) => Operation::Add(self.node(a)?, self.node(b)?),
            Term::Subtract(a, b) => Operation::Subtract(self.node(a)?, self.node(b)?),
            Term::Multiply(a, b) => Operation::Multiply(self.node(a)?, self.node(b)?),
            Term::Divide(a, b) => Operation::Divide(self.node(a)?, self.node(b)?),
            Term::SquareRoot(a) => Operation::SquareRoot(self.node(a)?),
        };
        Ok(self.program.push(operation))
    }
}

/// The constant that a variable is named after.
fn named_after<'c>(variable: &str, constants: &'c [Constant]) -> Option<&'c Constant> {
    let is_constant = |name: &str| constants.iter().any(|constant| constant.name == name);
    let is_it = |constant: &&Constant| is_spelling(variable, &constant.name, is_constant);
    constants.iter().find(is_it)
}

/// A number and its sign, if a term is no more than that.
fn literal(term: &Term) -> Option<Rational> {
    match term {
        Term::Number(number) => Some(number.clone()),
        Term::Negative(inner) => match inner.as_ref() {
            Term::Number(number) => Some(-number.clone()),
            _ => None,
        },
        _ => None,
    }
}
