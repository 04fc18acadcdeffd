//! Replacements, as they stand behind `at`.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::error::AlgebraError;
use crate::algebra::fraction::Fraction;
use crate::algebra::number::Integer;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::sign::Signs;
use crate::algebra::substitution::{Replacing, Substitution};
use crate::algebra::symbol::Symbol;
use crate::derivation::condition::Conditions;
use crate::derivation::quantity::{Quantity, QuantityError, Value, common_unit};
use crate::derivation::scope::{Entry, Meaning, Scope};
use crate::language::diagnostic::{Diagnostic, DiagnosticKind, nearest};
use crate::language::notation::Notation;
use crate::language::syntax::{Expression, Name, Place, Replacement, Span};
use crate::language::unit::Unit;

use super::Elaborator;
use super::error::{algebra, quantity as quantity_error};
use super::limit::check_replacements;

/// What replaces a symbol, and what must hold for it to exist.
#[derive(Clone, Debug)]
pub(super) struct Image {
    value: Fraction,
    conditions: Conditions,
}

/// What replaces what.
type Images = BTreeMap<Symbol, Image>;

/// What a named substitution came to.
#[derive(Clone, Debug)]
pub(super) struct KnownSubstitution {
    images: Images,
    /// Of how many polynomials something was assumed then.
    assumed: usize,
}

impl Elaborator {
    /// What an expression is with the replacements of a place.
    pub(super) fn at(
        &mut self,
        inner: &Expression,
        place: &Place,
        span: &Span,
    ) -> Result<Value, Diagnostic> {
        let (mut value, mut needed) = self.value_and_conditions(inner)?;
        let mut images = self.images_of(place, span)?;
        // What does not occur need not exist.
        let mentioned = self.mentioned(inner);
        images.retain(|symbol, _| self.is_mentioned(*symbol, &mentioned));
        let twins = self.twins(
            images.iter().map(|(symbol, image)| (*symbol, &image.value)),
            span,
        )?;
        if !twins.is_empty() {
            // Nothing is kept that was found for real values.
            (value, needed) =
                self.as_complex(&twins, |elaborator| elaborator.value_and_conditions(inner))?;
            for (symbol, twin) in twins {
                let image = images.remove(&symbol);
                images.extend(image.map(|image| (twin, image)));
            }
        }
        let mut substitution = Substitution::new();
        for (symbol, image) in images {
            self.conditions.extend(&image.conditions);
            substitution.insert(symbol, image.value);
        }
        self.require_after(&needed, &substitution, span)?;
        let mut replacing = Replacing::by(&substitution);
        value.try_map(|entry| {
            let image = replacing.image(&entry.value, &mut self.ring);
            Ok(Quantity {
                value: image.map_err(|error| algebra(error, span))?,
                unit: entry.unit.clone(),
            })
        })
    }

    /// The ASCII names of the symbols and functions that the text of an expression rests on, through other
    /// names and the arguments of the call that it stands in.
    pub(super) fn mentioned(&self, expression: &Expression) -> BTreeSet<String> {
        let mut names = BTreeSet::new();
        let arguments = self.arguments.last();
        expression.visit_names(
            &mut |name| match arguments.and_then(|known| known.get(&name.ascii)) {
                Some(argument) => names.extend(argument.rests_on.iter().cloned()),
                None => {
                    let entry = self.scope.get(name).into_iter();
                    names.extend(entry.flat_map(Entry::rests_on).map(str::to_owned));
                }
            },
        );
        names
    }

    fn is_mentioned(&self, symbol: Symbol, mentioned: &BTreeSet<String>) -> bool {
        let name = self.written_name(symbol);
        name.is_none_or(|name| mentioned.contains(name))
    }

    /// A value and the conditions that it needs; those noted before stay as they are.
    pub(crate) fn value_and_conditions(
        &mut self,
        expression: &Expression,
    ) -> Result<(Value, Conditions), Diagnostic> {
        let outer = std::mem::take(&mut self.conditions);
        let value = self.value(expression)?;
        Ok((value, std::mem::replace(&mut self.conditions, outer)))
    }

    /// Notes what conditions become by a substitution.
    pub(crate) fn require_after(
        &mut self,
        needed: &Conditions,
        substitution: &Substitution,
        span: &Span,
    ) -> Result<(), Diagnostic> {
        let needed = needed
            .substitute(substitution, &mut self.ring)
            .map_err(|error| algebra(error, span))?;
        self.conditions.extend(&needed);
        Ok(())
    }

    /// What a place replaces by what; what must hold for it to exist is noted.
    pub fn substitution(&mut self, place: &Place, span: &Span) -> Result<Substitution, Diagnostic> {
        let images = self.images_of(place, span)?;
        Ok(images
            .into_iter()
            .map(|(symbol, image)| {
                self.conditions.extend(&image.conditions);
                (symbol, image.value)
            })
            .collect())
    }

