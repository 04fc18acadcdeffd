//! Calls: functions known only through their derivatives, and definitions with arguments.

use std::sync::Arc;

use crate::algebra::error::AlgebraError;
use crate::algebra::number::Rational;
use crate::derivation::quantity::{Quantity, Value, common_unit};
use crate::derivation::scope::Meaning;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::syntax::{Expression, Name, Span};
use crate::language::unit::Unit;

use super::error::{algebra, argument_count};
use super::limit::check_calls;
use super::{Argument, Elaborator};

impl Elaborator {
    /// What a call gives.
    pub(super) fn call(
        &mut self,
        function: &Name,
        order: u32,
        arguments: &[Expression],
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        match self.scope.get(function).map(|entry| &entry.meaning) {
            Some(Meaning::Function { .. }) => {
                let [argument] = arguments else {
                    let usage = format!("write `{function}(…)` for each of the arguments");
                    return Err(argument_count(function, 1, arguments.len(), &usage, span));
                };
                let argument = self.scalar(argument)?;
                self.function_value(function, order, Some(argument), span)
            }
            Some(Meaning::Template {
                arguments: names,
                expression,
            }) => {
                if names.len() != arguments.len() {
                    let written: Vec<&str> =
                        names.iter().map(|name| name.unicode.as_str()).collect();
                    let usage = format!("it is defined as `{function}({})`", written.join(", "));
                    let (wanted, given) = (names.len(), arguments.len());
                    return Err(argument_count(function, wanted, given, &usage, span));
                }
                let (names, expression) = (names.clone(), Arc::clone(expression));
                self.template(function, names, &expression, arguments, span)
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

    /// The body of a definition with arguments, at their values.
    fn template(
        &mut self,
        function: &Name,
        names: Vec<Name>,
        body: &Expression,
        arguments: &[Expression],
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        check_calls(self.arguments.len(), function, span)?;
        let arguments: Result<Vec<Argument>, Diagnostic> = arguments
            .iter()
            .map(|argument| self.argument(argument))
            .collect();
        let names = names.into_iter().map(|name| name.ascii);
        self.arguments.push(names.zip(arguments?).collect());
        let value = self.value(body);
        self.arguments.pop();
        // A mistake in the definition's text may be one of this call.
        value.map_err(|error| match error.secondary.len() {
            // The text of an imported definition stands in another document.
            _ if error.span == (0..0) => error.moved_to(span, &format!("in `{function}`")),
            0..3 => error.with_secondary(span.clone(), format!("in this call of `{function}`")),
            _ => error,
        })
    }

    fn argument(&mut self, written: &Expression) -> Result<Argument, Diagnostic> {
        let (value, conditions) = self.value_and_conditions(written)?;
        Ok(Argument {
            value,
            conditions,
            rests_on: self.mentioned(written),
        })
    }

    /// f⁽ᵏ⁾ at the given argument, or at its reference argument.
    pub(super) fn function_value(
        &mut self,
        name: &Name,
        order: u32,
        argument: Option<Quantity>,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let Meaning::Function {
            argument: reference,
            conditions,
            unit,
            ..
        } = &self.scope.find(name, span)?.meaning
        else {
            let message = format!("`{name}` is not declared as a function");
            return Err(
                Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                    .with_label("a prime asks for the derivative of a function")
                    .with_help(format!(
                        "declare it with `function {name} at … : …`; a derivative by time is `dt({name})`, by \
                         another name `d({name}, x)`"
                    )),
            );
        };
        let unit = unit.clone();
        if argument.is_none() && self.rests_on_twin(name) {
            return Err(algebra(AlgebraError::NotReal, span)
                .with_label("its argument is replaced by a complex number"));
        }
        let argument = argument.unwrap_or_else(|| reference.clone());
        if common_unit(&argument.unit, &reference.unit).is_err() {
            let shown = |quantity: &Quantity| {
                let unit = quantity.unit.as_ref();
                unit.map(ToString::to_string).unwrap_or_default()
            };
            let (given, wanted) = (shown(&argument), shown(reference));
            let message = format!("the argument of `{name}` is in {given}, not in {wanted}");
            return Err(Diagnostic::new(DiagnosticKind::Unit, span.clone(), message)
                .with_label(format!("{given}, not {wanted}"))
                .with_help("the unit is that of what stands behind `at` in its declaration"));
        }
        if argument.value == reference.value {
            self.conditions.extend(conditions);
        }
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
}
