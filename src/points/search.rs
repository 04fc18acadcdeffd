//! Assignments that satisfy what a document assumes.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::algebra::sign::Signs;
use crate::language::syntax::Comparison;

use super::assignment::{Assignment, Draw, Size};
use super::evaluation::Evaluation;
use super::graph::{Graph, Node, NodeId};
use super::real::Reals;

/// How often values are drawn again to find an assignment that satisfies the assumptions.
const MOST_ATTEMPTS: u64 = 2_000;

/// How many operations that may take.
const MOST_OPERATIONS: usize = 200_000;

/// Up to how many bits the fractions of large random numbers stay exact: products of a few machine words
/// are enclosed faster than reduced.
const SHORT: usize = 100;

/// Up to how many bits the fractions of simple numbers stay exact.
const LONG: usize = 2_000;

const fn size(numerator: u64, denominator: u64) -> Size {
    with_zeros(numerator, denominator, 0)
}

const fn with_zeros(numerator: u64, denominator: u64, zeros: u64) -> Size {
    Size {
        numerator,
        denominator,
        zeros,
    }
}

/// Numbers large enough that two different expressions do not agree by chance; most on both sides of 1,
/// for assumptions that whole numbers do not satisfy.
const LARGE: [Size; 4] = [
    size(1_000_000, 1),
    size(1_000, 1_000),
    size(1_000, 1_000),
    size(1_000, 1_000_000),
];

/// Numbers small enough to check by hand; later ones are larger.
const SMALL: [Size; 5] = [
    size(3, 1),
    size(5, 2),
    size(40, 9),
    size(400, 900),
    size(1_000, 1_000_000),
];

/// Numbers at which values are missing more often than elsewhere: 0, and what coincides.
const DEGENERATE: [Size; 4] = [
    with_zeros(1, 1, 4),
    with_zeros(1, 1, 0),
    with_zeros(2, 1, 2),
    with_zeros(2, 1, 2),
];

/// How many degenerate assignments there are.
pub const DEGENERATE_PLACES: u64 = DEGENERATE.len() as u64;

/// What assignments are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// To tell apart what is not equal.
    Trust,
    /// To be shown.
    Show,
    /// To find where there is no value.
    Existence,
}

/// An inequality between nodes that is assumed.
#[derive(Clone, Copy, Debug)]
pub struct Assumed {
    /// The left side.
    pub left: NodeId,
    /// How they compare.
    pub comparison: Comparison,
    /// The right side.
    pub right: NodeId,
}

/// What assignments must satisfy.
#[derive(Clone, Debug)]
pub struct Search {
    /// The signs of variables, by ASCII name.
    pub signs: Arc<BTreeMap<String, Signs>>,
    /// The angles whose measure is a fraction, by ASCII name.
    pub measured: Arc<BTreeSet<String>>,
    /// The inequalities.
    pub assumed: Vec<Assumed>,
    /// Which numbers are wanted.
    pub purpose: Purpose,
}

impl Search {
    /// An evaluation at an assignment, counted from 0; nothing where none is found that satisfies what is
    /// assumed: the values of an inequality that does not hold are drawn again. The operations count among
    /// those that are left, which they do not depend on.
    pub fn find(&self, graph: &Graph, place: u64, left: &mut usize) -> Option<Evaluation> {
        if self.signs.values().any(|signs| *signs == Signs::NONE) {
            return None;
        }
        let mut steps = MOST_OPERATIONS;
        let found = self.drawn(graph, place, &mut steps);
        *left = left.saturating_sub(MOST_OPERATIONS - steps);
        found
    }

    /// Evaluations at the first so many assignments that are found.
    pub fn find_all(&self, graph: &Graph, places: u64) -> Vec<Evaluation> {
        let mut left = 10 * MOST_OPERATIONS;
        let places = 0..places;
        let found =
            places.map_while(|place| (left > 0).then(|| self.find(graph, place, &mut left)));
        found.flatten().collect()
    }

    fn drawn(&self, graph: &Graph, place: u64, steps: &mut usize) -> Option<Evaluation> {
        let longest = match self.purpose {
            Purpose::Trust => SHORT,
            Purpose::Show | Purpose::Existence => LONG,
        };
        let (signs, measured) = (Arc::clone(&self.signs), Arc::clone(&self.measured));
        let mut assignment = Assignment::new(self.draw(place, 0), signs, measured);
        for attempt in 1..=MOST_ATTEMPTS {
            let mut evaluation = Evaluation::new(assignment.clone(), Reals { longest });
            evaluation.steps = *steps;
            let broken = self.broken(graph, &mut evaluation);
            // Every attempt takes one, so that attempts end with the operations.
            *steps = evaluation.steps.saturating_sub(1);
            let Some(broken) = broken else {
                evaluation.steps = usize::MAX;
                return Some(evaluation);
            };
            if *steps == 0 {
                return None;
            }
            let names = names_of(graph, &[broken.left, broken.right]);
            let draw = self.draw(place, attempt);
            // The one that is drawn alone moves on, or two inequalities could break each other in step.
            let chosen = (draw.seed + attempt / 8) as usize % names.len().max(1);
            for (index, name) in names.iter().enumerate() {
                if attempt % 2 == 1 || index == chosen {
                    assignment.redraw(name, draw);
                }
            }
        }
        None
    }

