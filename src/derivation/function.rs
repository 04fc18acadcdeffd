//! The built-in functions of documents.

use std::collections::BTreeMap;

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::differential::Differential;
use crate::algebra::fraction::Fraction;
use crate::algebra::linear_system::{null_space, solve};
use crate::algebra::matrix::Matrix;
use crate::algebra::number::Rational;
use crate::algebra::symbol::Symbol;

use super::diagnostic::{Diagnostic, DiagnosticKind, nearest};
use super::elaboration::{
    Elaborator, algebra, argument_count, check_order, check_sides, identity, quantity, shape,
};
use super::quantity::{Quantities, Quantity, Value};
use super::syntax::{Expression, Name, Span};
use super::unit::Unit;

/// What documents can call without declaring it.
pub const NAMES: [&str; 24] = [
    "sin",
    "cos",
    "tan",
    "cot",
    "sqrt",
    "angle",
    "dt",
    "d",
    "det",
    "transpose",
    "inverse",
    "adjugate",
    "trace",
    "diagonal",
    "identity",
    "zero",
    "row",
    "column",
    "submatrix",
    "kernel",
    "solve",
    "coefficient",
    "hurwitz",
    "truncate",
];

impl Elaborator {
    /// What a built-in function gives.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where there is no such function or it does not take these arguments.
    pub(super) fn built_in(
        &mut self,
        function: &Name,
        order: u32,
        arguments: &[Expression],
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        if order > 0 && NAMES.contains(&function.ascii.as_str()) {
            let message = format!("the built-in function `{function}` has no primes");
            return Err(
                Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                    .with_label("a prime asks for the derivative of a declared function")
                    .with_help("differentiate with `d(…, x)` or `dt(…)`"),
            );
        }
        let wrong_count = |wanted| Err(argument_count(function, wanted, arguments.len(), span));
        match (function.ascii.as_str(), arguments) {
            ("sin" | "cos" | "tan" | "cot", [angle]) => self.circular(&function.ascii, angle, span),
            ("sqrt", [square]) => {
                let square = self.scalar(square)?;
                Ok(self.root(&square, span)?.scalar())
            }
            ("angle", [x, y]) => self.direction(x, y, span),
            ("dt", [inner]) => {
                let value = self.value(inner)?;
                let per_second = self.per_second();
                value
                    .try_map(|entry| self.derivative(entry, &Differential::Time, &per_second, span))
            }
            ("d", [value, variables]) => self.jacobian(value, variables, span),
            ("det", [matrix]) => {
                let matrix = self.square(matrix)?;
                Ok(self.determinant(&matrix, span)?.scalar())
            }
            ("adjugate", [matrix]) => {
                let matrix = self.square(matrix)?;
                self.adjugate(&matrix, span)
            }
            ("inverse", [matrix]) => {
                let value = self.square(matrix)?;
                self.inverse(&value, &matrix.span)
            }
            ("transpose", [matrix]) => Ok(self.value(matrix)?.transpose()),
            ("trace", [matrix]) => {
                let matrix = self.square(matrix)?;
                let arithmetic = Quantities(&self.ring);
                let diagonal = (0..matrix.rows()).map(|place| matrix.at(place, place));
                let trace = diagonal
                    .into_iter()
                    .try_fold(arithmetic.zero(), |sum, entry| arithmetic.sum(&sum, entry));
                Ok(trace.map_err(|error| quantity(error, span))?.scalar())
            }
            ("diagonal", [_, ..]) => {
                check_sides(arguments.len(), arguments.len(), span)?;
                let mut entries = Vec::new();
                for argument in arguments {
                    entries.push(self.scalar(argument)?);
                }
                let zero = Quantity::number(Rational::ZERO);
                Ok(Matrix::from_fn(
                    entries.len(),
                    entries.len(),
                    |row, column| {
                        if row == column {
                            entries[row].clone()
                        } else {
                            zero.clone()
                        }
                    },
                ))
            }
            ("identity", [size]) => {
                let size = self.positive(size)?;
                Ok(identity(size))
            }
            ("zero", [rows, columns]) => {
                let (rows, columns) = (self.positive(rows)?, self.positive(columns)?);
                Ok(Matrix::from_fn(rows, columns, |_, _| {
                    Quantity::number(Rational::ZERO)
                }))
            }
            ("row", [matrix, place]) => {
                let value = self.value(matrix)?;
                let place = self.place(place, value.rows())?;
                Ok(value.select(&[place], &every(value.columns())))
            }
            ("column", [matrix, place]) => {
                let value = self.value(matrix)?;
                let place = self.place(place, value.columns())?;
                Ok(value.select(&every(value.rows()), &[place]))
            }
            ("submatrix", [matrix, rows, columns]) => {
                let value = self.value(matrix)?;
                let rows = self.places(rows, value.rows())?;
                let columns = self.places(columns, value.columns())?;
                check_sides(rows.len(), columns.len(), span)?;
                Ok(value.select(&rows, &columns))
            }
            ("kernel", [matrix]) => self.kernel(matrix, span),
            ("solve", [matrix, right]) => self.solution(matrix, right, span),
            ("coefficient", [polynomial, variable, power]) => {
                let power = self.natural(power)?;
                let (variable, polynomial, coefficients) =
                    self.coefficients(polynomial, variable)?;
                let per = variable
                    .unit
                    .unwrap_or_default()
                    .power(&Rational::from(-(power as i64)));
                Ok(Quantity {
                    value: coefficients
                        .get(&(power as u32))
                        .cloned()
                        .unwrap_or(self.ring.zero()),
                    unit: polynomial.unit.map(|unit| unit.product(&per)),
                }
                .scalar())
            }
            ("hurwitz", [polynomial, variable, size]) => {
                self.hurwitz(polynomial, variable, size, span)
            }
            ("truncate", [value, small, order]) => self.truncation(value, small, order, span),
            ("angle" | "d" | "solve" | "zero" | "row" | "column", _) => wrong_count(2),
            ("submatrix" | "coefficient" | "hurwitz" | "truncate", _) => wrong_count(3),
            (known, _) if NAMES.contains(&known) => wrong_count(1),
            _ => {
                let functions = self
                    .scope
                    .entries()
                    .map(|entry| entry.name.unicode.as_str());
                let help = match nearest(&function.unicode, functions.chain(NAMES)) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("there are {}", NAMES.join(", ")),
                };
                let message = format!("`{function}` is not a function known here");
                Err(
                    Diagnostic::new(DiagnosticKind::UnknownName, span.clone(), message)
                        .with_label("unknown function")
                        .with_help(help),
                )
            }
        }
    }

    fn per_second(&self) -> Unit {
        let seconds = super::syntax::Spanned {
            value: "1/s".to_string(),
            span: 0..0,
        };
        Unit::parse(&seconds).unwrap_or_default()
    }

    fn derivative(
        &mut self,
        entry: &Quantity,
        differential: &Differential,
        per: &Unit,
        span: &Span,
    ) -> Result<Quantity, Diagnostic> {
        let value = self.ring.differentiate(&entry.value, differential);
        Ok(Quantity {
            value: value.map_err(|error| algebra(error, span))?,
            unit: entry.unit.as_ref().map(|unit| unit.product(per)),
        })
    }

    fn circular(
        &mut self,
        function: &str,
        argument: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let quantity = self.scalar(argument)?;
        if let Some(unit) = quantity.unit.filter(|unit| *unit != Unit::one()) {
            return Err(
                super::elaboration::units(&unit, &Unit::one(), &argument.span)
                    .with_help("sines and cosines are taken of angles"),
            );
        }
        let angle = self.ring.angle(&quantity.value).ok_or_else(|| {
            algebra(
                crate::algebra::error::AlgebraError::NotAnAngle,
                &argument.span,
            )
        })?;
        let pair = self
            .ring
            .cosine_and_sine(&angle)
            .map_err(|error| algebra(error, span))?;
        let (cosine, sine) = (pair.0, pair.1);
        let (above, below) = match function {
            "sin" => return Ok(Quantity::new(sine, Unit::one()).scalar()),
            "cos" => return Ok(Quantity::new(cosine, Unit::one()).scalar()),
            "tan" => (sine, cosine),
            _ => (cosine, sine),
        };
        let above = Quantity::new(above, Unit::one()).scalar();
        self.divide(&above, &Quantity::new(below, Unit::one()), span)
    }

    fn direction(
        &mut self,
        x: &Expression,
        y: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let (first, second) = (self.scalar(x)?, self.scalar(y)?);
        let arithmetic = Quantities(&self.ring);
        let squares = arithmetic
            .product(&first, &first)
            .and_then(|a| arithmetic.sum(&a, &arithmetic.product(&second, &second)?))
            .map_err(|error| quantity(error, span))?;
        self.require_non_zero(&squares.value, span)?;
        let value = self.ring.direction(&first.value, &second.value);
        Ok(Quantity::new(value.map_err(|error| algebra(error, span))?, Unit::one()).scalar())
    }

    /// ∂fᵢ/∂qⱼ: a row for each entry of the column f, a column for each entry of q.
    fn jacobian(
        &mut self,
        value: &Expression,
        variables: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let f = self.value(value)?;
        let q = self.value(variables)?;
        if f.columns() != 1 || (q.columns() != 1 && q.rows() != 1) {
            return Err(shape(
                span,
                "a derivative is taken of a column, by a vector".into(),
            )
            .with_help("write d([F_x; F_y], [x; y]) for the matrix of derivatives"));
        }
        let mut symbols = Vec::new();
        for entry in q.entries() {
            symbols.push((
                self.symbol(entry, &variables.span)?,
                entry.unit.clone().unwrap_or_default(),
            ));
        }
        Matrix::try_from_fn(f.rows(), symbols.len(), |row, column| {
            let (symbol, unit) = &symbols[column];
            let partial = Differential::partial(*symbol, &self.ring);
            self.derivative(f.at(row, 0), &partial, &unit.inverse(), span)
        })
    }

    fn square(&mut self, matrix: &Expression) -> Result<Value, Diagnostic> {
        let value = self.value(matrix)?;
        if value.is_square() {
            return Ok(value);
        }
        let (rows, columns) = value.shape();
        Err(shape(
            &matrix.span,
            format!("a square matrix is needed, not {rows}×{columns}"),
        )
        .with_help("`submatrix(…)` takes rows and columns out of a matrix"))
    }

    fn positive(&mut self, expression: &Expression) -> Result<usize, Diagnostic> {
        let number = self.natural(expression)?;
        if number > 0 {
            return Ok(number);
        }
        Err(shape(
            &expression.span,
            "a matrix has at least one row and one column".into(),
        )
        .with_help("write 1 or more"))
    }

    /// A row or column, counted from 1 in the document and from 0 here.
    fn place(&mut self, expression: &Expression, count: usize) -> Result<usize, Diagnostic> {
        let place = self.natural(expression)?;
        if (1..=count).contains(&place) {
            return Ok(place - 1);
        }
        Err(shape(
            &expression.span,
            format!("there is no row or column {place}"),
        )
        .with_label(format!("not one of 1, …, {count}"))
        .with_help("rows and columns count from 1"))
    }

    fn places(&mut self, list: &Expression, count: usize) -> Result<Vec<usize>, Diagnostic> {
        match &list.node {
            super::syntax::Node::Matrix(rows) => rows
                .iter()
                .flatten()
                .map(|entry| self.place(entry, count))
                .collect(),
            _ => Ok(vec![self.place(list, count)?]),
        }
    }

    /// The columns that span {x : A·x = 0}, side by side.
    fn kernel(&mut self, matrix: &Expression, span: &Span) -> Result<Value, Diagnostic> {
        let value = self.value(matrix)?;
        let found =
            null_space(&value, &Quantities(&self.ring)).map_err(|error| quantity(error, span))?;
        for pivot in &found.pivots {
            self.require_non_zero(&pivot.value, span)?;
        }
        if found.basis.is_empty() {
            let message = "only 0 is mapped to 0 by this matrix";
            return Err(
                Diagnostic::new(DiagnosticKind::Singular, span.clone(), message)
                    .with_label("has no null space")
                    .with_help(
                        "its determinant is not 0 for all values; take it `at` values where it is",
                    ),
            );
        }
        Ok(Matrix::from_fn(
            value.columns(),
            found.basis.len(),
            |row, column| found.basis[column].at(row, 0).clone(),
        ))
    }

    fn solution(
        &mut self,
        matrix: &Expression,
        right: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let a = self.square(matrix)?;
        let b = self.value(right)?;
        if b.rows() != a.rows() {
            return Err(shape(
                span,
                "the right side has not as many rows as the matrix".into(),
            )
            .with_label(format!("{} rows, not {}", b.rows(), a.rows()))
            .with_help("the right side of n equations is a column with n entries"));
        }
        self.adjugate(&a, span)?;
        let solved =
            solve(&a, &b, &Quantities(&self.ring)).map_err(|error| quantity(error, span))?;
        if solved.determinant.value.is_zero() {
            let message = "this linear system is singular: its determinant is identically 0";
            return Err(
                Diagnostic::new(DiagnosticKind::Singular, span.clone(), message)
                    .with_label("has no unique solution")
                    .with_help(
                        "leave out equations that follow from others, and look at `kernel(…)`",
                    ),
            );
        }
        self.divide(&solved.numerators, &solved.determinant, span)
    }

    /// A variable, a polynomial, and its coefficients by the power of the variable.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where the expression is no polynomial in the variable.
    pub fn coefficients(
        &mut self,
        polynomial: &Expression,
        variable: &Expression,
    ) -> Result<(Quantity, Quantity, BTreeMap<u32, Fraction>), Diagnostic> {
        let quantity = self.scalar(variable)?;
        let symbol = self.symbol(&quantity, &variable.span)?;
        let value = self.scalar(polynomial)?;
        let coefficients = self.coefficients_of(&value.value, symbol, &polynomial.span)?;
        Ok((quantity, value, coefficients))
    }

    /// The coefficients of an element that is a polynomial in a symbol.
    pub(super) fn coefficients_of(
        &mut self,
        value: &Fraction,
        symbol: Symbol,
        span: &Span,
    ) -> Result<BTreeMap<u32, Fraction>, Diagnostic> {
        let mut coefficients = BTreeMap::new();
        let partial = Differential::partial(symbol, &self.ring);
        let mut polynomial = !value.denominator().contains(symbol);
        for (power, coefficient) in value.numerator().coefficients_in(symbol) {
            let coefficient = self.ring.fraction(&coefficient, value.denominator());
            let coefficient = coefficient.map_err(|error| algebra(error, span))?;
            let change = self.ring.differentiate(&coefficient, &partial);
            polynomial &= change.map_err(|error| algebra(error, span))?.is_zero();
            coefficients.insert(power, coefficient);
        }
        if polynomial {
            return Ok(coefficients);
        }
        let message = "this is not a polynomial in the variable";
        Err(
            Diagnostic::new(DiagnosticKind::NotPolynomial, span.clone(), message)
                .with_label("the variable stands below a line, under a root or in an angle")
                .with_help(
                    "multiply by what stands below the line, or expand it with `truncate(…)` first",
                ),
        )
    }

    /// The leading principal minor of size k of Hurwitz' matrix (a₁, a₃, …; a₀, a₂, …; 0, a₁, …) of
    /// a₀λⁿ + a₁λⁿ⁻¹ + … + aₙ.
    fn hurwitz(
        &mut self,
        polynomial: &Expression,
        variable: &Expression,
        size: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let (variable, polynomial, coefficients) = self.coefficients(polynomial, variable)?;
        let degree = coefficients.keys().next_back().copied().unwrap_or(0);
        let size = self.positive(size)?;
        if size > degree as usize {
            return Err(shape(
                span,
                format!("a polynomial of degree {degree} has no minor of size {size}"),
            )
            .with_help(format!("its Hurwitz matrix has the sizes 1, …, {degree}")));
        }
        let per = variable.unit.unwrap_or_default();
        let entry = |row: usize, column: usize| {
            let place = 2 * (column + 1);
            let index = place
                .checked_sub(row + 1)
                .filter(|index| *index <= degree as usize);
            let power = index.map(|index| degree - index as u32);
            let value = power.and_then(|power| coefficients.get(&power).cloned());
            let unit = power
                .zip(polynomial.unit.as_ref())
                .map(|(power, unit)| unit.product(&per.power(&Rational::from(-i64::from(power)))));
            Quantity {
                unit: value.as_ref().and(unit),
                value: value.unwrap_or(self.ring.zero()),
            }
        };
        let matrix = Matrix::from_fn(size, size, entry);
        Ok(self.determinant(&matrix, span)?.scalar())
    }

    fn truncation(
        &mut self,
        value: &Expression,
        small: &Expression,
        order: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let order = check_order(self.natural(order)? as u32, &order.span)?;
        let mut symbols = Vec::new();
        for entry in self.value(small)?.entries() {
            symbols.push(self.symbol(entry, &small.span)?);
        }
        // What must hold must hold where the small quantities vanish.
        let outer = std::mem::take(&mut self.conditions);
        let value = self.value(value)?;
        let needed = std::mem::replace(&mut self.conditions, outer);
        let at_zero = symbols
            .iter()
            .map(|symbol| (*symbol, self.ring.zero()))
            .collect();
        let needed = needed.substitute(&at_zero, &mut self.ring);
        self.conditions
            .extend(&needed.map_err(|error| algebra(error, span))?);
        value.try_map(|entry| {
            let value = self.ring.truncate(&entry.value, &symbols, order);
            Ok(Quantity {
                value: value.map_err(|error| algebra(error, span))?,
                unit: entry.unit.clone(),
            })
        })
    }
}

fn every(count: usize) -> Vec<usize> {
    (0..count).collect()
}
