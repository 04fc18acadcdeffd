//! What went wrong, where, and what to do.

mod excerpt;

use std::fmt;

use ariadne::{Color, Config, IndexType, Label, Report, ReportKind, Source};

use super::line_end::unified;
use super::syntax::Span;
use excerpt::{Excerpt, shortened};

/// The sort of a mistake; each has a code that does not change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum DiagnosticKind {
    /// The text does not follow the grammar.
    Syntax,
    /// A name is used that nothing declares.
    UnknownName,
    /// Something is declared twice, or two labels have the same identifier.
    Duplicate,
    /// A function is given too few or too many arguments, or arguments it cannot take.
    Arguments,
    /// Matrices do not fit together.
    Shape,
    /// Units do not fit together.
    Unit,
    /// Something is divided by what is identically zero.
    DivisionByZero,
    /// An equation is not linear in what it should be solved for.
    NotLinear,
    /// An expression is not a polynomial in what it should be one.
    NotPolynomial,
    /// A matrix has no inverse.
    Singular,
    /// Equations contradict each other.
    Inconsistent,
    /// The two routes to a verdict disagree: a mistake of this program.
    Disagreement,
    /// A fenced block is not closed.
    UnbalancedFence,
    /// A document has nothing to execute.
    NoBlock,
    /// What is read is not what a reader of the rendered page sees.
    Hidden,
    /// Two names are written differently and look the same.
    LookAlike,
    /// A file is not UTF-8.
    NotUtf8,
    /// A file cannot be read.
    MissingFile,
    /// A document imports itself, perhaps through others.
    CircularImport,
    /// Something is larger than this program is willing to work on.
    Budget,
    /// Something has a meaning, but this program cannot compute with it.
    Unsupported,
}

impl DiagnosticKind {
    /// The code: lower-case words with hyphens.
    pub const fn code(self) -> &'static str {
        match self {
            Self::Syntax => "syntax",
            Self::UnknownName => "unknown-name",
            Self::Duplicate => "duplicate",
            Self::Arguments => "arguments",
            Self::Shape => "shape",
            Self::Unit => "unit",
            Self::DivisionByZero => "division-by-zero",
            Self::NotLinear => "not-linear",
            Self::NotPolynomial => "not-polynomial",
            Self::Singular => "singular",
            Self::Inconsistent => "inconsistent",
            Self::Disagreement => "disagreement",
            Self::UnbalancedFence => "unbalanced-fence",
            Self::NoBlock => "no-block",
            Self::Hidden => "hidden",
            Self::LookAlike => "look-alike",
            Self::NotUtf8 => "not-utf-8",
            Self::MissingFile => "missing-file",
            Self::CircularImport => "circular-import",
            Self::Budget => "budget",
            Self::Unsupported => "unsupported",
        }
    }
}

/// A mistake in a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Its sort.
    pub kind: DiagnosticKind,
    /// What is wrong, in a sentence without a full stop.
    pub message: String,
    /// Where.
    pub span: Span,
    /// A few words at the mark.
    pub label: String,
    /// What to do about it.
    pub help: Option<String>,
    /// Other places that have to do with it.
    pub secondary: Vec<(Span, String)>,
}

