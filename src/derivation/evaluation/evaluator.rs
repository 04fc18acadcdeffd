//! Evaluates expressions at a point.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::number::{Integer, Rational};
use crate::algebra::sign::Signs;
use crate::derivation::scope::{Entry, Meaning, Scope, SymbolKind};
use crate::derivation::syntax::{BinaryOperator, Expression, Name, Node, Place, Replacement};

use super::number::Number;
use super::point::{Argument, Atom, Key, Point, Size, Tag};
use super::table::{
    Sample, Table, adjugate, determinant, eliminate, null_space, numbers, samples, single,
};

/// Why an expression has no value at a point; the reason is for the reader of a verdict.
pub type Failure = String;

/// The most nodes a polynomial is sampled at to find its coefficients.
const MOST_NODES: i64 = 40;

/// How deep the evaluation of expressions may be nested, definitions and calls included.
const DEEPEST_NESTING: usize = 600;

/// How many parts of expressions are evaluated at one point for one assertion.
const MOST_PARTS: usize = 400_000;

/// Evaluates the expressions of a document at one point.
pub struct Evaluator<'a> {
    scope: &'a Scope,
    point: Point,
    surroundings: Vec<Surrounding<'a>>,
    frames: Vec<Frame<'a>>,
    nilpotents: u32,
    /// The values of names, by surrounding and frame.
    known: BTreeMap<(usize, usize, &'a str), Table>,
    replaced: BTreeMap<(usize, Key), Sample>,
    nesting: usize,
    parts: usize,
}

/// How the values of symbols differ from those of the point, on top of another surrounding.
#[derive(PartialEq)]
struct Surrounding<'a> {
    parent: usize,
    change: Change<'a>,
}

#[derive(Clone, PartialEq)]
enum Change<'a> {
    None,
    /// Every coordinate moves with time: q + q̇ε.
    Time(Number),
    /// One symbol moves: q + ε.
    Shift(Key, Number),
    /// One symbol has another value.
    Set(Key, Number),
    /// Symbols, and values of functions at their reference arguments, have other values, which are
    /// read in the parent surrounding and the given frame.
    Replace {
        symbols: BTreeMap<Key, &'a Expression>,
        functions: Vec<(&'a Name, u32, &'a Expression)>,
        frame: usize,
    },
    /// Symbols are multiplied by something small.
    Scale(BTreeSet<Key>, Number),
}

/// What can be replaced or differentiated by.
enum Target<'a> {
    Symbol(Key),
    Function(&'a Name, u32),
}

/// The arguments of a call, by name, and the frame in which they are to be read.
#[derive(PartialEq)]
struct Frame<'a> {
    arguments: BTreeMap<&'a str, &'a Expression>,
    caller: usize,
}

