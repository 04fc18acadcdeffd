//! What a document wants compiled.

use super::diagnostic::{Diagnostic, DiagnosticKind, nearest};
use super::syntax::{
    Approximated, EvaluatorBody, Expression, Label, Name, Node, Relation, Span, Spanned, Statement,
    StatementKind,
};

/// Something to compile: named outputs, each an expression of the document.
#[derive(Clone, Debug)]
pub struct Evaluator {
    /// How it is called in headers.
    pub label: Label,
    /// How it is called in programs.
    pub name: Name,
    /// In words.
    pub description: Option<String>,
    /// What it computes.
    pub outputs: Vec<Output>,
    /// What its outputs are close to, if the document says so.
    pub approximated: Option<Approximated>,
    /// Where that means something, beyond what its outputs themselves need.
    pub conditions: Vec<Relation>,
    /// Where the document asks for it.
    pub span: Span,
}

/// An output of an evaluator.
#[derive(Clone, Debug)]
pub struct Output {
    /// How it is called; the entries of a matrix are numbered behind the name.
    pub name: Name,
    /// What it is.
    pub expression: Expression,
}

impl Evaluator {
    /// What an `evaluator` statement asks for, given those before it; nothing is computed yet.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where a name is taken or unknown.
    pub(crate) fn of(
        statement: &Statement,
        known: &[Evaluator],
    ) -> Result<Option<Evaluator>, Diagnostic> {
        let StatementKind::Evaluator {
            label,
            name,
            body,
            approximated,
            conditions,
            description,
        } = &statement.kind
        else {
            return Ok(None);
        };
        let mut outputs: Vec<Output> = Vec::new();
        for (name, expression) in written_outputs(body, known)? {
            if outputs.iter().any(|output| output.name == name.value) {
                let message = format!("two outputs are called `{}`", name.value);
                return Err(
                    Diagnostic::new(DiagnosticKind::Duplicate, name.span.clone(), message)
                        .with_label("the same name again")
                        .with_help("give each output a name of its own"),
                );
            }
            outputs.push(Output {
                name: name.value,
                expression,
            });
        }
        Ok(Some(Evaluator {
            label: label.clone(),
            name: name.value.clone(),
            description: description.clone(),
            outputs,
            approximated: approximated.clone(),
            conditions: inherited(body, known)
                .chain(conditions.iter().cloned())
                .collect(),
            span: name.span.clone(),
        }))
    }
}

/// The conditions of the general evaluator after the replacements.
fn inherited<'a>(
    body: &'a EvaluatorBody,
    known: &'a [Evaluator],
) -> impl Iterator<Item = Relation> + 'a {
    let special = match body {
        EvaluatorBody::Special { general, place } => Some((&general.value, place)),
        EvaluatorBody::Outputs(_) => None,
    };
    let general = special.and_then(|(general, place)| {
        let found = known.iter().find(|known| known.name == *general)?;
        Some((found, place))
    });
    general.into_iter().flat_map(|(general, place)| {
        let at = |side: &Expression| side.clone().at(place.clone());
        general.conditions.iter().map(move |condition| Relation {
            left: at(&condition.left),
            comparison: condition.comparison,
            right: at(&condition.right),
        })
    })
}

/// The outputs as the document writes them; those of a special evaluator are those of the general one
/// after the replacements.
fn written_outputs(
    body: &EvaluatorBody,
    known: &[Evaluator],
) -> Result<Vec<(Spanned<Name>, Expression)>, Diagnostic> {
    let (general, place) = match body {
        EvaluatorBody::Outputs(outputs) => return Ok(outputs.clone()),
        EvaluatorBody::Special { general, place } => (general, place),
    };
    let Some(found) = known.iter().find(|known| known.name == general.value) else {
        let message = format!("there is no evaluator `{}` yet", general.value);
        let names = known.iter().map(|known| known.name.unicode.as_str());
        let help = match nearest(&general.value.unicode, names) {
            Some(near) => format!("did you mean `{near}`?"),
            None => "declare it above with `evaluator`".to_string(),
        };
        return Err(
            Diagnostic::new(DiagnosticKind::UnknownName, general.span.clone(), message)
                .with_label("unknown evaluator")
                .with_help(help),
        );
    };
    let outputs = found.outputs.iter().map(|output| {
        let span = general.span.clone();
        let name = Spanned {
            value: output.name.clone(),
            span: span.clone(),
        };
        let node = Node::At(Box::new(output.expression.clone()), place.clone());
        (name, Expression { node, span })
    });
    Ok(outputs.collect())
}
