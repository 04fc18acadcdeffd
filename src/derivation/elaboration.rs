//! Expressions become elements of the ring: the first of the two routes to a verdict.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::arithmetic::{Arithmetic, Division};
use crate::algebra::budget::Budget;
use crate::algebra::determinant::{adjugate, determinant};
use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::matrix::Matrix;
use crate::algebra::number::Rational;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::Ring;
use crate::algebra::sign::Signs;
use crate::algebra::substitution::Substitution;
use crate::algebra::symbol::Symbol;

use super::condition::Conditions;
use super::diagnostic::{Diagnostic, DiagnosticKind, nearest};
use super::notation::Notation;
use super::presentation::Presenter;
use super::quantity::{Quantities, Quantity, QuantityError, Value};
use super::scope::{Meaning, Scope};
use super::syntax::{BinaryOperator, Expression, Name, Node, Place, Replacement, Span};
use super::unit::{Unit, small_integer};

/// The largest side of a matrix.
const MOST_ROWS: usize = 64;

/// How deep definitions with arguments may call each other.
const DEEPEST_CALL: usize = 32;

/// How deep expressions may be nested, calls included; what evaluates them is recursive.
const DEEPEST_NESTING: usize = 600;

/// The most steps of one statement are spent on so many parts of expressions.
const MOST_PARTS: u64 = 200_000;

/// The highest order of an expansion in small quantities.
const HIGHEST_ORDER: u32 = 12;

/// The most minors that one determinant may need.
const MOST_MINORS: usize = 20_000;

/// The most terms that the entries of one value may have together.
const MOST_TERMS_OF_A_VALUE: usize = 1_000_000;

/// Turns expressions into elements of its ring, with units, and collects the conditions under which
/// they exist.
#[derive(Debug)]
pub struct Elaborator {
    /// The ring of the document.
    pub ring: Ring,
    /// The names of the document.
    pub scope: Scope,
    /// What the steps since the last [`Elaborator::fresh`] needed.
    pub conditions: Conditions,
    arguments: Vec<BTreeMap<String, Value>>,
    nesting: usize,
}

impl Elaborator {
    /// An elaborator that knows no names; every statement may take as many steps as the budget has.
    pub fn new(budget: Budget) -> Self {
        Elaborator {
            ring: Ring::new(budget),
            scope: Scope::default(),
            conditions: Conditions::default(),
            arguments: Vec::new(),
            nesting: 0,
        }
    }

    /// Begins a new statement: a full budget, no conditions.
    pub fn fresh(&mut self) {
        self.ring.budget().refill();
        self.conditions = Conditions::default();
        self.arguments.clear();
        self.nesting = 0;
    }

    /// What an expression is.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] at the part that has no value.
    pub fn value(&mut self, expression: &Expression) -> Result<Value, Diagnostic> {
        let span = &expression.span;
        let budget = self.ring.budget();
        budget
            .spend(budget.limit() / MOST_PARTS)
            .map_err(|exhausted| algebra(AlgebraError::Exhausted(exhausted), span))?;
        if self.nesting >= DEEPEST_NESTING {
            let message = "calls and brackets are nested too deeply";
            return Err(
                Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
                    .with_label(format!("more than {DEEPEST_NESTING} within each other"))
                    .with_help("give names to parts with `:=`"),
            );
        }
        self.nesting += 1;
        let value = self.value_of_node(expression, span);
        self.nesting -= 1;
        let value = value?;
        let terms =
            |entry: &Quantity| entry.value.numerator().len() + entry.value.denominator().len();
        if value.entries().iter().map(terms).sum::<usize>() > MOST_TERMS_OF_A_VALUE {
            let message = format!(
                "this is too large to compute: its entries have more than {MOST_TERMS_OF_A_VALUE} terms"
            );
            return Err(
                Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
                    .with_label("given up here")
                    .with_help("compute with fewer entries at a time"),
            );
        }
        Ok(value)
    }

