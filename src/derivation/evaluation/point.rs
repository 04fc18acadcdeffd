//! Points at which expressions are evaluated.

use std::collections::BTreeMap;

use crate::algebra::number::Rational;
use crate::algebra::sign::Signs;
use crate::derivation::visit::primed;

use super::number::Number;
use super::number::extension::Extension;

/// Something that has a value of its own at a point.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Key {
    /// A parameter, an angle, or a time derivative of a coordinate, by ASCII name and order.
    Symbol(String, u32),
    /// f⁽ᵏ⁾ at an argument, by ASCII name and order.
    Function(String, u32, Argument),
}

impl Key {
    /// The ASCII name.
    pub fn name(&self) -> &str {
        match self {
            Key::Symbol(name, _) | Key::Function(name, ..) => name,
        }
    }
}

/// The argument of a function known only through its derivatives.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Argument {
    /// The function's own reference argument.
    Reference,
    /// A sum of angles.
    Angle(Tag),
    /// A number.
    Number(Number),
    /// A sum of angles and a number more.
    Both(Tag, Number),
}

/// One of the angles of which others are sums.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Atom {
    /// A declared angle, or a coordinate that is one.
    Named(String),
    /// The angle of a vector, by the order of appearance.
    Direction(usize),
}

/// A sum of angles with rational coefficients, none of them 0.
pub type Tag = BTreeMap<Atom, Rational>;

/// How large the numbers of a point are: small ones to show, large ones to trust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Numerators run up to this.
    pub numerator: u64,
    /// Denominators run up to this.
    pub denominator: u64,
}

/// Values for everything that is free, drawn when they are first asked for; equal seeds give equal
/// values, whatever the order of the questions.
#[derive(Clone, Debug)]
pub struct Point {
    seed: u64,
    size: Size,
    signs: BTreeMap<String, Signs>,
    /// The roots adjoined so far.
    pub extension: Extension,
    drawn: BTreeMap<String, Rational>,
    circle: BTreeMap<Atom, (Number, Number)>,
    directions: Vec<(Number, Number)>,
}

impl Point {
    /// A point whose parameters have the given signs.
    pub fn new(seed: u64, size: Size, signs: BTreeMap<String, Signs>) -> Self {
        Point {
            seed,
            size,
            signs,
            extension: Extension::default(),
            drawn: BTreeMap::new(),
            circle: BTreeMap::new(),
            directions: Vec::new(),
        }
    }

    /// What has been drawn: ASCII expressions such as `m`, `dt(x)` or `cos(alpha_0)`, and their values.
    pub fn drawn(&self) -> &BTreeMap<String, Rational> {
        &self.drawn
    }

    /// The value of something that is free.
    pub fn value(&mut self, key: &Key) -> Number {
        let (name, signs) = match key {
            Key::Symbol(name, 0) => (name.clone(), self.signs.get(name).copied()),
            Key::Symbol(name, order) => (nested_dt(name, *order), None),
            Key::Function(name, order, argument) => {
                let primed = self.derivative_name(name, *order);
                match argument {
                    Argument::Reference => (primed, None),
                    Argument::Angle(tag) => (format!("{primed}({})", written(tag)), None),
                    Argument::Number(number) => (
                        format!("{primed}({})", number.display(&self.extension)),
                        None,
                    ),
                    Argument::Both(tag, number) => {
                        let number = number.display(&self.extension);
                        (format!("{primed}({} + {number})", written(tag)), None)
                    }
                }
            }
        };
        Number::from(self.draw(&name, signs.unwrap_or(Signs::ANY)))
    }

    /// `dC`, or `C'` where a parameter is called `dC`.
    fn derivative_name(&self, name: &str, order: u32) -> String {
        let primed = primed(name, order);
        match self.signs.contains_key(&primed) {
            true => format!("{name}{}", "'".repeat(order as usize)),
            false => primed,
        }
    }

    /// A whole number that depends on the seed alone.
    pub fn first_node(&self) -> i64 {
        100 + (mix(self.seed) % 900) as i64
    }

