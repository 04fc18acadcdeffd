//! What stands below a verdict: its conditions, what it neglects, where it fails, and why.

use crate::language::notation::Notation;
use crate::language::syntax::Comparison;
use crate::verdict::claim::{Claim, Verdict, Witness};

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
    if let Some(difference) = &claim.difference {
        let phrase = Phrase::of_mathematics(notation.expression(difference));
        details.push(Detail::new("left − right", phrase));
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
    let points = words::counted(claim.points, "random place");
    let points = format!("evaluation at {points}");
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
        Verdict::Refuted => "the sides differ at a point that satisfies everything assumed".into(),
        Verdict::IllFormed => "the sides cannot be compared, so nothing was computed".into(),
        Verdict::Undecided if claim.fault => {
            "the two routes disagree, so it does not count as true".into()
        }
        Verdict::Undecided => "neither route could decide it, so it does not count as true".into(),
        Verdict::Skipped => "it builds on what is refused, so nothing was computed".into(),
    }
}

/// `m = 2, cos(α_0) = 3/5: left 7/2, right 0`
fn point(claim: &Claim, witness: &Witness, notation: Notation, extent: Extent) -> Detail {
    let most = match extent {
        Extent::Overview => MOST_COORDINATES,
        Extent::Full => usize::MAX,
    };
    let coordinates = witness.point.iter().take(most).map(|one| {
        let name = notation.expression(&one.name);
        format!("{name} = {}", words::assigned(one, notation))
    });
    let mut phrase = Phrase::default().list(coordinates, ", ");
    let is_shortened = witness.point.len() > most;
    if is_shortened {
        phrase = phrase.words(", …");
    }
    phrase = phrase.words(
        match (witness.point.is_empty(), claim.conditions.is_empty()) {
            (false, _) => ": ",
            (true, true) => "every point: ",
            (true, false) => "every point that meets the conditions: ",
        },
    );
    if let Some((row, column)) = witness.entry {
        phrase = phrase.words(format!("entry [{row}, {column}] is "));
    }
    if let Some(degree) = witness.degree {
        phrase = phrase.words(format!("terms of order {degree}: "));
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_with_roots_are_shown_in_every_notation() {
        let ascii = "-1/2 + 3*sqrt(2)";
        assert_eq!(value(ascii, Notation::Unicode), "−1/2 + 3·√(2)");
        assert_eq!(value(ascii, Notation::Latex), r"-1/2 + 3\,\surd(2)");
        assert_eq!(value(ascii, Notation::Ascii), ascii);
    }
}
