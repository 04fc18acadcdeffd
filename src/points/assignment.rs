//! Assignments: what each variable and each function is.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

use crate::algebra::number::Rational;
use crate::algebra::sign::Signs;
use crate::language::visit::primed;

use super::enclosure::{Enclosure, circle_point};
use super::formal::mix;
use super::graph::{FunctionId, Kind, Variable};
use super::number::Number;
use super::real::Real;
use super::{Failure, Unknown};

/// How large the numbers of an assignment are: small ones to show, large ones to trust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Numerators run up to this.
    pub numerator: u64,
    /// Denominators run up to this.
    pub denominator: u64,
    /// How many of four numbers are 0, where that is admitted.
    pub zeros: u64,
}

/// How a value is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Draw {
    /// Equal seeds give equal values.
    pub seed: u64,
    /// How large the value is.
    pub size: Size,
}

/// The value that an assignment gives something, as it is shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assigned {
    /// An ASCII expression: `m`, `dt(x)`, `cos(alpha_0)`, `dC_D`, `C_D(2*alpha_0)`.
    pub name: String,
    /// The value, or its real part.
    pub value: Rational,
    /// The imaginary part of a complex one.
    pub imaginary: Option<Rational>,
}

/// Where a function is taken: at all arguments that may be equal to each other, as far as is known.
#[derive(Clone, Debug)]
struct Place {
    arguments: Enclosure,
    /// The argument as it is shown; nothing for that at which the bare name is taken.
    label: Option<String>,
}

/// Values for everything that is free, drawn when they are first asked for.
#[derive(Clone, Debug)]
pub struct Assignment {
    usual: Draw,
    /// Those that were drawn again, by name.
    others: BTreeMap<String, Draw>,
    signs: Arc<BTreeMap<String, Signs>>,
    /// The angles whose measure is a fraction, by name; of the others the sine and the cosine are.
    measured: Arc<BTreeSet<String>>,
    /// The places of each function, each below the next.
    places: BTreeMap<FunctionId, Vec<Place>>,
}

impl Assignment {
    /// An assignment in which parameters have the given signs.
    pub fn new(
        usual: Draw,
        signs: Arc<BTreeMap<String, Signs>>,
        measured: Arc<BTreeSet<String>>,
    ) -> Self {
        Assignment {
            usual,
            others: BTreeMap::new(),
            signs,
            measured,
            places: BTreeMap::new(),
        }
    }

    /// Draws the value of a name again.
    pub fn redraw(&mut self, name: &str, draw: Draw) {
        self.others.insert(name.to_owned(), draw);
    }

    /// A fraction that depends on the draw and on a text alone; `name` is whose draw it is.
    fn random(&self, name: &str, text: &str) -> Rational {
        match self.drawn(name, text) {
            (_, true) => Rational::ZERO,
            (value, false) => value,
        }
    }

    /// A fraction ≠ 0, and whether 0 is wanted instead.
    fn drawn(&self, name: &str, text: &str) -> (Rational, bool) {
        let Draw { seed, size } = self.others.get(name).copied().unwrap_or(self.usual);
        let mut state = seed;
        for byte in text.bytes() {
            state = mix(state ^ u64::from(byte));
        }
        let numerator = mix(state) % size.numerator + 1;
        let denominator = mix(state ^ 1) % size.denominator + 1;
        let value = Rational::from_parts(numerator.into(), denominator.into());
        let is_zero = mix(state ^ 3) % 4 < size.zeros;
        match mix(state ^ 2).is_multiple_of(2) {
            true => (value, is_zero),
            false => (-value, is_zero),
        }
    }

    /// A fraction of a sign that a name was declared with.
    fn signed(&self, name: &str) -> Result<Rational, Unknown> {
        let signs = self.signs.get(name).copied().unwrap_or(Signs::ANY);
        let (value, is_zero) = self.drawn(name, name);
        let is_positive = value > Rational::ZERO;
        match (signs.negative, signs.positive) {
            _ if signs.zero && is_zero => Ok(Rational::ZERO),
            (false, false) if signs.zero => Ok(Rational::ZERO),
            (false, false) => Err(Unknown::NoAssignment),
            (true, false) if is_positive => Ok(-value),
            (false, true) if !is_positive => Ok(-value),
            _ => Ok(value),
        }
    }

    fn is_measured(&self, variable: &Variable) -> bool {
        self.measured.contains(&variable.name)
    }

    /// The value of a variable.
    ///
    /// # Errors
    ///
    /// [`Unknown::Sign`] where the measure of an angle is not known well enough.
    pub fn value(&self, variable: &Variable) -> Result<Number, Failure> {
        let name = shown_name(variable);
        if variable.kind == Kind::Complex {
            let imaginary = self.random(&variable.name, &format!("imaginary part of {name}"));
            return Ok(Number::new(self.signed(&name)?.into(), imaginary.into()));
        }
        if !variable.is_angular() {
            return Ok(Number::from(Real::from(match variable.order {
                0 => self.signed(&name)?,
                _ => self.random(&variable.name, &name),
            })));
        }
        if self.is_measured(variable) {
            return Ok(Number::from(Real::from(self.signed(&name)?)));
        }
        let (cosine, sine) = self.circle(variable)?;
        if sine.is_zero() && cosine.sign() == Some(Ordering::Greater) {
            return Ok(Number::from(sine));
        }
        let angle = Enclosure::direction(&cosine.enclosure(), &sine.enclosure());
        angle
            .map(|angle| Number::from(Real::Enclosed(angle)))
            .ok_or(Unknown::Sign.into())
    }

