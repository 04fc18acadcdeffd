//! Expressions of a document become operations of a program, with the structure that they have there.

mod matrix;
mod normal_form;
mod operation;
mod surrounding;

use std::collections::BTreeMap;

use sextic_codegen::program::{Node, Program};

use crate::algebra::matrix::Matrix;
use crate::algebra::symbol::Symbol;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::scope::Meaning;
use crate::language::evaluator::Evaluator;
use crate::language::syntax::{Expression, Name, Node as Syntax};

use super::input::Input;
use super::polynomial::Polynomial;
use surrounding::{Context, Frame, Surrounding};

/// Longer programs are refused: calls within calls can become very long.
const OPERATIONS: usize = 100_000;

/// A matrix of polynomials; a scalar has one row and one column.
pub(super) type Table = Matrix<Polynomial>;

/// Why an expression cannot be translated.
#[derive(Clone, Debug)]
pub enum Obstacle {
    /// It has no structure of sums, products and the like; its normal form may do.
    Structure,
    /// A part of it is no number that an input gives, such as i; the normal form of the whole may do
    /// without.
    NoInput,
    /// No program computes it, for this reason.
    Refused(String),
}

/// A translated evaluator.
#[derive(Clone, Debug)]
pub struct Translated {
    /// The program, optimised.
    pub program: Program,
    /// Its inputs, and the symbols of the ring that they are.
    pub inputs: Vec<(Symbol, Input)>,
}

/// Translates an evaluator into a program.
///
/// Sums, products, powers, determinants and coefficients of polynomials keep the structure that the
/// document gives them; derivatives, expansions and the like become Horner forms of their normal form.
///
/// # Errors
///
/// Why no program computes an output.
pub fn translate(evaluator: &Evaluator, elaborator: &mut Elaborator) -> Result<Translated, String> {
    let mut translator = Translator::new(elaborator);
    translator.outputs(evaluator)?;
    let Translator { program, found, .. } = translator;
    // In the order in which the document declares them.
    let names: Vec<&str> = found
        .values()
        .map(|(_, input)| input.name.as_str())
        .collect();
    let program = sextic_codegen::optimiser::optimise(&program.with_inputs_first(&names));
    let program = program.without_idle_inputs();
    let inputs = found
        .iter()
        .map(|(symbol, (_, input))| (*symbol, input.clone()))
        .filter(|(_, input)| program.input(&input.name).is_some());
    Ok(Translated {
        inputs: inputs.collect(),
        program,
    })
}

/// Appends the operations of expressions to a program.
pub(super) struct Translator<'a> {
    pub(super) elaborator: &'a mut Elaborator,
    pub(super) program: Program,
    /// The inputs that were needed, and their values.
    found: BTreeMap<Symbol, (Node, Input)>,
    surroundings: Vec<Surrounding>,
    frames: Vec<Frame>,
    /// The values of definitions, by surrounding.
    known: BTreeMap<(usize, String), Table>,
}

impl<'a> Translator<'a> {
    fn new(elaborator: &'a mut Elaborator) -> Self {
        Translator {
            program: Program::default(),
            elaborator,
            found: BTreeMap::new(),
            surroundings: vec![Surrounding::default()],
            frames: vec![Frame::default()],
            known: BTreeMap::new(),
        }
    }

    fn outputs(&mut self, evaluator: &Evaluator) -> Result<(), String> {
        for output in &evaluator.outputs {
            let table = self
                .table(&output.expression, Context::default())
                .map_err(|obstacle| {
                    let reason = match obstacle {
                        Obstacle::Structure => "it has no value outside of its surroundings".into(),
                        Obstacle::NoInput => {
                            "it contains i, a coordinate or the angle of a vector, which is no input"
                                .into()
                        }
                        Obstacle::Refused(reason) => reason,
                    };
                    format!("{}: {reason}", output.name.unicode)
                })?;
            let names = entry_names(&output.name.ascii, table.shape());
            for (name, entry) in names.into_iter().zip(table.entries()) {
                let node = match entry.constant() {
                    Some(Some(node)) => node,
                    Some(None) => self.program.constant(0.into()),
                    None => return Err(format!("{name} is a polynomial, not a number")),
                };
                self.program.output(name, node);
            }
        }
        Ok(())
    }

    /// The value of an expression: with its structure, or else from its normal form. A real part is real
    /// only as a whole, so that what a part has no value for is left to the whole.
    fn table(&mut self, expression: &Expression, context: Context) -> Result<Table, Obstacle> {
        if self.program.operations().len() > OPERATIONS {
            let reason = format!("it takes more than {OPERATIONS} operations");
            return Err(Obstacle::Refused(reason));
        }
        match self.structure(expression, context) {
            Err(Obstacle::Structure | Obstacle::NoInput)
                if !self.names_an_argument(expression, context) =>
            {
                let value = self
                    .elaborator
                    .value(expression)
                    .map_err(|error| Obstacle::Refused(error.message))?;
                value.try_map(|entry| self.element(&entry.value, context))
            }
            result => result,
        }
    }

    /// Whether an expression has a value only in the call that it is a part of.
    fn names_an_argument(&self, expression: &Expression, context: Context) -> bool {
        let arguments = &self.frames[context.frame].arguments;
        let mut found = false;
        expression.visit_names(&mut |name| found |= arguments.contains_key(&name.ascii));
        found
    }

