//! What a program is run in.

pub mod doubles;
pub mod pairs;
pub mod rationals;

use crate::program::{Node, Operation, Program, Rational};

/// Numbers, or whatever else operations have a meaning for: doubles, enclosures, exact numbers, residues,
/// elements of a ring, operations of another program.
pub trait Arithmetic {
    /// A value.
    type Value: Clone;
    /// Why there is none.
    type Error;

    /// A number.
    ///
    /// # Errors
    ///
    /// Where it is none of these values.
    fn constant(&mut self, value: &Rational) -> Result<Self::Value, Self::Error>;

    /// −a
    ///
    /// # Errors
    ///
    /// Those of [`Arithmetic::sum`].
    fn negative(&mut self, a: &Self::Value) -> Result<Self::Value, Self::Error>;

    /// a + b
    ///
    /// # Errors
    ///
    /// Where there is no such value, or it would cost more than is allowed.
    fn sum(&mut self, a: &Self::Value, b: &Self::Value) -> Result<Self::Value, Self::Error>;

    /// a − b
    ///
    /// # Errors
    ///
    /// Those of [`Arithmetic::sum`].
    fn difference(&mut self, a: &Self::Value, b: &Self::Value) -> Result<Self::Value, Self::Error>;

    /// a·b
    ///
    /// # Errors
    ///
    /// Those of [`Arithmetic::sum`].
    fn product(&mut self, a: &Self::Value, b: &Self::Value) -> Result<Self::Value, Self::Error>;

    /// a/b
    ///
    /// # Errors
    ///
    /// Those of [`Arithmetic::sum`], where b is 0 among them.
    fn quotient(&mut self, a: &Self::Value, b: &Self::Value) -> Result<Self::Value, Self::Error>;

    /// √a
    ///
    /// # Errors
    ///
    /// Those of [`Arithmetic::sum`], where a is negative among them.
    fn square_root(&mut self, a: &Self::Value) -> Result<Self::Value, Self::Error>;
}

impl Program {
    /// The values of the outputs, in order, for values of the inputs, in order.
    ///
    /// Complexity: one operation of the arithmetic for each of the program, and a copy of each output.
    ///
    /// # Errors
    ///
    /// The first error of the arithmetic.
    ///
    /// # Panics
    ///
    /// If there are fewer values than inputs.
    ///
    /// ```
    /// use sextic_codegen::arithmetic::Arithmetic;
    /// use sextic_codegen::program::{Operation, Program, Rational};
    ///
    /// /// Whole numbers of which only the last digit is kept.
    /// struct LastDigit;
    ///
    /// impl Arithmetic for LastDigit {
    ///     type Value = i64;
    ///     type Error = &'static str;
    ///     fn constant(&mut self, value: &Rational) -> Result<i64, &'static str> {
    ///         i64::try_from(value.clone()).map(|own| own.rem_euclid(10)).map_err(|_| "no whole number")
    ///     }
    ///     fn negative(&mut self, a: &i64) -> Result<i64, &'static str> { Ok((10 - a) % 10) }
    ///     fn sum(&mut self, a: &i64, b: &i64) -> Result<i64, &'static str> { Ok((a + b) % 10) }
    ///     fn difference(&mut self, a: &i64, b: &i64) -> Result<i64, &'static str> { Ok((10 + a - b) % 10) }
    ///     fn product(&mut self, a: &i64, b: &i64) -> Result<i64, &'static str> { Ok(a * b % 10) }
    ///     fn quotient(&mut self, _: &i64, _: &i64) -> Result<i64, &'static str> { Err("no quotients") }
    ///     fn square_root(&mut self, _: &i64) -> Result<i64, &'static str> { Err("no roots") }
    /// }
    ///
    /// let mut program = Program::new(["a".to_string()]);
    /// let a = program.input("a").unwrap();
    /// let square = program.push(Operation::Multiply(a, a));
    /// program.output("square", square);
    /// assert_eq!(program.run(&mut LastDigit, &[17]), Ok(vec![9]));
    /// ```
    pub fn run<A: Arithmetic>(
        &self,
        arithmetic: &mut A,
        inputs: &[A::Value],
    ) -> Result<Vec<A::Value>, A::Error> {
        self.prepare(arithmetic)?.run(arithmetic, inputs)
    }

    /// The program with its constants as values, to be run at many points.
    ///
    /// # Errors
    ///
    /// The first error of a constant.
    pub fn prepare<A: Arithmetic>(
        &self,
        arithmetic: &mut A,
    ) -> Result<Prepared<'_, A::Value>, A::Error> {
        let constants = self.operations().iter().filter_map(|operation| {
            let Operation::Constant(value) = operation else {
                return None;
            };
            Some(arithmetic.constant(value))
        });
        Ok(Prepared {
            constants: constants.collect::<Result<_, _>>()?,
            program: self,
        })
    }
}

/// A program whose constants are values of an arithmetic: a number is converted once, and not at each
/// point.
#[derive(Clone, Debug)]
pub struct Prepared<'p, V> {
    program: &'p Program,
    /// In the order of the operations.
    constants: Vec<V>,
}

impl<V: Clone> Prepared<'_, V> {
    /// The values of the outputs, as [`Program::run`] gives them in the same arithmetic.
    ///
    /// # Errors
    ///
    /// The first error of an operation.
    ///
    /// # Panics
    ///
    /// If there are fewer values than inputs.
    pub fn run<A: Arithmetic<Value = V>>(
        &self,
        arithmetic: &mut A,
        inputs: &[V],
    ) -> Result<Vec<V>, A::Error> {
        let operations = self.program.operations();
        let mut values: Vec<V> = Vec::with_capacity(operations.len());
        let mut constants = self.constants.iter();
        for operation in operations {
            let of = |node: &Node| &values[node.index()];
            let value = match operation {
                Operation::Input(place) => inputs[*place as usize].clone(),
                Operation::Constant(_) => constants.next().expect("prepared").clone(),
                Operation::Negative(a) => arithmetic.negative(of(a))?,
                Operation::Add(a, b) => arithmetic.sum(of(a), of(b))?,
                Operation::Subtract(a, b) => arithmetic.difference(of(a), of(b))?,
                Operation::Multiply(a, b) => arithmetic.product(of(a), of(b))?,
                Operation::Divide(a, b) => arithmetic.quotient(of(a), of(b))?,
                Operation::SquareRoot(a) => arithmetic.square_root(of(a))?,
            };
            values.push(value);
        }
        let outputs = self.program.outputs().iter();
        Ok(outputs
            .map(|(_, node)| values[node.index()].clone())
            .collect())
    }
}
