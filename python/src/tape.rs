//! A program operation by operation over many points: each step is a loop over a few hundred doubles.

use sextic_codegen::arithmetic::Arithmetic;
use sextic_codegen::arithmetic::doubles::{Beyond, Doubles};
use sextic_codegen::program::{Node, Operation, Program};

use crate::kernel::Blocks;
use crate::lanes::{Kind, Values, widest};

/// How many points a step takes: what a program remembers of them stays in the cache next to the processor.
const POINTS: usize = 128;

/// A program with its constants in doubles.
pub struct Tape {
    program: Program,
    /// By the places of their operations.
    constants: Vec<f64>,
}

/// What a step takes.
#[derive(Clone, Copy)]
enum Operand {
    /// What is the same at all points.
    One(f64),
    /// An input of the program.
    Input(usize),
    /// What an earlier step has left.
    Slot(usize),
}

/// An operation at all points of a block.
struct Step {
    kind: Kind,
    operands: [Operand; 2],
    slot: usize,
}

/// A program for inputs of which some are the same at all points: what rests on these alone is computed already.
pub struct Prepared {
    steps: Vec<Step>,
    slots: Vec<Vec<f64>>,
    outputs: Vec<Operand>,
}

impl Tape {
    /// A program.
    ///
    /// # Errors
    ///
    /// If a constant is beyond the doubles.
    pub fn of(program: &Program) -> Result<Self, Beyond> {
        let constant = |own: &Operation| match own {
            Operation::Constant(value) => Doubles.constant(value),
            _ => Ok(0.0),
        };
        let constants = program.operations().iter().map(constant);
        Ok(Tape {
            constants: constants.collect::<Result<_, _>>()?,
            program: program.clone(),
        })
    }

    /// The program for inputs of which some are the same at all points.
    pub fn prepared(&self, same: &[Option<f64>]) -> Prepared {
        let mut plan = Plan::of(&self.program);
        for (node, operation) in self.program.nodes() {
            let operand = match operation {
                Operation::Input(place) => {
                    let place = *place as usize;
                    same[place].map_or(Operand::Input(place), Operand::One)
                }
                Operation::Constant(_) => Operand::One(self.constants[node.index()]),
                _ => plan.step(node, operation),
            };
            plan.found.push(operand);
        }
        let outputs = self.program.outputs().iter();
        Prepared {
            outputs: outputs.map(|(_, node)| plan.found[node.index()]).collect(),
            steps: plan.steps,
            slots: vec![vec![0.0; POINTS]; plan.slots],
        }
    }
}

/// Steps as they are put in order, and slots that later steps may take again.
struct Plan {
    /// What each node of the program is, as far as it is read.
    found: Vec<Operand>,
    /// The place of the last operation that takes each node; beyond all for outputs.
    last: Vec<usize>,
    steps: Vec<Step>,
    slots: usize,
    free: Vec<usize>,
}

impl Plan {
    fn of(program: &Program) -> Self {
        let mut last = vec![0; program.operations().len()];
        for (node, operation) in program.nodes() {
            operation
                .operands()
                .for_each(|own| last[own.index()] = node.index());
        }
        let outputs = program.outputs().iter();
        outputs.for_each(|(_, node)| last[node.index()] = usize::MAX);
        Plan {
            found: Vec::with_capacity(last.len()),
            last,
            steps: Vec::new(),
            slots: 0,
            free: Vec::new(),
        }
    }

    /// An operation on what was found: its value where that is the same at all points, else one step more.
    fn step(&mut self, node: Node, operation: &Operation) -> Operand {
        let (kind, nodes) = kind(operation);
        let operands = nodes.map(|own| self.found[own.index()]);
        if let [Operand::One(a), Operand::One(b)] = operands {
            return Operand::One(kind.of(a, b));
        }
        // No slot that is read is written to in one step.
        let slot = self.free.pop().unwrap_or(self.slots);
        self.slots = self.slots.max(slot + 1);
        for (place, own) in nodes.iter().enumerate() {
            let is_first = place == 0 || nodes[0] != nodes[1];
            match operands[place] {
                Operand::Slot(read) if is_first && self.last[own.index()] == node.index() => {
                    self.free.push(read);
                }
                _ => {}
            }
        }
        self.steps.push(Step {
            kind,
            operands,
            slot,
        });
        Operand::Slot(slot)
    }
}

/// What an operation does with two operands; with one, that stands twice.
fn kind(operation: &Operation) -> (Kind, [Node; 2]) {
    match *operation {
        Operation::Add(a, b) => (Kind::Sum, [a, b]),
        Operation::Subtract(a, b) => (Kind::Difference, [a, b]),
        Operation::Multiply(a, b) => (Kind::Product, [a, b]),
        Operation::Divide(a, b) => (Kind::Quotient, [a, b]),
        Operation::Negative(a) => (Kind::Negative, [a, a]),
        Operation::SquareRoot(a) => (Kind::Root, [a, a]),
        Operation::Input(_) | Operation::Constant(_) => unreachable!("they take nothing"),
    }
}

impl Prepared {
    /// The values of an operand at some points.
    fn values<'a>(slots: &'a [Vec<f64>], inputs: &[&'a [f64]], own: Operand) -> Values<'a> {
        match own {
            Operand::One(value) => Values::One(value),
            Operand::Input(place) => Values::Many(inputs[place]),
            Operand::Slot(place) => Values::Many(&slots[place]),
        }
    }

    /// All steps for as many points as there are values of each input, [`POINTS`] at most.
    fn steps(&mut self, inputs: &[&[f64]], points: usize) {
        let apply = widest();
        for step in &self.steps {
            let mut room = std::mem::take(&mut self.slots[step.slot]);
            let operands = step
                .operands
                .map(|own| Self::values(&self.slots, inputs, own));
            apply(step.kind, &mut room[..points], operands);
            self.slots[step.slot] = room;
        }
    }
}

impl Blocks for Prepared {
    fn run(&mut self, inputs: &[&[f64]], outputs: &mut [&mut [f64]]) {
        let points = outputs.first().map_or(0, |own| own.len());
        let mut start = 0;
        while start < points {
            let end = points.min(start + POINTS);
            let parts: Vec<&[f64]> = inputs.iter().map(|own| &own[start..end]).collect();
            self.steps(&parts, end - start);
            for (room, own) in outputs.iter_mut().zip(&self.outputs) {
                let room = &mut room[start..end];
                match Self::values(&self.slots, &parts, *own) {
                    Values::One(value) => room.fill(value),
                    Values::Many(values) => room.copy_from_slice(&values[..end - start]),
                }
            }
            start = end;
        }
    }
}
