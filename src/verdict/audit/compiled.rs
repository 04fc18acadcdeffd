//! What a document wants compiled: systems, and evaluators.

use crate::derivation::scope::Meaning;
use crate::language::diagnostic::{Diagnostic, DiagnosticKind, nearest};
use crate::language::evaluator::{Evaluator, Output};
use crate::language::mention::Mention;
use crate::language::syntax::{
    Approximated, Expression, Name, Quantities, Span, Spanned, Statement, StatementKind,
};
use crate::language::system::System;
use crate::language::unit::Unit;

use super::reader::{Read, Reader};

impl Reader<'_> {
    /// Takes up what a statement wants compiled, if it wants that.
    pub(super) fn ask_for(
        &mut self,
        statement: &Statement,
        read: &mut Read,
    ) -> Result<bool, Diagnostic> {
        if let Some(system) = System::of(statement)? {
            self.require_new(&system.name, &system.span, read)?;
            self.elaborator.check_system(&system)?;
            self.systems.push(system.clone());
            read.systems.push(system);
            return Ok(true);
        }
        let Some(evaluator) = Evaluator::of(statement, &self.evaluators)? else {
            return Ok(false);
        };
        self.require_new(&evaluator.name, &evaluator.span, read)?;
        self.declare_outputs(&evaluator)?;
        self.check_use(&evaluator, statement)?;
        self.evaluators.push(evaluator.clone());
        read.evaluators.push(evaluator);
        Ok(true)
    }

    /// What an evaluator says of its use must be possible: that which it inherits was checked before.
    fn check_use(
        &mut self,
        evaluator: &Evaluator,
        statement: &Statement,
    ) -> Result<(), Diagnostic> {
        if let StatementKind::Evaluator { conditions, .. } = &statement.kind {
            for condition in conditions {
                self.check_condition(condition)?;
            }
        }
        match &evaluator.approximated {
            Some(approximated) => self.check_approximated(evaluator, approximated),
            None => Ok(()),
        }
    }

    /// Gives the outputs of an evaluator the meaning that they have where they are named: what is wrong in them is wrong
    /// here.
    fn declare_outputs(&mut self, evaluator: &Evaluator) -> Result<(), Diagnostic> {
        for output in &evaluator.outputs {
            let value = evaluator.name.output(&output.name);
            let span = evaluator.span.clone();
            self.declare_value(Spanned { value, span }, output.expression.clone())?;
        }
        Ok(())
    }

    /// Gives the matrices of systems that a statement names the meaning that they have; they were checked with their
    /// system.
    pub(super) fn declare_matrices(&mut self, statement: &Statement) -> Result<(), Diagnostic> {
        for Mention { name: value, .. } in statement.mentions() {
            if self.elaborator.scope.get(&value).is_none()
                && let Some(matrix) = self.matrix_named(&value)
            {
                let span = statement.span.clone();
                self.declare_value(Spanned { value, span }, matrix)?;
            }
        }
        Ok(())
    }

    fn matrix_named(&self, name: &Name) -> Option<Expression> {
        let (owner, matrix) = name.of_output()?;
        let mut systems = self.systems.iter();
        let owner = systems.find(|own| own.name == owner)?;
        owner.matrix_named(&matrix)
    }

    fn declare_value(
        &mut self,
        name: Spanned<Name>,
        expression: Expression,
    ) -> Result<(), Diagnostic> {
        self.elaborator.fresh();
        let value = self.elaborator.value(&expression)?;
        let meaning = Meaning::Definition {
            expression,
            value,
            conditions: std::mem::take(&mut self.elaborator.conditions),
        };
        self.elaborator.scope.declare(&name, meaning, None)
    }

    /// A name is that of one system or evaluator.
    fn require_new(&self, name: &Name, span: &Span, read: &Read) -> Result<(), Diagnostic> {
        let known = |systems: &[System], evaluators: &[Evaluator]| {
            let systems = systems.iter().map(|own| (&own.name, &own.span));
            let mut all = systems.chain(evaluators.iter().map(|own| (&own.name, &own.span)));
            all.find(|(own, _)| *own == name)
                .map(|(_, span)| span.clone())
        };
        if known(&self.systems, &self.evaluators).is_none() {
            return Ok(());
        }
        let message = format!("`{name}` is the name of a system or an evaluator already");
        let diagnostic = Diagnostic::new(DiagnosticKind::Duplicate, span.clone(), message)
            .with_label("the same name again")
            .with_help("give each of them a name of its own");
        Err(match known(&read.systems, &read.evaluators) {
            Some(first) => diagnostic.with_secondary(first, "the first one"),
            None => diagnostic,
        })
    }

    fn system_named(&self, name: &Spanned<Name>) -> Result<&System, Diagnostic> {
        let mut systems = self.systems.iter();
        if let Some(system) = systems.find(|own| own.name == name.value) {
            return Ok(system);
        }
        let names = self.systems.iter().map(|own| own.name.unicode.as_str());
        let help = match nearest(&name.value.unicode, names) {
            Some(near) => format!("did you mean `{near}`?"),
            None => "declare it above with `system`".to_string(),
        };
        let message = format!("there is no system `{}` yet", name.value);
        let kind = DiagnosticKind::UnknownName;
        Err(Diagnostic::new(kind, name.span.clone(), message)
            .with_label("unknown system")
            .with_help(help))
    }

    /// An evaluator must have as many outputs as the system has numbers that they are close to, or as a polynomial
    /// with such roots has coefficients, in their units.
    fn check_approximated(
        &self,
        evaluator: &Evaluator,
        approximated: &Approximated,
    ) -> Result<(), Diagnostic> {
        let system = self.system_named(&approximated.system)?;
        let count = system.coordinates.len();
        let wanted = match (approximated.by_roots, approximated.quantities) {
            (false, Quantities::RealParts) => count,
            (true, _) | (_, Quantities::Eigenvalues) => 2 * count,
        };
        let units = self.units(evaluator);
        if units.len() != wanted {
            let found = units.len();
            return Err(outputs_do_not_fit(evaluator, approximated, found, wanted));
        }
        match approximated.by_roots {
            true => require_coefficients(&units),
            false => require_rates(&units),
        }
    }

    /// The units of all numbers of an evaluator whose outputs are declared.
    fn units<'e>(&self, evaluator: &'e Evaluator) -> Vec<Measured<'e>> {
        let mut units = Vec::new();
        for output in &evaluator.outputs {
            let entry = self
                .elaborator
                .scope
                .get(&evaluator.name.output(&output.name));
            if let Some(Meaning::Definition { value, .. }) = entry.map(|own| &own.meaning) {
                units.extend(value.entries().iter().map(|own| (output, own.unit.clone())));
            }
        }
        units
    }
}

