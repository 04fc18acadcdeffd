//! What a document declares and defines, in the words of the kernel.

use crate::derivation::scope::Meaning;
use crate::language::built_in::{BuiltIn, Declared};
use crate::language::mention::Mention;
use crate::language::notation::Notation;
use crate::language::syntax::{
    Comparison, Expression, Name, Node, Place, Relation, Sign, Spanned, Statement, StatementKind,
};
use crate::verdict::audit::Audit;

use super::entry::Entry;
use super::expression::{Function, Withheld, Writer};
use super::point::Usual;
use super::theorem::{Part, Theorem, comment};

/// Writes the parts of a certificate.
pub(super) struct Composer<'a> {
    pub(super) audit: &'a Audit,
    pub(super) writer: Writer,
    pub(super) parts: Vec<Part>,
    pub(super) entries: Vec<Entry>,
    /// The next number of a constant, a coordinate or a function; 1 is the kernel's mark.
    next: usize,
    /// Hypotheses that were not written yet, how many lists of them were, and whether directions and references are.
    pending: Vec<String>,
    lists: usize,
    /// Whether an assumption could not be said, so that what is possible is not known.
    pub(super) leaves_out_assumptions: bool,
    /// The angle along which an angle of a vector is taken.
    direction: Option<Expression>,
    references: Vec<String>,
    /// Values for quantities of which a point says nothing, and how many lists of them were written.
    usual: Usual,
    points: usize,
}

impl<'a> Composer<'a> {
    pub(super) fn new(audit: &'a Audit) -> Self {
        Composer {
            audit,
            writer: Writer::default(),
            parts: Vec::new(),
            entries: Vec::new(),
            next: 2,
            pending: Vec::new(),
            lists: 0,
            leaves_out_assumptions: false,
            direction: None,
            references: Vec::new(),
            usual: Usual::default(),
            points: 0,
        }
    }

    pub(super) fn text(&mut self, text: String) {
        self.parts.push(Part::Text(text));
    }

    pub(super) fn theorem(&mut self, claim: usize, theorem: Theorem) {
        self.parts.push(Part::Theorem(claim, theorem));
    }

    pub(super) fn control(&mut self, theorem: Theorem) {
        self.parts.push(Part::Control(theorem));
    }

    /// Defines the outputs of evaluators and the matrices of systems that a statement names.
    pub(super) fn outputs(&mut self, statement: &Statement) {
        let audit = self.audit;
        for Mention { name, .. } in statement.mentions() {
            let is_known = self.writer.names.get(&name.ascii).is_some()
                || self.writer.withheld.contains_key(&name.ascii);
            if is_known || name.of_output().is_none() {
                continue;
            }
            let entry = audit.elaborator.scope.get(&name);
            if let Some(Meaning::Definition { expression, .. }) = entry.map(|own| &own.meaning) {
                self.define(&name, &[], expression);
            }
        }
    }

