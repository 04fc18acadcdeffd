//! Documents that are audited.

use pyo3::prelude::*;
use sextic::compile::fixed::{Fixed, number_of};
use sextic::compile::generation::{self, specifications};
use sextic::disk::{self, Disk, Unread};
use sextic::documents::{ShippedLibrary, shipped};
use sextic::language::diagnostic::SourceFile;
use sextic::language::notation::Notation;
use sextic::report::advice::Advice;
use sextic::report::{json, refusals, text, words};
use sextic::verdict::audit::{Audit, Library, audit};
use sextic::verdict::claim::Claim;

use crate::compiled::Compiled;
use crate::evaluator::Evaluator;
use crate::failure::{Failure, of_document};

/// Audits recurse with what they read, and threads of Python may have little stack.
const STACK: usize = 64 << 20;

/// How messages call a document that has no file.
const NAME_OF_TEXT: &str = "text";

/// A document, and what became of it.
#[pyclass(frozen, module = "sextic._sextic")]
pub struct Document {
    pub audit: Audit,
}

/// Audits the document in a file; what it imports is sought beside it.
#[pyfunction]
pub fn audit_file(py: Python<'_>, path: &str) -> PyResult<Document> {
    let source = disk::document(path).map_err(|unread| match unread {
        Unread::File(message, help) => Failure::Input(Advice::new(message, help)),
        Unread::Text(at) => Failure::Document(at),
    })?;
    audited(py, &source, Disk::default)
}

/// Audits a text; what it imports is sought in the folder of this process.
#[pyfunction]
pub fn audit_text(py: Python<'_>, text: &str) -> PyResult<Document> {
    audited(py, &SourceFile::new(NAME_OF_TEXT, text), Disk::default)
}

/// Audits one of the documents that come with the program.
#[pyfunction]
pub fn audit_shipped(py: Python<'_>, path: &str) -> PyResult<Document> {
    let source = shipped().find(|own| own.path == path).ok_or_else(|| {
        let message = format!("no document `{path}` comes with the program");
        Failure::Input(Advice::unknown(message, path, &shipped_documents()))
    })?;
    audited(py, &source, || ShippedLibrary)
}

/// The paths of the documents that come with the program.
#[pyfunction]
pub fn shipped_documents() -> Vec<String> {
    shipped().map(|own| own.path).collect()
}

/// Audits while other threads of Python go on.
fn audited<L: Library>(
    py: Python<'_>,
    source: &SourceFile,
    library: impl FnOnce() -> L + Send,
) -> PyResult<Document> {
    let work = || audit(source, &library()).map_err(|own| *own);
    let found = py.detach(|| {
        std::thread::scope(|scope| {
            let thread = std::thread::Builder::new().stack_size(STACK);
            thread.spawn_scoped(scope, work).map(|own| own.join())
        })
    })?;
    let found = found.map_err(|_| {
        let help = "this is a mistake of the program: please report the document";
        Failure::Input(Advice::new("the audit broke off", help))
    })?;
    let audit = found.map_err(|rejected| match rejected.diagnostics.first() {
        Some(first) => Failure::Document(Box::new((first.clone(), rejected.source.clone()))),
        None => Failure::Input(Advice::new(rejected.to_string(), "")),
    })?;
    Ok(Document { audit })
}

#[pymethods]
impl Document {
    /// The verdicts as the command writes them with `--format json`.
    fn json(&self) -> String {
        let audits = std::slice::from_ref(&self.audit);
        json::audits(audits, &refusals::Messages::default())
    }

    /// The verdicts as the command writes them for a terminal.
    fn text(&self, width: usize) -> String {
        let styled = text::audit(&self.audit, width);
        anstream::adapter::strip_str(&styled).to_string()
    }

    /// The statements of the claims for a reader, and in LaTeX.
    fn statements(&self) -> Vec<(String, String)> {
        let claims = self.audit.claims.iter();
        let both = |own: &Claim| {
            let written = |notation| words::statement(own, notation);
            (written(Notation::Unicode), written(Notation::Latex))
        };
        claims.map(both).collect()
    }

