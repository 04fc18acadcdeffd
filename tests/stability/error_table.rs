//! The errors of all methods on a hundred thousand systems, against long arithmetic: the table of the guide to sections.

use std::fmt::Write;

use rayon::prelude::*;
use sextic::stability::closed_form::closed_form;
use sextic::stability::eigenvalue::Spectrum;
use sextic::stability::exact_modes;
use sextic::stability::forces::Forces;
use sextic::stability::model::Model;
use sextic::stability::section::{Parameters, Section};
use sextic::stability::uniform_form::{Order, uniform_form_of};
use sextic::stability::verdict::verdict;
use sextic::stability::{companion, state_matrix};

use super::cases::{read, snapshots};
use super::oracle::{characteristic_polynomial, roots, roots_near};
use super::sections::{Numbers, section};

/// Systems in each cell of the table: a tuned and undamped one, then a detuned and damped one.
const SYSTEMS: usize = 6_300;

const WINDS: [[f64; 2]; 4] = [[1e-5, 1e-4], [1e-4, 1e-3], [1e-3, 1e-2], [1e-2, 1e-1]];
const ECCENTRICITIES: [[f64; 2]; 4] = [[0.0, 0.0], [1e-4, 1e-2], [1e-2, 1e-1], [1e-1, 0.9]];

/// The largest error of a method, and how often its sign is wrong.
#[derive(Clone, Copy, Default)]
struct Worst {
    error: f64,
    wrong: usize,
    answers: usize,
    /// How often the state matrix had to answer in its place.
    replaced: usize,
}

impl Worst {
    fn and(self, other: Self) -> Self {
        Worst {
            error: self.error.max(other.error),
            wrong: self.wrong + other.wrong,
            answers: self.answers + other.answers,
            replaced: self.replaced + other.replaced,
        }
    }
}

/// State matrix, companion matrix, exact modes; second and first uniform form, closed form.
type Row = [Worst; 6];

/// A system with its frequencies near 1 rad/s, and S_a that of a random section but for its size, 1 to 20.
fn system(numbers: &mut Numbers, place: usize, wind: [f64; 2], e: [f64; 2]) -> Parameters {
    let usual = section(numbers);
    let usual_section = Section::new(usual).expect("a section");
    let size = numbers.between(1.0, 20.0) / usual_section.scaled_damping_norm();
    let scaled_damping = usual_section.scaled_damping();
    let scaled_damping = scaled_damping.map(|row| row.map(|entry| entry * size));
    let is_tuned = place.is_multiple_of(2);
    let detuning = numbers.scale(1e-4, 0.5);
    Parameters {
        mass: 1.0,
        radius_of_gyration: 1.0,
        reference_dimension: 1.0,
        air_density: 1.0,
        mass_centre_distance: match e {
            [_, 0.0] => 0.0,
            [low, high] => numbers.scale(low, high),
        },
        natural_frequencies: match is_tuned {
            true => [1.0; 3],
            false => [
                1.0,
                1.0 + detuning,
                1.0 - detuning * numbers.between(-1.0, 1.0),
            ],
        },
        damping_ratios: match is_tuned {
            true => [0.0; 3],
            false => usual.damping_ratios,
        },
        wind_speed: 2.0 * numbers.scale(wind[0], wind[1]),
        forces: Forces::ScaledDamping(scaled_damping),
        ..usual
    }
}

