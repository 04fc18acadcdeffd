//! Straight-line programs: named inputs, operations, named outputs.

use dashu_base::{PowerOfTwo, UnsignedAbs};
use dashu_ratio::RBig;

/// An exact constant.
pub type Rational = RBig;

/// Whether a number is a power of two, up to its sign.
pub fn is_power_of_two(value: &Rational) -> bool {
    let (above, below) = value.clone().into_parts();
    above.unsigned_abs().is_power_of_two() && below.is_power_of_two()
}

/// A value of a program, by the place of the operation that computes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Node(u32);

impl Node {
    /// The place of its operation.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// One step; its operands are values of earlier steps.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Operation {
    /// The input of this place.
    Input(u32),
    /// An exact number.
    Constant(Rational),
    /// a + b
    Add(Node, Node),
    /// a − b
    Subtract(Node, Node),
    /// a·b
    Multiply(Node, Node),
    /// a/b
    Divide(Node, Node),
    /// −a
    Negative(Node),
    /// √a
    SquareRoot(Node),
}

impl Operation {
    /// The values that it takes.
    pub fn operands(&self) -> impl Iterator<Item = Node> {
        let (first, second) = match *self {
            Operation::Input(_) | Operation::Constant(_) => (None, None),
            Operation::Negative(a) | Operation::SquareRoot(a) => (Some(a), None),
            Operation::Add(a, b)
            | Operation::Subtract(a, b)
            | Operation::Multiply(a, b)
            | Operation::Divide(a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }

    /// The same step on other values.
    #[must_use]
    pub fn map(&self, mut image: impl FnMut(Node) -> Node) -> Self {
        match self {
            Operation::Input(_) | Operation::Constant(_) => self.clone(),
            Operation::Negative(a) => Operation::Negative(image(*a)),
            Operation::SquareRoot(a) => Operation::SquareRoot(image(*a)),
            Operation::Add(a, b) => Operation::Add(image(*a), image(*b)),
            Operation::Subtract(a, b) => Operation::Subtract(image(*a), image(*b)),
            Operation::Multiply(a, b) => Operation::Multiply(image(*a), image(*b)),
            Operation::Divide(a, b) => Operation::Divide(image(*a), image(*b)),
        }
    }
}

/// A straight-line program; every operation stands behind those whose values it takes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Program {
    inputs: Vec<String>,
    operations: Vec<Operation>,
    outputs: Vec<(String, Node)>,
}

impl Program {
    /// A program that does nothing with these inputs, whose values are its first nodes.
    pub fn new(inputs: impl IntoIterator<Item = String>) -> Self {
        let inputs: Vec<String> = inputs.into_iter().collect();
        let operations = (0..inputs.len() as u32).map(Operation::Input).collect();
        Program {
            inputs,
            operations,
            outputs: Vec::new(),
        }
    }

    /// The names of the inputs.
    pub fn inputs(&self) -> &[String] {
        &self.inputs
    }

    /// The value of an input.
    pub fn input(&self, name: &str) -> Option<Node> {
        let place = self.inputs.iter().position(|known| known == name)?;
        Some(Node(place as u32))
    }

    /// The operations in order; the first ones give the inputs, unless some were added later.
    pub fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// The operation that computes a value.
    pub fn operation(&self, node: Node) -> &Operation {
        &self.operations[node.index()]
    }

    /// The values in order.
    pub fn nodes(&self) -> impl Iterator<Item = (Node, &Operation)> {
        (0..).map(Node).zip(&self.operations)
    }

    /// The names and values of the outputs.
    pub fn outputs(&self) -> &[(String, Node)] {
        &self.outputs
    }

    /// Appends an operation on values of this program.
    ///
    /// # Panics
    ///
    /// If an operand is not a value of this program yet.
    pub fn push(&mut self, operation: Operation) -> Node {
        assert!(
            operation
                .operands()
                .all(|node| node.index() < self.operations.len()),
            "an operand comes before its operation"
        );
        self.operations.push(operation);
        Node(self.operations.len() as u32 - 1)
    }

    /// Appends an input.
    pub fn add_input(&mut self, name: impl Into<String>) -> Node {
        self.inputs.push(name.into());
        self.push(Operation::Input(self.inputs.len() as u32 - 1))
    }

    /// The program with its inputs as the first operations, those of these names in this order before
    /// all others.
    #[must_use]
    pub fn with_inputs_first(&self, order: &[&str]) -> Program {
        let mut places: Vec<usize> = (0..self.inputs.len()).collect();
        let rank = |name: &str| order.iter().position(|known| *known == name);
        places.sort_by_key(|place| rank(&self.inputs[*place]).unwrap_or(order.len()));
        let mut arranged = Program::new(places.iter().map(|place| self.inputs[*place].clone()));
        let mut moved = vec![Node(0); places.len()];
        for (new, old) in places.into_iter().enumerate() {
            moved[old] = Node(new as u32);
        }
        let mut images: Vec<Node> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            images.push(match operation {
                Operation::Input(place) => moved[*place as usize],
                _ => arranged.push(operation.map(|operand| images[operand.index()])),
            });
        }
        for (name, node) in &self.outputs {
            arranged.output(name.clone(), images[node.index()]);
        }
        arranged
    }

    /// The program without the inputs that nothing rests on.
    #[must_use]
    pub fn without_idle_inputs(&self) -> Program {
        let mut is_used = vec![false; self.operations.len()];
        let operands = self.operations.iter().flat_map(Operation::operands);
        for node in operands.chain(self.outputs.iter().map(|(_, node)| *node)) {
            is_used[node.index()] = true;
        }
        let mut busy = Program::default();
        let mut images: Vec<Node> = Vec::with_capacity(self.operations.len());
        for (node, operation) in self.nodes() {
            images.push(match operation {
                Operation::Input(place) if is_used[node.index()] => {
                    busy.add_input(self.inputs[*place as usize].clone())
                }
                // Nobody asks for its image.
                Operation::Input(_) => node,
                _ => busy.push(operation.map(|operand| images[operand.index()])),
            });
        }
        for (name, node) in &self.outputs {
            busy.output(name.clone(), images[node.index()]);
        }
        busy
    }

    /// Appends a constant.
    pub fn constant(&mut self, value: Rational) -> Node {
        self.push(Operation::Constant(value))
    }

    /// Names a value as an output.
    pub fn output(&mut self, name: impl Into<String>, node: Node) {
        self.outputs.push((name.into(), node));
    }

    /// Rebuilds the program operation by operation: `step` is given the new program, the operation with
    /// its operands already in it, and gives the value that replaces it.
    #[must_use]
    pub fn rebuild(&self, mut step: impl FnMut(&mut Program, Node, Operation) -> Node) -> Program {
        let mut program = Program::new(self.inputs.iter().cloned());
        let mut images: Vec<Node> = Vec::with_capacity(self.operations.len());
        for (node, operation) in self.nodes() {
            let image = match operation {
                Operation::Input(place) => Node(*place),
                _ => {
                    let moved = operation.map(|operand| images[operand.index()]);
                    step(&mut program, node, moved)
                }
            };
            images.push(image);
        }
        for (name, node) in &self.outputs {
            program.output(name.clone(), images[node.index()]);
        }
        program
    }
}
