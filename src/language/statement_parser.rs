//! Statements: what begins with a keyword, and definitions.

use dashu_base::UnsignedAbs as _;

use super::cursor::{Cursor, Parsed};
use super::diagnostic::{Diagnostic, nearest};
use super::keyword::KEYWORDS;
use super::lexer::TokenKind;
use super::name::DottedName;
use super::syntax::{
    BinaryOperator, EvaluatorBody, Expectation, Expression, Matching, Name, Node, Order, Spanned,
    Statement, StatementKind,
};
use crate::algebra::number::Rational;

/// Those of the keywords that names follow.
const DECLARATIONS: [&str; 6] = [
    "parameter",
    "complex",
    "angle",
    "coordinate",
    "function",
    "imaginary",
];

impl Cursor<'_> {
    /// A whole statement, up to the end of the tokens.
    pub(crate) fn statement(&mut self) -> Parsed<Statement> {
        let start = self.here().start;
        let kind = self.statement_kind()?;
        self.expect_end("")?;
        Ok(Statement {
            kind,
            span: self.since(start),
        })
    }

    fn statement_kind(&mut self) -> Parsed<StatementKind> {
        if self.peek() != Some(TokenKind::Name) {
            let help = "if this line continues the statement above it, indent it";
            return Err(self
                .expected("the keyword or the name that begins a statement")
                .with_help(help));
        }
        // A keyword that is being defined is a name like others.
        if matches!(self.peek_at(1), Some(TokenKind::Define | TokenKind::Comma))
            || self.is_at_defined_function()
        {
            return self.definition();
        }
        if self.accept_ill_formed() {
            return self.assertion(Expectation::IllFormed);
        }
        let keyword = self.peek_text();
        let rest: fn(&mut Self) -> Parsed<StatementKind> = match keyword {
            "parameter" => Self::parameter,
            "complex" => Self::complex,
            "angle" => Self::angle,
            "coordinate" => Self::coordinate,
            "function" => Self::function,
            "imaginary" => Self::imaginary,
            "assume" => Self::assume,
            "substitution" => Self::substitution,
            "claim" => |cursor| cursor.assertion(Expectation::Holds),
            "refute" => |cursor| cursor.assertion(Expectation::Refuted),
            "approximate" => |cursor| cursor.assertion(Expectation::Approximate),
            "eigenpair" => Self::eigenpair,
            "match" => Self::matching,
            "system" => Self::system,
            "evaluator" => Self::evaluator,
            "domain" => |cursor| Ok(StatementKind::Domain(cursor.replacements()?)),
            "show" => Self::show,
            "import" => Self::import,
            _ => return self.definition_or_unknown_keyword(),
        };
        self.advance();
        rest(self)
    }

    /// Whether a function is defined here that is called like a declaration: `complex(z) := …`.
    fn is_at_defined_function(&self) -> bool {
        let word = self.peek_text();
        self.peek_at(1) == Some(TokenKind::OpenRound)
            && (DECLARATIONS.contains(&word) || word == "show")
            && self.is_ahead(TokenKind::Define)
    }

    /// `ill-formed` without a space is a keyword, not a difference.
    fn accept_ill_formed(&mut self) -> bool {
        let found = self.is_at_word("ill")
            && self.peek_at(1) == Some(TokenKind::Minus)
            && self.text_of(&self.span_of_next(3)) == "ill-formed";
        if found {
            for _ in 0..3 {
                self.advance();
            }
        }
        found
    }

    /// What begins with no keyword is a definition, or was meant to begin with one.
    fn definition_or_unknown_keyword(&mut self) -> Parsed<StatementKind> {
        if self.peek_at(1) == Some(TokenKind::Equals) || self.is_ahead(TokenKind::Define) {
            return self.definition();
        }
        let word = self.peek_text();
        let help = match nearest(word, KEYWORDS) {
            Some(keyword) => format!("did you mean `{keyword}`?"),
            None => format!(
                "the keywords are {}; a definition is `X := …`",
                KEYWORDS.join(", ")
            ),
        };
        let message = format!("no statement begins with `{word}`");
        Err(Diagnostic::syntax(self.here(), message)
            .with_label("not a keyword")
            .with_help(help))
    }

    /// `(8): left == right to order 1 in ρ "…"`
    fn assertion(&mut self, expectation: Expectation) -> Parsed<StatementKind> {
        let label = self.label()?;
        self.expect_colon("write `:` behind the label: `claim (1): a == b`")?;
        let relation = self.relation("`==`, `<`, `<=`, `>` or `>=`")?;
        let difference = match expectation == Expectation::Refuted && self.accept_word("by") {
            true => Some(self.expression()?),
            false => None,
        };
        let order = self.order()?;
        if expectation == Expectation::Approximate && order.is_none() {
            let help = "say which terms are kept: `to order 1 in x`";
            return Err(self.expected("`to order`").with_help(help));
        }
        let description = self.description()?;
        let what = match (&order, &description) {
            (_, Some(_)) => "",
            (Some(_), None) => "a description or ",
            (None, None) => "`to order`, a description or ",
        };
        self.expect_end(what)?;
        Ok(StatementKind::Assertion {
            expectation,
            label,
            relation,
            difference,
            order,
            description,
        })
    }

    /// `to order 1 in ρ, b_1`
    fn order(&mut self) -> Parsed<Option<Order>> {
        if !self.accept_word("to") {
            return Ok(None);
        }
        if !self.accept_word("order") {
            let help = "an approximation ends with `to order 1 in ρ`, say";
            return Err(self.expected("`order`").with_help(help));
        }
        let span = self.here();
        let digits = self.peek_text();
        self.expect(TokenKind::Number, "the order, a whole number")?;
        let Ok(order) = digits.parse() else {
            return Err(Diagnostic::syntax(
                span,
                format!("`{digits}` is not a whole number, or too large"),
            )
            .with_label("the order of the terms that are kept"));
        };
        self.expect_word("in")?;
        Ok(Some(Order {
            order: Spanned { value: order, span },
            small: self.small_quantities()?,
        }))
    }

    /// `ρ, b_1`: names, and nothing that is made of them.
    fn small_quantities(&mut self) -> Parsed<Vec<Spanned<Name>>> {
        let mut small = Vec::new();
        loop {
            let span = self.here();
            let is_rate = self.peek_at(1) == Some(TokenKind::OpenRound)
                || DottedName::read(self.peek_text()).is_ok_and(|dotted| dotted.dots > 0);
            if self.peek() == Some(TokenKind::Name) && is_rate {
                let message =
                    "a small quantity is a parameter, an angle, a coordinate or a function";
                return Err(Diagnostic::syntax(span, message)
                    .with_label("not the name of one")
                    .with_help("expand in rates with `truncate(…, [ẋ; ẏ], 1)`"));
            }
            small.push(self.name("the name of a small quantity")?);
            if self.accept(TokenKind::Comma).is_none() {
                return Ok(small);
            }
        }
    }

    /// `F_θ at rest "…"`
    fn show(&mut self) -> Parsed<StatementKind> {
        if self.peek().is_none() {
            let help = "say what is shown: `show a + b`";
            return Err(self.expected("an expression").with_help(help));
        }
        let expression = self.expression()?;
        let description = self.description()?;
        if description.is_none() && self.peek().is_some() {
            let help = "one expression is shown, without a label: `show a + b`; two sides are compared by `claim`";
            let unexpected = || self.expected_after_operand("a description or the end");
            let error = self.surplus_bracket().unwrap_or_else(unexpected);
            return Err(error.or_help(help));
        }
        Ok(StatementKind::Show {
            expression,
            description,
        })
    }

    /// `(15, mode 1) of K, M: value ω_n^2 vector [0; 1; 0] "…"`
    fn eigenpair(&mut self) -> Parsed<StatementKind> {
        let label = self.label()?;
        self.expect_word("of")?;
        let stiffness = self.expression()?;
        self.expect_behind_expression(TokenKind::Comma, "`,` and the second matrix")?;
        let mass = self.expression()?;
        self.expect_behind_expression(TokenKind::Colon, "`:`")?;
        self.expect_word("value")?;
        let value = self.expression()?;
        if !self.accept_word("vector") {
            return Err(self.expected_after_operand("`vector`"));
        }
        let vector = self.expression()?;
        let description = self.description()?;
        Ok(StatementKind::Eigenpair {
            label,
            stiffness,
            mass,
            value,
            vector,
            description,
        })
    }

    /// `(20) closed_form: p with q in λ unknown b_1, b_2 at λ^3, λ neglect b_1*b_2 small ρ "…"`
    fn matching(&mut self) -> Parsed<StatementKind> {
        let label = self.label()?;
        let name = self.name("the name of the matching")?;
        self.expect_colon("write `:` behind the name: `match (1) name: p with q in …`")?;
        let exact = self.expression()?;
        if !self.accept_word("with") {
            return Err(self.expected_after_operand("`with` and the assumed form"));
        }
        let assumed = self.expression()?;
        if !self.accept_word("in") {
            return Err(self.expected_after_operand("`in` and the variable"));
        }
        let variable = self.name("the variable")?;
        self.expect_word("unknown")?;
        let unknowns = self.names("the name of an unknown")?;
        self.expect_word("at")?;
        let powers = self.powers(&variable.value)?;
        let neglected = if self.accept_word("neglect") {
            self.expressions()?
        } else {
            Vec::new()
        };
        let small = if self.accept_word("small") {
            self.small_quantities()?
        } else {
            Vec::new()
        };
        let description = self.description()?;
        Ok(StatementKind::Match(Box::new(Matching {
            label,
            name,
            exact,
            assumed,
            variable,
            unknowns,
            powers,
            neglected,
            small,
            description,
        })))
    }

    /// `(21) closed_form: λ_R1 = λ_1, λ_R2 = λ_2 "…"`
    fn evaluator(&mut self) -> Parsed<StatementKind> {
        let label = self.label()?;
        let name = self.name("the name of the evaluator")?;
        self.expect(TokenKind::Colon, "`:`")?;
        let body = match self.peek_at(1) {
            Some(TokenKind::Equals) => self.outputs()?,
            _ => self.special_evaluator()?,
        };
        let approximated = self.approximated()?;
        let mut conditions = Vec::new();
        if self.accept_word("where") {
            conditions.push(self.relation("`<`, `<=`, `>` or `>=`")?);
            while self.accept(TokenKind::Comma).is_some() {
                conditions.push(self.relation("`<`, `<=`, `>` or `>=`")?);
            }
        }
        let description = self.description()?;
        self.expect_end("")?;
        Ok(StatementKind::Evaluator {
            label,
            name,
            body,
            approximated,
            conditions,
            description,
        })
    }

    fn outputs(&mut self) -> Parsed<EvaluatorBody> {
        let mut outputs = Vec::new();
        loop {
            let name = self.name("the name of an output")?;
            if self.accept(TokenKind::Equals).is_none() {
                let help = "an output is written `name = value`";
                return Err(self.expected("`=`").with_help(help));
            }
            outputs.push((name, self.expression()?));
            if self.accept(TokenKind::Comma).is_none() {
                return Ok(EvaluatorBody::Outputs(outputs));
            }
        }
    }

    /// `other at tuned`
    fn special_evaluator(&mut self) -> Parsed<EvaluatorBody> {
        let start = self.here();
        let expression = self.expression()?;
        if let Node::At(inner, place) = expression.node
            && let Node::Name(value) = inner.node
        {
            let span = inner.span;
            let general = Spanned { value, span };
            return Ok(EvaluatorBody::Special { general, place });
        }
        let message = "this is neither a list of outputs nor another evaluator at a place";
        Err(Diagnostic::syntax(start, message)
            .with_label("computes what?")
            .with_help("write `name: output = value, …` or `name: other_evaluator at (x = 0)`"))
    }

    /// `λ^5, λ^3, λ, 1`, as exponents.
    fn powers(&mut self, variable: &Name) -> Parsed<Vec<Spanned<u32>>> {
        let mut powers = Vec::new();
        loop {
            let expression = self.expression()?;
            let Some(value) = exponent(&expression, variable) else {
                let message = format!("this is not a power of `{variable}`");
                return Err(Diagnostic::syntax(expression.span, message)
                    .with_label(format!("expected `{variable}^2`, `{variable}` or `1`, say"))
                    .with_help(format!(
                        "behind `at` stand the powers of `{variable}` whose coefficients are used"
                    )));
            };
            powers.push(Spanned {
                value,
                span: expression.span,
            });
            if self.accept(TokenKind::Comma).is_none() {
                return Ok(powers);
            }
        }
    }

    pub(crate) fn expect_colon(&mut self, help: &str) -> Parsed<()> {
        let colon = self.expect(TokenKind::Colon, "`:`");
        colon.map(|_| ()).map_err(|error| error.or_help(help))
    }

    pub(super) fn expect_behind_expression(&mut self, kind: TokenKind, what: &str) -> Parsed<()> {
        match self.accept(kind) {
            Some(_) => Ok(()),
            None => Err(self.expected_after_operand(what)),
        }
    }
}

/// The exponent of a power of the variable.
fn exponent(power: &Expression, variable: &Name) -> Option<u32> {
    match &power.node {
        Node::Number(number) if *number == Rational::ONE => Some(0),
        Node::Name(name) if name == variable => Some(1),
        Node::Binary(BinaryOperator::Power, base, exponent)
            if base.node == Node::Name(variable.clone()) =>
        {
            let Node::Number(exponent) = &exponent.node else {
                return None;
            };
            let whole = exponent
                .is_int()
                .then(|| exponent.numerator().unsigned_abs())?;
            u32::try_from(whole).ok()
        }
        _ => None,
    }
}
