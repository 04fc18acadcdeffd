//! Emitted texts that are changed in one place are refused: every check of them is tried by itself.

use std::collections::BTreeMap;

use sextic::algebra::ring::Ring;
use sextic::compile::door;
use sextic::compile::operations::compare;
use sextic::compile::point::Point;
use sextic::compile::proof::prove;
use sextic::compile::reading::read;
use sextic::compile::resolution::resolve;
use sextic::compile::specification::Specification;
use sextic_codegen::language::{File, Language};
use sextic_codegen::program::Program;

use super::edits::{Edit, Kind, edits};
use super::{assert_locked, files_of, paper, specifications};

/// So many changes of a kind are tried in a file, evenly spread over all of them.
const MOST: usize = 80;

/// Normal forms examine all texts of evaluators with fewer operations; of others, those of which a point
/// decides nothing.
const FEW: usize = 50;

/// What the algebra says of a text, without a look at its operations.
#[derive(Clone, Copy, Debug)]
struct Algebra {
    differs_at_point: bool,
    /// By normal forms, if they were asked.
    is_proven: Option<bool>,
}

impl Algebra {
    /// What is said of a text whose names mean nothing.
    fn of_no_program(specification: &Specification) -> Self {
        Algebra {
            differs_at_point: true,
            is_proven: is_small(specification).then_some(false),
        }
    }

    fn is_equal(self) -> bool {
        self.is_proven.unwrap_or(!self.differs_at_point)
    }
}

fn is_small(specification: &Specification) -> bool {
    specification.evaluator.cost().total() < FEW
}

/// What became of the changes of a kind.
#[derive(Clone, Debug, Default)]
struct Count {
    possible: usize,
    tried: usize,
    unreadable: usize,
    /// Refused because inputs are made of other angles.
    door: usize,
    operations: usize,
    point: usize,
    normal_forms: usize,
    equal: usize,
    proven: usize,
    /// Equal in exact algebra, by other operations.
    rounded: Vec<String>,
    /// Refused by nothing.
    same: Vec<String>,
}

const COLUMNS: [&str; 11] = [
    "",
    "possible",
    "tried",
    "not read",
    "angles",
    "operations",
    "point",
    "normal forms",
    "equal",
    "proven",
    "same bits",
];

impl Count {
    fn row(&self, title: &str) -> String {
        let numbers = [
            self.possible,
            self.tried,
            self.unreadable,
            self.door,
            self.operations,
            self.point,
            self.normal_forms,
            self.equal,
            self.proven,
            self.same.len(),
        ];
        let cells = numbers.iter().map(ToString::to_string);
        row(std::iter::once(title.to_owned()).chain(cells))
    }

    fn add(&mut self, is_another: bool, algebra: Algebra, shown: impl Fn() -> String) {
        self.operations += usize::from(is_another);
        self.point += usize::from(algebra.differs_at_point);
        self.normal_forms += usize::from(algebra.is_proven == Some(false));
        self.equal += usize::from(algebra.is_equal());
        self.proven += usize::from(algebra.is_proven == Some(true));
        match (is_another, algebra.is_equal()) {
            (true, true) => self.rounded.push(shown()),
            (false, true) => self.same.push(shown()),
            (true, false) => {}
            (false, false) => panic!("the same operations give another result: {}", shown()),
        }
    }
}

fn row(cells: impl Iterator<Item = String>) -> String {
    let cells = cells.zip(COLUMNS).enumerate();
    let cells = cells.map(|(place, (cell, column))| match place {
        0 => format!("{cell:<37}"),
        _ => format!("{cell:>width$}", width = column.len()),
    });
    cells.collect::<Vec<String>>().join(" | ")
}

/// What a point and normal forms say of a text, each by itself.
fn examine(
    bodies: &[Program],
    specification: &Specification,
    point: &Point,
    ring: &mut Ring,
) -> Algebra {
    let at_point = bodies.iter().map(|body| point.refute(body, specification));
    let at_point: Vec<_> = at_point.collect();
    let differs_at_point = at_point.iter().any(Result::is_err);
    let is_decided = differs_at_point || at_point.iter().all(|decided| *decided == Ok(true));
    let is_proven = (is_small(specification) || !is_decided).then(|| {
        ring.budget().refill();
        let mut proofs = bodies.iter().map(|body| prove(body, specification, ring));
        proofs.all(|proof| proof.is_ok())
    });
    if is_decided && let Some(is_proven) = is_proven {
        assert_ne!(
            is_proven, differs_at_point,
            "a point and the normal forms disagree"
        );
    }
    Algebra {
        differs_at_point,
        is_proven,
    }
}