    /// The first inequality that does not hold, or of which that is not known.
    fn broken(&self, graph: &Graph, evaluation: &mut Evaluation) -> Option<Assumed> {
        let mut assumed = self.assumed.iter().copied();
        assumed.find(|one| {
            let left = evaluation.value(graph, one.left);
            let right = evaluation.value(graph, one.right);
            match (left, right) {
                (Ok(left), Ok(right)) => {
                    evaluation
                        .compared(&left, &right)
                        .map(|order| one.comparison.holds(order))
                        != Some(true)
                }
                _ => true,
            }
        })
    }

    fn draw(&self, place: u64, attempt: u64) -> Draw {
        let seed = seed(place, attempt);
        let larger = (place / 40 + attempt / 40) as usize;
        let simple = Draw {
            seed: 1_000_000 + seed,
            size: SMALL[larger.min(SMALL.len() - 1)],
        };
        match self.purpose {
            Purpose::Show => simple,
            // What is assumed may want larger numbers.
            Purpose::Existence if attempt >= 40 => simple,
            Purpose::Existence => Draw {
                seed: 2_000_000 + seed,
                size: DEGENERATE[(place % DEGENERATE_PLACES) as usize],
            },
            Purpose::Trust => Draw {
                seed,
                size: LARGE[((place + attempt) % LARGE.len() as u64) as usize],
            },
        }
    }
}

/// A seed of its own for every attempt.
fn seed(place: u64, attempt: u64) -> u64 {
    const USUAL: u64 = 400;
    match attempt {
        0..USUAL => place * USUAL + attempt,
        _ => 10_000_000 + place * MOST_ATTEMPTS + attempt,
    }
}

/// The ASCII names of the variables and functions that nodes rest on.
fn names_of(graph: &Graph, roots: &[NodeId]) -> BTreeSet<String> {
    let nodes = graph.below(roots).into_iter();
    let names = nodes.filter_map(|id| match graph.node(id) {
        Node::Variable(id) | Node::Cosine(id) | Node::Sine(id) => {
            Some(graph.variable(*id).name.clone())
        }
        Node::Function { function, .. } => Some(graph.function_name(*function).to_owned()),
        _ => None,
    });
    names.collect()
}

/// The ASCII names of the angles whose measure is a part of nodes, beside the arguments of functions.
pub fn measured(graph: &Graph, roots: &[NodeId]) -> BTreeSet<String> {
    let mut open = roots.to_vec();
    let (mut seen, mut names) = (BTreeSet::new(), BTreeSet::new());
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        match graph.node(id) {
            Node::Variable(id) if graph.variable(*id).is_angular() => {
                names.insert(graph.variable(*id).name.clone());
            }
            Node::Function { .. } => {}
            node => node.visit(&mut |part| open.push(part)),
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    fn search(purpose: Purpose) -> Search {
        Search {
            signs: Arc::default(),
            measured: Arc::default(),
            assumed: Vec::new(),
            purpose,
        }
    }

    #[test]
    fn every_sort_of_numbers_is_drawn() {
        let sizes = |purpose, places| -> Vec<Size> {
            let search = search(purpose);
            (0..places)
                .map(|place| search.draw(place, 0).size)
                .collect()
        };
        assert_eq!(sizes(Purpose::Existence, DEGENERATE_PLACES), DEGENERATE);
        assert_eq!(sizes(Purpose::Trust, 4), LARGE);
        let growing = |place| search(Purpose::Show).draw(place, 0).size;
        let grown = [0, 39, 40, 80, 120, 160, 1000].map(growing);
        let expected = [0, 0, 1, 2, 3, 4, 4].map(|place: usize| SMALL[place]);
        assert_eq!(grown, expected);
        // What is drawn again is larger, too.
        assert_eq!(search(Purpose::Show).draw(0, 40).size, SMALL[1]);
        assert_eq!(search(Purpose::Existence).draw(0, 40).size, SMALL[1]);
        assert_eq!(search(Purpose::Existence).draw(0, 39).size, DEGENERATE[0]);
    }

    #[test]
    fn no_two_attempts_draw_the_same() {
        let attempts = [0, 1, 399, 400, 1999];
        let places = (0..40).flat_map(|place| attempts.map(|attempt| seed(place, attempt)));
        let seeds: Vec<u64> = places.collect();
        let different: BTreeSet<u64> = seeds.iter().copied().collect();
        assert_eq!(different.len(), seeds.len());
    }
}