/// What every method does with a system.
fn row(p: &Parameters) -> Row {
    let section = Section::new(*p).expect("a section");
    let model = Model::new(&section).expect("a model");
    let state = state_matrix::eigenvalues(&model).expect("it converges");
    let polynomial = characteristic_polynomial(p);
    let start: Vec<(f64, f64)> = state
        .eigenvalues
        .iter()
        .map(|own| (own.value.re, own.value.im))
        .collect();
    let found = roots_near(&polynomial, &start).unwrap_or_else(|| roots(&polynomial));
    let critical = found
        .iter()
        .max_by(|one, other| one.real_part().total_cmp(&other.real_part()))
        .expect("six roots");
    let largest_ratio = p.damping_ratios.into_iter().fold(0.0, f64::max);
    let size = section.relative_aerodynamic_damping() + largest_ratio;
    let exact = critical.real_part();
    // A neutral motion has no sign.
    let has_sign = exact.abs() > 1e-9 * size;
    let of = |part: f64| Worst {
        error: critical.real_distance(part) / size,
        wrong: usize::from(has_sign && (part > 0.0) != (exact > 0.0)),
        answers: 1,
        replaced: 0,
    };
    let certain = |spectrum: &Spectrum| {
        let (part, bound) = spectrum.largest_real_part();
        assert!(
            critical.real_distance(part) <= bound,
            "{p:?}: {part} ± {bound}"
        );
        of(part)
    };
    // The sines of the oracle are rounded.
    if exact.abs() > 1e-14 * size {
        let wrong = match exact > 0.0 {
            true => "stable",
            false => "unstable",
        };
        let verdict = verdict(&section, &state);
        assert_ne!(verdict.name(), wrong, "{p:?}: {exact}");
    }
    let modes = exact_modes::eigenvalues(&model).expect("it converges");
    let form = |order| {
        of(uniform_form_of(order, &model)
            .expect("it applies")
            .largest_real_part())
    };
    [
        certain(&state),
        certain(&companion::eigenvalues(&model).expect("it converges")),
        Worst {
            replaced: usize::from(modes.fallback.is_some()),
            ..certain(&modes.spectrum)
        },
        form(Order::Second),
        form(Order::First),
        closed_form(&section).map_or(Worst::default(), |own| of(own.largest_real_part())),
    ]
}

/// A number as the next power of ten.
fn power(number: f64) -> String {
    format!("1e{}", number.log10().ceil() as i32)
}

/// The table in Markdown.
fn table() -> String {
    let mut table = "| δ | e | state matrix | companion matrix | exact modes | uniform, second order | uniform, first order | closed form |\n".to_string();
    table += "|---|---|---|---|---|---|---|---|\n";
    for (line, wind) in WINDS.into_iter().enumerate() {
        for (place, e) in ECCENTRICITIES.into_iter().enumerate() {
            let chunk = |own: usize| -> Row {
                let seed = 1_000_000 * (4 * line + place + 1) + own;
                let mut numbers = Numbers::new(seed as u64);
                row(&system(&mut numbers, own, wind, e))
            };
            let join = |one: Row, other: Row| std::array::from_fn(|own| one[own].and(other[own]));
            let worst: Row = (0..SYSTEMS)
                .into_par_iter()
                .map(chunk)
                .reduce(|| [Worst::default(); 6], join);
            let e = match e {
                [_, 0.0] => "0".to_string(),
                [low, high] => format!("{low} to {high}"),
            };
            write!(table, "| {:.0e} to {:.0e} | {e} |", wind[0], wind[1]).expect("a string");
            for own in worst {
                // What is less than one in a hundred is said, too.
                let share = 100.0 * own.wrong as f64 / own.answers as f64;
                let wrong = match own.wrong {
                    0 => String::new(),
                    _ => format!(", {} % wrong", share.ceil()),
                };
                let replaced = match own.replaced {
                    0 => String::new(),
                    count => format!(", {count} by state matrix"),
                };
                write!(table, " {}{wrong}{replaced} |", power(own.error)).expect("a string");
            }
            table += "\n";
        }
    }
    table
}

#[test]
fn the_errors_of_all_methods_are_those_of_the_guide() {
    let table = table();
    snapshots("errors", || insta::assert_snapshot!("error_table", table));
    let guide = "docs/sections.md";
    let text = read(&std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(guide));
    for line in table.lines() {
        assert!(text.contains(line), "{guide} lacks:\n{table}");
    }
}
