//! Numbers that may be the measures of angles.

use crate::algebra::number::Rational;

use super::number::Number;
use super::number::extension::Extension;
use super::point::Tag;

/// A number, and the sum of angles that it is the measure of (at the point itself, nilpotent
/// elements aside) where it is one.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The number.
    pub number: Number,
    /// The angle.
    pub angle: Option<Tag>,
}

impl From<Number> for Sample {
    fn from(number: Number) -> Self {
        // 0 is the empty sum of angles.
        let angle = number.base().is_zero().then(Tag::new);
        Sample { number, angle }
    }
}

impl Sample {
    /// −a.
    pub fn negative(&self) -> Self {
        Sample {
            number: self.number.negative(),
            angle: self
                .angle
                .as_ref()
                .map(|tag| multiple(tag, &-Rational::ONE)),
        }
    }

    /// a + b; sums of angles are angles.
    pub fn sum(&self, other: &Self) -> Self {
        Sample {
            number: self.number.sum(&other.number),
            angle: self.angle_plus(other, &Rational::ONE),
        }
    }

    /// a − b; differences of angles are angles.
    pub fn difference(&self, other: &Self) -> Self {
        Sample {
            number: self.number.difference(&other.number),
            angle: self.angle_plus(other, &-Rational::ONE),
        }
    }

    /// a·b; rational multiples of an angle are angles.
    pub fn product(&self, other: &Self, extension: &Extension) -> Self {
        let scaled = |factor: &Sample, angle: &Sample| {
            Some(multiple(
                angle.angle.as_ref()?,
                &factor.number.as_rational()?,
            ))
        };
        let angle = scaled(self, other).or_else(|| scaled(other, self));
        Sample {
            number: extension.product(&self.number, &other.number),
            angle,
        }
    }

    /// The angle a + k·b.
    fn angle_plus(&self, other: &Self, k: &Rational) -> Option<Tag> {
        let mut tag = self.angle.clone()?;
        for (atom, count) in multiple(other.angle.as_ref()?, k) {
            *tag.entry(atom).or_insert(Rational::ZERO) += count;
        }
        tag.retain(|_, count| !count.is_zero());
        Some(tag)
    }
}

/// k·a of a sum of angles.
fn multiple(tag: &Tag, k: &Rational) -> Tag {
    tag.iter()
        .map(|(atom, count)| (atom.clone(), count * k))
        .filter(|(_, count)| !count.is_zero())
        .collect()
}