    fn images_of(&mut self, place: &Place, span: &Span) -> Result<Images, Diagnostic> {
        let (name, here) = match place {
            Place::Replacements(replacements) => return self.read_replacements(replacements, span),
            Place::Named(name) => (&name.value, &name.span),
        };
        let (replacements, conditions) = match self.scope.get(name).map(|entry| &entry.meaning) {
            Some(Meaning::Substitution { sources, .. })
                if !sources.is_empty() && self.rests_on_twin(name) =>
            {
                return Err(algebra(AlgebraError::NotReal, span)
                    .with_label("this solution was found for a real number, which is replaced"));
            }
            Some(Meaning::Substitution {
                replacements,
                conditions,
                ..
            }) => (replacements.clone(), conditions.clone()),
            Some(_) => {
                let message = format!("`{name}` is not a substitution");
                return Err(
                    Diagnostic::new(DiagnosticKind::Arguments, here.clone(), message)
                        .with_label("cannot be used behind `at`")
                        .with_help(
                            "write `at (x = 0)`, or declare the replacements with `substitution`",
                        ),
                );
            }
            None => return Err(unknown(name, &self.scope, here)),
        };
        // It means the same until more is assumed, or a name is read as a complex one.
        let assumed = self.ring.assumptions().polynomials().len();
        let known = self.substitutions.get(&name.ascii);
        let known = known.filter(|known| known.assumed == assumed && self.twins.is_empty());
        if let Some(known) = known {
            return Ok(known.images.clone());
        }
        // The arguments of a call mean nothing where the substitution was declared.
        self.arguments.push(BTreeMap::new());
        let images = self.read_replacements(&replacements, span);
        self.arguments.pop();
        let mut images = images?;
        images
            .values_mut()
            .for_each(|image| image.conditions.extend(&conditions));
        if self.twins.is_empty() {
            let known = KnownSubstitution {
                images: images.clone(),
                assumed,
            };
            self.substitutions.insert(name.ascii.clone(), known);
        }
        Ok(images)
    }

    /// Values as a substitution, where the document's assumptions admit them.
    ///
    /// # Errors
    ///
    /// A [`Diagnostic`] where they do not, or where something is not free to have a value.
    pub fn admit(
        &mut self,
        values: &[Replacement],
        span: &Span,
    ) -> Result<Substitution, Diagnostic> {
        let images = values_of(&self.images(values)?);
        self.admit_images(&images, span)?;
        Ok(images)
    }

    /// Sees that no assumption is certain to be broken.
    fn admit_images(&mut self, images: &Substitution, span: &Span) -> Result<(), Diagnostic> {
        let is_possible = |found: Signs, assumed: Signs| found.intersection(assumed) != Signs::NONE;
        let Some([assumption, _]) = self.broken_assumption(images, is_possible, span)? else {
            return Ok(());
        };
        let message = format!("this contradicts the assumption {assumption}");
        Err(
            Diagnostic::new(DiagnosticKind::Arguments, span.clone(), message)
                .with_label("excluded by the document")
                .with_help("give a value that the document's assumptions allow"),
        )
    }

    fn read_replacements(
        &mut self,
        replacements: &[Replacement],
        span: &Span,
    ) -> Result<Images, Diagnostic> {
        check_replacements(replacements.len(), span)?;
        let images = self.images(replacements)?;
        let values = values_of(&images);
        let place = replacements
            .iter()
            .find(|replacement| !replacement.value.span.is_empty());
        let place = place.map_or(span, |replacement| &replacement.value.span);
        match self.trusts_replacements {
            true => self.admit_images(&values, place)?,
            false => self.respect_assumptions(&values, |signs| signs, place)?,
        }
        Ok(images)
    }

    /// The symbols that are replaced, and by what.
    fn images(&mut self, replacements: &[Replacement]) -> Result<Images, Diagnostic> {
        let mut images = Images::new();
        for replacement in replacements {
            let outer = std::mem::take(&mut self.conditions);
            let image = self.image(replacement);
            let conditions = std::mem::replace(&mut self.conditions, outer);
            let (symbol, value) = image?;
            if images.insert(symbol, Image { value, conditions }).is_some() {
                let message = "this is replaced twice";
                return Err(Diagnostic::new(
                    DiagnosticKind::Duplicate,
                    replacement.target.span.clone(),
                    message,
                )
                .with_label("replaced again")
                .with_help("replace it once; replacements in one `at` are carried out together"));
            }
        }
        Ok(images)
    }

    /// A symbol that is replaced, and by what.
    fn image(&mut self, replacement: &Replacement) -> Result<(Symbol, Fraction), Diagnostic> {
        let Replacement { target, value } = replacement;
        let quantity = self.scalar(target)?;
        let symbol = self.symbol(&quantity, &target.span)?;
        let image = self.scalar(value)?;
        // A bare number is read in the SI unit of what it replaces.
        let bare = image.value.as_constant().is_some() && image.unit == Some(Unit::one());
        if !bare {
            common_unit(&quantity.unit, &image.unit)
                .map_err(|error| unlike(error, target, value))?;
        }
        Ok((symbol, image.value))
    }

