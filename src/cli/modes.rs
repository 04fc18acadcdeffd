//! `sextic modes`: the modes of one section by one method.

use std::collections::BTreeMap;
use std::path::Path;

use clap::{Args, ValueEnum};
use num_complex::Complex;
use sextic_codegen::language::literal::Decimal;

use crate::algebra::number::Rational;
use crate::compile::fixed::{Fixed, number_of};
use crate::report::modes::{DampingCoefficient, ModeFound, ModesFound, Moving, Reading, Subject};
use crate::report::{json, text};
use crate::stability::case::Case;
use crate::stability::closed_form::{ClosedForm, closed_form};
use crate::stability::coefficient_table::CoefficientTable;
use crate::stability::comparison::{Open, angle as shown_angle};
use crate::stability::eigenvalue::{Eigenvalue, Spectrum};
use crate::stability::error::StabilityError;
use crate::stability::exact_modes::ExactModes;
use crate::stability::exact_section::ExactSection;
use crate::stability::limitation::Limitation;
use crate::stability::mean_twist::Twist;
use crate::stability::model::Model;
use crate::stability::quantity::{names, needed, parameters};
use crate::stability::section::{Parameters, Section};
use crate::stability::sections::Sections;
use crate::stability::system::instance::Instance;
use crate::stability::tracking::{Mode, places};
use crate::stability::uniform_form::uniform_form;
use crate::stability::variable::Variable;
use crate::stability::verdict::{Doubt, Verdict, exact_verdict, verdict};
use crate::stability::{companion, exact_modes, state_matrix};

use super::Outcome;
use super::case::{set_case_and_files, warn_of};
use super::generate::{FixedParser, unknown};
use super::output::{Results, finish, wrong};
use super::system::{Chosen, Which, numbers, refuse};
use super::vocabulary::Vocabulary;

/// Computes the modes of one section in the wind, or of a system that a document derives
///
/// With a case: its section at one angle of attack. With a document or --system: the system that the document
/// names so, whose quantities have the names of the document. Else a section as He & Macdonald (2017) model
/// it, whose quantities are all given by --set.
///
/// Eigenvalues are in 1/s, one of each pair of conjugates: the real part is the growth, the imaginary
/// part the circular frequency. Quantities are in SI units, angles in radians (`alpha_g_deg` in degrees),
/// frequencies in rad/s (`f_x` in hertz), derivatives per radian; numbers are decimals or fractions. Whether
/// the section is stable is decided in exact arithmetic for the numbers as they are written; eigenvalues and
/// the bounds of their errors are those of the section whose quantities are the doubles nearest to them.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A case file, in TOML, or a Markdown document with a system; without one and without --system, a section
    /// in the wind
    #[arg(value_name = "CASE|DOC")]
    document: Option<String>,

    #[command(flatten)]
    which: Which,

    /// Of a case: the angle of attack, in degrees
    #[arg(long, value_name = "DEGREES", value_parser = angle, allow_hyphen_values = true)]
    alpha: Option<Fixed>,

    /// A quantity and its value, of a case by a name of `sextic sweep`; may be given several times
    #[arg(long, value_name = "NAME=VALUE", value_parser = FixedParser, allow_hyphen_values = true)]
    set: Vec<Fixed>,

    /// How the modes are found
    #[arg(long, value_enum, default_value_t = Method::State)]
    method: Method,

    /// Let the angle of attack follow the turn of the section
    #[arg(long)]
    aerodynamic_stiffness: bool,

    /// Show how each mode moves, too: x, y and r theta, the largest of them 1
    #[arg(long)]
    shapes: bool,

    /// How the numbers are written
    #[arg(long, value_enum, default_value_t = Results::Text)]
    format: Results,
}

/// How modes are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Method {
    /// By the closed forms (21) to (23): perfect tuning, no structural damping
    Closed,
    /// By a form that holds at every eccentricity, to second order in the damping
    Uniform,
    /// By the roots of the characteristic polynomial about a natural frequency, which loses no digits
    Exact,
    /// By the companion matrix of the characteristic polynomial (19)
    Companion,
    /// By the state matrix (16)
    State,
}

