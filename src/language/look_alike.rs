//! Names that a reader takes for each other, in a document and in what it imports.

use std::collections::BTreeMap;

use super::diagnostic::{Diagnostic, DiagnosticKind, SourceFile};
use super::line_end::unified;
use super::name::skeleton::looks;
use super::syntax::{EvaluatorBody, Name, Span, Spanned, Statement, StatementKind};
use crate::language::built_in::is_built_in;

/// The names that documents declare, by what they look like.
#[derive(Clone, Debug, Default)]
pub(crate) struct Looks {
    by_skeleton: BTreeMap<String, Declared>,
    /// The functions, by their ASCII names.
    functions: BTreeMap<String, Declared>,
    /// The names that are printed like a derivative, by the ASCII name of the function.
    derivatives: BTreeMap<String, Declared>,
}

/// A name, and where it is declared.
#[derive(Clone, Debug)]
struct Declared {
    name: Name,
    place: Place,
}

#[derive(Clone, Debug)]
enum Place {
    /// In the document that is being read.
    Here(Span),
    /// In one that it imports: `other.md:4:11`.
    There(String),
}

impl Looks {
    /// Takes up all that the statements of a document declare, and says what a reader takes for
    /// something else.
    pub(crate) fn declare_all(&mut self, statements: &[Statement]) -> Vec<Diagnostic> {
        let mut errors = Vec::new();
        for statement in statements {
            let is_function = matches!(statement.kind, StatementKind::Function { .. });
            for name in declared(statement) {
                errors.extend(self.declare(name, is_function));
            }
        }
        errors
    }

    /// Takes up a name; what it is taken for, if it is.
    fn declare(&mut self, name: &Spanned<Name>, is_function: bool) -> Option<Diagnostic> {
        let own = Declared {
            name: name.value.clone(),
            place: Place::Here(name.span.clone()),
        };
        let mut error = None;
        for look in looks(&name.value) {
            if is_built_in(&look) && look != name.value.ascii {
                error.get_or_insert_with(|| taken_for_built_in(name, &look));
            }
            let known = self.by_skeleton.entry(look).or_insert_with(|| own.clone());
            if known.name != own.name {
                error.get_or_insert_with(|| same_look(name, known));
            }
        }
        error.or_else(|| self.declare_derivative(name, own, is_function))
    }

    /// In ASCII, C' is printed as `dC` and C'' as `d2C`.
    fn declare_derivative(
        &mut self,
        name: &Spanned<Name>,
        own: Declared,
        is_function: bool,
    ) -> Option<Diagnostic> {
        let ascii = &name.value.ascii;
        let mut error = None;
        if let Some(function) = differentiated(ascii) {
            let known = self.functions.get(function);
            error = known.map(|known| same_print(name, known, ascii, &known.name));
            let derivative = self.derivatives.entry(function.to_owned());
            derivative.or_insert_with(|| own.clone());
        }
        if !is_function {
            return error;
        }
        if let Some(known) = self.derivatives.get(ascii) {
            error = Some(same_print(name, known, &known.name.ascii, &name.value));
        }
        let printed = format!("d{ascii}");
        if is_built_in(&printed) {
            error = Some(prints_as_built_in(name, &printed));
        }
        self.functions.entry(ascii.clone()).or_insert(own);
        error
    }

    /// Notes in which document all of this stands, since what follows is another one.
    pub(crate) fn leave_document(&mut self, source: &SourceFile) {
        let text = unified(&source.text);
        let ends: Vec<usize> = text.match_indices('\n').map(|(end, _)| end).collect();
        let maps = [
            &mut self.by_skeleton,
            &mut self.functions,
            &mut self.derivatives,
        ];
        for declared in maps.into_iter().flat_map(BTreeMap::values_mut) {
            if let Place::Here(span) = &declared.place {
                let line = ends.partition_point(|end| *end < span.start) + 1;
                declared.place = Place::There(format!("{}:{line}", source.path));
            }
        }
    }

    /// Takes over what another document declares.
    pub(crate) fn extend(&mut self, other: &Self) {
        let take = |own: &mut BTreeMap<String, Declared>, other: &BTreeMap<String, Declared>| {
            for (key, declared) in other {
                own.entry(key.clone()).or_insert_with(|| declared.clone());
            }
        };
        take(&mut self.by_skeleton, &other.by_skeleton);
        take(&mut self.functions, &other.functions);
        take(&mut self.derivatives, &other.derivatives);
    }
}

/// The names that a statement declares, arguments of definitions and outputs of evaluators included.
fn declared(statement: &Statement) -> Vec<&Spanned<Name>> {
    match &statement.kind {
        StatementKind::Parameter { names, .. }
        | StatementKind::Complex { names, .. }
        | StatementKind::Angle { names, .. }
        | StatementKind::Coordinate { names, .. }
        | StatementKind::Function { names, .. } => names.iter().collect(),
        StatementKind::Definition {
            names, arguments, ..
        } => names.iter().chain(arguments).collect(),
        StatementKind::Imaginary { name } | StatementKind::Substitution { name, .. } => vec![name],
        StatementKind::Match(matching) => vec![&matching.name],
        StatementKind::System(system) => vec![&system.name],
        StatementKind::Evaluator { name, body, .. } => match body {
            EvaluatorBody::Outputs(outputs) => {
                let outputs = outputs.iter().map(|(output, _)| output);
                [name].into_iter().chain(outputs).collect()
            }
            EvaluatorBody::Special { .. } => vec![name],
        },
        StatementKind::Import { .. }
        | StatementKind::Assume { .. }
        | StatementKind::Assertion { .. }
        | StatementKind::Eigenpair { .. }
        | StatementKind::Show { .. }
        | StatementKind::Domain(_) => Vec::new(),
    }
}