    fn value_of_node(&mut self, expression: &Expression, span: &Span) -> Result<Value, Diagnostic> {
        match &expression.node {
            Node::Number(number) => Ok(Quantity::number(number.clone()).scalar()),
            Node::Name(name) => self.named(name, span),
            Node::Derivative(name, order) => self.function_value(name, *order, None, span),
            Node::Negative(inner) => {
                let value = self.value(inner)?;
                Ok(value.map(|entry| Quantities(&self.ring).negative(entry)))
            }
            Node::Binary(operator, left, right) => self.binary(*operator, left, right, span),
            Node::Call {
                function,
                order,
                arguments,
            } => self.call(function, *order, arguments, span),
            Node::Matrix(rows) => self.blocks(rows, span),
            Node::Index(matrix, indices) => self.entry(matrix, indices, span),
            Node::At(inner, place) => self.at(inner, place, span),
        }
    }

    /// What an expression with one entry is.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where it has no value or more than one entry.
    pub fn scalar(&mut self, expression: &Expression) -> Result<Quantity, Diagnostic> {
        let value = self.value(expression)?;
        if value.shape() != (1, 1) {
            let (rows, columns) = value.shape();
            return Err(shape(
                &expression.span,
                format!("this is a {rows}×{columns} matrix"),
            )
            .with_help("a single number is needed here; take an entry with [row, column]"));
        }
        Ok(value.at(0, 0).clone())
    }

    /// The free symbol that an expression stands for.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where it is anything else.
    pub fn symbol(&mut self, quantity: &Quantity, span: &Span) -> Result<Symbol, Diagnostic> {
        let single = self.ring.as_symbol(&quantity.value).filter(|symbol| {
            matches!(
                self.ring.generator(*symbol),
                Generator::Constant { .. }
                    | Generator::Angle { .. }
                    | Generator::Coordinate { .. }
                    | Generator::FunctionValue { .. }
            )
        });
        single.ok_or_else(|| {
            let message = "a variable is needed here";
            Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                .with_label("not a parameter, an angle, a coordinate, its time derivative or a function's value")
                .with_help("give the bare name of a variable, such as `x` or `dt(x)`")
        })
    }

    fn named(&mut self, name: &Name, span: &Span) -> Result<Value, Diagnostic> {
        if let Some(value) = self
            .arguments
            .last()
            .and_then(|known| known.get(&name.ascii))
        {
            return Ok(value.clone());
        }
        match &self.scope.find(name, span)?.meaning {
            Meaning::Symbol { symbol, unit, .. } => {
                Ok(Quantity::new(self.ring.element(*symbol), unit.clone()).scalar())
            }
            Meaning::Function { .. } => self.function_value(name, 0, None, span),
            Meaning::Definition {
                value, conditions, ..
            } => {
                self.conditions.extend(conditions);
                Ok(value.clone())
            }
            Meaning::Template { arguments, .. } => {
                let count = arguments.len();
                let message = format!("`{name}` needs arguments");
                Err(
                    Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                        .with_label(format!("{count} wanted"))
                        .with_help(format!("write `{name}(…)`")),
                )
            }
            Meaning::Substitution { .. } => {
                let message = format!("`{name}` is a substitution, not a value");
                Err(
                    Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                        .with_label("used as a value")
                        .with_help(format!("write `… at {name}`")),
                )
            }
        }
    }

    /// f⁽ᵏ⁾ at the given argument, or at its reference argument.
    fn function_value(
        &mut self,
        name: &Name,
        order: u32,
        argument: Option<Quantity>,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let Meaning::Function {
            argument: reference,
            unit,
            ..
        } = &self.scope.find(name, span)?.meaning
        else {
            let message = format!("`{name}` is not declared as a function");
            return Err(
                Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                    .with_label("a prime asks for the derivative of a function")
                    .with_help(format!("declare it with `function {name} at … : …`")),
            );
        };
        let unit = unit.clone();
        let argument = argument.unwrap_or_else(|| reference.clone());
        let slope = match &argument.unit {
            Some(per) => per.inverse().power(&Rational::from(order)),
            None => Unit::one(),
        };
        let value = self
            .ring
            .function_value(&name.ascii, order, &argument.value)
            .map_err(|error| algebra(error, span))?;
        Ok(Quantity::new(value, unit.product(&slope)).scalar())
    }

