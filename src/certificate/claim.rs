//! A claim as theorems, or why it is withheld.

use crate::algebra::arithmetic::Arithmetic;
use crate::derivation::assertion::Misfit;
use crate::derivation::matching::Matched;
use crate::derivation::scope::SymbolKind;
use crate::language::syntax::{
    Comparison, Expression, Matching, Name, Place, Statement, StatementKind,
};
use crate::verdict::claim::{Claim, Verdict};

use super::composer::{Composer, words};
use super::entry::{Entry, Kind, Subject};
use super::expression::Withheld;
use super::point::settings;
use super::theorem::{Rule, Theorem, comment};

/// What a theorem says, and how it is proved.
type Stated = (String, Rule);

/// The theorems of a claim.
type Theorems = (Kind, Vec<Stated>);

/// Adds the theorems of a claim and what became of it.
pub(super) fn add(composer: &mut Composer<'_>, claim: &Claim, statement: &Statement) {
    for side in [&claim.statement.left, &claim.statement.right] {
        composer.find_degrees(side);
    }
    composer.bring_up_to_date();
    let number = composer.entries.len();
    let id = plain(&claim.label.id);
    let theorems = theorems(composer, claim, statement);
    let heading = format!(
        "\n(* {} {} *)\n",
        claim.label.written(),
        words(&claim.statement)
    );
    composer.text(heading);
    let certificate = match theorems {
        Err(reason) => {
            composer.text(format!("(* withheld: {} *)\n", comment(&reason)));
            Err(reason)
        }
        Ok((kind, statements)) => {
            for (place, (statement, rule)) in statements.into_iter().enumerate() {
                let part = match place {
                    0 => String::new(),
                    _ => format!("_{}", place + 1),
                };
                let theorem = named(composer, format!("claim_{id}{part}"), statement, rule);
                composer.theorem(number, theorem);
            }
            Ok(kind)
        }
    };
    if let Some(statement) = control(composer, claim) {
        let control = named(composer, format!("control_{id}"), statement, Rule::Check);
        composer.control(control);
    }
    composer.entries.push(Entry {
        id: claim.label.id.clone(),
        label: claim.label.written(),
        line: claim.line,
        subject: Subject::Claim(claim.verdict),
        certificate,
    });
}

/// Adds the theorems of a matching: what its solution leaves of the powers of both polynomials.
pub(super) fn add_matching(composer: &mut Composer<'_>, matched: &Matched, matching: &Matching) {
    composer.bring_up_to_date();
    let heading = format!(
        "\n(* {} what the solution leaves, power by power *)\n",
        matched.label.written()
    );
    composer.text(heading);
    let residuals = residuals(composer, matched, matching);
    let number = composer.entries.len();
    let certificate = residuals.map(|statements| {
        let id = plain(&matched.label.id);
        for (power, statement) in statements {
            let name = format!("matching_{id}_{power}");
            let theorem = named(composer, name, statement, Rule::Check);
            composer.theorem(number, theorem);
        }
        Kind::Matching
    });
    composer.entries.push(Entry {
        id: matched.label.id.clone(),
        label: matched.label.written(),
        line: matched.line,
        subject: Subject::Matching,
        certificate,
    });
}

/// Of each power: the coefficients differ by nothing, by what is neglected, or by terms of a known order.
fn residuals(
    composer: &Composer<'_>,
    matched: &Matched,
    matching: &Matching,
) -> Result<Vec<(u32, String)>, Withheld> {
    let writer = &composer.writer;
    let name = Expression::name(matched.variable.clone());
    let at = |expression: &Expression| expression.clone().at(Place::named(matched.name.clone()));
    let (exact, variable) = (writer.argument(&matching.exact)?, writer.argument(&name)?);
    let assumed = writer.argument(&at(&matching.assumed))?;
    let given = composer.given(&[format!(
        "non_zero {}",
        writer.argument(&matched.determinant)?
    )]);
    let small = matched.small.iter().map(|name| {
        Ok(format!(
            "[{}]",
            writer.argument(&Expression::name(name.clone()))?
        ))
    });
    let small = small.collect::<Result<Vec<_>, Withheld>>()?.join("; ");
    let mut statements = Vec::new();
    for row in &matched.table {
        let power = row.power;
        let left = format!(
            "coefficient {exact} {variable} {power} - coefficient {assumed} {variable} {power}"
        );
        let neglected = matched.neglected.iter().filter(|own| own.power == power);
        let neglected = neglected.map(|own| {
            let expression = at(&own.expression);
            Ok(format!(
                "{}*{}",
                writer.argument(&own.factor)?,
                writer.argument(&expression)?
            ))
        });
        let neglected = neglected.collect::<Result<Vec<_>, Withheld>>()?;
        statements.push((
            power,
            match row.order {
                _ if !neglected.is_empty() => {
                    format!("{given} |=\n  {left}\n  == {}", neglected.join(" + "))
                }
                None => format!("{given} |=\n  {left}\n  == 0"),
                Some(order) if order > 0 && !small.is_empty() => {
                    format!(
                        "{given} |=\n  truncate ({left}) (blocks [{small}]) {}\n  == 0",
                        order - 1
                    )
                }
                Some(_) => continue,
            },
        ));
    }
    Ok(statements)
}

