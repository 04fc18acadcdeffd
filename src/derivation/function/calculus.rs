//! Derivatives and expansions.

use crate::algebra::arithmetic::Arithmetic;
use crate::algebra::differential::Differential;
use crate::algebra::matrix::Matrix;
use crate::algebra::sign::Signs;
use crate::algebra::symbol::Symbol;
use crate::derivation::condition::Conditions;
use crate::derivation::elaboration::Elaborator;
use crate::derivation::elaboration::error::{algebra, expansion, shape, unexpandable};
use crate::derivation::elaboration::limit::check_order;
use crate::derivation::quantity::{Quantity, Value};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::notation::Notation;
use crate::language::syntax::{Expression, Span};
use crate::language::unit::Unit;

impl Elaborator {
    /// d/dt, entry by entry.
    pub(super) fn time_derivative(
        &mut self,
        inner: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let (value, needed) = self.value_and_conditions(inner)?;
        self.require_slopes(needed, &[Differential::Time], span)?;
        let per_second = per_second();
        value.try_map(|entry| self.derivative(entry, &Differential::Time, &per_second, span))
    }

    /// ∂fᵢ/∂qⱼ: a row for each entry of the column f, a column for each entry of q.
    pub(super) fn jacobian(
        &mut self,
        value: &Expression,
        variables: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let (f, needed) = self.value_and_conditions(value)?;
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
        let partial = |symbol: &Symbol| Differential::partial(*symbol, &self.ring);
        let partials: Vec<Differential> =
            symbols.iter().map(|(symbol, _)| partial(symbol)).collect();
        self.require_slopes(needed, &partials, span)?;
        Matrix::try_from_fn(f.rows(), symbols.len(), |row, column| {
            let (_, unit) = &symbols[column];
            self.derivative(f.at(row, 0), &partials[column], &unit.inverse(), span)
        })
    }

    /// The derivative of a quantity, whose unit becomes so much `per`.
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

    /// Notes what a value needed, and that the roots have slopes which differentials move.
    fn require_slopes(
        &mut self,
        mut needed: Conditions,
        differentials: &[Differential],
        span: &Span,
    ) -> Result<(), Diagnostic> {
        self.add_slopes(&mut needed, differentials, span)?;
        self.conditions.extend(&needed);
        Ok(())
    }

    /// Adds that each root which one of the differentials moves has a slope.
    fn add_slopes(
        &mut self,
        needed: &mut Conditions,
        differentials: &[Differential],
        span: &Span,
    ) -> Result<(), Diagnostic> {
        for differential in differentials {
            let slopes = needed.differentiate(differential, &mut self.ring);
            slopes.map_err(|error| algebra(error, span))?;
        }
        Ok(())
    }

    /// Symbols as the document writes them.
    fn written(&self, symbols: &[Symbol], span: &Span) -> Result<Vec<String>, Diagnostic> {
        let shown = symbols.iter().map(|symbol| {
            let shown = self.presenter().symbol(*symbol);
            let shown = shown.map_err(|error| algebra(error, span))?;
            Ok(Notation::Unicode.expression(&shown))
        });
        shown.collect()
    }

    /// The terms up to an order in small quantities.
    pub(super) fn truncation(
        &mut self,
        value: &Expression,
        small: &Expression,
        order: &Expression,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let order = check_order(self.natural(order)? as u32, &order.span)?;
        let mut symbols = Vec::new();
        for entry in self.value(small)?.entries() {
            let symbol = self.symbol(entry, &small.span)?;
            if symbols.contains(&symbol) {
                let message = "a small quantity is named twice";
                return Err(Diagnostic::new(
                    DiagnosticKind::Duplicate,
                    small.span.clone(),
                    message,
                )
                .with_label("the same quantity again")
                .with_help("name each of them once"));
            }
            symbols.push(symbol);
        }
        // What must hold must hold where the small quantities vanish.
        let (value, needed) = self.value_and_conditions(value)?;
        let names = self.written(&symbols, span)?;
        self.require_expansion(needed, &symbols, span)
            .map_err(|error| unexpandable(error, &names, span))?;
        value.try_map(|entry| {
            let value = self.ring.truncate(&entry.value, &symbols, order);
            Ok(Quantity {
                value: value.map_err(|error| expansion(error, &names, span))?,
                unit: entry.unit.clone(),
            })
        })
    }

    /// Notes what an expansion in small quantities rests on: where they vanish, nothing that was divided
    /// by and no radicand that they move may be 0, and what is assumed of signs may at most become 0.
    pub(crate) fn require_expansion(
        &mut self,
        mut needed: Conditions,
        small: &[Symbol],
        span: &Span,
    ) -> Result<(), Diagnostic> {
        let along = |symbol: &Symbol| Differential::partial(*symbol, &self.ring);
        let along: Vec<Differential> = small.iter().map(along).collect();
        self.add_slopes(&mut needed, &along, span)?;
        let zero = |symbol: &Symbol| (*symbol, self.ring.zero());
        let at_zero = small.iter().map(zero).collect();
        self.require_after(&needed, &at_zero, span)?;
        let closure = |signs: Signs| Signs {
            zero: true,
            ..signs
        };
        self.respect_assumptions(&at_zero, closure, span)
            .map_err(|error| match error.kind {
                DiagnosticKind::Arguments => error
                    .with_label("it may fail where the small quantities vanish")
                    .with_help("declare signs that remain true there, at least as `>= 0`"),
                _ => error,
            })
    }
}

fn per_second() -> Unit {
    Unit::second().inverse()
}
