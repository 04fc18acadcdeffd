//! Replacements, and what is differentiated or expanded by.

use crate::derivation::syntax::{Expression, Place};
use crate::points::derivative::{By, Derivative};
use crate::points::graph::NodeId;
use crate::points::meaning::Meaning;
use crate::points::substitution::Substitution;
use crate::points::table::Table;
use crate::points::{Failure, Unknown};

use super::Unfolding;

impl<'a> Unfolding<'a> {
    /// An expression with replacements written in.
    pub(super) fn at(&mut self, inner: &'a Expression, place: &'a Place) -> Result<Table, Failure> {
        let table = self.table(inner)?;
        let mut substitution = self.replacements(place, &table)?;
        self.sheet
            .each(&table, |sheet, entry| substitution.of(entry, sheet))
    }

    /// What a place replaces by what, as far as it stands in a table.
    fn replacements(&mut self, place: &'a Place, table: &Table) -> Result<Substitution, Failure> {
        let (replacements, is_named) = match place {
            Place::Replacements(replacements) => (replacements.as_slice(), false),
            Place::Named(name) => match self.meanings.get(name.value.ascii.as_str()) {
                Some(Meaning::Substitution(replacements)) => (*replacements, true),
                _ => return Err(Unknown::Unsupported.into()),
            },
        };
        if is_named {
            // The arguments of a call mean nothing where the replacements were declared.
            self.frames.push(Default::default());
        }
        let present = self.sheet.graph.variables_of(table.entries());
        let mut substitution = Substitution::default();
        let mut outcome = Ok(());
        for replacement in replacements {
            let target = self.scalar(&replacement.target);
            outcome = target.and_then(|target| {
                match self.variable_of(target)? {
                    // What does not occur need not have a value.
                    By::Variable(id) if !present.contains(&id) => {}
                    By::Variable(id) => {
                        let value = self.scalar(&replacement.value)?;
                        substitution.variables.insert(id, value);
                    }
                    By::Function(function, order, place) => {
                        let value = self.scalar(&replacement.value)?;
                        substitution
                            .functions
                            .push(((function, order, place), value));
                    }
                    By::Time => return Err(Unknown::NoVariable.into()),
                }
                Ok(())
            });
            if outcome.is_err() {
                break;
            }
        }
        if is_named {
            self.frames.pop();
        }
        outcome.map(|()| substitution)
    }

    /// ∂fᵢ/∂qⱼ: a row for each entry of f, a column for each entry of q.
    pub(super) fn jacobian(
        &mut self,
        value: &'a Expression,
        variables: &'a Expression,
    ) -> Result<Table, Failure> {
        let (value, variables) = (self.table(value)?, self.table(variables)?);
        let (rows, width) = value.shape();
        if width != 1 {
            return Err(Unknown::Shape.into());
        }
        let by = variables.entries().iter();
        let by = by.map(|variable| self.variable_of(*variable).map(Derivative::new));
        let mut by: Vec<Derivative> = by.collect::<Result<_, _>>()?;
        Table::made(rows, by.len(), |row, column| {
            by[column].of(value.get(row, 0)?, &mut self.sheet)
        })
    }

    /// The time derivative of every entry.
    pub(super) fn rate(&mut self, inner: &'a Expression) -> Result<Table, Failure> {
        let table = self.table(inner)?;
        let mut derivative = Derivative::new(By::Time);
        self.sheet
            .each(&table, |sheet, entry| derivative.of(entry, sheet))
    }

    /// The parts of degree 0, …, `order` of every entry.
    pub(super) fn expanded(
        &mut self,
        table: &Table,
        small: &[By],
        order: u32,
    ) -> Result<Vec<Table>, Failure> {
        let (mut variables, mut functions) = (Vec::new(), Vec::new());
        for by in small {
            match *by {
                By::Variable(variable) => variables.push(variable),
                By::Function(function, k, place) => functions.push((function, k, place)),
                By::Time => return Err(Unknown::NoVariable.into()),
            }
        }
        let terms = table.entries().iter().map(|entry| {
            let sheet = &mut self.sheet;
            sheet.parts(*entry, &variables, &functions, order)
        });
        let terms: Vec<Vec<NodeId>> = terms.collect::<Result<_, _>>()?;
        let part = |degree: usize| {
            let mut entries = terms.iter().map(|parts| parts[degree]);
            table.each(|_| entries.next().ok_or(Unknown::Shape.into()))
        };
        (0..=order as usize).map(part).collect()
    }

    /// The terms up to an order in small quantities.
    pub(super) fn truncation(
        &mut self,
        value: &'a Expression,
        small: &'a Expression,
        order: &'a Expression,
    ) -> Result<Table, Failure> {
        let order = self.natural(order)?;
        let small = self.table(small)?;
        let small = small.entries().iter();
        let small = small.map(|entry| self.variable_of(*entry));
        let small: Vec<By> = small.collect::<Result<_, _>>()?;
        let value = self.table(value)?;
        let parts = self.expanded(&value, &small, order)?;
        let mut sum = value.each(|_| self.sheet.graph.integer(0))?;
        for part in &parts {
            sum = sum.zipped(part, |a, b| self.sheet.graph.sum(a, b))?;
        }
        Ok(sum)
    }
}
