//! Sines and cosines of sums of angles, and the angles of vectors.

use std::collections::BTreeMap;

use crate::algebra::number::{Integer, Rational};

use super::derivative::{By, Derivative};
use super::graph::{Made, Node, NodeId, VariableId};
use super::sheet::Sheet;
use super::substitution::Substitution;
use super::{Failure, Unknown};

/// The largest multiple of an angle whose sine is followed.
const LARGEST_MULTIPLE: i64 = 1_000;

/// What an angle is a sum of: angular variables, and angles of vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Part {
    Variable(VariableId),
    Direction(NodeId),
}

/// A sum of angles with whole coefficients.
type Whole = BTreeMap<Part, i64>;

/// A cosine and a sine.
pub type Circle = (NodeId, NodeId);

impl Sheet {
    /// (cos a, sin a) of a node that is a sum of angles, by the addition formulas.
    ///
    /// # Errors
    ///
    /// [`Unknown::NotAnAngle`] where it is none.
    pub fn cosine_and_sine(&mut self, angle: NodeId) -> Result<Circle, Failure> {
        let whole = match self.written_sum(angle) {
            Some(whole) => whole,
            None => self.hidden_sum(angle)?.ok_or(Unknown::NotAnAngle)?,
        };
        let mut result = (self.graph.integer(1)?, self.graph.integer(0)?);
        for (part, count) in whole {
            let pair = self.circle_of(part)?;
            let turned = self.multiple(pair, count)?;
            result = self.turn(result, turned)?;
        }
        let (cosine, sine) = result;
        Ok((
            self.graph.guarded(cosine, angle)?,
            self.graph.guarded(sine, angle)?,
        ))
    }

    fn circle_of(&mut self, part: Part) -> Result<Circle, Failure> {
        match part {
            Part::Variable(id) => Ok((self.graph.cosine(id)?, self.graph.sine(id)?)),
            Part::Direction(id) => {
                let Node::Direction { x, y, .. } = *self.graph.node(id) else {
                    return Err(Unknown::NotAnAngle.into());
                };
                let square = self.square_of_length(x, y)?;
                let length = self.graph.root(square)?;
                Ok((
                    self.graph.quotient(x, length)?,
                    self.graph.quotient(y, length)?,
                ))
            }
        }
    }

    /// (cos(a + b), sin(a + b)).
    fn turn(&mut self, (c, s): Circle, (d, t): Circle) -> Result<Circle, Failure> {
        let graph = &mut self.graph;
        let (cd, st) = (graph.product(c, d)?, graph.product(s, t)?);
        let (sd, ct) = (graph.product(s, d)?, graph.product(c, t)?);
        Ok((graph.difference(cd, st)?, graph.sum(sd, ct)?))
    }

    /// (cos ka, sin ka), by repeated doubling.
    fn multiple(&mut self, (cosine, sine): Circle, count: i64) -> Result<Circle, Failure> {
        let sine = match count < 0 {
            true => self.graph.negative(sine)?,
            false => sine,
        };
        let mut result = (self.graph.integer(1)?, self.graph.integer(0)?);
        let (mut power, mut rest) = ((cosine, sine), count.unsigned_abs());
        while rest > 0 {
            if rest % 2 == 1 {
                result = self.turn(result, power)?;
            }
            rest /= 2;
            if rest > 0 {
                power = self.turn(power, power)?;
            }
        }
        Ok(result)
    }

    /// The sum of angles that a node is written as.
    fn written_sum(&self, id: NodeId) -> Option<Whole> {
        let mut factors = BTreeMap::from([(id, Rational::ONE)]);
        let mut whole = Whole::new();
        // What rests on a node has a higher number, so that the factor of the highest one is complete.
        while let Some((id, factor)) = factors.pop_last() {
            if factor.is_zero() {
                continue;
            }
            let mut add = |part, share: Rational| {
                *factors.entry(part).or_insert(Rational::ZERO) += share;
            };
            match self.graph.node(id) {
                Node::Number(number) if number.is_zero() => {}
                Node::Variable(variable) if self.graph.variable(*variable).is_angular() => {
                    whole.insert(Part::Variable(*variable), small(&factor)?);
                }
                Node::Direction { .. } => drop(whole.insert(Part::Direction(id), small(&factor)?)),
                Node::Sum(a, b) => {
                    add(*a, factor.clone());
                    add(*b, factor);
                }
                Node::Product(a, b) => add(*b, factor * self.graph.as_number(*a)?),
                _ => return None,
            }
        }
        Some(whole)
    }

