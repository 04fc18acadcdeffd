//! Numbers that may be the measures of angles.

use crate::algebra::number::Rational;

use super::number::Number;
use super::number::extension::Extension;
use super::point::Tag;

/// A number, and how it is made of angles at the point itself, nilpotent elements aside: it is the
/// measure of a sum of angles and a rest.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The number.
    pub number: Number,
    /// The sum of angles.
    pub angle: Tag,
    /// What the number is more than the measure of the angles.
    pub rest: Number,
}

impl From<Number> for Sample {
    fn from(number: Number) -> Self {
        Sample {
            rest: number.base(),
            angle: Tag::new(),
            number,
        }
    }
}

impl Sample {
    /// The measure of a sum of angles, moved by something nilpotent.
    pub fn of_angle(angle: Tag, number: Number) -> Self {
        let rest = Number::default();
        Sample {
            number,
            angle,
            rest,
        }
    }

    /// The sum of angles that it is the measure of, if it is one.
    pub fn as_angle(&self) -> Option<&Tag> {
        self.rest.is_zero().then_some(&self.angle)
    }

    /// −a.
    pub fn negative(&self) -> Self {
        self.times(&-Rational::ONE)
    }

    /// a + b
    pub fn sum(&self, other: &Self) -> Self {
        let mut angle = self.angle.clone();
        for (atom, count) in &other.angle {
            *angle.entry(atom.clone()).or_insert(Rational::ZERO) += count;
        }
        angle.retain(|_, count| !count.is_zero());
        Sample {
            number: self.number.sum(&other.number),
            rest: self.rest.sum(&other.rest),
            angle,
        }
    }

    /// a − b
    pub fn difference(&self, other: &Self) -> Self {
        self.sum(&other.negative())
    }

    /// a·b; rational multiples of an angle are angles.
    pub fn product(&self, other: &Self, extension: &Extension) -> Self {
        let plain = |sample: &Sample| match sample.angle.is_empty() {
            true => sample.number.as_rational(),
            false => None,
        };
        match (plain(self), plain(other)) {
            (Some(factor), _) => other.times(&factor),
            (None, Some(factor)) => self.times(&factor),
            (None, None) => Sample::from(extension.product(&self.number, &other.number)),
        }
    }

    /// k·a for a rational number k.
    fn times(&self, factor: &Rational) -> Self {
        Sample {
            number: self.number.scale(factor),
            angle: multiple(&self.angle, factor),
            rest: self.rest.scale(factor),
        }
    }
}

/// k·a of a sum of angles.
fn multiple(tag: &Tag, k: &Rational) -> Tag {
    tag.iter()
        .map(|(atom, count)| (atom.clone(), count * k))
        .filter(|(_, count)| !count.is_zero())
        .collect()
}