    /// The mistakes, as exceptions.
    fn mistakes<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let mistakes = self.audit.mistakes.iter();
        let placed = mistakes.filter_map(|own| Some((own, self.audit.source_of(own)?)));
        placed
            .map(|(own, source)| of_document(py, &own.diagnostic, source))
            .collect()
    }

    /// The names of its evaluators.
    fn evaluators(&self) -> Vec<&str> {
        let evaluators = self.audit.evaluators.iter();
        evaluators.map(|own| own.name.ascii.as_str()).collect()
    }

    /// The names of its systems.
    fn systems(&self) -> Vec<&str> {
        let systems = self.audit.systems.iter();
        systems.map(|own| own.name.ascii.as_str()).collect()
    }

    /// The evaluator of this name, with quantities fixed to numbers as they are written.
    fn compile(
        &self,
        py: Python<'_>,
        name: &str,
        fix: Vec<(String, String)>,
    ) -> PyResult<Evaluator> {
        let compiled = py.detach(|| self.compiled(name, &fix))?;
        Ok(Evaluator::new(Box::new(compiled)))
    }
}

impl Document {
    /// Refuses a document that is not as it says.
    pub fn check(&self) -> Result<&Audit, Failure> {
        if let Some(mistake) = self.audit.mistakes.first() {
            let source = self.audit.source_of(mistake);
            let source = source.unwrap_or(self.audit.source()).clone();
            return Err(Failure::Document(Box::new((
                mistake.diagnostic.clone(),
                source,
            ))));
        }
        match self.audit.as_expected() {
            true => Ok(&self.audit),
            false => Err(Advice::differs(&self.audit).into()),
        }
    }

    fn compiled(&self, name: &str, fix: &[(String, String)]) -> Result<Compiled, Failure> {
        let audit = self.check()?;
        let fixed: Vec<Fixed> = fix.iter().map(fixed).collect::<Result<_, _>>()?;
        let found = specifications(std::slice::from_ref(audit), &[name.to_string()], &fixed);
        let found = found.map_err(|own| self.failed(own))?;
        let specification = found.first().ok_or_else(|| self.nothing())?;
        Compiled::of(specification).map_err(|_| {
            let message = format!("a constant of `{name}` is beyond the range of a double");
            Advice::new(message, "quantities are in SI units").into()
        })
    }

    fn nothing(&self) -> Failure {
        let message = format!("{} wants nothing compiled", self.audit.path);
        Advice::new(
            message,
            "say what with `evaluator (1) name: output = expression`",
        )
        .into()
    }

    /// Why nothing was compiled.
    fn failed(&self, failure: generation::Failure) -> Failure {
        use generation::Failure as Why;
        match failure {
            Why::UnknownEvaluator(name, known) => {
                Advice::unknown(format!("there is no evaluator `{name}`"), &name, &known).into()
            }
            Why::UnknownQuantity(name, known) => {
                let message = format!("no evaluator that is generated rests on `{name}`");
                Advice::unknown(message, &name, &known).into()
            }
            Why::Refused(evaluator, _, refusal) => refused(&self.audit, &evaluator, refusal),
            Why::NoEvaluator => self.nothing(),
            other => Advice::new(
                other.to_string(),
                "this is a mistake of the program: please report the document",
            )
            .into(),
        }
    }
}

/// Why something of a document becomes no program.
pub fn refused(
    audit: &Audit,
    name: &str,
    refusal: sextic::compile::specification::Refusal,
) -> Failure {
    use sextic::compile::specification::Refusal;
    match (Advice::refused(name, &refusal), refusal) {
        (None, Refusal::Document(diagnostic)) => {
            Failure::Document(Box::new((*diagnostic, audit.source().clone())))
        }
        (advice, _) => advice.unwrap_or_else(|| Advice::new(name, "")).into(),
    }
}

/// A quantity and its number, as it is written.
pub fn fixed((name, text): &(String, String)) -> Result<Fixed, Failure> {
    let value = number_of(text).ok_or_else(|| {
        let message = format!("`{text}` is no decimal number and no fraction");
        Advice::new(message, format!("give {name} as a number"))
    })?;
    Ok(Fixed {
        name: name.clone(),
        value,
        text: text.clone(),
    })
}
