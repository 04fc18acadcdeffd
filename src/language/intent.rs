//! What a statement is meant to do, also where it is not understood.

use std::collections::BTreeSet;

use super::diagnostic::{Diagnostic, nearest};
use super::keyword::is_keyword;
use super::lexer::{Token, TokenKind};
use super::name::{Aliases, DottedName};
use super::syntax::{Name, Span, Spanned, Statement, StatementKind};

/// The words behind which names are declared, up to a colon.
const DECLARING: [&str; 6] = [
    "parameter",
    "complex",
    "angle",
    "coordinate",
    "function",
    "imaginary",
];
/// The words behind which one name stands, perhaps behind a label.
const NAMING: [&str; 2] = ["substitution", "match"];
/// The words behind which the name of something stands that is to be compiled.
const COMPILING: [&str; 2] = ["system", "evaluator"];
/// The words of statements that declare nothing and assume nothing.
const SILENT: [&str; 7] = [
    "claim",
    "refute",
    "approximate",
    "ill",
    "eigenpair",
    "domain",
    "show",
];

/// What a statement is meant to do, as far as others rest on it.
#[derive(Clone, Debug, Default)]
pub struct Intent {
    /// The names to which it gives a meaning.
    pub declares: Vec<Name>,
    /// Whether these take arguments.
    pub is_template: bool,
    /// The evaluator or the system that it asks for.
    pub compiled: Option<Name>,
    /// What it may declare beside.
    pub may_declare: MayDeclare,
    /// Whether it assumes something, or may do so.
    pub may_assume: bool,
    /// The names that it mentions; nothing where they are not known.
    pub mentions: Option<Vec<Name>>,
}

/// What may be declared where the text is not understood.
#[derive(Clone, Debug, Default)]
pub enum MayDeclare {
    /// Nothing more than is known.
    #[default]
    Nothing,
    /// What is mentioned.
    Mentioned,
    /// Anything.
    Anything,
}

/// A part of a document that does not follow the grammar, or has the label of an earlier one.
#[derive(Clone, Debug)]
pub struct Unread {
    /// The statement or the block.
    pub span: Span,
    /// What is wrong with it.
    pub diagnostic: Diagnostic,
    /// What it was meant to do.
    pub intent: Intent,
}

impl Intent {
    /// What a part of a document is meant to do of which nothing can be told.
    pub fn anything() -> Self {
        Intent {
            may_declare: MayDeclare::Anything,
            may_assume: true,
            ..Intent::default()
        }
    }

    /// What a statement is meant to do.
    pub fn of(statement: &Statement) -> Self {
        let values =
            |names: &[Spanned<Name>]| names.iter().map(|name| name.value.clone()).collect();
        let mut intent = Intent::default();
        match &statement.kind {
            StatementKind::Import { .. } => intent = Intent::anything(),
            StatementKind::Parameter { names, .. }
            | StatementKind::Complex { names, .. }
            | StatementKind::Angle { names, .. }
            | StatementKind::Coordinate { names, .. }
            | StatementKind::Function { names, .. } => intent.declares = values(names),
            StatementKind::Imaginary { name } | StatementKind::Substitution { name, .. } => {
                intent.declares = vec![name.value.clone()];
            }
            StatementKind::Definition {
                names, arguments, ..
            } => {
                intent.declares = values(names);
                intent.is_template = !arguments.is_empty();
            }
            StatementKind::Match(matching) => intent.declares = vec![matching.name.value.clone()],
            StatementKind::System(system) => intent.compiled = Some(system.name.value.clone()),
            StatementKind::Evaluator { name, .. } => intent.compiled = Some(name.value.clone()),
            StatementKind::Assume { .. } => intent.may_assume = true,
            StatementKind::Assertion { .. }
            | StatementKind::Eigenpair { .. }
            | StatementKind::Show { .. }
            | StatementKind::Domain(_) => {}
        }
        let mentions = statement.mentions().into_iter();
        intent.mentions = Some(mentions.map(|mention| mention.name).collect());
        intent
    }

    /// What the tokens of a statement are meant to do that does not follow the grammar: by its keyword,
    /// or the keyword that it nearly has.
    pub(super) fn of_tokens(text: &str, tokens: &[Token], aliases: &Aliases) -> Self {
        let words = Words {
            text,
            tokens,
            aliases,
        };
        let keyword = words.keyword();
        let mut intent = Intent {
            mentions: Some(words.names(tokens.iter().skip(usize::from(keyword.is_some())))),
            ..Intent::default()
        };
        match keyword {
            Some("assume") => intent.may_assume = true,
            Some("import") => intent = Intent::anything(),
            Some(keyword) if COMPILING.contains(&keyword) => intent.compiled = words.named(),
            Some(keyword) if DECLARING.contains(&keyword) => {
                intent.declares = words.declared();
                // The other words are units, but for the argument of a function.
                if keyword != "function" {
                    intent.mentions = Some(Vec::new());
                }
            }
            Some(keyword) if NAMING.contains(&keyword) => {
                intent.declares = words.named().into_iter().collect();
            }
            Some(_) => {}
            None => match words.defined() {
                Some((names, is_template, value)) if !names.is_empty() => {
                    intent.declares = names;
                    intent.is_template = is_template;
                    // Arguments are no names of the document.
                    intent.mentions = (!is_template).then_some(value);
                }
                _ => {
                    intent.may_declare = MayDeclare::Mentioned;
                    intent.may_assume = true;
                }
            },
        }
        intent
    }

