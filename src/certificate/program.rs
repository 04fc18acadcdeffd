//! The operations of an emitted function, and that they are its formula.

use sextic_codegen::program::{Node, Operation, Program};

use crate::compile::specification::{Refusal, Specification};
use crate::language::evaluator::Evaluator;

use super::claim::named;
use super::composer::Composer;
use super::entry::{Entry, Kind, Subject};
use super::expression::{Withheld, number};
use super::theorem::{Rule, Theorem, comment};

/// So many terms an output may have where it is multiplied out, which the checker does: with a few thousand it takes
/// seconds.
const MOST_TERMS: u64 = 10_000;

/// Adds the operations of an evaluator, and a theorem for each of its outputs.
pub(super) fn add_program(composer: &mut Composer<'_>, evaluator: &Evaluator, line: usize) {
    let outputs = evaluator.outputs.iter();
    outputs.for_each(|output| composer.find_degrees(&output.expression));
    composer.bring_up_to_date();
    let name = comment(&evaluator.name.unicode);
    composer.text(format!(
        "\n(* {name}, operation by operation, as it is emitted *)\n"
    ));
    let number = composer.entries.len();
    let theorems = specified(composer, evaluator)
        .and_then(|specification| theorems(composer, evaluator, &specification));
    let certificate = match theorems {
        Ok(theorems) => {
            let all = theorems.into_iter();
            all.for_each(|theorem| composer.theorem(number, theorem));
            Ok(Kind::Program)
        }
        Err(reason) => {
            composer.text(format!("(* withheld: {} *)\n", comment(&reason)));
            Err(reason)
        }
    };
    composer.entries.push(Entry {
        id: evaluator.name.ascii.clone(),
        label: evaluator.name.unicode.clone(),
        line,
        subject: Subject::Program,
        certificate,
    });
}

/// What an evaluator is to compute, if that is not too large; if it is, its outputs are withheld from claims, too.
fn specified(
    composer: &mut Composer<'_>,
    evaluator: &Evaluator,
) -> Result<Specification, Withheld> {
    let specification = Specification::of(evaluator, composer.audit, &[]);
    let specification = specification.map_err(|refusal| refusal.to_string())?;
    let most = terms(&specification.evaluator.program).into_iter().max();
    let Some(most) = most.filter(|most| *most > MOST_TERMS) else {
        return Ok(specification);
    };
    let reason = format!("multiplied out it has {most} terms");
    let outputs = evaluator.outputs.iter();
    let outputs = outputs.map(|own| evaluator.name.output(&own.name).ascii);
    let withheld = &mut composer.writer.withheld;
    withheld.extend(outputs.map(|output| (output, reason.clone())));
    Err(reason)
}

/// For each output, that what its operations give is what the document says.
fn theorems(
    composer: &mut Composer<'_>,
    evaluator: &Evaluator,
    specification: &Specification,
) -> Result<Vec<Theorem>, Withheld> {
    let given = given(composer, evaluator, specification)?;
    let written = specification.written.iter();
    let written = written.map(|own| composer.writer.side(own));
    let written = written.collect::<Result<Vec<_>, _>>()?;
    let (name, program) = (&evaluator.name.ascii, &specification.evaluator.program);
    let values = operations(composer, specification)?;
    let outputs = program.outputs().iter().zip(written);
    let theorem = |((output, node), written): (&(String, Node), String)| {
        let value = &values[node.index()];
        let statement = format!("{given} |=\n  {value}\n  == {written}");
        let name = format!("program_{name}_{output}");
        named(composer, name, statement, Rule::Check)
    };
    Ok(outputs.map(theorem).collect())
}

/// Under what its outputs need, and what the document says that it is for.
fn given(
    composer: &Composer<'_>,
    evaluator: &Evaluator,
    specification: &Specification,
) -> Result<String, Withheld> {
    let conditions = specification.conditions();
    let conditions = conditions.map_err(|refusal: Refusal| refusal.to_string())?;
    let mut given = composer.conditions(&conditions)?;
    for relation in &evaluator.conditions {
        given.push(composer.hypothesis(relation)?);
    }
    Ok(composer.given(&given))
}

/// How many terms stand above and below the line of a fraction, where everything is multiplied out and nothing is
/// collected.
#[derive(Clone, Copy)]
struct Spread {
    above: u64,
    below: u64,
}

impl Spread {
    const ONE: Spread = Spread { above: 1, below: 1 };

    /// Two denominators of one size are taken to be the same.
    fn sum(self, other: Self) -> Self {
        let below = self.below.max(other.below);
        let above = |own: Self| own.above.saturating_mul(below / own.below);
        Spread {
            above: above(self).saturating_add(above(other)),
            below,
        }
    }

    fn product(self, other: Self) -> Self {
        Spread {
            above: self.above.saturating_mul(other.above),
            below: self.below.saturating_mul(other.below),
        }
    }

    fn quotient(self, other: Self) -> Self {
        self.product(Spread {
            above: other.below,
            below: other.above,
        })
    }
}

/// Of each output, how many terms it has where everything is multiplied out.
fn terms(program: &Program) -> Vec<u64> {
    let mut spreads: Vec<Spread> = Vec::new();
    for operation in program.operations() {
        let of = |node: &Node| spreads[node.index()];
        spreads.push(match operation {
            Operation::Input(_) | Operation::Constant(_) | Operation::SquareRoot(_) => Spread::ONE,
            Operation::Negative(a) => of(a),
            Operation::Add(a, b) | Operation::Subtract(a, b) => of(a).sum(of(b)),
            Operation::Multiply(a, b) => of(a).product(of(b)),
            Operation::Divide(a, b) => of(a).quotient(of(b)),
        });
    }
    let outputs = program.outputs().iter();
    outputs
        .map(|(_, node)| spreads[node.index()].above)
        .collect()
}

/// Defines the value of each operation, and gives the words for it.
fn operations(
    composer: &mut Composer<'_>,
    specification: &Specification,
) -> Result<Vec<String>, Withheld> {
    let inputs = specification.written_inputs();
    let inputs = inputs.map_err(|refusal| refusal.to_string())?;
    let evaluator = &specification.evaluator;
    let mut values: Vec<String> = Vec::new();
    for (place, operation) in evaluator.program.operations().iter().enumerate() {
        let of = |node: &Node| &values[node.index()];
        let written = match operation {
            Operation::Input(place) => {
                values.push(composer.writer.argument(&inputs[*place as usize])?);
                continue;
            }
            Operation::Constant(constant) => {
                values.push(number(constant));
                continue;
            }
            Operation::Add(a, b) => format!("{} + {}", of(a), of(b)),
            Operation::Subtract(a, b) => format!("{} - {}", of(a), of(b)),
            Operation::Multiply(a, b) => format!("{}*{}", of(a), of(b)),
            Operation::Divide(a, b) => format!("{}/{}", of(a), of(b)),
            Operation::Negative(a) => format!("- {}", of(a)),
            Operation::SquareRoot(a) => format!("sqrt {}", of(a)),
        };
        let names = &mut composer.writer.names;
        let name = names.fresh(&format!("{}_{place}", evaluator.name));
        composer.text(format!("Definition {name} : expr := {written}.\n"));
        values.push(name);
    }
    Ok(values)
}
