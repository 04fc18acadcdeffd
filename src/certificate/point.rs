//! Assignments at which statements are refuted, in the words of the kernel.

use std::collections::BTreeMap;

use crate::algebra::number::Rational;
use crate::language::syntax::{Expression, Name, Node, Sign};
use crate::verdict::claim::{Coordinate, Witness};

use super::expression::{Withheld, Writer};

/// Cosines and sines of five angles, over their denominator.
const CIRCLE: [(i32, i32, i32); 5] = [
    (4, 3, 5),
    (12, 5, 13),
    (15, 8, 17),
    (24, 7, 25),
    (21, 20, 29),
];

/// What a quantity is where nothing else is said of it: at a modest point as many as can be are 0 or 1, at a varied
/// one no two are equal, and what is declared later is smaller.
#[derive(Clone, Debug, Default)]
pub(super) struct Usual {
    pub(super) modest: Vec<String>,
    pub(super) varied: Vec<String>,
    count: usize,
}

impl Usual {
    fn add(&mut self, modest: String, varied: String) {
        self.modest.push(modest);
        self.varied.push(varied);
        self.count += 1;
    }

    fn next(&self) -> usize {
        200_usize.saturating_sub(self.count).max(1)
    }

    /// A constant or a coordinate.
    pub(super) fn number(&mut self, name: &str, sign: Option<Sign>) {
        let size = self.next();
        let (modest, varied) = match sign {
            None | Some(Sign::NonNegative) => ("0".into(), size.to_string()),
            Some(Sign::Positive | Sign::NonZero) => (size.to_string(), size.to_string()),
            Some(Sign::NonPositive) => ("0".into(), format!("(-{size})")),
            Some(Sign::Negative) => (format!("(-{size})"), format!("(-{size})")),
        };
        self.add(format!("Is {name} {modest}"), format!("Is {name} {varied}"));
    }

    /// A complex constant.
    pub(super) fn complex(&mut self, name: &str) {
        let number = self.next();
        self.add(
            format!("IsComplex {name} 0 0"),
            format!("IsComplex {name} {number} 3"),
        );
    }

    /// An angle.
    pub(super) fn angle(&mut self, name: &str) {
        let (c, s, below) = CIRCLE
            .into_iter()
            .nth(self.count % CIRCLE.len())
            .unwrap_or((1, 0, 1));
        self.add(
            format!("Turns {name} 1 0"),
            format!("Turns {name} ({c} # {below}) ({s} # {below})"),
        );
    }

    /// A function.
    pub(super) fn function(&mut self, name: &str) {
        let number = self.next();
        let varied = format!("Takes {name} [{number}; {}; {}]%Q", number + 1, number + 3);
        self.add(format!("Takes {name} []"), varied);
    }
}

/// What an assignment says, setting by setting.
///
/// # Errors
///
/// Why it cannot be said.
pub(super) fn settings(witness: &Witness, writer: &Writer) -> Result<Vec<String>, Withheld> {
    let mut settings = Vec::new();
    let mut angles: BTreeMap<String, [Option<Rational>; 2]> = BTreeMap::new();
    let mut functions: BTreeMap<String, BTreeMap<u32, Rational>> = BTreeMap::new();
    for coordinate in &witness.point {
        let Coordinate {
            name,
            value,
            imaginary,
        } = coordinate;
        if let Some((angle, place)) = circular(name) {
            let of = angles.entry(writer.argument(angle)?).or_default();
            if let Some(own) = of.get_mut(place) {
                *own = Some(value.clone());
            }
        } else if let Some((bare, order)) = function_value(name, writer) {
            functions
                .entry(writer.argument(&bare)?)
                .or_default()
                .insert(order, value.clone());
        } else {
            let name = writer.argument(name)?;
            settings.push(match imaginary {
                None => format!("Is {name} {}", fraction(value)),
                Some(imaginary) => format!(
                    "IsComplex {name} {} {}",
                    fraction(value),
                    fraction(imaginary)
                ),
            });
        }
    }
    for (angle, values) in angles {
        let [Some(cosine), Some(sine)] = values else {
            return Err("an angle of which the sine or the cosine is not told".into());
        };
        settings.push(format!(
            "Turns {angle} {} {}",
            fraction(&cosine),
            fraction(&sine)
        ));
    }
    for (function, values) in functions {
        let highest = values.keys().max().copied().unwrap_or(0);
        let values = (0..=highest).map(|order| values.get(&order).map_or("0".into(), fraction));
        settings.push(format!(
            "Takes {function} [{}]%Q",
            values.collect::<Vec<_>>().join("; ")
        ));
    }
    Ok(settings)
}

/// The angle of a cosine (0) or a sine (1).
fn circular(expression: &Expression) -> Option<(&Expression, usize)> {
    let Node::Call {
        function,
        arguments,
        ..
    } = &expression.node
    else {
        return None;
    };
    match (function.ascii.as_str(), arguments.as_slice()) {
        ("cos", [angle]) => Some((angle, 0)),
        ("sin", [angle]) => Some((angle, 1)),
        _ => None,
    }
}

/// The value of a function that an expression is a derivative of, and of which order.
fn function_value(expression: &Expression, writer: &Writer) -> Option<(Expression, u32)> {
    let known = |name: &Name| writer.functions.contains_key(&name.ascii);
    match &expression.node {
        Node::Name(name) if known(name) => Some((expression.clone(), 0)),
        Node::Derivative(name, order) if known(name) => {
            Some((Expression::name(name.clone()), *order))
        }
        Node::Call {
            function,
            order,
            arguments,
        } if known(function) => Some((
            Expression::call(function.clone(), 0, arguments.clone()),
            *order,
        )),
        _ => None,
    }
}

fn fraction(number: &Rational) -> String {
    let (above, below) = number.clone().into_parts();
    format!("({above} # {below})")
}
