//! Evaluates expressions at a point.

mod angle;
mod built_in;
mod call;
mod context;
mod function;
mod interpolation;
mod nilpotent;
mod operation;
mod symbol;
mod variable;

use std::collections::BTreeMap;

use crate::algebra::number::Rational;
use crate::algebra::sign::Signs;
use crate::derivation::scope::Scope;
use crate::derivation::syntax::{Expression, Node};

use super::number::Number;
use super::point::{Key, Point, Size};
use super::sample::Sample;
use super::table::{Table, each, numbers, only, single};

use context::{Context, Frame, Surrounding};

/// Why an expression has no value at a point; the reason is for the reader of a verdict.
pub type Failure = String;

/// How deep the evaluation of expressions may be nested, definitions and calls included.
const DEEPEST_NESTING: usize = 600;

/// How many parts of expressions are evaluated at one point for one assertion.
const MOST_PARTS: usize = 400_000;

/// How many surroundings may be made at one point for one assertion.
const MOST_SURROUNDINGS: usize = 2_000;

/// Evaluates the expressions of a document at one point.
pub struct Evaluator<'a> {
    scope: &'a Scope,
    point: Point,
    surroundings: Vec<Surrounding<'a>>,
    frames: Vec<Frame<'a>>,
    /// How many nilpotent numbers are in use.
    nilpotents: u32,
    /// The values of names.
    known: BTreeMap<(Context, &'a str), Table>,
    /// The values of what replaces symbols, by surrounding.
    replaced: BTreeMap<(usize, Key), Sample>,
    nesting: usize,
    parts: usize,
    /// How many surroundings there were before the assertion.
    surroundings_before: usize,
}

impl<'a> Evaluator<'a> {
    /// An evaluator at a random point that respects the signs of the scope's symbols.
    pub fn new(scope: &'a Scope, seed: u64, size: Size, signs: BTreeMap<String, Signs>) -> Self {
        Evaluator {
            scope,
            point: Point::new(seed, size, signs),
            surroundings: vec![Surrounding::default()],
            frames: vec![Frame::default()],
            nilpotents: 0,
            known: BTreeMap::new(),
            replaced: BTreeMap::new(),
            nesting: 0,
            parts: 0,
            surroundings_before: 0,
        }
    }

    /// The point, with what was drawn so far.
    pub fn point(&self) -> &Point {
        &self.point
    }

    /// The value of an expression, entry by entry.
    ///
    /// # Errors
    ///
    /// The reason where it has none at this point.
    pub fn evaluate(&mut self, expression: &'a Expression) -> Result<Vec<Vec<Number>>, Failure> {
        self.begin();
        let table = self.table(expression, Context::default())?;
        self.finish()?;
        Ok(numbers(&table))
    }

    /// The parts of degree 0, 1, …, `order` of an expression in small symbols.
    ///
    /// # Errors
    ///
    /// The reason where it has none at this point.
    pub fn parts(
        &mut self,
        expression: &'a Expression,
        small: &[&str],
        order: u32,
    ) -> Result<Vec<Vec<Vec<Number>>>, Failure> {
        self.begin();
        let keys = small.iter().map(|name| self.key_of(name));
        let keys = keys.collect::<Result<_, _>>()?;
        let parts = self.expansion(expression, keys, order, Context::default())?;
        self.finish()?;
        Ok(parts)
    }

    /// The coefficients of a polynomial at this point, lowest first.
    ///
    /// # Errors
    ///
    /// The reason where it has none at this point.
    pub fn coefficients(
        &mut self,
        polynomial: &'a Expression,
        variable: &str,
    ) -> Result<Vec<Number>, Failure> {
        self.begin();
        let key = self.key_of(variable)?;
        let coefficients = self.interpolation(polynomial, &key, Context::default())?;
        self.finish()?;
        Ok(coefficients)
    }

    fn begin(&mut self) {
        self.point.extension.refill();
        (self.nesting, self.parts, self.nilpotents) = (0, 0, 0);
        self.surroundings_before = self.surroundings.len();
    }

