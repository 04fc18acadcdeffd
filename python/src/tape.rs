//! A program operation by operation over many points: each step is a loop over a few hundred doubles.

use sextic_codegen::arithmetic::Arithmetic;
use sextic_codegen::arithmetic::doubles::{Beyond, Doubles};
use sextic_codegen::program::{Node, Operation, Program};

use crate::kernel::Blocks;
use crate::lanes::{Apply, Kind, POINTS, Points, Slot, Values, widest};

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
    operands: [Operand; 3],
    slot: usize,
}

/// A program for inputs of which some are the same at all points: what rests on these alone is computed already.
pub struct Prepared {
    steps: Vec<Step>,
    slots: Vec<Box<Slot>>,
    /// What the last step of a pass has no slot for stands here meanwhile.
    spare: Box<Slot>,
    /// Of each input, the last points, filled up.
    rest: Vec<Points>,
    outputs: Vec<Operand>,
    apply: Apply,
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
            let found = match operation {
                Operation::Input(place) => {
                    let place = *place as usize;
                    Found::Is(same[place].map_or(Operand::Input(place), Operand::One))
                }
                Operation::Constant(_) => Found::Is(Operand::One(self.constants[node.index()])),
                _ => plan.found_of(node, operation),
            };
            plan.found.push(found);
        }
        let outputs = self.program.outputs().iter();
        let outputs = outputs.map(|(_, node)| plan.operand(*node)).collect();
        Prepared {
            outputs,
            steps: plan.steps,
            slots: vec![Box::new(Slot([0.0; POINTS])); plan.slots],
            spare: Box::new(Slot([0.0; POINTS])),
            rest: vec![[0.0; POINTS]; self.program.inputs().len()],
            apply: widest(),
        }
    }
}

/// What a node of the program is, as far as it is read.
#[derive(Clone, Copy)]
enum Found {
    /// It is there.
    Is(Operand),
    /// It is a product that is taken once, by a sum or difference: one step does both.
    Product([Node; 2]),
}

/// Steps as they are put in order, and slots that later steps may take again.
struct Plan {
    found: Vec<Found>,
    /// How often each node is still to be taken.
    open: Vec<usize>,
    /// Whether a node is a product that is taken once, by a sum or difference.
    is_merged: Vec<bool>,
    steps: Vec<Step>,
    slots: usize,
    free: Vec<usize>,
}

impl Plan {
    fn of(program: &Program) -> Self {
        let mut open = vec![0; program.operations().len()];
        let mut is_merged = vec![false; open.len()];
        for (_, operation) in program.nodes() {
            let is_sum = matches!(operation, Operation::Add(..) | Operation::Subtract(..));
            for own in operation.operands() {
                open[own.index()] += 1;
                let is_product = matches!(program.operation(own), Operation::Multiply(..));
                is_merged[own.index()] = is_sum && is_product && open[own.index()] == 1;
            }
        }
        for (_, node) in program.outputs() {
            // What is given in the end is never done with.
            open[node.index()] = usize::MAX;
            is_merged[node.index()] = false;
        }
        Plan {
            found: Vec::with_capacity(open.len()),
            open,
            is_merged,
            steps: Vec::new(),
            slots: 0,
            free: Vec::new(),
        }
    }

    /// The value of an operation where that is the same at all points, else one step more.
    fn found_of(&mut self, node: Node, operation: &Operation) -> Found {
        let (kind, nodes) = kind(operation);
        let [a, b] = nodes.map(|own| self.found[own.index()]);
        if let [Found::Is(Operand::One(a)), Found::Is(Operand::One(b))] = [a, b] {
            return Found::Is(Operand::One(kind.of(a, b, 0.0)));
        }
        if self.is_merged[node.index()] {
            return Found::Product(nodes);
        }
        Found::Is(match (kind, a, b) {
            (Kind::Sum, Found::Product([a, b]), _) => {
                self.step(Kind::ProductPlus, [a, b, nodes[1]])
            }
            (Kind::Difference, Found::Product([a, b]), _) => {
                self.step(Kind::ProductMinus, [a, b, nodes[1]])
            }
            (Kind::Sum, _, Found::Product([a, b])) => {
                self.step(Kind::ProductPlus, [a, b, nodes[0]])
            }
            (Kind::Difference, _, Found::Product([a, b])) => {
                self.step(Kind::MinusProduct, [a, b, nodes[0]])
            }
            _ => self.step(kind, [nodes[0], nodes[1], nodes[1]]),
        })
    }

