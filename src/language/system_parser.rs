//! The statement `system`, and what an evaluator says of one.

use super::cursor::{Cursor, Parsed};
use super::lexer::TokenKind;
use super::syntax::{
    Approximated, Name, Part, Place, Quantities, Spanned, StatementKind, SystemBody,
    SystemStatement,
};

impl Cursor<'_> {
    /// `(9) section: mass M damping structural = C_s, wind = C_a stiffness K in x, y, θ "…"`
    pub(super) fn system(&mut self) -> Parsed<StatementKind> {
        let label = self.label()?;
        let name = self.name("the name of the system")?;
        self.expect_colon("write `:` behind the name: `system (9) section: mass M …`")?;
        let (body, coordinates) = match self.accept_word("equations") {
            true => {
                let equations = self.expression()?;
                let coordinates = self.coordinates()?;
                let rest = self.rest()?;
                (SystemBody::Equations { equations, rest }, coordinates)
            }
            false => (self.matrices()?, self.coordinates()?),
        };
        let description = self.description()?;
        self.expect_end("a description or ")?;
        Ok(StatementKind::System(Box::new(SystemStatement {
            label,
            name,
            body,
            coordinates,
            description,
        })))
    }

    /// `mass M damping C stiffness K`
    fn matrices(&mut self) -> Parsed<SystemBody> {
        if !self.accept_word("mass") {
            let help = "write `mass M damping C stiffness K in x, y`, or `equations [F_x; F_y] in x, y at rest`";
            return Err(self.expected("`mass` or `equations`").with_help(help));
        }
        let mass = self.expression()?;
        let damping = match self.accept_word("damping") {
            true => self.parts()?,
            false => Vec::new(),
        };
        if !self.accept_word("stiffness") {
            return Err(self.expected_after_operand("`stiffness` and its matrix"));
        }
        let stiffness = self.parts()?;
        Ok(SystemBody::Matrices {
            mass,
            damping,
            stiffness,
        })
    }

    /// `C`, or `structural = C_s, wind = C_a`
    fn parts(&mut self) -> Parsed<Vec<Part>> {
        let mut parts = Vec::new();
        loop {
            let is_named = self.peek_at(1) == Some(TokenKind::Equals);
            let name = is_named.then(|| self.name("the name of a part"));
            let name = name.transpose()?;
            if is_named {
                self.expect(TokenKind::Equals, "`=`")?;
            }
            let matrix = self.expression()?;
            parts.push(Part { name, matrix });
            if self.accept(TokenKind::Comma).is_none() {
                return Ok(parts);
            }
        }
    }

    /// `in x, y, θ`
    fn coordinates(&mut self) -> Parsed<Vec<Spanned<Name>>> {
        if !self.accept_word("in") {
            return Err(self.expected_after_operand("`in` and the coordinates"));
        }
        self.names("the name of a coordinate")
    }

    /// `at rest`
    fn rest(&mut self) -> Parsed<Place> {
        if !self.accept_word("at") {
            let help =
                "say where the equations are made linear: `at rest`, with a `substitution rest: …`";
            return Err(self.expected("`at` and the state of rest").with_help(help));
        }
        Ok(self.place()?.0)
    }

    /// `approximates real parts of section at tuned by roots`, if it stands here.
    pub(super) fn approximated(&mut self) -> Parsed<Option<Approximated>> {
        if !self.accept_word("approximates") {
            return Ok(None);
        }
        let quantities = if self.accept_word("eigenvalues") {
            Quantities::Eigenvalues
        } else if self.accept_word("real") {
            self.expect_word("parts")?;
            Quantities::RealParts
        } else {
            return Err(self.expected("`real parts of` or `eigenvalues of`, and a system"));
        };
        self.expect_word("of")?;
        let system = self.name("the name of a system")?;
        let place = match self.accept_word("at") {
            true => Some(self.place()?.0),
            false => None,
        };
        let by_roots = self.accept_word("by");
        if by_roots {
            self.expect_word("roots")?;
        }
        Ok(Some(Approximated {
            quantities,
            system,
            place,
            by_roots,
        }))
    }
}
