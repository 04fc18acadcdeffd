//! Verdicts and matchings as Markdown, with equations that a code host sets.

use std::fmt::Display;

use crate::derivation::matching::{Matched, Row};
use crate::derivation::shown::Shown;
use crate::language::notation::Notation;
use crate::language::syntax::Expression;
use crate::verdict::audit::Audit;
use crate::verdict::claim::Claim;

use super::details::{Detail, Extent, details};
use super::phrase::Phrase;
use super::shown::{lines, size};
use super::summary::Summary;
use super::{premises, refusals, residuals, words};

/// Characters that mean something to Markdown within a line.
const SPECIAL: &str = r"\`*_[]<>|$#~&";

/// Writes all verdicts on a document, and what they come to.
pub fn audit(audit: &Audit) -> String {
    let summary = Summary::new(audit);
    let title = audit.title.as_deref().unwrap_or(&audit.path);
    let mut page = format!("# {}\n\nThe verdicts on `{}`.\n", escape(title), audit.path);
    page += &format!("**{}**\n\n", escape(&summary.conclusion()));
    for (keyword, line) in premises::lines(audit, Notation::Latex) {
        page += &format!("- {keyword} {}\n", phrase(&line));
    }
    if !summary.counts.is_empty() {
        page += "\n| verdict | count |\n|---|---:|\n";
    }
    for (verdict, count) in &summary.counts {
        page += &row(&[words::verdict(*verdict), count.to_string()]);
    }
    if !summary.matchings.is_empty() {
        page += "\n## Matchings\n\n";
    }
    for matched in summary.matchings {
        let label = escape(&words::label(&matched.label));
        let overview = phrase(&residuals::overview(matched, Notation::Latex));
        page += &format!("- **{label}** {overview}\n");
    }
    for (heading, claims) in summary.failures() {
        page += &format!("\n## {heading}\n\n");
        for claim in claims {
            page += &format!("- {}{}\n", name(claim), description(claim, ": "));
        }
    }
    for (heading, lines) in refusals::lists(audit) {
        let lines: Vec<String> = lines.iter().map(|line| escape(line)).collect();
        page += &format!("\n## {heading}\n\n- {}\n", lines.join("\n- "));
    }
    if !audit.claims.is_empty() {
        page += "\n## Verdicts\n\n| verdict | of | says | with |\n|---|---|---|---|\n";
    }
    for claim in &audit.claims {
        page += &self::claim(claim);
    }
    if !audit.shown.is_empty() {
        page += "\n## Shown\n\n| line | expression | is |\n|---:|---|---|\n";
    }
    for shown in &audit.shown {
        page += &self::shown(shown);
    }
    page
}

/// Writes a matching of a document.
pub fn matching(path: &str, matched: &Matched) -> String {
    let label = escape(&words::label(&matched.label));
    let mut page = format!("# {label} {}\n\n", escape(&matched.name.unicode));
    if let Some(description) = &matched.description {
        page += &format!("{}.\n", escape(description));
    }
    page += &format!("`{path}`, line {}\n\n", matched.line);
    let (exact, assumed) = words::polynomials(matched, Notation::Latex);
    page += &format!(
        "{}is matched with\n{}\n",
        displayed(&exact),
        displayed(&assumed)
    );
    page +=
        "| power | used | exact | assumed | residual | remainder |\n|---|---|---|---|---|---|\n";
    for coefficients in &matched.table {
        page += &coefficients_row(matched, coefficients);
    }
    if !matched.neglected.is_empty() {
        page += "\n## Neglected\n\n";
    }
    for neglected in &matched.neglected {
        let power = mathematics(&words::power(matched, neglected.power, Notation::Latex));
        let (expression, factor) = (formula(&neglected.expression), formula(&neglected.factor));
        page += &format!(
            "- {expression} in the coefficient of {power}, where its factor is {factor}\n"
        );
    }
    page += &format!(
        "\n## The linear equations\n\nTheir determinant is {}.\n",
        formula(&matched.determinant)
    );
    for singularity in &matched.singular_where {
        let place = mathematics(&words::singularity(singularity, Notation::Latex));
        page += &format!(
            "They are singular where {place}{}.\n",
            words::at_singularity(singularity)
        );
    }
    page += "\n## Solution\n\n";
    for (name, value) in &matched.solution {
        let value = Notation::Latex.expression(value);
        let equation = format!("{} = {value}", Notation::Latex.name(name));
        page += &displayed(&equation);
    }
    page
}