    fn call(
        &mut self,
        function: &Name,
        order: u32,
        arguments: &[Expression],
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        match self.scope.get(function).map(|entry| entry.meaning.clone()) {
            Some(Meaning::Function { .. }) => {
                let [argument] = arguments else {
                    return Err(argument_count(function, 1, arguments.len(), span));
                };
                let argument = self.scalar(argument)?;
                self.function_value(function, order, Some(argument), span)
            }
            Some(Meaning::Template {
                arguments: names,
                expression,
            }) => {
                if names.len() != arguments.len() {
                    return Err(argument_count(function, names.len(), arguments.len(), span));
                }
                if self.arguments.len() >= DEEPEST_CALL {
                    let message = format!("`{function}` calls itself too deeply");
                    return Err(
                        Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
                            .with_label(format!("more than {DEEPEST_CALL} calls within each other"))
                            .with_help("a definition cannot call itself"),
                    );
                }
                let values: Result<Vec<Value>, Diagnostic> = arguments
                    .iter()
                    .map(|argument| self.value(argument))
                    .collect();
                let local = names
                    .into_iter()
                    .map(|name| name.ascii)
                    .zip(values?)
                    .collect();
                self.arguments.push(local);
                let value = self.value(&expression);
                self.arguments.pop();
                // A mistake in the definition's text may be one of this call.
                value.map_err(|error| match error.secondary.len() {
                    0..3 => {
                        error.with_secondary(span.clone(), format!("in this call of `{function}`"))
                    }
                    _ => error,
                })
            }
            Some(_) => {
                let message = format!("`{function}` is not a function");
                Err(
                    Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                        .with_label("called with arguments")
                        .with_help(format!("for a product write `{function}*(…)`")),
                )
            }
            None => self.built_in(function, order, arguments, span),
        }
    }

    fn binary(
        &mut self,
        operator: BinaryOperator,
        left: &Expression,
        right: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        if operator == BinaryOperator::Power {
            return self.power(left, right, span);
        }
        let (a, b) = (self.value(left)?, self.value(right)?);
        match operator {
            BinaryOperator::Add | BinaryOperator::Subtract => {
                if a.shape() != b.shape() {
                    return Err(mismatch("added", &a, &b, left, right, span));
                }
                let sum = a.zip_with(&b, |a, b| match operator {
                    BinaryOperator::Add => Quantities(&self.ring).sum(a, b),
                    _ => Quantities(&self.ring).difference(a, b),
                });
                sum.map_err(|error| sides(error, left, right, span))
            }
            BinaryOperator::Multiply => {
                let arithmetic = Quantities(&self.ring);
                let product = if a.shape() == (1, 1) {
                    b.try_map(|entry| arithmetic.product(a.at(0, 0), entry))
                } else if b.shape() == (1, 1) {
                    a.try_map(|entry| arithmetic.product(entry, b.at(0, 0)))
                } else if a.columns() == b.rows() {
                    a.product(&b, &arithmetic)
                } else {
                    return Err(mismatch("multiplied", &a, &b, left, right, span));
                };
                product.map_err(|error| sides(error, left, right, span))
            }
            BinaryOperator::Divide | BinaryOperator::Power => {
                if b.shape() != (1, 1) {
                    return Err(mismatch("divided", &a, &b, left, right, span)
                        .with_help("divide by a number, or multiply with `inverse(…)`"));
                }
                self.divide(&a, b.at(0, 0), &right.span)
            }
        }
    }

    /// Every entry divided by one quantity, which is required not to be 0.
    pub fn divide(&mut self, a: &Value, b: &Quantity, span: &Span) -> Result<Value, Diagnostic> {
        self.require_non_zero(&b.value, span)?;
        a.try_map(|entry| Quantities(&self.ring).quotient(entry, b))
            .map_err(|error| quantity(error, span))
    }

