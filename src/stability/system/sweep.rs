//! A system at all combinations of the values of some parameters.

use std::collections::BTreeMap;
use std::ops::Range;

use num_complex::Complex;
use rayon::prelude::*;
use sextic_codegen::evaluator::{Circular, Function};
use sextic_codegen::program::{Node, Operation, Program};

use crate::algebra::interval::Intervals;
use crate::algebra::number::Rational;
use crate::stability::eigenvalue::{Eigenvalue, Spectrum};
use crate::stability::verdict::{Verdict, verdict_by_errors};

use super::System;
use super::arithmetic::{NoValue, ball, nearest};
use super::disc::discs;
use super::entries::check;
use super::error::SystemError;
use super::parameter::{Parameters, chosen, names};
use super::pencil::Pencil;
use super::real::Real;
use super::state::state_matrix;
use crate::stability::francis::eigenvalues;

/// A parameter and its values, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepAxis {
    /// The parameter: an input, or an angle.
    pub name: String,
    /// Its values, as they are: doubles are counted as exact.
    pub values: Vec<f64>,
}

/// What is known of a system at one point of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepRow {
    /// The eigenvalue with the largest real part, its imaginary part 0 or above: λ_R + i ω with the rate of growth λ_R and
    /// the circular frequency ω; and a bound of the error of the largest real part. Or why there is none.
    pub growth: Result<Eigenvalue, SystemError>,
    /// Stable or unstable, where the errors decide it.
    pub verdict: Option<Verdict>,
}

/// The points of a sweep, ready to be computed.
#[derive(Clone, Debug)]
pub struct Sweep<'a> {
    system: &'a System,
    axes: Vec<SweepAxis>,
    /// All parameters that stay, as they are written.
    values: BTreeMap<String, Rational>,
    inputs: Vec<Source>,
    /// The values of all operations at the first point.
    known: Vec<Real>,
    /// The places of the operations that move with an axis.
    moving: Vec<usize>,
}

/// Where an input comes from.
#[derive(Clone, Debug)]
enum Source {
    Still(Real),
    /// The value of an axis.
    Axis(usize),
    /// The cosine or sine of a sum of an angle and multiples of axes.
    Turning(Function, Real, Vec<(i32, usize)>),
}

/// The least number of points for one task.
const TOGETHER: usize = 16;

/// An error of an eigenvalue above this share of the largest one is not left as it is: the row is computed again in
/// longer numbers.
const POOR: f64 = 1e-7;

impl System {
    /// A sweep over all combinations of the values of some parameters, the last of which moves fastest; the others have the
    /// given `values`.
    ///
    /// # Errors
    ///
    /// As [`System::at`] for missing, unknown and impossible parameters; an axis without values, or with one that is not
    /// finite, or two axes of one parameter.
    ///
    /// ```
    /// use std::collections::BTreeMap;
    /// use sextic::algebra::number::Rational;
    /// use sextic::stability::system::System;
    /// use sextic::stability::system::sweep::SweepAxis;
    /// use sextic_codegen::evaluator::Evaluator;
    /// use sextic_codegen::program::Program;
    ///
    /// // q̈ + c q̇ + k q = 0
    /// let mut program = Program::new(["c".to_string(), "k".to_string()]);
    /// let [c, k] = ["c", "k"].map(|name| program.input(name).unwrap());
    /// let one = program.constant(Rational::ONE);
    /// for (name, node) in [("M", one), ("C", c), ("K", k)] {
    ///     program.output(name, node);
    /// }
    /// let system = System {
    ///     evaluator: Evaluator::plain("oscillator", program),
    ///     coordinates: vec!["q".to_string()],
    ///     damping: vec![String::new()],
    ///     stiffness: vec![String::new()],
    /// };
    /// let values = BTreeMap::from([("k".to_string(), Rational::from(26))]);
    /// let axis = SweepAxis { name: "c".to_string(), values: vec![-2.0, 2.0, 4.0] };
    /// let sweep = system.sweep(&values, vec![axis])?;
    /// let rows = sweep.rows(0..sweep.len());
    /// let growth = rows[0].growth.as_ref().unwrap();
    /// // λ = 1 ± 5i
    /// assert!((growth.value.re - 1.0).abs() <= growth.error && (growth.value.im - 5.0).abs() < 1e-12);
    /// assert_eq!(rows[0].verdict.map(|own| own.name()), Some("unstable"));
    /// assert_eq!(rows[1].verdict.map(|own| own.name()), Some("stable"));
    /// # Ok::<(), sextic::stability::system::error::SystemError>(())
    /// ```
    pub fn sweep(
        &self,
        values: &BTreeMap<String, Rational>,
        axes: Vec<SweepAxis>,
    ) -> Result<Sweep<'_>, SystemError> {
        check(self)?;
        check_axes(self, &axes)?;
        let mut all = values.clone();
        for axis in &axes {
            let first = axis
                .values
                .first()
                .and_then(|own| Rational::try_from(*own).ok());
            all.insert(axis.name.clone(), first.unwrap_or_default());
        }
        let parameters = Parameters::new(&self.evaluator, &all)?;
        let inputs = sources(&parameters, &axes);
        let moving = moving(&self.evaluator.program, &inputs);
        Ok(Sweep {
            known: vec![Real::ZERO; self.evaluator.program.operations().len()],
            system: self,
            values: all,
            axes,
            inputs,
            moving,
        }
        .ready())
    }
}

