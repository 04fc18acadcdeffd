//! What stands between operators: numbers, names, calls, matrices, brackets, and what stands behind them.

use super::Tree;
use super::numeral::{number, superscript};
use crate::language::cursor::{Cursor, Parsed};
use crate::language::diagnostic::Diagnostic;
use crate::language::lexer::TokenKind;
use crate::language::syntax::{BinaryOperator, Expression, Name, Node, Span};

impl Cursor<'_> {
    /// An operand with its indices and superscripts.
    pub(super) fn operand(&mut self) -> Parsed<Tree> {
        let mut tree = self.atom()?;
        loop {
            let here = self.here();
            if self.accept(TokenKind::OpenSquare).is_some() {
                let start = tree.expression.span.start;
                let (indices, height) = self.list()?;
                self.expect_closing(TokenKind::CloseSquare, &here)?;
                let node = Node::Index(Box::new(tree.expression), indices);
                tree = self.grow(start, height.max(tree.height), node)?;
            } else if self.accept(TokenKind::Superscript).is_some() {
                let exponent = superscript(self.text_of(&here), here)?;
                tree = self.join(BinaryOperator::Power, tree, exponent)?;
            } else {
                return Ok(tree);
            }
        }
    }

    /// An operand without what stands behind it.
    fn atom(&mut self) -> Parsed<Tree> {
        let start = self.here();
        match self.peek() {
            Some(TokenKind::Number) => {
                let value = number(self.peek_text(), &start)?;
                self.advance();
                Ok(Tree::leaf(Node::Number(value), start))
            }
            Some(TokenKind::Name) => self.named(),
            Some(TokenKind::OpenRound) => {
                self.advance();
                let mut tree = self.placed()?;
                self.expect_closing(TokenKind::CloseRound, &start)?;
                // The brackets belong to the place of the expression, not to what it says.
                tree.expression.span = self.since(start.start);
                Ok(tree)
            }
            Some(TokenKind::OpenSquare) => self.matrix(),
            Some(TokenKind::Bar) => {
                self.advance();
                let tree = self.placed()?;
                self.expect_closing(TokenKind::Bar, &start)?;
                self.apply("det", start.start, tree)
            }
            Some(TokenKind::Root) => {
                self.advance();
                let open = self.here();
                if self.accept(TokenKind::OpenRound).is_none() {
                    let help = "write what stands under the root in brackets: `√(…)`";
                    return Err(self.expected("`(`").with_help(help));
                }
                let tree = self.placed()?;
                self.expect_closing(TokenKind::CloseRound, &open)?;
                self.apply("sqrt", start.start, tree)
            }
            Some(TokenKind::Plus) => Err(self
                .expected("an expression")
                .with_help("a plus sign stands between two terms")),
            Some(TokenKind::CloseSquare) => Err(self
                .expected("an expression")
                .with_help("a matrix has an entry at least, and one behind every `,` and `;`")),
            _ => Err(self.expected("an expression").or_help(
                "an expression is a number, a name, a call such as `sin(α)`, a matrix, or another one in brackets",
            )),
        }
    }

    /// `x`, `ẋ`, `C_D′`, `cos(θ)`
    fn named(&mut self) -> Parsed<Tree> {
        let (dotted, span) = self.dotted_name("a name")?;
        let start = span.start;
        if dotted.dots > 0 {
            let mut tree = Tree::leaf(Node::Name(dotted.name), span);
            for _ in 0..dotted.dots {
                tree = self.apply("dt", start, tree)?;
            }
            return Ok(tree);
        }
        if let Some(output) = self.output_of(&dotted.name, &span)? {
            return Ok(Tree::leaf(Node::Name(output), self.since(start)));
        }
        let mut order = 0_u32;
        if let Some(primes) = self.accept(TokenKind::Primes) {
            order = self.text_of(&primes).chars().map(primes_in).sum();
        }
        let here = self.here();
        if self.accept(TokenKind::OpenRound).is_some() {
            let (arguments, height) = self.list()?;
            self.expect_closing(TokenKind::CloseRound, &here)?;
            let node = Node::Call {
                function: dotted.name,
                order,
                arguments,
            };
            return self.grow(start, height, node);
        }
        let node = match order {
            0 => Node::Name(dotted.name),
            _ => Node::Derivative(dotted.name, order),
        };
        Ok(Tree::leaf(node, self.since(start)))
    }

    /// `closed_form.λ_R1`: an output of an evaluator, or a matrix of a system, behind the name of that.
    fn output_of(&mut self, compiled: &Name, span: &Span) -> Parsed<Option<Name>> {
        let dot = self.here();
        let is_output = dot.start == span.end
            && self.peek_text() == "."
            && self.peek_at(1) == Some(TokenKind::Name)
            && self.span_of_next(2)
                == (dot.start..dot.end + self.span_of_next(2).len() - dot.len());
        if !is_output {
            return Ok(None);
        }
        self.advance();
        let output = self.name("the name of an output")?.value;
        Ok(Some(compiled.output(&output)))
    }

    /// The call that a sign stands for: `√(x)`, `|M|`, `ẋ`.
    fn apply(&self, function: &str, start: usize, argument: Tree) -> Parsed<Tree> {
        let node = Node::Call {
            function: Name::new(function),
            order: 0,
            arguments: vec![argument.expression],
        };
        self.grow(start, argument.height, node)
    }

    /// `[a, b; c, d]`
    fn matrix(&mut self) -> Parsed<Tree> {
        let open = self.expect(TokenKind::OpenSquare, "`[`")?;
        let (first, mut height) = self.list()?;
        let mut rows = vec![first];
        while self.accept(TokenKind::Semicolon).is_some() {
            let (row, row_height) = self.list()?;
            rows.push(row);
            height = height.max(row_height);
        }
        self.expect_closing(TokenKind::CloseSquare, &open)?;
        if let [row] = rows.as_slice()
            && is_nested(row)
        {
            let span = self.since(open.start);
            return Err(Diagnostic::syntax(span, "a row consists of rows").with_help(
                "rows of a matrix are separated by semicolons, without brackets of their own: `[a, b; f, g]`; \
                 a single row is written `[a, b, f, g]`",
            ));
        }
        self.grow(open.start, height, Node::Matrix(rows))
    }

    /// Expressions with commas between them, and the height of the highest.
    pub(super) fn list(&mut self) -> Parsed<(Vec<Expression>, usize)> {
        let mut expressions = Vec::new();
        let mut height = 0;
        loop {
            let tree = self.placed()?;
            height = height.max(tree.height);
            expressions.push(tree.expression);
            if self.accept(TokenKind::Comma).is_none() {
                return Ok((expressions, height));
            }
        }
    }
}

/// Whether entries are rows, which elsewhere are rows of one matrix, and here would be one row.
fn is_nested(entries: &[Expression]) -> bool {
    let is_row = |own: &Expression| matches!(&own.node, Node::Matrix(rows) if rows.len() == 1);
    entries.len() > 1 && entries.iter().all(is_row)
}

fn primes_in(character: char) -> u32 {
    match character {
        '″' => 2,
        '‴' => 3,
        _ => 1,
    }
}
