//! What stands below a verdict: its conditions, what it neglects, where it fails, and why.

use std::collections::BTreeMap;

use crate::derivation::notation::Notation;
use crate::derivation::syntax::{Comparison, Expression, Name, Node};
use crate::derivation::verdict::{Claim, Verdict, Witness};

use super::phrase::Phrase;
use super::words;

/// How many coordinates of a point an overview shows.
const MOST_COORDINATES: usize = 8;

/// How much is said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// What fits among a hundred others.
    Overview,
    /// All of it.
    Full,
}

/// A line below a verdict.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Detail {
    /// What is said: `where`, `neglects`, `leading term`, `at`, `because`.
    pub keyword: &'static str,
    /// What is said of it.
    pub phrase: Phrase,
    /// Whether an overview leaves a part out.
    pub is_shortened: bool,
}

impl Detail {
    fn new(keyword: &'static str, phrase: Phrase) -> Self {
        Detail {
            keyword,
            phrase,
            is_shortened: false,
        }
    }
}

/// The lines below a claim's verdict.
pub fn details(claim: &Claim, notation: Notation, extent: Extent) -> Vec<Detail> {
    let mut details = Vec::new();
    if !claim.conditions.is_empty() {
        let conditions = claim.conditions.iter();
        let written = conditions.map(|condition| words::condition(condition, notation));
        details.push(Detail::new(
            "where",
            Phrase::default().list(written, " and "),
        ));
    }
    if let Some(phrase) = neglected(claim, notation) {
        details.push(Detail::new("neglects", phrase));
    }
    if let Some(residual) = &claim.residual {
        let phrase = Phrase::of_mathematics(notation.expression(residual));
        details.push(Detail::new("leading term", phrase));
    }
    if let Some(witness) = &claim.witness {
        details.push(point(claim, witness, notation, extent));
    }
    if let Some(reason) = &claim.reason {
        details.push(Detail::new("because", Phrase::of_words(reason)));
    }
    details
}

/// `terms of order 2 and above in ρ`, of an approximation.
pub fn neglected(claim: &Claim, notation: Notation) -> Option<Phrase> {
    let (order, small) = claim.neglected.as_ref()?;
    let phrase = Phrase::of_words(format!("terms of order {order} and above in "));
    Some(phrase.list(small.iter().map(|name| notation.name(name)), ", "))
}

/// How the verdict was reached, in a sentence without a full stop.
pub fn route(claim: &Claim) -> String {
    let points = words::counted(claim.explanation.points, "random point");
    let points = format!("exact evaluation at {points} of the relations");
    match claim.verdict {
        Verdict::Holds | Verdict::HoldsWhere if claim.statement.comparison == Comparison::Equal => {
            format!("both sides have the same normal form; {points} agrees")
        }
        Verdict::Holds | Verdict::HoldsWhere => {
            format!("the signs that the document declares decide it; {points} agrees")
        }
        Verdict::Approximate => {
            format!(
                "the normal forms agree up to the stated order, and not beyond; {points} agrees"
            )
        }
        Verdict::Refuted => {
            "the sides differ at an exact point that satisfies everything assumed".into()
        }
        Verdict::IllFormed => "the sides cannot be compared, so nothing was computed".into(),
        Verdict::Undecided => "neither route could decide it, so it does not count as true".into(),
    }
}

/// `m = 2, cos(α_0) = 3/5: left 7/2, right 0`
fn point(claim: &Claim, witness: &Witness, notation: Notation, extent: Extent) -> Detail {
    let most = match extent {
        Extent::Overview => MOST_COORDINATES,
        Extent::Full => usize::MAX,
    };
    let known = known_names(claim);
    let coordinates = witness.point.iter().take(most).map(|(name, value)| {
        let name = notation.expression(&coordinate(name, &known));
        format!("{name} = {}", notation.number(value))
    });
    let mut phrase = Phrase::default().list(coordinates, ", ");
    let is_shortened = witness.point.len() > most;
    if is_shortened {
        phrase = phrase.words(", …");
    }
    phrase = phrase.words(if witness.point.is_empty() {
        "every point: "
    } else {
        ": "
    });
    if let Some((row, column)) = witness.entry {
        phrase = phrase.words(format!("entry [{row}, {column}] is "));
    }
    let phrase = phrase
        .words("left ")
        .mathematics(value(&witness.left, notation))
        .words(", right ")
        .mathematics(value(&witness.right, notation));
    Detail {
        keyword: "at",
        phrase,
        is_shortened,
    }
}

