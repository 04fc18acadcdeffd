//! What names stand for at a point.

use std::collections::BTreeSet;

use crate::algebra::number::Rational;
use crate::derivation::evaluation::point::{Atom, Key, Tag};
use crate::derivation::evaluation::sample::Sample;
use crate::derivation::evaluation::table::{Table, single};
use crate::derivation::scope::{Entry, Meaning, SymbolKind};
use crate::derivation::syntax::Name;

use super::context::{Change, Context};
use super::{Evaluator, Failure};

impl<'a> Evaluator<'a> {
    /// The value of a name: an argument, or what the document declares.
    pub(super) fn named(&mut self, name: &'a Name, context: Context) -> Result<Table, Failure> {
        let frame = &self.frames[context.frame];
        let argument = frame.arguments.get(name.ascii.as_str()).copied();
        let caller = frame.caller;
        let context = match argument {
            Some(_) => context,
            None => context.outside_calls(),
        };
        let place = (context, name.ascii.as_str());
        if let Some(known) = self.known.get(&place) {
            return Ok(known.clone());
        }
        let table = match argument {
            // Arguments are read in the caller's frame, but where the body stands.
            Some(argument) => self.table(argument, context.in_frame(caller))?,
            None => {
                let mut names = BTreeSet::new();
                names.extend(self.scope.get(name).into_iter().flat_map(Entry::rests_on));
                match self.felt(&mut names, context.surrounding) {
                    felt if felt == context.surrounding => self.declared(name, context)?,
                    felt => self.named(name, Context::of(felt))?,
                }
            }
        };
        self.known.insert(place, table.clone());
        Ok(table)
    }

    fn declared(&mut self, name: &'a Name, context: Context) -> Result<Table, Failure> {
        let scope = self.scope;
        match &scope
            .get(name)
            .ok_or(format!("{name} is not known"))?
            .meaning
        {
            Meaning::Symbol { .. } => {
                let key = Key::Symbol(name.ascii.clone(), 0);
                Ok(vec![vec![self.look_up(&key, context.surrounding)?]])
            }
            Meaning::Function { reference, .. } => {
                Ok(single(self.function(name, 0, reference, context)?))
            }
            Meaning::Definition { expression, .. } => self.table(expression, context),
            _ => Err(format!("{name} is no value")),
        }
    }

    /// The value of something free in a surrounding.
    pub(super) fn look_up(&mut self, key: &Key, surrounding: usize) -> Result<Sample, Failure> {
        let parent = self.surroundings[surrounding].parent;
        match &self.surroundings[surrounding].change {
            Change::None => self.free(key),
            Change::Time(step) => {
                let step = step.clone();
                let mut sample = self.look_up(key, parent)?;
                if let Key::Symbol(name, order) = key
                    && self.is_coordinate(name)
                {
                    let next = Key::Symbol(name.clone(), order + 1);
                    let velocity = self.look_up(&next, parent)?;
                    let moved = self.point.extension.product(&velocity.number, &step);
                    sample.number = sample.number.sum(&moved);
                }
                Ok(sample)
            }
            Change::Shift(shifted, step) => {
                let step = (shifted == key).then(|| step.clone());
                let mut sample = self.look_up(key, parent)?;
                if let Some(step) = step {
                    sample.number = sample.number.sum(&step);
                }
                Ok(sample)
            }
            Change::Set(set, value) if set == key => Ok(Sample::from(value.clone())),
            Change::Set(..) => self.look_up(key, parent),
            Change::Replace { symbols, frame, .. } => {
                let Some(value) = symbols.get(key).copied() else {
                    return self.look_up(key, parent);
                };
                let context = Context::of(parent).in_frame(*frame);
                let place = (surrounding, key.clone());
                if let Some(known) = self.replaced.get(&place) {
                    return Ok(known.clone());
                }
                let sample = self.scalar(value, context)?;
                self.replaced.insert(place, sample.clone());
                Ok(sample)
            }
            Change::Scale(scaled, step) => {
                let step = scaled.contains(key).then(|| step.clone());
                let sample = self.look_up(key, parent)?;
                Ok(match step {
                    Some(step) => Sample::from(self.point.extension.product(&sample.number, &step)),
                    None => sample,
                })
            }
        }
    }

    /// The value of something free at the point itself.
    pub(super) fn free(&mut self, key: &Key) -> Result<Sample, Failure> {
        let number = match key {
            Key::Symbol(name, 0) if self.is_imaginary(name) => {
                let unit = self.point.extension.adjoin(-Rational::ONE);
                unit.ok_or("too many roots")?
            }
            _ => self.point.value(key),
        };
        Ok(match key {
            Key::Symbol(name, 0) if self.is_angular(name) => {
                let atom = Atom::Named(name.clone());
                Sample::of_angle(Tag::from([(atom, Rational::ONE)]), number)
            }
            _ => Sample::from(number),
        })
    }

    fn is_imaginary(&self, name: &str) -> bool {
        self.scope.kind_of(name) == Some(SymbolKind::Imaginary)
    }

    /// Whether a name is a coordinate, which changes with time.
    pub(super) fn is_coordinate(&self, name: &str) -> bool {
        let kind = self.scope.kind_of(name);
        matches!(
            kind,
            Some(SymbolKind::Coordinate | SymbolKind::AngularCoordinate)
        )
    }

    /// Whether a name is an angle.
    pub(super) fn is_angular(&self, name: &str) -> bool {
        let kind = self.scope.kind_of(name);
        matches!(
            kind,
            Some(SymbolKind::Angle | SymbolKind::AngularCoordinate)
        )
    }
}
