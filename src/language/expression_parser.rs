//! Expressions, by precedence climbing.
//!
//! From loose to tight: `at`; `+` and `-`; `*` and `/`; the sign `-`; `^`; what stands behind an operand
//! (`[1, 2]`, `²`). Only `^` groups to the right.

mod numeral;
mod operand;

use super::cursor::{Cursor, Parsed};
use super::diagnostic::{Diagnostic, DiagnosticKind};
use super::lexer::{self, TokenKind};
use super::name::Aliases;
use super::syntax::{
    BinaryOperator, Comparison, Expression, Node, Place, Relation, Replacement, Span,
};

/// How deep brackets, signs and powers may be nested.
const MAXIMUM_NESTING: usize = 200;
/// How high an expression's tree may grow; every later pass over it is recursive.
const MAXIMUM_HEIGHT: usize = 500;
/// Reads an expression that stands alone, with no declared spellings.
///
/// # Errors
///
/// The first mistake against the grammar.
pub fn parse_expression(text: &str) -> Result<Expression, Diagnostic> {
    parse_expression_with(text, &mut Aliases::default())
}

/// Reads an expression that stands alone, with the spellings that a document declares.
///
/// # Errors
///
/// The first mistake against the grammar.
pub fn parse_expression_with(text: &str, aliases: &mut Aliases) -> Result<Expression, Diagnostic> {
    let tokens = lexer::tokens(text, &(0..text.len()));
    let mut cursor = Cursor::new(text, &tokens, aliases);
    let expression = cursor.expression()?;
    if cursor.peek().is_none() {
        return Ok(expression);
    }
    let unexpected = || cursor.expected_after_operand("the end of the expression");
    Err(cursor.surplus_bracket().unwrap_or_else(unexpected))
}

/// An expression and the height of its tree.
pub(super) struct Tree {
    /// The expression.
    pub(super) expression: Expression,
    /// 1 for a leaf.
    pub(super) height: usize,
}

impl Tree {
    /// A tree that is only a leaf.
    pub(super) fn leaf(node: Node, span: Span) -> Self {
        Self {
            expression: Expression { node, span },
            height: 1,
        }
    }
}

/// How tightly an operator binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Precedence {
    Sum,
    Product,
    Power,
    Operand,
}

impl Precedence {
    fn of(operator: BinaryOperator) -> Self {
        match operator {
            BinaryOperator::Add | BinaryOperator::Subtract => Self::Sum,
            BinaryOperator::Multiply | BinaryOperator::Divide => Self::Product,
            BinaryOperator::Power => Self::Power,
        }
    }

    /// What the right operand must bind with at least.
    fn of_right_operand(operator: BinaryOperator) -> Self {
        match Self::of(operator) {
            Self::Sum => Self::Product,
            // `^` groups to the right.
            Self::Product | Self::Power => Self::Power,
            Self::Operand => Self::Operand,
        }
    }
}

