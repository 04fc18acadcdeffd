//! `sextic show`: what an expression of a document is.

use clap::{Args, ValueEnum};

use crate::derivation::scope::SymbolKind;
use crate::language::diagnostic::{SourceFile, render};
use crate::report::{json, latex, sympy, text};

use super::Outcome;
use super::output::{complain, finish, width};
use super::source::{Audited, audit_one};

/// How messages call what was asked for.
const ASKED: &str = "EXPR";

/// Shows what an expression is by the names of a document
///
/// Its normal form, which two expressions share where they are equal; the same as a product of factors;
/// its unit and the number of its terms; and on which conditions it has a value, beside what the document
/// declares and assumes. Of a matrix all entries are shown.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// An expression in the block language, such as a name that the document defines
    #[arg(value_name = "EXPR", allow_hyphen_values = true)]
    expression: String,

    /// A Markdown document; without one, He & Macdonald (2017), which comes with the command
    #[arg(long, value_name = "DOC")]
    document: Option<String>,

    /// How it is written
    #[arg(long, value_enum, default_value_t = Shape::Text)]
    format: Shape,

    /// How many columns text may fill (at least 40); as many as the terminal has if not given
    #[arg(long, value_name = "COLUMNS", value_parser = clap::value_parser!(u16).range(40..))]
    width: Option<u16>,
}

/// How an expression is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Shape {
    /// For a terminal
    Text,
    /// For programs
    Json,
    /// As mathematics for a formula in LaTeX: the product of factors
    Latex,
    /// As Python that SymPy runs: the product of factors
    Sympy,
}

const EXAMPLES: &str = "\
Examples:
  sextic show S_a                        the scaled damping matrix of the paper
  sextic show 'det(M)/m^2' --document mine.md
  sextic show closed_form.lamda_R1 --format latex   an output of an evaluator, for a paper
  sextic show closed_form.lamda_R1 --format sympy   the same for a notebook
  sextic show 'd(F_x, x) at rest' --document mine.md --format json | jq -r '.entries[].normal_form'

A document shows the same by a statement, `show det(M)/m^2`, in its audit.

Members of --format json:
  expression, description, rows, columns, conditions
  entries      row by row: row, column, normal_form, factored, unit (null for a 0 that fits every
               unit), terms and terms_below, the numbers of terms above and below the line";

/// Reads the document, elaborates the expression and writes what it is.
pub fn run(arguments: &Arguments) -> Outcome {
    let Audited {
        mut audits,
        outcome,
        ..
    } = audit_one(arguments.document.as_deref());
    // Where nothing could be read, its diagnostics have said all.
    let Some(audit) = audits.first_mut() else {
        return outcome;
    };
    let asked = &arguments.expression;
    match audit.show(asked) {
        Err(diagnostic) => {
            complain(&render(&diagnostic, &SourceFile::new(ASKED, asked), true));
            Outcome::WrongInput
        }
        Ok(shown) => {
            let path = &audit.path;
            let scope = &audit.elaborator.scope;
            let written = match arguments.format {
                Shape::Text => text::shown(path, &shown, width(arguments.width)),
                Shape::Json => json::shown(path, &shown),
                Shape::Latex => latex::equation(&shown),
                Shape::Sympy => sympy::shown(&shown, &|name| {
                    scope.kind_of(&name.ascii) == Some(SymbolKind::Imaginary)
                }),
            };
            finish(&written, outcome)
        }
    }
}
