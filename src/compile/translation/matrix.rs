//! Matrices of values of a program.

use std::collections::BTreeMap;

use sextic_codegen::program::{Operation, Program};

use crate::derivation::syntax::{Expression, Node as Syntax};

use super::{Context, Obstacle, Polynomial, Table, Translator, scalar};

impl Translator<'_> {
    pub(super) fn each(
        &mut self,
        table: &Table,
        mut image: impl FnMut(&Polynomial, &mut Program) -> Polynomial,
    ) -> Table {
        let program = &mut self.program;
        let mut row =
            |row: &Vec<Polynomial>| row.iter().map(|entry| image(entry, program)).collect();
        table.iter().map(&mut row).collect()
    }

    pub(super) fn zip(
        &mut self,
        a: &Table,
        b: &Table,
        image: fn(&Polynomial, &Polynomial, &mut Program) -> Polynomial,
    ) -> Table {
        let program = &mut self.program;
        let rows = a.iter().zip(b);
        rows.map(|(a, b)| a.iter().zip(b).map(|(a, b)| image(a, b, program)).collect())
            .collect()
    }

    /// A·B; a scalar multiplies every entry.
    pub(super) fn product(&mut self, a: &Table, b: &Table) -> Table {
        let single = |table: &Table| match table.as_slice() {
            [row] if row.len() == 1 => Some(row[0].clone()),
            _ => None,
        };
        if let Some(factor) = single(a) {
            return self.each(b, |entry, program| factor.product(entry, program));
        }
        if let Some(factor) = single(b) {
            return self.each(a, |entry, program| entry.product(&factor, program));
        }
        let program = &mut self.program;
        let columns = b.first().map_or(0, Vec::len);
        let mut product = Table::new();
        for row in a {
            let mut line = Vec::new();
            for column in 0..columns {
                let mut sum = Polynomial::default();
                for (x, below) in row.iter().zip(b) {
                    if !x.is_zero() && !below[column].is_zero() {
                        let term = x.product(&below[column], program);
                        sum = sum.sum(&term, program);
                    }
                }
                line.push(sum);
            }
            product.push(line);
        }
        product
    }

    pub(super) fn blocks(
        &mut self,
        rows: &[Vec<Expression>],
        context: Context,
    ) -> Result<Table, Obstacle> {
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

    pub(super) fn entry(
        &mut self,
        matrix: &Expression,
        indices: &[Expression],
        context: Context,
    ) -> Result<Table, Obstacle> {
        let table = self.table(matrix, context)?;
        let mut places = Vec::new();
        for index in indices {
            places.push(self.natural(index)?);
        }
        let (row, column) = match places[..] {
            [row, column] => (row, column),
            [column] if table.len() == 1 => (1, column),
            [row] => (row, 1),
            _ => return Err(Obstacle::Structure),
        };
        let entry = table.get(row.wrapping_sub(1));
        let entry = entry.and_then(|line| line.get(column.wrapping_sub(1)));
        entry.cloned().map(scalar).ok_or(Obstacle::Structure)
    }

    fn natural(&mut self, expression: &Expression) -> Result<usize, Obstacle> {
        let natural = self.elaborator.natural(expression);
        natural.map_err(|error| Obstacle::Refused(error.message))
    }

    /// A built-in function that keeps the structure of its arguments.
    pub(super) fn built_in(
        &mut self,
        function: &str,
        arguments: &[Expression],
        context: Context,
    ) -> Result<Table, Obstacle> {
        match (function, arguments) {
            ("sqrt", [square]) => {
                let square = self.table(square, context)?;
                let square = self.divisor(&square)?;
                let root = self.program.push(Operation::SquareRoot(square));
                Ok(scalar(Polynomial::monomial(0, root)))
            }
            ("det", [matrix]) => {
                let matrix = self.table(matrix, context)?;
                Ok(scalar(self.determinant(&matrix)))
            }
            ("transpose", [matrix]) => {
                let matrix = self.table(matrix, context)?;
                let columns = matrix.first().map_or(0, Vec::len);
                let column = |place: usize| matrix.iter().map(|row| row[place].clone()).collect();
                Ok((0..columns).map(column).collect())
            }
            ("trace", [matrix]) => {
                let matrix = self.table(matrix, context)?;
                let mut sum = Polynomial::default();
                for (place, row) in matrix.iter().enumerate() {
                    sum = sum.sum(&row[place], &mut self.program);
                }
                Ok(scalar(sum))
            }
            ("diagonal", entries) => {
                let mut table = vec![vec![Polynomial::default(); entries.len()]; entries.len()];
                for (index, entry) in entries.iter().enumerate() {
                    let entry = self.table(entry, context)?;
                    table[index][index] = entry[0][0].clone();
                }
                Ok(table)
            }
            ("coefficient", [polynomial, variable, power]) => {
                let Syntax::Name(variable) = &variable.node else {
                    return Err(Obstacle::Structure);
                };
                let power = self.natural(power)? as u32;
                let inside = self.with_variable(variable, context)?;
                let polynomial = self.table(polynomial, inside)?;
                let coefficient = polynomial[0][0].coefficient(power);
                let coefficient = coefficient.map(|node| Polynomial::monomial(0, node));
                Ok(scalar(coefficient.unwrap_or_default()))
            }
            ("hurwitz", [polynomial, variable, size]) => {
                let Syntax::Name(variable) = &variable.node else {
                    return Err(Obstacle::Structure);
                };
                let size = self.natural(size)?;
                let inside = self.with_variable(variable, context)?;
                let polynomial = self.table(polynomial, inside)?;
                let matrix = hurwitz_matrix(&polynomial[0][0], size);
                Ok(scalar(self.determinant(&matrix)))
            }
            _ => Err(Obstacle::Structure),
        }
    }

    /// |A| by expansion along the rows, each minor of the last rows computed once.
    fn determinant(&mut self, matrix: &Table) -> Polynomial {
        let columns: Vec<usize> = (0..matrix.len()).collect();
        self.minor(matrix, &columns, &mut BTreeMap::new())
    }

    fn minor(
        &mut self,
        matrix: &Table,
        columns: &[usize],
        known: &mut BTreeMap<Vec<usize>, Polynomial>,
    ) -> Polynomial {
        if let Some(known) = known.get(columns) {
            return known.clone();
        }
        let row = &matrix[matrix.len() - columns.len()];
        if let [column] = columns {
            return row[*column].clone();
        }
        let mut sum = Polynomial::default();
        for (place, column) in columns.iter().enumerate() {
            if row[*column].is_zero() {
                continue;
            }
            let others = [&columns[..place], &columns[place + 1..]].concat();
            let minor = self.minor(matrix, &others, known);
            let term = row[*column].product(&minor, &mut self.program);
            sum = match place % 2 {
                0 => sum.sum(&term, &mut self.program),
                _ => sum.difference(&term, &mut self.program),
            };
        }
        known.insert(columns.to_vec(), sum.clone());
        sum
    }
}

/// The leading principal part of Hurwitz' matrix of a polynomial.
fn hurwitz_matrix(polynomial: &Polynomial, size: usize) -> Table {
    let degree = polynomial.degree() as usize;
    let entry = |row: usize, column: usize| {
        let index = (2 * column + 1)
            .checked_sub(row)
            .filter(|index| *index <= degree);
        let node = index.and_then(|index| polynomial.coefficient((degree - index) as u32));
        node.map(|node| Polynomial::monomial(0, node))
            .unwrap_or_default()
    };
    (0..size)
        .map(|row| (0..size).map(|column| entry(row, column)).collect())
        .collect()
}
