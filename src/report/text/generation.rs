//! What was generated, for a terminal.

use sextic_codegen::cost::Cost;
use sextic_codegen::evaluator::Evaluator;
use sextic_codegen::language::Renamed;
use unicode_width::UnicodeWidthStr;

use crate::compile::generation::Generated;

/// A line an evaluator: its name, its operations, its rounding.
pub fn generated(generated: &Generated) -> String {
    let rows: Vec<[String; 3]> = generated
        .specifications
        .iter()
        .map(|specification| {
            let evaluator = &specification.evaluator;
            let operations = match evaluator.is_constant() {
                true => evaluator.cost(),
                false => Cost::of(&evaluator.hoisted().sweep),
            };
            let operations = operations.total();
            [
                evaluator.name.clone(),
                format!("{operations} operations"),
                rounding(evaluator),
            ]
        })
        .collect();
    let width = |column: usize| {
        rows.iter()
            .map(|row| row[column].width())
            .max()
            .unwrap_or(0)
    };
    let (names, counts) = (width(0), width(1));
    let line = |[name, count, rounding]: &[String; 3]| {
        let name = padded(name, names);
        let gap = " ".repeat(counts - count.width());
        format!("{name}  {gap}{count}, proven; {rounding}\n")
    };
    let lines = rows.iter().map(line);
    lines.chain(generated.renamed.iter().map(renamed)).collect()
}

/// What the files of an evaluator call otherwise than the document.
fn renamed(renamed: &Renamed) -> String {
    let function = (renamed.evaluator.clone(), renamed.function.clone());
    let function = Some(function).filter(|(name, written)| name != written);
    let names = function.iter().chain(&renamed.names);
    let names: Vec<String> = names
        .map(|(name, written)| format!("`{name}` is called `{written}`"))
        .collect();
    format!(
        "{}: {}, since the text needs the name\n",
        renamed.evaluator,
        names.join(", ")
    )
}

fn rounding(evaluator: &Evaluator) -> String {
    let Some(rounding) = &evaluator.rounding else {
        return "rounding not measured".to_string();
    };
    let worst = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
    let worst = worst(&rounding.percentile_99);
    let shown = match worst < 10_000.0 {
        true => format!("{worst:.1}"),
        false => format!("{worst:.1e}"),
    };
    match evaluator.is_constant() {
        true => format!("within {shown} units in the last place"),
        false => format!("at 99 of 100 points within {shown} units in the last place"),
    }
}

fn padded(text: &str, width: usize) -> String {
    format!("{text}{}", " ".repeat(width - text.width()))
}

/// The first line in which a file differs from what it should be.
pub fn difference(path: &str, found: &str, wanted: &str) -> String {
    let (mut left, mut right) = (found.lines(), wanted.lines());
    let mut number = 1;
    loop {
        let (left, right) = (left.next(), right.next());
        if left == right && left.is_some() {
            number += 1;
            continue;
        }
        let shown = |line: Option<&str>| line.unwrap_or("(the file ends)").to_string();
        return format!(
            "{path} differs from line {number} on:\n  - {}\n  + {}\n",
            shown(left),
            shown(right)
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_difference_is_shown() {
        let shown = difference("a.rs", "one\ntwo\nthree\n", "one\n2\nthree\n");
        assert_eq!(shown, "a.rs differs from line 2 on:\n  - two\n  + 2\n");
        let shown = difference("a.rs", "one\n", "one\ntwo\n");
        assert!(
            shown.contains("line 2") && shown.contains("(the file ends)"),
            "{shown}"
        );
        // Texts that differ only in how lines end.
        assert!(difference("a.rs", "one\r\n", "one\n").contains("the file ends"));
    }
}
