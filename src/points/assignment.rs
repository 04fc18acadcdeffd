//! Assignments: what each variable and each function is.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::algebra::number::Rational;
use crate::algebra::sign::Signs;
use crate::derivation::visit::primed;

use super::Failure;
use super::enclosure::{Enclosure, circle_point};
use super::formal::mix;
use super::graph::{FunctionId, Kind, Variable};
use super::number::Number;
use super::real::Real;

/// How large the numbers of an assignment are: small ones to show, large ones to trust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Numerators run up to this.
    pub numerator: u64,
    /// Denominators run up to this.
    pub denominator: u64,
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

/// A function at one of its arguments.
#[derive(Clone, Debug)]
struct Place {
    function: FunctionId,
    argument: Real,
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
    places: Vec<Place>,
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
            places: Vec::new(),
        }
    }

    /// Draws the value of a name again.
    pub fn redraw(&mut self, name: &str, draw: Draw) {
        self.others.insert(name.to_owned(), draw);
    }

    /// A fraction ≠ 0 that depends on the draw and on a text alone; `name` is whose draw it is.
    fn random(&self, name: &str, text: &str) -> Rational {
        let Draw { seed, size } = self.others.get(name).copied().unwrap_or(self.usual);
        let mut state = seed;
        for byte in text.bytes() {
            state = mix(state ^ u64::from(byte));
        }
        let numerator = mix(state) % size.numerator + 1;
        let denominator = mix(state ^ 1) % size.denominator + 1;
        let value = Rational::from_parts(numerator.into(), denominator.into());
        match mix(state ^ 2).is_multiple_of(2) {
            true => value,
            false => -value,
        }
    }

    /// A fraction of the sign that a name was declared with.
    fn signed(&self, name: &str) -> Rational {
        let signs = self.signs.get(name).copied().unwrap_or(Signs::ANY);
        let value = self.random(name, name);
        // Random values are never 0; the sign is the only thing to mend.
        match value > Rational::ZERO {
            true if !signs.positive => -value,
            false if !signs.negative => -value,
            _ => value,
        }
    }

    fn is_measured(&self, variable: &Variable) -> bool {
        self.measured.contains(&variable.name)
    }

    /// The value of a variable.
    ///
    /// # Errors
    ///
    /// [`Failure::UnknownSign`] where the measure of an angle is not known well enough.
    pub fn value(&self, variable: &Variable) -> Result<Number, Failure> {
        let name = shown_name(variable);
        if variable.kind == Kind::Complex {
            let imaginary = self.random(&variable.name, &format!("imaginary part of {name}"));
            return Ok(Number::new(self.signed(&name).into(), imaginary.into()));
        }
        if !variable.is_angular() {
            return Ok(Number::from(Real::from(match variable.order {
                0 => self.signed(&name),
                _ => self.random(&variable.name, &name),
            })));
        }
        if self.is_measured(variable) {
            return Ok(Number::from(Real::from(self.signed(&name))));
        }
        let (cosine, sine) = self.circle(variable);
        let angle = Enclosure::direction(&cosine.enclosure(), &sine.enclosure());
        angle
            .map(|angle| Number::from(Real::Enclosed(angle)))
            .ok_or(Failure::UnknownSign)
    }

    /// (cos, sin) of an angular variable.
    pub fn circle(&self, variable: &Variable) -> (Real, Real) {
        let name = &variable.name;
        if self.is_measured(variable) {
            let (cosine, sine) = circle_point(&self.signed(name));
            return (Real::Enclosed(cosine), Real::Enclosed(sine));
        }
        // Every t gives a rational point of the circle.
        let t = self.random(name, &format!("circle of {name}"));
        let square = &t * &t;
        let below = Rational::ONE + &square;
        let cosine = (Rational::ONE - square) / &below;
        (cosine.into(), ((&t + &t) / below).into())
    }

    /// f⁽ᵏ⁾(a): at arguments that may be equal the values are equal, which is so of a smooth function
    /// through finitely many points, whether they are or not.
    ///
    /// # Errors
    ///
    /// [`Failure::UnknownSign`] where an argument may be equal to two that are apart.
    pub fn function(
        &mut self,
        (function, name): (FunctionId, &str),
        order: u32,
        argument: &Real,
        label: impl FnOnce() -> Option<String>,
    ) -> Result<Real, Failure> {
        let place = match self.place(function, argument)? {
            Some(known) => {
                let place = Place {
                    argument: argument.clone(),
                    ..known.clone()
                };
                // What may be equal to this one later must get the same value.
                if argument.as_rational().is_none() {
                    self.places.push(place.clone());
                }
                place
            }
            None => {
                let place = Place {
                    function,
                    argument: argument.clone(),
                    label: label(),
                };
                self.places.push(place.clone());
                place
            }
        };
        Ok(self.random(name, &self.text_of(&place, name, order)).into())
    }

    /// The place of a function's argument.
    fn place(&self, function: FunctionId, argument: &Real) -> Result<Option<&Place>, Failure> {
        let of_function = self
            .places
            .iter()
            .filter(|place| place.function == function);
        let mut known = of_function.filter(|place| place.argument.may_be(argument));
        let first = known.next();
        match known.all(|other| first.is_some_and(|first| first.label == other.label)) {
            true => Ok(first),
            false => Err(Failure::UnknownSign),
        }
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
            let (cosine, sine) = self.circle(variable);
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
        let place = self.place(function, argument).ok()??;
        let text = self.text_of(place, name, order);
        Some(Assigned {
            value: self.random(name, &text),
            name: text,
            imaginary: None,
        })
    }
}

/// `dt(dt(x))`
fn shown_name(variable: &Variable) -> String {
    let name = variable.name.clone();
    (0..variable.order).fold(name, |inner, _| format!("dt({inner})"))
}
