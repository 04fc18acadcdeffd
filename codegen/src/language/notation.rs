//! How a language writes an operation, and what is written so.

use super::literal::Decimal;

/// How tightly the outermost sign of a text binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Binding {
    /// a + b, a − b
    Sum,
    /// a·b, a/b
    Product,
    /// −a
    Sign,
    /// A name, a literal, a call.
    Atom,
}

/// A printed value.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// What is printed.
    pub text: String,
    /// How tightly it binds.
    pub binding: Binding,
    /// The number, if it is a literal.
    pub decimal: Option<Decimal>,
}

impl Text {
    /// A printed value that is no literal.
    pub fn new(text: impl Into<String>, binding: Binding) -> Self {
        Text {
            text: text.into(),
            binding,
            decimal: None,
        }
    }

    /// In parentheses, if it binds less than that.
    pub fn at_least(&self, binding: Binding) -> String {
        match self.binding < binding {
            true => format!("({})", self.text),
            false => self.text.clone(),
        }
    }
}

/// An operation of two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// a + b
    Add,
    /// a − b
    Subtract,
    /// a·b
    Multiply,
    /// a/b
    Divide,
}

/// A product to which something is added: ±a·b ± c.
#[derive(Clone, Copy, Debug)]
pub struct Fused<'a> {
    /// a and b
    pub factors: (&'a Text, &'a Text),
    /// Whether the product is subtracted.
    pub negative_product: bool,
    /// c
    pub addend: &'a Text,
    /// Whether c is subtracted.
    pub negative_addend: bool,
}

/// How a language writes operations.
pub trait Notation {
    /// How long a text may become before its parts get names.
    const WIDTH: usize;
    /// Whether a product and a sum are written as one.
    const FUSES: bool = false;

    /// A literal where no operation says how to write it.
    fn literal(&self, decimal: &Decimal) -> Text;
    /// An operation of two values.
    fn binary(&self, sign: Sign, left: &Text, right: &Text) -> Text;
    /// −a
    fn negative(&self, operand: &Text) -> Text;
    /// √a
    fn square_root(&self, operand: &Text) -> Text;
    /// ±a·b ± c, if the language writes it as one.
    fn fused(&self, fused: &Fused<'_>) -> Text {
        let (left, right) = fused.factors;
        let product = self.binary(Sign::Multiply, left, right);
        match (fused.negative_product, fused.negative_addend) {
            (true, _) => self.binary(Sign::Subtract, fused.addend, &product),
            (false, true) => self.binary(Sign::Subtract, &product, fused.addend),
            (false, false) => self.binary(Sign::Add, &product, fused.addend),
        }
    }
}

/// The usual signs between two values, with as few parentheses as keep the order of evaluation.
pub fn infix(sign: Sign, left: &Text, right: &Text) -> Text {
    infix_by(["*", "/"], sign, left, right)
}

/// The same where the signs of products and quotients are these.
pub fn infix_by(products: [&str; 2], sign: Sign, left: &Text, right: &Text) -> Text {
    // x + (−2) is x − 2, to the bit.
    if let (Sign::Add | Sign::Subtract, Some(decimal)) = (sign, &right.decimal)
        && decimal.is_negative()
    {
        let opposite = match sign {
            Sign::Add => Sign::Subtract,
            _ => Sign::Add,
        };
        let negated = decimal.negated();
        let negated = Text::new(negated.text, Binding::Atom);
        return infix_by(products, opposite, left, &negated);
    }
    let (sign, outer, inner) = match sign {
        Sign::Add => ("+", Binding::Sum, Binding::Product),
        Sign::Subtract => ("-", Binding::Sum, Binding::Product),
        Sign::Multiply => (products[0], Binding::Product, Binding::Sign),
        Sign::Divide => (products[1], Binding::Product, Binding::Sign),
    };
    let text = format!("{} {sign} {}", left.at_least(outer), right.at_least(inner));
    Text::new(text, outer)
}

/// The usual sign before a value; never two of them.
pub fn prefix(operand: &Text) -> Text {
    Text::new(
        format!("-{}", operand.at_least(Binding::Atom)),
        Binding::Sign,
    )
}

/// A literal as it is.
pub fn plain_literal(decimal: &Decimal) -> Text {
    Text {
        text: decimal.text.clone(),
        binding: match decimal.is_negative() {
            true => Binding::Sign,
            false => Binding::Atom,
        },
        decimal: Some(decimal.clone()),
    }
}