const EXAMPLES: &str = "\
Names:
  m, r, L_g, alpha_g, theta_0, omega_x, omega_y, omega_theta; zeta_x, zeta_y, zeta_theta unless the
  method is closed; U, and unless it is 0: rho, D, alpha_0, L_a, gamma_r, C_D, C_L, C_M, dC_D, dC_L,
  dC_M; in place of the last nine the entries of the scaled damping matrix (18) may be given by
  rows: S_xx, S_xy, S_xt, S_yx, S_yy, S_yt, S_tx, S_ty, S_tt

Errors:
  state, companion, exact  what rounding may cost; numbers are shown as far as they are certain
  closed, uniform          also what the formula leaves out; six digits are shown, however far off
  Both are bounds for the section whose quantities are the doubles nearest to the numbers given, or
  for a system of a document with the numbers as they are written. The verdict is for these numbers
  themselves, by whichever method the modes are found.

Shapes (state, companion, exact):
  The entries have an amplitude and a phase in degrees by which they are ahead of the largest, 1.
  They are computed in doubles and have no bound of their error.

Members of --format json:
  method       what found the eigenvalues: state, too, where it stands in for exact
  eigenvalues  re and im in 1/s; error, the bound above, in 1/s, or null where there is none;
               with --shapes also shape: x, y and r_theta, each with re and im, or null
  s3d          -4 m max(re)/(rho D U), of the coordinates that are free, or null without wind;
               s3d_error, the bound of its error
  verdict      stable, unstable or undecided, with its reason
  diverges     whether the stiffness of the turn is below 0: else what is unstable gallops
  coefficients of a case: C_D, C_L, C_M and their derivatives per radian, as the section has them
  within_errors  of a case with errors: verdict and s3d for all coefficients within them
  twist        of a case with a mean twist: deg, error_deg, stiffness (of the turn in the wind over
               that of its springs), balance (only, several, jump)
  warnings     what speaks against the method for this section, and what was given in vain

Examples:
  sextic modes --set m=3.5 --set r=0.0178 --set L_g=0.004 --set alpha_g=0.5 --set theta_0=0 \\
    --set omega_x=6 --set omega_y=5.3 --set omega_theta=5.4 \\
    --set zeta_x=0 --set zeta_y=0 --set zeta_theta=0 --set U=0
  sextic modes case.toml --alpha 68.5 --shapes
  sextic modes mine.md --system bridge --set U=40 --shapes
  sextic modes … --method exact --shapes --format json | jq .eigenvalues";

/// Finds the modes and writes them.
pub fn run(arguments: &Arguments) -> Outcome {
    let found = match (&arguments.document, &arguments.alpha) {
        (Some(path), _) if is_case(path) => of_case(arguments, Path::new(path)),
        (_, Some(_)) => Err(wrong(
            "`--alpha` is the angle of attack of a case, and no case is named",
            "name a case file, `sextic modes case.toml --alpha 68.5`; other angles are given by `--set`",
        )),
        _ if arguments.document.is_some() || arguments.which.system.is_some() => {
            of_system(arguments)
        }
        _ => found(arguments),
    };
    match found {
        Err(outcome) => outcome,
        Ok(found) => {
            let written = match arguments.format {
                Results::Text => text::modes(&found),
                Results::Json => json::modes(&found),
            };
            finish(&written, Outcome::AsExpected)
        }
    }
}

fn is_case(path: &str) -> bool {
    Path::new(path).extension().is_some_and(|own| own == "toml")
}

/// The angle of attack of a case.
fn angle(text: &str) -> Result<Fixed, String> {
    let value = number_of(text.trim()).ok_or("an angle is a number of degrees, such as 68.5")?;
    Ok(Fixed {
        name: Variable::ANGLE.name.to_string(),
        value,
        text: text.to_string(),
    })
}

/// The modes of a case at one angle of attack.
fn of_case(arguments: &Arguments, path: &Path) -> Result<ModesFound, Outcome> {
    if arguments.which.system.is_some() {
        return Err(wrong(
            "a case has no system of a document",
            "leave `--system` away, or name the document",
        ));
    }
    let set = arguments.set.iter().chain(&arguments.alpha).cloned();
    let (mut case, table, _) = set_case_and_files(path, &set.collect::<Vec<_>>(), &[])?;
    warn_of(&case, &table);
    case.parameters.aerodynamic_stiffness |= arguments.aerodynamic_stiffness;
    let (section, reading, twist) = at_its_angle(&case, &table)?;
    let found = by_method(arguments, &section, &ExactSection::from(&section))?;
    Ok(ModesFound {
        reading: Some(reading),
        twist,
        ..found
    })
}

