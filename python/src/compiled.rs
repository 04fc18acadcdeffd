//! An evaluator of a document, whose program is run as it is.

use sextic::compile::specification::Specification;
use sextic_codegen::arithmetic::Arithmetic;
use sextic_codegen::arithmetic::doubles::Beyond;
use sextic_codegen::evaluator::{Circular, Evaluator, Function, Input, Origin};
use sextic_codegen::language::literal::{Decimal, Literal};
use sextic_codegen::program::Rational;
use sextic_evaluators::arithmetic::Arithmetic as Body;
use sextic_evaluators::bounded::Bounded;

use crate::kernel::{Blocks, Kernel, Quantity, Source};
use crate::tape::Tape;

/// An evaluator that was compiled here.
pub struct Compiled {
    evaluator: Evaluator,
    asked: Vec<Quantity>,
    tape: Tape,
}

impl Compiled {
    /// The evaluator of a specification.
    ///
    /// # Errors
    ///
    /// If a constant is beyond the doubles.
    pub fn of(specification: &Specification) -> Result<Self, Beyond> {
        let asked = specification.quantities().map(|own| {
            let text = match own.description.as_str() {
                "" => &own.symbol,
                description => description,
            };
            Quantity::new(own.name.clone(), said(text, &own.unit))
        });
        // What is fixed is asked of nobody.
        let free = |own: &Quantity| {
            let evaluator = &specification.evaluator;
            let fixed = evaluator
                .inputs
                .iter()
                .filter(|input| input.fixed().is_some());
            let angle = evaluator.angle(&own.name);
            !fixed
                .into_iter()
                .any(|input| input.quantity.name == own.name)
                && angle.is_none_or(|angle| angle.fixed.is_none())
        };
        Ok(Compiled {
            tape: Tape::of(&specification.evaluator.program)?,
            asked: asked.filter(free).collect(),
            evaluator: specification.evaluator.clone(),
        })
    }

    fn source(&self, input: &Input) -> Source {
        let place = |name: &str| self.asked.iter().position(|own| own.name == name);
        match &input.origin {
            Origin::Given => {
                place(&input.quantity.name).map_or(Source::Fixed(f64::NAN), Source::Given)
            }
            Origin::Circular(circular) => self.circular(circular),
            Origin::Fixed(fixed) => {
                let nearest = Decimal::nearest(&fixed.value);
                Source::Fixed(nearest.map_or(f64::NAN, |own| own.value))
            }
        }
    }

    /// The sine or cosine of a sum of angles, added in the order of the evaluator.
    fn circular(&self, circular: &Circular) -> Source {
        let place = |name: &str| self.asked.iter().position(|own| own.name == name);
        let fixed = |name: &str| {
            let angle = self.evaluator.angle(name)?.fixed.as_ref()?;
            Some(Decimal::nearest(&angle.value)?.value)
        };
        let terms: Vec<(f64, Option<usize>, f64)> = circular
            .angle
            .iter()
            .map(|(count, name)| {
                (
                    f64::from(*count),
                    place(name),
                    fixed(name).unwrap_or(f64::NAN),
                )
            })
            .collect();
        let of = terms.iter().filter_map(|own| own.1).collect();
        let function = circular.function;
        Source::Made(
            of,
            Box::new(move |given| {
                let value =
                    |place: Option<usize>, fixed| place.map_or(fixed, |place: usize| given[place]);
                let sum = terms.iter().fold(0.0, |sum, (count, place, fixed)| {
                    sum + count * value(*place, *fixed)
                });
                match function {
                    Function::Cosine => sum.cos(),
                    Function::Sine => sum.sin(),
                }
            }),
        )
    }
}

/// What a quantity is, and its unit, as emitted text says it.
fn said(description: &str, unit: &str) -> String {
    match unit {
        "" | "1" => format!("{description}, dimensionless"),
        unit => format!("{description}, in `{unit}`"),
    }
}

impl Kernel for Compiled {
    fn name(&self) -> &str {
        &self.evaluator.name
    }

    fn text(&self) -> String {
        let own = &self.evaluator;
        let list = |heading: &str, lines: &[String]| match lines {
            [] => String::new(),
            _ => {
                let lines: Vec<String> = lines.iter().map(|line| format!("- `{line}`")).collect();
                format!("\n\n{heading}\n\n{}", lines.join("\n"))
            }
        };
        format!(
            "{}.\n\nSource: {}{}{}{}",
            own.title,
            own.document,
            list("# Formula", &own.formula),
            list("# Conditions\n\nThe derivation assumes:", &own.assumptions),
            list("It needs:", &own.conditions),
        )
    }

    fn asked(&self) -> Vec<Quantity> {
        self.asked.clone()
    }

    fn outputs(&self) -> Vec<Quantity> {
        let outputs = self.evaluator.outputs.iter();
        outputs
            .map(|own| Quantity::new(own.name.clone(), said(&own.symbol, &own.unit)))
            .collect()
    }

    fn sources(&self) -> Vec<Source> {
        let inputs = self.evaluator.inputs.iter();
        inputs.map(|own| self.source(own)).collect()
    }

    fn prepared<'k>(&'k self, same: &[Option<f64>]) -> Box<dyn Blocks + 'k> {
        Box::new(self.tape.prepared(same))
    }

    fn bounded(&self, inputs: &[f64]) -> Vec<Bounded> {
        let inputs: Vec<Bounded> = inputs.iter().copied().map(Bounded::exact).collect();
        let found = self.evaluator.program.run(&mut Bounds, &inputs);
        found.unwrap_or_default()
    }
}

/// Doubles with bounds of their rounding, as the emitted twins have them.
struct Bounds;

impl Arithmetic for Bounds {
    type Value = Bounded;
    type Error = Beyond;

    fn constant(&mut self, value: &Rational) -> Result<Bounded, Beyond> {
        let literal = Literal::of(value).ok_or(Beyond)?;
        let sum = |terms: &[Decimal]| {
            let terms = terms.iter().map(|own| Bounded::exact(own.value));
            terms.reduce(|a, b| a + b)
        };
        let above = sum(&literal.above).unwrap_or(Bounded::exact(0.0));
        Ok(sum(&literal.below).map_or(above, |below| above / below))
    }

    fn negative(&mut self, a: &Bounded) -> Result<Bounded, Beyond> {
        Ok(-*a)
    }

    fn sum(&mut self, a: &Bounded, b: &Bounded) -> Result<Bounded, Beyond> {
        Ok(*a + *b)
    }

    fn difference(&mut self, a: &Bounded, b: &Bounded) -> Result<Bounded, Beyond> {
        Ok(*a - *b)
    }

    fn product(&mut self, a: &Bounded, b: &Bounded) -> Result<Bounded, Beyond> {
        Ok(*a * *b)
    }

    fn quotient(&mut self, a: &Bounded, b: &Bounded) -> Result<Bounded, Beyond> {
        Ok(*a / *b)
    }

    fn square_root(&mut self, a: &Bounded) -> Result<Bounded, Beyond> {
        Ok(a.square_root())
    }
}
