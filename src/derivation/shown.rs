//! What an expression is, when somebody asks.

use super::condition::Condition;
use super::elaboration::Elaborator;
use super::quantity::Quantity;
use crate::language::diagnostic::Diagnostic;
use crate::language::syntax::{Expression, Span};
use crate::language::unit::Unit;

/// What an expression of a document is.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The expression as it is written.
    pub expression: Expression,
    /// In words.
    pub description: Option<String>,
    /// The line on which it stands, counted from 1.
    pub line: usize,
    /// Where the statement stands.
    pub span: Span,
    /// How many columns it has.
    pub columns: usize,
    /// Its entries, row by row; one of a single number.
    pub entries: Vec<Entry>,
    /// Where all of it has a value, beside what is declared and assumed.
    pub conditions: Vec<Condition>,
}

/// What an entry of an expression is.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Sums above and below the line, as the ring holds them.
    pub normal_form: Expression,
    /// The same as a product of factors, each as short as it is found.
    pub factored: Expression,
    /// Nothing for a 0 that fits every unit.
    pub unit: Option<Unit>,
    /// How many terms the normal form has above the line.
    pub terms: usize,
    /// How many it has below.
    pub terms_below: usize,
}

impl Shown {
    /// The entries with their rows and columns, counted from 1.
    pub fn places(&self) -> impl Iterator<Item = ((usize, usize), &Entry)> {
        let place = |number| (number / self.columns + 1, number % self.columns + 1);
        let entries = self.entries.iter().enumerate();
        entries.map(move |(number, entry)| (place(number), entry))
    }

    /// How many rows it has.
    pub fn rows(&self) -> usize {
        self.entries.len() / self.columns.max(1)
    }

    /// The entry, if it is a single number.
    pub fn scalar(&self) -> Option<&Entry> {
        match self.entries.as_slice() {
            [only] => Some(only),
            _ => None,
        }
    }
}

impl Elaborator {
    /// What an expression is.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where it has no value, or is too long to be written.
    pub fn show(
        &mut self,
        expression: &Expression,
        description: Option<&str>,
        line: usize,
        span: &Span,
    ) -> Result<Shown, Diagnostic> {
        let value = self.value(expression)?;
        let needed = std::mem::take(&mut self.conditions);
        let entries = value.entries().iter();
        let entries = entries.map(|own| self.show_entry(own, &expression.span));
        Ok(Shown {
            expression: expression.clone(),
            description: description.map(str::to_string),
            line,
            span: span.clone(),
            columns: value.columns(),
            entries: entries.collect::<Result<_, _>>()?,
            conditions: self.present_conditions(&needed, &expression.span)?,
        })
    }

    fn show_entry(&self, entry: &Quantity, span: &Span) -> Result<Entry, Diagnostic> {
        Ok(Entry {
            normal_form: self.present_expanded(&entry.value, span)?,
            factored: self.present(&entry.value, span)?,
            unit: entry.unit.clone(),
            terms: entry.value.numerator().len(),
            terms_below: entry.value.denominator().len(),
        })
    }
}