/// The section of a case at its only angle, with what its table gives there, and its twist.
fn at_its_angle(
    case: &Case,
    table: &CoefficientTable,
) -> Result<(Section, Reading, Option<Twist>), Outcome> {
    let angle = case.angles.from;
    if case.angles.to > angle {
        return Err(wrong(
            &format!("{} has several angles of attack", case.file),
            &format!(
                "name one of them in degrees: `--alpha {}`",
                shown_angle(middle(case))
            ),
        ));
    }
    let refuse = |error| super::case::refuse(&error);
    let sections = Sections::new(case, table).map_err(refuse)?;
    sections.curves().at(angle).map_err(|outside| {
        wrong(
            &format!("{}: {outside}", table.file()),
            "name an angle of the table with `--alpha`",
        )
    })?;
    let (section, twist) = sections.at(angle, table).map_err(refuse)?;
    let open = Open::of(case, table).map_err(refuse)?;
    let errors = open.filter(Open::has_errors);
    let reading = Reading {
        angle,
        coefficients: section.parameters().forces.coefficients().copied(),
        within_errors: errors.map(|own| own.tolerance(angle, &section)),
    };
    Ok((section, reading, twist))
}

/// An angle in the middle of a sweep.
fn middle(case: &Case) -> f64 {
    let angles = case.angles.values();
    angles[angles.len() / 2]
}

fn impossible(error: StabilityError) -> Outcome {
    wrong(&error.to_string(), "`sextic modes --help` names the units")
}

/// The modes of a system that a document derives.
fn of_system(arguments: &Arguments) -> Result<ModesFound, Outcome> {
    if !matches!(arguments.method, Method::State | Method::Companion) {
        return Err(wrong(
            "the modes of a system of a document are found by its state matrix or its companion matrix",
            "`--method state` or `--method companion`; `sextic compare` has its closed forms",
        ));
    }
    if arguments.aerodynamic_stiffness {
        return Err(wrong(
            "the stiffness of a system is what its document says",
            "leave `--aerodynamic-stiffness` away",
        ));
    }
    let document = arguments.document.as_deref();
    numbers(&arguments.set, &[])?;
    let chosen = arguments.which.choose(document, &[&arguments.set])?;
    let values = chosen.numbers(&arguments.set, &[])?;
    let Chosen { system, shown, .. } = chosen;
    let instance = system.at(&values).map_err(|error| refuse(&error))?;
    let modes = match arguments.method {
        Method::Companion => by_companion(&instance)?,
        _ => by_state(&instance, &shown, arguments.shapes)?,
    };
    Ok(ModesFound {
        subject: Subject::System,
        method: match arguments.method {
            Method::Companion => "companion",
            _ => "state",
        },
        is_formula: false,
        modes,
        damping_coefficient: None,
        verdict: instance.verdict(),
        diverges: instance.diverges() == Some(true),
        reading: None,
        warnings: Vec::new(),
        twist: None,
    })
}

fn by_companion(instance: &Instance<'_>) -> Result<Vec<ModeFound>, Outcome> {
    let spectrum = instance.companion().map_err(|error| refuse(&error))?;
    let modes = spectrum.one_of_each_pair().map(|own| ModeFound {
        value: own.value,
        error: Some(own.error),
        shape: None,
    });
    Ok(modes.collect())
}

fn by_state(
    instance: &Instance<'_>,
    shown: &[String],
    with_shapes: bool,
) -> Result<Vec<ModeFound>, Outcome> {
    let modes = instance.modes().map_err(|error| refuse(&error))?;
    let names = &instance.system().coordinates;
    let moving = |((shown, name), entry): ((&String, &String), Complex<f64>)| Moving {
        shown: shown.clone(),
        name: name.clone(),
        entry,
    };
    let shape = |shape: Option<Vec<Complex<f64>>>| {
        let named = shown.iter().zip(names);
        shape.map(|entries| named.zip(entries).map(moving).collect())
    };
    let modes = modes.into_iter().map(|own| ModeFound {
        value: own.eigenvalue.value,
        error: Some(own.eigenvalue.error),
        shape: with_shapes.then(|| shape(own.shape)),
    });
    Ok(modes.collect())
}

