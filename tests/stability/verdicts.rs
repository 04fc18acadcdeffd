//! Verdicts with proof, against long arithmetic, the errors of eigenvalues, and by hand.

use std::collections::BTreeMap;

use sextic::algebra::number::Rational;
use sextic::compile::fixed::Fixed;
use sextic::stability::exact_section::ExactSection;
use sextic::stability::model::Model;
use sextic::stability::quantity::parameters;
use sextic::stability::section::{Parameters, Section};
use sextic::stability::state_matrix;
use sextic::stability::verdict::{Doubt, Proof, Verdict, exact_verdict, verdict};

use super::oracle::{characteristic_polynomial, roots};
use super::sections::{KINDS, Numbers, hard_section};

const BY_HAND: &str = include_str!("../data/stability/verdicts.txt");

/// The quantities of a line, by name.
fn quantities(text: &str) -> BTreeMap<String, Rational> {
    let fixed = text.split_whitespace().map(|one| one.parse::<Fixed>());
    let fixed = fixed.map(|own| own.unwrap_or_else(|error| panic!("{text}: {error:?}")));
    fixed.map(|own| (own.name, own.value)).collect()
}

#[test]
fn verdicts_by_hand() {
    let mut usual = BTreeMap::new();
    let mut count = 0;
    for line in BY_HAND
        .lines()
        .filter(|line| !line.is_empty() && !line.starts_with('#'))
    {
        if let Some(text) = line.strip_prefix("usual ") {
            usual = quantities(text);
            continue;
        }
        let (expected, text) = line.split_once(':').expect("a verdict and a section");
        let mut values = usual.clone();
        let own = quantities(text);
        if own.contains_key("C_D") {
            values.retain(|name, _| !name.starts_with("S_"));
        }
        values.extend(own);
        let (expected, is_stiffened) = match expected.strip_suffix(", stiffness") {
            Some(expected) => (expected, true),
            None => (expected, false),
        };
        let section = ExactSection::new(Parameters {
            aerodynamic_stiffness: is_stiffened,
            ..parameters(&values)
        });
        let section = section.expect("a possible section");
        let found = exact_verdict(&section);
        assert_eq!(found.name(), expected, "{line}: {found}");
        if expected == "undecided" {
            assert_eq!(found, Verdict::Undecided(Doubt::Neutral), "{line}");
        }
        count += 1;
    }
    assert!(count >= 25, "{count} lines");
}

#[test]
fn verdicts_are_those_of_long_arithmetic() {
    for kind in KINDS {
        let mut numbers = Numbers::new(41);
        let mut decided = 0;
        for _ in 0..20 {
            let p = hard_section(kind, &mut numbers);
            let section = Section::new(p).expect("a possible section");
            let found = exact_verdict(&ExactSection::from(&section));
            let exact = roots(&characteristic_polynomial(&p));
            let largest = exact.iter().map(|own| own.real()).fold(f64::MIN, f64::max);
            // The sines of the oracle are rounded, and its roots have 90 digits.
            let damping = section.relative_aerodynamic_damping() + p.damping_ratios[0];
            let size = p.natural_frequencies[0];
            if largest.abs() > size * (1e-12 * damping).max(1e-22) {
                let expected = if largest < 0.0 { "stable" } else { "unstable" };
                assert_eq!(found.name(), expected, "{kind}: {found} {p:?}");
                decided += 1;
            }
        }
        assert_eq!(
            decided > 0,
            !kind.contains("no wind") || kind.starts_with("some"),
            "{kind}"
        );
    }
}

#[test]
fn exact_verdicts_are_those_of_the_errors() {
    for kind in KINDS {
        let mut numbers = Numbers::new(43);
        let mut count = 0;
        for _ in 0..40 {
            let section = Section::new(hard_section(kind, &mut numbers)).expect("a section");
            let spectrum = state_matrix::eigenvalues(&Model::new(&section).expect("a model"));
            let by_errors = verdict(&section, &spectrum.expect("eigenvalues"));
            let exact = exact_verdict(&ExactSection::from(&section));
            assert_eq!(by_errors.name(), exact.name(), "{kind} {section:?}");
            let is_by_errors = matches!(
                by_errors,
                Verdict::Stable(Proof::Errors) | Verdict::Unstable(Proof::Errors)
            );
            count += usize::from(is_by_errors);
        }
        println!("{kind}: {count} of 40 by errors");
    }
}