impl fmt::Display for Diagnostic {
    /// What is wrong and what to do about it, without the place, which [`render`] shows.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)?;
        match &self.help {
            Some(help) => write!(formatter, " ({help})"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for Diagnostic {}

impl Diagnostic {
    /// A mistake at a place.
    pub fn new(kind: DiagnosticKind, span: Span, message: impl Into<String>) -> Self {
        Self {
            kind,
            message: message.into(),
            span,
            label: String::new(),
            help: None,
            secondary: Vec::new(),
        }
    }

    /// A mistake against the grammar.
    pub fn syntax(span: Span, message: impl Into<String>) -> Self {
        Self::new(DiagnosticKind::Syntax, span, message)
    }

    /// Adds the words at the mark.
    #[must_use]
    pub fn with_label(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// Adds what to do.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Adds what to do where nothing better is known.
    #[must_use]
    pub fn or_help(mut self, help: impl Into<String>) -> Self {
        self.help.get_or_insert_with(|| help.into());
        self
    }

    /// Moves it from where it stands in no text to a place, with the words that connect the two.
    #[must_use]
    pub fn moved_to(mut self, span: &Span, words: &str) -> Self {
        self.span = span.clone();
        self.label = format!("{} {words}", self.label).trim().to_string();
        self.secondary.retain(|(span, _)| *span != (0..0));
        self
    }

    /// Adds another place.
    #[must_use]
    pub fn with_secondary(mut self, span: Span, label: impl Into<String>) -> Self {
        self.secondary.push((span, label.into()));
        self
    }
}

/// A document as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceFile {
    /// How messages call it.
    pub path: String,
    /// What it says.
    pub text: String,
}

impl SourceFile {
    /// A document with a known text.
    pub fn new(path: impl Into<String>, text: impl Into<String>) -> Self {
        Self {
            path: path.into(),
            text: text.into(),
        }
    }

    /// Reads a document's bytes.
    ///
    /// # Errors
    ///
    /// Bytes that are not UTF-8; [`SourceFile::from_bytes_lossy`] gives the file to render that error with.
    pub fn from_bytes(path: impl Into<String>, bytes: &[u8]) -> Result<Self, Diagnostic> {
        match std::str::from_utf8(bytes) {
            // Some editors begin a file with a mark that is no part of its text.
            Ok(text) => Ok(Self::new(
                path,
                text.strip_prefix('\u{FEFF}').unwrap_or(text),
            )),
            Err(error) => {
                let offset = error.valid_up_to();
                let message = format!("the document is not UTF-8 from byte {offset} on");
                Err(
                    Diagnostic::new(DiagnosticKind::NotUtf8, offset..offset + 1, message)
                        .with_label("no character begins with this byte")
                        .with_help("save the document in the encoding UTF-8"),
                )
            }
        }
    }

    /// Reads a document's bytes for display, with `�` for what is no text.
    ///
    /// Up to the first `�` its offsets are those of the bytes.
    pub fn from_bytes_lossy(path: impl Into<String>, bytes: &[u8]) -> Self {
        Self::new(path, String::from_utf8_lossy(bytes))
    }

    /// The line and the column of a place, both counted from 1, the column in characters.
    pub fn line_and_column(&self, span: &Span) -> (usize, usize) {
        position(&self.text, self.clamp(span).start)
    }

    /// The nearest span that lies in the text and splits no character.
    fn clamp(&self, span: &Span) -> Span {
        let mut start = span.start.min(self.text.len());
        while !self.text.is_char_boundary(start) {
            start -= 1;
        }
        let mut end = span.end.clamp(start, self.text.len());
        while !self.text.is_char_boundary(end) {
            end += 1;
        }
        start..end
    }
}

/// Writes a diagnostic for a terminal: file, line and column (in characters), the marked place, the help.
pub fn render(diagnostic: &Diagnostic, source: &SourceFile, colour: bool) -> String {
    let path = source.path.as_str();
    let others = diagnostic.secondary.iter().map(|(span, _)| span);
    let spans: Vec<Span> = [&diagnostic.span]
        .into_iter()
        .chain(others)
        .map(|span| source.clamp(span))
        .collect();
    let text = unified(&source.text);
    let excerpt = Excerpt::new(&text, &spans);
    let place = |span: &Span| (path, excerpt.mark(&source.clamp(span)));
    let mark = |span, text: &str, paint| {
        // Without words no mark is drawn.
        let text = if text.is_empty() { "here" } else { text };
        Label::new(place(span))
            .with_color(paint)
            .with_message(shortened(text))
    };
    let others = diagnostic.secondary.iter();
    let mut marks = vec![(&diagnostic.span, diagnostic.label.as_str(), Color::Red)];
    marks.extend(others.map(|(span, text)| (span, text.as_str(), Color::Blue)));
    // In any other order the lines are shown in several pieces.
    marks.sort_by_key(|(span, ..)| span.start);
    let labels = marks
        .into_iter()
        .map(|(span, text, paint)| mark(span, text, paint));
    let mut report = Report::build(ReportKind::Error, place(&diagnostic.span))
        .with_config(
            Config::new()
                .with_color(colour)
                .with_index_type(IndexType::Byte),
        )
        .with_code(diagnostic.kind.code())
        .with_message(shortened(&diagnostic.message))
        .with_labels(labels);
    if let Some(help) = &diagnostic.help {
        report.set_help(shortened(help));
    }
    let mut rendered = Vec::new();
    let cache = (path, Source::from(excerpt.text.as_str()));
    // Writing to a vector fails only if the text of a label does, and it never does.
    if report.finish().write(cache, &mut rendered).is_err() {
        return format!("{path}: {}\n", diagnostic.message);
    }
    let rendered = String::from_utf8_lossy(&rendered);
    let written = |(line, column)| format!("{path}:{line}:{column}");
    let shown = written(position(&excerpt.text, place(&diagnostic.span).1.start));
    let meant = written(position(&text, spans[0].start));
    rendered
        .replacen(&shown, &meant, 1)
        .lines()
        .flat_map(|line| [line.trim_end(), "\n"])
        .collect()
}

/// The line and the column of a place, in characters.
fn position(text: &str, place: usize) -> (usize, usize) {
    let before = &text[..place];
    let line = before.matches('\n').count() + 1;
    let column = before
        .chars()
        .rev()
        .take_while(|letter| *letter != '\n')
        .count()
        + 1;
    (line, column)
}

/// The candidate that a misspelt name most probably means, if one is near enough.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = name.to_lowercase();
    // A third of the letters may be wrong: none of one letter, one of two.
    let limit = (name.chars().count() + 1) / 3;
    let length = lower.chars().count();
    // As many letters are wrong at least as there are too few or too many.
    let is_of_length = |candidate: &&str| {
        let letters = candidate.chars().flat_map(char::to_lowercase).count();
        letters.abs_diff(length) <= limit
    };
    let candidates = candidates.into_iter().filter(is_of_length);
    let distances = candidates.map(|candidate| {
        let exact = strsim::damerau_levenshtein(name, candidate);
        let folded = strsim::damerau_levenshtein(&lower, &candidate.to_lowercase());
        (exact, folded, candidate)
    });
    let near = distances.filter(|&(_, folded, _)| folded <= limit);
    near.min_by_key(|&(exact, folded, _)| (exact, folded))
        .map(|(_, _, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters() {
        let source = SourceFile::new("paper.md", "αβγ δ\n");
        let diagnostic = Diagnostic::syntax(7..9, "no").with_label("here");
        assert!(render(&diagnostic, &source, false).contains("paper.md:1:5"));
    }

    #[test]
    fn any_span_can_be_rendered() {
        let source = SourceFile::new("paper.md", "αβ\n");
        for start in 0..8 {
            for length in 0..8 {
                let diagnostic = Diagnostic::syntax(start..start + length, "no").with_label("here");
                assert!(render(&diagnostic, &source, true).contains("paper.md"));
            }
        }
        let empty = SourceFile::new("empty.md", "");
        let backwards = Diagnostic::syntax(Span { start: 3, end: 2 }, "no");
        assert!(render(&backwards, &empty, false).contains("empty.md"));
    }

    #[test]
    fn colour_is_used_only_when_it_is_wanted() {
        let source = SourceFile::new("paper.md", "a");
        let diagnostic = Diagnostic::syntax(0..1, "no").with_help("yes");
        assert!(!render(&diagnostic, &source, false).contains('\u{1b}'));
        assert!(render(&diagnostic, &source, true).contains('\u{1b}'));
    }

    #[test]
    fn bytes_that_are_no_text_are_shown_where_they_stand() {
        let bytes = b"# \xce\xb1\n\xff\n";
        let error = SourceFile::from_bytes("paper.md", bytes).unwrap_err();
        assert_eq!((error.kind.code(), error.span.start), ("not-utf-8", 5));
        let source = SourceFile::from_bytes_lossy("paper.md", bytes);
        assert!(render(&error, &source, false).contains("paper.md:2:1"));
    }

    #[test]
    fn a_mark_before_the_text_is_left_out() {
        let source = SourceFile::from_bytes("paper.md", b"\xef\xbb\xbfa").unwrap();
        assert_eq!(source.text, "a");
    }

    #[test]
    fn the_nearest_name_is_found() {
        let names = ["parameter", "L_g", "l_g", "C_D", "r"];
        assert_eq!(nearest("paramter", names), Some("parameter"));
        assert_eq!(nearest("L_q", names), Some("L_g"));
        assert_eq!(nearest("c_d", names), Some("C_D"));
        assert_eq!(nearest("R", names), Some("r"));
        assert_eq!(nearest("x", names), None);
        assert_eq!(nearest("coordinate", names), None);
    }
}
