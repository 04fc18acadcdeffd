//! What the matrices of a system must be.

use crate::algebra::determinant::determinant;
use crate::algebra::fraction::Fraction;
use crate::algebra::generator::Generator;
use crate::algebra::matrix::Matrix;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::notation::Notation;
use crate::language::syntax::{Expression, Name, Place, Span, Spanned};
use crate::language::system::System;
use crate::language::unit::Unit;

use super::elaboration::Elaborator;
use super::elaboration::error::{algebra, shape};
use super::quantity::Value;
use super::scope::{Meaning, SymbolKind};

/// Of how many coordinates the determinant of the mass matrix is looked at with its symbols.
const SHORT: usize = 4;

impl Elaborator {
    /// Checks that a system means something: its equations are 0 at rest, its matrices are real, n×n, free of
    /// coordinates, and of units that fit these, and the determinant of the mass matrix is not 0.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] for the first of this that is not so.
    pub(crate) fn check_system(&mut self, system: &System) -> Result<(), Diagnostic> {
        let coordinates = system.coordinates.iter();
        let units = coordinates.map(|name| self.unit_of_coordinate(name));
        let units: Vec<Unit> = units.collect::<Result<_, _>>()?;
        if let Some((equations, rest)) = &system.equations {
            self.check_rest(equations, rest, units.len())?;
        }
        let mass = self.system_matrix(&system.mass, &units)?;
        let mut forces = Forces::new(units.len());
        forces.check(&mass, &units, 2, &system.mass.span)?;
        for (parts, rates) in [(&system.damping, 1), (&system.stiffness, 0)] {
            for part in parts {
                let matrix = self.system_matrix(&part.matrix, &units)?;
                forces.check(&matrix, &units, rates, &part.matrix.span)?;
            }
        }
        self.check_mass(&mass, &system.mass.span)
    }

    fn unit_of_coordinate(&self, name: &Spanned<Name>) -> Result<Unit, Diagnostic> {
        let meaning = &self.scope.find(&name.value, &name.span)?.meaning;
        if let Meaning::Symbol {
            unit,
            kind: SymbolKind::Coordinate | SymbolKind::AngularCoordinate,
            ..
        } = meaning
        {
            return Ok(unit.clone());
        }
        let message = format!("`{}` is no coordinate", name.value);
        Err(
            Diagnostic::new(DiagnosticKind::Arguments, name.span.clone(), message)
                .with_label("it is no function of time")
                .with_help(format!("declare it: `coordinate {} : m`", name.value)),
        )
    }

    /// The equations must be as many as the coordinates, and 0 at rest.
    fn check_rest(
        &mut self,
        equations: &Expression,
        rest: &Place,
        count: usize,
    ) -> Result<(), Diagnostic> {
        let span = &equations.span;
        let value = self.value(&equations.clone().at(rest.clone()))?;
        if value.shape() != (count, 1) {
            let message = format!(
                "the equations of this system are {count} in a column, one for each coordinate"
            );
            return Err(shape(span, message)
                .with_label(format!("this is {}", shown_shape(&value)))
                .with_help("write one equation of motion for each coordinate: `[F_x; F_y]`"));
        }
        let mut entries = value.entries().iter().enumerate();
        let Some((place, force)) = entries.find(|(_, entry)| !entry.value.is_zero()) else {
            return Ok(());
        };
        let left = self.present(&force.value, span)?;
        let message = format!(
            "equation {} is not 0 at rest but {}",
            place + 1,
            Notation::Unicode.expression(&left)
        );
        Err(
            Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                .with_label("no state of rest")
                .with_help(match self.moves(&force.value) {
                    true => {
                        "a state of rest gives rates and accelerations too: `x = 0, ẋ = 0, ẍ = 0`"
                    }
                    false => {
                        "take off what holds the state of rest, such as the mean force of the wind"
                    }
                }),
        )
    }

    /// Whether a rate of a coordinate is left in an element.
    fn moves(&self, element: &Fraction) -> bool {
        let constituents = self.ring.constituents(element);
        constituents.iter().any(|symbol| {
            let generator = self.ring.generator(*symbol);
            matches!(generator, Generator::Coordinate { order: 1.., .. })
        })
    }

