//! Expressions with the usual signs, as C and Python have them, and with those of elements.

use super::body::{Term, Unreadable};
use super::cursor::{Cursor, is_word};
use super::literal::decimal;

/// How deep parentheses and signs may be nested.
const DEEPEST: usize = 64;

/// How many numbers and names an expression may have.
const MOST_OPERANDS: usize = 500;

/// How a language writes what is not the same in all of them.
pub(super) struct Words<'w> {
    /// The signs of a product and of a quotient.
    pub products: [&'w str; 2],
    /// The tokens in front of the parenthesis of a square root; nothing where there is none.
    pub root: &'w [&'w str],
}

impl<'w> Words<'w> {
    /// The usual signs.
    pub const fn usual(root: &'w [&'w str]) -> Self {
        Words {
            products: ["*", "/"],
            root,
        }
    }
}

/// Reads an expression.
///
/// Products bind tighter than sums, signs tighter than products; of two of the same kind the left one
/// comes first.
///
/// # Errors
///
/// [`Unreadable`] at the first token that belongs to no expression.
pub(super) fn expression(
    cursor: &mut Cursor<'_, '_>,
    words: &Words<'_>,
) -> Result<Term, Unreadable> {
    let mut reader = Reader {
        cursor,
        words,
        depth: 0,
        operands: 0,
    };
    reader.sum()
}

struct Reader<'r, 't, 'a> {
    cursor: &'r mut Cursor<'t, 'a>,
    words: &'r Words<'r>,
    depth: usize,
    operands: usize,
}

impl Reader<'_, '_, '_> {
    fn sum(&mut self) -> Result<Term, Unreadable> {
        let mut left = self.product()?;
        loop {
            left = if self.cursor.accept(&["+"]) {
                Term::Add(Box::new(left), Box::new(self.product()?))
            } else if self.cursor.accept(&["-"]) {
                Term::Subtract(Box::new(left), Box::new(self.product()?))
            } else {
                return Ok(left);
            };
        }
    }

    fn product(&mut self) -> Result<Term, Unreadable> {
        let [times, over] = self.words.products;
        let mut left = self.signed()?;
        loop {
            left = if self.cursor.accept(&[times]) {
                Term::Multiply(Box::new(left), Box::new(self.signed()?))
            } else if self.cursor.accept(&[over]) {
                Term::Divide(Box::new(left), Box::new(self.signed()?))
            } else {
                return Ok(left);
            };
        }
    }

    fn signed(&mut self) -> Result<Term, Unreadable> {
        if !self.cursor.accept(&["-"]) {
            return self.operand();
        }
        let operand = self.deeper(Self::signed)?;
        Ok(Term::Negative(Box::new(operand)))
    }

    fn operand(&mut self) -> Result<Term, Unreadable> {
        self.operands += 1;
        if self.operands > MOST_OPERANDS {
            return Err(self.cursor.refuse("the end of so long an expression"));
        }
        if self.cursor.accept(&["("]) {
            return self.in_parentheses();
        }
        if !self.words.root.is_empty() && self.cursor.accept(self.words.root) {
            self.cursor.expect(&["("])?;
            return Ok(Term::SquareRoot(Box::new(self.in_parentheses()?)));
        }
        if let Some(number) = self.cursor.peek().and_then(decimal) {
            self.cursor.advance();
            return Ok(Term::Number(number));
        }
        match self.cursor.peek().filter(|text| is_word(text)) {
            Some(name) => {
                self.cursor.advance();
                Ok(Term::Name(name.to_string()))
            }
            None => Err(self
                .cursor
                .refuse("a name, a decimal number or a parenthesis")),
        }
    }

    fn in_parentheses(&mut self) -> Result<Term, Unreadable> {
        let inner = self.deeper(Self::sum)?;
        self.cursor.expect(&[")"])?;
        Ok(inner)
    }

    fn deeper(
        &mut self,
        read: impl Fn(&mut Self) -> Result<Term, Unreadable>,
    ) -> Result<Term, Unreadable> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.cursor.refuse("an expression that is less deep"));
        }
        let term = read(self);
        self.depth -= 1;
        term
    }
}

#[cfg(test)]
mod tests {
    use super::super::token::{Dialect, tokens};
    use super::*;

    /// An expression with all its parentheses.
    fn read(text: &str) -> Result<String, Unreadable> {
        let tokens = tokens(text, Dialect::C)?;
        let mut cursor = Cursor::new(&tokens);
        let term = expression(&mut cursor, &Words::usual(&["sqrt"]))?;
        cursor.end()?;
        Ok(shown(&term))
    }

    fn shown(term: &Term) -> String {
        let binary = |a: &Term, sign: &str, b: &Term| format!("({}{sign}{})", shown(a), shown(b));
        match term {
            Term::Name(name) => name.clone(),
            Term::Number(number) => number.to_string(),
            Term::Negative(a) => format!("(-{})", shown(a)),
            Term::Add(a, b) => binary(a, "+", b),
            Term::Subtract(a, b) => binary(a, "-", b),
            Term::Multiply(a, b) => binary(a, "*", b),
            Term::Divide(a, b) => binary(a, "/", b),
            Term::SquareRoot(a) => format!("√{}", shown(a)),
        }
    }

    #[test]
    fn signs_bind_as_in_both_languages() {
        for (text, expected) in [
            ("a - b - c", "((a-b)-c)"),
            ("a - (b - c)", "(a-(b-c))"),
            ("a / b * c", "((a/b)*c)"),
            ("a + b * c", "(a+(b*c))"),
            ("-a * b", "((-a)*b)"),
            ("a * -b", "(a*(-b))"),
            ("- -2.0 * a", "((-(-2))*a)"),
            ("sqrt(a + b) / 0.5", "(√(a+b)/1/2)"),
        ] {
            assert_eq!(read(text).unwrap(), expected);
        }
    }

    #[test]
    fn what_is_no_arithmetic_is_refused() {
        for text in [
            "",
            "a +",
            "a b",
            "a--b",
            "(a",
            "a)",
            "a ** b",
            "a // b",
            "+a",
            "!a",
            "a ? b : c",
            "f(a)",
            "1 / 3",
            "0x1",
            "1.0f",
            "a, b",
            "sqrt a",
            "a = b",
            "a /* b",
            "a % b",
            "a[b]",
            "x.y",
        ] {
            assert!(read(text).is_err(), "{text}");
        }
    }

    #[test]
    fn deep_and_long_expressions_are_refused() {
        assert!(read(&format!("{}a{}", "(".repeat(64), ")".repeat(64))).is_ok());
        assert!(read(&format!("{}a{}", "(".repeat(65), ")".repeat(65))).is_err());
        assert!(read(&"(".repeat(1_000_000)).is_err());
        assert!(read(&"- ".repeat(1_000_000)).is_err());
        assert!(read(&format!("a{}", " + a".repeat(499))).is_ok());
        assert!(read(&format!("a{}", " + a".repeat(500))).is_err());
    }
}