fn found(arguments: &Arguments) -> Result<ModesFound, Outcome> {
    let (exact, values) = values(&arguments.set)?;
    let missing: Vec<&str> = needed(&values, arguments.method != Method::Closed)
        .into_iter()
        .filter(|name| !values.contains_key(*name))
        .collect();
    if !missing.is_empty() {
        return Err(wrong(
            &format!("the modes need {} too", missing.join(", ")),
            "`--set name=value`, in SI units and radians, or by `name_deg` in degrees",
        ));
    }
    let aerodynamic_stiffness = arguments.aerodynamic_stiffness;
    let section = Section::new(Parameters {
        aerodynamic_stiffness,
        ..parameters(&values)
    });
    let section = section.map_err(impossible)?;
    // The decimals themselves, which need not be doubles.
    let exact = ExactSection::new(Parameters {
        aerodynamic_stiffness,
        ..parameters(&exact)
    });
    let mut found = by_method(arguments, &section, &exact.map_err(impossible)?)?;
    // What a form leaves out is used by its warnings and bounds.
    let used = needed(&values, true);
    let unused = values.keys().filter(|name| !used.contains(&name.as_str()));
    let unused: Vec<&str> = unused.map(String::as_str).collect();
    if !unused.is_empty() {
        found
            .warnings
            .push(format!("{} did not matter", unused.join(", ")));
    }
    Ok(found)
}

/// The modes of a section by the method that is asked for, with the verdict on the section in exact numbers.
fn by_method(
    arguments: &Arguments,
    section: &Section,
    exact: &ExactSection,
) -> Result<ModesFound, Outcome> {
    let model = Model::new(section).map_err(impossible)?;
    // Of several sections the errors of the eigenvalues decide, or nothing does.
    let verdict = match exact.is_open() {
        true => verdict(
            section,
            &state_matrix::eigenvalues(&model).map_err(impossible)?,
        ),
        false => exact_verdict(exact),
    };
    let diverges = model.diverges().unwrap_or_else(|| exact.diverges());
    let spectrum = |found: Result<Spectrum, StabilityError>| found.map_err(impossible);
    let is_formula = matches!(arguments.method, Method::Closed | Method::Uniform);
    if arguments.shapes && is_formula {
        return Err(wrong(
            "the formulas give eigenvalues and no mode shapes",
            "`--method state`, `exact` and `companion` give shapes",
        ));
    }
    let by_spectrum = |method, spectrum: &Spectrum| {
        by_spectrum(method, spectrum, &model, verdict, arguments.shapes)
    };
    let mut found = match arguments.method {
        Method::Companion => by_spectrum("companion", &spectrum(companion::eigenvalues(&model))?),
        Method::Exact => {
            let ExactModes { spectrum, fallback } =
                exact_modes::eigenvalues(&model).map_err(impossible)?;
            let found_by = fallback.map_or("exact", |_| "state");
            let mut found = by_spectrum(found_by, &spectrum);
            found.warnings.extend(fallback.map(|own| own.to_string()));
            found
        }
        Method::Closed => by_form("closed", closed_form(section), &model, verdict)?,
        Method::Uniform => by_form("uniform", uniform_form(&model), &model, verdict)?,
        Method::State => by_spectrum("state", &spectrum(state_matrix::eigenvalues(&model))?),
    };
    found.diverges = diverges;
    Ok(found)
}

fn by_form(
    method: &'static str,
    form: Result<ClosedForm, Limitation>,
    model: &Model,
    verdict: Verdict,
) -> Result<ModesFound, Outcome> {
    let form = form.map_err(|limitation| {
        wrong(
            &limitation.to_string(),
            "`--method state` applies to every section",
        )
    })?;
    let errors = state_matrix::error_bounds_of(model, &form.eigenvalues);
    let pairs: Vec<_> = form.eigenvalues.into_iter().zip(errors).collect();
    let bounded = |&(value, error): &(Complex<f64>, Option<f64>)| {
        Some(Eigenvalue {
            value,
            error: error?,
        })
    };
    let bounded: Option<Vec<Eigenvalue>> = pairs.iter().map(bounded).collect();
    // What is left out may be so much that nothing is known.
    let damping = match bounded {
        Some(eigenvalues) => {
            let damping = Spectrum { eigenvalues }.damping_coefficient(model.section());
            damping.map(|(value, error)| (value, Some(error)))
        }
        None => {
            let damping = model
                .section()
                .damping_coefficient(form.largest_real_part());
            damping.map(|value| (value, None))
        }
    };
    let mode = |(value, error)| ModeFound {
        value,
        error,
        shape: None,
    };
    Ok(ModesFound {
        subject: Subject::Section,
        method,
        is_formula: true,
        modes: pairs.into_iter().map(mode).collect(),
        damping_coefficient: damping.map(|(value, error)| coefficient(model, value, error)),
        verdict,
        diverges: false,
        reading: None,
        warnings: form.warnings.iter().map(ToString::to_string).collect(),
        twist: None,
    })
}

