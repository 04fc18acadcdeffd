//! A matching of coefficients, power by power.

use crate::derivation::matching::{Matched, Row};
use crate::language::notation::Notation;
use crate::language::syntax::Expression;
use crate::report::phrase::Phrase;
use crate::report::words;

use super::page::Page;
use super::palette::{FAINT, GOOD, PLAIN, STRONG};
use super::run::{Run, column, spaces};

/// How many lines a coefficient gets.
const MOST_LINES: usize = 6;
/// The width of a power, and of the words that stand before expressions.
const POWER: usize = 7;
const KEYWORD: usize = 10;

const NOTATION: Notation = Notation::Unicode;

/// Writes a matching of a document: what is matched, how well, by which equations, the coefficients,
/// and the solution.
pub fn matching(path: &str, matched: &Matched, width: usize) -> String {
    let mut page = Page::new(width);
    let mut runs = vec![Run::words(words::label(&matched.label), STRONG)];
    runs.push(Run::words(format!(" {}", matched.name), PLAIN));
    if let Some(description) = &matched.description {
        runs.push(Run::words(format!(": {description}"), PLAIN));
    }
    page.prose(&[], &runs);
    page.place(path, matched.line);

    polynomials(&mut page, matched);
    table(&mut page, matched);
    neglected(&mut page, matched);
    let is_shortened = coefficients(&mut page, matched);
    equations(&mut page, matched);
    page.heading("Solution");
    for (name, value) in &matched.solution {
        let prefix = [spaces(2), Run::words(format!("{name} = "), STRONG)];
        page.expression(&prefix, 6, &NOTATION.expression(value), usize::MAX);
    }
    if is_shortened {
        page.gap();
        page.hint(0, "… coefficients in full: --format json");
    }
    page.finish()
}

fn polynomials(page: &mut Page, matched: &Matched) {
    page.heading("What is matched");
    let (exact, assumed) = words::polynomials(matched, NOTATION);
    for (keyword, polynomial) in [("exact", exact), ("assumed", assumed)] {
        let [keyword, rest] = column(keyword, KEYWORD, FAINT);
        page.expression(
            &[spaces(2), keyword, rest],
            4 + KEYWORD,
            &polynomial,
            usize::MAX,
        );
    }
}

/// Which powers were used, and what the solution leaves of each.
fn table(page: &mut Page, matched: &Matched) {
    page.heading(&format!("Power by power of {}", matched.variable));
    for row in &matched.table {
        let power = words::power(matched, row.power, NOTATION);
        let mut prefix = vec![spaces(2)];
        prefix.extend(column(&power, POWER, STRONG));
        prefix.extend(if row.used {
            column("used", KEYWORD, GOOD)
        } else {
            column("not used", KEYWORD, FAINT)
        });
        let remainder = words::remainder(matched, row, NOTATION).plain();
        page.prose(&prefix, &[Run::words(remainder, PLAIN)]);
    }
}

fn neglected(page: &mut Page, matched: &Matched) {
    if matched.neglected.is_empty() {
        return;
    }
    page.heading("Neglected");
    for neglected in &matched.neglected {
        let phrase = Phrase::of_mathematics(NOTATION.expression(&neglected.expression))
            .words(" in the coefficient of ")
            .mathematics(words::power(matched, neglected.power, NOTATION))
            .words(", where its factor is ")
            .mathematics(NOTATION.expression(&neglected.factor));
        page.phrase(2, "", &phrase);
    }
}

/// Both coefficients of every power, and the residual: whether one had to be shortened.
fn coefficients(page: &mut Page, matched: &Matched) -> bool {
    page.heading("Coefficients");
    let mut is_shortened = false;
    for row in &matched.table {
        let power = words::power(matched, row.power, NOTATION);
        for (index, (keyword, expression)) in expressions(row).into_iter().enumerate() {
            let mut prefix = vec![spaces(2)];
            prefix.extend(column(if index == 0 { &power } else { "" }, POWER, STRONG));
            prefix.extend(column(keyword, KEYWORD, FAINT));
            let expression = NOTATION.expression(expression);
            is_shortened |= page.expression(&prefix, 4 + POWER + KEYWORD, &expression, MOST_LINES);
        }
    }
    is_shortened
}

fn expressions(row: &Row) -> Vec<(&'static str, &Expression)> {
    let mut expressions = vec![("exact", &row.exact), ("assumed", &row.assumed)];
    if !words::is_zero(&row.residual) {
        expressions.push(("residual", &row.residual));
    }
    expressions
}

fn equations(page: &mut Page, matched: &Matched) {
    page.heading("The linear equations");
    let prefix = [spaces(2), Run::words("determinant ", FAINT)];
    page.expression(
        &prefix,
        6,
        &NOTATION.expression(&matched.determinant),
        usize::MAX,
    );
    if matched.singular_where.is_empty() {
        page.phrase(
            2,
            "singular",
            &Phrase::of_words("nowhere that the document allows"),
        );
    }
    for singularity in &matched.singular_where {
        let phrase = Phrase::of_mathematics(words::singularity(singularity, NOTATION));
        let phrase = phrase.words(words::at_singularity(singularity));
        page.phrase(2, "singular where", &phrase);
    }
}
