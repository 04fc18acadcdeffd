//! Expressions of a document become operations of a program, with the structure that they have there.

mod matrix;

use std::collections::BTreeMap;

use sextic_codegen::program::{Node, Operation, Program};

use crate::algebra::generator::Generator;
use crate::algebra::symbol::Symbol;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::evaluator::Evaluator;
use crate::derivation::presentation::Presenter;
use crate::derivation::scope::Meaning;
use crate::derivation::syntax::{
    BinaryOperator, Expression, Name, Node as Syntax, Place, Replacement,
};

use super::input::Input;
use super::polynomial::Polynomial;

/// A matrix of polynomials; a scalar has one row and one column.
pub(super) type Table = Vec<Vec<Polynomial>>;

/// Why an expression cannot be translated.
#[derive(Clone, Debug)]
pub enum Obstacle {
    /// It has no structure of sums, products and the like; its normal form may do.
    Structure,
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
    // The inputs are known when everything has been translated once.
    let mut inputs = BTreeMap::new();
    for _ in 0..2 {
        let mut translator = Translator::new(elaborator, inputs);
        translator.outputs(evaluator)?;
        let Translator { program, found, .. } = translator;
        if found.len() == program.inputs().len() {
            let program = sextic_codegen::optimiser::optimise(&program);
            return Ok(Translated {
                program,
                inputs: found.into_iter().collect(),
            });
        }
        inputs = found;
    }
    // Unreachable but for a mistake of this program.
    Err("its inputs change from one translation to the next".into())
}

/// Where an expression is read: a surrounding and a frame, by their numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Context {
    surrounding: usize,
    frame: usize,
}

/// What symbols stand for in a part of the document.
#[derive(Clone, Debug, Default)]
struct Surrounding {
    /// What replaces symbols, by ASCII name.
    replaced: BTreeMap<String, Table>,
    /// The places that do so, the innermost first.
    places: Vec<Place>,
    /// The variable whose powers are kept apart, by ASCII name.
    variable: Option<String>,
}

/// The arguments of a call, by ASCII name, and the frame in which they are to be read.
#[derive(Clone, Debug, Default)]
struct Frame {
    arguments: BTreeMap<String, Expression>,
    caller: usize,
}

/// Appends the operations of expressions to a program.
pub(super) struct Translator<'a> {
    pub(super) elaborator: &'a mut Elaborator,
    pub(super) program: Program,
    /// The inputs that were needed.
    pub(super) found: BTreeMap<Symbol, Input>,
    surroundings: Vec<Surrounding>,
    frames: Vec<Frame>,
    /// The values of definitions, by surrounding.
    known: BTreeMap<(usize, String), Table>,
}

