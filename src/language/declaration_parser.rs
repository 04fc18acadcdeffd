//! The statements that introduce names: declarations, definitions, substitutions, imports.

use super::cursor::{Cursor, Parsed};
use super::diagnostic::Diagnostic;
use super::lexer::TokenKind;
use super::syntax::{Name, Sign, Spanned, StatementKind};

impl Cursor<'_> {
    /// `import "other.md"`, behind its keyword like all of these.
    pub(crate) fn import(&mut self) -> Parsed<StatementKind> {
        match self.accept_text()? {
            Some(path) => Ok(StatementKind::Import { path }),
            None => Err(self
                .expected("a path in quotation marks")
                .with_help("write `import \"other.md\"`")),
        }
    }

    /// `parameter m : kg/m > 0 "mass per unit length"`
    pub(crate) fn parameter(&mut self) -> Parsed<StatementKind> {
        let names = self.declared_names()?;
        let unit = self.unit()?;
        let sign = self.sign()?;
        Ok(StatementKind::Parameter {
            names,
            unit,
            sign,
            description: self.description()?,
        })
    }

    /// `complex λ, μ : 1/s "eigenvalues"`
    pub(crate) fn complex(&mut self) -> Parsed<StatementKind> {
        let names = self.declared_names()?;
        let unit = self.unit()?;
        if self.peek().is_some_and(is_comparison) {
            let help =
                "complex numbers have no order: leave the sign out, or declare a `parameter`";
            return Err(self
                .expected("a description or the end of the statement")
                .with_help(help));
        }
        Ok(StatementKind::Complex {
            names,
            unit,
            description: self.description()?,
        })
    }

    /// `angle α_g, θ_0 "…"`
    pub(crate) fn angle(&mut self) -> Parsed<StatementKind> {
        let names = self.declared_names()?;
        if self.peek() == Some(TokenKind::Colon) {
            let help = "an angle is in rad: leave the unit out";
            return Err(self
                .expected("a description or the end of the statement")
                .with_help(help));
        }
        Ok(StatementKind::Angle {
            names,
            description: self.description()?,
        })
    }

    /// `coordinate x, y : m "…"`
    pub(crate) fn coordinate(&mut self) -> Parsed<StatementKind> {
        let names = self.declared_names()?;
        let unit = self.unit()?;
        Ok(StatementKind::Coordinate {
            names,
            unit,
            description: self.description()?,
        })
    }

    /// `function C_D, C_L at α_0 + θ_0 : 1 "…"`
    pub(crate) fn function(&mut self) -> Parsed<StatementKind> {
        let names = self.declared_names()?;
        if !self.accept_word("at") {
            let help = "say where the bare name is taken: `function C_D at α_0 : 1`";
            return Err(self.expected("`at` and the argument").with_help(help));
        }
        let reference = self.expression()?;
        let unit = self.unit()?;
        Ok(StatementKind::Function {
            names,
            reference,
            unit,
            description: self.description()?,
        })
    }

    /// `imaginary i`
    pub(crate) fn imaginary(&mut self) -> Parsed<StatementKind> {
        Ok(StatementKind::Imaginary {
            name: self.name("a name")?,
        })
    }

    /// `assume L_g < r "…"`
    pub(crate) fn assume(&mut self) -> Parsed<StatementKind> {
        let relation = self.relation("`<`, `<=`, `>` or `>=`")?;
        Ok(StatementKind::Assume {
            relation,
            description: self.description()?,
        })
    }

    /// `substitution rest: dt(x) = 0, dt(y) = 0`
    pub(crate) fn substitution(&mut self) -> Parsed<StatementKind> {
        let name = self.name("the name of the substitution")?;
        self.expect_colon("write `:` behind the name: `substitution rest: x = 0`")?;
        Ok(StatementKind::Substitution {
            name,
            replacements: self.replacements()?,
        })
    }

    /// `X := …`, `u, v := …, …`, `R(β) := …`
    pub(crate) fn definition(&mut self) -> Parsed<StatementKind> {
        let start = self.here().start;
        let names = self.names("a name")?;
        let targets = self.since(start);
        let open = self.here();
        let mut arguments = Vec::new();
        if self.accept(TokenKind::OpenRound).is_some() {
            arguments = self.names("the name of an argument")?;
            self.expect_closing(TokenKind::CloseRound, &open)?;
        }
        let is_function = !arguments.is_empty();
        if is_function && (names.len() > 1 || self.peek() == Some(TokenKind::Comma)) {
            return Err(
                Diagnostic::syntax(open, "only one function can be defined at a time")
                    .with_label("arguments among several names")
                    .with_help("write a definition for each function"),
            );
        }
        if self.accept(TokenKind::Define).is_none() {
            let help = "a definition is written `X := …`";
            return Err(self.expected("`:=`").with_help(help));
        }
        let start = self.here().start;
        let values = self.expressions()?;
        if self.peek() == Some(TokenKind::Text) {
            return Err(
                Diagnostic::syntax(self.here(), "a definition has no description")
                    .with_label("not expected here")
                    .with_help("write a comment behind `#`"),
            );
        }
        if values.len() != names.len() {
            let (given, wanted) = (count(values.len(), "value"), count(names.len(), "name"));
            let message = format!("{wanted} and {given} do not pair up");
            return Err(Diagnostic::syntax(self.since(start), message)
                .with_label(given)
                .with_secondary(targets, wanted)
                .with_help("give one value for each name"));
        }
        Ok(StatementKind::Definition {
            names,
            arguments,
            values,
        })
    }

    /// A string at the end of a statement.
    pub(crate) fn description(&mut self) -> Parsed<Option<String>> {
        Ok(self.accept_text()?.map(|description| description.value))
    }

    /// `m`, or `S_xθ as S_xt`, with commas between them.
    fn declared_names(&mut self) -> Parsed<Vec<Spanned<Name>>> {
        let mut names = vec![self.declared_name()?];
        while self.accept(TokenKind::Comma).is_some() {
            names.push(self.declared_name()?);
        }
        Ok(names)
    }

    fn declared_name(&mut self) -> Parsed<Spanned<Name>> {
        let spelling = self.name("a name")?;
        if !self.accept_word("as") {
            return Ok(spelling);
        }
        let ascii = self.name("an ASCII spelling")?;
        let written = self.text_of(&ascii.span);
        if !written.is_ascii() {
            return Err(Diagnostic::syntax(
                ascii.span,
                format!("`{written}` is not an ASCII spelling"),
            )
            .with_label("not ASCII")
            .with_help(format!(
                "behind `as` use only a-z, A-Z, digits and `_`: `{}`",
                ascii.value.ascii
            )));
        }
        let name = Name::with_ascii(&spelling.value.unicode, &Name::new(written).ascii);
        self.aliases
            .declare(&Name::new(&spelling.value.unicode), &name);
        Ok(Spanned {
            value: name,
            span: self.since(spelling.span.start),
        })
    }

    /// `: kg/m`, up to a sign, a string or the end.
    fn unit(&mut self) -> Parsed<Spanned<String>> {
        if self.accept(TokenKind::Colon).is_none() {
            let help = "give the unit behind `:`, as in `: kg/m`, or `: 1` for a plain number";
            return Err(self.expected("`:` and a unit").with_help(help));
        }
        let start = self.here().start;
        while self.peek().is_some_and(|kind| !ends_unit(kind)) && !self.is_at_indented_statement() {
            self.advance();
        }
        let span = self.since(start);
        if self.here().start == start {
            return Err(self
                .expected("a unit")
                .with_help("the unit of a plain number is `1`"));
        }
        Ok(Spanned {
            value: self.text_of(&span).to_owned(),
            span,
        })
    }

    /// `> 0`, `>= 0`, `!= 0`, `< 0`, `<= 0`
    fn sign(&mut self) -> Parsed<Option<Sign>> {
        let start = self.here().start;
        let sign = match self.peek() {
            Some(TokenKind::Greater) => Some(Sign::Positive),
            Some(TokenKind::GreaterOrEqual) => Some(Sign::NonNegative),
            Some(TokenKind::NotEqual) => Some(Sign::NonZero),
            Some(TokenKind::Less) => Some(Sign::Negative),
            Some(TokenKind::LessOrEqual) => Some(Sign::NonPositive),
            Some(kind) if is_comparison(kind) => None,
            _ => return Ok(None),
        };
        self.advance();
        let zero = self.peek_text() == "0";
        if self.peek().is_some() {
            self.advance();
        }
        match sign {
            Some(sign) if zero => Ok(Some(sign)),
            _ => Err(Diagnostic::syntax(
                self.since(start),
                "this is not a sign that can be declared",
            )
            .with_label("expected `> 0`, `>= 0`, `!= 0`, `< 0` or `<= 0`")
            .with_help(
                "write other assumptions as `assume a < b`, with a unit that fits; 0 fits every unit",
            )),
        }
    }
}

/// Whether a unit ends before this token.
fn ends_unit(kind: TokenKind) -> bool {
    let is_text = matches!(kind, TokenKind::Text | TokenKind::UnclosedText);
    is_text || is_comparison(kind) || kind == TokenKind::Unknown
}

fn is_comparison(kind: TokenKind) -> bool {
    matches!(
        kind,
        TokenKind::Greater
            | TokenKind::GreaterOrEqual
            | TokenKind::NotEqual
            | TokenKind::Less
            | TokenKind::LessOrEqual
            | TokenKind::Equals
            | TokenKind::EqualsEquals
    )
}

fn count(number: usize, noun: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {noun}{plural}")
}
