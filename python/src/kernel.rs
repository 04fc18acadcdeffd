//! An evaluator as Python calls it: what is asked for, and what is computed of many points at once.

use sextic_evaluators::bounded::Bounded;

/// What is asked for, or given.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Its name in the program: ASCII.
    pub name: String,
    /// What it is, and its unit.
    pub text: String,
}

impl Quantity {
    /// A quantity, and what it is.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        Quantity {
            name: name.into(),
            text: text.into(),
        }
    }
}

/// A number that is made of those that are asked for.
pub type Maker = Box<dyn Fn(&[f64]) -> f64 + Send + Sync>;

/// Where an input of the program comes from.
pub enum Source {
    /// From what is asked for, by its place.
    Given(usize),
    /// It is made of what has these places: the cosine of a sum of angles, say.
    Made(Vec<usize>, Maker),
    /// It is the same at every point.
    Fixed(f64),
}

/// What is computed at each point.
pub trait Kernel: Send + Sync {
    /// Its name.
    fn name(&self) -> &str;

    /// What it computes, in which conditions, and how it is proven.
    fn text(&self) -> String;

    /// What a caller gives: inputs, and angles rather than their sines and cosines.
    fn asked(&self) -> Vec<Quantity>;

    /// What it gives.
    fn outputs(&self) -> Vec<Quantity>;

    /// The inputs of the program, in order.
    fn sources(&self) -> Vec<Source>;

    /// What computes many points, where some inputs are the same at all of them.
    fn prepared<'k>(&'k self, same: &[Option<f64>]) -> Box<dyn Blocks + 'k>;

    /// The outputs at one point, each with a bound of its rounding.
    fn bounded(&self, inputs: &[f64]) -> Vec<Bounded>;
}

/// An evaluator that is ready for many points.
pub trait Blocks {
    /// The outputs at all points of slices of one length, one for each input and output.
    fn run(&mut self, inputs: &[&[f64]], outputs: &mut [&mut [f64]]);
}
