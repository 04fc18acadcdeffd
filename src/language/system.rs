//! Equations of motion that a document wants computed.

use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::evaluator::{Evaluator, Output};
use super::syntax::{
    BinaryOperator, Expression, Label, Name, Node, Part, Place, Span, Spanned, Statement,
    StatementKind, SystemBody, SystemStatement,
};

/// How many coordinates a system may have.
pub const MOST_COORDINATES: usize = 8;

/// M q̈ + C q̇ + K q = 0 with n coordinates q.
#[derive(Clone, Debug)]
pub struct System {
    /// How it is called in reports.
    pub label: Label,
    /// How it is called in commands.
    pub name: Name,
    /// In words.
    pub description: Option<String>,
    /// The coordinates, in order.
    pub coordinates: Vec<Spanned<Name>>,
    /// The column that is 0, and the state of rest about which it is linear; nothing where the matrices are
    /// given.
    pub equations: Option<(Expression, Place)>,
    /// M, n×n.
    pub mass: Expression,
    /// What C is the sum of, each n×n; nothing for 0.
    pub damping: Vec<Part>,
    /// What K is the sum of, each n×n.
    pub stiffness: Vec<Part>,
    /// Where the document asks for it.
    pub span: Span,
}

impl System {
    /// What a `system` statement asks for; nothing is computed yet.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where there are too many coordinates or a name occurs twice.
    pub(crate) fn of(statement: &Statement) -> Result<Option<System>, Diagnostic> {
        let StatementKind::System(statement) = &statement.kind else {
            return Ok(None);
        };
        let SystemStatement {
            label,
            name,
            body,
            coordinates,
            description,
        } = &**statement;
        check_coordinates(coordinates)?;
        let (mass, damping, stiffness) = match body {
            SystemBody::Matrices {
                mass,
                damping,
                stiffness,
            } => (mass.clone(), damping.clone(), stiffness.clone()),
            SystemBody::Equations { equations, rest } => linear(equations, coordinates, rest),
        };
        for parts in [&damping, &stiffness] {
            let names = parts.iter().filter_map(|part| part.name.as_ref());
            all_different("part", names)?;
        }
        let equations = match body {
            SystemBody::Equations { equations, rest } => Some((equations.clone(), rest.clone())),
            SystemBody::Matrices { .. } => None,
        };
        Ok(Some(System {
            label: label.clone(),
            name: name.value.clone(),
            description: description.clone(),
            coordinates: coordinates.clone(),
            equations,
            mass,
            damping,
            stiffness,
            span: name.span.clone(),
        }))
    }

    /// All matrices: M, the parts of C and the parts of K.
    pub fn matrices(&self) -> impl Iterator<Item = &Expression> {
        let parts = self.damping.iter().chain(&self.stiffness);
        [&self.mass]
            .into_iter()
            .chain(parts.map(|part| &part.matrix))
    }

    /// A matrix by its name: `mass`, `damping` and `stiffness`, or the name of a part that no other one has.
    pub(crate) fn matrix_named(&self, name: &Name) -> Option<Expression> {
        let parts = || self.damping.iter().chain(&self.stiffness);
        let sum = |parts: &[Part]| {
            let matrices = parts.iter().map(|part| part.matrix.clone());
            matrices.reduce(|sum, own| Expression::binary(BinaryOperator::Add, sum, own))
        };
        let is_it = |part: &&Part| part.name.as_ref().is_some_and(|own| own.value == *name);
        let own: Vec<&Part> = parts().filter(is_it).collect();
        match (name.ascii.as_str(), own.as_slice()) {
            ("mass", []) => Some(self.mass.clone()),
            ("damping", []) => sum(&self.damping),
            ("stiffness", []) => sum(&self.stiffness),
            ("mass" | "damping" | "stiffness", _) => None,
            (_, [only]) => Some(only.matrix.clone()),
            _ => None,
        }
    }

    /// What is to be compiled: the entries of M, of each part of C and of each part of K, row by row, after
    /// replacements.
    pub fn evaluator(&self, place: Option<&Place>) -> Evaluator {
        let matrices = self.matrices().enumerate();
        let outputs = matrices.map(|(number, matrix)| Output {
            name: Name::new(&format!("matrix_{number}")),
            expression: match place {
                Some(place) => matrix.clone().at(place.clone()),
                None => matrix.clone(),
            },
        });
        Evaluator {
            label: self.label.clone(),
            name: self.name.clone(),
            description: self.description.clone(),
            outputs: outputs.collect(),
            approximated: None,
            conditions: Vec::new(),
            span: self.span.clone(),
        }
    }
}

/// ∂F/∂q̈, ∂F/∂q̇ and ∂F/∂q at rest.
fn linear(
    equations: &Expression,
    coordinates: &[Spanned<Name>],
    rest: &Place,
) -> (Expression, Vec<Part>, Vec<Part>) {
    let matrix = |rates: usize| {
        let moved = coordinates.iter().map(|name| {
            let bare = Expression {
                node: Node::Name(name.value.clone()),
                span: name.span.clone(),
            };
            (0..rates).fold(bare, |inner, _| call("dt", vec![inner]))
        });
        let moved = Expression {
            node: Node::Matrix(vec![moved.collect()]),
            span: equations.span.clone(),
        };
        call("d", vec![equations.clone(), moved]).at(rest.clone())
    };
    let part = |rates| {
        vec![Part {
            name: None,
            matrix: matrix(rates),
        }]
    };
    (matrix(2), part(1), part(0))
}

fn call(function: &str, arguments: Vec<Expression>) -> Expression {
    let span = arguments[0].span.clone();
    Expression {
        span,
        ..Expression::call(Name::new(function), 0, arguments)
    }
}

fn check_coordinates(coordinates: &[Spanned<Name>]) -> Result<(), Diagnostic> {
    all_different("coordinate", coordinates.iter())?;
    match coordinates.get(MOST_COORDINATES) {
        None => Ok(()),
        Some(first) => {
            let message = format!("a system has at most {MOST_COORDINATES} coordinates");
            Err(
                Diagnostic::new(DiagnosticKind::Budget, first.span.clone(), message)
                    .with_label(format!("this is number {}", MOST_COORDINATES + 1))
                    .with_help("leave out coordinates, or take fewer modes"),
            )
        }
    }
}

fn all_different<'a>(
    what: &str,
    names: impl Iterator<Item = &'a Spanned<Name>>,
) -> Result<(), Diagnostic> {
    let mut known: Vec<&Spanned<Name>> = Vec::new();
    for name in names {
        if let Some(first) = known.iter().find(|known| known.value == name.value) {
            let message = format!("the {what} `{}` is named twice", name.value);
            return Err(
                Diagnostic::new(DiagnosticKind::Duplicate, name.span.clone(), message)
                    .with_label("the same name again")
                    .with_secondary(first.span.clone(), "the first one")
                    .with_help("name each of them once"),
            );
        }
        known.push(name);
    }
    Ok(())
}