    /// Notes that an element must not be 0.
    pub fn require_non_zero(&mut self, element: &Fraction, span: &Span) -> Result<(), Diagnostic> {
        if element.is_zero() {
            return Err(algebra(AlgebraError::DivisionByZero, span));
        }
        self.conditions
            .require_non_zero(element, &self.ring)
            .map_err(|error| algebra(error, span))
    }

    fn power(
        &mut self,
        base: &Expression,
        exponent: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let number = self.scalar(exponent)?.value.as_constant();
        let Some(number) = number else {
            return Err(Diagnostic::new(
                DiagnosticKind::Unsupported,
                exponent.span.clone(),
                "an exponent must be a number",
            )
            .with_label("not a number")
            .with_help("integers and, of single quantities, halves are understood"));
        };
        let value = self.value(base)?;
        if let Some(count) = small_integer(&number) {
            return self.integer_power(&value, count, base, span);
        }
        let twice = &number + &number;
        match small_integer(&twice) {
            Some(halves) if value.shape() == (1, 1) => {
                let root = self.root(value.at(0, 0), span)?.scalar();
                self.integer_power(&root, halves, base, span)
            }
            _ => Err(Diagnostic::new(
                DiagnosticKind::Unsupported,
                exponent.span.clone(),
                format!("the exponent {number} is not supported"),
            )
            .with_label("neither an integer nor a half")
            .with_help("integers and, of single quantities, halves are understood")),
        }
    }

    fn integer_power(
        &mut self,
        base: &Value,
        exponent: i64,
        at: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        if base.shape() == (1, 1) {
            let base = base.at(0, 0);
            if exponent < 0 {
                self.require_non_zero(&base.value, &at.span)?;
            }
            let value = self
                .ring
                .power(&base.value, exponent)
                .map_err(|error| algebra(error, span))?;
            let unit = base
                .unit
                .as_ref()
                .map(|unit| unit.power(&Rational::from(exponent)));
            return Ok(Quantity {
                value,
                unit: if exponent == 0 {
                    Some(Unit::one())
                } else {
                    unit
                },
            }
            .scalar());
        }
        if !base.is_square() || !(-1..=8).contains(&exponent) {
            let (rows, columns) = base.shape();
            return Err(shape(
                span,
                format!("a {rows}×{columns} matrix to the power {exponent}"),
            )
            .with_help("square matrices have the powers −1, 0, 1, …, 8"));
        }
        if exponent < 0 {
            return self.inverse(base, &at.span);
        }
        let mut power = identity(base.rows());
        for _ in 0..exponent {
            power = power
                .product(base, &Quantities(&self.ring))
                .map_err(|error| quantity(error, span))?;
        }
        Ok(power)
    }

    /// A⁻¹ = adj A/|A|; |A| must not vanish.
    pub fn inverse(&mut self, matrix: &Value, span: &Span) -> Result<Value, Diagnostic> {
        if !matrix.is_square() {
            let (rows, columns) = matrix.shape();
            return Err(
                shape(span, format!("a {rows}×{columns} matrix has no inverse"))
                    .with_help("only square matrices have one"),
            );
        }
        let below = self.determinant(matrix, span)?;
        let above = self.adjugate(matrix, span)?;
        if below.value.is_zero() {
            let message = "the determinant of this matrix is identically 0";
            return Err(
                Diagnostic::new(DiagnosticKind::Singular, span.clone(), message)
                    .with_label("has no inverse")
                    .with_help("look at its null space with `kernel(…)`"),
            );
        }
        self.divide(&above, &below, span)
    }

    /// |A| of a square matrix.
    pub fn determinant(&self, matrix: &Value, span: &Span) -> Result<Quantity, Diagnostic> {
        check_minors(matrix, 1, span)?;
        determinant(matrix, &Quantities(&self.ring)).map_err(|error| quantity(error, span))
    }