/// `C` of `dC`, `d2C`, `d3C`, …: the function whose derivative is printed so.
fn differentiated(ascii: &str) -> Option<&str> {
    let rest = ascii.strip_prefix('d')?;
    let function = rest.trim_start_matches(|digit: char| digit.is_ascii_digit());
    let order = &rest[..rest.len() - function.len()];
    let is_order = order.is_empty() || order != "1" && !order.starts_with('0');
    (is_order && !function.is_empty()).then_some(function)
}

fn same_look(name: &Spanned<Name>, known: &Declared) -> Diagnostic {
    let message = format!(
        "`{}` looks like `{}`, which is another name",
        name.value, known.name
    );
    let spelled = format!("this is {}", spelled(&name.value));
    error(name, message, spelled, known)
        .with_help("spell both in one way where one thing is meant, or rename one of them")
}

fn same_print(name: &Spanned<Name>, known: &Declared, printed: &str, of: &Name) -> Diagnostic {
    let message = format!("a derivative of `{of}` is printed as `{printed}`, which is a name here");
    error(name, message, "declared here".to_owned(), known)
        .with_help("rename one of the two: in ASCII, C' is dC and C'' is d2C")
}

fn error(name: &Spanned<Name>, message: String, label: String, known: &Declared) -> Diagnostic {
    let error = Diagnostic::new(DiagnosticKind::LookAlike, name.span.clone(), message);
    match &known.place {
        Place::Here(span) => error
            .with_label(label)
            .with_secondary(span.clone(), format!("this is {}", spelled(&known.name))),
        Place::There(place) => {
            error.with_label(format!("{label}, at {place} is {}", spelled(&known.name)))
        }
    }
}

fn taken_for_built_in(name: &Spanned<Name>, built_in: &str) -> Diagnostic {
    let message = format!(
        "`{}` looks like the built-in function `{built_in}`",
        name.value
    );
    Diagnostic::new(DiagnosticKind::LookAlike, name.span.clone(), message)
        .with_label(format!("this is {}", spelled(&name.value)))
        .with_help("choose another name")
}

fn prints_as_built_in(name: &Spanned<Name>, printed: &str) -> Diagnostic {
    let message = format!(
        "the derivative of `{}` is printed as `{printed}`, a built-in function",
        name.value
    );
    Diagnostic::new(DiagnosticKind::LookAlike, name.span.clone(), message)
        .with_label("this function")
        .with_help("choose another name")
}

/// A name with what tells it from others that look the same: its ASCII spelling.
fn spelled(name: &Name) -> String {
    if name.unicode == name.ascii {
        format!("`{}`", name.ascii)
    } else {
        format!("`{}`, in ASCII `{}`", name.unicode, name.ascii)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::document::parse_document;

    /// The codes and the places of the mistakes in a block.
    fn mistakes(block: &str) -> Vec<(&'static str, String, usize)> {
        let text = format!("```sextic\n{block}\n```\n");
        let errors = parse_document(&SourceFile::new("a.md", text.clone())).err();
        let place = |error: Diagnostic| {
            let places = error.secondary.len();
            (error.kind.code(), text[error.span].to_owned(), places)
        };
        errors.into_iter().flatten().map(place).collect()
    }

    #[test]
    fn names_that_look_alike_are_refused_with_both_places() {
        for (block, name) in [
            ("parameter A : 1\nparameter Α : 1", "Α"),
            ("T := 1\nΤ := 2", "Τ"),
            ("parameter v, ν : 1", "ν"),
            ("parameter x_1, x__1 : 1", "x__1"),
            ("parameter x_ : 1\nparameter x : 1", "x"),
            ("parameter x_0, x_O : 1", "x_O"),
            ("parameter A : 1\nf(Α) := A + Α", "Α"),
            ("parameter A : 1\nsubstitution Α: A = 0", "Α"),
            ("parameter A : 1\nevaluator (1) e: Α = A", "Α"),
            ("angle α\nfunction C at α : 1\nparameter dC : 1", "dC"),
            ("angle α\nparameter d2C : 1\nfunction C at α : 1", "C"),
            ("angle α\nfunction C, dC at α : 1", "dC"),
            ("parameter y as dC : 1\nangle α\nfunction C at α : 1", "C"),
        ] {
            let expected = ("look-alike", name.to_owned(), 1);
            assert_eq!(mistakes(block), [expected], "{block}");
        }
    }

    #[test]
    fn names_that_look_like_functions_are_refused() {
        for (block, name) in [
            ("angle α\nfunction t at α : 1", "t"),
            ("angle α\nfunction et at α : 1", "et"),
            ("sιn(x) := x", "sιn"),
            ("colυmn := 1", "colυmn"),
        ] {
            let expected = ("look-alike", name.to_owned(), 0);
            assert_eq!(mistakes(block), [expected], "{block}");
        }
    }

    #[test]
    fn what_papers_have_is_well() {
        let block = "parameter ρ, p, ω_n, S_xθ, α_g, S_yθ as S_yt, dx, d1C, C_d : 1\nangle α, a\n\
                     function C, C_D at α : 1\nf(x) := x + 1\ng(x) := x";
        assert_eq!(mistakes(block), []);
    }

    #[test]
    fn derivatives_have_names() {
        for (name, function) in [
            ("dC", Some("C")),
            ("d2C_D", Some("C_D")),
            ("d10C", Some("C")),
            ("d1C", None),
            ("d02C", None),
            ("d", None),
            ("d2", None),
            ("Cd", None),
        ] {
            assert_eq!(differentiated(name), function, "{name}");
        }
    }
}