    /// Says what a statement declares, assumes or defines.
    pub(super) fn statement(&mut self, statement: &Statement) {
        match &statement.kind {
            StatementKind::Parameter {
                names,
                unit,
                sign,
                description,
            } => {
                let words = format!("{}{}", unit.value, said(description.as_deref()));
                self.constants(names, *sign, &words);
            }
            StatementKind::Angle { names, description } => {
                let ascii = names.iter().map(|name| name.value.ascii.clone());
                self.writer.angles.extend(ascii);
                self.constants(
                    names,
                    None,
                    &format!("angle{}", said(description.as_deref())),
                );
            }
            StatementKind::Complex {
                names,
                unit,
                description,
            } => {
                for name in names {
                    let own = self.declare(&name.value);
                    let (real, imaginary) = (self.number(), self.number());
                    self.usual.complex(&own);
                    let words = comment(&format!("{}{}", unit.value, said(description.as_deref())));
                    self.text(format!(
                        "Definition {own} := complex_number {real} {imaginary}. (* {words} *)\n"
                    ));
                }
            }
            StatementKind::Coordinate {
                names,
                unit,
                description,
            } => {
                for name in names {
                    let (own, number) = (self.declare(&name.value), self.number());
                    match unit.value == "rad" {
                        true => self.usual.angle(&own),
                        false => self.usual.number(&own, None),
                    }
                    for rate in [format!("(dt {own})"), format!("(dt (dt {own}))")] {
                        self.usual.number(&rate, None);
                    }
                    let words = comment(&format!("{}{}", unit.value, said(description.as_deref())));
                    self.text(format!(
                        "Definition {own} := coordinate {number}. (* {words} *)\n"
                    ));
                }
            }
            StatementKind::Function {
                names, reference, ..
            } => self.functions(names, reference),
            StatementKind::Imaginary { name } => {
                let own = self.declare(&name.value);
                self.text(format!("Definition {own} := imaginary.\n"));
            }
            StatementKind::Assume { relation, .. } => match self.hypothesis(relation) {
                Ok(hypothesis) => self.pending.push(hypothesis),
                Err(reason) => {
                    self.text(format!(
                        "(* An assumption is left out: {} *)\n",
                        comment(&reason)
                    ));
                    self.leaves_out_assumptions = true;
                }
            },
            StatementKind::Definition {
                names,
                arguments,
                values,
            } => {
                for (name, value) in names.iter().zip(values) {
                    self.define(&name.value, arguments, value);
                }
            }
            StatementKind::Substitution { name, replacements } => {
                self.bring_up_to_date();
                let replaces = self.writer.replace_functions(replacements);
                let written = self.writer.replacements(replacements);
                self.place(&name.value, written, replaces);
            }
            StatementKind::Match(matching) => {
                let written = match self
                    .audit
                    .elaborator
                    .scope
                    .get(&matching.name.value)
                    .map(|own| &own.meaning)
                {
                    Some(Meaning::Substitution { replacements, .. }) => {
                        self.writer.replacements(replacements)
                    }
                    _ => Err("the matching has no solution".into()),
                };
                self.place(&matching.name.value, written, false);
            }
            _ => {}
        }
    }

    /// A new number of a constant, a coordinate or a function.
    fn number(&mut self) -> usize {
        let number = self.next;
        self.next += 1;
        number
    }

    fn declare(&mut self, name: &Name) -> String {
        self.writer.names.declare(&name.ascii)
    }

    fn constants(&mut self, names: &[Spanned<Name>], sign: Option<Sign>, words: &str) {
        for name in names {
            let (own, number) = (self.declare(&name.value), self.number());
            match self.writer.angles.contains(&name.value.ascii) {
                true => self.usual.angle(&own),
                false => self.usual.number(&own, sign),
            }
            self.text(format!(
                "Definition {own} := parameter {number}. (* {} *)\n",
                comment(words)
            ));
            let hypothesis = sign.map(|sign| match sign {
                Sign::Positive => format!("positive {own}"),
                Sign::NonNegative => format!("non_negative {own}"),
                Sign::NonZero => format!("non_zero {own}"),
                Sign::Negative => format!("positive (- {own})"),
                Sign::NonPositive => format!("non_negative (- {own})"),
            });
            self.pending.extend(hypothesis);
        }
    }

    fn functions(&mut self, names: &[Spanned<Name>], reference: &Expression) {
        for name in names {
            let number = self.number();
            match self.writer.argument(reference) {
                Err(reason) => self.withhold(&name.value, reason),
                Ok(reference) => {
                    let own = self.declare(&name.value);
                    self.usual.function(&own);
                    self.text(format!(
                        "Definition {own} := function_ {number} 0 {reference}.\n"
                    ));
                    if !self.references.contains(&reference) {
                        self.references.push(reference.clone());
                    }
                    let function = Function { number, reference };
                    self.writer
                        .functions
                        .insert(name.value.ascii.clone(), function);
                }
            }
        }
    }

