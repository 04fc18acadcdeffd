//! Calls: functions known only through their derivatives, and definitions with arguments.

use crate::derivation::evaluation::table::{Table, single};
use crate::derivation::scope::Meaning;
use crate::derivation::syntax::{Expression, Name};

use super::context::Context;
use super::{Evaluator, Failure};

impl<'a> Evaluator<'a> {
    /// The value of a call.
    pub(super) fn call(
        &mut self,
        function: &'a Name,
        order: u32,
        arguments: &'a [Expression],
        context: Context,
    ) -> Result<Table, Failure> {
        let scope = self.scope;
        match (scope.get(function).map(|entry| &entry.meaning), arguments) {
            (Some(Meaning::Function { .. }), [argument]) => {
                Ok(single(self.function(function, order, argument, context)?))
            }
            (
                Some(Meaning::Template {
                    arguments: names,
                    expression,
                }),
                _,
            ) => {
                let names = names.iter().map(|name| name.ascii.as_str());
                let inside = self.called(context, names.zip(arguments).collect());
                self.table(expression, inside)
            }
            (Some(_), _) => Err(format!("{function} is no function")),
            (None, _) => self.built_in(&function.ascii, arguments, context),
        }
    }
}