/// A theorem under a name that nothing else has.
pub(super) fn named(
    composer: &mut Composer<'_>,
    name: String,
    statement: String,
    rule: Rule,
) -> Theorem {
    let name = composer.writer.names.fresh(&name);
    Theorem {
        name,
        statement,
        rule,
    }
}

fn plain(id: &str) -> String {
    let plain = |own: char| {
        if own.is_ascii_alphanumeric() {
            own
        } else {
            '_'
        }
    };
    id.chars().map(plain).collect()
}

fn theorems(
    composer: &mut Composer<'_>,
    claim: &Claim,
    statement: &Statement,
) -> Result<Theorems, Withheld> {
    match claim.verdict {
        Verdict::Holds | Verdict::HoldsWhere => holds(composer, claim, statement),
        Verdict::Approximate => approximate(composer, claim, statement),
        Verdict::Refuted => refuted(composer, claim),
        Verdict::IllFormed => ill_formed(composer, claim),
        Verdict::Undecided | Verdict::Skipped => Err("it has no verdict".into()),
    }
}

/// What is refuted, only approximate or ill-formed, as if it held.
fn control(composer: &Composer<'_>, claim: &Claim) -> Option<String> {
    let is_control = matches!(
        claim.verdict,
        Verdict::Refuted | Verdict::Approximate | Verdict::IllFormed
    );
    let given = given(composer, claim).ok().filter(|_| is_control)?;
    let (left, right) = (&claim.statement.left, &claim.statement.right);
    let side = |expression: &Expression| composer.writer.side(expression).ok();
    let sign = sign(claim.statement.comparison);
    Some(format!(
        "{given} |=\n  {}\n  {sign} {}",
        side(left)?,
        side(right)?
    ))
}

fn given(composer: &Composer<'_>, claim: &Claim) -> Result<String, Withheld> {
    Ok(composer.given(&composer.conditions(&claim.conditions)?))
}

fn holds(
    composer: &Composer<'_>,
    claim: &Claim,
    statement: &Statement,
) -> Result<Theorems, Withheld> {
    let given = given(composer, claim)?;
    let (left, right) = (&claim.statement.left, &claim.statement.right);
    let sign = sign(claim.statement.comparison);
    let side = |expression: &Expression| composer.writer.side(expression);
    let first = format!("{given} |=\n  {}\n  {sign} {}", side(left)?, side(right)?);
    if let StatementKind::Eigenpair { vector, .. } = &statement.kind {
        let vector = composer.writer.argument(vector)?;
        let second = format!("{given} |= transpose {vector}*{vector} > 0");
        let both = [first, second].map(|own| (own, Rule::Check));
        return Ok((Kind::Eigenpair, both.into()));
    }
    let kind = match claim.statement.comparison {
        Comparison::Equal => Kind::Equation,
        _ => Kind::Inequality,
    };
    let rule = squares(composer, claim).map_or(Rule::Check, Rule::Squares);
    Ok((kind, vec![(first, rule)]))
}

/// What is squared in the difference of the sides of an inequality: it shows a sign that no other does.
fn squares(composer: &Composer<'_>, claim: &Claim) -> Option<String> {
    let (left, right) = claim.sides.as_ref()?;
    let ring = &composer.audit.elaborator.ring;
    if claim.statement.comparison == Comparison::Equal {
        return None;
    }
    let (left, right) = (left.entries().first()?, right.entries().first()?);
    let difference = ring.difference(&left.value, &right.value).ok()?;
    let factors = ring.factored(&difference).ok()?.factors;
    let squared = factors
        .iter()
        .filter(|(factor, exponent)| factor.len() > 1 && exponent % 2 == 0);
    let presenter = composer.audit.elaborator.presenter();
    let written = squared.map(|(factor, _)| {
        let factor = presenter.polynomial(factor).ok()?;
        composer.writer.side(&factor).ok()
    });
    let written = written.collect::<Option<Vec<_>>>()?;
    (!written.is_empty()).then(|| format!("(real_parts [{}])", written.join("; ")))
}