fn claim(claim: &Claim) -> String {
    let statement = mathematics(&words::statement(claim, Notation::Latex));
    let mut verdict = words::verdict(claim.verdict);
    if let Some(surprise) = words::surprise(claim) {
        verdict += &format!("<br>**{}**", escape(&surprise));
    }
    let details = details(claim, Notation::Latex, Extent::Full);
    let details: Vec<String> = details.iter().map(detail).collect();
    let says = description(claim, "")
        + if claim.description.is_some() {
            "<br>"
        } else {
            ""
        };
    row(&[
        verdict,
        name(claim),
        says + &statement,
        details.join("<br>"),
    ])
}

fn shown(shown: &Shown) -> String {
    let words = shown.description.iter().cloned().chain(size(shown));
    let head = words.map(|words| format!("{}<br>", escape(&words)));
    let says = head.collect::<String>() + &formula(&shown.expression);
    let lines = lines(shown, Notation::Latex);
    let lines: Vec<String> = lines
        .iter()
        .map(|line| format!("{} {}", escape(&line.keyword), phrase(&line.phrase)))
        .collect();
    row(&[shown.line.to_string(), says, lines.join("<br>")])
}

fn coefficients_row(matched: &Matched, coefficients: &Row) -> String {
    row(&[
        mathematics(&words::power(matched, coefficients.power, Notation::Latex)),
        if coefficients.used { "yes" } else { "no" }.to_owned(),
        formula(&coefficients.exact),
        formula(&coefficients.assumed),
        formula(&coefficients.residual),
        phrase(&words::remainder(matched, coefficients, Notation::Latex)),
    ])
}

fn detail(detail: &Detail) -> String {
    format!("{} {}", detail.keyword, phrase(&detail.phrase))
}

fn name(claim: &Claim) -> String {
    format!("**{}**", escape(&words::label(&claim.label)))
}

fn description(claim: &Claim, separator: &str) -> String {
    let description = claim.description.as_deref();
    description.map_or(String::new(), |words| {
        format!("{separator}{}", escape(words))
    })
}

fn row(cells: &[impl Display]) -> String {
    let cells: Vec<String> = cells.iter().map(ToString::to_string).collect();
    format!("| {} |\n", cells.join(" | "))
}

fn phrase(phrase: &Phrase) -> String {
    phrase.render(escape, mathematics)
}

fn formula(expression: &Expression) -> String {
    mathematics(&Notation::Latex.expression(expression))
}

/// A formula within a line, fenced so that backslashes stay; a bar would end the cell of a table.
fn mathematics(formula: &str) -> String {
    format!("$`{}`$", formula.replace('|', r"\vert "))
}

/// A formula in lines of its own.
fn displayed(formula: &str) -> String {
    format!("```math\n{formula}\n```\n")
}

/// Prose as it is meant, on one line.
fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        if SPECIAL.contains(character) {
            escaped.push('\\');
        }
        escaped.push(if character.is_control() {
            ' '
        } else {
            character
        });
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prose_is_shown_as_it_is_meant() {
        assert_eq!(escape("λ_R is |a|*b\n"), r"λ\_R is \|a\|\*b ");
    }

    #[test]
    fn bars_do_not_end_cells() {
        let cell = mathematics(r"\left.x\right|_{a}");
        assert_eq!(row(&[cell]), "| $`\\left.x\\right\\vert _{a}`$ |\n");
    }
}
