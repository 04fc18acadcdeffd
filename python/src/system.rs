//! Systems of documents in numbers.

use std::collections::BTreeMap;

use num_complex::Complex64;
use pyo3::prelude::*;
use sextic::compile::system::CompiledSystem;
use sextic::report::advice::Advice;
use sextic::stability::system::System as Computed;
use sextic::stability::system::error::SystemError;
use sextic::stability::system::instance::Instance;

use crate::document::{Document, fixed, refused};
use crate::failure::Failure;

/// A system of a document, ready to be computed.
#[pyclass(frozen, module = "sextic._sextic")]
pub struct System {
    compiled: CompiledSystem,
    system: Computed,
    path: String,
}

/// Eigenvalues, the bounds of their errors and their shapes; the verdict, its reason, and whether the system diverges.
type Found = (
    Vec<Complex64>,
    Vec<f64>,
    Vec<Option<Vec<Complex64>>>,
    String,
    String,
    Option<bool>,
);

#[pymethods]
impl System {
    #[new]
    #[pyo3(signature = (document, name=None))]
    fn new(document: &Document, name: Option<&str>) -> PyResult<Self> {
        Ok(System::of(document, name)?)
    }

    #[getter]
    fn name(&self) -> &str {
        &self.system.evaluator.name
    }

    /// The names of what must be given.
    fn names(&self) -> Vec<String> {
        self.system.names()
    }

    /// The names of the coordinates.
    fn coordinates(&self) -> Vec<String> {
        self.system.coordinates.clone()
    }

    /// The modes for numbers as they are written.
    fn modes(&self, py: Python<'_>, values: Vec<(String, String)>) -> PyResult<Found> {
        Ok(py.detach(|| self.found(&values))?)
    }
}

impl System {
    fn of(document: &Document, name: Option<&str>) -> Result<Self, Failure> {
        let audit = document.check()?;
        let known: Vec<String> = audit
            .systems
            .iter()
            .map(|own| own.name.ascii.clone())
            .collect();
        let stated = match (name, &audit.systems[..]) {
            (None, [only]) => Some(only),
            (None, []) => {
                let help =
                    "write `system (1) name: mass M damping C stiffness K in x, y` in a block";
                return Err(Advice::new("the document has no system", help).into());
            }
            (None, _) => {
                let message = format!("the documents have several systems: {}", known.join(", "));
                return Err(Advice::new(message, "name one of them").into());
            }
            (Some(name), systems) => systems.iter().find(|own| own.name.ascii == name),
        };
        let stated = stated.ok_or_else(|| {
            let name = name.unwrap_or_default();
            Failure::from(Advice::unknown(
                format!("there is no system `{name}`"),
                name,
                &known,
            ))
        })?;
        let compiled = CompiledSystem::of(stated, None, audit);
        let compiled = compiled.map_err(|own| refused(audit, &stated.name.unicode, own))?;
        let system = Computed {
            evaluator: compiled.specification.evaluator.clone(),
            coordinates: compiled.coordinates.clone(),
            damping: compiled.damping.clone(),
            stiffness: compiled.stiffness.clone(),
        };
        let path = audit.path.clone();
        Ok(System {
            compiled,
            system,
            path,
        })
    }

    fn found(&self, values: &[(String, String)]) -> Result<Found, Failure> {
        let set = values.iter().map(fixed).collect::<Result<Vec<_>, _>>()?;
        let known: Vec<_> = set
            .iter()
            .filter(|own| self.compiled.specification.rests_on(&own.name))
            .collect();
        let mut specification = self.compiled.specification.clone();
        let admitted = specification.admit(&known);
        admitted.map_err(|own| {
            let advice = Advice::refused(self.name(), &own);
            Failure::from(advice.unwrap_or_else(|| Advice::new(own.to_string(), &self.path)))
        })?;
        let values: BTreeMap<_, _> = set
            .iter()
            .map(|own| (own.name.clone(), own.value.clone()))
            .collect();
        let wrong = |own: SystemError| Failure::from(self.wrong(&own));
        let instance = self.system.at(&values).map_err(wrong)?;
        found(&instance).map_err(wrong)
    }

    fn wrong(&self, error: &SystemError) -> Advice {
        let message = error.to_string();
        match error {
            SystemError::Unknown { names, known } => {
                Advice::unknown(message, names.first().map_or("", String::as_str), known)
            }
            _ => Advice::new(message, "quantities are in SI units, angles in radians"),
        }
    }
}

fn found(instance: &Instance<'_>) -> Result<Found, SystemError> {
    let modes = instance.modes()?;
    let verdict = instance.verdict();
    Ok((
        modes.iter().map(|own| own.eigenvalue.value).collect(),
        modes.iter().map(|own| own.eigenvalue.error).collect(),
        modes.into_iter().map(|own| own.shape).collect(),
        verdict.name().to_string(),
        verdict.to_string(),
        instance.diverges(),
    ))
}