fn approximate(
    composer: &mut Composer<'_>,
    claim: &Claim,
    statement: &Statement,
) -> Result<Theorems, Withheld> {
    let given = given(composer, claim)?;
    let StatementKind::Assertion {
        order: Some(order), ..
    } = &statement.kind
    else {
        return Err("its order is not known".into());
    };
    let small = order.small.iter().map(|name| {
        composer
            .writer
            .argument(&Expression::name(name.value.clone()))
    });
    let order = order.order.value;
    let small = small.map(|own| own.map(|own| format!("[{own}]")));
    let small = small.collect::<Result<Vec<_>, _>>()?.join("; ");
    let truncated = |side: &Expression, order: u32| {
        let side = composer.writer.argument(side)?;
        Ok::<_, Withheld>(format!("truncate {side} (blocks [{small}]) {order}"))
    };
    let (left, right) = (&claim.statement.left, &claim.statement.right);
    let equal = format!(
        "{given} |=\n  {}\n  == {}",
        truncated(left, order)?,
        truncated(right, order)?
    );
    if composer.leaves_out_assumptions {
        return Err("an assumption of the document is left out".into());
    }
    let (beyond, names) = claim
        .neglected
        .as_ref()
        .ok_or("no term beyond its order is known")?;
    let differ = format!(
        "{given} refutes\n  {}\n  == {}",
        truncated(left, *beyond)?,
        truncated(right, *beyond)?
    );
    // What is small is replaced by numbers, so that it is the measure of an angle that counts.
    let scope = &composer.audit.elaborator.scope;
    let is_angle = |name: &&Name| {
        let kind = scope.kind_of(&name.ascii);
        matches!(
            kind,
            Some(SymbolKind::Angle | SymbolKind::AngularCoordinate)
        )
    };
    let angles = names.iter().filter(is_angle);
    let measures = angles.map(|name| {
        let name = composer.writer.argument(&Expression::name(name.clone()))?;
        Ok(format!("Is {name} 2"))
    });
    let measures = measures.collect::<Result<Vec<_>, Withheld>>()?;
    let (point, references) = composer.point(&measures, true);
    let beyond = (differ, Rule::Point(point, references));
    Ok((Kind::Approximation, vec![(equal, Rule::Check), beyond]))
}

fn sign(comparison: Comparison) -> &'static str {
    match comparison {
        Comparison::Equal => "==",
        Comparison::Less => "<",
        Comparison::LessOrEqual => "<=",
        Comparison::Greater => ">",
        Comparison::GreaterOrEqual => ">=",
    }
}

fn refuted(composer: &mut Composer<'_>, claim: &Claim) -> Result<Theorems, Withheld> {
    let witness = claim.witness.as_ref().ok_or("no assignment is shown")?;
    if composer.leaves_out_assumptions {
        return Err("an assumption of the document is left out".into());
    }
    if witness.degree.is_some() {
        return Err("it refutes an approximation".into());
    }
    let given = composer.given(&[]);
    let sign = sign(claim.statement.comparison);
    let left = composer.writer.side(&claim.statement.left)?;
    let right = composer.writer.side(&claim.statement.right)?;
    let text = format!("{given} refutes\n  {left}\n  {sign} {right}");
    let settings = settings(witness, &composer.writer)?;
    let (point, references) = composer.point(&settings, false);
    let rule = Rule::Point(point, references);
    Ok((Kind::Refutation, vec![(text, rule)]))
}

fn ill_formed(composer: &mut Composer<'_>, claim: &Claim) -> Result<Theorems, Withheld> {
    let (left, right) = (&claim.statement.left, &claim.statement.right);
    let misfit = claim
        .misfit
        .as_ref()
        .ok_or("what does not fit is not known")?;
    let rule = match misfit {
        Misfit::Units(_) => Rule::Units,
        Misfit::Shapes => Rule::Shapes,
    };
    let statement = composer.misfit(left, right, misfit)?;
    Ok((Kind::IllFormed, vec![(statement, rule)]))
}