fn check_axes(system: &System, axes: &[SweepAxis]) -> Result<(), SystemError> {
    let known = names(&system.evaluator);
    for (place, axis) in axes.iter().enumerate() {
        let name = axis.name.clone();
        if !known.contains(&name) {
            return Err(SystemError::Unknown {
                names: vec![name],
                known,
            });
        }
        let reason = if axis.values.is_empty() {
            "has no values: give at least one"
        } else if !axis.values.iter().all(|own| own.is_finite()) {
            "has a value that is not finite: give numbers"
        } else if axes[..place].iter().any(|other| other.name == name) {
            "is there twice: vary each parameter once"
        } else {
            continue;
        };
        return Err(SystemError::Range { name, reason });
    }
    Ok(())
}

fn sources(parameters: &Parameters<'_>, axes: &[SweepAxis]) -> Vec<Source> {
    let intervals = Intervals::new(128);
    let axis_of = |name: &str| axes.iter().position(|axis| axis.name == name);
    let number = |name: &str, value: &Rational| match axis_of(name) {
        Some(place) => Source::Axis(place),
        None => Source::Still(nearest(value)),
    };
    let circular = |own: &Circular, angle: &Rational| {
        let parts = own
            .angle
            .iter()
            .filter_map(|(count, name)| Some((*count, axis_of(name)?)));
        let parts: Vec<(i32, usize)> = parts.collect();
        if parts.is_empty() {
            return Source::Still(ball(
                &chosen(own.function, intervals.cosine_and_sine(angle)),
                &intervals,
            ));
        }
        let first = |place: usize| Rational::try_from(axes[place].values[0]).unwrap_or_default();
        let moved = parts.iter().fold(angle.clone(), |rest, (count, place)| {
            rest - Rational::from(*count) * first(*place)
        });
        Source::Turning(own.function, nearest(&moved), parts)
    };
    parameters.inputs(number, circular)
}

/// The places of the operations whose values move with an axis.
fn moving(program: &Program, inputs: &[Source]) -> Vec<usize> {
    let mut is_moving = vec![false; program.operations().len()];
    for (place, operation) in program.operations().iter().enumerate() {
        is_moving[place] = match operation {
            Operation::Input(input) => !matches!(inputs[*input as usize], Source::Still(_)),
            _ => operation.operands().any(|node| is_moving[node.index()]),
        };
    }
    (0..is_moving.len())
        .filter(|place| is_moving[*place])
        .collect()
}