impl<'a> Translator<'a> {
    fn new(elaborator: &'a mut Elaborator, inputs: BTreeMap<Symbol, Input>) -> Self {
        Translator {
            program: Program::new(inputs.values().map(|input| input.name.clone())),
            elaborator,
            found: inputs,
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
                        Obstacle::Refused(reason) => reason,
                    };
                    format!("{}: {reason}", output.name.unicode)
                })?;
            let shape = (table.len(), table.first().map_or(0, Vec::len));
            let names = entry_names(&output.name.ascii, shape);
            for (name, entry) in names.into_iter().zip(table.iter().flatten()) {
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

    /// The value of an expression: with its structure, or else from its normal form.
    fn table(&mut self, expression: &Expression, context: Context) -> Result<Table, Obstacle> {
        match self.structure(expression, context) {
            Err(Obstacle::Structure) if !self.names_an_argument(expression, context) => {
                let value = self
                    .elaborator
                    .value(expression)
                    .map_err(|error| Obstacle::Refused(error.message))?;
                let mut table = Table::new();
                for row in 0..value.rows() {
                    let mut line = Vec::new();
                    for column in 0..value.columns() {
                        line.push(self.element(&value.at(row, column).value, context)?);
                    }
                    table.push(line);
                }
                Ok(table)
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

    /// The value of a symbol of the ring: what the surroundings replace it by, or else an input.
    pub(super) fn symbol(&mut self, symbol: Symbol, context: Context) -> Result<Node, Obstacle> {
        let Surrounding {
            places, variable, ..
        } = &self.surroundings[context.surrounding];
        if places.is_empty() {
            return self.input(symbol);
        }
        let Elaborator { ring, scope, .. } = &*self.elaborator;
        let presenter = Presenter { ring, scope };
        let mut written = presenter.symbol(symbol).map_err(|_| Obstacle::Structure)?;
        let value = match ring.generator(symbol) {
            // What replaces it has a structure to keep.
            Generator::Constant { .. } | Generator::Angle { .. } => {
                self.structure(&written, context)?
            }
            _ => {
                let outside = Surrounding {
                    variable: variable.clone(),
                    ..Surrounding::default()
                };
                for place in places {
                    let node = Syntax::At(Box::new(written), place.clone());
                    written = Expression { node, span: 0..0 };
                }
                let outside = self.inside(outside, Context::default());
                let value = self.elaborator.scalar(&written);
                let value = value.map_err(|error| Obstacle::Refused(error.message))?;
                scalar(self.element(&value.value, outside)?)
            }
        };
        match value[0][0].constant() {
            Some(Some(node)) => Ok(node),
            Some(None) => Ok(self.program.constant(0.into())),
            None => Err(Obstacle::Structure),
        }
    }

    /// The node of a symbol that is an input.
    fn input(&mut self, symbol: Symbol) -> Result<Node, Obstacle> {
        let Elaborator { ring, scope, .. } = &*self.elaborator;
        let Some(input) = Input::of(symbol, ring, scope) else {
            return Err(Obstacle::Refused(
                "it contains i, a coordinate or the angle of a vector, which is no input".into(),
            ));
        };
        let same = |(known, other): (&Symbol, &Input)| *known != symbol && other.name == input.name;
        if self.found.iter().any(same) {
            let name = &input.shown;
            return Err(Obstacle::Refused(format!(
                "{name} would be an input beside another of its name"
            )));
        }
        let node = self.program.input(&input.name);
        self.found.insert(symbol, input);
        // In the first translation the inputs are only collected.
        Ok(node.unwrap_or_else(|| self.program.constant(2.into())))
    }

    fn binary(
        &mut self,
        operator: BinaryOperator,
        left: &Expression,
        right: &Expression,
        context: Context,
    ) -> Result<Table, Obstacle> {
        if operator == BinaryOperator::Power {
            return self.power(left, right, context);
        }
        let a = self.table(left, context)?;
        let b = self.table(right, context)?;
        match operator {
            BinaryOperator::Add => Ok(self.zip(&a, &b, Polynomial::sum)),
            BinaryOperator::Subtract => Ok(self.zip(&a, &b, Polynomial::difference)),
            BinaryOperator::Multiply => Ok(self.product(&a, &b)),
            BinaryOperator::Divide | BinaryOperator::Power => {
                let divisor = self.divisor(&b)?;
                Ok(self.each(&a, |entry, program| entry.quotient(divisor, program)))
            }
        }
    }

    fn power(
        &mut self,
        base: &Expression,
        exponent: &Expression,
        context: Context,
    ) -> Result<Table, Obstacle> {
        let exponent = self.elaborator.scalar(exponent);
        let exponent = exponent.map_err(|error| Obstacle::Refused(error.message))?;
        let exponent = exponent.value.as_constant();
        let whole = exponent.filter(crate::algebra::number::Rational::is_int);
        let count = whole.and_then(|whole| i32::try_from(whole.numerator().clone()).ok());
        let Some(count) = count.filter(|count| count.abs() <= 64) else {
            return Err(Obstacle::Structure);
        };
        let table = self.table(base, context)?;
        if table.len() != 1 || table[0].len() != 1 {
            return Err(Obstacle::Structure);
        }
        let one = self.program.constant(1.into());
        let mut power = Polynomial::monomial(0, one);
        for _ in 0..count.unsigned_abs() {
            power = power.product(&table[0][0], &mut self.program);
        }
        if count >= 0 {
            return Ok(scalar(power));
        }
        let divisor = self.divisor(&scalar(power))?;
        let inverse = self.program.push(Operation::Divide(one, divisor));
        Ok(scalar(Polynomial::monomial(0, inverse)))
    }

    /// What is divided by: a value without the variable.
    fn divisor(&self, table: &Table) -> Result<Node, Obstacle> {
        let entry = table.first().and_then(|row| row.first());
        match entry.map(Polynomial::constant) {
            Some(Some(Some(node))) => Ok(node),
            _ => Err(Obstacle::Structure),
        }
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

    /// The context inside of replacements.
    fn at(&mut self, at: &Place, context: Context) -> Result<Context, Obstacle> {
        let (replacements, frame) = match at {
            Place::Replacements(replacements) => (replacements.clone(), context.frame),
            Place::Named(name) => {
                match self
                    .elaborator
                    .scope
                    .get(&name.value)
                    .map(|entry| &entry.meaning)
                {
                    Some(Meaning::Substitution { replacements, .. }) => (replacements.clone(), 0),
                    _ => return Err(Obstacle::Structure),
                }
            }
        };
        let mut inside = self.surroundings[context.surrounding].clone();
        inside.places.insert(0, at.clone());
        for Replacement { target, value } in &replacements {
            let Syntax::Name(name) = &target.node else {
                return Err(Obstacle::Structure);
            };
            let value = self.table(value, Context { frame, ..context })?;
            inside.replaced.insert(name.ascii.clone(), value);
        }
        Ok(self.inside(inside, context))
    }

    /// The context in which the powers of a variable are kept apart.
    fn with_variable(&mut self, name: &Name, context: Context) -> Result<Context, Obstacle> {
        let mut inside = self.surroundings[context.surrounding].clone();
        if inside.variable.is_some() {
            return Err(Obstacle::Structure);
        }
        inside.replaced.remove(&name.ascii);
        inside.variable = Some(name.ascii.clone());
        Ok(self.inside(inside, context))
    }

    /// The variable whose powers are kept apart, by ASCII name.
    pub(super) fn variable(&self, context: Context) -> Option<&str> {
        self.surroundings[context.surrounding].variable.as_deref()
    }

    fn inside(&mut self, surrounding: Surrounding, context: Context) -> Context {
        self.surroundings.push(surrounding);
        let surrounding = self.surroundings.len() - 1;
        Context {
            surrounding,
            ..context
        }
    }
}

fn scalar(entry: Polynomial) -> Table {
    vec![vec![entry]]
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