    /// A name or a small sum such as n + 1 with what the callers wrote for the arguments in it.
    fn passed(&self, expression: &Expression, frame: usize) -> Expression {
        let passed = |part: &Expression| Box::new(self.passed(part, frame));
        let node = match &expression.node {
            Syntax::Name(name) => {
                let Frame { arguments, caller } = &self.frames[frame];
                match arguments.get(&name.ascii) {
                    Some(argument) => return self.passed(argument, *caller),
                    None => return expression.clone(),
                }
            }
            Syntax::Negative(inner) => Syntax::Negative(passed(inner)),
            Syntax::Binary(operator, left, right) => {
                Syntax::Binary(*operator, passed(left), passed(right))
            }
            _ => return expression.clone(),
        };
        Expression {
            node,
            span: expression.span.clone(),
        }
    }

    fn structure(&mut self, expression: &Expression, context: Context) -> Result<Table, Obstacle> {
        match &expression.node {
            Syntax::Number(number) => {
                let node = self.program.constant(number.clone());
                Ok(scalar(Polynomial::monomial(0, node)))
            }
            Syntax::Name(name) => self.named(name, context),
            Syntax::Derivative(..) => Err(Obstacle::Structure),
            Syntax::Negative(inner) => {
                let table = self.table(inner, context)?;
                Ok(self.each(&table, Polynomial::negative))
            }
            Syntax::Binary(operator, left, right) => self.binary(*operator, left, right, context),
            Syntax::Call {
                function,
                arguments,
                ..
            } => self.call(function, arguments, context),
            Syntax::Matrix(rows) => self.blocks(rows, context),
            Syntax::Index(matrix, indices) => self.entry(matrix, indices, context),
            Syntax::At(inner, at) => {
                let inside = self.at(at, context)?;
                self.table(inner, inside)
            }
        }
    }

    fn named(&mut self, name: &Name, context: Context) -> Result<Table, Obstacle> {
        let Frame { arguments, caller } = &self.frames[context.frame];
        if let Some(argument) = arguments.get(&name.ascii).cloned() {
            // Arguments are read in the caller's frame, but where the body stands.
            let frame = *caller;
            return self.table(&argument, Context { frame, ..context });
        }
        let surrounding = &self.surroundings[context.surrounding];
        if let Some(value) = surrounding.replaced.get(&name.ascii) {
            return Ok(value.clone());
        }
        if surrounding.variable.as_ref() == Some(&name.ascii) {
            let one = self.program.constant(1.into());
            return Ok(scalar(Polynomial::monomial(1, one)));
        }
        let meaning = match self.elaborator.scope.get(name) {
            Some(entry) => entry.meaning.clone(),
            None => return Err(Obstacle::Structure),
        };
        match meaning {
            Meaning::Symbol { symbol, .. } => {
                let node = self.input(symbol)?;
                Ok(scalar(Polynomial::monomial(0, node)))
            }
            Meaning::Definition { expression, .. } => {
                let key = (context.surrounding, name.ascii.clone());
                if let Some(known) = self.known.get(&key) {
                    return Ok(known.clone());
                }
                let table = self.table(
                    &expression,
                    Context {
                        frame: 0,
                        ..context
                    },
                )?;
                self.known.insert(key, table.clone());
                Ok(table)
            }
            _ => Err(Obstacle::Structure),
        }
    }

    /// The node of a symbol that is an input.
    fn input(&mut self, symbol: Symbol) -> Result<Node, Obstacle> {
        if let Some((node, _)) = self.found.get(&symbol) {
            return Ok(*node);
        }
        let Elaborator { ring, scope, .. } = &*self.elaborator;
        let Some(input) = Input::of(symbol, ring, scope) else {
            return Err(Obstacle::NoInput);
        };
        let mut others = self.found.values();
        if others.any(|(_, other)| other.name == input.name) {
            let name = &input.shown;
            return Err(Obstacle::Refused(format!(
                "{name} would be an input beside another of its name"
            )));
        }
        let node = self.program.add_input(input.name.clone());
        self.found.insert(symbol, (node, input));
        Ok(node)
    }

    fn call(
        &mut self,
        function: &Name,
        arguments: &[Expression],
        context: Context,
    ) -> Result<Table, Obstacle> {
        let meaning = self
            .elaborator
            .scope
            .get(function)
            .map(|entry| entry.meaning.clone());
        match meaning {
            Some(Meaning::Template {
                arguments: names,
                expression,
            }) => {
                let names = names.into_iter().map(|name| name.ascii);
                self.frames.push(Frame {
                    arguments: names.zip(arguments.iter().cloned()).collect(),
                    caller: context.frame,
                });
                let frame = self.frames.len() - 1;
                self.table(&expression, Context { frame, ..context })
            }
            Some(_) => Err(Obstacle::Structure),
            None => self.built_in(&function.ascii, arguments, context),
        }
    }
}

fn scalar(entry: Polynomial) -> Table {
    Matrix::from_fn(1, 1, |_, _| entry.clone())
}

/// What is divided by: a value without the variable.
fn divisor(entry: &Polynomial) -> Result<Node, Obstacle> {
    entry.constant().flatten().ok_or(Obstacle::Structure)
}

/// `C_a_12` for the entries of a matrix, `x_1` for those of a vector, the name itself for a number.
pub(super) fn entry_names(name: &str, (rows, columns): (usize, usize)) -> Vec<String> {
    let entry = |row: usize, column: usize| match (rows, columns) {
        (1, 1) => name.to_string(),
        (_, 1) => format!("{name}_{row}"),
        (1, _) => format!("{name}_{column}"),
        _ if rows.max(columns) < 10 => format!("{name}_{row}{column}"),
        _ => format!("{name}_{row}_{column}"),
    };
    let places = (1..=rows).flat_map(|row| (1..=columns).map(move |column| (row, column)));
    places.map(|(row, column)| entry(row, column)).collect()
}