/// cos or sin of an angle, right to a unit in the last place for the double that is taken.
fn circular(function: Function, angle: Real) -> Real {
    let value = chosen(function, [angle.centre.cos(), angle.centre.sin()]);
    let own = f64::EPSILON * value.abs() + f64::MIN_POSITIVE;
    Real::new(value, (own + angle.radius) * (1.0 + 16.0 * f64::EPSILON))
}

impl Sweep<'_> {
    /// Computes what stays. Where it has no value the rows tell.
    fn ready(mut self) -> Self {
        let still: Vec<usize> = (0..self.known.len())
            .filter(|place| self.moving.binary_search(place).is_err())
            .collect();
        let mut known = std::mem::take(&mut self.known);
        // What divides by 0 is no number, and neither is what is computed with it.
        let _ = self.evaluate(&still, &[], &mut known);
        self.known = known;
        self
    }

    /// The number of points: the product of the numbers of values.
    pub fn len(&self) -> usize {
        self.axes.iter().map(|axis| axis.values.len()).product()
    }

    /// Whether there is no point; there always is one.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The axes.
    pub fn axes(&self) -> &[SweepAxis] {
        &self.axes
    }

    /// The values of the axes at a point, in their order.
    pub fn values(&self, index: usize) -> Vec<f64> {
        let mut rest = index;
        let mut values: Vec<f64> = self
            .axes
            .iter()
            .rev()
            .map(|axis| {
                let own = axis.values[rest % axis.values.len()];
                rest /= axis.values.len();
                own
            })
            .collect();
        values.reverse();
        values
    }

    /// The rows of some points, in order, on all cores; the same on any number of them.
    ///
    /// Each is computed in doubles with bounds: what of the program moves, an eigenvalue problem and discs. A row whose
    /// bounds are poor, as about eigenvalues that coincide, is computed again as [`System::at`] does.
    ///
    /// Complexity: some 30 n³ operations a row, and those of the program that move.
    ///
    /// Points from [`Sweep::len`] on are left out.
    pub fn rows(&self, range: Range<usize>) -> Vec<SweepRow> {
        let range = range.start.min(self.len())..range.end.min(self.len());
        let scratch = || self.known.clone();
        let rows = range.into_par_iter().with_min_len(TOGETHER);
        rows.map_init(scratch, |known, index| self.row(index, known))
            .collect()
    }

    fn row(&self, index: usize, known: &mut [Real]) -> SweepRow {
        let values = self.values(index);
        let spectrum = match self.spectrum(&values, known) {
            Some(spectrum) => Ok(spectrum),
            None => self.longer(&values),
        };
        SweepRow {
            verdict: spectrum.as_ref().ok().and_then(verdict_by_errors),
            growth: spectrum.map(|own| growth(&own)),
        }
    }

    /// The eigenvalues in doubles with bounds; `None` if they are poor.
    fn spectrum(&self, values: &[f64], known: &mut [Real]) -> Option<Spectrum> {
        self.evaluate(&self.moving, values, known).ok()?;
        let pencil = self.pencil(known);
        let n = pencil.size;
        let values = eigenvalues(2 * n, &state_matrix(&pencil)?)?;
        let found = discs(&pencil, &values[..2 * n])?.eigenvalues();
        let largest = found
            .iter()
            .map(|own| own.value.l1_norm())
            .fold(0.0, f64::max);
        let is_good = found.iter().all(|own| own.radius <= POOR * largest);
        let eigenvalue = |own: &super::disc::Enclosed| Eigenvalue {
            value: own.value * pencil.unit,
            error: own.radius * pencil.unit,
        };
        let eigenvalues: Vec<Eigenvalue> = found.iter().map(eigenvalue).collect();
        is_good.then_some(Spectrum { eigenvalues })
    }

    /// The same in longer numbers.
    fn longer(&self, values: &[f64]) -> Result<Spectrum, SystemError> {
        let mut all = self.values.clone();
        for (axis, value) in self.axes.iter().zip(values) {
            all.insert(
                axis.name.clone(),
                Rational::try_from(*value).unwrap_or_default(),
            );
        }
        self.system.at(&all)?.spectrum()
    }

    /// Runs some operations of the program, in order.
    fn evaluate(
        &self,
        places: &[usize],
        values: &[f64],
        known: &mut [Real],
    ) -> Result<(), NoValue> {
        let operations = self.system.evaluator.program.operations();
        for &place in places {
            let of = |node: &Node| known[node.index()];
            known[place] = match &operations[place] {
                Operation::Input(input) => self.input(*input as usize, values),
                Operation::Constant(number) => nearest(number),
                Operation::Negative(a) => -of(a),
                Operation::Add(a, b) => of(a) + of(b),
                Operation::Subtract(a, b) => of(a) - of(b),
                Operation::Multiply(a, b) => of(a) * of(b),
                Operation::Divide(a, b) => of(a).quotient(of(b)).unwrap_or(NOTHING),
                Operation::SquareRoot(a) => of(a).square_root().unwrap_or(NOTHING),
            };
        }
        let is_known = places.iter().all(|place| !known[*place].centre.is_nan());
        is_known.then_some(()).ok_or(NoValue::Division)
    }

    fn input(&self, place: usize, values: &[f64]) -> Real {
        match &self.inputs[place] {
            Source::Still(value) => *value,
            Source::Axis(axis) => Real::exact(values[*axis]),
            Source::Turning(function, rest, parts) => {
                let part = |(count, axis): &(i32, usize)| {
                    Real::exact(f64::from(*count)) * Real::exact(values[*axis])
                };
                circular(
                    *function,
                    parts.iter().map(part).fold(*rest, |sum, own| sum + own),
                )
            }
        }
    }

    /// The matrices by the values of the outputs.
    fn pencil(&self, known: &[Real]) -> Pencil {
        let n = self.system.coordinates.len();
        let outputs = self.system.evaluator.program.outputs();
        let (damping, stiffness) = (self.system.damping.len(), self.system.stiffness.len());
        let parts = [1 + damping..1 + damping + stiffness, 1..1 + damping, 0..1];
        Pencil::new(n, |power, row, column| {
            let entry = |part: usize| known[outputs[(part * n + row) * n + column].1.index()];
            parts[power]
                .clone()
                .map(entry)
                .fold(Real::ZERO, |sum, own| sum + own)
        })
    }
}