/// An exact number with roots, `1/2 - 3*sqrt(2)`, in a notation.
fn value(ascii: &str, notation: Notation) -> String {
    match notation {
        Notation::Ascii => ascii.to_owned(),
        Notation::Unicode => ascii
            .replace("sqrt(", "√(")
            .replace('*', "·")
            .replace('-', "−"),
        Notation::Latex => ascii.replace("sqrt(", r"\surd(").replace('*', r"\,"),
    }
}

/// The names that a claim rests on, by their ASCII spelling.
fn known_names(claim: &Claim) -> BTreeMap<String, Name> {
    let explanation = &claim.explanation;
    let normal_forms = explanation.left.iter().chain(&explanation.right).flatten();
    let definitions = explanation
        .definitions
        .iter()
        .map(|(_, definition)| definition);
    let mut known = BTreeMap::new();
    for expression in normal_forms
        .chain(definitions)
        .chain([&claim.statement.left, &claim.statement.right])
    {
        expression.visit_names(&mut |name| {
            known.insert(name.ascii.clone(), name.clone());
        });
    }
    known
}

/// The expression that a point lists a value for: `m`, `cos(alpha_0)`, `dt(x)`, `dC_D`.
fn coordinate(ascii: &str, known: &BTreeMap<String, Name>) -> Expression {
    for function in ["cos", "sin", "dt"] {
        let inner = ascii
            .strip_prefix(function)
            .and_then(|rest| rest.strip_prefix('('));
        if let Some(inner) = inner.and_then(|rest| rest.strip_suffix(')')) {
            let arguments = vec![coordinate(inner, known)];
            return Expression::call(Name::new(function), 0, arguments);
        }
    }
    if let Some(name) = known.get(ascii) {
        return Expression::name(name.clone());
    }
    // `dC_D` and `d2C_D` are derivatives unless the document declares something that is called so.
    if let Some(primed) = ascii.strip_prefix('d') {
        let name = primed.trim_start_matches(|digit: char| digit.is_ascii_digit());
        let order = primed
            .strip_suffix(name)
            .filter(|digits| !digits.is_empty());
        let order = order.map_or(Some(1), |digits| digits.parse().ok());
        if let (Some(name), Some(order)) = (known.get(name), order) {
            return Expression::made(Node::Derivative(name.clone(), order));
        }
    }
    Expression::name(Name::new(ascii))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_shown_as_the_document_writes_them() {
        let names = [
            Name::with_ascii("S_xθ", "S_xt"),
            Name::new("C_D"),
            Name::new("d_1"),
        ];
        let known = names
            .into_iter()
            .map(|name| (name.ascii.clone(), name))
            .collect();
        for (ascii, expected) in [
            ("m", "m"),
            ("S_xt", "S_xθ"),
            ("cos(alpha_0)", "cos(α_0)"),
            ("dt(x)", "ẋ"),
            ("dt(dt(theta_d))", "θ̈_d"),
            ("dC_D", "C_D′"),
            ("d2C_D", "C_D″"),
            ("d_1", "d_1"),
            ("d", "d"),
        ] {
            let shown = Notation::Unicode.expression(&coordinate(ascii, &known));
            assert_eq!(shown, expected);
        }
    }

    #[test]
    fn values_with_roots_are_shown_in_every_notation() {
        let ascii = "-1/2 + 3*sqrt(2)";
        assert_eq!(value(ascii, Notation::Unicode), "−1/2 + 3·√(2)");
        assert_eq!(value(ascii, Notation::Latex), r"-1/2 + 3\,\surd(2)");
        assert_eq!(value(ascii, Notation::Ascii), ascii);
    }
}
