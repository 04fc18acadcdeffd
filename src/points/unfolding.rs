//! Expressions of a document become nodes of a graph.

mod built_in;
mod operation;
mod place;

use std::collections::BTreeMap;

use crate::algebra::number::Rational;
use crate::algebra::sign::Signs;
use crate::language::syntax::{Expression, Name, Node as Written};

use super::derivative::By;
use super::graph::{FunctionId, Kind, Made, Node, NodeId, Variable};
use super::meaning::{Meaning, Meanings};
use super::sheet::Sheet;
use super::table::Table;
use super::{Failure, Unknown};

/// How deep definitions and calls may be nested.
const DEEPEST_NESTING: usize = 400;

/// The most rows and columns of a matrix, and the largest power that is asked for.
const LARGEST_NUMBER: u32 = 64;

/// Unfolds expressions: definitions are written in, derivatives, expansions and replacements carried out.
#[derive(Debug)]
pub struct Unfolding<'a> {
    meanings: &'a Meanings<'a>,
    /// The graph that comes out.
    pub sheet: Sheet,
    known: BTreeMap<&'a str, Result<Table, Failure>>,
    references: BTreeMap<&'a str, Result<NodeId, Failure>>,
    /// The arguments of the calls that one is in.
    frames: Vec<BTreeMap<&'a str, Table>>,
    nesting: usize,
}

impl<'a> Unfolding<'a> {
    /// Nothing unfolded yet.
    pub fn new(meanings: &'a Meanings<'a>, sheet: Sheet) -> Self {
        Unfolding {
            meanings,
            sheet,
            known: BTreeMap::new(),
            references: BTreeMap::new(),
            frames: Vec::new(),
            nesting: 0,
        }
    }

    /// Forgets the nodes from a place on, and what was found with them.
    pub fn forget(&mut self, size: usize) {
        self.known.clear();
        self.references.clear();
        self.sheet.forget(size);
    }

    /// An expression, entry by entry.
    ///
    /// # Errors
    ///
    /// [`Failure`] where it has no value anywhere, or cannot be followed.
    pub fn table(&mut self, expression: &'a Expression) -> Result<Table, Failure> {
        if self.nesting >= DEEPEST_NESTING {
            return Err(Unknown::TooDeep.into());
        }
        self.nesting += 1;
        let table = self.unfolded(expression);
        self.nesting -= 1;
        table
    }

    /// An expression with one entry.
    ///
    /// # Errors
    ///
    /// Those of [`Unfolding::table`].
    pub fn scalar(&mut self, expression: &'a Expression) -> Made {
        let table = self.table(expression)?;
        table.as_single().ok_or(Unknown::Shape.into())
    }

    /// The parts of degree 0, …, `order` of an expression in small quantities, entry by entry.
    ///
    /// # Errors
    ///
    /// [`Unknown::NoExpansion`] where there are none.
    pub fn parts(
        &mut self,
        expression: &'a Expression,
        small: &[&str],
        order: u32,
    ) -> Result<Vec<Table>, Failure> {
        let small: Result<Vec<By>, Failure> = small.iter().map(|name| self.small(name)).collect();
        let table = self.table(expression)?;
        self.expanded(&table, &small?, order)
    }

    /// The coefficient of a power of a variable in an expression.
    ///
    /// # Errors
    ///
    /// [`Unknown::NoPolynomial`] where it is not found.
    pub fn coefficient(&mut self, polynomial: &'a Expression, variable: &str, power: u32) -> Made {
        let node = self.scalar(polynomial)?;
        let variable = self.small(variable)?;
        self.sheet.coefficient(node, variable, power)
    }

    fn unfolded(&mut self, expression: &'a Expression) -> Result<Table, Failure> {
        match &expression.node {
            Written::Number(number) => Ok(Table::single(self.sheet.graph.number(number.clone())?)),
            Written::Name(name) => self.named(name),
            Written::Derivative(name, order) => {
                Ok(Table::single(self.bare_function(name, *order)?))
            }
            Written::Negative(inner) => {
                let table = self.table(inner)?;
                self.sheet
                    .each(&table, |sheet, entry| sheet.graph.negative(entry))
            }
            Written::Binary(operator, left, right) => self.binary(*operator, left, right),
            Written::Call {
                function,
                order,
                arguments,
            } => self.call(function, *order, arguments),
            Written::Matrix(rows) => self.blocks(rows),
            Written::Index(matrix, indices) => self.entry(matrix, indices),
            Written::At(inner, place) => self.at(inner, place),
        }
    }

    /// What a name stands for.
    fn named(&mut self, name: &'a Name) -> Result<Table, Failure> {
        let name = name.ascii.as_str();
        if let Some(argument) = self.frames.last().and_then(|frame| frame.get(name)) {
            return Ok(argument.clone());
        }
        match self.meanings.get(name).copied() {
            Some(Meaning::Variable(kind, signs)) => {
                Ok(Table::single(self.variable(name, kind, signs)?))
            }
            Some(Meaning::ImaginaryUnit) => Ok(Table::single(self.sheet.graph.imaginary_unit()?)),
            Some(Meaning::Function(_)) => {
                let (function, reference) = self.declared_function(name)?;
                let graph = &mut self.sheet.graph;
                Ok(Table::single(
                    graph.function(function, 0, reference, reference)?,
                ))
            }
            Some(Meaning::Definition(expression)) => {
                if let Some(known) = self.known.get(name) {
                    return known.clone();
                }
                let table = self.apart(|own| own.table(expression));
                self.known.insert(name, table.clone());
                table
            }
            _ => Err(Unknown::Unsupported.into()),
        }
    }

