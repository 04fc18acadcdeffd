//! Walking through expressions.

use std::collections::BTreeSet;

use super::syntax::{Expression, Name, Node, Place};

impl Expression {
    /// Calls a function for the expression and all that it consists of, from left to right.
    pub fn visit<'a>(&'a self, visit: &mut dyn FnMut(&'a Expression)) {
        visit(self);
        for part in self.parts() {
            part.visit(visit);
        }
    }

    /// What it consists of; of replacements, what stands there then.
    fn parts(&self) -> Vec<&Expression> {
        match &self.node {
            Node::Number(_) | Node::Name(_) | Node::Derivative(..) => Vec::new(),
            Node::Negative(inner) => vec![inner],
            Node::Binary(_, left, right) => vec![left, right],
            Node::Call { arguments, .. } => arguments.iter().collect(),
            Node::Matrix(rows) => rows.iter().flatten().collect(),
            Node::Index(matrix, indices) => [&**matrix].into_iter().chain(indices).collect(),
            Node::At(inner, Place::Named(_)) => vec![inner],
            Node::At(inner, Place::Replacements(replacements)) => {
                let values = replacements.iter().map(|own| &own.value);
                [&**inner].into_iter().chain(values).collect()
            }
        }
    }

    /// Calls a function for every name in the expression, from left to right.
    pub fn visit_names(&self, visit: &mut dyn FnMut(&Name)) {
        match &self.node {
            Node::Number(_) => {}
            Node::Name(name) | Node::Derivative(name, _) => visit(name),
            Node::Negative(inner) => inner.visit_names(visit),
            Node::Binary(_, left, right) => {
                left.visit_names(visit);
                right.visit_names(visit);
            }
            Node::Call {
                function,
                arguments,
                ..
            } => {
                visit(function);
                arguments
                    .iter()
                    .for_each(|argument| argument.visit_names(visit));
            }
            Node::Matrix(rows) => rows
                .iter()
                .flatten()
                .for_each(|entry| entry.visit_names(visit)),
            Node::Index(matrix, indices) => {
                matrix.visit_names(visit);
                indices.iter().for_each(|index| index.visit_names(visit));
            }
            Node::At(inner, place) => {
                inner.visit_names(visit);
                match place {
                    Place::Named(name) => visit(&name.value),
                    Place::Replacements(replacements) => {
                        for replacement in replacements {
                            replacement.value.visit_names(visit);
                        }
                    }
                }
            }
        }
    }

    /// Forgets where it stands, as if the engine had made it.
    pub fn forget_places(&mut self) {
        self.span = 0..0;
        match &mut self.node {
            Node::Number(_) | Node::Name(_) | Node::Derivative(..) => {}
            Node::Negative(inner) => inner.forget_places(),
            Node::Binary(_, left, right) => {
                left.forget_places();
                right.forget_places();
            }
            Node::Call { arguments, .. } => arguments.iter_mut().for_each(Self::forget_places),
            Node::Matrix(rows) => rows.iter_mut().flatten().for_each(Self::forget_places),
            Node::Index(matrix, indices) => {
                matrix.forget_places();
                indices.iter_mut().for_each(Self::forget_places);
            }
            Node::At(inner, place) => {
                inner.forget_places();
                match place {
                    Place::Named(name) => name.span = 0..0,
                    Place::Replacements(replacements) => {
                        for replacement in replacements {
                            replacement.target.forget_places();
                            replacement.value.forget_places();
                        }
                    }
                }
            }
        }
    }

    /// The ASCII names under which a point lists the values that a normal form contains: `m`,
    /// `dt(x)`, `dC_D`, `cos(a)`, `sin(a)` for every angle a within a sine or
    /// cosine, and `C_D(` for the values of C_D at other arguments than its own.
    pub fn collect_values(&self, values: &mut BTreeSet<String>) {
        match &self.node {
            Node::Call {
                function,
                arguments,
                ..
            } if matches!(&*function.ascii, "cos" | "sin") => {
                for argument in arguments {
                    argument.visit_names(&mut |name| {
                        values.insert(format!("cos({})", name.ascii));
                        values.insert(format!("sin({})", name.ascii));
                    });
                }
            }
            Node::Call {
                function,
                arguments,
                ..
            } if function.ascii == "dt" => {
                let mut inner = BTreeSet::new();
                arguments
                    .iter()
                    .for_each(|argument| argument.collect_values(&mut inner));
                values.extend(inner.into_iter().map(|name| format!("dt({name})")));
            }
            Node::Name(name) => {
                values.insert(name.ascii.clone());
            }
            Node::Derivative(name, order) => {
                values.insert(primed(&name.ascii, *order));
            }
            Node::Number(_) => {}
            Node::Negative(inner) | Node::At(inner, _) | Node::Index(inner, _) => {
                inner.collect_values(values);
            }
            Node::Binary(_, left, right) => {
                left.collect_values(values);
                right.collect_values(values);
            }
            Node::Call {
                function,
                order,
                arguments,
            } => {
                values.insert(format!("{}(", primed(&function.ascii, *order)));
                arguments
                    .iter()
                    .for_each(|argument| argument.collect_values(values));
            }
            Node::Matrix(rows) => {
                rows.iter()
                    .flatten()
                    .for_each(|entry| entry.collect_values(values));
            }
        }
    }
}

/// `C_D`, `dC_D`, `d2C_D`: a function's derivative of some order.
pub fn primed(name: &str, order: u32) -> String {
    match order {
        0 => name.to_string(),
        1 => format!("d{name}"),
        _ => format!("d{order}{name}"),
    }
}