    /// adj A of a square matrix.
    pub fn adjugate(&self, matrix: &Value, span: &Span) -> Result<Value, Diagnostic> {
        check_minors(matrix, matrix.rows().pow(2).div_ceil(50), span)?;
        adjugate(matrix, &Quantities(&self.ring)).map_err(|error| quantity(error, span))
    }

    /// √q, which is real for q ≥ 0.
    pub fn root(&mut self, square: &Quantity, span: &Span) -> Result<Quantity, Diagnostic> {
        let value = self
            .ring
            .square_root(&square.value)
            .map_err(|error| algebra(error, span))?;
        let signs = self
            .ring
            .signs(&square.value)
            .map_err(|error| algebra(error, span))?;
        if !signs.is_non_negative() {
            self.conditions
                .require_positive(&square.value, &self.ring)
                .map_err(|error| algebra(error, span))?;
        }
        let half = Rational::ONE / Rational::from(2);
        Ok(Quantity {
            value,
            unit: square.unit.as_ref().map(|unit| unit.power(&half)),
        })
    }

    /// A matrix of blocks: the entries of a row have equally many rows, the rows equally many columns.
    fn blocks(&mut self, rows: &[Vec<Expression>], span: &Span) -> Result<Value, Diagnostic> {
        let mut lines: Vec<Vec<Quantity>> = Vec::new();
        for row in rows {
            let mut band: Vec<Vec<Quantity>> = Vec::new();
            for (place, block) in row.iter().enumerate() {
                let value = self.value(block)?;
                if place == 0 {
                    band = vec![Vec::new(); value.rows()];
                } else if band.len() != value.rows() {
                    let message = "the blocks of a row have different heights";
                    return Err(shape(&block.span, message.into())
                        .with_label(format!("height {}, not {}", value.rows(), band.len()))
                        .with_help("blocks side by side have equally many rows"));
                }
                for (index, line) in band.iter_mut().enumerate() {
                    line.extend((0..value.columns()).map(|column| value.at(index, column).clone()));
                }
            }
            lines.extend(band);
        }
        let width = lines.first().map_or(0, Vec::len);
        if lines.iter().any(|line| line.len() != width) {
            let widths: Vec<String> = lines.iter().map(|line| line.len().to_string()).collect();
            return Err(
                shape(span, "the rows of a matrix have different lengths".into())
                    .with_label(format!("lengths {}", widths.join(", ")))
                    .with_help("`,` stands between the entries of a row, `;` between rows"),
            );
        }
        check_sides(lines.len(), width, span)?;
        Ok(Matrix::from_fn(lines.len(), width, |row, column| {
            lines[row][column].clone()
        }))
    }

    fn entry(
        &mut self,
        matrix: &Expression,
        indices: &[Expression],
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let value = self.value(matrix)?;
        let mut places = Vec::new();
        for index in indices {
            places.push(self.natural(index)?);
        }
        let (row, column) = match places[..] {
            [row, column] => (row, column),
            [place] if value.columns() == 1 => (place, 1),
            [place] if value.rows() == 1 => (1, place),
            _ => {
                return Err(
                    shape(span, "an entry of a matrix has a row and a column".into())
                        .with_help("write `M[1, 3]`, or `v[2]` for a vector"),
                );
            }
        };
        let (rows, columns) = value.shape();
        if row < 1 || column < 1 || row > rows || column > columns {
            return Err(shape(
                span,
                format!("a {rows}×{columns} matrix has no entry [{row}, {column}]"),
            )
            .with_help("rows and columns count from 1"));
        }
        Ok(value.at(row - 1, column - 1).clone().scalar())
    }

    /// A small natural number.
    pub fn natural(&mut self, expression: &Expression) -> Result<usize, Diagnostic> {
        let number = self.scalar(expression)?.value.as_constant();
        let small = number.as_ref().and_then(small_integer);
        small
            .and_then(|n| usize::try_from(n).ok())
            .filter(|n| *n <= MOST_ROWS)
            .ok_or_else(|| {
                let message = "a small whole number is needed here";
                Diagnostic::new(DiagnosticKind::Arguments, expression.span.clone(), message)
                    .with_label(format!("not one of 0, 1, …, {MOST_ROWS}"))
                    .with_help("places, sizes, powers and orders are plain numbers, and not larger")
            })
    }