fn try_all(
    files: &[File],
    specification: &Specification,
    language: Language,
    ring: &mut Ring,
    counts: &mut BTreeMap<Kind, Count>,
) {
    let evaluator = &specification.evaluator;
    let inputs = evaluator
        .free_inputs()
        .map(|input| input.quantity.name.clone());
    let outputs = evaluator.outputs.iter().map(|output| output.name.clone());
    let angles = evaluator
        .angles
        .iter()
        .map(|angle| angle.quantity.name.clone());
    let fields: [Vec<String>; 3] = [inputs.collect(), outputs.collect(), angles.collect()];
    let point = Point::of(specification, ring);
    for (place, file) in files.iter().enumerate() {
        let all = edits(file, language, &fields);
        for kind in Kind::ALL {
            let of_kind: Vec<&Edit> = all.iter().filter(|edit| edit.kind == kind).collect();
            let count = counts.entry(kind).or_default();
            count.possible += of_kind.len();
            let step = of_kind.len().div_ceil(MOST).max(1);
            for edit in of_kind.into_iter().step_by(step) {
                let mut corrupt = files.to_vec();
                corrupt[place].text = edit.apply(&file.text);
                count.tried += 1;
                let Ok(readings) = read(&corrupt, evaluator, language) else {
                    count.unreadable += 1;
                    continue;
                };
                let door = readings.door.as_ref();
                let checked = door.map(|(_, door)| door::check(door, specification, ring));
                if checked.is_some_and(|verdict| verdict.is_err()) {
                    count.door += 1;
                    continue;
                }
                let readings = readings.bodies.iter();
                let bodies = readings.map(|(_, reading)| resolve(reading, specification));
                let (is_another, algebra) = match bodies.collect::<Result<Vec<Program>, _>>() {
                    Err(_) => (true, Algebra::of_no_program(specification)),
                    Ok(bodies) => (
                        bodies
                            .iter()
                            .any(|body| compare(body, specification).is_err()),
                        examine(&bodies, specification, &point, ring),
                    ),
                };
                let shown = || format!("{}: {}", file.path, edit.shown(&file.text));
                count.add(is_another, algebra, shown);
            }
        }
    }
}

fn corrupt_all(language: Language) {
    let audit = paper();
    let mut counts: BTreeMap<Kind, Count> = BTreeMap::new();
    for specification in specifications(&audit) {
        let files = files_of(&specification, language);
        let ring = &mut specification.elaborator.ring.clone();
        try_all(&files, &specification, language, ring, &mut counts);
    }
    let mut lines = vec![row(COLUMNS.into_iter().map(str::to_owned))];
    let (mut rounded, mut same) = (Vec::new(), Vec::new());
    for (kind, count) in counts.iter().filter(|(_, count)| count.possible > 0) {
        lines.push(count.row(kind.title()));
        match kind {
            // Both orders give the same bits.
            Kind::Order => assert_eq!(count.same.len(), count.tried),
            // −(a·b) and (−a)·b are the same double.
            Kind::Parentheses => same.extend(count.same.clone()),
            _ => assert_eq!(count.same, Vec::<String>::new(), "{kind:?}"),
        }
        // Without parentheses another sum or product is formed first.
        if !matches!(kind, Kind::Order | Kind::Parentheses) {
            rounded.extend(count.rounded.clone());
        }
    }
    same.sort();
    rounded.sort();
    lines.push(
        "\nEqual in exact algebra, refused for their operations, but for parentheses:".to_owned(),
    );
    lines.extend(rounded);
    lines.push("\nThe same to the bit, but for orders; not refused:".to_owned());
    lines.extend(same);
    assert_locked(&format!("corruption-{language}"), &lines.join("\n"));
}

#[test]
fn corrupt_rust_is_refused() {
    corrupt_all(Language::Rust);
}

#[test]
fn corrupt_c_is_refused() {
    corrupt_all(Language::C);
}

#[test]
fn corrupt_python_is_refused() {
    corrupt_all(Language::Python);
}

#[test]
fn corrupt_octave_is_refused() {
    corrupt_all(Language::Octave);
}