    /// What was declared elsewhere, where the arguments of a call mean nothing.
    fn apart<T>(&mut self, within: impl FnOnce(&mut Self) -> T) -> T {
        self.frames.push(BTreeMap::new());
        let found = within(self);
        self.frames.pop();
        found
    }

    fn variable(&mut self, name: &str, kind: Kind, signs: Signs) -> Made {
        let name = name.to_owned();
        let id = self.sheet.graph.variable_id(Variable {
            name,
            order: 0,
            kind,
            signs,
        });
        self.sheet.graph.free(id)
    }

    /// A declared function and where its bare name is taken.
    fn declared_function(&mut self, name: &str) -> Result<(FunctionId, NodeId), Failure> {
        let Some((name, Meaning::Function(reference))) = self.meanings.get_key_value(name) else {
            return Err(Unknown::Unsupported.into());
        };
        let place = match self.references.get(name) {
            Some(known) => *known,
            None => {
                let place = self.apart(|own| own.scalar(reference));
                self.references.insert(name, place);
                place
            }
        };
        Ok((self.sheet.graph.function_id(name), place?))
    }

    /// f⁽ᵏ⁾ where the bare name is taken.
    fn bare_function(&mut self, name: &Name, order: u32) -> Made {
        let (function, reference) = self.declared_function(&name.ascii)?;
        self.sheet
            .graph
            .function(function, order, reference, reference)
    }

    fn call(
        &mut self,
        function: &'a Name,
        order: u32,
        arguments: &'a [Expression],
    ) -> Result<Table, Failure> {
        match (
            self.meanings.get(function.ascii.as_str()).copied(),
            arguments,
        ) {
            (Some(Meaning::Function(_)), [argument]) => {
                let argument = self.scalar(argument)?;
                let (function, reference) = self.declared_function(&function.ascii)?;
                let graph = &mut self.sheet.graph;
                Ok(Table::single(
                    graph.function(function, order, argument, reference)?,
                ))
            }
            (Some(Meaning::Template(names, body)), _) => {
                let mut frame = BTreeMap::new();
                for (name, argument) in names.iter().zip(arguments) {
                    frame.insert(name.ascii.as_str(), self.table(argument)?);
                }
                self.frames.push(frame);
                let table = self.table(body);
                self.frames.pop();
                table
            }
            (Some(_), _) => Err(Unknown::Unsupported.into()),
            (None, _) => self.built_in(&function.ascii, arguments),
        }
    }

    fn blocks(&mut self, rows: &'a [Vec<Expression>]) -> Result<Table, Failure> {
        let mut bands = Vec::new();
        for row in rows {
            let blocks = row.iter().map(|block| self.table(block)?.transposed());
            let blocks: Vec<Table> = blocks.collect::<Result<_, _>>()?;
            bands.push(Table::stacked(&blocks)?.transposed()?);
        }
        Table::stacked(&bands)
    }

    fn entry(
        &mut self,
        matrix: &'a Expression,
        indices: &'a [Expression],
    ) -> Result<Table, Failure> {
        let table = self.table(matrix)?;
        let mut places = Vec::new();
        for index in indices {
            let place = (self.natural(index)? as usize).checked_sub(1);
            places.push(place.ok_or(Unknown::Shape)?);
        }
        let (row, column) = match places[..] {
            [row, column] => (row, column),
            [place] if table.shape().0 == 1 => (0, place),
            [place] => (place, 0),
            _ => return Err(Unknown::Unsupported.into()),
        };
        let entry = table.get(row, column)?;
        self.sheet.of_whole(&Table::single(entry), &table)
    }

    /// A small natural number.
    fn natural(&mut self, expression: &'a Expression) -> Result<u32, Failure> {
        let node = self.scalar(expression)?;
        let number = match self.sheet.graph.as_number(node) {
            Some(number) => number.clone(),
            None => self.constant(node)?,
        };
        let whole = number.is_int().then(|| number.numerator().clone());
        let whole = whole.and_then(|whole| u32::try_from(whole).ok());
        whole
            .filter(|n| *n <= LARGEST_NUMBER)
            .ok_or(Unknown::Unsupported.into())
    }

    /// The number that a node is everywhere.
    fn constant(&mut self, node: NodeId) -> Result<Rational, Failure> {
        let value = self.sheet.sample(node).ok_or(Unknown::Identity)?;
        let real = value.as_real().ok_or(Unknown::Unsupported)?;
        let number = match real.as_rational() {
            Some(number) => number.clone(),
            None => Rational::from(real.enclosure().middle().round()),
        };
        let candidate = self.sheet.graph.number(number.clone())?;
        match self.sheet.is_same(node, candidate)? {
            true => Ok(number),
            false => Err(Unknown::Unsupported.into()),
        }
    }

    /// What a node can be differentiated or replaced as.
    fn variable_of(&self, node: NodeId) -> Result<By, Failure> {
        match self.sheet.graph.node(node) {
            Node::Variable(id) => Ok(By::Variable(*id)),
            Node::Function {
                function,
                order,
                argument,
                ..
            } => Ok(By::Function(*function, *order, *argument)),
            _ => Err(Unknown::NoVariable.into()),
        }
    }

    /// The variable of an ASCII name.
    fn small(&mut self, name: &str) -> Result<By, Failure> {
        let node = match self.meanings.get_key_value(name) {
            Some((name, Meaning::Variable(kind, signs))) => self.variable(name, *kind, *signs)?,
            Some((name, Meaning::Function(_))) => {
                let (function, reference) = self.declared_function(name)?;
                self.sheet
                    .graph
                    .function(function, 0, reference, reference)?
            }
            Some((_, Meaning::Definition(expression))) => self.scalar(expression)?,
            _ => return Err(Unknown::NoVariable.into()),
        };
        self.variable_of(node)
    }
}