    /// Sees that what is assumed of symbols remains true, as far as wanted, of what replaces them: roots
    /// and signs were found with it.
    pub(crate) fn respect_assumptions(
        &mut self,
        substitution: &Substitution,
        wanted: fn(Signs) -> Signs,
        place: &Span,
    ) -> Result<(), Diagnostic> {
        let follows = |found: Signs, assumed: Signs| found.is_within(wanted(assumed));
        let Some([assumption, wanted]) = self.broken_assumption(substitution, follows, place)?
        else {
            return Ok(());
        };
        let message = format!("this need not respect the assumption {assumption}");
        Err(
            Diagnostic::new(DiagnosticKind::Arguments, place.clone(), message)
                .with_label("what was found by the assumption may not hold here")
                .with_help(format!(
                    "declare or assume that {wanted}, or replace it by something for which that is known"
                )),
        )
    }

    /// The first assumption whose signs are not accepted after a substitution, given those that are
    /// found then and those that are assumed; and what would have to be known.
    fn broken_assumption(
        &mut self,
        substitution: &Substitution,
        accepts: impl Fn(Signs, Signs) -> bool,
        span: &Span,
    ) -> Result<Option<[String; 2]>, Diagnostic> {
        let wrap = |error| algebra(error, span);
        let assumed: Vec<(Polynomial, Signs)> = {
            let assumptions = self.ring.assumptions();
            let symbols = substitution.keys();
            let of_symbols =
                symbols.map(|symbol| (Polynomial::symbol(*symbol), assumptions.of_symbol(*symbol)));
            of_symbols
                .chain(assumptions.polynomials().iter().cloned())
                .collect()
        };
        let mut replacing = Replacing::by(substitution);
        for (polynomial, signs) in assumed {
            let element = Fraction::from(polynomial.clone());
            let image = replacing.image(&element, &mut self.ring).map_err(wrap)?;
            if image == element {
                continue;
            }
            let found = self.ring.signs(&image).map_err(wrap)?;
            if !accepts(found, signs) {
                let assumption = self.assumption(&polynomial, signs).map_err(wrap)?;
                let shown = self.presenter().element(&image).map_err(wrap)?;
                let shown = Notation::Unicode.expression(&shown);
                return Ok(Some([assumption, format!("{shown} {signs}")]));
            }
        }
        Ok(None)
    }

    /// What is assumed of a polynomial, as one writes it: `0 < m`, `l < r`.
    fn assumption(&self, polynomial: &Polynomial, signs: Signs) -> Result<String, AlgebraError> {
        let written = |polynomial: &Polynomial| {
            let shown = self.presenter().polynomial(polynomial)?;
            Ok::<_, AlgebraError>(Notation::Unicode.expression(&shown))
        };
        let terms = polynomial.terms().iter().cloned();
        let (above, below): (Vec<_>, Vec<_>) =
            terms.partition(|(_, coefficient)| *coefficient > Integer::ZERO);
        if below.is_empty() {
            return Ok(format!("{} {signs}", written(polynomial)?));
        }
        let above = written(&Polynomial::from_terms(above))?;
        let below = written(&-&Polynomial::from_terms(below))?;
        let sign = signs.to_string();
        Ok(format!("{above} {} {below}", sign.trim_end_matches(" 0")))
    }
}

/// What replaces what, without conditions.
fn values_of(images: &Images) -> Substitution {
    let values = images.iter();
    values
        .map(|(symbol, image)| (*symbol, image.value.clone()))
        .collect()
}

/// What replaces something has another unit.
fn unlike(error: QuantityError, target: &Expression, value: &Expression) -> Diagnostic {
    let span = target.span.start..value.span.end.max(target.span.end);
    let QuantityError::Units(wanted, given) = error else {
        return quantity_error(error, &span);
    };
    let shown = Notation::Unicode.expression(target);
    let message = format!("{shown} is in {wanted}, its value in {given}");
    Diagnostic::new(DiagnosticKind::Unit, span, message)
        .with_label(format!("the value must be in {wanted} too"))
        .with_help(format!(
            "give a value in {wanted}, or a bare number, which is read in SI units"
        ))
}

/// A name behind `at` that the document does not declare.
fn unknown(name: &Name, scope: &Scope, span: &Span) -> Diagnostic {
    let substitutions = scope
        .entries()
        .filter(|entry| matches!(entry.meaning, Meaning::Substitution { .. }));
    let names = substitutions.map(|entry| entry.name.unicode.as_str());
    let help = match nearest(&name.unicode, names) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("declare it with `substitution {name}: x = 0`"),
    };
    let message = format!("there is no substitution `{name}`");
    Diagnostic::new(DiagnosticKind::UnknownName, span.clone(), message)
        .with_label("unknown name behind `at`")
        .with_help(help)
}
