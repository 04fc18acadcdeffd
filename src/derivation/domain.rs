//! Where a document's quantities lie in practice.

use std::collections::BTreeMap;

use crate::algebra::number::Rational;
use crate::algebra::symbol::Symbol;

use super::elaboration::Elaborator;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Expression, Replacement};

/// The numbers from the first to the last, in the SI unit of what they are numbers of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// The least.
    pub from: Rational,
    /// The greatest.
    pub to: Rational,
}

/// The intervals that a document states: the accuracy of what is compiled is measured there.
#[derive(Clone, Debug, Default)]
pub struct Domain {
    intervals: BTreeMap<Symbol, Interval>,
}

impl Domain {
    /// The symbols and their intervals.
    pub fn intervals(&self) -> impl Iterator<Item = (Symbol, &Interval)> {
        let intervals = self.intervals.iter();
        intervals.map(|(symbol, interval)| (*symbol, interval))
    }

    /// Adds what a statement `domain m = [1, 50], C_D′ = [-10, 10]` says.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where a quantity is not free, has an interval already or none that is one, or
    /// where the document's own assumptions exclude an end of it.
    pub(crate) fn extend(
        &mut self,
        stated: &[Replacement],
        elaborator: &mut Elaborator,
    ) -> Result<(), Diagnostic> {
        for Replacement { target, value } in stated {
            let quantity = elaborator.scalar(target)?;
            let symbol = elaborator.symbol(&quantity, &target.span)?;
            let interval = interval(value, elaborator)?;
            for end in [&interval.from, &interval.to] {
                let end = Replacement {
                    target: target.clone(),
                    value: Expression::number(end.clone()),
                };
                elaborator.admit(&[end], &value.span)?;
            }
            if self.intervals.insert(symbol, interval).is_some() {
                let message = "the same quantity has an interval already";
                let kind = DiagnosticKind::Duplicate;
                return Err(Diagnostic::new(kind, target.span.clone(), message)
                    .with_label("stated twice")
                    .with_help("state one interval a quantity"));
            }
        }
        Ok(())
    }
}

/// `[a, b]` with numbers a < b.
fn interval(value: &Expression, elaborator: &mut Elaborator) -> Result<Interval, Diagnostic> {
    let ends = elaborator.value(value)?;
    let number = |column| ends.at(0, column).value.as_constant();
    if ends.shape() == (1, 2)
        && let (Some(from), Some(to)) = (number(0), number(1))
        && from < to
    {
        return Ok(Interval { from, to });
    }
    let message = "this is no interval";
    Err(
        Diagnostic::new(DiagnosticKind::Arguments, value.span.clone(), message)
            .with_label("expected two numbers, the smaller first")
            .with_help("an interval is written `[1, 50]`, in SI units"),
    )
}