impl Cursor<'_> {
    /// An expression, together with where it is taken.
    pub(crate) fn expression(&mut self) -> Parsed<Expression> {
        Ok(self.placed()?.expression)
    }

    /// Expressions with commas between them.
    pub(crate) fn expressions(&mut self) -> Parsed<Vec<Expression>> {
        let (expressions, _) = self.list()?;
        Ok(expressions)
    }

    /// `left == right`; `comparisons` says which signs may stand between the sides.
    pub(crate) fn relation(&mut self, comparisons: &str) -> Parsed<Relation> {
        let left = self.expression()?;
        let Some(comparison) = self.accept_comparison() else {
            let unexpected = || self.expected_after_operand(comparisons);
            return Err(self.surplus_bracket().unwrap_or_else(unexpected));
        };
        let right = self.expression()?;
        let here = self.here();
        if self.accept_comparison().is_some() {
            return Err(Diagnostic::syntax(
                here,
                "a statement compares two expressions, not three",
            )
            .with_label("a second comparison")
            .with_help("write a statement for each comparison"));
        }
        Ok(Relation {
            left,
            comparison,
            right,
        })
    }

    /// `dt(x) = 0, y = 0`
    pub(crate) fn replacements(&mut self) -> Parsed<Vec<Replacement>> {
        let (replacements, _) = self.measured_replacements()?;
        Ok(replacements)
    }

    fn accept_comparison(&mut self) -> Option<Comparison> {
        let comparison = match self.peek()? {
            TokenKind::EqualsEquals => Comparison::Equal,
            TokenKind::Less => Comparison::Less,
            TokenKind::LessOrEqual => Comparison::LessOrEqual,
            TokenKind::Greater => Comparison::Greater,
            TokenKind::GreaterOrEqual => Comparison::GreaterOrEqual,
            _ => return None,
        };
        self.advance();
        Some(comparison)
    }

    /// An expression, together with where it is taken.
    pub(super) fn placed(&mut self) -> Parsed<Tree> {
        self.nested(Self::sum_at_places)
    }

    fn sum_at_places(&mut self) -> Parsed<Tree> {
        let mut tree = self.climb(Precedence::Sum)?;
        while self.accept_word("at") {
            let start = tree.expression.span.start;
            let (place, height) = self.place()?;
            if self.peek().is_some_and(|kind| operator(kind).is_some()) {
                let message = "`at` binds more loosely than every operator";
                return Err(Diagnostic::syntax(self.here(), message)
                    .with_label("an operator behind a place")
                    .with_help("write what stands before it in brackets: `(… at …)`"));
            }
            let height = height.max(tree.height);
            tree = self.grow(start, height, Node::At(Box::new(tree.expression), place))?;
        }
        Ok(tree)
    }

    pub(super) fn place(&mut self) -> Parsed<(Place, usize)> {
        let Some(open) = self.accept(TokenKind::OpenRound) else {
            let what = "the name of a substitution, or `(x = …)`";
            let help = "write the replacements in brackets, `at (x = 0)`, or name a `substitution`";
            let name = self.name(what).map_err(|error| error.or_help(help));
            return Ok((Place::Named(name?), 0));
        };
        let (replacements, height) = self.measured_replacements()?;
        self.expect_closing(TokenKind::CloseRound, &open)?;
        Ok((Place::Replacements(replacements), height))
    }

    fn measured_replacements(&mut self) -> Parsed<(Vec<Replacement>, usize)> {
        let mut replacements = Vec::new();
        let mut height = 0;
        loop {
            let target = self.placed()?;
            if self.accept(TokenKind::Equals).is_none() {
                let error = self.expected_after_operand("`=`");
                return Err(error.with_help("a replacement is written `x = value`"));
            }
            let value = self.placed()?;
            height = height.max(target.height).max(value.height);
            replacements.push(Replacement {
                target: target.expression,
                value: value.expression,
            });
            if self.accept(TokenKind::Comma).is_none() {
                return Ok((replacements, height));
            }
        }
    }

    /// Reads operands as long as the operators between them bind at least as tightly as `minimum`.
    fn climb(&mut self, minimum: Precedence) -> Parsed<Tree> {
        let mut left = self.signed()?;
        while let Some(operator) = self.peek().and_then(operator) {
            if Precedence::of(operator) < minimum {
                break;
            }
            self.advance();
            let minimum = Precedence::of_right_operand(operator);
            let right = self.nested(|cursor| cursor.climb(minimum))?;
            left = self.join(operator, left, right)?;
        }
        Ok(left)
    }

    /// An operand, perhaps with signs.
    fn signed(&mut self) -> Parsed<Tree> {
        let Some(minus) = self.accept(TokenKind::Minus) else {
            return self.operand();
        };
        let operand = self.nested(|cursor| cursor.climb(Precedence::Power))?;
        let node = Node::Negative(Box::new(operand.expression));
        self.grow(minus.start, operand.height, node)
    }

    /// Reads what is enclosed by a bracket, a sign or a power, as long as the stack is not in danger.
    fn nested(&mut self, read: impl FnOnce(&mut Self) -> Parsed<Tree>) -> Parsed<Tree> {
        if self.nesting >= MAXIMUM_NESTING {
            return Err(too_complex(
                self.here(),
                "the expression is nested too deeply",
            ));
        }
        self.nesting += 1;
        let tree = read(self)?;
        self.nesting -= 1;
        Ok(tree)
    }

    /// `left + right` and its like.
    pub(super) fn join(&self, operator: BinaryOperator, left: Tree, right: Tree) -> Parsed<Tree> {
        let start = left.expression.span.start;
        let height = left.height.max(right.height);
        let (left, right) = (Box::new(left.expression), Box::new(right.expression));
        self.grow(start, height, Node::Binary(operator, left, right))
    }

    /// Makes a node above others, of which the highest has the given height.
    pub(super) fn grow(&self, start: usize, height: usize, node: Node) -> Parsed<Tree> {
        let span = self.since(start);
        if height >= MAXIMUM_HEIGHT {
            return Err(too_complex(
                span,
                "the expression has too many terms or factors in a row",
            ));
        }
        Ok(Tree {
            expression: Expression { node, span },
            height: height + 1,
        })
    }
}

fn operator(kind: TokenKind) -> Option<BinaryOperator> {
    Some(match kind {
        TokenKind::Plus => BinaryOperator::Add,
        TokenKind::Minus => BinaryOperator::Subtract,
        TokenKind::Star => BinaryOperator::Multiply,
        TokenKind::Slash => BinaryOperator::Divide,
        TokenKind::Caret => BinaryOperator::Power,
        _ => return None,
    })
}

fn too_complex(span: Span, message: &str) -> Diagnostic {
    Diagnostic::new(DiagnosticKind::Budget, span, message)
        .with_label("here it becomes too much")
        .with_help("name parts of it by definitions: `part := …`")
}