    fn at(&mut self, inner: &Expression, place: &Place, span: &Span) -> Result<Value, Diagnostic> {
        let outer = std::mem::take(&mut self.conditions);
        let value = self.value(inner)?;
        let needed = std::mem::replace(&mut self.conditions, outer);
        let substitution = self.substitution(place, span)?;
        let needed = needed
            .substitute(&substitution, &mut self.ring)
            .map_err(|error| algebra(error, span))?;
        self.conditions.extend(&needed);
        value.try_map(|entry| {
            let image = self.ring.substitute(&entry.value, &substitution);
            Ok(Quantity {
                value: image.map_err(|error| algebra(error, span))?,
                unit: entry.unit.clone(),
            })
        })
    }

    /// What a place replaces by what.
    pub fn substitution(&mut self, place: &Place, span: &Span) -> Result<Substitution, Diagnostic> {
        let name = match place {
            Place::Replacements(replacements) => return self.read_replacements(replacements, span),
            Place::Named(name) => name,
        };
        let replacements = match self.scope.get(name).map(|entry| &entry.meaning) {
            Some(Meaning::Substitution {
                replacements,
                conditions,
                ..
            }) => {
                self.conditions.extend(conditions);
                replacements.clone()
            }
            Some(_) => {
                let message = format!("`{name}` is not a substitution");
                return Err(
                    Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                        .with_label("cannot be used behind `at`")
                        .with_help(
                            "write `at (x = 0)`, or declare the replacements with `substitution`",
                        ),
                );
            }
            None => {
                let substitutions = self
                    .scope
                    .entries()
                    .filter(|entry| matches!(entry.meaning, Meaning::Substitution { .. }));
                let names = substitutions.map(|entry| entry.name.unicode.as_str());
                let help = match nearest(&name.unicode, names) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("declare it with `substitution {name}: x = 0`"),
                };
                let message = format!("there is no substitution `{name}`");
                return Err(
                    Diagnostic::new(DiagnosticKind::UnknownName, span.clone(), message)
                        .with_label("unknown name behind `at`")
                        .with_help(help),
                );
            }
        };
        // The arguments of a call mean nothing where the substitution was declared.
        self.arguments.push(BTreeMap::new());
        let substitution = self.read_replacements(&replacements, span);
        self.arguments.pop();
        substitution
    }

    fn read_replacements(
        &mut self,
        replacements: &[Replacement],
        span: &Span,
    ) -> Result<Substitution, Diagnostic> {
        let mut substitution = Substitution::new();
        for Replacement { target, value } in replacements {
            let quantity = self.scalar(target)?;
            let symbol = self.symbol(&quantity, &target.span)?;
            let image = self.scalar(value)?;
            // A bare number is read in the SI unit of what it replaces.
            let bare = image.value.as_constant().is_some() && image.unit == Some(Unit::one());
            if !bare {
                super::quantity::common_unit(&quantity.unit, &image.unit)
                    .map_err(|error| sides(error, target, value, span))?;
            }
            if substitution.insert(symbol, image.value).is_some() {
                let message = "this is replaced twice";
                return Err(Diagnostic::new(
                    DiagnosticKind::Duplicate,
                    target.span.clone(),
                    message,
                )
                .with_label("replaced again")
                .with_help("replace it once; replacements in one `at` are carried out together"));
            }
        }
        self.respect_assumptions(&substitution, replacements, span)?;
        Ok(substitution)
    }

    /// Sees that what is assumed of symbols remains true of what replaces them: roots and signs were
    /// found with it.
    fn respect_assumptions(
        &mut self,
        substitution: &Substitution,
        replacements: &[Replacement],
        span: &Span,
    ) -> Result<(), Diagnostic> {
        let wrap = |error| algebra(error, span);
        let assumed: Vec<(Polynomial, Signs)> = {
            let assumptions = self.ring.assumptions();
            let symbols = substitution.keys();
            let of_symbols =
                symbols.map(|symbol| (Polynomial::symbol(*symbol), assumptions.of_symbol(*symbol)));
            of_symbols
                .chain(assumptions.polynomials().iter().cloned())
                .collect()
        };
        for (polynomial, signs) in assumed {
            if !substitution
                .keys()
                .any(|symbol| polynomial.contains(*symbol))
            {
                continue;
            }
            let element = Fraction::from(polynomial.clone());
            let image = self.ring.substitute(&element, substitution).map_err(wrap)?;
            if !self.ring.signs(&image).map_err(wrap)?.is_within(signs) {
                let shown = Presenter {
                    ring: &self.ring,
                    scope: &self.scope,
                }
                .polynomial(&polynomial);
                let shown = Notation::Unicode.expression(&shown.map_err(wrap)?);
                let place = replacements
                    .iter()
                    .find(|replacement| !replacement.value.span.is_empty());
                let place =
                    place.map_or(span.clone(), |replacement| replacement.value.span.clone());
                let message = format!("this need not respect what is assumed of {shown}");
                return Err(Diagnostic::new(DiagnosticKind::Arguments, place, message)
                    .with_label(format!("{shown} must stay {signs}"))
                    .with_help(
                        "replace it by something whose sign follows from the declarations",
                    ));
            }
        }
        Ok(())
    }
}