    /// Fails where the numbers were given up; then products are wrong.
    fn finish(&self) -> Result<(), Failure> {
        if self.point.extension.is_exhausted() {
            return Err("its numbers become too large".into());
        }
        Ok(())
    }

    /// The value of an expression in a context.
    fn table(&mut self, expression: &'a Expression, context: Context) -> Result<Table, Failure> {
        self.parts += 1;
        if self.nesting >= DEEPEST_NESTING {
            return Err("definitions rest on each other too deeply".into());
        }
        let surroundings = self.surroundings.len() - self.surroundings_before;
        if self.parts > MOST_PARTS || surroundings > MOST_SURROUNDINGS {
            return Err("it has too many parts".into());
        }
        self.nesting += 1;
        let table = self.table_of_node(expression, context);
        self.nesting -= 1;
        // Nothing may be remembered of a computation that was given up.
        self.finish()?;
        table
    }

    fn table_of_node(
        &mut self,
        expression: &'a Expression,
        context: Context,
    ) -> Result<Table, Failure> {
        match &expression.node {
            Node::Number(number) => Ok(single(Number::from(number.clone()))),
            Node::Name(name) => self.named(name, context),
            Node::Derivative(name, order) => {
                let reference = self.reference(name)?;
                let number = self.function(name, *order, reference, context.outside_calls())?;
                Ok(single(number))
            }
            Node::Negative(inner) => {
                let table = self.table(inner, context)?;
                Ok(each(&table, Sample::negative))
            }
            Node::Binary(operator, left, right) => self.binary(*operator, left, right, context),
            Node::Call {
                function,
                order,
                arguments,
            } => self.call(function, *order, arguments, context),
            Node::Matrix(rows) => self.blocks(rows, context),
            Node::Index(matrix, indices) => self.entry(matrix, indices, context),
            Node::At(inner, place) => {
                let change = self.replacements(place, context.frame)?;
                let inside = self.changed(context, change);
                self.table(inner, inside)
            }
        }
    }

    fn blocks(&mut self, rows: &'a [Vec<Expression>], context: Context) -> Result<Table, Failure> {
        let mut table = Table::new();
        for row in rows {
            let mut band = Table::new();
            for block in row {
                let block = self.table(block, context)?;
                band.resize(band.len().max(block.len()), Vec::new());
                for (line, more) in band.iter_mut().zip(block) {
                    line.extend(more);
                }
            }
            table.extend(band);
        }
        Ok(table)
    }

    fn entry(
        &mut self,
        matrix: &'a Expression,
        indices: &'a [Expression],
        context: Context,
    ) -> Result<Table, Failure> {
        let table = self.table(matrix, context)?;
        let mut places = Vec::new();
        for index in indices {
            places.push(self.natural(index, context)?.saturating_sub(1));
        }
        let (row, column) = match places[..] {
            [row, column] => (row, column),
            [place] if table.len() == 1 => (0, place),
            [place] => (place, 0),
            _ => return Err("an entry has a row and a column".into()),
        };
        let entry = table.get(row).and_then(|line| line.get(column));
        entry
            .map(|entry| vec![vec![entry.clone()]])
            .ok_or("no such entry".into())
    }

    /// The value of an expression with one entry.
    fn scalar(&mut self, expression: &'a Expression, context: Context) -> Result<Sample, Failure> {
        let table = self.table(expression, context)?;
        only(&table).cloned()
    }

    /// The number that an expression with one entry is.
    fn number(&mut self, expression: &'a Expression, context: Context) -> Result<Number, Failure> {
        Ok(self.scalar(expression, context)?.number)
    }

    fn natural(&mut self, expression: &'a Expression, context: Context) -> Result<usize, Failure> {
        let number = self.number(expression, context)?.as_rational();
        let whole = number.filter(Rational::is_int);
        let small = whole.and_then(|number| usize::try_from(number.numerator().clone()).ok());
        small.ok_or("a small whole number is needed".into())
    }

    /// 1/a of what an expression divides by.
    fn reciprocal(&self, divisor: &Number) -> Result<Number, Failure> {
        let inverse = self.point.extension.inverse(divisor);
        inverse.ok_or("a divisor vanishes".into())
    }
}
