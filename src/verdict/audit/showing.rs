//! What expressions are: those that a document shows, and those that stand in none, by the names of one.

use crate::derivation::shown::Shown;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind};
use crate::language::expression_parser::parse_expression_with;
use crate::language::syntax::{Expression, Node, Statement, StatementKind};

use super::Audit;
use super::reader::{Read, Reader};

impl Reader<'_> {
    /// Shows what a statement wants shown, if it wants that.
    pub(super) fn show(
        &mut self,
        statement: &Statement,
        read: &mut Read,
    ) -> Result<bool, Diagnostic> {
        let StatementKind::Show {
            expression,
            description,
        } = &statement.kind
        else {
            return Ok(false);
        };
        let (line, words) = (self.here.line, description.as_deref());
        let shown = self
            .elaborator
            .show(expression, words, line, &statement.span)?;
        read.shown.push(shown);
        Ok(true)
    }
}

impl Audit {
    /// What an expression is by the names of the document.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] with a place in the text of the expression.
    ///
    /// ```
    /// use sextic::documents::ShippedLibrary;
    /// use sextic::language::diagnostic::SourceFile;
    /// use sextic::language::notation::Notation;
    /// use sextic::verdict::audit::audit;
    ///
    /// let text = "```sextic\nparameter a, b : m\nc := a + b\n```\n";
    /// let mut audit = audit(&SourceFile::new("a.md", text), &ShippedLibrary)?;
    /// let shown = audit.show("c^2 - b^2")?;
    /// let entry = shown.scalar().expect("a number");
    /// assert_eq!(Notation::Ascii.expression(&entry.normal_form), "a**2 + 2*a*b");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn show(&mut self, text: &str) -> Result<Shown, Diagnostic> {
        let expression = parse_expression_with(text, &mut self.aliases.clone());
        let expression = expression.map_err(|error| match error.span.start < text.len() {
            true => error,
            false => error.with_help("complete the expression, such as `a + b`"),
        })?;
        let span = 0..text.len();
        let statement = Statement {
            kind: StatementKind::Show {
                expression: expression.clone(),
                description: None,
            },
            span: span.clone(),
        };
        self.elaborator.fresh();
        self.require_no_mistake(&statement)?;
        let words = self.words(&expression);
        let shown = self
            .elaborator
            .show(&expression, words.as_deref(), 1, &span);
        // A definition with arguments may be wrong in its own text, which is not this one.
        shown.map_err(|error| match error.span.end <= text.len() {
            true => error,
            false => error.moved_to(&span, "in what this rests on"),
        })
    }

    /// What the document says of a name that it declares.
    fn words(&self, expression: &Expression) -> Option<String> {
        let Node::Name(name) = &expression.node else {
            return None;
        };
        self.elaborator.scope.get(name)?.description.clone()
    }

    /// Sees that an expression does not build on a statement that is refused.
    fn require_no_mistake(&self, statement: &Statement) -> Result<(), Diagnostic> {
        let scope = &self.elaborator.scope;
        let Some(reason) = self.refusals.reason(statement, scope) else {
            return Ok(());
        };
        let basis = reason.basis("");
        let (kind, message) = (
            DiagnosticKind::UnknownName,
            format!("this {}", basis.reason),
        );
        Err(Diagnostic::new(kind, statement.span.clone(), message)
            .with_label("it rests on what is refused")
            .with_help(format!("correct `{}` first", basis.place.path)))
    }
}