/// Allows an expansion up to terms of this order.
pub fn check_order(order: u32, span: &Span) -> Result<u32, Diagnostic> {
    if order <= HIGHEST_ORDER {
        return Ok(order);
    }
    let message = format!("expansions go up to order {HIGHEST_ORDER}");
    Err(
        Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
            .with_label(format!("order {order}"))
            .with_help("take coefficients of a polynomial with `coefficient(…)`"),
    )
}

/// Allows a matrix of so many rows and columns.
pub fn check_sides(rows: usize, columns: usize, span: &Span) -> Result<(), Diagnostic> {
    if rows.max(columns) <= MOST_ROWS {
        return Ok(());
    }
    let message = format!("a matrix may have {MOST_ROWS} rows and columns at most");
    Err(
        Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
            .with_label(format!(
                "this one would have {rows} rows and {columns} columns"
            ))
            .with_help("compute with blocks of it"),
    )
}

/// Counts the minors that an expansion along the rows needs, leaving out entries that are 0; each
/// counts as often as `weight` says.
fn check_minors(matrix: &Value, weight: usize, span: &Span) -> Result<(), Diagnostic> {
    let all = u64::MAX >> (u64::BITS as usize - matrix.columns().clamp(1, u64::BITS as usize));
    let (mut level, mut count) = (BTreeSet::from([all]), 0);
    for row in 0..matrix.rows() {
        let mut next = BTreeSet::new();
        for columns in level {
            for column in (0..matrix.columns()).filter(|column| columns & (1 << column) != 0) {
                if !matrix.at(row, column).value.is_zero() {
                    next.insert(columns & !(1 << column));
                }
            }
            if (count + next.len()) * weight > MOST_MINORS {
                let (rows, columns) = matrix.shape();
                let message = format!(
                    "this is too large to compute: the determinants of this {rows}×{columns} matrix \
                     need more than {MOST_MINORS} minors"
                );
                return Err(
                    Diagnostic::new(DiagnosticKind::Budget, span.clone(), message)
                        .with_label("given up here")
                        .with_help(
                            "break the matrix into blocks, or claim its determinant block by block",
                        ),
                );
            }
        }
        count += next.len();
        level = next;
    }
    Ok(())
}

/// The identity matrix.
pub fn identity(size: usize) -> Value {
    Matrix::from_fn(size, size, |row, column| {
        Quantity::number(if row == column {
            Rational::ONE
        } else {
            Rational::ZERO
        })
    })
}

/// Matrices do not fit together.
pub fn shape(span: &Span, message: String) -> Diagnostic {
    Diagnostic::new(DiagnosticKind::Shape, span.clone(), message)
}