    fn withhold(&mut self, name: &Name, reason: Withheld) {
        self.text(format!(
            "(* {} is withheld: {} *)\n",
            name.ascii,
            comment(&reason)
        ));
        self.writer.withheld.insert(name.ascii.clone(), reason);
    }

    fn define(&mut self, name: &Name, arguments: &[Spanned<Name>], value: &Expression) {
        self.find_direction(value);
        self.find_degrees(value);
        self.bring_up_to_date();
        let outer = self.writer.clone();
        let ascii = arguments
            .iter()
            .map(|argument| argument.value.ascii.as_str());
        let (names, locals) = outer.names.with_arguments(ascii);
        self.writer.names = names;
        // An argument hides what is withheld or a function under its name.
        for argument in arguments {
            self.writer.withheld.remove(&argument.value.ascii);
            self.writer.functions.remove(&argument.value.ascii);
        }
        let written = self.writer.side(value);
        self.writer = outer;
        match written {
            Err(reason) => self.withhold(name, reason),
            Ok(value) => {
                let own = self.declare(name);
                let locals = match locals.is_empty() {
                    true => String::new(),
                    false => format!(" ({} : expr)", locals.join(" ")),
                };
                self.text(format!("Definition {own}{locals} : expr := {value}.\n"));
            }
        }
    }

    fn place(&mut self, name: &Name, written: Result<String, Withheld>, replaces_functions: bool) {
        match written {
            Err(reason) => self.withhold(name, reason),
            Ok(replacements) => {
                let own = self.declare(name);
                self.text(format!("Definition {own} := {replacements}.\n"));
                if replaces_functions {
                    self.writer.function_places.insert(name.ascii.clone());
                }
            }
        }
    }

    /// An inequality as a hypothesis.
    pub(super) fn hypothesis(&self, relation: &Relation) -> Result<String, Withheld> {
        let (left, right) = (self.writer.side(&relation.left)?, &relation.right);
        let left_term = self.writer.argument(&relation.left)?;
        let right_term = self.writer.argument(right)?;
        let right = self.writer.side(right)?;
        Ok(match relation.comparison {
            Comparison::Less => format!("positive ({right} - {left_term})"),
            Comparison::LessOrEqual => format!("non_negative ({right} - {left_term})"),
            Comparison::Greater => format!("positive ({left} - {right_term})"),
            Comparison::GreaterOrEqual => format!("non_negative ({left} - {right_term})"),
            Comparison::Equal => return Err("an equation is no sign".into()),
        })
    }

    /// Writes hypotheses that were not written yet.
    pub(super) fn bring_up_to_date(&mut self) {
        let directions = match &self.direction {
            Some(angle) => self
                .writer
                .side(angle)
                .map(|angle| format!("real_parts [{angle}]")),
            None => Ok("[]".into()),
        };
        let directions = directions.unwrap_or_else(|_| "[]".into());
        let is_new = self.lists == 0 || !self.pending.is_empty();
        if is_new {
            self.lists += 1;
            let before = match self.lists {
                1 => String::new(),
                number => format!("declared_{} ++ ", number - 1),
            };
            let new = std::mem::take(&mut self.pending).join("; ");
            self.text(format!(
                "Definition declared_{} : list need := {before}[{new}].\n",
                self.lists
            ));
        }
        let references = format!("(real_parts [{}])", self.references.join("; "));
        self.writer.hypotheses = format!("({directions}) declared_{} {references}", self.lists);
    }

