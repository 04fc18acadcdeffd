//! Points that satisfy what a document assumes.

use std::collections::BTreeMap;

use crate::algebra::sign::Signs;
use crate::derivation::evaluation::evaluator::Evaluator;
use crate::derivation::evaluation::point::Size;
use crate::derivation::scope::Scope;
use crate::derivation::syntax::Relation;

use super::sides::compare;

/// How many points are tried to find one that satisfies the assumptions.
const MOST_ATTEMPTS: u64 = 20_000;

/// Numbers large enough that two different expressions do not agree by chance.
const LARGE: Size = Size {
    numerator: 1_000_000,
    denominator: 1,
};

/// Numbers on both sides of 1, for assumptions that whole numbers do not satisfy.
const MIXED: Size = Size {
    numerator: 1_000,
    denominator: 1_000,
};

/// Numbers small enough to check by hand; later ones are larger.
const SMALL: [Size; 3] = [
    Size {
        numerator: 3,
        denominator: 1,
    },
    Size {
        numerator: 5,
        denominator: 2,
    },
    Size {
        numerator: 40,
        denominator: 9,
    },
];

/// Why there are too few points.
pub const NO_POINT: &str = "no point was found that satisfies the assumptions";

/// The seed and the size of the numbers for an attempt at a point.
type Choice = fn(point: u64, attempt: u64) -> (u64, Size);

/// A seed of its own for every attempt.
fn seed(point: u64, attempt: u64) -> u64 {
    const USUAL: u64 = 400;
    match attempt {
        0..USUAL => point * USUAL + attempt,
        _ => 10_000_000 + point * MOST_ATTEMPTS + attempt,
    }
}

/// Random points with large numbers.
pub fn random_point(point: u64, attempt: u64) -> (u64, Size) {
    let size = if attempt.is_multiple_of(4) {
        LARGE
    } else {
        MIXED
    };
    (seed(point, attempt), size)
}

/// Simple points, slowly less so.
pub fn simple_point(point: u64, attempt: u64) -> (u64, Size) {
    let larger = (point / 40 + attempt / 100) as usize;
    let size = SMALL[larger.min(SMALL.len() - 1)];
    (1_000_000 + seed(point, attempt), size)
}

/// Points that satisfy the assumptions, made when they are first asked for.
pub struct Points<'a> {
    /// The names of the document.
    pub scope: &'a Scope,
    assumptions: &'a [Relation],
    signs: BTreeMap<String, Signs>,
    choose: Choice,
    evaluators: Vec<Evaluator<'a>>,
    /// Whether no further point was found.
    exhausted: bool,
}

impl<'a> Points<'a> {
    /// Points that are chosen in this way.
    pub fn new(
        scope: &'a Scope,
        assumptions: &'a [Relation],
        signs: BTreeMap<String, Signs>,
        choose: Choice,
    ) -> Self {
        Points {
            scope,
            assumptions,
            signs,
            choose,
            evaluators: Vec::new(),
            exhausted: false,
        }
    }

    /// An evaluator at one of the points, counted from 0; nothing where no such point is found.
    pub fn at(&mut self, place: usize) -> Option<&mut Evaluator<'a>> {
        while self.evaluators.len() <= place && !self.exhausted {
            let point = self.evaluators.len() as u64;
            let found = (0..MOST_ATTEMPTS)
                .map(|attempt| (self.choose)(point, attempt))
                .find_map(|(seed, size)| self.admissible(seed, size));
            self.exhausted = found.is_none();
            self.evaluators.extend(found);
        }
        self.evaluators.get_mut(place)
    }

    /// The points that were found so far.
    pub fn found(&mut self) -> impl Iterator<Item = &mut Evaluator<'a>> {
        self.evaluators.iter_mut()
    }

    /// An evaluator at a point, if that satisfies the assumptions.
    fn admissible(&self, seed: u64, size: Size) -> Option<Evaluator<'a>> {
        let mut evaluator = Evaluator::new(self.scope, seed, size, self.signs.clone());
        let admissible = self.assumptions.iter().all(|assumption| {
            let left = evaluator.evaluate(&assumption.left);
            let right = evaluator.evaluate(&assumption.right);
            matches!((left, right), (Ok(left), Ok(right))
                if compare(&left, &right, assumption.comparison, &evaluator.point().extension)
                    == Some(true))
        });
        admissible.then_some(evaluator)
    }
}
