//! Angles at a point: their sines and cosines, and the angles of vectors.

use crate::algebra::number::Rational;
use crate::derivation::evaluation::number::Number;
use crate::derivation::evaluation::point::{Atom, Key, Tag};
use crate::derivation::evaluation::sample::Sample;

use super::{Evaluator, Failure};

impl Evaluator<'_> {
    /// (cos, sin) of an angle a + n: by the addition formulas from those of a, and by their finite
    /// series from those of a nilpotent n.
    pub(super) fn circular(&mut self, angle: &Sample) -> Result<(Number, Number), Failure> {
        let tag = angle.as_angle().ok_or("the sine of what is no angle")?;
        let (cosine, sine) = self
            .point
            .circle_of(tag)
            .ok_or("not a small whole multiple of an angle")?;
        let step = angle.number.step();
        let extension = &self.point.extension;
        let (mut even, mut odd) = (Number::from(1), Number::default());
        let mut power = step.clone();
        let mut k = 1;
        while !power.is_zero() {
            power = power.scale(&(Rational::ONE / Rational::from(k)));
            match k % 4 {
                1 => odd = odd.sum(&power),
                2 => even = even.difference(&power),
                3 => odd = odd.difference(&power),
                _ => even = even.sum(&power),
            }
            power = extension.product(&power, &step);
            k += 1;
        }
        let product = |a: &Number, b: &Number| extension.product(a, b);
        Ok((
            product(&cosine, &even).difference(&product(&sine, &odd)),
            product(&sine, &even).sum(&product(&cosine, &odd)),
        ))
    }

    /// The angle of (x, y): that of the point itself, and the finite series of the arctangent for the
    /// nilpotent rest.
    pub(super) fn direction(&mut self, x: &Number, y: &Number) -> Result<Sample, Failure> {
        let (x0, y0) = (x.base(), y.base());
        let square = {
            let extension = &self.point.extension;
            extension
                .product(&x0, &x0)
                .sum(&extension.product(&y0, &y0))
        };
        let length = self.root(&square)?;
        let inverse = self
            .point
            .extension
            .inverse(&length)
            .ok_or("the vector vanishes")?;
        let product = |a: &Number, b: &Number| self.point.extension.product(a, b);
        let (cosine, sine) = (product(&x0, &inverse), product(&y0, &inverse));
        let across = product(&cosine, y).difference(&product(&sine, x));
        let along = product(&cosine, x).sum(&product(&sine, y));
        let below = self
            .point
            .extension
            .inverse(&along)
            .ok_or("the vector vanishes")?;
        let tangent = product(&across, &below);
        let square = product(&tangent, &tangent).negative();
        let (mut turn, mut power, mut k) = (Number::default(), tangent, 1);
        while !power.is_zero() {
            turn = turn.sum(&power.scale(&(Rational::ONE / Rational::from(k))));
            power = self.point.extension.product(&power, &square);
            k += 2;
        }
        let tag = self.tag_of(&cosine, &sine)?;
        // The measure of the angle at the point itself, as for every other angle.
        let number = tag.iter().fold(turn, |sum, (atom, count)| {
            let name = match atom {
                Atom::Named(name) => name.clone(),
                Atom::Direction(index) => format!("direction {index}"),
            };
            let measure = self.point.value(&Key::Symbol(name, 0));
            sum.sum(&measure.scale(count))
        });
        Ok(Sample::of_angle(tag, number))
    }

    /// The sum of declared angles with the given cosine and sine, or a new atom for it.
    fn tag_of(&mut self, cosine: &Number, sine: &Number) -> Result<Tag, Failure> {
        if *cosine == Number::from(1) {
            return Ok(Tag::new());
        }
        let scope = self.scope;
        for entry in scope.entries() {
            if self.is_angular(&entry.name.ascii) {
                let atom = Atom::Named(entry.name.ascii.clone());
                if self.point.circle(&atom) == (cosine.clone(), sine.clone()) {
                    return Ok(Tag::from([(atom, Rational::ONE)]));
                }
            }
        }
        let atom = self.point.direction(cosine, sine);
        Ok(Tag::from([(atom, Rational::ONE)]))
    }
}
