//! Expressions without their names: a graph of operations on variables, in which equal parts stand once.

use std::collections::BTreeSet;
use std::ops::Range;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::algebra::number::Rational;
use crate::algebra::sign::Signs;

use super::real::exact_root;
use super::{Failure, NoValue, Unknown};

/// The most nodes of a graph; what needs more is given up.
const MOST_NODES: usize = 1_000_000;

/// The most bits of a number that is computed while a graph is made.
const LONGEST_CONSTANT: usize = 4_096;

/// A node of a graph, by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(u32);

/// A variable of a graph, by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VariableId(u32);

/// A declared function of a graph, by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FunctionId(u32);

impl VariableId {
    /// The place as a number.
    pub fn number(self) -> u64 {
        u64::from(self.0)
    }
}

impl FunctionId {
    /// The place as a number.
    pub fn number(self) -> u64 {
        u64::from(self.0)
    }
}

/// What is free to have a value of its own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// Its ASCII name.
    pub name: String,
    /// How often a coordinate is differentiated by time.
    pub order: u32,
    /// What it was declared as.
    pub kind: Kind,
    /// What is declared or assumed of its sign.
    pub signs: Signs,
}

/// The sorts of variables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A real constant.
    Real,
    /// A complex constant.
    Complex,
    /// A constant angle.
    Angle,
    /// A function of time.
    Coordinate,
    /// A function of time that is an angle.
    AngularCoordinate,
}

impl Variable {
    /// Whether its sine may be taken.
    pub fn is_angular(&self) -> bool {
        self.kind == Kind::Angle || (self.kind == Kind::AngularCoordinate && self.order == 0)
    }

    /// Whether it changes with time.
    pub fn is_moving(&self) -> bool {
        matches!(self.kind, Kind::Coordinate | Kind::AngularCoordinate)
    }
}

/// An operation, on nodes that stand before it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A number.
    Number(Rational),
    /// i
    ImaginaryUnit,
    /// What is free.
    Variable(VariableId),
    /// cos v of an angular variable v.
    Cosine(VariableId),
    /// sin v of an angular variable v.
    Sine(VariableId),
    /// a + b
    Sum(NodeId, NodeId),
    /// a·b
    Product(NodeId, NodeId),
    /// a/b
    Quotient(NodeId, NodeId),
    /// aⁿ, n ≥ 2
    Power(NodeId, u32),
    /// √a ≥ 0
    Root(NodeId),
    /// The angle of (x, y): β where that is given and points as (x, y) does, else in −π < β ≤ π.
    Direction {
        /// x
        x: NodeId,
        /// y
        y: NodeId,
        /// β, of which (cos β, sin β) is a multiple of (x, y) everywhere, with cos β and sin β.
        parallel: Option<[NodeId; 3]>,
    },
    /// f⁽ᵏ⁾(a)
    Function {
        /// f
        function: FunctionId,
        /// k
        order: u32,
        /// a
        argument: NodeId,
        /// Where the bare name of f is taken; f⁽ᵏ⁾(a) does not rest on it.
        reference: NodeId,
    },
    /// A value that exists only where another one does.
    Guarded {
        /// The value.
        value: NodeId,
        /// The other one.
        needed: NodeId,
    },
    /// A value that was found by steps which it does not ask for: it may exist where one of them fails.
    Detour(NodeId),
}

impl Node {
    /// Calls a function for each node that this one rests on.
    pub fn visit(&self, visit: &mut (impl FnMut(NodeId) + ?Sized)) {
        match self {
            Node::Number(_)
            | Node::ImaginaryUnit
            | Node::Variable(_)
            | Node::Cosine(_)
            | Node::Sine(_) => {}
            Node::Sum(a, b) | Node::Product(a, b) | Node::Quotient(a, b) => {
                visit(*a);
                visit(*b);
            }
            Node::Power(a, _) | Node::Root(a) | Node::Detour(a) => visit(*a),
            Node::Direction { x, y, parallel } => {
                visit(*x);
                visit(*y);
                parallel.iter().flatten().for_each(|node| visit(*node));
            }
            Node::Function { argument, .. } => visit(*argument),
            Node::Guarded { value, needed } => {
                visit(*value);
                visit(*needed);
            }
        }
    }
}