    /// A matrix that is n×n, and made of real constants.
    fn system_matrix(&mut self, matrix: &Expression, units: &[Unit]) -> Result<Value, Diagnostic> {
        let value = self.value(matrix)?;
        let count = units.len();
        if value.shape() != (count, count) {
            let message = format!(
                "the matrices of this system are {count}×{count}, with a column for each coordinate"
            );
            return Err(shape(&matrix.span, message)
                .with_label(format!("this is {}", shown_shape(&value)))
                .with_help("name all coordinates behind `in`, or leave rows and columns out with `submatrix`"));
        }
        for entry in value.entries() {
            self.check_constant(&entry.value, &matrix.span)?;
        }
        Ok(value)
    }

    fn check_constant(&self, entry: &Fraction, span: &Span) -> Result<(), Diagnostic> {
        let constituents = self.ring.constituents(entry);
        let mut moving = constituents.iter().filter(|symbol| {
            matches!(
                self.ring.generator(**symbol),
                Generator::Coordinate { .. }
                    | Generator::ImaginaryUnit
                    | Generator::Direction { .. }
            ) || self.ring.assumptions().is_complex(**symbol)
        });
        let Some(symbol) = moving.next() else {
            return Ok(());
        };
        let shown = self.presenter().symbol(*symbol);
        let shown = shown.map_err(|error| algebra(error, span))?;
        let shown = Notation::Unicode.expression(&shown);
        let message =
            format!("the matrices of a system are real constants, and this one contains {shown}");
        Err(
            Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                .with_label("not constant, or not real")
                .with_help("take it at a state of rest: `M at rest`"),
        )
    }

    /// What is too long to be told here is told where the matrix has numbers.
    fn check_mass(&self, mass: &Value, span: &Span) -> Result<(), Diagnostic> {
        let (count, _) = mass.shape();
        let entry = |row, column| mass.at(row, column).value.clone();
        let values = Matrix::from_fn(count, count, entry);
        let is_short = count <= SHORT;
        let is_singular = is_short
            && determinant(&values, &self.ring).is_ok_and(|determinant| determinant.is_zero());
        if !is_singular {
            return Ok(());
        }
        let message = "the determinant of the mass matrix is 0";
        Err(
            Diagnostic::new(DiagnosticKind::Singular, span.clone(), message)
                .with_label("singular")
                .with_help("leave out the coordinates that have no mass"),
        )
    }
}

/// The unit of each equation, as far as it is known.
struct Forces(Vec<Option<Unit>>);

impl Forces {
    fn new(count: usize) -> Self {
        Forces(vec![None; count])
    }

    /// Each entry times so many rates of its coordinate must have the unit of its equation.
    fn check(
        &mut self,
        matrix: &Value,
        units: &[Unit],
        rates: usize,
        span: &Span,
    ) -> Result<(), Diagnostic> {
        for row in 0..units.len() {
            for (column, coordinate) in units.iter().enumerate() {
                let Some(own) = &matrix.at(row, column).unit else {
                    continue;
                };
                let second = Unit::second().inverse();
                let force =
                    (0..rates).fold(own.product(coordinate), |unit, _| unit.product(&second));
                match &self.0[row] {
                    Some(known) if *known != force => {
                        return Err(wrong_unit(row, column, &force, known, span));
                    }
                    _ => self.0[row] = Some(force),
                }
            }
        }
        Ok(())
    }
}

fn wrong_unit(row: usize, column: usize, force: &Unit, known: &Unit, span: &Span) -> Diagnostic {
    let message = format!(
        "the entry in row {} and column {} gives a term in {force}, and others of this equation are in {known}",
        row + 1,
        column + 1
    );
    Diagnostic::new(DiagnosticKind::Unit, span.clone(), message)
        .with_label("of another unit")
        .with_help("M q̈, C q̇ and K q are added: name the coordinates in the order of the columns")
}

fn shown_shape(value: &Value) -> String {
    let (rows, columns) = value.shape();
    format!("{rows}×{columns}")
}
