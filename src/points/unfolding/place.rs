//! Replacements, and what is differentiated or expanded by.

use std::collections::BTreeSet;

use crate::language::syntax::{Expression, Place, Replacement};
use crate::points::derivative::{By, Derivative};
use crate::points::graph::{NodeId, VariableId};
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
        let present = self.sheet.graph.variables_of(table.entries());
        match place {
            Place::Replacements(replacements) => self.replacing(replacements, &present),
            Place::Named(name) => match self.meanings.get(name.value.ascii.as_str()) {
                Some(Meaning::Substitution(replacements)) => {
                    self.apart(|own| own.replacing(replacements, &present))
                }
                _ => Err(Unknown::Unsupported.into()),
            },
        }
    }

    fn replacing(
        &mut self,
        replacements: &'a [Replacement],
        present: &BTreeSet<VariableId>,
    ) -> Result<Substitution, Failure> {
        let mut substitution = Substitution::default();
        for replacement in replacements {
            let target = self.scalar(&replacement.target)?;
            let by = self.variable_of(target)?;
            // What does not occur need not have a value.
            if matches!(by, By::Variable(id) if !present.contains(&id)) {
                continue;
            }
            let value = self.scalar(&replacement.value)?;
            match by {
                By::Variable(id) => drop(substitution.variables.insert(id, value)),
                By::Function(function, order, place) => {
                    let replaced = (function, order, place);
                    substitution.functions.push((replaced, value));
                }
                By::Time => return Err(Unknown::NoVariable.into()),
            }
        }
        Ok(substitution)
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
