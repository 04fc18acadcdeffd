//! Verdicts and matchings as a LaTeX document.

mod escape;

use crate::derivation::matching::{Matched, Row};
use crate::derivation::shown::Shown;
use crate::language::notation::Notation;
use crate::language::syntax::{Expression, Node};
use crate::verdict::audit::Audit;
use crate::verdict::claim::{Claim, Verdict};

use super::details::{Extent, details};
use super::phrase::Phrase;
use super::shown::{left, lines, size};
use super::summary::Summary;
use super::{premises, refusals, residuals, words};
use escape::{Prose, literal};

const PREAMBLE: &str = r"\documentclass{article}
\usepackage[T1]{fontenc}
\usepackage{textcomp}
\usepackage{amsmath, amssymb}
\usepackage{longtable}
\usepackage[margin=25mm]{geometry}
% Long formulas are broken at the signs between their operands, never stretched.
\raggedright
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\allowdisplaybreaks
% One assertion: verdict, label, description.
\newcommand{\assertion}[3]{\par\medskip\textbf{#2}\quad\textit{#1}\quad #3\par\nopagebreak}
";

/// Writes all verdicts on documents, and what they come to.
pub fn audits(audits: &[Audit]) -> String {
    document(audits.iter().map(audit))
}

/// Writes what an expression is as mathematics for a formula: its name, and its value in factors.
pub fn equation(shown: &Shown) -> String {
    let value = match shown.scalar() {
        Some(entry) => entry.factored.clone(),
        None => entries(shown),
    };
    let [left, value] = [left(shown), value].map(|own| Notation::Latex.expression(&own));
    format!("{left} = {value}\n")
}

fn entries(shown: &Shown) -> Expression {
    let entries: Vec<Expression> = shown
        .entries
        .iter()
        .map(|own| own.factored.clone())
        .collect();
    let rows = entries
        .chunks(shown.columns.max(1))
        .map(<[Expression]>::to_vec);
    Expression::made(Node::Matrix(rows.collect()))
}

/// Writes the matchings of documents.
pub fn matchings(audits: &[Audit]) -> String {
    let matchings = audits.iter().flat_map(|audit| {
        let matchings = audit.matchings.iter();
        matchings.map(|matched| matching(audit, matched))
    });
    document(matchings)
}

fn document(sections: impl Iterator<Item = String>) -> String {
    let sections: Vec<String> = sections.collect();
    format!(
        "{PREAMBLE}\n\\begin{{document}}\n\n{}\n\\end{{document}}\n",
        sections.join("\n")
    )
}

fn audit(audit: &Audit) -> String {
    let summary = Summary::new(audit);
    let prose = &Prose::of(audit);
    let title = match &audit.title {
        Some(title) => prose.escape(title),
        None => literal(&audit.path),
    };
    let mut page = format!("\\section*{{{title}}}\n");
    page += &format!("The verdicts on \\texttt{{{}}}. ", literal(&audit.path));
    page += &format!("{}\n", literal(&summary.conclusion()));
    let premises = premises::lines(audit, Notation::Latex);
    let premises = premises
        .iter()
        .map(|(keyword, line)| format!("{keyword} {}", phrase(line, prose)));
    page += &items("", premises);
    if !summary.counts.is_empty() {
        let rows = summary.counts.iter().map(|(verdict, count)| {
            format!("{} {} & {count} \\\\\n", mark(*verdict), verdict.text())
        });
        let rows: String = rows.collect();
        page += &format!("\n\\begin{{longtable}}{{lr}}\n{rows}\\end{{longtable}}\n");
    }
    page += &matchings_overview(summary.matchings, prose);
    for (heading, claims) in summary.failures() {
        let claims = claims.iter().map(|claim| {
            let label = prose.escape(&words::label(&claim.label));
            format!("{label} {}", description(claim, prose))
        });
        page += &items(heading, claims);
    }
    for (heading, lines) in refusals::lists(audit) {
        page += &items(heading, lines.iter().map(|line| prose.escape(line)));
    }
    if !audit.claims.is_empty() {
        page += "\n\\subsection*{Verdicts}\n";
    }
    for claim in &audit.claims {
        page += &self::claim(claim, prose);
    }
    if !audit.shown.is_empty() {
        page += "\n\\subsection*{Shown}\n";
    }
    for shown in &audit.shown {
        page += &self::shown(shown, prose);
    }
    page
}

/// A line for each matching; nothing where there is none.
fn matchings_overview(matchings: &[Matched], prose: &Prose) -> String {
    let lines = matchings.iter().map(|matched| {
        let label = prose.escape(&words::label(&matched.label));
        let overview = phrase(&residuals::overview(matched, Notation::Latex), prose);
        format!("{label} {overview}")
    });
    items("Matchings", lines)
}

/// A list below a heading, if it has one; nothing where the list is empty.
fn items(heading: &str, lines: impl Iterator<Item = String>) -> String {
    let lines: String = lines.map(|line| format!("\\item {line}\n")).collect();
    if lines.is_empty() {
        return lines;
    }
    let heading = match heading {
        "" => String::new(),
        heading => format!("\\subsection*{{{heading}}}\n"),
    };
    format!("\n{heading}\\begin{{itemize}}\n{lines}\\end{{itemize}}\n")
}

fn claim(claim: &Claim, prose: &Prose) -> String {
    let mut written = format!(
        "\n\\assertion{{{} {}}}{{{}}}{{{}}}\n",
        mark(claim.verdict),
        claim.verdict.text(),
        prose.escape(&words::label(&claim.label)),
        description(claim, prose)
    );
    if let Some(surprise) = words::surprise(claim) {
        written += &format!("\\textbf{{{}}}\\par\n", literal(&surprise));
    }
    written += &format!(
        "{}\\par\n",
        mathematics(&words::statement(claim, Notation::Latex))
    );
    for detail in details(claim, Notation::Latex, Extent::Full) {
        written += &format!(
            "{} {}\\par\n",
            detail.keyword,
            phrase(&detail.phrase, prose)
        );
    }
    written
}

fn shown(shown: &Shown, prose: &Prose) -> String {
    let words = shown.description.iter().cloned().chain(size(shown));
    let words: Vec<String> = words.map(|words| prose.escape(&words)).collect();
    let (line, words) = (shown.line, words.join(": "));
    let mut written = format!("\n\\assertion{{line {line}}}{{}}{{{words}}}\n");
    written += &format!("{}\\par\n", formula(&shown.expression));
    for line in lines(shown, Notation::Latex) {
        let (keyword, phrase) = (literal(&line.keyword), phrase(&line.phrase, prose));
        written += &format!("{keyword} {phrase}\\par\n");
    }
    written
}

fn matching(audit: &Audit, matched: &Matched) -> String {
    let prose = &Prose::of(audit);
    let label = prose.escape(&words::label(&matched.label));
    let mut page = format!("\\section*{{{label} {}}}\n", literal(&matched.name.unicode));
    if let Some(description) = &matched.description {
        page += &format!("{}.\n", prose.escape(description));
    }
    page += &format!(
        "\\texttt{{{}}}, line {}\n\n",
        literal(&audit.path),
        matched.line
    );
    let (exact, assumed) = words::polynomials(matched, Notation::Latex);
    page += &format!(
        "{} is matched with {}.\n",
        mathematics(&exact),
        mathematics(&assumed)
    );
    page += "\n\\subsection*{Coefficients}\n\\begin{description}\n";
    for row in &matched.table {
        page += &coefficients(matched, row, prose);
    }
    page += "\\end{description}\n";
    if !matched.neglected.is_empty() {
        page += "\n\\subsection*{Neglected}\n";
    }
    for neglected in &matched.neglected {
        let power = mathematics(&words::power(matched, neglected.power, Notation::Latex));
        let (expression, factor) = (formula(&neglected.expression), formula(&neglected.factor));
        page += &format!(
            "{expression} in the coefficient of {power}, where its factor is {factor}\\par\n"
        );
    }
    page += "\n\\subsection*{The linear equations}\n";
    page += &format!("Their determinant is {}.\n", formula(&matched.determinant));
    for singularity in &matched.singular_where {
        let place = mathematics(&words::singularity(singularity, Notation::Latex));
        page += &format!(
            "They are singular where {place}{}.\n",
            words::at_singularity(singularity)
        );
    }
    page += "\n\\subsection*{Solution}\n";
    for (name, value) in &matched.solution {
        let value = Notation::Latex.expression(value);
        let equation = format!("{} = {value}", Notation::Latex.name(name));
        page += &format!("{}\\par\n", mathematics(&equation));
    }
    page
}

fn coefficients(matched: &Matched, row: &Row, prose: &Prose) -> String {
    let power = mathematics(&words::power(matched, row.power, Notation::Latex));
    let used = if row.used {
        "used to solve"
    } else {
        "not used"
    };
    let remainder = phrase(&words::remainder(matched, row, Notation::Latex), prose);
    let mut written = format!("\\item[{power}] {used}, {remainder}\\par\n");
    written += &format!("exact {}\\par\n", formula(&row.exact));
    written += &format!("assumed {}\\par\n", formula(&row.assumed));
    if !words::is_zero(&row.residual) {
        written += &format!("residual {}\\par\n", formula(&row.residual));
    }
    written
}

/// The mark of a verdict in the symbols of amssymb.
const fn mark(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds | Verdict::HoldsWhere => r"$\checkmark$",
        Verdict::Approximate => r"$\approx$",
        Verdict::Refuted | Verdict::IllFormed => r"$\times$",
        Verdict::Undecided => "?",
        Verdict::Skipped => "--",
    }
}

fn description(claim: &Claim, prose: &Prose) -> String {
    let description = claim.description.as_deref();
    description.map_or(String::new(), |words| prose.escape(words))
}

fn phrase(phrase: &Phrase, prose: &Prose) -> String {
    phrase.render(|words| prose.escape(words), mathematics)
}

fn formula(expression: &Expression) -> String {
    mathematics(&Notation::Latex.expression(expression))
}

fn mathematics(formula: &str) -> String {
    format!("${formula}$")
}