impl<'a> Evaluator<'a> {
    /// An evaluator at a random point that respects the signs of the scope's symbols.
    pub fn new(scope: &'a Scope, seed: u64, size: Size, signs: BTreeMap<String, Signs>) -> Self {
        let frame = Frame {
            arguments: BTreeMap::new(),
            caller: 0,
        };
        Evaluator {
            scope,
            point: Point::new(seed, size, signs),
            surroundings: vec![Surrounding {
                parent: 0,
                change: Change::None,
            }],
            frames: vec![frame],
            nilpotents: 0,
            known: BTreeMap::new(),
            replaced: BTreeMap::new(),
            nesting: 0,
            parts: 0,
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
        let table = self.table(expression, 0, 0)?;
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
        let keys = small
            .iter()
            .map(|name| Key::Symbol((*name).to_string(), 0))
            .collect();
        let parts = self.expansion(expression, keys, order, 0, 0)?;
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
        let key = Key::Symbol(variable.to_string(), 0);
        let coefficients = self.interpolation(polynomial, &key, 0, 0)?;
        self.finish()?;
        Ok(coefficients)
    }

    fn begin(&mut self) {
        self.point.extension.refill();
        (self.nesting, self.parts, self.nilpotents) = (0, 0, 0);
    }

    /// Fails where the numbers were given up; then products are wrong.
    fn finish(&self) -> Result<(), Failure> {
        if self.point.extension.is_exhausted() {
            return Err("its numbers become too large".into());
        }
        Ok(())
    }

    fn table(
        &mut self,
        expression: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<Table, Failure> {
        self.parts += 1;
        if self.nesting >= DEEPEST_NESTING {
            return Err("definitions rest on each other too deeply".into());
        }
        if self.parts > MOST_PARTS {
            return Err("it has too many parts".into());
        }
        self.nesting += 1;
        let table = self.table_of_node(expression, surrounding, frame);
        self.nesting -= 1;
        // Nothing may be remembered of a computation that was given up.
        self.finish()?;
        table
    }

    fn table_of_node(
        &mut self,
        expression: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<Table, Failure> {
        match &expression.node {
            Node::Number(number) => Ok(single(Number::from(number.clone()))),
            Node::Name(name) => self.named(name, surrounding, frame),
            Node::Derivative(name, order) => {
                let reference = self.reference(name)?;
                self.function(name, *order, reference, surrounding, 0)
            }
            Node::Negative(inner) => {
                let table = self.table(inner, surrounding, frame)?;
                Ok(each(&table, |sample| Sample {
                    number: sample.number.negative(),
                    angle: sample
                        .angle
                        .as_ref()
                        .map(|tag| combine(tag, &Tag::new(), -1)),
                }))
            }
            Node::Binary(operator, left, right) => {
                self.binary(*operator, left, right, surrounding, frame)
            }
            Node::Call {
                function,
                order,
                arguments,
            } => self.call(function, *order, arguments, surrounding, frame),
            Node::Matrix(rows) => {
                let mut table = Table::new();
                for row in rows {
                    let mut band: Table = Vec::new();
                    for block in row {
                        let block = self.table(block, surrounding, frame)?;
                        band.resize(band.len().max(block.len()), Vec::new());
                        for (line, more) in band.iter_mut().zip(block) {
                            line.extend(more);
                        }
                    }
                    table.extend(band);
                }
                Ok(table)
            }
            Node::Index(matrix, indices) => {
                let table = self.table(matrix, surrounding, frame)?;
                let mut places = Vec::new();
                for index in indices {
                    places.push(self.natural(index, surrounding, frame)?.saturating_sub(1));
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
            Node::At(inner, place) => {
                let change = self.replacements(place, frame)?;
                let inside = self.within(surrounding, change);
                self.table(inner, inside, frame)
            }
        }
    }

    fn scalar(
        &mut self,
        expression: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<Sample, Failure> {
        let table = self.table(expression, surrounding, frame)?;
        match (table.len(), table.first().map(Vec::as_slice)) {
            (1, Some([sample])) => Ok(sample.clone()),
            _ => Err("a single number is needed".into()),
        }
    }

    fn natural(
        &mut self,
        expression: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<usize, Failure> {
        let number = self
            .scalar(expression, surrounding, frame)?
            .number
            .as_rational();
        let whole = number.filter(Rational::is_int);
        let small = whole.and_then(|number| usize::try_from(number.numerator().clone()).ok());
        small.ok_or("a small whole number is needed".into())
    }

    /// The surrounding that a change makes of another; the same change makes the same surrounding, so
    /// that what is known there is known once.
    fn within(&mut self, parent: usize, change: Change<'a>) -> usize {
        index_of(&mut self.surroundings, Surrounding { parent, change })
    }

    fn nilpotent(&mut self) -> Result<Number, Failure> {
        let number = Number::nilpotent(self.nilpotents);
        self.nilpotents += 1;
        number.ok_or("derivatives are nested too deeply".into())
    }

    fn named(
        &mut self,
        name: &'a Name,
        surrounding: usize,
        frame: usize,
    ) -> Result<Table, Failure> {
        let argument = self.frames[frame]
            .arguments
            .get(name.ascii.as_str())
            .copied();
        let place = (
            surrounding,
            if argument.is_some() { frame } else { 0 },
            name.ascii.as_str(),
        );
        if let Some(known) = self.known.get(&place) {
            return Ok(known.clone());
        }
        let table = match argument {
            // Arguments are read in the caller's frame, but where the body stands.
            Some(argument) => self.table(argument, surrounding, self.frames[frame].caller)?,
            None => {
                let mut names = BTreeSet::new();
                names.extend(self.scope.get(name).into_iter().flat_map(Entry::rests_on));
                match self.felt(&mut names, surrounding) {
                    felt if felt == surrounding => self.declared(name, surrounding)?,
                    felt => self.named(name, felt, 0)?,
                }
            }
        };
        self.known.insert(place, table.clone());
        Ok(table)
    }

    /// The surrounding with only those changes that some names feel, which become the names that these
    /// rest on in what is left.
    fn felt(&mut self, names: &mut BTreeSet<&'a str>, surrounding: usize) -> usize {
        let Surrounding { parent, change } = &self.surroundings[surrounding];
        let (parent, feels) = (*parent, |key: &Key| names.contains(key.name()));
        let felt = match change {
            Change::None => return surrounding,
            Change::Time(_) => names.iter().any(|name| self.is_coordinate(name)),
            Change::Shift(key, _) | Change::Set(key, _) => feels(key),
            Change::Scale(keys, _) => keys.iter().any(feels),
            Change::Replace {
                symbols,
                functions,
                frame,
            } => {
                let symbols = symbols
                    .iter()
                    .filter(|(key, _)| feels(key))
                    .map(|(_, value)| *value);
                let functions = functions
                    .iter()
                    .filter(|(name, ..)| names.contains(&*name.ascii));
                let values: Vec<&Expression> = symbols
                    .chain(functions.map(|(_, _, value)| *value))
                    .collect();
                if *frame > 0 && !values.is_empty() {
                    // The values may mention arguments.
                    return surrounding;
                }
                let scope = self.scope;
                for value in &values {
                    value.visit_names(&mut |name| {
                        names.extend(scope.get(name).into_iter().flat_map(Entry::rests_on));
                    });
                }
                !values.is_empty()
            }
        };
        match self.felt(names, parent) {
            below if !felt => below,
            below if below == parent => surrounding,
            below => self.within(below, self.surroundings[surrounding].change.clone()),
        }
    }

    fn declared(&mut self, name: &'a Name, surrounding: usize) -> Result<Table, Failure> {
        let scope = self.scope;
        match &scope
            .get(name)
            .ok_or(format!("{name} is not known"))?
            .meaning
        {
            Meaning::Symbol { .. } => {
                let key = Key::Symbol(name.ascii.clone(), 0);
                Ok(vec![vec![self.look_up(&key, surrounding)?]])
            }
            Meaning::Function { reference, .. } => {
                self.function(name, 0, reference, surrounding, 0)
            }
            Meaning::Definition { expression, .. } => self.table(expression, surrounding, 0),
            _ => Err(format!("{name} is no value")),
        }
    }

    /// The value of something free in a surrounding.
    fn look_up(&mut self, key: &Key, surrounding: usize) -> Result<Sample, Failure> {
        let parent = self.surroundings[surrounding].parent;
        match &self.surroundings[surrounding].change {
            Change::None => {
                let number = match key {
                    Key::Symbol(name, 0) if self.is_imaginary(name) => {
                        let unit = self.point.extension.adjoin(-Rational::ONE);
                        unit.ok_or("too many roots")?
                    }
                    _ => self.point.value(key),
                };
                let angle = match key {
                    Key::Symbol(name, 0) if self.is_angular(name) => {
                        let atom = Atom::Named(name.clone());
                        Some(Tag::from([(atom, Integer::ONE)]))
                    }
                    _ => None,
                };
                Ok(Sample { number, angle })
            }
            Change::Time(step) => {
                let step = step.clone();
                let mut sample = self.look_up(key, parent)?;
                if let Key::Symbol(name, order) = key
                    && self.is_coordinate(name)
                {
                    let next = Key::Symbol(name.clone(), order + 1);
                    let velocity = self.look_up(&next, parent)?;
                    let moved = self.point.extension.product(&velocity.number, &step);
                    sample.number = sample.number.sum(&moved);
                }
                Ok(sample)
            }
            Change::Shift(shifted, step) => {
                let step = (shifted == key).then(|| step.clone());
                let mut sample = self.look_up(key, parent)?;
                if let Some(step) = step {
                    sample.number = sample.number.sum(&step);
                }
                Ok(sample)
            }
            Change::Set(set, value) if set == key => Ok(Sample {
                number: value.clone(),
                angle: None,
            }),
            Change::Set(..) => self.look_up(key, parent),
            Change::Replace { symbols, frame, .. } => {
                let Some(value) = symbols.get(key).copied() else {
                    return self.look_up(key, parent);
                };
                let frame = *frame;
                let place = (surrounding, key.clone());
                if let Some(known) = self.replaced.get(&place) {
                    return Ok(known.clone());
                }
                let sample = self.scalar(value, parent, frame)?;
                self.replaced.insert(place, sample.clone());
                Ok(sample)
            }
            Change::Scale(scaled, step) => {
                let step = scaled.contains(key).then(|| step.clone());
                let sample = self.look_up(key, parent)?;
                Ok(match step {
                    Some(step) => Sample::from(self.point.extension.product(&sample.number, &step)),
                    None => sample,
                })
            }
        }
    }

    fn is_imaginary(&self, name: &str) -> bool {
        self.scope.kind_of(name) == Some(SymbolKind::Imaginary)
    }

    fn is_coordinate(&self, name: &str) -> bool {
        let kind = self.scope.kind_of(name);
        matches!(
            kind,
            Some(SymbolKind::Coordinate | SymbolKind::AngularCoordinate)
        )
    }

    fn is_angular(&self, name: &str) -> bool {
        let kind = self.scope.kind_of(name);
        matches!(
            kind,
            Some(SymbolKind::Angle | SymbolKind::AngularCoordinate)
        )
    }

    fn replacements(&self, place: &'a Place, frame: usize) -> Result<Change<'a>, Failure> {
        let scope = self.scope;
        let (replacements, frame): (&'a [Replacement], usize) = match place {
            Place::Replacements(replacements) => (replacements, frame),
            Place::Named(name) => match scope.get(name).map(|entry| &entry.meaning) {
                Some(Meaning::Substitution { replacements, .. }) => (replacements, 0),
                _ => return Err(format!("{name} is no substitution")),
            },
        };
        let (mut symbols, mut functions) = (BTreeMap::new(), Vec::new());
        for Replacement { target, value } in replacements {
            match self.target(target, frame)? {
                Target::Symbol(key) => {
                    symbols.insert(key, value);
                }
                Target::Function(name, order) => functions.push((name, order, value)),
            }
        }
        Ok(Change::Replace {
            symbols,
            functions,
            frame,
        })
    }

    /// What can be replaced or differentiated by: a symbol, or the value of a function at its
    /// reference argument.
    fn target(&self, target: &'a Expression, frame: usize) -> Result<Target<'a>, Failure> {
        let scope = self.scope;
        if let Some((argument, caller)) = self.argument(target, frame) {
            return self.target(argument, caller);
        }
        match &target.node {
            Node::Name(name) => match scope.get(name).map(|entry| &entry.meaning) {
                Some(Meaning::Symbol { .. }) => {
                    Ok(Target::Symbol(Key::Symbol(name.ascii.clone(), 0)))
                }
                Some(Meaning::Function { .. }) => Ok(Target::Function(name, 0)),
                Some(Meaning::Definition { expression, .. }) => self.target(expression, 0),
                _ => Err(format!("{name} is no variable")),
            },
            Node::Derivative(name, order) => Ok(Target::Function(name, *order)),
            Node::Call {
                function,
                arguments,
                ..
            } if function.ascii == "dt" => {
                match arguments
                    .first()
                    .map(|inner| self.target(inner, frame))
                    .transpose()?
                {
                    Some(Target::Symbol(Key::Symbol(name, order))) => {
                        Ok(Target::Symbol(Key::Symbol(name, order + 1)))
                    }
                    _ => Err("this is no variable".into()),
                }
            }
            _ => Err("this is no variable".into()),
        }
    }

    /// What an argument of the frame's call stands for, and the frame in which that is read.
    fn argument(&self, name: &Expression, frame: usize) -> Option<(&'a Expression, usize)> {
        let Node::Name(name) = &name.node else {
            return None;
        };
        let Frame { arguments, caller } = &self.frames[frame];
        arguments
            .get(name.ascii.as_str())
            .map(|argument| (*argument, *caller))
    }

    /// The key of something that is differentiated by.
    fn key(
        &mut self,
        target: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<Key, Failure> {
        match self.target(target, frame)? {
            Target::Symbol(key) => Ok(key),
            Target::Function(name, order) => {
                self.function_key(name, order, self.reference(name)?, surrounding, 0)
            }
        }
    }

    /// The keys of the entries of a vector of variables.
    fn keys(
        &mut self,
        variables: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<Vec<Key>, Failure> {
        let scope = self.scope;
        if let Some((argument, caller)) = self.argument(variables, frame) {
            return self.keys(argument, surrounding, caller);
        }
        match &variables.node {
            Node::Matrix(rows) => {
                let mut keys = Vec::new();
                for entry in rows.iter().flatten() {
                    keys.extend(self.keys(entry, surrounding, frame)?);
                }
                Ok(keys)
            }
            Node::Name(name) => match scope.get(name).map(|entry| &entry.meaning) {
                Some(Meaning::Definition { expression, .. }) => {
                    self.keys(expression, surrounding, 0)
                }
                _ => Ok(vec![self.key(variables, surrounding, frame)?]),
            },
            _ => Ok(vec![self.key(variables, surrounding, frame)?]),
        }
    }

    /// f⁽ᵏ⁾(a + n) = Σ f⁽ᵏ⁺ʲ⁾(a) nʲ/j! for a nilpotent n.
    fn function(
        &mut self,
        name: &Name,
        order: u32,
        argument: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<Table, Failure> {
        let sample = self.scalar(argument, surrounding, frame)?;
        let step = sample.number.step();
        let (mut sum, mut power, mut order) = (Number::default(), Number::from(1), order);
        let mut j = 1;
        while !power.is_zero() {
            let slope = self.function_value(name, order, argument, surrounding, frame)?;
            sum = sum.sum(&self.point.extension.product(&slope, &power));
            power = self.point.extension.product(&power, &step);
            power = power.scale(&(Rational::ONE / Rational::from(j)));
            order += 1;
            j += 1;
        }
        Ok(single(sum))
    }

    /// f⁽ᵏ⁾ at the point itself.
    fn function_value(
        &mut self,
        name: &Name,
        order: u32,
        argument: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<Number, Failure> {
        let mut level = surrounding;
        while level > 0 {
            let parent = self.surroundings[level].parent;
            if let Change::Replace {
                functions,
                frame: outside,
                ..
            } = &self.surroundings[level].change
            {
                let outside = *outside;
                let replaced = functions
                    .iter()
                    .find(|(known, k, _)| *known == name && *k == order);
                if let Some((known, _, value)) = replaced.copied() {
                    // A replacement names the value that the function has without the replacement.
                    let reference = self.reference(known)?;
                    let lifted = self.lift(surrounding, level);
                    let here = argument_of(&self.scalar(argument, lifted, frame)?);
                    if here == argument_of(&self.scalar(reference, parent, 0)?) {
                        return Ok(self.scalar(value, parent, outside)?.number);
                    }
                }
            }
            level = parent;
        }
        let key = self.function_key(name, order, argument, surrounding, frame)?;
        Ok(self.look_up(&key, surrounding)?.number)
    }

    /// The key of f⁽ᵏ⁾ at an argument; the reference argument has a key of its own, under which the
    /// value is shown as `C_D`.
    fn function_key(
        &mut self,
        name: &Name,
        order: u32,
        argument: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<Key, Failure> {
        let here = argument_of(&self.scalar(argument, surrounding, frame)?);
        let reference = argument_of(&self.scalar(self.reference(name)?, 0, 0)?);
        let argument = if here == reference {
            Argument::Reference
        } else {
            here
        };
        Ok(Key::Function(name.ascii.clone(), order, argument))
    }

    /// The surrounding without the change of one of its levels.
    fn lift(&mut self, surrounding: usize, level: usize) -> usize {
        let parent = self.surroundings[surrounding].parent;
        if surrounding == level {
            return parent;
        }
        let parent = self.lift(parent, level);
        let change = self.surroundings[surrounding].change.clone();
        self.within(parent, change)
    }

    /// Where the bare name of a function is taken.
    fn reference(&self, name: &Name) -> Result<&'a Expression, Failure> {
        let scope = self.scope;
        match scope.get(name).map(|entry| &entry.meaning) {
            Some(Meaning::Function { reference, .. }) => Ok(reference),
            _ => Err(format!("{name} is no function")),
        }
    }

    fn binary(
        &mut self,
        operator: BinaryOperator,
        left: &'a Expression,
        right: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<Table, Failure> {
        let a = self.table(left, surrounding, frame)?;
        let b = self.table(right, surrounding, frame)?;
        match operator {
            BinaryOperator::Add | BinaryOperator::Subtract => {
                let sign = if operator == BinaryOperator::Add {
                    1
                } else {
                    -1
                };
                let rows = a.iter().zip(&b);
                Ok(rows
                    .map(|(a, b)| a.iter().zip(b).map(|(a, b)| add(a, b, sign)).collect())
                    .collect())
            }
            BinaryOperator::Multiply => Ok(self.multiply(&a, &b)),
            BinaryOperator::Divide => {
                let below = self.only(&b)?;
                let inverse = self
                    .point
                    .extension
                    .inverse(&below)
                    .ok_or("a divisor vanishes")?;
                Ok(self.multiply(&a, &single(inverse)))
            }
            BinaryOperator::Power => {
                let exponent = self
                    .only(&b)?
                    .as_rational()
                    .ok_or("an exponent is no number")?;
                self.power(&a, &exponent)
            }
        }
    }

    fn only(&self, table: &Table) -> Result<Number, Failure> {
        match (table.len(), table.first().map(Vec::as_slice)) {
            (1, Some([sample])) => Ok(sample.number.clone()),
            _ => Err("a single number is needed".into()),
        }
    }

    fn multiply(&self, a: &Table, b: &Table) -> Table {
        let extension = &self.point.extension;
        let is_single = |table: &Table| table.len() == 1 && table[0].len() == 1;
        let scaled = |factor: &Sample, table: &Table| {
            each(table, |entry| {
                let number = extension.product(&factor.number, &entry.number);
                // Whole multiples of an angle are angles.
                let whole = |sample: &Sample| sample.number.as_rational().filter(Rational::is_int);
                let angle = match (whole(factor), &entry.angle, whole(entry), &factor.angle) {
                    (Some(k), Some(tag), _, _) | (_, _, Some(k), Some(tag)) => {
                        let k = i64::try_from(k.numerator().clone()).ok();
                        k.map(|k| combine(tag, &Tag::new(), k))
                    }
                    _ => None,
                };
                Sample { number, angle }
            })
        };
        if is_single(a) {
            return scaled(&a[0][0], b);
        }
        if is_single(b) {
            return scaled(&b[0][0], a);
        }
        let entry = |row: &[Sample], column: usize| {
            let terms = row
                .iter()
                .zip(b)
                .map(|(x, line)| extension.product(&x.number, &line[column].number));
            Sample::from(terms.fold(Number::default(), |sum, term| sum.sum(&term)))
        };
        let width = b.first().map_or(0, Vec::len);
        a.iter()
            .map(|row| (0..width).map(|column| entry(row, column)).collect())
            .collect()
    }

    fn power(&mut self, base: &Table, exponent: &Rational) -> Result<Table, Failure> {
        if base.len() > 1 {
            let count = i64::try_from(exponent.numerator().clone()).map_err(|_| "too large")?;
            let identity: Table = identity(base.len());
            if count < 0 {
                return self.solve(base, &identity);
            }
            return Ok((0..count).fold(identity, |power, _| self.multiply(&power, base)));
        }
        let number = self.only(base)?;
        let twice = exponent + exponent;
        let (mut base, mut count) = if exponent.is_int() {
            (number, exponent.numerator().clone())
        } else {
            (self.root(&number)?, twice.numerator().clone())
        };
        if count < Integer::ZERO {
            base = self
                .point
                .extension
                .inverse(&base)
                .ok_or("a divisor vanishes")?;
            count = -count;
        }
        let count = u64::try_from(count).map_err(|_| "an exponent is too large")?;
        Ok(single(self.point.extension.power(&base, count)))
    }

    fn root(&mut self, square: &Number) -> Result<Number, Failure> {
        if square
            .base()
            .as_rational()
            .is_some_and(|square| square < Rational::ZERO)
        {
            return Err("the root of a negative number".into());
        }
        let root = self.point.extension.square_root(square);
        root.ok_or("a root that exact numbers cannot follow".into())
    }

    fn solve(&self, matrix: &Table, right: &Table) -> Result<Table, Failure> {
        let solved = eliminate(&numbers(matrix), &numbers(right), &self.point.extension);
        match solved {
            Some((_, solution)) if !solution.is_empty() => Ok(samples(solution)),
            _ => Err("a matrix is singular".into()),
        }
    }

    fn call(
        &mut self,
        function: &'a Name,
        order: u32,
        arguments: &'a [Expression],
        surrounding: usize,
        frame: usize,
    ) -> Result<Table, Failure> {
        let scope = self.scope;
        match (scope.get(function).map(|entry| &entry.meaning), arguments) {
            (Some(Meaning::Function { .. }), [argument]) => {
                self.function(function, order, argument, surrounding, frame)
            }
            (
                Some(Meaning::Template {
                    arguments: names,
                    expression,
                }),
                _,
            ) => {
                let names = names.iter().map(|name| name.ascii.as_str());
                let arguments = names.zip(arguments).collect();
                let inside = index_of(
                    &mut self.frames,
                    Frame {
                        arguments,
                        caller: frame,
                    },
                );
                self.table(expression, surrounding, inside)
            }
            (Some(_), _) => Err(format!("{function} is no function")),
            (None, _) => self.built_in(&function.ascii, arguments, surrounding, frame),
        }
    }

    fn built_in(
        &mut self,
        function: &str,
        arguments: &'a [Expression],
        surrounding: usize,
        frame: usize,
    ) -> Result<Table, Failure> {
        match (function, arguments) {
            ("sin" | "cos" | "tan" | "cot", [angle]) => {
                let angle = self.scalar(angle, surrounding, frame)?;
                let (cosine, sine) = self.circular(&angle)?;
                let (above, below) = match function {
                    "sin" => (sine, Number::from(1)),
                    "cos" => (cosine, Number::from(1)),
                    "tan" => (sine, cosine),
                    _ => (cosine, sine),
                };
                let inverse = self
                    .point
                    .extension
                    .inverse(&below)
                    .ok_or("a divisor vanishes")?;
                Ok(single(self.point.extension.product(&above, &inverse)))
            }
            ("sqrt", [square]) => {
                let square = self.scalar(square, surrounding, frame)?.number;
                Ok(single(self.root(&square)?))
            }
            ("angle", [x, y]) => {
                let x = self.scalar(x, surrounding, frame)?.number;
                let y = self.scalar(y, surrounding, frame)?.number;
                Ok(vec![vec![self.direction(&x, &y)?]])
            }
            ("dt", [inner]) => {
                let index = self.nilpotents;
                let step = self.nilpotent()?;
                let inside = self.within(surrounding, Change::Time(step));
                let table = self.table(inner, inside, frame)?;
                self.nilpotents = index;
                Ok(each(&table, |entry| {
                    Sample::from(entry.number.coefficient(index..index + 1))
                }))
            }
            ("d", [value, variables]) => self.jacobian(value, variables, surrounding, frame),
            ("det", [matrix]) => {
                let matrix = self.table(matrix, surrounding, frame)?;
                Ok(single(determinant(
                    &numbers(&matrix),
                    &self.point.extension,
                )))
            }
            ("adjugate", [matrix]) => {
                let matrix = self.table(matrix, surrounding, frame)?;
                Ok(samples(adjugate(&numbers(&matrix), &self.point.extension)))
            }
            ("inverse", [matrix]) => {
                let matrix = self.table(matrix, surrounding, frame)?;
                self.solve(&matrix, &identity(matrix.len()))
            }
            ("solve", [matrix, right]) => {
                let matrix = self.table(matrix, surrounding, frame)?;
                let right = self.table(right, surrounding, frame)?;
                self.solve(&matrix, &right)
            }
            ("kernel", [matrix]) => {
                let matrix = self.table(matrix, surrounding, frame)?;
                let found = null_space(&numbers(&matrix), &self.point.extension);
                Ok(samples(found.ok_or("a pivot is not invertible")?))
            }
            ("transpose", [matrix]) => {
                let matrix = self.table(matrix, surrounding, frame)?;
                let width = matrix.first().map_or(0, Vec::len);
                let column = |place: usize| matrix.iter().map(|row| row[place].clone()).collect();
                Ok((0..width).map(column).collect())
            }
            ("trace", [matrix]) => {
                let matrix = self.table(matrix, surrounding, frame)?;
                let diagonal = matrix
                    .iter()
                    .enumerate()
                    .map(|(place, row)| &row[place].number);
                Ok(single(
                    diagonal.fold(Number::default(), |sum, entry| sum.sum(entry)),
                ))
            }
            ("diagonal", entries) => {
                let mut table = identity(entries.len());
                for (place, entry) in entries.iter().enumerate() {
                    table[place][place] = self.scalar(entry, surrounding, frame)?;
                }
                Ok(table)
            }
            ("identity", [size]) => Ok(identity(self.natural(size, surrounding, frame)?)),
            ("zero", [rows, columns]) => {
                let rows = self.natural(rows, surrounding, frame)?;
                let columns = self.natural(columns, surrounding, frame)?;
                Ok(vec![vec![Sample::from(Number::default()); columns]; rows])
            }
            ("row", [matrix, place]) => {
                let matrix = self.table(matrix, surrounding, frame)?;
                let place = self.natural(place, surrounding, frame)?;
                select(
                    &matrix,
                    &[place],
                    &(1..=matrix[0].len()).collect::<Vec<_>>(),
                )
            }
            ("column", [matrix, place]) => {
                let matrix = self.table(matrix, surrounding, frame)?;
                let place = self.natural(place, surrounding, frame)?;
                select(&matrix, &(1..=matrix.len()).collect::<Vec<_>>(), &[place])
            }
            ("submatrix", [matrix, rows, columns]) => {
                let matrix = self.table(matrix, surrounding, frame)?;
                let rows = self.places(rows, surrounding, frame)?;
                let columns = self.places(columns, surrounding, frame)?;
                select(&matrix, &rows, &columns)
            }
            ("coefficient", [polynomial, variable, power]) => {
                let power = self.natural(power, surrounding, frame)?;
                let key = self.key(variable, surrounding, frame)?;
                let coefficients = self.interpolation(polynomial, &key, surrounding, frame)?;
                Ok(single(coefficients.get(power).cloned().unwrap_or_default()))
            }
            ("hurwitz", [polynomial, variable, size]) => {
                let size = self.natural(size, surrounding, frame)?;
                let key = self.key(variable, surrounding, frame)?;
                let coefficients = self.interpolation(polynomial, &key, surrounding, frame)?;
                let degree = coefficients.len() - 1;
                let entry = |row: usize, column: usize| {
                    let index = (2 * column + 2)
                        .checked_sub(row + 1)
                        .filter(|index| *index <= degree);
                    index
                        .map(|index| coefficients[degree - index].clone())
                        .unwrap_or_default()
                };
                let row = |row: usize| (0..size).map(|column| entry(row, column)).collect();
                let matrix: Vec<Vec<Number>> = (0..size).map(row).collect();
                Ok(single(determinant(&matrix, &self.point.extension)))
            }
            ("truncate", [value, small, order]) => {
                let order = self.natural(order, surrounding, frame)? as u32;
                let keys = self.keys(small, surrounding, frame)?.into_iter().collect();
                let parts = self.expansion(value, keys, order, surrounding, frame)?;
                let sum = parts.into_iter().reduce(|sum, part| {
                    let rows = sum.iter().zip(&part);
                    rows.map(|(a, b)| a.iter().zip(b).map(|(a, b)| a.sum(b)).collect())
                        .collect()
                });
                Ok(samples(sum.unwrap_or_default()))
            }
            _ => Err(format!("{function} cannot be evaluated at a point")),
        }
    }

    fn places(
        &mut self,
        list: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<Vec<usize>, Failure> {
        match &list.node {
            Node::Matrix(rows) => rows
                .iter()
                .flatten()
                .map(|entry| self.natural(entry, surrounding, frame))
                .collect(),
            _ => Ok(vec![self.natural(list, surrounding, frame)?]),
        }
    }

    /// (cos, sin) of an angle a + n: by the addition formulas from those of a, and by their finite
    /// series from those of a nilpotent n.
    fn circular(&mut self, angle: &Sample) -> Result<(Number, Number), Failure> {
        let tag = angle.angle.as_ref().ok_or("the sine of what is no angle")?;
        let (cosine, sine) = self
            .point
            .circle_of(tag)
            .ok_or("too large a multiple of an angle")?;
        let step = angle.number.step();
        let extension = &self.point.extension;
        let (mut even, mut odd) = (Number::from(1), Number::default());
        let mut power = step.clone();
        let mut k = 1;
        while !power.is_zero() {
            power = power.scale(&(Rational::ONE / Rational::from(k)));
            match k % 4 {
                1 => odd = odd.sum(&power),
                2 => even = even.difference(&power),
                3 => odd = odd.difference(&power),
                _ => even = even.sum(&power),
            }
            power = extension.product(&power, &step);
            k += 1;
        }
        let product = |a: &Number, b: &Number| extension.product(a, b);
        Ok((
            product(&cosine, &even).difference(&product(&sine, &odd)),
            product(&sine, &even).sum(&product(&cosine, &odd)),
        ))
    }

    /// The angle of (x, y): that of the point itself, and the finite series of the arctangent for the
    /// nilpotent rest.
    fn direction(&mut self, x: &Number, y: &Number) -> Result<Sample, Failure> {
        let (x0, y0) = (x.base(), y.base());
        let square = {
            let extension = &self.point.extension;
            extension
                .product(&x0, &x0)
                .sum(&extension.product(&y0, &y0))
        };
        let length = self.root(&square)?;
        let inverse = self
            .point
            .extension
            .inverse(&length)
            .ok_or("the vector vanishes")?;
        let product = |a: &Number, b: &Number| self.point.extension.product(a, b);
        let (cosine, sine) = (product(&x0, &inverse), product(&y0, &inverse));
        let across = product(&cosine, y).difference(&product(&sine, x));
        let along = product(&cosine, x).sum(&product(&sine, y));
        let below = self
            .point
            .extension
            .inverse(&along)
            .ok_or("the vector vanishes")?;
        let tangent = product(&across, &below);
        let square = product(&tangent, &tangent).negative();
        let (mut turn, mut power, mut k) = (Number::default(), tangent, 1);
        while !power.is_zero() {
            turn = turn.sum(&power.scale(&(Rational::ONE / Rational::from(k))));
            power = self.point.extension.product(&power, &square);
            k += 2;
        }
        let tag = self.tag_of(&cosine, &sine)?;
        // The measure of the angle at the point itself, as for every other angle.
        let number = tag.iter().fold(turn, |sum, (atom, count)| {
            let name = match atom {
                Atom::Named(name) => name.clone(),
                Atom::Direction(index) => format!("direction {index}"),
            };
            let measure = self.point.value(&Key::Symbol(name, 0));
            sum.sum(&measure.scale(&Rational::from(count.clone())))
        });
        Ok(Sample {
            number,
            angle: Some(tag),
        })
    }

    /// The sum of declared angles with the given cosine and sine, or a new atom for it.
    fn tag_of(&mut self, cosine: &Number, sine: &Number) -> Result<Tag, Failure> {
        if *cosine == Number::from(1) {
            return Ok(Tag::new());
        }
        let scope = self.scope;
        for entry in scope.entries() {
            if self.is_angular(&entry.name.ascii) {
                let atom = Atom::Named(entry.name.ascii.clone());
                if self.point.circle(&atom) == (cosine.clone(), sine.clone()) {
                    return Ok(Tag::from([(atom, Integer::ONE)]));
                }
            }
        }
        let atom = self.point.direction(cosine, sine);
        Ok(Tag::from([(atom, Integer::ONE)]))
    }

    fn jacobian(
        &mut self,
        value: &'a Expression,
        variables: &'a Expression,
        surrounding: usize,
        frame: usize,
    ) -> Result<Table, Failure> {
        let mut columns: Vec<Vec<Number>> = Vec::new();
        for key in self.keys(variables, surrounding, frame)? {
            let index = self.nilpotents;
            let step = self.nilpotent()?;
            let inside = self.within(surrounding, Change::Shift(key, step));
            let table = self.table(value, inside, frame)?;
            self.nilpotents = index;
            let entries = table.iter().flatten();
            columns.push(
                entries
                    .map(|entry| entry.number.coefficient(index..index + 1))
                    .collect(),
            );
        }
        let height = columns.first().map_or(0, Vec::len);
        let row = |row: usize| columns.iter().map(|column| column[row].clone()).collect();
        Ok(samples((0..height).map(row).collect()))
    }

    /// The parts of degree 0, …, `order` in small symbols: with q(ε₁ + … + εₙ) in place of q, the
    /// part of degree k is the coefficient of ε₁…ε_k over k!.
    fn expansion(
        &mut self,
        value: &'a Expression,
        small: BTreeSet<Key>,
        order: u32,
        surrounding: usize,
        frame: usize,
    ) -> Result<Vec<Vec<Vec<Number>>>, Failure> {
        let first = self.nilpotents;
        let mut step = Number::default();
        for _ in 0..order {
            step = step.sum(&self.nilpotent()?);
        }
        let inside = self.within(surrounding, Change::Scale(small, step));
        let table = self.table(value, inside, frame)?;
        self.nilpotents = first;
        let mut factorial = Rational::ONE;
        let mut parts = Vec::new();
        for degree in 0..=order {
            if degree > 0 {
                factorial /= Rational::from(degree);
            }
            let part = |sample: &Sample| {
                let coefficient = sample.number.coefficient(first..first + degree);
                coefficient.without(first..first + order).scale(&factorial)
            };
            parts.push(
                table
                    .iter()
                    .map(|row| row.iter().map(part).collect())
                    .collect(),
            );
        }
        Ok(parts)
    }

    /// The coefficients of a polynomial from its values at a, a + 1, a + 2, …, by Newton's divided
    /// differences, until three more values change nothing.
    fn interpolation(
        &mut self,
        polynomial: &'a Expression,
        key: &Key,
        surrounding: usize,
        frame: usize,
    ) -> Result<Vec<Number>, Failure> {
        let mut differences: Vec<Number> = Vec::new();
        let mut newton: Vec<Number> = Vec::new();
        // The nodes begin where no document's polynomial is likely to have its zeros.
        let first = self.point.first_node();
        for node in 0..MOST_NODES {
            let place = Number::from(first + node);
            let inside = self.within(surrounding, Change::Set(key.clone(), place));
            // f[xₙ₋ⱼ, …, xₙ] = (f[xₙ₋ⱼ₊₁, …, xₙ] − f[xₙ₋ⱼ, …, xₙ₋₁])/j
            let mut current = vec![self.scalar(polynomial, inside, frame)?.number];
            for (j, previous) in (1..).zip(&differences) {
                let change = current[j - 1].difference(previous);
                current.push(change.scale(&(Rational::ONE / Rational::from(j))));
            }
            newton.extend(current.last().cloned());
            differences = current;
            if newton.len() > 3 && newton.iter().rev().take(3).all(Number::is_zero) {
                return Ok(expand_newton(&newton, first));
            }
        }
        Err("no polynomial of a degree below 40".into())
    }
}

/// Σ cₖ (λ − a)(λ − a − 1)…(λ − a − k + 1) by powers of λ, by Horner's rule.
fn expand_newton(newton: &[Number], first: i64) -> Vec<Number> {
    let mut coefficients: Vec<Number> = Vec::new();
    for (index, leading) in newton.iter().enumerate().rev() {
        let node = index as i64 + first;
        // p ← p·(λ − node) + c
        let mut next = vec![Number::default(); coefficients.len() + 1];
        for (power, coefficient) in coefficients.iter().enumerate() {
            next[power + 1] = next[power + 1].sum(coefficient);
            next[power] = next[power].difference(&coefficient.scale(&Rational::from(node)));
        }
        next[0] = next[0].sum(leading);
        coefficients = next;
    }
    while coefficients.len() > 1 && coefficients.last().is_some_and(Number::is_zero) {
        coefficients.pop();
    }
    coefficients
}

/// Where an item stands in a list, which it joins if it is new.
fn index_of<T: PartialEq>(list: &mut Vec<T>, item: T) -> usize {
    list.iter()
        .position(|known| *known == item)
        .unwrap_or_else(|| {
            list.push(item);
            list.len() - 1
        })
}

fn argument_of(sample: &Sample) -> Argument {
    match &sample.angle {
        Some(tag) => Argument::Angle(tag.clone()),
        None => Argument::Number(sample.number.base()),
    }
}

/// a + k·b of tags: used with k = ±1, and with b = 0 for k·a.
fn combine(a: &Tag, b: &Tag, k: i64) -> Tag {
    let mut tag = Tag::new();
    let factor = Integer::from(k);
    if b.is_empty() {
        tag.extend(
            a.iter()
                .map(|(atom, count)| (atom.clone(), count * &factor)),
        );
    } else {
        tag.clone_from(a);
        for (atom, count) in b {
            *tag.entry(atom.clone()).or_insert(Integer::ZERO) += count * &factor;
        }
    }
    tag.retain(|_, count| !count.is_zero());
    tag
}

fn add(a: &Sample, b: &Sample, sign: i64) -> Sample {
    let number = if sign > 0 {
        a.number.sum(&b.number)
    } else {
        a.number.difference(&b.number)
    };
    let angle = match (&a.angle, &b.angle) {
        (Some(a), Some(b)) if b.is_empty() => Some(a.clone()),
        (Some(a), Some(b)) => Some(combine(a, b, sign)),
        _ => None,
    };
    Sample { number, angle }
}

fn each(table: &Table, image: impl Fn(&Sample) -> Sample) -> Table {
    table
        .iter()
        .map(|row| row.iter().map(&image).collect())
        .collect()
}

fn identity(size: usize) -> Table {
    let entry = |row: usize, column: usize| Sample::from(Number::from(i64::from(row == column)));
    (0..size)
        .map(|row| (0..size).map(|column| entry(row, column)).collect())
        .collect()
}

/// Rows and columns counted from 1.
fn select(table: &Table, rows: &[usize], columns: &[usize]) -> Result<Table, Failure> {
    let entry = |row: usize, column: usize| -> Option<Sample> {
        table
            .get(row.checked_sub(1)?)?
            .get(column.checked_sub(1)?)
            .cloned()
    };
    rows.iter()
        .map(|row| columns.iter().map(|column| entry(*row, *column)).collect())
        .collect::<Option<Table>>()
        .ok_or("no such row or column".into())
}