    /// The sum of angular variables that a node is everywhere, though it is written otherwise: its
    /// derivatives are the coefficients.
    fn hidden_sum(&mut self, id: NodeId) -> Result<Option<Whole>, Failure> {
        let slope =
            |sheet: &mut Sheet, variable| Derivative::new(By::Variable(variable)).of(id, sheet);
        let Some(whole) = self.whole_slopes(&[id], slope)? else {
            return Ok(None);
        };
        let sum = self.sum_of(&whole)?;
        Ok(self.is_same(sum, id)?.then_some(whole))
    }

    /// The slopes by all angular variables that some nodes rest on, if all of them are whole numbers.
    fn whole_slopes(
        &mut self,
        nodes: &[NodeId],
        mut slope: impl FnMut(&mut Sheet, VariableId) -> Made,
    ) -> Result<Option<Whole>, Failure> {
        let mut whole = Whole::new();
        for variable in self.graph.variables_of(nodes) {
            if !self.graph.variable(variable).is_angular() {
                continue;
            }
            let slope = slope(self, variable)?;
            let value = self.sample(slope).ok_or(Unknown::Identity)?;
            let Some(real) = value.as_real() else {
                return Ok(None);
            };
            let nearest = match real.as_rational() {
                Some(number) => number.round(),
                None => real.enclosure().middle().round(),
            };
            if !real.may_be(&Rational::from(nearest.clone()).into()) {
                return Ok(None);
            }
            match small(&Rational::from(nearest)) {
                Some(0) => {}
                Some(count) => drop(whole.insert(Part::Variable(variable), count)),
                None => return Ok(None),
            }
        }
        Ok(Some(whole))
    }

    fn sum_of(&mut self, whole: &Whole) -> Made {
        let mut terms = Vec::new();
        for (part, count) in whole {
            let part = match part {
                Part::Variable(id) => self.graph.free(*id)?,
                Part::Direction(id) => *id,
            };
            terms.push(self.graph.scaled(part, Rational::from(*count))?);
        }
        self.total(terms)
    }

    /// The angle of the vector (x, y).
    ///
    /// # Errors
    ///
    /// [`NoValue::ZeroVector`](super::NoValue::ZeroVector) for (0, 0), and those of [`Sheet::vanishes`].
    pub fn direction(&mut self, x: NodeId, y: NodeId) -> Made {
        let parallel = self.parallel(x, y)?;
        let (angle, along) = match parallel {
            Some([angle, cosine, sine]) => {
                let (one, other) = (self.graph.product(x, cosine)?, self.graph.product(y, sine)?);
                (angle, self.graph.sum(one, other)?)
            }
            None if self.graph.is_zero(y) => (y, x),
            None => return self.graph.angle_of(x, y, None),
        };
        match self.is_positive(along)? {
            true => {
                let angle = self.graph.guarded(angle, x)?;
                self.graph.guarded(angle, y)
            }
            false => self.graph.angle_of(x, y, parallel),
        }
    }

    /// Whether a node is above 0 under every assignment at which it has a value: variables on which it
    /// does not depend may be taken as 0.
    fn is_positive(&mut self, id: NodeId) -> Result<bool, Failure> {
        let zero = self.graph.integer(0)?;
        let mut at_zero = Substitution::default();
        for variable in self.graph.variables_of(&[id]) {
            if self.graph.variable(variable).signs.is_positive() {
                continue;
            }
            let slope = Derivative::new(By::Variable(variable)).of(id, self)?;
            if self.vanishes(slope)? {
                at_zero.variables.insert(variable, zero);
            }
        }
        let simple = at_zero.of(id, self);
        Ok(simple.is_ok_and(|simple| self.graph.is_positive(simple)))
    }

    /// The sum β of angular variables of which (cos β, sin β) is a multiple of (x, y) everywhere, with its
    /// cosine and sine.
    fn parallel(&mut self, x: NodeId, y: NodeId) -> Result<Option<[NodeId; 3]>, Failure> {
        let slope = |sheet: &mut Sheet, variable| {
            let mut derivative = Derivative::new(By::Variable(variable));
            let (dx, dy) = (derivative.of(x, sheet)?, derivative.of(y, sheet)?);
            sheet.turning(x, y, dx, dy)
        };
        let whole = match self.whole_slopes(&[x, y], slope)? {
            Some(whole) if !whole.is_empty() => whole,
            _ => return Ok(None),
        };
        let angle = self.sum_of(&whole)?;
        let (cosine, sine) = self.cosine_and_sine(angle)?;
        let (one, other) = (self.graph.product(x, sine)?, self.graph.product(y, cosine)?);
        let is_parallel = self.is_same(one, other)?;
        Ok(is_parallel.then_some([angle, cosine, sine]))
    }
}

/// A whole number that is not large.
fn small(number: &Rational) -> Option<i64> {
    let whole = number.is_int().then(|| number.numerator().clone())?;
    let whole: Integer = whole;
    i64::try_from(whole)
        .ok()
        .filter(|count| count.abs() <= LARGEST_MULTIPLE)
}
