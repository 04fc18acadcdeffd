//! Evaluators over arrays of NumPy.

use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;
use pyo3::types::PyFloat;
use sextic::report::advice::Advice;

use crate::columns::{self, Column};
use crate::failure::Failure;
use crate::kernel::{Kernel, Quantity};
use crate::shipped;

/// An evaluator: functions of what is asked for, over one dimension.
#[pyclass(frozen, module = "sextic._sextic")]
pub struct Evaluator {
    kernel: Box<dyn Kernel>,
}

impl Evaluator {
    pub fn new(kernel: Box<dyn Kernel>) -> Self {
        Evaluator { kernel }
    }
}

/// The names of the evaluators that come with the program.
#[pyfunction]
pub fn shipped_evaluators() -> Vec<&'static str> {
    shipped::names()
}

/// The evaluator of this name that comes with the program.
#[pyfunction]
pub fn shipped_evaluator(name: &str) -> PyResult<Evaluator> {
    let found = shipped::find(name).ok_or_else(|| {
        let known: Vec<String> = shipped::names().into_iter().map(Into::into).collect();
        let message = format!("there is no evaluator `{name}`");
        Failure::from(Advice::unknown(message, name, &known))
    })?;
    Ok(Evaluator::new(Box::new(found)))
}

/// What may be meant by a name that nothing has: the words of the command.
#[pyfunction]
pub fn meant(name: &str, known: Vec<String>) -> String {
    Advice::unknown("", name, &known).help
}

/// A quantity as Python gives it: one number, or one for each point.
enum Given<'py> {
    One(f64),
    Many(PyReadonlyArray1<'py, f64>),
}

impl<'py> Given<'py> {
    /// Numbers are looked for first: to ask what is none for an array costs an exception.
    fn of(given: &Bound<'py, PyAny>) -> PyResult<Self> {
        match given.cast::<PyFloat>() {
            Ok(number) => Ok(Given::One(number.value())),
            Err(_) => Ok(Given::Many(given.extract()?)),
        }
    }
}

type Arrays<'py> = Vec<Bound<'py, PyArray1<f64>>>;

#[pymethods]
impl Evaluator {
    #[getter]
    fn name(&self) -> &str {
        self.kernel.name()
    }

    #[getter]
    fn text(&self) -> String {
        self.kernel.text()
    }

    /// What is asked for, with what it is.
    fn asked(&self) -> Vec<(String, String)> {
        pairs(self.kernel.asked())
    }

    /// What is given, with what it is.
    fn outputs(&self) -> Vec<(String, String)> {
        pairs(self.kernel.outputs())
    }

    /// The outputs at so many points, in order, and bounds of their rounding if they are wanted.
    fn run<'py>(
        &self,
        py: Python<'py>,
        given: Vec<Bound<'py, PyAny>>,
        points: usize,
        bounds: bool,
    ) -> PyResult<(Arrays<'py>, Arrays<'py>)> {
        let given: Vec<Given> = given.iter().map(Given::of).collect::<PyResult<_>>()?;
        let given: Vec<Column> = given.iter().map(column).collect::<PyResult<_>>()?;
        let count = self.kernel.outputs().len();
        let make = |count: usize| -> Arrays<'py> {
            (0..count)
                .map(|_| PyArray1::zeros(py, points, false))
                .collect()
        };
        let (outputs, errors) = (make(count), make(if bounds { count } else { 0 }));
        let (mut values, mut radii) = (writable(&outputs), writable(&errors));
        let mut values: Vec<&mut [f64]> = slices(&mut values)?;
        let mut radii: Vec<&mut [f64]> = slices(&mut radii)?;
        let kernel = &self.kernel;
        py.detach(|| match bounds {
            true => columns::run_bounded(&**kernel, &given, &mut values, &mut radii),
            false => columns::run(&**kernel, &given, &mut values),
        });
        Ok((outputs, errors))
    }
}

fn pairs(quantities: Vec<Quantity>) -> Vec<(String, String)> {
    let all = quantities.into_iter();
    all.map(|own| (own.name, own.text)).collect()
}

fn column<'a>(given: &'a Given<'_>) -> PyResult<Column<'a>> {
    Ok(match given {
        Given::One(value) => Column::One(*value),
        Given::Many(values) => Column::Many(values.as_slice()?),
    })
}

fn writable<'py>(arrays: &Arrays<'py>) -> Vec<PyReadwriteArray1<'py, f64>> {
    arrays.iter().map(|own| own.readwrite()).collect()
}

fn slices<'a>(arrays: &'a mut [PyReadwriteArray1<'_, f64>]) -> PyResult<Vec<&'a mut [f64]>> {
    let all = arrays.iter_mut();
    all.map(|own| own.as_slice_mut().map_err(Into::into))
        .collect()
}
