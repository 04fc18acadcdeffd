//! Expressions that are made, and not read.

use crate::algebra::number::Rational;

use super::syntax::{BinaryOperator, Expression, Name, Node, Place};

impl Expression {
    /// An expression that stands in no document.
    pub fn made(node: Node) -> Self {
        Expression { node, span: 0..0 }
    }

    /// A number.
    pub fn number(number: Rational) -> Self {
        if number < Rational::ZERO {
            let size = Expression::number(-number);
            return Expression::made(Node::Negative(Box::new(size)));
        }
        if number.is_int() {
            return Expression::made(Node::Number(number));
        }
        let (above, below) = number.into_parts();
        let above = Expression::made(Node::Number(Rational::from(above)));
        let below = Expression::made(Node::Number(Rational::from(below)));
        Expression::binary(BinaryOperator::Divide, above, below)
    }

    /// A name.
    pub fn name(name: Name) -> Self {
        Expression::made(Node::Name(name))
    }

    /// Two expressions with an operator between them.
    pub fn binary(operator: BinaryOperator, left: Expression, right: Expression) -> Self {
        Expression::made(Node::Binary(operator, Box::new(left), Box::new(right)))
    }

    /// A call.
    pub fn call(function: Name, order: u32, arguments: Vec<Expression>) -> Self {
        Expression::made(Node::Call {
            function,
            order,
            arguments,
        })
    }

    /// The same expression after replacements, at its place in the document.
    #[must_use]
    pub fn at(self, place: Place) -> Self {
        let span = self.span.clone();
        Expression {
            node: Node::At(Box::new(self), place),
            span,
        }
    }

    /// A number itself, and `M[1, 1]`, `M[1, 2]`, … of a matrix of this shape.
    pub fn entries(&self, (rows, columns): (usize, usize)) -> Vec<Expression> {
        if (rows, columns) == (1, 1) {
            return vec![self.clone()];
        }
        let places = (1..=rows).flat_map(|row| (1..=columns).map(move |column| [row, column]));
        let entry = |place: [usize; 2]| {
            let indices = place.map(|own| Expression::number(own.into()));
            Expression::made(Node::Index(Box::new(self.clone()), indices.into()))
        };
        places.map(entry).collect()
    }
}