    /// (cos, sin) of an angular variable.
    ///
    /// # Errors
    ///
    /// [`Unknown::NoAssignment`] where no angle has the declared sign.
    pub fn circle(&self, variable: &Variable) -> Result<(Real, Real), Failure> {
        let name = &variable.name;
        if self.is_measured(variable) {
            let angle = self.signed(name)?;
            if angle.is_zero() {
                return Ok((Rational::ONE.into(), angle.into()));
            }
            let (cosine, sine) = circle_point(&angle);
            return Ok((Real::Enclosed(cosine), Real::Enclosed(sine)));
        }
        // Every t gives a rational point of the circle; that of half a turn has none.
        let text = format!("circle of {name}");
        let (t, is_on_the_axis) = self.drawn(name, &text);
        if is_on_the_axis {
            let cosine = Rational::from(if t > Rational::ZERO { 1 } else { -1 });
            return Ok((cosine.into(), Rational::ZERO.into()));
        }
        let square = &t * &t;
        let below = Rational::ONE + &square;
        let cosine = (Rational::ONE - square) / &below;
        Ok((cosine.into(), ((&t + &t) / below).into()))
    }

    /// f⁽ᵏ⁾(a): at arguments that may be equal the values are equal, which is so of a smooth function
    /// through finitely many points, whether they are or not.
    ///
    /// # Errors
    ///
    /// [`Unknown::Sign`] where an argument may be equal to two that are apart.
    pub fn function(
        &mut self,
        (function, name): (FunctionId, &str),
        order: u32,
        argument: &Real,
        label: impl FnOnce() -> Option<String>,
    ) -> Result<Real, Failure> {
        let argument = argument.enclosure();
        let places = self.places.entry(function).or_default();
        let known = known_places(places, &argument)?;
        let is_seen = |place: &Place| argument.is_within(&place.arguments);
        if !places.get(known.start).is_some_and(is_seen) {
            let joined = |joined: Enclosure, place: Place| joined.joined(&place.arguments);
            let label = match places[known.clone()].first() {
                Some(place) => place.label.clone(),
                None => label(),
            };
            let first = argument.into_owned();
            let arguments = places.drain(known.clone()).fold(first, joined);
            places.insert(known.start, Place { arguments, label });
        }
        let text = self.text_of(&self.places[&function][known.start], name, order);
        Ok(self.random(name, &text).into())
    }

    /// `dC_D`, or `C_D'` where something is called `dC_D`; `C_D(2*alpha)`.
    fn text_of(&self, place: &Place, name: &str, order: u32) -> String {
        let primed = primed(name, order);
        let primed = match self.signs.contains_key(&primed) {
            true => format!("{name}{}", "'".repeat(order as usize)),
            false => primed,
        };
        match &place.label {
            None => primed,
            Some(label) => format!("{primed}({label})"),
        }
    }

    /// What is shown of a variable, of which the number itself may be wanted.
    pub fn shown(&self, variable: &Variable) -> Vec<Assigned> {
        let real = |name: String, value: Rational| Assigned {
            name,
            value,
            imaginary: None,
        };
        let name = shown_name(variable);
        if variable.is_angular() && !self.is_measured(variable) {
            let Ok((cosine, sine)) = self.circle(variable) else {
                return Vec::new();
            };
            let parts = [("cos", cosine), ("sin", sine)];
            let parts = parts.into_iter().filter_map(|(function, part)| {
                let value = part.as_rational()?.clone();
                Some(real(format!("{function}({name})"), value))
            });
            return parts.collect();
        }
        let Ok(Number {
            real: Real::Exact(value),
            imaginary,
        }) = self.value(variable)
        else {
            return Vec::new();
        };
        let imaginary = imaginary.and_then(|part| part.as_rational().cloned());
        vec![Assigned {
            imaginary,
            ..real(name, value)
        }]
    }

    /// What is shown of a function at an argument.
    pub fn shown_function(
        &self,
        (function, name): (FunctionId, &str),
        order: u32,
        argument: &Real,
    ) -> Option<Assigned> {
        let places = self.places.get(&function)?;
        let known = known_places(places, &argument.enclosure()).ok()?;
        let text = self.text_of(places.get(known)?.first()?, name, order);
        Some(Assigned {
            value: self.random(name, &text),
            name: text,
            imaginary: None,
        })
    }
}

/// Those places at which an argument may be.
///
/// # Errors
///
/// [`Unknown::Sign`] where it may be at two at which a function has different values.
fn known_places(places: &[Place], argument: &Enclosure) -> Result<Range<usize>, Unknown> {
    let start = places.partition_point(|place| place.arguments.is_below(argument));
    let behind = places[start..].partition_point(|place| !argument.is_below(&place.arguments));
    let known = start..start + behind;
    let mut labels = places[known.clone()].iter().map(|place| &place.label);
    let first = labels.next();
    match labels.all(|label| Some(label) == first) {
        true => Ok(known),
        false => Err(Unknown::Sign),
    }
}

/// `dt(dt(x))`
fn shown_name(variable: &Variable) -> String {
    let name = variable.name.clone();
    (0..variable.order).fold(name, |inner, _| format!("dt({inner})"))
}