/// S of a section, by the name that its free coordinates give it.
fn coefficient(model: &Model, value: f64, error: Option<f64>) -> DampingCoefficient {
    let free = &model.section().parameters().free;
    DampingCoefficient {
        name: free.coefficient_name(),
        value,
        error,
    }
}

fn by_spectrum(
    method: &'static str,
    spectrum: &Spectrum,
    model: &Model,
    verdict: Verdict,
    with_shapes: bool,
) -> ModesFound {
    let section = model.section();
    let damping = spectrum.damping_coefficient(section);
    let mut warnings = Vec::new();
    let is_open = matches!(verdict, Verdict::Undecided(doubt) if doubt != Doubt::Neutral);
    if is_open && damping.is_some_and(|(damping, error)| damping.abs() <= error) {
        let name = section.parameters().free.coefficient_name();
        warnings.push(format!(
            "{name} is smaller than its error: its sign is not certain"
        ));
    }
    let places = places(spectrum);
    if with_shapes && places.iter().any(|(_, place)| place.is_some()) {
        let what = "modes coincide within their errors: their shapes are some of many, and those of a \
                    defective section are fewer than its modes";
        warnings.push(what.to_string());
    }
    let shape = |value, place| {
        let mode = Mode::new(model, value, place)?;
        let free = section.free().iter().copied();
        let moving = free.zip(mode.shape);
        Some(
            moving
                .map(|(own, entry)| Moving::of_section(own, entry))
                .collect(),
        )
    };
    let mode = |(own, place): (Eigenvalue, _)| ModeFound {
        value: own.value,
        error: Some(own.error),
        shape: with_shapes.then(|| shape(own.value, place)),
    };
    ModesFound {
        subject: Subject::Section,
        method,
        is_formula: false,
        modes: places.into_iter().map(mode).collect(),
        damping_coefficient: damping.map(|(value, error)| coefficient(model, value, Some(error))),
        verdict,
        diverges: false,
        reading: None,
        twist: None,
        warnings,
    }
}

/// A quantity of a case file in SI units and radians.
fn in_si(number: &Fixed, known: &[String]) -> Fixed {
    let angles = known.iter().filter(|own| is_angle(own)).cloned();
    let rates = known
        .iter()
        .filter(|own| own.starts_with("omega_"))
        .cloned();
    Vocabulary::new(known.iter().cloned(), angles, rates).in_si(number)
}

/// Whether a quantity of a section is an angle.
fn is_angle(name: &str) -> bool {
    Variable::named(&format!("{name}_deg")).is_some() || matches!(name, "alpha_0" | "theta_0")
}

/// The values by name, as they are written.
type Exact = BTreeMap<String, Rational>;

/// The values by name: as they are written, and in doubles.
fn values(set: &[Fixed]) -> Result<(Exact, BTreeMap<String, f64>), Outcome> {
    let known: Vec<String> = names().map(str::to_string).collect();
    let (mut exact, mut values) = (BTreeMap::new(), BTreeMap::new());
    for number in set {
        let number = &in_si(number, &known);
        let name = &number.name;
        if !known.contains(name) {
            return Err(unknown(
                &format!("nothing is called `{name}`"),
                name,
                &known,
            ));
        }
        let Some(value) = Decimal::nearest(&number.value) else {
            return Err(wrong(
                &format!("`{name}={}` is beyond the range of a double", number.text),
                "quantities are in SI units",
            ));
        };
        if values.insert(name.clone(), value.value).is_some() {
            return Err(wrong(&format!("`{name}` is set twice"), "set it once"));
        }
        exact.insert(name.clone(), number.value.clone());
    }
    Ok((exact, values))
}