/// What is known of a node without its value.
#[derive(Clone, Copy, Debug)]
struct Traits {
    /// Whether it has a value under every assignment.
    total: bool,
    /// Whether no value of it is anything but real.
    real: bool,
    /// Whether it rests on a root or on the angle of a vector, whose values depend on signs.
    branched: bool,
    /// Whether it rests on a detour.
    detour: bool,
    /// The signs that its values have, as far as its parts tell; any where one may not be real.
    signs: Signs,
}

/// A graph.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    traits: Vec<Traits>,
    places: FxHashMap<Node, NodeId>,
    variables: Vec<Variable>,
    functions: Vec<String>,
}

/// A node, or why there is none.
pub type Made = Result<NodeId, Failure>;

impl Graph {
    /// What a node does.
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0 as usize]
    }

    /// How many nodes there are.
    pub fn size(&self) -> usize {
        self.nodes.len()
    }

    /// The variable of a place.
    pub fn variable(&self, id: VariableId) -> &Variable {
        &self.variables[id.0 as usize]
    }

    /// The ASCII name of a function.
    pub fn function_name(&self, id: FunctionId) -> &str {
        &self.functions[id.0 as usize]
    }

    /// The place of a variable, which joins the graph if it is new.
    pub fn variable_id(&mut self, variable: Variable) -> VariableId {
        let known = self.variables.iter().position(|known| *known == variable);
        VariableId(known.unwrap_or_else(|| {
            self.variables.push(variable);
            self.variables.len() - 1
        }) as u32)
    }

    /// The place of a function, which joins the graph if it is new.
    pub fn function_id(&mut self, name: &str) -> FunctionId {
        let known = self.functions.iter().position(|known| known == name);
        FunctionId(known.unwrap_or_else(|| {
            self.functions.push(name.to_owned());
            self.functions.len() - 1
        }) as u32)
    }

    /// Whether a node has a value under every assignment.
    pub fn is_total(&self, id: NodeId) -> bool {
        self.traits[id.0 as usize].total
    }

    /// Whether every value of a node is above 0, as far as its parts tell.
    pub fn is_positive(&self, id: NodeId) -> bool {
        self.signs(id).is_positive()
    }

    /// Whether a node rests on a root or on the angle of a vector.
    pub fn is_branched(&self, id: NodeId) -> bool {
        self.traits[id.0 as usize].branched
    }

    fn traits_of(&self, node: &Node) -> Traits {
        let mut traits = Traits {
            total: true,
            real: true,
            branched: false,
            detour: matches!(node, Node::Detour(_)),
            signs: Signs::ANY,
        };
        node.visit(&mut |part| {
            let part = self.traits[part.0 as usize];
            traits.total &= part.total;
            traits.real &= part.real;
            traits.branched |= part.branched;
            traits.detour |= part.detour;
        });
        if traits.real || matches!(node, Node::Root(_)) {
            traits.signs = self.signs_of(node);
        }
        match node {
            Node::ImaginaryUnit => traits.real = false,
            Node::Variable(id) => traits.real = self.variable(*id).kind != Kind::Complex,
            Node::Quotient(_, below) => traits.total &= self.signs(*below).is_non_zero(),
            Node::Root(radicand) => {
                traits.total &= self.signs(*radicand).is_non_negative();
                (traits.real, traits.branched) = (true, true);
            }
            Node::Direction { x, y, .. } => {
                let is_seen = |part: &NodeId| self.signs(*part).is_non_zero();
                traits.total &= traits.real && (is_seen(x) || is_seen(y));
                (traits.real, traits.branched) = (true, true);
            }
            Node::Function { .. } => {
                (traits.total, traits.real) = (traits.total && traits.real, true)
            }
            _ => {}
        }
        traits
    }

    /// The signs that a real node can have, as far as its parts tell.
    fn signs_of(&self, node: &Node) -> Signs {
        let of = |part: &NodeId| self.traits[part.0 as usize].signs;
        match node {
            Node::Number(number) => Signs::of_integer(number.numerator()),
            Node::Variable(id) => self.variable(*id).signs,
            Node::Sum(a, b) => of(a).sum(of(b)),
            // A quotient has a value where its divisor is not 0.
            Node::Product(a, b) | Node::Quotient(a, b) => of(a).product(of(b)),
            Node::Power(a, exponent) => of(a).power(*exponent),
            Node::Root(a) => match of(a) {
                Signs::POSITIVE => Signs::POSITIVE,
                _ => Signs::NON_NEGATIVE,
            },
            Node::Guarded { value, .. } | Node::Detour(value) => of(value),
            _ => Signs::ANY,
        }
    }

    /// The place of a node, which joins the graph if it is new.
    fn join(&mut self, node: Node) -> Made {
        if let Some(known) = self.places.get(&node) {
            return Ok(*known);
        }
        if self.nodes.len() >= MOST_NODES {
            return Err(Unknown::TooLarge.into());
        }
        let id = NodeId(self.nodes.len() as u32);
        self.traits.push(self.traits_of(&node));
        self.nodes.push(node.clone());
        self.places.insert(node, id);
        Ok(id)
    }

    /// The number that a node is, if it is one.
    pub fn as_number(&self, id: NodeId) -> Option<&Rational> {
        match self.node(id) {
            Node::Number(number) => Some(number),
            _ => None,
        }
    }

    fn signs(&self, id: NodeId) -> Signs {
        self.traits[id.0 as usize].signs
    }

    fn is(&self, id: NodeId, number: i32) -> bool {
        self.as_number(id)
            .is_some_and(|own| *own == Rational::from(number))
    }

    /// Whether a node is the number 0.
    pub fn is_zero(&self, id: NodeId) -> bool {
        self.as_number(id).is_some_and(Rational::is_zero)
    }

    /// A number.
    pub fn number(&mut self, number: Rational) -> Made {
        self.join(Node::Number(number))
    }

    /// A whole number.
    pub fn integer(&mut self, number: i64) -> Made {
        self.number(Rational::from(number))
    }

    /// i
    pub fn imaginary_unit(&mut self) -> Made {
        self.join(Node::ImaginaryUnit)
    }

    /// A variable.
    pub fn free(&mut self, id: VariableId) -> Made {
        self.join(Node::Variable(id))
    }

    /// cos v
    pub fn cosine(&mut self, id: VariableId) -> Made {
        self.join(Node::Cosine(id))
    }

    /// sin v
    pub fn sine(&mut self, id: VariableId) -> Made {
        self.join(Node::Sine(id))
    }

    /// Both numbers, if both nodes are numbers that are short enough to compute with.
    fn numbers(&self, a: NodeId, b: NodeId) -> Option<(&Rational, &Rational)> {
        use dashu_base::BitTest;
        let short = |number: &&Rational| {
            number.numerator().bit_len() + number.denominator().bit_len() <= LONGEST_CONSTANT
        };
        let (a, b) = (self.as_number(a)?, self.as_number(b)?);
        (short(&a) && short(&b)).then_some((a, b))
    }

    /// a + b
    pub fn sum(&mut self, a: NodeId, b: NodeId) -> Made {
        if let Some((a, b)) = self.numbers(a, b) {
            let sum = a + b;
            return self.number(sum);
        }
        match (self.is_zero(a), self.is_zero(b)) {
            (true, _) => Ok(b),
            (_, true) => Ok(a),
            _ => self.join(Node::Sum(a.min(b), a.max(b))),
        }
    }

    /// −a
    pub fn negative(&mut self, a: NodeId) -> Made {
        let minus = self.integer(-1)?;
        self.product(minus, a)
    }

    /// a − b
    pub fn difference(&mut self, a: NodeId, b: NodeId) -> Made {
        if a == b && self.is_total(a) {
            return self.integer(0);
        }
        let negative = self.negative(b)?;
        self.sum(a, negative)
    }

    /// a·b; a factor 0 takes only those with it that have a value everywhere.
    pub fn product(&mut self, a: NodeId, b: NodeId) -> Made {
        if let Some((a, b)) = self.numbers(a, b) {
            let product = a * b;
            return self.number(product);
        }
        for (one, other) in [(a, b), (b, a)] {
            if self.is(one, 1) {
                return Ok(other);
            }
            if self.is_zero(one) && self.is_total(other) {
                return Ok(one);
            }
            // k·(l·c) = (k l)·c
            if let (Some(k), Node::Product(l, c)) = (self.as_number(one), self.node(other))
                && let Some(l) = self.as_number(*l)
            {
                let (factor, c) = (k * l, *c);
                let factor = self.number(factor)?;
                return self.product(factor, c);
            }
        }
        match self.as_number(b) {
            Some(_) => self.join(Node::Product(b, a)),
            None if self.as_number(a).is_some() => self.join(Node::Product(a, b)),
            None => self.join(Node::Product(a.min(b), a.max(b))),
        }
    }

    /// k·a
    pub fn scaled(&mut self, a: NodeId, factor: Rational) -> Made {
        let factor = self.number(factor)?;
        self.product(factor, a)
    }

    /// a/b
    pub fn quotient(&mut self, a: NodeId, b: NodeId) -> Made {
        match self.as_number(b) {
            Some(number) if number.is_zero() => Err(NoValue::DivisionByZero.into()),
            Some(number) => {
                let inverse = Rational::ONE / number;
                self.scaled(a, inverse)
            }
            None => self.join(Node::Quotient(a, b)),
        }
    }

    /// aⁿ; for a negative n the power of 1/a.
    pub fn power(&mut self, a: NodeId, exponent: i64) -> Made {
        let size =
            u32::try_from(exponent.unsigned_abs()).map_err(|_| Failure::from(Unknown::TooLarge))?;
        if exponent < 0 {
            let one = self.integer(1)?;
            let power = self.power(a, i64::from(size))?;
            return self.quotient(one, power);
        }
        match size {
            0 => {
                let one = self.integer(1)?;
                self.guarded(one, a)
            }
            1 => Ok(a),
            _ => {
                use dashu_base::BitTest;
                let bits = |number: &Rational| {
                    number.numerator().bit_len() + number.denominator().bit_len()
                };
                match self.as_number(a) {
                    Some(base) if bits(base) * size as usize <= LONGEST_CONSTANT => {
                        let power = base.pow(size as isize);
                        self.number(power)
                    }
                    _ => self.join(Node::Power(a, size)),
                }
            }
        }
    }

    /// √a
    pub fn root(&mut self, a: NodeId) -> Made {
        match self.as_number(a) {
            Some(number) if *number < Rational::ZERO => Err(NoValue::NegativeRadicand.into()),
            Some(number) => match exact_root(number) {
                Some(root) => self.number(root),
                None => self.join(Node::Root(a)),
            },
            None => match *self.node(a) {
                Node::Power(base, n) if n % 2 == 0 && self.signs(base).is_non_negative() => {
                    self.power(base, i64::from(n / 2))
                }
                Node::Power(base, n) if n % 2 == 0 && self.signs(base) == Signs::NEGATIVE => {
                    let size = self.negative(base)?;
                    self.power(size, i64::from(n / 2))
                }
                _ => self.join(Node::Root(a)),
            },
        }
    }

    /// The angle of (x, y), with the angle that it is a multiple of, if there is one.
    pub fn angle_of(&mut self, x: NodeId, y: NodeId, parallel: Option<[NodeId; 3]>) -> Made {
        if self.is_zero(x) && self.is_zero(y) {
            return Err(NoValue::ZeroVector.into());
        }
        self.join(Node::Direction { x, y, parallel })
    }

    /// f⁽ᵏ⁾(a)
    pub fn function(
        &mut self,
        function: FunctionId,
        order: u32,
        argument: NodeId,
        reference: NodeId,
    ) -> Made {
        self.join(Node::Function {
            function,
            order,
            argument,
            reference,
        })
    }

    /// A value that exists only where another one does.
    pub fn guarded(&mut self, value: NodeId, needed: NodeId) -> Made {
        match value == needed || self.is_total(needed) {
            true => Ok(value),
            false => self.join(Node::Guarded { value, needed }),
        }
    }

    /// A value that may exist where a step by which it was found fails.
    pub fn by_detour(&mut self, value: NodeId) -> Made {
        match self.is_total(value) {
            true => Ok(value),
            false => self.join(Node::Detour(value)),
        }
    }

    /// What it tells of a node that a part of it, or the image of one, has no value.
    pub fn failure_within(&self, id: NodeId, failure: Failure) -> Failure {
        match self.traits[id.0 as usize].detour {
            true => failure.of_detour(),
            false => failure,
        }
    }

    /// Forgets the nodes from a place on; no node before it rests on them.
    pub fn truncate(&mut self, size: usize) {
        for node in self.nodes.drain(size..) {
            self.places.remove(&node);
        }
        self.traits.truncate(size);
    }

    /// The nodes that some nodes rest on, and these, each behind those that it rests on.
    pub fn below(&self, roots: &[NodeId]) -> Vec<NodeId> {
        self.reached(roots, |_| false, |node, part| node.visit(part))
    }

    /// The nodes that one rests on, and it, each behind those that it rests on, without the known ones and
    /// what only these rest on.
    pub fn unknown(&self, root: NodeId, is_known: impl Fn(NodeId) -> bool) -> Vec<NodeId> {
        self.reached(&[root], is_known, |node, part| node.visit(part))
    }

    /// The same, with the places of the bare names of functions, which tell how a value is called.
    pub fn unknown_values(&self, root: NodeId, is_known: impl Fn(NodeId) -> bool) -> Vec<NodeId> {
        self.reached(&[root], is_known, |node, part| {
            node.visit(part);
            if let Node::Function { reference, .. } = node {
                part(*reference);
            }
        })
    }

    /// The nodes that the values of some nodes are made of, and these: without what need only exist.
    pub fn within(&self, roots: &[NodeId]) -> Vec<NodeId> {
        let parts = |node: &Node, part: &mut dyn FnMut(NodeId)| match node {
            Node::Guarded { value, .. } => part(*value),
            node => node.visit(part),
        };
        self.reached(roots, |_| false, parts)
    }

    /// The nodes that are not known and reached from some nodes by way of some of their parts, each behind
    /// those that it rests on.
    fn reached(
        &self,
        roots: &[NodeId],
        is_known: impl Fn(NodeId) -> bool,
        parts: impl Fn(&Node, &mut dyn FnMut(NodeId)),
    ) -> Vec<NodeId> {
        let mut open = roots.to_vec();
        let mut found = FxHashSet::default();
        while let Some(id) = open.pop() {
            if !is_known(id) && found.insert(id) {
                parts(self.node(id), &mut |part| open.push(part));
            }
        }
        // A node has a higher number than those that it rests on.
        let mut found: Vec<NodeId> = found.into_iter().collect();
        found.sort_unstable();
        found
    }

    /// The variables that some nodes rest on.
    pub fn variables_of(&self, roots: &[NodeId]) -> BTreeSet<VariableId> {
        let nodes = self.below(roots).into_iter();
        let variables = nodes.filter_map(|id| match self.node(id) {
            Node::Variable(id) | Node::Cosine(id) | Node::Sine(id) => Some(*id),
            _ => None,
        });
        variables.collect()
    }

    /// The nodes of some places.
    pub fn ids(range: Range<usize>) -> impl Iterator<Item = NodeId> {
        range.map(|place| NodeId(place as u32))
    }

    /// The place of a node as a number.
    pub fn place(id: NodeId) -> usize {
        id.0 as usize
    }
}