/// A number of an evaluator: its output and, where it has one, its unit.
type Measured<'a> = (&'a Output, Option<Unit>);

fn require_rates(units: &[Measured<'_>]) -> Result<(), Diagnostic> {
    let rate = Unit::second().inverse();
    let known = units.iter();
    let mut known = known.filter_map(|(output, unit)| Some((output, unit.as_ref()?)));
    match known.find(|(_, unit)| **unit != rate) {
        Some((output, unit)) => Err(no_rate(output, unit)),
        None => Ok(()),
    }
}

/// The k-th coefficient of each half must be in the unit of a rate to the power k.
fn require_coefficients(units: &[Measured<'_>]) -> Result<(), Diagnostic> {
    let rate = Unit::second().inverse();
    let degree = units.len() / 2;
    for half in units.chunks(degree) {
        let mut wanted = Unit::one();
        for (place, (output, unit)) in half.iter().enumerate() {
            wanted = wanted.product(&rate);
            if let Some(unit) = unit.as_ref().filter(|unit| **unit != wanted) {
                let power = degree - 1 - place;
                return Err(no_coefficient(output, unit, &wanted, power));
            }
        }
    }
    Ok(())
}

fn no_coefficient(output: &Output, unit: &Unit, wanted: &Unit, power: usize) -> Diagnostic {
    let message = format!(
        "roots are in 1/s, so the coefficient of power {power} is in {wanted}, and `{}` gives it in {unit}",
        output.name
    );
    let span = output.expression.span.clone();
    Diagnostic::new(DiagnosticKind::Unit, span, message)
        .with_label("of another unit")
        .with_help(COEFFICIENTS)
}

/// What is read where an evaluator approximates by roots.
const COEFFICIENTS: &str = "give the coefficients below the leading 1, that of the highest power first: all real parts, and then all imaginary parts";

fn no_rate(output: &Output, unit: &Unit) -> Diagnostic {
    let message = format!("eigenvalues are in 1/s, and `{}` is in {unit}", output.name);
    Diagnostic::new(
        DiagnosticKind::Unit,
        output.expression.span.clone(),
        message,
    )
    .with_label("of another unit")
    .with_help("a real part is a rate of growth: the damping −c of a mass m has −c/(2*m)")
}

fn outputs_do_not_fit(
    evaluator: &Evaluator,
    approximated: &Approximated,
    found: usize,
    wanted: usize,
) -> Diagnostic {
    let (system, span) = (&approximated.system.value, &approximated.system.span);
    let name = &evaluator.name;
    let (message, help) = match approximated.quantities {
        _ if approximated.by_roots => (
            format!(
                "a polynomial with a root for each coordinate of `{system}` has {wanted} real and imaginary parts of coefficients, and `{name}` has {found} outputs"
            ),
            COEFFICIENTS,
        ),
        Quantities::RealParts => (
            format!(
                "`{system}` has a pair of eigenvalues for each coordinate, so {wanted} in all, and `{name}` has outputs for {found}"
            ),
            "give one real part for each coordinate",
        ),
        Quantities::Eigenvalues => (
            format!(
                "the eigenvalues of `{system}` are {wanted} numbers, and the outputs of `{name}` {found}"
            ),
            "give a real part for each coordinate, and then as many imaginary parts",
        ),
    };
    Diagnostic::new(DiagnosticKind::Shape, span.clone(), message)
        .with_label("they do not fit")
        .with_help(help)
}
