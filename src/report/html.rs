//! A derivation and a case as one HTML file, which refers to nothing outside of itself.
//!
//! Rust decides what is said and prints every formula; the templates place strings, and escape what is
//! not marked as HTML. The page is well-formed XML too, so that a test can read it.

mod assertion;
mod case;
mod document;
mod matching;
mod mathematics;
mod prose;
mod repetition;
mod shown;
mod statement;
mod unit;

use serde::Serialize;
use tera::{Context, Tera};

use crate::language::diagnostic::SourceFile;
use crate::stability::comparison::Comparison;
use crate::stability::validity::Validity;
use crate::verdict::audit::Audit;

use super::gallery::Named;
use super::markup::{escape, visible};
use super::speeds::SpeedsFound;
use case::CaseView;
use document::DocumentView;
use repetition::Repetition;

/// Names end in `.html`, or nothing would be escaped.
const TEMPLATES: [(&str, &str); 5] = [
    ("report.html", include_str!("html/templates/report.html")),
    (
        "document.html",
        include_str!("html/templates/document.html"),
    ),
    (
        "matching.html",
        include_str!("html/templates/matching.html"),
    ),
    ("case.html", include_str!("html/templates/case.html")),
    ("style.html", include_str!("html/templates/style.css")),
];

/// What a report is about.
#[derive(Clone, Copy, Debug)]
pub struct Request<'a> {
    /// The document that was asked for; `None` for those that come with the command.
    pub document: Option<&'a str>,
    /// What became of the documents.
    pub audits: &'a [Audit],
    /// A case, if there is one.
    pub case: Option<&'a CaseFiles>,
    /// The version of the command.
    pub version: &'a str,
}

/// A case at all its angles, and the files that it was read from.
#[derive(Clone, Debug)]
pub struct CaseFiles {
    /// What the methods say of it.
    pub comparison: Comparison,
    /// Its figures beside that of its stability.
    pub figures: Vec<Named>,
    /// Its critical wind speeds, or why they are not known.
    pub speeds: Result<SpeedsFound, String>,
    /// Where its closed forms may be trusted, or why that is not known.
    pub validity: Result<Validity, String>,
    /// The case file and its table of coefficients.
    pub files: [SourceFile; 2],
}

/// What the template of the page is given.
#[derive(Serialize)]
struct PageView<'a> {
    title: String,
    documents: Vec<DocumentView>,
    case: Option<CaseView>,
    repetition: Repetition,
    version: &'a str,
}

/// Writes the page; the same request gives the same bytes.
///
/// Linear in the size of the documents and in the number of angles.
///
/// # Errors
///
/// In words, if the figure cannot be drawn or a template does not fit what it is given.
pub fn page(request: &Request) -> Result<String, String> {
    let documents = request.audits.iter().enumerate();
    let documents: Vec<DocumentView> = documents
        .map(|(index, audit)| DocumentView::new(audit, index + 1))
        .collect();
    let view = PageView {
        title: title(&documents, request.case),
        documents,
        case: request.case.map(CaseView::new).transpose()?,
        repetition: Repetition::new(request),
        version: request.version,
    };
    let failed = |error: tera::Error| format!("the page could not be made: {error:?}");
    let mut tera = Tera::new();
    tera.add_raw_templates(TEMPLATES).map_err(failed)?;
    let context = Context::from_serialize(&view).map_err(failed)?;
    tera.render("report.html", &context).map_err(failed)
}

/// What a browser calls the page.
fn title(documents: &[DocumentView], case: Option<&CaseFiles>) -> String {
    if let Some(case) = case {
        return format!(
            "Stability of {}",
            super::stability_figure::name(&case.comparison.case)
        );
    }
    let titles: Vec<&str> = documents.iter().map(DocumentView::title).collect();
    titles.join("; ")
}