/// What has no value.
const NOTHING: Real = Real::new(f64::NAN, f64::INFINITY);

/// The eigenvalue with the largest real part, and the error of that part.
fn growth(spectrum: &Spectrum) -> Eigenvalue {
    let (part, error) = spectrum.largest_real_part();
    let largest = spectrum.one_of_each_pair().find(|own| own.value.re == part);
    Eigenvalue {
        value: Complex::new(part, largest.map_or(0.0, |own| own.value.im)),
        error,
    }
}

#[cfg(test)]
mod tests {
    use super::super::laws::{Writer, values};
    use super::*;
    use proptest::prelude::*;

    /// Three coordinates with an angle, a quotient and two parameters.
    fn system() -> System {
        let mut writer = Writer::new(&["m", "k", "U", "cosine"]);
        let [m, k, speed, cosine] = ["m", "k", "U", "cosine"].map(|name| writer.input(name));
        let [zero, one] = [0, 1].map(|own| writer.number(own, 1));
        let wind = writer.times(speed, cosine);
        let square = writer.times(speed, speed);
        let turned = writer.over(square, m);
        let soft = writer.minus(k, turned);
        let [less, tenth] = [(1, 20), (1, 10)].map(|(a, b)| writer.number(a, b));
        let damping = writer.minus(less, wind);
        let mut system = writer.system([
            &[m, tenth, zero, tenth, m, zero, zero, tenth, one],
            &[damping, zero, wind, zero, less, zero, zero, tenth, less],
            &[k, zero, one, zero, soft, zero, tenth, zero, k],
        ]);
        let angle = vec![(2, "α".to_string())];
        system.evaluator.inputs[3].origin = sextic_codegen::evaluator::Origin::Circular(Circular {
            function: Function::Cosine,
            angle,
        });
        system
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(8))]

        /// Rows are those of single instances, within both bounds, whatever is asked for together.
        #[test]
        fn rows_are_those_of_single_instances(speeds in prop::collection::vec(-2.0..2.0f64, 1..5), angles in prop::collection::vec(-3.0..3.0f64, 1..4)) {
            let system = system();
            let axes = vec![
                SweepAxis { name: "α".to_string(), values: angles },
                SweepAxis { name: "U".to_string(), values: speeds },
            ];
            let sweep = system.sweep(&values(&[("m", 5, 4), ("k", 7, 3)]), axes).unwrap();
            let rows = sweep.rows(0..sweep.len() + 7);
            prop_assert_eq!(rows.len(), sweep.len());
            for (index, row) in rows.iter().enumerate() {
                prop_assert_eq!(&sweep.rows(index..index + 1)[0], row);
                let at = sweep.values(index);
                let mut given = values(&[("m", 5, 4), ("k", 7, 3)]);
                for (axis, value) in sweep.axes().iter().zip(&at) {
                    given.insert(axis.name.clone(), Rational::try_from(*value).unwrap());
                }
                let instance = system.at(&given).unwrap();
                let (part, error) = instance.spectrum().unwrap().largest_real_part();
                let growth = row.growth.as_ref().unwrap();
                prop_assert!((growth.value.re - part).abs() <= growth.error + error, "{growth:?} {part} {error}");
                prop_assert!(growth.error <= 1e-12, "{growth:?}");
                if let Some(verdict) = row.verdict {
                    prop_assert_eq!(verdict.name(), instance.verdict().name());
                }
            }
        }
    }

    #[test]
    fn what_has_no_row_says_why() {
        let mut writer = Writer::new(&["m", "w"]);
        let (m, w, one) = (writer.input("m"), writer.input("w"), writer.number(1, 1));
        let over = writer.over(one, w);
        let system = writer.system([&[m], &[one], &[over]]);
        let axis = |name: &str, values: &[f64]| SweepAxis {
            name: name.to_string(),
            values: values.to_vec(),
        };
        let sweep = system
            .sweep(
                &BTreeMap::new(),
                vec![axis("m", &[0.0, 1.0]), axis("w", &[0.0, 2.0])],
            )
            .unwrap();
        let rows = sweep.rows(0..4);
        let errors: Vec<_> = rows
            .iter()
            .map(|own| own.growth.as_ref().err().cloned())
            .collect();
        assert_eq!(
            errors,
            [
                Some(SystemError::Division),
                Some(SystemError::SingularMass),
                Some(SystemError::Division),
                None
            ]
        );
        // A double eigenvalue with one vector: the errors are those of longer numbers.
        let sweep = system
            .sweep(&values(&[("m", 1, 1)]), vec![axis("w", &[4.0])])
            .unwrap();
        let growth = sweep.rows(0..1)[0].growth.clone().unwrap();
        assert!(
            (growth.value.re + 0.5).abs() <= growth.error && growth.error < 1e-7,
            "{growth:?}"
        );
        for (axes, told) in [
            (
                vec![axis("x", &[1.0])],
                "x is no parameter of the system; its parameters are m, w",
            ),
            (
                vec![axis("m", &[])],
                "the range of m has no values: give at least one",
            ),
            (
                vec![axis("m", &[f64::NAN])],
                "the range of m has a value that is not finite: give numbers",
            ),
            (
                vec![axis("m", &[1.0]), axis("m", &[1.0])],
                "the range of m is there twice: vary each parameter once",
            ),
            (vec![axis("m", &[1.0])], "w has no value: give w=…"),
        ] {
            assert_eq!(
                system
                    .sweep(&BTreeMap::new(), axes)
                    .unwrap_err()
                    .to_string(),
                told
            );
        }
    }
}