    /// (cos, sin) of an atom.
    pub fn circle(&mut self, atom: &Atom) -> (Number, Number) {
        if let Some(known) = self.circle.get(atom) {
            return known.clone();
        }
        let pair = match atom {
            Atom::Direction(index) => self.directions[*index].clone(),
            Atom::Named(name) => {
                // Every t gives a rational point of the circle.
                let t = self.random(&format!("circle of {name}"));
                let square = &t * &t;
                let below = Rational::ONE + &square;
                let cosine = (Rational::ONE - square) / &below;
                let sine = (&t + &t) / below;
                self.drawn.insert(format!("cos({name})"), cosine.clone());
                self.drawn.insert(format!("sin({name})"), sine.clone());
                (Number::from(cosine), Number::from(sine))
            }
        };
        self.circle.insert(atom.clone(), pair.clone());
        pair
    }

    /// (cos, sin) of a sum of angles with small whole coefficients.
    pub fn circle_of(&mut self, tag: &Tag) -> Option<(Number, Number)> {
        let mut result = (Number::from(1), Number::from(0));
        for (atom, count) in tag {
            let (cosine, sine) = self.circle(atom);
            let whole = count.is_int().then(|| count.numerator().clone())?;
            let count = i64::try_from(whole)
                .ok()
                .filter(|count| count.abs() <= 64)?;
            let sine = if count < 0 { sine.negative() } else { sine };
            for _ in 0..count.unsigned_abs() {
                let extension = &self.extension;
                let product = |a: &Number, b: &Number| extension.product(a, b);
                result = (
                    product(&result.0, &cosine).difference(&product(&result.1, &sine)),
                    product(&result.1, &cosine).sum(&product(&result.0, &sine)),
                );
            }
        }
        Some(result)
    }

    /// The atom for the angle with the given cosine and sine.
    pub fn direction(&mut self, cosine: &Number, sine: &Number) -> Atom {
        let pair = (cosine.clone(), sine.clone());
        let known = self.directions.iter().position(|known| *known == pair);
        Atom::Direction(known.unwrap_or_else(|| {
            self.directions.push(pair);
            self.directions.len() - 1
        }))
    }

    fn draw(&mut self, name: &str, signs: Signs) -> Rational {
        if let Some(known) = self.drawn.get(name) {
            return known.clone();
        }
        let value = self.random(name);
        // Random values are never 0; the sign is the only thing to mend.
        let value = if signs.positive || value < Rational::ZERO {
            value
        } else {
            -value
        };
        let value = if signs.negative || value > Rational::ZERO {
            value
        } else {
            -value
        };
        self.drawn.insert(name.to_string(), value.clone());
        value
    }

    /// A rational number ≠ 0 that depends on the seed and the name alone.
    fn random(&self, name: &str) -> Rational {
        let mut state = self.seed;
        for byte in name.bytes() {
            state = mix(state ^ u64::from(byte));
        }
        let numerator = mix(state) % self.size.numerator + 1;
        let denominator = mix(state ^ 1) % self.size.denominator + 1;
        let value = Rational::from_parts(numerator.into(), denominator.into());
        if mix(state ^ 2).is_multiple_of(2) {
            value
        } else {
            -value
        }
    }
}

/// `dt(dt(x))`
fn nested_dt(name: &str, order: u32) -> String {
    (0..order).fold(name.to_string(), |inner, _| format!("dt({inner})"))
}

/// `alpha_0 + theta_0`
fn written(tag: &Tag) -> String {
    let terms = tag.iter().map(|(atom, count)| {
        let name = match atom {
            Atom::Named(name) => name.clone(),
            Atom::Direction(index) => format!("direction {index}"),
        };
        if *count == Rational::ONE {
            name
        } else {
            format!("{count}*{name}")
        }
    });
    let terms: Vec<String> = terms.collect();
    if terms.is_empty() {
        "0".into()
    } else {
        terms.join(" + ")
    }
}

/// Spreads the bits of a number (the finaliser of SplitMix64).
fn mix(state: u64) -> u64 {
    let state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let state = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let state = (state ^ (state >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    state ^ (state >> 31)
}
