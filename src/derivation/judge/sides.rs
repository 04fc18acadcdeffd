//! Both sides of an assertion at a point.

use crate::derivation::assertion::Assertion;
use crate::derivation::evaluation::evaluator::{Evaluator, Failure};
use crate::derivation::evaluation::number::Number;
use crate::derivation::evaluation::number::extension::Extension;
use crate::derivation::syntax::{Comparison, Order, Relation};

/// The numbers that a side is made of, row by row.
pub type Numbers = Vec<Vec<Number>>;

/// Both sides at a point: as they are, or part by part for an approximation.
pub fn sides<'a>(
    evaluator: &mut Evaluator<'a>,
    assertion: &'a Assertion,
    order: Option<&Order>,
) -> Result<Vec<(Numbers, Numbers)>, Failure> {
    let Relation { left, right, .. } = &assertion.relation;
    match order {
        None => Ok(vec![(
            evaluator.evaluate(left)?,
            evaluator.evaluate(right)?,
        )]),
        Some(order) => {
            let small = small_names(order);
            let left = evaluator.parts(left, &small, order.order.value)?;
            let right = evaluator.parts(right, &small, order.order.value)?;
            Ok(left.into_iter().zip(right).collect())
        }
    }
}

/// The ASCII names of small quantities.
pub fn small_names(order: &Order) -> Vec<&str> {
    let names = order.small.iter();
    names.map(|name| name.value.ascii.as_str()).collect()
}

/// Whether two tables stand in a relation; nothing where that cannot be told.
pub fn compare(
    left: &Numbers,
    right: &Numbers,
    comparison: Comparison,
    extension: &Extension,
) -> Option<bool> {
    if comparison == Comparison::Equal {
        return Some(first_difference(left, right).is_none());
    }
    let [[a]] = [left.first()?.as_slice()] else {
        return None;
    };
    let [[b]] = [right.first()?.as_slice()] else {
        return None;
    };
    let order = extension.order(&a.difference(b))?;
    Some(comparison.holds(order))
}

/// The row and column, counted from 0, of the first entry in which two tables differ.
pub fn first_difference(left: &Numbers, right: &Numbers) -> Option<(usize, usize)> {
    let mut places =
        (0..left.len()).flat_map(|row| (0..left[row].len()).map(move |column| (row, column)));
    places.find(|(row, column)| {
        let other = right.get(*row).and_then(|line| line.get(*column));
        other.is_none_or(|other| !left[*row][*column].difference(other).is_zero())
    })
}