    /// What it may declare beside what it surely declares; nothing where that may be anything.
    pub fn doubtful(&self) -> Option<BTreeSet<String>> {
        let mentioned = || {
            let names = self.mentions.iter().flatten();
            names.map(|name| name.ascii.clone()).collect()
        };
        match self.may_declare {
            MayDeclare::Nothing => Some(BTreeSet::new()),
            MayDeclare::Mentioned => Some(mentioned()),
            MayDeclare::Anything => None,
        }
    }
}

/// The tokens of a statement that does not follow the grammar.
struct Words<'a> {
    text: &'a str,
    tokens: &'a [Token],
    aliases: &'a Aliases,
}

impl Words<'_> {
    fn text_of(&self, token: &Token) -> &str {
        self.text.get(token.span.clone()).unwrap_or_default()
    }

    /// The keyword that it begins with, or nearly begins with; what is defined has none.
    fn keyword(&self) -> Option<&'static str> {
        let first = self.text_of(self.tokens.first()?);
        let known = || {
            DECLARING
                .into_iter()
                .chain(NAMING)
                .chain(COMPILING)
                .chain(SILENT)
        };
        let all = || known().chain(["assume", "import"]);
        let second = self.tokens.get(1).map(|token| token.kind);
        if matches!(second, Some(TokenKind::Define | TokenKind::Comma)) {
            return None;
        }
        if let Some(exact) = all().find(|word| *word == first) {
            return Some(exact);
        }
        let is_definition = self
            .tokens
            .iter()
            .any(|token| token.kind == TokenKind::Define);
        if is_keyword(first) || is_definition || second == Some(TokenKind::Equals) {
            return None;
        }
        let near = nearest(first, all())?;
        all().find(|word| *word == near)
    }

    /// The names that some tokens are; dots above them are not theirs.
    fn names<'t>(&self, tokens: impl Iterator<Item = &'t Token>) -> Vec<Name> {
        let names = tokens.filter(|token| token.kind == TokenKind::Name);
        names
            .map(|token| {
                let word = self.text_of(token);
                let dotted = DottedName::read(word);
                let name = dotted.map_or_else(|_| Name::new(word), |dotted| dotted.name);
                self.aliases.resolve(name)
            })
            .collect()
    }

    /// The names behind a keyword that declares some: those up to a colon or `at`, but for what follows
    /// `as`.
    fn declared(&self) -> Vec<Name> {
        let is_name = |token: &&Token| match token.kind {
            TokenKind::Name => self.text_of(token) != "at",
            kind => kind == TokenKind::Comma,
        };
        let header: Vec<&Token> = self.tokens[1..].iter().take_while(is_name).collect();
        let is_spelling = |place: usize| {
            let before = place.checked_sub(1).and_then(|before| header.get(before));
            before.is_some_and(|token| self.text_of(token) == "as")
        };
        let own = header.iter().enumerate();
        let own = own.filter(|(place, token)| self.text_of(token) != "as" && !is_spelling(*place));
        self.names(own.map(|(_, token)| *token))
    }

    /// The name behind a keyword and perhaps a label.
    fn named(&self) -> Option<Name> {
        let mut depth = 0_usize;
        let name = self.tokens[1..].iter().find(|token| {
            match token.kind {
                TokenKind::OpenRound | TokenKind::OpenSquare => depth += 1,
                TokenKind::CloseRound | TokenKind::CloseSquare => depth = depth.saturating_sub(1),
                _ => {}
            }
            token.kind == TokenKind::Name && depth == 0
        });
        self.names(name.into_iter()).pop()
    }

    /// The names before `:=`, or before `=` where that was meant, whether they take arguments, and the
    /// names behind.
    fn defined(&self) -> Option<(Vec<Name>, bool, Vec<Name>)> {
        if self
            .tokens
            .first()
            .is_some_and(|first| is_keyword(self.text_of(first)))
        {
            return None;
        }
        let place = |kind| self.tokens.iter().position(|token| token.kind == kind);
        let end = place(TokenKind::Define).or_else(|| place(TokenKind::Equals))?;
        let header = &self.tokens[..end];
        let open = header
            .iter()
            .position(|token| token.kind == TokenKind::OpenRound);
        let names = self.names(header[..open.unwrap_or(end)].iter());
        Some((names, open.is_some(), self.names(self.tokens[end..].iter())))
    }
}
