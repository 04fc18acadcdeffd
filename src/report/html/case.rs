//! A case: where it gallops, and how the methods agree.

use serde::Serialize;

use super::unit::behind_numbers;
use super::{CaseFiles, escape};
use crate::report::gallery::Named;
use crate::report::speeds::{self, SpeedsFound};
use crate::report::stability::{
    PROOF, WITHIN, agreement, conclusion, frequency, largest_error, mode, power, reasons, rounded,
    title, twists, within_errors,
};
use crate::report::validity::{departure, reach};
use crate::report::{speeds_figure, stability_figure, validity_figure};
use crate::stability::comparison::{Comparison, Method, UnstableRange, angle};
use crate::stability::validity::{Form, Validity};

/// What the template is given of a case.
#[derive(Serialize)]
pub struct CaseView {
    /// The name of its file.
    name: String,
    /// What it is, in one line.
    title: String,
    /// `S_3D`
    coefficient: &'static str,
    /// SVG.
    figure: String,
    figures: Vec<FigureView>,
    conclusion: String,
    proof: &'static str,
    unstable: Vec<UnstableView>,
    /// Within the errors of the coefficients: what, and where.
    within: Vec<(&'static str, String)>,
    within_worth: &'static str,
    /// Critical wind speeds by the angles.
    speed_lines: Vec<(String, String)>,
    highest_speed: Option<String>,
    speeds: Option<FigureView>,
    /// Why there are none.
    no_speeds: Option<String>,
    /// Between which mean twists the section lies.
    twists: Option<String>,
    validity: Option<FigureView>,
    /// Why there is no figure of it.
    no_validity: Option<String>,
    methods: Vec<MethodView>,
    remarks: Vec<String>,
    /// The text of the case file.
    file: String,
    table: String,
}

#[derive(Serialize)]
struct FigureView {
    /// SVG.
    svg: String,
    caption: String,
}

#[derive(Serialize)]
struct UnstableView {
    angles: String,
    worst: String,
    damping: String,
    frequency: String,
    mode: String,
    verdict: String,
}

#[derive(Serialize)]
struct MethodView {
    name: &'static str,
    source: &'static str,
    agreement: String,
    reasons: Vec<String>,
}

impl CaseView {
    /// A case at all its angles.
    ///
    /// # Errors
    ///
    /// If its curves cannot be drawn.
    pub fn new(case: &CaseFiles) -> Result<Self, String> {
        let comparison = &case.comparison;
        let [file, table] = &case.files;
        let found = case.speeds.as_ref().ok();
        Ok(CaseView {
            name: stability_figure::name(&comparison.case).to_owned(),
            title: behind_numbers(&title(comparison)),
            coefficient: comparison.coefficient_name(),
            figure: stability_figure::figure(comparison).svg()?,
            figures: case.figures.iter().map(figure).collect::<Result<_, _>>()?,
            conclusion: behind_numbers(&conclusion(comparison)),
            proof: PROOF,
            within: within_errors(comparison),
            within_worth: WITHIN,
            speed_lines: found
                .map(speeds::lines)
                .unwrap_or_default()
                .into_iter()
                .map(|(angles, words)| (angles, behind_numbers(&words)))
                .collect(),
            highest_speed: found.map(|own| behind_numbers(&format!("{} m/s", own.highest))),
            speeds: found.map(speeds).transpose()?,
            no_speeds: case.speeds.as_ref().err().cloned(),
            twists: twists(comparison),
            validity: case.validity.as_ref().ok().map(validity).transpose()?,
            no_validity: case.validity.as_ref().err().cloned(),
            unstable: comparison
                .unstable
                .iter()
                .map(|own| unstable(own, comparison))
                .collect(),
            methods: methods(comparison),
            remarks: comparison.remarks.iter().map(ToString::to_string).collect(),
            file: escape(&file.text),
            table: table.path.clone(),
        })
    }
}

fn figure((name, figure): &Named) -> Result<FigureView, String> {
    let caption = match name.as_str() {
        "coefficients" => "The coefficients as they are read between the rows of the table",
        "slopes" => "Their derivatives by the angle of attack, on which galloping hangs",
        "damping_of_modes" => {
            "The damping of every mode, by the state matrix; modes are numbered by their frequency at the first angle and followed by their shapes"
        }
        "frequencies_of_modes" => "The frequency of every mode",
        "inertial_coupling" => {
            "What the eccentricity does: the same section with its mass centre at the elastic centre"
        }
        "damping_against_offset" => {
            "The damping of every mode at the worst angle, with the mass centre moved"
        }
        "frequencies_against_offset" => {
            "Their frequencies: where they come close the modes exchange their shapes"
        }
        _ => figure.title.as_str(),
    };
    Ok(FigureView {
        svg: figure.svg()?,
        caption: caption.to_string(),
    })
}

/// The critical wind speeds, with where they are the lowest.
fn speeds(found: &SpeedsFound) -> Result<FigureView, String> {
    let conclusion = speeds::conclusion(found);
    Ok(FigureView {
        svg: speeds_figure::figure(found).svg()?,
        caption: behind_numbers(&format!("{conclusion} {}", speeds_figure::caption(found))),
    })
}

/// The errors of the closed forms, with those of the case as it is.
fn validity(validity: &Validity) -> Result<FigureView, String> {
    let forms = Form::ALL.map(|form| {
        let departure = departure(validity, form);
        format!("{}: {departure}", form.name())
    });
    let caption = format!(
        "Where the closed forms may be trusted. Errors of S over |S_a|, for the case as it is: {}. The closed form, perfectly \
         tuned and without structural damping: {}",
        forms.join("; "),
        reach(validity)
    );
    Ok(FigureView {
        svg: validity_figure::map(validity).svg()?,
        caption,
    })
}

fn unstable(own: &UnstableRange, comparison: &Comparison) -> UnstableView {
    let case = &comparison.case;
    let mut points = comparison.points.iter();
    let worst = points.find(|point| point.angle == own.worst);
    let verdict = worst.map(|point| point.verdict);
    let mode_of = own.mode.as_ref();
    UnstableView {
        angles: own.angles.to_string(),
        worst: format!("{}°", angle(own.worst)),
        damping: rounded(own.damping, 9),
        frequency: mode_of.map_or(String::new(), |mode| {
            behind_numbers(&frequency(mode, own.diverges, case))
        }),
        mode: mode_of.map_or(String::new(), mode),
        verdict: verdict.map_or(String::new(), |own| format!("{}: {own}", own.name())),
    }
}

fn methods(comparison: &Comparison) -> Vec<MethodView> {
    let name = comparison.coefficient_name();
    let error = largest_error(&comparison.points);
    let exact = MethodView {
        name: "state matrix",
        source: "Eq. (16)",
        agreement: format!("the standard; {name} is certain to {}", power(error)),
        reasons: Vec::new(),
    };
    let others = comparison.agreements.iter().map(|own| {
        let (name, source) = match own.method {
            Method::Companion => ("companion matrix", "Eq. (19)"),
            Method::Closed => ("closed form", "Eqs. (21)–(23)"),
            Method::Uniform => ("uniform form", "uniform.md"),
        };
        MethodView {
            name,
            source,
            agreement: agreement(own, comparison.points.len()),
            reasons: reasons(own),
        }
    });
    [exact].into_iter().chain(others).collect()
}