    /// What is there of a node; a product that waits is computed now.
    fn operand(&mut self, node: Node) -> Operand {
        match self.found[node.index()] {
            Found::Is(operand) => operand,
            Found::Product([a, b]) => {
                let operand = self.step(Kind::Product, [a, b, b]);
                self.found[node.index()] = Found::Is(operand);
                operand
            }
        }
    }

    /// One step more, into a slot that it does not read.
    fn step(&mut self, kind: Kind, nodes: [Node; 3]) -> Operand {
        let operands = nodes.map(|own| self.operand(own));
        let slot = self.free.pop().unwrap_or(self.slots);
        self.slots = self.slots.max(slot + 1);
        for (own, operand) in nodes.iter().zip(&operands).take(kind.count()) {
            let open = &mut self.open[own.index()];
            *open = open.saturating_sub(1);
            match operand {
                Operand::Slot(read) if *open == 0 => self.free.push(*read),
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

/// What an operation does with two operands; where it takes one, that stands twice.
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

/// The values of an operand.
fn values<'a>(slots: &'a [Box<Slot>], inputs: &[&'a Points], own: Operand) -> Values<'a> {
    match own {
        Operand::One(value) => Values::One(value),
        Operand::Input(place) => Values::Many(inputs[place]),
        Operand::Slot(place) => Values::Many(&slots[place].0),
    }
}

impl Prepared {
    /// All steps, and the outputs at as many points as there is room for.
    fn pass(&mut self, inputs: &[&Points], outputs: &mut [&mut [f64]], start: usize) {
        for step in &self.steps {
            // A step does not read where it writes, so that the room may be away while it runs.
            std::mem::swap(&mut self.spare, &mut self.slots[step.slot]);
            let operands = step.operands.map(|own| values(&self.slots, inputs, own));
            (self.apply)(step.kind, &mut self.spare.0, operands);
            std::mem::swap(&mut self.spare, &mut self.slots[step.slot]);
        }
        for (room, own) in outputs.iter_mut().zip(&self.outputs) {
            let end = room.len().min(start + POINTS);
            let room = &mut room[start..end];
            match values(&self.slots, inputs, *own) {
                Values::One(value) => room.fill(value),
                Values::Many(values) => room.copy_from_slice(&values[..room.len()]),
            }
        }
    }

    /// The points from `start` on, fewer than a step takes: the last of them stands in for those that lack.
    fn pass_over_rest(&mut self, inputs: &[&[f64]], outputs: &mut [&mut [f64]], start: usize) {
        let mut rest = std::mem::take(&mut self.rest);
        for (points, values) in rest.iter_mut().zip(inputs) {
            let values = &values[start..];
            points.fill(values.last().copied().unwrap_or_default());
            points[..values.len()].copy_from_slice(values);
        }
        self.pass(&rest.iter().collect::<Vec<_>>(), outputs, start);
        self.rest = rest;
    }
}

impl Blocks for Prepared {
    fn run(&mut self, inputs: &[&[f64]], outputs: &mut [&mut [f64]]) {
        let points = outputs.first().map_or(0, |own| own.len());
        let whole = points / POINTS;
        let chunks: Vec<&[Points]> = inputs.iter().map(|own| own.as_chunks().0).collect();
        let mut parts = Vec::with_capacity(inputs.len());
        for place in 0..whole {
            parts.clear();
            parts.extend(chunks.iter().map(|own| &own[place]));
            self.pass(&parts, outputs, place * POINTS);
        }
        if whole * POINTS < points {
            self.pass_over_rest(inputs, outputs, whole * POINTS);
        }
    }
}
