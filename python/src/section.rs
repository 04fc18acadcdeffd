//! Sections with a table of coefficients.

use pyo3::prelude::*;
use sextic::report::advice::Advice;
use sextic::report::csv;
use sextic::stability::case::Case;
use sextic::stability::comparison::compare;
use sextic::stability::input::{InputError, Remark};
use sextic::stability::variable::{Setting, Variable};

use crate::failure::Failure;

/// A case, whose table is read beside it.
#[pyclass(frozen, module = "sextic._sextic")]
pub struct Section {
    case: Case,
}

#[pymethods]
impl Section {
    /// The case of this text; messages call it by the name of its file.
    #[new]
    fn new(file: &str, text: &str) -> PyResult<Self> {
        let case = Case::read(file, text).map_err(|own| wrong(&own))?;
        Ok(Section { case })
    }

    /// The file of its table, relative to its own.
    #[getter]
    fn coefficients(&self) -> &str {
        &self.case.coefficients
    }

    /// The same with quantities set, by their names in a case.
    fn set(&self, values: Vec<(String, f64)>) -> PyResult<Self> {
        let set = values.iter().map(setting).collect::<Result<Vec<_>, _>>()?;
        let case = self.case.with(&set).map_err(|own| wrong(&own))?;
        Ok(Section { case })
    }

    /// What the methods say at each angle with the table of this text, as CSV, and what is odd about case and table.
    fn stability(&self, py: Python<'_>, file: &str, text: &str) -> PyResult<(String, Vec<String>)> {
        let found = py.detach(|| {
            let table = self.case.read_table(file, text)?;
            compare(&self.case, &table)
        });
        let found = found.map_err(|own| wrong(&own))?;
        let said = |own: &Remark| format!("{}: {}", own.place, own.what);
        let remarks = found.remarks.iter().map(said).collect();
        Ok((csv::comparison(&found), remarks))
    }
}

/// A quantity of a case and its value.
fn setting((name, value): &(String, f64)) -> Result<Setting, Failure> {
    let value = *value;
    let variable = Variable::named(name).ok_or_else(|| {
        let known: Vec<String> = Variable::all().map(|own| own.name.into()).collect();
        Advice::unknown(format!("a case has no quantity `{name}`"), name, &known)
    })?;
    Ok(Setting { variable, value })
}

fn wrong(error: &InputError) -> Failure {
    Advice::new(format!("{}: {}", error.place, error.what), &error.help).into()
}