fn mismatch(
    verb: &str,
    a: &Value,
    b: &Value,
    left: &Expression,
    right: &Expression,
    span: &Span,
) -> Diagnostic {
    let size = |value: &Value| format!("{}×{}", value.rows(), value.columns());
    shape(
        span,
        format!("a {} and a {} matrix cannot be {verb}", size(a), size(b)),
    )
    .with_label("the shapes do not fit")
    .with_help(
        "sums need equal shapes; a product needs as many columns on the left as rows on the right",
    )
    .with_secondary(left.span.clone(), size(a))
    .with_secondary(right.span.clone(), size(b))
}

/// A wrong number of arguments.
pub fn argument_count(function: &Name, wanted: usize, given: usize, span: &Span) -> Diagnostic {
    let message = format!("`{function}` takes {wanted} arguments, not {given}");
    let message = if wanted == 1 {
        message.replace("arguments", "argument")
    } else {
        message
    };
    Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
        .with_label(format!("{given} given"))
        .with_help(
            "separate arguments by `,`; the entries of a vector stand in one pair of brackets",
        )
}

/// What the algebra could not do, at a place of the document.
pub fn algebra(error: AlgebraError, span: &Span) -> Diagnostic {
    let (kind, message, label, help) = match &error {
        AlgebraError::DivisionByZero => (
            DiagnosticKind::DivisionByZero,
            "division by an expression that is identically 0".to_string(),
            "a divisor here is 0",
            "change the expression or the replacement, or cancel what vanishes before it does",
        ),
        AlgebraError::Exhausted(limit) => (
            DiagnosticKind::Budget,
            format!("this is too large to compute: {limit}"),
            "given up here",
            "break it into parts, or give names to what need not be expanded",
        ),
        AlgebraError::TooManySymbols => (
            DiagnosticKind::Budget,
            "the document has more symbols than the ring can hold".to_string(),
            "no symbol left",
            "split the document",
        ),
        AlgebraError::FractionalAngle => (
            DiagnosticKind::Unsupported,
            "the sine of this angle is no polynomial in the sines used before".to_string(),
            "a fraction of earlier angles",
            "mention the sine or cosine of the smaller angle earlier in the document",
        ),
        AlgebraError::NotAnAngle => (
            DiagnosticKind::Unsupported,
            "sines are taken of sums of angles with whole coefficients".to_string(),
            "not such an angle",
            "declare what stands here with `angle` or as a coordinate in rad",
        ),
        AlgebraError::UnknownSign => (
            DiagnosticKind::Unsupported,
            "the sign below this root, or of the root, cannot be told".to_string(),
            "a root of what may be negative, or of a square whose base may be",
            "state a sign with `parameter … > 0` or `assume … > 0`; for √−1 declare `imaginary i`",
        ),
    };
    Diagnostic::new(kind, span.clone(), message)
        .with_label(label)
        .with_help(help)
}

/// What the arithmetic of quantities could not do, at a place of the document.
pub fn quantity(error: QuantityError, span: &Span) -> Diagnostic {
    match error {
        QuantityError::Algebra(error) => algebra(error, span),
        QuantityError::Units(a, b) => units(&a, &b, span),
    }
}

/// Quantities of different units were added or compared.
pub fn units(a: &Unit, b: &Unit, span: &Span) -> Diagnostic {
    let message = format!("the units {a} and {b} do not fit together");
    Diagnostic::new(DiagnosticKind::Unit, span.clone(), message)
        .with_label(format!("{a} and {b}"))
        .with_help("only quantities of one unit can be added or compared")
}

fn sides(error: QuantityError, left: &Expression, right: &Expression, span: &Span) -> Diagnostic {
    match error {
        QuantityError::Units(a, b) => units(&a, &b, span)
            .with_label("added or compared here")
            .with_secondary(left.span.clone(), a.to_string())
            .with_secondary(right.span.clone(), b.to_string()),
        error => quantity(error, span),
    }
}