    /// A point, with usual values for all of which it says nothing, and the places of functions.
    pub(super) fn point(&mut self, settings: &[String], is_varied: bool) -> (String, String) {
        let new = [&mut self.usual.modest, &mut self.usual.varied].map(std::mem::take);
        if self.points == 0 || !new.iter().all(Vec::is_empty) {
            self.points += 1;
            for (kind, new) in ["modest", "varied"].into_iter().zip(new) {
                let before = match self.points {
                    1 => String::new(),
                    number => format!(" ++ {kind}_{}", number - 1),
                };
                let number = self.points;
                let new = new.join("; ");
                self.text(format!(
                    "Definition {kind}_{number} : list setting := [{new}]{before}.\n"
                ));
            }
        }
        let kind = if is_varied { "varied" } else { "modest" };
        let references = format!("(real_parts [{}])", self.references.join("; "));
        (
            format!("([{}] ++ {kind}_{})", settings.join("; "), self.points),
            references,
        )
    }

    /// What a theorem stands under: `given directions declared conditions`.
    pub(super) fn given(&self, conditions: &[String]) -> String {
        let directions = match &self.direction {
            Some(angle) => self
                .writer
                .side(angle)
                .map_or("[]".into(), |angle| format!("(real_parts [{angle}])")),
            None => "[]".into(),
        };
        format!(
            "given {directions} declared_{} [{}]",
            self.lists,
            conditions.join("; ")
        )
    }

    /// Finds the angle along which an angle of a vector is taken, where a place of the document makes it one.
    fn find_direction(&mut self, expression: &Expression) {
        let mut vectors = Vec::new();
        collect_calls(expression, "angle", &mut vectors);
        let places: Vec<Name> = self.audit.elaborator.scope.entries()
            .filter(|entry| matches!(&entry.meaning, Meaning::Substitution { sources, .. } if sources.is_empty()))
            .map(|entry| entry.name.clone())
            .collect();
        for vector in vectors {
            for place in &places {
                let mut elaborator = self.audit.elaborator.clone();
                elaborator.fresh();
                let moved = vector.clone().at(Place::named(place.clone()));
                let Ok(shown) = elaborator.show(&moved, None, 1, &(0..0)) else {
                    continue;
                };
                let Some(own) = shown.scalar() else { continue };
                let mut left = Vec::new();
                collect_calls(&own.normal_form, "angle", &mut left);
                if left.is_empty() && self.direction.is_none() {
                    self.direction = Some(own.normal_form.clone());
                }
            }
        }
    }

    /// Finds the degrees of polynomials whose determinants are asked for.
    pub(super) fn find_degrees(&mut self, expression: &Expression) {
        let mut calls = Vec::new();
        collect_calls(expression, "hurwitz", &mut calls);
        for call in calls {
            let Node::Call {
                function,
                arguments,
                ..
            } = &call.node
            else {
                continue;
            };
            let Some(BuiltIn::Hurwitz(p, variable, _)) =
                Declared::of(&function.ascii).and_then(|own| own.call(arguments))
            else {
                continue;
            };
            let mut elaborator = self.audit.elaborator.clone();
            let coefficient = |degree: usize| {
                let degree = Expression::number(degree.into());
                Expression::call(
                    Name::new("coefficient"),
                    0,
                    vec![p.clone(), variable.clone(), degree],
                )
            };
            let degree = (0..=16).rev().find(|degree| {
                elaborator.fresh();
                let value = elaborator.scalar(&coefficient(*degree));
                value.is_ok_and(|value| !value.value.is_zero())
            });
            self.writer
                .degrees
                .extend(degree.map(|degree| (p.clone(), variable.clone(), degree)));
        }
    }
}

/// `: mass per unit length`
fn said(description: Option<&str>) -> String {
    description
        .map(|own| format!(": {own}"))
        .unwrap_or_default()
}

/// The calls of a function in an expression.
fn collect_calls(expression: &Expression, name: &str, found: &mut Vec<Expression>) {
    expression.visit(&mut |own| {
        if let Node::Call { function, .. } = &own.node
            && function.ascii == name
        {
            found.push(own.clone());
        }
    });
}

/// The words of a statement, for a comment above it.
pub(super) fn words(relation: &Relation) -> String {
    comment(&Notation::Unicode.relation(relation))
}
